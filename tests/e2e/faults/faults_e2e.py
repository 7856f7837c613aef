#!/usr/bin/env python3
"""A channel that is killed or frozen, at seeded moments in cuts, corners, arcs, threads, waits, tool calls and holds:
its axes come to rest on the path within the braking distance, an alarm names it, and the partner drives exactly as if
nothing had happened until it needs the dead one.

    FAULT_RUNS=200 FAULT_SEED=1 python3 faults_e2e.py        as many runs as asked (default 12)
"""
import math
import os
import random
import unittest

from polyturn_runner import Case, read_trace
from seeds import seeds

RUNS = int(os.environ.get("FAULT_RUNS", "12"))
SEED = int(os.environ.get("FAULT_SEED", "1"))

PARTNER = """(COMMANDS THE SPINDLE, CUTS FOR A WHILE, MEETS THE OTHER ONE TWICE)
G97 S1200 M3
M500 P12
G98 G0 X80. Z20.
G1 X60. Z0. F3000.
G3 X80. Z-10. R10. F2000.
G1 Z-60.
X100.
G0 Z20.
G1 Z-60. F2500.
M501 P12
G0 X120. Z50.
M30
"""
VICTIM = """(EVERYTHING THAT A CHANNEL MAY DO WHEN IT DIES)
M500 P12
T0202
G98 G0 X80. Z20.
G1 X60. Z0. F4000.
Z-20. (CORNER)
X70. Z-25.
G2 X90. Z-35. R10. F3000. (ARC)
G3 X110. Z-45. R10.
G1 X112. Z-46. F4000. (SHORT ONES)
X114. Z-47.
X116. Z-48.
G0 X60. Z10.
G99 G32 Z-20. F1.5 (THREAD)
G98 G0 X80.
Z10.
T0303
G4 U0.2
G1 X60. Z-10. F4000.
M501 P12
G0 X120. Z50.
M30
"""
SETUP = """[channel.1]
machine = { X = 200.0, Z = 100.0 }
[channel.2]
machine = { X = 200.0, Z = 100.0 }
"""
TICK_S = 0.001
ACCELERATION, JERK = 3000.0, 60_000.0                          # of the twin-turret machine's X and Z, mm/s2 and mm/s3
CHANNEL_TIMEOUT_S = 1.0                                        # PT_CHANNEL_TIMEOUT
AXES = ("A1.cmd", "A2.cmd", "A3.cmd", "A4.cmd")
WAITING = 4                                                    # ChannelState::Waiting


def braking_distance(speed, acceleration):
    """Of a path under the limits of one axis: the acceleration must first go, then braking rises, holds and falls."""
    release = max(0.0, acceleration) / JERK
    top = speed + max(0.0, acceleration) * release / 2
    return (speed + top) / 2 * release + acceleration * release * release / 12 + top * top / (2 * ACCELERATION) + top * ACCELERATION / (2 * JERK)


