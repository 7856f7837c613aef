#!/usr/bin/env python3
"""Fuzzes the controller's socket with a real supervisor, kernel and store: random bytes, random JSON, JSON from the grammar of requests
with wrong types in it, real requests with bytes changed, many connections that come and go in the middle of a line. Afterwards the same
processes live and answer, and each line that ended had its answer.

SOCKET_SEED and SOCKET_SECONDS choose what is tried and how long (default 7 and 10). With a failure the last lines that were sent are
printed; LINES=FILE plays such lines."""
import json
import os
import pathlib
import random
import socket
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "e2e"))
from polyturn_runner import LiveCase   # noqa: E402

SEED = os.environ.get("SOCKET_SEED", "7")   # "new": another one each time
SEED = random.SystemRandom().randrange(10**6, 10**9) if SEED == "new" else int(SEED)
SECONDS = float(os.environ.get("SOCKET_SECONDS", "10"))

PRESSES = ["cycle_start L1", "feed_hold", "reset", "emergency_stop", "release_emergency_stop", "machine_on", "mode L1=mdi", "select L1=O1.nc", "mdi L1 G0 X50.", "jog A1+ 0.1s", "step A1- 0.01",
           "handwheel 1 A1 +120", "reference all", "feed_override L1=50", "block_skip L1=1", "restart L1=N10", "scope 1 measured A1", "answer L1 #500=1 key=1", "warm_up L1=1", "teach_thread L1"]
SETS = ["AP_SYNCR A1=0", "I5=1", "offset L1 3 wear X=0.05", "zero L1 G54 Z=-150", "N1600 L1=2.5", "drive A1=ok", "PT_HORIZON=512"]
OPERATIONS = ["tools.list", "tools.set", "tools.add", "tools.load", "tools.unload", "tools.move", "tools.delete", "tools.places", "tools.place", "tools.import", "tools.export", "tools.answers", "life.report",
              "life.reset", "offsets.list", "offsets.set", "offsets.relative", "offsets.preset", "offsets.undo", "offsets.history", "offsets.touch", "zeros.list", "zeros.set", "zeros.touch", "parts.list",
              "parts.add", "parts.set", "parts.measure", "parts.accept", "parts.delete", "pallets.list", "pallets.set", "pallets.exchange", "users.list", "users.login", "users.add", "users.level", "users.delete",
              "users.password", "history.list", "stops.list", "alarms.list", "compensation.set", "compensation.import", "stops.note", "alarms.note"]
KEYS = ["tool", "name", "type", "magazine", "pot", "channel", "number", "table", "field", "value", "fields", "preview", "since", "who", "most", "dimension", "axis", "zero", "user", "password", "level", "uid",
        "text", "format", "file", "what", "pallet", "group", "offset", "edge", "rows", "delta", "expected", "all"]


