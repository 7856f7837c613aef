#!/usr/bin/env python3
"""A run whose kernel stands still for a while, and one that is ended from outside; what is said of a controller without its name
(faults.md L15, N4)."""
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, Case, LiveCase

PROGRAM = "G98 G0 X80. Z20.\nG1 Z-100. F600.\nM30\n"   # 12 s


class Stopped(Case):
    def test_a_kernel_that_is_stopped_for_a_while_goes_on(self):
        program = self.write("O1.nc", PROGRAM)
        plain = self.polyturn("run", "--virtual", program)
        self.assertEqual(plain.status, 0, plain.said())
        scenario = self.write("s.toml", '[[at]]\nt = 3.0\nstop = "kernel"\nfor = 0.5\n')
        stopped = self.polyturn("run", "--virtual", "--scenario", scenario, program)
        self.assertEqual(stopped.status, 0, stopped.said())
        self.assertEqual(stopped.of("summary")[0]["seconds"], plain.of("summary")[0]["seconds"])
        self.assertEqual(stopped.of("move"), plain.of("move"))

    def test_a_run_that_is_ended_from_outside_tells_how_long_it_ran(self):
        program = self.write("O1.nc", PROGRAM)
        run = subprocess.Popen([POLYTURN, "run", "--set", "PT_LATE_MAX=1000", program], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(run.kill)
        time.sleep(4.0)   # the start, and a part of the long block
        run.send_signal(signal.SIGTERM)
        out = run.communicate(timeout=30)[0]
        summary = [json.loads(line) for line in out.splitlines() if '"summary"' in line]
        self.assertEqual(len(summary), 1, out)
        self.assertGreater(summary[0]["seconds"], 0.5, out)
        self.assertEqual(run.returncode, 1)


class Named(LiveCase):
    def test_a_program_that_has_been_selected_is_shown(self):
        program = self.write("O1.nc", PROGRAM)
        second = self.write("O2.nc", "G4 X1.\nM98 P3\nM30\n")
        self.write("O0003.nc", "O3\nG4 X5.\nM99\n")
        self.start()

        def shown():
            return self.polyturn("status", "--instance", self.name).out

        self.polyturn("press", "--instance", self.name, "machine_on")
        self.polyturn("press", "--instance", self.name, "select", f"L1={second}")
        self.polyturn("press", "--instance", self.name, "cycle_start", "L1")
        self.wait_for(lambda: "O0003.nc" in shown(), 20, "the subprogram")
        self.polyturn("press", "--instance", self.name, "reset", "L1")
        self.wait_for(lambda: self.polyturn("press", "--instance", self.name, "select", f"L1={program}").status == 0, 10, "the reset")
        self.wait_for(lambda: "O1.nc" in shown(), 5, "the name of the program")

    def test_params_without_a_name_speak_to_the_usual_controller(self):
        if pathlib.Path("/dev/shm/polyturn.polyturn.supervisor").exists():
            self.skipTest("a controller of the usual name runs on this computer")
        self.name = "polyturn"
        self.start()
        done = self.polyturn("params", "set", "N1600 L1=2.75")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(self.polyturn("params", "get", "N1600 L1").out.split()[-1], "2.75")


if __name__ == "__main__":
    unittest.main()
