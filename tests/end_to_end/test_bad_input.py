"""Bad input gets one clear error, its exit code, and changes nothing."""
import sqlite3

from support import Programs, grid

USAGE, UNREACHABLE, STORAGE = 2, 3, 6


class BadInput(Programs):
    def refused(self, arguments, code, *words):
        before = {path: path.read_bytes() for path in self.folder.iterdir() if path.suffix in (".db", ".yaml", ".txt")}
        result = self.lamprey(*arguments, code=code)
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertNotIn("terminate", result.stderr)
        after = {path: path.read_bytes() for path in self.folder.iterdir() if path.suffix in (".db", ".yaml", ".txt")}
        self.assertEqual(before, after, "nothing is changed")
        return result.stderr

    def refused_sweep(self, text, *words):
        sweep = self.write("bad.yaml", text)
        for command in (["plan", sweep], ["run", sweep, "--database", self.folder / "new.db"],
                        ["submit", sweep, *self.join, "--timeout", 1]):
            self.refused(command, USAGE, "bad.yaml", *words)
        self.assertFalse((self.folder / "new.db").exists())

    def test_sweep_files(self):
        self.refused_sweep(grid("a", "required_fule: [25]"), ":5:6", "required_fule", "did you mean 'required_fuel'")
        self.refused_sweep(grid("a", "required_fuel: [25, 250]"), ":5:", "250", "0", "100")
        self.refused_sweep(grid("a", "required_fuel: []"), ":5:", "required_fuel", "no values")
        self.refused_sweep(grid("a", "steps: [unifrom]"), "did you mean 'uniform'", "normal")
        self.refused_sweep("name: a\nseed: 1\nname: b\n", ":3:1", "duplicate key 'name'", "line 1")
        self.refused_sweep(grid("a", "required_fuel: {from: 0, to: 100, step: 1}, required_stability: {from: 0, to: 100, "
                                "step: 1}, required_distance: {from: 0, to: 100, step: 1}", replicates=1000), "jobs")
        self.refused_sweep("name: [a\n", ":", "bad.yaml")

    def test_files_that_are_not_there(self):
        self.refused(["plan", "nothing.yaml"], USAGE, "nothing.yaml", "no such file")
        self.refused(["verify", "nothing.db"], STORAGE, "nothing.db")
        self.refused(["results", "a", "--database", "nothing.db"], STORAGE, "nothing.db")

    def test_configuration_files(self):
        configuration = self.write("site.yaml", "isolation: lab\npers: [a]\ndomain: 231\n")
        for command in (["status"], ["run", "none.yaml", "--database", self.folder / "new.db"]):
            self.refused([*command, "--config", configuration], USAGE, "site.yaml:2:1: ", "'pers'; did you mean 'peers'?",
                         "site.yaml:3:9: domain: ", "0 to 230")
        self.refused(["status", "--config", "nothing.yaml"], USAGE, "nothing.yaml", "no such file")
        for program in ("lamprey-coordinator", "lamprey-worker", "lamprey-bridge"):
            more = {"lamprey-coordinator": ["--database", self.folder / "new.db"],
                    "lamprey-bridge": ["--robot", "bench", "--driver", "mock"]}.get(program, [])
            process = self.start(program, *more, "--config", configuration, *self.join)
            self.assertEqual(process.wait(30), USAGE, program)
            self.assertIn("site.yaml:3:9: domain: ", self.log_of(process))
        self.assertFalse((self.folder / "new.db").exists())

    def test_parameters_on_the_command_line(self):
        self.refused(["evaluate", "gate=walk"], USAGE, "gate", "did you mean 'gait'")
        self.refused(["evaluate", "gait=wlak"], USAGE, "wlak", "did you mean 'walk'")
        self.refused(["evaluate", "required_fuel=101"], USAGE, "101", "100")
        self.refused(["evalute"], USAGE, "did you mean 'evaluate'")
        self.refused(["run"], USAGE, "FILE")
        self.refused(["status", "--dds", "opensplice"], USAGE, "opensplice", "cyclonedds", "fastdds")

    def test_databases_that_are_none(self):
        sweep = self.write("good.yaml", grid("good", "required_fuel: [25]", cycles=1))
        text = self.write("text.db", "this is not a database, but long enough to look at, and then some more of it\n" * 20)
        self.refused(["run", sweep, "--database", text], STORAGE, "text.db", "not a")
        self.refused(["verify", text], STORAGE, "text.db", "not a")
        foreign = self.folder / "foreign.db"
        connection = sqlite3.connect(foreign)
        connection.execute("CREATE TABLE recipe (name TEXT)")
        connection.commit()
        connection.close()
        self.refused(["run", sweep, "--database", foreign], STORAGE, "foreign.db")
        self.refused(["run", sweep, "--database", self.folder / "no" / "folder.db"], STORAGE, "folder.db")

    def test_database_of_a_newer_schema(self):
        sweep = self.write("good.yaml", grid("good", "required_fuel: [25]", cycles=1))
        database = self.folder / "newer.db"
        self.lamprey("run", sweep, "--database", database, "--workers", 1, "--quiet")
        connection = sqlite3.connect(database)
        version = connection.execute("PRAGMA user_version").fetchone()[0]
        connection.execute(f"PRAGMA user_version = {version + 1}")
        connection.execute("UPDATE schema_version SET version = version + 1")
        connection.commit()
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.close()
        self.refused(["run", sweep, "--database", database], STORAGE, "newer.db", str(version + 1))

    def test_database_that_another_coordinator_holds(self):
        database = self.folder / "held.db"
        sweep = self.write("good.yaml", grid("good", "required_fuel: [25]", cycles=1))
        self.start_coordinator(database)
        self.wait_until(lambda: self.number(database, "SELECT epoch FROM database") == 1, "the coordinator's start")
        result = self.lamprey("run", sweep, "--database", database, code=STORAGE)
        self.assertIn("held.db", result.stderr)
        self.assertIn("another coordinator", result.stderr)
        self.assertEqual(self.number(database, "SELECT epoch FROM database"), 1)

    def test_no_coordinator_within_the_time_limit(self):
        for dds in ("cyclonedds", "fastdds"):
            error = self.refused(["status", "--timeout", 1, "--dds", dds, *self.join], UNREACHABLE, "no coordinator", dds)
            self.assertEqual(len(error.strip().splitlines()), 1, error)

    def test_another_sweep_of_the_same_name(self):
        database = self.folder / "names.db"
        first = self.write("first.yaml", grid("same", "required_fuel: [25]", cycles=1))
        second = self.write("second.yaml", grid("same", "required_fuel: [50]", cycles=1))
        self.lamprey("run", first, "--database", database, "--workers", 1, "--quiet")
        rows = self.digests(database)
        result = self.lamprey("run", second, "--database", database, "--workers", 1, code=USAGE)
        self.assertIn("'same'", result.stderr)
        self.assertEqual(self.digests(database), rows)
