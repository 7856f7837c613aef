#!/usr/bin/env python3
"""Programs, data and printed texts that come and go through a socket or a folder: M198 (programmer.md), G05 (fanuc_lathe 9.2, 9.3),
DPRNT (6.10). What the sender sends is made here from the specification's table of bits."""
import socket
import threading
import time
import unittest

from polyturn_runner import Case

SETUP = "[channel.1]\npos = { X = 50.0, Z = 0.0 }\n"


class Server:
    """Listens at unix:PATH; `serve(connection)` has each connection in turn."""

    def __init__(self, case, serve):
        self.path = case.folder / "sender"
        self.listener = socket.socket(socket.AF_UNIX)
        self.listener.bind(str(self.path))
        self.listener.listen()
        self.name = f"unix:{self.path}"
        self.thread = threading.Thread(target=self.run, args=(serve,), daemon=True)
        self.thread.start()
        case.addCleanup(self.listener.close)

    def run(self, serve):
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            with connection:
                serve(connection)


def block(*ways):
    """A block of G05: 14 bits an axis with a sign, seven in each byte above a bit that is 0, then the lowest byte of the sum."""
    data = bytes(part << 1 for way in ways for part in (way >> 7 & 0x7F, way & 0x7F))
    return data + bytes([sum(data) & 0xFF])


def line_of(connection):
    text = b""
    while not text.endswith(b"\n"):
        piece = connection.recv(1)
        if not piece:
            break
        text += piece
    return text.decode()


class Remote(Case):
    def run_it(self, program, *sets):
        words = [word for one in sets for word in ("--set", one)]
        return self.polyturn("run", "--virtual", "--language", "fanuc", "--setup", self.write("setup.toml", SETUP), *words, self.write("O0001.nc", program))


class External(Remote):
    PROGRAM = "O1\nG98\n#500=1\nM198 P8700 L2\nG01 Z-5. F600\nM30\n"
    CALLED = "O8700\n#500=#500+1\nG01 Z-[10.*#500] F600\nM99\n"

    def test_a_program_is_called_from_a_folder(self):
        (self.folder / "outside").mkdir()
        self.write("outside/O8700.nc", self.CALLED)
        done = self.run_it(self.PROGRAM, f"PT_EXTERNAL L1={self.folder / 'outside'}")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual([m["pos"]["Z"] for m in done.of("move")], [-20.0, -30.0, -5.0])

    def test_a_program_is_asked_for_by_its_number_and_comes_through_a_socket(self):
        asked = []

        def serve(connection):
            asked.append(line_of(connection))
            for part in (self.CALLED[:9], self.CALLED[9:]):   # in pieces, as lines bring it
                connection.sendall(part.encode())
                time.sleep(0.05)

        done = self.run_it(self.PROGRAM, f"PT_EXTERNAL L1={Server(self, serve).name}")
        self.assertEqual(done.status, 0, done.said())
        self.assertEqual(asked, ["O8700\n"])
        self.assertEqual([m["pos"]["Z"] for m in done.of("move")], [-20.0, -30.0, -5.0])

    def test_one_that_is_not_there_is_an_alarm_at_the_call(self):
        (self.folder / "outside").mkdir()
        done = self.run_it(self.PROGRAM, f"PT_EXTERNAL L1={self.folder / 'outside'}")
        self.assertEqual([(a["number"], a["line"]) for a in done.alarms], [(78, 4)], done.said())
        self.assertEqual(done.of("move"), [])

    def test_a_sender_that_says_nothing_is_an_alarm_in_its_time(self):
        over = threading.Event()
        self.addCleanup(over.set)
        done = self.run_it(self.PROGRAM, f"PT_EXTERNAL L1={Server(self, lambda connection: over.wait(20)).name}", "PT_REMOTE_TIMEOUT L1=0.2")
        self.assertEqual([(a["number"], a["line"]) for a in done.alarms], [(179, 4)], done.said())


class Data(Remote):
    PROGRAM = "O1\nG98\nG05\nG01 Z0. F600\nM30\n"

    def test_blocks_move_the_axes_by_increments_in_their_time(self):
        def serve(connection):
            connection.sendall(block(-2000, -1000) + block(0, -500) + block(0, 0))

        done = self.run_it(self.PROGRAM, f"PT_REMOTE_INPUT L1={Server(self, serve).name}", "F7510 L1=2")
        self.assertEqual(done.status, 0, done.said())
        # Least increments of 0.001, X in diameter: X 50. - 2., Z -1.; then Z -1.5. The unit of time is 8 ms (F7501).
        self.assertEqual([(m["pos"]["X"], m["pos"]["Z"]) for m in done.of("move", line=3)], [(48.0, -1.0), (48.0, -1.5)])
        self.assertAlmostEqual(done.of("move", line=3)[1]["feed"]["value"], 0.5 / 0.008 * 60, delta=1)

    def test_data_that_break_off_are_an_alarm_and_the_axes_stand_behind_the_last_whole_block(self):
        over = threading.Event()
        self.addCleanup(over.set)

        def serve(connection):
            connection.sendall(block(0, -1000) + block(0, -1000)[:2])
            over.wait(20)

        done = self.run_it(self.PROGRAM, f"PT_REMOTE_INPUT L1={Server(self, serve).name}", "F7510 L1=2", "PT_REMOTE_TIMEOUT L1=0.2")
        self.assertEqual([(a["number"], a["line"]) for a in done.alarms], [(179, 3)], done.said())
        self.assertEqual([m["pos"]["Z"] for m in done.of("move")], [-1.0])

    def test_a_wrong_check_byte_is_an_alarm(self):
        wrong = bytearray(block(0, -1000))
        wrong[-1] ^= 1
        done = self.run_it(self.PROGRAM, f"PT_REMOTE_INPUT L1={Server(self, lambda connection: connection.sendall(bytes(wrong))).name}", "F7510 L1=2")
        self.assertEqual([a["number"] for a in done.alarms], [179], done.said())
        self.assertEqual(done.of("move"), [])


class Printing(Remote):
    def test_dprnt_goes_through_a_socket(self):
        got = []

        def serve(connection):
            while piece := connection.recv(4096):
                got.append(piece)

        server = Server(self, serve)
        done = self.run_it("O1\n#100=12.3456\nPOPEN\nDPRNT[X#100[53]*END]\nPCLOS\nM30\n", f"PT_PRINT_TO L1={server.name}")
        self.assertEqual(done.status, 0, done.said())
        deadline = time.monotonic() + 5
        while b"END" not in b"".join(got) and time.monotonic() < deadline:
            time.sleep(0.02)
        # A blank for the sign, five digits, point and three; the star is a blank.
        self.assertIn(b"X    12.346 END", b"".join(got))


if __name__ == "__main__":
    unittest.main()
