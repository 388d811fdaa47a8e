"""Machines that share nothing but a network, whose switch (relay.cpp) loses, delays, repeats and reorders frames."""
import json
import subprocess


class Machine:
    def __init__(self, name, number):
        self.name = name
        self.address = f"10.77.0.{number}"

    def command(self, *arguments):
        """The command line that runs these arguments on the machine."""
        return ["nsenter", f"--net=/run/netns/{self.name}", *map(str, arguments)]

    def ip(self, *arguments):
        return subprocess.run(["ip", "-n", self.name, *arguments], check=True, capture_output=True, text=True).stdout

    def link_is_up(self):
        return "UP" in json.loads(self.ip("-j", "link", "show", "lan0"))[0]["flags"]


class Network:
    def __init__(self, relay, seed, names, log):
        self.machines = {name: Machine(name, number) for number, name in enumerate(names, start=1)}
        for name in names:
            subprocess.run(["ip", "netns", "add", name], check=True)
        self._relay = subprocess.Popen([relay, str(seed), *names], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                       stderr=log, text=True)
        if self._relay.stdout.readline().strip() != "ready":
            raise RuntimeError("the relay did not start; see its log")
        for machine in self.machines.values():
            machine.ip("link", "set", "lo", "up")
            machine.ip("addr", "add", f"{machine.address}/24", "dev", "lan0")
            machine.ip("link", "set", "lan0", "up")

    def close(self):
        self._relay.stdin.close()
        self._relay.wait(10)
        self._relay.stdout.close()
        for name in self.machines:
            subprocess.run(["ip", "netns", "del", name], check=True)

    def _ask(self, line):
        self._relay.stdin.write(line + "\n")
        self._relay.stdin.flush()
        return self._relay.stdout.readline().strip()

    def _tell(self, line):
        answer = self._ask(line)
        if answer != "ok":
            raise RuntimeError(f"the relay answered '{answer}'")

    def counters(self):
        """How many frames were carried, cut, lost, duplicated, reordered, delayed since the start."""
        return json.loads(self._ask("counters"))

    def weather(self, loss=0.0, duplicate=0.0, reorder=0.0, delay=0.0, jitter=0.0):
        """For every link: shares of the frames, milliseconds."""
        for name in self.machines:
            self._tell(f"faults {name} {loss} {duplicate} {reorder} {delay} {jitter}")

    def cut(self, machine, direction):
        self._tell(f"cut {machine.name} {direction}")

    def heal(self, machine):
        self._tell(f"cut {machine.name} none")
