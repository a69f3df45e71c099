#!/usr/bin/env python3
"""Failures of the disk in a campaign, a merge and a run: each call that changes a file fails once, in turn. Also a clock that jumps.

A library that is preloaded (tests/faults/broken_disk.c) counts the calls below the folder of results and lets one of them fail: by an error of the
disk, by a disk that is full from there on, by the end of the process before it, or by a loss of power, which takes what was not
synchronised. After any failure the program reports it in its own words, or its
results are complete. The same command then continues to the bytes of an undisturbed one.

Of each way to fail it takes every sixteenth call (of a run every eighth), each way beginning at another one. With WYTHE_LONG=1 (make test-long) it takes all.
"""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from cli_test import SMALL, SOURCE, WYTHE

BLOCKS = ('{"units": "m", "blocks": [{"id": "base", "polygon": [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]},'
          '{"id": "ledge", "polygon": [[0.08, 0.2], [0.48, 0.2], [0.48, 0.4], [0.08, 0.4]]}]}')
MODEL = ('wall = { blocks = "blocks.json", thickness = "0.2 m", unit = { density = "2000 kg/m^3" } }\n'
         'stage = [{ name = "push", at = { x = "0.08 m", y = "0.3 m" }, direction = "+x", velocity = "5 mm/s", ramp = "1 ms", until = "0.01 mm" }]\n'
         "output = { rows = 10 }\n" + SMALL[SMALL.index("[material.joint]"):SMALL.index("[material.unit]")])
STUDY = ('[study]\nmodel = "model.toml"\nsamples = 3\nseed = 3\nstates = ["0.005 mm"]\nread_modes_at = "0.005 mm"\n[variable.ft]\n'
         'path = "material.joint.tensile_strength"\nunit = "MPa"\ndistribution = "uniform"\nlow = "10 kPa"\nhigh = "30 kPa"\n')
LONG = "WYTHE_LONG" in os.environ
RAW = re.compile(r"std::|basic_|bad_alloc|SQLITE_|json\.exception|terminate called|filesystem error|HDF5-DIAG")


