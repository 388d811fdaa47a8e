"""Namespaces of the kernel's that end with the driver: whatever happens to it, no process, mount or network stays."""
import os
import subprocess
import sys

NOT_PERMITTED = 77  # exit code: the machine does not allow what the test needs
_INSIDE = "LAMPREY_CHAOS_INSIDE"


def obstacle():
    """Why this machine can't run the chaos test, or None."""
    if os.geteuid() != 0:
        return "network namespaces and mounts need root"
    if not os.access("/dev/net/tun", os.R_OK | os.W_OK):
        return "/dev/net/tun, for the network devices, is missing or not permitted"
    attempt = subprocess.run(
        ["unshare", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc", "sh", "-c",
         "mkdir -p /run/netns && mount -t tmpfs none /run/netns && ip netns add trial && "
         "ip netns exec trial ip tuntap add trial0 mode tap"], capture_output=True, text=True, check=False)
    if attempt.returncode != 0:
        return "namespaces, mounts or TAP devices are not permitted here: " + attempt.stderr.strip()
    return None


def enter(arguments):
    """Runs this program again as the first process of its own process and mount namespaces, and returns its exit code;
    returns None where that has been done. When the first process ends, the kernel ends all others with it."""
    if os.environ.get(_INSIDE):
        return None
    why_not = obstacle()
    if why_not:
        print(f"chaos: not run: {why_not}", file=sys.stderr)
        return NOT_PERMITTED
    command = ["unshare", "--mount", "--propagation", "private", "--pid", "--fork", "--kill-child", "--mount-proc",
               sys.executable, "-m", "chaos", *arguments]
    # If this process is killed, so is unshare, and with it everything inside.
    return subprocess.run(["setpriv", "--pdeathsig", "KILL", *command], env={**os.environ, _INSIDE: "1"},
                          check=False).returncode


def prepare():
    """Inside: network namespaces get names that nobody else sees."""
    os.makedirs("/run/netns", exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "none", "/run/netns"], check=True)
