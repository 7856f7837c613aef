#!/usr/bin/env python3
"""Parameters of the machine's groups (nct_parameters_part1 6, 8, 9, 14) act in a run, each against the same run without it."""
import unittest

from polyturn_runner import SOURCE, Case, read_trace

SETUP = """
[channel.1]
machine = { X = 100.0, Z = 50.0 }
[channel.2]
machine = { X = 100.0, Z = 50.0 }
"""


class Parameters(Case):
    def run_nct(self, program, *sets, scenario="", options=(), status=0, trace=False, machine=None, setup=True):
        arguments = ["run", "--virtual", "--language", "nct"]
        if setup:
            arguments += ["--setup", self.write("setup.toml", SETUP)]
        for line in sets:
            arguments += ["--set", line]
        if machine:
            arguments += ["--machine", SOURCE / "examples/machines" / machine]
        if scenario:
            arguments += ["--scenario", self.write("scenario.toml", scenario)]
        if trace:
            arguments += ["--trace", self.folder / "trace.csv"]
        done = self.polyturn(*arguments, *options, f"1={self.write('O0001.nc', program)}")
        self.assertEqual(done.status, status, done.said())
        return done

    def trace(self):
        return read_trace(self.folder / "trace.csv")

    def codes(self, done):
        return [event["code"] for event in done.of("aux", ch=1)]


class Values(Parameters):
    def test_a_position_that_is_read_behind_a_move_is_its_end(self):
        done = self.run_nct("G94 G90 G1 Z20. F3000.\n#100=#5042\n#101=#5022\nG0 X60.\n#102=#5041\nM30\n", options=("--variables",))
        value = {e["name"]: e["value"] for e in done.of("variable")}
        self.assertEqual([value[f"#{n}"] for n in (100, 101, 102)], [20, 20, 60], "not what the loop still lags behind")

    def test_channels_of_a_check_see_the_offsets_they_share(self):
        first = self.write("O0001.nc", "G10 L10 P3 X10. Z4.\nG10 L10 P5 X10. Z4.\nM510 P12\nM30\n")
        second = self.write("O0002.nc", "M510 P12\nT0303\nG0 X20. Z1.\nT0505\nX21. Z1.\nM30\n")
        done = self.polyturn("check", "--language", "nct", "--set", "N1412=4", "--set", "N1414 L2=0", "--set", "N1413 L2=2", f"1={first}", f"2={second}")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([(m["machine"]["X"], m["machine"]["Z"]) for m in done.of("move", ch=2)], [(15, 5), (10.5, 1)])

    def test_mills_and_lathes_share_offsets_among_themselves(self):   # nct_parameters_part1 15.1: N1401 those that mill, N1412 those that turn
        first = self.write("O0001.nc", "O1\nG10 P1 X0.5 Z0.7\nM510 P12\nM30\n")
        second = self.write("O0002.nc", "O2\nM510 P12\n#100=#2001\nM30\n")
        values = {}
        for mode in ["check"], ["run", "--virtual"]:
            for kind in 0, 1:
                done = self.polyturn(*mode, "--language", "nct", "--variables", "--set", f"N0001 L2={kind}", "--set", "N1401=5", "--set", "N1412=5", f"1={first}", f"2={second}")
                self.assertEqual(done.status, 0, done.said())
                values[mode[0], kind] = [e["value"] for e in done.of("variable", ch=2) if e["name"] == "#100"]
        self.assertEqual(values, {("check", 0): [0.5], ("check", 1): [0], ("run", 0): [0.5], ("run", 1): [0]})


