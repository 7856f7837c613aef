#!/usr/bin/env python3
"""Drives in a process of their own: a job is made with CiA 402 slaves behind the drive segment as with the drives inside the
kernel; late, lost and failing drives stop the machine with the alarm that names them; a builder's drive.so works alike."""
import os
import pathlib
import subprocess
import unittest

from polyturn_runner import SOURCE, Case, read_trace

MACHINE = """N0005=1000
N0000 L1=1
PT_LANGUAGE L1=fanuc
N0002 A1=1
N0100 A1=88
N0103 A1=1
N0106 A1=00000001
N0002 A2=1
N0100 A2=90
N0103 A2=3
N1300 L1=00000010
N1301 L1=00000000
N0604 L1=1
PT_TURRET_STATIONS L1=8
N0607 S1=00000111
N0608 S1=4096
N0634 S1=5000
N0650 S1=4500
N0666 S1=1500
N0674 S1=1500
""" + "".join(f"N0304 A{a}=12000\nN0305 A{a}=6000\nN0400 A{a}=2000\nN0401 A{a}=0.05\nN0504 A{a}=40\nN0511 A{a}=1\nN0515 A{a}=00000011\nN0516 A{a}=0.005\nN0518 A{a}=0.025\n"
              f"N0519 A{a}=0.1\nN0520 A{a}=1\nN0521 A{a}=5\nN0505 A{a}=14000\nN0900 A{a}=8\n" for a in (1, 2))
PROCESS = "PT_DRIVE A1=2\nPT_DRIVE A2=2\nPT_SPINDLE_DRIVE S1=2\n"
FAST = ("PT_DRIVE_FREQ A1=1000", "PT_DRIVE_FREQ A2=1000")   # a drive without a lag: feed-forward has nothing to make up for
PROGRAM = """O0001
G98 G0 X100. Z20.
M3 S800
G1 X80. Z-10. F2000.
G3 X100. Z-20. R10. F1500.
G1 Z-60.
G0 X120. Z20.
M5
M30
"""
SETUP = "[channel.1]\nmachine = { X = 160.0, Z = 50.0 }\n"


