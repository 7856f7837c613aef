#!/usr/bin/env python3
"""The production jobs of examples/jobs make what their drawings show: the part is turned in a model from the trace of the axes."""
import unittest

import part_model
from polyturn_runner import SOURCE, Case, read_trace

JOBS = SOURCE / "examples/jobs"
AXES = {1: ("A1.cmd", "A2.cmd"), 2: ("A3.cmd", "A4.cmd")}   # of the twin-turret machine


class Contours(Case):
    def made(self, name, blocks=200, written=0, *options):
        """blocks: driven at least; written: in the programs of both channels."""
        folder = JOBS / name
        lines = sum(1 for program in ("O1001.nc", "O2001.nc") for line in (folder / program).read_text().splitlines() if line.startswith("N"))
        self.assertGreaterEqual(lines, written)
        drawing = part_model.read_toml(folder / "drawing.toml")
        trace = self.folder / "trace.csv"
        done = self.polyturn("run", "--virtual", folder / f"{name}.job.toml", "--trace", trace, *options)
        self.assertEqual((done.status, done.alarms), (0, []), done.said())
        driven = sum(channel["blocks"] for channel in done.of("summary")[0]["channels"])
        self.assertGreaterEqual(driven, blocks)
        part = part_model.machined(drawing, part_model.read_toml(folder / f"{name}.setup.toml"), done.events, read_trace(trace), AXES)
        for kind in ("outside", "bore"):
            if kind in drawing:
                found = part_model.deviations(part, drawing[kind], kind == "bore", drawing.get("skip", []), drawing.get("nose", 0.0), drawing.get("tolerance", 0.02))
                worst = [f"{d:.3f} mm at X{x:.2f} Z{z:.2f}" for d, x, z in found[:5]]
                self.assertLess(found[0][0], drawing.get("tolerance", 0.02), f"{kind}: {worst}")

    def test_pinch(self):
        """Two turrets on one slender shaft; without the balance cut G68 mirrors, and the part is another one."""
        self.made("pinch", blocks=20)
        with self.assertRaises(AssertionError):
            self.made("pinch", 20, 0, "--set", "PT_BALANCE=0")

    def test_stud(self):
        self.made("stud")

    def test_bush(self):
        self.made("bush")

    def test_pulley(self):
        self.made("pulley")

    def test_knob(self):
        self.made("knob")

    def test_arbor(self):
        self.made("arbor")

    def test_spool(self):
        self.made("spool", written=200)

    def test_flange(self):
        self.made("flange", written=200)

    def test_handle(self):
        self.made("handle", written=200)

    def test_connector(self):
        self.made("connector", written=200)

    def test_ring_arbor(self):
        self.made("ring-arbor", written=200)


if __name__ == "__main__":
    unittest.main()
