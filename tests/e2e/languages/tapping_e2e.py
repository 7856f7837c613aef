#!/usr/bin/env python3
"""Taps as they run: a rigid one keeps the angle of its spindle at every tick on every shipped machine and in every language, one that
cannot be rigid is refused by name, and a floating one asks of its holder only what the spindle's own ramps cost."""
import unittest

from polyturn_runner import SOURCE, Case, read_trace

MACHINES = sorted(p.name for p in (SOURCE / "examples/machines").iterdir() if (p / "machine.params").exists())
SETUP = "[channel.1]\npos = { X = 0.0, Z = 10.0 }\n"
LEAD = 1.0
# Language, program; F and S make 1 mm a revolution, 8 mm deep.
RIGID = {
    "M29, G84": ("fanuc", "O1\nG98 G18 G97\nG0 X0 Z5.\nM29 S500\nG84 Z-6. R-3. F500\nG80\nM30\n", ()),
    "M29 behind M3": ("fanuc", "O1\nG98 G18 G97 S500 M3\nG0 X0 Z5.\nM29 S500\nG84 Z-6. R-3. F500\nG80\nM30\n", ()),
    "F5200#0": ("fanuc", "O1\nG98 G18 G97 S500\nG0 X0 Z5.\nG84 Z-6. R-3. F500\nG80\nM30\n", ("F5200#0=1",)),
    "series 15, G84.2": ("fanuc", "O1\nG98 G18 G97 S500\nG0 X0 Z5.\nG84.2 Z-6. R-3. F500\nG80\nM30\n", ("F0001#1=1",)),
    "nct, G84.2": ("nct", "G95 G18 G90 G97 S500\nG0 X0 Z5\nG84.2 Z-6 R2 F1\nG80\nM30\n", ()),
    "nct, G84.3": ("nct", "G94 G18 G90 G97 S500\nG0 X0 Z5\nG84.3 Z-6 R2 F500\nG80\nM30\n", ()),
    "nct, oriented": ("nct", "G95 G18 G90 G97 S500\nG0 X0 Z5\nG84.2 Z-6 R2 F1\nG80\nM30\n", ("N1503#1=1",)),
    "sinumerik, G331": ("sinumerik", "G18 G90\nSPOS=0\nG0 X0 Z2\nG331 Z-6 K1 S500\nG332 Z2 K1\nM5\nM30\n", ()),
    "fagor, R1": ("fagor", "G94 G97 S500 F500 M3\nG0 X0 Z5\nG83 X0 Z0 I6 B0 D2 R1\nM30\n", ()),
    "fagor, R2": ("fagor", "G94 G97 S500 F500 M3\nG0 X0 Z5\nG83 X0 Z0 I6 B0 D2 R2\nM30\n", ()),
}
FLOATING = {
    "fanuc, per minute": ("fanuc", "O1\nG98 G18 G97 S500 M3\nG0 X0 Z5.\nG84 Z-6. R-3. F500\nG80\nM30\n", ()),
    "fanuc, per turn": ("fanuc", "O1\nG99 G18 G97 S500 M3\nG0 X0 Z5.\nG84 Z-6. R-3. F1.\nG80\nM30\n", ()),
    "nct": ("nct", "G94 G18 G90 G97 S500 M3\nG0 X0 Z5\nG84 Z-6 R2 F500\nG80\nM30\n", ()),
    "fagor, R0": ("fagor", "G94 G97 S500 F500 M3\nG0 X0 Z5\nG83 X0 Z0 I6 B0 D2 R0\nM30\n", ()),
}


