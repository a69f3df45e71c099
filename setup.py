"""Builds the module wythe._wythe with CMake; everything else stands in pyproject.toml.

WYTHE_BUILD names a build folder; without it build/release is used, and configured if it is not there yet.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        build = pathlib.Path(os.environ.get("WYTHE_BUILD", ROOT / "build" / "release"))
        program = getattr(sys, "_base_executable", None) or sys.executable
        if not (build / "CMakeCache.txt").exists():
            subprocess.run(["cmake", "--preset", "release", "-B", str(build), "-DWYTHE_TESTS=OFF",
                            "-DWYTHE_BENCHMARKS=OFF", f"-DWYTHE_PYTHON_PROGRAM={program}"], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", str(build), "--target", "wythe_python"], cwd=ROOT, check=True)
        suffix = sysconfig.get_config_var("EXT_SUFFIX")
        module = build / "python" / "wythe" / f"_wythe{suffix}"
        if not module.exists():
            sys.exit(f"{build} has no module for this interpreter ({suffix}): set WYTHE_BUILD to another "
                     f"folder, or configure with -DWYTHE_PYTHON_PROGRAM={program}")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(module, target)


VERSION = re.search(r"project\(wythe VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))

setup(version=VERSION.group(1), ext_modules=[Extension("wythe._wythe", sources=[])],
      cmdclass={"build_ext": BuildWithCMake})
