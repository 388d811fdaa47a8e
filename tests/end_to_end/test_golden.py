"""Numbers that the thesis prints."""
from support import Programs, ROOT, grid


class Golden(Programs):
    def test_the_walk_is_80_60_83(self):
        answer = self.json("evaluate", "gait=walk")
        self.assertEqual((answer["stability"], answer["distance"], answer["fuel"], answer["total"]), (80, 60, 83, 223))

    def test_the_grids_have_the_thesis_number_of_jobs(self):
        for name, jobs in {"mutate-all": 18432, "mutate-one": 18432, "mutate-some": 4608,
                           "thesis-chapter-8": 41472}.items():
            self.assertEqual(self.json("plan", ROOT / "sweeps" / f"{name}.yaml")["jobs"], jobs, name)

    def test_mean_expected_total_is_139_375(self):
        levels = "[25, 50, 75, 100]"
        sweep = self.write("expected.yaml", grid("expected", f"required_stability: {levels}, "
                                                 f"required_distance: {levels}, required_fuel: {levels}", cycles=1))
        database = self.folder / "expected.db"
        self.lamprey("run", sweep, "--database", database, "--workers", 2, "--quiet")
        self.assertEqual(self.rows(database, "SELECT count(*), avg(expected_total) FROM result"), [(64, 139.375)])
