"""A robot under attack: faults of the line in mid-job, commands that nobody should give, and stops at bad moments.

What has become of the servos is told by the emulated controller's own record, never by the bridge alone.
"""
import csv
import json
import re
import signal
import socket
import subprocess
import time

from support import BIN, PATIENCE, ROOT
from test_robot import CALIBRATIONS, Robot

RATE = 10  # time steps per second: servos have time to arrive on a machine that stops them for milliseconds
STOPPED_LATE = "latched, but the device has not confirmed that its servos are off"


class Attacked(Robot):
    def start_emulator(self, family):
        line = self.folder / "tty"
        emulator = self.start(f"lamprey-{family}-emulator", "--link", line, "--quadruped", "--report",
                              self.folder / "report.json", "--control", self.folder / "control", "--log",
                              self.folder / "moves.csv")
        self.wait_until((self.folder / "control").exists, "the emulator's control socket")
        self.wait_until(line.exists, "the emulator's line")
        return emulator

    def start_robot(self, family, *more):
        """Emulator and bridge, active."""
        emulator = self.start_emulator(family)
        confirm = ["--confirm-pose"] if family == "ssc32" else []
        bridge = self.start_bridge(family, RATE, "--activate", *confirm, *more)
        self.wait_for_state("active")
        return emulator, bridge

    def start_run(self, cycles):
        """A sweep of a job on the robot and its twin, going on; its database, too."""
        database = self.folder / "robot.db"
        run = subprocess.Popen([BIN / "lamprey", "run", self.sweep("attacked", "mutation: [all]", cycles), "--database", database,
                                "--bridge", "bench", "--quiet"], cwd=self.folder, env=self.environment,
                               stdout=subprocess.DEVNULL)
        run.log = open(self.folder / "run.log", "w+")
        self.addCleanup(run.log.close)
        self.processes.append(run)
        return run, database

    def control(self, *lines):
        with socket.socket(socket.AF_UNIX) as connection:
            connection.settimeout(PATIENCE)
            connection.connect(str(self.folder / "control"))
            with connection.makefile() as answers:
                for line in lines:
                    connection.sendall(line.encode() + b"\n")
                    answer = answers.readline().rstrip("\n")
                    self.assertFalse(answer.startswith("error"), answer)
        return answer

    def servos(self):
        return json.loads(self.control("state"))["servos"]

    def servos_on(self):
        return sum(servo["on"] for servo in self.servos().values())

    def moves(self):
        return sum(servo["moves"] for servo in json.loads(self.control("report"))["servos"].values())

    def record(self):
        """Of all that the controller was told: time in nanoseconds, servo, and value, None where it was turned off."""
        self.control("report")
        with open(self.folder / "moves.csv") as file:
            return [(int(row["time_ns"]), int(row["servo"]), int(row["value"]) if row["value"] else None)
                    for row in csv.DictReader(file)]

    def counter(self, name):
        return self.status()["counters"][name]

    def wait_for_steps(self, steps):
        wanted = self.counter("steps") + steps
        self.wait_until(lambda: self.counter("steps") >= wanted, f"{steps} more steps")

    def check_record(self, lowest, highest, step):
        """Whatever happened: no value out of range, none further from the last than a servo may go in a time step."""
        # Where it stands after a fault an SSC-32 tells to 10 µs; a machine that stops for a quarter of a second is one.
        step += 10 if self.counter("device_errors") > 0 else 0
        report = json.loads(self.control("report"))
        self.assertEqual(len(report["servos"]), 8)
        for number, servo in report["servos"].items():
            self.assertGreaterEqual(servo["lowest"], lowest, number)
            self.assertLessEqual(servo["highest"], highest, number)
            self.assertLessEqual(servo["largest_change"], step, number)
            self.assertLessEqual(servo["largest_jump"], 1, number)
        self.assertEqual(report["refusals"], 0, report["refused"])

    def terminate(self, process):
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(30), 0, self.log_of(process))


