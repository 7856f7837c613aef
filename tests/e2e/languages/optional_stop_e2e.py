#!/usr/bin/env python3
"""The optional stop on the running machine: the key counts when the machine comes to M01, however far the program has been read by then."""
import unittest

from polyturn_runner import Case

BODY = {
    "fanuc": "G98 G1 X50. Z0. F600\nZ-10.\nM01\nZ-20.\nM30\n",
    "nct": "G94 G1 X50. Z0. F600\nZ-10.\nM01\nZ-20.\nM30\n",
    "fagor": "G94 G01 X50 Z0 F600\nZ-10\nM01\nZ-20\nM30\n",
    "sinumerik": "G18 G71 G90 G94 G500 DIAMON\nG1 X50 Z0 F600\nZ-10\nM1\nZ-20\nM30\n",
}
SETUP = "[channel.1]\npos = { X = 50.0, Z = 0.0 }\n"
PRESS = '[[at]]\nt = 0.5\npress = "optional_stop L1=%s"\n'   # within the second that Z-10 takes
START = '[[at]]\nt = 3.0\npress = "cycle_start"\n'


class OptionalStop(Case):
    def run_one(self, language, scenario, body=None, setup="", *options):
        program = self.write("PART.nc", body or BODY[language])
        done = self.polyturn("run", "--virtual", "--language", language, *options, "--setup", self.write("setup.toml", SETUP + setup), "--scenario", self.write("scenario.toml", scenario), f"1={program}")
        self.assertEqual(done.status, 0, done.said())
        return done

    def z_moves(self, done):
        return [(round(e["t"], 2), e["pos"]["Z"]) for e in done.of("move") if e["pos"]["Z"] in (-10, -20)]

    def test_a_key_that_comes_while_the_block_before_is_driven_stops(self):
        for language in BODY:
            with self.subTest(language):
                done = self.run_one(language, PRESS % "on" + START)
                self.assertEqual([e["reason"] for e in done.of("stop")], ["M01", "M30"], done.said())
                (first, _), (second, _) = self.z_moves(done)
                self.assertAlmostEqual(first, 0.0, delta=0.1)
                self.assertAlmostEqual(second, 3.0, delta=0.1, msg="it goes on with cycle start")

    def test_a_key_that_is_taken_back_stops_nothing(self):
        for language in BODY:
            with self.subTest(language):
                done = self.run_one(language, PRESS % "off", setup="keys = { optional_stop = true }\n")
                self.assertEqual([e["reason"] for e in done.of("stop")], ["M30"], done.said())

    def test_without_the_key_nothing_is_told(self):
        for language in BODY:
            with self.subTest(language):
                done = self.run_one(language, "")
                self.assertEqual([e["reason"] for e in done.of("stop")], ["M30"], done.said())
                (_, _), (second, _) = self.z_moves(done)
                self.assertAlmostEqual(second, 1.0, delta=0.2)

    def test_the_key_switched_off_does_not_start_the_machine(self):
        done = self.run_one("fanuc", PRESS % "on" + '[[at]]\nt = 2.0\npress = "optional_stop L1=off"\n' + START)
        (_, _), (second, _) = self.z_moves(done)
        self.assertAlmostEqual(second, 3.0, delta=0.1, msg=done.said())
        self.assertEqual([e["reason"] for e in done.of("stop")], ["M01", "M30"], "it stood there")

    def test_an_offset_that_is_entered_at_the_stop_acts_behind_it(self):
        body = "T0101\nG98 G1 X100. Z0. F6000\nZ-50. F600\nN30 M01\nN40 X90.\nN50 X80. Z-70.\nM30\n"
        change = '[[at]]\nt = 7.0\nset = "offset L1 1 wear X=-0.4"\n[[at]]\nt = 8.5\npress = "cycle_start"\n'
        setup = "[channel.1.offset.1]\ngeometry = { X = 0.0, Z = 0.0 }\nwear = { X = 0.0, Z = 0.0 }\n"
        for key, keys in (('[[at]]\nt = 2.0\npress = "optional_stop L1=on"\n', ""), ("", "keys = { optional_stop = true }\n")):
            with self.subTest(key):
                done = self.run_one("fanuc", key + change, body, keys + setup)
                self.assertEqual([e["reason"] for e in done.of("stop")], ["M01", "M30"], done.said())
                moves = [e for e in done.of("move") if e.get("n") in (40, 50)]
                self.assertEqual([e["machine"]["X"] for e in moves][-2:], [44.8, 39.8], done.said())
                self.assertGreaterEqual(moves[0]["t"], 8.5, "nothing moves before the start")

    def test_under_compensation_the_contour_stays(self):
        body = "T0101\nG98 G42 G1 X40. Z0. F600\nZ-10.\nM01\nX60. Z-20.\nG40 X80. Z-30.\nM30\n"
        setup = "[channel.1.offset.1]\ngeometry = { R = 0.8, T = 3 }\n"
        quiet = self.run_one("fanuc", "", body, setup)
        late = self.run_one("fanuc", PRESS % "on" + START, body, setup)
        points = [[(round(e["pos"]["X"], 3), round(e["pos"]["Z"], 3)) for e in done.of("move")] for done in (quiet, late)]
        self.assertEqual(points[0], points[1])
        self.assertEqual([e["reason"] for e in late.of("stop")], ["M01", "M30"], late.said())

    def test_a_contour_of_a_cycle_may_hold_it(self):
        body = "G98 G71 U2. R0.5\nG71 P10 Q20 U0. W0. F600\nN10 G0 X40.\nM01\nN20 G1 Z-10.\nM30\n"
        done = self.run_one("fanuc", "", body)
        self.assertFalse(done.of("alarm"), done.said())


class BlockSkip(Case):
    def test_level_10_skips_its_own_lines_only(self):   # sinumerik_part1 4: / and /0 are level 1, /9 is level 10
        program = self.write("PART.nc", "G18 G71 G90 G94 G500\n/9 G0 Z1\n/8 G0 Z2\nG0 Z3\nM30\n")
        for levels, expected in ("[10]", [2, 3]), ("[9]", [1, 3]):
            done = self.polyturn("run", "--virtual", "--language", "sinumerik", "--setup", self.write("setup.toml", f"[channel.1]\nkeys = {{ block_skip = {levels} }}\n"), f"1={program}")
            self.assertEqual([e["pos"]["Z"] for e in done.of("move")], expected, done.said())


if __name__ == "__main__":
    unittest.main()
