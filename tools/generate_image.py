#!/usr/bin/env python3
"""The shared image: ipc/image/fields.csv gives the structures, the table of fields and the layout hash."""
import csv, hashlib, pathlib, re, sys

import display_languages

fields_csv, signals_csv, enums_hpp, capacities_hpp, out = map(pathlib.Path, sys.argv[1:6])
BASE = {"f64": "double", "i64": "std::int64_t", "u64": "std::uint64_t", "i32": "std::int32_t", "u32": "std::uint32_t", "u16": "std::uint16_t",
        "u8": "std::uint8_t", "char": "char", "a64": "std::atomic<std::uint64_t>", "a32": "std::atomic<std::uint32_t>"}


def rows(path):
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line.strip() and not line.startswith("#")]
    table = list(csv.DictReader(lines, restval=""))
    for row in table:
        if None in row or (not row.get("meaning")):
            sys.exit(f"{path}: wrong number of columns: {row}")
    return table


def text(value):
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def write(path, content):
    if not path.exists() or path.read_text(encoding="utf-8") != content:
        path.write_text(content, encoding="utf-8")


structs, order = {}, []
for row in rows(fields_csv):
    if not row["field"]:
        if row["struct"] in structs:
            sys.exit(f"{fields_csv}: {row['struct']} stands twice")
        structs[row["struct"]] = {"writer": row["type"], "meaning": row["meaning"], "fields": []}
        order.append(row["struct"])
        continue
    if row["struct"] not in structs:
        sys.exit(f"{fields_csv}: {row['struct']} has no opening row")
    match = re.fullmatch(r"(\w+)(?:\[(\w+)\])?", row["type"])
    if not match or (match[1] not in BASE and match[1] not in structs):
        sys.exit(f"{fields_csv}: {row['struct']}.{row['field']}: type {row['type']!r}")
    if any(f["field"] == row["field"] for f in structs[row["struct"]]["fields"]):
        sys.exit(f"{fields_csv}: {row['struct']}.{row['field']} stands twice")
    structs[row["struct"]]["fields"].append(row | {"base": match[1], "count": match[2]})

# Signals: PLC and NC flags and registers with their slots. A name may hold ranges: CP_MGR{1..16} stands for sixteen rows. The
# column `index` gives an array its elements: 0..31 is NAME[0] to NAME[31]; `alias` other spellings, with a space between them.
# A double occupies two slots, its low word first.
SCOPES = {"global": "1", "channel": "kMaxChannels", "axis": "kMaxAxes", "spindle": "kMaxSpindles"}
COUNTS = {"global": 1, "channel": 16, "axis": 96, "spindle": 32}
KINDS = {"flag": 1, "register": 1, "double": 2}


def spelled_out(name):
    match = re.search(r"\{(\d+)\.\.(\d+)\}", name)
    if not match:
        return [name]
    return [full for i in range(int(match[1]), int(match[2]) + 1) for full in spelled_out(name[:match.start()] + str(i) + name[match.end():])]


signals, next_slot, spellings = [], {"N": 0, "P": 0}, set()
patterns = rows(signals_csv)
for pattern in patterns:
    index = re.fullmatch(r"(\d+)\.\.(\d+)", pattern.get("index") or "0..0")
    if pattern["scope"] not in SCOPES or pattern["writer"] not in next_slot or pattern["kind"] not in KINDS or not index \
            or (pattern.get("index") and pattern["scope"] != "global"):
        sys.exit(f"{signals_csv}: {pattern}")
    for name in spelled_out(pattern["name"]):
        row = pattern | {"pattern": pattern["name"], "name": name, "first": int(index[1]), "count": int(index[2]) - int(index[1]) + 1, "alias": pattern.get("alias", "")}
        for spelling in [name, *row["alias"].split()]:
            if spelling in spellings:
                sys.exit(f"{signals_csv}: {spelling} stands twice")
            spellings.add(spelling)
        signals.append(row | {"slot": next_slot[row["writer"]], "array": bool(pattern.get("index"))})
        next_slot[row["writer"]] += COUNTS[row["scope"]] * row["count"] * KINDS[row["kind"]]

hash_of = hashlib.sha256(b"".join(p.read_bytes() for p in (fields_csv, signals_csv, enums_hpp, capacities_hpp))).hexdigest()[:16]

h = ["// Generated from ipc/image/fields.csv and ipc/image/signals.csv.", "#pragma once", "#include <array>", "#include <atomic>", "#include <cstdint>",
     "#include <span>", "#include <string_view>", '#include "ipc/capacities.hpp"', '#include "ipc/image/enums.hpp"', "namespace polyturn {",
     f"inline constexpr std::uint64_t kLayoutHash = 0x{hash_of}ull;",
     f"inline constexpr std::size_t kNcSignals = {max(1, next_slot['N'])};", f"inline constexpr std::size_t kPlcSignals = {max(1, next_slot['P'])};"]
