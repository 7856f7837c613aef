#!/usr/bin/env python3
"""Every channel is a process of its own, in virtual time too; each maps only its own segment writable."""
import os
import pathlib
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, Case
from process_tree import command_line, descendants


def writable_segments(pid):
    try:
        lines = pathlib.Path(f"/proc/{pid}/maps").read_text().splitlines()
    except OSError:
        return set()
    return {line.split()[5] for line in lines if "/dev/shm/polyturn." in line and "w" in line.split()[1]}


class Processes(Case):
    def observe(self, channels, settings):
        """{program name: [pids]} and {pid: writable segments} while a virtual run goes."""
        programs = [f"{c}={self.write(f'long{c}.nc', 'G4 U20000.' + chr(10) + 'M30' + chr(10))}" for c in range(1, channels + 1)]
        arguments = [POLYTURN, "run", "--virtual", "--quiet"] + [x for s in settings for x in ("--set", s)] + programs
        run = subprocess.Popen(list(map(str, arguments)), cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            deadline = time.monotonic() + 20
            while time.monotonic() < deadline:
                names = {}
                for pid in descendants(run.pid):
                    line = command_line(pid)
                    if line:
                        names.setdefault(os.path.basename(line[0]), []).append(pid)
                if len(names.get("polyturn-channel", [])) >= channels and "polyturn-kernel" in names and "polyturn-plc" in names:
                    time.sleep(0.3)  # everybody has attached
                    return run.poll(), names, {pid: writable_segments(pid) for pids in names.values() for pid in pids} | {run.pid: writable_segments(run.pid)}
                self.assertIsNone(run.poll(), run.stderr.read().decode() if run.poll() is not None else "")
                time.sleep(0.02)
            self.fail(f"processes seen: {names}")
        finally:
            run.kill()
            run.wait()
            run.stderr.close()

    def test_two_channels_are_two_processes_in_virtual_time(self):
        ended, names, segments = self.observe(2, [])
        self.assertIsNone(ended, "the run was too short to look at")
        self.assertEqual(len(names["polyturn-channel"]), 2, names)
        for name in ("polyturn-kernel", "polyturn-plc", "polyturn-toolmgmt"):
            self.assertEqual(len(names[name]), 1, names)
        owners = {}
        for pid, mapped in segments.items():
            for segment in mapped:
                owners.setdefault(segment, []).append(pid)
        self.assertGreaterEqual(len(owners), 6)
        for segment, pids in owners.items():
            self.assertEqual(len(pids), 1, f"{segment} is mapped writable by more than one process")
        for pid in names["polyturn-channel"] + names["polyturn-plc"]:
            self.assertEqual(len(segments[pid]), 1)

    def test_nothing_survives_the_supervisor(self):
        _, names, _ = self.observe(2, [])
        deadline = time.monotonic() + 5
        left = [pid for pids in names.values() for pid in pids]
        while left and time.monotonic() < deadline:
            left = [pid for pid in left if command_line(pid)]
            time.sleep(0.02)
        self.assertEqual(left, [])

    def test_a_finished_run_leaves_no_segment(self):
        program = self.write("short.nc", "G4 U0.1\nM30\n")
        self.polyturn("run", "--virtual", "--instance", "e2e-leaves-nothing", program)
        self.assertEqual([name for name in os.listdir("/dev/shm") if "e2e-leaves-nothing" in name], [])


if __name__ == "__main__":
    unittest.main()
