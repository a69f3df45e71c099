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


if __name__ == "__main__":
    os.environ.setdefault("SOURCE", ".")
    unittest.main(verbosity=1)
