#!/usr/bin/env python3
"""Turns ipc/params/parameters.csv into C++: the typed handles, the table of rows, and what people read of them in other languages.

    generate_parameters.py TABLE.csv HANDLES.hpp ROWS.cpp [TONGUES.hpp]

Run by CMake. Whatever is wrong with the table is reported as TABLE.csv:LINE: message, all faults at once, and fails the
build: a parameter that is read wrongly moves a machine wrongly. The columns are described in ipc/params/README.md.
"""
import csv
import math
import pathlib
import re
import sys

import display_languages

COLUMNS = ["number", "name", "group", "scope", "type", "unit", "min", "max", "default", "effect", "protection", "acts",
           "bits", "meaning"]
SCOPES = {"global": "Global", "T": "Group", "L": "Channel", "A": "Axis", "S": "Spindle"}
TYPES = {"bit": "Bits", "int": "Int", "double": "Real", "text": "Text", "ipv4": "Text"}
EFFECTS = {"tick": "Tick", "barrier": "Barrier", "restart": "Restart"}
PROTECTIONS = {"operator": "Operator", "setter": "Setter", "maker": "Maker"}
NUMBER = re.compile(r"(N|F|MD|SD)[0-9]{4,5}|PT_[A-Z0-9_]+|FG\.[A-Z0-9_]+|MEFI\.[0-9]+")
BIT = re.compile(r"#([0-7]) ([A-Z0-9]+): (.+)")
TEXT_CAPACITY = 63
LARGEST = 1.7e308          # limit of a double when the table names none
EXACT = 2.0 ** 53          # whole numbers are kept in doubles


class Row:
    def __init__(self, line, cells):
        self.line = line
        self.__dict__.update({key: cells[key].strip() for key in COLUMNS})
        self.array = 1
        self.bit_list = []
        self.choices = []
        self.series = 1


def slug(text):
    return re.sub(r"_+", "_", re.sub(r"[^a-z0-9]+", "_", text.lower())).strip("_")


def handle_name(row):
    """n0304_rapid; pt_horizon; f5002; mefi_80."""
    number = slug(row.number)
    return f"{number}_{slug(row.name)}" if row.number.startswith("N") else number


def quoted(text):
    out = []
    for byte in text.encode():
        if byte in b'"\\':
            out.append("\\" + chr(byte))
        elif 32 <= byte < 127:
            out.append(chr(byte))
        else:
            out.append(f"\\{byte:03o}")
    return '"' + "".join(out) + '"'


def number_literal(value):
    return repr(float(value))


def parse_number(text, what, fail, fallback):
    if text == "":
        return fallback
    try:
        value = float(text)
    except ValueError:
        fail(f"{what} '{text}' is no number")
        return fallback
    if not math.isfinite(value):
        fail(f"{what} '{text}' is not finite")
        return fallback
    return value


def read(path):
    """Rows and faults; a row with a fault is still in the list, so that its successors are checked too."""
    faults, rows = [], []
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames != COLUMNS:
            return [], [(1, f"columns are {reader.fieldnames}, wanted {COLUMNS}")]
        numbers, handles = {}, {}
        for cells in reader:
            line = reader.line_num
            if None in cells or None in cells.values():
                faults.append((line, f"{len(COLUMNS)} columns wanted"))
                continue
            row = Row(line, cells)
            rows.append(row)
            check(row, lambda message, at=line, of=row: faults.append((at, f"{of.number}: {message}")))
            for table, key, what in ((numbers, row.number.upper(), "number"), (handles, handle_name(row), "handle")):
                if key in table:
                    faults.append((line, f"{what} {key} is already on line {table[key]}"))
                table.setdefault(key, line)
    return rows, faults


def check(row, fail):
    if not NUMBER.fullmatch(row.number):
        fail("is no parameter number")
    array = re.fullmatch(r"([a-z0-9]+)\[([1-9][0-9]*)\]", row.type)
    if array:
        row.type, row.array = array[1], int(array[2])
    for value, known, what in ((row.scope, SCOPES, "scope"), (row.type, TYPES, "type"), (row.effect, EFFECTS, "effect"),
                               (row.protection, PROTECTIONS, "protection")):
        if value not in known:
            fail(f"unknown {what} '{value}', known are {', '.join(known)}")
    for value, what in ((row.name, "name"), (row.group, "group"), (row.acts, "acts"), (row.meaning, "meaning")):
        if value == "":
            fail(f"{what} is empty")
    text = TYPES.get(row.type) == "Text"
    row.low = parse_number(row.min, "min", fail, 0.0 if text or row.type == "bit" else -LARGEST)
    row.high = parse_number(row.max, "max", fail, TEXT_CAPACITY if text else 255.0 if row.type == "bit" else LARGEST)
    if row.type == "int":
        row.low, row.high = max(row.low, -EXACT), min(row.high, EXACT)
    if row.low > row.high:
        fail(f"min {row.min} is above max {row.max}")
    if text and (row.array != 1 or row.high > TEXT_CAPACITY or row.low < 0):
        fail(f"a text has one element and 0 to {TEXT_CAPACITY} characters")
    if row.type == "bit" and not (0 <= row.low and row.high <= 255):
        fail("a bit parameter has 0 to 255")
    check_bits(row, fail)
    check_default(row, text, fail)


