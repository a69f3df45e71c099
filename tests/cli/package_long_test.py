#!/usr/bin/env python3
"""make package, then its packages in a new, minimal Debian: each works there, and removing them leaves nothing (make test-long). Skipped
where there is no root, no network or no mmdebstrap."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])).resolve()
PACKAGES = ["libwythe-dev", "libwythe1", "python3-wythe", "wythe"]
# What runs in the new Debian, with the packages in it.
INSIDE = """set -e
wythe --version
wythe check /usr/share/doc/wythe/examples/brick_pier/model.toml
python3 -c 'import wythe, importlib.metadata; assert wythe.__version__ == importlib.metadata.version("wythe")'
test -e /usr/lib/*/libwythe.so -a -e /usr/include/wythe/c.h
gzip -dc /usr/share/man/man1/wythe.1.gz | grep -q campaign
apt-get purge -q -y libwythe1 libwythe-dev python3-wythe wythe >/dev/null
find /usr /etc -name '*wythe*' | grep . && exit 1
echo all gone
"""


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = subprocess.run(["make", "package"], cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        assert done.returncode == 0, done.stdout[-5000:]
        cls.files = sorted((SOURCE / "build/package").glob("*.deb"))

    def test_each_package_has_its_files_and_no_place_of_the_build(self):
        self.assertEqual([file.name.split("_")[0] for file in self.files], PACKAGES)
        with tempfile.TemporaryDirectory() as folder:
            for file in self.files:
                subprocess.run(["dpkg-deb", "-x", file, folder], check=True)
            found = [p for p in pathlib.Path(folder).rglob("*") if p.is_file() and not p.is_symlink() and b"build/package/wythe" in p.read_bytes()]
            self.assertEqual(found, [])

    def test_each_works_in_a_new_debian_and_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "inside.sh"
            script.write_text(INSIDE)
            done = subprocess.run(["mmdebstrap", "--variant=apt", "--hook-dir=/usr/share/mmdebstrap/hooks/file-mirror-automount",
                                   *(f"--include={file}" for file in self.files), f"--customize-hook=copy-in {script} /root",
                                   '--customize-hook=chroot "$1" sh /root/inside.sh', "bookworm", "/dev/null"], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-5000:])
        self.assertRegex(done.stdout, re.compile(r"^all gone$", re.M))


if __name__ == "__main__":
    if os.geteuid() or not shutil.which("apt-get") or not (SOURCE / ".git").exists():
        print("needs root, Debian and the repository")
        sys.exit(77)
    unittest.main(verbosity=1)