class Drives(Case):
    def machine(self, *lines):
        folder = self.folder / "lathe"
        folder.mkdir(exist_ok=True)
        (folder / "machine.params").write_text(MACHINE + "\n".join(lines) + "\n")
        return folder

    def make(self, folder, scenario="", name="run"):
        program, setup, stimuli = self.write("O0001.nc", PROGRAM), self.write("setup.toml", SETUP), self.write("scenario.toml", scenario)
        done = self.polyturn("run", "--virtual", "--machine", folder, "--setup", setup, "--scenario", stimuli, "--trace", f"{name}.csv", f"1={program}")
        return done, read_trace(self.folder / f"{name}.csv")

    def same_path(self, one, other):
        for column in ("A1.cmd", "A2.cmd"):
            self.assertEqual(one[column][-1], other[column][-1])
            self.assertEqual(len(one[column]), len(other[column]))
            self.assertLess(max(abs(a - b) for a, b in zip(one[column], other[column])), 1e-6, column)
        for column in ("A1.act", "A2.act"):
            self.assertLess(max(abs(a - b) for a, b in zip(one[column], other[column])), 0.2, column)

    def test_a_job_is_made_as_with_simulated_drives(self):
        inside, inside_trace = self.make(self.machine())
        self.assertEqual(inside.status, 0, inside.said())
        for mode in (0, 1):   # csv, csp
            outside, trace = self.make(self.machine(PROCESS, f"PT_DRIVE_MODE A1={mode}", f"PT_DRIVE_MODE A2={mode}"))
            self.assertEqual(outside.status, 0, outside.said())
            self.assertEqual(outside.alarms, [], outside.said())
            self.same_path(inside_trace, trace)
        again, again_trace = self.make(self.machine(PROCESS, "PT_DRIVE_MODE A1=1", "PT_DRIVE_MODE A2=1"))
        self.assertEqual(again.status, 0, again.said())
        self.assertEqual(trace, again_trace, "two virtual runs differ")

    def stops(self, what, number, axis="A2", on=None):
        """The drive does `what` on its way: the alarm comes, all axes rest soon, on their way within limits."""
        done, trace = self.make(self.machine(PROCESS), f'[[at]]\nt = 1.7\nset = "drive {axis}={what}"\n')
        self.assertEqual(done.status, 1, done.said())
        alarm = [a for a in done.alarms if a["number"] == number]
        self.assertTrue(alarm, done.said())
        self.assertIn(axis, alarm[0]["text"], done.said())
        for column in ("A1.cmd", "A2.cmd"):
            after = [p for t, p in zip(trace["t"], trace[column]) if t > 1.9]
            self.assertEqual(len(set(after)), 1, f"{column} moves on")
            speed = [abs(b - a) * 1000 for a, b in zip(trace[column], trace[column][1:])]
            change = [abs(b - a) * 1000 for a, b in zip(speed, speed[1:])]
            self.assertLess(max(change), 10100, column)   # PT_ESTOP_DEC
        return done

    def test_a_drive_fault_stops_the_machine(self):
        self.stops("fault", "PT0532")
        self.stops("encoder", "PT0532")
        self.stops("fault", "PT0532", axis="S1")

    def test_a_drive_that_answers_no_more_stops_it(self):
        self.stops("silent", "PT0566")

    def test_a_drive_without_supply_stops_it(self):
        self.stops("dead", "PT0532")   # its voltage goes: a fault of the drive

    def test_an_answer_that_is_too_late_stops_it(self):
        self.stops("delay 9", "PT0566")

    def test_few_lost_or_late_answers_are_ridden_out(self):
        for what in ("loses 4", "delay 2"):
            done, trace = self.make(self.machine(PROCESS), f'[[at]]\nt = 0.5\nset = "drive A2={what}"\n')
            self.assertEqual(done.status, 0, what + done.said())
            self.assertEqual(done.alarms, [], done.said())
            away = max(abs(c - a) for c, a in zip(trace["A2.cmd"], trace["A2.act"]))
            self.assertLess(away, 1.0, what)

    def test_a_killed_drive_process_stops_it(self):
        done, trace = self.make(self.machine(PROCESS), '[[at]]\nt = 1.7\nkill = "drives"\n')
        self.assertEqual(done.status, 1, done.said())
        self.assertIn("PT0566", [a["number"] for a in done.alarms], done.said())
        self.assertEqual(trace["A2.cmd"][-1], trace["A2.cmd"][-50])

    def test_it_goes_on_after_the_fault_is_gone(self):
        scenario = "".join(f'[[at]]\nt = {t}\n{key} = "{words}"\n' for t, key, words in (
            (1.7, "set", "drive A2=fault"), (2.5, "set", "drive A2=ok"), (2.6, "press", "machine_on"), (3.2, "press", "reset"), (3.4, "press", "cycle_start")))
        done, trace = self.make(self.machine(PROCESS), scenario)
        self.assertEqual(sum(e["ev"] == "stop" and e["reason"] == "M30" for e in done.events), 1, done.said())
        self.assertAlmostEqual(trace["A2.cmd"][-1], 20.0, places=6)
        self.assertAlmostEqual(trace["A2.act"][-1], 20.0, places=2)

    def test_a_missing_drive_is_named_and_nothing_moves(self):
        done, trace = self.make(self.machine("PT_DRIVE A1=1"))
        self.assertEqual(done.status, 1, done.said())
        self.assertIn("PT0567", [a["number"] for a in done.alarms], done.said())
        self.assertEqual(len(set(trace["A1.cmd"])), 1)

    def test_a_builders_own_drive(self):
        folder = self.machine("PT_DRIVE A1=1", "PT_DRIVE A2=1", *FAST)
        subprocess.run([os.environ.get("CC", "cc"), "-std=c11", "-Wall", "-Werror", "-shared", "-fPIC", "-I", SOURCE / "kernel/drives", SOURCE / "examples/drives/minimal_drive.c", "-o",
                        folder / "drive.so"], check=True)
        done, trace = self.make(folder)
        self.assertEqual(done.status, 0, done.said())
        self.assertAlmostEqual(trace["A2.act"][-1], 20.0, places=2)

    def test_a_builders_own_drive_process(self):
        folder = self.machine("PT_DRIVE A1=2", "PT_DRIVE A2=2", *FAST)
        subprocess.run([os.environ.get("CC", "cc"), "-std=gnu11", "-Wall", "-Werror", "-I", SOURCE / "kernel/drives", SOURCE / "examples/drives/minimal_process.c", "-o", folder / "drives"],
                       check=True)
        done, trace = self.make(folder)
        self.assertEqual(done.status, 0, done.said())
        self.assertAlmostEqual(trace["A2.act"][-1], 20.0, places=2)


if __name__ == "__main__":
    unittest.main()
