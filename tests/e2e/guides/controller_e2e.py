#!/usr/bin/env python3
"""A controller that stays: start, status, press, params, and what is still there after it has been started again.
In real time, so the figures are generous; what is exact is tested in virtual time."""
import json
import os
import pathlib
import signal
import time
import unittest

from polyturn_runner import LiveCase


class Controller(LiveCase):
    def press(self, *words):
        done = self.polyturn("press", "--instance", self.name, *words)
        self.assertEqual(done.status, 0, done.said())

    def status(self):
        done = self.polyturn("status", "--json", "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())
        return json.loads(done.out)

    def channel(self, number):
        return next(c for c in self.status()["channels"] if c["ch"] == number)

    def test_runs_a_program_that_an_operator_starts_holds_and_resets(self):
        program = self.write("cut.nc", "G98 G0 X80. Z20.\nG1 Z-100. F600.\nM30\n")
        self.start()
        self.press("machine_on")
        self.press("select", f"L1={program}")
        self.press("cycle_start", "L1")
        self.wait_for(lambda: self.channel(1)["state"] == "running", 10, "the program to run")
        self.press("feed_hold", "L1")
        self.wait_for(lambda: self.channel(1)["state"] == "held", 5, "the hold")
        self.press("reset", "L1")
        self.wait_for(lambda: self.channel(1)["state"] == "reset", 5, "the reset")
        self.assertEqual(self.stop(), 0)

    def test_a_selected_job_is_read_in_the_language_that_it_names(self):
        self.write("TURN.MPF", "DIAMON G90 G94 G0 X80 Z20\nG1 X60 F2000\nM30\n")     # fanuc: G90 is a cycle, X80 are 80 um
        job = self.write("turn.job.toml", '[programs]\n1 = { file = "TURN.MPF", language = "sinumerik" }\n')
        self.start()
        self.press("machine_on")
        self.press("select", job)
        self.press("cycle_start", "L1")
        self.wait_for(lambda: self.channel(1)["state"] == "ended", 20, "the program to end")
        at = lambda name: next(a for a in self.status()["axes"] if a["axis"] == name)["act"]
        self.wait_for(lambda: abs(at("A1") - 30) < 0.005 and abs(at("A2") - 20) < 0.005, 5, "the slides to stand at X60 Z20")
        self.assertEqual(self.status()["alarms"], 0)
        self.press("mode", "L1=mdi")
        self.press("mdi", "L1", "G98 G0 X80.")         # a block by hand is in the machine's language
        self.press("cycle_start", "L1")
        self.wait_for(lambda: abs(at("A1") - 40) < 0.005, 10, "the slide to stand at X80")
        plain = self.write("plain.nc", "G98 G0 X70. Z10.\nM30\n")
        self.press("mode", "L1=auto")
        self.press("select", f"L1={plain}")            # without a job, so is a program
        self.press("cycle_start", "L1")
        self.wait_for(lambda: abs(at("A1") - 35) < 0.005, 10, "the slide to stand at X70")

    def test_what_a_selected_job_has_otherwise_is_told_and_what_is_entered_holds(self):
        self.write("part.nc", "G98 G0 X70. Z10.\nM30\n")
        other = self.write("other.params", "N0304 A1=11000\n")
        job = self.write("part.job.toml", f'machine = "{other}"\nsetup = "part.setup.toml"\n[programs]\n1 = {{ file = "part.nc" }}\n[zeros]\n1 = {{ G54 = {{ X = 1.5, Z = -150.0 }}, G55 = {{ Z = -20.0 }} }}\n')
        self.write("part.setup.toml", "[channel.1.offset.5]\ngeometry = { X = 40.5, T = 3 }\n[channel.1.offset.6]\ngeometry = { X = 0.0 }\n")
        self.start()
        self.press("machine_on")
        done = self.polyturn("set", "zero L1 G55 Z=-20", "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())
        done = self.polyturn("press", "--instance", self.name, "select", job)
        self.assertEqual(done.status, 0, done.said())
        self.assertIn("the job is for the machine", done.said())
        self.assertIn("L1 G54 X = 1.5000, entered is 0.0000", done.said())
        self.assertIn("L1 G54 Z = -150.0000, entered is 0.0000", done.said())
        self.assertIn("L1: other offsets than in the job's setup are entered, and those hold: 5\n", done.said())
        self.assertNotIn("G55", done.said())
        done = self.polyturn("zeros", "list", "L1", "--instance", self.name, "--json")
        self.assertNotIn("-150", done.out)
        for entered in ("Z=-150", "X=1.5"):
            done = self.polyturn("set", f"zero L1 G54 {entered}", "--instance", self.name)
            self.assertEqual(done.status, 0, done.said())
        zeros = lambda: self.polyturn("zeros", "list", "L1", "--instance", self.name, "--json").out
        self.wait_for(lambda: "-150" in zeros() and "1.5" in zeros(), 10, "the zeros to be entered")
        done = self.polyturn("press", "--instance", self.name, "select", job)
        self.assertEqual(done.status, 0, done.said())
        self.assertIn("the job is for the machine", done.said())
        self.assertNotIn("G54", done.said())

    def test_a_killed_controllers_program_is_not_its_successors(self):
        program = self.write("there.nc", "G98 G1 X100. F5000\nX80.\nX100.\nM30\n")
        for life in range(3):
            self.start()
            self.assertEqual(self.channel(1)["line"], 0, f"life {life}: a block of before stands in the channel")
            self.press("machine_on")
            self.press("select", f"L1={program}")
            self.press("cycle_start", "L1")
            self.wait_for(lambda: self.channel(1)["state"] == "ended", 10, f"the program of life {life} to end")
            self.assertEqual(self.status()["alarms"], 0)
            at = lambda: next(a for a in self.status()["axes"] if a["axis"] == "A1")["act"]
            self.wait_for(lambda: abs(at() - 50) < 0.005, 5, "the slide to come to rest at 50")   # the program ends before it does
            self.stop(signal.SIGKILL)      # what it had in memory stays there

    def test_a_message_of_the_machines_builder_is_told_with_its_words(self):
        self.start()
        self.press("machine_on")
        self.press("mode", "L1=mdi")
        self.press("mdi", "L1", "G97", "M3", "S500")
        self.press("cycle_start", "L1")
        self.wait_for(lambda: abs(self.status()["spindles"][0]["speed"]) > 100, 10, "the spindle to turn")

        def told():
            self.polyturn("press", "--instance", self.name, "hand_key", "L1", "M11")   # the spindle's block may not have ended yet
            time.sleep(0.5)
            return [a for a in json.loads(self.polyturn("alarms", "--json", "--instance", self.name).out) if a.get("number") == "PT0539"]
        self.wait_for(told, 15, "the message of the PLC")
        alarm = told()[0]
        self.assertIn("the chuck must not open while the spindle turns; cause: M11 before the spindle was stopped. Program M5 before M11.", alarm["text"])
        self.assertIn("патрон нельзя разжать при вращении шпинделя", alarm["builder"]["ru"]["text"])
        self.assertEqual(alarm["builder"]["cs"]["remedy"], "Naprogramujte M5 před M11.")

    def test_a_block_by_hand_is_entered_and_moves_only_with_a_start(self):
        self.start()
        self.press("machine_on")
        before = self.axis("A1")
        self.press("mdi", "L1", "G98 G0 U10.")
        self.wait_for(lambda: any(a.get("number") == "PT0536" for a in json.loads(self.polyturn("alarms", "--json", "--instance", self.name).out)), 10, "the refusal in automatic mode")
        self.assertEqual((self.channel(1)["mode"], self.channel(1).get("mdi")), ("auto", None))
        self.press("mode", "L1=mdi")
        self.press("mdi", "L1", "G98 G0 U10.")
        self.press("mdi", "L1", "M99")
        time.sleep(0.5)
        self.assertEqual((self.axis("A1"), self.channel(1)["state"]), (before, "reset"))
        self.press("cycle_start", "L1")
        self.wait_for(lambda: [line["state"] for line in self.channel(1)["mdi"]] == ["done", "done"], 10, "both blocks")
        self.wait_for(lambda: abs(self.axis("A1") - before - 5) < 1e-6, 5, "the way")
        self.assertEqual((self.channel(1)["parts"], self.channel(1)["mode"]), (0, "mdi"))
        self.press("hand_key", "L1", "G0 U-10.")
        self.wait_for(lambda: abs(self.axis("A1") - before) < 1e-6, 10, "the way back by a key that is a start")
        self.assertEqual(self.stop(), 0)

    def test_selecting_a_job_enters_how_many_parts_it_wants(self):
        self.start()
        for n in (1, 2):
            self.write(f"O{n}.nc", f"O{n}\nM30\n")
        job = '[programs]\n1 = {{ file = "O1.nc" }}\n2 = {{ file = "O2.nc" }}\n{}'
        self.write("some.job.toml", job.format("[parts]\nwanted = 25\n"))
        self.write("any.job.toml", job.format(""))

        def wanted():
            return [self.polyturn("params", "get", f"N2308 L{n}", "--instance", self.name).out.split()[-1] for n in (1, 2)]
        self.press("select some.job.toml")
        self.wait_for(lambda: wanted() == ["25", "25"], 5, "the parts that the job wants")
        self.press("select any.job.toml")
        time.sleep(0.3)
        self.assertEqual(wanted(), ["25", "25"], "a job that does not say it changes nothing")

    def test_a_parameter_is_on_disk_when_set_returns(self):
        self.start()
        done = self.polyturn("params", "set", "N1600 L1=2.75", "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())
        self.stop(signal.SIGKILL)          # the power fails
        time.sleep(0.3)
        self.start()
        done = self.polyturn("params", "get", "N1600 L1", "--instance", self.name)
        self.assertEqual(float(done.out.split()[-1]), 2.75, done.said())
        refused = self.polyturn("params", "set", "N1600 L1=fast", "--instance", self.name)
        self.assertEqual(refused.status, 2, refused.said())
        self.assertEqual(self.stop(), 0)

    def test_an_import_is_refused_as_a_whole_with_every_fault_named(self):
        self.start()
        bad = self.write("bad.params", "N1600 L1=fast\nN9999=1\n")
        done = self.polyturn("params", "import", bad, "--instance", self.name)
        self.assertEqual(done.status, 2, done.said())
        self.assertIn("fast", done.err)
        self.assertIn("N9999", done.err)
        # Each line is right, together they contradict: a ring of masters, and an axis of a channel that does not exist.
        bad = self.write("contradiction.params", "N1600 L1=2.5\nN2101 A1=3\nN2101 A3=1\nN0002 A5=7\n")
        done = self.polyturn("params", "import", bad, "--instance", self.name)
        self.assertEqual(done.status, 2, done.said())
        self.assertGreaterEqual(done.err.count("alarm"), 2, done.said())
        got = self.polyturn("params", "get", "N1600 L1", "--instance", self.name)
        self.assertNotEqual(float(got.out.split()[-1]), 2.5, got.said())
        good = self.write("good.params", "N1600 L1=2.5 ; depth of cut\nN1601 L1=0.7\n")
        done = self.polyturn("params", "import", good, "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())
        got = self.polyturn("params", "get", "N1601 L1", "--instance", self.name)
        self.assertEqual(float(got.out.split()[-1]), 0.7)
        self.assertEqual(self.stop(), 0)

    def test_an_offset_is_set_on_a_running_controller_and_kept(self):
        self.start()
        for words in ("offset L1 3 wear X=0.05", "zero L2 G54 Z=-150"):
            done = self.polyturn("set", "--instance", self.name, words)
            self.assertEqual(done.status, 0, done.said())
        refused = self.polyturn("set", "--instance", self.name, "offset L1 999 wear X=0.05")
        self.assertEqual(refused.status, 2, refused.said())
        self.assertEqual(self.stop(), 0)

    def test_an_offset_that_is_set_in_a_hold_acts_at_once(self):
        program = self.write("cut.nc", "G98 T0101\nG0 X80. Z20.\nG1 Z-300. F3000.\nM30\n")
        self.start()
        self.press("machine_on")
        self.press("select", f"L1={program}")
        self.press("cycle_start", "L1")
        self.wait_for(lambda: self.channel(1)["line"] == 3, 10, "the cut")
        self.press("feed_hold", "L1")
        self.wait_for(lambda: self.channel(1)["state"] == "held", 5, "the hold")
        before = self.axis("A1")
        done = self.polyturn("set", "--instance", self.name, "offset L1 1 wear X=1")
        self.assertEqual(done.status, 0, done.said())
        self.press("cycle_start", "L1")
        self.wait_for(lambda: abs(self.axis("A1") - before - 0.5) < 1e-6, 5, "the step to the corrected path")
        self.press("feed_hold", "L1")
        self.wait_for(lambda: self.channel(1)["state"] == "held", 5, "the hold")
        self.press("mdi", "L1", "G0", "X120.")
        time.sleep(0.3)
        self.assertEqual((self.channel(1)["state"], self.channel(1)["mdi"]), ("held", [{"block": "G0 X120.", "state": "entered"}]))   # entering moves nothing
        self.press("cycle_start", "L1")
        self.wait_for(lambda: self.axis("A1") > 55, 10, "the block by hand")
        self.wait_for(lambda: self.channel(1)["state"] == "held", 5, "the hold again")
        self.press("retrace", "L1=on")
        self.press("cycle_start", "L1")
        self.wait_for(lambda: abs(self.axis("A1") - before - 0.5) < 1e-6, 10, "the way back to the path")
        self.press("reset", "L1")
        self.assertEqual(self.stop(), 0)

    def axis(self, name):
        return next(a for a in self.status()["axes"] if a["axis"] == name)["cmd"]

    def test_ends_without_leaving_anything(self):
        self.start()
        self.assertEqual(self.stop(), 0)
        self.assertEqual([name for name in os.listdir("/dev/shm") if self.name in name], [])
        self.assertNotEqual(self.polyturn("status", "--instance", self.name).status, 0)

    def test_clean_removes_what_a_killed_controller_left(self):
        self.start()
        self.stop(signal.SIGKILL)
        self.wait_for(lambda: not any(self.name in line for line in self.command_lines()), 5, "the processes to follow")
        self.polyturn("clean")
        self.assertEqual([name for name in os.listdir("/dev/shm") if self.name in name], [])

    @staticmethod
    def command_lines():
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    line = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode()
                except OSError:
                    continue
                if "polyturn-" in line:
                    yield line


if __name__ == "__main__":
    unittest.main()
