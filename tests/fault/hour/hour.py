#!/usr/bin/env python3
"""Issue 3's property: whatever flags, modes, holds, overrides, stops, jogs, restarts and deaths come, a machine of eight
channels exceeds no limit of an axis, loses no position, nothing hangs, and every alarm names its cause.

    HOUR_SECONDS=3600 HOUR_SEED=7 python3 hour.py     so much virtual time, in runs of a minute; default 120 s, seed of the day
    HOUR_RUN=3 ...                                    only that run of it, its files are kept in ./hour-<seed>-3
    HOUR_MACHINE=coupled_axes ...                     issue 4's: couplings, exchanges and deaths on a machine of coupled slides

The judge is a program of its own (judge.cpp) and knows only the trace and the numbers below.
"""
import csv
import importlib
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from stimuli import Stimuli  # noqa: E402

machine = importlib.import_module(os.environ.get("HOUR_MACHINE", "eight_channels"))
CHANNELS, TICK_S, axes, machine_lines, program = machine.CHANNELS, machine.TICK_S, machine.axes, machine.machine_lines, machine.program
COUPLINGS, GANTRY, WATCH = getattr(machine, "COUPLINGS", {}), getattr(machine, "GANTRY", {}), getattr(machine, "WATCH", [])

SOURCE = pathlib.Path(__file__).resolve().parents[3]
POLYTURN = pathlib.Path(os.environ["POLYTURN"]).resolve()
JUDGE = pathlib.Path(os.environ["HOUR_JUDGE"]).resolve()
RUN_S = float(os.environ.get("HOUR_RUN_SECONDS", "60"))
PATIENCE_S = 25.0
INTERRUPTED, DEAD = 7, 8
NEVER = ("FollowingError", "StandstillError", "ModelError", "DualDifference", "NoProgress", "TickLate", "ChannelInvariant", "AxisDisplaced", "RecordInvalid")


