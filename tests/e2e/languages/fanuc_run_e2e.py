#!/usr/bin/env python3
"""What of the fanuc language shows only while the machine runs: loops that wait for an input, programs of the B axis, interrupt
macros, a thread that is picked up again. Real processes, virtual time."""
import json
import unittest

from polyturn_runner import SHAFT, Case, LiveCase, read_trace

B_AXIS = ["N0002 A7=1", "N0100 A7=66", "F8251=81", "F8252=82", "F8257=20", "F8240#6=1"]
SETUP = '[channel.1]\npos = { X = 50.0, Z = 0.0 }\nsubprograms = ["O8300.nc"]\n'
MAIN = "O1115\nG98\n#120=0\nM96 P8300\nN10 G01 Z-40. F600\nN20 Z-60.\nM97\nN30 Z-100.\nM30\n"   # N10 runs for 4 s


class Run(Case):
    def run_it(self, program, sets=(), scenario="", watch=(), trace=False):
        arguments = ["run", "--virtual", "--language", "fanuc", "--variables", "--setup", self.write("setup.toml", SETUP)]
        arguments += [word for one in sets for word in ("--set", one)] + [word for one in watch for word in ("--watch", one)]
        if scenario:
            arguments += ["--scenario", self.write("scenario.toml", scenario)]
        if trace:
            arguments += ["--trace", self.folder / "trace.csv"]
        done = self.polyturn(*arguments, self.write("O0001.nc", program))
        return done


class Inputs(Run):
    def test_a_loop_waits_for_an_input(self):
        for loop in ("WHILE[#1000EQ0]DO1\nEND1\n", "N10 IF[#1000EQ0]GOTO10\n"):
            with self.subTest(loop):
                done = self.run_it("O1\n" + loop + "G04 X1.\nM30\n", scenario='[[at]]\nt = 2.0\nset = "#1000 L1=1"\n')
                self.assertEqual(done.status, 0, done.said())
                self.assertAlmostEqual(done.of("dwell")[0]["t"], 2.0, delta=0.1, msg=done.said())


    def test_a_loop_that_nobody_answers_ends_the_run(self):
        for loop in ("WHILE[#1000EQ0]DO1\nEND1\n", "N10 IF[#1000EQ0]GOTO10\n"):
            with self.subTest(loop):
                done = self.run_it("O1\nG98\nG01 Z-5. F600\n" + loop + "M30\n")
                self.assertEqual(done.status, 1, done.said())
                self.assertEqual([stop["reason"] for stop in done.of("stop")], ["waiting"], done.said())
        # Those that come to an end by themselves: by counting, by the clock.
        for loop in ("#1=0\nWHILE[[#1000EQ0]AND[#1LT25000]]DO1\n#1=#1+1\nEND1\n", "#3001=0\nWHILE[[#1000EQ0]AND[#3001LT25000]]DO1\nEND1\n"):
            with self.subTest(loop):
                done = self.run_it("O1\n" + loop + "M30\n")
                self.assertEqual(done.status, 0, done.said())
                self.assertAlmostEqual(done.of("stop")[0]["t"], 25.0, delta=0.5, msg=done.said())


