#!/usr/bin/env python3
"""Two turrets restart together: both stand at blocks that fit together, or neither does, and then nobody passes a wait through which the
other one never came. The shaft job with real processes, in virtual time and on a controller that stays."""
import json
import unittest

from polyturn_runner import SHAFT, Case, LiveCase, read_trace

START_ALL = '[[at]]\nt = 3.0\npress = "cycle_start"\n[[at]]\nt = 6.0\npress = "cycle_start"\n'
FIT = {1: "N170", 2: "N50"}          # both between M501 and M502
DO_NOT = {1: "N170", 2: "N100"}      # L2's lies behind N60 M502, L1's in front of N180 M502


class Virtual(Case):
    def restart(self, blocks, scenario="", *more):
        words = [word for channel, block in blocks.items() for word in ("--from", f"{channel}={block}")]
        if scenario:
            words += ["--scenario", self.write("keys.toml", scenario)]
        return self.polyturn("run", "--virtual", *words, "--trace", self.folder / "trace.csv", *more, SHAFT)

    def stands(self):
        trace = read_trace(self.folder / "trace.csv")
        moved = [name for name in trace if name.endswith(".cmd") and max(trace[name]) - min(trace[name]) > 1e-9]
        self.assertEqual(moved, [])

    def test_blocks_that_do_not_fit_move_nothing_whatever_is_pressed_then(self):
        done = self.restart(DO_NOT, START_ALL)
        self.assertEqual(done.of("wait", ch=1, code=502), [], "L1 has not met L2")
        self.stands()
        self.assertEqual(done.status, 1, done.said())
        numbers = [str(e["number"]) for e in done.alarms]
        self.assertIn("PT0542", numbers, done.said())
        self.assertEqual(numbers.count("PT0548"), 1, done.said())
        refused = next(e for e in done.alarms if str(e["number"]) == "PT0548")
        self.assertIn("L2", refused["text"])
        self.assertEqual(done.of("move"), [])

    def test_nor_without_a_key(self):
        done = self.restart(DO_NOT)
        self.assertEqual(done.status, 1, done.said())
        self.assertIn("PT0548", [str(e["number"]) for e in done.alarms], done.said())
        self.stands()

    def test_the_other_way_round(self):
        done = self.restart({1: "N250", 2: "N40"})
        self.assertEqual(done.status, 1, done.said())
        self.assertIn("PT0548", [str(e["number"]) for e in done.alarms], done.said())
        self.stands()

    def test_a_block_that_one_of_them_does_not_have(self):
        for blocks in ({1: "N170", 2: "N9999"}, {1: "N9999", 2: "N50"}):
            done = self.restart(blocks, START_ALL)
            self.assertEqual(done.status, 1, done.said())
            numbers = {str(e["number"]) for e in done.alarms}
            self.assertIn("PT0548", numbers, done.said())
            self.assertTrue(numbers & {"PT0541", "PT0542"}, done.said())   # its program's end, or before that a wait in front of which the other one stands
            self.stands()

    def test_a_start_of_one_of_them_while_the_other_searches_or_is_reset(self):
        done = self.restart(FIT, '[[at]]\nt = 2.0\npress = "reset L2"\n[[at]]\nt = 2.0\npress = "cycle_start L1"\n[[at]]\nt = 4.0\npress = "cycle_start"\n')
        self.assertEqual(done.status, 1, done.said())
        self.assertIn("PT0548", [str(e["number"]) for e in done.alarms], done.said())
        self.stands()

    def test_blocks_that_fit_go_on_to_the_end(self):
        done = self.restart(FIT)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([e["code"] for e in done.of("wait", ch=1)][-8:], [502, 503, 504, 505, 506, 507, 508, 509], done.said())
        first = {ch: done.of("move", ch=ch)[0]["n"] for ch in (1, 2)}
        self.assertEqual(first, {1: 170, 2: 50})
        begun = [e["t"] for e in done.of("stop", reason="restart")]
        self.assertGreaterEqual(min(e["t"] for e in done.of("move")), max(begun) + 1.0, "none begins before the last one is there")


class Real(LiveCase):
    def press(self, *words):
        done = self.polyturn("press", "--instance", self.name, *words)
        self.assertEqual(done.status, 0, done.said())

    def status(self):
        return json.loads(self.polyturn("status", "--json", "--instance", self.name).out)

    def states(self):
        return [c["state"] for c in self.status()["channels"]][:2]

    def axes(self):
        return [round(a["cmd"], 6) for a in self.status()["axes"]]

    def test_blocks_that_do_not_fit_move_nothing_whatever_is_pressed_then(self):
        self.start()
        self.press("machine_on")
        self.press("select", SHAFT)
        places = self.axes()
        self.press("restart", "L1=N170", "L2=N100")
        self.wait_for(lambda: "PT0548" in self.polyturn("alarms", "--instance", self.name).out, 20, "the restart to be refused")
        self.wait_for(lambda: self.states() == ["reset", "reset"], 10, "both to be in reset")
        for _ in range(3):
            self.press("cycle_start")
        self.wait_for(lambda: self.polyturn("alarms", "--instance", self.name).out.count("not all channels of the restart") >= 6, 10, "the starts to be refused")
        self.assertEqual(self.states(), ["reset", "reset"])
        self.assertEqual(self.axes(), places)
        self.press("restart", "L1=N170", "L2=N50")      # the right blocks, without another key between
        self.wait_for(lambda: [c["restart"] for c in self.status()["channels"]][:2] == ["at_block", "at_block"], 20, "both to be at their blocks")
        self.assertEqual(self.axes(), places)
        self.press("cycle_start")
        self.wait_for(lambda: self.axes() != places, 20, "the approach")
        self.assertEqual(self.stop(), 0)


if __name__ == "__main__":
    unittest.main()
