#!/usr/bin/env python3
"""What a sinumerik program shows on the running machine only: inputs that change, reading that is held, what the next start finds."""
import unittest

from polyturn_runner import Case

HEAD = "G18 G71 G90 G94 G500 DIAMOF\n"


class SinumerikRun(Case):
    OUTER_TOOL = '[channel.1.tool.1]\nname = "ROUGH"\nedge.1 = { DP1 = 500, DP2 = 3 }\n'
    SIGNAL_BEHIND_M77 = "".join(f'[[at]]\nwhen = {{ ev = "aux", code = "M77" }}\nafter = {after}\nset = "INT1 L1={level}"\n' for after, level in ((2.0, 1), (2.2, 0)))

    def run_one(self, text, scenario, *options, status=0):
        program = self.write("PART.MPF", text)
        stimuli = self.write("scenario.toml", scenario)
        done = self.polyturn("run", "--virtual", "--variables", "--language", "sinumerik", "--set", "N1000=0", *options, "--scenario", stimuli, f"1={program}")
        self.assertEqual(done.status, status, done.said())
        return done

    def test_an_input_lets_the_program_go_on(self):   # part 3, 8: RDISABLE
        done = self.run_one(HEAD + "WHENEVER $A_IN[3]==0 DO RDISABLE\nG4 F1\nR1=$A_IN[3]\nG4 F0.5\nM30\n", '[[at]]\nt = 5.0\nset = "$A_IN[3] L1=1"\n')
        at = {e["seconds"]: e["t"] for e in done.of("dwell")}
        self.assertAlmostEqual(at[1], 5.0, delta=0.1, msg=done.said())
        self.assertAlmostEqual(at[0.5], 6.0, delta=0.1, msg=done.said())
        self.assertEqual([e["value"] for e in done.of("variable", name="R1")], [1])

    def test_a_loop_waits_for_an_input(self):
        for loop in ("LB: IF $A_IN[2]==0 GOTOB LB\n", "WHILE $A_IN[2]==0\nENDWHILE\n", "REPEAT\nUNTIL $A_IN[2]==1\n"):
            with self.subTest(loop):
                done = self.run_one(HEAD + loop + "G4 F1\nM30\n", '[[at]]\nt = 2.0\nset = "$A_IN[2] L1=1"\n')
                self.assertAlmostEqual(done.of("dwell")[0]["t"], 2.0, delta=0.1, msg=done.said())

    def test_a_loop_that_nobody_answers_ends_the_run(self):   # cli.md, section 5
        for loop in ("LB: IF $A_IN[2]==0 GOTOB LB\n", "WHILE $A_IN[2]==0\nENDWHILE\n", "REPEAT\nSTOPRE\nUNTIL $A_IN[2]==1\n"):
            with self.subTest(loop):
                done = self.run_one(HEAD + "G0 Z5\n" + loop + "M30\n", "", status=1)
                self.assertEqual([stop["reason"] for stop in done.of("stop")], ["waiting"], done.said())
        # Those that come to an end by themselves.
        done = self.run_one(HEAD + "R1=0\nWHILE ($A_IN[2]==0) AND (R1<2000)\nR1=R1+1\nENDWHILE\nM30\n", "")
        self.assertEqual([stop["reason"] for stop in done.of("stop")], ["M30"], done.said())

    def test_actions_go_on_while_reading_is_held(self):
        done = self.run_one(HEAD + "$AC_MARKER[1]=0\nID=1 EVERY $A_IN[1]==1 DO M8\nID=2 WHENEVER $A_IN[2]==0 DO RDISABLE\nG4 F1\nM30\n",
                            '[[at]]\nt = 1.0\nset = "$A_IN[1]=1"\n[[at]]\nt = 3.0\nset = "$A_IN[2]=1"\n')
        self.assertAlmostEqual(done.of("aux", code="M8")[0]["t"], 1.0, delta=0.1, msg=done.said())
        self.assertEqual(len(done.of("aux", code="M8")), 1)
        self.assertAlmostEqual(done.of("dwell")[0]["t"], 3.0, delta=0.1, msg=done.said())

    def test_outputs_reach_the_machine_and_stay(self):
        done = self.run_one(HEAD + "R1=R1+1\n$A_OUT[R1]=1\nG4 F1\nIF R1==2\n$A_OUT[1]=0\nENDIF\nM30\n", '[[at]]\nwhen = { ev = "stop", reason = "M30" }\nafter = 0.5\npress = "cycle_start"\n', "--watch", "CN_UOUT L1")
        self.assertEqual([e["value"] for e in done.of("flag", name="CN_UOUT L1")], [1, 3, 2], done.said())

    def test_the_next_start_finds_what_the_program_has_left(self):   # part 3, 2 and 11.5
        again = '[[at]]\nwhen = { ev = "stop", reason = "M30" }\nafter = 0.5\npress = "cycle_start"\n'
        text = HEAD.replace("G90 ", "") + "R1=$P_GG[14]\nR2=R2+1\nG91\nG4 F0.1\nM30\n"
        for mode, value in ((0, 1), (1, 2)):
            with self.subTest(mode):
                done = self.run_one(text, again, "--set", f"MD20152[13]={mode}")
                self.assertEqual([e["value"] for e in done.of("variable", name="R1")], [1, value], done.said())
                self.assertEqual([e["value"] for e in done.of("variable", name="R2")], [1, 2])
                self.assertEqual([e["count"] for e in done.of("part")], [1, 2])

    RESET_AND_START = '[[at]]\nt = 2.0\npress = "reset L1"\n[[at]]\nt = 3.0\npress = "cycle_start L1"\n'

    def test_a_reset_forgets_what_was_only_read_ahead(self):   # architecture 5.4: the first start is broken off in the dwell of 9 s
        text = HEAD + "R2=R1\n$A_OUT[3]=1\nIF R1==1 GOTOF LAST\nR1=1\nG4 F9\nR1=5\n$A_OUT[1]=1\nG4 F1\nM30\nLAST: $A_OUT[2]=1\nG4 F1\nM30\n"
        done = self.run_one(text, self.RESET_AND_START, "--watch", "CN_UOUT L1")
        self.assertEqual([e["value"] for e in done.of("variable", name="R2")], [0, 1], done.said())
        self.assertEqual([e["value"] for e in done.of("flag", name="CN_UOUT L1")], [4, 6], done.said())
        self.assertEqual([e["count"] for e in done.of("part")], [1])

    def test_a_reset_forgets_a_zero_that_was_only_read_ahead(self):   # MD20152: the zero outlives the program
        setup = self.write("setup.toml", "[channel.1.work.G54]\nZ = 10.0\n[channel.1.work.G55]\nZ = -30.0\n")
        done = self.run_one("G18 G90 G94 DIAMOF\nG0 Z0\nG54\nG1 Z5 F600\nG4 F9\nG55\nG1 Z-1\nM30\n", self.RESET_AND_START, "--set", "MD20152[7]=1", "--setup", setup)
        self.assertEqual([e["machine"]["Z"] for e in done.of("move", line=2)], [10], done.said())

    def test_a_flying_wait_brakes_only_where_somebody_is_missing(self):   # part 3, 7.14, rule 2; architecture 7
        for first, seconds in (("", 2.027), ("G4 F3\n", 3.0)):
            with self.subTest(first):
                one = self.write("ONE.MPF", "G18 G71 G90 G94 G500 DIAMOF G64\nN10 G1 Z40 F600\nWAITMC(1,1,2)\nN20 G1 Z30\nM30\n")
                two = self.write("TWO.MPF", first + "WAITMC(1,1,2)\nM30\n")
                setup = self.write("setup.toml", "[channel.1]\nmachine = { X = 100.0, Z = 50.0 }\n")
                done = self.polyturn("run", "--virtual", "--language", "sinumerik", "--setup", setup, f"1={one}", f"2={two}")
                self.assertEqual(done.status, 0, done.said())
                begin, behind = done.of("move", n=10)[0], done.of("move", n=20)[0]
                self.assertAlmostEqual(begin["t"], 0.0, delta=0.01)
                self.assertAlmostEqual(behind["t"], 1.013 if not first else seconds, delta=0.01, msg=done.said())
                self.assertAlmostEqual(behind["end"], seconds if not first else seconds + 1.026, delta=0.01)

    def test_an_interrupt_lifts_the_tool_before_its_routine(self):   # part 2, 10.10.4; part 3, 7.12 and 11.3
        self.write("UP.SPF", "R1=$AC_LIFTFAST R2=$AA_IM[X] R3=$AA_IM[Z]\nM17\n")
        setup = self.write("setup.toml", '[channel.1]\npos = { X = 60.0, Z = 40.0 }\n' + self.OUTER_TOOL)
        # Edge position 3: the tool lies in the direction X+ Z+ of its edge, the work opposite; N20 goes in Z-.
        for words, lifted, x, z in (("DILF=3", 1, 3, 0), ("DILF=3 ALF=3", 1, 0, -3), ("LFWP DILF=3 ALF=3", 1, 3, 0), ("LFWP DILF=3 ALF=1", 1, 0, 3), ("LFWP DILF=3 ALF=7", 1, -3, 0),
                                    ("LFPOS POLF[X]=50\nPOLFMASK(X)", 1, 30, 0), ("DISABLE(1)", None, 0, 0), ("ALF=0", 0, 0, 0)):
            with self.subTest(words):
                done = self.run_one(HEAD + f"SETINT(1) PRIO=1 UP LIFTFAST\n{words}\nT1 D1\nN10 G0 X20 Z30\nM77\nN20 G1 Z-30 F600\nN30 X40\nM30\n", self.SIGNAL_BEHIND_M77, "--setup", setup)
                self.assertEqual(done.of("move")[-1]["pos"]["X"], 40)
                value = {name: [e["value"] for e in done.of("variable", name=name)] for name in ("R1", "R2", "R3")}
                self.assertEqual(value["R1"], [] if lifted is None else [lifted], done.said())
                if lifted is None:
                    continue
                [cut] = [m for m in done.of("move", n=20)][:1]
                stands = 30 - 10 * (done.of("aux", code="M77")[0]["t"] + 2.0 - cut["t"])   # where the path is when the signal comes; it brakes a little behind
                self.assertAlmostEqual(value["R2"][0], 20 + x, places=3)
                self.assertAlmostEqual(value["R3"][0], stands + z, delta=1.0)

    def test_every_input_interrupts(self):   # part 3, 7.12: SETINT(n) hears $A_IN[n], and INT1 to INT4 as ever
        self.write("UP.SPF", "R1=R1+1 R3=$AA_IM[Z]\nM17\n")
        for n, signal in ((1, "INT1 L1"), (2, "$A_IN[2] L1"), (5, "$A_IN[5] L1"), (32, "$A_IN[32] L1")):
            with self.subTest(signal):
                scenario = "".join(f'[[at]]\nwhen = {{ ev = "aux", code = "M77" }}\nafter = {after}\nset = "{signal}={level}"\n' for after, level in ((2.0, 1), (2.2, 0)))
                done = self.run_one(HEAD + f"SETINT({n}) PRIO=1 UP\nN10 G0 Z30\nM77\nN20 G1 Z-30 F600\nM30\n", scenario)
                self.assertEqual([e["value"] for e in done.of("variable", name="R1")], [1], done.said())
                self.assertAlmostEqual(done.of("variable", name="R3")[0]["value"], 10, delta=1.0, msg=done.said())

    def lift_in_n40(self, tool, status=0):
        """N30 goes up a shoulder in X+, N40 turns behind it in Z-: the signal comes there, 5 s long."""
        self.write("UP.SPF", "R1=$AC_LIFTFAST R2=$AA_IM[X]\nM17\n")
        setup = self.write("setup.toml", '[channel.1]\npos = { X = 60.0, Z = 40.0 }\n' + tool)
        program = self.write("PART.MPF", HEAD + "SETINT(1) PRIO=1 UP LIFTFAST\nDILF=3\nT1 D1\nN10 G0 X20 Z30\nN20 G1 Z20 F6000\nN30 X40\nM77\nN40 Z-30 F600\nM30\n")
        scenario = self.write("scenario.toml", self.SIGNAL_BEHIND_M77)
        done = self.polyturn("run", "--virtual", "--variables", "--language", "sinumerik", "--set", "N1000=0", "--setup", setup, "--scenario", scenario, f"1={program}")
        self.assertEqual(done.status, status, done.said())
        return done

    def test_the_tool_lifts_to_the_side_on_which_it_is(self):   # part 2, 10.10.4: LFTXT, ALF=1, in the direction of the tool, whatever moved last
        for position, x in ((3, 43), (4, 43), (2, 37), (8, 43), (6, 37)):   # part 2, 11.1: where the edge lies seen from the nose
            with self.subTest(position):
                done = self.lift_in_n40(self.OUTER_TOOL.replace("DP2 = 3", f"DP2 = {position}"))
                self.assertEqual([e["value"] for e in done.of("variable", name="R1")], [1], done.said())
                [at] = [e["value"] for e in done.of("variable", name="R2")]
                self.assertAlmostEqual(at, x, places=3, msg=done.said())

    def test_a_lift_whose_side_the_edge_does_not_tell_is_refused(self):
        for position in (7, 9):
            with self.subTest(position):
                done = self.lift_in_n40(self.OUTER_TOOL.replace("DP2 = 3", f"DP2 = {position}"), status=1)
                self.assertIn("LIFTFAST LFTXT: $TC_DP2", done.said())
                self.assertEqual(done.of("variable", name="R1"), [])
                self.assertEqual({e["pos"]["X"] for e in done.of("move", n=40)}, {40})

    def test_speed_limits_outlast_the_program(self):   # part 1, 7.3, 7.5
        again = '[[at]]\nwhen = { ev = "stop", reason = "M30" }\nafter = 0.5\npress = "cycle_start"\n'
        text = HEAD + "R1=$SA_SPIND_MAX_VELO_G26[S1] R2=$SA_SPIND_MAX_VELO_LIMS[1] R3=$SA_SPIND_MIN_VELO_G25[S1]\n$SA_SPIND_MIN_VELO_G25[1]=40\nG26 S1500\nG96 S100 M3 LIMS=1200\nG4 F0.1\nM30\n"
        for redefined, kept in (("", 1200), ("REDEF $SA_SPIND_MAX_VELO_LIMS PRLOC\n", 0)):
            with self.subTest(redefined):
                done = self.run_one(redefined + text, again)
                self.assertEqual([e["value"] for e in done.of("variable", name="R1")], [0, 1500], done.said())
                self.assertEqual([e["value"] for e in done.of("variable", name="R2")], [0, kept], done.said())
                self.assertEqual([e["value"] for e in done.of("variable", name="R3")], [0, 40], done.said())

    def test_a_probe_is_passed(self):   # part 3, 5.3: MEAW measures without deleting the way
        setup = self.write("setup.toml", '[channel.1]\npos = { X = 20.0, Z = 0.0 }\nsensor = [{ input = "1", axis = "Z", at = -20.0, direction = "-" }]\n')
        done = self.run_one(HEAD + "N10 MEAW=1 G1 Z-50 F600\nR1=$AC_MEA[1] R2=$AA_MW[Z] R3=$AA_DELT[Z]\nN20 MEAS=1 Z-60\nN30 Z0\nM30\n", "", "--setup", setup)
        self.assertAlmostEqual(done.of("move", n=10)[0]["pos"]["Z"], -50, delta=1e-6, msg=done.said())
        self.assertAlmostEqual(done.of("move", n=10)[0]["end"], 5.0, delta=0.3)
        self.assertEqual([e["value"] for e in done.of("variable", name="R1")], [1])
        self.assertAlmostEqual(done.of("variable", name="R2")[0]["value"], -20, delta=0.01)
        self.assertEqual([e["value"] for e in done.of("variable", name="R3")], [0])

    def test_a_released_axis_comes_back_where_the_plc_has_left_it(self):   # part 3, 7.14: by its name (MD30552) as by GET
        drive = "".join(f'[[at]]\nt = {t}\nset = "{line}"\n' for t, line in ((1.0, "AP_PAXPOS A2=-20000"), (1.0, "AP_PAXFEED A2=3000"), (1.1, "AP_PAXR A2=1"), (3.5, "AP_PAXR A2=0")))
        for back, moves in (("GET(Z)\nN30 G1 Z=IC(-10) F500\n", "move"), ("N30 G1 Z=IC(-10) F500\n", "move"), ("N30 POS[Z]=IC(-10)\n", "beside"), ("WHEN TRUE DO POS[Z]=IC(-10)\nG4 F1\n", "beside")):
            with self.subTest(back):
                setup = self.write("setup.toml", "[channel.1]\npos = { X = 100.0, Z = 0.0 }\n")
                done = self.run_one(HEAD + "RELEASE(Z)\nG4 F4\n" + back + "N35 G0 X90\nM30\n", drive, "--set", "MD30552 A2=1", "--setup", setup)
                self.assertEqual(done.alarms, [], done.said())
                self.assertAlmostEqual(done.of("move", n=35)[0]["machine"]["Z"], -30, delta=1e-3, msg=done.said())
                if moves == "move":
                    self.assertAlmostEqual(done.of("move", n=30)[0]["pos"]["Z"], -30, delta=1e-3, msg=done.said())

    def test_speed_limits_hold_for_the_programs_that_follow(self):   # part 1, 7.3 and 7.5
        text = (HEAD + "IF R1==1 GOTOF TWO\nR1=1\nN20 G25 S300\nG26 S500\nLIMS=400\nG4 F0.5\nM30\n"
                "TWO: R2=$SA_SPIND_MIN_VELO_G25[S1] R3=$SA_SPIND_MAX_VELO_G26[S1] R4=$SA_SPIND_MAX_VELO_LIMS[S1]\nN50 S1000 M3\nG4 F0.5\nN60 S100\nG4 F0.5\nM30\n")
        done = self.run_one(text, '[[at]]\nwhen = { ev = "stop", reason = "M30" }\nafter = 0.5\npress = "cycle_start"\n')
        self.assertEqual(done.of("alarm"), [], done.said())
        self.assertEqual([done.of("variable", name=name)[-1]["value"] for name in ("R2", "R3", "R4")], [300, 500, 400], done.said())
        self.assertEqual([done.of("spindle", n=n)[-1]["value"] for n in (50, 60)], [500, 300], done.said())

    def test_surface_speed_keeps_to_the_lower_limit(self):   # part 1, 7.5: G25 S
        setup = self.write("setup.toml", "[channel.1]\npos = { X = 100.0, Z = 0.0 }\n")   # radius 100: G96 S30 would be 48 a minute
        done = self.run_one(HEAD + "G25 S200\nG96 S30 M3\nG4 F3\nN10 G1 Z-10 F0.5\nG25 S400\nG4 F3\nN20 Z0\nM30\n", "", "--setup", setup)
        for n, seconds in ((10, 6.0), (20, 3.0)):
            move = done.of("move", n=n)[0]
            self.assertAlmostEqual(move["end"] - move["t"], seconds, delta=0.3, msg=done.said())


if __name__ == "__main__":
    unittest.main()