class Tapping(Run):
    """With a floating holder nothing ties the feed to the spindle but their two numbers: what changes one of them cuts the thread away."""
    TAP = "O1\nG98 G97 S300 M3\nG00 X0 Z5.\nG84 Z-10. R-3. F300\nG80\nG00 X60.\nM30\n"   # 12 mm at 5 mm/s, in and out

    def setUp(self):
        super().setUp()
        self.write("O8300.nc", "O8300\nM99\n")

    def test_a_feed_hold_waits_until_the_tap_is_out(self):
        for after in (1.0, 3.5):   # on the way in, and out
            with self.subTest(after):
                done = self.run_it(self.TAP, scenario=f'[[at]]\nwhen = {{ ev = "move", line = 4, kind = "linear" }}\nafter = {after}\npress = "feed_hold L1"\n'
                                                      '[[at]]\nt = 20.0\npress = "cycle_start L1"\n')
                self.assertEqual(done.status, 0, done.said())
                into, out = done.of("move", line=4, kind="linear")
                self.assertAlmostEqual(into["end"] - into["t"], 2.4, delta=0.1, msg=done.said())
                self.assertAlmostEqual(out["end"] - out["t"], 2.4, delta=0.1, msg=done.said())
                self.assertGreaterEqual(done.of("move", line=6)[0]["end"], 20.0, "then it acts\n" + done.said())

    def test_overrides_rest(self):
        press = '[[at]]\nt = 0.0\npress = "{}"\n'
        done = self.run_it(self.TAP, scenario=press.format("feed_override L1=50") + press.format("spindle_override S1=50"), trace=True)
        self.assertEqual(done.status, 0, done.said())
        trace = read_trace(self.folder / "trace.csv")
        for way in done.of("move", line=4, kind="linear"):
            self.assertAlmostEqual(way["end"] - way["t"], 2.4, delta=0.1, msg=done.said())
            middle = (way["t"] + way["end"]) / 2
            speed = min(zip(trace["t"], trace["S1.speed"]), key=lambda row: abs(row[0] - middle))[1]
            self.assertAlmostEqual(abs(speed), 300.0, delta=3.0)


    def test_a_rigid_tap_leads_the_spindle_where_its_loop_can_be_closed(self):   # fanuc_lathe 8.5: M29 S, then G84; N0823
        done = self.run_it("O1\nG98 G97\nG00 X0 Z5.\nM29 S300\nG84 Z-10. R-3. F300\nG80\nM30\n", ["N0823 S1=29"], trace=True)
        self.assertEqual(done.status, 0, done.said())
        trace = read_trace(self.folder / "trace.csv")
        for way in done.of("move", line=5, kind="linear"):
            turned, before, start, steady = 0.0, None, None, []
            for t, z, angle in zip(trace["t"], trace["A2.act"], trace["S1.angle"]):
                if not way["t"] + 0.005 <= t <= way["end"]:
                    continue
                if before is None:
                    before, start = angle, z
                turned += (angle - before + 180.0) % 360.0 - 180.0
                before = angle
                if 0.45 < (t - way["t"]) / (way["end"] - way["t"]) < 0.55:   # between its accelerations
                    steady.append(abs(turned) / 360.0 - abs(z - start))   # F / S: 1 mm a revolution; the two loops lag differently
            self.assertLess(max(steady) - min(steady), 0.02)
            self.assertAlmostEqual(abs(turned) / 360.0, 12.0, delta=0.1)

    def test_g63_puts_off_a_hold_until_g64(self):
        done = self.run_it("O1\nG98 G97 S300 M3\nG63\nG01 Z-10. F300\nG01 Z0 M4\nG64\nG00 X60.\nM30\n",
                           scenario='[[at]]\nwhen = { ev = "move", line = 4 }\nafter = 1.0\npress = "feed_hold L1"\n[[at]]\nt = 20.0\npress = "cycle_start L1"\n')
        self.assertEqual(done.status, 0, done.said())
        for line in (4, 5):
            [way] = done.of("move", line=line)
            self.assertAlmostEqual(way["end"] - way["t"], 2.0, delta=0.1, msg=done.said())
        self.assertGreaterEqual(done.of("move", line=7)[0]["end"], 20.0, done.said())

    def test_an_override_that_3004_puts_off_stays_off_behind_g64(self):   # fanuc_lathe 6.3.4
        done = self.run_it("O1\nG98\n#3004=2\nG64\nG01 Z-10. F600\n#3004=0\nG01 Z-20.\nM30\n", scenario='[[at]]\nt = 0.0\npress = "feed_override L1=50"\n')
        self.assertEqual(done.status, 0, done.said())
        for line, seconds in ((5, 1.0), (7, 2.0)):
            [way] = done.of("move", line=line)
            self.assertAlmostEqual(way["end"] - way["t"], seconds, delta=0.1, msg=done.said())

    def test_what_an_interrupt_program_puts_off_comes_back_with_m99(self):   # fanuc_lathe 6.14: all is as before the interrupt
        self.write("O8300.nc", "O8300\n#3004=1\nG04 X0.1\nM99\n")
        done = self.run_it("O1115\nG98\nM96 P8300\nN10 G01 Z-40. F600\nM97\nN30 Z-100.\nM30\n", ["F6003#2=1", "F6003#3=0"],
                           scenario='[[at]]\nt = 1.0\nset = "UINT L1=1"\n[[at]]\nt = 6.0\npress = "feed_hold L1"\n[[at]]\nt = 20.0\npress = "cycle_start L1"\n')
        self.assertEqual(done.status, 0, done.said())
        self.assertGreater(done.of("move", line=6)[0]["end"], 20.0, "the hold acts\n" + done.said())


