#!/usr/bin/env python3
"""What the command line promises to scripts: version, help, exit statuses, parameters of a private controller."""
import shutil
import subprocess
import unittest

from polyturn_runner import POLYTURN, Case


class Usage(Case):
    def test_version_and_help(self):
        done = self.polyturn("--version")
        self.assertEqual(done.status, 0)
        self.assertRegex(done.out, r"\d+\.\d+\.\d+")
        for verb in ("check", "run", "start", "press", "params", "status", "clean"):
            with self.subTest(verb):
                done = self.polyturn(verb, "--help")
                self.assertEqual(done.status, 0, done.said())
                self.assertTrue(done.out.strip())

    def test_events_of_a_check(self):
        program = self.write("a.nc", "G97 S1000 M3\nN10 G0 X50. Z2.\nN20 G1 Z-10. F0.2\nN30 G4 U1.5\nN40 M8\nN50 M30\n")
        done = self.polyturn("check", program)
        self.assertEqual(done.status, 0, done.said())
        for event in done.events:
            self.assertIn("ev", event)
            self.assertTrue("ch" in event or event["ev"] == "sync", event)
        self.assertEqual([e["kind"] for e in done.of("move")], ["rapid", "linear"])
        cut = done.of("move")[1]
        self.assertEqual((cut["n"], cut["line"], cut["pos"]["X"], cut["pos"]["Z"]), (20, 3, 50, -10))
        self.assertEqual(cut["feed"], {"mode": "per_rev", "value": 0.2})
        self.assertEqual(done.of("dwell")[0]["seconds"], 1.5)
        self.assertEqual([e["code"] for e in done.of("aux")], ["M3", "M8"])
        self.assertEqual(done.of("stop")[0]["reason"], "M30")

    def test_quiet_keeps_alarms_and_summary(self):
        program = self.write("a.nc", "G98\nG0 X50. Z2.\nG1 Z-10. F500.\nM30\n")
        done = self.polyturn("run", "--virtual", "--quiet", program)
        self.assertEqual(done.status, 0, done.said())
        self.assertTrue(set(e["ev"] for e in done.events) <= {"alarm", "message", "summary"}, done.out)
        self.assertEqual(len(done.of("summary")), 1)

    def test_a_job_that_waits_for_nobody_ends_with_status_1(self):
        one = self.write("one.nc", "M500 P12\nM30\n")
        two = self.write("two.nc", "M30\n")
        done = self.polyturn("run", "--virtual", f"1={one}", f"2={two}")
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue(done.of("stop", ch=1, reason="waiting"), done.said())

    def test_people_read_the_language_that_the_machine_is_set_to(self):
        program = self.write("O0001.nc", "G98 G0 X60.\nG1 X50. F0\nM30\n")
        said = {}
        for code in ("en", "ru", "cs", "hu"):
            done = self.polyturn("run", "--virtual", "--language", "fanuc", "--set", f"PT_DISPLAY_LANGUAGE={code}", program, "--report")
            self.assertTrue(done.alarms, done.said())
            said[code] = (done.err, done.out.split("}")[-1])
            self.assertEqual(done.alarms[0]["text"], done.alarms[0]["text"].encode("ascii", "replace").decode(), "events stay English")
        self.assertEqual(len({text for text, report in said.values()}), 4, said)
        self.assertEqual(len({report for text, report in said.values()}), 4, said)

    def test_a_build_folder_anywhere_finds_the_machines(self):
        share = POLYTURN.parent.parent / "share/polyturn"
        self.assertTrue((share / "examples/machines").is_dir(), "what the build makes beside bin")
        (self.folder / "build/share").mkdir(parents=True)
        (self.folder / "build/share/polyturn").symlink_to(share.resolve())
        shutil.copytree(POLYTURN.parent, self.folder / "build/bin", ignore=lambda folder, names: [n for n in names if not n.startswith("polyturn") or n == "polyturn-hmi"])
        program = self.write("a.nc", "G0 X50.\nM30\n")
        done = subprocess.run([self.folder / "build/bin/polyturn", "check", program], capture_output=True, cwd=self.folder, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
