#!/usr/bin/env python3
"""Alarms: one row in ipc/diagnosis/alarms.csv gives the identifier, its numbers per control, text and remedy."""
import csv, pathlib, sys

source, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
dialects = ["polyturn", "fanuc", "nct", "fagor", "sinumerik", "mefi"]
rows = list(csv.DictReader(source.open(encoding="utf-8")))
seen = set()
for number, row in enumerate(rows, 2):
    where = f"{source}:{number}"
    if None in row or None in row.values():
        sys.exit(f"{where}: wrong number of columns")
    if row["key"] in seen or not row["key"].isidentifier():
        sys.exit(f"{where}: key {row['key']!r} is no identifier or stands twice")
    if row["severity"] not in ("message", "warning", "error"):
        sys.exit(f"{where}: severity {row['severity']!r}")
    if not row["polyturn"] or not row["text"]:
        sys.exit(f"{where}: number or text missing")
    seen.add(row["key"])
numbers = [row["polyturn"] for row in rows]
for number in {n for n in numbers if numbers.count(n) > 1}:
    sys.exit(f"{source}: Polyturn number {number} stands twice")


def text(value):
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


folder = out / "polyturn"
folder.mkdir(parents=True, exist_ok=True)


def write(path, content):
    if not path.exists() or path.read_text(encoding="utf-8") != content:
        path.write_text(content, encoding="utf-8")


write(folder / "alarm_ids.hpp", "// Generated from ipc/diagnosis/alarms.csv.\n#pragma once\n#include <cstdint>\nnamespace polyturn {\n"
      "enum class Alarm : std::uint16_t {\n" + "".join(f"    {row['key']},\n" for row in rows)
      + "};\ninline constexpr std::uint16_t kAlarmCount = " + str(len(rows)) + ";\n}\n")
write(out / "alarm_rows.cpp", '// Generated from ipc/diagnosis/alarms.csv.\n#include "ipc/diagnosis/diagnosis.hpp"\nnamespace polyturn {\n'
      "static constexpr AlarmRow kRows[] = {\n" + "".join(
          f"    {{Alarm::{row['key']}, {text(row['key'])}, Severity::{row['severity'].capitalize()}, {{"
          + ", ".join(text(row[d]) for d in dialects) + f"}}, {text(row['text'])}, {text(row['remedy'])}}},\n" for row in rows)
      + "};\nconst AlarmRow& alarm_row(Alarm id) { return kRows[static_cast<std::size_t>(id)]; }\n}\n")
