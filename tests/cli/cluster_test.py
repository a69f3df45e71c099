#!/usr/bin/env python3
"""Campaigns as arrays of Slurm: the scripts, what is left to run, and a cluster of one node that runs them."""
import os
import pathlib
import re
import shutil
import signal
import socket
import sqlite3
import subprocess
import tempfile
import time
import unittest

from campaign_test import Base
from cli_test import SOURCE, WYTHE, wythe

PROGRAM = pathlib.Path(WYTHE).resolve()
LONG = 600  # [s], for what does not come: no test waits for a time


def wait_for(event, what):
    end = time.monotonic() + LONG
    while time.monotonic() < end:
        found = event()
        if found:
            return found
        time.sleep(0.1)
    raise AssertionError(f"{what}: not within {LONG} s")


class Scripts(Base):
    """Without a cluster: the scripts are run as Slurm would."""

    def written(self, *more, out=None):
        done = wythe("campaign", self.study, "--out", out or self.out(), "--slurm", "3", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def run_task(self, task, out=None):
        script = (out or self.out()) / "slurm" / "array.sh"
        return subprocess.run(["sh", script], env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(task)),
                              capture_output=True, text=True, check=False)

    def join(self, out=None):
        done = subprocess.run(["sh", (out or self.out()) / "slurm" / "merge.sh"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_tasks_and_their_join_give_the_bytes_of_the_whole(self):
        said = self.written("--cores", "1")
        self.assertIn("3 of 3 tasks have samples left: 1-3", said)
        for task in (3, 1, 2):
            self.assertEqual(self.run_task(task).returncode, 0)
        self.join()
        self.assert_equals_whole(self.out())
        self.assertIn("all samples have run", self.written("--cores", "1"))
        self.assertNotIn("--array", (self.out() / "slurm/array.sh").read_text())

    def test_only_what_is_missing_is_handed_in_again(self):
        self.written()
        self.run_task(2)
        self.assertIn("2 of 3 tasks have samples left: 1,3", self.written())
        self.assertIn("#SBATCH --array=1,3\n", (self.out() / "slurm/array.sh").read_text())
        done = wythe("status", self.out())
        self.assertEqual(done.returncode, 3)
        self.assertIn("shard 2: 2 of 2 samples", done.stdout)
        self.assertIn("shard 1, not begun: 0 of 2 samples", done.stdout)
        self.assertIn("all: 2 of 6 samples", done.stdout)

    def test_another_number_of_tasks_does_not_mix_with_shards_that_ran(self):
        self.written()
        self.run_task(1)
        done = wythe("campaign", self.study, "--out", self.out(), "--slurm", "2")
        self.refused(done, 2, "--slurm", "shards/1, which is one of 3 shards", "write --slurm 3")
        shard = self.out() / "shards/2"  # by hand
        wythe("campaign", self.study, "--out", shard, "--shard", "2/2", "--quiet")
        self.refused(wythe("status", self.out()), 2, "one of 2 shards", "no campaign")

    def test_array_that_waits_is_no_fault(self):
        self.written()
        done = wythe("status", self.out())
        self.assertEqual((done.returncode, done.stdout), (3, "no task of the array has begun\n"))

    def test_joined_folder_takes_late_shards_in(self):
        self.written()
        self.run_task(1)
        self.assertIn("4 samples are in none of these shards", self.join().stderr)
        self.run_task(2)
        self.run_task(3)
        self.join()
        self.assert_equals_whole(self.out())

    def test_more_samples_later_are_more_work_for_each_task(self):
        self.written()
        for task in (1, 2, 3):
            self.run_task(task)
        self.join()
        self.assertIn("3 of 3 tasks", self.written("--samples", "9"))
        for task in (1, 2, 3):
            self.assertEqual(self.run_task(task).returncode, 0)
        self.join()
        whole = self.folder / "nine"
        shutil.copytree(self.whole, whole)
        self.assertEqual(self.resume(whole, "--samples", "9").returncode, 0)
        self.assertEqual((self.out() / "samples.csv").read_bytes(), (whole / "samples.csv").read_bytes())

    def test_names_with_blanks_and_quotes_reach_the_program_whole(self):
        odd = self.folder / "my 'odd' $(touch x) study.toml"
        odd.write_text(self.study.read_text())
        out = self.folder / "an odd; folder"
        done = wythe("campaign", odd, "--out", out, "--slurm", "3", "--set", "stage.push.until=0.8 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.run_task(1, out).returncode, 0)
        self.assertFalse((self.folder / "x").exists())
        self.assertIn("2 of 2", wythe("status", out).stdout)

    def test_several_studies_share_an_array(self):
        other = self.folder / "other.toml"
        other.write_text(self.study.read_text().replace("seed = 7", "seed = 8"))
        done = wythe("campaign", self.study, other, "--out", self.out(), "--slurm", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        for task in (1, 2, 3, 4):
            self.assertEqual(self.run_task(task).returncode, 0)
        self.join()
        self.assert_equals_whole(self.out() / "study")
        self.assertNotEqual((self.out() / "other/samples.csv").read_bytes(),
                            (self.whole / "samples.csv").read_bytes())

    def test_submit_hands_in_array_and_join(self):
        fake = self.folder / "bin"
        fake.mkdir()
        (fake / "sbatch").write_text('#!/bin/sh\necho "$@" >> "$0.log"\nif [ "$1" = --parsable ]; then echo "17;c"; fi\n')
        (fake / "sbatch").chmod(0o755)
        environment = dict(os.environ, PATH=f"{fake}:{os.environ['PATH']}")
        arguments = [WYTHE, "campaign", self.study, "--out", self.out(), "--slurm", "2", "--submit"]
        done = subprocess.run(arguments, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((fake / "sbatch.log").read_text().splitlines(),
                         ["--parsable array.sh", "--dependency=afterany:17 merge.sh 17"])
        (fake / "sbatch").write_text("#!/bin/sh\necho 'Invalid partition' >&2\nexit 1\n")
        done = subprocess.run(arguments, env=environment, capture_output=True, text=True, check=False)
        self.refused(done, 4, "Slurm did not take the jobs", "submit.sh")

    def test_what_slurm_would_read_otherwise_is_refused(self):
        def said(*more):
            return wythe("campaign", self.study, "--out", self.out(), *more)
        self.refused(said("--slurm", "7"), 2, "--slurm", "more than the 6 samples", "fewer tasks")
        self.refused(said("--slurm", "0"), 2, "--slurm", "whole number from 1 to 1000")
        self.refused(said("--slurm", "2", "--partition", "a b\n#SBATCH --mem=0"), 2, "--partition")
        self.refused(said("--slurm", "2", "--shard", "1/2"), 2, "--shard", "leave it out")
        self.refused(said("--slurm", "2", "--until", "relative_interval(peak_reaction) < 1 %"), 2,
                     "sees only its own")
        self.refused(said("--cores", "2"), 2, "--cores", "for --slurm alone")
        self.refused(wythe("campaign", self.study, self.study, "--out", self.out()), 2, "second study")
        self.refused(wythe("campaign", self.study, self.study, "--out", self.out(), "--slurm", "2"), 2,
                     "name of another study")
        self.refused(wythe("status", self.folder / "nowhere"), 2, "holds no campaign")
        self.assertFalse(self.out().exists())


class Stores(Base):
    """wythe store: whole ones, damaged ones, and what is saved of them."""

    def spoil(self, place, length=16):
        store = self.copy()
        data = bytearray(store.read_bytes())
        data[place:place + length] = bytes(b ^ 0xFF for b in data[place:place + length])
        store.write_bytes(data)

    def test_whole_store_is_whole(self):
        done = wythe("store", "check", self.whole)
        self.assertEqual((done.returncode, done.stdout), (0, f"{self.whole}: whole\n"))

    def test_damaged_states_and_curves_are_found_and_the_other_samples_saved(self):
        with sqlite3.connect(self.copy()) as store:
            store.execute("UPDATE curve SET data = substr(data, 1, 20) || zeroblob(8) || substr(data, 29) "
                          "WHERE sample = 2")
            store.execute("UPDATE state SET data = substr(data, 1, length(data) - 5) || zeroblob(5) WHERE sample = 4")
        store.close()
        self.refused(wythe("store", "check", self.out()), 4, "sample 2", "store rescue")
        saved = self.folder / "saved"
        done = wythe("store", "rescue", self.out(), "--out", saved)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4 samples kept, 2 lost", done.stdout)
        self.assertRegex(done.stdout, r"sample 2 is lost: .*curve")
        self.assertRegex(done.stdout, r"sample 4 is lost: .*state")
        self.assertEqual(wythe("store", "check", saved).returncode, 0)
        self.assertEqual(self.resume(saved).returncode, 0)
        self.assert_equals_whole(saved)

    def test_damaged_pages_cost_the_samples_on_them_alone(self):
        size = (self.whole / "campaign.db").stat().st_size
        kept = []
        for k in range(1, 8):
            self.spoil(size * k // 8, 512)
            code = wythe("store", "check", self.out()).returncode
            saved = self.folder / f"saved_{k}"
            done = wythe("store", "rescue", self.out(), "--out", saved)
            self.assertIn(done.returncode, (0, 4), done.stderr)
            for raw in ("terminate", "what()", "std::"):
                self.assertNotIn(raw, done.stdout + done.stderr)
            if done.returncode == 0:
                self.assertEqual(wythe("store", "check", saved).returncode, 0)
                kept.append(int(re.search(r"(\d+) samples kept", done.stdout).group(1)))
                if code == 0:
                    self.assertEqual(kept[-1], 6)
            shutil.rmtree(self.out())
        self.assertTrue(any(0 < n for n in kept), kept)

    def test_a_damaged_study_is_taken_from_its_file(self):
        with sqlite3.connect(self.copy()) as store:
            store.execute("UPDATE study SET value = '0.1' WHERE key = 'load_height_m'")
        store.close()
        saved = self.folder / "saved_by_study"
        self.refused(wythe("store", "rescue", self.out(), "--out", saved), 4, "--study FILE", "nothing was saved")
        self.refused(wythe("store", "rescue", self.out(), "--out", saved, "--study", self.study, "--seed", 999), 2,
                     "draws none of the 6 samples", "nothing was written")
        self.assertFalse(saved.exists())
        done = wythe("store", "rescue", self.out(), "--out", saved, "--study", self.study)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("6 samples kept, 0 lost", done.stdout)
        self.assert_equals_whole(saved)

    def test_status_and_check_leave_no_trace_of_a_killed_campaign(self):
        with sqlite3.connect(self.copy(), isolation_level=None) as store:  # as a writer that ends by force leaves it
            store.execute("PRAGMA journal_mode = WAL")
            store.execute("PRAGMA wal_autocheckpoint = 0")
            store.execute("UPDATE study SET value = value")
            killed = self.folder / "left_by_force"
            shutil.copytree(self.out(), killed)
        store.close()
        listed = {p.name: p.read_bytes() for p in killed.iterdir()}
        self.assertIn("campaign.db-wal", listed)
        for command in (["status", killed], ["store", "check", killed], ["merge", killed, "--out", self.folder / "merged_of_left"],
                        ["replay", killed, "--sample", 1, "--out", self.folder / "replayed_of_left", "--quiet"]):
            done = wythe(*command)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual({p.name: p.read_bytes() for p in killed.iterdir()}, listed, command)

    def test_what_is_no_store_is_not_rescued(self):
        self.copy().write_bytes(b"no database at all" * 1000)
        self.refused(wythe("store", "check", self.out()), 4, "store")
        self.refused(wythe("store", "rescue", self.out(), "--out", self.folder / "none"), 4, "campaign.db")
        self.assertFalse((self.folder / "none").exists())
        self.refused(wythe("store", "rescue", self.whole, "--out", self.whole), 2, "holds a campaign already")


CONF = (SOURCE / "tests/data/slurm.conf").read_text()


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Cluster:
    """Slurm on this machine, with a configuration, ports and folders of its own."""

    def __init__(self, folder):
        self.folder, self.munge = folder, None
        host = socket.gethostname().split(".")[0]
        conf = folder / "slurm.conf"
        conf.write_text(CONF.format(host=host, folder=folder, port=free_port(), node_port=free_port()))
        self.environment = dict(os.environ, SLURM_CONF=str(conf))
        self.address = None

    def call(self, *command, **options):
        return subprocess.run([str(c) for c in command], env=self.environment, capture_output=True,
                              text=True, check=False, timeout=LONG, **options)

    def start(self):
        """Returns why it cannot be had, or None."""
        if not pathlib.Path("/run/munge/munge.socket.2").exists():
            self.call("install", "-d", "-o", "munge", "-g", "munge", "-m", "755", "/run/munge")
            done = self.call("runuser", "-u", "munge", "--", "munged")
            if done.returncode != 0:
                return "munge does not start: " + done.stderr.strip()
            self.munge = pathlib.Path("/run/munge/munged.pid")
        routes = self.call("ip", "-4", "addr", "show", "scope", "global").stdout
        if "inet " not in routes:  # with loopback alone Slurm's clients find no address at all
            self.address = "10.99.0.1/32"
            self.call("ip", "addr", "add", self.address, "dev", "lo")
        for daemon in ("slurmctld", "slurmd"):
            done = self.call(daemon, "-f", self.environment["SLURM_CONF"], "-c")
            if done.returncode != 0:
                return f"{daemon} does not start: {done.stderr.strip()}"
        try:
            wait_for(lambda: "idle" in self.call("sinfo", "-h", "-o", "%T").stdout, "an idle node")
        except AssertionError as late:
            return str(late)
        return None

    def stop(self):
        """Ends with the daemons: until then they write into the folder."""
        files = [self.folder / name for name in ("ctl.pid", "d.pid")]
        alive = [pathlib.Path("/proc", file.read_text().strip()) for file in files if file.exists()]
        self.call("scontrol", "shutdown")
        wait_for(lambda: not any(process.exists() for process in alive), "the end of Slurm")
        if self.munge is not None:
            try:
                os.kill(int(self.munge.read_text()), signal.SIGTERM)
            except (OSError, ValueError):
                pass
        if self.address:
            self.call("ip", "addr", "del", self.address, "dev", "lo")


class RealSlurm(Base):
    """An array of four over 24 samples on a cluster of one node; a task is told to stop and handed in again."""
    study_text = Base.study_text.replace("samples = 6", "samples = 24")

    def setUp(self):
        for program in ("slurmctld", "slurmd", "sbatch", "munged", "ip"):
            if shutil.which(program) is None:
                self.skipTest(f"needs {program}, which is not installed")
        if os.geteuid() != 0:
            self.skipTest("needs root to start Slurm")
        self.cluster = Cluster(self.folder)
        self.addCleanup(self.cluster.stop)
        why = self.cluster.start()
        if why:
            self.skipTest(why)

    def state_of(self, job):
        return self.cluster.call("squeue", "-h", "-j", job, "-o", "%T").stdout.strip()

    def test_array_with_a_task_that_gives_way_equals_the_campaign_here(self):
        # the first time, task 2 takes one sample after the other, and waits after its second until it is told to stop
        pipe, wrapper = self.folder / "pipe", self.folder / "program"
        os.mkfifo(pipe)
        wrapper.write_text(f"""#!/bin/sh
if [ "$SLURM_ARRAY_TASK_ID" = 2 ] && [ -z "$SLURM_RESTART_COUNT" ]; then
  WYTHE_LANES=1 WYTHE_TEST_HOLD="sample 2" exec {PROGRAM} "$@" <> {pipe}
fi
exec {PROGRAM} "$@"
""")
        wrapper.chmod(0o755)
        self.cluster.environment["WYTHE"] = str(wrapper)
        done = self.cluster.call(WYTHE, "campaign", self.study, "--out", self.out(), "--slurm", "4",
                                 "--cores", "1", "--submit")
        self.assertEqual(done.returncode, 0, done.stderr)
        array = re.search(r"array job (\d+)", done.stdout).group(1)
        self.assertRegex(done.stdout, r"Submitted batch job \d+")
        log = self.out() / "slurm/2.log"
        wait_for(lambda: log.exists() and "held at sample 2" in log.read_text(), "the second sample of task 2")
        said = wythe("status", self.out()).stdout
        self.assertRegex(said, r"shard 2: [12] of 6 samples, process \d+ on \S+ writes")
        done = self.cluster.call("scontrol", "requeue", f"{array}_2")
        self.assertEqual(done.returncode, 0, done.stderr)
        wait_for(lambda: self.state_of(f"{array}_2") == "PENDING", "task 2 back in the queue")
        self.assertIn("of 6 samples are stored", log.read_text())  # it stored what it had, in time
        self.cluster.call("scontrol", "update", f"JobId={array}_2", "StartTime=now")
        wait_for(lambda: not self.cluster.call("squeue", "-h").stdout.strip(), "the array, and the join of all of it")
        self.assert_equals_whole(self.out())
        self.assertIn("all: 24 of 24 samples", wythe("status", self.out()).stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
