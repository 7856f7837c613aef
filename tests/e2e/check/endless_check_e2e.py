#!/usr/bin/env python3
"""`check` ends, whatever the program does: one that goes round without changing anything is found after so many rounds, one that counts or
wanders for ever after --most-blocks, and a long one that ends is left alone."""
import unittest

from polyturn_runner import Case

ROUND = {
    "to where it stands": ("fanuc", "O1\nN10 G0 X50.\nM99 P10\n"),
    "with moves": ("fanuc", "O1\nN10 G0 X50.\nG1 X60. F0.2\nG97 S500 M3\nM99 P10\n"),
    "over a call": ("fanuc", "O1\nN10 M98 P2\nGOTO 10\nM30\nO2\nG0 X50.\nM99\n"),
    "an empty loop": ("fanuc", "O1\nWHILE[1EQ1]DO1\nEND1\nM30\n"),
    "the same value again and again": ("fanuc", "O1\nN10 #1=5\nG0 X[#1]\nGOTO 10\n"),
    "waits for what check cannot know": ("fanuc", "O1\nN10 IF[#1000EQ0]GOTO10\nM30\n"),
    "nct": ("nct", "N10 G0 X50\nGOTO 10\n"),
    "fagor": ("fagor", "%L,1\nN10 G00 X50\n(GOTO N10)\n"),
    "fagor with moves": ("fagor", "N10 G00 X50\nG01 X60 F100\n(GOTO N10)\n"),
    "sinumerik": ("sinumerik", "AGAIN: G0 X50\nGOTOB AGAIN\n"),
    "sinumerik from the start": ("sinumerik", "G0 X50\nG0 X60\nGOTOS\n"),
}
NEVER_THE_SAME = {
    "counts": ("fanuc", "O1\n#1=0\nN10 #1=#1+1\nGOTO 10\n"),
    "wanders": ("fanuc", "O1\nG0 C0\nN10 G0 H1.\nM99 P10\n"),
    "fagor counts": ("fagor", "(P1=0)\nN10 (P1=P1+1)\n(GOTO N10)\n"),
    "sinumerik counts": ("sinumerik", "R1=0\nAGAIN: R1=R1+1\nGOTOB AGAIN\n"),
}
LONG = {
    "a call repeated 9999 times": ("fanuc", "O1\nM98 P99990002\nM30\nO2\nG0 X50.\nG0 X60.\nM99\n"),
    "nested loops": ("fanuc", "O1\n#1=0\nWHILE[#1LT300]DO1\n#2=0\nWHILE[#2LT300]DO2\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nM30\n"),
    "many lines": ("fanuc", "O1\n" + "G0 X50.\n" * 60000 + "M30\n"),
    "fagor repeats": ("fagor", "N10 G00 X50\nN20 X60\n(RPT N10,N20) N9999\nM30\n"),
}


class EndlessCheck(Case):
    def check(self, language, program, *more):
        return self.polyturn("check", "--language", language, *more, self.write("P0001.nc", program), timeout=60)   # a hang, not a slow computer

    def ends_with_a_diagnosis(self, done):
        self.assertEqual(done.status, 1, done.said())
        self.assertEqual([a["text"] for a in done.alarms], ["the program goes round here without an end"], done.said())
        self.assertGreaterEqual(done.alarms[0].get("line", 0), 1)
        self.assertIn("--most-blocks", done.alarms[0]["remedy"])

    def test_what_goes_round_is_found(self):
        for name, (language, program) in ROUND.items():
            with self.subTest(name):
                done = self.check(language, program, "--most-blocks", "0")
                self.ends_with_a_diagnosis(done)
                self.assertLess(len(done.out), 200_000_000, "bounded")

    def test_what_is_never_the_same_ends_by_the_number_of_blocks(self):
        for name, (language, program) in NEVER_THE_SAME.items():
            with self.subTest(name):
                self.ends_with_a_diagnosis(self.check(language, program, "--most-blocks", "100000"))

    def test_the_number_of_blocks_has_a_default(self):
        self.ends_with_a_diagnosis(self.check("fanuc", NEVER_THE_SAME["counts"][1]))

    def test_a_long_program_that_ends_is_left_alone(self):
        for name, (language, program) in LONG.items():
            with self.subTest(name):
                done = self.check(language, program)
                self.assertEqual(done.status, 0, done.said())
                self.assertTrue(done.of("stop"), done.said())


if __name__ == "__main__":
    unittest.main()
