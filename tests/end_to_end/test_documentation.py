"""Every command that the documentation shows is run as it stands there.

A ```console block is a terminal: lines that begin with "$ " are typed, in order, one terminal per document, in a scratch
folder where sweeps/, deploy/ and benchmarks/ lie as in the project's and the programs are on the PATH. Programs that run
until they are stopped are started in the background and interrupted at the document's end.
"""
import os
import re
import shlex
import signal
import subprocess
import time

from support import BIN, FULL, PATIENCE, Programs, ROOT

SERVERS = ("lamprey-coordinator", "lamprey-worker")
# Shown, and run by other means: they are what runs this test, take a whole grid's time, or need a second machine.
ELSEWHERE = re.compile(r"^(tests/run|git clone|cd |benchmarks/)|--peer")
ONLY_FULL = re.compile(r"sweeps/(thesis-chapter-8|mutate-\w+)\.yaml --database")


def documents():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("**/*.md"))]


def commands(document):
    for block in re.findall(r"```console\n(.*?)```", document.read_text(), re.DOTALL):
        text = block.replace("\\\n", " ")
        for line in text.splitlines():
            if line.startswith("$ "):
                yield line[2:].strip()


class Documentation(Programs):
    def setUp(self):
        super().setUp()
        for name in ("sweeps", "deploy", "benchmarks"):
            (self.folder / name).symlink_to(ROOT / name)
        self.environment["PATH"] = f"{BIN}:{self.environment['PATH']}"
        self.environment["LAMPREY_ISOLATION"] = self.isolation

    def servers_end(self):
        for process in self.processes:
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for process in self.processes:
            process.wait(30)
        self.processes.clear()

    def type_in(self, document, line):
        words = shlex.split(line, comments=True)
        if words[0] in SERVERS:
            log = open(self.folder / f"server-{len(self.processes)}.log", "w")
            self.addCleanup(log.close)
            self.processes.append(subprocess.Popen(words, cwd=self.folder, env=self.environment, stderr=log))
            time.sleep(1)
            self.assertIsNone(self.processes[-1].poll(), f"{document.name}: {line}")
            return
        result = subprocess.run(["bash", "-euo", "pipefail", "-c", line], cwd=self.folder, env=self.environment,
                                capture_output=True, text=True, timeout=1200 if FULL else PATIENCE)
        self.assertEqual(result.returncode, 0, f"{document.name}: {line}\n{result.stdout}\n{result.stderr}")

    def test_every_command_works(self):
        typed = 0
        for document in documents():
            with self.subTest(document.name):
                for line in commands(document):
                    if ELSEWHERE.search(line) or line.startswith("deploy/") or (ONLY_FULL.search(line) and not FULL):
                        continue
                    self.type_in(document, line)
                    typed += 1
                self.servers_end()
        self.assertGreater(typed, 10)

    def test_quickstart_shows_results_and_leaves_a_database(self):
        database = self.folder / "quickstart.db"
        result = subprocess.run([ROOT / "deploy" / "quickstart", "--database", database], capture_output=True, text=True,
                                timeout=900, env={**os.environ})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("one_fifth_rule", result.stdout)
        self.assertIn("What next", result.stdout)
        self.assertIn(str(database), result.stdout)
        self.assertEqual(self.number(database, "SELECT count(*) FROM result WHERE state = 'done'"), 360)
        self.assertEqual(self.number(database, "SELECT count(*) FROM worker"), 2)

    def test_links_lead_somewhere(self):
        for document in documents():
            for target in re.findall(r"\]\(([^)#]+)", document.read_text()):
                if "://" not in target:
                    self.assertTrue((document.parent / target).exists(), f"{document.name}: {target}")
