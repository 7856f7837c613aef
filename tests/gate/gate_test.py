#!/usr/bin/env python3
"""The gate's own tests: what it must refuse, it refuses."""
import contextlib
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "cases"), str(HERE.parent / "e2e"), str(HERE.parent / "bench")]
import counts  # noqa: E402
import judge  # noqa: E402
import run_bench  # noqa: E402
import seeds  # noqa: E402
import skips  # noqa: E402


class Folder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path


class Counts(Folder):
    def test_fewer_cases_and_a_missing_suite_are_faults_and_more_is_told(self):
        before = {"a": 3, "b": 2, "c": 1}
        faults, news = counts.compared(before, {"a": 2, "c": 2, "d": 4})
        self.assertEqual([line.split(":")[0] for line in faults], ["a", "b"])
        self.assertEqual([line.split(":")[0] for line in news], ["c", "d"])
        self.assertEqual(counts.compared(before, {"a": 3, "c": 1}, without=("b",))[0], [])

    def test_what_is_written_is_read_back(self):
        now = {"test_kernel": 412, "e2e/a_e2e.py": 3}
        self.assertEqual(counts.read(counts.written(now)), now)

    def test_programs_modules_and_goldens_are_counted(self):
        program = self.write("bin/test_one", "#!/bin/sh\nprintf 'Suite.\\n  First\\n  Second  # GetParam() = 1\\n'\n")
        program.chmod(0o755)
        self.write("bin/test_programs.txt", "test_one\ntest_gone\n")
        self.write("tests/e2e/a_e2e.py", "class A:\n    def test_x(self):\n        def test_inner(): pass\n    def helper(self): pass\n    def test_y(self): pass\ndef test_outside(): pass\n")
        self.write("tests/e2e/part.py", "X = 1\n")
        self.write("tests/golden/nct/one/expected.jsonl", "{}\n")
        self.write("tests/golden/nct/topic/two/expected.jsonl", "{}\n")
        self.write("tests/cases/passing.txt", "# list\na/b\n")
        self.assertEqual(counts.counted(self.folder / "bin", self.folder / "tests"),
                         {"test_one": 2, "test_gone": 0, "e2e/a_e2e.py": 2, "golden/nct": 2, "cases": 1})


class Skips(Folder):
    def result(self, *cases):
        return self.write("result.xml", "<testsuite>" + "".join(cases) + "</testsuite>")

    def test_each_single_skip_is_found(self):
        path = self.result(
            '<testcase name="Ring.Holds" status="run"><system-out>[       OK ] Ring.Holds (0 ms)</system-out></testcase>',
            '<testcase name="hmi_Tools" status="run"><system-out>[       OK ] Tools.A (1 ms)\n[  SKIPPED ] Tools.B (2 ms)\n[  PASSED  ] 1 test.\n[  SKIPPED ] 1 test, listed below:\n[  SKIPPED ] Tools.B\n</system-out></testcase>',
            '<testcase name="plc_e2e" status="run"><system-out>test_a (__main__.Plc.test_a) ... ok\ntest_b (__main__.Plc.test_b) ... skipped \'x is not built\'\n\nOK (skipped=1)\n</system-out></testcase>',
            '<testcase name="whole_e2e" status="run"><system-out>Ran 3 tests\nOK (skipped=3)\n</system-out></testcase>',
            '<testcase name="acceptance_cases" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/><system-out>no cases</system-out></testcase>')
        self.assertEqual([name for name, _ in skips.skipped(path)], ["Tools.B", "acceptance_cases", "plc_e2e.test_b", "whole_e2e"])

    def test_one_that_is_not_listed_fails(self):
        path = self.result('<testcase name="A.B" status="notrun"><skipped message="x"/></testcase>')
        ask = lambda text: subprocess.run([sys.executable, skips.__file__, path, "--list", self.write("skips.txt", text)], capture_output=True, text=True)
        self.assertEqual(ask("# nothing\n").returncode, 1)
        self.assertIn("NOT EXPECTED A.B", ask("").stdout)
        self.assertEqual(ask("A.B: needs root\n").returncode, 0)
        self.assertIn("has no reason", ask("A.B:\n").stderr)


