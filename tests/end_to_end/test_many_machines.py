"""Machines of the tests' own, with real programs of both vendors on them: what the guide says, and what cuts do."""
import json
import os
import re
import shlex
import signal
import stat
import subprocess
import time
import unittest

import hosts
from support import BIN, EVERY_OPERATOR, FULL, PATIENCE, Programs, ROOT, grid

OBSTACLE = hosts.obstacle()
CUTS = (5, 30) if FULL else (5,)  # seconds


class OnHosts(Programs):
    def place(self, *subnets, multicast=True):
        self.network = hosts.Hosts(*subnets, multicast=multicast)
        # Processes are killed before their network goes: what is added last is done first.
        self.addCleanup(self.network.close)
        self.addCleanup(self.kill_all)

    def start_on(self, host, *words, environment=None):
        log = open(self.folder / f"{len(self.processes)}-{host}.log", "w+")
        self.addCleanup(log.close)
        process = subprocess.Popen(self.network.hosts[host].command(*words), stdout=subprocess.DEVNULL, stderr=log,
                                   cwd=self.folder, env={**self.environment, **(environment or {})},
                                   start_new_session=True)
        process.log = log
        self.processes.append(process)
        return process

    def kill_all(self):
        for process in self.processes:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def wait_until(self, condition, what, patience=PATIENCE):
        deadline = time.monotonic() + patience
        while not condition():
            if time.monotonic() > deadline:
                self.fail(f"{what} did not happen within {patience} s\n" +
                          "\n".join(f"--- {process.log.name}\n{self.log_of(process)[-2000:]}" for process in self.processes))
            time.sleep(0.05)

    def jobs_by(self, database, process):
        """How many of the jobs that are stored that process has computed. `ip netns exec` becomes the program."""
        return self.number(database, "SELECT count(*) FROM job JOIN worker USING (worker) "
                                     f"WHERE worker.process = {process.pid}")


@unittest.skipIf(OBSTACLE, OBSTACLE)
class Cuts(OnHosts):
    """Three hosts, both vendors, a link that is cut in mid-sweep: not a bit changes."""

    def setUp(self):
        super().setUp()
        cycles, replicates = (4000, 40) if FULL else (2000, 4)  # one worker alone must not end it during a cut
        self.sweep = self.write("cut.yaml", grid("cut", EVERY_OPERATOR, cycles=cycles, replicates=replicates))
        database = self.folder / "undisturbed.db"
        self.lamprey("run", self.sweep, "--database", database, "--quiet", timeout=600)
        self.undisturbed = self.digests(database)

    def survive(self, seconds, coordinator_dds, peers):
        database = self.folder / f"cut-{coordinator_dds}-{seconds}.db"
        self.start_on("coordinator", BIN / "lamprey-coordinator", "--database", database, "--dds", coordinator_dds)
        alpha = self.start_on("alpha", BIN / "lamprey-worker", "--threads", 1, "--dds", "cyclonedds", *peers)
        beta = self.start_on("beta", BIN / "lamprey-worker", "--threads", 1, "--dds", "fastdds", *peers)
        command = self.network.hosts["coordinator"].command(BIN / "lamprey", "submit", self.sweep, "--dds",
                                                            coordinator_dds, "--timeout", 60)
        subprocess.run(command, check=True, env=self.environment, cwd=self.folder, stdout=subprocess.DEVNULL)
        for worker, host in ((alpha, "alpha"), (beta, "beta")):
            begun = self.jobs_by(database, worker)
            self.wait_until(lambda: self.jobs_by(database, worker) > begun, f"work of {host}'s")
            self.network.cut(host)
            time.sleep(1)  # what was on its way has arrived
            cut_at = self.jobs_by(database, worker)
            time.sleep(seconds - 1)
            self.assertEqual(self.jobs_by(database, worker), cut_at, "the link was cut")
            self.network.heal(host)
            healed = time.monotonic()
            self.assertLess(self.jobs_stored(database), len(self.undisturbed), "the cut was in mid-sweep")
            self.wait_until(lambda: self.jobs_by(database, worker) > cut_at, f"results of {host} after the cut")
            print(f"\n  {coordinator_dds}, {host} cut for {seconds} s: results {time.monotonic() - healed:.1f} s after healing",
                  end=" ", flush=True)
        self.wait_for_end(database, 600)
        self.assertEqual(self.digests(database), self.undisturbed)
        self.assertEqual(self.number(database, "SELECT count(*) FROM divergence"), 0)
        self.kill_all()

    def test_with_multicast(self):
        self.place(["coordinator", "alpha", "beta"])
        for seconds in CUTS:
            self.survive(seconds, "cyclonedds", [])

    def test_without_multicast_and_with_peers_named_by_the_workers_only(self):
        self.place(["coordinator", "alpha", "beta"], multicast=False)
        for seconds in CUTS:
            self.survive(seconds, "fastdds", ["--peer", "coordinator"])

    def test_across_a_router(self):
        self.place(["coordinator", "alpha"], ["beta"])
        for seconds in CUTS:
            self.survive(seconds, "cyclonedds", ["--peer", "coordinator"])


