#!/usr/bin/env python3
"""Dialogues of programs: fanuc's pattern data (fanuc_lathe 11) asked by a program, answered by scenario, command line, or not at all."""
import json
import os
import signal
import unittest

from polyturn_runner import Case, LiveCase


def codes(letters, text):
    """The words of G65 H9x: two characters a word."""
    text = text.ljust(2 * len(letters))
    return " ".join(f"{letter}{ord(text[2 * i]):03d}{ord(text[2 * i + 1]):03d}" for i, letter in enumerate(letters) if text[2 * i:2 * i + 2] != "  ")


def line(kind, text, number=None):
    letters = "PQRIJK" if number is None else "QRIJK"
    return f"G65 H{kind}" + (f" P{number}" if number is not None else "") + " " + codes(letters, text)


MENU = "\n".join(["O9500", line(90, "HOLE PATTERN"), line(91, "BOLT HOLE", 1), line(91, "GRID", 2), "M99", ""])
DATA = "\n".join(["O9502", line(92, "VAR: GRID"), line(93, "PITCH", 500), line(93, "COUNT", 501), line(94, "ONLY IN X"), "M99", ""])
MAIN = "O1\nM98 P9500\n#502=#500*2\n#503=#5900\nG4 X0.1\nM30\n"


def write_all(case):
    for name, text in (("O9500.nc", MENU), ("O9502.nc", DATA)):
        case.write(name, text)
    return case.write("O0001.nc", MAIN)


class InARun(Case):
    def test_the_program_waits_and_goes_on_with_the_answers(self):
        main = write_all(self)
        scenario = self.write("answers.toml", '[[at]]\nwhen = { ev = "stop", reason = "dialogue" }\npress = "answer L1 key=2"\n'
                                              '[[at]]\nt = 1.0\npress = "answer L1 #500=12.5 #501=3 key=1"\n')
        done = self.polyturn("run", "--virtual", "--variables", "--scenario", scenario, main)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(len(done.of("stop", reason="dialogue")), 2, done.said())
        written = {e["name"]: e["value"] for e in done.of("variable")}
        self.assertEqual(written.get("#5900"), 2, done.said())
        self.assertEqual((written.get("#500"), written.get("#501"), written.get("#502"), written.get("#503")), (12.5, 3, 25, 2), done.said())
        self.assertGreaterEqual(done.of("stop", reason="M30")[0]["t"], 1.0)

    def test_without_an_answer_it_stays_there(self):
        done = self.polyturn("run", "--virtual", write_all(self))
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue(done.of("stop", reason="dialogue"), done.said())
        self.assertFalse(done.of("stop", reason="M30"), done.said())

    def test_a_start_is_no_answer(self):
        scenario = self.write("start.toml", '[[at]]\nt = 0.5\npress = "cycle_start L1"\n[[at]]\nt = 1.0\npress = "answer L1 key=7"\n')
        done = self.polyturn("run", "--virtual", "--scenario", scenario, write_all(self))
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue(any("answer" in e["text"] or "not ready" in e["text"].lower() for e in done.alarms), done.said())
        self.assertFalse(done.of("stop", reason="M30"), done.said())   # there is no pattern 7 either: it is asked again

    def test_check_reads_the_texts_and_goes_on(self):
        done = self.polyturn("check", write_all(self))
        self.assertEqual(done.status, 0, done.said())
        self.assertIn("pattern 2: GRID", [e["text"] for e in done.of("message")])


class OnAController(LiveCase):
    def pages(self):
        done = self.polyturn("dialogue", "--json", "--instance", self.name)
        self.assertEqual(done.status, 0, done.said())
        return json.loads(done.out)

    def press(self, words, status=0):
        self.assertEqual(self.polyturn("press", "--instance", self.name, *words.split()).status, status, words)

    def state(self):
        return json.loads(self.polyturn("status", "--json", "--instance", self.name).out)["channels"][0]["state"]

    def begin(self):
        main = write_all(self)
        self.press("machine_on")
        self.press("reference all")
        self.press(f"select L1={main}")
        self.wait_for(lambda: self.polyturn("press", "--instance", self.name, "cycle_start", "L1").status == 0 and self.state() in ("running", "program_stop"), 30, "the program to start")
        self.wait_for(lambda: self.pages(), 10, "the menu")

    def test_the_terminal_shows_and_answers(self):
        self.start()
        self.assertEqual(self.pages(), [])
        self.begin()
        page = self.pages()[0]
        self.assertEqual((page["ch"], page["title"], [k["text"] for k in page["keys"]]), (1, "HOLE PATTERN", ["BOLT HOLE", "GRID"]))
        self.assertEqual(self.polyturn("dialogue", "--instance", self.name, "L1", "key=2").status, 0)
        self.wait_for(lambda: any(p["title"] == "VAR: GRID" for p in self.pages()), 10, "the data page")
        page = self.pages()[0]
        self.assertEqual([f["name"] for f in page["fields"]], ["PITCH", "COUNT"])
        self.assertEqual(page["notes"], ["ONLY IN X"])
        self.press("answer L1 #500=7.25")
        self.wait_for(lambda: self.pages()[0]["fields"][0]["value"] == 7.25, 5, "the value to be shown")
        self.assertIn("PITCH", self.polyturn("dialogue", "--instance", self.name).out)
        self.press("answer L1 key=1")
        self.wait_for(lambda: self.state() == "ended", 10, "the end")
        self.assertEqual(self.pages(), [])

    def test_the_menu_is_called_by_hand(self):
        self.start()
        main = write_all(self)
        self.press("machine_on")
        self.press("reference all")
        self.press(f"select L1={main}")
        self.press("mode L1=mdi")
        self.wait_for(lambda: (self.press("hand_key L1 M98 P9500"), self.pages())[1], 30, "the menu")   # subprograms beside the selected program
        self.press("answer L1 key=2")
        self.wait_for(lambda: any(p["title"] == "VAR: GRID" for p in self.pages()), 10, "the data page")
        self.press("answer L1 #500=3 #501=4 key=1")
        self.wait_for(lambda: self.state() == "ended", 10, "the end")
        self.press("mdi L1 #504=#5900*10+#500")
        self.press("cycle_start L1")
        self.wait_for(lambda: self.state() == "ended", 10, "the end of the block")

    def test_a_reset_or_a_kill_leaves_nothing(self):
        self.start()
        self.begin()
        self.press("reset L1")
        self.wait_for(lambda: self.state() == "reset", 10, "the reset")
        self.assertEqual(self.pages(), [])
        self.press("cycle_start L1")
        self.wait_for(lambda: self.pages(), 10, "the menu again")
        self.assertEqual(self.pages()[0]["title"], "HOLE PATTERN")
        channel = [p["pid"] for p in json.loads(self.polyturn("status", "--json", "--instance", self.name).out)["processes"] if p["name"].startswith("channel") and p["name"].endswith("1")]
        self.assertEqual(len(channel), 1)
        os.kill(channel[0], signal.SIGKILL)
        self.wait_for(lambda: self.pages() == [], 20, "the page of the dead program to go")


if __name__ == "__main__":
    unittest.main()
