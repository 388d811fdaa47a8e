"""A coordinator and workers on machines of their own, and what can be seen of them."""
import json
import os
import pathlib
import sqlite3
import subprocess
import time

PATIENCE = 90  # seconds for what normally takes a few: a deadline against hanging, never a measurement


class ChaosFailed(Exception):
    """Something that had to hold did not."""


class Cluster:
    def __init__(self, bin_folder, folder, network, plan):
        self.bin = pathlib.Path(bin_folder)
        self.folder = folder
        self.network = network
        self.plan = plan
        self.disk = folder / "disk"
        self.disk.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=512m", "none", str(self.disk)], check=True)
        self.database = self.disk / "chaos.db"
        self.home = network.machines["coordinator"]
        self.places = [network.machines[f"worker-{number}"] for number in range(len(plan.workers))]
        self.environment = {name: value for name, value in os.environ.items()
                            if not name.startswith(("LAMPREY_", "CYCLONEDDS_", "FASTRTPS_", "ROS_"))}
        self.coordinator = None
        self.workers = [None] * len(self.places)
        self.logs = {}
        self.computed_by_the_gone = 0
        self.feed = lambda: None  # submits more work if little is left

    def close(self):
        for process in [self.coordinator, *self.workers]:
            if process is not None and process.poll() is None:
                process.kill()
                process.wait()
        for log in self.logs.values():
            log.close()
        subprocess.run(["umount", str(self.disk)], check=True)

    # Processes

    def _start(self, machine, program, *arguments):
        log = self.logs.setdefault(machine.name, open(self.folder / f"{machine.name}.log", "a"))
        return subprocess.Popen(machine.command(self.bin / program, *arguments), stdout=log, stderr=log,
                                env=self.environment, cwd=self.folder)

    def join(self, machine, dds):
        arguments = ["--dds", dds, "--isolation", "chaos"]
        if self.plan.discovery == "peers" and machine is not self.home:
            arguments += ["--peer", self.home.address]
        return arguments

    def start_coordinator(self):
        self.coordinator = self._start(self.home, "lamprey-coordinator", "--database", self.database,
                                       *self.join(self.home, self.plan.coordinator))

    def start_worker(self, place):
        machine = self.places[place]
        self.workers[place] = self._start(machine, "lamprey-worker", "--threads", 1,
                                          *self.join(machine, self.plan.workers[place]))

    def log_of(self, machine):
        return (self.folder / f"{machine.name}.log").read_text()

    def check_that_all_live(self):
        for name, process in [("the coordinator", self.coordinator), *zip(self.network.machines, self.workers)]:
            if process is not None and process.poll() is not None:
                raise ChaosFailed(f"{name} has ended by itself with {process.returncode}")

    # What is seen of them

    def lamprey(self, *arguments, codes=(0,), timeout=PATIENCE):
        """The client, on the coordinator's machine; returns the JSON document."""
        result = subprocess.run(
            self.home.command(self.bin / "lamprey", *arguments, "--format", "json",
                              *self.join(self.home, self.plan.coordinator), "--timeout", 30),
            capture_output=True, text=True, env=self.environment, cwd=self.folder, timeout=timeout, check=False)
        if result.returncode not in codes:
            raise ChaosFailed(f"lamprey {' '.join(map(str, arguments))} ended with {result.returncode}: "
                              f"{result.stdout}{result.stderr}")
        return json.loads(result.stdout)

    def status(self):
        return self.lamprey("status")

    def leased(self, place=None):
        """How many jobs are leased now, as the coordinator says, or how many leases one worker has."""
        status = self.status()
        if place is None:
            return sum(sweep["counts"]["leased"] for sweep in status["sweeps"])
        process = self.workers[place].pid
        return sum(worker["leases"] for worker in status["workers"] if worker["process"] == process)

    def computed(self, place=None):
        """How many jobs the living workers have computed, or one of them."""
        processes = {worker.pid for at, worker in enumerate(self.workers) if place in (None, at)}
        return sum(worker["jobs_done"] for worker in self.status()["workers"] if worker["process"] in processes)

    def wait_until(self, condition, what, patience=PATIENCE):
        deadline = time.monotonic() + patience
        while not condition():
            if time.monotonic() > deadline:
                raise ChaosFailed(f"{what} did not happen within {patience} s")
            time.sleep(0.1)

    def rows(self, sql):
        """From the database, without disturbing the coordinator; nothing before it has its tables."""
        if not self.database.exists():
            return []
        connection = sqlite3.connect(f"file:{self.database}?mode=ro", uri=True, timeout=30)
        try:
            return connection.execute(sql).fetchall()
        except sqlite3.OperationalError as error:
            if "no such table" in str(error) or "unable to open" in str(error) or "full" in str(error):
                return []
            raise
        finally:
            connection.close()

    def jobs_ended(self):
        rows = self.rows("SELECT sum(done + failed + quarantined + cancelled) FROM sweep")
        return rows[0][0] or 0 if rows else None
