#!/usr/bin/env python3
"""The surroundings of the program: numbers and empty words on the command line, an environment for other programs,
file size limits. The program reports the fault in words, ends without a signal, and leaves no incomplete file."""
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from assess_test import WALL  # noqa: E402
from campaign_test import MODEL, STUDY  # noqa: E402
from cli_test import WYTHE  # noqa: E402
from hostile_test import RAW  # noqa: E402

# options whose value is a number, with what else their command needs; `help` below finds that none is missing
NUMBERS = {
    "run": {"--threads": [], "--checkpoint": [], "--walls": [], "--jobs": ["--walls", "2"]},
    "assess": {"--walls": [], "--until": [], "--seed": [], "--between": [], "--jobs": []},
    "campaign": {"--samples": [], "--seed": [], "--jobs": [], "--slurm": [], "--cores": ["--slurm", "2"], "--shard": [],
                 "--until": []},
    "replay": {"--sample": [], "--threads": ["--sample", "1"], "--intensity": ["--sample", "1"]},
    "compare": {"--walls": [], "--seed": [], "--jobs": [], "--stiffness": [], "--strength": [], "--displacement": []},
    "picture": {"--sample": [], "--at": ["--sample", "1"], "--scale": ["--sample", "1"]},
}
NO_NUMBERS = {"--help", "--out", "--set", "--resume", "--replace", "--quiet", "--lang", "--path", "--unit", "--outline", "--openings",
              "--lintels", "--submit", "--stored", "--partition", "--time", "--with", "--only", "--assessment", "--hdf5", "--replace"}
BAD = ("nan", "inf", "1e308", "-1", "", " ", "99999999999999999999", "1,5", "abc", "nan s",
       "relative_interval(peak_reaction) < nan", "relative_interval(peak_reaction) < 1e308")
COMMANDS = ("run", "assess", "check", "contact", "drawing", "materials", "campaign", "merge", "store", "status", "compare", "replay",
            "report", "limit", "export", "new", "picture", "studio")


def wythe(*arguments, **options):
    return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True, errors="replace", timeout=120,
                          **options)


