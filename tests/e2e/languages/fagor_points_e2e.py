#!/usr/bin/env python3
"""Random programs of the language fagor beside a small model of what its words mean (fagor_8037t part 1, 3.3 to 3.6, 4.3, 4.4, 6, 7.5,
7.6): units, diameters, increments, zeros that replace and add to each other, mirror, scale, polar points, every form of an arc."""
import json
import math
import os
import random
import unittest

from polyturn_runner import Case
from seeds import seeds

PROGRAMS = 60
FIRST = int(os.environ.get("FAGOR_SEED", "0"))
ZEROS = ("G54", "G55", "G56", "G57", "G58", "G59", "G159N9", "G159N14")
TOLERANCE = 0.004   # words have four decimals, five in inches


def written(value):
    text = f"{value:.5f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


class Model:
    """Where the tool stands: X as a radius, millimetres. `at` is the commanded point of the part, mirrored and scaled."""

    def __init__(self, seed):
        self.draw = random.Random(seed)
        self.table = {name: [round(self.draw.uniform(-9, 9), 2), round(self.draw.uniform(-60, 60), 2)] for name in ZEROS}
        self.lengths = {n: [round(self.draw.uniform(-9, 9), 2), round(self.draw.uniform(-30, 30), 2)] for n in (1, 2, 3)}
        self.lines = ["G18 G71 G90 G94 G151", "F500"]
        self.diameter, self.inch, self.absolute = True, False, True
        self.base, self.zero, self.preset = [0.0, 0.0], [0.0, 0.0], False
        self.tool, self.pole = [0.0, 0.0], [0.0, 0.0]
        self.scale, self.mirror = 1.0, [1, 1]
        self.at, self.machine = [100.0, 100.0], [100.0, 100.0]
        self.points, self.slides, self.kinds = [], [], []
        for _ in range(self.draw.randint(14, 26)):
            self.draw.choices((self.mode, self.shift, self.offset, self.frame, self.polar_origin, self.line, self.polar, self.arc),
                              (10, 8, 4, 5, 3, 30, 14, 40))[0]()
        self.lines.append("M30")

    # --- numbers as the program writes them, and what they come to
    @property
    def unit(self):
        return 25.4 if self.inch else 1.0

    def length_word(self, mm):
        word = round(mm / self.unit, 5 if self.inch else 4)
        return written(word), word * self.unit

    def x_word(self, radius):
        text, mm = self.length_word(radius * (2 if self.diameter else 1))
        return text, mm / (2 if self.diameter else 1)

    def programmed(self):
        return [self.at[i] / (self.scale * self.mirror[i]) for i in (0, 1)]

    def plain(self):
        return self.scale == 1 and self.mirror == [1, 1]

    def tool_is_new(self):
        return max(abs(self.at[i] + self.zero[i] + self.tool[i] - self.machine[i]) for i in (0, 1)) > 1e-9

    def go(self, to, kind):
        self.at = [to[i] * self.scale * self.mirror[i] for i in (0, 1)]
        self.machine = [self.at[i] + self.zero[i] + self.tool[i] for i in (0, 1)]
        self.points.append((self.at[0] * (2 if self.diameter else 1), self.at[1]))
        self.slides.append(tuple(self.machine))
        self.kinds.append(kind)

    def end_words(self, to, axes="XZ"):
        here = self.programmed()
        text, end = "", list(here)
        for axis, i, word in (("X", 0, self.x_word), ("Z", 1, self.length_word)):
            if axis not in axes:
                continue
            number, mm = word(to[i] if self.absolute else to[i] - here[i])
            text += f" {axis}{number}"
            end[i] = mm if self.absolute else here[i] + mm
        return text, end

    # --- blocks
    def mode(self):
        which = self.draw.choice(("diameter", "inch", "absolute"))
        setattr(self, which, not getattr(self, which))
        self.lines.append({"diameter": "G151" if self.diameter else "G152", "inch": "G70" if self.inch else "G71", "absolute": "G90" if self.absolute else "G91"}[which])

    def shift(self):
        code = self.draw.choice(("G54", "G55", "G56", "G57", "G58", "G59", "G159", "G92", "G53"))
        if code == "G92":
            if not self.plain() or self.tool_is_new():
                return
            number, mm = self.length_word(self.draw.uniform(-50, 50))
            self.lines.append(f"G92 Z{number}")
            self.preset, self.base = True, [self.zero[0], self.at[1] + self.zero[1] - mm]
            return self.take_zero(self.base)
        if code in ("G58", "G59"):
            if self.preset:
                return
            self.lines.append(code)
            return self.take_zero([self.base[i] + self.table[code][i] for i in (0, 1)])
        name, self.preset = code, False
        if code == "G159":
            n = self.draw.choice((1, 5, 9, 14))   # 5 is the entry of G58, absolute here
            code, name = f"G159 N{n}", {1: "G54", 5: "G58", 9: "G159N9", 14: "G159N14"}[n]
        self.lines.append(code)
        self.base = [0.0, 0.0] if code == "G53" else list(self.table[name])
        return self.take_zero(self.base)

    def take_zero(self, zero):
        self.at = [self.at[i] + self.zero[i] - zero[i] for i in (0, 1)]
        self.zero = list(zero)

    def offset(self):
        n = self.draw.choice((0, 1, 2, 3))
        self.lines.append(f"D{n}")
        self.tool = self.lengths.get(n, [0.0, 0.0])

    def frame(self):
        code = self.draw.choice(("G10", "G11", "G13", "G11 G13", "G72"))
        if code == "G72":
            self.scale = self.draw.choice((1, 0.5, 2, 1.25))
            code = f"G72 S{self.scale:g}"
        elif code == "G10":
            self.mirror = [1, 1]
        else:
            self.mirror = [-1 if "G11" in code else self.mirror[0], -1 if "G13" in code else self.mirror[1]]
        self.lines.append(code)

    def polar_origin(self):
        if not self.plain():
            return
        if self.draw.random() < 0.3:
            self.lines.append("G93")
            self.pole = [self.at[i] + self.zero[i] for i in (0, 1)]
            return
        abscissa, z = self.length_word(self.draw.uniform(-20, 20))
        ordinate, x = self.x_word(self.draw.uniform(-20, 20))
        self.lines.append(f"G93 I{abscissa} J{ordinate}")
        self.pole = [x + self.zero[0], z + self.zero[1]]

    def line(self):
        code = self.draw.choice((0, 1))
        here = self.programmed()
        to = [here[i] + self.draw.choice((-1, 1)) * self.draw.uniform(1, 12) for i in (0, 1)]
        text, end = self.end_words(to, self.draw.choice(("X", "Z", "XZ")))
        self.lines.append(f"G{code:02}{text}")
        self.go(end, ("rapid", "linear")[code])

    def polar(self):
        if not self.plain():
            return
        here, pole = self.programmed(), [self.pole[i] - self.zero[i] for i in (0, 1)]
        radius, angle = math.hypot(here[0] - pole[0], here[1] - pole[1]), math.degrees(math.atan2(here[0] - pole[0], here[1] - pole[1]))
        if radius < 0.5:
            return
        text = "G01"
        which = self.draw.choice(("R", "Q", "RQ"))
        if "R" in which:
            wanted = self.draw.uniform(3, 30)
            number, mm = self.length_word(wanted if self.absolute else wanted - radius)
            text += f" R{number}"
            radius = mm if self.absolute else radius + mm
        if "Q" in which:
            degrees = round(self.draw.uniform(-700, 700) if self.absolute else self.draw.uniform(-170, 170), 2)
            text += f" Q{written(degrees)}"
            angle = degrees if self.absolute else angle + degrees
        end = [pole[0] + radius * math.sin(math.radians(angle)), pole[1] + radius * math.cos(math.radians(angle))]
        if math.dist(end, here) < 0.01:
            return
        self.lines.append(text)
        self.go(end, "linear")

    def arc(self):
        if self.tool_is_new():   # the arc would begin where the new tip is not yet
            return
        here = self.programmed()
        radius, first, sweep = self.draw.uniform(3, 15), self.draw.uniform(-180, 180), self.draw.choice((-1, 1)) * self.draw.uniform(40, 330)
        if 172 < abs(sweep) < 188:
            return
        on = lambda centre, degrees: [centre[0] + radius * math.sin(math.radians(degrees)), centre[1] + radius * math.cos(math.radians(degrees))]
        centre = [2 * here[i] - on(here, first)[i] for i in (0, 1)]
        clockwise = sweep < 0
        text, end = self.end_words(on(centre, first + sweep))
        code = "G02" if clockwise else "G03"
        form = self.draw.choice(("IK", "R", "G06", "G09"))
        if form == "IK":
            self.lines.append(f"{code}{text} I{self.length_word(centre[0] - here[0])[0]} K{self.length_word(centre[1] - here[1])[0]}")
        elif form == "R":
            self.lines.append(f"{code}{text} R{self.length_word(radius if abs(sweep) < 180 else -radius)[0]}")
        elif form == "G06":
            self.lines.append(f"G06 {code}{text} I{self.x_word(centre[0])[0]} K{self.length_word(centre[1])[0]}")
        else:
            middle = on(centre, first + sweep * self.draw.uniform(0.3, 0.7))
            self.lines.append(f"G09{text} I{self.x_word(middle[0])[0]} K{self.length_word(middle[1])[0]}")
        mirrored = self.mirror[0] * self.mirror[1] < 0
        self.go(end, "cw" if clockwise != mirrored else "ccw")


