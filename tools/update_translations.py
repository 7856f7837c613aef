#!/usr/bin/env python3
"""Keeps the translations of the HMI (hmi/translations/polyturn_*.ts, Qt Linguist) in step with its sources.

Collects every literal in word("...") and WORD("...") below hmi/, and the operator's words in tables of ipc. New texts are added as
unfinished, texts that are no longer used go. Without options the files are rewritten.

  --check        changes nothing; names what is missing or unfinished in any language, exit status 1
  --merge FILE   takes translations from a table: english|ru|cs|hu, one text a line
  --missing      prints what is not translated yet, as such a table
"""
import argparse
import csv
import pathlib
import re
import sys
import xml.etree.ElementTree as ET
from xml.sax.saxutils import escape

TOP = pathlib.Path(__file__).resolve().parent.parent
LANGUAGES = {"ru": "ru_RU", "cs": "cs_CZ", "hu": "hu_HU"}
LITERAL = r'"((?:[^"\\]|\\.)*)"'


def plain(text):
    return text.replace('\\"', '"').replace("\\n", "\n").replace("\\\\", "\\")


def collect():
    found = {}
    for path in sorted((TOP / "hmi").rglob("*.[ch]pp")):
        content = path.read_text(encoding="utf-8")
        content = re.sub(r"^\s*//.*$", "", content, flags=re.M)
        for call in re.finditer(r"\b(?:word|WORD)\(\s*((?:" + LITERAL + r"\s*)+)", content):
            text = "".join(plain(part) for part in re.findall(LITERAL, call.group(1)))
            if text:
                found.setdefault(text, path.relative_to(TOP / "hmi").as_posix())
    # {"name", "text", "remedy"} and {MachineStep::X, "name", "text", "next"}
    for header, columns in (("ipc/requests/start_words.hpp", (1, 2)), ("ipc/model/machine/machine_step.hpp", (1, 2))):
        content = re.sub(r"//.*$", "", (TOP / header).read_text(encoding="utf-8"), flags=re.M)
        for row in re.finditer(r"\{((?:\w+::\w+,\s*)?" + LITERAL + r"(?:,\s*" + LITERAL + r")+)\}", content):
            texts = re.findall(LITERAL, row.group(1))
            for column in columns:
                if column < len(texts) and texts[column]:
                    found.setdefault(plain(texts[column]), "../" + header)
    # Groups and units of the parameters; their names and meanings lie beside them (ipc/params/translations.hpp).
    for row in csv.DictReader((TOP / "ipc/params/parameters.csv").read_text(encoding="utf-8").splitlines()):
        for text in (row["group"], *row["unit"].split("|")):
            if text and text != "%":
                found.setdefault(text, "../ipc/params/parameters.csv")
    # Titles and meanings of the cycles' forms: every literal there that is words.
    for path in sorted((TOP / "ipc/model/languages").glob("*_forms.cpp")):
        content = re.sub(r"^\s*(?://|#include).*$", "", path.read_text(encoding="utf-8"), flags=re.M)
        for text in re.findall(LITERAL, content):
            if re.search(r"[A-Z][a-z]", text):
                found.setdefault(plain(text), "../" + path.relative_to(TOP).as_posix())
    return found


def read(code):
    path = TOP / f"hmi/translations/polyturn_{code}.ts"
    if not path.exists():
        return {}
    out = {}
    for message in ET.parse(path).getroot().iter("message"):
        translation = message.find("translation")
        if translation is not None and translation.get("type") is None and translation.text:
            out[message.find("source").text] = translation.text
    return out


def write(code, texts, translations):
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", f'<TS version="2.1" language="{LANGUAGES[code]}" sourcelanguage="en">', "<context>", "    <name>hmi</name>"]
    for text in sorted(texts):
        done = translations.get(text)
        lines += ["    <message>", f'        <location filename="../{texts[text]}"/>', f"        <source>{escape(text)}</source>",
                  f"        <translation>{escape(done)}</translation>" if done else '        <translation type="unfinished"></translation>', "    </message>"]
    lines += ["</context>", "</TS>", ""]
    (TOP / f"hmi/translations/polyturn_{code}.ts").write_text("\n".join(lines), encoding="utf-8")


def places(text):
    return sorted(re.findall(r"%\d", text))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--merge")
    parser.add_argument("--missing", action="store_true")
    options = parser.parse_args()
    texts = collect()
    known = {code: read(code) for code in LANGUAGES}
    faults = 0
    if options.merge:
        for number, line in enumerate(pathlib.Path(options.merge).read_text(encoding="utf-8").splitlines(), 1):
            parts = line.split("|")
            if not line.strip():
                continue
            if len(parts) != 4:
                print(f"{options.merge}:{number}: not english|ru|cs|hu: {line}", file=sys.stderr)
                return 2
            for code, translation in zip(LANGUAGES, parts[1:]):
                known[code][parts[0]] = translation
    if options.missing:
        for text in texts:
            if any(text not in known[code] for code in LANGUAGES):
                print("|".join([text] + [known[code].get(text, "") for code in LANGUAGES]))
        return 0
    for code in LANGUAGES:
        for text in texts:
            if text not in known[code]:
                faults += 1
                print(f"{code}: not translated: {text!r} ({texts[text]})", file=sys.stderr)
            elif places(text) != places(known[code][text]):
                faults += 1
                print(f"{code}: the places %1, %2 ... are not those of {text!r}: {known[code][text]!r}", file=sys.stderr)
        if options.check:
            for text in known[code]:
                if text not in texts:
                    faults += 1
                    print(f"{code}: no longer used: {text!r}; run tools/update_translations.py", file=sys.stderr)
        else:
            write(code, texts, known[code])
    return 1 if options.check and faults else 0


if __name__ == "__main__":
    sys.exit(main())