class Draw:
    def __init__(self, seed):
        self.random = random.Random(seed)

    def value(self, depth=0):
        r = self.random
        kind = r.randrange(12 if depth < 4 else 8)
        if kind == 0:
            return None
        if kind == 1:
            return r.random() < 0.5
        if kind == 2:
            return r.choice([0, 1, -1, 2, 3, 2**31, -2**31 - 1, 2**53, 2**63, 2**64 - 1, -2**63, 10**30])
        if kind == 3:
            return r.choice([0.5, -0.0, 1e308, -1e308, 1e-320, 3.3])
        if kind < 8:
            return r.choice(["", "x", "1", "L1", "X", "G54", "wear", "\u0000", "\ud7ff", "../../etc/passwd", "%s%n", "a" * r.choice([1, 95, 96, 97, 300, 5000]), "é" * 60, "'; drop table tools;--"])
        if kind < 10:
            return [self.value(depth + 1) for _ in range(r.randrange(4))]
        return {r.choice(KEYS + ["do", "op"]): self.value(depth + 1) for _ in range(r.randrange(4))}

    def sensible(self):
        r = self.random
        kind = r.randrange(9)
        if kind < 3:
            return {"do": "press", "words": r.choice(PRESSES), "folder": "/tmp"}
        if kind == 3:
            return {"do": "set", "words": r.choice(SETS)}
        if kind == 4:
            return {"do": "parameters", "lines": [r.choice(["N1600 L1=2.5", "N1=", "PT_HORIZON=512", "x" * 200]) for _ in range(r.randrange(5))], "import": r.random() < 0.3}
        if kind < 8:
            return {"do": "store", "op": {"do": r.choice(OPERATIONS), **{r.choice(KEYS): self.value(2) for _ in range(r.randrange(5))}}}
        return {"do": r.choice(["alarms", "who", "logout", "release"]), "words": "AP_SYNCR A1"} if r.random() < 0.3 else {"do": r.choice(["alarms", "who", "logout"])}

    def spoilt(self, request):
        """One of its values is another."""
        r = self.random
        at = request
        while True:
            key = r.choice(list(at) + (["import", "since", "token", "lines", "spell"] if at is request else KEYS[:5]))
            if isinstance(at.get(key), dict) and at[key] and r.random() < 0.7:
                at = at[key]
                continue
            if r.random() < 0.15 and key in at:
                del at[key]
            else:
                at[key] = self.value()
            return request

    def line(self):
        r = self.random
        kind = r.randrange(10)
        if kind == 0:
            return bytes(b for b in r.randbytes(r.choice([0, 1, 10, 300, 5000])) if b != 10)
        if kind == 1:
            return json.dumps(self.value()).encode()
        if kind == 2:
            deep = r.choice([10, 31, 33, 1000, 200_000])
            return b'{"do":"store","op":' + r.choice([b"[", b'{"a":']) * deep + b"}" * deep + b"}"
        request = self.sensible()
        if request.get("do") == "store" and isinstance(request["op"], dict) and request["op"].get("do") == "users.add":
            request["op"]["level"] = "nothing"   # with a user everybody else would be shut out, and little more tried
        if kind < 6:
            request = self.spoilt(request)
        line = json.dumps(request).encode()
        if kind < 8:
            return line
        changed = bytearray(line)
        for _ in range(r.randrange(1, 4)):
            what = r.randrange(3)
            place = r.randrange(len(changed) + 1)
            if what == 0 and changed:
                changed[place % len(changed)] = r.choice(b'{}[]",:\\0-e\x00\xff')
            elif what == 1:
                changed[place:place + r.randrange(1, 9)] = b""
            else:
                changed[place:place] = changed[:r.randrange(1, 30)]
        return bytes(b for b in changed if b != 10)


class SocketFuzz(LiveCase):
    def connect(self):
        one = socket.socket(socket.AF_UNIX)
        one.connect("\0polyturn." + self.name)
        one.settimeout(40)
        return one

    def pids(self):
        return {p["name"]: p["pid"] for p in json.loads(self.polyturn("status", "--json", "--instance", self.name).out)["processes"]}

    def answers(self, one, count):
        got = b""
        while got.count(b"\n") < count:
            piece = one.recv(1 << 16)
            if not piece:
                break
            got += piece
        return got.split(b"\n")[:-1]

    def test_the_same_processes_live_and_answer(self):
        self.start()
        self.addCleanup(self.stop)
        self.wait_for(lambda: {"channel 1", "channel 2"} <= set(self.pids()), 20, "both channels: status answers before they are there")
        before = self.pids()
        draw = Draw(SEED)
        last, sent = [], 0
        given = os.environ.get("LINES")
        given = pathlib.Path(given).read_bytes().split(b"\n") if given else None
        end = time.monotonic() + SECONDS
        try:
            while time.monotonic() < end and given != []:
                lines = [given.pop(0)] if given else [draw.line() for _ in range(draw.random.randrange(1, 12))]
                last = (last + lines)[-60:]
                text = b"".join(line + b"\n" for line in lines)
                with self.connect() as one:
                    if draw.random.random() < 0.15:   # goes in the middle
                        one.sendall(text[:draw.random.randrange(len(text) + 1)])
                        continue
                    one.sendall(text)
                    told = self.answers(one, len(lines))
                sent += len(lines)
                self.assertEqual(len(told), len(lines), "each line has its answer")
                for answer in told:
                    self.assertIn("ok", json.loads(answer))
                self.assertIsNone(self.running.poll(), "the supervisor has died")
            time.sleep(0.5)
            self.assertEqual(self.pids(), before, "a process has died")
            with self.connect() as one:
                one.sendall(b'{"do":"store","op":{"do":"tools.list"}}\n{"do":"press","words":"feed_hold"}\n')
                self.assertTrue(all(json.loads(answer)["ok"] for answer in self.answers(one, 2)))
        except BaseException:
            kept = pathlib.Path(os.environ.get("TMPDIR", "/tmp")) / f"socket_fuzz_{SEED}.lines"
            kept.write_bytes(b"\n".join(last))
            print(f"seed {SEED}, {sent} lines; the last of them: {kept}\n" + (self.folder / "start.log").read_text(errors="replace")[-2000:], file=sys.stderr)
            raise
        print(f"seed {SEED}: {sent} lines")


if __name__ == "__main__":
    unittest.main()
