#!/usr/bin/env python3
"""The controller's socket against whoever speaks to it: lines that are none, too deep, too long, of wrong types; clients that flood,
that never read, that come by the dozen; a store and a kernel that stand still. Nobody who was there before dies of it, and each line
that was understood or not has its answer (faults.md L1, L4, L14)."""
import json
import os
import pathlib
import signal
import socket
import time
import unittest

from polyturn_runner import LiveCase


class Client:
    def __init__(self, name, patience=20):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect("\0polyturn." + name)
        self.socket.settimeout(patience)
        self.got = b""

    def send(self, line):
        self.socket.sendall((line if isinstance(line, bytes) else json.dumps(line).encode()) + b"\n")

    def line(self):
        """The next answer; None: the connection was closed."""
        while b"\n" not in self.got:
            try:
                piece = self.socket.recv(65536)
            except ConnectionResetError:
                return None
            if not piece:
                return None
            self.got += piece
        line, self.got = self.got.split(b"\n", 1)
        return json.loads(line)

    def ask(self, line):
        self.send(line)
        return self.line()

    def close(self):
        self.socket.close()


class Requests(LiveCase):
    def setUp(self):
        super().setUp()
        self.start()
        self.addCleanup(self.stop)   # before its folder goes: the store writes its last words there
        self.wait_for(lambda: {"channel 1", "channel 2"} <= set(self.pids()), 20, "both channels: status answers before they are there")

    def client(self):
        one = Client(self.name)
        self.addCleanup(one.close)
        return one

    def pids(self):
        return {p["name"]: p["pid"] for p in json.loads(self.polyturn("status", "--json", "--instance", self.name).out)["processes"]}

    def answers_and_lives(self, before):
        self.assertIsNone(self.running.poll(), "the supervisor has died\n" + (self.folder / "start.log").read_text(errors="replace")[-3000:])
        self.assertEqual(self.pids(), before, "a process has died\n" + (self.folder / "start.log").read_text(errors="replace")[-3000:])
        one = self.client()
        self.assertTrue(one.ask({"do": "who"})["ok"])
        self.assertTrue(one.ask({"do": "store", "op": {"do": "tools.list"}})["ok"])

    def refused(self, line):
        before = self.pids()
        answer = self.client().ask(line)
        self.assertIsNotNone(answer, "no answer")
        self.assertFalse(answer["ok"], answer)
        self.answers_and_lives(before)
        return answer

    def test_nesting_without_end(self):
        deep = 450_000
        answer = self.refused(b'{"do":"store","op":{"do":"tools.list","x":' + b"[" * deep + b"]" * deep + b"}}")
        self.assertEqual(answer["number"], "PT0335", answer)
        answer = self.refused(b'{"do":"store","op":{"do":"tools.list","x":' + b"[" * 33 + b"]" * 33 + b"}}")
        self.assertEqual(answer["number"], "PT0335", answer)

    def test_wrong_types(self):
        for line in ({"do": "parameters", "lines": [], "import": "x"}, {"do": "parameters", "lines": "N1"}, {"do": "parameters", "lines": [1]}, {"do": "press", "words": 1},
                     {"do": "press", "words": ["feed_hold"]}, {"do": "store", "op": []}, {"do": "store", "op": {"do": 1}}, {"do": "alarms", "since": -1}, {"do": "alarms", "since": "x"},
                     {"do": "who", "token": {}}, {"do": 7}, [], 3, "x", {"do": "unheard"}, {"do": "press", "words": "feed_hold", "spell": 1}, {"do": "press", "words": "select L1=a\0b"}):
            with self.subTest(line=line):
                self.assertIn(self.refused(line)["number"], ("PT0335", "PT0310"))

    def test_a_store_request_of_a_wrong_type(self):
        """A store that dies of a request dies of it once: its successor does not read it again."""
        before = self.pids()
        answer = self.client().ask({"do": "store", "op": {"do": "tools.list", "preview": "x"}})
        self.assertFalse(answer["ok"], answer)
        self.wait_for(lambda: self.client().ask({"do": "store", "op": {"do": "tools.list"}})["ok"], 10, "the store")
        now = self.pids()
        time.sleep(1.0)
        self.answers_and_lives(now)
        self.assertEqual({**before, "toolmgmt": 0}, {**now, "toolmgmt": 0})

    def test_lines_that_are_too_long(self):
        answer = self.refused(b'{"do":"press","words":"' + b"x" * 70_000 + b'"}')
        self.assertEqual(answer["number"], "PT0335", answer)
        before = self.pids()
        one = self.client()
        try:
            one.socket.sendall(b'{"do":"parameters","import":true,"lines":["' + b"x" * 3_000_000)
        except OSError:
            pass   # it was closed: right
        told = one.line()
        self.assertTrue(told is None or told["number"] == "PT0335", told)
        self.answers_and_lives(before)

    def test_an_import_may_be_long(self):
        lines = ["N1600 L1=2.5"] * 20_000
        answer = self.client().ask({"do": "parameters", "import": True, "lines": lines})
        self.assertTrue(answer["ok"], answer)

    def test_newlines_are_answered_and_nobody_waits_for_them(self):
        before = self.pids()
        flood = self.client()
        flood.socket.setblocking(False)
        sent = 0
        begin = time.monotonic()
        slowest = 0.0
        while time.monotonic() - begin < 2.0:
            try:
                sent += flood.socket.send(b"\n" * 65536)
            except BlockingIOError:
                pass
            asked = time.monotonic()
            other = Client(self.name)
            self.assertTrue(other.ask({"do": "who"})["ok"])
            other.close()
            slowest = max(slowest, time.monotonic() - asked)
        self.assertGreater(sent, 0)
        self.assertLess(slowest, 1.0)
        self.answers_and_lives(before)

    def test_a_client_that_never_reads_is_closed_and_costs_little(self):
        before = self.pids()
        for _ in range(300):
            self.client_alarm()
        one = self.client()
        one.socket.settimeout(0.2)
        line = b'{"do":"alarms"}\n' * 1000
        begin = time.monotonic()
        closed = False
        while time.monotonic() - begin < 12 and not closed:
            try:
                one.socket.send(line)
            except (TimeoutError, BlockingIOError):
                pass
            except OSError:
                closed = True
        resident = int(next(l for l in pathlib.Path(f"/proc/{self.running.pid}/status").read_text().splitlines() if l.startswith("VmHWM")).split()[1])
        self.assertTrue(closed, "who never reads is closed")
        self.assertLess(resident, 200_000, "kB")
        self.answers_and_lives(before)

    def client_alarm(self):
        self.client_once = getattr(self, "client_once", None) or self.client()
        self.client_once.ask({"do": "press", "words": "cycle_start L1"})   # nothing is selected: an alarm

    def test_a_request_that_kills_its_reader_is_not_read_again(self):
        """The reader is killed by hand while it has the request: no store need be faulty for this test."""
        store = self.pids()["toolmgmt"]
        os.kill(store, signal.SIGSTOP)
        asked = [self.client() for _ in range(3)]
        for number, one in enumerate(asked):
            one.send({"do": "set", "words": f"N1600 L1={number + 3}.5"})
        time.sleep(0.3)
        os.kill(store, signal.SIGKILL)
        for one in asked:
            answer = one.line()
            self.assertIsNotNone(answer)
            self.assertFalse(answer["ok"], answer)
        self.wait_for(lambda: self.pids().get("toolmgmt") not in (None, store), 10, "the store's successor")
        self.wait_for(lambda: self.client().ask({"do": "store", "op": {"do": "tools.list"}})["ok"], 10, "the successor to answer")
        value = self.polyturn("params", "get", "N1600 L1", "--instance", self.name).out.split()[-1]
        self.assertNotIn(value, ("3.5", "4.5", "5.5"), "what was refused was done")

    def test_an_operation_that_kills_its_reader_is_not_read_again(self):
        """The reader is killed while it works on it (a password's hash takes some time). The controller says that the store has died,
        its successor serves others, and of what was refused nothing is done."""
        for number, delay in enumerate((0.0, 0.004, 0.015)):
            store = self.pids()["toolmgmt"]
            os.kill(store, signal.SIGSTOP)
            one = self.client()
            one.send({"do": "store", "op": {"do": "parts.add", "dimension": 500 + number, "fields": {"nominal": 1, "upper": 1, "lower": 0}}})
            two = self.client()
            two.send({"do": "store", "op": {"do": "users.login", "name": "nobody", "password": "wrong"}})
            time.sleep(0.2)
            os.kill(store, signal.SIGCONT)
            time.sleep(delay)
            os.kill(store, signal.SIGKILL)
            first, second = one.line(), two.line()
            self.assertIsNotNone(first), self.assertIsNotNone(second)
            self.assertFalse(second["ok"], second)
            self.wait_for(lambda: self.pids().get("toolmgmt") not in (None, 0, store), 10, "the store's successor")
            self.wait_for(lambda: self.client().ask({"do": "store", "op": {"do": "tools.list"}})["ok"], 10, "the successor to answer")
            parts = self.client().ask({"do": "store", "op": {"do": "parts.list"}})
            there = any(d["dimension"] == 500 + number for d in parts["dimensions"])
            # A refusal may come too late for what is on the disk already, but nothing is done afterwards: it is told or it is not there.
            if first["ok"]:
                self.assertTrue(there, "told as done and not there")
            time.sleep(0.5)
            again = self.client().ask({"do": "store", "op": {"do": "parts.list"}})
            self.assertEqual(parts["dimensions"], again["dimensions"], "a refused one was done later")
        alarms = self.polyturn("alarms", "--json", "--instance", self.name).out
        self.assertIn("toolmgmt", alarms, "the death is told")

    def test_a_frozen_store_is_said_in_time(self):
        store = self.pids()["toolmgmt"]
        os.kill(store, signal.SIGSTOP)
        self.addCleanup(lambda: os.kill(store, signal.SIGCONT))
        one, other = self.client(), self.client()
        begin = time.monotonic()
        one.send({"do": "set", "words": "N1600 L1=2.5"})
        one.send({"do": "press", "words": "feed_hold"})   # acts at once, is answered in its turn
        self.assertTrue(other.ask({"do": "press", "words": "feed_hold"})["ok"])
        self.assertLess(time.monotonic() - begin, 2.0)
        importing = self.client()
        importing.send({"do": "parameters", "import": True, "lines": ["N1600 L1=2.5"] * 1000})
        self.assertFalse(one.line()["ok"])
        self.assertLess(time.monotonic() - begin, 9.0)
        self.assertFalse(importing.line()["ok"], "an import too: its store shows no life")
        self.assertLess(time.monotonic() - begin, 12.0)
        self.assertTrue(one.line()["ok"])

    def test_a_frozen_kernel_does_not_keep_the_controller_from_ending(self):
        kernel = self.pids()["kernel"]
        os.kill(kernel, signal.SIGSTOP)
        one = self.client()
        try:
            one.socket.settimeout(2)
            for _ in range(1500):
                one.send({"do": "press", "words": "feed_override L1=50"})
        except OSError:
            pass
        time.sleep(0.5)
        begin = time.monotonic()
        self.running.send_signal(signal.SIGTERM)
        self.running.wait(timeout=20)
        self.assertEqual(self.running.returncode, 0)
        self.assertLess(time.monotonic() - begin, 15)

    def test_wrong_log_ins_keep_nobody_from_the_store(self):
        """Each costs the store a hash. Judged by order, not by time: when somebody else has been served, not all of them have been."""
        self.assertTrue(self.client().ask({"do": "store", "op": {"do": "users.add", "name": "maker", "password": "secret!", "level": "maker"}})["ok"])
        wrong = self.client()
        for _ in range(60):
            wrong.send({"do": "store", "op": {"do": "users.login", "name": "nobody", "password": "wrong"}})
        time.sleep(0.1)
        self.assertTrue(self.client().ask({"do": "store", "op": {"do": "tools.list"}})["ok"])
        wrong.socket.setblocking(False)
        try:
            wrong.got += wrong.socket.recv(1 << 20)
        except BlockingIOError:
            pass
        self.assertLess(wrong.got.count(b"\n"), 30)
        wrong.socket.setblocking(True)
        right = self.client().ask({"do": "store", "op": {"do": "users.login", "name": "maker", "password": "secret!"}})
        self.assertTrue(right["ok"] or right["number"] in ("PT0336", "PT0431"), right)   # of the same user of the computer: he may have to wait
        for _ in range(12):
            self.assertFalse(wrong.line()["ok"])

    def test_steps_out_of_reach_are_refused(self):
        one = self.client()
        for words in ("step A2+ 1e308", "step A2- 1e9", "jog A2+ 1e300s", "handwheel 1 A2 +1e300", "handwheel 1 A2 1e12", "warm_up L1=1e300", "restart L1=N1e300", "answer L1 key=1e300",
                      "step A2+ nan", "step A2+ inf", "feed_override L1=nan", "feed_override L1=1e9", "block_skip L1=1e9"):
            with self.subTest(words=words):
                answer = one.ask({"do": "press", "words": words})
                self.assertFalse(answer["ok"], words)
        for words in ("offset L1 3 wear X=1e300", "zero L1 G54 Z=1e300", "CP_REG1 L1=1e300", "offset L1 3 wear X=nan"):
            with self.subTest(words=words):
                self.assertFalse(one.ask({"do": "set", "words": words})["ok"], words)
        self.assertTrue(one.ask({"do": "press", "words": "mode L1=jog"})["ok"])


if __name__ == "__main__":
    unittest.main()
