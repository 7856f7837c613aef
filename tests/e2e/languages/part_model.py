"""The part that a run leaves: turned in a model of the stock from the trace of the axes, and compared with a drawing.

The model is a radius over Z (outside) and one for the bore, 0.01 mm apart. Each position of the axes in the trace cuts it with
the tool's own shape, so that a rapid through the stock cuts too. It knows the machine from its trace and its events only:

    x ^        ____         each tick, the nose circle (or the insert with its width) at the place of its imaginary tip
      |   ____/    |        lowers the outside where it lies below it, or widens the bore
      +--------------> z

Cost: ticks thinned to 0.02 mm of path times the cells below the nose. Weakness: what an insert's flank or shank would cut is
not in it, nor threads (ticks of thread moves are left out).
"""
import bisect
import math
import tomllib

STEP = 0.01       # mm between two cells
THIN = 0.02       # mm of path between two cuts; reversals are kept whatever their distance

# Nose centre seen from the imaginary tip, in nose radii: (X, Z) by tip direction.
CENTRE = {0: (0, 0), 1: (-1, -1), 2: (-1, 1), 3: (1, 1), 4: (1, -1), 5: (0, -1), 6: (-1, 0), 7: (0, 1), 8: (1, 0), 9: (0, 0)}


class Part:
    def __init__(self, diameter, bore, z_from, z_to):
        self.z0 = z_from
        cells = round((z_to - z_from) / STEP) + 1
        self.outside = [diameter / 2] * cells
        self.bore = [bore / 2] * cells

    def z(self, cell):
        return self.z0 + cell * STEP

    def cut(self, x, z, nose, tip, width, inside):
        """One position: x, z of the imaginary tip (x a radius). width: of an insert with two corners, measured from the tip to +Z."""
        cx, cz = x + CENTRE[tip][0] * nose, z + CENTRE[tip][1] * nose
        far = cz + max(0.0, width - 2 * nose)
        first = max(0, math.ceil((cz - nose - self.z0) / STEP))
        last = min(len(self.outside) - 1, math.floor((far + nose - self.z0) / STEP))
        # The radius is kept with the sign that makes every cut a lowering; what lies below the whole nose needs no root.
        sign, cells = (-1, self.bore) if inside else (1, self.outside)
        edge, squared, root, z0 = sign * cx, nose * nose, math.sqrt, self.z0
        lowest = edge - nose
        for cell in range(first, last + 1):
            have = sign * cells[cell]
            if have <= lowest:
                continue
            at = z0 + cell * STEP
            over = cz - at if at < cz else at - far if at > far else 0.0
            left = squared - over * over
            level = edge - root(left) if left > 0 else edge
            if level < have:
                cells[cell] = -level if inside else max(0.0, level)

    def drill(self, z, diameter, point):
        """A drill whose tip stands at z; point: its angle in degrees."""
        first = max(0, math.ceil((z - self.z0) / STEP))
        slope = math.tan(math.radians(point / 2))
        for cell in range(first, len(self.bore)):
            r = min(diameter / 2, (self.z(cell) - z) * slope)
            if self.bore[cell] < r:
                self.bore[cell] = r


def thinned(points):
    """Of (x, z): those THIN apart, and those where X or Z turns back."""
    kept, before, last = [], None, None
    for point in points:
        if last is not None:
            turn = before is not None and ((point[0] - last[0]) * (last[0] - before[0]) < 0 or (point[1] - last[1]) * (last[1] - before[1]) < 0)
            if turn and kept[-1] != last:
                kept.append(last)
            if point == last:
                continue
        if not kept or math.dist(kept[-1], point) >= THIN:
            kept.append(point)
        before, last = last, point
    if last is not None and kept[-1] != last:
        kept.append(last)
    return kept


def machined(drawing, setup, events, trace, axes):
    """The part after the run. axes: {channel: (column of X, column of Z)}; trace: {column: values}, X as a radius."""
    stock = drawing["stock"]
    part = Part(stock["diameter"], stock.get("bore", 0.0), stock["from"], stock["to"])
    cuts = []
    for channel, (x_axis, z_axis) in axes.items():
        moves = sorted((e for e in events if e.get("ev") == "move" and e.get("ch") == channel and "tool" in e), key=lambda e: e["t"])
        starts = [e["t"] for e in moves]
        run, key = [], None
        for t, x, z in zip(trace["t"], trace[x_axis], trace[z_axis]):
            at = bisect.bisect_right(starts, t) - 1
            if at < 0:
                continue
            move = moves[at]
            if move["kind"] == "thread" and t <= move["end"]:
                continue
            offset = (move["machine"]["X"] - move["pos"]["X"] / 2, move["machine"]["Z"] - move["pos"]["Z"])
            new = (channel, move["tool"]["offset"])
            if new != key and run:
                cuts.append((key, run))
                run = []
            key = new
            run.append((round(x - offset[0], 6), round(z - offset[1], 6)))
        if run:
            cuts.append((key, run))
    for (channel, offset), points in cuts:
        shape = drawing.get("tools", {}).get(f"L{channel}", {}).get(str(offset), {})
        entry = setup["channel"][str(channel)]["offset"].get(str(offset), {}).get("geometry", {})
        if not shape.get("cuts", True):   # what it does to the contour is not drawn
            continue
        for x, z in thinned(points):
            if "drill" in shape:
                if abs(x) < 0.01:
                    part.drill(z, shape["drill"], shape.get("point", 118.0))
            else:
                part.cut(x, z, entry.get("R", 0.0), int(entry.get("T", 0)), shape.get("width", 0.0), shape.get("inside", False))
    return part


