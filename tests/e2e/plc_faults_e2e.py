#!/usr/bin/env python3
"""The PLC process dies in the middle of cutting: every axis stops along its path, the spindle stops, an alarm says so."""
import unittest

from polyturn_runner import Case, read_trace


class PlcFaults(Case):
    def test_killed_while_both_turrets_cut(self):
        one = self.write("one.nc", "G97 S1000 M3\nG98 G0 X80. Z20.\nG1 Z-100. F1000.\nM30\n")
        two = self.write("two.nc", "G98 G0 X80. Z20.\nG1 Z-100. F1000.\nM30\n")
        setup = self.write("setup.toml", "[channel.1]\nmachine = { X = 200.0, Z = 100.0 }\n[channel.2]\nmachine = { X = 200.0, Z = 100.0 }\n")
        scenario = self.write("s.toml", '[[at]]\nt = 4.0\nkill = "plc"\n')
        done = self.polyturn("run", "--virtual", "--setup", setup, "--scenario", scenario, "--trace", "t.csv", f"1={one}", f"2={two}")
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue(done.alarms, done.said())
        trace = read_trace(self.folder / "t.csv")
        at = next(i for i, t in enumerate(trace["t"]) if t >= 4.0)
        for axis in ("A1", "A2", "A3", "A4"):
            cmd = trace[f"{axis}.cmd"]
            self.assertEqual(cmd[-1], cmd[-3], f"{axis} does not rest")
            self.assertLess(abs(cmd[-1] - cmd[at]), 5.0, axis)
        # The run ends when nothing is commanded any more; the spindle's last few turns are its inertia.
        self.assertGreater(max(trace["S1.speed"]), 950.0)
        self.assertLess(abs(trace["S1.speed"][-1]), 50.0, "the spindle turns on")


if __name__ == "__main__":
    unittest.main()
