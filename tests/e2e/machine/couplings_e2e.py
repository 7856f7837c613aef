#!/usr/bin/env python3
"""What turns by another's turns, balance cut, part transfer, measured errors and guarded shapes: from program and file to the axes, good
and bad input."""
import json
import shutil
import unittest

from polyturn_runner import SOURCE, Case, read_trace

MACHINES = SOURCE / "examples/machines"
JOBS = SOURCE / "examples/jobs"


def unwound(angles):
    """Revolutions over all turns from angles of 0 to 360 degrees."""
    turns, out = 0.0, []
    for i, angle in enumerate(angles):
        if i:
            turns += (angle - angles[i - 1] + 540.0) % 360.0 - 180.0
        out.append((angles[0] + turns) / 360.0)
    return out


def sets(*lines):
    return [word for line in lines for word in ("--set", line)]


class Coupled(Case):
    def run_program(self, language, text, *options, status=0):
        program = self.write("O1.nc", text)
        done = self.polyturn("run", "--virtual", "--language", language, f"1={program}", "--trace", "trace.csv", *options)
        self.assertEqual(done.status, status, done.said())
        return done, read_trace(self.folder / "trace.csv")

    def between(self, trace, begin, end):
        return [i for i, t in enumerate(trace["t"]) if begin <= t <= end]


class Polygon(Coupled):
    CUTTER = ("N0607 S3=7",)   # it can close its loop

    def run_program(self, language, text, *options, status=0):
        return super().run_program(language, text, *sets(*self.CUTTER), *options, status=status)

    def test_the_cutter_turns_by_the_spindle_and_stops_with_it(self):
        for ratio, sign in (("P1 Q2", 2), ("P1 Q-2", -2), ("P2 Q3", 1.5)):
            with self.subTest(ratio=ratio):
                done, trace = self.run_program("fanuc", f"O1\nG97 S300 M3\nG4 X2.\nG51.2 {ratio}\nG4 X2.\nS500\nG4 X2.\nG50.2\nG4 X3.\nM5\nM30\n")
                dwells = done.of("dwell")
                inside = self.between(trace, dwells[1]["t"] + 0.1, dwells[2]["t"] + 2.0)
                master, cutter = unwound(trace["S1.angle"]), unwound(trace["S3.angle"])
                apart = [cutter[i] - sign * master[i] for i in inside]
                self.assertLess(max(apart) - min(apart), 10 / 360, "degrees, while the spindle changes its speed too")
                whole = abs(apart[-1] - round(apart[-1] * 2) / 2)
                self.assertLess(whole, 10 / 360, "from the one-rotation signal on")
                self.assertLess(abs(trace["S3.speed"][-1]), 5, "the cutter is free again and stands")

    def test_what_cannot_be_is_an_alarm(self):
        for text, number, options in (("G51.2 P0 Q1", "218", ()), ("G51.2 P1 Q10", "218", ()), ("G51.2 Q1", "218", ()), ("G51.2 P1 Q1\nG51.2 P1 Q1", "217", ()),
                                      ("G51.2 P1 Q1", "PT0699", sets("PT_DRIVEN_SPINDLE L1=0"))):
            with self.subTest(text=text, options=options):
                done, trace = self.run_program("fanuc", f"O1\nG97 S300 M3\n{text}\nG4 X1.\nM30\n", *options, status=1)
                self.assertIn(number, [str(a["number"]) for a in done.alarms], done.said())


