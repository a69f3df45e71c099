#!/usr/bin/env python3
"""The Debian packages: the same bytes twice, what is in each, and that each works from where it is unpacked. Installing them in a
new Debian needs a network: tools/package --check."""
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
BUILD = pathlib.Path(os.environ.get("BUILD", SOURCE / "build/release")).resolve()
NAMES = ["wythe", "libwythe1", "libwythe-dev", "python3-wythe"]
EPOCH = "1700000000"


def call(*command, **options):
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    assert done.returncode == 0, (command, done.stdout[-3000:])
    return done.stdout


@unittest.skipUnless(all(shutil.which(p) for p in ("dpkg-deb", "dpkg-shlibdeps", "git")), "needs Debian's tools")
class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        for out, mask in (("one", 0o022), ("two", 0o077)):
            call(SOURCE / "tools/package", "--build", BUILD, "--out", cls.folder / out, "--level", 0,
                 env=dict(os.environ, SOURCE_DATE_EPOCH=EPOCH, TMPDIR=cls.place(out)), preexec_fn=lambda mask=mask: os.umask(mask) and None)
        cls.root = cls.folder / "root"
        cls.fields = {}
        for name in NAMES:
            file = next((cls.folder / "one").glob(f"{name}_*.deb"))
            call("dpkg-deb", "-x", file, cls.root)
            cls.fields[name] = dict(re.findall(r"^(\S+): (.*)$", call("dpkg-deb", "-f", file), re.M))

    @classmethod
    def place(cls, name):
        path = cls.folder / f"temporary_{name}"
        path.mkdir()
        return str(path)

    def test_the_same_build_gives_the_same_bytes_whoever_packs_it(self):
        sums = [(self.folder / out / "SHA256SUMS").read_text() for out in ("one", "two")]
        self.assertEqual(sums[0], sums[1])
        self.assertEqual(len(sums[0].splitlines()), len(NAMES) + (SOURCE / ".git").exists())
        call("sha256sum", "--check", "SHA256SUMS", cwd=self.folder / "one")

    def test_a_second_build_is_compared_byte_by_byte(self):
        loader = importlib.machinery.SourceFileLoader("package", str(SOURCE / "tools/package"))
        package = importlib.util.module_from_spec(importlib.util.spec_from_loader("package", loader))
        loader.exec_module(package)
        if not list(BUILD.glob("python/wythe/_wythe.cpython-*.so")):
            self.skipTest("the build has no Python module")
        one, two = (package.digests(BUILD, self.folder / out) for out in ("one", "two"))
        self.assertEqual(package.compared(one, two), [])
        self.assertLessEqual({"wythe"} | {p.name for p in (self.folder / "one").glob("*.deb")}, set(one))
        self.assertEqual(package.compared(one, {**two, "wythe": "other"}), ["wythe"])
        self.assertEqual(package.compared(one, {name: sum_ for name, sum_ in two.items() if name != "wythe"}), ["wythe"])

    def test_no_file_holds_a_path_of_the_machine(self):
        for file in [p for p in self.root.rglob("*") if p.is_file()]:
            found = [place for place in (str(SOURCE), str(BUILD), str(self.folder)) if place.encode() in file.read_bytes()]
            self.assertEqual(found, [], file)

    def test_every_file_has_the_time_of_the_commit(self):
        for file in self.root.rglob("*"):
            if not file.is_dir():
                self.assertEqual(int(file.lstat().st_mtime), int(EPOCH), file)

    def test_the_program_needs_no_python(self):
        self.assertNotIn("python", self.fields["wythe"]["Depends"])
        self.assertNotIn("libwythe1", self.fields["wythe"]["Depends"])
        version = call(self.root / "usr/bin/wythe", "--version")
        self.assertIn(self.fields["wythe"]["Version"], version)
        model = self.root / "usr/share/doc/wythe/examples/brick_pier/model.toml"
        self.assertIn("blocks", call(self.root / "usr/bin/wythe", "check", model, env={"PATH": "/nowhere"}))

    def test_the_man_page_and_the_completion_know_every_command(self):
        import gzip
        page = gzip.decompress((self.root / "usr/share/man/man1/wythe.1.gz").read_bytes()).decode()
        text = (self.root / "usr/share/bash-completion/completions/wythe").read_text()
        words = call("bash", "-c", f'. "{self.root}/usr/share/bash-completion/completions/wythe"; COMP_WORDS=(wythe "") COMP_CWORD=1; _wythe; '
                     'echo "${COMPREPLY[@]}"').split()
        for command in ("run", "check", "campaign", "merge", "replay", "report", "limit", "store", "export", "status", "compare", "new"):
            self.assertIn(f".SS wythe {command}\n", page)
            self.assertIn(command, words)
            self.assertIn(f"    {command}) options=", text)

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_c_compiles_against_what_was_unpacked(self):
        library = next(self.root.glob("usr/lib/*/libwythe.so")).parent
        program = self.folder / "a.c"
        program.write_text("#include <wythe/wythe.h>\n#include <stdio.h>\n"
                           "int main(void) { puts(wythe_version()); return wythe_interface() != WYTHE_INTERFACE; }\n")
        call("cc", program, f"-I{self.root}/usr/include", f"-L{library}", "-lwythe", "-o", self.folder / "a")
        said = call(self.folder / "a", env=dict(os.environ, LD_LIBRARY_PATH=str(library)))
        self.assertIn(self.fields["libwythe1"]["Version"], said)
        self.assertEqual(self.fields["libwythe-dev"]["Depends"], f"libwythe1 (= {said.split()[1]})")
        self.assertIn("libwythe.so.1", call("readelf", "-d", self.folder / "a"))

    def test_python_imports_what_was_unpacked(self):
        place = self.root / "usr/lib/python3/dist-packages"
        if not list(place.glob("wythe/_wythe*.so")):
            self.skipTest("the build has no Python module")
        said = call("/usr/bin/python3", "-c", "import wythe, importlib.metadata as m; print(wythe.__file__, wythe.__version__, m.version('wythe'))",
                    env=dict(os.environ, PYTHONPATH=str(place), PYTHONDONTWRITEBYTECODE="1"), cwd=self.folder)
        file, here, told = said.split()
        self.assertTrue(file.startswith(str(place)), file)
        self.assertEqual(here, told)


if __name__ == "__main__":
    if not (BUILD / "wythe").exists():
        print(f"no build in {BUILD}")
        sys.exit(77)
    unittest.main(verbosity=1)
