#!/usr/bin/env python3
"""Tool management on a controller that runs: T calls answered by the store, sisters, life, outlines, the tool setter, offsets of the
managed tool, life groups. In real time, so times are generous; what is exact is tested in virtual time (tests/unit/kernel)."""
import json
import signal
import time
import unittest

from polyturn_runner import LiveCase


class Tools(LiveCase):
    language = "nct"

    def start(self, *sets):
        super().start("N2900=00000001", f"PT_LANGUAGE L1={self.language}", "PT_TURRET_TIME L1=0.05", *sets)

    def do(self, *words, status=0):
        done = self.polyturn(*words, "--instance", self.name)
        self.assertEqual(done.status, status, done.said())
        return done

    def ask(self, *words):
        return json.loads(self.do(*words, "--json").out)

    def channel(self, number=1):
        return next(c for c in self.ask("status")["channels"] if c["ch"] == number)

    def cycle(self, program, ends="ended", seconds=20):
        """Selects, starts, waits for the end; what the channel says then."""
        path = self.write("part.nc", program)
        self.do("press", "reset", "L1")
        self.do("press", "select", f"L1={path}")
        self.do("press", "cycle_start", "L1")
        time.sleep(0.1)
        self.wait_for(lambda: self.channel()["state"] in ("ended", "interrupted", "held"), seconds, "the program's end")
        self.assertEqual(self.channel()["state"], ends, self.polyturn("alarms", "--instance", self.name).out)
        return self.channel()

    def tool(self, number):
        return next(t for t in self.ask("tools", "list")["tools"] if t["tool"] == number)

    def alarms(self):
        return self.polyturn("alarms", "--instance", self.name).out

    def test_the_next_sister_works_when_one_is_used_up(self):
        self.start("PT_LIFE_END L1=0")
        self.do("press", "machine_on")
        for pot in (3, 7):
            self.do("tools", "add", f"name=R{pot}", "type=5", f"duplo={pot}", f"h={pot}", "life_kind=uses", "life=1")
        self.do("tools", "load", "1", "1", "3")
        self.do("tools", "load", "2", "1", "7")
        program = "T0501\nG94 G0 X80. Z20.\nM30\n"
        self.assertEqual(self.cycle(program)["tool"], 1)
        self.wait_for(lambda: self.tool(1)["worn"], 3, "the life to be counted")
        self.assertEqual(self.cycle(program)["tool"], 2)
        self.cycle(program, ends="interrupted")
        self.assertIn("PT0418", self.alarms())
        self.do("tools", "life", "reset", "1")
        self.assertEqual(self.cycle(program)["tool"], 1)
        self.assertEqual(self.stop(), 0)

    def test_the_offset_of_the_managed_tool_is_that_of_the_sister(self):
        self.start("N2923 L1=31")
        self.do("press", "machine_on")
        self.do("tools", "add", "name=A", "type=5", "h=4")
        self.do("tools", "load", "1", "1", "3")
        self.do("offsets", "set", "L1", "4", "geometry", "X=40", "Z=30")
        here = self.cycle("T0531\nG94 G0 X80. Z20.\nM30\n")
        self.assertEqual((here["tool"], here["tool_offset"]), (1, 4))
        axes = {a["axis"]: a for a in self.ask("status")["axes"]}
        self.assertAlmostEqual(axes["A1"]["cmd"], 60, places=6)     # (80 + 40) / 2
        self.assertAlmostEqual(axes["A2"]["cmd"], 50, places=6)
        self.assertEqual(self.stop(), 0)

    def test_the_sister_is_asked_for_also_while_the_radius_is_compensated(self):
        self.start("N2923 L1=31")
        self.do("press", "machine_on")
        for number, (kind, cell, pot) in enumerate(((5, 4, 3), (6, 8, 7)), 1):
            self.do("tools", "add", f"name=T{kind}", f"type={kind}", f"h={cell}")
            self.do("tools", "load", number, "1", pot)
            self.do("offsets", "set", "L1", cell, "geometry", f"Z={30 * number}", "R=0.4")
        here = self.cycle("T0531\nG94 G0 X100. Z20.\nG42 G1 X90. Z0. F4000.\nZ-5.\nT0631\nZ-10.\nX95.\nG40 X100. Z-10.\nM30\n")
        self.assertEqual((here["tool"], here["tool_offset"]), (2, 8))
        z = next(a for a in self.ask("status")["axes"] if a["axis"] == "A2")["cmd"]
        self.assertAlmostEqual(z, -10 + 60, places=6)
        self.assertEqual(self.stop(), 0)

    def test_life_is_counted_only_while_the_tool_cuts_and_survives(self):
        self.start("PT_LIFE_END L1=0")
        self.do("press", "machine_on")
        self.do("tools", "add", "name=A", "type=5", "h=4", "life_kind=minutes", "life=10")
        self.do("tools", "load", "1", "1", "3")
        self.cycle("T0504\nG94 G0 X80. Z20.\nG1 Z10. F600.\nG4 P1\nG0 Z60.\nM30\n")   # 10 mm at 10 mm/s
        self.wait_for(lambda: self.tool(1)["counter"] > 0, 3, "the life to be counted")
        self.assertAlmostEqual(self.tool(1)["counter"] * 60, 1.05, delta=0.15)
        counted = self.tool(1)["counter"]
        time.sleep(0.3)
        self.stop(signal.SIGKILL)
        time.sleep(0.3)
        self.start()
        self.assertAlmostEqual(self.tool(1)["counter"], counted, places=9)
        self.assertEqual(self.stop(), 0)

    def by_hand(self, channel, block):
        self.do("press", "mode", channel + "=mdi")
        self.do("press", "mdi", channel, block)
        self.do("press", "cycle_start", channel)

    def test_a_place_is_called_with_the_code_of_n2924(self):
        self.start("N2924 L1=66")
        self.do("press", "machine_on")
        self.do("tools", "add", "name=A", "type=5")
        self.do("tools", "load", "1", "1", "9")
        self.assertEqual(self.cycle("M66 T00010009\nM30\n")["tool"], 1)
        self.cycle("M66 T00010013\nM30\n", ends="interrupted")
        self.assertIn("PT0412", self.alarms())
        self.assertEqual(self.stop(), 0)

    def test_a_longer_drill_makes_a_safe_program_stop(self):
        self.start("N2000 L1=00001111", "N2000 L2=00001111")
        self.do("press", "machine_on")
        self.do("tools", "add", "name=DRILL", "type=5", "h=4", "outline=X -60:0 Z -5:5")
        self.do("tools", "load", "1", "1", "3")
        self.by_hand("L2", "G0 X200. Z0.")       # the other turret stands below the bar
        self.wait_for(lambda: self.channel(2)["state"] == "ended", 10, "the other turret")
        program = "T0504\nG94 G0 X200. Z50.\nG1 Z0. F6000.\nG0 Z50.\nM30\n"
        self.cycle(program)
        self.do("tools", "set", "1", "outline=X -250:0 Z -5:5")    # it reaches over to the other turret now
        self.cycle(program, ends="interrupted")
        z = next(a for a in self.ask("status")["axes"] if a["axis"] == "A2")["cmd"]
        self.assertGreater(z, 5.0)      # it has stopped before it touched
        self.do("tools", "set", "1", "outline=X -60:0 Z -5:5")
        self.cycle(program)
        self.assertEqual(self.stop(), 0)

    def test_the_setter_gives_the_offset_after_a_look_at_it(self):
        self.start("N3012 L1=5", "N0209 L1=12.5", "N0319 L1=600")
        self.do("press", "machine_on")
        self.do("press", "mode", "L1=jog")
        self.do("set", "CP_TMEAS L1=1")
        refused = self.do("offsets", "touch", "L1", "4", status=2)
        self.assertIn("PT0425", refused.err)
        before = next(a for a in self.ask("status")["axes"] if a["axis"] == "A2")["cmd"]
        self.do("press", "jog", "A2-", "0.4s")
        time.sleep(0.15)
        self.do("set", "input 5=1")
        self.wait_for(lambda: "touched" in self.channel(), 5, "the contact")
        self.assertEqual(self.channel()["touched"], "A2-")
        shown = self.ask("offsets", "touch", "L1", "4")
        self.assertAlmostEqual(shown["new"], shown["machine"] - 12.5, places=6)
        self.assertLess(shown["machine"], before)
        self.assertEqual(self.ask("offsets", "list", "L1")["offsets"][3]["geometry"]["Z"], 0)    # only shown
        self.do("offsets", "touch", "L1", "4", "--yes")
        self.assertAlmostEqual(self.ask("offsets", "list", "L1")["offsets"][3]["geometry"]["Z"], shown["new"], places=6)
        self.assertEqual(self.stop(), 0)


    def test_the_workpiece_setter_gives_the_zero_after_a_look_at_it(self):
        self.start("N3014 L1=6", "N0319 L1=600")
        self.do("press", "machine_on")
        self.do("press", "mode", "L1=jog")
        self.do("set", "CP_TMEAS L1=1")
        self.assertIn("PT0425", self.do("zeros", "touch", "L1", "--offset", "0", status=2).err)
        self.do("press", "jog", "A2-", "0.4s")
        time.sleep(0.15)
        self.do("set", "input 6=1")
        self.wait_for(lambda: "touched" in self.channel(), 5, "the contact")
        self.assertEqual((self.channel()["touched"], self.channel()["workpiece_setter"]), ("A2-", 1))
        self.assertIn("PT0424", self.do("offsets", "touch", "L1", "4", status=2).err)       # no tool setter here
        self.do("offsets", "set", "L1", "9", "geometry", "Z=20", "R=1")                     # a ball of 2 mm, lengths to its middle
        shown = self.ask("zeros", "touch", "L1", "G55", "Z=5", "--offset", "9")
        self.assertAlmostEqual(shown["new"], shown["machine"] - 1 - 20 - 5, places=6)
        zero = lambda: next(z for z in self.ask("zeros", "list", "L1")["zeros"] if z["zero"] == "G55")["Z"]
        self.assertEqual(zero(), 0)                                                         # only shown
        self.assertIn("Written", self.do("zeros", "touch", "L1", "G55", "Z=5", "--offset", "9", "--yes").out)
        self.assertAlmostEqual(zero(), shown["new"], places=6)
        self.assertEqual(self.stop(), 0)

    def test_an_offset_that_is_common_is_the_same_in_every_channel(self):
        self.start("N1412=3")
        self.do("press", "machine_on")
        self.do("offsets", "set", "L2", "3", "geometry", "Z=4")
        self.by_hand("L2", "T0003 G0 Z10.")
        self.wait_for(lambda: abs(next(a for a in self.ask("status")["axes"] if a["axis"] == "A4")["cmd"] - 14) < 1e-6, 10, "the way with the offset")
        self.assertEqual(self.ask("offsets", "list", "L1")["offsets"][2]["geometry"]["Z"], 4)
        self.assertEqual(self.stop(), 0)

    def test_the_status_shows_the_tool_that_n2901_tsp_names(self):
        self.start("N2901 L2=10000000")
        self.do("press", "machine_on")
        self.do("tools", "add", "5", "name=ROUGH")
        self.do("tools", "load", "5", "1", "5")   # a station in which nothing stands is no tool
        self.by_hand("L1", "T0500")
        self.wait_for(lambda: self.channel().get("active_tool") == 5, 10, "CP_ACTT")
        self.do("set", "CP_ACTT L2=7")
        self.do("set", "SP_ACTT S4=9")
        self.wait_for(lambda: self.channel(2).get("active_tool") == 9, 5, "SP_ACTT of the driven tools")
        self.assertEqual(self.stop(), 0)


