"""Which networks programs use, who tells them of each other, and what they say of it."""
import signal
import subprocess
import time
import unittest

import hosts
from support import BIN, PATIENCE, grid
from test_many_machines import OnHosts

OBSTACLE = hosts.obstacle()
OPEN_DOOR = "there is no security"


class Networks(OnHosts):
    def on(self, host, *arguments, code=0):
        """Runs the client on the host to its end, and checks its exit code; what it has written."""
        result = subprocess.run(self.network.hosts[host].command(BIN / "lamprey", *arguments), cwd=self.folder,
                                env=self.environment, capture_output=True, text=True, timeout=PATIENCE)
        if code is not None:
            self.assertEqual(result.returncode, code, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result.stdout + result.stderr

    def run_sweep(self, *join):
        sweep = self.write("small.yaml", grid("small", "mutation: [all, one], required_fuel: [25, 50, 75, 100]",
                                              cycles=200, replicates=20))
        self.on("coordinator", "submit", sweep, "--wait", "--timeout", 60, *join)
        self.assertEqual(self.number(self.folder / "results.db", "SELECT count(*) FROM job WHERE state = 'done'"), 160)

    def workers_seen(self):
        return self.number(self.folder / "results.db", "SELECT count(*) FROM worker")


@unittest.skipIf(OBSTACLE, OBSTACLE)
class Interfaces(Networks):
    """Hosts with two networks, of which they have been told to use the one that nothing leads to by default."""

    def setUp(self):
        super().setUp()
        self.place(["coordinator", "alpha", "beta"])
        self.network.add_network("private", "coordinator", "alpha", "beta")

    def received(self, device):
        return {host: self.network.received_octets(host, device) for host in self.network.hosts}

    def use(self, coordinator_dds, *more):
        chosen = ["--interface", "private", *more]
        before = self.received("lan")
        self.start_on("coordinator", BIN / "lamprey-coordinator", "--database", self.folder / "results.db", "--dds",
                      coordinator_dds, *chosen)
        self.start_on("alpha", BIN / "lamprey-worker", "--threads", 1, "--dds", "cyclonedds", *chosen)
        self.start_on("beta", BIN / "lamprey-worker", "--threads", 1, "--dds", "fastdds", "--interface", "10.79.0.3",
                      *more)
        self.wait_until(lambda: self.workers_seen() == 2, "a meeting over the private network")
        self.run_sweep("--dds", coordinator_dds, *chosen)
        self.assertEqual(self.received("lan"), before, "nothing went over the other network")
        for host, octets in self.received("private").items():
            self.assertGreater(octets, 10_000, host)
        for process in self.processes:
            self.assertEqual(self.log_of(process).count(OPEN_DOOR), 1, self.log_of(process))
        # What this test looks at does tell.
        self.on("alpha", "net", "--seconds", 1, "--dds", "fastdds", code=None)
        self.assertNotEqual(self.received("lan"), before)

    def test_cyclone_and_whom_it_meets_by_multicast(self):
        self.use("cyclonedds")

    def test_fast_and_whom_it_meets_by_multicast(self):
        self.use("fastdds")

    def test_peers_of_the_chosen_network(self):
        self.use("fastdds", "--peer", "10.79.0.1")

    def test_a_bridge_says_whether_others_can_reach_it(self):
        for place, warnings in (["--interface", "private"], 1), (["--loopback-only"], 0):
            bridge = self.start_on("alpha", BIN / "lamprey-bridge", "--robot", "bench", "--driver", "mock", "--state",
                                   self.folder / f"state-{warnings}", *place)
            self.wait_until(lambda: "robot bench" in self.log_of(bridge), "the bridge's start")
            time.sleep(0.5)
            self.assertEqual(self.log_of(bridge).count(OPEN_DOOR), warnings, self.log_of(bridge))

    def test_doctor_tells_what_is_used(self):
        self.assertIn("interfaces: chosen: private (10.79.0.1)",
                      self.on("coordinator", "doctor", "--seconds", 0.1, "--interface", "private", code=None))
        self.assertIn("--interface NAME", self.on("coordinator", "doctor", "--seconds", 0.1, code=None))

    def test_an_interface_that_is_not_there_is_refused_by_every_program(self):
        for program in (["lamprey", "status"], ["lamprey-coordinator", "--database", self.folder / "none.db"],
                        ["lamprey-worker"]):
            for name, nearest in (("privat", "private"), ("10.79.0.2", "10.79.0.1")):
                result = subprocess.run(
                    self.network.hosts["coordinator"].command(BIN / program[0], *program[1:], "--interface", name),
                    env=self.environment, capture_output=True, text=True, timeout=PATIENCE)
                self.assertEqual(result.returncode, 2, result.stderr)
                for word in (f"'{name}'", f"did you mean '{nearest}'?", "lan (10.78.0.1), private (10.79.0.1)"):
                    self.assertIn(word, result.stdout + result.stderr)
        self.assertFalse((self.folder / "none.db").exists())


@unittest.skipIf(OBSTACLE, OBSTACLE)
class DiscoveryServer(Networks):
    """Two subnets, programs that know nothing but where the server is, and a server that is killed."""

    JOIN = ["--dds", "fastdds", "--discovery-server", "coordinator"]

    def setUp(self):
        super().setUp()
        self.place(["coordinator", "alpha"], ["beta"], multicast=False)

    def serve(self):
        server = self.start_on("coordinator", BIN / "lamprey-discovery-server")
        self.wait_until(lambda: "find each other" in self.log_of(server), "the server's start")
        return server

    def start_worker_on(self, host):
        return self.start_on(host, BIN / "lamprey-worker", "--threads", 1, *self.JOIN)

    def test_programs_find_each_other_and_again_after_it_was_killed(self):
        server = self.serve()
        self.start_on("coordinator", BIN / "lamprey-coordinator", "--database", self.folder / "results.db", *self.JOIN)
        self.start_worker_on("alpha")
        self.start_worker_on("beta")
        self.wait_until(lambda: self.workers_seen() == 2, "a meeting of three")
        server.send_signal(signal.SIGKILL)
        server.wait()
        time.sleep(1)
        self.serve()
        self.start_worker_on("beta")
        self.wait_until(lambda: self.workers_seen() == 3, "a meeting by the new server")
        self.run_sweep(*self.JOIN)

    def test_everybody_is_seen_by_who_looks(self):
        self.serve()
        self.start_on("coordinator", BIN / "lamprey-coordinator", "--database", self.folder / "results.db", *self.JOIN)
        self.start_worker_on("beta")
        self.wait_until(lambda: self.workers_seen() == 1, "a meeting of two")
        network = self.on("alpha", "net", *self.JOIN)
        for role in ("coordinator", "worker", "discovery-server"):
            self.assertIn(role, network)
        self.assertIn("discovery server: coordinator:11811 is there", self.on("alpha", "doctor", *self.JOIN))

    def test_doctor_names_a_server_that_is_not_there(self):
        self.assertIn("coordinator:11811 doesn't answer", self.on("alpha", "doctor", "--seconds", 1, *self.JOIN, code=5))

    def test_cyclone_refuses_it_by_name(self):
        self.assertIn("Cyclone DDS has no discovery server",
                      self.on("alpha", "status", "--discovery-server", "coordinator", code=2))


if __name__ == "__main__":
    unittest.main()
