"""What ROS 2's tools would see of a robot, seen by a client that shares no code with Lamprey or its DDS vendors."""
import fcntl
import hashlib
import json
import math
import queue
import random
import shutil
import signal
import subprocess
import threading

from support import BIN, ROOT, Programs

CLIENT = ROOT / "tests" / "end_to_end" / "ros2"
JOINTS = ["front_left_vertical", "front_right_vertical", "front_left_horizontal", "front_right_horizontal",
          "back_left_vertical", "back_right_vertical", "back_left_horizontal", "back_right_horizontal"]
JOINT_STATE_HASH = "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"
UNIT = math.radians(4.5)  # of the mock


def installed_client():
    """The folder of the client and its packages, in the build tree; they are installed there once."""
    folder = BIN.parent / "ros2_listener"
    folder.mkdir(exist_ok=True)
    with open(folder / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        sources = [CLIENT / name for name in ("package.json", "package-lock.json", ".npmrc")]
        wanted = hashlib.sha256(b"".join(source.read_bytes() for source in sources)).hexdigest()
        done = folder / "installed"
        if not done.exists() or done.read_text() != wanted:
            for source in sources:
                shutil.copy(source, folder)
            result = subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder,
                                    capture_output=True, text=True, timeout=300)
            if result.returncode != 0:
                raise AssertionError(f"npm ci failed:\n{result.stdout}\n{result.stderr}")
            done.write_text(wanted)
        # node looks for packages beside the program that asks for them.
        for program in ("listener.js", "mcap_reader.js"):
            shutil.copy(CLIENT / program, folder)
    return folder


class Ros2(Programs):
    dds = other_dds = None

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.client = installed_client()

    def setUp(self):
        super().setUp()
        self.environment["LAMPREY_ISOLATION"] = self.isolation
        # ROS 2 knows no isolation: a domain that others hardly use at the time.
        self.domain = random.randrange(201, 230)

    def start_robot(self, *more):
        bridge = self.start("lamprey-bridge", "--robot", "bench", "--driver", "mock", "--state", self.folder / "state",
                            "--dds", self.dds, "--loopback-only", "--ros2", "--ros2-domain", self.domain, *more)
        self.wait_until(lambda: "ROS 2 sees the robot" in self.log_of(bridge), "the bridge joining ROS 2's domain")
        return bridge

    def start_listener(self):
        log = open(self.folder / "listener.log", "w+")
        self.addCleanup(log.close)
        listener = subprocess.Popen(["node", self.client / "listener.js", str(self.domain)], stdout=subprocess.PIPE,
                                    stderr=log, text=True, env=self.environment)
        self.addCleanup(listener.stdout.close)
        listener.log = log
        listener.args[0] = self.client / "node"
        self.processes.append(listener)
        self.listener = listener
        lines = queue.Queue()
        reader = threading.Thread(target=lambda: [lines.put(json.loads(line)) for line in listener.stdout])
        reader.start()
        self.addCleanup(reader.join)
        self.addCleanup(listener.kill)
        return lines

    def start_commander(self, angles):
        return self.start("lamprey_ros2_commander", "--dds", self.other_dds, "--domain", self.domain, "--loopback-only",
                          "--", *angles)

    def next_of(self, lines, topic, condition=lambda message: True):
        """The next message of the topic for which the condition holds, with what its publisher announces."""
        found = []

        def look():
            self.assertIsNone(self.listener.poll(), "the listener has ended; its log:\n" + self.log_of(self.listener))
            while not lines.empty():
                line = lines.get()
                if line["topic"] == topic and condition(line["message"]):
                    found.append(line)
            return found
        self.wait_until(look, f"a message of {topic}")
        return found[0]["message"], found[0]["userData"]

    def next_diagnostics(self, lines, condition=lambda values: True):
        def values(message):
            return {pair["key"]: pair["value"] for pair in message["status"][0]["values"]}
        message, _ = self.next_of(lines, "/diagnostics", lambda one: condition(values(one)))
        return message["status"][0], values(message)


