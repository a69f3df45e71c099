"""Builds a commit a second time and says which bytes differ, and where (tools/package --rebuild, --against).

The second build lies in a folder of its own and stays there until its bytes are the same: an interrupted one goes on, and one
that differs can be looked at. Nothing of the first build reaches it: no compiler cache, no settings, another path.
"""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from release import call, git, plain

TARGETS = ("wythe_cli", "wythe_c", "wythe_python")


def digest(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


# --- where two files differ --------------------------------------------------------------------------

def first_difference(a, b):
    """(place, bytes of a there, bytes of b there), or None."""
    if a == b:
        return None
    place = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
    start = max(0, place - 16)
    return place, a[start:place + 48], b[start:place + 48]


def sections(file):
    """Name and bytes of each section of a binary."""
    data, found = file.read_bytes(), {}
    for name, kind, offset, size in re.findall(r"^\s*\[\s*\d+\]\s(\S+)\s+(\S+)\s+[0-9a-f]+\s+([0-9a-f]+)\s+([0-9a-f]+)\s",
                                               call("readelf", "--wide", "--sections", file), re.M):
        found[name] = b"" if kind == "NOBITS" else data[int(offset, 16):int(offset, 16) + int(size, 16)]
    return found


def in_binary(a, b):
    one, two = sections(a), sections(b)
    names = [name for name in {**one, **two} if one.get(name) != two.get(name)]
    if not names:
        return ["no section differs: the headers do, or what is between sections"]
    place, here, there = first_difference(one.get(names[0], b""), two.get(names[0], b""))
    sizes = ", ".join(f"{name} ({len(one.get(name, b''))} and {len(two.get(name, b''))} bytes)" for name in names)
    return [f"sections that differ: {sizes}", f"first: {names[0]} at byte {place}", f"  {here!r}", f"  {there!r}"]


def in_folder(a, b):
    """Differences of two unpacked archives: names, rights, links, times and content."""
    lines = []
    one, two = ({str(p.relative_to(folder)): p for p in sorted(folder.rglob("*"))} for folder in (a, b))
    for name in sorted(one.keys() | two.keys()):
        if name not in one or name not in two:
            lines.append(f"{name}: only in the {'first' if name in one else 'second'}")
            continue
        x, y = one[name], two[name]
        for what, value in (("mode", lambda p: oct(p.lstat().st_mode)), ("time", lambda p: int(p.lstat().st_mtime)),
                            ("link", lambda p: os.readlink(p) if p.is_symlink() else "")):
            if value(x) != value(y):
                lines.append(f"{name}: {what} {value(x)} and {value(y)}")
        if x.is_file() and y.is_file() and not x.is_symlink() and not y.is_symlink() and digest(x) != digest(y):
            lines += [f"{name}: {line}" for line in differences(x, y)]
    return lines or ["the same files: order, owners or compression differ"]


def unpack(file, folder):
    folder.mkdir()
    if file.suffix == ".deb":
        call("dpkg-deb", "--raw-extract", file, folder)
    else:
        call("tar", "--extract", "--same-permissions", "--gzip", f"--file={file}", f"--directory={folder}")
    return folder


def differences(a, b):
    """Lines that say how two files of one name differ; none where their bytes are the same."""
    if digest(a) == digest(b):
        return []
    start = a.read_bytes()[:4]
    if start == b"\x7fELF" and b.read_bytes()[:4] == start:
        return in_binary(a, b)
    if a.suffix == ".deb" or a.name.endswith(".tar.gz"):
        with tempfile.TemporaryDirectory() as temporary:
            return in_folder(*(unpack(file, pathlib.Path(temporary) / side) for file, side in ((a, "first"), (b, "second"))))
    place, here, there = first_difference(a.read_bytes(), b.read_bytes())
    return [f"at byte {place}", f"  {here!r}", f"  {there!r}"]


def compared(first, again, report=None):
    """Prints which files are the same, which differ and how, and which one side lacks; the names of the latter two."""
    lines, different = [], []
    for name in sorted(first | again):
        if name not in first or name not in again:
            different.append(name)
            lines.append(f"DIFFERS  {name}: only in the {'first' if name in first else 'second'} build")
        elif said := differences(first[name], again[name]):
            different.append(name)
            lines += [f"DIFFERS  {digest(first[name])} {digest(again[name])}  {name}", *(f"    {line}" for line in said)]
        else:
            lines.append(f"same     {digest(first[name])}  {name}")
    print("\n".join(lines), flush=True)
    if report is not None:
        report.write_text("\n".join(lines) + "\n")
    return different


# --- two builds --------------------------------------------------------------------------------------

def files_of(build, packages):
    """Name and place of the binaries and of what their packages' SHA256SUMS lists; a listed file is there and has its sum."""
    found = {"wythe": build / "wythe", "libwythe.so": (build / "libwythe.so").resolve(),
             **{"_wythe.so": p for p in sorted((build / "python/wythe").glob("_wythe.cpython-*.so"))}}
    for line in (packages / "SHA256SUMS").read_text().splitlines():
        stated, name = line.split("  ", 1)
        if digest(packages / name) != stated:
            sys.exit(f"{packages / name} has another sum than SHA256SUMS states: pack again")
        found[name] = packages / name
    return {name: file for name, file in found.items() if file.exists()}


def compare_builds(release, out, other, pack):
    if other.commit != release.commit:
        sys.exit(f"{other.build} is of commit {other.commit[:12]}, {release.build} of {release.commit[:12]}: only builds of one commit can be the same")
    with tempfile.TemporaryDirectory() as packages:
        pack(pathlib.Path(packages))
        return compared(files_of(release.build, out), files_of(other.build, pathlib.Path(packages)), out / "compared.txt")


def clone(root, commit, folder):
    """The commit in a folder of its own; one that an interrupted build left is taken as it is, if it is that commit unchanged."""
    if folder.exists():
        head, changes = git(folder, "rev-parse", "HEAD"), git(folder, "status", "--porcelain", "--untracked-files=no")
        if head is None or head.decode().strip() != commit or changes:
            sys.exit(f"{folder} is no unchanged {commit[:12]}: remove it, or name another with --again")
        print(f"goes on in {folder}", flush=True)
        return
    part = folder.with_name(folder.name + ".part")
    shutil.rmtree(part, ignore_errors=True)
    part.parent.mkdir(parents=True, exist_ok=True)
    call("git", "clone", "--quiet", "--no-checkout", root, part)
    call("git", "-C", part, "checkout", "--quiet", "--detach", commit)
    os.rename(part, folder)


def build_again(root, commit, folder, jobs, level):
    """Clones, compiles and packs in the folder; each step that is done is not done again."""
    clone(root, commit, folder)
    environment = {name: value for name, value in plain().items()
                   if not name.startswith(("CCACHE", "CMAKE", "SOURCE_DATE")) and name not in ("CFLAGS", "CXXFLAGS", "CPPFLAGS", "LDFLAGS", "CC", "CXX")}
    environment["CCACHE_DISABLE"] = "1"
    for command in (["cmake", "--preset", "release"],
                    ["cmake", "--build", "build/release", "-j", str(jobs), "--target", *TARGETS],
                    [str(folder / "tools/package"), "--build", str(folder / "build/release"), "--out", str(folder / "packages"), "--level", str(level)]):
        log = folder.with_name(folder.name + ".log")
        with log.open("a") as said:
            done = subprocess.run(command, cwd=folder, env=environment, stdout=said, stderr=subprocess.STDOUT, check=False)
        if done.returncode:
            sys.exit(f"the second build ended at {' '.join(command[:2])} (exit {done.returncode}); what it said is in {log}. "
                     f"What is built is kept in {folder}: the same command goes on")


def rebuild(release, out, folder, jobs, level):
    """Names of what differs after a second whole build, in a folder whose path has another length."""
    folder = folder.resolve()
    if any(name == "dirty" for name, _ in release.faults):
        sys.exit("the sources differ from the commit; commit them first: what is built again is the commit")
    if len(str(folder)) == len(str(release.root)) or (folder.exists() and folder.samefile(release.root)):
        sys.exit(f"{folder} has a path as long as {release.root}: name a longer one with --again")
    build_again(release.root, release.commit, folder, jobs, level)
    different = compared(files_of(release.build, out), files_of(folder / "build/release", folder / "packages"), out / "compared.txt")
    if different:
        print(f"both builds are kept: {release.build} and {folder / 'build/release'}", flush=True)
    else:
        shutil.rmtree(folder)
        folder.with_name(folder.name + ".log").unlink(missing_ok=True)
    return different
