#!/usr/bin/env python3
"""Runs a benchmark for a moment and judges whether it measures anything: each one in it ends without an error, and there is at least one.

    run_bench.py PROGRAM [SECONDS]

Google Benchmark ends with 0 when a benchmark has given up (SkipWithError); here that is a fault. Figures are printed and not judged: those
in the documents come from a release build on an idle computer, each with its command.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile


def judged(status, report, out=""):
    """What is wrong, line by line."""
    faults = [] if status == 0 else [f"exit status {status}\n{out[-3000:]}"]
    rows = (report or {}).get("benchmarks", [])
    if not rows:
        faults.append("it has measured nothing")
    for row in rows:
        if row.get("error_occurred"):
            faults.append(f"{row['name']}: {row.get('error_message', 'gave up')}")
        elif not row.get("real_time", 0) > 0:
            faults.append(f"{row['name']}: took no time")
    return faults


def main():
    program, seconds = pathlib.Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "0.05"
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "result.json"
        done = subprocess.run([program, f"--benchmark_min_time={seconds}", f"--benchmark_out={path}", "--benchmark_out_format=json"],
                              capture_output=True, text=True, env=dict(os.environ, POLYTURN_BENCH_MOMENT="1"))
        try:
            report = json.loads(path.read_text(encoding="utf-8"))
        except (OSError, json.JSONDecodeError):
            report = None
    print(done.stdout)
    print(done.stderr, file=sys.stderr)
    faults = judged(done.returncode, report, done.stdout + done.stderr)
    for fault in faults:
        print(f"FAULT {program.name}: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
