#!/usr/bin/env python3
"""Files as others have them: each is read for what it is, or refused with the reason that is so (tests/data/strangers)."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

WYTHE = os.environ["WYTHE"]
FOLDER = pathlib.Path(os.environ["SOURCE"]) / "tests/data/strangers"


class Strangers(unittest.TestCase):
    def test_each_is_read_or_refused_for_what_it_is(self):
        for name, wanted in json.loads((FOLDER / "expected.json").read_text()).items():
            with self.subTest(name):
                done = subprocess.run([WYTHE, "check", FOLDER / name], capture_output=True, text=True, timeout=60)
                said = done.stdout + done.stderr
                self.assertEqual(done.returncode, wanted["code"], said)
                for words in wanted.get("has", []):
                    self.assertIn(words, said)
                for words in wanted.get("lacks", []):
                    self.assertNotIn(words, said)
                if "faults" in wanted:
                    self.assertEqual(len(done.stderr.strip().splitlines()), wanted["faults"], said)

    def test_every_model_there_has_its_expectation(self):
        models = {str(path.relative_to(FOLDER)) for path in FOLDER.glob("*/*.toml")}
        self.assertEqual(models, set(json.loads((FOLDER / "expected.json").read_text())))


class Paths(unittest.TestCase):
    """A folder may bear any name that the system takes."""

    NAMES = ["a b", "a#b", "a?b", "100%", "%41", "it's", 'a"b', "übung 石", "a&b=c", "-dash", "a;b", "x\\y", "*", "[1]", "~", "a\tb"]

    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="wythe_paths_"))
        self.addCleanup(shutil.rmtree, self.root)

    def wythe(self, *arguments, code=0):
        done = subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout[-500:]}{done.stderr[-2000:]}")
        return done

    def everything_in(self, folder):
        """Every command that reads or writes, with `folder` in all of its paths."""
        dry = pathlib.Path(os.environ["SOURCE"]) / "tests/data/strangers/paths"
        os.makedirs(folder, exist_ok=True)
        for name in ("model.toml", "study.toml", "b.json"):
            shutil.copy(dry / name, folder + "/" + name)
        model, study = folder + "/model.toml", folder + "/study.toml"
        self.wythe("check", model)
        self.wythe("run", model, "--out", folder + "/run", "--quiet", "--threads", 1)
        self.wythe("report", folder + "/run")
        self.wythe("export", folder + "/run", "--out", folder + "/tables")
        self.wythe("limit", model, "--out", folder + "/limit", "--only", "lp", "--quiet")
        self.wythe("check", study)
        self.wythe("campaign", study, "--out", folder + "/campaign", "--jobs", 1, "--quiet")
        self.wythe("campaign", study, "--out", folder + "/campaign", "--jobs", 1, "--quiet", "--resume")
        self.wythe("replay", folder + "/campaign", "--sample", 1, "--out", folder + "/sample", "--quiet")
        self.wythe("picture", folder + "/campaign", "--sample", 1, "--out", folder + "/sample.svg")
        self.wythe("report", folder + "/campaign")
        self.wythe("export", folder + "/campaign", "--out", folder + "/samples")
        for file in ("run/summary.json", "sample.svg", "campaign/campaign.db", "sample/summary.json"):
            self.assertTrue(os.path.exists(folder + "/" + file), file)

    def test_two_slashes_before_a_path(self):
        self.everything_in("//" + str(self.root).lstrip("/") + "//deep")

    def test_names_of_any_characters(self):
        self.everything_in(str(self.root / "".join(name.replace("/", "") for name in self.NAMES)[:80]))
        for name in self.NAMES:
            folder = self.root / name
            folder.mkdir()
            for file in ("study.toml", "model.toml", "b.json"):
                shutil.copy(FOLDER / "paths" / file, folder / file)
            self.wythe("campaign", folder / "study.toml", "--out", folder / "out", "--jobs", 1, "--quiet")
            self.assertTrue((folder / "out/campaign.db").exists(), name)

    def test_paths_of_any_length_are_taken_or_refused_for_their_length(self):
        model = FOLDER / "paths/model.toml"
        study = FOLDER / "paths/study.toml"
        for length in (600, 4200):
            path = str(self.root) + "/x" * ((length - len(str(self.root))) // 2)
            for command in (["check", path], ["run", path, "--out", self.root / "o"], ["report", path], ["export", path, "--out", self.root / "o"],
                            ["replay", path, "--sample", "1", "--out", self.root / "o"], ["picture", path, "--sample", "1", "--out", self.root / "o.svg"]):
                done = subprocess.run([WYTHE, *map(str, command)], capture_output=True, text=True, timeout=60)
                self.assertIn(done.returncode, (2, 4), command[0])
                self.assertNotIn("terminate", done.stderr)
                self.assertNotIn("filesystem error", done.stderr)
            done = subprocess.run([WYTHE, "campaign", study, "--out", path, "--jobs", "1", "--quiet"], capture_output=True, text=True, timeout=60)
            self.assertIn(done.returncode, (2, 4), length)
            self.assertRegex(done.stderr, "characters|too long", done.stderr[-300:])
        path = str(self.root) + "/x" * 300
        self.wythe("run", model, "--out", path, "--quiet", "--threads", 1)


if __name__ == "__main__":
    unittest.main()