class BAxis(Run):
    def setUp(self):
        super().setUp()
        self.write("O8300.nc", "O8300\nM99\n")

    def test_its_program_runs_while_the_path_cuts(self):
        done = self.run_it("O1\nG98\nG101\nG01 B20. F600\nG04 X1.\nG00 B5.\nG100\nM81\nG01 Z-40. F600\nM30\n", B_AXIS, trace=True)
        self.assertEqual(done.status, 0, done.said())
        trace = read_trace(self.folder / "trace.csv")
        both = [1 for b0, b1, z0, z1 in zip(trace["A7.cmd"], trace["A7.cmd"][1:], trace["A2.cmd"], trace["A2.cmd"][1:]) if b0 != b1 and z0 != z1]
        self.assertGreater(len(both), 500, "both move in the same ticks")
        self.assertAlmostEqual(max(trace["A7.cmd"]), 20.0, places=6)
        self.assertAlmostEqual(trace["A7.cmd"][-1], 5.0, places=6)
        [cut] = done.of("move", line=9)
        first, last = [m for m in done.of("move", line=8)]
        self.assertLess(first["t"], cut["t"] + 0.1)
        self.assertAlmostEqual(last["t"] - first["end"], 1.0, delta=0.05, msg="the dwell of the axis")
        self.assertAlmostEqual(cut["end"] - cut["t"], 4.0, delta=0.1)

    def test_the_programs_run_in_the_order_of_their_codes_and_the_end_waits(self):
        done = self.run_it("O1\nG98\nG101\nG01 B10. F600\nG100\nG102\nG01 B0. F600\nG100\nM81\nM82\nM81\nM30\n", B_AXIS)
        self.assertEqual(done.status, 0, done.said())
        moves = [m for m in done.of("move")]
        self.assertEqual([m["pos"]["B"] for m in moves], [10, 0, 10])
        for before, behind in zip(moves, moves[1:]):
            self.assertGreaterEqual(behind["t"], before["end"])
        self.assertGreaterEqual(done.of("stop")[0]["t"], moves[-1]["end"] - 1e-6)

    def test_a_move_of_the_path_waits_for_it(self):
        done = self.run_it("O1\nG98\nG101\nG01 B10. F600\nG04 X2.\nG100\nM81\nG00 B3.\nM30\n", B_AXIS)
        self.assertEqual(done.status, 0, done.said())
        [own], [path] = done.of("move", line=7), done.of("move", line=8)
        self.assertGreaterEqual(path["t"], own["end"] + 2.0 - 1e-6)

    def test_a_feed_hold_stops_it_too(self):
        scenario = '[[at]]\nt = 1.0\npress = "feed_hold L1"\n[[at]]\nt = 2.0\npress = "cycle_start L1"\n'
        done = self.run_it("O1\nG98\nG101\nG01 B20. F600\nG100\nM81\nG01 Z-40. F600\nM30\n", B_AXIS, scenario)
        self.assertEqual(done.status, 0, done.said())
        [own] = done.of("move", line=6)
        self.assertAlmostEqual(own["end"] - own["t"], 3.0, delta=0.1)

    def test_a_feed_per_revolution_of_a_spindle_that_stands_is_an_alarm(self):
        done = self.run_it("O1\nG98\nG101\nG99 G01 B20. F.5\nG100\nM81\nM30\n", B_AXIS)
        self.assertEqual(done.status, 1, done.said())
        self.assertEqual([a["number"] for a in done.of("alarm")], ["PT0520"], done.said())


