"""Installs the packages in a new, minimal Debian, uses, upgrades and removes them (tools/package --check)."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from release import call

INSTALL = "apt-get -o APT::Sandbox::User=root install -q -y --no-install-recommends"
ONLY_OLDER, ONLY_NEWER = "/usr/share/doc/wythe/only_in_the_older", "/usr/share/zsh/vendor-completions/_wythe"
EXAMPLES = "/usr/share/doc/wythe/examples"
# What a system writes while packages come and go, whoever's they are; all else has to be as it was.
LIVING = ("/var/cache/", "/var/lib/", "/var/log/", "/etc/ld.so.cache", "/tmp/", "/proc/", "/sys/", "/dev/", "/run/", "/root/")
COMPLETE = ("_complete() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _wythe; echo \"${COMPREPLY[*]}\"; }; "
            ". /usr/share/bash-completion/completions/wythe; ")


def cannot(why):
    print(f"skipped: {why}", flush=True)
    sys.exit(77)


def older(packages, folder):
    """The same packages as an earlier version: one file more in the program's, one less."""
    made = []
    for file in packages:
        tree = pathlib.Path(folder) / file.name.split("_")[0]
        call("dpkg-deb", "--raw-extract", file, tree)
        control = (tree / "DEBIAN/control").read_text()
        version = re.search(r"^Version: (.*)$", control, re.M).group(1)
        (tree / "DEBIAN/control").write_text(control.replace(version, "0.0.9-1"))
        if tree.name == "wythe":
            (tree / ONLY_OLDER[1:]).write_text("gone with the next version\n")
            (tree / ONLY_NEWER[1:]).unlink()
            (tree / "DEBIAN/md5sums").unlink()
        made.append(pathlib.Path(folder) / f"{tree.name}_0.0.9-1_all.deb")
        call("dpkg-deb", "--root-owner-group", "-Znone", "--build", tree, made[-1])
    return made


def debian(root):
    """A new Debian 12 with man and bash-completion."""
    if os.geteuid() != 0:
        cannot("a new Debian needs root: sudo tools/package --check")
    if shutil.which("mmdebstrap") is None:
        cannot("needs mmdebstrap: tools/setup deps/package.txt")
    done = subprocess.run(["mmdebstrap", "--variant=apt", "--dpkgopt=force-unsafe-io", "--include=man-db,bash-completion", "bookworm", str(root)], check=False,
                          capture_output=True, text=True, errors="replace")
    if done.returncode:
        cannot("mmdebstrap could not make a Debian: " + "; ".join(done.stderr.strip().splitlines()[-3:]))
    shutil.copy("/etc/resolv.conf", root / "etc/resolv.conf")


