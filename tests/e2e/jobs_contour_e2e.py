"""Production jobs of 200 and more written blocks: what `check` prints cuts a bar, and the bar must become the drawing.
(contours_e2e.py judges other jobs behind the whole machine, by the trace of its axes.)

The bar is a height (radius) on a raster along Z. A tool is a nose circle, a flat edge or a drill; everything it passes over at
feed is gone. The finished part must nowhere be lower than the drawing, and nowhere higher than a nose can leave it in a
corner. Rapid traverse must not touch the part.
"""
import json
import math
import tomllib
import unittest

from polyturn_runner import SOURCE, Case

STEP = 0.02   # mm of the raster
TIPS = {0: (0, 0), 1: (1, 1), 2: (-1, 1), 3: (-1, -1), 4: (1, -1), 5: (1, 0), 6: (0, 1), 7: (-1, 0), 8: (0, -1), 9: (0, 0)}   # Z, X


class Side:
    """One side of the part, outside or bore; h grows away from the material that stays."""

    def __init__(self, drawing, points, sign):
        self.sign = sign
        zs = [p[0] for p in points]
        self.low, self.count = min(zs), int(round((max(zs) - min(zs)) / STEP)) + 1
        start = drawing["stock"] / 2 if sign > 0 else 0.0   # a bore grows from nothing
        self.stock = [sign * start] * self.count
        self.rapid = [math.inf] * self.count
        self.lowest, self.highest = self.raster(points)

    def raster(self, points):
        low, high = [math.inf] * self.count, [-math.inf] * self.count
        for (z0, x0), (z1, x1) in zip(points, points[1:]):
            a, b = sorted((self.cell(z0), self.cell(z1)))
            for i in range(max(0, a - 1), min(self.count, b + 2)):
                z = min(max(self.z(i), min(z0, z1)), max(z0, z1))
                hs = (x0, x1) if abs(z1 - z0) < 1e-9 else (x0 + (x1 - x0) * (z - z0) / (z1 - z0),)
                for x in hs:
                    low[i], high[i] = min(low[i], self.sign * x / 2), max(high[i], self.sign * x / 2)
        return low, high

    def z(self, i):
        return self.low + i * STEP

    def cell(self, z):
        return int(round((z - self.low) / STEP))

    def circle(self, field, z, h, r, wide=0.0):
        for i in range(max(0, self.cell(z - r)), min(self.count, self.cell(z + wide + r) + 1)):
            d = max(z - self.z(i), self.z(i) - z - wide, 0.0)
            if d <= r:
                field[i] = min(field[i], h - math.sqrt(r * r - d * d))

    def pass_over(self, a, b, r, wide, cuts):
        """From a to b (Z, h of the circle's centre, or of the left end of a flat edge)."""
        field = self.stock if cuts else self.rapid
        if abs(a[1] - b[1]) < 1e-9:   # along the part
            self.circle(field, min(a[0], b[0]), a[1], r, abs(b[0] - a[0]) + wide)
        elif abs(a[0] - b[0]) < 1e-9:   # into it: the deepest place counts
            self.circle(field, a[0], min(a[1], b[1]), r, wide)
        else:
            n = max(1, math.ceil(math.dist(a, b) / STEP))
            for k in range(n + 1):
                self.circle(field, a[0] + (b[0] - a[0]) * k / n, a[1] + (b[1] - a[1]) * k / n, r, wide)

    def left_by_a_nose(self, r):
        """The lowest that a circle of radius r can reach without cutting into the drawing."""
        w = int(r / STEP)
        arch = [math.sqrt(max(0.0, r * r - (k * STEP) ** 2)) for k in range(w + 1)]
        centre = [max(self.highest[j] + arch[abs(j - i)] for j in range(max(0, i - w), min(self.count, i + w + 1))) for i in range(self.count)]
        return [min(centre[j] - arch[abs(j - i)] for j in range(max(0, i - w), min(self.count, i + w + 1))) for i in range(self.count)]


