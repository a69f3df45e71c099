#!/usr/bin/env python3
"""Campaigns from the command line: killed, stopped, resumed, sharded, replayed, and faulty stores."""
import csv
import json
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import unittest

from cli_test import SMALL, SOURCE, Held, wythe
from stores import renew_checksums

MODEL = SMALL.replace('until = "3 mm"', 'until = "1 mm"')
STUDY = """
[study]
name = "small"
model = "model.toml"
samples = 6
seed = 7
states = ["0.5 mm"]
read_modes_at = "0.5 mm"
[variable.ft]
path = "material.joint.tensile_strength"
unit = "MPa"
distribution = "normal"
mean = "0.15 MPa"
cov = 0.2
[dependent.c]
path = "material.joint.cohesion"
unit = "MPa"
formula = "1.5 * ft"
"""
CONTRACT = ["sample", "ft_MPa", "c_MPa", "status", "peak_reaction_kN", "displacement_at_peak_mm",
            "displacement_at_80_percent_mm", "censored_80", "displacement_max_mm", "failure_mode"]


class Base(unittest.TestCase):
    """One undisturbed campaign, made once, to compare with."""
    model, study_text = MODEL, STUDY

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "model.toml").write_text(cls.model)
        (cls.folder / "study.toml").write_text(cls.study_text)
        cls.study = cls.folder / "study.toml"
        cls.whole = cls.folder / "whole"
        cls.done = wythe("campaign", cls.study, "--out", cls.whole)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def out(self):
        return self.folder / self._testMethodName

    def rows(self, out):
        with (out / "samples.csv").open() as file:
            return list(csv.DictReader(file))

    def resume(self, out=None, *more):
        return wythe("campaign", self.study, "--out", out or self.out(), "--resume", "--quiet", *more)

    def copy(self):
        """A finished campaign to spoil: only its store."""
        self.out().mkdir()
        (self.out() / "campaign.db").write_bytes((self.whole / "campaign.db").read_bytes())
        return self.out() / "campaign.db"

    def assert_equals_whole(self, out):
        self.assertEqual((out / "samples.csv").read_bytes(), (self.whole / "samples.csv").read_bytes())

    def refused(self, done, code, *words):
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)


