"""The benchmarks run; what they measure is for people to read."""
import json
import os
import subprocess
import unittest

from support import BIN, Programs, ROOT


class Messaging(Programs):
    def measure(self, *options):
        return subprocess.run([ROOT / "benchmarks" / "messaging", "--runs", "1", "--trips", "50", "--leases", "1000",
                               "--records", "10000", "--build", BIN.parent, *options],
                              env=self.environment, capture_output=True, text=True, timeout=300)

    def test_each_vendors_part_can_be_measured(self):
        done = self.measure("--pair", "cyclonedds-fastdds", "fastdds-cyclonedds", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        pairs = json.loads(done.stdout)["pairs"]
        self.assertEqual([(pair["from"], pair["to"]) for pair in pairs],
                         [("cyclonedds", "fastdds"), ("fastdds", "cyclonedds")])
        for pair in pairs:
            self.assertGreaterEqual(pair["records_without_loss"], 10_000)
            self.assertEqual(len(pair["measures"]), 10)
            for name, measure in pair["measures"].items():
                self.assertGreater(measure["port"]["median"], 0, name)
                self.assertGreater(measure["raw"]["median"], 0, name)

    def test_as_over_a_network_and_as_a_table(self):
        done = self.measure("--pair", "fastdds-fastdds", "--network")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("fastdds → fastdds: 12,800 records, none lost or doubled", done.stdout)
        self.assertIn("first match", done.stdout)

    def test_bad_options_are_refused(self):
        for options in (["--runs", "0"], ["--records", "-1"], ["--pair", "rti-fastdds"]):
            self.assertEqual(self.measure(*options).returncode, 2, options)


def obstacle():
    """Why packets can't be counted here, or None."""
    user = [] if os.geteuid() == 0 else ["--map-root-user"]
    attempt = subprocess.run(["unshare", "--net", *user, "true"], capture_output=True, text=True, check=False)
    return None if attempt.returncode == 0 else "network namespaces are not permitted here: " + attempt.stderr.strip()


OBSTACLE = obstacle()


class Sized(Programs):
    def measure(self, *options):
        return subprocess.run([ROOT / "benchmarks" / "scale", "--runs", "1", "--workers", "4", "--fit", "1", "2",
                               "--settling", "1", "--idle", "2", "--simulated", "30", "--jobs", "400", "--cycles", "3", "--build", BIN.parent,
                               *options], env=self.environment, capture_output=True, text=True, timeout=600)


@unittest.skipIf(OBSTACLE, OBSTACLE)
class Scale(Sized):
    def test_processes_of_each_vendor(self):
        done = self.measure("--part", "processes", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        for dds, rows in json.loads(done.stdout)["processes"].items():
            self.assertEqual(sorted(rows["sizes"]), ["1", "2", "4"], dds)
            for size, row in rows["sizes"].items():
                # Discovery's part of what so few say and compute is too little to be told from what they always do.
                for name in ("working_seconds", "joined_seconds", "idle_packets_per_second", "idle_octets_per_second",
                             "worker_share_megabytes", "one_more_joined_seconds"):
                    self.assertGreater(row[name]["median"], 0, f"{dds}, {size}: {name}")
            for name in ("joined_seconds", "idle_packets_per_second", "idle_octets_per_second"):
                self.assertGreater(rows["predictions"][name]["predicted"], 0, f"{dds}: {name}")

    def test_as_over_a_network_and_as_a_table(self):
        done = self.measure("--part", "processes", "--network", "--dds", "cyclonedds")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("predicted from 1, 2 for 4", done.stdout)
        self.assertIn("working seconds", done.stdout)


class Simulated(Sized):
    def test_costs_are_told(self):
        done = self.measure("--part", "simulated", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        spaced, unbounded = json.loads(done.stdout)["simulated"]
        for row in (spaced, unbounded):
            self.assertEqual(row["workers"]["median"], 30)
            self.assertGreater(row["jobs_per_second"]["median"], 0)
            self.assertGreater(row["cpu_microseconds_per_job"]["median"], 0)
            self.assertGreater(row["idle_bytes_per_worker"]["median"], 0)
        # 30 workers with a job in 100 ms each: no more than that, whatever the coordinator could do.
        self.assertLessEqual(spaced["jobs_per_second"]["median"], 300)
        self.assertGreater(spaced["leases"]["median"], 30)

    def test_what_they_leave_is_a_database_like_any_other(self):
        done = subprocess.run([BIN / "simulated_workers", "--workers", "7", "--jobs", "80", "--database", "crowd.db"],
                              cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        database = self.folder / "crowd.db"
        self.assertEqual(self.rows(database, "SELECT state, count(*) FROM job GROUP BY state"), [("done", 80)])
        self.assertEqual(self.number(database, "SELECT count(DISTINCT worker) FROM job"), 7)
        self.lamprey("verify", database)
        again = subprocess.run([BIN / "simulated_workers", "--database", "crowd.db"], cwd=self.folder,
                               capture_output=True, text=True, timeout=120)
        self.assertEqual(again.returncode, 1)
        self.assertIn("'crowd.db' exists", again.stderr)

    def test_bad_options_are_refused(self):
        for options in (["--runs", "0"], ["--workers", "0"], ["--fit", "2"], ["--fit", "2", "4"], ["--dds", "rti"],
                        ["--workers", "111"], ["--idle", "0"], ["--settling", "0"], ["--simulated", "0"], ["--jobs", "3"]):
            self.assertEqual(self.measure(*options).returncode, 2, options)