def check_bits(row, fail):
    """The bits column: '#0 DIA: meaning; #1 ...' for a bit parameter, 'word / word' for a text with choices."""
    if row.type == "text" and row.bits:
        row.choices = [word.strip() for word in row.bits.split(" / ")]
        if len(set(row.choices)) != len(row.choices) or "" in row.choices:
            fail("choices are empty or double")
    elif row.type == "bit":
        for part in filter(None, row.bits.split("; ")):
            found = BIT.fullmatch(part.strip())
            if not found:
                fail(f"'{part}' is no bit, wanted '#0 NAME: meaning'")
                continue
            number = int(found[1])
            if row.bit_list and number <= row.bit_list[-1][0]:
                fail(f"bit #{number} is out of order or double")
            if not int(row.high) >> number & 1:
                fail(f"bit #{number} is not within max {row.max}")
            row.bit_list.append((number, found[2], found[3].strip()))
    elif row.bits:
        fail("only bit parameters have bits, only texts have choices")


def check_default(row, text, fail):
    row.defaults, row.default_text = [], ""
    if text:
        row.default_text = row.default
        if len(row.default) > row.high or (row.choices and row.default not in row.choices):
            fail(f"default '{row.default}' is not allowed")
        return
    values = row.default.split()
    if len(values) not in (1, row.array):
        fail(f"{len(values)} defaults, wanted 1 or {row.array}")
    for value in values:
        number = parse_number(value, "default", fail, row.low)
        if not row.low <= number <= row.high:
            fail(f"default {value} is outside {row.low} to {row.high}")
        if row.type != "double" and number != int(number):
            fail(f"default {value} is no whole number")
        row.defaults.append(number)


def lay_out(rows):
    """Slots, and how many alike rows follow: same type and scope, names that differ by one counter, numbers that run on."""
    counts = {"number": 0, "text": 0}
    instances = {"global": "1", "T": "kMaxGroups", "L": "kMaxChannels", "A": "kMaxAxes", "S": "kMaxSpindles"}
    capacity = {"global": 1, "T": 8, "L": 16, "A": 96, "S": 32}
    for row in rows:
        kind = "text" if TYPES[row.type] == "Text" else "number"
        row.first_slot = counts[kind]
        counts[kind] += capacity[row.scope] * row.array
    for index in range(len(rows) - 2, -1, -1):
        if alike(rows[index], rows[index + 1]):
            rows[index].series = rows[index + 1].series + 1
    return counts["number"], counts["text"], instances, capacity


def alike(first, second):
    shape = [(row.type, row.array, row.scope, row.unit, row.min, row.max) for row in (first, second)]
    digits = [re.fullmatch(r"([A-Z.]+)([0-9]+)", row.number) for row in (first, second)]
    if shape[0] != shape[1] or not all(digits) or digits[0][1] != digits[1][1] or int(digits[1][2]) != int(digits[0][2]) + 1:
        return False
    parts = [re.split(r"([0-9]+)", row.name) for row in (first, second)]
    if len(parts[0]) != len(parts[1]):
        return False
    different = [(a, b) for a, b in zip(*parts) if a != b]
    return len(different) == 1 and different[0][0].isdigit() and int(different[0][1]) == int(different[0][0]) + 1


def write(path, lines):
    """Only what changed: a new meaning must not rebuild everything that includes the handles."""
    text = "\n".join(lines)
    try:
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    except OSError:
        pass
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def write_handles(rows, path, layout):
    numbers, texts, names, capacity = layout
    out = ["// Generated from ipc/params/parameters.csv by tools/generate_parameters.py. Do not edit.",
           "#pragma once", "", "#include <cstddef>", "", '#include "ipc/params/handle.hpp"', "",
           "namespace polyturn::params {", ""]
    out += [f"static_assert({name} == {capacity[scope]}, \"tools/generate_parameters.py knows other capacities\");"
            for scope, name in names.items() if scope != "global"]
    out += ["", f"inline constexpr std::size_t kRowCount = {len(rows)};",
            f"inline constexpr std::size_t kNumberSlots = {numbers};", f"inline constexpr std::size_t kTextSlots = {texts};", ""]
    for index, row in enumerate(rows):
        out.append(f"inline constexpr Handle<Scope::{SCOPES[row.scope]}, Type::{TYPES[row.type]}> {handle_name(row)}"
                   f"{{{row.first_slot}, {index}, {row.array}, {row.series}}};   // {row.number} {row.name}"
                   + (f", {row.unit}" if row.unit else ""))
    out += ["", "}  // namespace polyturn::params", ""]
    write(path, out)


