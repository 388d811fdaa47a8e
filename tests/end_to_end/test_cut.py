"""The messaging port over a link that is cut under streams of samples, between two machines, for each pair of vendors.
Shorter than the lease of a participant (messaging/tuning.hpp) a cut costs nothing; a longer one what nobody promised."""
import os
import pathlib
import secrets
import signal
import shutil
import subprocess
import tempfile
import time
import unittest

import hosts
from support import BIN, FULL, PATIENCE

OBSTACLE = hosts.obstacle()
PAIRS = [(writer, reader) for writer in ("cyclonedds", "fastdds") for reader in ("cyclonedds", "fastdds")]
LEASES_KEPT = 512  # by their writer, for late readers: messaging/qos.hpp


class Stream:
    """Numbers from one machine to the other: a writer and a reader of a topic, processes of their own."""

    def __init__(self, test, topic, vendors, milliseconds):
        self.name = f"{topic} from {vendors[0]} to {vendors[1]}"
        isolation = "cut-" + secrets.token_hex(8)
        self.said = test.folder / f"{self.name}.said"
        log = test.folder / f"{self.name}.log"
        test.start("readers", vendors[1], isolation, topic, "read", output=self.said, log=log)
        test.start("writers", vendors[0], isolation, topic, "write", 1, 10**9, milliseconds,
                   output=subprocess.DEVNULL, log=log)

    def numbers(self):
        # The last line may not have ended yet.
        return [int(number) for number in self.said.read_text().split("\n")[:-1]]

    def last(self):
        return max(self.numbers(), default=0)


@unittest.skipIf(OBSTACLE, OBSTACLE)
class Cut(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="lamprey-cut-"))
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.network = hosts.Hosts(["writers", "readers"])
        self.addCleanup(self.network.close)
        self.processes = []
        self.addCleanup(self.kill_all)

    def start(self, host, vendor, isolation, topic, *action, output, log):
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("LAMPREY_", "CYCLONEDDS_", "FASTRTPS_", "ROS_"))}
        with open(log, "a") as errors:
            words = [BIN / "lamprey_conformance_program", vendor, 7, isolation, "multicast", topic, 0, *action]
            if output != subprocess.DEVNULL:
                output = open(output, "w")
                self.addCleanup(output.close)
            self.processes.append(subprocess.Popen(self.network.hosts[host].command(*words), stdout=output,
                                                   stderr=errors, env=environment, start_new_session=True))

    def kill_all(self):
        for process in self.processes:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def wait_until_beyond(self, streams, numbers):
        """Until each stream's reader has said a number as high as that."""
        deadline = time.monotonic() + PATIENCE
        for stream, number in zip(streams, numbers):
            while stream.last() < number:
                if time.monotonic() > deadline:
                    logs = "\n".join(f"--- {log.name}\n{log.read_text()[-1000:]}" for log in self.folder.glob("*.log"))
                    self.fail(f"{stream.name}: nothing after {stream.last()}\n{logs}")
                time.sleep(0.2)

    def cut(self, seconds, milliseconds):
        """Streams that have been through it, results and leases: a sample each so many milliseconds."""
        results = [Stream(self, "result", pair, 2) for pair in PAIRS]
        leases = [Stream(self, "lease", pair, milliseconds) for pair in PAIRS]
        streams = results + leases
        self.wait_until_beyond(streams, [1] * len(streams))
        time.sleep(1)
        self.network.cut("readers")
        time.sleep(0.5)  # what was on its way has arrived
        cut_at = [stream.last() for stream in streams]
        time.sleep(seconds)
        self.assertEqual([stream.last() for stream in streams], cut_at, "the link was not cut")
        self.network.heal("readers")
        self.wait_until_beyond(streams, [last + 2000 for last in cut_at[:len(results)]] +
                               [last + int((seconds + 1) * 1000 / milliseconds) for last in cut_at[len(results):]])
        self.kill_all()
        return results, leases

    def assert_unbroken(self, stream):
        numbers = stream.numbers()
        expected = list(range(numbers[0], numbers[-1] + 1))
        missing, twice = sorted(set(expected) - set(numbers)), len(numbers) - len(set(numbers))
        self.assertEqual(numbers, expected, f"{stream.name}: {len(missing)} missing, {twice} twice")

    def test_of_five_seconds_loses_and_doubles_nothing(self):
        results, leases = self.cut(5, 20)
        for stream in results + leases:
            with self.subTest(stream.name):
                self.assert_unbroken(stream)

    if FULL:
        def test_longer_than_a_participants_lease_loses_no_lease_that_its_writer_keeps(self):
            seconds, milliseconds = 30, 100
            self.assertLess((seconds + 10) * 1000 / milliseconds, LEASES_KEPT)
            _, leases = self.cut(seconds, milliseconds)
            for stream in leases:
                with self.subTest(stream.name):
                    numbers = stream.numbers()
                    # Those who meet anew may get again what they had.
                    self.assertEqual(sorted(set(numbers)), list(range(numbers[0], max(numbers) + 1)))


if __name__ == "__main__":
    unittest.main()
