#!/usr/bin/env python3
"""What only a running machine shows of the language fagor: stops that a program holds off, overrides, tapping, the probe (fagor_8037t)."""
import csv
import math
import unittest

from polyturn_runner import Case

HEAD = "G18 G71 G90 G151 G94\n"


class Fagor(Case):
    def run_program(self, text, *options, setup="[channel.1]\npos = { X = 100.0, Z = 50.0 }\n", scenario="", status=0):
        program = self.write("1.nc", text)
        setup_file, scenario_file = self.write("setup.toml", setup), self.write("scenario.toml", scenario)
        done = self.polyturn("run", "--virtual", "--language", "fagor", "--set", "N1000=0", "--variables", "--setup", setup_file, "--scenario",
                             scenario_file, *options, f"1={program}")
        self.assertEqual(done.status, status, done.said())
        return done

    def points(self, done, **parts):
        return [(e["pos"]["X"], e["pos"]["Z"]) for e in done.of("move", **parts)]

    def seconds(self, done, **pos):
        return sum(e["end"] - e["t"] for e in done.of("move") if all(e["pos"][k] == v for k, v in pos.items()))

    HOLD = '[[at]]\nt = 0.5\npress = "feed_hold L1"\n'

    def test_a_stop_waits_until_the_program_allows_it(self):   # part 2, 12.3; part 1, 6.12
        for off, on in (("DSTOP", "ESTOP"), ("DFHOLD", "EFHOLD")):
            with self.subTest(off):
                done = self.run_program(f"{HEAD}({off})\nG01 X60 F600\nX50\n({on})\nX40\nM30\n", scenario=self.HOLD, status=1)
                self.assertEqual(self.points(done)[:2], [(60, 50), (50, 50)], done.said())
                self.assertAlmostEqual(self.seconds(done, X=60), 2.0, delta=0.1)
                self.assertTrue(done.of("stop", reason="held"))
                self.assertFalse(done.of("stop", reason="M30"))

    def test_a_stop_comes_at_once_otherwise(self):
        done = self.run_program(f"{HEAD}(DSTOP)\n(ESTOP)\nG01 X60 F600\nX50\nM30\n", scenario=self.HOLD, status=1)
        self.assertNotIn((50, 50), self.points(done))

    def test_esblk_makes_one_block_of_many(self):   # part 2, 12.3
        done = self.run_program(f"{HEAD}X90\n(ESBLK)\nX80\nX70\n(DSBLK)\nX50\nM30\n", setup="[channel.1]\npos = { X = 100.0, Z = 50.0 }\nkeys = { single_block = true }\n",
                                scenario="".join(f'[[at]]\nt = {t}.0\npress = "cycle_start L1"\n' for t in range(1, 20)))
        begins = {e["pos"]["X"]: e["t"] for e in done.of("move")}
        self.assertGreater(begins[80] - begins[90], 0.9, done.said())
        self.assertLess(begins[70] - begins[80], 0.9, done.said())
        self.assertGreater(begins[50] - begins[70], 0.5, done.said())   # at the next cycle start

    def test_the_override_of_the_program_goes_before_the_panel(self):   # part 2, 11.2.6
        done = self.run_program(f"{HEAD}(PRGFRO=50)\nG01 X90 Z30 F600\n(PRGFRO=0)\nX80\nM30\n", scenario='[[at]]\nt = 0.0\npress = "feed_override L1=20"\n')
        self.assertAlmostEqual(self.seconds(done, X=90), (20**2 + 5**2) ** 0.5 / 5, delta=0.1)
        self.assertAlmostEqual(self.seconds(done, X=80), 2.5, delta=0.1)

    def test_the_panel_ends_at_its_switch_and_at_maxfovr(self):   # part 1, 5.2
        for most, seconds in (("100", 5.0), ("80", 6.25), ("255", 4.17)):
            with self.subTest(most):
                done = self.run_program(f"{HEAD}(P100=FRO,P101=CNCFRO)\nG01 Z0 F600\nM30\n", "--set", f"FG.MAXFOVR={most}", scenario='[[at]]\nt = 0.0\npress = "feed_override L1=150"\n')
                self.assertAlmostEqual(self.seconds(done, Z=0), seconds, delta=0.1)

    def test_the_spindle_keys_end_at_their_limits(self):   # part 1, 4.4.1, 5.3; part 2, 11.2.10
        text = f"{HEAD}{{}}S300 M3\nG04 K300\n(P100=SSO)\nG95 G01 Z40 F1\nM30\n"
        for before, options, keys, sso, rpm in (("", (), 150, 120, 360), ("", ("--set", "FG.MAXSOVR=110"), 120, 110, 330), ("", ("--set", "FG.MINSOVR=80"), 50, 80, 240),
                                                ("G92 S300\n", (), 120, 120, 300), ("(PRGSSO=60)\n", (), 120, 60, 180)):
            with self.subTest(before=before, options=options):
                done = self.run_program(text.format(before), *options, scenario=f'[[at]]\nt = 0.0\npress = "spindle_override S1={keys}"\n')
                self.assertEqual([e["value"] for e in done.of("variable", name="P100")], [sso])
                self.assertAlmostEqual(self.seconds(done, Z=40), 10 / (rpm / 60), delta=0.12)

    def test_the_second_travel_limits_act_with_actlim2(self):   # part 2, 11.2.7
        text = f"{HEAD}(LIMPLX=55,LIMMIZ=-20)\nM77\nG04\nG01 X110 F3000\n{{}}\nM30\n"
        on = '[[at]]\nwhen = { ev = "aux", ch = 1, code = "M77" }\nset = "ACTLIM2 L1=1"\n'
        for block, axis in (("X110.01", "X"), ("Z-20.01", "Z")):
            with self.subTest(block):
                done = self.run_program(text.format(block), scenario=on, status=1)
                self.assertEqual(self.points(done), [(110, 50)])
                self.assertIn(f"axis {axis}", done.said())
                self.run_program(text.format(block))   # without the PLC they say nothing
        self.run_program(text.format("Z-20"), scenario=on)

    def test_g51_takes_a_share_of_the_acceleration(self):   # part 1, 7.4
        slopes = [word for line in ("N0400=500", "N0401=0", "N0305=100000") for word in ("--set", line)]
        for corner, acceleration in (("G51 A50 E0.1", 250), ("G51 A0 E0.1", 500), ("G51 E0.1", 500), ("G51 A50 E0.1\nG05", 500), ("G51 A200 E0.1", 500)):
            with self.subTest(corner):
                done = self.run_program(f"{HEAD}{corner}\nG01 Z10 F3000\nM30\n", *slopes)
                self.assertAlmostEqual(self.seconds(done, Z=10), 40 / 50 + 50 / acceleration, delta=0.03)

    def test_g51_rounds_its_corners_within_e_and_leaves_those_below_b_square(self):   # part 1, 7.4
        trace = self.folder / "trace.csv"
        def nearest(corner):   # how far from the corner Z0 X40 the path stays
            self.run_program(f"{HEAD}G152\n{corner}\nG01 X40 Z10 F1000\nZ0\nX60\nM30\n", "--trace", str(trace), "--trace-every", "1")
            with open(trace, newline="", encoding="utf-8") as lines:
                return min(math.hypot(float(row["A1.cmd"]) - 40, float(row["A2.cmd"])) for row in csv.DictReader(lines))
        wide = nearest("G51 E0.1")
        self.assertLess(wide, 0.1)
        self.assertGreater(wide, 0.05)
        self.assertLess(nearest("G51 E0.1\nG05"), 0.006)          # as the machine has it
        self.assertLess(nearest("G51 E0.1 B100"), 0.0002)        # the blocks make an angle of 90 degrees
        self.assertGreater(nearest("G51 E0.1 B80"), 0.05)

    def test_a_loop_that_nobody_answers_ends_the_run(self):   # cli.md, section 5
        for loop in ("N10 (IF (PLCMM200 EQ 0) GOTO N10)\n", "N10 G04\n(IF (PLCMM200 EQ 0) GOTO N10)\n"):
            with self.subTest(loop):
                done = self.run_program(f"{HEAD}G01 Z40 F3000\n{loop}M30\n", status=1)
                self.assertEqual([stop["reason"] for stop in done.of("stop")], ["waiting"], done.said())
        # Those that come to an end by themselves: by counting, by the clock.
        for loop in ("(P100=0)\nN10 (P100=P100+1)\n(IF ((PLCMM200 EQ 0) AND (P100 LT 2000)) GOTO N10)\n", "N10 (IF ((PLCMM200 EQ 0) AND (CYTIME LT 2500)) GOTO N10)\n"):
            with self.subTest(loop):
                done = self.run_program(f"{HEAD}{loop}M30\n")
                self.assertEqual([stop["reason"] for stop in done.of("stop")], ["M30"], done.said())

    def test_two_loaded_programs_do_not_define_one_subroutine(self):   # part 2, 12.5
        for name in ("701", "702"):
            self.write(f"000{name}.PIT", f"%A,MX,\n(SUB 5)\n(P100={name})\n(RET)\n")
        loaded = '[channel.1]\npos = { X = 100.0, Z = 50.0 }\nsubprograms = ["000701.PIT", "000702.PIT"]\n'
        done = self.run_program(f"{HEAD}(CALL 5)\nX90\nM30\n", setup=loaded, status=1)
        self.assertIn("subroutine 5 is defined twice", done.said())
        self.assertEqual(done.of("move"), [])
        self.run_program(f"{HEAD}(CALL 5)\nX90\nM30\n", setup=loaded.replace(', "000702.PIT"', ""))   # beside the program it is not loaded

    def test_a_tap_turns_back_at_once(self):   # part 2, 9.6.2
        done = self.run_program("G18 G71 G90 G151 G95\nG00 X60 Z20 F1 S300 M3\nG83 X0 Z0 I6 B0 D4\nM30\n")
        self.assertEqual(done.alarms, [])
        self.assertEqual(self.points(done, cycle="G83"), [(0, 4), (0, -6), (0, 4)])

    def test_a_cut_behind_a_reversal_waits_for_it(self):
        done = self.run_program("G18 G71 G90 G151 G95\nS500 M3\nG04 K100\nG01 Z40 F0.2\nM4\nZ30\nM30\n")
        self.assertEqual(done.alarms, [], done.said())

    def test_rigid_taps_of_both_types(self):   # part 2, 9.6.3
        for kind in (1, 2):
            with self.subTest(kind):
                done = self.run_program(f"G18 G71 G90 G151 G95\nG00 X60 Z20 F1 S300 M3\nG83 X0 Z0 I6 B0 D4 R{kind}\nM30\n")
                self.assertEqual(done.alarms, [], done.said())
                self.assertEqual(self.points(done, cycle="G83"), [(0, 4), (0, -6), (0, 4)])

    def test_g76_ends_where_the_signal_goes(self):   # part 2, 10.1
        setup = '[channel.1]\npos = { X = 80.0, Z = 20.0 }\n[[channel.1.sensor]]\ninput = "1"\naxis = "X"\nat = 30.0\ndirection = "-"\n'
        done = self.run_program(f"{HEAD}G00 X20 Z5\nG76 X50 F150\n(P100=POSX, P101=PRBST)\nG75 X10\n(P102=POSX, P103=PRBST)\nM30\n", "--set", "FG.PROBERR=1", setup=setup)
        values = {e["name"]: e["value"] for e in done.of("variable")}
        self.assertAlmostEqual(values["P100"], 30, delta=0.1)
        self.assertAlmostEqual(values["P102"], 30, delta=0.1)
        self.assertEqual((values["P101"], values["P103"]), (0, 1), done.said())

    def test_g233_leaves_a_thread_that_is_stopped(self):   # part 1, 6.12
        done = self.run_program(f"{HEAD}S300 M3\nG04 K200\nG05 G00 X40 Z5\nG233 X5\nG33 Z-25 L2\nG00 X60\nM30\n", "--trace", "trace.csv",
                                scenario='[[at]]\nwhen = { ev = "move", kind = "thread" }\nafter = 1.0\npress = "feed_hold L1"\n', status=1)
        self.assertTrue(done.of("stop", reason="held"), done.said())
        last = (self.folder / "trace.csv").read_text().splitlines()
        x = last[0].split(",").index("A1.cmd")
        self.assertAlmostEqual(float(last[-1].split(",")[x]), 25.0, delta=0.01, msg="5 mm out of the thread at X40")

    def test_m19_counts_its_angle_on(self):   # part 1, 5.5.1
        done = self.run_program(f"{HEAD}M19\nM19 S90\nM19 S-45\nM19 S450\nG04 K20\nM30\n", "--trace", "trace.csv")
        self.assertEqual(done.alarms, [], done.said())
        self.assertEqual([e["value"] for e in done.of("spindle", mode="position")], [0, 90, -45, 450])
        lines = (self.folder / "trace.csv").read_text().splitlines()
        angle = float(lines[-1].split(",")[lines[0].split(",").index("S1.angle")])
        self.assertAlmostEqual(angle % 360, 90, delta=0.5)

    THREAD = f"{HEAD}S600 M3\nG04 K300\nG05 G00 X40 Z5\nX30\n"

    def test_joined_threads_go_round_their_corner_at_the_speed_of_the_spindle(self):   # part 1, 6.11
        done = self.run_program(f"{self.THREAD}G33 Z-35 L2\nX50 Z-65 L2\nG00 X60\nM30\n", "--trace", "trace.csv")
        self.assertEqual(done.alarms, [], done.said())
        self.assertAlmostEqual(sum(e["end"] - e["t"] for e in done.of("move", kind="thread")), 35 * 0.1, delta=0.2)   # 70 mm, 2 mm a turn of 0.1 s
        header, *rows = (self.folder / "trace.csv").read_text().splitlines()
        x, z = header.split(",").index("A1.cmd"), header.split(",").index("A2.cmd")
        at = [(float(row.split(",")[x]), float(row.split(",")[z])) for row in rows]
        nearest = min((px - 15) ** 2 + (pz + 35) ** 2 for px, pz in at) ** 0.5
        self.assertLess(nearest, 0.3, "the corner is rounded, not cut off")
        cut = [(px, pz) for px, pz in at if -63 < pz < 4]
        for (x0, z0), (x1, z1), (x2, z2) in zip(cut, cut[1:], cut[2:]):   # no axis jumps: 1 ms ticks
            self.assertLess(abs(x2 - 2 * x1 + x0), 0.005, f"X at Z{z1}")

    def test_no_override_of_the_program_acts_on_a_thread(self):   # part 1, 5.3
        done = self.run_program(f"(PRGSSO=50, PRGFRO=50)\n{self.THREAD}G33 Z-35 L2\nG00 X60\nG95 G01 Z-45 F2\nM30\n")
        self.assertEqual(done.alarms, [], done.said())
        self.assertAlmostEqual(sum(e["end"] - e["t"] for e in done.of("move", kind="thread")), 2.0, delta=0.15)
        self.assertAlmostEqual(self.seconds(done, Z=-45), 10 / (2 * 300 / 60 * 0.5), delta=0.4)   # both act again

    def test_a_real_position_is_read_when_the_axis_is_quiet(self):   # part 2, 11.2.7
        done = self.run_program(f"{HEAD}G00 X40 Z10\n(P100=POSX, P101=APOSZ)\nG05 G01 Z-5 F2000\n(P102=POSZ)\n(IF (P102 EQ P102) P103=P102)\nM30\n")
        values = {e["name"]: e["value"] for e in done.of("variable")}
        for name, value in (("P100", 40), ("P101", 10), ("P102", -5), ("P103", -5)):
            self.assertAlmostEqual(values[name], value, delta=0.001, msg=name)

    def test_a_channel_waits_for_one_of_another_language(self):
        first, second = self.write("1.nc", f"{HEAD}G01 X60 F600\nM501\nX50\nM30\n"), self.write("2.nc", "G0 X90.\nM501\nX80.\nM30\n")
        done = self.polyturn("run", "--virtual", "--language", "1=fagor", "--language", "2=fanuc", "--set", "N1000=0", f"1={first}", f"2={second}")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(len(done.of("wait", code=501)), 2, done.said())
        begins = {(e["ch"], e["pos"]["X"]): e["t"] for e in done.of("move")}
        self.assertAlmostEqual(begins[1, 50], begins[2, 80], delta=0.05)


if __name__ == "__main__":
    unittest.main()
