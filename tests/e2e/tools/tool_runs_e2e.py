#!/usr/bin/env python3
"""Tool management in virtual runs on a kept store: two runs are the same byte for byte, a restart in the middle goes on with the
offset of the sister that works, pieces are counted once."""
import json
import multiprocessing
import shutil
import unittest

from polyturn_runner import LiveCase


def keep_busy():
    while True:
        pass


class ToolRuns(LiveCase):
    language = "nct"
    sets = ["N2900=00000001", "PT_LIFE_END L1=0", "PT_LIFE_END L2=0", "PT_TURRET_TIME L1=0.05", "N2923 L1=31"]

    def do(self, *words, status=0):
        done = self.polyturn(*words, "--instance", self.name)
        self.assertEqual(done.status, status, done.said())
        return done

    def tools(self):
        return {t["tool"]: t for t in json.loads(self.do("tools", "list", "--json").out)["tools"]}

    def all_sets(self):
        return [*self.sets, f"PT_LANGUAGE L1={self.language}"]

    def prepare(self, *operations):
        """A store that holds these tools and nothing else."""
        self.start(*self.all_sets())
        for words in operations:
            self.do(*words.split())
        self.assertEqual(self.stop(), 0)

    def run_copy(self, name, *words):
        store = self.folder / name
        shutil.copytree(self.folder / "store", store)
        sets = [word for one in self.all_sets() for word in ("--set", one)]
        return self.polyturn("run", *words, "--virtual", "--store", store, *sets)

    def test_two_virtual_runs_are_the_same_byte_for_byte(self):
        self.prepare("tools add name=A type=5 h=4 life_kind=uses life=2", "tools add name=B type=5 duplo=2 h=5 life_kind=minutes life=1 warning=0.99", "tools load 1 1 3", "tools load 2 1 7",
                     "tools add name=C type=6 h=2 life_kind=metres life=0.03 warning=0.02", "tools load 3 2 5", "offsets set L1 4 geometry X=40 Z=30", "offsets set L1 5 geometry X=41 Z=31")
        first = self.write("one.nc", "T0531\nG94 G0 X80. Z20.\nG1 Z15. F600.\nT0531\nG1 X90. Z10. F300.\nT0531\nG1 Z0. F900.\nG0 Z50.\nM30\n")
        second = self.write("two.nc", "T0602\nG94 G0 X180. Z20.\nG1 Z-15. F600.\nG1 Z10. F3000.\nM30\n")
        busy = [multiprocessing.Process(target=keep_busy, daemon=True) for _ in range(2)]
        results = []
        for k in range(2):
            for one in busy if k else []:
                one.start()    # another load of the computer must make no other run
            done = self.run_copy(f"copy{k}", f"1={first}", f"2={second}", "--language", "nct", "--trace", f"trace{k}.csv")
            self.assertEqual(done.status, 0, done.said())
            results.append((done.out, (self.folder / f"trace{k}.csv").read_bytes()))
        for one in busy:
            one.kill()
        self.assertEqual(results[0][0], results[1][0])
        self.assertEqual(results[0][1], results[1][1])
        self.assertIn("PT0420", results[0][0])                       # a life ended on the way, and its sister went on
        self.assertGreater(results[0][1].count(b"\n"), 1000)

    def test_a_restart_behind_a_managed_t_goes_on_with_the_sisters_offset(self):
        self.prepare("tools add name=A type=5 h=4 life_kind=uses life=1 counter=1 worn=1", "tools add name=B type=5 duplo=2 h=5", "tools load 1 1 3", "tools load 2 1 7",
                     "offsets set L1 4 geometry X=10 Z=5", "offsets set L1 5 geometry X=40 Z=30")
        program = self.write("part.nc", "N10 T0531\nN20 G94 G0 X80. Z20.\nN30 G1 Z10. F600.\nN40 G1 Z0. F1200.\nN50 G0 Z50.\nN60 M30\n")
        whole = self.run_copy("whole", f"1={program}")
        self.assertEqual(whole.status, 0, whole.said())
        restarted = self.run_copy("restarted", f"1={program}", "--from", "1=N40")
        self.assertEqual(restarted.status, 0, restarted.said())
        self.assertEqual([e["code"] for e in restarted.of("aux", ch=1)].count("T0531"), 1, restarted.said())   # called once, for real

        def behind(done):
            return [(e["line"], e["kind"], e["machine"]) for e in done.of("move", ch=1) if e["line"] >= 5]
        self.assertEqual(behind(restarted), behind(whole))
        self.assertEqual(behind(whole)[-1][2], {"X": 60, "Z": 80, "C": 0})
        begins = [e for e in restarted.of("move", ch=1) if e["line"] == 4]
        self.assertEqual(begins[-1]["machine"]["Z"], 30)              # 0 + 30

    def test_a_restart_whose_tools_are_used_up_says_so_before_anything_moves(self):
        self.prepare("tools add name=A type=5 h=4 worn=1", "tools load 1 1 3")
        program = self.write("part.nc", "N10 T0531\nN20 G94 G0 X80. Z20.\nN40 G1 Z0. F1200.\nN60 M30\n")
        done = self.run_copy("none", f"1={program}", "--from", "1=N40")
        self.assertEqual(done.status, 1, done.said())
        self.assertEqual([e["number"] for e in done.alarms][:1], ["PT0418"], done.said())
        self.assertEqual(done.of("move"), [])


    def test_the_turret_turns_while_the_rapid_move_brakes(self):
        """N0421 ROL with the built-in PLC, with and without tool management; protection off."""
        self.prepare("tools add name=A type=5 h=4", "tools load 1 1 3")
        program = self.write("part.nc", "G94 G0 X100. Z0.\nG0 X300. Z200.\nT0501\nG0 Z100.\nM30\n")
        sets, given = list(self.sets), {}
        for managed in (True, False):
            for overlaps in (True, False):
                self.sets = [one for one in sets if managed or not one.startswith("N2900")] + (["N0421#0 L1=1", "N0422 A1=100", "N0422 A2=100"] if overlaps else [])
                done = self.run_copy(f"store{managed}{overlaps}", f"1={program}")
                self.assertEqual(done.status, 0, done.said())
                self.assertEqual(done.alarms, [])
                retracts = done.of("move", ch=1, line=2)[0]
                given[managed, overlaps] = retracts["end"] - done.of("aux", ch=1)[0]["t"]
        for managed in (True, False):
            self.assertGreater(given[managed, True], 0.02, given)      # seconds before the end of the retraction
            self.assertLessEqual(given[managed, False], 1e-6, given)


