#!/usr/bin/env python3
"""tools/soak at its shortest: it counts what it did, keeps the count, and does not do it again."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from cli_test import SOURCE, WYTHE


class Soak(unittest.TestCase):
    def test_figures_are_kept_and_gone_on_from(self):
        with tempfile.TemporaryDirectory() as folder:
            def soak(kills):
                done = subprocess.run([SOURCE / "tools/soak", "--wythe", WYTHE, "--folder", folder, "--kills", str(kills), "--full", "1",
                                       "--samples", "20", "--executions", "0"], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                return json.loads((pathlib.Path(folder) / "figures.json").read_text())

            first = soak(1)
            self.assertEqual((first["kills"], first["full_disks"], first["tiny_samples"], first["failures"]), (1, 1, 20, []))
            self.assertEqual(soak(1), first)
            self.assertEqual(soak(2)["kills"], 2)

    def test_a_trace_is_a_failure(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "whole_200").mkdir()
            (pathlib.Path(folder) / "whole_200/samples.csv").write_text("other")
            done = subprocess.run([SOURCE / "tools/soak", "--wythe", WYTHE, "--folder", folder, "--kills", "1", "--full", "0",
                                   "--samples", "0", "--executions", "0"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertIn("killed: other samples.csv", done.stdout)

    def fuzz(self, folder, script):
        """A fuzzer that says what libFuzzer says, 7 inputs a turn; the targets, and what tools/soak made of it."""
        binary = folder / "fuzzer"
        binary.write_text(f"#!/bin/sh\n{script}\necho '#7 DONE cov: 12 ft: 3'\necho stat::number_of_executed_units: 7\n")
        binary.chmod(0o755)
        page = folder / "page.md"
        page.write_text("above\n<!-- soak: written by tools/soak -->\nold\n<!-- end of soak -->\nbelow\n")
        targets = sorted(p.name for p in pathlib.Path(SOURCE, "tests/fuzz/corpus").iterdir())
        return targets, page, subprocess.run(
            [SOURCE / "tools/soak", "--wythe", WYTHE, "--folder", folder, "--kills", "0", "--full", "0", "--samples", "0", "--executions",
             str(7 * len(targets)), "--jobs", "3", "--binary", binary, "--page", page], capture_output=True, text=True, check=False)

    def test_fuzz_targets_have_turns_and_a_page(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            targets, page, done = self.fuzz(folder, "")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            figures = json.loads((folder / "figures.json").read_text())
            self.assertEqual(sorted(figures["fuzz"]), targets)  # each had its turn before one had its second
            self.assertGreaterEqual(sum(one["executions"] for one in figures["fuzz"].values()), 7 * len(targets))
            text = page.read_text()
            self.assertTrue(text.startswith("above\n") and text.endswith("below\n") and "old" not in text, text)
            self.assertIn(f"| `{targets[0]}` | {figures['fuzz'][targets[0]]['executions']} |", text)

    def test_a_fuzzer_that_does_nothing_is_no_soak(self):
        with tempfile.TemporaryDirectory() as folder:
            _, _, done = self.fuzz(pathlib.Path(folder), "[ $WYTHE_FUZZ_TARGET = law ] && exit 0")
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertIn("fuzz law: nothing was executed", done.stderr)


if __name__ == "__main__":
    os.environ.setdefault("SOURCE", ".")
    unittest.main(verbosity=1)
