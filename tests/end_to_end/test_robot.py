"""A robot in the simulator's place: worker, bridge, driver, serial line and servo controller, as real processes."""
import hashlib
import json
import shutil
import signal
import subprocess
import time

from support import BIN, FULL, ROOT, Programs

# Steps per second that leave a servo time to arrive even where a loaded machine holds its octets back: what goes through a
# pseudo-terminal is passed on by a thread of the kernel's that waits for a processor like any other. At full size the
# machine has to be a quiet one. The SSC-32 tells of a contact 15 ms late besides.
SSC32_RATE = 10 if FULL else 5
DYNAMIXEL_RATE = 20 if FULL else 10
CALIBRATIONS = ROOT / "robot_bridge" / "calibrations"


class Robot(Programs):
    """Helpers for tests with a bridge and an emulated servo controller."""

    def setUp(self):
        super().setUp()
        self.environment["LAMPREY_ISOLATION"] = self.isolation

    def start_emulator(self, family):
        line = self.folder / "tty"
        emulator = self.start(f"lamprey-{family}-emulator", "--link", line, "--quadruped", "--report",
                              self.folder / "report.json", "--control", self.folder / "control")
        self.wait_until(line.exists, "the emulator's line")
        return emulator

    def start_bridge(self, family, rate, *more):
        port = [] if family == "mock" else ["--port", self.folder / "tty", "--calibration",
                                            CALIBRATIONS / f"quadruped_{family}.yaml"]
        # A loaded test machine is slow, which is no fault of the robot's.
        return self.start("lamprey-bridge", "--robot", "bench", "--driver", family, *port, "--rate", rate, "--grace",
                          2000, "--state", self.folder / "state", *more)

    def status(self):
        robots = self.json("bridge", "status", "bench", "--timeout", 30)["robots"]
        return robots[0]

    def wait_for_state(self, state):
        self.wait_until(lambda: self.status()["state"] == state, f"the robot being {state}")

    def sweep(self, name, axes, cycles):
        return self.write(f"{name}.yaml", f"name: {name}\nseed: 2006\nbase: {{cycles: {cycles}, posture: carry, "
                          f"equilibrium_disturbance: 50}}\ngrids:\n  - {{robot: [quadruped, bridge], {axes}}}\n")

    def run_on_robot(self, sweep, database):
        self.lamprey("run", sweep, "--database", database, "--bridge", "bench", "--quiet", timeout=1800)

    def check_gap(self, database, jobs):
        """Each job on the robot has come to what its twin in simulation has."""
        scores = "expected_total, initial_total, evolved_total, highest_total, final_total, final_stability, " \
                 "final_distance, final_fuel, success_rate"
        by_robot = {robot: self.rows(database, f"SELECT mutation, steps, required_fuel, {scores} FROM result WHERE robot = '{robot}' "
                                               f"AND state = 'done' ORDER BY mutation, steps, required_fuel")
                    for robot in ("quadruped", "bridge")}
        self.assertEqual(len(by_robot["bridge"]), jobs)
        self.assertEqual(by_robot["bridge"], by_robot["quadruped"])
        self.assertEqual(self.rows(database, "SELECT DISTINCT repeatability FROM result WHERE robot = 'bridge'"),
                         [("physical",)])

    def check_limits(self, lowest, highest, fastest):
        """Of what has ever reached the servo controller."""
        report = json.loads((self.folder / "report.json").read_text())
        self.assertEqual(len(report["servos"]), 8)
        for number, servo in report["servos"].items():
            self.assertGreater(servo["moves"], 100, number)
            self.assertGreaterEqual(servo["lowest"], lowest, number)
            self.assertLessEqual(servo["highest"], highest, number)
            # By the times of arrival, which a machine that stops a program for some milliseconds draws together; what a
            # step may be at most is checked by test_robot_faults.
            self.assertLessEqual(servo["largest_speed"], 1.5 * fastest, number)
            self.assertEqual(servo["largest_jump"], 0, number)

    def finish(self, bridge, emulator):
        for process in (bridge, emulator):
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(30), 0, self.log_of(process))


class OnControllers(Robot):
    """20 jobs of 5 cycles at full size; reduced two of 2 cycles, since a robot takes its own time."""

    def compare(self, name, steps):
        """Both mutations on each step kind, five times over at full size."""
        self.check_walk()
        fuels = "20, 40, 60, 80, 100" if FULL else "100"
        axes = f"mutation: [all, one], steps: [{steps}], required_fuel: [{fuels}]"
        database = self.folder / "robot.db"
        self.run_on_robot(self.sweep(name, axes, 5 if FULL else 2), database)
        self.check_gap(database, 20 if FULL else 2)

    def check_walk(self):
        """The preset of the walk scores what the thesis says: 80, 60, 83."""
        sweep = self.write("walk.yaml", "name: walk\nbase: {robot: bridge, cycles: 1, equilibrium_disturbance: 0, "
                           "posture: carry}\n")
        database = self.folder / "walk.db"
        self.run_on_robot(sweep, database)
        self.assertEqual(self.rows(database, "SELECT initial_stability, initial_distance, initial_fuel FROM result"),
                         [(80, 60, 83)])


