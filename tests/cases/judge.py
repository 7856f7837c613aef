#!/usr/bin/env python3
"""Runs the acceptance cases and judges them against passing.txt: a case that has passed once must go on passing.

    judge.py --polyturn BIN --cases DIR [--result FILE] [--bless]     runs them, prints a table per folder
    judge.py --judge FILE                                             only judges what an earlier call has written

Without --cases and --judge the variables POLYTURN_CASES and POLYTURN_CASES_RESULT say where they are.
Exit status 1: a case listed in passing.txt fails or is gone; 77: there are no cases here. Cases that newly pass are named, so that they are added
(--bless). Blessing only adds: a case that passed before stays listed and fails the run until somebody takes it out by hand.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

PASSING = pathlib.Path(__file__).with_name("passing.txt")


def name_of(path, root):
    return str(path.relative_to(root)).removesuffix(".case.json")


def run(cases, polyturn):
    """{case name: None, or the first thing that does not hold}"""
    runner = cases / "run_cases.py"
    paths = sorted(cases.rglob("*.case.json"))

    def one(path):
        try:
            done = subprocess.run([sys.executable, str(runner), "--polyturn", str(polyturn), str(path)], capture_output=True, text=True, timeout=120)
        except subprocess.TimeoutExpired:
            return "no end within 120 s"
        if done.returncode == 0:
            return None
        lines = [line for line in done.stdout.splitlines() if line.startswith("FAIL ")]
        return lines[0].split(": ", 1)[-1] if lines else (done.stderr.strip().splitlines() or ["failed"])[-1]

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return {name_of(path, cases): fault for path, fault in zip(paths, pool.map(one, paths))}


def table(results):
    folders = {}
    for name, fault in results.items():
        good, all_ = folders.get(name.split("/")[0], (0, 0))
        folders[name.split("/")[0]] = (good + (fault is None), all_ + 1)
    width = max(map(len, folders), default=5)
    for folder, (good, all_) in sorted(folders.items()):
        print(f"  {folder:{width}}  {good:3} of {all_:3}")
    print(f"  {'all':{width}}  {sum(f is None for f in results.values()):3} of {len(results):3}")


def judge(results, bless):
    listed = [line for line in PASSING.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    lost = [name for name in listed if results.get(name) is not None]
    gone = [name for name in listed if name not in results]
    new = [name for name, fault in results.items() if fault is None and name not in listed]
    for name in lost:
        print(f"LOST {name}: {results[name]}")
    for name in gone:
        print(f"gone {name}: no such case any more")
    for name, fault in results.items():
        if fault is not None and name not in listed:
            print(f"open {name}: has never passed: {fault}")
    if bless:
        head = "# Acceptance cases that pass and must go on passing. packaging/test --bless-cases adds to this list.\n"
        keep = sorted(listed + new)
        PASSING.write_text(head + "".join(f"{name}\n" for name in keep), encoding="utf-8")
        print(f"{PASSING}: {len(keep)} cases, {len(new)} of them new")
    else:
        for name in new:
            print(f"new  {name}: passes; packaging/test --bless-cases writes it down")
    return 1 if lost or gone else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--polyturn", type=pathlib.Path)
    parser.add_argument("--cases", type=pathlib.Path)
    parser.add_argument("--result", type=pathlib.Path)
    parser.add_argument("--judge", type=pathlib.Path)
    parser.add_argument("--bless", action="store_true")
    options = parser.parse_args()
    if not options.cases:
        beside = pathlib.Path(__file__).resolve().parents[3] / "shared" / "cases"
        options.cases = pathlib.Path(os.environ.get("POLYTURN_CASES", beside))
        if not options.judge and os.environ.get("POLYTURN_CASES_RESULT"):
            options.judge = pathlib.Path(os.environ["POLYTURN_CASES_RESULT"])
    if options.judge:
        results = json.loads(options.judge.read_text(encoding="utf-8"))
        table(results)
        return judge(results, False)
    if not (options.cases / "run_cases.py").exists():
        print(f"no acceptance cases in {options.cases}")
        return 77
    results = run(options.cases, options.polyturn.resolve())
    if options.result:
        options.result.write_text(json.dumps(results, indent=1), encoding="utf-8")
    table(results)
    return judge(results, options.bless)


if __name__ == "__main__":
    sys.exit(main())
