"""Workers, vendors and deaths change no bit: the same sweep gives the same digests, row for row."""
import os

from support import EVERY_OPERATOR, FULL, PATIENCE, Programs, ROOT, grid


class SameDigests(Programs):
    def setUp(self):
        super().setUp()
        if FULL:
            self.sweep, self.jobs = ROOT / "sweeps" / "thesis-chapter-8.yaml", 41472
        else:
            self.sweep, self.jobs = self.write("digests.yaml", grid("digests", EVERY_OPERATOR, cycles=500, replicates=2)), 384
        self.patience = 1200 if FULL else PATIENCE

    def run_it(self, name, *options):
        database = self.folder / f"{name}.db"
        summary = self.json("run", self.sweep, "--database", database, "--quiet", *options, timeout=self.patience)
        self.assertEqual(summary["counts"]["done"], self.jobs)
        rows = self.digests(database)
        self.assertEqual(len(rows), self.jobs, "none is missing")
        self.assertEqual(len({row[:2] for row in rows}), self.jobs, "none is doubled")
        self.assertEqual({row[2] for row in rows}, {"done"})
        self.assertEqual(self.number(database, "SELECT count(*) FROM job WHERE json_array_length(trace) != accepted"), 0)
        return rows

    def run_with_a_killed_worker(self):
        database = self.folder / "killed.db"
        self.start_coordinator(database)
        victim = self.start_worker()
        self.start_worker(dds="fastdds")
        self.lamprey("submit", self.sweep, *self.join, "--timeout", 30)
        self.wait_until(lambda: self.jobs_stored(database) > self.jobs // 2, "half of the sweep", self.patience)
        self.assertLess(self.jobs_stored(database), self.jobs, "the kill comes in mid-sweep")
        victim.kill()
        self.wait_for_end(database, self.patience)
        self.assertEqual(self.number(database, "SELECT count(*) FROM divergence"), 0)
        return self.digests(database)

    def test_any_workers_on_any_vendor(self):
        reference = self.run_it("one-worker", "--workers", 1)
        for name, options in {
            "two-workers": ["--workers", 2],
            "fastdds": ["--workers", 2, "--dds", "fastdds"],
            "mixed": ["--workers", 2, "--dds", "cyclonedds", "--worker-dds", "fastdds", "--worker-dds", "cyclonedds"],
            "mixed-the-other-way": ["--workers", 2, "--dds", "fastdds", "--worker-dds", "cyclonedds",
                                    "--worker-dds", "cyclonedds"],
        }.items():
            with self.subTest(name):
                self.assertEqual(self.run_it(name, *options), reference)
                os.remove(self.folder / f"{name}.db")

    def test_a_worker_killed_half_way(self):
        if not FULL:
            self.sweep, self.jobs = self.write("killed.yaml", grid("killed", EVERY_OPERATOR, cycles=2000, replicates=6)), 1152
        reference = self.run_it("quiet", "--workers", 2)
        self.assertEqual(self.run_with_a_killed_worker(), reference)

    def test_a_cell_is_the_same_job_in_two_sweeps(self):
        axes = "required_stability: [25, 50, 75, 100], required_distance: [25, 100]"
        one = self.write("one.yaml", grid("one", axes, cycles=50))
        other = self.write("other.yaml", grid("other", "required_distance: [100, 25], mutation_size: [25, 50], "
                                              "required_stability: [50, 100, 75, 25]", cycles=50))
        database = self.folder / "both.db"
        for sweep in (one, other):
            self.lamprey("run", sweep, "--database", database, "--workers", 1, "--quiet")
        pairs = self.rows(database, "SELECT a.digest = b.digest FROM job a JOIN job b "
                                    "ON a.identity = b.identity AND a.sweep < b.sweep")
        self.assertEqual(pairs, [(1,)] * 8)
