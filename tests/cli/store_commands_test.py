#!/usr/bin/env python3
"""wythe status lists the running processes and the remaining samples of a folder; wythe store check finds damage."""
import fcntl
import os
import re
import shutil
import sqlite3
import unittest

from campaign_test import Base
from cli_test import Held, wythe


def remove(path):
    shutil.rmtree(path) if path.is_dir() else path.unlink()


def tree(folder):
    """Every file below a folder with its bytes, but SQLite's scratch file of shared memory."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*"))
            if p.is_file() and not p.name.endswith("-shm")}


def hold_lock(test, folder, words):
    """Holds the lock of a store as a process would that runs it, until the test ends."""
    file = (folder / "campaign.lock").open("w")
    test.addCleanup(file.close)
    file.write(words)
    file.flush()
    fcntl.flock(file, fcntl.LOCK_EX)
    return file


class Status(Base):
    """wythe status, with stores that are made up: who runs, what is left."""

    def setUp(self):
        done = wythe("campaign", self.study, "--out", self.out(), "--slurm", "3")
        self.assertEqual(done.returncode, 0, done.stderr)

    def fill(self, shard, done, seconds, failed=0):
        """So many samples of a shard, of so many seconds each; the last ones without an answer."""
        samples = [s for s in range(shard, 7, 3)][:done]
        with sqlite3.connect(self.out() / f"shards/{shard}/campaign.db") as store:
            columns = [c[1] for c in store.execute("PRAGMA table_info(sample)")]
            for k, sample in enumerate(samples):
                values = {"sample": sample, "wall_seconds": seconds,
                          "status": "unstable" if k >= done - failed else "completed"}
                known = [c for c in columns if c in values]
                store.execute(f"INSERT INTO sample ({', '.join(known)}) VALUES ({', '.join('?' * len(known))})",
                              [values[c] for c in known])
        store.close()

    def locked(self, shard, words="process 17 on node9\n4 workers\n"):
        return hold_lock(self, self.out() / f"shards/{shard}", words)

    def said(self):
        before = tree(self.out())
        done = wythe("status", self.out())
        self.assertEqual(tree(self.out()), before)
        return done

    def test_lines_and_sum(self):
        self.fill(1, 2, 600, failed=1)
        self.fill(2, 1, 1200)
        self.locked(2)
        done = self.said()
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stdout.splitlines(), [
            "shard 1: 2 of 2 samples, 1 without an answer",
            "shard 2: 1 of 2 samples, process 17 on node9 writes with 4 workers; about 5 min left",
            "shard 3: 0 of 2 samples, not begun; about 27 min of one core left",
            "all: 3 of 6 samples, 1 without an answer, 1 running, 1 not running; about 10 min left with the workers that run"])

    def test_sum_when_nobody_runs(self):
        self.fill(1, 1, 600)
        self.assertEqual(self.said().stdout.splitlines()[-1],
                         "all: 1 of 6 samples, 3 not running; about 50 min of one core left")

    def test_end_is_no_earlier_than_that_of_the_slowest_shard(self):
        self.fill(1, 1, 60)
        self.fill(2, 1, 36000)
        self.locked(1, "process 1 on a\n8 workers\n")
        self.locked(2, "process 2 on b\n1 workers\n")
        said = self.said().stdout
        self.assertIn("shard 2: 1 of 2 samples, process 2 on b writes with 1 worker; about 10 h left", said)
        self.assertIn("about 10 h left with the workers that run", said)

    def test_lock_of_another_program_or_version_tells_no_workers(self):
        self.fill(1, 1, 600)
        for text in ("process 1 on a\n", "process 1 on a\nmany workers\n", "", "process 1 on a\n-5 workers\n"):
            file = self.locked(1, text)
            self.assertIn("writes; about 10 min of one core left", self.said().stdout)
            file.close()

    def test_finished_array(self):
        for shard in (1, 2, 3):
            self.fill(shard, 2, 60)
        done = self.said()
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, "all: 6 of 6 samples"))

    def test_a_store_that_cannot_be_read_has_its_line_beside_the_others(self):
        self.fill(1, 2, 600)
        self.fill(3, 1, 600)
        store = self.out() / "shards/2/campaign.db"
        whole = store.read_bytes()
        for damage in (b"no database at all" * 500, whole[:5000], whole[:16] + b"\0" * 84 + whole[100:], b"", b"S", os.mkfifo, os.mkdir):
            remove(store)
            if callable(damage):
                damage(store)
            else:
                store.write_bytes(damage)
            done = self.said()
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertEqual(done.stdout.splitlines(), [
                "shard 1: 2 of 2 samples",
                "shard 2: not counted, 2 samples",
                "shard 3: 1 of 2 samples, not running; about 10 min of one core left",
                "all: 3 of 6 samples, 1 not running, 1 not counted; about 30 min of one core left"])
            for words in (str(store), "1 of 3 stores not counted"):
                self.assertIn(words, done.stderr)
            self.refused(wythe("store", "check", self.out()), 4, f"{store}: is ")
        remove(store)
        store.write_bytes(whole)
        for shard in (1, 2, 3):  # none reads: nothing tells how many there are
            (self.out() / f"shards/{shard}/campaign.db").write_bytes(b"no database at all" * 500)
        done = self.said()
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(done.stdout.splitlines()[:3], [f"shard {s}: not counted" for s in (1, 2, 3)])

    def test_a_shard_that_is_not_there_or_in_another_ones_folder_or_has_not_grown_is_missing(self):
        for shard in (1, 2, 3):
            self.fill(shard, 2, 60)
        last = lambda: self.said().stdout.splitlines()[-1]
        self.assertEqual(last(), "all: 6 of 6 samples")
        first, second = (self.out() / f"shards/{s}" for s in (1, 2))
        shutil.move(first, self.folder / "kept")
        self.assertIn("all: 4 of 6 samples, 1 not running", last())
        shutil.copytree(second, first)  # a copy of the second in its place
        done = self.said()
        self.assertIn("all: 4 of 6 samples, 1 not counted", done.stdout)
        self.assertEqual(done.returncode, 4)
        self.assertIn("is shard 2 of 3, in the folder of shard 1", done.stderr)
        shutil.rmtree(first)
        shutil.move(self.folder / "kept", first)
        alien = wythe("campaign", self.study, "--samples", "12", "--out", self.folder / "alien")  # 1/1, where 1/3 should be
        self.assertEqual(alien.returncode, 0, alien.stderr)
        shutil.move(first, self.folder / "kept")
        shutil.move(self.folder / "alien", first)
        done = self.said()
        self.assertEqual(done.stdout.splitlines()[0], "shard 1: not counted, 2 samples")
        self.assertIn("all: 4 of 6 samples, 1 not counted", done.stdout)
        self.assertIn("is one of 1 shards, most others of 3", done.stderr)
        shutil.rmtree(first)
        other = wythe("campaign", self.study, "--seed", "8", "--shard", "1/3", "--out", first)  # the right number, but another study
        self.assertEqual(other.returncode, 0, other.stderr)
        done = self.said()
        self.assertEqual((done.returncode, done.stdout.splitlines()[0]), (4, "shard 1: not counted, 2 samples"))
        self.assertIn("of another study", done.stderr)
        shutil.rmtree(first)
        shutil.move(self.folder / "kept", first)
        grown = wythe("campaign", self.study, "--samples", "9", "--shard", "3/3", "--resume", "--out", self.folder / "grown")
        self.assertEqual(grown.returncode, 0, grown.stderr)
        shutil.rmtree(self.out() / "shards/3")
        shutil.move(self.folder / "grown", self.out() / "shards/3")
        self.assertIn("all: 7 of 9 samples, 2 not running", last())
        self.assertEqual(self.said().returncode, 3)

    def test_a_store_that_cannot_be_read_is_not_left_out_of_a_join_or_of_an_array(self):
        store = self.out() / "shards/2/campaign.db"
        store.write_bytes(b"no database at all" * 500)
        self.refused(wythe("merge", self.out(), "--out", self.folder / "joined"), 4, str(store))
        self.assertFalse((self.folder / "joined/campaign.db").exists())
        self.refused(wythe("campaign", self.study, "--out", self.out(), "--slurm", "3"), 4, str(store))
        self.assertEqual(store.read_bytes(), b"no database at all" * 500)

    def test_journal_of_a_killed_task_is_left_as_it_is(self):
        held = Held("sample 1", "campaign", self.study, "--out", self.out() / "shards/1", "--shard", "1/3", "--resume",
                    "--stored", "--jobs", "1", "--quiet")
        running = self.said().stdout
        self.assertRegex(running, r"shard 1: 1 of 2 samples, process \d+ on \S+ writes with 1 worker; about ")
        held.kill()
        self.assertTrue((self.out() / "shards/1/campaign.db-wal").exists())
        self.assertIn("shard 1: 1 of 2 samples, not running", self.said().stdout)
        self.assertEqual(self.resume(self.out() / "shards/1", "--shard", "1/3").returncode, 0)


class StatusOfOptions(Base):
    """An array of a study with [[variant]]: each option of each shard counts, there or not."""
    study_text = Base.study_text + """
