"""The machine builder's guide does what it says: all its blocks of commands run, in order, in one folder."""
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[3]
POLYTURN = pathlib.Path(os.environ["POLYTURN"]).resolve()


def blocks(text):
    return re.findall(r"^```sh\n(.*?)^```$", text, re.M | re.S)


class BuilderGuide(unittest.TestCase):
    def test_every_command_runs(self):
        text = (SOURCE / "docs" / "builder.md").read_text(encoding="utf-8")
        script = "set -e\n"
        for number, block in enumerate(blocks(text), 1):
            script += f"echo '--- block {number}'\n{block}\n"
        # Instances are shared by the whole computer: this run has one of its own.
        instance = f"guide-{os.getpid()}"
        script = script.replace("--instance first", f"--instance {instance}")
        # A busy computer is late now and then, and a machine that has stopped for it never gets ready.
        script = script.replace("polyturn start lathe ", "polyturn start lathe --set PT_LATE_MAX=1000 ")
        with tempfile.TemporaryDirectory() as folder:
            environment = dict(os.environ, PATH=f"{POLYTURN.parent}:{os.environ['PATH']}", POLYTURN_SOURCE=str(SOURCE))
            guide = subprocess.Popen(["bash", "-c", script], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
            try:
                out = guide.communicate(timeout=300)[0]
            except subprocess.TimeoutExpired:
                os.killpg(guide.pid, signal.SIGTERM)    # the controller that it has started too
                out = guide.communicate()[0]
                self.fail("the guide does not come to its end\n" + out)
        self.assertEqual(guide.returncode, 0, out)
        self.assertIn("PT0900", out)                                       # the empty machine
        self.assertIn("press machine on", out)                             # status says what comes next
        self.assertIn("press reference all", out)
        self.assertIn("the door is open", out)
        self.assertIn("the machine is ready", out)
        self.assertRegex(out, r'"ev":"summary".*"alarms":0')
        self.assertRegex(out, r"the drive of (axis )?A2 has not answered")   # the emulator, too late
        self.assertGreaterEqual(out.count('"name":"CP_MFIN L1"'), 2, out)  # the minimal PLC has finished M8 and M9


if __name__ == "__main__":
    unittest.main()
