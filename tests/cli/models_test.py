#!/usr/bin/env python3
"""Models before and after by one command: pushed both ways, compared, summarised in a sentence, resumed, and refused."""
import json
import pathlib
import shutil
import signal
import tempfile
import unittest

from cli_test import Held, wythe

WALL = """
[wall]
length = "1.2 m"
height = "1.0 m"
thickness = "0.2 m"
unit = { length = "200 mm", height = "100 mm", split = "none", density = "2000 kg/m^3" }
[material.joint]
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
tensile_strength = "0.05 MPa"
cohesion = "0.08 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
mode_1_energy = "4 N/m"
mode_2_energy = "20 N/m"
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "floors"
pressure = "0.1 MPa"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.95 m" }
velocity = "3 mm/s"
until = "12 mm"
"""
SCATTER = """
[scatter]
use = "clay_brick"
"""
OPENING = """
[[wall.opening]]
name = "shop"
x = "0.4 m"
y = "0 m"
width = "0.4 m"
height = "0.6 m"
"""
FRAME = """
[[frame]]
name = "F1"
round = "shop"
feet = "fixed"
profile = "HEB 100"
grade = "S275"
joint = "steel_contact"
[material.steel_contact]
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "22 deg"
residual_friction_angle = "22 deg"
compressive_strength = "unlimited"
"""
ASSESSMENT = """
[assessment]
code = "circolare_2019"
confidence_factor = 1.2
added_mass = "3000 kg"
[assessment.spectrum]
kind = "ntc2018"
ground_acceleration = "1.5 m/s^2"
amplification = 2.5
corner_period = "0.30 s"
ground = "A"
"""
STIFFNESS, STRENGTH, DISPLACEMENT = range(3)