class GearBox(Coupled):
    AXES = ("N1801 L1=3", "N1802 L1=5", "N1803 L1=2", "N1804 A1=15", "N1805 L1=1200", "N0817 S3=66", "N0607 S3=7")

    def test_the_workpiece_turns_by_the_hob_and_by_the_way_of_z(self):
        text = "G18 G90 G94\nG0 Z5. X100.\nM13\nG4 P1.\nG81.8 T20 L2 Q2. P30.\nG4 P2.\nG1 Z-15. F300.\nG4 P0.5\nG80.8\nM15\nM30\n"
        done, trace = self.run_program("nct", text, *sets(*self.AXES))
        move = [e for e in done.of("move", ch=1, kind="linear")][0]
        hob = unwound(trace["S3.angle"])
        inside = self.between(trace, move["t"] - 1.0, move["end"] + 0.3)
        import math
        helix = math.sin(math.radians(30)) / (math.pi * 2.0 * 20) * 360.0
        apart = [trace["A5.cmd"][i] - hob[i] * 360 * 2 / 20 - helix * trace["A2.cmd"][i] for i in inside]
        apart = [a - 360 * round((a - apart[0]) / 360) for a in apart]
        self.assertLess(max(apart) - min(apart), 1.0, "degrees")

    def test_a_reset_takes_it_out_of_the_work_first(self):
        self.write("s.toml", '[[at]]\nwhen = { ev = "move", ch = 1, kind = "linear" }\nafter = 1.0\npress = "reset"\n')
        text = "G18 G90 G94\nG0 Z5. X100.\nM13\nG4 P1.\nG81.8 T20 L1\nG1 Z-15. F100.\nG80.8\nM30\n"
        _, kept = self.run_program("nct", text, *sets(*self.AXES, "N1800 L1=0"), "--scenario", "s.toml")
        _, gone = self.run_program("nct", text, *sets(*self.AXES, "N1800 L1=1"), "--scenario", "s.toml")
        self.assertAlmostEqual(kept["A1.cmd"][-1], 50.0, places=3, msg="RCE 0: nothing is retracted, it stays closed")
        self.assertGreater(gone["A1.cmd"][-1], 50.001, "RCE 1: it goes N1804 away (the run ends with the reset), then it opens")

    def test_the_plc_takes_it_out_of_the_work(self):   # nct part 2, 19: CP_EGBRRQ; an order, no fault
        axes = ("N0002 A7=1", "N0100 A7=66", "N0106 A7=2", "N0900 A7=8", "N1801 L1=1", "N1802 L1=7", "N1804 A1=15", "N1805 L1=1200")
        text = "G18 G90 G94\nG0 Z5. X100.\nS60 M3\nG4 P3.\nG81.8 T20 L1\nG1 Z-15. F100.\nG80.8\nM30\n"
        for opens in (0, 1):
            with self.subTest(RCE=opens):
                self.write("s.toml", '[[at]]\nt = 6.0\nset = "CP_EGBRRQ L1=1"\n')
                done, trace = self.run_program("nct", text, *sets(*axes, f"N1800 L1={opens}"), "--scenario", "s.toml", status=1 - opens)
                self.assertEqual([a["severity"] for a in done.of("alarm", number="PT0687")], ["warning"], done.said())
                self.assertAlmostEqual(trace["A1.cmd"][-1], 65.0, places=3, msg="N1804 away")
                self.assertGreater(trace["A2.cmd"][-1], -14, "the cut is held")
                if not opens:
                    self.assertEqual(done.of("stop", ch=1)[-1]["reason"], "held")
                    self.assertGreater(abs(trace["A7.cmd"][-1] - trace["A7.cmd"][-2]), 1e-6, "the gear stays closed, and the run ends all the same")

    def test_what_the_plc_has_taken_out_goes_back_and_on(self):   # RCE 0
        axes = ("N0002 A7=1", "N0100 A7=66", "N0106 A7=2", "N0900 A7=8", "N1801 L1=1", "N1802 L1=7", "N1804 A1=15", "N1805 L1=1200", "N1800 L1=0")
        text = "G18 G90 G94\nG0 Z5. X100.\nS60 M3\nG4 P3.\nG81.8 T20 L1\nG1 Z-15. F100.\nG80.8\nM5\nM30\n"
        self.write("s.toml", '[[at]]\nt = 6.0\nset = "CP_EGBRRQ L1=1"\n[[at]]\nt = 9.5\nset = "CP_EGBRRQ L1=0"\n'
                             '[[at]]\nt = 10.0\npress = "return L1"\n[[at]]\nt = 12.0\npress = "cycle_start L1"\n')
        done, trace = self.run_program("nct", text, *sets(*axes), "--scenario", "s.toml")
        at = lambda t: min(range(len(trace["t"])), key=lambda i: abs(trace["t"][i] - t))
        self.assertAlmostEqual(trace["A1.cmd"][at(9.9)], 65.0, places=3)
        self.assertAlmostEqual(trace["A1.cmd"][at(11.9)], 50.0, places=3)
        self.assertAlmostEqual(trace["A2.cmd"][-1], -15.0, places=3, msg="and the cut goes on to its end")
        self.assertLess(max(abs(trace["A1.cmd"][i] - trace["A1.cmd"][i - 1]) for i in range(1, len(trace["t"]))), 1.0, "nothing jumps")

    def test_what_is_missing_is_named(self):
        for lines, block in ((("N1802 L1=5", "N0817 S3=66"), "G81.8 T20"), (("N1801 L1=3", "N0817 S3=66"), "G81.8 T20"), (self.AXES, "G81.8 T0"), (self.AXES, "G81.8 T20 L0"),
                             (self.AXES, "G81.8 T20 P30."), (self.AXES[:2] + ("N0817 S3=66",), "G81.8 T20 Q2. P30.")):
            with self.subTest(block=block, lines=lines):
                done, _ = self.run_program("nct", f"M13\n{block}\nM30\n", *sets(*lines), status=1)
                self.assertIn("PT0688", [str(a["number"]) for a in done.alarms], done.said())