class SinumerikTools(Tools):
    """T by name: the sister that works decides whose edges D means; $TC_MOP is the same life."""
    language = "sinumerik"
    test_the_next_sister_works_when_one_is_used_up = test_the_offset_of_the_managed_tool_is_that_of_the_sister = test_the_sister_is_asked_for_also_while_the_radius_is_compensated = None
    test_life_is_counted_only_while_the_tool_cuts_and_survives = test_a_place_is_called_with_the_code_of_n2924 = None
    test_the_setter_gives_the_offset_after_a_look_at_it = test_a_longer_drill_makes_a_safe_program_stop = None
    test_the_workpiece_setter_gives_the_zero_after_a_look_at_it = test_an_offset_that_is_common_is_the_same_in_every_channel = test_the_status_shows_the_tool_that_n2901_tsp_names = None

    def test_a_name_calls_the_sister_and_her_edges(self):
        self.start("PT_TOOL_SEARCH L1=2", "PT_LIFE_END L1=0")
        self.do("press", "machine_on")
        for duplo, pot, length in ((1, 3, 30), (2, 7, 35)):
            self.do("tools", "add", "name=ROUGH", f"duplo={duplo}", "life_kind=uses", "life=1", "D1.DP1=500", "D1.DP2=3", f"D1.DP4={length}")
            self.do("tools", "load", duplo, 1, pot)
        program = 'G18 T="ROUGH" D1\nG0 Z20\nM30\n'
        for tool, length in ((1, 30), (2, 35)):
            self.assertEqual(self.cycle(program)["tool"], tool)
            z = next(a for a in self.ask("status")["axes"] if a["axis"] == "A2")["cmd"]
            self.assertAlmostEqual(z, 20 + length, places=6)
            self.wait_for(lambda: self.tool(tool)["worn"], 3, "the use to be counted")
        self.cycle(program, ends="interrupted")
        self.assertIn("PT0418", self.alarms())
        for duplo, length in ((1, 30), (2, 35)):    # TCA takes it whatever its state
            self.assertEqual(self.cycle(f'G18 G0 Z0\nTCA("ROUGH",{duplo})\nD1 Z20\nM30\n')["tool"], duplo)
            z = next(a for a in self.ask("status")["axes"] if a["axis"] == "A2")["cmd"]
            self.assertAlmostEqual(z, 20 + length, places=6)
        self.assertEqual(self.cycle("G18 G0 Z0\nTML(3)\nM30\n", ends="interrupted")["tool"], 2)    # as T: it is used up
        self.cycle("IF CHKDM(1)\nSETAL(65001)\nENDIF\nSETDNO(2,1,7)\nIF NOT CHKDM(1)\nSETAL(65002)\nENDIF\nM30\n")    # both have a D1 in magazine 1
        self.assertEqual(self.stop(), 0)

    def test_another_tool_while_the_radius_is_compensated(self):
        self.start("PT_LIFE_END L1=0")
        self.do("press", "machine_on")
        for number, (name, pot) in enumerate((("A", 3), ("B", 7)), 1):
            self.do("tools", "add", f"name={name}", "D1.DP1=500", "D1.DP2=9", "D1.DP6=0.4", f"D1.DP4={30 * number}")
            self.do("tools", "load", number, 1, pot)
        program = 'G18 G90 DIAMOF T="A" D1\nG0 X100 Z20\nG1 G42 X90 Z0 F4000\nZ-5\nT="B" D1\nZ-10\nX95\nG40 X100 Z-10\nM30\n'
        self.assertEqual(self.cycle(program)["tool"], 2)
        z = next(a for a in self.ask("status")["axes"] if a["axis"] == "A2")["cmd"]
        self.assertAlmostEqual(z, -10 + 60, places=6)
        self.assertEqual(self.stop(), 0)

    def test_monitoring_reads_and_writes_the_same_life(self):
        self.start("PT_LIFE_END L1=0")
        self.do("press", "machine_on")
        self.do("tools", "add", "name=A", "life_kind=pieces", "life=100", "counter=40", "warning=10", "D1.DP1=500")
        self.cycle("DEF INT STATE\nR1=$TC_MOP4[1,1] R2=$TC_MOP13[1,1] R3=$TC_TP9[1]\n$TC_MOP3[1,1]=25\n$TC_MOP4[1,1]=R1-5\nSTOPRE\nR4=$TC_MOP4[1,1]\nMSG(\"<<R1>> <<R2>> <<R3>> <<R4>>\")\nM30\n".replace("<<", "\"<<").replace(">>", "<<\""))
        self.wait_for(lambda: self.tool(1)["warning"] == 25, 3, "the warning limit")
        self.assertEqual(self.tool(1)["counter"], 45)
        self.cycle("DEF INT STATE\nRESETMON(STATE,1,1,0)\nM30\n")
        self.wait_for(lambda: self.tool(1)["counter"] == 0, 3, "the new life")
        self.assertEqual(self.stop(), 0)


