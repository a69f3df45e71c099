#!/usr/bin/env python3
"""What a package may vouch for: binaries, sources and tools of one commit, and a version that sorts where it belongs. In small
repositories, without a build (tools/release.py, cmake/write_provenance.cmake)."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(SOURCE / "tools"))
sys.dont_write_bytecode = True
import release  # noqa: E402  (its folder is known only now)


def call(*command, cwd=None, **more):
    environment = {**os.environ, "GIT_AUTHOR_DATE": "1700000000 +0000", "GIT_COMMITTER_DATE": "1700000000 +0000", **more}
    return subprocess.run(list(map(str, command)), cwd=cwd, check=True, capture_output=True, text=True, env=environment).stdout.strip()


class Repository(unittest.TestCase):
    """A repository with the tools, and a build folder whose binaries say what the test lets them say."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.root, self.build = self.folder / "root", self.folder / "build"
        for name in [*release.TOOLS, "cmake/commit.txt", "cmake/write_provenance.cmake", ".gitattributes"]:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / name, self.root / name)
        (self.root / "cmake/commit.txt").write_text("$Format:%H %ct %(describe:tags=true,match=v[0-9]*,abbrev=40)$\n")
        self.git("init", "-q", "-b", "main")
        self.commit("first")
        (self.build / "python/wythe").mkdir(parents=True)
        for name in ("wythe", "libwythe.so", "python/wythe/_wythe.cpython-311-x86_64-linux-gnu.so"):
            (self.build / name).touch()
        self.said = {}

    def git(self, *words):
        return call("git", "-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false", *words, cwd=self.root)

    def commit(self, text):
        (self.root / "text.txt").write_text(text)
        self.git("add", "-A")
        self.git("commit", "-q", "-m", text)
        self.head = self.git("rev-parse", "HEAD")
        return self.head

    def made(self, anyway=False, **differs):
        """A release whose binaries are of the head, but for what differs by binary."""
        def said_by(file, _):
            of = {"commit": self.head[:12], "dirty": None, "type": "Release", "flags": release.FLAGS}
            of.update(differs.get("all", {}))
            of.update(differs.get("module" if file.name.startswith("_") else file.name.split(".")[0], {}))
            if of.get("unread"):
                return None
            return ("0.1.0", of["commit"], of["dirty"], "GNU 12.2.0", of["type"], None if file.name == "wythe" else of["flags"])
        with mock.patch.object(release, "said_by", said_by):
            return release.Release(self.root, self.build, anyway)

    def refused(self, *words, **differs):
        with self.assertRaises(SystemExit) as ended:
            self.made(**differs)
        for word in words:
            self.assertIn(word, str(ended.exception))


