"""Each kind of fault: done to the cluster, and shown to have struck while leases were held."""
import errno
import os
import signal
import sqlite3
import time

from .cluster import ChaosFailed

# What each weather does to every link at full strength, and which of the relay's counters shows it.
WEATHER = {
    "lost": ({"loss": 0.15}, "lost"),
    "delayed": ({"delay": 60, "jitter": 60}, "delayed"),
    "duplicated": ({"duplicate": 0.4}, "duplicated"),
    "reordered": ({"reorder": 0.3}, "reordered"),
}


def held(cluster, place=None):
    """Waits until jobs are leased (to that worker), whatever new sweeps that takes; returns how many jobs (or, of a
    worker, how many leases)."""
    seen = 0

    def some():
        nonlocal seen
        seen = cluster.leased(place)
        if seen == 0:
            cluster.feed()
        return seen > 0

    cluster.wait_until(some, "a lease" if place is None else f"a lease of worker-{place}")
    return seen


def require(holds, what):
    if not holds:
        raise ChaosFailed(f"a fault did not strike: {what}")


def begin_weather(cluster, step):
    """Returns what `end_weather` needs."""
    values, _ = WEATHER[step.weather]
    leased = held(cluster)
    before = cluster.network.counters()
    cluster.network.weather(**{name: value * step.strength for name, value in values.items()})
    return before, leased


def end_weather(cluster, step, before):
    """Returns how many frames it has struck."""
    cluster.network.weather()
    _, counter = WEATHER[step.weather]
    struck = cluster.network.counters()[counter] - before[counter]
    require(struck > 0, f"no packet was {step.weather}")
    return struck


def worker_killed(cluster, step):
    leases = held(cluster, step.worker)
    cluster.computed_by_the_gone += cluster.computed(step.worker)
    cluster.workers[step.worker].kill()
    require(cluster.workers[step.worker].wait() == -signal.SIGKILL, "the worker was not killed")
    time.sleep(step.replacement)
    cluster.start_worker(step.worker)
    return leases


def worker_stopped(cluster, step):
    leases = held(cluster, step.worker)
    process = cluster.workers[step.worker]
    process.send_signal(signal.SIGSTOP)
    stopped, status = os.waitpid(process.pid, os.WUNTRACED)
    require(stopped == process.pid and os.WIFSTOPPED(status), "the worker was not stopped")
    time.sleep(step.seconds)
    process.send_signal(signal.SIGCONT)
    return leases


def coordinator_killed(cluster, step):
    leased = held(cluster)
    cluster.coordinator.kill()
    require(cluster.coordinator.wait() == -signal.SIGKILL, "the coordinator was not killed")
    time.sleep(step.replacement)
    cluster.start_coordinator()
    return leased


def _cut(cluster, step, machine):
    before = cluster.network.counters()["cut"]
    cluster.network.cut(machine, step.direction)
    time.sleep(step.seconds)
    cluster.network.heal(machine)
    require(cluster.network.counters()["cut"] > before, f"no packet of {machine.name} was cut off")


def worker_cut(cluster, step):
    leases = held(cluster, step.worker)
    _cut(cluster, step, cluster.places[step.worker])
    return leases


def coordinator_cut(cluster, step):
    leased = held(cluster)
    _cut(cluster, step, cluster.home)
    return leased


def worker_unplugged(cluster, step):
    """The worker's own kernel knows that the link is down: addresses can't be sent to."""
    machine = cluster.places[step.worker]
    leases = held(cluster, step.worker)
    machine.ip("link", "set", "lan0", "down")
    require(not machine.link_is_up(), "the link is still up")
    time.sleep(step.seconds)
    machine.ip("link", "set", "lan0", "up")
    return leases


def _storage_waits(cluster, log_before, what):
    """The coordinator says so, and says nothing else about it: it has not ended."""
    cluster.wait_until(lambda: "; waiting" in cluster.log_of(cluster.home)[log_before:], f"waiting for {what}")
    require(cluster.coordinator.poll() is None, "the coordinator has ended")


def _storage_goes_on(cluster, log_before):
    cluster.wait_until(lambda: ": going on" in cluster.log_of(cluster.home)[log_before:], "going on")


def _fill(path):
    """Takes what is left of its disk, to the last page, since the coordinator goes on writing meanwhile."""
    with open(path, "wb", buffering=0) as file:
        size = 0
        for step in (8 << 20, 1 << 20, os.fstatvfs(file.fileno()).f_bsize):
            try:
                while True:
                    os.posix_fallocate(file.fileno(), size, step)
                    size += step
            except OSError as error:
                if error.errno != errno.ENOSPC:
                    raise
    free = os.statvfs(path.parent).f_bavail
    require(free < 16, f"{free} pages of the disk are still free")


def disk_full(cluster, step):
    log_before = len(cluster.log_of(cluster.home))
    leased = held(cluster)
    # The write-ahead log has room of its own, in which the coordinator could go on for long.
    other = sqlite3.connect(cluster.database, timeout=30)
    other.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchall()
    other.close()
    filler = cluster.disk / "filler"
    _fill(filler)
    try:
        _storage_waits(cluster, log_before, "a full disk")
        stored = cluster.jobs_ended()
        time.sleep(step.seconds)
        require(cluster.coordinator.poll() is None, "the coordinator outlives a full disk")
        require(cluster.jobs_ended() == stored, "rows were stored although the disk was full")
    finally:
        filler.unlink()
    _storage_goes_on(cluster, log_before)
    return leased


def database_locked(cluster, step):
    log_before = len(cluster.log_of(cluster.home))
    leased = held(cluster)
    writer = sqlite3.connect(cluster.database, timeout=30, isolation_level=None)
    try:
        writer.execute("BEGIN IMMEDIATE")
        _storage_waits(cluster, log_before, "another writer")
        time.sleep(step.seconds)
        writer.execute("ROLLBACK")
    finally:
        writer.close()
    _storage_goes_on(cluster, log_before)
    return leased


BY_NAME = {function.__name__: function for function in (
    worker_killed, worker_stopped, coordinator_killed, worker_cut, coordinator_cut, worker_unplugged, disk_full,
    database_locked)}
