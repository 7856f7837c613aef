#!/usr/bin/env python3
"""Tests that were skipped, from ctest's result file: all are listed, and one that tests/skips.txt does not expect is a fault.

    skips.py RESULT.xml [--list FILE]

Within a test of ctest each single skip counts: those of GoogleTest, of Python's unittest, and ctest's own.
Each line of the list is "NAME: reason".
"""
import argparse
import pathlib
import re
import sys
import xml.etree.ElementTree

TESTS = pathlib.Path(__file__).resolve().parents[1]
GTEST = re.compile(r"^\[  SKIPPED \] ([\w/]+\.[\w/]+)(?: \(\d+ ms\))?$", re.MULTILINE)
UNITTEST_LINE = re.compile(r"^(test\w+) \(([\w.]+)\).*\.\.\. skipped ['\"](.*)['\"]$", re.MULTILINE)
UNITTEST_SUM = re.compile(r"^(?:OK|FAILED) \(.*?skipped=(\d+)", re.MULTILINE)


def skipped(path):
    """[(name, what it said)]"""
    found = {}
    for case in xml.etree.ElementTree.parse(path).getroot().iter("testcase"):
        name, said = case.get("name"), case.findtext("system-out") or ""
        inner = {}
        for one in GTEST.findall(said):
            inner[one.replace("/", ".")] = ""
        lines = UNITTEST_LINE.findall(said)
        for test, owner, reason in lines:
            inner[f"{name}.{test}"] = reason
        claimed = sum(int(number) for number in UNITTEST_SUM.findall(said))
        if claimed > len(lines):      # a whole class, or output that is told otherwise
            inner.setdefault(name, f"{claimed} skipped")
        if not inner and (case.find("skipped") is not None or case.get("status") == "notrun"):
            inner[name] = (case.find("skipped").get("message") or "") if case.find("skipped") is not None else "not run"
        found.update(inner)
    return sorted(found.items())


def expected(text):
    rows = {}
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            name, _, reason = line.partition(":")
            if not reason.strip():
                raise SystemExit(f"tests/skips.txt: {name} has no reason")
            rows[name.strip()] = reason.strip()
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result", type=pathlib.Path)
    parser.add_argument("--list", type=pathlib.Path, default=TESTS / "skips.txt")
    options = parser.parse_args()
    reasons = expected(options.list.read_text(encoding="utf-8"))
    all_ = skipped(options.result)
    print(f"{len(all_)} tests skipped")
    faulty = 0
    for name, said in all_:
        known = name in reasons
        faulty += not known
        print(f"  {'   ' if known else 'NOT EXPECTED '}{name}: {reasons.get(name, said)}")
    if faulty:
        print(f"{faulty} of them are not in tests/skips.txt: repair what keeps them from running, or say there why")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