class OneCommit(Repository):
    def test_what_fits_together_is_packed(self):
        made = self.made()
        self.assertEqual((made.commit, made.faults, made.epoch), (self.head, [], 1700000000))

    def test_a_library_or_module_of_another_commit_is_refused_even_so(self):
        for name in ("libwythe", "module"):
            for anyway in (False, True):
                self.refused(self.head[:12], "0123456789ab", "make build", anyway=anyway, **{name: {"commit": "0123456789ab"}})

    def test_a_commit_that_the_clone_lacks_is_refused(self):
        self.refused("0123456789ab", "does not find", all={"commit": "0123456789ab"})
        self.refused("unknown", all={"commit": "unknown"})

    def test_changed_sources_debug_builds_native_code_and_unread_files_are_packed_only_when_asked_and_named(self):
        for name, differs, words in (("dirty", {"all": {"dirty": "-dirty"}}, "in no commit"),
                                     ("relwithdebinfo", {"all": {"type": "RelWithDebInfo"}}, "RelWithDebInfo"),
                                     ("flags", {"module": {"flags": "-O3 -march=native"}}, "-march=native"),
                                     ("unread", {"libwythe": {"unread": True}}, "can't be loaded")):
            with self.subTest(name):
                self.refused(words, "--anyway", **differs)
                made = self.made(anyway=True, **differs)
                self.assertTrue(made.version.endswith(f".{name}"), made.version)
                self.assertEqual(made.archive() is None, name == "dirty")

    def test_tools_of_another_commit_are_refused(self):
        (self.root / "tools/shell_words.py").write_text("# other\n")
        self.refused("tools/shell_words.py", "--anyway")

    def test_the_archive_is_of_the_programs_commit_when_the_head_moves_on(self):
        made = self.made()
        before = made.archive()
        head = self.head
        self.commit("second")
        self.assertEqual(made.archive(), before)
        tree = made.sources(self.folder / "unpacked")
        self.assertEqual((tree / "text.txt").read_text(), "first")
        self.assertEqual((tree / "cmake/commit.txt").read_text().split(), [head, "1700000000"])
        self.assertEqual(self.made(all={"commit": head[:12]}).archive(), before)

    def test_settings_of_a_user_change_no_byte_of_the_archive(self):
        before = self.made().archive()
        for setting in (("tar.umask", "0077"), ("core.autocrlf", "true")):
            self.git("config", *setting)
        with mock.patch.dict(os.environ, GIT_DIR="/nowhere", TZ="Asia/Tokyo", LC_ALL="it_IT.UTF-8"):
            self.assertEqual(self.made().archive(), before)

    def test_an_unpacked_archive_knows_its_commit_and_refuses_a_program_of_another(self):
        tree = self.made().sources(self.folder / "unpacked")
        head, self.root = self.head, tree
        self.assertEqual((self.made().commit, self.made().archive()), (head, None))
        self.head = "0123456789ab"
        self.refused("0123456789ab", head)

    def test_an_epoch_that_is_no_number_is_refused(self):
        with mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="yesterday"):
            self.refused("SOURCE_DATE_EPOCH", "yesterday")
        with mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="1600000000"):
            self.assertEqual(self.made().epoch, 1600000000)

    def test_no_module_and_two_modules_are_refused(self):
        (self.build / "python/wythe/_wythe.cpython-312-x86_64-linux-gnu.so").touch()
        self.refused("2 modules")
        shutil.rmtree(self.build / "python")
        self.refused("0 modules", "pybind11-dev")
        (self.build / "wythe").unlink()
        (self.build / "python/wythe").mkdir(parents=True)
        self.refused("make build")


class Versions(Repository):
    def test_a_release_is_called_so_at_its_tag_alone_and_all_sort_as_they_came(self):
        before = self.made().version
        self.commit("the release")
        self.git("tag", "-a", "v0.1.0", "-m", "0.1.0")
        at = self.made().version
        changed = self.made(anyway=True, all={"dirty": "-dirty"}).version
        self.commit("later")
        after = self.made().version
        self.assertEqual(at, "0.1.0")
        self.assertRegex(before, r"^0\.1\.0~git20231114\.221320\.[0-9a-f]{7}$")
        self.assertRegex(after, r"^0\.1\.0\+git20231114\.221320\.[0-9a-f]{7}$")
        self.assertRegex(changed, r"^0\.1\.0.*dirty$")
        if shutil.which("dpkg"):
            for smaller, larger in ((before, at), (at, after), (before, after)):
                call("dpkg", "--compare-versions", f"{smaller}-1", "lt", f"{larger}-1")

    def test_the_archive_of_a_tag_knows_that_it_is_the_release(self):
        self.git("tag", "-a", "v0.1.0", "-m", "0.1.0")
        self.root = self.made().sources(self.folder / "unpacked")
        self.assertEqual(self.made().version, "0.1.0")


@unittest.skipUnless(shutil.which("cmake"), "needs cmake")
class Provenance(Repository):
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
        head = self.head
        tree = self.made().sources(self.folder / "unpacked")
        inside = self.root / "archive"
        shutil.copytree(tree, inside)
        self.commit("another project")
        self.assertNotEqual(self.head, head)
        self.assertEqual(self.told(inside), head[:12])


if __name__ == "__main__":
    unittest.main(verbosity=1)