def pulse(*moments):
    return "".join(f'[[at]]\nt = {t}\nset = "UINT L1={value}"\n' for t, value in moments)


class Interrupt(Run):
    def test_type_two_its_macro_statements_act_at_once_and_the_others_behind_the_block(self):
        self.write("O8300.nc", "O8300\n#120=#120+1\n#121=#5042\n#122=#5002\n#1100=1\nG00 U2.\n#123=#5042\n#1100=0\nM99\n")
        done = self.run_it(MAIN, ["F6003#2=1"], pulse((2.0, 1), (2.3, 0)), ["CN_UOUT L1"])
        self.assertEqual(done.status, 0, done.said())
        value = {e["name"]: e for e in done.of("variable")}
        self.assertEqual(value["#120"]["value"], 1)
        self.assertAlmostEqual(value["#121"]["value"], -20.0, delta=0.5, msg="read where the signal came")
        self.assertAlmostEqual(value["#122"]["value"], -40.0, places=3, msg="the end of the interrupted block")
        self.assertAlmostEqual(value["#121"]["t"], 2.0, delta=0.1)
        self.assertAlmostEqual(value["#123"]["value"], -40.0, delta=0.01)
        output = done.of("flag", name="CN_UOUT L1")
        self.assertEqual([e["value"] for e in output], [1, 0], done.said())
        self.assertAlmostEqual(output[0]["t"], 2.0, delta=0.1, msg="the output is on while the block is still cut")
        [cut] = done.of("move", n=10)
        self.assertAlmostEqual(cut["end"] - cut["t"], 4.0, delta=0.1)
        [off] = [m for m in done.of("move", kind="rapid")]
        self.assertGreaterEqual(off["t"], cut["end"])
        self.assertAlmostEqual(off["pos"]["Z"], -40.0, places=3)
        [back] = done.of("move", n=20)
        self.assertEqual((back["kind"], back["pos"]["X"]), ("linear", 52))

    def test_type_two_with_macro_statements_only(self):
        self.write("O8300.nc", "O8300\n#120=#120+1\n#121=#5042\nM99\n")
        done = self.run_it(MAIN, ["F6003#2=1"], pulse((2.0, 1), (2.3, 0)))
        self.assertEqual(done.status, 0, done.said())
        value = {e["name"]: e for e in done.of("variable")}
        self.assertAlmostEqual(value["#121"]["value"], -20.0, delta=0.5)
        self.assertEqual(value["#120"]["value"], 1)
        self.assertEqual([m["n"] for m in done.of("move")], [10, 20, 30])

    def test_type_two_a_loop_that_waits_goes_on_behind_the_block(self):
        self.write("O8300.nc", "O8300\nWHILE[#5042GT-39.]DO1\nEND1\n#121=#5042\nM99\n")
        done = self.run_it(MAIN, ["F6003#2=1"], pulse((2.0, 1), (2.3, 0)))
        self.assertEqual(done.status, 0, done.said())
        self.assertAlmostEqual([e for e in done.of("variable", name="#121")][-1]["value"], -40.0, delta=0.01)

    def test_type_two_more_statements_than_the_ring_has_room_for(self):
        self.write("O8300.nc", "O8300\n#121=0\nWHILE[#121LT1500]DO1\n#121=#121+1\n#1100=1-#1100\n#1132=#121\nEND1\nM99\n")
        done = self.run_it(MAIN, ["F6003#2=1"], pulse((2.0, 1), (2.3, 0)))
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(done.of("variable", name="#121")[-1]["value"], 1500)
        self.assertEqual([m["n"] for m in done.of("move")], [10, 20, 30])

    def test_type_two_behind_a_block_with_many_writes(self):
        self.write("O8300.nc", "O8300\n#121=#5042\nM99\n")
        many = "#130=0\nWHILE[#130LT400]DO1\n#130=#130+1\nEND1\n"
        done = self.run_it(MAIN.replace("N20", many + "N20"), ["F6003#2=1"], pulse((2.0, 1), (2.3, 0)))
        self.assertEqual(done.status, 0, done.said())
        self.assertAlmostEqual(done.of("variable", name="#121")[-1]["value"], -20.0, delta=0.5)
        self.assertEqual(done.of("variable", name="#130")[-1]["value"], 400)
        self.assertEqual([m["n"] for m in done.of("move")], [10, 20, 30])

    def test_type_two_begins_behind_the_last_motion_of_a_cycle_and_each_of_its_moves_is_told(self):
        self.write("O8300.nc", "O8300\n#120=#120+1\nN77 G00 W-5.\nM99\n")
        done = self.run_it("O1\nG98\n#120=0\nM96 P8300\nN10 G90 X40. Z-20. F600\nM97\nM30\n", ["F6003#2=1"], pulse((1.5, 1), (1.8, 0)))
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([(m["n"], m["pos"]["X"], m["pos"]["Z"]) for m in done.of("move")], [(10, 40, 0), (10, 40, -20), (10, 50, -20), (10, 50, 0), (77, 50, -5)])
        self.assertAlmostEqual(done.of("variable", name="#120")[-1]["t"], 1.5, delta=0.1, msg="at once")
        done = self.run_it("O1\nG98\n#120=0\nM96 P8300\nN10 G28 U-20. W-30.\nM97\nM30\n", ["F6003#2=1"], pulse((0.05, 1), (0.35, 0)))
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([(m["n"], m["pos"]["X"], m["pos"]["Z"]) for m in done.of("move")], [(10, 30, -30), (10, 0, 0), (77, 0, -5)])

    def test_type_one_breaks_the_block_off_and_loses_its_rest(self):
        self.write("O8300.nc", "O8300\n#121=#5042\nG00 U2.\nM99\n")
        done = self.run_it(MAIN, ["F6003#2=0"], pulse((2.0, 1), (2.3, 0)))
        self.assertEqual(done.status, 0, done.said())
        [cut] = done.of("move", n=10)
        self.assertAlmostEqual(cut["end"], 2.0, delta=0.1)
        [back] = done.of("move", n=20)
        self.assertEqual((back["pos"]["X"], back["pos"]["Z"]), (52, -60))

    def test_type_one_without_nc_statements_resumes_the_rest_of_a_move_and_of_a_dwell(self):
        self.write("O8300.nc", "O8300\n#120=#120+1\nM99\n")
        done = self.run_it(MAIN, ["F6003#2=0"], pulse((2.0, 1), (2.3, 0)))
        first, rest = done.of("move", n=10)
        self.assertAlmostEqual(first["end"] - first["t"] + rest["end"] - rest["t"], 4.0, delta=0.1)
        done = self.run_it("O1\nG98\nM96 P8300\nN10 G4 X5.\nN20 G4 X1.\nM97\nM30\n", ["F6003#2=0"], pulse((2.0, 1), (2.3, 0)))
        self.assertEqual(done.status, 0, done.said())
        first, rest, other = done.of("dwell")
        self.assertAlmostEqual(first["end"] - first["t"], 2.0, delta=0.05)
        self.assertAlmostEqual(rest["end"] - rest["t"], 3.0, delta=0.05)
        self.assertAlmostEqual(other["end"] - other["t"], 1.0, delta=0.01)