class Functions(Parameters):
    def test_m_codes_of_one_group_contradict_and_the_valid_one_is_shown(self):
        group = ("N1341 L1=51", "N1357 L1=53")
        done = self.run_nct("M51\nM52 M53\nM30\n", *group, status=1)
        self.assertIn("M52 and M53", str(done.alarms))
        self.run_nct("M51\nM52 M53\nM30\n")   # no group, no contradiction
        done = self.run_nct("M51\nG4 P0.1\nM53\nG4 P0.1\nM30\n", *group, options=("--watch", "CP_MGR1 L1"))
        self.assertEqual([e["value"] for e in done.of("flag", name="CP_MGR1 L1")], [51, 53])
        self.assertEqual(self.run_nct("M51\nM53\nM30\n", options=("--watch", "CP_MGR1 L1")).of("flag"), [])

    # What a restart at a block collects: 14.5, 14.7.
    RESTART = "M51\nM53\nT0101\nM6\nT0202\nM6\nT0303\nG100\nG90 G94 G0 X80. Z10.\nN50 G1 Z-5. F500.\nM30\n"

    def restarted(self, *sets):
        self.write("O9010.nc", "O9010\nM8\nM99\n")
        done = self.run_nct(self.RESTART, "N1704 L1=100", *sets, options=("--from", "1=N50"))
        return self.codes(done)

    def test_a_restart_keeps_the_last_code_of_a_group(self):
        both = self.restarted()
        self.assertIn("M51", both)
        self.assertIn("M53", both)
        one = self.restarted("N1341 L1=51", "N1357 L1=53")
        self.assertNotIn("M51", one)
        self.assertIn("M53", one)

    def test_a_restart_changes_tools_by_t_or_by_m6(self):
        tools = [c for c in self.restarted() if c[0] == "T"]
        self.assertEqual(tools, ["T0303"])
        self.assertEqual([c for c in self.restarted("N1338#0 L1=1") if c[0] == "T" or c == "M6"], ["T0202", "M6", "T0303"])

    def test_a_restart_looks_into_macros_that_codes_call_or_not(self):
        self.assertNotIn("M8", self.restarted())
        self.assertIn("M8", self.restarted("N1338#1 L1=1"))

    # Suppressed preparation (14.3): an offset that changes while the block before is executed counts behind the code, or not.
    CHANGES = """
[[at]]
t = 1.0
set = "offset L1 1 geometry X=-10"
"""

    def x_behind(self, code, *sets):
        program = f"G90 G94\nG0 X80. Z10.\nG4 P2.\n{code}\nT0101\nG0 X60.\nM30\n"
        done = self.run_nct(program, *sets, scenario=self.CHANGES)
        return done.of("move", ch=1)[-1]["machine"]["X"]

    def test_codes_that_suppress_preparation(self):
        early = self.x_behind("M77")
        self.assertAlmostEqual(early, 30.0)
        aux = "N1333 L1=66"
        for code, *sets in (("M77", "N1307 L1=77"), ("M77", "N1316 L1=77"), ("M77", "N1317 L1=70", "N1325 L1=79"), ("M77", "N1324 L1=77", "N1332 L1=77"),
                            ("S100", "N1336 L1=00000001"), ("T0202", "N1336 L1=00000010"), ("B5.", aux, "N1336 L1=00000100"),
                            ("B5.", "N1334 L1=66", "N1336 L1=00001000"), ("B5.", "N1335 L1=66", "N1336 L1=00010000")):
            with self.subTest(code=code, sets=sets):
                self.assertAlmostEqual(self.x_behind(code, *sets), 25.0)
                if code != "M77":
                    self.assertAlmostEqual(self.x_behind(code, *[s for s in sets if "N1336" not in s]), 30.0)

    # N1337 CBB: may the switch of a block skip sign still be changed while the block before runs?
    def test_a_block_skip_sign_stops_preparation_or_not(self):
        scenario = """
[[at]]
t = 1.0
press = "block_skip L1=1"
"""
        program = "G90 G94\nG0 X80. Z10.\nG4 P2.\n/G0 X60.\nG0 Z5.\nM30\n"
        skipped = self.run_nct(program, scenario=scenario)
        self.assertEqual(skipped.of("move", ch=1)[-1]["pos"]["X"], 80)
        read_before = self.run_nct(program, "N1337#4 L1=1", scenario=scenario)
        self.assertEqual(read_before.of("move", ch=1)[-1]["pos"]["X"], 60)

    # N1337 HEF: the feed of a helix counts in the plane of the arc, or along the path.
    def test_the_feed_of_a_helix(self):
        program = "G18 G90 G94\nG0 X40. Z0 Y0\nG2 X40. Z-40. I0 K-20. Y30. F600.\nM30\n"

        def seconds(*sets):
            arc = [e for e in self.run_nct(program, *sets, machine="twin-turret-y").of("move", ch=1) if e["kind"] in ("cw", "ccw")][0]
            return arc["end"] - arc["t"]
        flat, along = seconds(), seconds("N1337#3 L1=1")
        plane = 3.141592653589793 * 20.0
        self.assertAlmostEqual(flat, plane / 10.0, delta=0.3)
        self.assertAlmostEqual(along, (plane ** 2 + 30.0 ** 2) ** 0.5 / 10.0, delta=0.3)
        self.assertGreater(along, flat + 0.4)


