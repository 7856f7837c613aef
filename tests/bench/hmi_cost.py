#!/usr/bin/env python3
"""What the screens cost while eight channels cut: frames a second, share of one core, the longest time in which a touch waits, time to
the first screen, for every page of every screen: the scope with eight traces, the timeline and the synchronised view of a job with all the
channels among them. Starts a controller of its own (the twin-turret machine with further channels like its second one) and a program in
each channel, then `polyturn-hmi --measure` without a display.

  python3 tests/bench/hmi_cost.py --bin build/release/bin [--channels 8] [--seconds 2]

Exit status 1: a bound was passed (15 % of one core, 60 frames a second, 50 ms, 1 s); the bounds are for a Release build on a computer that has time.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

TOP = pathlib.Path(__file__).resolve().parents[2]
TRACES = ("command A1", "measured A2", "error A2", "velocity A2", "torque A2", "speed S1", "path L1", "velocity A4")
PROGRAM = "O{0:04d}\nN10 G0 G98 X60. Z5.\n" + "".join(f"N{20 + i} G1 X{40 + i % 7}. Z-{i % 50}. F{300 + i}.\n" for i in range(400)) + "N900 M99\n"


def machine_with(channels):
    """Further channels, each with X and Z like those of channel 2."""
    text = (TOP / "examples/machines/twin-turret/machine.params").read_text(encoding="utf-8")
    out, axis = text, 7
    for channel in range(3, channels + 1):
        out += f"\nN0000 L{channel}=1\n"
        for name, scope, value in re.findall(r"^(\w+) (A3|A4|L2)=([^;\s]+)", text, re.M):
            if scope == "L2":
                if name not in ("N0000", "N0687", "PT_TURRET_MAGAZINE"):
                    out += f"{name} L{channel}={value}\n"
                continue
            number = axis + (scope == "A4")
            value = {"N0002": str(channel), "N0501": str(number), "N0503": str(number)}.get(name, value)
            out += f"{name} A{number}={value}\n"
        axis += 2
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=str(TOP / "build/release/bin"))
    parser.add_argument("--channels", type=int, default=8)
    parser.add_argument("--seconds", type=float, default=2)
    options = parser.parse_args()
    name = f"hmi-cost-{os.getpid()}"
    options.bin = os.path.abspath(options.bin)
    polyturn = os.path.join(options.bin, "polyturn")
    with tempfile.TemporaryDirectory() as folder:
        machine = os.path.join(folder, "many.params")
        pathlib.Path(machine).write_text(machine_with(options.channels), encoding="utf-8")
        log = open(os.path.join(folder, "log"), "w")
        controller = subprocess.Popen([polyturn, "start", machine, "--instance", name, "--store", os.path.join(folder, "store"), "--no-hmi", "--set", "PT_PLC_CYCLE=100", "--set", "PT_LATE_MAX=1000"],
                                      stdout=log, stderr=subprocess.STDOUT)

        def press(*words):
            done = subprocess.run([polyturn, "press", *words, "--instance", name], capture_output=True, text=True)
            if done.returncode:
                print(done.stdout + done.stderr, file=sys.stderr)

        try:
            for _ in range(120):
                if subprocess.run([polyturn, "status", "--instance", name], capture_output=True).returncode == 0:
                    break
                time.sleep(0.5)
            press("machine_on")
            time.sleep(2)
            press("reference", "all")
            time.sleep(5)
            for channel in range(1, options.channels + 1):
                file = os.path.join(folder, f"O{channel:04d}.nc")
                pathlib.Path(file).write_text(PROGRAM.format(channel), encoding="utf-8")
                press("select", f"L{channel}={file}")
            press("cycle_start")
            for trace, signal in enumerate(TRACES, 1):
                press("scope", str(trace), *signal.split())
            time.sleep(2)
            state = subprocess.run([polyturn, "status", "--instance", name], capture_output=True, text=True).stdout
            running = len(re.findall(r"^\s+L\d+\s+running", state, re.M))
            print(f'{{"channels_running":{running}}}')
            if running < options.channels:
                print(state, pathlib.Path(folder, "log").read_text(), file=sys.stderr)
                return 2
            job = pathlib.Path(folder, "job")      # the same programs with an end, for the dry runs
            job.mkdir()
            for channel in range(1, options.channels + 1):
                (job / f"O{channel:04d}.nc").write_text(PROGRAM.format(channel).replace("M99", "M30"), encoding="utf-8")
            rows = "".join(f'{channel} = {{ file = "O{channel:04d}.nc", language = "fanuc" }}\n' for channel in range(1, options.channels + 1))
            (job / "cost.job.toml").write_text(f'name = "cost"\n\n[programs]\n{rows}', encoding="utf-8")
            done = subprocess.run([os.path.join(options.bin, "polyturn-hmi"), "--instance", name, "--lang", "en", "--measure", str(options.seconds)], cwd=job, env=dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_RUNTIME_DIR=folder))
            return done.returncode
        finally:
            controller.terminate()
            try:
                controller.wait(20)
            except subprocess.TimeoutExpired:
                controller.kill()
            subprocess.run([polyturn, "clean"], capture_output=True)


if __name__ == "__main__":
    sys.exit(main())
