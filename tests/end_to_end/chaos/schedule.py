"""What will go wrong, and when: a pure function of the seed."""
import dataclasses
import random

FAULTS = ("worker_killed", "worker_stopped", "coordinator_killed", "worker_cut", "coordinator_cut", "worker_unplugged",
          "disk_full", "database_locked")
WEATHERS = ("lost", "delayed", "duplicated", "reordered")
LEASE = 5.0  # seconds: after so long a silence a worker's leases are lost


@dataclasses.dataclass(frozen=True)
class Step:
    """One fault, in one kind of network weather that starts before it and ends after it."""
    fault: str
    worker: int       # which one, where it is about one
    seconds: float    # how long it lasts
    pause: float      # seconds of weather before it
    direction: str    # of a cut
    replacement: float  # seconds until what was killed is started again
    weather: str
    strength: float   # of the weather, from 0 to 1

    def __str__(self):
        details = {
            "worker_killed": f"worker-{self.worker}, replaced after {self.replacement:.1f} s",
            "coordinator_killed": f"restarted after {self.replacement:.1f} s",
            "worker_stopped": f"worker-{self.worker} for {self.seconds:.1f} s",
            "worker_cut": f"worker-{self.worker} ({self.direction}) for {self.seconds:.1f} s",
            "worker_unplugged": f"worker-{self.worker} for {self.seconds:.1f} s",
            "coordinator_cut": f"{self.direction} for {self.seconds:.1f} s",
        }.get(self.fault, f"for {self.seconds:.1f} s")
        return f"{self.fault} {details}; packets {self.weather} ({self.strength:.2f}) from {self.pause:.1f} s before"


@dataclasses.dataclass(frozen=True)
class Plan:
    seed: int
    coordinator: str       # DDS implementation
    workers: tuple         # theirs
    discovery: str         # multicast, or peers: by the coordinator's address
    steps: tuple


def other(dds):
    return "fastdds" if dds == "cyclonedds" else "cyclonedds"


def _duration(fault, draw):
    if fault == "worker_stopped" or ("cut" in fault and draw.random() < 0.3):
        return LEASE + draw.uniform(1.0, 2.5)
    return draw.uniform(1.0, 3.0)


def make_plan(seed, coordinator, laps):
    """Every lap has each fault once, in an order of its own, and each weather at least once."""
    draw = random.Random(seed)
    steps = []
    for _ in range(laps):
        faults = draw.sample(FAULTS, len(FAULTS))
        weathers = [*WEATHERS, *(draw.choice(WEATHERS) for _ in range(len(FAULTS) - len(WEATHERS)))]
        draw.shuffle(weathers)
        for fault, weather in zip(faults, weathers):
            steps.append(Step(
                fault=fault, worker=draw.randrange(3), seconds=_duration(fault, draw),
                pause=draw.uniform(0.5, 1.5), direction=draw.choice(("in", "out", "both")),
                replacement=draw.uniform(0.0, 3.0), weather=weather, strength=draw.uniform(0.2, 1.0)))
    return Plan(seed, coordinator, (coordinator, other(coordinator), draw.choice((coordinator, other(coordinator)))),
                draw.choice(("multicast", "peers")), tuple(steps))