class Balance(Coupled):
    def job(self, *options, status=0):
        done = self.polyturn("run", "--virtual", JOBS / "pinch/pinch.job.toml", "--trace", "trace.csv", *options)
        self.assertEqual(done.status, status, done.said())
        return done

    def test_both_turrets_begin_each_run_of_cuts_in_the_same_tick(self):
        done = self.job()
        first = [[e for e in done.of("move", ch=ch, kind="linear")] for ch in (1, 2)]
        for upper, lower in zip((first[0][0], first[0][1]), (first[1][0], first[1][1])):
            self.assertAlmostEqual(upper["t"], lower["t"], places=6)
        self.assertTrue(done.of("wait", code="G68"), done.said())
        trace = read_trace(self.folder / "trace.csv")
        cut = self.between(trace, first[0][0]["t"] + 0.2, min(first[0][0]["end"], first[1][0]["end"]) - 0.3)
        apart = [trace["A2.cmd"][i] - trace["A4.cmd"][i] for i in cut]
        self.assertLess(max(apart) - min(apart), 1e-6, "3 mm behind, all the way")

    def test_what_slows_or_holds_one_does_so_to_both(self):
        self.write("s.toml", '[[at]]\nwhen = { ev = "move", ch = 1, kind = "linear" }\nafter = 1.0\npress = "feed_override L2=50"\n'
                             '[[at]]\nwhen = { ev = "move", ch = 1, kind = "linear" }\nafter = 3.0\npress = "feed_hold L1"\n'
                             '[[at]]\nwhen = { ev = "move", ch = 1, kind = "linear" }\nafter = 5.0\npress = "cycle_start"\n')
        done = self.job("--scenario", "s.toml")
        trace = read_trace(self.folder / "trace.csv")
        upper, lower = (done.of("move", ch=ch, kind="linear")[0] for ch in (1, 2))
        cut = self.between(trace, upper["t"], min(upper["end"], lower["end"]) - 0.5)
        apart = [trace["A2.cmd"][i] - trace["A4.cmd"][i] for i in cut]
        self.assertLess(max(apart) - min(apart), 0.01)
        held = self.between(trace, upper["t"] + 3.6, upper["t"] + 4.9)
        for axis in ("A2.cmd", "A4.cmd"):
            self.assertEqual(trace[axis][held[0]], trace[axis][held[-1]], "held together")

    def test_programs_that_do_not_fit_are_an_alarm(self):
        one = self.write("O1.nc", "O1\nG98\nG68\nG1 X50. F500\nG0 X60.\nG1 X50.\nG69\nM30\n")
        two = self.write("O2.nc", "O2\nG98\nG68\nG1 X50. F500\nG69\nM30\n")
        done = self.polyturn("run", "--virtual", "--language", "fanuc", "--machine", MACHINES / "transfer", f"1={one}", f"2={two}")
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue(done.alarms, done.said())


