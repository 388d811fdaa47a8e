"""The chaos test's command line: see deploy/chaos."""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile
import time

from . import sandbox
from .report import Report
from .round import Round
from .schedule import make_plan

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent.parent


def parse(arguments):
    parser = argparse.ArgumentParser(prog="chaos", description="Rounds of faults, over real DDS, as root.")
    parser.add_argument("--seed", type=int, default=1, help="of the first round; each further one takes the next")
    parser.add_argument("--minutes", type=float, help="starts rounds until so many minutes have passed (else: one)")
    parser.add_argument("--laps", type=int, default=1, help="how often each kind of fault strikes in a round")
    parser.add_argument("--coordinator", choices=("cyclonedds", "fastdds"),
                        help="its DDS implementation (else: both, in turn)")
    parser.add_argument("--report", type=pathlib.Path, help="file that gets the report, brought up to date by each round")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    inside = sandbox.enter(arguments)
    if inside is not None:
        return inside
    sandbox.prepare()
    bin_folder = pathlib.Path(os.environ.get("LAMPREY_BIN", ROOT / "build" / "release" / "bin"))
    report = Report(options.seed)
    start = time.monotonic()
    number = 0
    while number == 0 or (options.minutes and time.monotonic() - start < options.minutes * 60):
        vendor = options.coordinator or ("cyclonedds", "fastdds")[number % 2]
        plan = make_plan(options.seed + number, vendor, options.laps)
        print(f"round {number + 1}: seed {plan.seed}, coordinator {vendor}, workers {', '.join(plan.workers)}, "
              f"discovery by {plan.discovery}", flush=True)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="lamprey-chaos-"))
        chaos = Round(bin_folder, folder, plan, lambda text: print(text, flush=True))
        try:
            chaos.run()
            report.add(chaos, None)
        except Exception as error:  # whatever it is, the report has to say it
            report.add(chaos, f"{type(error).__name__}: {error}")
        finally:
            shutil.rmtree(folder, ignore_errors=True)
        print(report.last_round(), flush=True)
        if options.report:
            report.write(options.report)
        number += 1
    print(report.text(), flush=True)
    return 1 if report.failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
