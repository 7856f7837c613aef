#!/usr/bin/env python3
"""`--like`: a private check or run on what a running controller has: its machine's folder, its tools, its values but not its counts."""
import os
import shutil
import subprocess
import unittest
from unittest import mock

from polyturn_runner import SOURCE, LiveCase

MACHINE = SOURCE / "examples/machines/twin-turret"


class Like(LiveCase):
    def check(self, *words, **where):
        return self.polyturn("check", *words, "--like", self.name, **where)

    def run_virtual(self, *words):
        return self.polyturn("run", "--virtual", *words, "--like", self.name, "--instance", self.name + "x")

    def do(self, *words):
        done = self.polyturn(*words, "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())

    def test_a_tool_loaded_by_name_is_there(self):
        self.start("N2900=00000001", "PT_LANGUAGE L1=sinumerik", "PT_TURRET_TIME L1=0.05")
        for words in ("tools add name=CUT duplo=1 worn=1 D1.DP1=500 D1.DP2=3 D1.DP4=10", "tools add name=CUT duplo=2 D1.DP1=500 D1.DP2=3 D1.DP4=30 D2.DP1=500 D2.DP4=31", "tools add name=GROOVE D1.DP1=520 D1.DP2=3 D1.DP4=60", "tools load 1 1 3",
                      "tools load 2 1 7", "tools load 3 1 5", "tools place 1 9 locked=1"):
            self.do(*words.split())
        program = self.write("part.mpf", 'G18 T="CUT" D1\nG94 G0 X80 Z20\nG1 Z10 F6000\nT5 D1\nG0 Z100\nM30\n')
        for done in (self.check(program), self.run_virtual(program)):
            self.assertEqual(done.status, 0, done.said())
            shifts = {e["line"]: round(e["machine"]["Z"] - e["pos"]["Z"], 3) for e in done.of("move") if "Z" in e["pos"]}
            self.assertEqual((shifts[2], shifts[5]), (30, 60), done.said())
            self.assertEqual({e["tool"]["name"] for e in done.of("move", line=2)}, {"CUT"})
        done = self.check(self.write("none.mpf", 'G18 T="NONE" D1\nM30\n'))
        self.assertEqual([e["number"] for e in done.alarms], [17190], done.said())

    def test_tools_of_a_job_are_compared_with_those_of_the_controller(self):
        self.start("N2900=00000001", "PT_LANGUAGE L1=sinumerik")
        self.do("tools", "add", "name=CUT", "D1.DP1=500")
        self.do("tools", "load", "1", "1", "3")
        self.write("part.mpf", "M30\n")
        job = self.write("part.job.toml", '[programs]\n1 = { file = "part.mpf" }\n[[tools]]\nchannel = 1\nstation = 3\nname = "CUT"\n[[tools]]\nchannel = 1\nstation = 4\nname = "GROOVE"\n')
        for done in (self.check(job), self.run_virtual(job)):
            self.assertEqual(done.status, 0, done.said())
            self.assertNotIn("CUT", done.err)
            self.assertIn("GROOVE", done.err)

    def start_on(self, machine):
        log = open(self.folder / "start.log", "ab")
        self.addCleanup(log.close)
        self.running = subprocess.Popen([os.environ.get("POLYTURN", SOURCE / "build/test/bin/polyturn"), "start", machine, "--instance", self.name, "--store", self.folder / "store", "--no-hmi", "--set", "PT_LATE_MAX=1000"], cwd=self.folder,
                                        stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.wait_for(lambda: self.polyturn("status", "--instance", self.name).status == 0, 20, "the controller to start")

    def test_the_machines_folder_is_that_of_the_controller(self):
        machine = self.folder / "ours"
        shutil.copytree(MACHINE, machine)
        self.start_on(machine)
        share = self.folder / "share/examples/machines/twin-turret"   # an example that is broken, and one that is not there
        share.mkdir(parents=True)
        (share / "machine.params").write_text("N0001=nonsense\n")
        program = self.write("part.nc", "G54\nG0 X50. Z5.\nM30\n")
        for folder in (self.folder / "share", self.folder / "nothing"):
            with mock.patch.dict(os.environ, {"POLYTURN_SHARE": str(folder)}):
                for done in (self.check(program), self.run_virtual(program)):
                    self.assertEqual(done.status, 0, done.said())

    def test_a_virtual_run_counts_its_own_parts(self):
        self.start("PT_LANGUAGE L1=fanuc", "N2308 L1=3", "N2307 L1=4")
        program = self.write("part.nc", "G0 X50. Z5.\nM30\n")
        done = self.run_virtual(program)
        self.assertEqual(done.status, 0, done.said())
        self.assertTrue(done.of("part"), done.said())
        self.assertEqual([e["number"] for e in done.of("alarm")], [], done.said())


if __name__ == "__main__":
    unittest.main()