class OnSsc32(OnControllers):
    def test_comes_to_what_the_simulator_comes_to(self):
        emulator = self.start_emulator("ssc32")
        bridge = self.start_bridge("ssc32", SSC32_RATE, "--activate", "--confirm-pose")
        self.wait_for_state("active")
        self.compare("ssc32", "uniform, normal" if FULL else "uniform")
        self.finish(bridge, emulator)
        self.check_limits(500, 2000, 3000)


class OnDynamixel(OnControllers):
    def test_comes_to_what_the_simulator_comes_to(self):
        emulator = self.start_emulator("dynamixel")
        bridge = self.start_bridge("dynamixel", DYNAMIXEL_RATE, "--activate")
        self.wait_for_state("active")
        self.compare("dynamixel", "uniform, normal" if FULL else "normal")
        self.finish(bridge, emulator)
        self.check_limits(1648, 2848, 4000)


class Stop(Robot):
    def test_emergency_stop_needs_no_coordinator_and_outlives_the_bridge(self):
        bridge = self.start_bridge("mock", 50, "--activate")
        self.wait_for_state("active")
        stopped = self.json("bridge", "stop", "bench", "--reason", "a test")
        self.assertTrue(stopped["stopped"])
        self.assertEqual(stopped["reason"], "")
        bridge.kill()
        bridge.wait()
        self.start_bridge("mock", 50, "--activate")
        status = self.status()
        self.assertTrue(status["stopped"])
        self.assertEqual(status["reason"], "a test")
        self.wait_for_state("inactive")
        refused = self.lamprey("bridge", "activate", "bench", code=1)
        self.assertIn("emergency stop: a test", refused.stderr)
        self.lamprey("bridge", "reset", "bench")
        self.lamprey("bridge", "activate", "bench")
        self.wait_for_state("active")

    def test_emergency_stop_finds_a_bridge_of_either_vendor(self):
        """Over Cyclone DDS, which each bridge is on: Fast DDS may need seconds to find a program."""
        for bridge_dds, client_dds in (("fastdds", "fastdds"), ("fastdds", "cyclonedds"), ("cyclonedds", "fastdds")):
            bridge = self.start_bridge("mock", 50, "--activate", "--dds", bridge_dds)
            self.wait_for_state("active")
            answer = self.json("bridge", "stop", "bench", "--dds", client_dds)
            self.assertTrue(answer["stopped"])
            print(f"\n  {client_dds} -> {bridge_dds}: {1000 * answer['seconds']:.0f} ms", end=" ", flush=True)
            self.lamprey("bridge", "reset", "bench")
            bridge.send_signal(signal.SIGTERM)
            self.assertEqual(bridge.wait(30), 0, self.log_of(bridge))

    def test_a_stop_in_mid_job_is_waited_out(self):
        self.start_bridge("mock", 200, "--activate")
        self.wait_for_state("active")
        database = self.folder / "robot.db"
        sweep = self.sweep("stopped", "mutation: [all, one]", 5)
        run = subprocess.Popen([BIN / "lamprey", "run", sweep, "--database", database, "--bridge", "bench", "--quiet"],
                               cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL)
        self.processes.append(run)
        run.log = open(self.folder / "run.log", "w+")
        self.addCleanup(run.log.close)
        self.wait_until(lambda: self.status()["counters"]["steps"] > 50, "the robot moving")
        self.lamprey("bridge", "stop", "bench")
        time.sleep(1)
        self.lamprey("bridge", "reset", "bench")
        self.lamprey("bridge", "activate", "bench")
        self.assertEqual(run.wait(120), 0)
        self.assertEqual(self.number(database, "SELECT count(*) FROM result WHERE state = 'done'"), 4)
        self.assertGreater(self.status()["counters"]["evaluations_voided"], 0)
        kinds = {kind for kind, in self.rows(database, "SELECT DISTINCT kind FROM event")}
        self.assertLessEqual({"robot_joined", "robot_active", "robot_inactive", "robot_stopped", "robot_reset",
                              "robot_evaluations_voided"}, kinds)


class Claim(Robot):
    def test_none_of_a_stopped_workers_commands_moves_a_servo(self):
        emulator = self.start_emulator("dynamixel")
        bridge = self.start_bridge("dynamixel", 50, "--activate")
        self.wait_for_state("active")
        database = self.folder / "claims.db"
        self.start("lamprey-coordinator", "--database", database)
        first = self.start("lamprey-worker", "--bridge", "bench")
        self.lamprey("submit", self.sweep("claims", "mutation: [all, one]", 3), "--timeout", 30)
        self.wait_until(lambda: self.status()["counters"]["steps"] > 60, "the first worker moving the robot")
        token = self.status()["claim"]
        first.send_signal(signal.SIGSTOP)
        self.start("lamprey-worker", "--bridge", "bench")
        self.wait_until(lambda: (self.status()["claim"] or 0) > token, "a claim of the second worker")
        first.send_signal(signal.SIGCONT)
        self.wait_for_end(database, 300)
        self.assertEqual(self.number(database, "SELECT count(*) FROM result WHERE state = 'done'"), 4)
        self.finish(bridge, emulator)
        self.check_limits(1648, 2848, 4000)