class Follower(Coupled):
    def test_the_drive_of_a_resting_c_axis_is_the_followers(self):   # sinumerik part 3, 7.18, on the default machine
        for kind in ("DV", "VV"):
            with self.subTest(kind):
                text = f'S1=500 M1=3\nCOUPDEF(S2,S1,1,1,"FINE","{kind}")\nCOUPON(S2,S1)\nG4 F2\nCOUPOFS(S2,S1)\nG4 F2\nWAITM(1,1,2)\nM30\n'
                one, two = self.write("ONE.MPF", text), self.write("TWO.MPF", "WAITM(1,1,2)\nG0 C90\nM30\n")
                done = self.polyturn("run", "--virtual", "--language", "sinumerik", "--trace", "trace.csv", f"1={one}", f"2={two}")
                self.assertEqual((done.status, done.alarms), (0, []), done.said())
                trace, dwell = read_trace(self.folder / "trace.csv"), done.of("dwell", ch=1)[0]
                coupled = [i for i, t in enumerate(trace["t"]) if dwell["t"] + 0.1 <= t <= dwell["end"] - 0.1]
                self.assertLess(max(abs(trace["S2.speed"][i] - trace["S1.speed"][i]) for i in coupled), 25)
                self.assertAlmostEqual(trace["S2.speed"][coupled[-1]], 500, delta=1)
                self.assertAlmostEqual(trace["S2.speed"][-1], 0, delta=1)
                self.assertEqual(done.of("move", ch=2)[0]["pos"]["C"], 90)


    def test_what_is_let_go_turns_on_as_fast_as_it_did(self):   # COUPOF, COUPOFS; COUPONC keeps its own speed over the coupling
        for begin, on, speed in (("", "COUPON", 600), ("S2=100 M2=3\nG4 F2\n", "COUPONC", 700), ("S2=100 M2=4\nG4 F2\n", "COUPONC", 500)):
            for off in ("COUPOF", "COUPOFS"):
                with self.subTest(on=on, off=off, speed=speed):
                    text = f'S300 M3\n{begin}COUPDEF(S2,S1,2,1,"COARSE","DV")\n{on}(S2,S1)\nG4 F3\n{off}(S2,S1)\nG4 F3\nM2=5\nG4 F3\nM5\nM30\n'
                    done, trace = self.run_program("sinumerik", text)
                    self.assertEqual(done.alarms, [])
                    dwells = done.of("dwell")[-3:]
                    until = 1 if off == "COUPOF" else 0
                    for i in self.between(trace, dwells[0]["t"] + 2.5, dwells[until]["end"] - 0.05):
                        self.assertAlmostEqual(trace["S2.speed"][i], speed, delta=10)
                    for i in self.between(trace, dwells[until + 1]["t"] + 2.0, dwells[until + 1]["end"]):
                        self.assertAlmostEqual(trace["S2.speed"][i], 0, delta=1)


class Transfer(Coupled):
    def job(self, *lines, status=0, scenario=None):
        more = ["--scenario", scenario] if scenario else []
        done = self.polyturn("run", "--virtual", JOBS / "transfer/transfer.job.toml", "--trace", "trace.csv", *sets(*lines), *more)
        self.assertEqual(done.status, status, done.said())
        return done

    def test_the_part_passes_over_in_phase_and_is_cut_on_its_way(self):
        done = self.job()
        self.assertEqual(done.alarms, [])
        trace = read_trace(self.folder / "trace.csv")
        main, counter = unwound(trace["S1.angle"]), unwound(trace["S2.angle"])
        codes = {e["code"]: e for e in done.of("aux", ch=2)}
        clamped = self.between(trace, codes["M10"]["t"], codes["M62"]["t"])
        apart = [counter[i] + main[i] for i in clamped]
        self.assertLess((max(apart) - min(apart)) * 360, 2.0, "degrees, while both hold the part")
        self.assertLess(abs(apart[0] - round(apart[0])) * 360, 2.0, "zero pulse beside zero pulse")
        pull = done.of("move", ch=2, kind="linear")[0]
        during = self.between(trace, pull["t"], pull["end"])
        ways = [trace["A5.cmd"][i] - trace["A5.cmd"][during[0]] for i in during]
        self.assertAlmostEqual(ways[-1], -100.0, delta=0.6)
        own = [trace["A2.cmd"][i] + trace["A5.cmd"][i] for i in during]   # the other way round: what is left is what the program cuts
        self.assertAlmostEqual(max(own) - min(own), 16.0, delta=0.1)

    def test_it_fails_when_a_function_is_off(self):
        for line, number in (("PT_M_FOLLOW S2=0", "PT0553"), ("PT_M_SUPER A2=0", "3001"), ("N2108 A2=0", "3001"), ("PT_DRIVE_STOP A5=1000000", "3002")):
            with self.subTest(line=line):
                done = self.job(line, status=1)
                if number.startswith("PT05"):   # the PLC names its message
                    self.assertIn("must not clamp", done.out + done.err, done.said())
                else:
                    self.assertIn(number, [str(a["number"]) for a in done.alarms], done.said())


    def test_a_part_that_is_not_cut_off_holds_the_slide(self):
        done = self.job("PT_DRIVE_HELD A5=445", status=1)
        self.assertIn("3003", [str(a["number"]) for a in done.alarms], done.said())
        trace = read_trace(self.folder / "trace.csv")
        self.assertGreater(trace["A5.act"][-1], 444.5, "the slide stays where the bar holds the part")


