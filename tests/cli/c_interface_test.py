#!/usr/bin/env python3
"""The C interface: a C program compiled with only the header, and the symbols that libwythe.so exports."""
import os
import pathlib
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()


class CInterface(unittest.TestCase):
    def test_a_c_program_runs_checks_and_stops(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "interface_test"
            subprocess.run(["cc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-pedantic",
                            f"-I{SOURCE}/include", str(SOURCE / "tests/c/interface_test.c"), "-o", str(program),
                            f"-L{BUILD}", "-lwythe", "-lm", f"-Wl,-rpath,{BUILD}"], check=True)
            done = subprocess.run([str(program), str(SOURCE / "examples/brick_pier/model.toml")],
                                  capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_the_library_shows_only_its_own_names(self):
        listed = subprocess.run(["nm", "-D", "--defined-only", str(BUILD / "libwythe.so")],
                                capture_output=True, text=True, check=True).stdout
        names = [line.split()[-1] for line in listed.splitlines()]
        self.assertTrue(names)
        self.assertEqual([name for name in names if not name.startswith("wythe_")], [])


if __name__ == "__main__":
    unittest.main()