HOLD = '[[at]]\nt = 1.0\npress = "feed_hold L1"\n[[at]]\nt = 3.0\npress = "cycle_start L1"\n'


class Signals(Run):
    def setUp(self):
        super().setUp()
        self.write("O8300.nc", "O8300\nM99\n")

    def told(self, done, name):
        return [(e["value"], round(e["t"], 1)) for e in done.of("flag", name=name)]

    def test_the_start_lamp_is_out_while_feed_hold_is_on(self):
        done = self.run_it("O1\nG98\nG01 Z-40. F600\nM30\n", scenario=HOLD, watch=["STL L1"])
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(self.told(done, "STL L1"), [(1, 0.0), (0, 1.0), (1, 3.0)], done.said())   # the run ends with the program

    def test_the_hour_timer_stands_while_feed_hold_is_on(self):   # fanuc_lathe 6.3.3: 4 s of cutting, 2 s of hold
        done = self.run_it("O1\nG98\n#3002=0\n#3001=0\nG01 Z-40. F600\n#101=#3001\n#100=#3002*3600\nM30\n", scenario=HOLD)
        self.assertEqual(done.status, 0, done.said())
        value = {e["name"]: e["value"] for e in done.of("variable")}
        self.assertAlmostEqual(value["#101"], 6000, delta=200, msg=done.said())
        self.assertAlmostEqual(value["#100"], value["#101"] / 1000 - 2.0, delta=0.1, msg=done.said())

    def test_it_stands_at_single_block_stops_and_runs_while_a_tool_is_changed(self):
        scenario = '[[at]]\nt = 0.0\npress = "single_block L1=on"\n' + "".join(f'[[at]]\nt = {t}\npress = "cycle_start L1"\n' for t in (2.0, 4.0))
        done = self.run_it("O1\n#3002=0\nT0303\nG04 X1.\n#100=#3002*3600\nM30\n", scenario=scenario, watch=["STL L1"])
        self.assertEqual(done.status, 0, done.said())
        lit, since = 0.0, None
        read = done.of("variable", name="#100")[0]
        for e in done.of("flag", name="STL L1"):
            if e["value"] and e["t"] < read["t"]:
                since = e["t"]
            elif since is not None:
                lit, since = lit + min(e["t"], read["t"]) - since, None
        self.assertAlmostEqual(read["value"], lit, delta=0.05, msg=done.said())
        self.assertGreater(lit, 1.0)
        self.assertLess(lit, read["t"] - 1.5, "it stood between the blocks")

    def test_distribution_ends_behind_the_move_and_is_silent_where_nobody_waits(self):
        done = self.run_it("O1\nG98\nG01 Z-10. F600 M5\nM30\n", watch=["DEN L1"])
        self.assertEqual(done.status, 0, done.said())
        [cut] = done.of("move")
        changes = done.of("flag", name="DEN L1")
        self.assertEqual([e["value"] for e in changes][:2], [1, 0], done.said())
        self.assertGreaterEqual(changes[0]["t"], cut["end"] - 1e-6, "not before the move of its block is over")
        done = self.run_it("O1\nG98\n#3003=2\nG01 Z-10. F600 M5\nG01 Z-20.\n#3003=0\nG04 X1.\nM9\nM30\n", watch=["DEN L1"])
        self.assertEqual(done.status, 0, done.said())
        [rest] = done.of("dwell")
        changes = done.of("flag", name="DEN L1")
        self.assertTrue(changes and changes[0]["t"] >= rest["end"] - 1e-6, "#3003=2: no signal for M5\n" + done.said())

    def test_nozagc_leaves_z_where_it_is(self):   # fanuc_lathe 10.5: real X = X / cos 30; Z follows by X tan 30 only without the signal
        tangent, cosine = 0.5773503, 0.8660254

        def run(scenario):
            done = self.run_it("O1\nG98\nG00 X60. Z1.\nG00 X50. Z0\nG04 X.2\nG01 X30. F600\nM0\nG01 X40.\nG04 X.2\nM30\n", ["F8200#0 L1=1", "F8210 L1=30"], scenario, trace=True)
            self.assertEqual(done.status, 0, done.said())
            moves = done.of("move")[1:]
            self.assertEqual([(m["pos"]["X"], round(m["pos"]["Z"], 4)) for m in moves], [(50, 0), (30, 0), (40, 0)], done.said())
            trace = read_trace(self.folder / "trace.csv")
            at = [next(i for i, t in enumerate(trace["t"]) if t >= m["end"] + 0.01) for m in moves]
            for i, x in zip(at, (25, 15, 20)):
                self.assertAlmostEqual(trace["A1.cmd"][i], x / cosine, places=3)
            return [trace["A2.cmd"][at[k + 1]] - trace["A2.cmd"][at[k]] for k in (0, 1)]

        off = run("")
        self.assertAlmostEqual(off[0], 10 * tangent, places=3)
        self.assertAlmostEqual(off[1], -5 * tangent, places=3)
        on = run('[[at]]\nt = 0.0\nset = "NOZAGC L1=1"\n')
        self.assertAlmostEqual(on[0], 0, places=3)
        self.assertAlmostEqual(on[1], 0, places=3)
        later = run('[[at]]\nwhen = { ev = "stop", reason = "M00" }\nset = "NOZAGC L1=1"\n')
        self.assertAlmostEqual(later[0], 10 * tangent, places=3)
        self.assertAlmostEqual(later[1], 0, places=3)


