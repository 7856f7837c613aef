"""Translations of a table: beside TABLE.csv lie TABLE.ru.csv, TABLE.cs.csv and TABLE.hu.csv, one row for each of its rows, by its key.

Whoever changes an English row need not speak the other languages: a translation that is missing or no longer fits is told and left
to English. What can never be right (columns, a key that stands twice) stops the build. Used by the generators of alarms, parameters
and signals.
"""
import csv
import sys

CODES = ("ru", "cs", "hu")   # the order of polyturn::DisplayLanguage, without English


def read(table, code, key, columns, english, misfit):
    """{key: row} of one language. `english`: the table's own rows by key; misfit(english row, row): why it does not fit, or None."""
    path = table.with_name(f"{table.stem}.{code}.csv")
    found = {}
    with path.open(newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames != columns:
            sys.exit(f"{path}:1: columns are {reader.fieldnames}, wanted {columns}")
        for row in reader:
            where, name = f"{path}:{reader.line_num}", row[key]
            if None in row or None in row.values() or name in found:
                sys.exit(f"{where}: wrong number of columns, or {name} stands twice")
            if name not in english:
                continue   # it was renamed or taken away
            why = misfit(english[name], row)
            if why:
                print(f"{where}: {name} {why}; shown in English")
                continue
            found[name] = row
    missing = [name for name in english if name not in found]
    if missing:
        print(f"{path}: {len(missing)} rows are shown in English: {', '.join(missing[:5])}{' ...' if len(missing) > 5 else ''}")
    return found
