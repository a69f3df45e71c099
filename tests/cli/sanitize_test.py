#!/usr/bin/env python3
"""The tests of CI under sanitizers: their counts add up, missing output fails, and each named test exists."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()
FAKE = """#!/bin/sh
echo "$@" >>"$(dirname "$0")/calls"
echo "3 passed, 1 failed"
"""


class Sanitize(unittest.TestCase):
    def test_each_test_under_sanitizers_in_ci_is_there(self):
        part = re.search(r"PART = \[(.*)\]", (SOURCE / "tools/sanitize").read_text()).group(1)
        for name in re.findall(r'"(.*?)"', part):
            self.assertTrue((SOURCE / "tests" / name).is_dir() or (SOURCE / f"tests/{name}.cpp").exists(), name)

    def test_each_test_with_threads_is_there(self):
        threaded = re.search(r"THREADED = \[(.*)\]", (SOURCE / "tools/sanitize").read_text()).group(1)
        for name in re.findall(r'"(.*?)"', threaded):
            self.assertTrue((SOURCE / "tests" / name).is_dir() or list((SOURCE / "tests").glob(f"**/{name}.*")), name)

    def test_both_sanitizers_run_and_their_counts_are_added(self):
        with tempfile.TemporaryDirectory() as folder:
            tools = pathlib.Path(folder) / "tools"
            tools.mkdir()
            (tools / "sanitize").write_text((SOURCE / "tools/sanitize").read_text())
            (tools / "run_tests").write_text(FAKE)
            (tools / "run_tests").chmod(0o755)
            done = subprocess.run(["python3", tools / "sanitize"], capture_output=True, text=True, check=False)
            self.assertEqual((done.stdout.splitlines()[-1], done.returncode), ("6 passed, 2 failed", 1))
            calls = (tools / "calls").read_text().splitlines()
            for call, words in zip(calls, ("--preset asan --timeout 7200 --only unit property verification regression determinism fuzz",
                                           "--preset tsan --timeout 7200 --only determinism unit/core/parallel_test"), strict=True):
                self.assertIn(words, call)
            done = subprocess.run(["python3", tools / "sanitize", "--preset", "asan", "--only", "property", "fuzz"], capture_output=True, text=True, check=False)
            self.assertEqual(done.stdout.splitlines()[-1], "3 passed, 1 failed")
            self.assertEqual((tools / "calls").read_text().splitlines()[2:], ["--preset asan --timeout 7200 --only property fuzz"])


class ContinuousIntegration(unittest.TestCase):
    """.ci/run adds up what two commands count; neither can end without a count and pass."""

    def last_line(self, tests, part):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for name, text in (("make", tests), ("tools/sanitize", part), (".ci/run", (SOURCE / ".ci/run").read_text())):
                (folder / name).parent.mkdir(exist_ok=True)
                (folder / name).write_text(text if name == ".ci/run" else f"#!/bin/sh\n{text}\n")
                (folder / name).chmod(0o755)
            (folder / "build/release").mkdir(parents=True)
            (folder / "build/release/build.ninja").touch()
            done = subprocess.run([folder / ".ci/run"], capture_output=True, text=True, check=False,
                                  env=dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}"))
            return done.stdout.splitlines()[-1], done.returncode

    def test_counts_are_added_and_silence_is_a_failure(self):
        good = 'echo "10 passed, 0 failed"'
        for tests, part, expected in ((good, 'echo "5 passed, 0 failed"', ("15 passed, 0 failed", 0)),
                                      (good, 'echo "5 passed, 1 failed"; exit 1', ("15 passed, 1 failed", 1)),
                                      ('echo "10 passed, 2 failed"; exit 2', good, ("20 passed, 2 failed", 1)),
                                      ("exit 2", good, ("0 passed, 1 failed", 1)),
                                      (good, "exit 3", ("10 passed, 1 failed", 1)),
                                      (good + "; exit 2", good, ("20 passed, 1 failed", 1)),
                                      ('echo "0 passed, 0 failed"', 'echo "0 passed, 0 failed"', ("0 passed, 0 failed", 1))):
            self.assertEqual(self.last_line(tests, part), expected, (tests, part))


if __name__ == "__main__":
    unittest.main(verbosity=1)
