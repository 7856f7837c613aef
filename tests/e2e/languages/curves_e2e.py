#!/usr/bin/env python3
"""Arcs of sinumerik that a frame makes no arcs of the machine: the axes go along the curve, not along its chord (part 2, 13.5 and 13.7)."""
import math
import unittest

from polyturn_runner import Case, read_trace

Y_AXIS = ("N0002 A16=1", "N0100 A16=89", "N0103 A16=2", "N1000=0")


class Curves(Case):
    def points(self, text):
        """Where X, Y, Z are commanded while the only G3 is driven."""
        program = self.write("CURVE.MPF", "G17 G90 G94 G500 G64 DIAMOF\n" + text + "M30\n")
        setup = self.write("setup.toml", "[channel.1]\npos = { X = 10.0, Y = 0.0, Z = 0.0 }\n")
        done = self.polyturn("run", "--virtual", "--language", "sinumerik", f"1={program}", "--setup", setup, "--trace", "trace.csv",
                             *(word for line in Y_AXIS for word in ("--set", line)))
        self.assertEqual((done.status, done.alarms), (0, []), done.said())
        curve = done.of("move", kind="linear")[0]
        trace = read_trace(self.folder / "trace.csv")
        within = [i for i, t in enumerate(trace["t"]) if curve["t"] + 0.002 < t < curve["end"]]
        self.assertGreater(len(within), 500)
        return [tuple(trace[f"{a}.cmd"][i] for a in ("A1", "A16", "A2")) for i in within]

    def test_a_circle_in_an_inclined_plane(self):
        points = self.points("ROT X30\nG0 X10\nG3 I10 J0 F2000\n")
        for x, y, z in points:
            self.assertAlmostEqual(math.hypot(x - 20, y, z), 10, delta=0.003)
            self.assertAlmostEqual(z, y * math.tan(math.radians(30)), delta=0.003)
        self.assertGreater(max(p[0] for p in points), 29.9, "all the way round")

    def test_an_ellipse_by_two_factors(self):
        points = self.points("SCALE X3 Y1\nG0 X10\nG3 I10 J0 F2000\n")
        for x, y, z in points:
            self.assertAlmostEqual(math.hypot((x - 60) / 3, y), 10, delta=0.003)
            self.assertAlmostEqual(z, 0, delta=0.001)


if __name__ == "__main__":
    unittest.main()
