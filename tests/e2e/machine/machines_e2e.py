#!/usr/bin/env python3
"""Each example machine makes its demonstration part, and not without the function that is special about it."""
import unittest

from polyturn_runner import SOURCE, Case

JOBS = SOURCE / "examples/jobs"


class Machines(Case):
    def made(self, job):
        done = self.polyturn("run", "--virtual", JOBS / job / f"{job}.job.toml")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(done.alarms, [], done.said())
        return done

    def refused(self, job, line, *numbers, status=1):
        done = self.polyturn("run", "--virtual", JOBS / job / f"{job}.job.toml", "--set", line)
        self.assertEqual(done.status, status, done.said())
        said = [str(alarm["number"]) for alarm in done.alarms]
        for number in numbers:
            self.assertIn(number, said, done.said())

    def test_one_turret_with_its_tailstock(self):
        done = self.made("pin")
        codes = [event["code"] for event in done.of("aux")]
        self.assertLess(codes.index("M25"), codes.index("M3"))
        self.refused("pin", "PT_M_TAILSTOCK L1=0", "3001")
        self.refused("pin", "PT_TURRET_STATIONS L1=4", "PT0539")

    def test_counter_spindle(self):
        done = self.made("two-sides")
        self.assertTrue(done.of("spindle", ch=2, spindle=2), done.said())
        self.refused("two-sides", "PT_M_SPINDLE=0", "PT0523")

    def test_y_axis_and_driven_tool(self):
        done = self.made("flats")
        mills = [event for event in done.of("move", ch=1, kind="linear")]
        self.assertEqual(len(mills), 4)
        self.assertEqual([event["pos"]["C"] for event in mills], [0, 90, 180, 270])
        self.refused("flats", "PT_DRIVEN_SPINDLE L1=0", "PT0539")
        self.refused("flats", "N0002 A7=0", "PT0302", status=2)

    def test_face_milling_with_x_and_c(self):
        done = self.made("hexagon")
        sides = [event["pos"] for event in done.of("move", ch=1, kind="linear") if event.get("comp") == "left"]
        self.assertGreaterEqual(len(sides), 8, done.said())
        before, groove = ([event["machine"] for event in done.of("move", ch=1, kind="linear") if event["line"] == line][0] for line in (18, 19))
        self.assertAlmostEqual(before["X"] - groove["X"], 30.0)   # through the centre: X goes on to the other side ...
        self.assertAlmostEqual(before["C"], groove["C"])          # ... and C stands
        self.refused("hexagon", "F5461 L1=1", "145")
        self.refused("hexagon", "N0217 A5=3", "PT1616")

    def test_vertical_lathe_with_inclined_ram(self):
        done = self.made("disk")
        self.assertEqual(len(done.of("move", ch=1, kind="ccw")), 1)
        self.refused("disk", "MD24100 L1=0", "14401")
        self.refused("disk", "MD24700 L1=0", "14404")

    def test_swiss_type(self):
        self.made("swiss-pin")
        self.refused("swiss-pin", "PT_M_SUPER A6=0", "3003")


if __name__ == "__main__":
    unittest.main()
