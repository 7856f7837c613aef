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
        done = self.run_it("O1\nM82\nM81\nM30\n", options=store)
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


if __name__ == "__main__":
    unittest.main()