class Models(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.before = cls.file("before.toml", WALL + SCATTER)
        cls.after = cls.file("after.toml", WALL + SCATTER + OPENING)
        cls.whole = cls.folder / "whole"
        cls.done = cls.compare(cls.before, cls.after, cls.whole)
        cls.found = cls.json_of(cls.whole)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def file(cls, name, text):
        path = cls.folder / name
        path.write_text(text)
        return path

    @staticmethod
    def compare(before, after, out, *options):
        walls = () if "--walls" in options else ("--walls", 5)
        return wythe("compare", before, after, "--out", out, *walls, "--jobs", 1, "--quiet", *options)

    @staticmethod
    def json_of(out):
        return json.loads((out / "comparison.json").read_text())

    def out(self):
        return self.folder / self._testMethodName

    def changes(self, out):
        return self.json_of(out)["intervention"][0]["change"]

    def refused(self, after, *words, before=None):
        path = self.file(self._testMethodName + ".toml", after)
        done = self.compare(before or self.before, path, self.out())
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out().exists())
        return done

    # --- what it says

    def test_the_sentence_comes_first_with_every_change_its_interval_limit_and_answer(self):
        self.assertIn(self.done.returncode, (0, 3), self.done.stderr)
        sentence = self.done.stdout.splitlines()[0]
        self.assertIn("after.toml against before.toml does not keep within the limits", sentence)
        self.assertRegex(sentence, r"initial stiffness -[\d.]+ % in [+-]x \(95 %: -[\d.]+ to -[\d.]+ %\), may change by 15 %: no")
        self.assertRegex(sentence, r"strength -[\d.]+ % in [+-]x \(95 %: -[\d.]+ to -[\d.]+ %\), must not fall: no")
        self.assertIn("displacement capacity", sentence)
        self.assertIn("not verified", self.done.stdout)
        self.assertEqual(self.found["intervention"][0]["sentence"] in self.done.stdout, True)

    def test_it_is_campaigns_underneath(self):
        shutil.copytree(self.whole, self.out() / "copy")
        for model in ("before", "after"):
            done = wythe("status", self.out() / "copy" / model)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = wythe("report", self.out() / "copy" / model, "--lang", "it")
            self.assertEqual(done.returncode, 0, done.stderr)
            # ways of pushing are no options: they are not compared
            self.assertFalse((self.out() / "copy" / model / "comparison.html").exists())
            self.assertIn('<html lang="it">', (self.out() / "copy" / model / "minus_x_at/report.html").read_text())
        done = wythe("compare", self.out() / "copy/before", "--out", self.out() / "never")
        self.assertEqual(done.returncode, 2)
        self.assertIn("one model, pushed in several ways", done.stderr)
        done = wythe("replay", self.whole / "after/base", "--sample", 3, "--out", self.out() / "replayed", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("bit for bit", done.stdout)

    def test_both_directions_are_pairs_of_the_same_walls(self):
        options = self.found["option"]
        self.assertEqual([o["name"] for o in options], ["after.toml, +x", "after.toml, -x"])
        self.assertEqual([o["base_folder"].split("/")[0] for o in options], ["before", "before"])
        self.assertEqual([o["pairs"] for o in options], [5, 5])
        ways = self.found["intervention"][0]["change"][STIFFNESS]["way"]
        self.assertEqual([w["direction"] for w in ways], ["+x", "-x"])
        for way, option in zip(ways, options):
            self.assertAlmostEqual(way["ratio"], option["response"]["initial_stiffness_kN_per_mm"]["ratio"], places=8)

    def test_units_that_stay_draw_the_same_and_where_they_cannot_it_is_said(self):
        self.assertNotIn("drew other numbers", self.done.stdout)
        field = '[field.ft]\npath = "material.joint.tensile_strength"\ncov = 0.3\nalong = "0.5 m"\nacross = "0.3 m"\n'
        before, after = self.file("field.toml", WALL + field), self.file("field_after.toml", WALL + field + OPENING)
        done = self.compare(before, after, self.out(), "--walls", 2, "--set", "stage.push.until=1 mm")
        self.assertIn("drew other numbers", done.stdout, done.stderr)

    def test_the_page_says_it_in_both_languages(self):
        page = (self.whole / "comparison.html").read_text()
        self.assertTrue("does not keep within the limits" in page)
        shutil.copytree(self.whole, self.out())
        done = self.compare(self.before, self.after, self.out(), "--resume", "--lang", "it")
        self.assertTrue("non resta entro i limiti" in (self.out() / "comparison.html").read_text(), done.stderr)

    def test_report_names_the_command_that_writes_the_page(self):
        done = wythe("report", self.whole, "--lang", "it")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("holds a comparison", done.stderr)
        self.assertIn("--lang it; of models add --resume", done.stderr)

    def test_limits_are_inputs(self):
        shutil.copytree(self.whole, self.out())
        done = self.compare(self.before, self.after, self.out(), "--resume", "--stiffness", "0.9", "--strength", "0.9",
                            "--displacement", "0.99")
        self.assertIn("may change by 90 %: yes", done.stdout, done.stderr)
        self.assertIn("may fall by 90 %: yes", done.stdout)
        self.assertNotIn("not verified", done.stdout)
        for wrong in ("-0.1", "1", "ten", "nan"):
            self.assertEqual(self.compare(self.before, self.after, self.out(), "--resume", "--strength", wrong).returncode, 2)

    def test_a_second_call_needs_resume_and_a_stopped_one_goes_on_to_the_same(self):
        done = self.compare(self.before, self.after, self.whole)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--resume", done.stderr)
        held = Held("sample 3", "compare", self.before, self.after, "--out", self.out(), "--walls", 5, "--jobs", 1)
        said = held.interrupt(signal.SIGTERM)
        self.assertEqual(held.process.returncode, 3, said)
        self.assertIn("--resume", said)
        self.compare(self.before, self.after, self.out(), "--resume")
        same = [o["response"] for o in self.json_of(self.out())["option"]]
        self.assertEqual(same, [o["response"] for o in self.found["option"]])

    def test_an_assessment_tells_the_pga_before_and_after(self):
        before, after = self.file("pga.toml", WALL + ASSESSMENT), self.file("pga_after.toml", WALL + OPENING + ASSESSMENT)
        self.refused(WALL + OPENING + ASSESSMENT.replace("1.5 m/s", "1.4 m/s"), "ground_acceleration", before=before)
        done = self.compare(before, after, self.out(), "--set", "stage.push.until=6 mm")
        self.assertRegex(done.stdout, r"PGA (at least )?0\.\d+ g.* before, (at least )?0\.\d+ g.* after")
        told = self.json_of(self.out())["intervention"][0]["pga_capacity_g"]
        self.assertGreater(told["before"]["median"], told["after"]["median"])

    def test_several_models_have_a_sentence_each(self):
        files = [self.file(f"model_{k}.toml", WALL + more) for k, more in enumerate(("", OPENING, OPENING + FRAME))]
        done = wythe("compare", *files, "--out", self.out(), "--jobs", 1, "--quiet", "--set", "stage.push.until=3 mm")
        for name in ("model_1.toml", "model_2.toml"):
            self.assertIn(f"{name} against model_0.toml", done.stdout, done.stderr)
        self.assertEqual(sorted(p.name for p in self.out().iterdir() if p.is_dir()), ["after_1", "after_2", "before"])
        self.assertEqual(len(self.json_of(self.out())["option"]), 4)

    def test_more_walls_are_added_and_stay(self):
        shutil.copytree(self.whole, self.out())
        for more in (("--walls", 7), ()):
            done = wythe("compare", self.before, self.after, "--out", self.out(), "--jobs", 1, "--quiet", "--resume", *more)
            self.assertEqual([o["pairs"] for o in self.json_of(self.out())["option"]], [7, 7], done.stderr)

    # --- tries to fool it

    def test_swapped_files_give_the_inverse_ratios(self):
        for now, then in (("before", "after"), ("after", "before")):  # pushed already
            shutil.copytree(self.whole / then, self.out() / now)
        self.compare(self.after, self.before, self.out(), "--resume")
        for there, back in zip(self.found["intervention"][0]["change"][:2], self.changes(self.out())[:2]):
            for a, b in zip(there["way"], back["way"]):
                self.assertAlmostEqual(a["ratio"] * b["ratio"], 1, places=7)

    def test_a_model_against_itself_is_no_change(self):
        copy = self.file("copy.toml", WALL + SCATTER)
        done = self.compare(self.before, copy, self.out())
        self.assertIn("no change: all walls are equal to the last bit", done.stdout)
        for change in self.changes(self.out())[:2]:
            for way in change["way"]:
                self.assertEqual((way["ratio"], way["ratio_interval"], way["answer"]), (1, [1, 1], "yes"))
        self.assertNotRegex(done.stdout.splitlines()[0], r"\+[\d.]+ %")

    def test_another_seed_in_the_model_is_refused_since_walls_are_drawn_alike(self):
        self.refused(WALL + SCATTER + "seed = 7\n", "scatter.seed", "before.toml")

    def test_a_push_too_short_gives_no_displacement_capacity(self):
        for until, why in (("0.2 mm", "have no such number"), ("2 mm", "push further")):
            short = WALL.replace('until = "12 mm"', f'until = "{until}"') + SCATTER
            before, after = self.file("short.toml", short), self.file("short_after.toml", short + "# the same\n")
            out = self.out() / until
            done = self.compare(before, after, out)
            self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
            change = self.changes(out)
            self.assertEqual(change[DISPLACEMENT]["answer"], "not known")
            self.assertIsNone(change[DISPLACEMENT]["way"][0]["ratio"])
            self.assertEqual(change[STRENGTH]["answer"], "not known")
            self.assertIn(why, done.stdout)

    def test_a_changed_wall_that_falls_is_answered_no_and_its_reason_is_told(self):
        weak = OPENING.replace('x = "0.4 m"', 'x = "0 m"').replace('width = "0.4 m"', 'width = "0.8 m"')
        path = self.file("falls.toml", WALL + SCATTER + weak)
        done = self.compare(self.before, path, self.out(), "--set", "stage.push.until=1 mm")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"strength in \+x falls to nothing: in 5 of 5 pairs the changed wall falls")
        self.assertRegex(done.stdout, r"note: falls.toml, \+x, wall 1: ")
        self.assertEqual({c["answer"] for c in self.changes(self.out())}, {"no"})

    def test_without_scatter_one_run_each_is_judged_and_said(self):
        before, after = self.file("one.toml", WALL), self.file("one_frame.toml", WALL + OPENING + FRAME)
        done = self.compare(before, after, self.out())
        self.assertIn("changes have no interval", done.stdout)
        found = self.json_of(self.out())["intervention"][0]
        self.assertEqual(found["change"][STIFFNESS]["way"][0]["pairs"], 1)
        self.assertEqual(found["change"][STIFFNESS]["way"][0]["ratio_interval"], [None, None])
        self.assertNotIn("95 %", done.stdout.splitlines()[0])

    def test_a_displacement_that_a_run_cannot_tell_is_not_known_here(self):
        before, after = self.file("doubt.toml", WALL), self.file("doubt_after.toml", WALL + OPENING)
        ran = wythe("run", after, "--out", self.out() / "run", "--quiet")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        promise = json.loads((self.out() / "run/summary.json").read_text())["quasi_static"]["displacement"]
        self.assertEqual(promise["verdict"], "not known")
        self.compare(before, after, self.out() / "compared")
        change = self.changes(self.out() / "compared")[DISPLACEMENT]
        self.assertEqual(change["answer"], "not known")
        self.assertIn("a slower push may give another one", change["way"][0]["why"])
        self.assertIsNone(change["way"][0]["ratio"])

    def test_too_few_walls_have_no_interval_and_no_answer(self):
        done = self.compare(self.before, self.after, self.out(), "--walls", 2)
        self.assertEqual(done.returncode, 3)
        self.assertIn("too few for an interval", done.stdout)

    # --- refused

    def test_what_is_not_comparable_is_refused_by_name_and_line(self):
        done = self.refused(WALL.replace("0.95 m", "0.85 m") + SCATTER + OPENING, "stage.2.at.y", "before.toml")
        self.assertRegex(done.stderr, r"\.toml:\d+: ")
        self.refused(WALL.replace('height = "1.0 m"', 'height = "1.1 m"') + SCATTER, "wall.height")
        self.refused(WALL.replace('height = "100 mm"', 'height = "50 mm"') + SCATTER, "wall.unit.height", "each unit")
        self.refused(WALL.replace("0.1 MPa\"\n[[stage]]", "0.2 MPa\"\n[[stage]]") + SCATTER, "stage.1.pressure")
        self.refused(WALL + SCATTER.replace("clay_brick", "stone"), "scatter.use")
        self.refused(WALL, "scatter", "is given in")
        self.refused(WALL.replace('[[stage]]\nname = "floors"\npressure = "0.1 MPa"\n', "") + SCATTER, "2 stages")

    def test_results_of_something_else_are_not_touched(self):
        self.out().mkdir()
        (self.out() / "comparison.json").write_text("{}")
        for out in (self.out(), self.whole / "before", self.whole / "before/base"):
            done = self.compare(self.before, self.after, out)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn("--out", done.stderr)
        self.assertEqual((self.out() / "comparison.json").read_text(), "{}")

    def test_settings_of_a_study_are_refused(self):
        self.assertEqual(self.compare(self.before, self.after, self.out(), "--set", "study.seed=3").returncode, 2)

    def test_faults_of_all_models_are_told_at_once(self):
        wrong = self.file("wrong.toml", WALL.replace("1.2 m", "-1 m"))
        self.refused(WALL.replace("30 deg", "30 m"), "wrong.toml", self._testMethodName, before=wrong)

    def test_walls_that_were_pushed_are_compared_from_their_folders(self):
        def compare(*words):
            return wythe("compare", self.whole / "before", self.whole / "after", "--out", self.out(), *words)
        done = compare()
        self.assertEqual(done.returncode, self.done.returncode, done.stderr)
        again = self.json_of(self.out())
        for one in (*again["intervention"], *self.found["intervention"]):
            one.pop("name", None), one["sentence_message"].pop("arguments", None), one.pop("sentence")
        self.assertEqual(again["intervention"][0]["change"], self.found["intervention"][0]["change"])
        self.assertIn("may fall by 60 %", compare("--strength", "0.6").stdout)
        self.assertEqual(self.changes(self.out())[STRENGTH]["limit"], "asked")
        for option, value in (("--walls", 8), ("--seed", 1), ("--set", "wall.length=1 m")):
            done = compare(option, value)
            self.assertEqual(done.returncode, 2)
            self.assertIn("leave it out", done.stderr)

    def test_walls_that_were_pushed_in_other_ways_are_refused(self):
        one_way = self.folder / "one_way"
        shutil.copytree(self.whole / "after/base", one_way / "base")
        done = wythe("compare", self.whole / "before", one_way, "--out", self.out())
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("one_way: was pushed in other ways than", done.stderr)
        self.assertFalse(self.out().exists())

    def test_a_run_of_one_wall_names_the_command_that_compares_its_model(self):
        runs = [self.folder / "run_before", self.folder / "run_after"]
        for model, out in zip((self.before, self.after), runs):
            self.assertEqual(wythe("run", model, "--out", out, "--quiet", "--set", "stage.push.until=0.2 mm").returncode, 0)
        done = wythe("compare", *runs, "--out", self.out())
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("run_before: is a run of one wall, pushed one way", done.stderr)
        self.assertIn("wythe compare run_before/model.used.toml".replace("run_before", str(runs[0])), done.stderr)

    def test_files_and_folders_do_not_mix_and_one_model_is_none_to_compare(self):
        done = self.compare(self.before, self.whole / "after/base", self.out())
        self.assertEqual(done.returncode, 2)
        self.assertIn("which is none", done.stderr)
        done = wythe("compare", self.before, "--out", self.out())
        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing to be compared with", done.stderr)
        done = wythe("compare", self.whole / "before/base", self.whole / "after/base", "--out", self.out(), "--walls", 8)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--walls", done.stderr)


if __name__ == "__main__":
    unittest.main()
