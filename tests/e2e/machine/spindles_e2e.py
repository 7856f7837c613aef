#!/usr/bin/env python3
"""Spindles of a running machine: rigid tapping, the C axis on the spindle's motor, gear ranges, orientation."""
import unittest

from polyturn_runner import Case, read_trace


def unwound(angles):
    """Revolutions over all turns from angles of 0 to 360 degrees."""
    turns, out = 0.0, []
    for i, angle in enumerate(angles):
        if i:
            step = angle - angles[i - 1]
            turns += (step + 540.0) % 360.0 - 180.0
        out.append((angles[0] + turns) / 360.0)
    return out


class Spindles(Case):
    def run_program(self, text, *options):
        program = self.write("O1.nc", text)
        done = self.polyturn("run", "--virtual", "--language", "nct", f"1={program}", "--trace", "trace.csv", *options)
        self.assertEqual(done.status, 0, done.said())
        return done, read_trace(self.folder / "trace.csv")

    def test_a_rigid_tap_turns_with_its_axis_in_and_out(self):
        done, trace = self.run_program("G18 G90 G94\nG0 X0 Z5.\nS300\nG17 G84.2 Z-10. R2. F300.\nG80\nM30\n", "--set", "N1503 L1=2",
                                       "--set", "N1508 S1=20", "--set", "N1532 S1=40")
        feeds = [e for e in done.of("move", ch=1, kind="linear")]
        self.assertEqual([e["pos"]["Z"] for e in feeds], [-10, 2], done.said())
        codes = [e["code"] for e in done.of("aux")]
        self.assertIn("M19", codes)
        self.assertNotIn("M3", codes, "the PLC hears nothing of a rigid tap's turning")
        turns = unwound(trace["S1.angle"])
        inside = [i for i, t in enumerate(trace["t"]) if feeds[0]["t"] + 0.05 <= t <= feeds[1]["end"]]
        offset = turns[inside[0]] + trace["A2.act"][inside[0]]
        worst = max(abs(turns[i] + trace["A2.act"][i] - offset) for i in inside)
        self.assertLess(worst, 0.15, "one revolution a millimetre")
        self.assertAlmostEqual(turns[inside[-1]] - min(turns[i] for i in inside[:3]), 0.0, delta=0.2, msg="and back again")
        self.assertGreater(max(turns[i] for i in inside) - turns[inside[0]], 11.0)

    def test_the_end_of_a_program_stops_its_spindle(self):   # docs/design/spindle-of-two-channels.md: the PLC hears of M30 and M02
        for end in ("M30", "M02"):
            with self.subTest(end):
                other = self.write("O2.nc", "G4 P6.\nM30\n")
                done, trace = self.run_program(f"S600 M3\nG4 P1.\n{end}\n", f"2={other}", "--watch", "SP_ROT S1")
                self.assertEqual([e["value"] for e in done.of("flag", name="SP_ROT S1")][-1], 5, done.said())
                self.assertAlmostEqual(trace["S1.speed"][-1], 0, delta=1)

    def test_who_cuts_by_the_spindle_of_an_ended_program_is_stopped(self):
        first, second = self.write("O1.nc", "S600 M3\nM510\nG4 P1.\nM30\n"), self.write("O2.nc", "G95\nM510\nG1 W-30. F0.5\nM30\n")
        done = self.polyturn("run", "--virtual", "--language", "nct", f"1={first}", f"2={second}")
        self.assertEqual((done.status, [alarm["number"] for alarm in done.alarms]), (1, ["PT0520"]), done.said())

    def test_a_cut_by_the_spindle_of_another_channel_waits_for_its_speed(self):   # PT_FEED_WAITS
        first, second = self.write("O1.nc", "G97 S600 M3\nM510 P12\nG4 P9.\nM30\n"), self.write("O2.nc", "M510 P12\nG18 G90 G95\nG1 Z20. F0.5\nM30\n")
        setup = self.write("setup.toml", "[channel.1]\nmachine = { X = 100.0, Z = 50.0 }\n[channel.2]\nmachine = { X = 100.0, Z = 50.0 }\n")
        for waits, seconds in ((1, 6.02), (0, 6.2)):
            with self.subTest(waits):
                done = self.polyturn("run", "--virtual", "--language", "nct", "--set", f"PT_FEED_WAITS L2={waits}", "--setup", setup, f"1={first}", f"2={second}")
                way = done.of("move", ch=2)[0]
                self.assertAlmostEqual(way["end"] - way["t"], seconds, delta=0.06, msg=done.said())   # 30 mm at 0.5 mm and 600 1/min

    def test_a_spindle_of_another_channel_is_refused_at_its_block(self):
        first, second = self.write("O1.nc", "G96 S100 M3\nM510 P12\nG4 P3.\nM30\n"), self.write("O2.nc", "M510 P12\nG4 P1.\nS300\nM30\n")
        done = self.polyturn("run", "--virtual", "--language", "nct", f"1={first}", f"2={second}")
        self.assertEqual([(e["number"], e["ch"], e.get("line")) for e in done.alarms], [("PT0523", 2, 3)], done.said())

    def test_a_feed_behind_a_rigid_tap_leaves_the_spindle_alone(self):
        done, trace = self.run_program("G18 G90 G94\nG0 X0 Z5.\nS300\nG17 G84.2 Z-10. R2. F300.\nG80\nG1 Z12. F600.\nS200 M3\nG1 Z22.\nM5\nM30\n", "--set", "N1503 L1=2",
                                       "--set", "N1508 S1=20", "--set", "N1532 S1=40")
        self.assertEqual(done.alarms, [])
        way = {e["line"]: (e["t"], e["end"]) for e in done.of("move", ch=1, kind="linear")}
        self.assertAlmostEqual(way[8][1] - way[8][0], 1.0, delta=0.1, msg="10 mm at 600 mm/min")
        turns = unwound(trace["S1.angle"])
        still = [turns[i] for i, t in enumerate(trace["t"]) if way[6][0] + 0.2 <= t <= way[6][1]]
        self.assertLess(max(still) - min(still), 0.1)

    def test_the_c_axis_is_the_spindle(self):
        done, trace = self.run_program("G18 G90 G94\nG0 C90.\nS400 M3\nG4 P1.\nM5\nG0 C270.\nG4 P0.2\nM30\n")
        self.assertEqual(done.alarms, [])
        moves = [e for e in done.of("move") if "C" in e["pos"]]
        at = {e["line"]: next(i for i, t in enumerate(trace["t"]) if t >= e["end"] + 0.005) for e in moves if e["line"] in (2, 6)}
        for line, angle in ((2, 90.0), (6, 270.0)):
            self.assertAlmostEqual(trace["S1.angle"][at[line]], angle, delta=0.3, msg=f"line {line}")

    def test_naming_the_axis_takes_a_positioned_spindle_back(self):   # sinumerik part 1, 8.4: SPOS, M19, M70, a tap
        program = self.write("POS.MPF", "G18 G90 G94 DIAMOF\nG0 X0 Z5\nSPOS=90\nG0 C45\nM19\nG0 C60\nS300 M3\nG4 F1\nM70\nG0 C200\n"
                                        "G331 Z0 K1 S100\nG332 Z5 K1\nG0 C30\nR1=10 SPOS=10\nR1=R1+1 C=R1\nG4 F.1\nM30\n")
        done = self.polyturn("run", "--virtual", "--language", "sinumerik", f"1={program}", "--trace", "trace.csv")
        self.assertEqual((done.status, done.alarms), (0, []), done.said())
        trace = read_trace(self.folder / "trace.csv")
        turns = [e for e in done.of("move", kind="rapid") if e["line"] > 2]
        self.assertEqual([e["pos"]["C"] for e in turns], [45, 60, 200, 30, 11], done.said())
        for e in turns:
            at = next(i for i, t in enumerate(trace["t"]) if t >= e["end"] + 0.005)
            self.assertAlmostEqual(trace["S1.angle"][at], e["pos"]["C"], delta=0.5, msg=f"line {e['line']}")

    def test_a_rigid_tap_may_be_fast(self):   # its following error is within N0777
        for speed in (1200, 3000):
            with self.subTest(speed):
                program = self.write("TAP.MPF", f"G18 G90 G94 DIAMOF\nG0 X0 Z5\nSPOS=0\nG331 Z-100 K1 S{speed}\nG332 Z5 K1\nM30\n")
                done = self.polyturn("run", "--virtual", "--language", "sinumerik", f"1={program}")
                self.assertEqual((done.status, done.alarms), (0, []), done.said())

    def test_gear_ranges_are_engaged_at_creep_speed(self):
        sets = ("PT_GEAR_RANGES S1=2", "PT_GEAR_TIME S1=0.5", "N0651 S1=900", "N0635 S1=1000", "N0658 S1=15", "N0659 S1=15", "N0667 S1=1500")
        done, trace = self.run_program("S2000 M3\nG4 P2.\nM42\nG4 P2.\nM5\nM30\n", *(word for line in sets for word in ("--set", line)),
                                       "--watch", "SN_RANGE S1", "--watch", "SP_PAR S1")
        flags = [(e["name"], e["value"]) for e in done.of("flag")]
        self.assertLess(flags.index(("SP_PAR S1", 1)), flags.index(("SN_RANGE S1", 2)), flags)
        change = next(e["t"] for e in done.of("flag") if e["name"] == "SN_RANGE S1" and e["value"] == 2)
        self.assertLess(abs(trace["S1.speed"][int(change * 1000)]), 20, "creeping while the gear changes")
        self.assertAlmostEqual(trace["S1.speed"][int((change + 1.5) * 1000)], 900, delta=5)

    def test_m19_goes_to_the_grid_shift(self):
        _, trace = self.run_program("S500 M3\nG4 P1.\nM19\nG4 P0.2\nM30\n", "--set", "N0684 S1=512")
        self.assertAlmostEqual(trace["S1.angle"][-30], 45.0, delta=0.5)


if __name__ == "__main__":
    unittest.main()