class BrokenDisk(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        for name, text in (("blocks.json", BLOCKS), ("model.toml", MODEL), ("study.toml", STUDY)):
            (cls.folder / name).write_text(text)
        cls.library = cls.folder / "broken_disk.so"
        subprocess.run(["gcc", "-shared", "-fPIC", "-O1", "-o", cls.library, pathlib.Path(SOURCE) / "tests/faults/broken_disk.c", "-ldl"], check=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def run_(self, *command, at=None, how="EIO", under=None):
        """Runs wythe in the folder; the call number `at` below `under` fails."""
        environment = dict(os.environ)
        if under is not None:
            environment.update(LD_PRELOAD=str(self.library), BROKEN_DISK_UNDER=str(under), BROKEN_DISK_HOW=how, BROKEN_DISK_COUNT=str(self.folder / "count"))
            if at is not None:
                environment["BROKEN_DISK_AT"] = str(at)
        return subprocess.run([os.path.abspath(WYTHE), *map(str, command)], cwd=self.folder, capture_output=True, text=True, errors="replace", check=False,
                              env=environment, timeout=120)

    def whole(self, folder, names):
        return {name: (folder / name).read_bytes() if (folder / name).exists() else None for name in names}

    def each_call(self, what, command, names, clear, out, every=16):
        """The command with its calls failing in turn, each time followed by the same command undisturbed."""
        clear()
        done = self.run_(*command, under=out)
        self.assertEqual(done.returncode, 0, done.stderr)
        calls = int((self.folder / "count").read_text())
        self.assertGreater(calls, 5, what)
        good = self.whole(out, names)
        self.assertEqual([name for name, text in good.items() if text is None], [], what)
        told, step = 0, 1 if LONG else every
        for first, how in enumerate(("EIO", "POWER", "FULL", "KILL"), 1):
            for at in range(1 + 3 * first % step, calls + 1, step):
                clear()
                done = self.run_(*command, at=at, how=how, under=out)
                case = f"{what}: call {at} of {calls}, {how}: exit {done.returncode}\n{done.stderr}"
                self.assertNotRegex(done.stderr, RAW, case)
                if how in ("KILL", "POWER"):
                    self.assertEqual(done.returncode, -9, case)
                else:
                    self.assertIn(done.returncode, (0, 4), case)
                    if done.returncode == 0:
                        self.assertTrue(self.whole(out, names) == good, case)
                        continue
                    self.assertIn(str(self.folder), done.stderr, case)  # the place
                    told += 1
                then = self.run_(*command)
                self.assertEqual(then.returncode, 0, f"{case}\nthen: {then.stderr}")
                self.assertTrue(self.whole(out, names) == good, f"{case}\nthen: {then.stderr}")
        self.assertGreater(told, calls // step, what)  # of two ways
        print(f"{what}: {calls} calls, {told} errors told")

    def test_a_clock_that_jumps_changes_nothing(self):
        """In a campaign that is stopped and resumed, a check and a merge: the bytes are those under a steady clock. Files of all ages lie there."""
        library, count = self.folder / "jumping_clock.so", self.folder / "jumps"
        subprocess.run(["gcc", "-shared", "-fPIC", "-O1", "-o", library, pathlib.Path(SOURCE) / "tests/faults/jumping_clock.c", "-ldl"], check=True)
        steady = self.folder / "steady"
        self.assertEqual(self.run_("campaign", "study.toml", "--out", steady, "--jobs", 1, "--quiet").returncode, 0)

        environment = dict(os.environ, LD_PRELOAD=str(library), JUMPING_CLOCK_COUNT=str(count))
        subprocess.run(["date"], check=True, capture_output=True, env=environment)
        self.assertGreater(count.stat().st_size, 0)  # who asks for the time of day is counted
        count.unlink()

        def jumping(*command):
            done = subprocess.run([os.path.abspath(WYTHE), *map(str, command)], cwd=self.folder, capture_output=True, text=True, check=False, env=environment)
            self.assertEqual((done.returncode, done.stderr), (0, ""), command)
            return done.stdout

        shards = [self.folder / f"jumping_{k}" for k in (1, 2)]
        for k, shard in enumerate(shards, 1):
            jumping("campaign", "study.toml", "--shard", f"{k}/2", "--out", shard, "--jobs", 1, "--quiet")
            for path in shard.iterdir():
                os.utime(path, (0, 0) if k == 1 else (4102444800, 4102444800))  # 1970, 2100
            jumping("campaign", "study.toml", "--shard", f"{k}/2", "--out", shard, "--jobs", 1, "--quiet", "--resume")
            self.assertIn("whole", jumping("store", "check", shard))
        out = self.folder / "joined_under_jumps"
        jumping("merge", *shards, "--out", out)
        jumping("report", out)
        for name in ("samples.csv", "statistics.json"):
            self.assertEqual((out / name).read_bytes(), (steady / name).read_bytes(), name)
        self.assertFalse(count.exists(), "the program asks for the time of day")

    def test_a_campaign_goes_on(self):
        out = self.folder / "campaign"
        command = ["campaign", "study.toml", "--out", out, "--jobs", 1, "--quiet", "--resume"]
        self.each_call("campaign", command, ["samples.csv", "statistics.json"], lambda: shutil.rmtree(out, ignore_errors=True), out)
        self.assertEqual(self.run_("store", "check", out).returncode, 0)

    def test_a_merge_goes_on(self):
        shards = [self.folder / f"shard_{k}" for k in (1, 2)]
        for k, shard in enumerate(shards, 1):
            done = self.run_("campaign", "study.toml", "--shard", f"{k}/2", "--out", shard, "--jobs", 1, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
        out = self.folder / "merged"
        self.each_call("merge", ["merge", *shards, "--out", out], ["samples.csv"], lambda: shutil.rmtree(out, ignore_errors=True), out)

    def test_a_run_is_whole_or_not_there(self):
        out = self.folder / "run"
        self.each_call("run", ["run", "model.toml", "--out", out], ["force_displacement.csv", "model.used.toml"], lambda: shutil.rmtree(out, ignore_errors=True), out,
                       every=8)


if __name__ == "__main__":
    unittest.main(verbosity=1)
