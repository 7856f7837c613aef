#!/usr/bin/env python3
"""Does `params list` tell the truth? Compares the column `acts` of ipc/params/parameters.csv with the sources.

    check_parameter_readers.py [--strict]

Prints the rows that say `yes` though no source reads them, those that give a reason though some source does (it may only
check the configuration: such rows are left out), and the named bits that no source asks for though their text does not say so
("without effect", "reserved"). With --strict a row of the first kind or such a bit is an error.
"""
import pathlib
import re
import sys

import generate_parameters as generator

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["ipc", "kernel", "channels", "toolmgmt", "hmi"]
QUOTED = re.compile(r'"(PT_[A-Z0-9_]+|[NF][0-9]{4})"')   # a PLC asks for its parameters by name
SERIES = re.compile(r"\b(?:numbered|in_row)\((2[0-9]{3})\b")          # ... or by the number of the first of a series
# Names that a source makes, or hands on: parameter -> where.
MADE = {f"N{n:04}": ("toolmgmt/operations/offset_operations.cpp", "N0205") for n in range(205, 217)}
MADE |= {name: ("channels/sinumerik/spindles/speed_limits.cpp", name) for name in ("SD43210", "SD43220", "SD43230")}
SILENT = ("without effect", "reserved", "not used", "no effect")
HANDLE = re.compile(r"\b(?:n[0-9]{4}_[a-z0-9_]+|pt_[a-z0-9_]+|f[0-9]{4}|md[0-9]{5}|sd[0-9]{5}|fg_[a-z0-9_]+|mefi_[0-9]+)\b")


def readers():
    """Handle name -> files that mention it; nth(first, n) reads the whole series of `first`."""
    found = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.[ch]pp")):
            for name in set(HANDLE.findall(path.read_text(encoding="utf-8", errors="replace"))):
                found.setdefault(name, []).append(str(path.relative_to(ROOT)))
            text = path.read_text(encoding="utf-8", errors="replace")
            for number in set(QUOTED.findall(text)) if "plc" in path.parts else ():
                found.setdefault(number, []).append(str(path.relative_to(ROOT)))
            for first in set(SERIES.findall(text)):
                for number in range(int(first), int(first) + (8 if first == "2914" else 4)):   # four magazines; rows and columns of a matrix
                    found.setdefault(f"N{number}", []).append(str(path.relative_to(ROOT)))
    for number, (file, word) in MADE.items():
        if word in (ROOT / file).read_text(encoding="utf-8"):
            found.setdefault(number, []).append(file)
    return found


def last_argument(text, begin):
    """Of the call whose bracket opens at `begin`."""
    depth, last = 0, begin + 1
    for at in range(begin, min(len(text), begin + 400)):
        if text[at] == "(":
            depth += 1
        elif text[at] == ")":
            depth -= 1
            if depth == 0:
                return text[last:at].strip()
        elif text[at] == "," and depth == 1:
            last = at + 1
    return ""


def asked_bits(name, files):
    """Bits of a parameter that the sources ask for; None where one of them takes its whole value or counts the bits."""
    bits = set()
    for file in files:
        if "config_check_effects" in file:   # warns of what has no effect
            continue
        text = (ROOT / file).read_text(encoding="utf-8", errors="replace")
        for use in re.finditer(rf"\b{name}\b", text):
            call = re.search(r"\bbit(\()[^;()]*(?:\([^;()]*\)[^;()]*)*$", text[max(0, use.start() - 120):use.start()])
            number = last_argument(text, max(0, use.start() - 120) + call.start(1)) if call else ""
            if not number.isdigit():
                return None
            bits.add(int(number))
    return bits or None


def main(arguments):
    rows, faults = generator.read(ROOT / "ipc/params/parameters.csv")
    if faults:
        sys.exit("the table itself is wrong: build first")
    generator.lay_out(rows)
    found = readers()
    for row in rows:
        if row.number in found:
            found.setdefault(generator.handle_name(row), found[row.number])
    members = set()   # of a series that is read through its first parameter
    for index, row in enumerate(rows):
        files = found.get(generator.handle_name(row), [])
        for member in rows[index + 1:index + row.series] if files else []:
            found.setdefault(generator.handle_name(member), files)
            members.add(member.number)
    unread = [row for row in rows if row.acts == "yes" and generator.handle_name(row) not in found]
    read = [(row, found[generator.handle_name(row)]) for row in rows if row.acts != "yes" and generator.handle_name(row) in found]
    read = [(row, files) for row, files in read if not all("config_check" in file for file in files)]
    for row in unread:
        print(f"{row.number} {row.name}: says yes, nobody reads it")
    for row, files in read:
        print(f"{row.number} {row.name}: says '{row.acts}', read by {', '.join(files)}")
    silent = []
    for row in rows:
        if row.acts != "yes" or not row.bit_list or row.number in members or generator.handle_name(row) not in found:
            continue
        bits = asked_bits(generator.handle_name(row), found[generator.handle_name(row)])
        for number, name, text in row.bit_list if bits is not None else []:
            if int(number) not in bits and not any(word in text for word in SILENT):
                silent.append((row, number, f"{name}: {text}"))
    for row, number, text in silent:
        print(f"{row.number}#{number} {text}: nobody asks for this bit")
    print(f"{len(unread)} say yes unread, {len(read)} give a reason though read, {len(silent)} bits that nobody asks for")
    sys.exit(1 if (unread or silent) and "--strict" in arguments else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