class Faults(Attacked):
    """Each fault holds the robot, is told, and is over when it is over: the sweep comes to what the simulator has."""

    COMMON = [("silence", ["silence on"], ["silence off"], "no answer"),
              ("partial octets", ["partial on"], ["partial off"], "octets instead of|only a part|without an end|no answer|noise"),
              ("noise", ["noise 0.5"], ["noise off"], "noise|octets instead|not the answer|only a part|error|can't be at|no answer|no SSC-32"),
              ("slow answers", ["slow 600"], ["slow off"], "no answer"),
              ("the plug", ["unplug"], ["replug"], "is gone|can't be opened")]

    def ride_out(self, family, faults, lowest, highest, step):
        _, bridge = self.start_robot(family, "--off-after", 60_000)
        # Each fault voids the evaluation that goes on, and so the sweep lasts until there are no more of them.
        run, database = self.start_run(1)
        for name, begin, end, reason in faults:
            self.wait_for_steps(10)
            errors = self.counter("device_errors")
            self.control(*begin)
            self.wait_for_state("fault")
            self.assertGreater(self.counter("device_errors"), errors, name)
            self.assertRegex(self.status()["reason"], reason, name)
            moves = self.moves()
            time.sleep(0.3)
            self.assertEqual(self.moves(), moves, f"{name}: the servos hold")
            self.assertGreaterEqual(self.servos_on(), 7, f"{name}: they hold with torque")
            self.control(*end)
            self.wait_for_state("active")
        self.assertEqual(run.wait(300), 0)
        self.check_gap(database, 1)
        log = self.log_of(bridge)
        self.assertGreaterEqual(len(re.findall("active -> fault: .", log)), len(faults), log)
        voided = self.rows(database, "SELECT voided FROM robot_evaluation WHERE voided IS NOT NULL")
        # A fault between two evaluations voids none.
        self.assertGreaterEqual(len(voided), len(faults) - 2, voided)
        self.assertNotIn(("",), voided)
        self.check_record(lowest, highest, step)
        self.terminate(bridge)
        self.assertEqual(self.servos_on(), 0)

    def test_an_ssc32_is_held_through_each_fault_and_goes_on(self):
        self.ride_out("ssc32", self.COMMON, 500, 2000, 3000 / RATE)

    def test_dynamixel_servos_are_held_through_each_fault_and_go_on(self):
        # Who takes the load away switches the power off and on: the alert lasts until then.
        overload = ("overload", ["overload 3 on"], ["overload 3 off", "reset"], "overload")
        self.ride_out("dynamixel", [*self.COMMON, overload], 1648, 2848, 4000 / RATE)


class Watchdog(Attacked):
    def test_servos_hold_when_commands_stop_and_are_turned_off_after_the_time(self):
        self.start_emulator("ssc32")
        self.start_bridge("ssc32", RATE, "--off-after", 3000)
        self.wait_for_state("inactive")
        database = self.folder / "watchdog.db"
        self.start("lamprey-coordinator", "--database", database)
        worker = self.start("lamprey-worker", "--bridge", "bench")
        self.lamprey("submit", self.sweep("watchdog", "mutation: [all]", 50), "--timeout", 30)
        self.lamprey("bridge", "activate", "bench", "--confirm-pose")
        self.wait_for_steps(15)
        worker.kill()
        self.wait_for_state("inactive")
        self.assertIn("nobody needed the servos for 3000 ms", self.status()["reason"])
        self.assertEqual(self.servos_on(), 0)
        record = self.record()
        self.assertEqual([value for _, _, value in record[-8:]], [None] * 8)
        self.assertNotIn(None, [value for _, _, value in record[:-8]], "held until then")
        # A loaded machine makes it longer, nothing makes it shorter but a late stamp of the last move.
        self.assertGreater(record[-1][0] - record[-9][0], 2e9)

    def test_servos_of_a_mute_device_are_turned_off_after_the_time_and_stay_off(self):
        self.start_robot("dynamixel", "--off-after", 3000)
        run, database = self.start_run(1)
        self.wait_for_steps(15)
        self.control("silence on")
        self.wait_for_state("fault")
        self.wait_until(lambda: self.servos_on() == 0, "the servos being turned off without an answer")
        self.assertEqual([value for _, _, value in self.record()[-8:]], [None] * 8)
        self.control("silence off")
        self.wait_for_state("inactive")
        self.assertIn("the device had failed for 3000 ms", self.status()["reason"])
        moves = self.moves()
        time.sleep(1)
        self.assertEqual((self.servos_on(), self.moves()), (0, moves), "nothing moves before somebody says so")
        self.lamprey("bridge", "activate", "bench")
        self.assertEqual(run.wait(300), 0)
        self.assertEqual(self.number(database, "SELECT count(*) FROM result WHERE state = 'done'"), 2)


