"""Machines of a test's own: network namespaces that are joined by switches and routers, with names that resolve."""
import json
import os
import pathlib
import secrets
import shutil
import subprocess


def obstacle():
    """Why this machine can't have them, or None."""
    if os.geteuid() != 0:
        return "network namespaces need root"
    name = f"lm-{secrets.token_hex(4)}"
    attempt = subprocess.run(["ip", "netns", "add", name], capture_output=True, text=True, check=False)
    if attempt.returncode != 0:
        return "network namespaces are not permitted here: " + attempt.stderr.strip()
    subprocess.run(["ip", "netns", "del", name], check=True)
    return None


def ip(namespace, *arguments):
    return subprocess.run(["ip", "-n", namespace, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


class Host:
    def __init__(self, network, name, subnet, number):
        self.name, self.subnet, self.address = name, subnet, f"10.78.{subnet}.{number}"
        self.namespace = f"{network.prefix}-{name}"
        self.port = f"to-{name}"  # of the switch

    def command(self, *arguments):
        """The command line that runs these arguments on the host; there the hosts' names resolve."""
        return ["ip", "netns", "exec", self.namespace, *map(str, arguments)]


class Hosts:
    """One switch for each subnet, and where there are several a router between them.

    `subnets`: the names of each subnet's hosts.
    """

    def __init__(self, *subnets, multicast=True):
        self.prefix = f"lm-{secrets.token_hex(4)}"
        self.router = f"{self.prefix}-router"
        self.hosts = {}
        self._namespaces = []
        for subnet, names in enumerate(subnets):
            self._add_switch(subnet, len(subnets) > 1)
            for number, name in enumerate(names, start=1):
                self._add_host(Host(self, name, subnet, number), multicast, len(subnets) > 1)
        self._write_names()

    def _add_namespace(self, name):
        subprocess.run(["ip", "netns", "add", name], check=True)
        self._namespaces.append(name)
        ip(name, "link", "set", "lo", "up")

    def _switch(self, subnet):
        return f"{self.prefix}-switch{subnet}"

    def _plug_in(self, namespace, device, subnet, port):
        """A cable from the device to a port of the subnet's switch."""
        ip(namespace, "link", "add", device, "type", "veth", "peer", "name", port, "netns", self._switch(subnet))
        ip(self._switch(subnet), "link", "set", port, "master", "switch", "up")
        ip(namespace, "link", "set", device, "up")

    def _add_switch(self, subnet, routed):
        self._add_namespace(self._switch(subnet))
        # Without spanning tree a port carries frames at once; without snooping groups need no querier.
        ip(self._switch(subnet), "link", "add", "switch", "type", "bridge", "forward_delay", 0, "mcast_snooping", 0)
        ip(self._switch(subnet), "link", "set", "switch", "up")
        if not routed:
            return
        if self.router not in self._namespaces:
            self._add_namespace(self.router)
            subprocess.run(["ip", "netns", "exec", self.router, "sysctl", "-qw", "net.ipv4.ip_forward=1"], check=True)
        self._plug_in(self.router, f"lan{subnet}", subnet, "to-router")
        ip(self.router, "addr", "add", f"10.78.{subnet}.254/24", "dev", f"lan{subnet}")

    def _add_host(self, host, multicast, routed):
        self.hosts[host.name] = host
        self._add_namespace(host.namespace)
        self._plug_in(host.namespace, "lan", host.subnet, host.port)
        ip(host.namespace, "addr", "add", f"{host.address}/24", "dev", "lan")
        if not multicast:
            ip(host.namespace, "link", "set", "lan", "multicast", "off")
        if routed:
            ip(host.namespace, "route", "add", "default", "via", f"10.78.{host.subnet}.254")
        elif multicast:
            ip(host.namespace, "route", "add", "224.0.0.0/4", "dev", "lan")

    def add_network(self, device, *names):
        """A second network between these hosts, each at it with a device of that name, at 10.79.0.1 and so on. Nobody
        speaks IPv6 any more: what comes over a network was sent by a program."""
        subnet = 79
        self._add_switch(subnet, False)
        for number, name in enumerate(names, start=1):
            host = self.hosts[name]
            self._plug_in(host.namespace, device, subnet, host.port)
            ip(host.namespace, "addr", "add", f"10.79.0.{number}/24", "dev", device)
        for namespace in self._namespaces:
            subprocess.run(["ip", "netns", "exec", namespace, "sysctl", "-qw", "net.ipv6.conf.all.disable_ipv6=1"],
                           check=True)

    def _write_names(self):
        """What `ip netns exec` puts in the place of /etc/hosts."""
        names = "127.0.0.1 localhost\n" + "".join(f"{host.address} {host.name}\n" for host in self.hosts.values())
        for host in self.hosts.values():
            folder = pathlib.Path("/etc/netns") / host.namespace
            folder.mkdir(parents=True)
            (folder / "hosts").write_text(names)

    def close(self):
        for namespace in reversed(self._namespaces):
            subprocess.run(["ip", "netns", "del", namespace], check=False)
            shutil.rmtree(pathlib.Path("/etc/netns") / namespace, ignore_errors=True)

    def cut(self, name):
        """The switch carries nothing from or to the host any more; at the host nothing tells of it."""
        host = self.hosts[name]
        ip(self._switch(host.subnet), "link", "set", host.port, "nomaster")

    def heal(self, name):
        host = self.hosts[name]
        ip(self._switch(host.subnet), "link", "set", host.port, "master", "switch")

    def received_octets(self, name, device="lan"):
        """By the host's network device so far."""
        link = json.loads(ip(self.hosts[name].namespace, "-j", "-s", "link", "show", device))[0]
        return link["stats64"]["rx"]["bytes"]
