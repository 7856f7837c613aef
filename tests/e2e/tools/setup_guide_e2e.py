"""The setup technician's guide does what it says: all its blocks of commands run, in order, in one folder."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from presetter_e2e import draw, insert

SOURCE = pathlib.Path(__file__).resolve().parents[3]
POLYTURN = pathlib.Path(os.environ["POLYTURN"]).resolve()
PRESETTER = (POLYTURN.parent / "polyturn-presetter").exists()


class SetupGuide(unittest.TestCase):
    def test_every_command_runs(self):
        text = (SOURCE / "docs" / "setup.md").read_text(encoding="utf-8")
        script = "set -e\ntrap 'kill $(jobs -p) 2> /dev/null' EXIT\n"
        for number, block in enumerate(re.findall(r"^```sh\n(.*?)^```$", text, re.M | re.S), 1):
            script += f"echo '--- block {number}'\n{block}\n"
        if not PRESETTER:
            script = re.sub(r"^polyturn presetter .*\n", "", script, flags=re.M)
        # Instances are shared by the whole computer: this run has one of its own.
        script = script.replace("--instance shop", f"--instance shop-{os.getpid()}")
        # A computer that builds beside it is late now and then: on the shop's computer that stops the machine, here the guide shall go on.
        script = script.replace("polyturn start ", "polyturn start --set PT_PLC_CYCLE=100 --set PT_LATE_MAX=1000 ")
        with tempfile.TemporaryDirectory() as folder:
            if PRESETTER:
                draw(pathlib.Path(folder) / "pin.pgm", lambda z, x: x >= 0 and abs(z) <= 1.0)
                for k, name in enumerate(("tool.pgm", "shot_00.pgm", "shot_01.pgm", "shot_02.pgm", "shot_03.pgm")):
                    draw(pathlib.Path(folder) / name, insert(0.8, 0.1, 0.2), seed=k)
            environment = dict(os.environ, PATH=f"{POLYTURN.parent}:{os.environ['PATH']}", XDG_RUNTIME_DIR=folder, LC_ALL="C")
            try:
                done = subprocess.run(["bash", "-c", script], cwd=folder, env=environment, capture_output=True, text=True, timeout=200)
            except subprocess.TimeoutExpired as late:
                log = pathlib.Path(folder) / "start.log"
                self.fail(f"hangs\n{late.stdout.decode()}{late.stderr.decode()}\n--- start.log\n{log.read_text() if log.exists() else ''}")
        out = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, out)
        block = {int(n): words for n, words in re.findall(r"--- block (\d+)\n(.*?)(?=--- block|\Z)", done.stdout, re.S)}
        self.assertIn("turret", block[1])
        self.assertIn("magazine 1 pot 3", block[2])
        self.assertIn("row 3, column life: alarm PT0411", done.stderr)                # the wrong table
        self.assertIn("3 tools, 0 of them new, 0 values changed", block[3])            # what was exported reads in again
        self.assertRegex(block[5], r"wear X.*(?s:.)*0\.02")
        self.assertIn("PT0404", done.stderr)                                           # wear of 1.5 mm
        self.assertRegex(block[6], r"L1 offset 3 geometry Z: .* -> ")                     # the tool setter
        self.assertIn("Nothing was changed yet", block[6])
        self.assertIn("Written.", block[6])
        self.assertRegex(block[7], r"G54 +0 +-149\.5")
        self.assertRegex(block[8], r"L1 G55 Z: .* -> ")                                 # the workpiece setter
        self.assertIn("Written.", block[8])
        if PRESETTER:
            self.assertRegex(block[9], r"L1 offset 7 geometry R: 0 -> 0\.[78]")
            self.assertIn("Written.", block[9])
        self.assertIn("of 45 min", block[10])                                           # the unit is always shown
        self.assertRegex(block[11], r"2 of 2 pieces.*worn")                              # two parts by the first sister,
        self.assertRegex(block[11], r"1 of 200 pieces")                                 # the third by the second
        self.assertIn("-0.0100 mm", block[14])                                          # mean of +0.008 and +0.012
        self.assertIn("tool 3 exists", block[15])                                      # the preview
        self.assertRegex(block[15].split("Restored.")[1], r"3 +3 +1 +FINISH_35")
        self.assertIn("PT0401", block[16])                                             # the damaged file
        self.assertIn("FINISH_35", block[16])
        self.assertIn("PT0432", done.stderr)                                           # the operator and the life
        self.assertRegex(block[17], r"anna +L1 offset 3 wear Z")


if __name__ == "__main__":
    unittest.main()
