"""Workers and coordinators that die all the time: nothing that was acknowledged is missing, nobody innocent is blamed."""
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import time

from support import BIN, EVERY_OPERATOR, FULL, Programs, grid


class Churn(Programs):
    def test_workers_that_are_killed_and_replaced(self):
        jobs = 100_000 if FULL else 10_000
        sweep = self.write("churn.yaml", f"name: churn\nseed: 2006\nbase: {{cycles: 500}}\ngrids:\n"
                           f"  - {{required_fuel: [25, 50, 75, 100]}}\nreplicates: {jobs // 4}\n")
        database = self.folder / "churn.db"
        draw = random.Random(7)
        self.start_coordinator(database)
        workers = [self.start_worker(dds) for dds in ("cyclonedds", "fastdds", "cyclonedds")]
        start = time.monotonic()
        self.lamprey("submit", sweep, *self.join, "--timeout", 30)
        killed = 0
        while self.jobs_stored(database) < jobs:
            until = time.monotonic() + draw.uniform(1.5, 3.0)
            self.wait_until(lambda: time.monotonic() > until or self.jobs_stored(database) == jobs, "a moment")
            if self.jobs_stored(database) == jobs:
                break
            victim = draw.randrange(len(workers))
            workers[victim].kill()
            self.assertEqual(workers[victim].wait(), -signal.SIGKILL)
            workers[victim] = self.start_worker(draw.choice(("cyclonedds", "fastdds")))
            killed += 1
            self.assertLess(time.monotonic() - start, 3000, "the sweep must end in spite of the killing")
        disturbed = time.monotonic() - start
        self.wait_for_end(database)
        self.assertGreater(killed, 1)
        self.assertEqual(self.jobs_stored(database), jobs)
        self.assertEqual(self.rows(database, "SELECT state, count(*) FROM job GROUP BY state"), [("done", jobs)])
        self.assertEqual(self.number(database, "SELECT count(*) FROM divergence"), 0)
        self.lamprey("verify", database)
        quiet = self.folder / "quiet.db"
        seconds = self.json("run", sweep, "--database", quiet, "--workers", 3, "--quiet", timeout=3000)["seconds"]
        self.assertEqual(self.digests(database), self.digests(quiet))
        print(f"\n{jobs} jobs: {disturbed:.1f} s while {killed} workers were killed and replaced, {seconds:.1f} s in quiet "
              f"({100 * (disturbed / seconds - 1):.0f} % more)", file=sys.stderr)


class Acknowledgements(Programs):
    def setUp(self):
        super().setUp()
        self.database = self.folder / "moments.db"
        self.submitted = 0

    def observe(self):
        """Who hears what workers are told; its lines go to a file."""
        lines = open(self.folder / "acknowledged", "w")
        self.addCleanup(lines.close)
        observer = subprocess.Popen([BIN / "lamprey_acknowledgement_observer", "cyclonedds", self.isolation],
                                    stdin=subprocess.PIPE, stdout=lines, env=self.environment)
        self.addCleanup(observer.stdin.close)
        self.processes.append(observer)

    def acknowledged(self):
        text = (self.folder / "acknowledged").read_text()
        lines = [line.split() for line in text[:text.rfind("\n") + 1].splitlines()]
        for _, _, verdict in lines:
            self.assertIn(verdict, ("committed", "duplicate"))
        return {(sweep, int(job)) for sweep, job, _ in lines}

    def stored(self):
        """What the file holds, as the dead coordinator left it: a copy is opened, so that nothing is repaired."""
        copy = self.folder / "copy.db"
        for ending in ("", "-wal"):
            if (source := self.database.with_name(self.database.name + ending)).exists():
                shutil.copyfile(source, copy.with_name(copy.name + ending))
        connection = sqlite3.connect(copy)
        try:
            return set(connection.execute("SELECT id, job FROM job JOIN sweep USING (sweep)"))
        finally:
            connection.close()
            for ending in ("", "-wal", "-shm"):
                copy.with_name(copy.name + ending).unlink(missing_ok=True)

    def counted(self, dds, *states):
        sweeps = self.json("status", "--dds", dds, *self.join, "--timeout", 30)["sweeps"]
        return sum(sweep["counts"][state] for sweep in sweeps for state in states)

    def keep_busy(self, dds):
        """Jobs are leased whenever the coordinator is to be killed, however fast the machine; not many more than that."""
        while self.counted(dds, "leased", "pending") < 1000:
            sweep = self.write("part.yaml", grid(f"part-{self.submitted}", EVERY_OPERATOR, cycles=2000, replicates=5,
                                                 seed=self.submitted))
            self.lamprey("submit", sweep, "--dds", dds, *self.join, "--timeout", 30)
            self.submitted += 1
        self.wait_until(lambda: self.counted(dds, "leased") > 0, "a lease")

    def test_none_is_missing_whenever_the_coordinator_is_killed(self):
        moments = 100 if FULL else 12
        draw = random.Random(11)
        self.observe()
        for dds in ("cyclonedds", "fastdds"):
            self.start_worker(dds)
        heard = set()
        for moment in range(moments):
            dds = ("cyclonedds", "fastdds")[moment % 2]
            coordinator = self.start_coordinator(self.database, dds)
            self.keep_busy(dds)
            before = len(heard)
            self.wait_until(lambda: len(self.acknowledged()) > before, "an acknowledgement by this coordinator")
            time.sleep(draw.uniform(0.0, 1.5))
            coordinator.kill()
            coordinator.wait()
            time.sleep(0.2)  # what it sent last is heard
            heard = self.acknowledged()
            missing = heard - self.stored()
            self.assertFalse(missing, f"acknowledged, but not in the file after kill {moment + 1}")
        self.start_coordinator(self.database)
        self.wait_for_end(self.database, 600)
        self.assertFalse(heard - self.stored())
        self.assertEqual(self.number(self.database, "SELECT count(*) FROM divergence"), 0)
        self.assertEqual(self.number(self.database, "SELECT count(*) FROM job WHERE state <> 'done'"), 0)
        self.assertEqual(self.number(self.database, "SELECT epoch FROM database"), moments + 1)
        self.lamprey("verify", self.database)
        print(f"\n{len(heard)} acknowledgements heard, {moments} coordinators killed, none missing", file=sys.stderr)