class EmergencyStop(Attacked):
    def test_a_stop_in_mid_job_is_the_last_thing_that_the_servos_hear(self):
        _, bridge = self.start_robot("ssc32")
        self.start_run(50)
        self.wait_for_steps(15)
        asked = time.clock_gettime_ns(time.CLOCK_MONOTONIC)
        answer = self.json("bridge", "stop", "bench")
        answered = time.clock_gettime_ns(time.CLOCK_MONOTONIC)
        self.assertTrue(answer["stopped"])
        time.sleep(1)
        off = [row for row in self.record() if row[2] is None]
        self.assertEqual(self.record()[-8:], off)
        self.assertGreater(off[0][0], asked)
        if answer["reason"] == "":  # it says that the device has confirmed
            self.assertLess(off[0][0], answered)
        print(f"\n  {(off[0][0] - asked) / 1e6:.0f} ms from the program's start to pulses off, answer after "
              f"{1000 * answer['seconds']:.0f} ms", end=" ", flush=True)
        self.terminate(bridge)

    def test_a_stop_reaches_a_device_that_is_mute(self):
        self.start_robot("ssc32")
        self.control("silence on")
        answer = self.json("bridge", "stop", "bench", "--reason", "mute")
        self.assertTrue(answer["stopped"])
        self.assertEqual(answer["reason"], STOPPED_LATE)
        self.wait_until(lambda: self.servos_on() == 0, "the servos being turned off without an answer")
        self.control("silence off")
        self.wait_for_state("inactive")
        self.assertTrue(self.status()["stopped"])

    def test_a_stop_that_found_the_line_unplugged_is_carried_out_by_the_next_bridge(self):
        _, bridge = self.start_robot("ssc32")
        self.control("unplug")
        self.wait_for_state("fault")
        self.assertEqual(self.json("bridge", "stop", "bench", "--reason", "unplugged")["reason"], STOPPED_LATE)
        bridge.kill()
        bridge.wait()
        self.assertEqual(self.servos_on(), 8, "the board keeps its pulses")
        self.control("replug")
        self.start_bridge("ssc32", RATE, "--activate", "--confirm-pose")
        self.wait_until(lambda: self.servos_on() == 0, "the servos being turned off")
        self.wait_for_state("inactive")
        self.assertEqual(self.status()["reason"], "unplugged")
        self.assertIn("emergency stop: unplugged", self.lamprey("bridge", "activate", "bench", code=1).stderr)

    def test_whenever_a_bridge_is_ended_its_servos_are_off(self):
        for family in ("ssc32", "dynamixel"):
            emulator, bridge = self.start_robot(family)
            run, _ = self.start_run(50)
            self.wait_for_steps(15)
            self.terminate(bridge)
            self.assertEqual(self.servos_on(), 0)
            self.terminate(emulator)
            run.kill()
            run.wait()