def alarm_rows():
    with open(SOURCE / "ipc/diagnosis/alarms.csv", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def numbers_of(keys):
    return {row["polyturn"]: row["key"] for row in alarm_rows() if row["key"] in keys}


class Episode:
    def __init__(self, seed, number, folder):
        self.rng = random.Random(f"{seed}/{number}")
        self.folder = pathlib.Path(folder)
        self.name = f"seed {seed} run {number}"
        self.faults = []

    def run(self):
        blocks, programs = {}, []
        common = [machine.plan(self.rng)] if COUPLINGS else []
        for channel in range(1, CHANNELS + 1):
            text, blocks[channel] = program(self.rng, channel, *common)
            path = self.folder / f"O{1000 + channel}.nc"
            path.write_text(text)
            programs.append(f"{channel}={path}")
        self.stimuli = Stimuli(self.rng, RUN_S, blocks, deaths=self.rng.random() < 0.4, machine=machine).build()
        (self.folder / "machine.params").write_text("\n".join(machine_lines()) + "\n")
        (self.folder / "scenario.toml").write_text(self.stimuli.text())
        named = {(a.channel, a.name) for a in axes()}
        (self.folder / "setup.toml").write_text("".join(f"[channel.{c}]\nmachine = {{ X = 200.0, Z = 100.0{', Y = 100.0' if (c, 'Y') in named else ''} }}\n" for c in range(1, CHANNELS + 1)))
        trace = self.folder / "trace.csv"
        try:
            done = subprocess.run([POLYTURN, "run", "--virtual", "--machine", self.folder, "--setup", self.folder / "setup.toml", "--scenario", self.folder / "scenario.toml",
                                   "--trace", trace, *(word for name in WATCH for word in ("--watch", name)), *programs], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=1200, check=False)
        except subprocess.TimeoutExpired:
            self.faults.append("the run does not end")
            return
        (self.folder / "events.jsonl").write_text(done.stdout)
        (self.folder / "stderr.txt").write_text(done.stderr)
        if done.returncode not in (0, 1):
            self.faults.append(f"exit status {done.returncode}: {done.stderr[-500:]}")
            return
        self.events = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
        self.look_at_events()
        self.judge(trace)

    def look_at_events(self):
        never = numbers_of(NEVER)
        if not any(e["ev"] == "summary" for e in self.events):
            self.faults.append("no summary: the run was cut short")
        faulty = any("drive" in line[2] and "ok" not in line[2] for line in self.stimuli.lines)
        for alarm in (e for e in self.events if e["ev"] == "alarm"):
            if not str(alarm.get("text", "")).strip() or not alarm.get("number"):
                self.faults.append(f"an alarm without a cause: {alarm}")
            if str(alarm.get("number")) in never and not (faulty and "displaced" in alarm["text"]):
                self.faults.append(f"t={alarm.get('t')}: {alarm['number']} {alarm['text']} ({never[str(alarm['number'])]} must not come)")
        stops = [e["t"] for e in self.events if e["ev"] == "machine" and e["state"] in ("estop", "emergency_stop")]
        alarms = [e.get("t", 0) for e in self.events if e["ev"] == "alarm"]
        for t in stops:
            if not any(abs(t - alarm) < 0.05 for alarm in alarms):
                self.faults.append(f"t={t}: an emergency stop without an alarm")

    def spans(self):
        """What the judge must know of the machine's state: from its events."""
        free, hard = [], []
        off_since = None
        for e in self.events:
            if e["ev"] != "machine":
                continue
            off = e["state"] in ("estop", "emergency_stop", "off")
            if off and off_since is None:
                off_since = e["t"]
            if not off and off_since is not None:
                hard.append((off_since - 2 * TICK_S, e["t"]))
                free += [(a.number, off_since + 1.0, e["t"] + 5 * TICK_S) if e["t"] - off_since > 1.0 else (a.number, e["t"] - 2 * TICK_S, e["t"] + 5 * TICK_S) for a in axes()]
                off_since = None
        if off_since is not None:
            hard.append((off_since - 2 * TICK_S, 1e9))
        return free, hard

    def judge(self, trace):
        free, hard = self.spans()
        facts = [f"tick {TICK_S}", f"patience {PATIENCE_S}"]
        for a in axes():
            facts.append(f"axis {a.number} {a.channel} {a.rapid / 60} {a.acceleration} {a.jerk} {a.low} {a.high} {a.estop} 1.0 0.02")
        # An open loop, a detached axis: nobody commands it; and while its coordinates are found anew (a second around it).
        opened = {}
        for t, key, words, _ in sorted(self.stimuli.lines, key=lambda line: line[0]):
            name = words.split("=")[0]
            if name.startswith(("AP_OPNR", "AP_DETCHR")):
                number = int(name.split("A")[-1])
                if key == "set":
                    opened.setdefault(number, t)
                elif number in opened:
                    free.append((number, opened.pop(number), t + 0.2))
            if key == "press" and words.startswith("reference") and "all" not in words:
                number = int(words.split("A")[-1])
                free.append((number, t, t + 4))
            if key == "press" and words == "reference all":
                free += [(a.number, t, t + 2.4) for a in axes() if a.pulse]
        free += [(number, t, 1e9) for number, t in opened.items()]
        free += self.carried(free)
        facts += self.couplings()
        facts += [f"free {n} {lo:.4f} {hi:.4f}" for n, lo, hi in free]
        facts += [f"hard {lo:.4f} {hi:.4f}" for lo, hi in hard]
        facts += self.standing()
        facts += self.points(free)
        (self.folder / "facts.txt").write_text("\n".join(facts) + "\n")
        done = subprocess.run([JUDGE, self.folder / "facts.txt", trace], capture_output=True, text=True, check=False)
        if done.returncode:
            self.faults += (done.stdout + done.stderr).strip().splitlines()

    def acting(self, answer):
        """When the machine said that a coupling acts."""
        out, since = [], None
        for e in self.events:
            if e["ev"] != "flag" or e["name"] != answer:
                continue
            if e["value"] and since is None:
                since = e["t"]
            elif not e["value"] and since is not None:
                out.append((since, e["t"]))
                since = None
        return out + ([(since, 1e9)] if since is not None else [])

    def couplings(self):
        out = [f"tie {slave} {master} {sign} 0 1e9 1.2" for slave, (master, sign) in GANTRY.items()]
        for slave, (kind, master, sign, _, _, answer) in COUPLINGS.items():
            for lo, hi in self.acting(f"{answer} A{slave}"):
                if kind == "sync":
                    out.append(f"tie {slave} {master} {sign} {lo:.6f} {hi:.6f} 1e-6")   # 1 nm
                elif kind == "add":
                    out.append(f"add {slave} {master} {sign} {lo:.6f} {hi:.6f}")
        return out

    def carried(self, free):
        """What nobody commands carries its slaves along, and theirs."""
        follows = [(slave, c[1]) for slave, c in COUPLINGS.items()] + [(c[1], slave) for slave, c in COUPLINGS.items() if c[0] == "mix"] + [(slave, c[0]) for slave, c in GANTRY.items()]
        out, new = [], list(free)
        while new:
            new = [(slave, lo, hi) for n, lo, hi in new for slave, master in follows if master == n and (slave, lo, hi) not in out]
            out += new
        return out

    def behind(self, number, t):
        """The drive behind an address."""
        for slave, (kind, other, _, _, _, answer) in COUPLINGS.items():
            if kind == "mix" and number in (slave, other) and any(lo <= t <= hi for lo, hi in self.acting(f"{answer} A{slave}")):
                return other if number == slave else slave
        return number

    def standing(self):
        """Overrides at 0, forced answers that never come: the operator's and the PLC's own reasons."""
        out, since = [], {}
        for t, _, words, _ in sorted(self.stimuli.lines, key=lambda line: line[0]):
            if words.startswith(("feed_override", "rapid_override")):
                key, value = words.split("=")
                if value == "0":
                    since.setdefault(key, t)
                elif key in since:
                    out.append(f"still {key.split('L')[1]} {since.pop(key)} {t + 1}")
            if words.startswith("CP_MFIN"):
                out.append(f"still {words.split('L')[1].split('=')[0]} {t} {t + 30}")
        return out + [f"still {key.split('L')[1]} {t} 1e9" for key, t in since.items()]

    def points(self, free):
        """Ends of moves behind which the program went on at once: the command must have been there."""
        out, last = [], {}
        disturbed = sorted(t for t, _, words, _ in self.stimuli.lines)
        number = {(a.channel, a.name): a.number for a in axes()}
        moves = sorted((e for e in self.events if e["ev"] == "move" and "end" in e), key=lambda e: e["t"])
        for e in moves:
            before = last.get(e["ch"])
            last[e["ch"]] = e
            if not before or abs(before["end"] - e["t"]) > 1e-6 or before["end"] <= before["t"]:
                continue
            t = before["end"]
            if any(t - 4.5 <= d <= t + 0.1 for d in disturbed):   # what was asked shortly before may have changed the way
                continue
            for name, value in before.get("machine", {}).items():
                n = self.behind(number.get((e["ch"], name)), t)
                if n and not any(f[0] == n and f[1] <= t <= f[2] for f in free):
                    out.append(f"at {t:.6f} {n} {value}")
        self.checked = len(out)
        return out


def main():
    seconds = float(os.environ.get("HOUR_SECONDS", "120"))
    seed = os.environ.get("HOUR_SEED", "1")
    seed = random.SystemRandom().randrange(10**6, 10**9) if seed == "new" else int(seed)
    only = os.environ.get("HOUR_RUN")
    print(f"seed {seed}: {seconds:.0f} s of virtual time; HOUR_SEED={seed} HOUR_RUN=n repeats a run", flush=True)
    faulty = 0
    for number in ([int(only)] if only else range(int(max(1, round(seconds / RUN_S))))):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            if only:
                folder = pathlib.Path(f"hour-{seed}-{number}")
                folder.mkdir(exist_ok=True)
            episode = Episode(seed, number, folder)
            episode.run()
            print(f"{episode.name}: {len(episode.faults)} faults", flush=True)
            for fault in episode.faults[:20]:
                print("   ", fault, flush=True)
            faulty += bool(episode.faults)
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
