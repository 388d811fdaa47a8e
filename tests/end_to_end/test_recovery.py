"""Whatever is killed or interrupted: nothing that was acknowledged is lost, and the sweep can always be ended."""
import signal
import subprocess
import time

from support import BIN, EVERY_OPERATOR, Programs, grid


class Recovery(Programs):
    def setUp(self):
        super().setUp()
        self.sweep = self.write("recovery.yaml", grid("recovery", EVERY_OPERATOR, cycles=2000, replicates=6))
        self.jobs = 1152
        self.database = self.folder / "recovery.db"

    def kill_coordinator_in_mid_sweep(self, dds):
        coordinator = self.start_coordinator(self.database, dds)
        workers = [self.start_worker(dds), self.start_worker(dds)]
        self.lamprey("submit", self.sweep, "--dds", dds, *self.join, "--timeout", 30)
        self.wait_until(lambda: self.jobs_stored(self.database) > 100, "a part of the sweep")
        coordinator.kill()
        coordinator.wait()
        stored = self.digests(self.database)
        self.assertLess(len(stored), self.jobs)
        time.sleep(1)
        self.assertTrue(all(worker.poll() is None for worker in workers), "workers outlive the coordinator")
        self.start_coordinator(self.database, dds)
        self.wait_for_end(self.database)
        rows = self.digests(self.database)
        self.assertEqual(len(rows), self.jobs)
        self.assertTrue(set(stored) <= set(rows), "nothing that was stored is lost")
        self.assertEqual(self.number(self.database, "SELECT count(*) FROM divergence"), 0)
        self.assertTrue(all(worker.poll() is None for worker in workers))
        self.assertEqual(self.number(self.database, "SELECT epoch FROM database"), 2)
        self.lamprey("verify", self.database)

    def test_killed_coordinator_on_cyclonedds(self):
        self.kill_coordinator_in_mid_sweep("cyclonedds")

    def test_killed_coordinator_on_fastdds(self):
        self.kill_coordinator_in_mid_sweep("fastdds")

    def test_workers_that_start_first(self):
        self.start_worker()
        time.sleep(1)
        self.start_coordinator(self.database)
        small = self.write("small.yaml", grid("small", "required_fuel: [25, 50]", cycles=10))
        self.lamprey("submit", small, "--wait", *self.join, "--timeout", 30)
        self.assertEqual(len(self.digests(self.database)), 2)

    def test_run_again_goes_on_where_it_was_interrupted(self):
        first = subprocess.Popen([BIN / "lamprey", "run", self.sweep, "--database", self.database, "--workers", "2"],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.processes.append(first)
        self.wait_until(lambda: self.jobs_stored(self.database) > 50, "a part of the sweep")
        self.assertEqual(self.interrupt_run(first), 130)
        stored = self.digests(self.database)
        self.assertLess(len(stored), self.jobs)
        summary = self.json("run", self.sweep, "--database", self.database, "--workers", 2, "--quiet")
        self.assertEqual(summary["counts"]["done"], self.jobs)
        self.assertTrue(set(stored) <= set(self.digests(self.database)))
        again = self.json("run", self.sweep, "--database", self.database, "--quiet")
        self.assertEqual(again["counts"], summary["counts"], "a finished sweep is simply shown")

    def interrupt_run(self, process):
        process.send_signal(signal.SIGINT)
        _, text = process.communicate(timeout=10)
        self.assertIn("again", text, "it says how to go on")
        return process.returncode


class Interruption(Programs):
    def test_ctrl_c_ends_every_program(self):
        database = self.folder / "ctrl-c.db"
        sweep = self.write("long.yaml", grid("long", "required_fuel: [25, 50, 75, 100]", cycles=10_000_000))
        coordinator = self.start_coordinator(database)
        worker = self.start_worker(threads=2)
        self.lamprey("submit", sweep, *self.join, "--timeout", 30)
        waiting = self.start("lamprey", "submit", sweep, "--wait", *self.join, "--timeout", 30)
        self.wait_until(lambda: self.json("status", *self.join)["sweeps"][0]["counts"]["leased"] > 0, "a lease")
        for process, code in ((waiting, 130), (worker, 0), (coordinator, 0)):
            self.assertEqual(self.interrupt(process), code, process.args[0].name + "\n" + self.log_of(process))
        self.assertEqual(self.number(database, "SELECT count(*) FROM event WHERE kind = 'coordinator_stopped'"), 1)
        self.assertEqual(self.number(database, "SELECT count(*) FROM event WHERE kind = 'worker_left'"), 1)

    def test_cancel_ends_a_sweep_and_its_work(self):
        database = self.folder / "cancel.db"
        sweep = self.write("long.yaml", grid("long", "required_fuel: [25, 50, 75, 100]", cycles=10_000_000))
        self.start_coordinator(database)
        self.start_worker()
        self.lamprey("submit", sweep, *self.join, "--timeout", 30)
        self.assertEqual(self.json("cancel", "long", *self.join)["cancelled"], 4)
        self.wait_for_end(database)
        self.assertEqual(self.rows(database, "SELECT state, count(*) FROM result GROUP BY state"), [("cancelled", 4)])
