"""One round: a cluster, a schedule of faults, sweeps that go on all the while, and the judgement."""
import collections
import time
import traceback

from . import faults, judgement
from .cluster import ChaosFailed, Cluster
from .network import Network

PART = """name: part-{number}
seed: {seed}
base: {{cycles: 4000}}
grids:
  - {{mutation: [all, one], steps: [uniform, normal, one_fifth_rule], acceptance: [simple, annealing],
     equilibrium_disturbance: [50, 100], required_fuel: [25, 100]}}
replicates: {replicates}
"""
REPLICATES = 20
JOBS_OF_A_PART = 48 * REPLICATES
RESERVE = 8.0  # seconds of work that must be pending when a fault begins
FIRST_GUESS = 100.0  # jobs per second


class Round:
    """Its result, for the report, is in the public members."""

    def __init__(self, bin_folder, folder, plan, say):
        self.bin = bin_folder
        self.folder = folder
        self.plan = plan
        self.say = say
        self.struck = collections.Counter()  # faults by kind
        self.held_at_faults = collections.Counter()
        self.frames = collections.Counter()  # frames by weather
        self.parts = []
        self.jobs = 0
        self.computed_again = 0
        self.longest_stall = 0.0
        self.seconds = 0.0
        self._began = 0.0

    def run(self):
        """Raises ChaosFailed, after everything that is of use in finding out why has been said."""
        with open(self.folder / "relay.log", "w") as log:
            names = ["coordinator", *(f"worker-{number}" for number in range(len(self.plan.workers)))]
            network = Network(self.bin / "lamprey_chaos_relay", self.plan.seed, names, log)
            cluster = Cluster(self.bin, self.folder, network, self.plan)
            try:
                self._run(cluster)
            except Exception:
                self._say_what_is_known(cluster)
                raise
            finally:
                cluster.close()
                network.close()

    def _run(self, cluster):
        self._began = time.monotonic()
        cluster.start_coordinator()
        for place in range(len(cluster.places)):
            cluster.start_worker(place)
        cluster.wait_until(lambda: len(cluster.status()["workers"]) == len(cluster.places), "the workers' joining")
        cluster.feed = lambda: self._feed(cluster)
        for step in self.plan.steps:
            cluster.feed()
            self._take(cluster, step)
            cluster.check_that_all_live()
        cluster.wait_until(lambda: cluster.jobs_ended() == self.jobs, "the sweeps' end", 300)
        self.longest_stall = self._longest_stall(cluster)
        # By what workers told last; of one that was killed the last jobs may be missing.
        self.computed_again = max(0, cluster.computed_by_the_gone + cluster.computed() - self.jobs)
        self.seconds = time.monotonic() - self._began
        cluster.check_that_all_live()
        judgement.check(cluster, self.jobs)
        self._check_that_all_struck()
        disturbed = judgement.rows_of(cluster.database)
        for process in [cluster.coordinator, *cluster.workers]:
            process.kill()
        quiet = judgement.undisturbed(self.bin, self.folder, self.parts, 2)
        judgement.compare(disturbed, judgement.rows_of(quiet))

    def _feed(self, cluster):
        """So much work that the next fault doesn't outlast it, on a fast machine too."""
        while True:
            ended = cluster.jobs_ended() or 0
            rate = max(FIRST_GUESS, 1.3 * ended / (time.monotonic() - self._began))
            if self.jobs - ended >= RESERVE * rate:
                return
            file = self.folder / f"part-{len(self.parts)}.yaml"
            file.write_text(PART.format(number=len(self.parts), seed=self.plan.seed % 2**32 + len(self.parts),
                                        replicates=REPLICATES))
            cluster.lamprey("submit", file)
            self.parts.append(file)
            self.jobs += JOBS_OF_A_PART

    def _take(self, cluster, step):
        before, leased = faults.begin_weather(cluster, step)
        time.sleep(step.pause)
        held = faults.BY_NAME[step.fault](cluster, step)
        frames = faults.end_weather(cluster, step, before)
        self.struck[step.fault] += 1
        self.held_at_faults[step.fault] += held
        self.struck["packets_" + step.weather] += 1
        self.held_at_faults["packets_" + step.weather] += leased
        self.frames[step.weather] += frames
        self.say(f"  {step}: {frames} packets struck, {held} held, {cluster.jobs_ended()} of {self.jobs} jobs ended")

    def _check_that_all_struck(self):
        planned = collections.Counter()
        for step in self.plan.steps:
            planned[step.fault] += 1
            planned["packets_" + step.weather] += 1
        if planned != self.struck:
            raise ChaosFailed(f"planned were {planned}, and what struck was {self.struck}")

    @staticmethod
    def _longest_stall(cluster):
        """Seconds between one row and the next."""
        times = [row[0] for row in cluster.rows("SELECT DISTINCT ended FROM job ORDER BY ended")]
        return max((later - earlier for earlier, later in zip(times, times[1:])), default=0) / 1000

    def _say_what_is_known(self, cluster):
        self.say(traceback.format_exc())
        self.say(f"seed {self.plan.seed}, coordinator {self.plan.coordinator}, workers {', '.join(self.plan.workers)}, "
                 f"discovery by {self.plan.discovery}; the schedule:")
        for step in self.plan.steps:
            self.say(f"  {step}")
        for machine in cluster.network.machines.values():
            if (self.folder / f"{machine.name}.log").exists():
                self.say(f"--- log of {machine.name}\n{cluster.log_of(machine)[-6000:]}")
        try:
            self.say(f"--- the last events\n" + "\n".join(
                map(str, cluster.rows("SELECT * FROM event ORDER BY event DESC LIMIT 40"))))
        except Exception as error:  # the first failure is the one to report
            self.say(f"the database can't be read: {error}")
