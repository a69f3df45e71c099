"""wythe new, and the examples: each starter runs without changes."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

WYTHE = os.environ["WYTHE"]
SOURCE = pathlib.Path(os.environ["SOURCE"])
KINDS = {"pier": ["model.toml"], "portal": ["model.toml"], "facade": ["model.toml"], "arch": ["model.toml"],
         "opening": ["before.toml", "after.toml"], "study": ["study.toml", "model.toml"]}
# Enough of each example to see that it goes all the way: a push of half a millimetre. The facade, the palazzina and the shaken parapet are
# run by guides_test.py, in the pages that are about them.
SHORT = {"brick_pier": ["--set", "stage.push.until=0.5 mm"], "brick_portal": ["--set", "stage.push.until=0.5 mm"],
         "ring_beam": ["--set", "stage.push.until=0.5 mm"],
         "arch": ["--set", "stage.push.until=0.5 mm"],
         "tied_arch": ["--set", "stage.push.until=0.5 mm"], "dry_tilt": ["--set", "stage.tilt.tilt_until=5 deg"]}


def wythe(*arguments):
    return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True)


class Starters(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_each_kind_writes_a_file_that_is_valid(self):
        for kind, files in KINDS.items():
            with self.subTest(kind):
                place = self.folder / kind / "deep"
                done = wythe("new", kind, place)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(sorted(p.name for p in place.iterdir()), sorted(files))
                self.assertIn(str(place / files[0]), done.stdout)
                checked = wythe("check", place / files[0])
                self.assertEqual(checked.returncode, 0, checked.stderr)
                self.assertIn("valid", checked.stdout)

    def test_a_starter_is_the_example_of_its_kind(self):
        wythe("new", "facade", self.folder)
        self.assertEqual((self.folder / "model.toml").read_text(), (SOURCE / "examples/brick_facade/model.toml").read_text())

    def test_an_opening_is_compared_as_it_is_written(self):
        done = wythe("new", "opening", self.folder)
        self.assertIn("wythe compare", done.stdout)
        done = wythe("compare", self.folder / "before.toml", self.folder / "after.toml", "--out", self.folder / "result", "--quiet",
                     "--walls", 5, "--set", "stage.push.until=1 mm")
        self.assertIn("after.toml against before.toml does not keep within the limits", done.stdout, done.stderr)

    def test_nothing_is_replaced_and_nothing_half_written(self):
        (self.folder / "model.toml").write_text("mine")
        done = wythe("new", "study", self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("model.toml", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["model.toml"])
        self.assertEqual((self.folder / "model.toml").read_text(), "mine")

    def test_a_link_is_not_followed(self):
        (self.folder / "model.toml").symlink_to(self.folder / "elsewhere")
        self.assertEqual(wythe("new", "pier", self.folder).returncode, 2)
        self.assertFalse((self.folder / "elsewhere").exists())

    def test_an_unknown_kind_names_those_there_are(self):
        done = wythe("new", "castle", self.folder)
        self.assertEqual(done.returncode, 2)
        for kind in KINDS:
            self.assertIn(kind, done.stderr)

    def test_a_file_in_the_place_of_the_folder_is_said(self):
        (self.folder / "taken").write_text("")
        done = wythe("new", "pier", self.folder / "taken")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("taken", done.stderr)


class Examples(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_each_example_runs(self):
        for name, short in SHORT.items():
            with self.subTest(name):
                out = self.folder / name
                done = wythe("run", SOURCE / "examples" / name / "model.toml", "--out", out, "--quiet", *short)
                self.assertEqual(done.returncode, 0, done.stderr)
                summary = json.loads((out / "summary.json").read_text())
                self.assertIn(summary["status"], ("completed", "collapsed"))
                self.assertTrue((out / "report.html").is_file())

    def test_the_list_names_every_example_with_its_picture_and_command(self):
        listed = (SOURCE / "examples/README.md").read_text()
        for folder in (SOURCE / "examples").iterdir():
            if folder.is_dir():
                self.assertIn(f"`{folder.name}/`", listed)


if __name__ == "__main__":
    unittest.main()
