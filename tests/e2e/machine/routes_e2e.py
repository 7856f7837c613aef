#!/usr/bin/env python3
"""Axes that are exchanged while a channel dies: its successor reads the routes, not the axes it has at home. In real time, for in virtual
time the dead stay dead."""
import json
import os
import signal
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, SOURCE, Case
from process_tree import command_line, descendants

MACHINE = SOURCE / "examples/machines/twin-turret"


class Routes(Case):
    def setUp(self):
        super().setUp()
        self.name = f"routes-{os.getpid()}"
        machine = self.folder / "lathe"
        subprocess.run(["cp", "-r", MACHINE, machine], check=True)
        with open(machine / "machine.params", "a", encoding="utf-8") as file:
            file.write("\nN2104 A3=1\nPT_PARTNER_DEATH=0\n")   # X of the lower turret may get the drive of the upper one
        log = open(self.folder / "start.log", "ab")
        self.addCleanup(log.close)
        self.running = subprocess.Popen([POLYTURN, "start", machine, "--instance", self.name, "--store", self.folder / "store", "--no-hmi"], stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.addCleanup(lambda: self.polyturn("clean"))
        self.addCleanup(lambda: self.running.poll() is None and (self.running.send_signal(signal.SIGKILL), self.running.wait()))
        self.wait(lambda: self.polyturn("status", "--instance", self.name).status == 0, "the controller to start")
        self.press("machine_on")

    def wait(self, condition, what):
        deadline = time.monotonic() + 25
        while not condition():
            if time.monotonic() > deadline:
                self.fail(f"waited for {what}\n" + (self.folder / "start.log").read_text(errors="replace")[-2000:] + self.polyturn("status", "--instance", self.name).said())
            time.sleep(0.05)

    def press(self, *words):
        done = self.polyturn("press", "--instance", self.name, *words)
        self.assertEqual(done.status, 0, done.said())

    def status(self):
        return json.loads(self.polyturn("status", "--json", "--instance", self.name).out)

    def axis(self, name):
        return next(a for a in self.status()["axes"] if a["axis"] == name)["cmd"]

    def channel(self, number):
        return next(c for c in self.status()["channels"] if c["ch"] == number)

    def mdi(self, text):
        self.press("mode", "L2=mdi")
        self.wait(lambda: self.channel(2)["state"] != "running", "MDI")
        self.press("mdi", "L2", text)
        self.press("cycle_start", "L2")

    def process(self):
        return next(pid for pid in descendants(self.running.pid) if os.path.basename((command_line(pid) or [""])[0]) == "polyturn-channel" and "2" in command_line(pid))

    def test_a_channel_that_starts_again_moves_the_drive_it_was_lent(self):
        done = self.polyturn("set", "--instance", self.name, "AP_MIXR A3=1")
        self.assertEqual(done.status, 0, done.said())
        home, lent = self.axis("A3"), self.axis("A1")
        time.sleep(0.3)
        dead = self.process()
        os.kill(dead, signal.SIGKILL)
        self.wait(lambda: any(pid != dead for pid in [self.process()]) if self.alive() else False, "the successor")
        self.wait(lambda: self.channel(2)["state"] == "reset", "the successor to stand")
        self.press("reset", "L2")
        self.mdi("G98 G1 U10. F3000")
        self.wait(lambda: abs(self.axis("A1") - (lent + 5.0)) < 1e-3, "the lent drive to have moved by 5 mm of radius")
        self.assertAlmostEqual(self.axis("A3"), home, places=6, msg="the drive at home stands")

    def alive(self):
        return any(os.path.basename((command_line(pid) or [""])[0]) == "polyturn-channel" and "2" in command_line(pid) for pid in descendants(self.running.pid))


if __name__ == "__main__":
    unittest.main()
