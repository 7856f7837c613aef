"""A lathe whose slides are coupled in every way, and programs that couple, exchange, cut and let go: what the hour of couplings
drives (issue 4). Four channels; A9 is a hidden motor beside A5.

    A4 Z of L2   synchronous to A2 (M61, M62)              A3 X of L2   exchanged with A1 (M63, M64)
    A8 Z of L4   synchronous to A4, mirrored (M65, M66)    A6 Z of L3   superimposed on A2, subtracted (M67, M68)
    A7 X of L4   superimposed on A5 (M69, M70)             A9           gantry slave of A5, always
    S2 follows S1 (M71: as it comes, M72: in phase, M73: free)
"""
from eight_channels import TICK_S, Axis  # noqa: F401

CHANNELS = 4
SPINDLES = 2
TOGETHER = "1234"
# slave: (kind, master, sign, code that switches it on, flag of the PLC, answer)
COUPLINGS = {
    4: ("sync", 2, 1, 61, "AP_SYNCR", "AN_SYNCA"),
    3: ("mix", 1, 1, 63, "AP_MIXR", "AN_MIXA"),
    8: ("sync", 4, -1, 65, "AP_SYNCR", "AN_SYNCA"),
    6: ("add", 2, -1, 67, "AP_SPRPNR", "AN_SPRPNA"),
    7: ("add", 5, 1, 69, "AP_SPRPNR", "AN_SPRPNA"),
}
GANTRY = {9: (5, 1)}
WATCH = [f"{answer} A{slave}" for slave, (_, _, _, _, _, answer) in COUPLINGS.items()] + ["SN_SYNCA S2"]


def axes():
    out = []
    for channel in range(1, CHANNELS + 1):
        slow = (1.0, 0.7, 0.9, 0.6)[channel - 1]   # a slave has lower limits than its master
        out += [Axis(2 * channel - 1, channel, "X", 12000 * slow, 2500 * slow, 0.05, -250, 420), Axis(2 * channel, channel, "Z", 18000 * slow, 3000 * slow, 0.05, -900, 900)]
    out.append(Axis(9, 3, "Y", 9000, 2000, 0.05, -250, 420))
    return out


def machine_lines():
    lines = ["N0005=1000", "N2201=500", "N2202=599", "PT_COUPLE_TIMEOUT=3"]
    for channel in range(1, CHANNELS + 1):
        lines += [f"N0000 L{channel}=1", f"PT_LANGUAGE L{channel}=fanuc", f"N0104 L{channel}=0", f"N0105 L{channel}=2", f"N0604 L{channel}=1", f"N0687 L{channel}={2 * channel - 1}",
                  f"N1300 L{channel}=00000010", f"N1301 L{channel}=01000001", f"N1337 L{channel}=00000010", f"N1400 L{channel}=32", f"N1413 L{channel}=2", f"PT_TURRET_STATIONS L{channel}=8",
                  f"N1317 L{channel}=60", f"N1325 L{channel}=73"]
    for a in axes():
        n = a.number
        role = {"X": 1, "Y": 2, "Z": 3}[a.name]
        lines += [f"N0002 A{n}={a.channel}", f"N0100 A{n}={ord(a.name)}", f"N0103 A{n}={role}", f"N0106 A{n}={1 if a.name == 'X' else 0}",
                  f"N0302 A{n}={a.rapid / 4}", f"N0303 A{n}=300", f"N0304 A{n}={a.rapid}", f"N0505 A{n}={a.rapid * 1.15}", f"N0305 A{n}={a.rapid / 2}", f"N0314 A{n}={a.rapid / 2}", f"N0315 A{n}={a.rapid / 4}",
                  f"N0400 A{n}={a.acceleration}", f"N0401 A{n}={a.rise}", f"N0504 A{n}=40", f"N0511 A{n}=1", f"N0515 A{n}=00000011", f"N0516 A{n}=0.005", f"N0518 A{n}=0.025",
                  f"N0519 A{n}=0.1", f"N0520 A{n}=1", f"N0521 A{n}=10", f"N1000 A{n}=00000001", f"N1002 A{n}={a.high}", f"N1003 A{n}={a.low}", f"N1004 A{n}={a.high - 5}", f"N1005 A{n}={a.low + 5}",
                  f"PT_ESTOP_DEC A{n}={a.estop}", f"N0900 A{n}=8"]
    for slave, (kind, master, sign, code, _, _) in COUPLINGS.items():
        if kind == "sync":
            lines += [f"N2101 A{slave}={master}", f"N2102 A{slave}={int(sign < 0) + (4 if slave == 4 else 0)}", f"N0522 A{slave}=40", f"PT_M_SYNC A{slave}={code}"]
        elif kind == "add":
            lines += [f"N2107 A{slave}={master}", f"N2108 A{slave}={int(sign < 0)}", f"PT_M_SUPER A{slave}={code}"]
        else:
            lines += [f"N2104 A{slave}={master}", f"PT_M_MIX A{slave}={code}"]
    for slave, (master, _) in GANTRY.items():
        lines += [f"N2101 A{slave}={master}", f"N2102 A{slave}=16", f"N0522 A{slave}=10", f"N2103 A{slave}=1"]
    for s in range(1, SPINDLES + 1):
        lines += [f"N0607 S{s}=00000111", f"N0608 S{s}=4096", f"N0610 S{s}=0", f"N0627 S{s}=5", f"N0628 S{s}=10", f"N0629 S{s}=10", f"N0634 S{s}=5000", f"N0642 S{s}=20", f"N0650 S{s}=4500",
                  f"N0666 S{s}=1500", f"N0674 S{s}=1500", f"N0701 S{s}=20", f"N0761 S{s}=0", f"N0769 S{s}=0", f"N0777 S{s}=0"]
    lines += ["PT_SPINDLE_MASTER S2=1", "PT_M_FOLLOW S2=71"]
    return lines


