#!/usr/bin/env python3
"""Installs the packages in a new, minimal Debian, runs examples there, reads the manual page, completes, upgrades and removes
(tools/package --check). Skipped, with the reason, where there is no root, no network or no mmdebstrap."""
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
BUILD = pathlib.Path(os.environ.get("BUILD", SOURCE / "build/release")).resolve()


def main():
    if not (BUILD / "wythe").exists() or not list(BUILD.glob("python/wythe/_wythe.cpython-*.so")):
        print(f"no build of the program and the Python module in {BUILD}")
        return 77
    if "sanitize" in (BUILD / "CMakeCache.txt").read_text():
        print("a build under sanitizers needs libraries that no package brings")
        return 77
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([str(SOURCE / "tools/package"), "--anyway", "--build", str(BUILD), "--out", out, "--level", "0", "--check"], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    print(done.stdout.strip().splitlines()[-1].removeprefix("skipped: ") if done.returncode == 77 else done.stdout[-6000:])
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
