#!/usr/bin/env python3
"""Feed hold and emergency stop are answered within 10 ms while every other client misbehaves (faults.md L4): floods of newlines, of deep
and of wrong lines, selects without end, wrong log-ins, dozens of connections, clients that never read, and at last a store that stands
still with an import under way.

How it is judged on a computer that has other things to do: the operating system tells how long the supervisor, and this program, stood
ready without a processor while a stop was under way (/proc/PID/schedstat). That is the computer's; what is left is the controller's, and
its 99th percentile is at most 10 ms, the longest 50 ms (before the repair: 4 to 25 s). A process that does nothing but send back what it
gets is asked at the same moments, to be looked at beside it. All figures are printed. STOP_ANSWERS says how many stops each phase has
(default 300; 10000 for the whole proof)."""
import json
import multiprocessing
import os
import pathlib
import signal
import socket
import time
import unittest

from polyturn_runner import SHAFT, LiveCase

COUNT = int(os.environ.get("STOP_ANSWERS", "300"))
LIMIT = 0.010


def connect(name):
    one = socket.socket(socket.AF_UNIX)
    one.connect("\0polyturn." + name)   # waits where many come
    one.settimeout(30)
    return one


def line_of(one):
    got = b""
    while not got.endswith(b"\n"):
        piece = one.recv(65536)
        if not piece:
            raise ConnectionResetError
        got += piece
    return json.loads(got.split(b"\n")[0])


def again_and_again(name, act):
    while True:
        try:
            with connect(name) as one:
                act(one)
        except OSError:
            time.sleep(0.01)   # closed: he deserved it


def sends(line, pause=0.0, reads=True):
    """Sends the line without end, reads what comes."""
    def act(one):
        one.setblocking(False)
        while True:
            try:
                one.send(line)
            except BlockingIOError:
                time.sleep(0.001)
            if reads:
                try:
                    if not one.recv(1 << 20):
                        return
                except BlockingIOError:
                    pass
            time.sleep(pause)
    return act


def asks(line):
    def act(one):
        while True:
            one.sendall(line + b"\n")
            line_of(one)
    return act


def crowd(name, many):
    held = []
    while True:
        try:
            held.append(connect(name))
            if len(held) > many:
                held.pop(0).close()
        except OSError:
            pass
        time.sleep(0.002)


def echo(one):
    while True:
        got = one.recv(256)
        if not got:
            return
        one.send(got)


def without_a_processor(pid):
    """Seconds that its main thread has stood ready so far."""
    try:
        return int(pathlib.Path(f"/proc/{pid}/schedstat").read_text().split()[1]) * 1e-9
    except (OSError, IndexError):
        return 0.0   # this computer does not tell


def percentiles(seconds):
    ordered = sorted(seconds)
    return {name: ordered[min(len(ordered) - 1, int(len(ordered) * part))] * 1e3 for name, part in (("median", 0.5), ("90 %", 0.9), ("99 %", 0.99), ("longest", 1.0))}


class StopAnswer(LiveCase):
    def setUp(self):
        super().setUp()
        self.others = []
        self.addCleanup(self.end_others)

    def end_others(self):
        for one in self.others:
            one.kill()
            one.join()

    def misbehave(self, target, *arguments):
        one = multiprocessing.get_context("fork").Process(target=target, args=arguments, daemon=True)
        one.start()
        self.others.append(one)

    def measure(self, what):
        here, there = socket.socketpair()
        self.misbehave(echo, there)
        kept = connect(self.name)
        stops, computer, own = [], [], []
        for i in range(COUNT):
            begin = time.monotonic()
            here.send(b"x")
            here.recv(1)
            computer.append(time.monotonic() - begin)
            words = ("feed_hold", "emergency_stop")[i % 2]
            request = json.dumps({"do": "press", "words": words}).encode() + b"\n"
            waited = without_a_processor(self.running.pid) + without_a_processor("self")
            begin = time.monotonic()
            one = kept if i % 3 else connect(self.name)   # a screen has its connection, the command line makes one
            one.sendall(request)
            answer = line_of(one)
            stops.append(time.monotonic() - begin)
            waited = without_a_processor(self.running.pid) + without_a_processor("self") - waited
            own.append(max(0.0, stops[-1] - waited))
            if one is not kept:
                one.close()
            self.assertTrue(answer["ok"], answer)
            time.sleep(0.005)
        kept.close()
        here.close()
        stop, own, echoed = percentiles(stops), percentiles(own), percentiles(computer)
        print(f"\n{what}: {COUNT} stops")
        for name, value in stop.items():
            print(f"  {name:>8}  stop {value:8.3f} ms   of it the controller {own[name]:8.3f} ms   an echo {echoed[name]:8.3f} ms")
        # What a process that only echoes waits for on this computer, nobody can answer sooner: on a quiet one it is a tenth of a millisecond.
        self.assertLessEqual(own["99 %"], LIMIT * 1e3 + echoed["99 %"], what)
        self.assertLessEqual(own["longest"], 5 * LIMIT * 1e3 + echoed["longest"], what)

    def test_while_every_other_client_misbehaves(self):
        self.start()
        self.addCleanup(self.stop)
        pids = {p["name"]: p["pid"] for p in json.loads(self.polyturn("status", "--json", "--instance", self.name).out)["processes"]}
        self.measure("alone")
        name = self.name
        self.misbehave(again_and_again, name, sends(b"\n" * 65536))
        self.misbehave(again_and_again, name, sends(b'{"do":"store","op":{"do":"tools.list","x":' + b"[" * 2000 + b"]" * 2000 + b"}}\n"))
        self.misbehave(again_and_again, name, sends(b'{"do":"alarms"}\n' * 100, reads=False))
        self.misbehave(again_and_again, name, sends(b'{"do":"press","words":"reset or what","folder":"' + b"x" * 3000 + b'"}\n'))
        self.misbehave(again_and_again, name, asks(json.dumps({"do": "press", "words": f"select {SHAFT}"}).encode()))
        self.misbehave(again_and_again, name, asks(b'{"do":"store","op":{"do":"users.login","name":"nobody","password":"wrong"}}'))
        self.misbehave(again_and_again, name, asks(b'{"do":"store","op":{"do":"tools.list"}}'))
        self.misbehave(crowd, name, 40)
        time.sleep(0.5)
        self.measure("while all misbehave")
        os.kill(pids["toolmgmt"], signal.SIGSTOP)
        self.addCleanup(lambda: os.kill(pids["toolmgmt"], signal.SIGCONT))
        importing = connect(name)
        importing.sendall(json.dumps({"do": "parameters", "import": True, "lines": ["N1600 L1=2.5"] * 20_000}).encode() + b"\n")
        self.measure("and the store stands still with an import")
        self.assertFalse(line_of(importing)["ok"])
        self.assertIsNone(self.running.poll())


if __name__ == "__main__":
    unittest.main()
