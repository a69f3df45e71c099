#!/usr/bin/env python3
"""The Debian packages: the same bytes twice, what is in each, and that each works from where it is unpacked. Installing them in a
new Debian: package_root_test.py. What is refused: release_test.py. Completion and manual page: completion_test.py."""
import gzip
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
# Another folder, time zone, language, user's git settings, rights, and, where root may ask for it, user. The clock differs anyway.
OTHER = {"TZ": "Pacific/Auckland", "LC_ALL": "it_IT.UTF-8", "LANGUAGE": "it", "COLUMNS": "40"}
SETTINGS = "[tar]\n\tumask = 0077\n[core]\n\tautocrlf = true\n[safe]\n\tdirectory = *\n"


def call(*command, **options):
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    assert done.returncode == 0, (command, done.stdout[-3000:])
    return done.stdout


def owner_of(path):
    """The package that a file of the system belongs to."""
    return subprocess.run(["dpkg", "-S", path], check=False, capture_output=True, text=True).stdout.split(":")[0]


def may_read(user):
    """Whether another user may read the sources and the build; then that user packs the second time."""
    return os.geteuid() == 0 and subprocess.run(["test", "-x", str(BUILD / "wythe"), "-a", "-r", str(SOURCE / "tools/package")], user=user,
                                                check=False).returncode == 0


