"""Every ready sweep runs to its end, and the report on all of them has a verdict for each of the thesis's claims."""
import json
import re

from support import FULL, Programs, ROOT

# Of thesis-chapter-8, for a first look, or not of the thesis and in need of a robot (test_robot.py).
PARTS = {"quickstart", "mutate-all", "mutate-one", "mutate-some", "robot"}
MOST_CYCLES = 200
MOST_REPLICATES = 2


def reduced(text):
    """The same experiment, smaller: fewer cycles and replicates, the ends of long axes only."""
    if "environment:" not in text:  # its changes come at cycles of their own
        text = re.sub(r"cycles: (\d+)", lambda found: f"cycles: {min(int(found[1]), MOST_CYCLES)}", text)
    text = re.sub(r"replicates: (\d+)", lambda found: f"replicates: {min(int(found[1]), MOST_REPLICATES)}", text)
    return re.sub(r"(equilibrium_disturbance|mutation_size|system_disturbance|required_\w+): \[25, 50, 75, 100\]",
                  r"\1: [25, 100]", text).replace("values: [25, 50, 75, 100]", "values: [25, 100]")


class Findings(Programs):
    def test_all_sweeps_run_and_each_claim_has_a_verdict(self):
        database = self.folder / "findings.db"
        sweeps = [path for path in sorted((ROOT / "sweeps").glob("*.yaml")) if path.stem not in PARTS]
        for path in sweeps:
            with self.subTest(path.stem):
                text = path.read_text()
                summary = self.json("run", self.write(path.name, text if FULL else reduced(text)), "--database", database,
                                    "--workers", 2, "--quiet", timeout=1800)
                self.assertGreater(summary["counts"]["done"], 0)
                self.assertEqual(summary["counts"]["done"], summary["counts"]["jobs"], "none failed")
        self.lamprey("verify", database, timeout=1800)

        report = self.lamprey("report", database, timeout=600).stdout
        findings = json.loads(self.lamprey("report", database, "--format", "json", timeout=600).stdout)
        self.assertEqual([claim["number"] for claim in findings["claims"]], list(range(1, 12)))
        for claim in findings["claims"]:
            with self.subTest(claim["statement"]):
                self.assertIn(claim["statement"][:40], re.sub(r"\s+", " ", report))
                self.assertTrue(claim["assessments"], "what it rests on was run")
                for assessment in claim["assessments"]:
                    for verdict in assessment["verdicts"].values():
                        self.assertIn(verdict, {"holds", "does not hold"}, assessment["reading"])
        self.lamprey("report", database, "--format", "html", "--output", self.folder / "findings.html", timeout=600)
        page = (self.folder / "findings.html").read_text()
        self.assertIn("<svg", page)
        self.assertNotIn("http://", re.sub(r'xmlns(:\w+)?="[^"]*"', "", page), "self-contained")
