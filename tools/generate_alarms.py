#!/usr/bin/env python3
"""Alarms: one row in ipc/diagnosis/alarms.csv gives the identifier, its numbers per control, text and remedy."""
import csv, pathlib, re, sys

import display_languages

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


# Translations. One that quotes other values than the English row stays English.
def placeholders(value):
    return sorted(re.findall(r"\{[01d]\}", value))


# Parameters that the person at the machine is told to look at, in whatever order the language has them.
def parameters(row):
    return sorted(re.findall(r"\b(?:N|F)\d{4}\b|\bPT_\w+|\bFG\.\w+|\bMD\d+", row["text"] + " " + row["remedy"]))


def misfit(english, row):
    if parameters(row) != parameters(english):
        return f"must name {parameters(english)}"
    if not row["text"] or bool(row["remedy"]) != bool(english["remedy"]) or placeholders(row["text"]) != placeholders(english["text"]):
        return f"must quote {placeholders(english['text'])}, and have a remedy if the English one has"
    return None


known = {row["key"]: row for row in rows}
tables = [display_languages.read(source, code, "key", ["key", "text", "remedy"], known, misfit) for code in display_languages.CODES]
write(folder / "alarm_display_languages.hpp", '// Generated from ipc/diagnosis/alarms.ru.csv, alarms.cs.csv and alarms.hu.csv.\n#pragma once\n#include <array>\n'
      '#include "ipc/diagnosis/display_language.hpp"\nnamespace polyturn {\ninline constexpr std::array<std::array<TranslatedAlarm, kAlarmCount>, 3> kAlarmTranslations{{\n'
      + "".join("  {{\n" + "".join(f"    {{{text(table[r['key']]['text'])}, {text(table[r['key']]['remedy'])}}},\n" if r["key"] in table else "    {},\n" for r in rows)
                + "  }},\n" for table in tables) + "}};\n}\n")
