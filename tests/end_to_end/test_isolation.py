"""Runs don't meet, and need no network."""
import os
import shutil
import subprocess
import unittest

from support import BIN, EVERY_OPERATOR, Programs, grid


class Isolation(Programs):
    def test_two_runs_side_by_side_both_finish(self):
        runs = []
        for name in ("left", "right"):
            sweep = self.write(f"{name}.yaml", grid(name, EVERY_OPERATOR, cycles=300))
            runs.append(subprocess.Popen([BIN / "lamprey", "run", sweep, "--database", self.folder / f"{name}.db",
                                          "--workers", "2", "--quiet"], cwd=self.folder, env=self.environment,
                                         stdout=subprocess.DEVNULL))
        self.processes += runs
        self.assertEqual([run.wait(120) for run in runs], [0, 0])
        for name in ("left", "right"):
            database = self.folder / f"{name}.db"
            self.assertEqual(self.rows(database, "SELECT sweep, count(*) FROM result GROUP BY sweep"), [(name, 192)])
            self.assertEqual(self.number(database, "SELECT count(*) FROM worker"), 2, "only its own workers")

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("unshare"), "needs to be root to make a network namespace")
    def test_run_needs_nothing_but_loopback(self):
        sweep = self.write("alone.yaml", grid("alone", "required_fuel: [25, 50, 75, 100]", cycles=20))
        for dds in ("cyclonedds", "fastdds"):
            database = self.folder / f"{dds}.db"
            script = f"ip link set lo up multicast off && exec {BIN}/lamprey run {sweep} --database {database} --dds {dds} --quiet"
            subprocess.run(["unshare", "--net", "sh", "-c", script], check=True, timeout=120, env=self.environment,
                           stdout=subprocess.DEVNULL)
            self.assertEqual(len(self.digests(database)), 4)
