#!/usr/bin/env python3
"""A tool is measured in a picture of its shadow and entered as an offset of a controller that runs: shown first, written on demand.
The pictures are drawn here, pixel by pixel; the measuring program shares nothing with that."""
import json
import math
import os
import random
import signal
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, Case

SIZE, UM = 400, 10.0


def draw(path, covers, blur=1.0, seed=1):
    """A PGM: share of each pixel that is covered (8 x 8 places where it is not plain), blurred by repeated averaging, with noise."""
    mm = UM / 1000
    rnd = random.Random(seed)

    def at(px, py):
        return covers((px - SIZE / 2) * mm, (SIZE / 2 - py) * mm)

    corner = [[at(px - 0.5, py - 0.5) for px in range(SIZE + 1)] for py in range(SIZE + 1)]
    rows = []
    for py in range(SIZE):
        row = []
        for px in range(SIZE):
            around = (corner[py][px], corner[py][px + 1], corner[py + 1][px], corner[py + 1][px + 1])
            if all(around) or not any(around):
                row.append(1.0 if around[0] else 0.0)
            else:
                row.append(sum(at(px - 0.5 + (i + 0.5) / 8, py - 0.5 + (j + 0.5) / 8) for i in range(8) for j in range(8)) / 64)
        rows.append(row)
    for _ in range(round(2 * blur * blur)):      # each pass adds half a pixel of variance each way
        rows = [[(r[max(i - 1, 0)] + 2 * r[i] + r[min(i + 1, SIZE - 1)]) / 4 for i in range(SIZE)] for r in rows]
        rows = [[(a + 2 * b + c) / 4 for a, b, c in zip(rows[max(j - 1, 0)], rows[j], rows[min(j + 1, SIZE - 1)])] for j in range(SIZE)]
    data = bytes(min(255, max(0, round(220 - 190 * v + rnd.gauss(0, 2)))) for row in rows for v in row)
    path.write_bytes(b"P5\n%d %d\n255\n" % (SIZE, SIZE) + data)
    return path


def insert(radius, z, x):
    """An 80 degree insert cutting to -Z: its nose centre stands at z, x."""
    corner_z, corner_x = z, x
    a, b = math.radians(85), math.radians(5)
    axis = (a + b) / 2
    half = (a - b) / 2
    corner_z -= radius / math.sin(half) * math.cos(axis)
    corner_x -= radius / math.sin(half) * math.sin(axis)

    def covers(pz, px):
        dz, dx = pz - corner_z, px - corner_x
        along = dz * math.cos(axis) + dx * math.sin(axis)
        across = -dz * math.sin(axis) + dx * math.cos(axis)
        if along <= 0 or abs(across) > along * math.tan(half):
            return False
        if along >= radius / math.tan(half) * math.cos(half):
            return True
        return math.hypot(pz - z, px - x) <= radius
    return covers


