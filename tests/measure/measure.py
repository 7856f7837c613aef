#!/usr/bin/env python3
"""Measures the sources and prints the table of what was agreed for them (packaging/test --measure).

    measure.py [--top FOLDER] [--json] [--find MEASURE]

Production code is C and C++ below the top folder, without tests, examples, documents and what a build generates.
--json prints the figures as one object; --find lists the places behind a figure (orders, dialects, long, wide, old).
Each measure's definition is the sentence beside its name in MEASURES.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from source_text import Source  # noqa: E402

C_NAMES = (".c", ".h", ".cpp", ".hpp", ".cc", ".hh")
NOT_PRODUCTION = ("tests", "examples", "docs", "build", "tools", "third_party")
CONTROLS = ("fanuc", "nct", "mefi", "sinumerik", "fagor")
WINDOW = 8

# key, wanted (None: told only), definition
MEASURES = (
    ("files", None, "production files"),
    ("lines", None, "lines of production files, with blank ones and comments"),
    ("class_functions", 60, "member functions with a body of the class that has most of them, in all its files"),
    ("class_lines", 1500, "lines of the bodies, from head to bracket, of the class with most such lines"),
    ("folder_files", 30, "production files of the folder, without its subfolders, that has most"),
    ("file_lines_median", None, "lines of the file in the middle"),
    ("file_lines_p90", None, "nine of ten files have no more lines"),
    ("file_lines_max", 700, "lines of the longest file"),
    ("width_p99", 100, "ninety-nine of a hundred lines are not wider, in characters"),
    ("width_max", 110, "the widest line, in characters"),
    ("comment_share", 20.0, "per cent of the lines that hold a comment, alone or behind code"),
    ("orders", None, "places that name a memory order"),
    ("orders_reasoned", 100.0, "per cent of those with a comment of three words or more at most three lines away"),
    ("test_lines_share", 0.6, "lines of C, C++ and Python below tests and of golden programs, for each production line"),
    ("dialect_places", 0, "lines outside the folder of a control that name it: Dialect::Fanuc and the like, or a member .nct, .mefi"),
    ("function_median", None, "lines of the function in the middle"),
    ("function_p90", 25, "nine of ten functions have no more lines"),
    ("function_p99", 70, "ninety-nine of a hundred functions have no more lines"),
    ("function_max", 120, "lines of the longest function"),
    ("duplicates_share", 2.0, "per cent of code lines in a run of eight that stood before in the same words"),
    ("old_code", 0.1, "comment lines that are code put aside, in 1000 lines"),
    ("todo", 0.3, "TODO, FIXME, XXX and HACK, in 1000 lines"),
    ("defines", 2.0, "#define, in 1000 lines"),
    ("static_asserts", None, "static_assert, in 1000 lines"),
    ("asserts", None, "PT_ASSERT with a condition, in 1000 lines"),
)
# Where more is better.
AT_LEAST = {"comment_share", "orders_reasoned", "test_lines_share"}

ORDER = re.compile(r"\bmemory_order(?:_|::)\w+")
DIALECT = re.compile(r"\bDialect::(Fanuc|Nct|Mefi|Sinumerik|Fagor)\b|(?:\.|->)(nct|mefi)\b")
OLD_CODE = re.compile(r"^(?:(?:if|for|while|switch)\s*\(.*\)\s*\{?|return\b[^.]*;|[\w:<>*&,\s.\[\]>-]+\([^)]*\)\s*;|[\w.\[\]>-]+\s*[-+*/|&]?=\s*[^=].*;|[{}]+;?)$")
TODO = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")


def tracked(top):
    """Files of the tree: those that git knows, or all where there is no git."""
    try:
        done = subprocess.run(["git", "-C", str(top), "ls-files", "-z"], capture_output=True, text=True, check=True)
        if done.stdout:
            return [top / name for name in done.stdout.split("\0") if name]
    except (OSError, subprocess.CalledProcessError):
        pass
    return [path for path in top.rglob("*") if path.is_file()]


def text_of(path):
    return path.read_text(encoding="utf-8", errors="replace")


def share(values, part):
    """The value that this part of the sorted values does not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(len(ordered) * part))] if ordered else 0