class Motion(Parameters):
    # 6.4: a rapid move is overlapped by a block without movement too.
    def test_rapid_overlap_before_a_function(self):
        program = "G90\nG0 X100. Z-200.\nM8\nG0 Z-100.\nM30\n"

        def gap(*sets):
            done = self.run_nct(program, *sets)
            rapid = done.of("move", ch=1, kind="rapid")[0]
            return done.of("aux", ch=1, code="M8")[0]["t"] - rapid["t"], rapid["end"] - rapid["t"]
        stands, length = gap()
        self.assertGreaterEqual(stands, length - 1e-9, "without ROL the move is over first")
        overlapped, _ = gap("N0421#0 L1=1", "N0422 A1=60", "N0422 A2=60")
        self.assertLess(overlapped, stands - 0.01)
        less, _ = gap("N0421#0 L1=1", "N0422 A1=20", "N0422 A2=20")
        self.assertLess(overlapped, less)

    # 14.1 MBM: with the smallest look-ahead the path knows one block more than the one that runs.
    def test_short_blocks_are_slow_when_little_is_prepared(self):
        program = "G90 G94\nG0 Z0\n" + "".join(f"G1 Z-{k}. F6000.\n" for k in range(1, 41)) + "M30\n"
        much = self.run_nct(program, "N1301 L1=01000000").of("summary")[0]["seconds"]
        little = self.run_nct(program, "N1301 L1=00000000").of("summary")[0]["seconds"]
        self.assertGreater(little, much + 0.1)
        tool = "T0101\nG0 X60. Z5.\n"
        thread = self.run_nct("G90 G95\n" + tool + "S500 M3\nG4 P1.\nG33 Z-5. F1.\nG33 Z-9. F1.5\nG33 Z-12. F1.\nG0 X80.\nM30\n", "N1301 L1=00000001")
        self.assertEqual(len([e for e in thread.of("move", ch=1) if e["kind"] == "thread"]), 3)

    # 6.1 JRK: no steps of the jerk in what the drives are led to; nothing else of the path changes.
    def test_smoothed_jerk(self):
        program = "G90 G94\nG1 Z-40. F8000.\nZ50.\nM30\n"

        def roughness(*sets):
            done = self.run_nct(program, *sets, trace=True)
            z = self.trace()["A2.act"]
            self.assertAlmostEqual(z[-1], 50.0, delta=0.05)
            a = [z[i + 1] - 2 * z[i] + z[i - 1] for i in range(1, len(z) - 1)]
            mean = [sum(a[i:i + 4]) / 4 for i in range(len(a) - 4)]   # the encoder's last digit is no jerk
            jerk = [mean[i + 4] - mean[i] for i in range(len(mean) - 4)]
            return max(abs(jerk[i + 4] - jerk[i]) for i in range(len(jerk) - 4)), done.of("summary")[0]["seconds"]
        stepped, seconds = roughness("N0421#1 L1=0")
        smooth, same = roughness("N0421#1 L1=1")
        self.assertLess(smooth, 0.6 * stepped)
        self.assertAlmostEqual(seconds, same, delta=0.2)

    # 8.7: surface speed by another axis than X.
    def test_surface_speed_on_a_chosen_axis(self):
        program = "G90 G94\nG0 X100. Z40.\nG96 S100 M3\nG4 P3.\nG0 Z80.\nG4 P3.\nM5\nM30\n"

        def speeds(*sets):
            done = self.run_nct(program, "N0688 L1=0", *sets, trace=True)
            trace = self.trace()
            at = {e["line"]: e for e in done.of("dwell", ch=1)}
            return [trace["S1.speed"][int((at[line]["t"] + 2.9) * 1000)] for line in (4, 6)]
        rpm = lambda radius: 100_000.0 / (2 * 3.141592653589793 * radius)
        for got, wanted in zip(speeds(), (rpm(50), rpm(50))):
            self.assertAlmostEqual(got, wanted, delta=2)
        for got, wanted in zip(speeds("N0687 L1=2"), (rpm(40), rpm(80))):
            self.assertAlmostEqual(got, wanted, delta=2)


