#!/usr/bin/env python3
"""Pictures of every screen with something on it: starts a controller with a chain and a matrix magazine beside its turrets, enters tools,
measured parts, pallets, users and a table of compensation, makes pictures for the presetter and calibrates it, runs a program into an alarm, lets the two-channel job run
and stand, then saves the screens; then a program that asks, for its dialogue, one that drives circles, for the plot of circularity, and last
the machine with a counter spindle, for the part transfer and for couplings.

  python3 tools/take_screens.py --bin build/dev/bin --out pictures [--lang en] [--theme dark] [--size 1280x800] [--only diagnosis-7]
"""
import argparse
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

TOP = pathlib.Path(__file__).resolve().parent.parent
# A program that asks: Fanuc's pattern data input (G65 H90 ..), a menu of two patterns and the values of one.
ASKS = {"O9500.nc": "O9500\nG65 H90 P072079 Q076069\nG65 H91 P1 Q066079 R076084\nG65 H91 P2 Q071082 R073068\nM99\n",
        "O9502.nc": "O9502\nG65 H92 P071082 Q073068\nG65 H93 P500 Q080073 R084067 I072000\nG65 H93 P501 Q067079 R085078 I084000\nG65 H94 P079078 Q076089\nM99\n",
        "O0001.nc": "O1\nM98 P9500\n#502=#500*2\nG4 X0.1\nM30\n"}
# Circles without a rest between them; one axis is told a little less of its speed than the other, so that they come out oval.
CIRCLES = "O0003\nN10 G98 G0 X80. Z10.\nN20 G1 Z0 F2400.\nN30 G2 U0 W-30. R15.\nN40 G2 U0 W30. R15.\nN50 GOTO 30\n"
# A pitch error table of the axis Z of L1, how straight its X stays along it, and their grid of 4 by 5 points.
COMPENSATION = ["N2500 A2=1", "N2501 A2=10", "N2502 A2=10010", "N2503 A2=10000", "N2504 A2=10020", "N2601 L1=2", "N2607 L1=1", "N2613 L1=10100",
                "N2700 L1=1", "N2701 L1=2", "N2703 L1=4", "N2704 L1=5", "N2707 L1=2", "N2709 L1=50", "N2710 L1=100"]
MACHINE = ["N2912=24", "N2905=00001000", "N2920=4", "N2921=6", "N3300=3", "N3301=4", "PT_PLC_CYCLE=100", "PT_LATE_MAX=1000"]


def shadow(path, covers, size=640, um=5.0):
    """A tool's shadow, dark on bright, eight bits, as a presetter's camera sees it: a pixel on an edge is the share that is covered."""
    mm, noise = um / 1000, random.Random(7)
    rows = bytearray()
    for py in range(size):
        w = (size / 2 - py) * mm
        for px in range(size):
            u = (px - size / 2) * mm
            corners = [covers(u + dx * mm, w + dy * mm) for dx, dy in ((-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5))]
            if all(corners) or not any(corners):
                share = 1.0 if corners[0] else 0.0
            else:
                share = sum(covers(u + (i / 8 - 0.4375) * mm, w + (j / 8 - 0.4375) * mm) for i in range(8) for j in range(8)) / 64
            rows.append(max(0, min(255, round(220 - 190 * share + noise.gauss(0, 2)))))
    path.write_bytes(b"P5\n%d %d\n255\n" % (size, size) + bytes(rows))


