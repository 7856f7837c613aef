#!/usr/bin/env python3
"""Programs of the B axis (fanuc_lathe 10.4): they run beside the path, and survive power-off. Real processes, virtual time."""
import unittest

from polyturn_runner import Case, read_trace

B_AXIS = ["N0002 A7=1", "N0100 A7=66", "F8251=81", "F8252=82", "F8240=01000000"]
REGISTER = "G101\nG01 B40. F600\nG04 X1.\nG00 B10.\nG100\n"   # 40 mm at 10 mm/s, 1 s, back: a little over 5 s


class BAxis(Case):
    def run_it(self, program, sets=(), options=()):
        setup = self.write("setup.toml", "[channel.1]\npos = { X = 50.0, Z = 0.0 }\n")
        words = [word for one in [*B_AXIS, *sets] for word in ("--set", one)]
        return self.polyturn("run", "--virtual", "--language", "fanuc", "--setup", setup, *words, *options, "--trace", self.folder / "trace.csv", self.write("O0001.nc", program))

    def test_it_runs_while_the_path_goes_on(self):
        done = self.run_it("O1\nG98\n" + REGISTER + "M81\nN10 G01 Z-20. F600\nN20 G01 B0 F1200\nM30\n")
        self.assertEqual(done.status, 0, done.said())
        [cut] = done.of("move", n=10)
        out, back = [e for e in done.of("move") if e["line"] == 8 and "n" not in e]
        [dwell] = done.of("dwell")
        self.assertLess(cut["t"], 1.0, "the path does not wait for it")
        self.assertAlmostEqual(out["end"] - out["t"], 4.0, delta=0.2)
        self.assertAlmostEqual(dwell["t"], out["end"], delta=0.05)
        self.assertAlmostEqual(dwell["end"] - dwell["t"], 1.0, delta=0.01)
        self.assertGreaterEqual(back["t"], dwell["end"])
        [own] = done.of("move", n=20)
        self.assertGreaterEqual(own["t"] + 1e-9, back["end"], "a move of B by the path waits for its own program")
        trace = read_trace(self.folder / "trace.csv")
        self.assertAlmostEqual(max(trace["A7.cmd"]), 40.0, places=3)
        self.assertAlmostEqual(trace["A7.cmd"][-1], 0.0, places=3)

    def test_a_live_position_does_not_disturb_it(self):
        # #5021 is read while B is on its way; the incremental move behind its program begins where that ends.
        done = self.run_it("O1\nG94\n" + REGISTER + "M81\n#100=#5021\nG04 X1.\n#101=#5024\nN20 G91 G01 B5. F600\nM30\n", ["F3401=01000000"], ["--variables"])
        self.assertEqual(done.status, 0, done.said())
        self.assertAlmostEqual(read_trace(self.folder / "trace.csv")["A7.cmd"][-1], 15.0, places=3)
        value = {e["name"]: e["value"] for e in done.of("variable")}
        self.assertTrue(5 < value["#101"] < 15, value)

    def test_registered_programs_are_there_after_power_off(self):
        store = ("--store", self.folder / "store")
        done = self.run_it("O1\n" + REGISTER + "G102\nG110\nG100\nM30\n", options=store)
        self.assertEqual(len(done.alarms), 1, "the second one has a code that does not belong there")
        done = self.run_it("O1\nM82\nM30\n", options=store)
        self.assertEqual([e["number"] for e in done.alarms], [5039], "its error has left it unregistered")
        done = self.run_it("O1\nM81\nM30\n", options=store)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([(e["kind"], e["pos"]["B"]) for e in done.of("move")], [("linear", 40), ("rapid", 10)])

    def test_names_of_variables_too(self):
        store = ("--store", self.folder / "store", "--variables")
        self.assertEqual(self.run_it("O1\nSETVN 510[COUNT,SIZE]\n[#SIZE]=2.5\nM30\n", options=store).status, 0)
        done = self.run_it("O1\n[#COUNT]=[#SIZE]*2\nM30\n", options=store)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([(e["name"], e["value"]) for e in done.of("variable")], [("#510", 5)])

    def test_the_sixth_start_is_alarm_5038(self):
        done = self.run_it("O1\nG101\nG04 X40.\nG100\n" + "M81\n" * 6 + "M30\n")
        self.assertEqual([e["number"] for e in done.alarms], [5038], done.said())


    def test_the_plc_ends_it_alone(self):
        # AP_PAXRST at 1 s: B stands at about 10, the second program does not begin, the path goes on (10.4.6).
        scenario = self.write("reset_b.toml", '[[at]]\nt = 1.0\nset = "AP_PAXRST A7=1"\n[[at]]\nt = 1.5\nrelease = "AP_PAXRST A7"\n')
        program = "O1\nG98\n" + REGISTER + "M81\nM81\nN10 G01 Z-30. F600\nN20 M81\nG04 X0.5\nM30\n"
        done = self.run_it(program, options=("--scenario", scenario))
        self.assertEqual(done.status, 0, done.said())
        [cut] = done.of("move", n=10)
        self.assertAlmostEqual(cut["end"] - cut["t"], 3.0, delta=0.3)
        b = read_trace(self.folder / "trace.csv")
        stopped = [x for t, x in zip(b["t"], b["A7.cmd"]) if 1.6 < t < cut["end"] - 0.1]
        self.assertTrue(8 < stopped[0] < 13, stopped[:1])
        self.assertEqual(max(stopped), min(stopped), "nothing of it goes on")
        self.assertAlmostEqual(max(b["A7.cmd"]), 40.0, places=3, msg="the one that is started behind it runs")

    def test_the_plc_must_allow_it(self):
        scenario = self.write("no_b.toml", '[[at]]\nt = 0.0\nset = "AP_PAXENA A7=0"\n')
        done = self.run_it("O1\nG98\nG04 X0.5\n" + REGISTER + "M81\nM30\n", options=("--scenario", scenario))
        self.assertEqual([e["number"] for e in done.alarms], [5040], done.said())