class Results(Base):
    def test_files_table_and_progress(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        names = {p.name for p in self.whole.iterdir()}
        self.assertEqual(names, {"campaign.db", "samples.csv", "statistics.json", "report.html"})
        self.assertIn("samples 6 of 6: 6 completed", self.done.stdout)
        self.assertRegex(self.done.stderr, r"6 of 6 samples  .* a minute.*  sample \d: [\d.]+ kN, ")

    def test_pushes_that_are_too_fast_are_counted_first(self):
        done = wythe("campaign", self.study, "--out", self.out(), "--samples", "2", "--quiet",
                     "--set", "stage.push.velocity=20 mm/s")
        self.assertTrue(done.stdout.startswith('WARNING 2 of 2 pushes were not slow enough (2 "too fast")'), done.stdout)
        counts = json.loads((self.out() / "statistics.json").read_text())["samples"]["judgements"]
        self.assertEqual(counts, {"too fast": 2})

    def test_samples_csv_has_the_contract_columns(self):
        rows = self.rows(self.whole)
        self.assertEqual(list(rows[0])[:len(CONTRACT)], CONTRACT)
        self.assertEqual([r["sample"] for r in rows], list("123456"))
        for row in rows:
            self.assertAlmostEqual(float(row["c_MPa"]), 1.5 * float(row["ft_MPa"]), delta=1e-9)
            self.assertGreater(float(row["peak_reaction_kN"]), 1)

    def test_the_view_of_the_store_says_the_same(self):
        rows = self.rows(self.whole)
        with sqlite3.connect(self.whole / "campaign.db") as store:
            store.row_factory = sqlite3.Row
            seen = store.execute("SELECT * FROM samples ORDER BY sample").fetchall()
        self.assertEqual(len(seen), len(rows))
        for row, view in zip(rows, seen):
            for name in CONTRACT:
                if name in ("status", "failure_mode"):
                    self.assertEqual(row[name], view[name])
                else:  # the file has ten digits
                    self.assertAlmostEqual(float(row[name]), view[name], delta=1e-9 * abs(view[name]))

    def test_the_queries_of_the_documentation_run(self):
        page = (SOURCE / "docs/reference/store.md").read_text()
        queries = [q for block in re.findall(r"```sql\n(.*?)```", page, re.S) for q in block.split(";") if q.strip()]
        self.assertGreater(len(queries), 5)
        with sqlite3.connect(self.whole / "campaign.db") as store:
            for query in queries:
                store.execute(query).fetchall()

    def test_samples_and_seed_are_those_asked(self):
        done = wythe("campaign", self.study, "--out", self.out(), "--samples", 2, "--seed", 8, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        rows = self.rows(self.out())
        first = self.rows(self.whole)[0]
        self.assertEqual(len(rows), 2)
        self.assertNotEqual(rows[0]["ft_MPa"], first["ft_MPa"])

    def test_check_describes_a_study(self):
        done = wythe("check", self.study)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("valid", "ft_MPa", "c_MPa", "6 samples"):
            self.assertIn(word, done.stdout)

    def test_results_are_replaced_as_a_whole_or_not_at_all(self):
        names = ("samples.csv", "statistics.json", "report.html")
        self.copy()
        self.assertEqual(wythe("report", self.out()).returncode, 0)
        old = {n: (self.out() / n).read_bytes() for n in names}
        with sqlite3.connect(self.out() / "campaign.db") as store:
            tables = [name for (name,) in store.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
            of_samples = [t for t in tables if "sample" in (row[1] for row in store.execute(f"PRAGMA table_info({t})"))]
            for table in of_samples:
                if table != "sample_input":
                    store.execute(f"DELETE FROM {table} WHERE sample > 4")
        for point in ("results written", "results ready", "results removed", "results moving"):
            Held(point, "report", self.out()).kill()
            there = {n: (self.out() / n).read_bytes() for n in names if (self.out() / n).exists()}
            same = [there[n] == old[n] for n in there]
            self.assertIn(same, ([True] * 3, [False] * len(there)), point)  # all old, or none
            if point == "results written":
                self.assertEqual(there, old)
        done = wythe("report", self.out())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([p.name for p in self.out().iterdir() if p.name.startswith(".")], [])
        self.assertEqual(len(self.rows(self.out())), 4)

    def test_report_writes_the_results_again(self):
        self.copy()
        done = wythe("report", self.out())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())
        self.assertTrue((self.out() / "report.html").exists())


class Disturbed(Base):
    study_text = STUDY.replace("samples = 6", "samples = 20")  # more than a core has in hand when it is stopped

    def held(self, samples):
        """A campaign of one core that waits while `samples` are stored."""
        return Held(f"sample {samples}", "campaign", self.study, "--out", self.out(), "--jobs", "1")

    def test_killed_and_resumed_equals_undisturbed(self):
        self.held(2).kill()
        with sqlite3.connect(self.out() / "campaign.db") as store:
            self.assertEqual(store.execute("PRAGMA integrity_check").fetchone()[0], "ok")
            stored = store.execute("SELECT count(*) FROM sample").fetchone()[0]
        self.assertEqual(stored, 2)
        done = self.resume()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_interrupted_says_how_to_go_on(self):
        held = self.held(2)
        said = held.interrupt()
        self.assertEqual(held.process.returncode, 3, said)
        stored = int(re.search(r"stopped: (\d+) of 20 samples are stored", said).group(1))
        self.assertGreaterEqual(stored, 2)
        self.assertLess(stored, 20)
        asked = json.loads((self.out() / "statistics.json").read_text())["samples"]
        self.assertEqual(asked["run"], len(self.rows(self.out())))  # the files say what the store holds
        command = shlex.split(said.strip().splitlines()[-1])
        self.assertEqual(command[-1], "--resume")
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_a_full_disk_is_said_and_resume_goes_on(self):
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, resource.RLIM_INFINITY))

        done = wythe("campaign", self.study, "--out", self.out(), "--quiet", preexec_fn=small_files)
        self.refused(done, 4, "disk", "--resume")
        with sqlite3.connect(self.out() / "campaign.db") as store:
            self.assertGreater(store.execute("SELECT count(*) FROM sample").fetchone()[0], 0)
        done = self.resume()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_a_second_campaign_in_the_folder(self):
        first = self.held(1)
        done = self.resume()
        first.go_on()
        self.refused(done, 4, f"another campaign is writing there (process {first.process.pid} on ")
        self.assert_equals_whole(self.out())

    def test_resume_without_a_store_begins(self):
        done = self.resume()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_resume_keeps_the_size_and_says_how_to_add(self):
        wythe("campaign", self.study, "--out", self.out(), "--samples", 2, "--quiet")
        done = self.resume()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("a design of 2 samples, the study asks for 20; --samples 20 adds the rest", done.stderr)
        done = self.resume(None, "--samples", "20")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("samples 20 of 20", done.stdout)