class Tapping(Case):
    def run_it(self, language, program, sets=(), machine=None):
        words = [word for one in sets for word in ("--set", one)]
        if machine:
            words += ["--machine", SOURCE / "examples/machines" / machine]
        return self.polyturn("run", "--virtual", "--language", f"1={language}", "--setup", self.write("setup.toml", SETUP), "--trace", self.folder / "trace.csv", *words,
                             self.write("P0001.nc", program))

    def stretch(self, done):
        """Of the thread, from its first tick to its last: (t, Z, revolutions of the spindle since); A2 is Z of L1 on every shipped machine."""
        taps = [e for e in done.of("move", ch=1) if e["kind"] in ("linear", "thread")]
        self.assertGreaterEqual(len(taps), 2, done.said())
        trace = read_trace(self.folder / "trace.csv")
        found, turned, before = [], 0.0, None
        for t, z, angle in zip(trace["t"], trace["A2.act"], trace["S1.angle"]):
            if before is not None:
                turned += (angle - before + 180.0) % 360.0 - 180.0
            before = angle
            if taps[0]["t"] - 0.002 <= t <= taps[-1]["end"] + 0.002:
                found.append((t, z, turned / 360.0))
        return found

    def test_a_rigid_tap_keeps_the_angle_at_every_tick(self):
        for name, (language, program, sets) in RIGID.items():
            with self.subTest(name):
                done = self.run_it(language, program, sets)
                self.assertEqual(done.status, 0, done.said())
                thread = self.stretch(done)
                _, z0, turned0 = thread[0]
                hand = -1.0 if "G84.3" in name else 1.0
                off = [abs((z0 - z) / LEAD - hand * (turned - turned0)) for _, z, turned in thread]
                self.assertGreater(max(abs(turned - turned0) for _, _, turned in thread), 7.5, "it turns along")
                self.assertLess(max(off), 0.02, f"revolutions beside the thread, at {thread[off.index(max(off))][0]} s\n" + done.said()[-400:])

    def test_every_shipped_machine_taps_rigidly(self):
        program = RIGID["M29, G84"][1].replace("500", "200")
        for machine in MACHINES:
            with self.subTest(machine):
                done = self.run_it("fanuc", program, machine=machine)
                self.assertEqual(done.status, 0, done.said())
                thread = self.stretch(done)
                off = [abs((thread[0][1] - z) / LEAD - (turned - thread[0][2])) for _, z, turned in thread]
                self.assertGreater(max(abs(turned - thread[0][2]) for _, _, turned in thread), 7.5, "it turns along")
                self.assertLess(max(off), 0.02, done.said()[-400:])

    def test_what_cannot_be_rigid_is_refused_by_name(self):
        cannot = {"no code and no M19": ("N0823 S1=0",), "no loop": ("N0607 S1=00000001",), "no encoder": ("N0608 S1=0",), "loop stays open": ("N0742#7 S1=1",)}
        for name, (language, program, sets) in RIGID.items():
            for why, how in cannot.items():
                if why == "no code and no M19" and name in ("nct, oriented", "sinumerik, G331", "fagor, R1"):
                    continue   # these orient
                for verb in ("check", "run"):
                    with self.subTest(f"{name}: {why}, {verb}"):
                        words = [word for one in (*sets, *how) for word in ("--set", one)]
                        done = self.polyturn(verb, *(("--virtual",) if verb == "run" else ()), "--language", f"1={language}", "--setup", self.write("setup.toml", SETUP), *words,
                                             self.write("P0001.nc", program))
                        self.assertEqual(done.status, 1, done.said())
                        told = done.alarms   # on the machine M29 and SPOS may be refused before the tap is
                        self.assertTrue(told, done.said())
                        if verb == "check":
                            self.assertIn("tapping", told[0]["text"])
                            self.assertIn("S1", told[0]["text"])
                        self.assertFalse([e for e in done.of("move") if e["kind"] in ("linear", "thread")], "nothing has cut\n" + done.said())

    def test_a_floating_holder_gives_no_more_than_the_spindles_ramps(self):
        # From 500 1/min to the other way round, 1500 1/min a second: the tap runs on by 1.39 turns, and the ramp back takes them out
        # again while Z stands.
        for name, (language, program, sets) in FLOATING.items():
            with self.subTest(name):
                done = self.run_it(language, program, sets)
                self.assertEqual(done.status, 0, done.said())
                thread = self.stretch(done)
                _, z0, turned0 = thread[0]
                off = [(z0 - z) / LEAD - (turned - turned0) for _, z, turned in thread]
                self.assertLess(max(off), 0.4, "Z never runs ahead of the tap\n" + done.said()[-400:])
                self.assertGreater(min(off), -2.0, done.said()[-400:])
                bottom = min(z for _, z, _ in thread)
                out = [o for (t, z, _), o in zip(thread, off) if z > bottom + 0.5 and t > [t for t, z, _ in thread if z < bottom + 0.01][-1]]
                self.assertLess(max(abs(o) for o in out), 0.7, "on the way out the holder is back in its middle")

    def test_a_floating_tap_keeps_its_pitch_when_the_spindle_is_slower_than_its_word(self):
        language, program, _ = FLOATING["fanuc, per minute"]
        done = self.run_it(language, program, ("N0650 S1=400",))   # S500 asked for, 400 given
        self.assertEqual(done.status, 0, done.said())
        thread = self.stretch(done)
        off = [abs((thread[0][1] - z) / LEAD - (turned - thread[0][2])) for _, z, turned in thread]
        self.assertLess(max(off), 2.0, done.said()[-400:])


if __name__ == "__main__":
    unittest.main()