class Reset(Run):
    def test_a_reset_forgets_what_was_only_read_ahead(self):   # architecture 5.4; F6001#6 keeps #100 and on over a reset, F5003#6 the offset
        program = "G98\n#101=#110\n#110=1\nG4 X9.\n#110=5\nG4 X1.\nM30\n"
        done = self.run_it(program, ["F6001#6=1"], '[[at]]\nt = 2.0\npress = "reset L1"\n[[at]]\nt = 3.0\npress = "cycle_start L1"\n', [])
        self.assertEqual([e.get("value") for e in done.of("variable", name="#101")], [None, 1], done.said())

    def test_outputs_outlive_it_as_they_were_executed_and_a_timer_goes_on(self):
        # Behind N20 the program is read ahead: what it writes there has not happened when the reset comes (fanuc_lathe 6.3.1, 6.10).
        self.write("O8300.nc", "O8300\nM99\n")
        program = "O1\nG98\n#102=#3001\nIF[#1100EQ1]GOTO 10\n#3001=0\nN10 #100=#1100\n#101=#1133\n#1100=1\n#1133=-5\nN20 G01 X100. F600\n#1100=0\n#1133=7\nM30\n"
        done = self.run_it(program, [], '[[at]]\nt = 2.0\npress = "reset L1"\n[[at]]\nt = 3.0\npress = "cycle_start L1"\n', ["CN_UOUT L1"])
        self.assertEqual(done.status, 0, done.said())
        value = {e["name"]: e["value"] for e in done.of("variable")}
        self.assertEqual((value["#100"], value["#101"]), (1, -5), done.said())
        self.assertAlmostEqual(value["#102"], 3000, delta=20, msg="set to 0 by the first program")
        self.assertEqual([e["value"] for e in done.of("flag", name="CN_UOUT L1")], [1, 0], done.said())


