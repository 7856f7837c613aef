#!/usr/bin/env python3
"""A contradiction in the configuration is an alarm without `ch`, nothing runs, and the exit status is 1 (cli.md 3, 10); what is stored and
acts on nothing is one warning, and the shipped machines have neither."""
import unittest

from polyturn_runner import SOURCE, Case

MACHINES = sorted(p.name for p in (SOURCE / "examples/machines").iterdir() if (p / "machine.params").exists())
CONTRADICTIONS = {
    "two axes X": ("N0103 A2=1",),
    "no such spindle": ("N0604 L2=7",),
    "an angular axis at 0 degrees": ("F8200#0 L1=1",),
    "an angular axis at 90 degrees": ("F8200#0 L1=1", "F8210 L1=90"),
    "an angular axis of the other channel": ("F8200#0 L2=1", "F8210 L2=-90"),
    "an inclined slide in balance": ("F8200#0 L1=1", "F8210 L1=30", "PT_BALANCE L1=2", "PT_BALANCE L2=1"),
    "a direct measuring device that is not virtual": ("N0002 A7=99", "N0534 A1=7"),
}


class Contradictions(Case):
    def run_it(self, verb, sets, *more):
        words = [word for one in sets for word in ("--set", one)]
        return self.polyturn(verb, *(("--virtual",) if verb == "run" else ()), *words, *more, self.write("O0001.nc", "O1\nG0 X40.\nM30\n"))

    def test_each_is_an_alarm_without_a_channel_and_nothing_runs(self):
        for name, sets in CONTRADICTIONS.items():
            for verb in ("check", "run"):
                with self.subTest(f"{verb}: {name}"):
                    done = self.run_it(verb, sets)
                    self.assertEqual(done.status, 1, done.said())
                    self.assertEqual(len(done.alarms), 1, done.said())
                    self.assertNotIn("ch", done.alarms[0])
                    self.assertFalse(done.of("move"), "nothing runs")

    def test_what_has_no_effect_warns_and_runs(self):
        for line in ("N1402#1 L1=1", "N1755#4 L1=1", "N1758#5 L1=1", "N1800#2 L1=1", "N3103 L1=0.01", "F1008#2 A5=1"):
            for verb in ("check", "run"):
                with self.subTest(f"{verb}: {line}"):
                    done = self.run_it(verb, (line,))
                    self.assertEqual(done.status, 0, done.said())
                    self.assertIn("nothing acts on it", done.out + done.err)

    def test_the_shipped_machines_have_none(self):
        for machine in MACHINES:
            with self.subTest(machine):
                done = self.run_it("check", (), "--language", "fanuc", "--machine", SOURCE / "examples/machines" / machine)
                self.assertEqual(done.status, 0, done.said())
                self.assertNotIn("nothing acts on it", done.out + done.err)

    # N0307 and N0308 act where N0306 FDF is 0, N0310 where an axis' N0400 is softer than its N0402: then they change how long a part takes.
    def test_what_says_that_it_acts_changes_the_time(self):
        corner = "O1\nG98\nG0 X40. Z0.\nG1 Z-20. F3000\nX54. Z-40.\nZ-60.\nM30\n"
        arc = "O1\nG98\nG0 X40. Z0.\nG1 Z-10. F6000\nG3 X60. Z-20. R10.\nG1 Z-40.\nM30\n"
        soft = ("N0400 A1=100", "N0400 A2=100")
        for name, program, common, one, other in (("N0306", corner, (), "N0306 L1=0", "N0306 L1=1"), ("N0307", corner, ("N0306 L1=0",), "N0307 L1=15", "N0307 L1=120"),
                                                  ("N0308", corner, ("N0306 L1=0",), "N0308 L1=300", "N0308 L1=3000"), ("N0310", arc, soft, "N0310 L1=10", "N0310 L1=6000")):
            with self.subTest(name):
                took = []
                for value in (one, other):
                    words = [word for line in (*common, value) for word in ("--set", line)]
                    done = self.polyturn("run", "--virtual", *words, self.write("O0002.nc", program))
                    self.assertEqual(done.status, 0, done.said())
                    took.append(done.of("summary")[0]["seconds"])
                self.assertNotEqual(*took)


if __name__ == "__main__":
    unittest.main()
