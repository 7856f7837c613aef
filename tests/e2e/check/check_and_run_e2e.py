#!/usr/bin/env python3
"""What `check` says of a job, a run of it shows: nothing of the shipped ones, and of mutated ones no fault and no warning that the run does
not bear out. CHECK_RUNS mutations (default 10), CHECK_SEED their first seed; a failure prints the seed."""
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
import tomllib
import unittest

from polyturn_runner import SOURCE, Case
from seeds import seeds

JOBS = sorted((SOURCE / "examples/jobs").glob("*/*.job.toml"))
BROKEN = "shaft-broken"   # shipped to show what a crossed wait looks like
RUNS, SEED = int(os.environ.get("CHECK_RUNS", "10")), int(os.environ.get("CHECK_SEED", "1"))


def told(done):
    """{number: severity} of all that was said of the programs."""
    return {str(event["number"]): event.get("severity", "error") for event in done.of("alarm")}


def mutate(lines, dice):
    """One slip of a programmer: (what, lines)."""
    at = dice.randrange(1, len(lines) - 1)
    kind = dice.choice(("deleted", "doubled", "swapped", "digit", "sign"))
    out = list(lines)
    if kind == "deleted":
        del out[at]
    elif kind == "doubled":
        out.insert(at, out[at])
    elif kind == "swapped":
        out[at], out[at - 1] = out[at - 1], out[at]
    elif kind == "digit":
        digits = [m.start() for m in re.finditer(r"\d", out[at])]
        if digits:
            place = dice.choice(digits)
            out[at] = out[at][:place] + str(dice.randrange(10)) + out[at][place + 1:]
    else:
        out[at] = out[at].replace("-", "", 1) if "-" in out[at] else re.sub(r"([XZUW])(\d)", r"\1-\2", out[at], count=1)
    return f"{kind} {at + 1}: {lines[at].strip()!r}", out


class CheckAndRun(Case):
    def test_the_shipped_jobs_are_good(self):
        for job in JOBS:
            with self.subTest(job.stem):
                done = self.polyturn("check", job, "--quiet")
                if job.parent.name == BROKEN:
                    self.assertEqual(done.status, 1, done.said())
                    continue
                self.assertEqual(done.status, 0, done.said())
                self.assertEqual({number: severity for number, severity in told(done).items() if severity != "message"}, {}, done.said())

    def test_what_check_says_of_a_mutated_job_a_run_shows(self):
        false = []
        tried = seeds("check_and_run_e2e", "CHECK_SEED", SEED, RUNS, 3)
        for seed in tried:
            dice = random.Random(seed)
            job = dice.choice([one for one in JOBS if one.parent.name != BROKEN])
            with tempfile.TemporaryDirectory() as scratch:
                copy = pathlib.Path(scratch) / "jobs" / job.parent.name
                shutil.copytree(job.parent, copy)
                (pathlib.Path(scratch) / "machines").symlink_to(SOURCE / "examples/machines")
                for shared in (SOURCE / "examples/jobs").iterdir():
                    if not (copy.parent / shared.name).exists():
                        (copy.parent / shared.name).symlink_to(shared)
                (pathlib.Path(scratch) / "programs").symlink_to(SOURCE / "examples/programs")
                programs = tomllib.loads(job.read_text(encoding="utf-8"))["programs"]
                channel, program = dice.choice(sorted((number, one["file"] if isinstance(one, dict) else one) for number, one in programs.items()))
                path = copy / program
                if not path.is_file() or path.is_symlink():
                    continue
                what, lines = mutate(path.read_text(encoding="utf-8", errors="replace").splitlines(), dice)
                path.write_text("\n".join(lines) + "\n", encoding="utf-8")
                checked = self.polyturn("check", copy / job.name, "--quiet", timeout=60)
                says = {number: severity for number, severity in told(checked).items() if severity != "message"}
                if not says and checked.status == 0:
                    continue
                try:
                    ran = self.polyturn("run", "--virtual", copy / job.name, "--quiet", timeout=300)
                except subprocess.TimeoutExpired:   # the others are judged all the same, and the seed repeats this one
                    false.append(f"seed {seed}, {job.stem} L{channel} {what}: check said {says}, the run has not ended in 300 s")
                    continue
                if ran.status == 0 and not set(says) <= set(told(ran)):
                    false.append(f"seed {seed}, {job.stem} L{channel} {what}: check said {says}, the run went well: {json.dumps(told(ran))}")
        self.assertEqual(false, [], f"{len(false)} of {len(tried)}\n" + "\n".join(false))


if __name__ == "__main__":
    unittest.main()