class SinumerikRuns(ToolRuns):
    language = "sinumerik"
    sets = ["N2900=00000001", "PT_LIFE_END L1=0", "PT_TURRET_TIME L1=0.05", "PT_TOOL_SEARCH L1=2"]
    test_two_virtual_runs_are_the_same_byte_for_byte = test_a_restart_whose_tools_are_used_up_says_so_before_anything_moves = test_the_turret_turns_while_the_rapid_move_brakes = None

    def test_a_restart_behind_a_managed_t_goes_on_with_the_sisters_offset(self):
        self.prepare("tools add name=CUT duplo=1 worn=1 D1.DP1=500 D1.DP2=3 D1.DP4=10", "tools add name=CUT duplo=2 D1.DP1=500 D1.DP2=3 D1.DP4=30", "tools load 1 1 3", "tools load 2 1 7")
        program = self.write("part.mpf", 'N10 G18 T="CUT" D1\nN20 G0 X80 Z20\nN30 G1 Z10 F600\nN40 G1 Z0\nN50 G0 Z50\nN60 M30\n')
        whole = self.run_copy("whole", f"1={program}")
        self.assertEqual(whole.status, 0, whole.said())
        done = self.run_copy("restarted", f"1={program}", "--from", "1=N40")
        self.assertEqual(done.status, 0, done.said())
        for one in (whole, done):
            self.assertEqual([e["machine"]["Z"] for e in one.of("move", ch=1) if e["line"] >= 4][-2:], [30, 80], one.said())

    def test_setpiece_counts_and_the_end_of_the_part_does_not_count_again(self):
        self.prepare("tools add name=A life_kind=pieces life=100 D1.DP1=500 D1.DP2=3", "tools add name=B life_kind=pieces life=100 D1.DP1=500 D1.DP2=3", "tools load 1 1 3", "tools load 2 1 7")
        program = self.write("part.mpf", 'G18 T="A" D1\nG94 G0 X80 Z20\nG1 Z10 F600\nSETPIECE(3)\nT="B" D1\nG1 Z5\nM30\n')
        shutil.rmtree(self.folder / "kept", ignore_errors=True)
        done = self.run_copy("kept", f"1={program}")
        self.assertEqual(done.status, 0, done.said())
        shutil.rmtree(self.folder / "store")
        shutil.copytree(self.folder / "kept", self.folder / "store")
        self.start(*self.all_sets())
        tools = self.tools()
        self.assertEqual((tools[1]["counter"], tools[2]["counter"]), (3, 1))
        self.assertEqual(self.stop(), 0)


class FagorRuns(ToolRuns):
    """TOFFM06: T chooses, M06 changes; with tool management the family's sister, and her offset from M06 on."""
    language = "fagor"
    sets = ["N2900=00000001", "PT_LIFE_END L1=0", "PT_TURRET_TIME L1=0.05", "FG.TOFFM06 L1=1"]
    test_two_virtual_runs_are_the_same_byte_for_byte = test_a_restart_whose_tools_are_used_up_says_so_before_anything_moves = test_the_turret_turns_while_the_rapid_move_brakes = None
    test_a_restart_behind_a_managed_t_goes_on_with_the_sisters_offset = None

    def test_the_sister_and_her_offset_hold_from_m06_on(self):
        self.prepare("tools add name=F1 type=5 h=4 worn=1", "tools add name=F2 type=5 h=8", "tools load 1 1 3", "tools load 2 1 7", "offsets set L1 4 geometry X=10 Z=5", "offsets set L1 8 geometry X=40 Z=30",
                     "offsets set L1 9 geometry X=50 Z=35")
        program = self.write("part.pit", "G90 G94 G152\nG0 X10 Z10\nT1\n(P100=NXTOOL,P101=TOOL)\nX20 Z20\nM06\n(P102=TOOL,P103=TOD)\nX30 Z30\nT1 D9 M06\nX40 Z40\nM30\n")
        done = self.run_copy("kept", f"1={program}", "--variables")
        self.assertEqual(done.status, 0, done.said())
        moves = {e["line"]: e["machine"]["Z"] for e in done.of("move", ch=1)}
        self.assertEqual([moves[k] for k in (2, 5, 8, 10)], [10, 20, 60, 75], done.said())
        values = {e["name"]: e["value"] for e in done.of("variable", ch=1)}
        self.assertEqual([values[p] for p in ("P100", "P102", "P103")], [1, 2, 8], done.said())


if __name__ == "__main__":
    unittest.main(verbosity=2)
