#!/usr/bin/env python3
"""What tools/sanitize makes of time that is too short, and of test programs that do nothing; with a compiler that copies."""
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from cli_test import SOURCE


def tool(name):
    loader = importlib.machinery.SourceFileLoader(name, str(pathlib.Path(SOURCE) / "tools" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class Turns(unittest.TestCase):
    def setUp(self):
        self.sanitize, self.tests = tool("sanitize"), tool("run_tests")

    def judged(self, ended, *cases):
        tally = self.tests.Tally()
        for status in cases:
            tally.add("case", status)
        self.sanitize.judge(self.tests, tally, "turn", ended, "no time")
        return tally.passed, tally.failed, tally.skipped

    def test_nothing_tested_is_never_a_success(self):
        self.assertEqual(self.judged(False), (0, [], ["turn"]))  # for lack of time
        self.assertEqual(self.judged(True), (0, ["turn"], []))  # though a program came to its end
        self.assertEqual(self.judged(True, 0), (1, [], []))
        self.assertEqual(self.judged(False, 1), (0, ["case"], []))

    def test_the_clock_takes_only_the_case_that_ran(self):
        output = "[ RUN      ] A.a\n[       OK ] A.a\n[ RUN      ] A.b\n"
        for status, passed, failed in ((124, 1, 0), (-11, 1, 1)):
            tally = self.tests.Tally()
            self.tests.count_cases("unit", *self.sanitize.cut(status, output), tally)
            self.assertEqual((tally.passed, len(tally.failed)), (passed, failed))

    def project(self, folder, sources):
        """A build of the preset release, as far as it is read; its compiler copies and says what it depends on."""
        compiler = folder / "compiler"
        compiler.write_text('#!/bin/sh\nwhile [ $# -gt 0 ]; do case $1 in -o) out=$2;; -MF) rule=$2;; -c) in=$2;; esac; shift; done\n'
                            'grep -q broken "$in" && exit 1\necho "$out: $in" >"$rule"\ncp "$in" "$out"\n')
        compiler.chmod(0o755)
        release = folder / "build/release"
        release.mkdir(parents=True)
        entries = []
        for name, text in sources.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
            entries.append({"file": str(folder / name), "command": f"{compiler} -O3 -DNDEBUG -o CMakeFiles/wythe.dir/{name}.o -c {folder / name}"})
        (release / "compile_commands.json").write_text(json.dumps(entries))
        self.sanitize.ROOT = folder
        return self.sanitize.Sanitized("address", release)

    def test_slices_hold_every_source_but_the_kernels_once(self):
        with tempfile.TemporaryDirectory() as folder:
            made = self.project(pathlib.Path(folder), {**{f"src/core/{i}.cpp": "x" * (1 + 97 * i % 41) for i in range(60)}, "src/a/press_kernels_avx2.cpp": "x"})
            self.assertEqual([o.split("/")[-1] for o in made.kernels()], ["press_kernels_avx2.cpp.o"])
            self.assertEqual(made.linked(["k_avx512.o", "k_avx2.o", "k_sse2.o", "a.o"]), ["k_sse2.o", "a.o", "k_avx2.o", "k_avx512.o"])
            slices = [made.slice(i) for i in range(self.sanitize.SLICES)]
            self.assertEqual(sorted(sum(slices, [])), [o for o in sorted(made.commands) if "kernels" not in o])
            self.assertTrue(all(slices))

    def test_an_object_older_than_its_source_is_not_ready(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            made = self.project(folder, {"src/core/a.cpp": "a", "src/core/b.cpp": "b"})
            objects = sorted(made.commands)
            self.assertEqual(made.compile(objects, 1), objects)
            file = made.folder / "build.ninja"
            self.assertEqual(made.not_ready(file), set())
            (folder / "src/core/a.cpp").write_text("changed")
            later = (made.folder / objects[0]).stat().st_mtime_ns + 10**9
            os.utime(folder / "src/core/a.cpp", ns=(later, later))
            self.assertEqual(made.not_ready(file), {objects[0]})

    def test_a_source_that_does_not_compile_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            made = self.project(pathlib.Path(folder), {"src/core/a.cpp": "a", "src/core/b.cpp": "broken"})
            with self.assertRaises(SystemExit) as told:
                made.compile(sorted(made.commands), 1)
            self.assertIn("b.cpp", str(told.exception))


class ContinuousIntegration(unittest.TestCase):
    """.ci/run adds up what two commands count; neither can end without a count and pass."""

    def last_line(self, tests, turn):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for name, text in (("make", tests), ("tools/sanitize", turn), (".ci/run", (pathlib.Path(SOURCE) / ".ci/run").read_text())):
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
        for tests, turn, expected in ((good, 'echo "5 passed, 0 failed"', ("15 passed, 0 failed", 0)),
                                      (good, 'echo "5 passed, 1 failed"; exit 1', ("15 passed, 1 failed", 1)),
                                      ('echo "10 passed, 2 failed"; exit 2', good, ("20 passed, 2 failed", 1)),
                                      ("exit 2", good, ("0 passed, 1 failed", 1)),
                                      (good, "exit 3", ("10 passed, 1 failed", 1)),
                                      (good + "; exit 2", good, ("20 passed, 1 failed", 1)),
                                      ('echo "0 passed, 0 failed"', 'echo "0 passed, 0 failed"', ("0 passed, 0 failed", 1))):
            self.assertEqual(self.last_line(tests, turn), expected, (tests, turn))


if __name__ == "__main__":
    unittest.main(verbosity=1)
