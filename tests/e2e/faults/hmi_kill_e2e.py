#!/usr/bin/env python3
"""A crash of the HMI never touches the machine, and on restart it shows the same screen: the process is killed with SIGKILL while two
channels cut, in real time. Without a display; needs the HMI (polyturn-hmi beside polyturn)."""
import configparser
import os
import signal
import struct
import subprocess
import time
import unittest
import zlib

from polyturn_runner import POLYTURN, Done, LiveCase, read_trace

HMI = POLYTURN.parent / "polyturn-hmi"
LIVES = 3
CUT = "O{0:04d}\nN10 G98 G0 X80. Z20.\n" + "".join(f"N{20 + i} G1 X{80 - i % 3}. Z{-4 * i}. F900.\n" for i in range(60)) + "M30\n"


def kept_paths(file):
    """{channel: points} of the piece that the HMI keeps (hmi/screens/graphics/kept_paths.cpp): z, x, flags; None while there is none."""
    try:
        data = zlib.decompress(file.read_bytes()[4:])
    except (OSError, zlib.error):
        return None
    at = 12                                             # mark, run
    length, = struct.unpack_from(">I", data, at)
    at += 4 + length
    count, = struct.unpack_from(">I", data, at)
    at += 4
    out = {}
    for _ in range(count):
        number, = struct.unpack_from(">I", data, at)
        size, = struct.unpack_from(">I", data, at + 4 + 8 + 4 + 4 + 1)
        at += 4 + 8 + 4 + 4 + 1 + 4
        out[number] = [struct.unpack_from("<ffB", data, at + 9 * i) for i in range(size // 9)]
        at += size
    return out


@unittest.skipUnless(HMI.exists(), "built without the HMI")
class HmiKill(LiveCase):
    def screens(self):
        environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_CONFIG_HOME=str(self.folder), XDG_RUNTIME_DIR=str(self.folder))
        log = open(self.folder / "hmi.log", "ab")
        self.addCleanup(log.close)
        hmi = subprocess.Popen([HMI, "--instance", self.name, "--lang", "en"], cwd=self.folder, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        self.addCleanup(lambda: hmi.poll() is None and (hmi.kill(), hmi.wait()))
        return hmi

    def kept(self):
        settings = configparser.ConfigParser(interpolation=None)
        settings.optionxform = str
        settings.read(self.folder / "polyturn" / f"hmi-{self.name}.ini", encoding="utf-8")
        return {section: dict(settings[section]) for section in settings.sections()}

    def test_the_machine_goes_on_and_the_same_screen_comes_back(self):
        os.chmod(self.folder, 0o700)
        programs = [self.write(f"O{n:04d}.nc", CUT.format(n)) for n in (1, 2)]
        ini = self.folder / "polyturn" / f"hmi-{self.name}.ini"
        ini.parent.mkdir()
        ini.write_text("[General]\nscreen=graphics\nchannel=2\n\n[screens]\ngraphics=machine 1.25 0.1 0\n", encoding="utf-8")
        events = open(self.folder / "events", "wb")
        self.addCleanup(events.close)
        self.running = subprocess.Popen([POLYTURN, "run", f"1={programs[0]}", f"2={programs[1]}", "--instance", self.name, "--trace", "trace.csv", "--set", "PT_LATE_MAX=1000"],
                                        cwd=self.folder, stdin=subprocess.DEVNULL, stdout=events, stderr=subprocess.STDOUT)
        piece = self.folder / f"polyturn-hmi-{self.name}.paths"
        before, seen = {}, []
        for life in range(LIVES):
            hmi = self.screens()
            began = time.time()
            self.wait_for(lambda: piece.exists() and piece.stat().st_mtime > began and len((kept_paths(piece) or {}).get(2, [])) > len(before.get(2, [])) + 5, 30, f"the paths of life {life}")
            self.assertIsNone(self.running.poll(), "the programs still run")
            now = kept_paths(piece)
            for channel, points in before.items():      # what was on the screen before the crash is on it again
                self.assertEqual(now[channel][:len(points)], points, f"life {life}, channel {channel}")
            before = now
            seen.append(self.kept())
            hmi.send_signal(signal.SIGKILL)
            self.assertEqual(hmi.wait(10), -signal.SIGKILL)
        for one in seen:
            self.assertEqual(one["General"]["screen"], "graphics")
            self.assertEqual(one["General"]["channel"], "2")
            self.assertEqual(one["screens"]["graphics"], "machine 1.25 0.1 0")
        self.assertEqual(set(before), {1, 2})
        # The machine has noticed nothing: every tick is in the trace, every move follows the one before.
        self.running.wait(120)
        events.flush()
        done = Done(self.running.returncode, (self.folder / "events").read_text(encoding="utf-8", errors="replace"), "")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(done.alarms, [], done.said())
        ticks = read_trace(self.folder / "trace.csv")["t"]
        self.assertGreater(len(ticks), 5000)
        steps = sorted({round(b - a, 6) for a, b in zip(ticks, ticks[1:])})
        self.assertEqual(len(steps), 1, f"a gap in the trace: {steps}")
        for channel in (1, 2):
            moves = done.of("move", ch=channel)
            self.assertEqual(len(moves), 61)
            for first, second in zip(moves, moves[1:]):
                self.assertLess(abs(second["t"] - first["end"]), 0.02, f"channel {channel} stood still: {first} {second}")


if __name__ == "__main__":
    unittest.main()