class HostileCommands(Attacked):
    """Whatever arrives on DDS, from either vendor, with or without the claim."""

    HOSTILE_RATE = 50
    SLEW = 600  # µs/s: so slow that a step too far is far from what jitter does to it
    REFUSALS = ("setpoints_clamped", "setpoints_slowed", "commands_under_no_claim", "commands_repeated",
                "commands_of_void_evaluations", "commands_not_numbers", "evaluations_voided",
                "samples_for_other_robots")

    def slow_calibration(self):
        text = (CALIBRATIONS / "quadruped_ssc32.yaml").read_text()
        self.assertIn("slew_rate: 3000", text)
        return self.write("slow.yaml", text.replace("slew_rate: 3000", f"slew_rate: {self.SLEW}"))

    def start_hostile(self, seconds, seed, dds, *more):
        process = subprocess.Popen([BIN / "lamprey_hostile_commander", "--robot", "bench", "--seconds", str(seconds),
                                    "--seed", str(seed), "--dds", dds, *more], cwd=self.folder, env=self.environment,
                                   stdout=subprocess.PIPE, text=True)
        process.log = open(self.folder / f"hostile-{seed}.log", "w+")
        self.addCleanup(process.log.close)
        self.addCleanup(process.stdout.close)
        self.processes.append(process)
        return process

    def wait_for_hostile(self, *attackers):
        for attacker in attackers:
            output, _ = attacker.communicate(timeout=PATIENCE)
            self.assertEqual(attacker.returncode, 0)
            self.assertGreater(sum(json.loads(output).values()), 1000, output)

    def start_attacked(self, dds):
        self.start_emulator("ssc32")
        self.start("lamprey-bridge", "--robot", "bench", "--driver", "ssc32", "--port", self.folder / "tty",
                   "--calibration", self.slow_calibration(), "--rate", self.HOSTILE_RATE, "--state",
                   self.folder / "state", "--dds", dds, "--activate", "--confirm-pose")
        self.wait_for_state("active")

    def check_never_faster_than_allowed(self):
        """Not between two commands, and not over any stretch of them."""
        self.check_record(500, 2000, self.SLEW / self.HOSTILE_RATE)
        late_stamp = 0.25  # seconds: how late a loaded machine may have stamped a command
        by_servo = {}
        for moment, servo, value in self.record():
            if value is not None:
                by_servo.setdefault(servo, []).append((moment / 1e9, value))
        self.assertEqual(len(by_servo), 8)
        travelled = 0
        for moves in by_servo.values():
            for i in range(0, len(moves), 10):
                for j in range(i + 1, len(moves), 10):
                    seconds, change = moves[j][0] - moves[i][0], abs(moves[j][1] - moves[i][1])
                    self.assertLessEqual(change, self.SLEW * (seconds + late_stamp))
                    travelled = max(travelled, change)
        self.assertGreater(travelled, 100, "they have been moved")

    def attack(self, bridge_dds):
        self.start_attacked(bridge_dds)
        self.wait_for_hostile(self.start_hostile(10, 1, "cyclonedds"))
        self.wait_for_hostile(self.start_hostile(8, 2, "cyclonedds"), self.start_hostile(8, 3, "fastdds"),
                              self.start_hostile(8, 4, "fastdds", "--no-claim"))
        counters = self.status()["counters"]
        for refusal in self.REFUSALS:
            self.assertGreater(counters[refusal], 0, f"{refusal}: {counters}")
        self.assertGreater(counters["steps"], 50)
        self.check_never_faster_than_allowed()

    def test_nothing_on_cyclone_dds_moves_a_servo_beyond_its_limits(self):
        self.attack("cyclonedds")

    def test_nothing_on_fast_dds_moves_a_servo_beyond_its_limits(self):
        self.attack("fastdds")

    def test_a_stop_among_hostile_commands_is_the_last_thing_that_the_servos_hear(self):
        self.start_attacked("cyclonedds")
        attackers = [self.start_hostile(60, 5, "cyclonedds")]
        self.wait_for_steps(150)
        attackers.append(self.start_hostile(60, 6, "fastdds", "--no-claim"))
        self.wait_for_steps(15)
        self.assertTrue(self.json("bridge", "stop", "bench")["stopped"])
        self.wait_until(lambda: self.servos_on() == 0, "the servos being off")
        accepted = self.counter("steps")
        time.sleep(2)
        self.assertEqual([attacker.poll() for attacker in attackers], [None, None], "they go on")
        self.assertEqual(self.counter("steps"), accepted)
        self.assertEqual([value for _, _, value in self.record()[-8:]], [None] * 8)
        self.check_never_faster_than_allowed()


class Benchmark(Robot):
    def test_the_loop_can_be_measured(self):
        done = subprocess.run([ROOT / "benchmarks" / "robot_loop", "--seconds", "2", "--stops", "1", "--device",
                               "dynamixel", "--dds", "cyclonedds", "--format", "json", "--build", BIN.parent],
                              env=self.environment, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        run, = json.loads(done.stdout)
        self.assertGreater(run["loop"]["steps"], 20)
        self.assertEqual([row["part"] for row in run["loop"]["by_step"][:3]],
                         ["command_to_line", "line_to_state", "jitter"])
        self.assertEqual(len(run["stop"]["milliseconds"]), 4)