class Tests:
    """Of a robot that speaks through one vendor, commanded through the other; the listener is neither."""

    def test_joint_states_are_decoded(self):
        self.start_robot()
        lines = self.start_listener()
        message, user_data = self.next_of(lines, "/joint_states")
        self.assertEqual(message["name"], JOINTS)
        self.assertEqual(message["position"], [0] * 8)
        self.assertEqual(message["effort"], [])
        self.assertEqual(message["header"]["frame_id"], "base_link")
        self.assertGreater(message["header"]["stamp"]["sec"], 1_700_000_000)
        self.assertEqual(user_data, f"typehash={JOINT_STATE_HASH};")

    def test_diagnostics_follow_the_robot(self):
        self.start_robot()
        lines = self.start_listener()
        status, values = self.next_diagnostics(lines, lambda values: values["state"] == "inactive")
        self.assertEqual(status["name"], "lamprey-bridge: bench")
        self.assertEqual(status["hardware_id"], "the simulator's quadruped")
        self.assertEqual(status["level"], 0)
        self.assertEqual(values["steps"], "0")
        self.lamprey("bridge", "stop", "bench", "--loopback-only", "--reason", "a test")
        status, values = self.next_diagnostics(lines, lambda values: values["stopped"] == "yes")
        self.assertEqual(status["level"], 1)
        self.assertEqual(values["reason"], "emergency stop: a test")

    def test_commands_move_an_active_robot_that_no_job_has(self):
        self.start_robot("--activate")
        lines = self.start_listener()
        # The last one is beyond the range of 0 to 30 units.
        self.start_commander([UNIT * units for units in (1, -2, 3, -4, 5, -6, 7, 1000)])
        expected = [UNIT * units for units in (1, -2, 3, -4, 5, -6, 7, 20)]
        self.next_of(lines, "/joint_states", lambda message: all(
            math.isclose(position, wanted, abs_tol=1e-9) for position, wanted in zip(message["position"], expected)))

    def test_commands_do_not_move_an_inactive_robot(self):
        self.start_robot()
        lines = self.start_listener()
        self.start_commander([UNIT] * 8)
        self.next_diagnostics(lines, lambda values: int(values["ros2_commands_refused_not_active"]) > 3)
        message, _ = self.next_of(lines, "/joint_states")
        self.assertEqual(message["position"], [0] * 8)

    def test_a_job_has_the_robot_to_itself(self):
        self.start_robot("--activate", "--rate", 500, "--grace", 2000)
        lines = self.start_listener()
        self.start_commander([UNIT] * 8)
        self.next_diagnostics(lines, lambda values: int(values["ros2_commands_obeyed"]) > 0)
        sweep = self.write("walk.yaml", "name: walk\nbase: {robot: bridge, cycles: 4, equilibrium_disturbance: 0, "
                           "posture: carry}\n")
        database = self.folder / "walk.db"
        self.start_coordinator(database)
        self.start("lamprey-worker", "--bridge", "bench", *self.join)
        self.lamprey("submit", sweep, "--loopback-only", "--timeout", 30)
        self.wait_for_end(database)
        # What the walk's preset scores where nothing disturbs it.
        self.assertEqual(self.rows(database, "SELECT initial_stability, initial_distance, initial_fuel FROM result"),
                         [(80, 60, 83)])
        self.next_diagnostics(lines, lambda values: int(values["ros2_commands_refused_claimed"]) > 0)

    def test_it_ends_when_it_is_told_to(self):
        bridge = self.start_robot()
        lines = self.start_listener()
        self.next_of(lines, "/joint_states")
        bridge.send_signal(signal.SIGTERM)
        self.next_diagnostics(lines, lambda values: values["state"] == "finalized")
        self.assertEqual(bridge.wait(30), 0, self.log_of(bridge))


class OnCyclone(Tests, Ros2):
    dds, other_dds = "cyclonedds", "fastdds"


class OnFast(Tests, Ros2):
    dds, other_dds = "fastdds", "cyclonedds"


class Recording(Ros2):
    """The bridge's MCAP files, read by a library that shares no code with Lamprey."""

    def record(self):
        """A job on the simulated robot, recorded: the bridge, and the file."""
        file = self.folder / "walk.mcap"
        bridge = self.start("lamprey-bridge", "--robot", "bench", "--driver", "mock", "--state", self.folder / "state",
                            "--activate", "--rate", 200, "--grace", 2000, "--record", file)
        sweep = self.write("walk.yaml", "name: walk\nbase: {robot: bridge, cycles: 1, equilibrium_disturbance: 0, "
                           "posture: carry}\n")
        self.lamprey("run", sweep, "--database", self.folder / "walk.db", "--bridge", "bench", "--quiet", timeout=120)
        return bridge, file

    def read(self, file, *more):
        done = subprocess.run(["node", self.client / "mcap_reader.js", file, *more], capture_output=True, text=True,
                              timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def check_steps(self, lines):
        """The file tells what the database tells."""
        by_topic = {}
        for line in lines:
            if "topic" in line:
                by_topic.setdefault(line["topic"], []).append(line["message"])
        steps = by_topic["/robot_step"]
        stored = {}
        for *when, servo, reported in self.rows(self.folder / "walk.db", "SELECT attempt, evaluation, try, step, servo, "
                                                "reported FROM motion ORDER BY attempt, evaluation, try, step"):
            stored.setdefault(tuple(when), {})[servo.replace(" ", "_")] = reported
        done = [step for step in steps if step["done"]]
        self.assertEqual(len(done), len(stored))
        self.assertEqual(len(by_topic["/joint_states"]), len(done))
        self.assertEqual(len(by_topic["/commanded_joint_states"]), len(done))
        for message, positions in zip(by_topic["/joint_states"], stored.values()):
            self.assertEqual(message["name"], JOINTS)
            for name, position in zip(JOINTS, message["position"]):
                self.assertAlmostEqual(position, (positions[name] - 10) * UNIT, places=9)
        return len(steps) + 2 * len(done)

    def test_a_finished_file_tells_what_the_database_tells(self):
        bridge, file = self.record()
        bridge.send_signal(signal.SIGTERM)
        self.assertEqual(bridge.wait(30), 0, self.log_of(bridge))
        lines = self.read(file)
        self.assertEqual(lines[-1], {"statistics": self.check_steps(lines)})

    def test_a_killed_bridge_leaves_a_file_that_can_be_read(self):
        bridge, file = self.record()
        bridge.kill()
        bridge.wait()
        self.check_steps(self.read(file, "--cut"))