class HeadAndTable(Coupled):
    """Tool tip control: a B head about Y and the C spindle as a table about Z, against rotation matrices written down here."""
    AXES = ("N0002 A8=1", "N0100 A8=66", "N0103 A8=0", "N0106 A8=2", "N0302 A8=6000", "N0304 A8=12000", "N0305 A8=12000", "N0314 A8=6000", "N0315 A8=6000",
            "N0400 A8=2000", "N0401 A8=0.05", "N0402 A8=2000", "N0504 A8=40", "N0511 A8=1", "N0515 A8=3", "N0516 A8=0.01", "N0521 A8=20", "N0503 A8=18",
            "N3200 L1=3", "N3204 L1=8", "N3205 L1=2", "N3208 L1=5", "N3209 L1=3", "N3213 L1=3", "N3214 L1=-2", "N3215 L1=-300",
            "N3219 L1=10", "N3220 L1=0", "N3221 L1=80")
    TABLE, PIVOT, TOOL, ZERO = (3.0, -2.0, -300.0), (10.0, 0.0, 80.0), (20.0, 0.0, 30.0), (0.0, 0.0, -150.0)

    @staticmethod
    def turned(point, axis, degrees):
        import math
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        x, y, z = point
        return (c * x + s * z, y, c * z - s * x) if axis == "Y" else (c * x - s * y, s * x + c * y, z)

    def tip(self, x, y, z, b, c):
        """Where the tip is on the part, the part lying at C 0, in the program's coordinates."""
        arm = self.turned([-p - t for p, t in zip(self.PIVOT, self.TOOL)], "Y", b)
        room = [m + p + a for m, p, a in zip((x, y, z), self.PIVOT, arm)]
        part = self.turned([r - t for r, t in zip(room, self.TABLE)], "Z", -c)
        return [p + t - zero for p, t, zero in zip(part, self.TABLE, self.ZERO)]

    def drive(self, language, text, *more, status=0):
        setup = self.write("s.toml", "[channel.1]\nmachine = { X = 400.0, Y = 0.0, Z = 0.0 }\nwork = { G54 = { X = 0.0, Y = 0.0, Z = -150.0 } }\n"
                                     "[channel.1.offset.1]\ngeometry = { X = 40.0, Z = 30.0 }\n")
        return self.run_program(language, text, "--machine", MACHINES / "twin-turret-y", "--setup", setup, *sets(*self.AXES, *more), status=status)

    TEXT = "O1\nG98\nT0101\nG0 X200. Z50.\nG43.4\nG1 X120. Y5. Z20. F3000\nX100. Y-5. Z0. B30. C60.\nX60. Z-10. B-20. C90.\nG49\nG0 X200. Z80.\nM30\n"

    def test_the_tip_goes_where_the_program_says(self):
        done, trace = self.drive("fanuc", self.TEXT)
        self.assertEqual(done.alarms, [])
        moves = done.of("move", ch=1, kind="linear")
        self.assertEqual(len(moves), 3)
        for move in moves:
            m, p = move["machine"], move["pos"]
            there = self.tip(m["X"], m["Y"], m["Z"], m.get("B", 0.0), m.get("C", 0.0))
            for got, wanted in zip(there, (p["X"] / 2, p["Y"], p["Z"])):
                self.assertAlmostEqual(got, wanted, places=4)
        before, move = moves[0]["pos"], moves[1]
        import math
        a, e = [(before["X"] / 2, before["Y"], before["Z"]), (move["pos"]["X"] / 2, move["pos"]["Y"], move["pos"]["Z"])]
        way = [q - p for p, q in zip(a, e)]
        length = math.dist(a, e)
        worst = 0.0
        for i in self.between(trace, move["t"] + 0.05, move["end"] - 0.05):
            at = self.tip(*(trace[f"A{n}.cmd"][i] for n in (1, 7, 2, 8, 5)))
            along = sum((p - s) * w for p, s, w in zip(at, a, way)) / length
            worst = max(worst, math.dist(at, [s + w * along / length for s, w in zip(a, way)]))
        self.assertLess(worst, 0.006, "a straight line, but for the blends of PT_PATH_TOL at its ends")

    def test_the_length_of_a_milling_tool_lies_along_n3201(self):
        setup = self.write("s.toml", "[channel.1]\nmachine = { X = 400.0, Y = 0.0, Z = 0.0 }\n[channel.1.offset.2]\ngeometry = { Z = 50.0 }\n")
        program = self.write("O1.nc", "G94 G90\nG43.4 H2\nG1 X100. Y5. Z20. F1000\nM30\n")
        for direction, axis in ((1, "X"), (2, "Y"), (3, "Z")):
            with self.subTest(axis=axis):
                done = self.polyturn("check", "--language", "nct", "--machine", MACHINES / "twin-turret-y", "--setup", setup, *sets(*self.AXES, "N0001 L1=1", "N0106 A1=0", f"N3201 L1={direction}"), program)
                self.assertEqual(done.status, 0, done.said())
                move = done.of("move", kind="linear")[0]
                for name, value in (("X", 100.0), ("Y", 5.0), ("Z", 20.0)):
                    self.assertAlmostEqual(move["machine"][name], value + (50.0 if name == axis else 0.0), places=6, msg=name)

    OUTER, SECOND = (5.0, 4.0, 60.0), (0.0, 6.0, 25.0)
    KINDS = {
        1: ("N3200 L1=1", "N3204 L1=5", "N3205 L1=3", "N3208 L1=8", "N3209 L1=2", "N3222 L1=5", "N3223 L1=4", "N3224 L1=60", "N1002 A7=300", "N1003 A7=-300"),          # C carries B, both in the head
        2: ("N3200 L1=2", "N3204 L1=8", "N3205 L1=2", "N3208 L1=5", "N3209 L1=3", "N3216 L1=0", "N3217 L1=6", "N3218 L1=25"),          # B tilts the table C
    }

    def tip_of(self, kind, x, y, z, b, c):
        """Likewise for both axes in the head (1) and both in the table (2)."""
        add = lambda *vs: [sum(v) for v in zip(*vs)]
        less = lambda u, v: [p - q for p, q in zip(u, v)]
        if kind == 1:   # two arms: from C's pivot to B's, and from B's to the tip
            arm = self.turned(less([-p for p in self.PIVOT], self.TOOL), "Y", b)
            return less(add((x, y, z), self.PIVOT, self.OUTER, self.turned(less(arm, self.OUTER), "Z", c)), self.ZERO)
        centre = add(self.TABLE, self.SECOND)
        tilted = self.turned(less(less((x, y, z), self.TOOL), self.TABLE), "Y", -b)
        return less(add(centre, self.turned(less(tilted, self.SECOND), "Z", -c)), self.ZERO)

    def test_two_axes_in_the_head_or_in_the_table(self):
        import math
        for kind, lines in self.KINDS.items():
            with self.subTest(kind=kind):
                done, trace = self.drive("fanuc", self.TEXT, *lines)
                self.assertEqual(done.alarms, [])
                moves = done.of("move", ch=1, kind="linear")
                self.assertEqual(len(moves), 3)
                for move in moves:
                    m, p = move["machine"], move["pos"]
                    there = self.tip_of(kind, m["X"], m["Y"], m["Z"], m.get("B", 0.0), m.get("C", 0.0))
                    for got, wanted in zip(there, (p["X"] / 2, p["Y"], p["Z"])):
                        self.assertAlmostEqual(got, wanted, places=4)
                before, move = moves[0]["pos"], moves[1]
                a, e = [(q["X"] / 2, q["Y"], q["Z"]) for q in (before, move["pos"])]
                way, worst = [q - p for p, q in zip(a, e)], 0.0
                for i in self.between(trace, move["t"] + 0.05, move["end"] - 0.05):
                    at = self.tip_of(kind, *(trace[f"A{n}.cmd"][i] for n in (1, 7, 2, 8, 5)))
                    along = sum((p - s) * w for p, s, w in zip(at, a, way)) / math.dist(a, e) ** 2
                    worst = max(worst, math.dist(at, [s + w * along for s, w in zip(a, way)]))
                self.assertLess(worst, 0.006)

    def test_it_needs_its_parameters(self):
        for line in ("N3200 L1=0", "N3204 L1=3", "N3205 L1=2 ", "N3208 L1=8"):
            if line.endswith(" "):
                continue
            with self.subTest(line=line):
                done, _ = self.drive("fanuc", self.TEXT, line, status=1)
                self.assertIn("PT0722", [str(a["number"]) for a in done.alarms], done.said())
        done, _ = self.drive("fanuc", "O1\nG98\nT0101\nG43.5\nM30\n", status=1)
        self.assertIn("PT1032", [str(a["number"]) for a in done.alarms], done.said())


