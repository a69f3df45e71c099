#!/usr/bin/env python3
"""The program as g++ builds it: it compiles without a warning, and walls end with the same state hashes (make test-long)."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()


class Gcc(unittest.TestCase):
    def test_its_program_gives_the_same_bits(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["cmake", "-S", SOURCE, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=g++",
                                   "-DWYTHE_KERNELS=native", "-DWYTHE_TESTS=OFF", "-DWYTHE_BENCHMARKS=OFF", "-DWYTHE_PYTHON=OFF"],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = subprocess.run(["cmake", "--build", folder, "--target", "wythe_cli"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-5000:])
            done = subprocess.run([sys.executable, SOURCE / "tests/cli/reference_hashes_test.py"], capture_output=True, text=True, check=False,
                                  env={**os.environ, "WYTHE": f"{folder}/wythe", "SOURCE": str(SOURCE)})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    if not shutil.which("g++"):
        print("needs g++")
        sys.exit(77)
    unittest.main(verbosity=1)