class Surroundings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.made = pathlib.Path(cls.temporary.name)
        (cls.made / "model.toml").write_text(MODEL)
        (cls.made / "study.toml").write_text(STUDY)
        (cls.made / "assess.toml").write_text(WALL)
        for command in (["campaign", "study.toml", "--samples", 2, "--out", "campaign"], ["run", "model.toml", "--out", "run"]):
            done = wythe(*command, "--quiet", cwd=cls.made)
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.out = pathlib.Path(scratch.name) / "out"

    def start_of(self, command):
        return {"run": ["run", self.made / "model.toml", "--out", self.out, "--quiet"],
                "assess": ["assess", self.made / "assess.toml", "--out", self.out, "--quiet"],
                "campaign": ["campaign", self.made / "study.toml", "--out", self.out, "--quiet"],
                "compare": ["compare", self.made / "model.toml", self.made / "assess.toml", "--out", self.out, "--quiet"],
                "replay": ["replay", self.made / "campaign", "--out", self.out, "--quiet"],
                "picture": ["picture", self.made / "campaign", "--out", self.out]}[command]

    def in_words(self, done):
        for word in RAW:
            self.assertNotIn(word, done.stderr)

    # --- the command line

    def test_every_option_of_the_help_is_in_the_table_of_this_test(self):
        for command in COMMANDS:
            options = set(re.findall(r"(?<![\w-])--[a-z0-9]+", wythe(command, "--help").stdout.split("example:")[0]))
            self.assertEqual(options - NO_NUMBERS - set(NUMBERS.get(command, ())), set(), command)
        self.assertEqual({c for c in re.findall(r"^  ([a-z]+) ", wythe("--help").stdout, re.M)}, set(COMMANDS))

    def test_a_number_that_is_none_is_refused_by_every_option(self):
        options = [(command, option, more) for command, named in NUMBERS.items() for option, more in named.items()]
        for k, bad in enumerate(BAD):
            # make test-long takes every option; else each takes a third of these words, and each word a third of the options
            for command, option, more in options if "WYTHE_LONG" in os.environ else options[k % 3::3]:
                with self.subTest(option=option, value=bad):
                    done = wythe(*self.start_of(command), *more, option, bad)
                    self.assertEqual(done.returncode, 2, (done.stdout[-300:], done.stderr[-500:]))
                    self.assertIn(option, done.stderr)
                    self.in_words(done)
                    self.assertFalse(self.out.exists())
                shutil.rmtree(self.out, ignore_errors=True)

    def test_an_empty_word_is_refused_wherever_it_stands(self):
        for command in (["run", "", "--out", self.out], ["check", ""], ["new", "pier", ""],
                        ["campaign", self.made / "study.toml", "--slurm=", "--out", self.out],
                        ["report", self.made / "run", "--lang", ""]):
            done = wythe(*command)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn("is empty", done.stderr)
        self.assertFalse(self.out.exists())

    # --- the environment

    def test_settings_of_other_programs_change_nothing(self):
        told = (self.made / "campaign/samples.csv").read_bytes()
        for change in ({"HOME": "/nowhere", "TMPDIR": "/nowhere"}, {"LC_ALL": "de_DE.UTF-8"},
                       {"LC_ALL": "nowhere", "LANG": "x"}, {"HDF5_PLUGIN_PATH": "/nowhere", "HDF5_DRIVER": "none"}):
            with self.subTest(change=change):
                self.assertEqual(self.drawn("study.toml", change), told)
        bare = wythe("run", self.made / "model.toml", "--out", self.out, "--quiet", env={})
        self.assertEqual(bare.returncode, 0, bare.stderr)

    def drawn(self, study, change):
        """samples.csv of a campaign in a changed environment."""
        done = wythe("campaign", self.made / study, "--samples", 2, "--out", self.out, "--quiet", env={**os.environ, **change})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.in_words(done)
        samples = (self.out / "samples.csv").read_bytes()
        shutil.rmtree(self.out)
        return samples

    # --- files that may not grow

    def test_a_limit_on_the_size_of_files_is_told_and_leaves_no_half_file(self):
        campaign, run = self.made / "campaign", self.made / "run"
        for most, command in ((20_000, ["run", self.made / "model.toml", "--quiet", "--out", self.out]),
                              (2_000, ["run", self.made / "model.toml", "--quiet", "--checkpoint", "0.001 s", "--out", self.out]),
                              (5_000, ["campaign", self.made / "study.toml", "--samples", 2, "--quiet", "--out", self.out]),
                              (100, ["export", campaign, "--out", self.out]),
                              (100, ["export", campaign, "--hdf5", "--out", self.out]),
                              (3_000, ["export", campaign, "--hdf5", "--out", self.out]),
                              (9_000, ["export", run, "--hdf5", "--out", self.out]),
                              (100, ["export", run, "--out", self.out]),
                              (1_000, ["picture", campaign, "--sample", 1, "--out", self.out]),
                              (1_000, ["merge", campaign, "--out", self.out]),
                              (1_000, ["limit", self.made / "model.toml", "--quiet", "--out", self.out]),
                              (100, ["new", "facade", self.out]),
                              (20_000, ["replay", campaign, "--sample", 1, "--quiet", "--out", self.out])):
            with self.subTest(most=most, command=command[0]):
                limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))  # noqa: B023
                done = wythe(*command, preexec_fn=limit)
                self.assertEqual(done.returncode, 4, (done.stdout[-500:], done.stderr[-1000:]))
                self.in_words(done)
                self.assertNotIn("HDF5-DIAG", done.stderr)
                self.assertLess(len(done.stderr), 2_000)
                if self.out.is_dir():
                    left = [p.name for p in self.out.iterdir() if p.is_file() and not p.name.startswith("campaign.")]
                    self.assertEqual(left, [])
                    shutil.rmtree(self.out)
                self.assertFalse(self.out.exists())

    def test_a_page_that_cannot_be_written_again_stays_as_it_was(self):
        run = pathlib.Path(shutil.copytree(self.made / "run", self.out))
        old = (run / "report.html").read_bytes()
        done = wythe("report", run, "--lang", "it",
                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000)))
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("cannot be written", done.stderr)
        self.assertEqual((run / "report.html").read_bytes(), old)
        self.assertEqual({p.name for p in run.iterdir()}, {p.name for p in (self.made / "run").iterdir()})


if __name__ == "__main__":
    unittest.main(verbosity=1)
