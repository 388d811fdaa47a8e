"""The database answers plain SQL while the sweep runs, and verify finds what has been tampered with."""
import shutil
import sqlite3
import subprocess

from support import EVERY_OPERATOR, Programs, grid

MISMATCH = 5


class Database(Programs):
    def test_stock_sqlite3_answers_while_the_sweep_runs(self):
        database = self.folder / "live.db"
        sweep = self.write("live.yaml", grid("live", EVERY_OPERATOR, cycles=1500, replicates=4))
        self.start_coordinator(database)
        self.start_worker()
        self.start_worker()
        self.lamprey("submit", sweep, *self.join, "--timeout", 30)
        self.wait_until(lambda: self.jobs_stored(database) > 50, "some results")
        views = ["operators", *(f"figure_8_{i}" for i in range(3, 11)), "trace", "progress", "result"]
        for view in views:
            answer = subprocess.run(["sqlite3", "-readonly", database, f"SELECT count(*) FROM {view}"],
                                    capture_output=True, text=True, timeout=60, check=True)
            self.assertRegex(answer.stdout, r"^\d+\n$", view)
        self.assertEqual(self.number(database, "SELECT count(*) FROM sweep WHERE state = 'running'"), 1,
                         "it was running while it answered")
        self.wait_for_end(database)
        averages = self.rows(database, "SELECT steps, acceptance, jobs, expected_total, evolved_total, "
                                       "highest_total, success_rate FROM figure_8_3 WHERE sweep = 'live'")
        self.assertTrue(averages)
        for row in averages:
            self.assertTrue(all(value is not None for value in row), row)

    def test_verify_finds_a_flipped_byte_and_replay_recomputes(self):
        database = self.folder / "verify.db"
        sweep = self.write("verify.yaml", grid("verify", "acceptance: [simple, annealing], required_fuel: [25, 100]",
                                               cycles=200))
        self.lamprey("run", sweep, "--database", database, "--workers", 1, "--quiet")
        self.assertEqual(self.json("verify", database)["jobs"], 4)
        self.assertTrue(self.json("replay", "verify", 3, "--database", database)["same"])
        for change in ("evolved_fuel = evolved_fuel + 0.1", "successes = successes + 1", "seed = seed + 1",
                       "trace = replace(trace, '[[', '[[1')", "digest = zeroblob(32)"):
            spoiled = self.folder / "spoiled.db"
            shutil.copy(database, spoiled)
            connection = sqlite3.connect(spoiled)
            connection.execute(f"UPDATE job SET {change} WHERE job = 3")
            connection.commit()
            connection.close()
            answer = self.json("verify", spoiled, code=MISMATCH)
            self.assertEqual(answer["discrepancies"][0]["job"], 3, change)
        self.assertFalse(self.json("replay", "verify", 3, "--database", spoiled, code=MISMATCH)["same"])

    def test_results_from_the_file_and_from_the_coordinator_are_the_same(self):
        database = self.folder / "results.db"
        sweep = self.write("results.yaml", grid("results", "required_fuel: {from: 0, to: 100, step: 1}", cycles=5))
        self.start_coordinator(database)
        self.start_worker()
        self.lamprey("submit", sweep, "--wait", *self.join, "--timeout", 30)
        self.assertEqual(self.json("results", "results", "--database", database)["rows"],
                         self.json("results", "results", *self.join)["rows"])
        self.assertTrue(self.json("replay", "results", 100, *self.join)["same"])