def commands(names, old):
    """(what it shows, command, pattern that its words have to match)."""
    every = " ".join(names.values())
    check_all = " ".join(names)
    return [
        ("the program alone", f"{INSTALL} {names['wythe']} >/dev/null; ! command -v python3", ""),
        ("its version", "wythe --version; dpkg-query -W wythe", r"wythe \d"),
        ("its libraries", "! ldd /usr/bin/wythe | grep 'not found'", ""),
        ("the manual page", "man -P cat wythe | col -b | head -400", r"wythe store rescue"),
        ("no fault of the manual page", "test -z \"$(man --warnings -E UTF-8 -l /usr/share/man/man1/wythe.1.gz 2>&1 >/dev/null)\"", ""),
        ("a run", f"wythe run {EXAMPLES}/brick_pier/model.toml --out /tmp/pier --quiet", r"\d"),
        ("a campaign", f"wythe campaign {EXAMPLES}/tuff_wall/study.toml --out /tmp/tuff --samples 2 --quiet", r"\d"),
        ("every model and study is read", f"for f in {EXAMPLES}/*/model.toml {EXAMPLES}/*/study.toml; do wythe check $f >/dev/null || exit 1; echo $f; done", "stone_house"),
        ("stores of older versions", "for s in /tmp/data/store_v*.db; do d=/tmp/$(basename $s .db); mkdir $d; cp $s $d/campaign.db; "
         "wythe report $d || exit 1; done", r"store_v5"),
        ("completion of commands", COMPLETE + "_complete wythe ca", "^campaign$"),
        ("completion as bash loads it", ". /usr/share/bash-completion/bash_completion; _completion_loader wythe; complete -p wythe", "_wythe"),
        ("completion of options and values", COMPLETE + "_complete wythe run --q; _complete wythe report DIR --lang ''; _complete wythe store ''",
         r"--quiet\nen it\ncheck rescue"),
        ("the program is removed", "apt-get purge -q -y wythe >/dev/null; ! test -e /usr/bin/wythe && ! test -e /usr/share/doc/wythe", ""),
        ("all packages, of an older version", f"{INSTALL} {' '.join(old)} gcc libc6-dev >/dev/null; dpkg-query -W wythe && test -e {ONLY_OLDER} && ! test -e {ONLY_NEWER}",
         r"0\.0\.9-1"),
        ("upgrade", f"{INSTALL} {every} >/dev/null; ! test -e {ONLY_OLDER} && test -e {ONLY_NEWER} && dpkg-query -W wythe && ! dpkg-query -W {check_all} | grep 0.0.9",
         r"wythe\s+\d"),
        ("C", "printf '#include <wythe/wythe.h>\\n#include <stdio.h>\\nint main(void) { puts(wythe_version()); return 0; }' "
         ">/tmp/a.c && gcc /tmp/a.c -lwythe -o /tmp/a && /tmp/a", r"wythe \d"),
        ("Python", f"python3 -c 'import wythe; print(wythe.run(\"{EXAMPLES}/brick_pier/model.toml\").summary[\"peak_reaction_kN\"])'", r"\d"),
        ("nothing of a package is changed", f"dpkg -V {check_all}; test -z \"$(dpkg -V {check_all})\"", ""),
        ("all removed", f"apt-get purge -q -y {check_all} >/dev/null; ! dpkg-query -W {check_all} 2>/dev/null", ""),
    ]


def listing(root):
    """Every path of the new system that packages answer for."""
    found = set()
    for folder, folders, files in os.walk(root):
        here = "/" + os.path.relpath(folder, root).removeprefix(".") + "/"
        here = re.sub("/+", "/", here)
        folders[:] = [name for name in folders if not f"{here}{name}/".startswith(LIVING)]
        found.update(f"{here}{name}" for name in [*folders, *files] if not f"{here}{name}".startswith(LIVING))
    return found


def check(packages, data):
    """Uses the program alone in a new, minimal Debian; then the others; upgrades and removes them."""
    with tempfile.TemporaryDirectory() as temporary:
        root = pathlib.Path(temporary) / "root"
        debian(root)
        old = older(packages, temporary)
        for file in [*packages, *old]:
            shutil.copy(file, root / "tmp")
        (root / "tmp/data").mkdir()
        for store in sorted(data.glob("store_v*.db")):
            shutil.copy(store, root / "tmp/data")
        environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C.UTF-8",
                       **{name: value for name, value in os.environ.items() if name.lower().endswith("_proxy")}}

        def inside(command):
            return subprocess.run(["chroot", str(root), "bash", "-c", command], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  stdin=subprocess.DEVNULL, text=True, errors="replace", check=False)
        if (done := inside("apt-get update -q")).returncode:
            cannot("no network for the new Debian: " + done.stdout.strip()[-300:])
        before = listing(root)
        names = {p.name.split("_")[0]: f"/tmp/{p.name}" for p in packages}
        for what, command, pattern in commands(names, [f"/tmp/{p.name}" for p in old]):
            done = inside(command)
            print(f"{what}: $ {command}\n{done.stdout[-1500:]}", flush=True)
            if done.returncode or not re.search(pattern, done.stdout, re.M):
                sys.exit(f"FAILED: {what}: exit {done.returncode}" + (f", expected {pattern}" if pattern else ""))
        inside("apt-get purge -q -y gcc libc6-dev; apt-get autoremove --purge -q -y")
        left = sorted(path for path in listing(root) - before if "wythe" in path)
        others = sorted(path for path in listing(root) - before if "wythe" not in path)
        print(f"left after all were removed: {left or 'nothing'}; of packages they needed: {others[:10] or 'nothing'}", flush=True)
        if left:
            sys.exit(f"FAILED: left after all were removed: {' '.join(left)}")