class MeasuredErrors(Coupled):
    LINES = ("N2500 A2=1", "N2501 A2=10", "N2502 A2=10010", "N2503 A2=10000", "N2504 A2=10020")

    def machine(self, table):
        folder = self.folder / "lathe"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(MACHINES / "twin-turret", folder)
        with open(folder / "machine.params", "a", encoding="utf-8") as file:
            file.write("\n" + "\n".join(self.LINES) + "\n")
        (folder / "machine.compensation").write_text(table, encoding="ascii")
        return folder

    def test_a_table_acts_and_the_machine_shows_its_true_position(self):
        machine = self.machine("".join(f"{10000 + i}={0.002 * (i - 10)}\n" for i in range(21)))
        plain, with_table = self.positions(MACHINES / "twin-turret"), self.positions(machine)
        self.assertEqual(plain, with_table, "commands and displays know nothing of it")

    def positions(self, machine):
        program = self.write("O1.nc", "O1\nG98\nG1 Z30. F3000\nZ-60.\nM30\n")
        setup = self.write("s.toml", "[channel.1]\nmachine = { X = 200.0, Z = 0.0 }\n")
        done = self.polyturn("run", "--virtual", "--machine", machine, "--language", "fanuc", "--setup", setup, "--trace", "trace.csv", "--trace-every", "50", program)
        self.assertEqual(done.status, 0, done.said())
        return read_trace(self.folder / "trace.csv")["A2.cmd"]

    def test_a_table_that_cannot_be_is_refused_with_its_line(self):
        good = [f"{10000 + i}=0.001" for i in range(21)]
        for table, place in ((good[:5] + good[6:], "10005"), (good + ["10003=0.1"], ":22"), (good + ["9999=0.1"], ":22"), (good + ["what"], ":22"), (good + ["10021=x"], ":22"),
                             (good + ["10021=0.1 0.2"], ":22")):
            machine = self.machine("\n".join(table) + "\n")
            with self.subTest(place=place):
                done = self.polyturn("run", "--virtual", "--machine", machine, self.write("O1.nc", "O1\nM30\n"))
                self.assertEqual(done.status, 2, done.said())
                self.assertIn("PT0696", done.out + done.err)
                self.assertIn(place, done.out + done.err)