for name in order:
    struct = structs[name]
    h.append(f"// {struct['meaning']}. Written by: {struct['writer']}.\nstruct {name} {{")
    for f in struct["fields"]:
        base = BASE.get(f["base"], f["base"])
        kind = f"std::array<{base}, {f['count']}>" if f["count"] else base
        unit = f" [{f['unit']}]" if f["unit"] else ""
        h.append(f"    {kind} {f['field']}{{}};  // {f['meaning']}{unit}")
    h.append("};")
h += ["enum class SignalScope : std::uint8_t { Global, Channel, Axis, Spindle };",
      "enum class SignalWriter : std::uint8_t { Nc, Plc };",
      "enum class SignalKind : std::uint8_t { Flag, Register, Double };  // a double: two slots, its low word first",
      "// `elements` counts NAME[first] and what follows; 0: no array. `alias`: other spellings, separated by a space.",
      "struct SignalRow { std::string_view name; SignalScope scope; SignalWriter writer; bool is_register; std::uint32_t slot; std::string_view meaning;",
      "                   SignalKind kind; std::uint16_t first, elements; std::string_view alias; };",
      "std::span<const SignalRow> signal_rows();",
      "struct FieldRow { std::string_view structure, writer, field, type, unit, meaning; std::uint32_t offset, size; };",
      "std::span<const FieldRow> image_fields();",
      "// A signal written by the NC (index into PlcInputs::signal) or by the PLC (PlcOutputs::signal); instance counts from 1.",
      "struct NcSignal { std::uint32_t slot; constexpr std::uint32_t operator()(std::size_t instance = 1) const { return slot + static_cast<std::uint32_t>(instance) - 1; } };",
      "struct PlcSignal { std::uint32_t slot; constexpr std::uint32_t operator()(std::size_t instance = 1) const { return slot + static_cast<std::uint32_t>(instance) - 1; } };",
      "namespace signals {"]
for s in signals:
    kind = "NcSignal" if s["writer"] == "N" else "PlcSignal"
    h.append(f"inline constexpr {kind} {s['name'].lower()}{{{s['slot']}}};  // {s['meaning']}")
h += ["}  // namespace signals", "}  // namespace polyturn", ""]

c = ["// Generated from ipc/image/fields.csv and ipc/image/signals.csv.", "#include <cstddef>", '#include "polyturn/image_structs.hpp"', "namespace polyturn {",
     "static constexpr SignalRow kSignals[] = {"]
for s in signals:
    c.append(f"    {{{text(s['name'])}, SignalScope::{s['scope'].capitalize()}, SignalWriter::{'Nc' if s['writer'] == 'N' else 'Plc'}, "
             f"{'false' if s['kind'] == 'flag' else 'true'}, {s['slot']}, {text(s['meaning'])}, "
             f"SignalKind::{s['kind'].capitalize()}, {s['first']}, {s['count'] if s['array'] else 0}, {text(s['alias'])}}},")
c += ["};", "std::span<const SignalRow> signal_rows() { return kSignals; }", '#pragma GCC diagnostic ignored "-Winvalid-offsetof"', "static const FieldRow kFields[] = {"]
for name in order:
    struct = structs[name]
    for f in struct["fields"]:
        c.append(f"    {{{text(name)}, {text(struct['writer'])}, {text(f['field'])}, {text(f['type'])}, {text(f['unit'])}, {text(f['meaning'])}, "
                 f"static_cast<std::uint32_t>(offsetof({name}, {f['field']})), static_cast<std::uint32_t>(sizeof({name}::{f['field']}))}},")
c += ["};", "std::span<const FieldRow> image_fields() { return kFields; }", "}  // namespace polyturn", ""]
(out / "polyturn").mkdir(parents=True, exist_ok=True)
write(out / "polyturn" / "image_structs.hpp", "\n".join(h))
write(out / "image_tables.cpp", "\n".join(c))

# What people read of a signal in other languages, one text for each row of signal_rows().
found = [display_languages.read(signals_csv, code, "name", ["name", "meaning"], {pattern["name"]: pattern for pattern in patterns},
                      lambda _, row: None if row["meaning"] else "has no meaning")
         for code in display_languages.CODES]
write(out / "polyturn" / "signal_translations.hpp",
      "// Generated from ipc/image/signals.ru.csv, signals.cs.csv and signals.hu.csv.\n#pragma once\n#include <array>\n#include <string_view>\nnamespace polyturn {\n"
      f"inline constexpr std::array<std::array<std::string_view, {len(signals)}>, 3> kSignalTranslations{{{{\n"
      + "".join("  {{\n" + "".join(f"    {text(display_language[s['pattern']]['meaning']) if s['pattern'] in display_language else '{}'},\n" for s in signals) + "  }},\n" for display_language in found)
      + "}};\n}\n")
