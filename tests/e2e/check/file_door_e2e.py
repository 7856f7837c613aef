#!/usr/bin/env python3
"""Files that are none, names that lead elsewhere, keys that have no end: refused at once, by whoever is told to read them."""
import os
import subprocess
import unittest

from polyturn_runner import POLYTURN, SOURCE, Case, LiveCase

AT_ONCE = 20   # seconds; a reader that waits for a pipe's writer never comes back
JOB = '[programs]\n1 = { file = "a.nc" }\n'


class NoFile(Case):
    def pipe(self, name):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        os.mkfifo(path)
        return path

    def refused(self, *arguments):
        done = self.polyturn(*arguments, timeout=AT_ONCE)
        self.assertIn(done.status, (1, 2), done.said())
        self.assertIn("pipe", done.out + done.err, done.said())

    def test_pipes_are_refused_wherever_a_file_is_named(self):
        program = self.write("a.nc", "G0 X50.\nM30\n")
        self.write("a.job.toml", JOB)
        for verb in (["check"], ["run", "--virtual"]):
            with self.subTest(verb=verb, what="program"):
                self.refused(*verb, self.pipe(f"{verb[0]}.nc"))
            with self.subTest(verb=verb, what="job"):
                self.refused(*verb, self.pipe(f"{verb[0]}.job.toml"))
            with self.subTest(verb=verb, what="setup"):
                self.refused(*verb, program, "--setup", self.pipe(f"{verb[0]}.setup.toml"))
            with self.subTest(verb=verb, what="parameters"):
                self.refused(*verb, program, "--param-file", self.pipe(f"{verb[0]}.params"))
            with self.subTest(verb=verb, what="machine"):
                self.pipe(f"{verb[0]}-machine/machine.params")
                self.refused(*verb, program, "--machine", self.folder / f"{verb[0]}-machine")
        with self.subTest(what="scenario"):
            self.refused("run", "--virtual", program, "--scenario", self.pipe("s.toml"))
        with self.subTest(what="room, compensation, PLC of a machine"):
            parameters = (SOURCE / "examples/machines/twin-turret/machine.params").read_bytes()
            for name in ("machine.toml", "machine.compensation", "plc.so"):
                self.write_machine(f"m-{name}", parameters)
                self.pipe(f"m-{name}/{name}")
                self.refused("run", "--virtual", program, "--machine", self.folder / f"m-{name}")

    def write_machine(self, name, parameters):
        (self.folder / name).mkdir()
        (self.folder / name / "machine.params").write_bytes(parameters)

    def test_a_called_program_that_is_a_pipe_is_not_there(self):
        self.pipe("O7.nc")
        done = self.polyturn("check", self.write("a.nc", "M98 P7\nM30\n"), timeout=AT_ONCE)
        self.assertEqual(done.alarms[0]["number"], 78, done.said())

    def test_keys_without_end(self):
        for key in ("k." * 50_000 + "k = 1\n", "[" + "k." * 50_000 + "k]\n", "a = " + "[" * 100_000 + "\n"):
            for verb in (["check"], ["run", "--virtual"]):
                done = self.polyturn(*verb, self.write("deep.job.toml", key), timeout=AT_ONCE)
                self.assertEqual(done.status, 2, done.said())
                self.assertIn("PT0013", done.out + done.err, done.said())


class Running(LiveCase):
    def test_the_controller_outlives_what_it_is_told_to_select(self):
        self.start()
        os.mkfifo(self.folder / "p.nc")
        os.mkfifo(self.folder / "p.job.toml")
        self.write("deep.job.toml", "k." * 50_000 + "k = 1\n")
        for words in ("p.job.toml", "deep.job.toml"):
            done = self.polyturn("press", "--instance", self.name, "select", words, timeout=AT_ONCE)
            self.assertNotEqual(done.status, 0, done.said())
        self.polyturn("press", "--instance", self.name, "select", "L1=p.nc", timeout=AT_ONCE)
        self.polyturn("press", "--instance", self.name, "machine_on")
        self.polyturn("press", "--instance", self.name, "reference", "all")
        self.polyturn("press", "--instance", self.name, "cycle_start", "L1", timeout=AT_ONCE)
        self.assertEqual(self.polyturn("status", "--instance", self.name, timeout=AT_ONCE).status, 0)
        self.assertEqual(self.stop(), 0, "SIGTERM ends it")

    def test_an_operator_reaches_program_folders_only(self):
        outside = self.folder.parent / (self.folder.name + "-outside.nc")
        outside.write_text("root:$6$secret\n")
        self.addCleanup(outside.unlink)
        self.write("in.nc", "G0 X50.\nM30\n")
        (self.folder / "link.nc").symlink_to(outside)
        self.write("far.job.toml", f'[programs]\n1 = {{ file = "{outside}" }}\n')
        self.write("near.job.toml", '[programs]\n1 = { file = "in.nc" }\n')
        self.start("PT_LEVEL_OUT=1")
        # As long as the controller has no user, everybody is the maker; then who is not logged in has the level of PT_LEVEL_OUT.
        added = subprocess.run([POLYTURN, "users", "add", "chief", "maker", "--instance", self.name], input=b"secret-1\n", capture_output=True, timeout=AT_ONCE)
        self.assertEqual(added.returncode, 0, added.stderr)
        reached = {name: self.polyturn("press", "--instance", self.name, "select", name) for name in
                   ("L1=in.nc", "near.job.toml", f"L1={outside}", "L1=link.nc", "far.job.toml", "L1=/etc/passwd", "\tL1=/etc/passwd")}
        for name in ("L1=in.nc", "near.job.toml"):
            self.assertEqual(reached[name].status, 0, reached[name].said())
        for name in (f"L1={outside}", "L1=link.nc", "far.job.toml", "L1=/etc/passwd", "\tL1=/etc/passwd"):
            with self.subTest(name):
                self.assertNotEqual(reached[name].status, 0, reached[name].said())
                self.assertIn("PT0007", reached[name].out + reached[name].err, reached[name].said())
                self.assertNotIn("secret", reached[name].out + reached[name].err)

    def test_what_is_measured_on_an_example_machine_is_not_written_into_the_examples(self):
        shipped = POLYTURN.parents[3] / "examples/machines/twin-turret"
        kept, own = shipped / "machine.compensation", self.folder / "store/machines/twin-turret/machine.compensation"
        self.assertFalse(kept.exists())
        self.addCleanup(lambda: kept.unlink(missing_ok=True))
        self.start()
        press = lambda *words: self.polyturn("press", "--instance", self.name, *words)
        program = self.write("cells.nc", "O1\nG10 L50\nN10000 R-20\nG11\nM30\n")
        for words in ("machine_on", "reference all"):
            press(*words.split())
        self.assertEqual(press("select", f"L1={program}").status, 0)
        self.wait_for(lambda: press("cycle_start", "L1").status == 0 and self.polyturn("alarms", "--instance", self.name).status == 0 and (own.exists() or kept.exists()), 20, "the cell")
        self.assertFalse(kept.exists(), "in the examples")
        self.assertIn("10000=-0.02", own.read_text())


if __name__ == "__main__":
    unittest.main()
