#!/usr/bin/env python3
"""Results that were changed: folders of other content, links within them, shards without write permission,
stores with impossible counts. They are refused with their names, in plain words, in little memory."""
import json
import os
import pathlib
import resource
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from campaign_test import MODEL, STUDY  # noqa: E402
from cli_test import SMALL, WYTHE  # noqa: E402

MEMORY = 2_000_000_000  # address space of each command [bytes]
# words of the libraries underneath: who reads them learns neither what is wrong nor what to do
RAW = ("json.exception", "_M_", "std::", "basic_string", "bad_alloc", "what():", "terminate", "nlohmann", "stoul", "stod",
       "filesystem error", "mistake of its own")
NOBODY = 65534


def wythe(*arguments, memory=MEMORY, before=(), **options):
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    return subprocess.run([*before, WYTHE, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          preexec_fn=limit, **options)


class Hostile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.made = pathlib.Path(cls.temporary.name)
        os.chmod(cls.made, 0o755)
        (cls.made / "model.toml").write_text(MODEL)
        (cls.made / "study.toml").write_text(STUDY)
        for shard in (1, 2):
            done = wythe("campaign", cls.made / "study.toml", "--samples", 2, "--shard", f"{shard}/2", "--out",
                         cls.made / f"shard{shard}")
            assert done.returncode == 0, done.stderr
        done = wythe("run", cls.made / "model.toml", "--out", cls.made / "run")
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        os.chmod(self.folder, 0o777)

    def copy(self, name):
        return pathlib.Path(shutil.copytree(self.made / name, self.folder / name))

    def refused(self, *arguments, words=(), codes=(2, 4), **options):
        done = wythe(*arguments, **options)
        self.assertIn(done.returncode, codes, (arguments, done.stdout[-500:], done.stderr[-2000:]))
        for word in words:
            self.assertIn(word, done.stderr)
        for word in RAW:
            self.assertNotIn(word, done.stderr, arguments)
        self.assertLess(len(done.stderr), 50_000)
        return done.stderr

    def test_what_is_no_folder_of_results_is_refused_by_every_command(self):
        os.mkfifo(self.folder / "pipe")
        os.mkdir(self.folder / "empty")
        run, shard, out = self.made / "run", self.made / "shard1", self.folder / "out"
        for path in (self.folder / "pipe", "/dev/zero", self.folder / "empty", self.made / "model.toml"):
            for command in (["report", path], ["export", path, "--out", out], ["merge", path, "--out", out],
                            ["merge", shard, path, "--out", out], ["compare", shard, path, "--out", out],
                            ["compare", path, shard, "--out", out], ["replay", path, "--sample", 1, "--out", out],
                            ["status", path], ["store", "check", path],
                            ["limit", self.made / "model.toml", "--with", path, "--out", out],
                            ["picture", path, "--sample", 1, "--out", self.folder / "p.svg"], ["run", "--resume", path]):
                with self.subTest(command=command):
                    self.refused(*command, words=(str(path),))
                    self.assertFalse((out / "campaign.db").exists())
        self.assertTrue(run.exists())

    def test_a_link_for_a_store_is_not_written_through(self):
        mine = self.folder / "mine"
        for command in (["merge", self.made / "shard1", self.made / "shard2"],
                        ["campaign", self.made / "study.toml", "--resume"]):
            for name in ("campaign.db", "campaign.db-wal", "campaign.lock"):
                with self.subTest(command=command, name=name):
                    out = self.folder / "out"
                    os.mkdir(out)
                    os.symlink("../mine", out / name)
                    self.refused(*command, "--out", out, words=(name, "is a link"))
                    self.assertFalse(mine.exists())
                    shutil.rmtree(out)

    def test_a_link_for_a_folder_within_the_results_is_not_followed(self):
        (self.folder / "mine").mkdir()
        (self.folder / "options.toml").write_text(
            STUDY.replace('"model.toml"', f'"{self.made}/model.toml"') +
            '[[variant]]\nname = "soft"\nset = ["material.joint.mode_1_energy=5 N/m"]\n')
        options = self.folder / "options.toml"
        for command, inner in ((["campaign", self.made / "study.toml", "--slurm", 2], "slurm"),
                               (["campaign", self.made / "study.toml", "--slurm", 2], "shards"),
                               (["campaign", options], "base"), (["campaign", options], "soft")):
            with self.subTest(inner=inner):
                out = self.folder / "out"
                os.mkdir(out)
                os.symlink("../mine", out / inner)
                self.refused(*command, "--out", out, words=(inner, "is a link to ../mine"), codes=(2,))
                self.assertEqual(os.listdir(self.folder / "mine"), [])
                shutil.rmtree(out)

    def test_a_shard_that_may_not_be_written_is_merged_as_it_lies(self):
        shards = [self.copy("shard1"), self.copy("shard2")]
        out = self.folder / "out"
        for shard in shards:
            for file in shard.iterdir():
                file.chmod(0o444)
            shard.chmod(0o555)
        as_nobody = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.geteuid() == 0 else {}
        done = wythe("merge", *shards, "--out", out, **as_nobody)
        self.assertEqual(done.returncode, 0, done.stderr)
        whole = wythe("merge", self.made / "shard1", self.made / "shard2", "--out", self.folder / "whole")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        self.assertEqual((out / "samples.csv").read_bytes(), (self.folder / "whole/samples.csv").read_bytes())

    def test_a_shard_whose_journal_cannot_be_read_is_blamed_itself_and_nothing_is_written(self):
        shard, out = self.copy("shard2"), self.folder / "out"
        # as a killed writer leaves it: rows in the journal alone
        database = sqlite3.connect(shard / "campaign.db")
        database.execute("PRAGMA journal_mode = WAL")
        database.execute("UPDATE study SET value = value")
        database.commit()
        shutil.copytree(shard, self.folder / "left")
        database.close()
        left = self.folder / "left"
        self.assertTrue((left / "campaign.db-wal").exists())
        (left / "campaign.db-shm").unlink(missing_ok=True)
        for file in left.iterdir():
            file.chmod(0o444)
        left.chmod(0o555)
        as_nobody = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.geteuid() == 0 else {}
        done = wythe("merge", self.made / "shard1", left, "--out", out, **as_nobody)
        self.assertIn(done.returncode, (0, 4), done.stderr)
        if done.returncode == 4:
            self.assertIn(str(left), done.stderr)
            self.assertNotIn(f"{out}/campaign.db", done.stderr)
            self.assertFalse((out / "campaign.db").exists())

    def test_a_store_of_impossible_counts_is_refused_by_every_command(self):
        for sql in ("UPDATE state SET blocks = blocks * 1000", "UPDATE state SET points = 3", "UPDATE curve SET rows = rows * 2",
                    "UPDATE sample SET sample = 4294967297", "UPDATE sample_input SET position = position + 10"):
            store = self.copy("shard1")
            database = sqlite3.connect(store / "campaign.db")
            database.execute(sql)
            database.commit()
            database.close()
            for command in (["report", store], ["export", store], ["merge", store], ["store", "check", store]):
                out = self.folder / "out"
                if command[0] in ("export", "merge"):
                    command += ["--out", out]
                with self.subTest(sql=sql, command=command[0]):
                    self.addCleanup(shutil.rmtree, out, ignore_errors=True)
                    self.refused(*command, words=("campaign.db", "damaged"), codes=(4,))
                    self.assertFalse((out / "campaign.db").exists())
                    shutil.rmtree(out, ignore_errors=True)
            shutil.rmtree(store)

    def test_a_summary_that_somebody_changed_is_refused_by_its_key(self):
        run = self.copy("run")
        whole = json.loads((run / "summary.json").read_text())
        for key, change in (("failure_mode", lambda s: s.pop("failure_mode")), ("name", lambda s: s["failure_mode"].update(name=1)),
                            ("quasi_static", lambda s: s.update(quasi_static=[])),
                            ("verdict", lambda s: s["quasi_static"].pop("verdict")),
                            ("load_factor", lambda s: s.pop("load_factor")),
                            ("judgement", lambda s: s["quasi_static"].update(judgement={})),
                            ("failure_mode", lambda s: [s.pop(k) for k in list(s)])):
            summary = json.loads(json.dumps(whole))
            change(summary)
            (run / "summary.json").write_text(json.dumps(summary))
            with self.subTest(key=key):
                self.refused("limit", self.made / "model.toml", "--with", run, "--out", self.folder / "out",
                             words=("summary.json", key, "run the model again"), codes=(4,))
        for text in ("[]", "1", "null", '{"failure_mode":', "[" * 50_000):
            (run / "summary.json").write_text(text)
            self.refused("limit", self.made / "model.toml", "--with", run, "--out", self.folder / "out",
                         words=("summary.json",))

    def test_memory_that_is_too_small_is_said_in_words(self):
        (self.folder / "b.json").write_text('{"units": "m", "blocks": [' + "0," * 15_000_000 + "0]}")
        (self.folder / "model.toml").write_text(SMALL.replace("[wall]", '[wall]\nblocks = "b.json"', 1))
        said = self.refused("check", self.folder / "model.toml", memory=450_000_000, codes=(4,))
        self.assertIn("no more memory", said)


if __name__ == "__main__":
    unittest.main(verbosity=1)
