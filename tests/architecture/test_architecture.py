"""The folders depend on each other in one direction only, and vendors stay in their rooms."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# What a folder's sources may include besides their own.
MAY_INCLUDE = {
    "science": set(),
    "experiment": {"science", "idl"},
    "messaging": {"experiment"},
    "storage": {"experiment", "idl"},
    "coordinator": {"experiment", "idl", "messaging", "storage"},
    "worker": {"science", "experiment", "idl", "messaging"},
    "robot_bridge": {"science", "experiment", "messaging"},
    "client": {"science", "experiment", "idl", "messaging", "storage"},
}
VENDORS = {
    "fastdds": re.compile(r"^(fastdds|fastrtps|fastcdr)/"),
    "cyclonedds": re.compile(r"^(dds|ddsc|dds/.*)/"),
}
SYSTEM_OF = {
    "sqlite3.h": {"storage"},
    "yaml-cpp/": {"experiment"},
    "Random123/": {"science"},
    "pagmo/": {"experiment"},
    "asio": {"robot_bridge"},
}


def sources(folder):
    return sorted(path for path in (ROOT / folder).rglob("*") if path.suffix in (".cpp", ".hpp"))


def includes(path):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', path.read_text(), re.MULTILINE)


class Architecture(unittest.TestCase):
    def test_dependencies_go_one_way(self):
        for folder, allowed in MAY_INCLUDE.items():
            self.assertTrue(sources(folder), folder)
            for path in sources(folder):
                for include in includes(path):
                    other = include.split("/")[0]
                    if "/" in include and other in MAY_INCLUDE.keys() | {"idl", "tests"} and other != folder:
                        self.assertIn(other, allowed, f"{path.relative_to(ROOT)} includes {include}")

    def test_only_the_coordinator_writes_storage(self):
        for path in sources("client") + sources("worker"):
            self.assertIsNone(re.search(r"\bResultsStore\b", path.read_text()), path.relative_to(ROOT))

    def test_vendor_headers_stay_in_their_folders(self):
        for folder in MAY_INCLUDE:
            for path in sources(folder):
                for include in includes(path):
                    for vendor, pattern in VENDORS.items():
                        if pattern.match(include):
                            self.assertEqual(path.relative_to(ROOT).parts[:2], ("messaging", vendor),
                                             f"{path.relative_to(ROOT)} includes {include}")

    def test_libraries_are_used_in_one_folder(self):
        for folder in MAY_INCLUDE:
            for path in sources(folder):
                for include in includes(path):
                    for prefix, owners in SYSTEM_OF.items():
                        if include.startswith(prefix):
                            self.assertIn(folder, owners, f"{path.relative_to(ROOT)} includes {include}")

    def test_results_depend_on_no_library_function_and_no_flag(self):
        """No libm, no distributions of the standard library, in what decides an outcome."""
        forbidden = re.compile(r"std::(exp|log|sin|cos|pow|exp2|log2|log1p|expm1|\w+_distribution|mt19937\w*|fma)\b")
        for path in sources("science"):
            self.assertIsNone(forbidden.search(path.read_text()), path.relative_to(ROOT))
        for path in ROOT.rglob("CMakeLists.txt"):
            if "build" not in path.relative_to(ROOT).parts:
                self.assertNotRegex(path.read_text(), r"-ffast-math|-march=native|-mfma", str(path))

    def test_files_stay_short(self):
        for folder in [*MAY_INCLUDE, "tests", "benchmarks"]:
            for path in sources(folder):
                self.assertLessEqual(len(path.read_text().splitlines()), 500, path.relative_to(ROOT))

    def test_every_top_level_entry_is_known(self):
        known = {"CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "idl", "science", "experiment",
                 "messaging", "storage", "coordinator", "worker", "robot_bridge", "client", "sweeps", "tests",
                 "benchmarks", "deploy", "docs", "build", "results"}
        found = {path.name for path in ROOT.iterdir() if not path.name.startswith(".")}
        self.assertEqual(found - known, set())
