#!/usr/bin/env python3
"""The second build of tools/package --rebuild, with programs that stand in for cmake and the packer: it goes on where it was interrupted, loses
nothing, and says which bytes differ and where (tools/second_build.py)."""
import contextlib
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace
from unittest import mock

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(SOURCE / "tools"))
sys.dont_write_bytecode = True
import second_build  # noqa: E402  (its folder is known only now)

# `cmake --preset` makes the folder, `cmake --build` the program; both write down that they ran, and what they saw
CMAKE = """#!/bin/sh
echo "$1 ${CCACHE_DISABLE:-} ${CXXFLAGS:-none} ${CCACHE_DIR:-none}" >>"$PWD/calls"
mkdir -p build/release
if [ "$1" = --build ]; then
  [ ! -e ../interrupted ] || { rm ../interrupted; echo "no space left"; exit 7; }
  cp program build/release/wythe
fi
"""
PACKER = """#!/bin/sh
mkdir -p packages && cp program packages/a.deb && cd packages && sha256sum a.deb >SHA256SUMS
"""


def call(*command, cwd=None):
    return subprocess.run(list(map(str, command)), cwd=cwd, check=True, capture_output=True, text=True).stdout.strip()


class Builds(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.root, self.again, self.out = self.folder / "root", self.folder / "in/another/place", self.folder / "out"
        for name, text in (("root/program", "the program\n"), ("root/tools/package", PACKER), ("tools/cmake", CMAKE)):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text)
            (self.folder / name).chmod(0o755)
        for words in (("init", "-q"), ("add", "-A"), ("-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "first")):
            call("git", *words, cwd=self.root)
        build = self.root / "build/release"
        build.mkdir(parents=True)
        shutil.copy(self.root / "program", build / "wythe")
        self.out.mkdir()
        shutil.copy(self.root / "program", self.out / "a.deb")
        (self.out / "SHA256SUMS").write_text(call("sha256sum", "a.deb", cwd=self.out) + "\n")
        self.release = SimpleNamespace(root=self.root, build=build, faults=[], commit=call("git", "rev-parse", "HEAD", cwd=self.root))
        for patch in (mock.patch.dict(os.environ, PATH=f"{self.folder / 'tools'}:{os.environ['PATH']}", CXXFLAGS="-march=native", CCACHE_DIR="/cache"),):
            patch.start()
            self.addCleanup(patch.stop)

    def rebuild(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            try:
                return second_build.rebuild(self.release, self.out, self.again, 1, 0), said.getvalue()
            finally:
                self.calls = (self.again / "calls").read_text().splitlines() if (self.again / "calls").exists() else []

    def test_the_same_bytes_are_said_and_the_second_build_is_removed(self):
        different, said = self.rebuild()
        self.assertEqual(different, [])
        self.assertEqual(said.count("same  "), 2)
        self.assertIn("wythe", (self.out / "compared.txt").read_text())
        self.assertFalse(self.again.exists())

    def test_an_interrupted_build_goes_on_and_clones_nothing_again(self):
        (self.again.parent).mkdir(parents=True)
        (self.again.parent / "interrupted").touch()
        with self.assertRaises(SystemExit) as ended:
            self.rebuild()
        self.assertIn("goes on", str(ended.exception))
        self.assertIn("no space left", self.again.with_name("place.log").read_text())
        (self.again / "build/release/half.o").touch()
        inode = self.again.stat().st_ino
        with mock.patch.object(second_build.shutil, "rmtree") as removed:
            different, said = self.rebuild()
        self.assertEqual((different, self.again.stat().st_ino), ([], inode))
        self.assertIn("goes on in", said)
        self.assertTrue((self.again / "build/release/half.o").exists())
        removed.assert_called_once_with(self.again)
        self.assertEqual(self.calls, ["--preset 1 none none", "--build 1 none none"] * 2)

    def test_a_clone_that_was_cut_off_is_made_anew(self):
        part = self.again.with_name("place.part")
        part.mkdir(parents=True)
        (part / "half").touch()
        self.assertEqual(self.rebuild()[0], [])

    def test_a_folder_of_another_commit_or_with_changes_is_refused(self):
        call("git", "clone", "-q", self.root, self.again)
        (self.again / "program").write_text("changed\n")
        with self.assertRaises(SystemExit) as ended:
            self.rebuild()
        self.assertIn("remove it", str(ended.exception))

    def test_what_differs_is_named_and_both_builds_are_kept(self):
        (self.release.build / "wythe").write_text("the pro-gram\n")
        different, said = self.rebuild()
        self.assertEqual(different, ["wythe"])
        self.assertIn("at byte 7", said)
        self.assertIn("b'the pro-gram", said)
        self.assertTrue((self.again / "build/release/wythe").exists())

    def test_a_package_that_is_not_what_its_sum_says_is_refused(self):
        (self.out / "a.deb").write_text("other\n")
        with self.assertRaises(SystemExit) as ended:
            self.rebuild()
        self.assertIn("SHA256SUMS", str(ended.exception))

    def test_builds_of_two_commits_are_not_compared(self):
        other = SimpleNamespace(build=self.folder, commit="0" * 40)
        with self.assertRaises(SystemExit) as ended:
            second_build.compare_builds(self.release, self.out, other, None)
        self.assertIn("000000000000", str(ended.exception))


class Differences(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def compared(self, one, two):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            different = second_build.compared(one, two)
        return different, said.getvalue()

    def test_a_file_on_one_side_alone_differs(self):
        (self.folder / "a").touch()
        different, said = self.compared({"a": self.folder / "a"}, {})
        self.assertEqual((different, "only in the first" in said), (["a"], True))

    @unittest.skipUnless(shutil.which("cc") and shutil.which("readelf"), "needs a C compiler")
    def test_the_section_of_a_binary_that_differs_is_named_with_its_bytes(self):
        for name in ("one", "two"):
            source = self.folder / "a.c"
            source.write_text(f'#include <stdio.h>\nint main(void) {{ puts("built in /home/{name}"); return 0; }}\n')
            call("cc", "-Wl,--build-id=none", "-s", source, "-o", self.folder / name)
        different, said = self.compared({"wythe": self.folder / "one"}, {"wythe": self.folder / "two"})
        self.assertEqual(different, ["wythe"])
        self.assertIn("first: .rodata at byte", said)
        self.assertIn("/home/two", said)
        self.assertNotIn(".text", said)

    @unittest.skipUnless(shutil.which("dpkg-deb"), "needs Debian's tools")
    def test_inside_a_package_the_file_its_mode_and_its_time_are_named(self):
        for name, text, mode, when in (("one", "a\n", 0o644, 1000), ("two", "b\n", 0o600, 2000)):
            tree = self.folder / name
            (tree / "DEBIAN").mkdir(parents=True)
            (tree / "DEBIAN/control").write_text("Package: a\nVersion: 1\nArchitecture: all\nMaintainer: A <a@example.org>\nDescription: a\n")
            (tree / "DEBIAN/control").chmod(0o644)
            (tree / "page").write_text(text)
            (tree / "page").chmod(mode)
            for path in (tree / "DEBIAN/control", tree / "DEBIAN", tree / "page", tree):
                os.utime(path, (when, when))
            call("dpkg-deb", "--root-owner-group", "-Znone", "--build", tree, self.folder / f"{name}.deb")
        different, said = self.compared({"a.deb": self.folder / "one.deb"}, {"a.deb": self.folder / "two.deb"})
        self.assertEqual(different, ["a.deb"])
        for words in ("page: mode 0o100644 and 0o100600", "page: time 1000 and 2000", "page: at byte 0"):
            self.assertIn(words, said)


if __name__ == "__main__":
    unittest.main(verbosity=1)
