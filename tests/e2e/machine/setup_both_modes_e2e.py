#!/usr/bin/env python3
"""A setup means the same to `check` and to `run`: every case is interpreted and driven, and moves, functions and written values are
compared. And what the machine keeps: part counters over a SIGKILL, positions over a restart."""
import json
import os
import pathlib
import signal
import sqlite3
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, Case

MEASURE = ["F5002#0=0", "F5002#1=0", "F5002#4=0", "F5002#5=0", "F5002#6=0", "F5002#7=0", "F3405#3=0", "F6241=200", "F6251=15", "F6254=4"]

# name, language, set lines, setup, program, kinds of events to compare
CASES = [
    ("machine position", "fanuc", [], "[channel.1]\nmachine = { X = 123.0, Z = 45.0 }\n", "G0 U-10. W5.\nX50.\nM30\n"),
    ("pos with a zero", "fanuc", [], "[channel.1]\npos = { X = 80.0, Z = 5.0 }\nwork = { G54 = { Z = -150.0 }, shift = { X = 2.0 } }\n", "G0 U-10. W1.\nZ10.\nM30\n"),
    ("pos wins over machine", "nct", [], "[channel.1]\nmachine = { X = 1.0 }\npos = { X = 60.0 }\nwork = { G54 = { X = 10.0 } }\n", "G0 U2.\nM30\n"),
    ("offsets", "fanuc", ["F5002#4=1"], "[channel.1]\npos = { X = 100.0, Z = 0.0 }\n[channel.1.offset.3]\ngeometry = { X = -12.3, Z = 4.5, R = 0.8, T = 3 }\nwear = { X = 0.05, Z = -0.02, R = 0.0 }\n",
     "G98 F200\nG0 X50. Z5. T0303\nG42 G1 X20. Z0\nX30. Z-10.\nZ-20.\nG40 G0 X60.\n#101=#2003\nM30\n"),
    ("nct offsets", "nct", [], "[channel.1.offset.2]\ngeometry = { X = 10.0, Z = -4.0 }\nwear = { X = 0.2 }\n", "T202\nG94 G0 X50. Z5.\nG1 Z-5. F100\nM30\n"),
    ("variables", "fanuc", [], "[channel.1]\nvariables = { \"#100\" = 12.5, \"#500\" = 3.0, \"#1000\" = 1 }\n", "G0 X[#100+#500]\nIF[#1000 EQ 1]GOTO5\nX99.\nN5 Z7.\n#101=#1000\nM30\n"),
    ("keys", "fanuc", [], "[channel.1]\nkeys = { block_skip = [1, 3], optional_stop = true }\n", "G0 X50.\n/X60.\n/2 X70.\n/3 X80.\nM01\nZ5.\nM30\n"),
    ("subprogram", "fanuc", [], "[channel.1]\nsubprograms = [\"O0200.nc\"]\n", "G0 X50.\nM98 P200\nZ9.\nM30\n"),
    ("clock", "fanuc", [], "clock = \"2026-01-31T12:34:56\"\n", "#101=#3011\nG0 X10.\nM30\n"),
    ("measuring", "fanuc", MEASURE, "[channel.1]\npos = { X = 140.0, Z = 30.0 }\n[channel.1.offset.3]\ngeometry = { X = 20.0 }\n[[channel.1.sensor]]\ninput = \"XAE\"\naxis = \"X\"\nat = 81.2\ndirection = \"-\"\n",
     "G98\nN10 G0 X130. Z30. T0303\nN20 G36 X60.\nN40 G0 X80. Z40. T0303\nM30\n"),
    ("skip", "fanuc", ["F5002#4=1"], "[channel.1]\npos = { X = 100.0, Z = 50.0 }\n[[channel.1.sensor]]\ninput = \"SKIP\"\naxis = \"Z\"\nat = 20.0\ndirection = \"-\"\n",
     "G98\nG31 Z0 F120\n#101=#5062\nG0 Z60.\nM30\n"),
    ("a radius by Fagor's format", "fagor", ["FG.DFORMAT X=0"], "[channel.1]\nmachine = { X = 123.0, Z = 45.0 }\n", "G00 G91 X-10 Z5\nG90 Z2\nM30\n"),
    ("a radius by Fagor's state", "fagor", ["FG.DIAM X=0"], "[channel.1]\nmachine = { X = 123.0, Z = 45.0 }\n", "G00 G91 X-10 Z5\nG90 Z2\nM30\n"),
    ("skip without a signal", "fanuc", [], "[channel.1]\npos = { X = 100.0, Z = 50.0 }\n", "G98\nG31 Z40. F300\n#101=#5062\nG0 Z60.\nM30\n"),
]
TOLERANCE = 0.003   # mm, of what a simulated encoder measured: one count of 4096 a turn, latched between two ticks


