"""Starts the real programs for the end-to-end tests and reads what they say (cli.md, sections 3 and 4)."""
import dataclasses
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
POLYTURN = pathlib.Path(os.environ.get("POLYTURN", SOURCE / "build/test/bin/polyturn")).resolve()
SHAFT = SOURCE / "examples/jobs/shaft/shaft.job.toml"
BROKEN_SHAFT = SOURCE / "examples/jobs/shaft-broken/shaft-broken.job.toml"


@dataclasses.dataclass
class Done:
    status: int
    out: str
    err: str

    @property
    def events(self):
        return [json.loads(line) for line in self.out.splitlines() if line.startswith("{")]

    def of(self, ev, **parts):
        return [e for e in self.events if e.get("ev") == ev and all(e.get(k) == v for k, v in parts.items())]

    @property
    def alarms(self):
        return [e for e in self.of("alarm") if e.get("severity", "error") == "error"]

    def said(self):
        """Everything a person would read, for the message of a failed test."""
        return f"status {self.status}\n--- stdout (end)\n{self.out[-3000:]}\n--- stderr (end)\n{self.err[-3000:]}"


class Case(unittest.TestCase):
    """A test with a folder of its own to write programs into."""
    maxDiff = 4000

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def polyturn(self, *arguments, timeout=120):
        done = subprocess.run([POLYTURN, *map(str, arguments)], capture_output=True, cwd=self.folder, timeout=timeout, stdin=subprocess.DEVNULL)
        result = Done(done.returncode, done.stdout.decode("utf-8", "replace"), done.stderr.decode("utf-8", "replace"))
        self.assertGreaterEqual(result.status, 0, "died of a signal\n" + result.said())
        self.assertIn(result.status, (0, 1, 2), result.said())
        return result


class LiveCase(Case):
    """A test with a controller that stays. Its name is the test's own: one that was killed must not meet the next."""

    def setUp(self):
        super().setUp()
        self.name = f"e2e-{os.getpid()}-{self._testMethodName[5:25]}"
        self.running = None
        self.addCleanup(self.stop, signal.SIGKILL)
        self.addCleanup(lambda: self.polyturn("clean"))

    def start(self, *sets):
        log = open(self.folder / "start.log", "ab")
        self.addCleanup(log.close)
        # A computer that builds or tests something else beside it is late now and then: that is not what these tests are about.
        words = [word for one in ("PT_LATE_MAX=1000", *sets) for word in ("--set", one)]
        self.running = subprocess.Popen([POLYTURN, "start", "--instance", self.name, "--store", self.folder / "store", "--no-hmi", *words], cwd=self.folder,
                                        stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.wait_for(lambda: self.polyturn("status", "--instance", self.name).status == 0, 20, "the controller to start")

    def stop(self, how=signal.SIGTERM):
        if self.running and self.running.poll() is None:
            self.running.send_signal(how)
            self.running.wait(timeout=20)
        return self.running.returncode if self.running else None

    def wait_for(self, condition, seconds, what):
        deadline = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > deadline:
                self.fail(f"waited {seconds} s for {what}\n" + (self.folder / "start.log").read_text(errors="replace")[-3000:]
                          + self.polyturn("status", "--instance", self.name).said() + self.polyturn("alarms", "--instance", self.name).said())
            time.sleep(0.05)


def read_trace(path):
    """{column name: list of values}; the whole run must fit into memory."""
    with open(path, encoding="ascii") as file:
        names = file.readline().rstrip("\n").split(",")
        columns = [[] for _ in names]
        for line in file:
            for column, cell in zip(columns, line.rstrip("\n").split(",")):
                column.append(cell if cell == "" else float(cell))
    return dict(zip(names, columns))