def wedge(z, x):
    """An insert of 55 degrees with a nose radius of 0.4 mm that points down and to the left."""
    r, e1, e2 = 0.4, math.radians(38), math.radians(93)
    axis, half = (e1 + e2) / 2, (e2 - e1) / 2
    dz, dx = z + 0.5, x + 0.6
    along, across = dz * math.cos(axis) + dx * math.sin(axis), -dz * math.sin(axis) + dx * math.cos(axis)
    if along <= 0 or abs(across) > along * math.tan(half):
        return False
    if along >= r / math.tan(half) * math.cos(half):
        return True
    to = r / math.sin(half)
    return math.hypot(dz - to * math.cos(axis), dx - to * math.sin(axis)) <= r


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=str(TOP / "build/dev/bin"))
    parser.add_argument("--out", required=True)
    parser.add_argument("--lang", default="")
    parser.add_argument("--theme", default="")
    parser.add_argument("--size", default="1280x800")
    parser.add_argument("--only", default="", help="pictures whose name begins so, or one page: offsets, diagnosis-7")
    options = parser.parse_args()
    name, binary = f"screens-{os.getpid()}", pathlib.Path(options.bin).resolve()

    def run(*words, stdin=None):
        done = subprocess.run([binary / "polyturn", *words, "--instance", name], capture_output=True, text=True, input=stdin)
        if done.returncode:
            print(" ".join(words), done.stdout, done.stderr, file=sys.stderr)
        return done.stdout

    with tempfile.TemporaryDirectory() as folder:
        job = pathlib.Path(folder, "shaft")
        shutil.copytree(TOP / "examples/jobs/shaft", job)
        shadow(job / "finish-35.pgm", wedge)
        shadow(job / "gauge-pin.pgm", lambda z, x: x >= 0 and abs(z) <= 1.5)
        programs = sorted(job.glob("*.nc"))
        (job / (programs[0].stem + "-old.nc")).write_text(programs[0].read_text(encoding="utf-8").replace("F0.2", "F0.25").replace("M30", "M99", 1), encoding="utf-8")
        first = programs[0].read_text(encoding="utf-8")
        programs[0].write_text(first.replace("N20 ", "N11 #1=12.5\nN12 #101=#1*2\nN13 #500=[#101+1]/3\nN20 ", 1), encoding="utf-8")   # variables
        (job / "wrong.nc").write_text("O0009\nN10 G0 X40. Z2.\nN20 G2 X60. Z-12. I5. K0. F0.1\nM30\n", encoding="utf-8")              # its arc has two radii
        machine = pathlib.Path(folder, "machine")
        shutil.copytree(TOP / "examples/machines/twin-turret", machine)
        with open(machine / "machine.params", "a", encoding="utf-8") as file:
            file.write("\n" + "\n".join(COMPENSATION) + "\n")
        cells = "".join(f"{10000 + i}={0.006 * math.sin(i / 4) + 0.0007 * (i - 10):.4f}\n{10100 + i}={0.004 * math.cos((i - 10) / 5) - 0.004:.4f}\n" for i in range(21))
        points = "".join(f"3D L1 {i + 4 * k}={0.002 * i * (1 + 0.3 * (k - 2)):.4f} {0.0015 * (k - 2) + 0.0004 * i * (k - 2) ** 2:.4f} 0\n" for k in range(5) for i in range(4))
        (machine / "machine.compensation").write_text(cells + points, encoding="ascii")
        sets = [word for line in MACHINE for word in ("--set", line)]

        def start(machine, sets):
            with open(os.path.join(folder, "log"), "a") as log:
                started = subprocess.Popen([binary / "polyturn", "start", machine, "--instance", name, "--store", os.path.join(folder, f"store-{machine.name}"), "--no-hmi", *sets], stdout=log, stderr=subprocess.STDOUT)
            for _ in range(120):
                if subprocess.run([binary / "polyturn", "status", "--instance", name], capture_output=True).returncode == 0:
                    break
                time.sleep(0.5)
            return started

        def end(running):
            running.terminate()
            try:
                running.wait(20)
            except subprocess.TimeoutExpired:
                running.kill()

        controller = start(machine, sets)
        try:
            tools = [("ROUGH_80", 1, 500, 1, 1, 60, 52), ("ROUGH_80", 1, 500, 1, 2, 60, 12), ("FINISH_35", 3, 510, 1, 3, 45, 44.2), ("GROOVE_3", 5, 520, 1, 5, 30, 4), ("THREAD_60", 7, 540, 1, 7, 0, 0),
                     ("DRILL_8", 9, 200, 2, 2, 90, 10), ("BORE_12", 11, 550, 2, 4, 90, 89), ("MILL_10", 13, 120, 3, 3, 60, 20), ("MILL_16", 15, 120, 3, 9, 60, 59), ("TAP_M8", 17, 240, 3, 14, 0, 0), ("PROBE", 19, 580, 4, 8, 0, 0),
                     ("DRILL_3", 21, 200, 4, 15, 40, 39), ("REAMER_10", 23, 250, 4, 22, 80, 1), ("SPARE_80", 1, 500, 0, 0, 60, 0)]
            for number, (tool, kind, code, magazine, pot, life, counter) in enumerate(tools, 1):
                run("tools", "add", str(number), f"name={tool}", f"type={kind}", f"h={number}", f"kind={code}", *([f"life_kind=minutes", f"life={life}", f"counter={counter}", "warning=5"] if life else []))
                if magazine:
                    run("tools", "load", str(number), str(magazine), str(pot))
            for number, (dimension, nominal, upper, lower, tool, axis) in enumerate([("Bearing seat D 30 h6", 30, 0, -0.013, 3, "X"), ("Shoulder L 42", 42, 0.05, -0.05, 3, "Z"), ("Groove D 26", 26, 0.1, -0.1, 4, "X")], 1):
                run("parts", "add", str(number), f"name={dimension}", f"nominal={nominal}", f"upper={upper}", f"lower={lower}", f"tool={tool}", f"axis={axis}", "average=3")
                for part in range(9 if number == 1 else 4 if number == 2 else 0):
                    run("parts", "measure", str(number), f"{nominal - 0.009 + 0.0011 * part + 0.0008 * (part % 3):.4f}")
            run("pallets", "set", "2", "pallet=12", f"program=1001")
            run("press", "machine_on")
            time.sleep(3)
            run("press", "reference", "all")
            time.sleep(6)
            for channel, wear in (("L1", "-0.02"), ("L2", "0.015")):
                run("set", f"offset {channel} 3 geometry X=42.5"), run("set", f"offset {channel} 3 wear X={wear}")
            for channel in ("L1", "L2"):   # as the job has them, so that workpiece and machine are not the same
                run("set", f"zero {channel} G54 Z=-150")
            run("presetter", "calibrate", str(job / "gauge-pin.pgm"), "diameter=3", "x=50", "z=30", "--calibration", os.path.join(folder, "polyturn", f"presetter-{name}.json"))
            run("press", f"select L1={job}/wrong.nc")
            run("press", "cycle_start L1")
            time.sleep(3)
            run("press", "reset")
            time.sleep(1)
            for trace, signal in enumerate(("command A2", "velocity A2", "error A2", "torque A2", "speed S1", "path L1", "measured A4", "left L2"), 1):
                run("press", f"scope {trace} {signal}")
            run("press", f"select {job}/shaft.job.toml")
            run("press", "cycle_start")
            time.sleep(4)
            run("press", "feed_hold L1")
            time.sleep(8)                       # a stop and a wait for the log
            run("press", "cycle_start L1")
            time.sleep(2)
            run("press", "single_block L2=on")
            time.sleep(4)
            run("press", "single_block L2=off"), run("press", "cycle_start L2")
            run("users", "add", "anna", "maker", f"uid={os.getuid()}", stdin="secret-1\nsecret-1\n")
            run("users", "add", "boris", "operator", stdin="secret-2\nsecret-2\n")
            words = [word for option, value in (("--lang", options.lang), ("--theme", options.theme)) if value for word in (option, value)]

            def pictures(only):
                return subprocess.run([binary / "polyturn-hmi", "--instance", name, "--size", options.size, *words, "--screenshots", os.path.abspath(options.out), *(["--only", only] if only else [])], cwd=job,
                                      env=dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_RUNTIME_DIR=folder, XDG_CONFIG_HOME=folder)).returncode

            done = 0 if options.only == "dialogue" else pictures(options.only)
            if done == 0 and options.only in ("", "dialogue"):
                asks = pathlib.Path(folder, "asks")
                asks.mkdir()
                for file, text in ASKS.items():
                    (asks / file).write_text(text, encoding="utf-8")
                run("press", "reset")
                time.sleep(2)
                run("press", f"select L1={asks}/O0001.nc"), run("press", "cycle_start L1")
                time.sleep(2)
                done = pictures("dialogue")
            if done == 0 and options.only in ("", "diagnosis", "diagnosis-8"):
                circles = pathlib.Path(folder, "circles.nc")
                circles.write_text(CIRCLES, encoding="ascii")
                run("press", "reset")
                time.sleep(2)
                run("params", "set", "N0511 A1=0.995")
                for trace, signal in enumerate(("command A1", "command A2", "measured A1", "measured A2"), 1):
                    run("press", f"scope {trace} {signal}")
                run("press", f"select L1={circles}"), run("press", "cycle_start L1")
                time.sleep(6)
                done = pictures("diagnosis-8")
            if done == 0 and options.only in ("", "manual", "manual-2", "diagnosis", "diagnosis-3"):   # part transfer, on the machine that passes parts
                end(controller)
                controller = start(TOP / "examples/machines/transfer", [])
                run("press", "machine_on")
                time.sleep(3)
                run("press", "reference", "all")
                time.sleep(6)
                run("press", "mode L1=jog L2=jog")
                run("press", "hand_key L2 M72")
                time.sleep(1)
                run("press", "hand_key L2 M11")
                time.sleep(3)
                if options.only in ("", "manual", "manual-2"):
                    done = pictures("manual-2")
                if done == 0 and options.only in ("", "diagnosis", "diagnosis-3"):   # the counter spindle follows the main one, Z takes its slide along
                    run("press", "hand_key L2 M61")
                    time.sleep(3)
                    run("press", "hand_key L1 M64")
                    time.sleep(3)
                    done = pictures("diagnosis-3")
            return done
        finally:
            end(controller)
            subprocess.run([binary / "polyturn", "clean"], capture_output=True)


if __name__ == "__main__":
    sys.exit(main())
