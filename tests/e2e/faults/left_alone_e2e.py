#!/usr/bin/env python3
"""The supervisor is killed (SIGKILL) at seeded moments while the machine cuts, in real and in virtual time: the kernel brings all axes and
spindles to rest within their limits and ends by itself; channels, PLC and store after it; nobody stays behind.

What happened is read from the shared image by a process of the test's own (tests/fault/alone/black_box.cpp), for whoever writes traces is dead.

    ALONE_RUNS=200 ALONE_SEED=1 python3 left_alone_e2e.py        as many moments as asked (default 20), half of them in virtual time
"""
import os
import pathlib
import random
import signal
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, Case
from seeds import seeds

RUNS = int(os.environ.get("ALONE_RUNS", "20"))
SEED = int(os.environ.get("ALONE_SEED", "1"))
BLACK_BOX = pathlib.Path(os.environ.get("BLACK_BOX", POLYTURN.parent / "black_box"))

# Both channels, the spindle, arcs, short moves, a thread; again and again.
ONE = """G97 S1200 M3
G98 G0 X80. Z20.
WHILE [1 EQ 1] DO1
G1 X60. Z0. F3000.
G3 X80. Z-10. R10. F2000.
G1 Z-60.
X100.
G0 Z20.
END1
M30
"""
TWO = """G98 G0 X80. Z20.
WHILE [1 EQ 1] DO1
G1 X60. Z0. F4000.
Z-20.
X70. Z-25.
G2 X90. Z-35. R10. F3000.
G3 X110. Z-45. R10.
G1 X112. Z-46. F4000.
X114. Z-47.
G0 X60. Z10.
G99 G32 Z-20. F1.5
G98 G0 X80.
Z10.
END1
M30
"""
SETUP = """[channel.1]
machine = { X = 200.0, Z = 100.0 }
[channel.2]
machine = { X = 200.0, Z = 100.0 }
"""
SCOPE = ["command A1", "command A2", "command A3", "command A4", "speed_command S1", "speed S1"]
TICK_S = 0.001
VELOCITY, ACCELERATION, JERK = 24000 / 60, 3000.0, 60_000.0     # set below, mm/s, mm/s2, mm/s3
SETS = [f"N0304={VELOCITY * 60}", f"N0305={VELOCITY * 60}", f"N0400={ACCELERATION}", f"N0401={ACCELERATION / JERK}"]
MORE = 1.01                                                     # rounding of differences of differences
STANDING = 10                                                   # 1/min: what the machine calls a standing spindle (N0690)
ENDS_WITHIN_S = 60                                              # of the computer, however busy it is


def alive(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


class LeftAlone(Case):
    def watch(self, instance):
        box = subprocess.Popen([BLACK_BOX, instance, self.folder / "box.csv"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(box.kill)
        pids = {}
        for line in box.stdout:
            if line.startswith("watching"):
                return box, pids
            slot, pid = line.split()
            pids[slot] = int(pid)
        self.fail("the black box has not found the controller\n" + (self.folder / "said.log").read_text(errors="replace")[-3000:])

    def judge(self, about):
        rows = [[float(cell) for cell in line.split(",")] for line in open(self.folder / "box.csv", encoding="ascii")]
        self.assertGreater(len(rows), 2, about)
        moved = 0.0
        for axis in range(1, 5):
            v = a = 0.0
            known = 0
            for before, now in zip(rows, rows[1:]):
                self.assertEqual(now[0], before[0] + 1, "a tick is missing; " + about)
                speed = (now[axis] - before[axis]) / TICK_S
                acceleration = (speed - v) / TICK_S
                jerk = (acceleration - a) / TICK_S
                where = f"A{axis} at tick {now[0]:.0f} of {rows[-1][0]:.0f}; {about}"
                self.assertLessEqual(abs(speed), VELOCITY * MORE, "velocity of " + where)
                if known >= 1:
                    self.assertLessEqual(abs(acceleration), ACCELERATION * MORE, "acceleration of " + where)
                if known >= 2:
                    self.assertLessEqual(abs(jerk), JERK * MORE, "jerk of " + where)
                known, v, a = known + 1, speed, acceleration
                moved += abs(speed) * TICK_S
            self.assertEqual(rows[-1][axis], rows[-2][axis], f"A{axis} has not come to rest; " + about)
        self.assertGreater(moved, 0, about)
        self.assertEqual(rows[-1][5], 0, "S1 is still told to turn; " + about)
        self.assertLess(abs(rows[-1][6]), STANDING, "S1 turns; " + about)

    def after(self, supervisor, box, pids, about):
        supervisor.kill()
        supervisor.wait()
        killed = time.monotonic()
        try:
            box.wait(timeout=ENDS_WITHIN_S)
        except subprocess.TimeoutExpired:
            self.fail("the kernel has not ended; " + about)
        about = f"ended {time.monotonic() - killed:.2f} s later; " + about
        while any(alive(pid) for pid in pids.values()):
            left = {slot: pid for slot, pid in pids.items() if alive(pid)}
            self.assertLess(time.monotonic() - killed, ENDS_WITHIN_S, f"{left} stay behind; {about}")
            time.sleep(0.01)
        self.judge(about)

    def files(self):
        return self.write("one.nc", ONE), self.write("two.nc", TWO), self.write("setup.toml", SETUP)

    def sets(self, *more):
        return [word for one in (*SETS, "PT_PARTNER_DEATH=0", *more) for word in ("--set", one)]

    def one_run(self, seed, number, rng, virtual):
        one, two, setup = self.files()
        instance = f"alone-{os.getpid()}-{number}"
        scenario = self.write("s.toml", "".join(f'[[at]]\nt = 0.0\npress = "scope {i + 1} {what}"\n' for i, what in enumerate(SCOPE)))
        log = open(self.folder / "said.log", "wb")
        self.addCleanup(log.close)
        command = [POLYTURN, "run", "--instance", instance, "--language", "fanuc", "--setup", setup, "--scenario", scenario, *self.sets("PT_LATE_MAX=1000"), *(["--virtual"] if virtual else []), f"1={one}", f"2={two}"]
        supervisor = subprocess.Popen(command, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.addCleanup(supervisor.kill)
        try:
            box, pids = self.watch(instance)
            delay = rng.uniform(0.0, 1.5 if virtual else 4.0)
            time.sleep(delay)
            about = f"{'virtual' if virtual else 'real'} time, {delay:.3f} s; ALONE_SEED={seed} run {number}; {(self.folder / 'said.log').read_text(errors='replace')[-500:]}"
            self.assertIsNone(supervisor.poll(), "the run is over already; " + about)
            self.after(supervisor, box, pids, about)
        finally:
            supervisor.kill()
            supervisor.wait()
            self.polyturn("clean")

    def test_the_machine_comes_to_rest_and_everybody_ends(self):
        for seed in seeds("left_alone_e2e", "ALONE_SEED", SEED, 1, 1):
            rng = random.Random(seed)
            for number in range(RUNS if seed == SEED else RUNS // 5):
                with self.subTest(seed=seed, run=number):
                    self.one_run(seed, number, rng, virtual=number % 2 == 1)


if __name__ == "__main__":
    unittest.main()
