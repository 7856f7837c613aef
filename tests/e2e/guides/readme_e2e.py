#!/usr/bin/env python3
"""A new user follows the README word by word: every command of its ten minutes, typed as it stands there, does what the text says, and a good
program is not warned of."""
import json
import os
import pathlib
import re
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, SOURCE, Case

README = (SOURCE / "README.md").read_text(encoding="utf-8")


def section(number):
    """The text of step `number`, and the lines of its code."""
    text = re.search(rf"\*\*{number}\. .*?(?=\n\*\*{number + 1}\. |\n## )", README, re.S).group(0)
    return text, [line[4:] for line in text.splitlines() if line.startswith("    ")]


def children(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return []


def command(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")[0].decode()
    except OSError:
        return ""   # it is gone


class TenMinutes(Case):
    def setUp(self):
        super().setUp()
        # As a clone looks to him: examples beside where he stands; the programs of this build in place of build/demo/bin.
        (self.folder / "examples").symlink_to(SOURCE / "examples")
        self.surroundings = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        self.surroundings |= {"PATH": f"{POLYTURN.parent}:{os.environ['PATH']}", "XDG_STATE_HOME": str(self.folder / "state"), "HOME": str(self.folder)}

    def type(self, line, timeout=120):
        return subprocess.run(["bash", "-c", line], cwd=self.folder, env=self.surroundings, capture_output=True, text=True, timeout=timeout)

    def write_the_two_programs(self):
        _, lines = section(1)
        width = lines[0].index("M500 P12")
        for name, cut in (("upper.nc", slice(0, width)), ("lower.nc", slice(width, None))):
            self.write(name, "".join(line[cut].strip() + "\n" for line in lines if line[cut].strip()))

    def good(self, line):
        done = self.type(line)
        self.assertEqual(done.returncode, 0, f"{line}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
        self.assertNotIn('"ev":"alarm"', done.stdout, line)
        self.assertNotIn("PT1015", done.stdout + done.stderr)
        return done

    def test_check_run_trace_disturb(self):
        self.write_the_two_programs()
        _, check = section(2)
        for line in check:
            self.good(line)
        whole = (self.folder / "lower.nc").read_text()
        self.write("lower.nc", whole.replace("M501 P12\n", ""))
        wrong = self.type(check[0])
        self.assertEqual(wrong.returncode, 1)
        alarm = next(json.loads(line) for line in wrong.stdout.splitlines() if '"ev":"alarm"' in line)
        self.assertTrue(alarm["file"] and alarm["line"] and alarm["remedy"], alarm)
        self.write("lower.nc", whole)
        for line in section(3)[1]:
            self.good(line)
        self.assertIn("<svg", (self.folder / "two.svg").read_text()[:500])
        traces = []
        for _ in range(2):
            self.good(section(4)[1][0])
            traces.append((self.folder / "trace.csv").read_bytes())
        self.assertEqual(traces[0], traces[1])
        killed = [self.type(line) for line in section(5)[1]][-1]
        self.assertIn("PT0500", killed.stdout, killed.stdout[-2000:])

    def test_a_controller_that_stays(self):
        text, lines = section(6)
        start, *typed = lines
        self.assertEqual(start, "polyturn start")
        name = f"readme-{os.getpid()}"   # two of these tests may run at once
        # Typed one after the other as fast as a person pastes them: none is too early.
        first = subprocess.Popen(["bash", "-c", f"exec {start} --instance {name}"], cwd=self.folder, env=self.surroundings, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(lambda: (first.kill(), first.wait(), first.stdout.close()))
        deadline = time.monotonic() + 30
        while self.type(f"polyturn status --instance {name}").returncode != 0:
            self.assertLess(time.monotonic(), deadline)
        for line in typed:
            done = self.type(f"{line} --instance {name}")
            self.assertEqual(done.returncode, 0, line + "\n" + done.stdout + done.stderr)
        state = lambda: json.loads(self.type(f"polyturn status --json --instance {name}").stdout)
        while not any(channel["state"] in ("running", "waits", "waiting") for channel in state()["channels"]):
            self.assertLess(time.monotonic(), deadline + 30, json.dumps(state())[:3000] + self.type(f"polyturn alarms --instance {name}").stdout)
        self.assertEqual(self.type(f"polyturn job diff examples/jobs/shaft/shaft.job.toml --instance {name}").returncode, 0, "zeros and offsets are the job's")
        alarms = self.type(f"polyturn alarms --instance {name}").stdout
        self.assertIn("No alarms", alarms)
        first.terminate()
        said, _ = first.communicate(timeout=30)
        self.assertEqual(first.returncode, 0, said)

    @unittest.skipUnless(os.environ.get("DISPLAY") and (POLYTURN.parent / "polyturn-hmi").exists(), "needs a display, and screens that were built")
    def test_where_there_is_a_display_start_opens_the_screens(self):
        text, (start, *_) = section(6)
        self.assertIn("where there is a display, it opens the screens too", " ".join(text.split()))
        name = f"readme-screens-{os.getpid()}"
        around = self.surroundings | {"DISPLAY": os.environ["DISPLAY"]}
        first = subprocess.Popen(["bash", "-c", f"exec {start} --instance {name}"], cwd=self.folder, env=around, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(lambda: (first.kill(), first.wait(), first.stdout.close()))
        screens = lambda: [pid for pid in children(first.pid) if "polyturn-hmi" in command(pid)]
        deadline = time.monotonic() + 60
        while not screens():
            self.assertLess(time.monotonic(), deadline, "no screens")
            self.assertIsNone(first.poll())
            time.sleep(0.1)
        time.sleep(5)   # long enough for them to fail at what they open
        opened = screens()
        self.assertEqual(len(opened), 1, "the screens stay")
        first.terminate()   # Ctrl-C ends the screens too
        said, _ = first.communicate(timeout=30)
        self.assertEqual(first.returncode, 0, said)
        self.assertNotIn("polyturn-hmi", command(opened[0]), said)


if __name__ == "__main__":
    unittest.main()