def plan(rng):
    """What all four programs do between their meetings: [(codes that switch on, in the channel that says them)]."""
    parts = []
    for _ in range(rng.randint(2, 4)):
        slaves = rng.sample(sorted(COUPLINGS), rng.randint(0, 3))
        if 3 in slaves and rng.random() < 0.5:
            slaves.remove(3)
        parts.append((sorted(slaves), rng.random() < 0.4, rng.randint(1, 4)))
    return parts


def program(rng, channel, parts=None):
    """A program of half a minute. `parts` is common to all channels: without it they would not fit together."""
    lines, number = [f"O{1000 + channel}"], 10
    slow = (1.0, 0.7, 0.9, 0.6)[channel - 1]

    def block(text):
        nonlocal number
        lines.append(f"N{number} {text}")
        number += 10

    block("G98")
    if channel == 1:   # what an earlier run has left
        for code in sorted(code for _, _, _, code, _, _ in COUPLINGS.values()):
            block(f"M{code + 1}")
        block("M73")
        block(f"G97 S{rng.randint(300, 1200)} M3")
    block(f"M500 P{TOGETHER}")
    block("G0 X200. Z100.")
    for n, (slaves, follows, who) in enumerate(parts):
        meet = 510 + 5 * n
        block(f"M{meet} P{TOGETHER}")
        if channel == who:
            for slave in slaves:
                block(f"M{COUPLINGS[slave][3]}")
            if follows:
                block(f"M{rng.choice((71, 72))}")
        block(f"M{meet + 1} P{TOGETHER}")
        still = {s for s in slaves if COUPLINGS[s][0] == "sync"}
        x, z = 200.0, 100.0
        for _ in range(rng.randint(3, 8)):
            kind = rng.random()
            to_x, to_z = x + rng.uniform(-40, 40), z + rng.uniform(-60, 60)
            to_x, to_z = min(max(to_x, 120), 280), min(max(to_z, 20), 180)
            words = "" if 2 * channel - 1 in still else f" X{to_x:.3f}"
            words += "" if 2 * channel in still else f" Z{to_z:.3f}"
            if not words or kind > 0.9:
                block(f"G4 X{rng.uniform(0.05, 0.4):.2f}")
                continue
            block(f"G0{words}" if kind < 0.3 else f"G1{words} F{rng.randint(300, int(5000 * slow))}.")
            x, z = (x if 2 * channel - 1 in still else to_x), (z if 2 * channel in still else to_z)
        block(f"M{meet + 2} P{TOGETHER}")
        if channel == who:
            for slave in reversed(slaves):
                block(f"M{COUPLINGS[slave][3] + 1}")
            if follows:
                block("M73")
        block(f"M{meet + 3} P{TOGETHER}")
        block("G0 X200. Z100.")
    block(f"M590 P{TOGETHER}")
    if channel == 1:
        block("M5")
    block("M30")
    return "\n".join(lines) + "\n", list(range(20, number - 10, 10))
