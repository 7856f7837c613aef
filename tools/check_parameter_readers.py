#!/usr/bin/env python3
"""Does `params list` tell the truth? Compares the column `acts` of ipc/params/parameters.csv with the sources.

    check_parameter_readers.py [--strict]

Prints the rows that say `yes` though no source reads them, and those that give a reason though some source does (it may
only check the configuration: such rows are left out). With --strict a row of the first kind is an error.
"""
import pathlib
import re
import sys

import generate_parameters as generator

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["ipc", "kernel", "channels", "toolmgmt", "hmi"]
QUOTED = re.compile(r'"(PT_[A-Z0-9_]+|[NF][0-9]{4})"')   # a PLC asks for its parameters by name
HANDLE = re.compile(r"\b(?:n[0-9]{4}_[a-z0-9_]+|pt_[a-z0-9_]+|f[0-9]{4}|md[0-9]{5}|sd[0-9]{5}|fg_[a-z0-9_]+|mefi_[0-9]+)\b")


def readers():
    """Handle name -> files that mention it; nth(first, n) reads the whole series of `first`."""
    found = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.[ch]pp")):
            for name in set(HANDLE.findall(path.read_text(encoding="utf-8", errors="replace"))):
                found.setdefault(name, []).append(str(path.relative_to(ROOT)))
            if "plc" in path.parts:
                for number in set(QUOTED.findall(path.read_text(encoding="utf-8", errors="replace"))):
                    found.setdefault(number, []).append(str(path.relative_to(ROOT)))
    return found


def main(arguments):
    rows, faults = generator.read(ROOT / "ipc/params/parameters.csv")
    if faults:
        sys.exit("the table itself is wrong: build first")
    generator.lay_out(rows)
    found = readers()
    for row in rows:
        if row.number in found:
            found.setdefault(generator.handle_name(row), found[row.number])
    for index, row in enumerate(rows):
        files = found.get(generator.handle_name(row), [])
        for member in rows[index + 1:index + row.series] if files else []:
            found.setdefault(generator.handle_name(member), files)
    unread = [row for row in rows if row.acts == "yes" and generator.handle_name(row) not in found]
    read = [(row, found[generator.handle_name(row)]) for row in rows if row.acts != "yes" and generator.handle_name(row) in found]
    read = [(row, files) for row, files in read if not all("config_check" in file for file in files)]
    for row in unread:
        print(f"{row.number} {row.name}: says yes, nobody reads it")
    for row, files in read:
        print(f"{row.number} {row.name}: says '{row.acts}', read by {', '.join(files)}")
    print(f"{len(unread)} say yes unread, {len(read)} give a reason though read")
    sys.exit(1 if unread and "--strict" in arguments else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
