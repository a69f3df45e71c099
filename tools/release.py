"""One release: of which commit the program, the library and the Python module of a build are, and that commit's files.

A package vouches that what it holds is what it says. So everything in it comes from one commit: the binaries say which they
were built from, and documents, examples, headers and Python sources are read from that commit, not from the folder as it is
now. What does not fit together is refused (tools/package).
"""
import datetime
import gzip
import io
import os
import pathlib
import re
import subprocess
import sys
import tarfile

FLAGS = "-O3 -DNDEBUG -ffp-contract=off"  # of the preset "release"
PROVENANCE = re.compile(r"wythe (\S+) \((\w+)(-dirty)?, ([^,]*), (\w*)(?:, (.*)|;.*)?\)")
TOOLS = ("tools/package", "tools/release.py", "tools/program_help.py", "tools/shell_words.py")
# prints the provenance of a library or a Python module without the rest of the package
ASK_LIBRARY = "import ctypes, sys; f = ctypes.CDLL(sys.argv[1]).wythe_version; f.restype = ctypes.c_char_p; print(f().decode())"
ASK_MODULE = """import importlib.machinery, importlib.util, sys
loader = importlib.machinery.ExtensionFileLoader("_wythe", sys.argv[1])
module = importlib.util.module_from_spec(importlib.util.spec_from_loader("_wythe", loader))
loader.exec_module(module)
print(module.version)"""


def plain(environment=None):
    """An environment in which no language, no time zone and no other repository changes what a tool says."""
    kept = {name: value for name, value in (environment or os.environ).items()
            if not name.startswith(("LC_", "GIT_")) and name not in ("LANG", "LANGUAGE", "TZ")}
    return {**kept, "LC_ALL": "C.UTF-8", "TZ": "UTC"}


