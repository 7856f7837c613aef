"""A lathe with eight channels, and programs for them: what the hour's test drives. Everything here comes from one random
generator, so that a seed is a test."""
import dataclasses

CHANNELS = 8
TICK_S = 0.001
WAIT_FIRST = 500


@dataclasses.dataclass
class Axis:
    number: int
    channel: int
    name: str
    rapid: float          # mm/min
    acceleration: float   # mm/s2
    rise: float           # s
    low: float
    high: float
    estop: float = 10000.0
    pulse: bool = False   # referenced by a zero pulse; otherwise it has an absolute encoder

    @property
    def jerk(self):
        return self.acceleration / self.rise


def axes():
    out = []
    for channel in range(1, CHANNELS + 1):
        fast = 1.0 + 0.1 * (channel % 3)
        x = Axis(2 * channel - 1, channel, "X", 12000 * fast, 2500 * fast, 0.05, -30, 220, pulse=channel > 4)
        z = Axis(2 * channel, channel, "Z", 18000 * fast, 3000, 0.04 + 0.01 * (channel % 2), -320, 420, pulse=channel > 6)
        out += [x, z]
    return out


def machine_lines():
    lines = ["N0005=1000", "N2201=500", "N2202=599", "PT_PARTNER_DEATH=1 "]
    for channel in range(1, CHANNELS + 1):
        group = 1 if channel <= 5 else 2   # the last three are another machine beside the first
        lines += [f"N0000 L{channel}={group}", f"PT_LANGUAGE L{channel}=fanuc", f"N0104 L{channel}=0", f"N0105 L{channel}=2", f"N0604 L{channel}={1 if group == 1 else 2}",
                  f"N0687 L{channel}={2 * channel - 1}", f"N1300 L{channel}=00000010", f"N1301 L{channel}=01000001", f"N1337 L{channel}=00000010", f"N1400 L{channel}=32",
                  f"N1413 L{channel}=2", f"PT_TURRET_STATIONS L{channel}=8", f"N1001 L{channel}=00000100"]
    for a in axes():
        n = a.number
        lines += [f"N0002 A{n}={a.channel}", f"N0100 A{n}={ord(a.name)}", f"N0103 A{n}={1 if a.name == 'X' else 3}", f"N0106 A{n}={1 if a.name == 'X' else 0}",
                  f"N0302 A{n}={a.rapid / 4}", f"N0303 A{n}=300", f"N0304 A{n}={a.rapid}", f"N0505 A{n}={a.rapid * 1.15}", f"N0305 A{n}={a.rapid / 2}", f"N0314 A{n}={a.rapid / 2}", f"N0315 A{n}={a.rapid / 4}",
                  f"N0400 A{n}={a.acceleration}", f"N0401 A{n}={a.rise}", f"N0504 A{n}=40", f"N0511 A{n}=1", f"N0515 A{n}=00000011", f"N0516 A{n}=0.005", f"N0518 A{n}=0.025",
                  f"N0519 A{n}=0.1", f"N0520 A{n}=1", f"N0521 A{n}=10", f"N1000 A{n}=00000001", f"N1002 A{n}={a.high}", f"N1003 A{n}={a.low}", f"N1004 A{n}={a.high - 5}", f"N1005 A{n}={a.low + 5}",
                  f"PT_ESTOP_DEC A{n}={a.estop}"]
        lines += [f"N0900 A{n}=2", f"N0904 A{n}=10", f"N0200 A{n}={100 if a.name == 'X' else 50}"] if a.pulse else [f"N0900 A{n}=8"]
    for s in (1, 2):
        lines += [f"N0607 S{s}=00000111", f"N0608 S{s}=4096", f"N0610 S{s}=0", f"N0627 S{s}=5", f"N0628 S{s}=10", f"N0629 S{s}=10", f"N0634 S{s}=5000", f"N0642 S{s}=20", f"N0650 S{s}=4500",
                  f"N0666 S{s}=1500", f"N0674 S{s}=1500"]
    return [line.replace(" =", "=").strip() for line in lines if "PT_PARTNER" not in line]


def program(rng, channel):
    """A program of some half a minute: cuts, arcs, threads, dwells, tools, meetings. Ends where it began."""
    lines, number = [f"O{1000 + channel}"], 10
    meeting = WAIT_FIRST if channel <= 5 else WAIT_FIRST + 50
    together = "12345" if channel <= 5 else "678"
    leader = channel in (1, 6)

    def block(text):
        nonlocal number
        skip = f"/{rng.randint(1, 9)} " if rng.random() < 0.05 and text.startswith("G4") else ""
        lines.append(f"{skip}N{number} {text}")
        number += 10

    def point():
        return rng.uniform(20, 300), rng.uniform(-250, 250)   # X as a diameter

    block("G98 G0 X200. Z100.")
    if leader:
        block(f"G97 S{rng.randint(300, 1500)} M3")
    else:
        block("G4 X0.1")
    for part in range(rng.randint(2, 4)):
        block(f"M{meeting + part} P{together}")
        x, z = 200.0, 100.0
        for _ in range(rng.randint(6, 14)):
            kind = rng.random()
            if kind < 0.30:
                x, z = point()
                block(f"G0 X{x:.3f} Z{z:.3f}")
            elif kind < 0.60:
                x, z = point()
                block(f"G1 X{x:.3f} Z{z:.3f} F{rng.randint(200, 8000)}.")
            elif kind < 0.72:   # a run of short ones
                for _ in range(rng.randint(5, 40)):
                    x, z = min(max(x + rng.uniform(-2, 2), 10), 320), min(max(z + rng.uniform(-2, 2), -260), 260)
                    block(f"G1 X{x:.3f} Z{z:.3f} F{rng.randint(500, 5000)}.")
            elif kind < 0.84:   # a quarter arc
                r = rng.uniform(1, 30)
                up = rng.choice((-1, 1))
                if 10 < x + 2 * up * r < 330:
                    x, z = x + 2 * up * r, z - r
                    if z > -260:
                        block(f"G{rng.choice((2, 3))} X{x:.3f} Z{z:.3f} R{r:.3f} F{rng.randint(300, 4000)}.")
                    else:
                        z += r
                        x -= 2 * up * r
            elif kind < 0.88:
                block(f"G4 X{rng.uniform(0.05, 0.6):.2f}")
            elif kind < 0.92:
                tool = rng.randint(1, 8)
                block(f"T{tool:02d}00")
            elif kind < 0.96:
                block(rng.choice(("M8", "M9", "M1")))
            elif leader:
                block(f"S{rng.randint(300, 1500)}")
            else:
                block("G61" if rng.random() < 0.5 else "G64")
        if leader and rng.random() < 0.7:   # a thread in line with the axis
            block(f"G0 X{x:.3f} Z100.")
            block(f"G99 G32 Z60. F{rng.uniform(0.8, 2.0):.2f}")
            block("G98 G0 X250.")
        block("G0 X200. Z100.")
    block(f"M{meeting + 20} P{together}")
    if leader:
        block("M5")
    block("M30")
    return "\n".join(lines) + "\n", list(range(20, number - 10, 10))
