#!/usr/bin/env python3
"""Options side by side from the command line: run, killed, resumed, sharded, compared, refused."""
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

from campaign_test import MODEL, STUDY
from cli_test import SOURCE, WYTHE, Held, wythe

OPTIONS = """
[[variant]]
name = "Damped, 0.4"
set = ["stage.push.damping=0.4"]
[[variant]]
name = "free energy"
set = ["dependent.c.formula=2 * ft"]
[[variant]]
name = "other wall"
model = "longer.toml"
"""
FOLDERS = ["base", "damped_0_4", "free_energy", "other_wall"]


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "model.toml").write_text(MODEL)
        (cls.folder / "longer.toml").write_text(MODEL.replace('length = "0.8 m"', 'length = "1.2 m"'))
        cls.study = cls.folder / "study.toml"
        cls.study.write_text(STUDY + OPTIONS)
        cls.whole = cls.folder / "whole"
        cls.done = wythe("campaign", cls.study, "--out", cls.whole, "--jobs", 1)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def out(self):
        return self.folder / self._testMethodName

    def refused(self, study, *words, code=2, command="campaign"):
        path = self.folder / (self._testMethodName + ".toml")
        path.write_text(study)
        arguments = [command, path] + (["--out", self.out()] if command == "campaign" else [])
        done = wythe(*arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out().exists())
        return done

    def assert_equals_whole(self, out):
        for name in FOLDERS:
            self.assertEqual((out / name / "samples.csv").read_bytes(), (self.whole / name / "samples.csv").read_bytes())
        self.assertEqual((out / "comparison.json").read_bytes(), (self.whole / "comparison.json").read_bytes())

    # --- what it writes

    def test_every_option_is_an_ordinary_campaign_of_the_same_samples(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(sorted(p.name for p in self.whole.iterdir()), sorted(FOLDERS + ["comparison.json", "comparison.html"]))
        inputs = {tuple(line.split(",")[1] for line in (self.whole / name / "samples.csv").read_text().splitlines())
                  for name in FOLDERS}
        self.assertEqual(len(inputs), 1)
        plain = self.folder / "plain.toml"
        plain.write_text(STUDY)
        done = wythe("campaign", plain, "--out", self.out(), "--set", "stage.push.damping=0.4", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.out() / "samples.csv").read_bytes(),
                         (self.whole / "damped_0_4/samples.csv").read_bytes())
        self.assertIn("24 of 24 samples", self.done.stderr)  # progress of all together

    def test_the_comparison_says_what_differs(self):
        json_of = json.loads((self.whole / "comparison.json").read_text())
        self.assertEqual([o["name"] for o in json_of["option"]], ["Damped, 0.4", "free energy", "other wall"])
        self.assertEqual([o["folder"] for o in json_of["option"]], FOLDERS[1:])
        damped, energy, other = json_of["option"]
        self.assertEqual(damped["changes"], ["stage.push.damping=0.4"])
        self.assertIn("dependent.c.formula", energy["changes"][0])
        self.assertEqual(other["changes"], ["model longer.toml"])
        peak = other["response"]["peak_reaction_kN"]
        self.assertIsNone(peak["ratio"])  # bounds are no numbers
        self.assertEqual(peak["in_means"], 0)
        self.assertEqual((peak["smaller"], peak["larger"] + peak["undecided"]), (0, 6))
        self.assertEqual(peak["undecided"], len(peak["pair"]["base"]["lower_bounds"]))  # it was still rising
        self.assertEqual(other["pairs"], 6)
        self.assertRegex(self.done.stdout, r"other wall: peak force: of 6 samples \d surely stronger, 0 surely weaker")

    def test_the_mean_difference_is_that_of_the_two_tables(self):
        def stiffness(name):
            lines = (self.whole / name / "samples.csv").read_text().splitlines()
            at = lines[0].split(",").index("initial_stiffness_kN_per_mm")
            return [float(line.split(",")[at]) for line in lines[1:]]
        gaps = [b - a for a, b in zip(stiffness("base"), stiffness("other_wall"))]
        found = json.loads((self.whole / "comparison.json").read_text())["option"][2]["response"]["initial_stiffness_kN_per_mm"]
        self.assertAlmostEqual(found["difference"], sum(gaps) / 6, delta=1e-6)

    # --- the same however it is run

    def test_stopped_and_resumed_it_is_the_same(self):
        held = Held("sample 9", "campaign", self.study, "--out", self.out(), "--jobs", 1)
        said = held.interrupt(signal.SIGTERM)
        self.assertEqual(held.process.returncode, 3, said)
        self.assertRegex(said, r"stopped: \d+ of 24 samples are stored")
        self.assertFalse((self.out() / "comparison.json").exists())
        again = wythe("campaign", self.study, "--out", self.out(), "--quiet")
        self.assertEqual(again.returncode, 2)
        self.assertIn("--resume", again.stderr)
        done = wythe("campaign", self.study, "--out", self.out(), "--quiet", "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_killed_and_resumed_it_is_the_same(self):
        Held("sample 8", "campaign", self.study, "--out", self.out(), "--jobs", 2).kill()
        done = wythe("campaign", self.study, "--out", self.out(), "--quiet", "--resume", "--jobs", 3)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_shards_merge_to_the_same(self):
        for k in (1, 2):
            done = wythe("campaign", self.study, "--out", f"{self.out()}_{k}", "--shard", f"{k}/2", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
        done = wythe("merge", f"{self.out()}_1", f"{self.out()}_2", "--out", self.out())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_an_option_may_be_added_later(self):
        shutil.copytree(self.whole, self.out())
        study = self.folder / "more.toml"
        study.write_text(STUDY + OPTIONS + '[[variant]]\nname = "slow"\nset = ["stage.push.velocity=1 mm/s"]\n')
        done = wythe("campaign", study, "--out", self.out(), "--quiet", "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        json_of = json.loads((self.out() / "comparison.json").read_text())
        self.assertEqual([o["folder"] for o in json_of["option"]], FOLDERS[1:] + ["slow"])

    def test_options_take_the_samples_that_a_rule_gave_the_base(self):
        study = self.folder / "until.toml"
        study.write_text(STUDY.replace("samples = 6", "samples = 30") + OPTIONS.split("[[variant]]")[0] +
                         '[[variant]]\nname = "damped"\nset = ["stage.push.damping=0.4"]\n')
        done = wythe("campaign", study, "--out", self.out(), "--quiet", "--until",
                     "relative_interval(peak_reaction) < 90 %")
        self.assertEqual(done.returncode, 0, done.stderr)
        option = json.loads((self.out() / "comparison.json").read_text())["option"][0]
        self.assertEqual((option["pairs"], option["lost"], option["not_run"]), (20, 0, 10))

    # --- compare, report

    def test_any_two_stores_of_equal_samples_compare(self):
        done = wythe("compare", self.whole / "base", self.whole / "other_wall", "--out", self.out())
        self.assertEqual(done.returncode, 0, done.stderr)
        one = json.loads((self.out() / "comparison.json").read_text())["option"][0]
        all_of = json.loads((self.whole / "comparison.json").read_text())["option"][2]
        self.assertEqual(one["response"], all_of["response"])

    def test_the_report_of_all_is_written_again(self):
        shutil.copytree(self.whole, self.out())
        (self.out() / "comparison.json").unlink()
        done = wythe("report", self.out())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole(self.out())

    def test_other_seeds_are_refused_with_the_first_difference(self):
        plain = self.folder / "seeds.toml"
        plain.write_text(STUDY)
        done = wythe("campaign", plain, "--out", self.out(), "--samples", 2, "--seed", 8, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = wythe("compare", self.whole / "base", self.out(), "--out", self.folder / "never")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"its samples are not those of .*: sample 1 has ft = [\d.]+ MPa in the base, ")
        self.assertIn("[[variant]]", done.stderr)
        self.assertFalse((self.folder / "never").exists())

    def test_one_folder_is_not_two_and_what_is_no_store_is_named(self):
        done = wythe("compare", self.whole / "base", self.whole / "base/", "--out", self.out())
        self.assertEqual(done.returncode, 2)
        self.assertIn("is the same folder as", done.stderr)
        done = wythe("compare", self.whole / "base", self.folder / "absent", "--out", self.out())
        self.assertEqual(done.returncode, 2)
        self.assertIn("holds no campaign", done.stderr)

    def test_the_folder_of_all_is_no_campaign_and_takes_none(self):
        done = wythe("replay", self.whole, "--sample", 1, "--out", self.out())
        self.assertEqual(done.returncode, 2)
        self.assertIn("base", done.stderr)
        plain = self.folder / "into.toml"
        plain.write_text(STUDY)
        done = wythe("campaign", plain, "--out", self.whole, "--quiet")
        self.assertEqual(done.returncode, 2)
        self.assertIn("[[variant]]", done.stderr)

    # --- what stands on it

    def test_the_example_says_what_each_measure_adds(self):
        done = wythe("campaign", SOURCE / "examples/what_if/study.toml", "--out", self.out(), "--samples", 2, "--quiet",
                     "--set", "stage.push.until=1 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [o["name"] for o in json.loads((self.out() / "comparison.json").read_text())["option"]]
        self.assertEqual(names, ["repointed", "steel lintel", "twice the load"])
        tutorial = (SOURCE / "docs/tutorial/is_it_worth_it.md").read_text()
        for name in names:
            self.assertIn(f"{name}: +", tutorial)

    # --- refused

    def test_an_option_may_not_set_what_the_samples_set(self):
        place = 'variant "strong": material.joint.tensile_strength'
        study = STUDY + '[[variant]]\nname = "strong"\nset = ["material.joint.tensile_strength=0.16 MPa"]\n'
        done = self.refused(study, place, "it is set by variable.ft")
        line = study.splitlines().index("[[variant]]") + 1
        self.assertIn(f".toml:{line}: ", done.stderr)
        self.refused(STUDY + '[[variant]]\nname = "c"\nset = ["material.joint.cohesion=0.2 MPa"]\n', "dependent.c")

    def test_an_option_may_not_change_the_samples(self):
        for setting in ("variable.ft.mean=1 MPa", "study.seed=8", "study.samples=3", "correlation.0.rank=0.1"):
            self.refused(STUDY + f'[[variant]]\nname = "o"\nset = ["{setting}"]\n', setting.split("=")[0],
                         "which all options share")

    def test_a_model_without_a_place_for_an_input_is_refused(self):
        dry = re.sub(r"\[material\.joint\]", "[material.mortar]", MODEL)
        (self.folder / "dry.toml").write_text(dry)
        self.refused(STUDY + '[[variant]]\nname = "dry"\nmodel = "dry.toml"\n', 'variant "dry": variable.ft.path', 'mortar')
        self.refused(STUDY + '[[variant]]\nname = "gone"\nmodel = "absent.toml"\n', 'variant "gone"', "absent.toml")

    def test_every_fault_of_every_option_is_told_at_once(self):
        self.refused(STUDY + '[[variant]]\nname = "one"\nset = ["stage.push.velocty=1 mm/s"]\n'
                     '[[variant]]\nname = "two"\nset = ["wall.length=-1 m"]\n',
                     'variant "one": stage.push.velocty', 'variant "two": wall.length')
        self.refused(STUDY + '[[variant]]\nset = ["stage.push.damping=0.4"]\n[[variant]]\nname = "nothing"\n'
                     '[[variant]]\nname = "Base"\nset = []\n[[variant]]\nname = "nothing!"\nset = ["a=1"]\nsett = 1\n',
                     "name", "changes nothing", "what options are compared with", 'the folder nothing of "nothing"', "sett")
        self.refused(STUDY + '[variant.x]\nset = []\n', "two brackets")

    def test_check_looks_at_every_option(self):
        done = wythe("check", self.study)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ('variant "Damped, 0.4"', 'variant "other wall": blocks', "6 samples of each of 4 walls"):
            self.assertIn(word, done.stdout)
        weak = STUDY + '[[variant]]\nname = "brittle"\nset = ["material.joint.mode_1_energy=0.001 N/m"]\n'
        path = self.folder / "brittle.toml"
        path.write_text(weak)
        done = wythe("check", path)
        self.assertIn("mode_1_energy", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