def call(*command, env=None, **options):
    done = subprocess.run([str(c) for c in command], check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=plain(env),
                          text=True, errors="replace", **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\nexit {done.returncode}: {(done.stderr or done.stdout).strip()[-2000:]}")
    return done.stdout


def git(root, *words):
    """What git says, free of the user's settings that change an archive; None where it refuses."""
    done = subprocess.run(["git", "-C", str(root), "-c", "tar.umask=0022", "-c", "core.autocrlf=false", "-c", "core.attributesFile=/dev/null",
                           *words], check=False, capture_output=True, env=plain())
    return done.stdout if done.returncode == 0 else None


def said_by(file, program):
    """(version, commit, dirty, compiler, build type, flags) of a binary; None where it does not say."""
    if file == program:
        command = [file, "--version"]
    else:
        command = ["/usr/bin/python3", "-c", ASK_MODULE if file.name.startswith("_wythe") else ASK_LIBRARY, file]
    done = subprocess.run(list(map(str, command)), check=False, capture_output=True, text=True, env=plain())
    found = PROVENANCE.match(done.stdout)
    return found.groups() if found else None


class Release:
    """The build, the files of its commit, its version, and one time for every file."""

    def __init__(self, root, build, anyway=False):
        self.root, self.build, self.anyway = root, build.resolve(), anyway
        self.program = self.build / "wythe"
        self.library = (self.build / "libwythe.so").resolve()
        self.module = self.one_module()
        self.faults = []  # what --anyway lets pass, and the version then tells
        self.read_binaries()
        self.find_commit()
        self.compare_tools()
        if self.faults and not anyway:
            sys.exit("\n".join(["no package was made:", *(f"- {said}" for _, said in self.faults),
                                "For a package to try out, which says so in its version: --anyway"]))
        self.version = self.name_version()
        self.debian = f"{self.version}-1"
        self.epoch = self.read_epoch()
        self.date = datetime.datetime.fromtimestamp(self.epoch, datetime.timezone.utc).strftime("%Y-%m-%d")
        self.architecture = call("dpkg", "--print-architecture").strip()
        self.triplet = call("dpkg-architecture", "-qDEB_HOST_MULTIARCH").strip()

    def one_module(self):
        found = sorted((self.build / "python/wythe").glob("_wythe.cpython-*.so"))
        if not self.program.exists() or not self.library.exists():
            sys.exit(f"no package was made: {self.build} has no wythe or no libwythe.so. Build them first: make build")
        if len(found) != 1:
            sys.exit(f"no package was made: {self.build}/python/wythe has {len(found)} modules _wythe.cpython-*.so, and python3-wythe takes one. "
                     "Install pybind11-dev and python3-dev, remove old modules, and build again")
        return found[0]

    def read_binaries(self):
        said = {file.name: said_by(file, self.program) for file in (self.program, self.library, self.module)}
        if (program := said[self.program.name]) is None:
            sys.exit(f"no package was made: {self.program} --version does not say its commit and build type")
        self.upstream, self.short, dirty, compiler, build_type, _ = program
        for name, of in said.items():
            if of is None:
                self.faults.append(("unread", f"{name} can't be loaded, so nobody knows of which commit it is"))
            elif of[:5] != program[:5]:
                sys.exit(f"no package was made: {self.program.name} is of {self.short}{dirty or ''} ({compiler}, {build_type}), {name} of "
                         f"{of[1]}{of[2] or ''} ({of[3]}, {of[4]}). Build all of them: make build")
            elif of[5] not in (None, FLAGS):
                self.faults.append(("flags", f"{name} was compiled with {of[5]}; a release takes {FLAGS}, which runs on any machine"))
        if dirty:
            self.faults.append(("dirty", f"the program was built from {self.short} with changes that are in no commit: commit them, and build again"))
        if build_type != "Release":
            self.faults.append((build_type.lower() or "untyped", f"the program is a build of type {build_type}; a release is Release"))

    def find_commit(self):
        """The whole name of the commit, its time, and the tag it stands at or after."""
        if (self.root / ".git").exists():
            whole = git(self.root, "rev-parse", "--verify", f"{self.short}^{{commit}}")
            if whole is None:
                sys.exit(f"no package was made: the program is of commit {self.short}, which git does not find in {self.root}. Build again: make build")
            self.commit = whole.decode().strip()
            self.committed = int(git(self.root, "log", "-1", "--format=%ct", self.commit))
            tag = git(self.root, "describe", "--tags", "--match", "v[0-9]*", "--abbrev=40", self.commit)
            self.tag = tag.decode().strip() if tag else ""
        else:
            words = (self.root / "cmake/commit.txt").read_text().split()
            if not re.fullmatch(r"[0-9a-f]{40}", words[0]) or not words[0].startswith(self.short):
                sys.exit(f"no package was made: the program is of commit {self.short}, the sources in {self.root} of {words[0]}. Build again: make build")
            self.commit, self.committed, self.tag = words[0], int(words[1]), " ".join(words[2:])

    def compare_tools(self):
        """The tools that pack are those of the commit too: others would give other bytes."""
        tar = self.archive()
        if tar is None:
            return
        with tarfile.open(fileobj=io.BytesIO(tar)) as packed:
            for name in TOOLS:
                path = next((m for m in packed.getmembers() if m.name.split("/", 1)[-1] == name), None)
                if path is None or packed.extractfile(path).read() != (self.root / name).read_bytes():
                    self.faults.append(("tools", f"{name} is not the one of {self.short}, which the program was built from: build again"))

    def name_version(self):
        """0.1.0 at the tag v0.1.0 alone; before it 0.1.0~git..., which sorts below, after it 0.1.0+git..., which sorts above."""
        faults = "".join(f".{name}" for name in sorted({re.sub(r"\W", "", name) for name, _ in self.faults}))
        if self.tag == f"v{self.upstream}" and not faults:
            return self.upstream
        when = datetime.datetime.fromtimestamp(self.committed, datetime.timezone.utc).strftime("%Y%m%d.%H%M%S")
        after = "+" if self.tag.split("-")[0] == f"v{self.upstream}" else "~"
        return f"{self.upstream}{after}git{when}.{self.commit[:7]}{faults}"

    def read_epoch(self):
        said = os.environ.get("SOURCE_DATE_EPOCH", "").strip()
        if said and not said.isdecimal():
            sys.exit(f"no package was made: SOURCE_DATE_EPOCH is {said!r}; give seconds since 1970, or leave it away to take the commit's time")
        return int(said) if said else self.committed

    def archive(self):
        """The commit as a tar; None in an unpacked archive and for changed sources, which are in no commit."""
        if not (self.root / ".git").exists() or any(name == "dirty" for name, _ in self.faults):
            return None
        return git(self.root, "archive", "--format=tar", f"--prefix=wythe-{getattr(self, 'version', '')}/", self.commit)

    def sources(self, folder):
        """Where the files of the commit lie: unpacked in a folder; as they are where there is no commit to take them from."""
        if (tar := self.archive()) is None:
            return self.root
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        subprocess.run(["tar", "--extract", "--no-same-owner", f"--directory={folder}"], input=tar, check=True)
        return pathlib.Path(folder) / f"wythe-{self.version}"

    def tracked(self, tree, below):
        """Files of a folder of the sources, without what a run left in them."""
        if tree == self.root and (self.root / ".git").exists():
            return sorted(tree / name for name in git(tree, "ls-files", "-z", below).decode().split("\0") if name)
        return sorted(p for p in (tree / below).rglob("*") if p.is_file() and "__pycache__" not in p.parts)


def gzipped(data, level=9):
    return gzip.compress(data, level, mtime=0)
