#!/usr/bin/env python3
"""The commit that a build names (cmake/write_provenance.cmake), in small repositories: changed, unpacked, inside another one."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()


def call(*command, cwd=None):
    return subprocess.run(list(map(str, command)), cwd=cwd, check=True, capture_output=True, text=True).stdout.strip()


class Provenance(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.root = self.folder / "root"
        for name in ("cmake/commit.txt", "cmake/write_provenance.cmake", ".gitattributes"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / name, self.root / name)
        (self.root / "cmake/commit.txt").write_text("$Format:%H$\n")  # where the sources are an archive, it is filled in
        self.git("init", "-q", "-b", "main")
        self.head = self.commit("first")

    def git(self, *words):
        return call("git", "-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false", *words, cwd=self.root)

    def commit(self, text):
        (self.root / "text.txt").write_text(text)
        self.git("add", "-A")
        self.git("commit", "-q", "-m", text)
        return self.git("rev-parse", "HEAD")

    def told(self, root):
        header = self.folder / "provenance.h"
        call("cmake", f"-DSOURCE_DIR={root}", f"-DOUTPUT={header}", "-DVERSION=0.1.0", "-P", root / "cmake/write_provenance.cmake")
        return next(line.split('"')[1] for line in header.read_text().splitlines() if "WYTHE_COMMIT" in line)

    def test_a_new_source_file_that_is_compiled_in_is_a_change(self):
        self.assertEqual(self.told(self.root), self.head[:12])
        (self.root / "out").mkdir()
        (self.root / "out/results.csv").touch()
        self.assertEqual(self.told(self.root), self.head[:12])
        (self.root / "src").mkdir()
        (self.root / "src/new.cpp").touch()
        self.assertEqual(self.told(self.root), f"{self.head[:12]}-dirty")

    def test_a_repository_around_an_unpacked_archive_is_another_one(self):
        inside = self.root / "archive"
        inside.mkdir()
        call("git", "archive", "--output", self.folder / "archive.tar", "HEAD", cwd=self.root)
        call("tar", "xf", self.folder / "archive.tar", cwd=inside)
        self.assertNotEqual(self.commit("another project"), self.head)
        self.assertEqual(self.told(inside), self.head[:12])


if __name__ == "__main__":
    unittest.main(verbosity=1)
