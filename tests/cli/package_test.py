#!/usr/bin/env python3
"""The packaging in debian/: its control file, one version everywhere, and the lists of installed files. Building the packages and
installing them in a new Debian: package_long_test.py (make test-long)."""
import fnmatch
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()
BUILD = pathlib.Path(os.environ.get("BUILD", SOURCE / "build/release")).resolve()
NAMES = ["wythe", "libwythe1", "libwythe-dev", "python3-wythe"]


def paragraphs(text):
    """Fields of each paragraph of a control file."""
    found = []
    for part in re.split(r"\n\n+", text.strip()):
        fields = re.findall(r"^([A-Za-z-]+):((?: .*)?(?:\n[ \t].*)*)$", part, re.M)
        assert part == "\n".join(f"{name}:{value}" for name, value in fields), part  # no line is left over
        found.append({name: value.strip() for name, value in fields})
    return found


def listed(name):
    """Patterns of a list in debian/."""
    return [line for line in (SOURCE / "debian" / name).read_text().split("\n") if line and not line.startswith("#")]


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source, *cls.packages = paragraphs((SOURCE / "debian/control").read_text())

    def test_there_are_four_packages(self):
        self.assertEqual([p["Package"] for p in self.packages], NAMES)
        for package in self.packages:
            self.assertRegex(package["Description"], r"^strength, drift and failure of masonry walls.*\n \S")
            self.assertIn("${misc:Depends}", package["Depends"])
        self.assertNotIn("python", self.packages[0]["Depends"])  # clusters have none
        self.assertEqual(self.packages[1]["Package"], f"libwythe{re.search('SOVERSION ([0-9]+)', (SOURCE / 'CMakeLists.txt').read_text()).group(1)}")

    def test_what_the_build_needs_is_what_setup_installs(self):
        needed = set(re.findall(r"^\s*([a-z][\w.+-]+)", self.source["Build-Depends"].replace(",", "\n"), re.M)) - {"debhelper-compat"}
        installed = {name for deps in ("apt.txt", "package.txt") for name in re.findall(r"^([a-z]\S+)", (SOURCE / "deps" / deps).read_text(), re.M)}
        self.assertEqual(needed - installed, set())
        libraries = {name for name in installed if re.fullmatch(r"(lib.*|zlib1g|nlohmann-json3|pybind11)-dev", name)}
        self.assertEqual(libraries - needed, {"libgtest-dev", "librapidcheck-dev", "libbenchmark-dev", "libclang-rt-dev|libclang-rt-18-dev", "libudunits2-dev"})

    def test_setup_asks_a_new_machine_which_of_two_packages_it_has_after_the_update(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "deps").mkdir()
            (root / "tools").mkdir()
            shutil.copy(SOURCE / "tools/setup", root / "tools/setup")
            (root / "deps/apt.txt").write_text("wythe-one-dev|wythe-two-dev # one of both\n")
            fakes = {"apt-cache": f"test -e {root}/updated -a $2 = wythe-one-dev", "dpkg-query": "false", "sudo": 'exec "$@"',
                     "apt-get": f"case $1 in update) touch {root}/updated ;; *) echo $* >>{root}/asked; test -e {root}/updated ;; esac"}
            for name, body in fakes.items():
                (root / name).write_text(f"#!/bin/sh\n{body}\n")
                (root / name).chmod(0o755)
            subprocess.run([root / "tools/setup"], check=True, capture_output=True, env={**os.environ, "PATH": f"{root}:{os.environ['PATH']}"})
            self.assertEqual([line.split()[-1] for line in (root / "asked").read_text().splitlines()], ["wythe-two-dev", "wythe-one-dev"])

    def test_every_version_is_that_of_cmake(self):
        version = re.search(r"project\(wythe VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
        self.assertEqual(subprocess.run(["dpkg-parsechangelog", "-S", "Version", "-l", SOURCE / "debian/changelog"], capture_output=True, text=True,
                                        check=True).stdout.strip().split("-")[0], version)
        self.assertIn(f"\nversion: {version}\n", (SOURCE / "CITATION.cff").read_text())
        said = subprocess.run([BUILD / "wythe", "--version"], capture_output=True, text=True, check=True).stdout
        self.assertRegex(said, rf"^wythe {re.escape(version)} \(")
        told = subprocess.run(["/usr/bin/python3", "setup.py", "--version"], cwd=SOURCE, capture_output=True, text=True, check=True).stdout
        self.assertEqual(told.split()[-1], version)

    def test_the_lists_name_every_file_that_is_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cmake", "--install", BUILD, "--prefix", f"{folder}/usr"], check=True, capture_output=True)
            root = pathlib.Path(folder)
            files = {str(path.relative_to(root)) for path in root.rglob("*") if not path.is_dir()}
        left = set(files)
        for name in ("wythe.install", "libwythe1.install", "libwythe-dev.install", "not-installed"):
            for pattern in listed(name):
                # Debian's folder of libraries is usr/lib/x86_64-linux-gnu, any other build's may be usr/lib
                shapes = {pattern, pattern.replace("lib/*/", "lib/")}
                found = {file for file in files for shape in shapes if fnmatch.fnmatch(file, shape) or fnmatch.fnmatch(file, f"{shape}/*")}
                self.assertTrue(found, f"debian/{name}: {pattern}")
                left -= found
        self.assertEqual(left, set())

    def test_the_studio_is_in_the_package_of_the_program_where_it_is_built(self):
        # the rule of debian/rules, with a dh_install that notes how it was called
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "dh_install").write_text(f'#!/bin/sh\necho "dh_install $*" >>{root}/called\n')
            (root / "dh_install").chmod(0o755)
            (root / "debian").mkdir()
            rules = re.search(r"^override_dh_install:\n(?:\t.*\n)+", (SOURCE / "debian/rules").read_text(), re.M).group()
            (root / "Makefile").write_text(rules)
            environment = {**os.environ, "PATH": f"{root}:{os.environ['PATH']}"}
            subprocess.run(["make", "override_dh_install"], cwd=root, env=environment, check=True, capture_output=True)
            self.assertEqual((root / "called").read_text().split("\n"), ["dh_install ", ""])
            page = root / "debian/tmp/usr/share/wythe/studio.html"
            page.parent.mkdir(parents=True)
            page.touch()
            subprocess.run(["make", "override_dh_install"], cwd=root, env=environment, check=True, capture_output=True)
            self.assertEqual((root / "called").read_text().split("\n")[2], "dh_install -pwythe usr/share/wythe/studio.html")
        recipe = re.search(r"^package:.*\n(?:\t.*\n)+", (SOURCE / "Makefile").read_text(), re.M).group()
        place = re.search(r"build/package/wythe/(build/studio.html)", recipe).group(1)
        self.assertIn(f"${{CMAKE_SOURCE_DIR}}/{place} ", (SOURCE / "cmake/install.cmake").read_text())

    def test_pages_and_examples_are_there(self):
        for name in ("wythe.docs", "libwythe-dev.docs", "wythe.examples"):
            for pattern in listed(name):
                self.assertTrue(list(SOURCE.glob(pattern)), f"debian/{name}: {pattern}")


if __name__ == "__main__":
    if not (BUILD / "wythe").exists():
        print(f"no build of the program in {BUILD}")
        sys.exit(77)
    unittest.main(verbosity=1)