class BorrowedAxis(Coupled):
    """L2 has a Y without a drive; exchanged, it moves the Y of L1, which meanwhile has none."""
    LINES = ("N0002 A8=2", "N0100 A8=89", "N0103 A8=2", "N0106 A8=10000000", "N2104 A8=7", "PT_M_MIX A8=63", "N1317 L2=60", "N1325 L2=70", "N1317 L1=60", "N1325 L1=70")

    def drive(self, one, two, status=0):
        setup = self.write("s.toml", "[channel.1]\nmachine = { X = 200.0, Y = 0.0, Z = 0.0 }\n[channel.2]\nmachine = { X = 200.0, Z = 0.0 }\n")
        done = self.polyturn("run", "--virtual", "--language", "fanuc", "--machine", MACHINES / "twin-turret-y", "--setup", setup, "--trace", "trace.csv", *sets(*self.LINES),
                             f"1={self.write('O1.nc', one)}", f"2={self.write('O2.nc', two)}")
        self.assertEqual(done.status, status, done.said())
        return done

    def test_it_moves_the_drive_of_the_other_channel(self):
        self.drive("O1\nG98\nM500\nM501\nG1 Y3. F1000\nM30\n", "O2\nG98\nM500\nM63\nG1 Y12. F1000\nM64\nM501\nM30\n")
        y = read_trace(self.folder / "trace.csv")["A7.cmd"]
        self.assertAlmostEqual(max(y), 12.0, places=6)
        self.assertAlmostEqual(y[-1], 3.0, places=6, msg="given back, it is the first channel's again")

    def test_an_address_without_a_drive_is_an_alarm(self):
        done = self.drive("O1\nG98\nM30\n", "O2\nG98\nG1 Y12. F1000\nM30\n", status=1)
        self.assertEqual([(a["ch"], a["line"]) for a in done.alarms], [(2, 3)], done.said())
        done = self.drive("O1\nG98\nM500\nM501\nG1 Y3. F1000\nM30\n", "O2\nG98\nM500\nM63\nM501\nG4 X1.\nM30\n", status=1)
        self.assertEqual([(a["ch"], a["line"]) for a in done.alarms], [(1, 5)], done.said())