class HeldProgram(Run):
    def test_a_code_that_is_void_again_has_not_turned_the_spindle(self):
        # The M3 of N50 is read ahead when the offset changes in the hold; read again, M301 of N30 finds the loop that M19 has closed.
        program = "O1\nN10 M19\nN20 G94 G1 Z-50. F600\nN30 M301\nN40 G1 Z-55.\nN50 S100 M3\nN60 G1 Z-60.\nN70 M30\n"
        scenario = '[[at]]\nt = 2.0\npress = "feed_hold L1"\n[[at]]\nt = 2.5\nset = "offset L1 1 wear Z=-0.4"\n[[at]]\nt = 3.0\npress = "cycle_start L1"\n'
        for held in ("", scenario):
            done = self.polyturn("run", "--virtual", "--language", "nct", "--set", "N0820 S1=301", "--set", "N0821=11", "--set", "N0822=30",
                                 "--scenario", self.write("scenario.toml", held), self.write("O0001.nc", program))
            self.assertEqual(done.alarms, [], done.said())


class PickedUpThread(LiveCase):
    """A part is clamped again: spindle and tool are put into its groove by hand, and the thread goes on in it."""

    def press(self, words):
        done = self.polyturn("press", "--instance", self.name, *words.split())
        self.assertEqual(done.status, 0, words + "\n" + done.said())

    def parameter(self, name):
        done = self.polyturn("params", "get", name, "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())
        return float(done.out.split()[-1])

    def test_a_thread_begins_where_it_meets_the_groove_that_was_taught(self):
        self.start("PT_LANGUAGE L1=fanuc")
        self.press("machine_on")
        self.press("reference all")
        self.press("mode L1=mdi")
        for block in ("G98 G97 S60 M3", "G0 Z-7.3", "M5"):
            self.press("mdi L1 " + block)
        self.press("cycle_start L1")     # one start takes what was entered, line by line
        self.wait_for(lambda: [line["state"] for line in json.loads(self.polyturn("status", "--json", "--instance", self.name).out)["channels"][0].get("mdi", [])] == ["done"] * 3, 20, "the three blocks")
        self.press("teach_thread L1")
        angle, at = self.parameter("PT_THREAD_ANGLE L1"), self.parameter("PT_THREAD_AT L1")
        self.assertEqual(self.parameter("PT_THREAD_PICKUP L1"), 1)
        program = self.write("O0001.nc", "O1\nG97 S300 M3\nG0 X50. Z5.\nG32 Z-30. F2.\nG0 X60.\nM30\n")
        done = self.polyturn("run", "--virtual", "--language", "fanuc", "--like", self.name, "--instance", self.name + "x", "--trace", self.folder / "trace.csv", program)
        self.assertEqual(done.status, 0, done.said())
        [thread] = done.of("move", kind="thread")
        trace = read_trace(self.folder / "trace.csv")
        met = [(z0, z1, a0, a1) for t, z0, z1, a0, a1 in zip(trace["t"], trace["A2.cmd"], trace["A2.cmd"][1:], trace["S1.angle"], trace["S1.angle"][1:])
               if thread["t"] <= t <= thread["end"] and z0 > at >= z1]
        self.assertEqual(len(met), 1, f"{at}: {done.said()}")
        z0, z1, a0, a1 = met[0]
        there = a0 + ((a1 - a0) % 360) * (z0 - at) / (z0 - z1)
        off = (there - angle + 180) % 360 - 180
        self.assertLess(abs(off), 3.0, f"taught {angle} at {at}, met at {there}")

    def test_a_dry_run_like_the_controller_takes_its_zeros_and_offsets_and_not_those_of_the_jobs_files(self):
        self.start()
        for words in (("zeros", "set", "1", "G54", "Z=-100"), ("offsets", "set", "1", "1", "geometry", "Z=7")):
            done = self.polyturn(*words, "--instance", self.name)
            self.assertEqual(done.status, 0, done.said())

        def shifts(*more):
            done = self.polyturn("run", "--virtual", SHAFT, "--like", self.name, "--instance", self.name + "x", *more)
            self.assertEqual(done.status, 0, done.said())
            return {round(e["machine"]["Z"] - e["pos"]["Z"], 3) for e in done.of("move", ch=1) if e.get("tool", {}).get("offset") == 1 and "Z" in e["pos"] and "Z" in e["machine"]}
        self.assertEqual(shifts(), {-93.0})                 # shaft.job.toml: -150, its setup: 31.5
        self.assertEqual(shifts("--setup", SHAFT.parent / "shaft.setup.toml"), {-68.5})   # said for this run


if __name__ == "__main__":
    unittest.main()