def distance_to_path(point, path):
    """From a point to the polyline of an undisturbed run."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(path, path[1:]):
        dx, dy = bx - ax, by - ay
        length = dx * dx + dy * dy
        u = 0.0 if length == 0 else max(0.0, min(1.0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / length))
        best = min(best, math.hypot(point[0] - ax - u * dx, point[1] - ay - u * dy))
    return best


class Faults(Case):
    def job(self, name, scenario):
        one, two = self.write("partner.nc", PARTNER), self.write("victim.nc", VICTIM)
        setup, stimuli = self.write("setup.toml", SETUP), self.write(f"{name}.toml", scenario)
        done = self.polyturn("run", "--virtual", "--setup", setup, "--scenario", stimuli, "--trace", f"{name}.csv", "--set", "PT_PARTNER_DEATH=0",
                             f"1={one}", f"2={two}")
        return done, read_trace(self.folder / f"{name}.csv")

    def check(self, seed, calm, calm_trace):
        rng = random.Random(seed)
        moment = rng.uniform(0.05, calm_trace["t"][-1] - 0.05)
        hold = rng.random() < 0.2
        action = "stop" if rng.random() < 0.25 else "kill"
        stimuli = f'[[at]]\nt = {moment - 0.04:.4f}\npress = "feed_hold L2"\n' if hold else ""
        stimuli += f'[[at]]\nt = {moment:.4f}\n{action} = "channel 2"\n'
        done, trace = self.job("fault", stimuli)
        about = f"seed {seed}: {stimuli}{done.said()}"

        if action == "stop" and done.status == 0:
            # Frozen so late that its whole program was already committed: nobody misses it.
            self.assertGreater(moment, calm_trace["t"][-1] - CHANNEL_TIMEOUT_S - 0.1, about)
            self.assertEqual({k: trace[k] for k in AXES}, {k: calm_trace[k] for k in AXES}, "differs although all was committed")
            return
        self.assertEqual(done.status, 1, about)
        self.assertTrue(any(a.get("ch") == 2 for a in done.alarms), "no alarm names channel 2; " + about)

        # Its axes: at rest at the end, on the path, within the braking distance of where they were.
        at = next(i for i, t in enumerate(trace["t"]) if t >= moment)
        x, z = trace["A3.cmd"], trace["A4.cmd"]
        self.assertEqual((x[-1], z[-1]), (x[-3], z[-3]), "not at rest; " + about)
        path = list(zip(calm_trace["A3.cmd"], calm_trace["A4.cmd"]))
        path = [p for i, p in enumerate(path) if i == 0 or p != path[i - 1]]
        # In a hold both runs leave and reach the path at other ticks, the path itself is the same.
        for i in (at, (at + len(x)) // 2, len(x) - 1):
            self.assertLess(distance_to_path((x[i], z[i]), path), 0.01, f"left the path at t = {trace['t'][i]}; {about}")
        in_thread = any(e["kind"] == "thread" and e["t"] <= moment <= e["end"] for e in calm.of("move", ch=2))
        if action == "kill" and not in_thread:
            steps = [math.hypot(x[at - k] - x[at - k - 1], z[at - k] - z[at - k - 1]) / TICK_S for k in (0, 1)]
            # On arcs as on lines: what a bend at these speeds takes of the axes is little.
            longest = 1.05 * braking_distance(steps[0], (steps[0] - steps[1]) / TICK_S) + 0.1
            travel = sum(math.hypot(x[i + 1] - x[i], z[i + 1] - z[i]) for i in range(at, len(x) - 1))
            self.assertLessEqual(travel, longest, about)

        # The partner: the same to the last bit, until it stands and waits for the dead one.
        for column in ("A1.cmd", "A2.cmd", "A1.act", "A2.act"):
            for i, (now, before) in enumerate(zip(trace[column], calm_trace[column])):
                if now != before:
                    self.assertEqual(trace["L1.state"][i], WAITING, f"{column} differs at t = {trace['t'][i]}; {about}")
                    break

    def test_a_killed_channel_comes_back_in_reset_state(self):   # architecture 3: its program is still selected, the meeting takes place
        one, two = self.write("ONE.nc", "M510 P12\nM81\nM30\n"), self.write("TWO.nc", "G4 P2.\nM510 P12\nM82\nM30\n")
        scenario = self.write("s.toml", '[[at]]\nt = 1.0\nkill = "channel 2"\n[[at]]\nt = 4.0\npress = "reset L2"\n[[at]]\nt = 5.0\npress = "cycle_start L2"\n')
        runs = [self.polyturn("run", "--virtual", "--language", "nct", "--scenario", scenario, f"1={one}", f"2={two}") for _ in range(2)]
        done = runs[0]
        self.assertEqual(done.status, 1, "the death is an alarm")
        self.assertEqual([e["number"] for e in done.alarms], ["PT0500"], done.said())
        self.assertEqual([(e["ch"], round(e["t"], 1)) for e in done.of("aux")], [(1, 7.0), (2, 7.0)], done.said())
        self.assertEqual(len(done.of("stop", reason="M30")), 2)
        self.assertEqual(runs[0].out, runs[1].out)

    def test_a_killed_channel_comes_back_in_real_time_too(self):   # architecture 3: the kernel takes the successor some ticks later
        one, two = self.write("ONE.nc", "M510 P12\nM81\nM30\n"), self.write("TWO.nc", "G4 P2.\nM510 P12\nM82\nM30\n")
        scenario = self.write("s.toml", '[[at]]\nt = 1.0\nkill = "channel 2"\n[[at]]\nt = 3.0\npress = "reset L2"\n[[at]]\nt = 3.5\npress = "cycle_start L2"\n')
        done = self.polyturn("run", "--language", "nct", "--set", "PT_LATE_MAX=1000", "--scenario", scenario, f"1={one}", f"2={two}")
        self.assertEqual(done.status, 1, "the death is an alarm")
        self.assertIn("PT0500", [e["number"] for e in done.alarms], done.said())
        self.assertEqual(sorted(e["ch"] for e in done.of("aux")), [1, 2], done.said())
        self.assertEqual(len(done.of("stop", reason="M30")), 2, done.said())

    def test_killed_and_frozen_at_seeded_moments(self):
        calm, calm_trace = self.job("calm", "")
        self.assertEqual(calm.status, 0, calm.said())
        for seed in seeds("faults_e2e", "FAULT_SEED", SEED, RUNS, 3):
            with self.subTest(seed=seed):
                self.check(seed, calm, calm_trace)


if __name__ == "__main__":
    unittest.main()
