"""What the rounds have shown, as text for people."""
import collections


class Report:
    def __init__(self, seed):
        self.seed = seed
        self.failures = []
        self._rounds = []

    def add(self, chaos, failure):
        self._rounds.append((chaos, failure))
        if failure:
            self.failures.append((chaos.plan.seed, failure))

    def last_round(self):
        chaos, failure = self._rounds[-1]
        verdict = f"FAILED: {failure}" if failure else "every row equal to the undisturbed run's, verified"
        return (f"round {len(self._rounds)} (seed {chaos.plan.seed}): {sum(chaos.struck.values())} faults, "
                f"{chaos.jobs} jobs, {chaos.computed_again} computed again, longest stall {chaos.longest_stall:.1f} s, "
                f"{chaos.seconds:.0f} s; {verdict}")

    def text(self):
        total = collections.Counter()
        held = collections.Counter()
        frames = collections.Counter()
        for chaos, _ in self._rounds:
            total += chaos.struck
            held += chaos.held_at_faults
            frames += chaos.frames
        rounds = [chaos for chaos, _ in self._rounds]
        lines = [
            f"rounds           {len(rounds)} (seeds {self.seed} to {self.seed + len(rounds) - 1}), "
            f"{len(self.failures)} failed",
            f"time             {sum(chaos.seconds for chaos in rounds) / 60:.1f} minutes with faults",
            f"jobs             {sum(chaos.jobs for chaos in rounds):,}; "
            f"{sum(chaos.computed_again for chaos in rounds):,} computed again",
            f"longest stall    {max((chaos.longest_stall for chaos in rounds), default=0):.1f} s between two rows",
            "",
            "fault               struck  held then (leases of the worker, or leased jobs; mean)",
        ]
        for kind in sorted(total):
            lines.append(f"{kind:20}{total[kind]:6}  {held[kind] / total[kind]:.0f}")
        lines += ["", "packets " + ", ".join(f"{frames[kind]:,} {kind}" for kind in sorted(frames))]
        for seed, failure in self.failures:
            lines += ["", f"FAILED with seed {seed}: {failure}"]
        return "\n".join(lines) + "\n"

    def write(self, path):
        path.write_text(self.text())