@unittest.skipUnless((POLYTURN.parent / "polyturn-presetter").exists(), "built without OpenCV")
class Presetter(Case):
    def setUp(self):
        super().setUp()
        self.name = f"presetter-{os.getpid()}"
        self.running = None
        self.addCleanup(self.stop)
        self.addCleanup(lambda: self.polyturn("clean"))

    def stop(self):
        if self.running and self.running.poll() is None:
            self.running.send_signal(signal.SIGKILL)
            self.running.wait(timeout=20)

    def test_it_is_shown_and_entered_only_on_demand(self):
        pin = draw(self.folder / "pin.pgm", lambda z, x: x >= 0 and abs(z) <= 1.0)
        tool = draw(self.folder / "tool.pgm", insert(0.8, 0.1, 0.2))
        done = self.polyturn("presetter", "calibrate", pin, "diameter=2", "x=50", "z=30")
        self.assertEqual(done.status, 0, done.said())
        shown = self.polyturn("presetter", "measure", tool, "--json")
        self.assertEqual(shown.status, 0, shown.said())
        m = json.loads(shown.out)
        self.assertEqual(m["T"], 3)
        self.assertAlmostEqual(m["R"], 0.8, delta=0.006)
        # The pin's end has X 50, Z 30 and stands in the middle; the tip (-Z, -X of the nose) lies at -0.7, -0.6 from there.
        self.assertAlmostEqual(m["X"], 50 + 0.6, delta=0.004)
        self.assertAlmostEqual(m["Z"], 30 + 0.7, delta=0.004)
        self.assertAlmostEqual(m["included_deg"], 80, delta=0.3)
        with open(self.folder / "start.log", "wb") as log:
            self.running = subprocess.Popen([POLYTURN, "start", "--instance", self.name, "--store", self.folder / "store", "--no-hmi"], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        deadline = time.monotonic() + 20
        while self.polyturn("status", "--instance", self.name).status != 0:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)

        def offset():
            listed = self.polyturn("offsets", "list", "L1", "--json", "--instance", self.name)
            return json.loads(listed.out)["offsets"][6]["geometry"]
        proposed = self.polyturn("presetter", "measure", tool, "L1", "7", "--instance", self.name)
        self.assertEqual(proposed.status, 0, proposed.said())
        self.assertIn("Nothing was changed yet", proposed.out)
        self.assertEqual(offset()["Z"], 0)
        written = self.polyturn("presetter", "measure", tool, "L1", "7", "--yes", "--instance", self.name)
        self.assertEqual(written.status, 0, written.said())
        self.assertAlmostEqual(offset()["X"], 2 * m["X"], delta=1e-3)     # X of L1 is a diameter
        self.assertAlmostEqual(offset()["Z"], m["Z"], delta=1e-3)
        self.assertEqual(offset()["T"], 3)

    def test_a_camera_gives_one_picture_out_of_several_frames(self):
        pin, tool = (lambda z, x: x >= 0 and abs(z) <= 1.0), insert(0.8, 0.1, 0.2)
        for k in range(4):
            draw(self.folder / f"pin_{k:02}.pgm", pin, seed=10 + k)
            draw(self.folder / f"tool_{k:02}.pgm", tool, seed=20 + k)
        done = self.polyturn("presetter", "calibrate", "camera:pin_%02d.pgm", "diameter=2", "x=50", "z=30", "--frames", "4")
        self.assertEqual(done.status, 0, done.said())
        sources = ["camera:tool_%02d.pgm"]
        frames = [(self.folder / f"tool_{k:02}.pgm").read_bytes().split(b"255\n", 1)[1] for k in range(4)]
        self.write("film.y4m", b"YUV4MPEG2 W%d H%d F25:1 Ip A1:1 Cmono\n" % (SIZE, SIZE) + b"".join(b"FRAME\n" + one for one in frames))
        film = self.polyturn("presetter", "measure", "camera:film.y4m", "--frames", "4", "--json")
        if "has no cameras" not in film.err:     # built with OpenCV's videoio
            sources.append("camera:film.y4m")
        for source in sources:
            measured = self.polyturn("presetter", "measure", source, "--frames", "4", "--json")
            self.assertEqual(measured.status, 0, measured.said())
            m = json.loads(measured.out)
            self.assertEqual(m["T"], 3)
            self.assertAlmostEqual(m["R"], 0.8, delta=0.006)
            self.assertAlmostEqual(m["X"], 50.6, delta=0.004)
            self.assertAlmostEqual(m["Z"], 30.7, delta=0.004)

    def test_a_camera_that_is_not_there_or_shows_no_still_picture_is_refused(self):
        pin = draw(self.folder / "pin.pgm", lambda z, x: x >= 0 and abs(z) <= 1.0)
        self.assertEqual(self.polyturn("presetter", "calibrate", pin, "diameter=2", "x=50", "z=30").status, 0)
        for k in range(3):
            draw(self.folder / f"moves_{k}.pgm", insert(0.8, 0.1 + 0.05 * k, 0.2), seed=k)
        draw(self.folder / "blurred_1.pgm", insert(0.8, 0.1, 0.2), 5)
        for source, word in (("camera:97", "no picture"), ("camera:/dev/video97", "no picture"), ("camera:none_%02d.pgm", "no picture"), ("camera:moves_%d.pgm", "move"), ("camera:", "no picture"),
                             ("camera:pin.pgm%", "no picture")):
            done = self.polyturn("presetter", "measure", source)
            self.assertEqual(done.status, 2, done.said())
            self.assertIn("PT0426", done.err, source)
            self.assertIn(word, done.err, source)
        blurred = self.polyturn("presetter", "measure", "camera:blurred_%d.pgm", "--frames", "1")
        self.assertEqual(blurred.status, 2, blurred.said())
        self.assertIn("blurred", blurred.err)

    def test_what_cannot_be_measured_is_refused_with_its_reason(self):
        pin = draw(self.folder / "pin.pgm", lambda z, x: x >= 0 and abs(z) <= 1.0)
        self.assertEqual(self.polyturn("presetter", "calibrate", pin, "diameter=2", "x=50", "z=30").status, 0)
        for name, covers, blur, word in (("empty", lambda z, x: False, 1, "empty"), ("blurred", insert(0.8, 0.1, 0.2), 5, "blurred")):
            done = self.polyturn("presetter", "measure", draw(self.folder / "bad.pgm", covers, blur))
            self.assertEqual(done.status, 2, done.said())
            self.assertIn("PT0426", done.err)
            self.assertIn(word, done.err, name)
        nothing = self.polyturn("presetter", "measure", pin, "--calibration", "none.json")
        self.assertEqual(nothing.status, 2)
        self.assertIn("PT0427", nothing.err)
        broken = self.write("broken.pgm", b"P5\n400 400\n255\nabc")
        self.assertEqual(self.polyturn("presetter", "measure", broken).status, 2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
