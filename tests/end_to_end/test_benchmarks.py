"""The benchmarks run; what they measure is for people to read."""
import json
import subprocess

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