class Example(Robot):
    """The example in C: a robot that shares nothing with the bridge but the topics' documentation."""

    def start_example(self):
        number = hashlib.sha256(b"bench").hexdigest()[:16]
        robot = subprocess.Popen([BIN / "lamprey-example-robot", "bench", number, self.isolation,
                                  self.folder / "bench.state"], cwd=self.folder, env=self.environment)
        robot.log = None
        self.processes.append(robot)
        self.wait_for_state("active")
        return robot

    def test_walks_and_comes_to_what_the_simulator_comes_to(self):
        robot = self.start_example()
        database = self.folder / "example.db"
        self.run_on_robot(self.sweep("example", "mutation: [all, one], steps: [uniform, normal]", 20), database)
        self.check_gap(database, 4)
        robot.send_signal(signal.SIGTERM)
        self.assertEqual(robot.wait(30), 0)

    def test_is_built_by_the_commands_in_its_head(self):
        source = ROOT / "messaging" / "cyclonedds" / "example" / "example_robot.c"
        for file in (source, ROOT / "idl" / "robot.idl"):
            shutil.copy(file, self.folder)
        commands = [line[5:].split("  ")[0] for line in source.read_text().splitlines()
                    if line.startswith((" *   idlc", " *   cc"))]
        self.assertEqual(len(commands), 2)
        for command in commands:
            subprocess.run(command, shell=True, check=True, cwd=self.folder)
        usage = subprocess.run([self.folder / "example_robot"], capture_output=True, text=True)
        self.assertEqual(usage.returncode, 2)
        self.assertIn("NAME NUMBER ISOLATION STATE_FILE", usage.stderr)

    def test_latches_its_stop_and_never_grants_a_token_again(self):
        robot = self.start_example()
        self.lamprey("bridge", "stop", "bench", "--reason", "a test")
        robot.kill()
        robot.wait()
        number = hashlib.sha256(b"bench").hexdigest()[:16]
        self.processes.append(subprocess.Popen([BIN / "lamprey-example-robot", "bench", number, self.isolation,
                                                self.folder / "bench.state"], env=self.environment))
        self.wait_until(lambda: self.status()["stopped"], "the stop being known after a restart")
        self.assertEqual(self.status()["reason"], "a test")
        self.lamprey("bridge", "activate", "bench", code=1)
        self.lamprey("bridge", "reset", "bench")
        self.lamprey("bridge", "activate", "bench")


class Calibrate(Robot):
    def calibrate(self, family, talk, code=0):
        done = subprocess.run([BIN / "lamprey", "bridge", "calibrate", "--driver", family, "--port", self.folder / "tty",
                               "--calibration", self.folder / "measured.yaml"], cwd=self.folder, env=self.environment,
                              input=talk, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def test_a_joint_that_was_wrong_is_measured_anew(self):
        emulator = self.start_emulator("ssc32")
        shipped = (CALIBRATIONS / "quadruped_ssc32.yaml").read_text()
        right = "minimum: 500, centre: 1000, maximum: 2000, per_unit: 50"
        wrong = shipped.replace(right, "minimum: 900, centre: 1100, maximum: 1300, per_unit: 20", 1)
        (self.folder / "measured.yaml").write_text(wrong)
        done = self.calibrate("ssc32", "yes\n1000\nstand\n1500\nunits 20\n2000\nmaximum\n500\nminimum\nsave\n")
        self.assertIn("a unit is 50", done.stdout)
        self.assertEqual((self.folder / "measured.yaml.before").read_text(), wrong)
        self.assertEqual((self.folder / "measured.yaml").read_text().count(right), 8)
        bridge = self.start("lamprey-bridge", "--robot", "bench", "--driver", "ssc32", "--port", self.folder / "tty",
                            "--calibration", self.folder / "measured.yaml", "--state", self.folder / "state",
                            "--activate", "--confirm-pose")
        self.wait_for_state("active")
        self.finish(bridge, emulator)

    def test_dynamixel_servos_tell_where_they_are(self):
        self.start_emulator("dynamixel")
        done = self.calibrate("dynamixel", "free\nstand\nquit\n")
        self.assertIn("1 front left vertical at 2048", done.stdout)
        self.assertIn("Nothing is written.", done.stdout)
        self.assertFalse((self.folder / "measured.yaml").exists())

    def test_a_line_that_is_not_there_is_an_error(self):
        done = self.calibrate("ssc32", "", code=1)
        self.assertIn("tty", done.stderr)
