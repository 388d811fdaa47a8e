"""The emulators as programs: raw octets over the pseudo-terminal, commands over the control socket."""
import csv
import json
import os
import pathlib
import select
import signal
import socket
import subprocess
import tempfile
import termios
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent.parent
BIN = pathlib.Path(os.environ.get("LAMPREY_BIN", ROOT / "build" / "release" / "bin"))
PATIENCE = 30  # seconds for what takes milliseconds: a deadline against hanging, never a measurement
QUIET = 0.2    # seconds after which nothing more is expected to come


class Emulator(unittest.TestCase):
    PROGRAM = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="lamprey-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.link = self.folder / "tty"

    def start(self, *arguments):
        process = subprocess.Popen(
            [BIN / self.PROGRAM, "--link", self.link, "--control", self.folder / "control", "--report",
             self.folder / "report.json", "--log", self.folder / "log.csv", *arguments],
            stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.process = process
        self.greeting = process.stdout.readline().strip()
        return process

    def stop(self):
        self.process.terminate()
        self.assertEqual(self.process.wait(PATIENCE), 0)
        return json.loads((self.folder / "report.json").read_text())

    def open(self):
        descriptor = os.open(self.link, os.O_RDWR | os.O_NOCTTY)
        self.addCleanup(self.close, descriptor)
        return descriptor

    @staticmethod
    def close(descriptor):
        try:
            os.close(descriptor)
        except OSError:
            pass  # a test has closed it

    def control(self, line):
        with socket.socket(socket.AF_UNIX) as connection:
            connection.settimeout(PATIENCE)
            connection.connect(str(self.folder / "control"))
            connection.sendall(line.encode() + b"\n")
            with connection.makefile() as answers:
                return answers.readline().rstrip("\n")

    def state(self):
        return json.loads(self.control("state"))

    def read(self, descriptor, count, patience=PATIENCE):
        """`count` octets, or what has come when nothing came for so long."""
        octets = b""
        while len(octets) < count and select.select([descriptor], [], [], patience)[0]:
            octets += os.read(descriptor, count - len(octets))
        return octets

    def ask(self, descriptor, request, count, patience=PATIENCE):
        os.write(descriptor, request)
        return self.read(descriptor, count, patience)


class Ssc32Program(Emulator):
    PROGRAM = "lamprey-ssc32-emulator"
    VERSION = b"SSC32-V2.50USB\r"

    def test_presents_itself_and_leaves_nothing_behind(self):
        self.start()
        self.assertEqual(self.greeting, f"SSC-32 emulator at {self.link} ({os.readlink(self.link)}), 115200 baud")
        self.assertEqual(self.ask(self.open(), b"ver\r", 15), self.VERSION)
        report = self.stop()
        self.assertEqual(report["octets_received"], 4)
        self.assertEqual(report["octets_answered"], 15)
        self.assertFalse(os.path.lexists(self.link))
        self.assertFalse(os.path.lexists(self.folder / "control"))

    def test_the_quadruped_moves_and_touches(self):
        self.start("--quadruped", "--speed", "instant")
        line = self.open()
        self.assertEqual(self.ask(line, b"ABCD\r", 4), b"0000")
        os.write(line, b"".join(b"#%dP1000" % channel for channel in range(8)) + b"\r")
        self.assertEqual(self.ask(line, b"QP0QP7QP8\r", 3), bytes([100, 100, 0]))
        os.write(line, b"#1P1050#4P1100T100\r")
        while self.ask(line, b"Q\r", 1) != b".":
            pass
        state = self.state()
        self.assertEqual(state["contacts"], {"A": True, "B": False, "C": False, "D": True})
        self.assertEqual(state["servos"]["4"]["position"], 1100)
        report = self.stop()
        self.assertEqual(report["servos"]["4"]["largest_change"], 100)
        self.assertEqual(report["servos"]["4"]["largest_jump"], 0)
        self.assertLessEqual(report["servos"]["4"]["largest_speed"], 1000)
        self.assertEqual(report["refusals"], 0)
        with open(self.folder / "log.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["servo"] for row in rows], ["0", "1", "2", "3", "4", "5", "6", "7", "1", "4"])
        self.assertEqual(rows[-1]["value"], "1100")
        self.assertEqual(rows[-1]["duration_ms"], "100")
        self.assertLess(int(rows[0]["time_ns"]), int(rows[-1]["time_ns"]))
        self.assertLess(int(rows[-1]["time_ns"]), time.clock_gettime_ns(time.CLOCK_MONOTONIC))

    def test_no_octet_is_faster_than_the_line(self):
        self.start("--baud", "9600")
        line = self.open()
        begin = time.monotonic()
        self.assertEqual(self.ask(line, b"VER\r", 15), self.VERSION)
        # 4 octets there, 15 back, ten bits each. A machine under load makes it longer, nothing makes it shorter.
        self.assertGreaterEqual(time.monotonic() - begin, 19 * 10 / 9600)

    def test_closing_and_opening_again_is_no_end(self):
        self.start()
        for _ in range(3):
            line = self.open()
            self.assertEqual(self.ask(line, b"VER\r", 15), self.VERSION)
            os.close(line)

    def test_whoever_speaks_at_another_speed_is_not_understood(self):
        self.start()
        line = self.open()
        settings = termios.tcgetattr(line)
        settings[4] = settings[5] = termios.B9600
        termios.tcsetattr(line, termios.TCSANOW, settings)
        self.assertEqual(self.ask(line, b"VER\r", 15, QUIET), b"")
        settings[4] = settings[5] = termios.B115200
        termios.tcsetattr(line, termios.TCSANOW, settings)
        self.assertEqual(self.ask(line, b"VER\r", 15), self.VERSION)
        self.assertEqual(self.stop()["octets_at_another_speed"], 4)

    def test_faults_of_answers(self):
        self.start("--seed", "3")
        line = self.open()
        self.assertEqual(self.control("silence on"), "ok")
        self.assertEqual(self.ask(line, b"VER\r", 15, QUIET), b"")
        self.control("silence off")
        self.control("partial on")
        self.assertEqual(self.ask(line, b"VER\r", 15, QUIET), self.VERSION[:7])
        self.control("partial off")
        self.control("noise 1")
        noisy = self.ask(line, b"VER\r", 30, QUIET)
        self.assertGreaterEqual(len(noisy), 15)
        self.assertNotEqual(noisy[:15], self.VERSION)
        self.control("noise off")
        self.control("slow 250")
        begin = time.monotonic()
        self.assertEqual(self.ask(line, b"VER\r", 15), self.VERSION)
        self.assertGreaterEqual(time.monotonic() - begin, 0.25)
        self.control("slow off")
        self.assertEqual(self.ask(line, b"VER\r", 15), self.VERSION)

    def test_unplugged_and_plugged_in_again(self):
        self.start("--quadruped")
        line = self.open()
        os.write(line, b"#0P1500\r")
        self.assertEqual(self.ask(line, b"QP0\r", 1), bytes([150]))
        self.assertEqual(self.control("unplug"), "ok")
        self.assertTrue(select.select([line], [], [], PATIENCE)[0])
        try:
            self.assertEqual(os.read(line, 1), b"")
        except OSError:
            pass  # that, too, is how a line ends
        self.assertFalse(os.path.lexists(self.link))
        self.assertEqual(self.control("unplug"), "error unplug: is not plugged in")
        self.assertEqual(self.control("replug"), "ok")
        self.assertEqual(self.control("replug"), "error replug: is plugged in")
        self.assertEqual(self.ask(self.open(), b"QP0\r", 1), bytes([150]))  # the board has kept its power

    def test_overload_place_and_reset(self):
        self.start("--quadruped", "--speed", "instant")
        line = self.open()
        self.assertEqual(self.control("place 0 1500"), "ok")
        self.assertFalse(self.state()["contacts"]["A"])
        self.assertEqual(self.control("overload 0 on"), "ok")
        self.assertEqual(self.ask(line, b"#0P1000\rQP0\r", 1), bytes([100]))
        self.assertEqual(self.state()["servos"]["0"]["position"], 1500)
        self.assertEqual(self.control("reset"), "ok")
        self.assertEqual(self.ask(line, b"QP0\r", 1), bytes([0]))
        self.assertEqual(json.loads(self.control("report"))["servos"]["0"]["largest_jump"], 500)


class DynamixelProgram(Emulator):
    PROGRAM = "lamprey-dynamixel-emulator"

    @staticmethod
    def packet(identity, instruction, parameters=b""):
        body = bytes([255, 255, 253, 0, identity]) + (len(parameters) + 3).to_bytes(2, "little")
        body += bytes([instruction]) + parameters
        crc = 0
        for octet in body:
            crc ^= octet << 8
            for _ in range(8):
                crc = (crc << 1 ^ (0x8005 if crc & 0x8000 else 0)) & 0xFFFF
        return body + crc.to_bytes(2, "little")

    def write(self, line, identity, address, octets):
        """The error octet."""
        return self.ask(line, self.packet(identity, 3, address.to_bytes(2, "little") + octets), 11)[8]

    def positions(self, line, count=8):
        """Errors and positions of the servos 1, 2, …"""
        request = self.packet(254, 0x82, bytes([132, 0, 4, 0, *range(1, count + 1)]))
        answer = self.ask(line, request, 15 * count)
        statuses = [answer[i:i + 15] for i in range(0, len(answer), 15)]
        self.assertEqual([status[4] for status in statuses], list(range(1, count + 1)))
        for status in statuses:
            self.assertEqual(status, self.packet(status[4], 0x55, status[8:13]))
        return [(status[8], int.from_bytes(status[9:13], "little", signed=True)) for status in statuses]

    def test_the_quadruped_answers_moves_and_touches(self):
        self.start("--quadruped", "--speed", "instant")
        self.assertEqual(self.greeting, f"DYNAMIXEL emulator at {self.link} ({os.readlink(self.link)}), 1000000 baud")
        line = self.open()
        ping = self.ask(line, bytes.fromhex("FFFFFD0001030001194E"), 14)
        self.assertEqual(ping[:11], bytes.fromhex("FFFFFD0001070055000604"))
        self.assertEqual(self.positions(line), [(0, 2048)] * 8)
        contacts = self.packet(200, 2, bytes([10, 0, 1, 0]))
        self.assertEqual(self.ask(line, contacts, 12)[9], 0b1111)
        for servo in range(1, 9):
            self.assertEqual(self.write(line, servo, 64, b"\1"), 0)
        goals = b"".join(bytes([servo]) + (2048 + 40 * servo).to_bytes(4, "little") for servo in (1, 6))
        os.write(line, self.packet(254, 0x83, bytes([116, 0, 4, 0]) + goals))
        expected = [(0, 2048)] * 8
        expected[0] = (0, 2088)
        expected[5] = (0, 2288)
        deadline = time.monotonic() + PATIENCE
        while self.positions(line) != expected and time.monotonic() < deadline:
            pass
        self.assertEqual(self.positions(line), expected)
        self.assertEqual(self.ask(line, contacts, 12)[9], 0b0110)
        report = self.stop()
        self.assertEqual(report["servos"]["6"]["largest_change"], 240)
        self.assertEqual(report["servos"]["6"]["largest_jump"], 0)
        self.assertEqual(report["refusals"], 0)

    def test_an_overloaded_servo_alerts(self):
        self.start("--quadruped")
        line = self.open()
        self.assertEqual(self.write(line, 3, 64, b"\1"), 0)
        self.assertEqual(self.control("overload 3 on"), "ok")
        self.assertEqual([error for error, _ in self.positions(line)], [0, 0, 0x80, 0, 0, 0, 0, 0])
        self.assertEqual(self.write(line, 3, 64, b"\1"), 0x87)
        self.control("overload 3 off")
        self.assertEqual(self.ask(line, self.packet(3, 8), 11)[8], 0)
        self.assertEqual(self.write(line, 3, 64, b"\1"), 0)

    def test_a_servo_can_be_placed_and_a_contact_board_had_elsewhere(self):
        self.start("--servos", "5,6", "--contact-board", "9:20", "--foot", "2=6>=3000", "--position", "1000")
        line = self.open()
        contacts = self.packet(9, 2, bytes([20, 0, 1, 0]))
        self.assertEqual(self.ask(line, contacts, 12)[9], 0)
        self.assertEqual(self.control("place 6 3000"), "ok")
        self.assertEqual(self.ask(line, contacts, 12)[9], 4)
        self.assertEqual(self.state()["servos"]["5"]["position"], 1000)


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="lamprey-")
        self.addCleanup(folder.cleanup)
        self.link = pathlib.Path(folder.name) / "tty"

    def refused(self, device, *arguments):
        result = subprocess.run([BIN / f"lamprey-{device}-emulator", *map(str, arguments)], capture_output=True,
                                text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertFalse(os.path.islink(self.link))
        return result.stderr + result.stdout

    def test_bad_usage_is_told_and_nothing_is_made(self):
        ssc32 = ("ssc32", "--link", self.link)
        dynamixel = ("dynamixel", "--link", self.link)
        for arguments, complaint in (
                (("ssc32",), "--link is required"),
                ((*ssc32, "--baud", "12"), "--baud"),
                ((*ssc32, "--speed", "fast"), "--speed: 'fast' is not in 1..1000000, or instant"),
                ((*ssc32, "--foot", "G=0<=1000"), "input 'G' is not in A..F"),
                ((*ssc32, "--log", "/nonexistent/log"), "--log: '/nonexistent/log' can't be written"),
                ((*ssc32, "--control", self.link.parent), "there is something else"),
                (("ssc32", "--link", self.link.parent), "is there and no link to a pseudo-terminal"),
                (dynamixel, "--servos: at least one id is needed"),
                ((*dynamixel, "--servos", "1,2,1"), "id 1 is there twice"),
                ((*dynamixel, "--servos", "1,253"), "--servos"),
                ((*dynamixel, "--quadruped", "--contact-board", "8:10"), "id 8 is a servo's"),
                ((*dynamixel, "--quadruped", "--contact-board", "9:9"), "'9:9' is not ID:ADDRESS"),
                ((*dynamixel, "--quadruped", "--baud", "250000"), "250000 is no speed of these servos"),
                ((*dynamixel, "--servos", "1", "--foot", "0=2<=2048"), "no servo has the id 2")):
            with self.subTest(complaint):
                self.assertIn(complaint, self.refused(*arguments))

    def test_options_can_stand_in_a_file(self):
        file = self.link.parent / "emulator.conf"
        file.write_text(f'link = "{self.link}"\nbaud = 9600\nfoot = ["A=3<=1200", "B=4<=1200"]\n')
        command = [BIN / "lamprey-ssc32-emulator", "--configuration", file, "--control", "-"]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
            self.addCleanup(process.kill)
            self.assertIn("9600 baud", process.stdout.readline())
            process.stdin.write("state\nnonsense\n")
            process.stdin.flush()
            self.assertEqual(json.loads(process.stdout.readline())["contacts"], {"A": False, "B": False})
            self.assertTrue(process.stdout.readline().startswith("error unknown command 'nonsense'"))
            process.terminate()
            self.assertEqual(process.wait(PATIENCE), 0)
        file.write_text(f'link = "{self.link}"\nbaut = 9600\n')
        self.assertIn("baut", self.refused("ssc32", "--configuration", file))

    def test_a_link_that_leads_nowhere_is_replaced(self):
        self.link.symlink_to("/dev/pts/999999")
        command = [BIN / "lamprey-ssc32-emulator", "--link", self.link]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            self.addCleanup(process.kill)
            greeting = process.stdout.readline()
            self.assertIn(os.readlink(self.link), greeting)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(PATIENCE), 0)
        self.assertFalse(os.path.lexists(self.link))


if __name__ == "__main__":
    unittest.main()