class Tree:
    def __init__(self, top):
        self.top = pathlib.Path(top).resolve()
        self.sources = []
        self.test_lines = 0
        for path in sorted(tracked(self.top)):
            parts = path.relative_to(self.top).parts
            if not path.exists():
                continue
            if parts[0] == "tests":
                golden = parts[1:2] == ("golden",)
                if path.suffix in C_NAMES + (".py",) or (golden and path.name == "program.nc"):
                    self.test_lines += text_of(path).count("\n")
            elif parts[0] not in NOT_PRODUCTION and path.suffix in C_NAMES:
                self.sources.append(Source("/".join(parts), text_of(path)))
        self.functions = [f for s in self.sources for f in s.functions()]
        self.lines = sum(len(s.lines) for s in self.sources)

    # Each returns places as "path:line: text".
    def orders(self):
        bare, count = [], 0
        for s in self.sources:
            for number, line in enumerate(s.code, 1):
                found = len(ORDER.findall(line))
                if not found:
                    continue
                count += found
                about = " ".join(s.comments.get(n, "") for n in range(number - 3, number + 4))
                if len(re.findall(r"\w+", about)) < 3:
                    bare += [f"{s.path}:{number}: {line.strip()}"] * found
        return count, bare

    def dialects(self):
        places = []
        for s in self.sources:
            folders = s.path.split("/")[:-1]
            for number, line in enumerate(s.code, 1):
                named = {(a or b).lower() for a, b in DIALECT.findall(line)}
                if any(name not in folders for name in named):
                    places.append(f"{s.path}:{number}: {line.strip()}")
        return places

    def old(self):
        places = []
        for s in self.sources:
            for number in s.comment_lines():
                if OLD_CODE.match(s.comments[number].strip()):
                    places.append(f"{s.path}:{number}: {s.lines[number - 1].strip()}")
        return places

    def long(self):
        return [f"{f.path}:{f.first}: {f.lines} {f.name}" for f in sorted(self.functions, key=lambda f: -f.lines)[:40]]

    def wide(self):
        all_ = [(len(line), s.path, n) for s in self.sources for n, line in enumerate(s.lines, 1)]
        return [f"{path}:{n}: {width}" for width, path, n in sorted(all_, reverse=True)[:40]]

    def classes(self):
        """{class: (functions, lines)}"""
        found = collections.defaultdict(lambda: [0, 0])
        for f in self.functions:
            if f.owner:
                found[f.owner][0] += 1
                found[f.owner][1] += f.lines
        return found

    def duplicates(self):
        """(repeated lines, code lines)"""
        seen = {}
        repeated = total = 0
        for s in self.sources:
            texts = [re.sub(r"\s+", "", line) for line in s.text_without_comments()]
            kept = [t for t in texts if t and not t.startswith("#include") and t not in ("{", "}", "};", ");", "public:", "private:")]
            total += len(kept)
            marked = set()
            for k in range(len(kept) - WINDOW + 1):
                window = hash(tuple(kept[k:k + WINDOW]))
                if window in seen:
                    marked.update(range(k, k + WINDOW))
                else:
                    seen[window] = s.path
            repeated += len(marked)
        return repeated, total

    def count(self, pattern, comments=False):
        found = re.compile(pattern)
        if comments:
            return sum(len(found.findall(text)) for s in self.sources for text in s.comments.values())
        return sum(len(found.findall(line)) for s in self.sources for line in s.code)


def figures(tree):
    per_thousand = lambda n: round(1000 * n / max(1, tree.lines), 2)
    sizes = [len(s.lines) for s in tree.sources]
    widths = [len(line) for s in tree.sources for line in s.lines]
    bodies = [f.lines for f in tree.functions]
    folders = collections.Counter(s.path.rpartition("/")[0] for s in tree.sources)
    classes = tree.classes()
    most = max(classes.items(), key=lambda c: c[1][0], default=("", [0, 0]))
    longest = max(classes.items(), key=lambda c: c[1][1], default=("", [0, 0]))
    orders, bare = tree.orders()
    repeated, code = tree.duplicates()
    folder = max(folders.items(), key=lambda f: f[1], default=("", 0))
    longest_function = max(tree.functions, key=lambda f: f.lines, default=None)
    widest = tree.wide()[:1]
    values = {
        "files": len(sizes), "lines": tree.lines,
        "class_functions": most[1][0], "class_lines": longest[1][1], "folder_files": folder[1],
        "file_lines_median": share(sizes, .5), "file_lines_p90": share(sizes, .9), "file_lines_max": max(sizes, default=0),
        "width_p99": share(widths, .99), "width_max": max(widths, default=0),
        "comment_share": round(100 * sum(len(s.comments) for s in tree.sources) / max(1, tree.lines), 1),
        "orders": orders, "orders_reasoned": round(100 * (1 - len(bare) / orders), 1) if orders else 100.0,
        "test_lines_share": round(tree.test_lines / max(1, tree.lines), 2),
        "dialect_places": len(tree.dialects()),
        "function_median": share(bodies, .5), "function_p90": share(bodies, .9), "function_p99": share(bodies, .99),
        "function_max": max(bodies, default=0),
        "duplicates_share": round(100 * repeated / max(1, code), 2),
        "old_code": per_thousand(len(tree.old())), "todo": per_thousand(tree.count(TODO.pattern, comments=True)),
        "defines": per_thousand(tree.count(r"^\s*#\s*define\b")),
        "static_asserts": per_thousand(tree.count(r"\bstatic_assert\b")), "asserts": per_thousand(tree.count(r"\bPT_ASSERT\s*\(")),
    }
    where = {
        "class_functions": most[0], "class_lines": longest[0], "folder_files": folder[0],
        "file_lines_max": max(tree.sources, key=lambda s: len(s.lines)).path if tree.sources else "",
        "function_max": f"{longest_function.path}:{longest_function.first}" if longest_function else "",
        "width_max": widest[0].rpartition(": ")[0] if widest else "",
    }
    return values, where


def good(key, value, wanted):
    return wanted is None or (value >= wanted if key in AT_LEAST else value <= wanted)


def table(values, where):
    width = max(len(key) for key, _, _ in MEASURES)
    for key, wanted, meaning in MEASURES:
        goal = "" if wanted is None else f"{'from' if key in AT_LEAST else 'to'} {wanted:g}"
        mark = " " if good(key, values[key], wanted) else "-"
        print(f"{mark} {key:{width}}  {values[key]:>9,}  {goal:>10}   {meaning}" + (f" ({where[key]})" if where.get(key) else ""))
    print("- is not yet as wanted")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--top", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--find", choices=("orders", "dialects", "old", "long", "wide", "classes"))
    options = parser.parse_args()
    tree = Tree(options.top)
    if options.find == "classes":
        for name, (functions, lines) in sorted(tree.classes().items(), key=lambda c: -c[1][1])[:40]:
            print(f"{functions:5} functions {lines:6} lines  {name}")
        return 0
    if options.find:
        found = getattr(tree, options.find)()
        print("\n".join(found[1] if options.find == "orders" else found))
        return 0
    values, where = figures(tree)
    if options.json:
        print(json.dumps({"figures": values, "where": where}, indent=1))
    else:
        table(values, where)
    return 0


if __name__ == "__main__":
    sys.exit(main())