class FagorPoints(Case):
    def test_random_programs_go_where_the_model_does(self):
        for seed in seeds("fagor_points_e2e", "FAGOR_SEED", FIRST, PROGRAMS, 5):
            with self.subTest(seed=seed):
                model = Model(seed)
                pairs = [f"{name} = {{ X = {x}, Z = {z} }}" for name, (x, z) in model.table.items()]
                setup = "[channel.1]\nmachine = { X = 200.0, Z = 100.0 }\nwork = { " + ", ".join(pairs) + " }\n"
                for n, (x, z) in model.lengths.items():
                    setup += f"[channel.1.offset.{n}]\ngeometry = {{ X = {x}, Z = {z}, R = 0.0, T = 0 }}\n"
                text = "\n".join(model.lines) + "\n"
                done = self.polyturn("check", "--language", "fagor", "--set", "N1000=0", "--set", "FG.CIRINERR=0.05", "--setup", self.write("setup.toml", setup), f"1={self.write('1.nc', text)}")
                self.assertEqual(done.alarms, [], text)
                moves = done.of("move")
                self.assertEqual([e["kind"] for e in moves], model.kinds, text)
                for move, point, slide in zip(moves, model.points, model.slides):
                    for axis, i in (("X", 0), ("Z", 1)):
                        self.assertAlmostEqual(move["pos"][axis], point[i], delta=TOLERANCE, msg=f"{text}{json.dumps(move)}")
                        self.assertAlmostEqual(move["machine"][axis], slide[i], delta=TOLERANCE, msg=f"{text}{json.dumps(move)}")


if __name__ == "__main__":
    unittest.main()