@unittest.skipIf(OBSTACLE, OBSTACLE)
class Guide(OnHosts):
    """docs/guides/many_machines.md, line by line, each on the host before its "$"."""

    def setUp(self):
        super().setUp()
        self.place(["coordinator", "alpha", "beta"])
        self.tools = self.folder / "tools"
        self.tools.mkdir()
        (self.folder / "sweeps").symlink_to(ROOT / "sweeps")
        self.install()
        self.write_tools()
        self.environment["PATH"] = f"{self.tools}:{self.prefix}/bin:{self.environment['PATH']}"
        self.environment["LAMPREY_ISOLATION"] = self.isolation
        self.environment["HOME"] = str(self.folder / "home")

    def install(self):
        self.prefix = self.folder / "opt"
        subprocess.run(["cmake", "--install", BIN.parent, "--prefix", self.prefix], check=True, stdout=subprocess.DEVNULL)

    def tool(self, name, script):
        path = self.tools / name
        path.write_text(f"#!/bin/bash\nset -euo pipefail\n{script}")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def write_tools(self):
        """What the machines of a laboratory have, and these don't: ssh to their hosts, a batch queue of two nodes."""
        enter = f"ip netns exec {self.network.prefix}-"
        self.tool("ssh", f'host=$1; shift; exec {enter}"$host" "$@"\n')
        self.tool("sbatch", 'export "${1#--export=ALL,}" SLURM_CPUS_PER_TASK=1; exec "$2"\n')
        self.tool("srun", f'shift; {enter}alpha "$@" & {enter}beta "$@" & wait\n')

    def lines(self, heading):
        text = (ROOT / "docs" / "guides" / "many_machines.md").read_text()
        section = text.split(f"## {heading}\n")[1].split("\n## ")[0]
        blocks = re.findall(r"```console\n(.*?)```", section, re.DOTALL)
        lines = re.findall(r"^(\w+)\$ (.+)$", "\n".join(blocks), re.MULTILINE)
        self.assertTrue(lines, heading)
        return lines

    def type_in(self, host, line):
        line = line.replace("/opt/lamprey", str(self.prefix))
        words = shlex.split(line)
        if words[0] in ("lamprey-coordinator", "lamprey-worker", "lamprey-discovery-server", "ssh", "sbatch"):
            self.start_on(host, *words)
            time.sleep(0.5)
            self.assertIsNone(self.processes[-1].poll(), f"{host}$ {line}\n{self.log_of(self.processes[-1])}")
            return ""
        result = subprocess.run(self.network.hosts[host].command("bash", "-c", line), cwd=self.folder,
                                env=self.environment, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 0, f"{host}$ {line}\n{result.stdout}\n{result.stderr}")
        return result.stdout

    def walk(self, heading):
        return [self.type_in(host, line) for host, line in self.lines(heading)]

    def wait_for_workers(self, count):
        def seen():
            command = self.network.hosts["coordinator"].command("lamprey", "workers", "--format", "json")
            result = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=PATIENCE)
            return result.returncode == 0 and len(json.loads(result.stdout)["workers"]) == count
        self.wait_until(seen, f"{count} workers")

    def test_by_hand_and_a_look_at_the_network(self):
        answers = self.walk("By hand")
        self.assertIn("quickstart", answers[4])
        network, health = self.walk("When they don't meet")
        for program in ("coordinator", "worker", "Cyclone DDS", "Fast DDS"):
            self.assertIn(program, network)
        self.assertNotIn("trouble", health)

    def test_chosen_networks(self):
        self.assertIn("database", self.walk("A machine with several networks")[-1])

    def test_what_a_site_always_says(self):
        for name in ("LAMPREY_CONFIG", "LAMPREY_ISOLATION"):
            del self.environment[name]
        self.assertIn("database", self.walk("What a site always says")[-1])

    def test_discovery_server(self):
        server, *others = self.lines("By a discovery server")
        self.type_in(*server)
        self.wait_until(lambda: "find each other" in self.log_of(self.processes[-1]), "the server's start")
        network, status = [self.type_in(*line) for line in others][-2:]
        for role in ("discovery-server", "coordinator", "worker"):
            self.assertIn(role, network)
        self.assertIn("database", status)

    def test_peers_ssh_and_a_batch_queue(self):
        self.type_in(*self.lines("By hand")[0])
        status = self.walk("Where there is no multicast")[-1]
        self.assertIn("database", status)
        self.walk("Over ssh")
        self.walk("On a Slurm cluster")
        self.wait_for_workers(4)

    def test_units_are_sound_and_start_the_programs(self):
        lines = [line for _, line in self.lines("As services")]
        self.assertTrue(any("lamprey-worker@4" in line for line in lines))
        folder = self.prefix / "lib" / "systemd" / "system"
        for line in lines:
            for unit in re.findall(r"/opt/lamprey(/lib/systemd/\S+)", line):
                self.assertTrue((self.prefix / unit[1:]).exists(), unit)
        for name, instance in (("lamprey-coordinator.service", ""), ("lamprey-worker@.service", "2"),
                               ("lamprey-bridge@.service", "bench"), ("lamprey-discovery-server.service", "")):
            with self.subTest(name):
                self.verify(folder / name, instance)
        command = self.command_of(folder / "lamprey-worker@.service", "2")
        self.start_on("alpha", *command)
        self.start_on("coordinator", *self.command_of(folder / "lamprey-coordinator.service", "")[:-1],
                      self.folder / "results.db")
        self.wait_for_workers(1)

    def verify(self, unit, instance):
        """With systemd's own checker, where it is installed."""
        if subprocess.run(["which", "systemd-analyze"], capture_output=True).returncode != 0:
            self.skipTest("systemd-analyze is not installed")
        copy = self.folder / unit.name.replace("@.", f"@{instance}.")
        copy.write_text(unit.read_text())
        result = subprocess.run(["systemd-analyze", "verify", "--man=no", copy], capture_output=True, text=True)
        complaints = [line for line in result.stderr.splitlines() if copy.name in line]
        self.assertEqual(complaints, [])

    def command_of(self, unit, instance):
        start = re.search(r"^ExecStart=(.+)$", unit.read_text(), re.MULTILINE).group(1)
        return shlex.split(start.replace("%i", instance))
