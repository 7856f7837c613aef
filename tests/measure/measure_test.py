#!/usr/bin/env python3
"""The measures on small trees whose figures can be counted by hand."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import measure  # noqa: E402
from source_text import Source  # noqa: E402


class Trees(unittest.TestCase):
    def figures(self, files):
        with tempfile.TemporaryDirectory() as top:
            for name, text in files.items():
                path = pathlib.Path(top) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            self.tree = measure.Tree(top)
            values, self.where = measure.figures(self.tree)
            return values

    def test_every_measure_has_a_figure_and_a_sentence(self):
        values = self.figures({"a/x.cpp": "int f() { return 1; }\n"})
        self.assertEqual(set(values), {key for key, _, _ in measure.MEASURES})
        self.assertTrue(all(meaning for _, _, meaning in measure.MEASURES))

    def test_an_empty_tree_is_measured_without_a_fault(self):
        self.assertEqual(self.figures({})["lines"], 0)

    def test_production_is_what_is_not_test_example_or_build(self):
        line = "int x;\n"
        values = self.figures({"kernel/a.cpp": line, "kernel/b.hpp": line, "kernel/c.c": line, "kernel/README.md": line, "tests/unit/a_test.cpp": line,
                               "examples/plc/a.c": line, "build/test/a.cpp": line, "docs/a.cpp": line})
        self.assertEqual((values["files"], values["lines"]), (3, 3))

    def test_the_largest_folder_is_counted_without_its_subfolders(self):
        values = self.figures({f"a/{n}.cpp": "\n" for n in range(3)} | {f"a/b/{n}.cpp": "\n" for n in range(5)} | {"a/README.md": "\n"})
        self.assertEqual((values["folder_files"], self.where["folder_files"]), (5, "a/b"))

    def test_functions_of_a_class_are_gathered_from_all_its_files(self):
        head = "namespace p::k {\nclass Machine : public Base {\npublic:\n    Machine() : a_{1}, b_(2) {}\n    int small() const { return 1; }\n    void tick();\nprivate:\n    struct Inner {\n" \
               "        int one() { return 1; }\n    };\n    int a_ = 0, b_{3};\n};\n}\n"
        body = "namespace p::k {\nvoid Machine::tick() {\n    if (a_) {\n        b_ = 1;\n    }\n}\n\nint free_one(int a) {\n    auto f = [&](int b) { return a + b; };\n    return f(1);\n}\n}\n"
        other = "namespace p::q {\nvoid Machine::tick() {}\n}\n"
        values = self.figures({"k/machine.hpp": head, "k/tick.cpp": body, "q/machine.cpp": other})
        self.assertEqual(self.tree.classes()["p::k::Machine"], [3, 7])   # another Machine in another namespace is another class
        self.assertEqual(self.tree.classes()["p::k::Machine::Inner"], [1, 1])
        self.assertEqual((values["class_functions"], values["class_lines"]), (3, 7))
        self.assertEqual(self.where["class_functions"], "p::k::Machine")

    def test_the_lines_of_functions(self):
        values = self.figures({"a.cpp": "int a() {\n    return 1;\n}\nstatic int b(int x,\n             int y)\n    noexcept {\n    return x + y;\n}\n"
                                        "template <class T>\nT c(T t) { return t; }\nbool operator==(A l, A r) { return l.x == r.x; }\n"})
        self.assertEqual(sorted(f.lines for f in self.tree.functions), [1, 2, 3, 5])
        self.assertEqual((values["function_max"], self.where["function_max"]), (5, "a.cpp:4"))

    def test_what_is_no_function(self):
        self.figures({"a.cpp": "enum class E { A, B };\nconst int kRows[] = {1, 2};\nstruct S { int x; };\nS make{4};\nconst auto kCall = [](int a) { return a; };\n"
                               "#define LOOP(x) {\nint f(int a) {\n    for (int i = 0; i < a; ++i) {\n    }\n    return S{1}.x;\n}\n"})
        self.assertEqual([f.name for f in self.tree.functions], ["f"])

    def test_brackets_in_text_and_comments_are_none(self):
        self.figures({"a.cpp": "// }\nint a() {\n    const char* t = \"} // {\";\n    char c = '}';   /* } */\n    long n = 1'000'000;\n    auto r = R\"({\n\" }})\";\n    return 0;\n}\nint b() { return 1; }\n"})
        self.assertEqual([(f.name, f.lines) for f in self.tree.functions], [("a", 8), ("b", 1)])

    def test_widths_are_characters(self):
        values = self.figures({"a.cpp": "// " + "ä" * 50 + "\n" + "x;\n" * 99})
        self.assertEqual((values["width_max"], values["width_p99"]), (53, 53))
        self.assertEqual(self.figures({"a.cpp": "// " + "ä" * 50 + "\n" + "xy;\n" * 200})["width_p99"], 3)

    def test_comments_count_alone_and_behind_code(self):
        values = self.figures({"a.cpp": "// one\nint a;   // two\n\n/* three\n   four */\nconst char* t = \"// none\";\nint b;\nint c;\nint d;\nint e;\n"})
        self.assertEqual(values["comment_share"], 40.0)

    def test_a_memory_order_needs_a_reason_within_three_lines(self):
        near = "// P1: what was written before is seen by the reader\nint x;\nint y;\na.store(1, std::memory_order_release);\n"
        far = "int p;\nint q;\nint r;\nb.load(std::memory_order_acquire);\n"
        bare = "c.load(std::memory_order_relaxed);   // why\n"
        values = self.figures({"a.cpp": near, "b.cpp": far, "c.cpp": bare, "d.cpp": "// std::memory_order_release is not asked here\n"})
        self.assertEqual((values["orders"], values["orders_reasoned"]), (3, 33.3))
        self.assertEqual([place.split(":")[0] for place in self.tree.orders()[1]], ["b.cpp", "c.cpp"])

    def test_places_that_name_a_control_outside_its_folder(self):
        values = self.figures({"channels/fanuc/a.cpp": "bool a() { return d == Dialect::Fanuc; }\nbool b() { return settings_.nct || s->mefi; }\n",
                               "kernel/a.cpp": "bool a() { return speaks() == Dialect::Fagor; }   // Dialect::Nct\nbool p() { return d == Dialect::Polyturn; }\n",
                               "channels/nct/a.cpp": "Dialect d = Dialect::Nct;\n"})
        self.assertEqual(values["dialect_places"], 2)
        self.assertEqual([place.rsplit(": ")[0] for place in self.tree.dialects()], ["channels/fanuc/a.cpp:2", "kernel/a.cpp:1"])

    def test_repeated_runs_of_eight_lines(self):
        run = "".join(f"call_{n}(a, b);\n" for n in range(8))
        values = self.figures({"a.cpp": run + "other();\n", "b.cpp": "first();\n" + run.replace("(a, b);", "( a,b );   // said otherwise")})
        self.assertEqual(values["duplicates_share"], round(800 / 18, 2))
        self.assertEqual(self.figures({"a.cpp": run.replace("call_7", "call_8"), "b.cpp": run})["duplicates_share"], 0)

    def test_code_that_was_put_aside(self):
        values = self.figures({"a.cpp": "// x = 1;\n// if (a) {\n// return x;\n// run(a, b);\n// the axis stands (see G4); then it moves\n// a word.\n" + "int x;\n" * 994})
        self.assertEqual(values["old_code"], 4.0)

    def test_what_is_counted_by_word(self):
        values = self.figures({"a.cpp": "#define A 1\n# define B 2\nstatic_assert(true);\nPT_ASSERT(I1, x > 0);\n// TODO: later\n// static_assert would do\n" + "int x;\n" * 994})
        self.assertEqual((values["defines"], values["static_asserts"], values["asserts"], values["todo"]), (2, 1, 1, 1))

    def test_lines_of_tests_for_each_line(self):
        values = self.figures({"a.cpp": "int x;\n" * 10, "tests/a_test.cpp": "int y;\n" * 3, "tests/e2e/a.py": "a\n" * 2,
                               "tests/golden/fanuc/x/program.nc": "G1\n" * 2, "tests/golden/fanuc/x/expected.jsonl": "{}\n" * 50})
        self.assertEqual(values["test_lines_share"], 0.7)

    def test_where_more_is_better_the_table_knows_it(self):
        self.assertTrue(measure.good("comment_share", 21, 20) and not measure.good("comment_share", 19, 20))
        self.assertTrue(measure.good("width_max", 109, 110) and not measure.good("width_max", 111, 110))


class Program(unittest.TestCase):
    def test_the_table_and_the_object_tell_the_same(self):
        with tempfile.TemporaryDirectory() as top:
            (pathlib.Path(top) / "a.cpp").write_text("int f() { return 1; }\n")
            ask = lambda *words: subprocess.run([sys.executable, measure.__file__, "--top", top, *words], capture_output=True, text=True, check=True).stdout
            told = json.loads(ask("--json"))["figures"]
            rows = [line[2:].split() for line in ask().splitlines()[:-1]]
            self.assertEqual({row[0]: float(row[1].replace(",", "")) for row in rows}, {key: float(value) for key, value in told.items()})

    def test_lines_of_a_source_end_where_the_file_ends(self):
        self.assertEqual(len(Source("a", "a\nb\n").lines), 2)
        self.assertEqual(len(Source("a", "a\nb").lines), 2)


if __name__ == "__main__":
    unittest.main()
