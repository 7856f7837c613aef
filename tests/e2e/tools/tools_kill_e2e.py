#!/usr/bin/env python3
"""Everything of a controller is killed at random moments while tools, life and offsets change, and what the disk had not finished is
torn: nothing that was acknowledged is lost, and the table of tools never contradicts itself.
TOOL_KILLS says how often (default 12; 200 for the whole proof), TOOL_SEED from where."""
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import time
import unittest

from polyturn_runner import POLYTURN, Case
from seeds import seeds

KILLS = int(os.environ.get("TOOL_KILLS", "12"))
SEED = int(os.environ.get("TOOL_SEED", "2026"))


def descendants(pid):
    out = []
    for task in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            fields = (task / "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue
        if int(fields[1]) == pid:
            out += [int(task.name)] + descendants(int(task.name))
    return out


class Killed(Case):
    def setUp(self):
        super().setUp()
        self.name = f"killed-{os.getpid()}"
        self.running = None
        self.addCleanup(self.kill)
        self.addCleanup(lambda: self.polyturn("clean"))

    def start(self):
        self.log = open(self.folder / "start.log", "ab")
        self.running = subprocess.Popen([POLYTURN, "start", "--instance", self.name, "--store", self.folder / "store", "--no-hmi", "--set", "N2900=00000001"],
                                        cwd=self.folder, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)
        deadline = time.monotonic() + 20
        while self.polyturn("status", "--instance", self.name).status != 0:
            self.assertLess(time.monotonic(), deadline, (self.folder / "start.log").read_text(errors="replace")[-3000:])
            time.sleep(0.02)

    def kill(self):
        if not self.running:
            return
        for pid in [self.running.pid] + descendants(self.running.pid):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.running.wait(timeout=20)
        self.running = None
        self.log.close()

    def call(self, *words):
        """(acknowledged, answer)"""
        done = subprocess.run([POLYTURN, *map(str, words), "--instance", self.name], capture_output=True, text=True, cwd=self.folder, timeout=30, stdin=subprocess.DEVNULL)
        return done.returncode == 0, done

    def seen(self):
        tools = {t["tool"]: t for t in json.loads(self.call("tools", "list", "--json")[1].stdout)["tools"]}
        offsets = {o["number"]: o for o in json.loads(self.call("offsets", "list", "L1", "--json")[1].stdout)["offsets"]}
        places = json.loads(self.call("tools", "places", "--json")[1].stdout)["places"]
        return tools, offsets, places

    def tear(self, rnd):
        """The last write did not reach the disk whole: the end of the log is cut or spoilt behind its last commit."""
        wal = self.folder / "store" / "store.sqlite-wal"
        if not wal.exists() or wal.stat().st_size < 64:
            return
        with open(wal, "ab") as file:      # a torn frame behind what was synced
            file.write(rnd.randbytes(rnd.randrange(1, 4096 + 24)))

    def test_nothing_acknowledged_is_lost(self):
        self.kills(SEED, KILLS)

    def test_nothing_acknowledged_is_lost_at_new_moments(self):
        for seed in seeds("tools_kill_e2e", "TOOL_SEED", SEED, 1, 1)[1:]:
            with self.subTest(seed=seed):
                self.folder = self.folder / str(seed)   # a store of its own
                self.folder.mkdir()
                self.kills(seed, max(2, KILLS // 3))
                self.kill()

    def kills(self, seed, count):
        rnd = random.Random(seed)
        self.start()
        for n in range(1, 6):
            self.assertTrue(self.call("tools", "add", f"name=T{n}", f"type={n}", f"h={n}", "life_kind=pieces", "life=1000000")[0])
            self.assertTrue(self.call("tools", "load", n, 1, n)[0])
        known = {}          # what -> acknowledged value
        asked = {}          # what -> values asked for and not acknowledged
        acknowledged = 0
        for round_ in range(count):
            moment = time.monotonic() + rnd.uniform(0.02, 0.5)
            while time.monotonic() < moment:
                n = rnd.randrange(1, 6)
                kind = rnd.choice(("life", "counter", "pot", "wear"))
                if kind == "wear":
                    value = round(rnd.uniform(-0.9, 0.9), 4)
                    words = ("offsets", "set", "L1", n, "wear", f"X={value}")
                elif kind == "pot":
                    value = rnd.randrange(1, 13)
                    words = ("tools", "move", n, 1, value)
                else:
                    value = rnd.randrange(1, 10**6)
                    words = ("tools", "set", n, f"{kind}={value}")
                asked.setdefault((kind, n), []).append(value)
                before = time.monotonic()
                # The kill comes while this call is under way, or between two.
                if moment - before < 0.03:
                    call = subprocess.Popen([POLYTURN, *map(str, words), "--instance", self.name], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                    time.sleep(max(0, moment - time.monotonic()))
                    self.kill()
                    call.communicate(timeout=30)
                    good = call.returncode == 0
                else:
                    good, done = self.call(*words)
                    if not good and kind == "pot":      # the place is taken: refused, nothing happened
                        asked[(kind, n)].pop()
                if good:
                    known[(kind, n)] = value
                    asked[(kind, n)] = []
                    acknowledged += 1
            self.kill()
            self.tear(rnd)
            self.polyturn("clean")
            self.start()
            tools, offsets, places = self.seen()
            self.assertEqual(sorted(tools), [1, 2, 3, 4, 5])
            for (kind, n), value in known.items():
                now = offsets[n]["wear"]["X"] if kind == "wear" else tools[n]["pot"] if kind == "pot" else tools[n][kind]
                if kind == "pot" and now is None:
                    now = 0
                self.assertIn(now, [value] + asked.get((kind, n), []), f"round {round_}: {kind} of {n}: {now}, acknowledged {value}")
                known[(kind, n)] = now
                asked[(kind, n)] = []
            standing = [(p["magazine"], p["pot"]) for p in places if p.get("tool")]
            self.assertEqual(len(standing), len(set(standing)))
            self.assertEqual(len(standing), 5)
        self.assertGreater(acknowledged, count)
        print(f"{count} kills, {acknowledged} acknowledged changes")


if __name__ == "__main__":
    unittest.main(verbosity=2)
