"""What happens to the machine of eight channels: operator, PLC, drives, deaths at random moments. Every few seconds somebody
puts all right again, so that programs run most of the time."""
REPAIR_EVERY_S = 9.0
REPAIR_TAKES_S = 3.5
LAST_S = 4.0


class Stimuli:
    def __init__(self, rng, seconds, blocks, deaths, machine):
        self.rng, self.seconds, self.blocks = rng, seconds, blocks
        self.lines = []          # (t, key, words, for)
        self.forced = {}         # signal -> since
        self.free = []           # (axis, from, to): its command is not the path's doing
        self.still = []          # (channel, from, to): it may stand
        self.dead = {}           # process -> t
        self.deaths = deaths
        self.axes = machine.axes()
        self.channels = machine.CHANNELS
        self.couplings = getattr(machine, "COUPLINGS", {})

    def add(self, t, key, words, duration=None):
        self.lines.append((round(t, 3), key, words, duration))

    def text(self):
        out = []
        for t, key, words, duration in sorted(self.lines, key=lambda line: line[0]):
            out.append(f'[[at]]\nt = {t:.3f}\n{key} = "{words}"\n' + (f"for = {duration}\n" if duration else ""))
        return "".join(out)

    def build(self):
        t = 0.3
        repair = REPAIR_EVERY_S
        while t < self.seconds - REPAIR_TAKES_S - LAST_S - 1:
            if t > repair:
                t = self.repair(t)
                repair = t + self.rng.uniform(0.4, 1.6) * REPAIR_EVERY_S
                continue
            self.one(t)
            t += self.rng.expovariate(1.0 / 0.35)
        if self.deaths:
            self.die()
        self.repair(self.seconds - REPAIR_TAKES_S - LAST_S)   # after all that, it can be brought to run again
        self.add(self.seconds, "press", "reset")
        return self

    def repair(self, t):
        for name, since in self.forced.items():
            self.add(t, "release", name)
        self.forced.clear()
        for a in self.axes:
            self.add(t, "set", f"drive A{a.number}=ok")
        for channel in range(1, self.channels + 1):
            for key in ("single_block", "dry_run", "machine_lock", "retrace", "program_wheel", "ignore_waits", "rapid_key", "first_part", "optional_stop"):
                self.add(t, "press", f"{key} L{channel}=off")
            self.add(t, "press", f"feed_override L{channel}=100")
            self.add(t, "press", f"rapid_override L{channel}=100")
        self.add(t + 0.05, "press", "reset")
        self.add(t + 0.30, "press", "machine_on")
        self.add(t + 0.60, "press", "reset")
        for channel in range(1, self.channels + 1):
            self.add(t + 0.65, "press", f"mode L{channel}=reference")
        self.add(t + 0.70, "press", "reference all")
        for channel in range(1, self.channels + 1):
            self.add(t + 2.9, "press", f"mode L{channel}=auto")
        self.add(t + 3.0, "press", "reset")
        self.add(t + 3.2, "press", "cycle_start")
        return t + REPAIR_TAKES_S

    def one(self, t):
        rng = self.rng
        if self.couplings and rng.random() < 0.2:
            return self.couple(t)
        l = rng.randint(1, self.channels)
        a = rng.choice(self.axes)
        on_off = rng.choice(("on", "off"))
        kind = rng.random()
        if kind < 0.10:
            self.add(t, "press", f"feed_hold L{l}")
            if rng.random() < 0.8:
                self.add(t + rng.uniform(0.02, 2), "press", f"cycle_start L{l}")
        elif kind < 0.24:
            self.add(t, "press", f"feed_override L{l}={rng.choice((0, 1, 20, 50, 80, 100, 120, 150, 200))}")
        elif kind < 0.30:
            self.add(t, "press", f"rapid_override L{l}={rng.choice((0, 5, 25, 50, 100))}")
        elif kind < 0.33:
            self.add(t, "press", f"spindle_override S{rng.randint(1, 2)}={rng.choice((50, 80, 100, 120))}")
        elif kind < 0.38:
            self.add(t, "press", f"cycle_start L{l}")
        elif kind < 0.42:
            self.add(t, "press", f"mode L{l}={rng.choice(('auto', 'mdi', 'jog', 'handwheel', 'reference'))}")
        elif kind < 0.50:
            self.add(t, "press", f"{rng.choice(('single_block', 'optional_stop', 'dry_run', 'rapid_key', 'first_part'))} L{l}={on_off}")
        elif kind < 0.52:
            self.add(t, "press", f"machine_lock L{l}={on_off}")
        elif kind < 0.55:
            self.add(t, "press", f"block_skip L{l}={rng.randint(-9, 9)}")
        elif kind < 0.61:   # by hand
            self.add(t, "press", f"feed_hold L{l}")
            how = rng.random()
            hand = [x for x in self.axes if x.channel == l]
            x = rng.choice(hand)
            sign = rng.choice("+-")
            if how < 0.4:   # in the hold, with the way back recorded
                self.add(t + 0.6, "press", f"jog_in_hold L{l}")
                self.add(t + 0.7, "press", f"jog A{x.number}{sign} {rng.uniform(0.05, 0.6):.2f}s")
                self.add(t + 1.6, "press", f"return L{l}")
                self.add(t + 2.6, "press", f"cycle_start L{l}")
            else:
                self.add(t + 0.5, "press", f"reset L{l}")
                self.add(t + 0.6, "press", f"mode L{l}={'handwheel' if how > 0.8 else 'jog'}")
                words = f"handwheel 1 A{x.number} {sign}{rng.randint(1, 200)}" if how > 0.8 else f"step A{x.number}{sign} {rng.choice((0.001, 0.01, 0.1, 1))}" if how > 0.6 else f"jog A{x.number}{sign} {rng.uniform(0.05, 1):.2f}s"
                self.add(t + 0.7, "press", words)
        elif kind < 0.64:   # back and forth on the path
            self.add(t, "press", f"feed_hold L{l}")
            self.add(t + 0.5, "press", f"retrace L{l}=on")
            self.add(t + 0.6, "press", f"cycle_start L{l}")
            self.add(t + rng.uniform(0.8, 2.5), "press", f"feed_hold L{l}")
            self.add(t + 3.0, "press", f"retrace L{l}=off")
            self.add(t + 3.1, "press", f"cycle_start L{l}")
        elif kind < 0.66:   # a handwheel is the time of its group
            self.add(t, "press", f"program_wheel L{l}=on")
            for n in range(6):
                self.add(t + 0.3 + 0.4 * n, "press", f"handwheel 1 L{l} {rng.choice('+-')}{rng.randint(5, 60)}")
            self.add(t + 3, "press", f"program_wheel L{l}=off")
        elif kind < 0.70:
            self.add(t, "press", f"reset L{l}")
            self.add(t + 0.4, "press", f"restart L{l}=N{rng.choice(self.blocks[l])}")
            self.add(t + 0.9, "press", f"cycle_start L{l}")
        elif kind < 0.72:
            self.add(t, "press", f"ignore_waits L{l}={on_off}")
        elif kind < 0.75:
            self.add(t, "press", "emergency_stop")
            if rng.random() < 0.5:
                self.add(t + rng.uniform(0.01, 1.5), "press", "machine_on")
        elif kind < 0.79:
            self.add(t, "press", f"mode L{l}=mdi")
            self.add(t + 0.1, "press", f"mdi L{l} {rng.choice(('G0 X150.', 'G98 G1 Z0. F3000', 'G4 X0.3', 'M8', 'G98 G1 U5. W-5. F500'))}")
        elif kind < 0.82:
            self.add(t, "set", f"drive A{a.number}={rng.choice(('fault', 'fault', 'encoder'))}")
        elif kind < 0.84:
            self.add(t, "press", f"reset L{l}" if rng.random() < 0.7 else "reset")
        elif kind < 0.86:
            self.add(t, "press", f"reference A{a.number}")
        elif kind < 0.88:
            self.add(t, "set", f"N0304 A{a.number}={a.rapid * rng.choice((0.5, 0.75, 1.0)):.0f}")
        else:
            self.flag(t, l, a)

    def flag(self, t, l, a):
        rng = self.rng
        name, value = rng.choice((
            (f"CP_STOP L{l}", 1), (f"CP_DOOROPEN L{l}", 1), (f"CP_SETUP L{l}", 1), (f"CP_NOLUBE L{l}", 1), (f"CP_BAREND L{l}", 1), (f"CP_TURRETOPEN L{l}", 1),
            (f"CP_TAILOPEN L{l}", 1), (f"CP_NOWT L{l}", 1), (f"CP_LIMSEL L{l}", 1), (f"CP_RAPIDKEY L{l}", 1), (f"CP_TMEAS L{l}", 1), (f"CP_JOGFD L{l}", rng.randint(0, 20)),
            ("SP_UNCLAMPED S1", 1), ("SP_UNCLAMPED S2", 1), ("PLC_ALARM", rng.randint(1, 20)), ("PLC_NOTE", rng.randint(1, 20)), ("PLC_ESTOP", 1),
            (f"AP_LIMSELP A{a.number}", 1), (f"AP_FLWU A{a.number}", 1), (f"AP_END A{a.number}", 1), (f"AP_OPNR A{a.number}", 1), (f"AP_DETCHR A{a.number}", 1),
            (f"CP_MFIN L{l}", 0), ("SP_ROT S1", rng.choice((3, 4, 5, 19))), ("SP_OREQ S1", 1), ("SP_PAR S2", 1)))
        self.add(t, "set", f"{name}={value}")
        if rng.random() < 0.7:
            self.add(t + rng.uniform(0.01, 3), "release", name)
        self.forced[name] = t   # released again with the next repair, whatever was said here

    def couple(self, t):
        """Somebody couples or lets go at a moment that no program knows of: the PLC by its flags, an operator by hand."""
        rng = self.rng
        slave = rng.choice(sorted(self.couplings))
        _, _, _, code, flag, _ = self.couplings[slave]
        kind = rng.random()
        if kind < 0.55:
            name = f"{flag} A{slave}"
            self.add(t, "set", f"{name}={rng.choice((1, 1, 1, 0))}")
            if rng.random() < 0.8:
                self.add(t + rng.uniform(0.05, 6), "release", name)
            self.forced[name] = t
        elif kind < 0.75:
            name = rng.choice(("SP_SYNCR S2", "SP_PHASER S2"))
            self.add(t, "set", f"{name}=1")
            if rng.random() < 0.8:
                self.add(t + rng.uniform(0.05, 6), "release", name)
            self.forced[name] = t
        else:
            l = rng.randint(1, self.channels)
            self.add(t, "press", f"reset L{l}")
            self.add(t + 0.5, "press", f"mode L{l}=mdi")
            self.add(t + 0.6, "press", f"mdi L{l} M{code + rng.randint(0, 1)}")
            self.add(t + rng.uniform(1, 5), "press", f"mode L{l}=auto")

    def die(self):
        """The last part of it goes on without somebody."""
        rng = self.rng
        t = rng.uniform(0.5, 0.9) * self.seconds
        for who in rng.sample([f"channel {n}" for n in range(1, self.channels + 1)] + ["plc", "toolmgmt"], rng.randint(1, 3)):
            if rng.random() < 0.25:
                self.add(t, "stop", who, round(rng.uniform(0.1, 3), 2))
            else:
                self.add(t, "kill", who)
                self.dead[who] = t
            t = min(t + rng.uniform(0.0, 5.0), self.seconds - 9)