class Spindles(Parameters):
    # 9, N0817 to N0819.
    def test_a_spindle_is_positioned_by_an_address_of_up_to_three_characters(self):
        address = ("N0817 S1=65", "N0818 S1=77", "N0819 S1=50")   # AM2
        self.run_nct("M19\nAM2=90.\nG4 P0.2\nG91 AM2=45\nG4 P0.2\nM30\n", *address, trace=True)
        self.assertAlmostEqual(self.trace()["S1.angle"][-30], 135.0, delta=0.5)
        done = self.run_nct("M19\nAM90.\nG4 P0.2\nM30\n", *address[:2], trace=True)   # ends in a letter: no sign of equality needed
        self.assertAlmostEqual(self.trace()["S1.angle"][-30], 90.0, delta=0.5)
        self.assertEqual(self.run_nct("M19\nAM2=90.\nM30\n", status=1).alarms[0]["line"], 2)

    # 8.4, N0609 OSW: the switch reaches the spindle by the PLC's fast task, within ticks and not within cycles.
    def test_a_spindle_is_oriented_by_a_switch_that_the_fast_task_copies(self):
        setup = SETUP.replace("[channel.2]", '[[channel.1.sensor]]\ninput = 4\naxis = "S1"\nat = 123.0\n[channel.2]')

        def angle(*sets, status=0):
            arguments = ["run", "--virtual", "--language", "nct", "--setup", self.write("switch.toml", setup), "--trace", self.folder / "trace.csv"]
            for line in ("N0609#4 S1=1", "N0801 S1=200", *sets):
                arguments += ["--set", line]
            program = self.write("O0001.nc", "M19\nG4 P0.3\nM30\n")
            done = self.polyturn(*arguments, f"1={program}")
            self.assertEqual(done.status, status, done.said())
            return self.trace()["S1.angle"][-30]
        self.assertTrue(123.0 < angle("PT_IN_ORIENT S1=5") < 123.0 + 4 * 1.2, "a tick is 1.2 degrees, a PLC cycle 12")
        angle("PT_IN_ORIENT S1=6", status=1)   # nobody sees the switch: it does not come into position
        done = self.polyturn("run", "--virtual", "--setup", self.write("none.toml", setup.replace("S1", "S9")), self.write("O0002.nc", "M30\n"))
        self.assertEqual(done.status, 2, done.said())
        self.assertIn("S9", done.said())

    # 5, N0320 and N0328: in rapid, or at a feed that is held.
    def test_a_positioned_spindle_moves_in_rapid_or_at_its_feed(self):
        def seconds(motion, *sets):
            done = self.run_nct(f"G90 G94\nM19\n{motion}\nM8\nM30\n", "N0817 S1=65", "N0320 S1=100", *sets)
            position = [e for e in done.of("spindle", ch=1) if e["mode"] == "position"][-1]
            return done.of("aux", ch=1, code="M8")[0]["t"] - position["t"]
        rapid, feed, held = seconds("G0 A180."), seconds("G1 A180. F3600."), seconds("G1 A180. F3600.", "N0328 S1=5")
        self.assertLess(rapid, 1.0)
        self.assertAlmostEqual(feed, 3.0, delta=0.6)      # 10 turns a minute
        self.assertAlmostEqual(held, 6.0, delta=0.6)

    # 8.1, N0605 and N0606: S2=3200 means the spindle of that name, plain S that of N0604.
    def test_a_spindle_is_commanded_by_its_name(self):
        program = "S600 M3\nS2=300 M4\nG4 P1.\nM5\nS700\nG4 P1.\nM5\nM30\n"
        done = self.run_nct(program, trace=True, options=("--watch", "CN_SSEL L1"))
        told = [(e["spindle"], e["mode"], e.get("value"), e.get("direction")) for e in done.of("spindle", ch=1)]
        self.assertEqual(told[:2], [(1, "rpm", 600, "cw"), (2, "rpm", 300, "ccw")])
        self.assertEqual([t[:2] for t in told[2:]], [(2, "off"), (1, "rpm"), (1, "off")])
        trace = self.trace()
        at = {e["line"]: e["t"] for e in done.of("dwell", ch=1)}
        first, second = (int((at[line] + 0.95) * 1000) for line in (3, 6))
        self.assertAlmostEqual(trace["S1.speed"][first], 600, delta=3)
        self.assertAlmostEqual(abs(trace["S2.speed"][first]), 300, delta=3)
        self.assertAlmostEqual(trace["S1.speed"][second], 700, delta=3)
        self.assertAlmostEqual(trace["S2.speed"][second], 0, delta=1)
        self.assertEqual([e["value"] for e in done.of("flag", name="CN_SSEL L1")], [1, 2, 1], "none before the first S")
        self.run_nct("SB5=300\nM30\n", "N0605 S2=66", "N0606 S2=53")
        self.run_nct("SB5=300\nM30\n", status=1)


