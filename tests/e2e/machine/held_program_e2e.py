#!/usr/bin/env python3
"""What an operator does with a program that is held or that begins in its middle: other offsets, a block by hand, restart,
retrace, the handwheel as the program's time. Real processes, virtual time."""
import unittest

from polyturn_runner import Case, read_trace

SETUP = """
[channel.1]
machine = { X = 100.0, Z = 50.0 }
[channel.2]
machine = { X = 100.0, Z = 50.0 }
"""


class HeldProgram(Case):
    def run_it(self, program, scenario="", *more, second=None, trace=True):
        files = [self.write("O0001.nc", program)]
        if second:
            files.append(self.write("O0002.nc", second))
        setup = self.write("setup.toml", SETUP)
        arguments = ["run", "--virtual", "--language", "fanuc", "--setup", setup, *more]
        if scenario:
            arguments += ["--scenario", self.write("scenario.toml", scenario)]
        if trace:
            arguments += ["--trace", self.folder / "trace.csv"]
        return self.polyturn(*arguments, *files)

    def trace(self):
        return read_trace(self.folder / "trace.csv")

    def test_a_wear_that_changes_in_a_hold_acts_when_the_program_goes_on(self):
        program = "G98 T0101\nG0 X60. Z2.\nG1 Z-40. F600.\nX70.\nM30\n"
        scenario = """
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.0
press = "feed_hold L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 3.0
set = "offset L1 1 wear X=-0.4"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 4.0
press = "cycle_start L1"
"""
        done = self.run_it(program, scenario)
        self.assertEqual(done.status, 0, done.said())
        trace = self.trace()
        x, z = trace["A1.cmd"], trace["A2.cmd"]
        first = [a for a, b in zip(x, z) if -10 < b < 0]
        second = [a for a, b in zip(x, z) if -39 < b < -25]
        self.assertTrue(first and second)
        self.assertAlmostEqual(max(first), 30.0, places=6)
        self.assertAlmostEqual(min(second), 29.8, places=6)
        self.assertAlmostEqual(max(second), 29.8, places=6)
        behind = [b for b in z if b < -39.999]
        self.assertTrue(behind, "the block is driven to its end")

    def test_two_changes_in_one_hold_do_not_drive_back(self):
        program = "G98 T0101\nG0 X60. Z2.\nG1 Z-40. F600.\nM30\n"
        scenario = """
[[at]]
t = 2.0
press = "feed_hold L1"
[[at]]
t = 2.5
set = "offset L1 1 wear X=-0.4"
[[at]]
t = 3.0
set = "zero L1 G54 Z=0.3"
[[at]]
t = 3.0
press = "cycle_start L1"
"""
        done = self.run_it(program, scenario)
        self.assertEqual(done.status, 0, done.said())
        trace = self.trace()
        z = [b for t, b in zip(trace["t"], trace["A2.cmd"]) if t > 1.0]
        self.assertTrue(all(b <= a + 1e-9 for a, b in zip(z, z[1:])), "never back along the path")
        self.assertAlmostEqual(z[-1], -39.7, places=6)
        self.assertAlmostEqual(trace["A1.cmd"][-1], 29.8, places=6)

    def test_a_change_under_compensation_acts_later_and_is_told(self):
        program = "G98 T0101\nG0 X60. Z2.\nG42 G1 X50. Z0. F600.\nZ-40.\nX70.\nG40 G0 X100. Z50.\nM30\n"
        scenario = """
[[at]]
when = { ev = "move", ch = 1, comp = "right" }
after = 1.5
press = "feed_hold L1"
[[at]]
when = { ev = "move", ch = 1, comp = "right" }
after = 2.5
set = "offset L1 1 wear X=-0.4"
[[at]]
when = { ev = "move", ch = 1, comp = "right" }
after = 3.5
press = "cycle_start L1"
"""
        done = self.run_it(program, scenario)
        self.assertEqual(done.status, 0, done.said())
        self.assertTrue([e for e in done.of("alarm") if str(e.get("number")) == "PT0540"], done.said())

    def test_a_block_by_hand_in_a_hold(self):
        program = "G98\nG0 X60. Z2.\nG1 Z-40. F600.\nM30\n"
        scenario = """
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.0
press = "feed_hold L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 3.0
press = "mdi L1 G0 X90."
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 6.0
press = "cycle_start L1"
"""
        done = self.run_it(program, scenario)
        self.assertEqual(done.status, 0, done.said())
        trace = self.trace()
        x, z = trace["A1.cmd"], trace["A2.cmd"]
        away = [b for a, b in zip(x, z) if abs(a - 45) < 1e-6]
        self.assertTrue(away)
        left_at = away[-1]
        self.assertTrue(-25 < left_at < -10, left_at)
        self.assertTrue([1 for a, b in zip(x, z) if b < left_at - 0.01 and a > 30.001 and b > -39.9] == [], "back before it goes on")
        self.assertTrue([b for b in z if b < -39.999])

    # nct part 1 14.4, N1337 #5: the operator moves X by 5 mm in the hold and starts without `return`.
    AWAY = """
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 1.0
press = "feed_hold L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.0
press = "jog_in_hold L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.1
press = "step A1+ 5"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 4.0
press = "cycle_start L1"
"""

    def away(self, program, *sets, language="nct", status=0):
        arguments = ["run", "--virtual", "--language", language, "--setup", self.write("setup.toml", SETUP), "--trace", self.folder / "trace.csv",
                     "--scenario", self.write("scenario.toml", self.AWAY)]
        for line in sets:
            arguments += ["--set", line]
        done = self.polyturn(*arguments, self.write("O0001.nc", program))
        self.assertEqual(done.status, status, done.said())
        trace = self.trace()
        return done, list(zip(trace["A1.cmd"], trace["A2.cmd"]))

    def test_a_start_away_from_an_incremental_path(self):
        program = "G90 G94 G18\nG0 X60. Z0.\nG91 G1 Z-40. F600.\nX4.\nZ-5.\nG90 X50. Z-60.\nM30\n"
        _, path = self.away(program)            # REL 0: back onto the programmed path
        behind = [x for x, z in path if -39.9 < z < -20]
        self.assertTrue(behind)
        self.assertAlmostEqual(max(behind), 30.0, places=6)
        self.assertTrue([1 for x, z in path if abs(x - 32) < 1e-6 and abs(z + 44) < 0.5])
        self.assertAlmostEqual(path[-1][0], 25.0, places=6)
        _, path = self.away(program, "N1337#5 L1=1")     # the path has moved along, until both axes are named absolutely
        behind = [x for x, z in path if -39.9 < z < -20]
        self.assertTrue(behind)
        self.assertAlmostEqual(min(behind), 35.0, places=6)
        self.assertTrue([1 for x, z in path if abs(x - 37) < 1e-6 and abs(z + 44) < 0.5])
        self.assertAlmostEqual(path[-1][0], 25.0, places=6)
        self.assertAlmostEqual(path[-1][1], -60.0, places=6)
        self.assertTrue(all(b[1] <= a[1] + 1e-6 for a, b in zip(path, path[1:]) if a[1] < -0.001), "nothing is cut twice")

    def test_a_start_away_from_an_absolute_path_goes_back_to_it(self):
        for sets in ((), ("N1337#5 L1=1",)):
            _, path = self.away("G90 G94 G18\nG0 X60. Z0.\nG1 Z-40. F600.\nX70.\nM30\n", *sets)
            self.assertAlmostEqual(max(x for x, z in path if -39.9 < z < -20), 30.0, places=6)
            self.assertAlmostEqual(path[-1][0], 35.0, places=6)

    def test_other_languages_want_the_axes_back_first(self):
        done, path = self.away("G98\nG0 X60. Z0.\nG1 Z-40. F600.\nX70.\nM30\n", language="fanuc", status=1)
        self.assertIn("axes were moved in the hold", done.said())
        self.assertAlmostEqual(path[-1][0], 35.0, places=6)
        self.assertGreater(path[-1][1], -20)

    def test_restart_shows_and_approaches_and_goes_on(self):
        program = "N10 G98 T0101\nN20 G97 S500 M3\nN30 G0 X60. Z2. M8\nN40 G1 Z-10. F600.\nN50 X70.\nN60 G0 Z2.\nN70 X50.\nN80 G1 Z-20.\nN90 G0 X100. Z50. M9\nM30\n"
        done = self.run_it(program, "", "--from", "1=N80")
        self.assertEqual(done.status, 0, done.said())
        shown = done.of("message")
        self.assertTrue(shown and "N80" in shown[0]["text"] and "T0101" in shown[0]["text"], done.said())
        self.assertTrue(done.of("stop", reason="restart"), done.said())
        moves = done.of("move")
        kinds = [(m["kind"], m["n"]) for m in moves]
        self.assertEqual(kinds[:3], [("rapid", 80), ("rapid", 80), ("linear", 80)], done.said())
        self.assertEqual(moves[0]["pos"]["Z"], 2)
        self.assertEqual(moves[1]["pos"]["X"], 50)
        self.assertGreaterEqual(moves[0]["t"], done.of("stop", reason="restart")[0]["t"] + 1.0)
        codes = [a["code"] for a in done.of("aux")]
        self.assertEqual(codes[:1], ["T0101"])
        self.assertIn("M8", codes)

    def test_a_restart_that_finds_no_block(self):
        done = self.run_it("N10 G0 X60.\nM30\n", "", "--from", "1=N99", trace=False)
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue([e for e in done.alarms if str(e["number"]) == "PT0541"], done.said())

    FIRST = "N10 G98 G0 X60. Z2.\nN20 G1 Z-10. F600.\nN30 M501 P12\nN40 G0 X80.\nN50 M502 P12\nN60 G1 Z-12.\nM30\n"
    SECOND = "N10 G98 G0 X60. Z2.\nN20 G1 Z-30. F600.\nN30 M501 P12\nN40 G1 X70. F600.\nN50 M502 P12\nN60 G0 X100.\nM30\n"

    def test_two_programs_restart_together_and_replay_their_waits(self):
        done = self.run_it(self.FIRST, "", "--from", "1=N40", "--from", "2=N40", second=self.SECOND)
        self.assertEqual(done.status, 0, done.said())
        meetings = [e["code"] for e in done.of("wait", ch=1)]
        self.assertIn(502, meetings)
        self.assertEqual([m["n"] for m in done.of("move", ch=2)][0], 40)

    def test_blocks_of_a_restart_that_do_not_fit(self):
        done = self.run_it(self.FIRST, "", "--from", "1=N20", "--from", "2=N40", second=self.SECOND, trace=False)
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue([e for e in done.alarms if str(e["number"]) == "PT0542"], done.said())

    def test_retrace_and_forward_again(self):
        program = "G98\nG0 X60. Z2.\nG1 Z-20. F600.\nX80. Z-30.\nZ-40.\nG0 X100. Z50.\nM30\n"
        scenario = """
[[at]]
t = 8.0
press = "feed_hold L1"
[[at]]
t = 9.0
press = "retrace L1=on"
[[at]]
t = 9.1
press = "cycle_start L1"
[[at]]
t = 30.0
press = "retrace L1=off"
[[at]]
t = 30.1
press = "cycle_start L1"
"""
        done = self.run_it(program, scenario)
        self.assertEqual(done.status, 0, done.said())
        trace = self.trace()
        held = [(a, b) for t, a, b in zip(trace["t"], trace["A1.cmd"], trace["A2.cmd"]) if 29.5 < t < 30.0]
        self.assertTrue(held)
        self.assertAlmostEqual(held[0][0], 50.0, places=6)   # as far back as the program has come from
        self.assertAlmostEqual(held[0][1], 50.0, places=6)
        self.assertEqual(done.events[-1]["ev"], "summary")

    def test_the_handwheel_is_the_time_of_the_programs(self):
        scenario = """
[[at]]
t = 0.0
press = "program_wheel L1=on"
[[at]]
t = 1.0
press = "handwheel 1 L1 +120"
[[at]]
t = 8.0
press = "handwheel 1 L1 -70"
[[at]]
t = 16.0
press = "handwheel 1 L1 +900"
"""
        done = self.run_it(self.FIRST, scenario, second=self.SECOND)
        self.assertEqual(done.status, 0, done.said())
        trace = self.trace()
        at = {round(t, 3): z for t, z in zip(trace["t"], trace["A4.cmd"])}
        self.assertGreater(at[15.5], at[7.5], "the lower turret has gone back")
        self.assertEqual(at[0.9], 50.0)

    def test_first_part_mode_stops_before_each_tool(self):
        done = self.run_it("T0101\nG0 X60. Z2.\nT0202\nG0 X70.\nM30\n", '[[at]]\nt = 0.0\npress = "first_part L1=on"\n', trace=False)
        self.assertEqual(done.status, 0, done.said())
        self.assertGreater(done.events[-1]["seconds"], 2.0)

    def test_m99_in_the_main_program_counts_parts_and_stop_after_part_ends_it(self):
        done = self.run_it("G0 X60. Z2.\nG0 X100. Z50.\nM99\n", "", "--parts", "3", trace=False)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(len(done.of("part")), 3, done.said())
        done = self.run_it("G0 X60. Z2.\nG0 X100. Z50.\nM99\n", '[[at]]\nt = 0.1\npress = "stop_after_part"\n', "--parts", "3", trace=False)
        self.assertEqual(len(done.of("part")), 1, done.said())

    def test_jog_in_hold_and_return(self):
        program = "G98\nG0 X60. Z2.\nG1 Z-40. F600.\nG0 X100. Z50.\nM30\n"
        scenario = """
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.0
press = "feed_hold L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.5
press = "jog_in_hold L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 2.6
press = "jog A1+ 0.5s"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 5.0
press = "return L1"
[[at]]
when = { ev = "move", ch = 1, kind = "linear" }
after = 9.0
press = "cycle_start L1"
"""
        done = self.run_it(program, scenario)
        self.assertEqual(done.status, 0, done.said())
        x, z = self.trace()["A1.cmd"], self.trace()["A2.cmd"]
        self.assertGreater(max(a for a, b in zip(x, z) if -30 < b < -1), 30.5)
        self.assertTrue([b for b in z if b < -39.999])


if __name__ == "__main__":
    unittest.main()