def close(a, b):
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(close(a[k], b[k]) for k in a)
    if isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return abs(a - b) <= TOLERANCE
    return a == b


def essence(events):
    keys = ("ev", "ch", "n", "kind", "pos", "machine", "feed", "code", "table", "number", "axis", "value", "name", "reason", "comp")
    # A skip move is told by `check` with the place where it stops, by `run`, which cannot know that yet, with its target.
    return [{k: e[k] for k in keys if k in e and not (e.get("kind") == "skip" and k in ("pos", "machine"))}
            for e in events if e["ev"] in ("move", "aux", "offset", "variable", "stop", "alarm")]


class SetupInBothModes(Case):
    def test_check_and_run_tell_the_same(self):
        self.write("O0200.nc", "O0200\nG0 X33.\nM99\n")
        for name, language, settings, setup, program in CASES:
            with self.subTest(name):
                arguments = [self.write("a.nc", program), "--language", language, "--setup", self.write("setup.toml", setup), "--variables"]
                for line in settings:
                    arguments += ["--set", line]
                checked, driven = self.polyturn("check", *arguments), self.polyturn("run", "--virtual", *arguments)
                self.assertEqual((checked.status, driven.status), (0, 0), checked.said() + driven.said())
                one, other = essence(checked.events), essence(driven.events)
                self.assertEqual(len(one), len(other), f"{json.dumps(one, indent=0)}\n{json.dumps(other, indent=0)}")
                for a, b in zip(one, other):
                    self.assertTrue(close(a, b), f"check {a}\nrun   {b}")

    def test_a_sensor_that_fits_no_machine_is_refused(self):
        for entry in ("input = \"XAE\"\naxis = \"Q\"\nat = 1.0\n", "input = \"NOSE\"\naxis = \"X\"\nat = 1.0\n", "input = 300\naxis = \"X\"\nat = 1.0\n"):
            with self.subTest(entry):
                done = self.polyturn("run", "--virtual", self.write("a.nc", "M30\n"), "--setup", self.write("s.toml", "[[channel.1.sensor]]\n" + entry))
                self.assertEqual(done.status, 2, done.said())
                self.assertTrue(done.alarms, done.said())


class WhatTheMachineKeeps(Case):
    def kept(self, store):
        base = sqlite3.connect(next(pathlib.Path(store).glob("*.sqlite")))
        counters = dict(base.execute("SELECT number, value FROM counters"))
        positions = [value for (value,) in base.execute("SELECT value FROM positions")]
        base.close()
        return counters, positions

    def test_parts_hours_and_positions_add_up_over_runs(self):
        program, store = self.write("a.nc", "G98\nG0 X50.\nG1 Z-10. F600\nM30\n"), self.folder / "store"
        cutting = 0
        for parts in (1, 2, 3):
            done = self.polyturn("run", "--virtual", program, "--store", store)
            self.assertEqual(done.status, 0, done.said())
            counters, positions = self.kept(store)
            self.assertEqual((counters[0], counters[1]), (parts, parts))
            self.assertGreaterEqual(counters[3], cutting)   # the second run finds the axis where the first one left it
            cutting = counters[3]
            self.assertTrue(any(abs(p - 25) < 1e-6 for p in positions) and any(abs(p + 10) < 1e-6 for p in positions), positions)

    def test_parts_survive_a_kill_of_every_process(self):
        program, store = self.write("a.nc", "N1 G4 U0.02\nM30\n"), self.folder / "store"
        process = subprocess.Popen([POLYTURN, "run", "--virtual", program, "--parts", "100000", "--store", store], stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, cwd=self.folder, start_new_session=True, text=True)
        seen = 0
        until = time.monotonic() + 3
        while time.monotonic() < until:
            line = process.stdout.readline()
            if '"ev":"part"' in line:
                seen += 1
        os.killpg(process.pid, signal.SIGKILL)
        process.stdout.close()
        process.wait()
        time.sleep(0.5)
        base = sqlite3.connect(next(pathlib.Path(store).glob("*.sqlite")))
        self.addCleanup(base.close)
        total = base.execute("SELECT value FROM counters WHERE number=0").fetchone()[0]
        self.assertGreater(total, 0)
        self.assertEqual(total, int(total))
        self.polyturn("clean")


if __name__ == "__main__":
    unittest.main()