class Cases(Folder):
    def judged(self, listed, results, bless):
        self.addCleanup(setattr, judge, "PASSING", judge.PASSING)
        judge.PASSING = self.write("passing.txt", "# list\n" + "".join(f"{name}\n" for name in listed))
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = judge.judge(results, bless)
        return status, [line for line in judge.PASSING.read_text().splitlines() if not line.startswith("#")], said.getvalue()

    def test_blessing_loses_no_case(self):
        status, kept, said = self.judged(["a", "b", "c"], {"a": None, "b": "differs", "d": None}, True)
        self.assertEqual((status, kept), (1, ["a", "b", "c", "d"]))
        self.assertIn("LOST b", said)
        self.assertIn("gone c", said)

    def test_a_case_that_is_gone_fails(self):
        self.assertEqual(self.judged(["a", "b"], {"a": None}, False)[0], 1)
        self.assertEqual(self.judged(["a"], {"a": None, "never": "differs"}, False)[0], 0)


class Benchmarks(unittest.TestCase):
    def test_one_that_gives_up_is_a_fault(self):
        good, bad = {"name": "a", "real_time": 1.5}, {"name": "b", "error_occurred": True, "error_message": "nothing moves"}
        self.assertEqual(run_bench.judged(0, {"benchmarks": [good]}), [])
        self.assertEqual(run_bench.judged(0, {"benchmarks": [good, bad]}), ["b: nothing moves"])
        self.assertEqual(run_bench.judged(0, None), ["it has measured nothing"])
        self.assertEqual(len(run_bench.judged(1, {"benchmarks": [good]})), 1)


class Seeds(unittest.TestCase):
    def test_seeds_of_the_list_belong_to_their_module(self):
        self.assertEqual(seeds.found("a_e2e", ["# a_e2e 1", "a_e2e 5", "b_e2e 6", "a_e2e 7"]), [5, 7])

    def test_fixed_ones_always_and_new_ones_unless_one_is_asked_for(self):
        with contextlib.redirect_stderr(io.StringIO()):
            first, second = (seeds.seeds("no_e2e", "NO_SUCH_SEED", 3, 4, 2) for _ in range(2))
        self.assertEqual(first[:4], [3, 4, 5, 6])
        self.assertNotEqual(first[4:], second[4:])
        os.environ["NO_SUCH_SEED"] = "3"
        self.addCleanup(os.environ.pop, "NO_SUCH_SEED")
        self.assertEqual(seeds.seeds("no_e2e", "NO_SUCH_SEED", 3, 1, 2), [3])

    @unittest.skipUnless(os.environ.get("SEEDS_PROBE"), "runs in ctest")
    def test_a_random_test_runs_again_with_a_new_seed_and_tells_it(self):
        probe = os.environ["SEEDS_PROBE"]
        environment = {name: value for name, value in os.environ.items() if name != "POLYTURN_SEED"}
        run = lambda *words, **more: subprocess.run([probe, *words], capture_output=True, text=True, env=environment | more)
        whole = run()
        self.assertEqual(whole.returncode, 1)
        told = re.search(r"POLYTURN_SEED=(\d+) found a fault", whole.stdout)
        self.assertTrue(told, whole.stdout)
        again = re.search(r"filter=(\S+)", whole.stdout[told.end():]).group(1)
        self.assertEqual(again, "Probe.HoldsAlways:Probe.HoldsForItsFixedSeedAlone")
        self.assertNotEqual(re.search(r"POLYTURN_SEED=(\d+) found", run().stdout).group(1), told.group(1), "a new one each time")
        self.assertEqual(run("--gtest_filter=Probe.HoldsForItsFixedSeedAlone", POLYTURN_SEED=told.group(1)).returncode, 1, "it is repeated")
        self.assertNotIn("once more", run("--gtest_filter=Probe.AsksForNoSeed").stdout)
        one = run("--gtest_filter=Probe.HoldsAlways")
        self.assertEqual(one.returncode, 0)
        self.assertIn("seed=2026", one.stderr + one.stdout)


if __name__ == "__main__":
    unittest.main()