def write_rows(rows, path):
    out = ["// Generated from ipc/params/parameters.csv by tools/generate_parameters.py. Do not edit.",
           '#include "ipc/params/row_table.hpp"', "", "#include <string_view>", "", "namespace polyturn::params::detail {",
           "namespace {", "using namespace std::string_view_literals;", ""]
    for index, row in enumerate(rows):
        if row.defaults:
            out.append(f"constexpr double kDefaults{index}[] = {{{', '.join(map(number_literal, row.defaults))}}};")
        if row.bit_list:
            bits = ", ".join(f"{{{number}, {quoted(name)}sv, {quoted(text)}sv}}" for number, name, text in row.bit_list)
            out.append(f"constexpr Bit kBits{index}[] = {{{bits}}};")
        if row.choices:
            out.append(f"constexpr std::string_view kChoices{index}[] = {{{', '.join(quoted(word) + 'sv' for word in row.choices)}}};")
    out += ["", "constexpr Row kRowTable[] = {"]
    for index, row in enumerate(rows):
        rule = "Ipv4" if row.type == "ipv4" else "Choice" if row.choices else "Any"
        texts = ", ".join(quoted(text) + "sv" for text in (row.number, row.name, row.group, row.unit, row.meaning, row.acts))
        out.append(f"    {{{texts}, Scope::{SCOPES[row.scope]}, Type::{TYPES[row.type]}, TextRule::{rule}, "
                   f"Effect::{EFFECTS[row.effect]}, Protection::{PROTECTIONS[row.protection]}, {number_literal(row.low)}, "
                   f"{number_literal(row.high)}, {row.first_slot}, {row.array}, "
                   + (f"kDefaults{index}" if row.defaults else "{}") + f", {quoted(row.default_text)}sv, "
                   + (f"kBits{index}" if row.bit_list else "{}") + ", " + (f"kChoices{index}" if row.choices else "{}") + "},")
    order = sorted(range(len(rows)), key=lambda index: rows[index].number)
    out += ["};", "", "constexpr std::uint16_t kOrder[] = {",
            "    " + ", ".join(map(str, order)), "};", "", "}  // namespace", "",
            "const std::span<const Row> kRows{kRowTable};", "const std::span<const std::uint16_t> kByNumber{kOrder};", "",
            "}  // namespace polyturn::params::detail", ""]
    write(path, out)


def misfit(row, cells):
    """A translation names the same bits, in the same order, and says something wherever the English row does."""
    if not cells["name"] or not cells["meaning"] or bool(cells["acts"]) != (row.acts != "yes"):
        return "needs a name, a meaning, and acts where the row has no effect"
    if row.type == "text":
        return None if cells["bits"] == row.bits else f"must leave the choices as they are: {row.bits}"
    parts = [BIT.fullmatch(part.strip()) for part in filter(None, cells["bits"].split("; "))]
    wanted = [f"#{number} {name}" for number, name, _ in row.bit_list]
    if not all(parts) or [f"#{part[1]} {part[2]}" for part in parts] != wanted:
        return f"must name the bits {', '.join(wanted) or 'none'}"
    cells["bit texts"] = [part[3].strip() for part in parts]
    return None


def write_tongues(table, rows, path):
    english = {row.number: row for row in rows}
    columns = ["number", "name", "bits", "meaning", "acts"]
    found = [display_languages.read(table, code, "number", columns, english, misfit) for code in display_languages.CODES]
    out = ["// Generated from ipc/params/parameters.ru.csv, parameters.cs.csv and parameters.hu.csv by tools/generate_parameters.py.",
           "#pragma once", "#include <array>", '#include "ipc/params/translations.hpp"', '#include "polyturn/parameter_handles.hpp"', "",
           "namespace polyturn::params::detail {", "using namespace std::string_view_literals;", ""]
    for code, display_language in zip(display_languages.CODES, found):
        for index, row in enumerate(rows):
            texts = display_language.get(row.number, {}).get("bit texts")
            if texts:
                out.append(f"inline constexpr std::string_view kBits_{code}{index}[] = {{{', '.join(quoted(text) + 'sv' for text in texts)}}};")
    out += ["", "inline constexpr std::array<std::array<TranslatedRow, kRowCount>, 3> kDisplayLanguages{{"]
    for code, display_language in zip(display_languages.CODES, found):
        out.append("  {{")
        for index, row in enumerate(rows):
            cells = display_language.get(row.number)
            out.append("    {}," if cells is None else
                       f"    {{{quoted(cells['name'])}sv, {quoted(cells['meaning'])}sv, {quoted(cells['acts'])}sv, "
                       + (f"kBits_{code}{index}" if cells.get("bit texts") else "{}") + f"}},   // {row.number}")
        out.append("  }},")
    out += ["}};", "", "}  // namespace polyturn::params::detail", ""]
    write(path, out)


def main(arguments):
    if len(arguments) not in (3, 4):
        sys.exit(__doc__)
    table, handles, source = arguments[:3]
    rows, faults = read(table)
    for line, message in faults:
        print(f"{table}:{line}: {message}", file=sys.stderr)
    if faults:
        sys.exit(1)
    layout = lay_out(rows)
    write_handles(rows, handles, layout)
    write_rows(rows, source)
    if len(arguments) == 4:
        write_tongues(pathlib.Path(table), rows, arguments[3])


if __name__ == "__main__":
    main(sys.argv[1:])
