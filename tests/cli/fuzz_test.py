#!/usr/bin/env python3
"""tools/fuzz with a simulated libFuzzer: its counts, and a failure if the fuzzer does nothing."""
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()


class Fuzz(unittest.TestCase):
    def fuzz(self, script):
        with tempfile.TemporaryDirectory() as folder:
            binary = pathlib.Path(folder) / "fuzzer"
            binary.write_text(f"#!/bin/sh\n{script}\n" + 'echo "#7 DONE cov: 21 ft: 3"\necho "stat::number_of_executed_units: 7" \n')
            binary.chmod(0o755)
            return subprocess.run([SOURCE / "tools/fuzz", "--binary", binary, "--target", "law", "dxf"], capture_output=True, text=True, check=False)

    def test_each_target_is_told_with_its_counts(self):
        done = self.fuzz("")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines(), ["law: 7 executions, 21 edges, 0 findings", "dxf: 7 executions, 21 edges, 0 findings"])

    def test_a_fuzzer_that_does_nothing_has_failed(self):
        done = self.fuzz("[ $WYTHE_FUZZ_TARGET = law ] && exit 0")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("law: 0 executions", done.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=1)
