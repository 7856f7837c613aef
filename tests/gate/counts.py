#!/usr/bin/env python3
"""How many test cases there are, program by program and module by module, against tests/counts.txt.

    counts.py --bin FOLDER [--without PROGRAM …]     fewer than written down, or none where some were: exit status 1
    counts.py --bin FOLDER --write                   writes them down (packaging/test --counts)

A count may only fall by a commit that changes the file. More than written down is named and is no fault.
Counted are: GoogleTest cases of the built programs, test functions of Python's modules, folders of golden programs by language, fuzzers,
benchmarks, acceptance cases that must pass.
"""
import argparse
import ast
import os
import pathlib
import re
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parents[1]
HEAD = "# Test cases of each suite: tests/gate/counts.py. Fewer fail the gate; packaging/test --counts writes the file, the commit says why.\n"


def gtest_cases(program):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen")
    done = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, env=environment, check=True)
    return sum(1 for line in done.stdout.splitlines() if line.startswith("  "))


def python_cases(text):
    """Test functions in classes, and what parses them is Python itself."""
    return sum(isinstance(part, ast.FunctionDef) and part.name.startswith("test")
               for one in ast.parse(text).body if isinstance(one, ast.ClassDef) for part in one.body)


def programs(cmake):
    """Test programs that must be there: as CMake has them, one name a line."""
    return [line for line in cmake.read_text(encoding="utf-8").split() if line]


def counted(binaries, tests=TESTS, without=()):
    counts = {}
    for name in programs(binaries / "test_programs.txt"):
        counts[name] = gtest_cases(binaries / name) if (binaries / name).exists() else 0
    for name in without:
        counts.pop(name, None)
    for path in sorted(tests.rglob("*.py")):
        found = python_cases(path.read_text(encoding="utf-8"))
        if found:
            counts[path.relative_to(tests).as_posix()] = found
    for folder in sorted((tests / "golden").iterdir()) if (tests / "golden").is_dir() else []:
        if folder.is_dir():
            counts[f"golden/{folder.name}"] = sum(1 for _ in folder.rglob("expected.jsonl"))
    for folder, ending in (("fuzz", "_fuzz.cpp"), ("bench", "_bench.cpp")):
        found = [path for path in (tests / folder).glob(f"*{ending}")] if (tests / folder).is_dir() else []
        if found:
            counts[folder] = len(found)
    passing = tests / "cases" / "passing.txt"
    if passing.exists():
        counts["cases"] = sum(1 for line in passing.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#"))
    return counts


def read(text):
    return {name: int(number) for number, name in re.findall(r"^\s*(\d+) (\S+)$", text, re.MULTILINE)}


def written(counts):
    return HEAD + "".join(f"{number:5} {name}\n" for name, number in sorted(counts.items()))


def compared(before, now, without=()):
    """(faults, news): what is less than before, what is more."""
    faults = [f"{name}: {now.get(name, 0)} test cases, {number} are written down" for name, number in sorted(before.items())
              if name not in without and now.get(name, 0) < number]
    news = [f"{name}: {number} test cases, {before.get(name, 0)} are written down" for name, number in sorted(now.items()) if number > before.get(name, 0)]
    return faults, news


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--file", type=pathlib.Path, default=TESTS / "counts.txt")
    parser.add_argument("--without", nargs="*", default=())
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    now = counted(options.bin, without=options.without)
    if options.write:
        empty = [name for name, number in now.items() if number == 0]
        if empty:
            sys.exit(f"not written: {', '.join(empty)} not built")
        options.file.write_text(written(now), encoding="utf-8")
    before = read(options.file.read_text(encoding="utf-8"))
    faults, news = compared(before, now, options.without)
    for line in news:
        print(f"more   {line}")
    for line in faults:
        print(f"FEWER  {line}")
    print(f"{sum(now.values())} test cases in {len(now)} suites")
    if faults:
        print("If that is meant: packaging/test --counts writes tests/counts.txt, and the commit says why.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
