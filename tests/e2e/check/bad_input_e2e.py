#!/usr/bin/env python3
"""Bad input is a diagnosis with file, line, column, text and remedy, and an exit status; never a crash or silence."""
import unittest

from polyturn_runner import Case

GOOD = "G98 G0 X50. Z2.\nG1 Z-10. F200.\nM30\n"


class BadPrograms(Case):
    def test_table(self):
        # name, program, alarm number as the operator of a fanuc control knows it (None: any), line, column (0: any)
        rows = [
            ("unknown G code", b"G0 X50.\nG999 X1.\nM30\n", "010", 2, 1),
            ("missing feed", b"G98 G0 X50. Z2.\nG1 Z-10.\nM30\n", "011", 2, 0),
            ("arc that does not fit", b"G98 G0 X50. Z0.\nG1 X40. F200.\nG2 X60. Z-10. I1. K0.\nM30\n", "020", 3, 0),
            ("radius too small", b"G98 G0 X50. Z0.\nG2 X50. Z-20. R5. F200.\nM30\n", None, 2, 0),
            ("subprogram missing", b"G0 X50.\nM98 P7777\nM30\n", "078", 2, 0),
            ("address without number", b"G0 X\nM30\n", None, 1, 4),
            ("second point", b"G0 X4.0.\nM30\n", None, 1, 0),
            ("number out of range", b"G0 X99999999999.\nM30\n", None, 1, 0),
            ("unknown letter", b"G0 X50.\nG0 @5\nM30\n", None, 2, 4),
            ("cut off in a word", b"G0 X50.\nG1 X", None, 2, 0),
            ("target outside the stroke", b"G0 X50.\nG0 X5000.\nM30\n", None, 2, 0),
            ("binary", bytes(range(256)) * 40, None, 0, 0),
            ("an executable", b"\x7fELF\x02\x01\x01" + bytes(500), None, 0, 0),
            ("UTF-16", ("\ufeff" + GOOD).encode("utf-16-le"), None, 0, 0),
        ]
        for name, content, number, line, column in rows:
            with self.subTest(name):
                done = self.polyturn("check", self.write("bad.nc", content))
                self.assertIn(done.status, (1, 2), done.said())
                self.assertTrue(done.alarms or done.err.strip(), "silence\n" + done.said())
                if number or line:
                    self.assertTrue(done.alarms, done.said())
                    alarm = done.alarms[0]
                    self.assertIn("bad.nc", alarm.get("file", ""), alarm)
                    self.assertEqual(alarm.get("line"), line, alarm)
                    self.assertTrue(alarm.get("text"), alarm)
                    if number:
                        self.assertEqual(str(alarm.get("number")).zfill(3), number, alarm)
                    if column:
                        self.assertEqual(alarm.get("column"), column, alarm)

    def test_nested_too_deep(self):
        program = self.write("O1.nc", "O0001\nM98 P0001\nM30\n")
        done = self.polyturn("check", program)
        self.assertEqual(done.status, 1, done.said())

    def test_file_that_cannot_be_read(self):
        for path in (self.folder / "nowhere.nc", self.folder):
            with self.subTest(str(path)):
                done = self.polyturn("check", path)
                self.assertEqual(done.status, 2, done.said())
                self.assertIn(path.name, done.err + done.out)


class ForeignLineEnds(Case):
    def test_read_as_if_they_were_native(self):
        plain = self.polyturn("check", self.write("a.nc", GOOD))
        self.assertEqual(plain.status, 0, plain.said())
        for name, content in (("CRLF", GOOD.replace("\n", "\r\n")), ("CR", GOOD.replace("\n", "\r")), ("percent", "%\n" + GOOD + "%\n"), ("no end of line", GOOD.rstrip("\n"))):
            with self.subTest(name):
                done = self.polyturn("check", self.write("a.nc", content))
                self.assertEqual(done.status, 0, done.said())
                moves = [[{k: v for k, v in e.items() if k != "line"} for e in x.of("move")] for x in (plain, done)]
                self.assertEqual(moves[0], moves[1])


class BadSettings(Case):
    def test_exit_status_2_with_a_reason(self):
        good = self.write("good.nc", GOOD)
        bad_toml = self.write("bad.toml", "[channel.1\nmachine = 5\n")
        wrong_type = self.write("type.toml", '[channel.1]\nmachine = "left"\n')
        bad_job = self.write("bad.job.toml", "name = 5\n[programs\n")
        params = self.write("bad.params", "N0304 A1=20000\nN0304 A1=fast\n")
        rows = [
            (["--set", "N9999=1"], "N9999"), (["--set", "N0304 A1=fast"], "N0304"), (["--set", "N0304 L1=1"], "N0304"),
            (["--set", "PT_HORIZON=1"], "PT_HORIZON"), (["--set", "nonsense"], "nonsense"), (["--set", "N1300#9 L1=1"], "N1300"),
            (["--param-file", params], "2"), (["--param-file", self.folder / "none.params"], "none.params"),
            (["--setup", bad_toml], "bad.toml"), (["--setup", wrong_type], "type.toml"), (["--setup", self.folder / "none.toml"], "none.toml"),
            (["--machine", self.folder / "none.machine"], "none.machine"), (["--language", "klingon"], "klingon"), (["--no-such-option"], "no-such-option"),
        ]
        for arguments, word in rows:
            with self.subTest(str(arguments)):
                done = self.polyturn("check", *arguments, good)
                self.assertEqual(done.status, 2, done.said())
                self.assertIn(word, done.err + done.out)
        for arguments in (["check", bad_job], ["check"], ["no-such-verb"], ["run", "--virtual", "--scenario", bad_toml, good]):
            with self.subTest(str(arguments)):
                done = self.polyturn(*arguments)
                self.assertEqual(done.status, 2, done.said())
                self.assertTrue(done.err.strip() or done.out.strip())


class AlarmsWhileRunning(Case):
    def test_table(self):
        rows = [
            ("feed per revolution with the spindle at rest", "G99\nG0 X50. Z2.\nG1 Z-10. F0.2\nM30\n"),
            ("thread without spindle", "G99\nG0 X50. Z2.\nG32 Z-10. F1.5\nM30\n"),
            ("lead times speed beyond the axis", "G99\nG97 S3000 M3\nG0 X50. Z20.\nG32 Z-100. F8.\nM30\n"),
        ]
        for name, text in rows:
            with self.subTest(name):
                done = self.polyturn("run", "--virtual", self.write("run.nc", text))
                self.assertEqual(done.status, 1, done.said())
                self.assertTrue(done.alarms, done.said())
                self.assertIn("run.nc", done.alarms[0].get("file", ""), done.alarms)
                self.assertEqual(done.alarms[0].get("line"), 3 if "lead" not in name else 4, done.alarms)

    def test_the_other_channel_goes_on(self):
        good = self.write("good.nc", "G98\nG0 X100. Z5.\nG1 Z-50. F2000.\nM30\n")
        bad = self.write("bad.nc", "G0 X100. Z5.\nG999\nM30\n")
        done = self.polyturn("run", "--virtual", f"1={good}", f"2={bad}")
        self.assertEqual(done.status, 1, done.said())
        self.assertEqual(done.alarms[0].get("ch"), 2)
        self.assertTrue(done.of("stop", ch=1, reason="M30"), done.said())


if __name__ == "__main__":
    unittest.main()