[[variant]]
name = "heavy"
set = ['wall.unit.density = "2300 kg/m^3"']
"""

    def test_every_option_of_every_shard_counts(self):
        done = wythe("campaign", self.study, "--out", self.out(), "--slurm", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        last = lambda: wythe("status", self.out()).stdout.splitlines()[-1]
        whole = last()
        self.assertIn("all: 0 of 12 samples, 6 not running", whole)
        for gone in ("2/heavy", "2"):
            shutil.move(self.out() / "shards" / gone, self.folder / "kept")
            self.assertEqual(last(), whole, gone)
            shutil.move(self.folder / "kept", self.out() / "shards" / gone)
        shutil.copytree(self.out() / "shards/2/heavy", self.out() / "shards/2/heavy.bad")  # a copy by hand
        self.assertEqual(last(), whole)
        self.assertEqual(wythe("campaign", self.study, "--out", self.out(), "--slurm", "3").returncode, 0)
        for place in ("2/heavy", "2/base"):
            store = self.out() / "shards" / place / "campaign.db"
            kept = store.read_bytes()
            store.write_bytes(b"no database at all" * 500)
            done = wythe("status", self.out())
            self.assertEqual((done.returncode, len(done.stdout.splitlines())), (4, 7), done.stdout)
            self.assertIn("all: 0 of 12 samples, 5 not running, 1 not counted", done.stdout)
            done = wythe("store", "check", self.out())
            self.assertEqual((done.returncode, len(done.stdout.splitlines())), (4, 5), done.stdout)
            self.assertIn(f"{store}: is ", done.stderr)
            store.write_bytes(kept)


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

    def test_damaged_states_and_curves_are_found_and_the_cure_gives_the_same_campaign(self):
        with sqlite3.connect(self.copy()) as store:
            store.execute("UPDATE curve SET data = substr(data, 1, 20) || zeroblob(8) || substr(data, 29) "
                          "WHERE sample = 2")
            store.execute("UPDATE state SET data = substr(data, 1, length(data) - 5) || zeroblob(5) WHERE sample = 4")
        store.close()
        self.refused(wythe("store", "check", self.out()), 4, "sample 2", "remove it and start the same campaign")
        shutil.rmtree(self.out())
        done = wythe("campaign", self.study, "--out", self.out(), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(wythe("store", "check", self.out()).returncode, 0)
        self.assert_equals_whole(self.out())

    def test_a_store_of_another_version_is_refused_by_every_command(self):
        with sqlite3.connect(self.copy()) as store:
            store.execute("PRAGMA user_version = 7")
        store.close()
        for command in (["store", "check", self.out()], ["report", self.out()], ["merge", self.out(), "--out", self.folder / "merged_of_7"],
                        ["campaign", self.study, "--out", self.out(), "--resume", "--quiet"]):
            self.refused(wythe(*command), 4, "store version 7", "version 1", "run the campaign again")

    def test_check_reads_the_joined_store_of_an_array_too(self):
        array = self.folder / "array"
        for shard in (1, 2):
            done = wythe("campaign", self.study, "--shard", f"{shard}/2", "--out", array / "shards" / str(shard), "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(wythe("merge", array, "--out", array).returncode, 0)
        shutil.copytree(array / "shards/1", array / "shards/1.bak")
        self.assertNotIn("1.bak", wythe("status", array).stdout)
        self.assertEqual(wythe("store", "check", array).returncode, 0)
        with sqlite3.connect(array / "campaign.db") as store:
            store.execute("UPDATE sample SET peak_reaction_N = peak_reaction_N * 2 WHERE sample = 2")
        store.close()
        self.refused(wythe("store", "check", array), 4, "sample 2")

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

    def test_what_is_no_store_is_not_checked(self):
        self.copy().write_bytes(b"no database at all" * 1000)
        self.refused(wythe("store", "check", self.out()), 4, "store")


if __name__ == "__main__":
    unittest.main(verbosity=2)