class Configuration(Parameters):
    # 1.3, 3.3: parameters are in the machine's unit; programs in their own.
    def test_a_machine_measured_in_inches(self):
        inch = ("N0104#0 L1=1", "N0304 A2=400", "N0305 A2=200", "N0400 A2=100", "N1002 A2=30", "N1003 A2=-30", "N0516 A2=0.0005")
        done = self.run_nct("G21 G90 G94\nG0 Z-203.2\nG20\nG1 Z-2. F100.\nM30\n", *inch)
        rapid, feed = done.of("move", ch=1)[:2]
        self.assertAlmostEqual(rapid["machine"]["Z"], -203.2, places=4)
        # 253.2 mm at 400 inch/min = 169.3 mm/s and 100 inch/s2 with its ramps
        self.assertAlmostEqual(rapid["end"] - rapid["t"], 253.2 / (400 * 25.4 / 60), delta=0.2)
        self.assertAlmostEqual(feed["machine"]["Z"], -50.8, places=4)
        self.assertAlmostEqual(feed["end"] - feed["t"], 6.0 / (100 / 60), delta=0.2)
        refused = self.run_nct("G20 G90\nG0 Z-31.\nM30\n", *inch, status=1)
        self.assertTrue(refused.alarms)

    # 3.4: the PLC inverts diameter and radius of an axis.
    def test_diameter_and_radius_by_the_plc(self):
        program = "G90\nG4 P0.2\nG0 X80.\nM30\n"
        scenario = '[[at]]\nt = 0.0\nset = "AP_DIARAD A1=1"\n'
        self.assertEqual(self.run_nct(program).of("move", ch=1)[-1]["machine"]["X"], 40)
        self.assertEqual(self.run_nct(program, scenario=scenario).of("move", ch=1)[-1]["machine"]["X"], 80)
        self.assertEqual(self.run_nct(program, "N0106#5 A1=1", scenario=scenario).of("move", ch=1)[-1]["machine"]["X"], 40)

    # 3.4: a hypothetical axis moves nothing until a drive is exchanged onto it; 2.1: one that is only measured has no name in programs.
    def test_axes_without_a_drive_of_their_own(self):
        hypothetical = ("N0002 A7=1", "N0100 A7=89", "N0106 A7=10000000")
        refused = self.run_nct("G90\nG0 Y5.\nM30\n", *hypothetical, status=1)
        self.assertEqual(refused.alarms[0]["line"], 2)
        measured = self.run_nct("G90\nG0 Y5.\nM30\n", "N0002 A7=99", "N0100 A7=89", status=1)
        self.assertEqual(measured.alarms[0]["line"], 2)

    # 3.1: names of three characters.
    def test_long_names(self):
        named = ("N0101 A1=77", "N0102 A1=65", "N0101 A2=50")   # XMA, Z2
        done = self.run_nct("G90\nG0 XMA60. Z2=10.\nM30\n", *named, setup=False)
        self.assertEqual(done.of("move", ch=1)[-1]["pos"], {"XMA": 60, "Z2": 10, "C": 0})
        self.run_nct("G90\nG0 Z210.\nM30\n", *named, status=1, setup=False)


class Plc(Parameters):
    # 13, N1274 NVF: where the turret stands is known again when the machine is started the next time.
    def test_what_the_plc_keeps_over_power_off(self):
        store = ("--store", self.folder / "kept", "--watch", "CP_ACTT L1")
        stations = lambda done: [e["value"] for e in done.of("flag", name="CP_ACTT L1")]
        self.assertEqual(stations(self.run_nct("T0303\nM30\n", options=store)), [2, 3])
        self.assertEqual(stations(self.run_nct("T0505\nM30\n", options=store)), [4, 5], "it stood at the third one")
        self.assertEqual(stations(self.run_nct("T0303\nM30\n", "N1274=00000001", options=store)), [2, 3], "and is at the first one again")


class EndOfAStrokeInCheck(Case):
    def test_the_alarm_names_the_subprogram_whose_move_leaves_the_stroke(self):   # nct_parameters_part1 11.4
        self.write("O0200.nc", "O200\nG1 Z-10. F500\nG1 Z-5000.\nG1 Z0\nM99\n")
        done = self.polyturn("check", "--language", "nct", "--set", "N1001 L1=0", self.write("a.nc", "G94 G0 X50. Z0.\nM98 P200\nM30\n"))
        self.assertEqual(done.status, 1, done.said())
        alarm, = done.of("alarm", number="PT0533")
        self.assertTrue(alarm["file"].endswith("O0200.nc"))
        self.assertEqual(alarm["line"], 3)
        self.assertIn("O0200.nc:3: alarm PT0533", done.said())
        self.assertEqual(done.of("move")[-1]["line"], 3, "nothing is driven behind it")


if __name__ == "__main__":
    unittest.main()
