#!/usr/bin/env python3
"""The demonstration's two jobs, as packaging/demo runs them."""
import subprocess
import sys
import unittest

from polyturn_runner import BROKEN_SHAFT, SHAFT, Case, read_trace


class DemoJob(Case):
    def test_runs_to_the_end_in_virtual_time(self):
        done = self.polyturn("run", "--virtual", SHAFT)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(done.alarms, [], done.said())
        summary = done.of("summary")[-1]
        self.assertGreater(summary["seconds"], 60.0)
        self.assertEqual([c["ch"] for c in summary["channels"]], [1, 2])
        for channel in summary["channels"]:
            self.assertGreater(channel["cutting"], 5.0)
            self.assertLessEqual(channel["cutting"] + channel["rapid"] + channel["waiting"], channel["seconds"] + 0.01)
        self.assertEqual(len(done.of("wait", ch=1)), 10)
        self.assertEqual(len(done.of("wait", ch=2)), 10)
        threads = [e for e in done.of("move", ch=2) if e["kind"] == "thread"]
        self.assertEqual(len(threads), 8)
        for thread in threads:
            self.assertAlmostEqual(thread["lead"], 1.5, places=6)

    def test_events_come_in_the_order_of_time(self):
        done = self.polyturn("run", "--virtual", SHAFT)
        keys = [(e["t"], e.get("ch", 0)) for e in done.events if "t" in e]
        self.assertEqual(keys, sorted(keys))
        for event in done.of("move"):
            self.assertGreaterEqual(event["end"], event["t"], event)

    def test_two_runs_are_identical_also_on_a_busy_computer(self):
        first = self.polyturn("run", "--virtual", SHAFT, "--trace", "first.csv", timeout=300)
        load = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(2)]
        try:
            second = self.polyturn("run", "--virtual", SHAFT, "--trace", "second.csv", timeout=600)
        finally:
            for process in load:
                process.kill()
                process.wait()
        self.assertEqual(first.status, 0, first.said())
        self.assertEqual(first.out, second.out)
        self.assertEqual((self.folder / "first.csv").read_bytes(), (self.folder / "second.csv").read_bytes())

    def test_the_thread_follows_the_spindle(self):
        done = self.polyturn("run", "--virtual", SHAFT, "--trace", "trace.csv")
        trace = read_trace(self.folder / "trace.csv")
        threads = [e for e in done.of("move", ch=2) if e["kind"] == "thread"]
        phases = []
        for thread in threads:  # spindle angle where Z crosses a plane in the part of constant pitch
            first, last = (next(i for i, t in enumerate(trace["t"]) if t >= thread[key]) for key in ("t", "end"))
            plane = (trace["A4.cmd"][first] + trace["A4.cmd"][last]) / 2
            i = next(k for k in range(first, last) if trace["A4.cmd"][k + 1] <= plane)
            z0, z1 = trace["A4.cmd"][i], trace["A4.cmd"][i + 1]
            turned = (trace["S1.angle"][i + 1] - trace["S1.angle"][i] + 540.0) % 360.0 - 180.0
            phases.append((trace["S1.angle"][i] + turned * (z0 - plane) / (z0 - z1)) % 360.0)
        for phase in phases:
            self.assertLess(abs((phase - phases[0] + 540.0) % 360.0 - 180.0), 0.04, phases)

    def test_crossed_waits_are_found_without_moving(self):
        done = self.polyturn("check", BROKEN_SHAFT)
        self.assertEqual(done.status, 1, done.said())
        self.assertTrue(done.alarms, done.said())
        said = " ".join(str(a) for a in done.alarms)
        for word in ("O1001", "O2001", "506", "507"):
            self.assertIn(word, said)

    def test_the_good_job_has_ten_meetings(self):
        done = self.polyturn("check", SHAFT)
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(done.of("sync"), [{"ev": "sync", "ok": True, "meetings": 10}])

    def test_draws_the_picture(self):
        done = self.polyturn("run", "--virtual", SHAFT, "--quiet", "--plot", "shaft.svg")
        self.assertEqual(done.status, 0, done.said())
        picture = (self.folder / "shaft.svg").read_text(encoding="utf-8")
        self.assertIn("<svg", picture)
        self.assertTrue(picture.rstrip().endswith("</svg>"))


if __name__ == "__main__":
    unittest.main()
