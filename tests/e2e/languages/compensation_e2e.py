#!/usr/bin/env python3
"""Measured errors from their table to the drive: imported and checked, at the drive by the table's value, faded in and out, reported per
axis. The drive is one of ours (drive.so) that writes down where it has been told to be, so nothing of the kernel judges itself."""
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, SOURCE, Case, read_trace

MACHINES = SOURCE / "examples/machines"
LAYOUT = ("N2500 A2=1", "N2501 A2=10", "N2502 A2=10010", "N2503 A2=10000", "N2504 A2=10020")
GOOD = "".join(f"{10000 + i}={0.002 * (i - 10):.3f}\n" for i in range(21))   # 0.2 um for each millimetre, nothing at machine zero
FLAT = "".join(f"{10000 + i}=0.050\n" for i in range(21))


def sets(*lines):
    return [word for line in lines for word in ("--set", line)]


class MeasuredErrors(Case):
    def machine(self, table=None, lines=LAYOUT):
        folder = self.folder / "lathe"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(MACHINES / "twin-turret", folder)
        with open(folder / "machine.params", "a", encoding="utf-8") as file:
            file.write("\n" + "\n".join(lines) + "\n")
        if table is not None:
            (folder / "machine.compensation").write_text(table, encoding="ascii")
        return folder

    def recording_drive(self, machine):
        """The manual's smallest drive, and in each exchange its position goes into a file."""
        source = (SOURCE / "examples/drives/minimal_drive.c").read_text(encoding="utf-8")
        source = source.replace("#include <stdlib.h>", "#include <stdio.h>\n#include <stdlib.h>\nstatic FILE* record;")
        source = source.replace("    drive->state = next_state(", f'    if (!record) record = fopen("{self.folder / "drive.txt"}", "w");\n'
                                                                "    fprintf(record, \"%.6f\\n\", drive->position / drive->setup.increments_per_unit);\n    fflush(record);\n    drive->state = next_state(")
        path = self.write("recording.c", source)
        subprocess.run(["cc", "-shared", "-fPIC", "-I", SOURCE / "kernel/drives", path, "-o", machine / "drive.so"], check=True)

    def positions(self, machine, text, *more):
        """Where the drive of A2 was in each tick, and what everybody sees."""
        program = self.write("O1.nc", text)
        setup = self.write("s.toml", "[channel.1]\nmachine = { X = 200.0, Z = 0.0 }\n")
        self.recording_drive(machine)
        done = self.polyturn("run", "--virtual", "--machine", machine, "--language", "fanuc", "--setup", setup, "--trace", "trace.csv", *sets("PT_DRIVE A2=1", "PT_DRIVE_FREQ A2=1000"), *more, program)
        self.assertEqual(done.status, 0, done.said())
        drive = [float(line) for line in (self.folder / "drive.txt").read_text().split()]
        return drive, read_trace(self.folder / "trace.csv"), done

    def test_the_drive_goes_where_the_table_says_and_nobody_else_notices(self):
        text = "O1\nG98\nG1 Z30. F6000\nG4 X0.5\nZ-60.\nG4 X0.5\nZ-55.\nG4 X0.5\nM30\n"
        for table, shift in ((None, lambda z: 0.0), (GOOD, lambda z: 0.0002 * z)):
            drive, trace, done = self.positions(self.machine(table), text)
            ends = [e["t"] + e["seconds"] for e in done.of("dwell", ch=1)]
            self.assertEqual(len(ends), 3)
            for t, z in zip(ends, (30.0, -60.0, -55.0)):
                tick = round((t - trace["t"][0]) / 0.001) - 3
                self.assertAlmostEqual(trace["A2.cmd"][tick], z, places=6)
                self.assertAlmostEqual(trace["A2.act"][tick], z, delta=2e-4, msg="the machine shows its true position")
                self.assertTrue(any(abs(p - (z + shift(z))) < 2e-4 for p in drive[max(0, tick - 100):tick + 100]), f"the drive at {z}: {drive[tick]}")

    def test_it_comes_and_goes_within_the_limits(self):
        scenario = self.write("c.toml", '[[at]]\nt = 1.5\nset = "N2500 A2=0"\n[[at]]\nt = 3.0\nset = "N2500 A2=1"\n')
        drive, trace, _ = self.positions(self.machine(FLAT), "O1\nG98\nG4 X4.5\nM30\n", "--scenario", scenario)
        self.assertEqual(set(trace["A2.cmd"]), {0.0})
        for tick, where in ((1400, 0.05), (2900, 0.0), (4400, 0.05)):
            self.assertAlmostEqual(drive[tick], where, delta=2e-4)
        speeds = [(b - a) / 0.001 for a, b in zip(drive, drive[1:])]
        self.assertLess(max(map(abs, speeds)), 0.021 * 24000 / 60, "2 % of rapid")
        rises = [(b - a) / 0.001 for a, b in zip(speeds, speeds[1:])]
        self.assertLess(max(map(abs, rises)), 3000 * 0.1, "far below its acceleration; the loop's answer included")

    def test_a_table_is_imported_whole_or_not_at_all(self):
        machine = self.machine()
        kept = machine / "machine.compensation"

        def imported(text):
            return self.polyturn("params", "import", self.write("new.compensation", text), "--machine", machine)
        done = imported(GOOD)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(kept.read_text(), GOOD)
        gap = "".join(GOOD.splitlines(True)[:5] + GOOD.splitlines(True)[6:])
        for text, named in ((gap, "10005"), (GOOD + "10003=1\n", ":22"), (GOOD + "9000=1\n", ":22"), ("what\n", ":1")):
            with self.subTest(named=named):
                done = imported(text)
                self.assertEqual(done.status, 2, done.said())
                self.assertIn("PT0696", done.out + done.err)
                self.assertIn(named, done.out + done.err)
                self.assertEqual(kept.read_text(), GOOD, "what was there stays")
        kept.write_text(gap)   # somebody has edited it by hand: a good one replaces it
        self.assertEqual(imported(GOOD).status, 0)
        done = self.polyturn("params", "import", self.write("new.compensation", GOOD), "--instance", "nobody")
        self.assertEqual(done.status, 2, done.said())

    def test_the_parameter_check_looks_at_the_table(self):
        for table, lines, status, named in ((GOOD, LAYOUT, 0, ""), (GOOD, LAYOUT + ("N2504 A2=10025",), 1, "10021"),
                                            ("".join(f"{10000 + i}={i}\n" for i in range(37)), ("N2500 A5=5", "N2501 A5=10", "N2502 A5=10000", "N2503 A5=10000", "N2504 A5=10036", "N2506 A5=360"), 1, "cyclic"),
                                            ("3D L1 0=0 0 0\n3D L1 1=0.001 0 0\n", ("N2700 L1=2", "N2703 L1=2", "N2706 L1=1", "N2709 L1=50"), 1, "machine zero")):
            with self.subTest(named=named):
                done = self.polyturn("params", "check", self.machine(table, lines))
                self.assertEqual(done.status, status, done.said())
                self.assertIn(named, done.out + done.err)

    def test_a_program_gives_points_their_value(self):
        name = f"cells-{os.getpid()}"
        machine = self.machine(FLAT)
        log = open(self.folder / "start.log", "ab")
        self.addCleanup(log.close)
        running = subprocess.Popen([POLYTURN, "start", machine, "--instance", name, "--store", self.folder / "store", "--no-hmi"], stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.addCleanup(lambda: self.polyturn("clean"))
        self.addCleanup(lambda: running.poll() is None and (running.send_signal(signal.SIGKILL), running.wait()))

        def until(condition, what):
            deadline = time.monotonic() + 20
            while not condition():
                self.assertLess(time.monotonic(), deadline, what + "\n" + (self.folder / "start.log").read_text() + self.polyturn("alarms", "--instance", name).said())
                time.sleep(0.1)

        def compensation():
            done = self.polyturn("status", "--json", "--instance", name)
            return next((a["compensation"] for a in json.loads(done.out)["axes"] if a["axis"] == "A2"), None) if done.status == 0 else None
        until(lambda: compensation() is not None, "start")
        for words in ("machine_on", "reference all"):
            self.polyturn("press", "--instance", name, *words.split())
        until(lambda: abs(compensation() - 0.05) < 1e-6, "the table acts")
        program = self.write("cells.nc", "O1\nG10 L50\n" + "".join(f"N{10000 + i} R-20\n" for i in range(21)) + "G11\nM30\n")
        self.polyturn("press", "--instance", name, "mode", "L1=auto")
        self.polyturn("press", "--instance", name, "select", f"L1={program}")
        done = self.polyturn("press", "--instance", name, "cycle_start", "L1")
        self.assertEqual(done.status, 0, done.said())
        until(lambda: abs(compensation() + 0.02) < 1e-6, "what the program gave acts")
        self.assertIn("10007=-0.02\n", (machine / "machine.compensation").read_text())
        # What cannot be written is a message: the program has gone on long since.
        (machine / "machine.compensation").unlink()
        (machine / "machine.compensation").mkdir()
        until(lambda: self.polyturn("press", "--instance", name, "cycle_start", "L1").status == 0, "it runs again")
        until(lambda: "PT1624" in self.polyturn("alarms", "--instance", name).out, "the message")

    def test_a_running_controller_reports_it_per_axis(self):
        name = f"compensation-{os.getpid()}"
        machine = self.machine(FLAT)
        log = open(self.folder / "start.log", "ab")
        self.addCleanup(log.close)
        running = subprocess.Popen([POLYTURN, "start", machine, "--instance", name, "--store", self.folder / "store", "--no-hmi"], stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.addCleanup(lambda: self.polyturn("clean"))
        self.addCleanup(lambda: running.poll() is None and (running.send_signal(signal.SIGKILL), running.wait()))

        def axes():
            done = self.polyturn("status", "--json", "--instance", name)
            return {a["axis"]: a for a in json.loads(done.out)["axes"]} if done.status == 0 else {}

        def wait(condition):
            deadline = time.monotonic() + 20
            while time.monotonic() < deadline:
                if condition():
                    return True
                time.sleep(0.1)
            return False
        self.assertTrue(wait(lambda: axes()), (self.folder / "start.log").read_text())
        self.polyturn("press", "--instance", name, "machine_on")
        self.assertTrue(wait(lambda: abs(axes()["A2"]["compensation"] - 0.05) < 1e-6), axes().get("A2"))
        self.assertEqual(axes()["A1"]["compensation"], 0)
        done = self.polyturn("params", "set", "N2500 A2=0", "--instance", name)
        self.assertEqual(done.status, 0, done.said())
        self.assertTrue(wait(lambda: axes()["A2"]["compensation"] == 0), axes().get("A2"))
        # A table that is imported while the machine runs acts at once, fading in; one that has a gap changes nothing.
        self.assertEqual(self.polyturn("params", "set", "N2500 A2=1", "--instance", name).status, 0)
        self.assertTrue(wait(lambda: abs(axes()["A2"]["compensation"] - 0.05) < 1e-6), axes().get("A2"))
        other = self.write("other.compensation", FLAT.replace("0.05", "-0.02"))
        done = self.polyturn("params", "import", other, "--instance", name)
        self.assertEqual(done.status, 0, done.said())
        self.assertTrue(wait(lambda: abs(axes()["A2"]["compensation"] + 0.02) < 1e-6), axes().get("A2"))
        self.assertEqual(self.polyturn("params", "check", "--instance", name).status, 0)
        gap = "".join(FLAT.splitlines(True)[:-1])
        done = self.polyturn("params", "import", self.write("gap.compensation", gap), "--instance", name)
        self.assertEqual(done.status, 2, done.said())
        (machine / "machine.compensation").write_text(gap)   # by hand: the controller refuses it and keeps what it has
        self.assertTrue(wait(lambda: "PT0696" in self.polyturn("alarms", "--instance", name).out), self.polyturn("alarms", "--instance", name).said())
        self.assertAlmostEqual(axes()["A2"]["compensation"], -0.02, delta=1e-6)
        done = self.polyturn("params", "check", "--instance", name)
        self.assertEqual(done.status, 1, done.said())
        self.assertIn("PT0696", done.out + done.err)
        running.send_signal(signal.SIGTERM)
        running.wait(timeout=20)


if __name__ == "__main__":
    unittest.main()