class FallenBeforeThePush(unittest.TestCase):
    """A ledge on a block, held by a bond that one of three samples has not: it falls under its own weight."""

    def test_has_no_strength_anywhere(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            blocks = [{"id": "base", "polygon": [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]},
                      {"id": "ledge", "polygon": [[0.08, 0.2], [0.48, 0.2], [0.48, 0.4], [0.08, 0.4]]}]
            (folder / "blocks.json").write_text(json.dumps({"units": "m", "blocks": blocks}))
            text = re.sub(r'\[wall\].*?\[material.joint\]',
                          '[wall]\nblocks = "blocks.json"\nthickness = "0.2 m"\n[wall.unit]\n'
                          'density = "2000 kg/m^3"\n[material.joint]', MODEL, count=1, flags=re.S)
            text = text[:text.index("[[stage]]")] + '[[stage]]\nname = "gravity"\n' + text[text.rindex("[[stage]]"):]
            (folder / "model.toml").write_text(text.replace('x = "0 m", y = "0.75 m"', 'x = "0.08 m", y = "0.3 m"'))
            study = STUDY.replace("samples = 6", "samples = 3").replace(
                'distribution = "normal"\nmean = "0.15 MPa"\ncov = 0.2', 'distribution = "uniform"\nlow = "0.0005 MPa"\nhigh = "0.03 MPa"')
            (folder / "study.toml").write_text(study)
            done = wythe("campaign", folder / "study.toml", "--out", folder / "out", "--jobs", 1)
            self.assertEqual(done.returncode, 0, done.stderr)
            with (folder / "out/samples.csv").open() as file:
                rows = list(csv.DictReader(file))
            fallen = [r["sample"] for r in rows if r["status"] == "collapsed" and r["peak_reaction_kN"] == ""]
            self.assertEqual(len(fallen), 1, rows)
            for row in rows:
                if row["sample"] in fallen:
                    self.assertEqual({row[name] for name in CONTRACT[4:]}, {""})
            with sqlite3.connect(folder / "out/campaign.db") as store:
                weakest = store.execute("SELECT * FROM samples WHERE peak_reaction_kN IS NOT NULL "
                                        "ORDER BY peak_reaction_kN LIMIT 5").fetchall()
                self.assertEqual(len(weakest), 2)
                self.assertEqual(store.execute("SELECT count(*) FROM sample WHERE coalesce(peak_reaction_N, "
                                               "displacement_max_m, failure_mode, energy_loads_J) IS NULL").fetchone()[0], 1)
            said = json.loads((folder / "out/statistics.json").read_text())
            self.assertEqual(said["samples"]["collapsed_before_push"], 1)
            self.assertEqual([str(u["sample"]) for u in said["samples"]["unanswered"]], fallen)
            self.assertIn('stage "gravity"', said["samples"]["unanswered"][0]["reason"])
            self.assertEqual(said["table"]["all"]["peak_reaction_kN"]["n"], 2)
            self.assertIn("1 collapsed before the push: they have no strength", done.stdout)
            self.assertRegex(done.stderr, r"sample \d: collapsed before the push")
            self.assertIn("1 of them collapsed before the push", (folder / "out/report.html").read_text())


class InstructionSets(Base):
    def test_none_changes_a_byte_of_the_results(self):
        sets = [name for name in ("scalar", "sse2", "avx2", "avx512")
                if wythe("--version", env=os.environ | {"WYTHE_SIMD": name}).returncode == 0]
        self.assertIn("scalar", sets)
        for name in sets:
            out = self.folder / name
            self.assertEqual(wythe("campaign", self.study, "--out", out, "--quiet",
                                   env=os.environ | {"WYTHE_SIMD": name}).returncode, 0)
            self.assertEqual(self.hashes(out), self.hashes(self.whole), name)
            self.assert_equals_whole(out)

    def hashes(self, out):
        return sqlite3.connect(out / "campaign.db").execute("SELECT sample, state_hash FROM sample").fetchall()


class Parts(Base):
    def test_shards_merge_to_the_whole(self):
        shards = [self.folder / f"shard_{i}" for i in (1, 2)]
        for i, shard in enumerate(shards, 1):
            done = wythe("campaign", self.study, "--out", shard, "--shard", f"{i}/2", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
        done = wythe("merge", *shards, "--out", self.out())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())
        for name in ("statistics.json", "report.html"):
            self.assertTrue((self.out() / name).exists(), name)
        done = wythe("merge", shards[0], "--out", self.folder / "half")
        self.assertIn("3 samples are in none of these shards", done.stderr)

    def test_replay_gives_the_same_bits_and_all_files(self):
        done = wythe("replay", self.whole, "--sample", 3, "--out", self.out(), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("equals that of the campaign, bit for bit", done.stdout)
        names = {p.name for p in self.out().iterdir()}
        for name in ("force_displacement.csv", "summary.json", "report.html", "run.pvd", "model.toml", "settings.txt"):
            self.assertIn(name, names)

    def test_replay_that_differs_exits_with_3(self):
        shutil.copytree(self.whole, self.out())
        with sqlite3.connect(self.out() / "campaign.db") as database:
            database.execute("UPDATE sample SET state_hash = '0123456789abcdef' WHERE sample = 1")
            renew_checksums(database)
        database.close()
        done = wythe("replay", self.out(), "--sample", 1, "--out", self.folder / "replayed", "--quiet")
        self.refused(done, 3, "differs from that of the campaign", "0123456789abcdef", "the campaign was run by")

    def test_replay_of_a_sample_that_is_not_there(self):
        done = wythe("replay", self.whole, "--sample", 7, "--out", self.out())
        self.refused(done, 2, "--sample", "write a number from 1 to 6")
        self.refused(wythe("replay", self.folder / "nowhere", "--sample", 1, "--out", self.out()), 2,
                     "holds no campaign")


class Faults(Base):
    def test_options_that_are_wrong(self):
        for options in (["--samples", "0"], ["--samples", "1"], ["--shard", "0/2"], ["--shard", "two"], ["--jobs", "-1"], ["--jobs", "1025"],
                        ["--fly"], ["--until", "share < soon"], ["--set", "wall.thickness=-1 m"],
                        ["--until", "interval(share) < 0.1", "--shard", "1/2"]):
            done = wythe("campaign", self.study, "--out", self.out(), *options)
            self.assertEqual(done.returncode, 2, f"{options}: {done.stderr}")
            self.assertNotEqual(done.stderr, "")
            self.assertFalse(self.out().exists(), options)

    def test_options_are_named_as_typed(self):
        for option, value, words in (("--seed", "-1", "must be a whole number from 0"),
                                     ("--samples", "0", "must be at least 2"),
                                     ("--samples", "2.5", "must be a whole number"),
                                     ("--jobs", "1025", "must be a whole number from 0 to 1024; leave it out for all cores"),
                                     ("--until", "x", "write e.g.")):
            done = wythe("campaign", self.study, "--out", self.out(), option, value)
            self.refused(done, 2, words)
            self.assertTrue(done.stderr.startswith(option + ":"), done.stderr)

    def test_results_of_the_other_kind_are_not_written_over(self):
        before = (self.whole / "report.html").read_bytes()
        for command in (["replay", self.whole, "--sample", 1], ["run", self.folder / "model.toml"]):
            self.refused(wythe(*command, "--out", self.whole, "--quiet"), 2, "holds a campaign", "another folder")
        self.assertEqual({p.name for p in self.whole.iterdir()}, {"campaign.db", "samples.csv", "statistics.json", "report.html"})
        self.assertEqual((self.whole / "report.html").read_bytes(), before)
        done = wythe("replay", self.whole, "--sample", 1, "--out", self.out(), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        for command in (["campaign", self.study], ["merge", self.whole]):
            self.refused(wythe(*command, "--out", self.out()), 2, "holds the results of a run")

    def test_ten_million_samples_are_refused_at_once(self):
        done = wythe("campaign", self.study, "--out", self.out(), "--samples", 10000000,
                     env=os.environ | {"WYTHE_MEMORY": "8 GB"})
        self.assertEqual(done.returncode, 2, done.stdout)
        for word in ("--samples: 10000000: 10 million samples", "10 million samples", "of memory", "of computing", "write at most"):
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out().exists())

    def test_a_state_that_is_not_stored(self):
        picture = self.folder / "old.svg"
        old = '<svg class="states"></svg>'
        picture.write_text(old)
        some = wythe("picture", self.whole, "--sample", 1, "--at", 0.5, 7, 9, "--out", self.folder / "some.svg")
        self.assertEqual(some.returncode, 0, some.stderr)
        self.assertIn("no state is stored at 7, 9 mm", some.stderr)
        done = wythe("picture", self.whole, "--sample", 1, "--at", 7, "--out", picture)
        self.refused(done, 2, "--at: 7: sample 1 has no state there", "stored are, in mm: 0.5")
        self.assertEqual(picture.read_text(), old)

    def test_check_names_the_samples_that_will_be_refused(self):
        study = self.folder / "wide.toml"
        study.write_text(STUDY.replace("cov = 0.2", "cov = 1.2").replace("samples = 6", "samples = 40"))
        done = wythe("check", study)
        lines = [line for line in done.stdout.splitlines() if "will be refused" in line]
        self.assertEqual(len(lines), 2, done.stdout)  # many values, two reasons: below zero, snap-back
        for line in lines:
            self.assertRegex(line, r"^\d+ samples will be refused \((\d+, )+\d+\), e.g. material.joint")

    def test_a_push_that_ends_before_the_reading_is_said(self):
        study = self.folder / "short.toml"
        study.write_text(STUDY.replace('read_modes_at = "0.5 mm"', 'read_modes_at = "5 mm"'))
        self.assertIn("note: failure modes are named at 5 mm, the push ends at 1 mm", wythe("check", study).stdout)
        done = wythe("campaign", study, "--out", self.out(), "--samples", 2, "--quiet")
        self.assertIn("failure modes are named at 5 mm, the push ends at 1 mm", done.stderr)
        self.assertIn("2 of 2 pushes ended before 5 mm", done.stdout)
        self.assertEqual(json.loads((self.out() / "statistics.json").read_text())["samples"]["named_earlier"], 2)

    def test_an_existing_campaign_needs_resume(self):
        before = (self.whole / "campaign.db").read_bytes()
        self.refused(wythe("campaign", self.study, "--out", self.whole), 2, "holds a campaign already", "--resume")
        self.assertEqual((self.whole / "campaign.db").read_bytes(), before)

    def test_a_changed_study_is_named(self):
        self.copy()
        changed = self.folder / "changed.toml"
        changed.write_text(STUDY.replace("cov = 0.2", "cov = 0.3"))
        done = wythe("campaign", changed, "--out", self.out(), "--resume", "--set", "output.rows=600")
        self.refused(done, 2, "variable.ft.cov: was 0.2 when the campaign began, is 0.3 now",
                     "settings: was not given", "output.rows=600")
        (self.folder / "model.toml").write_text(MODEL.replace('density = "2000', 'density = "2100'))
        try:
            done = self.resume()
        finally:
            (self.folder / "model.toml").write_text(MODEL)
        self.refused(done, 2, 'density = "2000 kg/m^3": stood in the model when', 'density = "2100 kg/m^3": did not')

    def test_a_locked_store(self):
        store = self.copy()
        other = sqlite3.connect(store, isolation_level=None)
        other.execute("BEGIN IMMEDIATE")
        done = self.resume(None, "--samples", "8")
        other.execute("ROLLBACK")
        other.close()
        self.refused(done, 4, "locked by another program", str(store))
        self.assertEqual(self.resume(None, "--samples", "8").returncode, 0)

    def test_a_damaged_store(self):
        store = self.copy()
        store.write_bytes(store.read_bytes()[:store.stat().st_size // 2])
        spoiled = store.read_bytes()
        self.refused(self.resume(), 4, "damaged", str(store))
        self.assertEqual(store.read_bytes(), spoiled)
        store.write_bytes(b"not a database " * 1000)
        self.refused(self.resume(), 4, "is not a campaign store")
        self.refused(wythe("report", self.out()), 4, "is not a campaign store")

    def test_a_store_of_another_version(self):
        store = self.copy()
        with sqlite3.connect(store) as database:
            database.execute("PRAGMA user_version = 99")
        self.refused(self.resume(), 4, "store version 99", "version 1", "run the campaign again")

    def test_a_folder_that_cannot_be_written(self):
        (self.folder / "file").write_text("x")
        self.refused(wythe("campaign", self.study, "--out", self.folder / "file" / "out"), 4, "cannot be")

    def test_samples_that_never_settle_are_outcomes(self):
        done = wythe("campaign", self.study, "--out", self.out(), "--samples", 2, "--quiet", "--set",
                     "solve.settle_ratio=1e-300", "--set", "solve.settle_limit=0.01 s")
        self.assertEqual(done.returncode, 3, done.stderr)  # nothing to count
        for row in self.rows(self.out()):
            self.assertEqual(row["status"], "not_settled")
            self.assertEqual(row["peak_reaction_kN"] + row["failure_mode"] + row["censored_80"], "")
        self.assertIn("2 not_settled", done.stdout)

    def test_help_has_an_example(self):
        for command in ("campaign", "merge", "replay", "report"):
            self.assertIn("example:", wythe(command, "--help").stdout)


if __name__ == "__main__":
    unittest.main(verbosity=1)