@unittest.skipUnless(all(shutil.which(p) for p in ("dpkg-deb", "dpkg-shlibdeps", "git")), "needs Debian's tools")
class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.folder.chmod(0o755)
        said = call(BUILD / "wythe", "--version")
        cls.upstream, cls.commit = re.match(r"wythe (\S+) \((\w+)", said).groups()
        cls.pack("one", {}, 0o022, None)
        home = cls.folder / "two"
        home.mkdir()
        (home / ".gitconfig").write_text(SETTINGS)
        (home / "old.deb").write_text("of an older release")
        (home / "SHA256SUMS").write_text("0  old.deb\n")
        user = 65534 if may_read(65534) else None
        if user:
            for path in (home, home / "SHA256SUMS"):
                os.chown(path, user, user)
        cls.pack("two", {**OTHER, "HOME": str(home)}, 0o077, user)
        cls.root = cls.folder / "root"
        cls.fields = {}
        for name in NAMES:
            file = next((cls.folder / "one").glob(f"{name}_*.deb"))
            call("dpkg-deb", "-x", file, cls.root)
            cls.fields[name] = dict(re.findall(r"^(\S+): (.*)$", call("dpkg-deb", "-f", file), re.M))

    @classmethod
    def pack(cls, out, environment, mask, user):
        """As a user would, but whatever state the sources are in: a test packs what a release refuses."""
        temporary = cls.folder / f"temporary_{out}"
        temporary.mkdir()
        temporary.chmod(0o777)
        clean = {name: value for name, value in os.environ.items() if name != "SOURCE_DATE_EPOCH"}
        call("/usr/bin/python3", "-B", SOURCE / "tools/package", "--anyway", "--build", BUILD, "--out", cls.folder / out, "--level", 0,
             env={**clean, **environment, "TMPDIR": str(temporary)}, preexec_fn=lambda: os.umask(mask) and None, user=user, cwd=cls.folder)

    def packages(self):
        return sorted((self.folder / "one").glob("*.deb"))

    def test_the_same_build_gives_the_same_bytes_whoever_packs_it(self):
        sums = [(self.folder / out / "SHA256SUMS").read_text() for out in ("one", "two")]
        self.assertEqual(sums[0], sums[1])

    def test_the_sums_list_every_file_and_an_older_release_is_gone(self):
        for out in ("one", "two"):
            place = self.folder / out
            listed = {line.split("  ")[1] for line in (place / "SHA256SUMS").read_text().splitlines()}
            there = {p.name for p in place.iterdir() if p.name not in ("SHA256SUMS", ".gitconfig")}
            self.assertEqual(listed, there)
            self.assertEqual(sum(name.endswith(".deb") for name in listed), len(NAMES))
            call("sha256sum", "--check", "--strict", "SHA256SUMS", cwd=place)

    def test_the_sources_and_all_packages_are_of_the_programs_commit(self):
        versions = {self.fields[name]["Version"] for name in NAMES}
        self.assertEqual(len(versions), 1)
        for name in NAMES:
            log = gzip.decompress((self.root / f"usr/share/doc/{name}/changelog.Debian.gz").read_bytes()).decode()
            self.assertIn(f"Built from commit {self.commit}", log)
            self.assertTrue((self.root / f"usr/share/doc/{name}/copyright").read_text().startswith("Format: https://www.debian.org"))
        for archive in (self.folder / "one").glob("*.tar.gz"):
            place = archive.name.removesuffix(".tar.gz")
            self.assertTrue(call("tar", "xOf", archive, f"{place}/cmake/commit.txt").startswith(self.commit))
            self.assertEqual({line.split("/")[0] for line in call("tar", "tf", archive).splitlines()}, {place})

    def test_a_development_build_sorts_below_the_release(self):
        version = self.fields["wythe"]["Version"]
        if "~" in version or "+" in version:
            call("dpkg", "--compare-versions", version, "lt" if "~" in version else "gt", f"{self.upstream}-1")
            self.assertIn(self.commit[:7], version)
        else:
            self.assertEqual(version, f"{self.upstream}-1")

    def test_owners_rights_and_sums_of_the_files_are_those_of_a_package(self):
        for file in self.packages():
            place = self.folder / f"control_{file.stem}"
            call("dpkg-deb", "-e", file, place)
            summed = {line.split("  ")[1] for line in (place / "md5sums").read_text().splitlines()}
            call("md5sum", "--check", "--strict", place / "md5sums", cwd=self.root)
            files = set()
            for line in call("dpkg-deb", "-c", file).splitlines():
                rights, owner, name = line.split()[0], line.split()[1], line.split(maxsplit=5)[5]
                self.assertEqual(owner, "root/root", line)
                if not rights.startswith("l"):
                    expected = "drwxr-xr-x" if name.endswith("/") else "-rwxr-xr-x" if "/bin/" in name else "-rw-r--r--"
                    self.assertEqual(rights, expected, line)
                    files |= set() if name.endswith("/") else {name.removeprefix("./")}
            self.assertEqual(summed, files)
            for script in ("postinst", "prerm"):
                if (place / script).exists():
                    self.assertEqual((place / script).stat().st_mode & 0o777, 0o755)
            self.assertFalse((place / "conffiles").exists())

    def test_every_library_that_is_loaded_comes_with_a_package_that_is_asked_for(self):
        known = call("/sbin/ldconfig", "-p")
        for name, pattern in (("wythe", "usr/bin/wythe"), ("libwythe1", "usr/lib/*/libwythe.so.0*"), ("python3-wythe", "usr/lib/python3/*/wythe/_wythe*.so")):
            asked = {part.split()[0] for part in self.fields[name]["Depends"].split(", ")}
            binary = next(self.root.glob(pattern))
            needed = re.findall(r"NEEDED.*\[(.*)\]", call("readelf", "-d", binary, env=dict(os.environ, LC_ALL="C")))
            self.assertGreater(len(needed), 5)
            for library in needed:
                if not library.startswith("ld-linux"):
                    path = pathlib.Path(re.search(rf"\s{re.escape(library)} .*=> (\S+)", known).group(1)).resolve()
                    # /lib is a link to /usr/lib on a Debian of today, and dpkg knows either name
                    owners = [owner for place in (str(path), str(path).removeprefix("/usr")) if (owner := owner_of(place))]
                    self.assertTrue(asked & set(owners), (library, owners, asked))

    @unittest.skipUnless(shutil.which("lintian"), "needs lintian: tools/setup deps/package.txt")
    def test_debians_own_checks_find_no_fault(self):
        # no bug of Debian asks for this package, as long as it is not in Debian
        said = call("lintian", "--allow-root", "--fail-on=error,warning", "--suppress-tags=initial-upload-closes-no-bugs", *self.packages())
        self.assertNotRegex(said, r"(?m)^[EW]:")

    def test_no_file_holds_a_path_of_the_machine(self):
        for file in [p for p in self.root.rglob("*") if p.is_file()]:
            found = [place for place in (str(SOURCE), str(BUILD), str(self.folder)) if place.encode() in file.read_bytes()]
            self.assertEqual(found, [], file)

    def test_every_file_has_the_time_of_the_commit(self):
        if (SOURCE / ".git").exists():
            epoch = call("git", "-C", SOURCE, "log", "-1", "--format=%ct", self.commit)
        else:
            epoch = (SOURCE / "cmake/commit.txt").read_text().split()[1]
        for file in self.root.rglob("*"):
            if not file.is_dir():
                self.assertEqual(int(file.lstat().st_mtime), int(epoch), file)

    def test_every_example_is_there(self):
        place = self.root / "usr/share/doc/wythe/examples"
        models = {p.parent.name for p in (SOURCE / "examples").glob("*/model.toml")}
        self.assertEqual({p.parent.name for p in place.glob("*/model.toml")}, models)
        self.assertTrue((place / "README.md").exists())
        for page in ("docs/upgrading.md", "docs/reference/model.md", "README.md"):
            self.assertTrue((place.parent / page).exists(), page)

    def test_the_program_needs_no_python(self):
        self.assertNotIn("python", self.fields["wythe"]["Depends"])
        self.assertNotIn("libwythe1", self.fields["wythe"]["Depends"])
        self.assertIn(self.commit, call(self.root / "usr/bin/wythe", "--version"))
        model = self.root / "usr/share/doc/wythe/examples/brick_pier/model.toml"
        self.assertIn("blocks", call(self.root / "usr/bin/wythe", "check", model, env={"PATH": "/nowhere"}))

    def test_the_manual_page_and_the_completions_are_the_tools_own(self):
        share = self.root / "usr/share"
        for option, name in (("--bash", "bash-completion/completions/wythe"), ("--zsh", "zsh/vendor-completions/_wythe"),
                             ("--fish", "fish/vendor_completions.d/wythe.fish")):
            self.assertEqual((share / name).read_text(), call(SOURCE / "tools/command_line", BUILD / "wythe", option))
        page = gzip.decompress((share / "man/man1/wythe.1.gz").read_bytes()).decode()
        made = call(SOURCE / "tools/command_line", BUILD / "wythe", "--man")
        self.assertEqual(page.splitlines()[1:], made.splitlines()[1:])
        self.assertRegex(page.splitlines()[0], r'^\.TH WYTHE 1 "\d{4}-\d\d-\d\d" "wythe \S+" "User Commands"$')

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_c_compiles_against_what_was_unpacked(self):
        library = next(self.root.glob("usr/lib/*/libwythe.so")).parent
        program = self.folder / "a.c"
        program.write_text("#include <wythe/wythe.h>\n#include <stdio.h>\n"
                           "int main(void) { puts(wythe_version()); return wythe_interface() != WYTHE_INTERFACE; }\n")
        call("cc", program, f"-I{self.root}/usr/include", f"-L{library}", "-lwythe", "-o", self.folder / "a")
        said = call(self.folder / "a", env=dict(os.environ, LD_LIBRARY_PATH=str(library)))
        self.assertIn(self.commit, said)
        self.assertEqual(self.fields["libwythe-dev"]["Depends"], f"libwythe1 (= {self.fields['libwythe1']['Version']})")
        self.assertIn("libwythe.so.1", call("readelf", "-d", self.folder / "a"))

    def test_python_imports_what_was_unpacked(self):
        place = self.root / "usr/lib/python3/dist-packages"
        said = call("/usr/bin/python3", "-c", "import wythe, importlib.metadata as m; print(wythe.__file__, wythe.__version__, m.version('wythe'))",
                    env=dict(os.environ, PYTHONPATH=str(place), PYTHONDONTWRITEBYTECODE="1"), cwd=self.folder)
        file, here, told = said.split()
        self.assertTrue(file.startswith(str(place)), file)
        self.assertEqual(here, told)


if __name__ == "__main__":
    if not (BUILD / "wythe").exists() or not list(BUILD.glob("python/wythe/_wythe.cpython-*.so")):
        print(f"no build of the program and the Python module in {BUILD}")
        sys.exit(77)
    unittest.main(verbosity=1)
