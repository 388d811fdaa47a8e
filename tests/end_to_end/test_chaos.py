"""A network of their own for a coordinator and workers, faults by a seeded schedule, and rows equal to those of an
undisturbed run: tests/end_to_end/chaos. `deploy/chaos` does it for as long as one likes."""
import os
import pathlib
import subprocess
import sys
import unittest

from chaos import sandbox


class Chaos(unittest.TestCase):
    def run_round(self, coordinator, seed):
        obstacle = sandbox.obstacle()
        if obstacle:
            self.skipTest(f"the chaos test was NOT run: {obstacle}")
        result = subprocess.run(
            [sys.executable, "-m", "chaos", "--seed", str(seed), "--coordinator", coordinator], check=False,
            cwd=pathlib.Path(__file__).parent, env=os.environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True)
        print(result.stdout, file=sys.stderr)
        self.assertEqual(result.returncode, 0, f"seed {seed}, coordinator on {coordinator}: see above")


class OnCyclone(Chaos):
    def test_every_row_is_that_of_an_undisturbed_run(self):
        self.run_round("cyclonedds", 1)


class OnFast(Chaos):
    def test_every_row_is_that_of_an_undisturbed_run(self):
        self.run_round("fastdds", 2)