class OneBAxisOfTwoChannels(Case):
    """F8250 = 3 (fanuc_lathe 10.4.5): both channels register and start programs of the same axis, and share its coordinate."""

    def run_both(self, first, second, *sets):
        self.write("O1.nc", first)
        self.write("O2.nc", second)
        job = self.write("both.job.toml", '[programs]\n1 = { file = "O1.nc", language = "fanuc" }\n2 = { file = "O2.nc", language = "fanuc" }\n')
        words = [word for one in ("N0002 A7=1", "N0100 A7=66", "F8250 L1=3", "F8250 L2=3", "F8251 L1=81", "F8251 L2=82", *sets) for word in ("--set", one)]
        return self.polyturn("run", job, "--virtual", *words, "--trace", self.folder / "trace.csv")

    def moves_of_b(self, done):
        return sorted((e for e in done.of("move") if "B" in e["pos"]), key=lambda e: e["t"])

    def test_the_second_waits_for_its_turn(self):
        done = self.run_both("O1\nG98\nG101\nG01 B40. F600\nG100\nM81\nM30\n", "O2\nG98\nG101\nG01 B10. F600\nG100\nG04 X0.5\nM82\nN10 G04 X1.\nM30\n", "F8240 L1=01000000", "F8240 L2=01000000")
        self.assertEqual(done.status, 0, done.said())
        out, back = self.moves_of_b(done)
        self.assertEqual([(out["ch"], out["pos"]["B"]), (back["ch"], back["pos"]["B"])], [(1, 40), (2, 10)])
        self.assertAlmostEqual(out["end"] - out["t"], 4.0, delta=0.2)
        self.assertGreaterEqual(back["t"] + 1e-9, out["end"])
        self.assertAlmostEqual(back["end"] - back["t"], 3.0, delta=0.2, msg="from where the other has left it")
        [dwell] = done.of("dwell", n=10)
        self.assertLess(dwell["t"], 1.5, "its path does not wait")
        b = read_trace(self.folder / "trace.csv")["A7.cmd"]
        self.assertAlmostEqual(max(b), 40.0, places=3)
        self.assertAlmostEqual(b[-1], 10.0, places=3)

    def test_an_incremental_program_goes_on_from_where_the_other_has_left_it(self):
        done = self.run_both("O1\nG98\nG101\nG01 B40. F600\nG100\nM81\nM30\n", "O2\nG98\nG101\nG01 B-5. F600\nG00 B-3.\nG100\nG04 X0.5\nM82\nM30\n")
        self.assertEqual(done.status, 0, done.said())
        b = read_trace(self.folder / "trace.csv")["A7.cmd"]
        self.assertAlmostEqual(max(b), 40.0, places=3)
        self.assertAlmostEqual(min(b), 0.0, places=3)
        self.assertAlmostEqual(b[-1], 32.0, places=3)

    def test_each_channel_has_its_own_programs_and_variables(self):
        done = self.run_both("O1\nG98\n#100=20\nG101\nG01 B#100 F600\nG100\nM81\nM30\n", "O2\nG98\n#100=7\nG101\nG01 B#100 F600\nG100\nG04 X5.\nM82\nM30\n", "F8240 L1=01000000", "F8240 L2=01000000")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([(e["ch"], e["pos"]["B"]) for e in self.moves_of_b(done)], [(1, 20), (2, 7)])

    def test_no_path_moves_it(self):
        for channel in (1, 2):
            with self.subTest(channel=channel):
                still, moves = "O1\nG04 X0.1\nM30\n", "O1\nG98\nN10 G01 B5. F600\nM30\n"
                done = self.run_both(*((moves, still) if channel == 1 else (still, moves)))
                self.assertEqual([(e["ch"], e["line"]) for e in done.alarms], [(channel, 3)], done.said())


if __name__ == "__main__":
    unittest.main()