def arc_points(event, a, b):
    c = (event["centre"]["Z"], event["centre"]["X"])
    r = math.dist(a, c)
    first, last = math.atan2(a[1] - c[1], a[0] - c[0]), math.atan2(b[1] - c[1], b[0] - c[0])
    sweep = (last - first) % (2 * math.pi) if event["kind"] == "ccw" else -((first - last) % (2 * math.pi))
    n = max(2, math.ceil(abs(sweep) * r / STEP))
    return [(c[0] + r * math.cos(first + sweep * k / n), c[1] + r * math.sin(first + sweep * k / n)) for k in range(1, n)] + [b]


def grooved(points, grooves):
    """Grooves (Z of the right flank, of the left one, X of the bottom, X beside it) let into a contour."""
    for right, left, bottom, beside in grooves:
        at = next(i for i in range(len(points) - 1) if points[i][0] >= right and points[i + 1][0] <= left and points[i][1] == points[i + 1][1] == beside)
        points = points[: at + 1] + [[right, beside], [right, bottom], [left, bottom], [left, beside]] + points[at + 1 :]
    return points


class JobsBecomeTheirDrawing(Case):
    def judge(self, name):
        folder = SOURCE / "examples/jobs" / name
        drawing = json.loads((folder / "drawing.json").read_text())
        setup = tomllib.loads((folder / f"{name}.setup.toml").read_text())
        done = self.polyturn("check", folder / f"{name}.job.toml")
        self.assertEqual(done.alarms, [], done.said())
        self.assertEqual(done.status, 0, done.said())
        lines = sum(1 for channel in ("O1001.nc", "O2001.nc") for line in (folder / channel).read_text().splitlines() if line.startswith("N"))
        self.assertGreaterEqual(lines, 200)
        sides = {"outer": Side(drawing, grooved(drawing["outer"], drawing.get("grooves", [])), 1.0)}
        if "inner" in drawing:
            sides["inner"] = Side(drawing, drawing["inner"], -1.0)
        here = {}
        for event in done.of("move"):
            channel, number = event["ch"], event.get("tool", {}).get("number")
            to = (event["pos"]["Z"], event["pos"]["X"] / 2)
            before, here[channel] = here.get(channel), to
            tool = drawing["tools"].get(f"{channel}.{number}")
            if before is None or tool is None or tool["side"] == "none" or event["kind"] == "thread":
                continue
            side, sign = sides[tool["side"]], sides[tool["side"]].sign
            offset = setup["channel"][str(channel)]["offset"][str(event["tool"]["offset"])]["geometry"]
            r, tip = offset.get("R", 0.0), TIPS[int(offset.get("T", 0))]
            way = arc_points(event, before, to) if event["kind"] in ("cw", "ccw") else [to]
            cuts = event["kind"] != "rapid"
            at = before
            for point in way:
                if "drill" in tool:
                    ends = [(z, sign * tool["drill"] / 2) for z, _ in (at, point)]
                    if cuts:   # the whole way from the face
                        side.pass_over(ends[0], ends[1], 0.0, 0.0, True)
                else:
                    centre = [(p[0] - r * tip[0], sign * (p[1] - r * tip[1])) for p in (at, point)]
                    side.pass_over(centre[0], centre[1], r, tool.get("flat", 0.0), cuts)
                at = point
        for what, side in sides.items():
            reach = side.left_by_a_nose(drawing["nose"])
            tolerance = drawing["tolerance"]
            for i in range(2, side.count - 2):
                if side.z(i) > -0.05:   # in front of the face: where tools come from
                    continue
                near = range(i - 2, i + 3)
                lowest, highest = min(side.lowest[j] for j in near), max(max(reach[j], side.highest[j]) if side.highest[j] - side.lowest[j] > 0.01 else reach[j] for j in near)
                self.assertGreaterEqual(side.stock[i], lowest - tolerance, f"{name} {what}: cut into the part at Z{side.z(i):.2f}")
                self.assertLessEqual(side.stock[i], highest + tolerance, f"{name} {what}: stock left at Z{side.z(i):.2f}")
                self.assertGreaterEqual(side.rapid[i], lowest - tolerance, f"{name} {what}: rapid through the part at Z{side.z(i):.2f}")

    def test_spool(self):
        self.judge("spool")

    def test_flange(self):
        self.judge("flange")

    def test_handle(self):
        self.judge("handle")

    def test_connector(self):
        self.judge("connector")

    def test_ring_arbor(self):
        self.judge("ring-arbor")


if __name__ == "__main__":
    unittest.main()