class Shapes(Coupled):
    """Bodies of machine.toml: two carriers that would meet stop, and shapes that cannot be are refused."""

    def machine(self, more):
        folder = self.folder / "lathe"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(MACHINES / "twin-turret", folder)
        text = (folder / "machine.toml").read_text(encoding="utf-8")
        for turret, lines in more.items():
            text = text.replace(f"[turret.{turret}]\n", f"[turret.{turret}]\n{lines}\n")
        (folder / "machine.toml").write_text(text, encoding="utf-8")
        return folder

    def meet(self, machine, *lines, offset=0.0, target=""):
        setup = self.write("s.toml", "[channel.1]\nmachine = { X = 400.0, Z = 0.0 }\n[channel.1.offset.1]\n"
                                     f"geometry = {{ X = {offset}, Z = 0.0 }}\n[channel.2]\nmachine = {{ X = 100.0, Z = 0.0 }}\n")
        program = self.write("O1.nc", "O1\nG98\nT0101\nG1 X-60. F2000\nM30\n")
        return self.polyturn("run", "--virtual", "--machine", machine, "--language", "fanuc", "--setup", setup, "--trace", "trace.csv",
                             *sets("N2000 L1=15", "N2000 L2=15", *lines), program)

    def test_a_carrier_stops_before_the_other(self):
        body = "body = [{ X = [-20.0, 20.0], Z = [-30.0, 30.0] }]"
        done = self.meet(self.machine({"L1": body, "L2": body}))
        self.assertEqual(done.status, 1, done.said())
        alarm = done.alarms[0]
        self.assertEqual(alarm["number"], "PT0690", done.said())
        self.assertIn("tool carrier of L1 and tool carrier of L2", alarm["text"])
        upper = read_trace(self.folder / "trace.csv")["A1.cmd"][-1]
        self.assertGreater(upper - (-50.0), 41.0 - 0.1, "the lower one stands at -50 of the room; 40 mm of bodies and 1 mm")
        self.assertLess(upper - (-50.0), 46.0)
        self.assertEqual(self.meet(self.machine({"L1": body, "L2": body}), "N2000 L2=0").status, 0)

    def test_the_shape_of_a_tool_goes_with_its_offset(self):
        body = "body = [{ X = [-20.0, 20.0], Z = [-30.0, 30.0] }]"
        tool = body + "\ntools = { 1 = [{ X = [-60.0, 0.0], Z = [-10.0, 10.0] }] }\ntips = { 1 = { X = -60.0, Z = 0.0 } }"
        for offset, reach in ((120.0, 60.0), (160.0, 80.0), (80.0, 40.0)):   # of X as a diameter
            with self.subTest(offset=offset):
                done = self.meet(self.machine({"L1": tool, "L2": body}), offset=offset)
                self.assertEqual([a["number"] for a in done.alarms][:1], ["PT0690"], done.said())
                upper = read_trace(self.folder / "trace.csv")["A1.cmd"][-1]
                self.assertGreater(upper - (-50.0), 21.0 + reach - 0.1)
                self.assertLess(upper - (-50.0), 26.0 + reach)

    def test_a_shape_that_cannot_be_is_refused_with_its_place(self):
        for lines in ("body = [{ X = [20.0, -20.0], Z = [-30.0, 30.0] }]", 'body = [{ X = "wide", Z = [-30.0, 30.0] }]', "body = 5", "tips = { 3 = { X = -60.0 } }"):
            with self.subTest(lines=lines):
                done = self.meet(self.machine({"L1": lines}))
                self.assertEqual(done.status, 1, done.said())
                self.assertIn("PT0921", done.out + done.err)
                self.assertIn("machine.toml", done.out + done.err)

    def test_a_barrier_of_a_negative_size_is_refused(self):
        for line in ("N1902 L1=-5", "N1901 L1=-1"):
            done = self.meet(self.machine({}), line)
            self.assertEqual(done.status, 2, done.said())


if __name__ == "__main__":
    unittest.main()
