#!/usr/bin/env python3
"""tools/run_tests in a folder of its own: the tests of a name, the count of cases, and the order of the start."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()
# A GoogleTest program that tells its filter, and whose second shard dies in its second case.
PROGRAM = """#!/bin/sh
echo "filter $GTEST_FILTER" >>"$0.filters"
echo "[ RUN      ] A.first"
echo "[       OK ] A.first (1200 ms)"
[ "$GTEST_SHARD_INDEX" = 1 ] || exit 0
echo "[ RUN      ] A.second"
exit 139
"""
LONG = "WYTHE_" + "LONG"  # apart, because a script that names it is one for make test-long


class RunTests(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        (self.root / "tools").mkdir()
        shutil.copy(SOURCE / "tools/run_tests", self.root / "tools/run_tests")
        self.write("build/release/tests/wythe_unit_tests", PROGRAM).chmod(0o755)
        self.write("tests/unit/a_test.cpp", "TEST(A, first) {}\nTEST_F(A, second) {}\n" + "".join(f"TEST(A, more_{i}) {{}}\n" for i in range(12)))
        self.write("tests/unit/walls/b_test.cpp", "TEST_P(B, third) {}\nTYPED_TEST(C, fourth) {}\nRC_GTEST_PROP(D, fifth, (int i)) {}\n")
        for name in ("one", "two", "three"):
            self.write(f"tests/cli/{name}_test.sh", f"echo {name} ${LONG} >>{self.root}/order\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def run_tests(self, *words, expected=0):
        done = subprocess.run(["python3", "tools/run_tests", "--no-build", "--jobs", "1", *words], cwd=self.root, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, expected, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def order(self):
        text = (self.root / "order").read_text()
        (self.root / "order").unlink()
        return text.split()

    def filters(self):
        return set((self.root / "build/release/tests/wythe_unit_tests.filters").read_text().splitlines())

    def test_a_file_means_its_cases(self):
        said = self.run_tests("--only", "unit/walls/b_test")
        self.assertEqual(self.filters(), {"filter */B.third/*:C/*.fourth:D.fifth"})
        self.assertEqual(said.splitlines()[-1], "1 passed, 0 failed")

    def test_what_a_file_leaves_out_is_said_where_that_is_shorter(self):
        self.run_tests("--only", "tests/unit/a_test.cpp", expected=1)
        self.assertEqual(self.filters(), {"filter -*/B.third/*:C/*.fourth:D.fifth"})

    def test_a_case_that_crashes_has_failed_and_slow_ones_are_named(self):
        said = self.run_tests("--only", "unit", expected=1)
        self.assertEqual(self.filters(), {"filter *"})
        self.assertIn("FAILED: unit: A.second (exit 139)", said)
        self.assertIn("    1.2 s  unit: A.first", said)
        self.assertEqual(said.splitlines()[-1], "3 passed, 1 failed")

    def test_what_took_longest_begins_first(self):
        file = self.write("build/release/tests/durations.json", json.dumps({"cli/one_test": 3, "cli/two_test": 1, "cli/three_test": 2}))
        self.run_tests("--only", "cli")
        self.assertEqual(self.order(), ["one", "three", "two"])
        self.assertLess(json.loads(file.read_text())["cli/one_test"], 3)

    def test_long_tests_are_apart(self):
        self.write("tests/cli/four_long_test.sh", f"echo four ${LONG} >>{self.root}/order\n")
        self.run_tests("--only", "cli")
        self.assertEqual(sorted(self.order()), ["one", "three", "two"])
        said = self.run_tests("--long")
        self.assertEqual(sorted(self.order()), ["1"] * 4 + ["four", "one", "three", "two"])
        self.assertEqual(said.splitlines()[-1], "4 passed, 0 failed")

    def test_an_unknown_name_is_refused(self):
        self.assertIn("--only unit/nowhere: no test of this name", self.run_tests("--only", "unit/nowhere", expected=1))


if __name__ == "__main__":
    unittest.main(verbosity=1)