class FagorTools(Tools):
    """An expended tool gives way to another of its family."""
    language = "fagor"
    test_the_next_sister_works_when_one_is_used_up = test_the_offset_of_the_managed_tool_is_that_of_the_sister = test_the_sister_is_asked_for_also_while_the_radius_is_compensated = None
    test_life_is_counted_only_while_the_tool_cuts_and_survives = test_a_place_is_called_with_the_code_of_n2924 = None
    test_the_setter_gives_the_offset_after_a_look_at_it = test_a_longer_drill_makes_a_safe_program_stop = None
    test_the_workpiece_setter_gives_the_zero_after_a_look_at_it = test_an_offset_that_is_common_is_the_same_in_every_channel = test_the_status_shows_the_tool_that_n2901_tsp_names = None

    def test_the_family_is_the_type_number_and_the_life_is_the_stores(self):
        self.start("PT_LIFE_END L1=0")
        self.do("press", "machine_on")
        for pot, h in ((3, 4), (7, 8)):
            self.do("tools", "add", f"name=F{pot}", "type=5", f"h={h}", "life_kind=uses", "life=1")
        self.do("tools", "load", 1, 1, 3)
        self.do("tools", "load", 2, 1, 7)
        program = "T1\nG0 Z20\nM30\n"
        here = self.cycle(program)
        self.assertEqual((here["tool"], here["tool_offset"]), (1, 4))
        self.wait_for(lambda: self.tool(1)["worn"], 3, "the use to be counted")
        here = self.cycle(program)
        self.assertEqual((here["tool"], here["tool_offset"]), (2, 8))
        self.wait_for(lambda: self.tool(2)["worn"], 3, "the use to be counted")
        self.cycle(program, ends="interrupted")
        self.cycle("(TLFR1=0)\n(P1=TLFR2)\nM30\n")
        self.wait_for(lambda: self.tool(1)["counter"] == 0, 3, "what the program has written")
        self.assertEqual(self.stop(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