def outline(rows):
    """Points of a contour at most 0.02 mm apart. A row: x (diameter), z, and for an arc its radius, positive to the left of the way (G3)."""
    points = []
    for row in rows:
        x, z = row[0] / 2, row[1]
        if not points:
            points.append((x, z))
            continue
        x0, z0 = points[-1]
        chord = math.hypot(x - x0, z - z0)
        count = max(1, math.ceil(chord / 0.02))
        if len(row) == 2:
            points += [(x0 + (x - x0) * k / count, z0 + (z - z0) * k / count) for k in range(1, count + 1)]
            continue
        r = abs(row[2])
        # Seen with Z to the right and X upward: the centre lies left of the way from start to end for a positive radius.
        h = math.sqrt(max(0.0, r * r - chord * chord / 4))
        side = 1 if row[2] > 0 else -1
        mz, mx = (z0 + z) / 2, (x0 + x) / 2
        cz, cx = mz - side * h * (x - x0) / chord, mx + side * h * (z - z0) / chord
        a0, a1 = math.atan2(x0 - cx, z0 - cz), math.atan2(x - cx, z - cz)
        turn = math.remainder(a1 - a0, 2 * math.pi)
        steps = max(2, math.ceil(abs(turn) * r / 0.02))
        points += [(cx + r * math.sin(a0 + turn * k / steps), cz + r * math.cos(a0 + turn * k / steps)) for k in range(1, steps + 1)]
    return points


class Band:
    """What a nose of radius r may leave of a contour: from the drawing to the drawing with its roots rounded by the nose."""

    def __init__(self, points, nose, inside):
        self.sign = -1 if inside else 1
        self.low, high = min(z for _, z in points), max(z for _, z in points)
        count = round((high - self.low) / STEP) + 1
        self.least, self.most = [math.inf] * count, [-math.inf] * count
        for (x0, z0), (x1, z1) in zip(points, points[1:]):
            for k in range(max(0, math.floor((min(z0, z1) - self.low) / STEP)), min(count, math.ceil((max(z0, z1) - self.low) / STEP) + 1)):
                z = min(max(self.low + k * STEP, min(z0, z1)), max(z0, z1))
                for x in (x0, x1) if abs(z1 - z0) < 1e-9 else (x0 + (x1 - x0) * (z - z0) / (z1 - z0),):
                    self.least[k], self.most[k] = min(self.least[k], self.sign * x), max(self.most[k], self.sign * x)
        wide = int(nose / STEP)
        arch = [math.sqrt(max(0.0, nose * nose - (k * STEP) ** 2)) for k in range(wide + 1)]
        centre = [max(self.most[j] + arch[abs(j - i)] for j in range(max(0, i - wide), min(count, i + wide + 1))) for i in range(count)]
        self.reach = [min(centre[j] - arch[abs(j - i)] for j in range(max(0, i - wide), min(count, i + wide + 1))) for i in range(count)]

    def around(self, z):
        at = round((z - self.low) / STEP)
        return range(max(0, at - 2), min(len(self.least), at + 3))

    def holds(self, x, z, tolerance):
        near = self.around(z)
        return bool(near) and min(self.least[k] for k in near) - tolerance <= self.sign * x <= max(max(self.reach[k], self.most[k]) for k in near) + tolerance

    def is_root(self, x, z, tolerance):
        near = self.around(z)
        return bool(near) and self.sign * x < max(self.reach[k] for k in near) - tolerance


def deviations(part, rows, inside, skip, nose=0.0, tolerance=0.0):
    """[(distance, x, z)] between drawing and part, largest first: each point of the one to the nearest of the other, both ways.
    skip: ranges of Z where the drawing says nothing (threads, the root of a corner). nose: roots may be rounded by so much."""
    wanted = outline(rows)
    radius = part.bore if inside else part.outside
    band = Band(wanted, nose, inside) if nose else None
    low, high = min(z for _, z in wanted), max(z for _, z in wanted)
    made = []
    for cell, r in enumerate(radius):
        z = part.z(cell)
        if low - 1e-9 <= z <= high + 1e-9:
            if made and abs(made[-1][0] - r) > 0.02:   # a wall
                steps = math.ceil(abs(made[-1][0] - r) / 0.02)
                x0 = made[-1][0]
                made += [(x0 + (r - x0) * k / steps, z) for k in range(1, steps)]
            made.append((r, z))

    def nearest(points):
        """Distance to the nearest point, looked up by squares of 0.25 mm."""
        squares = {}
        for x, z in points:
            squares.setdefault((int(x * 4), int(z * 4)), []).append((x, z))

        def look(x, z):
            i, k = int(x * 4), int(z * 4)
            near = [p for a in (i - 1, i, i + 1) for b in (k - 1, k, k + 1) for p in squares.get((a, b), ())]
            return min((math.dist(p, (x, z)) for p in near), default=0.25)
        return look

    to_drawing, to_part = nearest(wanted), nearest(made)
    if band:   # a point between the drawing and what a nose can reach is as good as one on it
        made = [(x, z) for x, z in made if not band.holds(x, z, tolerance / 2)]
        wanted = [(x, z) for x, z in wanted if not band.is_root(x, z, tolerance / 2)]
    found = [(to_drawing(x, z), x, z) for x, z in made] + [(to_part(x, z), x, z) for x, z in wanted]
    found = [(d, 2 * x, z) for d, x, z in found if not any(a <= z <= b for a, b in skip)]
    return sorted(found, reverse=True) or [(0.0, 0.0, 0.0)]


def read_toml(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))
