"""What the end-to-end tests share: running the programs as a user does, and looking at the databases they leave."""
import json
import os
import pathlib
import secrets
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BIN = pathlib.Path(os.environ.get("LAMPREY_BIN", ROOT / "build" / "release" / "bin"))
FULL = os.environ.get("LAMPREY_TEST_SIZE") == "full"
PATIENCE = 120  # seconds for what normally takes a few: a deadline against hanging, never a measurement


def grid(name, axes, cycles=1000, replicates=1, seed=2006):
    """A sweep file's text; `axes` in YAML flow style."""
    return (f"name: {name}\nseed: {seed}\nbase: {{cycles: {cycles}}}\n"
            f"grids:\n  - {{{axes}}}\nreplicates: {replicates}\n")


EVERY_OPERATOR = ("mutation: [all, one], steps: [uniform, normal, one_fifth_rule], acceptance: [simple, annealing], "
                  "criterion: [per_component, total], posture: [reset, carry], equilibrium_disturbance: [50, 100], "
                  "required_fuel: [25, 100]")


class Programs(unittest.TestCase):
    """A scratch folder and a partition of its own for every test; no process outlives it."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="lamprey-"))
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.isolation = "test-" + secrets.token_hex(8)
        self.processes = []
        self.addCleanup(self.kill_all)
        self.environment = {name: value for name, value in os.environ.items()
                            if not name.startswith(("LAMPREY_", "CYCLONEDDS_", "FASTRTPS_", "ROS_"))}
        self.environment["LAMPREY_CONFIG"] = "/dev/null"  # whatever this machine is set to

    def kill_all(self):
        for process in self.processes:
            if process.poll() is None:
                process.kill()
            process.wait()
            if process.stderr:
                process.stderr.close()

    @property
    def join(self):
        return ["--isolation", self.isolation, "--loopback-only"]

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def start(self, program, *arguments, **options):
        log = open(self.folder / f"{len(self.processes)}-{program}.log", "w+")
        process = subprocess.Popen([BIN / program, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=log,
                                   cwd=self.folder, env=self.environment, **options)
        process.log = log
        self.addCleanup(log.close)
        self.processes.append(process)
        return process

    def start_coordinator(self, database, dds="cyclonedds"):
        return self.start("lamprey-coordinator", "--database", database, "--dds", dds, *self.join)

    def start_worker(self, dds="cyclonedds", threads=1):
        return self.start("lamprey-worker", "--threads", threads, "--dds", dds, *self.join)

    def lamprey(self, *arguments, code=0, timeout=PATIENCE, environment=None):
        """Runs the client to its end and checks its exit code; returns its output."""
        result = subprocess.run([BIN / "lamprey", *map(str, arguments)], capture_output=True, text=True,
                                cwd=self.folder, timeout=timeout, env={**self.environment, **(environment or {})})
        if code is not None:
            self.assertEqual(result.returncode, code,
                             f"lamprey {' '.join(map(str, arguments))}\n{result.stdout}\n{result.stderr}")
        return result

    def json(self, *arguments, code=0, timeout=PATIENCE):
        return json.loads(self.lamprey(*arguments, "--format", "json", code=code, timeout=timeout).stdout)

    def log_of(self, process):
        process.log.flush()
        return pathlib.Path(process.log.name).read_text()

    def wait_until(self, condition, what, patience=PATIENCE):
        deadline = time.monotonic() + patience
        while not condition():
            if time.monotonic() > deadline:
                logs = "\n".join(f"--- {p.args[0].name}\n{self.log_of(p)[-3000:]}" for p in self.processes)
                self.fail(f"{what} did not happen within {patience} s\n{logs}")
            time.sleep(0.05)

    def rows(self, database, sql):
        """Like `sqlite3 FILE SQL`; an unreadable or missing file has no rows yet."""
        if not pathlib.Path(database).exists():
            return []
        connection = sqlite3.connect(f"file:{database}?mode=ro", uri=True, timeout=30)
        try:
            return connection.execute(sql).fetchall()
        except sqlite3.OperationalError as error:
            # A coordinator that has just started has not made its tables yet.
            if "no such table" in str(error) or "unable to open" in str(error):
                return []
            raise
        finally:
            connection.close()

    def number(self, database, sql):
        rows = self.rows(database, sql)
        return rows[0][0] if rows else 0

    def jobs_stored(self, database):
        return self.number(database, "SELECT count(*) FROM job")

    def digests(self, database):
        return self.rows(database, "SELECT sweep, job, state, digest FROM result ORDER BY sweep, job")

    def wait_for_end(self, database, patience=PATIENCE):
        self.wait_until(lambda: self.number(database, "SELECT count(*) FROM sweep") > 0 and self.number(
            database, "SELECT count(*) FROM sweep WHERE state IN ('running', 'cancelling')") == 0,
            "the end of the sweep", patience)

    def interrupt(self, process, patience=2.0):
        """Ctrl-C; the promise is an end within two seconds. Returns the exit code."""
        process.send_signal(signal.SIGINT)
        try:
            # The promise is about the program, not about a loaded test machine's scheduler: some grace on top.
            return process.wait(patience + 3.0)
        except subprocess.TimeoutExpired:
            self.fail(f"{process.args[0].name} was still running {patience + 3.0} s after Ctrl-C\n{self.log_of(process)}")
