#!/usr/bin/env python3
"""INIT and START of sinumerik (part 3, 7.14): a program begins those of other channels, read through and on the running machine."""
import unittest

from polyturn_runner import Case

HEAD = "G18 G71 G90 G94 G500 DIAMOF\n"
LOWER = HEAD + "G0 X50 Z5\nG4 F3\nM30\n"
UPPER = HEAD + 'INIT(2,"LOWER","S")\nSTART(2)\nG4 F1\nWAITE(2)\nG4 F2\nM30\n'


class ProgramStart(Case):
    def both(self, verb, text, *options, status=0, files=(("LOWER.MPF", LOWER),), programs=()):
        for name, content in files:
            self.write(name, content)
        program = self.write("UPPER.MPF", text)
        setup = self.write("setup.toml", "[channel.1]\npos = { X = 77.0, Z = 33.0 }\n[channel.2]\npos = { X = 77.0, Z = 33.0 }\n")
        done = self.polyturn(verb, "--language", "sinumerik", "--set", "N1000=0", "--setup", setup, *options, f"1={program}", *programs)
        self.assertEqual(done.status, status, done.said())
        return done

    def test_the_other_channels_program_is_read_too(self):
        done = self.both("check", UPPER)
        self.assertEqual([(e["pos"]["X"], e["pos"]["Z"]) for e in done.of("move", ch=2)], [(50, 5)], done.said())
        self.assertEqual(done.of("select")[0]["channel"], 2)
        self.assertEqual(done.of("start")[0]["channels"], [2])
        order = [(e["ev"], e["ch"]) for e in done.events if e["ev"] in ("start", "stop")]
        self.assertEqual(order, [("start", 1), ("stop", 2), ("stop", 1)], "WAITE: the other one ends first")
        self.assertTrue(done.of("sync", ok=True))

    def test_it_runs_beside_the_one_that_started_it(self):
        done = self.both("run", UPPER, "--virtual")
        at = {(e["ch"], e["seconds"]): e["t"] for e in done.of("dwell")}
        self.assertAlmostEqual(at[2, 3], at[1, 1], delta=1.0)   # both at once; the other one drives to its place first
        self.assertAlmostEqual(at[1, 2], at[2, 3] + 3, delta=0.2, msg=done.said())
        self.assertEqual([c["ch"] for c in done.of("summary")[0]["channels"]], [1, 2])
        ends = {e["ch"]: e["t"] for e in done.of("stop", reason="M30")}
        self.assertGreater(ends[1], ends[2])

    def test_the_run_lasts_until_the_started_one_ends(self):
        done = self.both("run", HEAD + 'INIT(2,"LOWER")\nSTART(2)\nM30\n', "--virtual")
        self.assertTrue(done.of("stop", ch=2, reason="M30"), done.said())
        self.assertGreater(done.of("summary")[0]["seconds"], 3)

    def test_one_after_the_other(self):
        two = HEAD + 'INIT(2,"LOWER")\nSTART(2)\nWAITE(2)\nINIT(2,"SECOND")\nSTART(2)\nWAITE(2)\nM30\n'
        for verb, options in (("check", ()), ("run", ("--virtual",))):
            with self.subTest(verb):
                done = self.both(verb, two, *options, files=(("LOWER.MPF", LOWER), ("SECOND.MPF", HEAD + "G0 X60 Z7\nM30\n")))
                self.assertEqual([(e["pos"]["X"], e["pos"]["Z"]) for e in done.of("move", ch=2)], [(50, 5), (60, 7)], done.said())

    def test_programs_that_start_each_other_are_not_read_for_ever(self):
        files = (("LOWER.MPF", HEAD + 'INIT(1,"UPPER")\nWAITE(1)\nSTART(1)\nM30\n'),)
        self.assertTrue(self.both("check", HEAD + 'INIT(2,"LOWER")\nSTART(2)\nM30\n', files=files, status=1).alarms)

    def test_a_marker_is_named_as_the_language_writes_it(self):
        upper, lower = self.write("UPPER.MPF", "G4 F2\nWAITM(510,1,2)\nM30\n"), self.write("LOWER.nc", "M510 P12\nG4 P1.\nM510 P12\nM30\n")
        for verb, options, said in (("check", (), {2: " waits at M510 for L1"}), ("run", ("--virtual",), {2: ": L1 (M510)"})):
            with self.subTest(verb):
                done = self.polyturn(verb, "--language", "1=sinumerik", "--language", "2=nct", *options, f"1={upper}", f"2={lower}")
                self.assertEqual([(e["ch"], said[e["ch"]] in e["text"]) for e in done.of("alarm")], [(2, True)], done.said())
        lower.write_text("G4 P1.\nM30\n")
        for verb, options, said in (("check", (), " waits at WAITM(510) for L2"), ("run", ("--virtual",), ": L2 (WAITM(510))")):
            with self.subTest(verb):
                done = self.polyturn(verb, "--language", "1=sinumerik", "--language", "2=nct", *options, f"1={upper}", f"2={lower}")
                self.assertEqual([(e["ch"], said in e["text"]) for e in done.of("alarm")], [(1, True)], done.said())

    def test_they_meet_at_markers(self):
        files = (("LOWER.MPF", HEAD + "WAITM(1,1,2)\nG0 X50 Z5\nM30\n"),)
        text = HEAD + 'INIT(2,"LOWER")\nSTART(2)\nG4 F1\nWAITM(1,1,2)\nM30\n'
        self.assertEqual(self.both("check", text, files=files).of("sync")[0]["meetings"], 1)
        done = self.both("run", text, "--virtual", files=files)
        self.assertGreaterEqual(done.of("move", ch=2)[0]["t"], 1.0)

    def test_the_started_program_is_read_in_the_language_chosen_for_its_channel(self):
        files = (("LOWER.MPF", "#1=25.\nG0 X[#1*2] Z5.\nM30\n"),)
        text = HEAD + 'INIT(2,"LOWER")\nSTART(2)\nWAITE(2)\nM30\n'
        for verb, options in (("check", ()), ("run", ("--virtual",))):
            with self.subTest(verb):
                done = self.both(verb, text, "--language", "2=nct", *options, files=files)
                self.assertEqual([(e["pos"]["X"], e["pos"]["Z"]) for e in done.of("move", ch=2)], [(50, 5)], done.said())

    def test_a_channel_that_runs_takes_no_other_program(self):
        lower = self.write("OTHER.MPF", HEAD + "G4 F5\nM30\n")
        done = self.both("run", HEAD + 'G4 F1\nINIT(2,"LOWER")\nM30\n', "--virtual", programs=(f"2={lower}",), status=1)
        self.assertTrue(done.alarms, done.said())
        done = self.both("run", HEAD + "G4 F1\nSTART(2)\nM30\n", "--virtual", programs=(f"2={lower}",))   # it runs on
        self.assertEqual(len(done.of("stop", ch=2, reason="M30")), 1)

    def test_nothing_is_selected(self):
        for verb, options in (("check", ()), ("run", ("--virtual",))):
            with self.subTest(verb):
                done = self.both(verb, HEAD + "START(2)\nM30\n", *options, status=1)
                self.assertTrue(done.alarms, done.said())


if __name__ == "__main__":
    unittest.main()
