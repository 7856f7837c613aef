#!/usr/bin/env python3
"""The PLC dies in the middle of cutting, or does not come back from a cycle: every axis stops along its path, the
spindle stops, an alarm says so. And a machine with a PLC of its own."""
import shutil
import unittest

from polyturn_runner import POLYTURN, SOURCE, Case, read_trace


class PlcFaults(Case):
    def machine_with(self, plc):
        """A copy of the twin-turret machine with this shared object as its PLC."""
        library = POLYTURN.parent / plc
        if not library.exists():
            self.skipTest(f"{library} is not built")
        folder = self.folder / "machine"
        shutil.copytree(SOURCE / "examples/machines/twin-turret", folder)
        shutil.copy(library, folder / "plc.so")
        return folder

    def test_machine_with_its_own_plc(self):
        program = self.write("coolant.nc", "M8\nM77\nM9\nM30\n")
        done = self.polyturn("run", "--virtual", "--machine", self.machine_with("minimal_plc.so"), program)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([e["code"] for e in done.of("aux")], ["M8", "M77", "M9"])

    def test_plc_that_crashes_or_never_returns_stops_the_machine(self):
        program = self.write("cut.nc", "G98 G0 X80. Z20.\nG1 Z-100. F1000.\nM30\n")
        setup = self.write("setup.toml", "[channel.1]\nmachine = { X = 200.0, Z = 100.0 }\n")
        for plc in ("crash_plc.so", "endless_plc.so"):
            with self.subTest(plc):
                machine = self.machine_with(plc)
                done = self.polyturn("run", "--virtual", "--machine", machine, "--setup", setup, "--trace", "t.csv", program)
                shutil.rmtree(machine)
                self.assertEqual(done.status, 1, done.said())
                self.assertTrue(done.alarms, done.said())
                trace = read_trace(self.folder / "t.csv")
                # The run ends at the tick at which the axis comes to rest: its last step is the end of braking.
                self.assertLess(abs(trace["A2.cmd"][-1] - trace["A2.cmd"][-2]), 1e-5, "is not at rest")
                self.assertGreater(trace["A2.cmd"][-1], -90.0, "went on to the end of the program")

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
