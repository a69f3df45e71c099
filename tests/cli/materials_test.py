#!/usr/bin/env python3
"""Materials by rule and typology, from the command line: the list, a run and its files, a stiff crack plane."""
import json
import pathlib
import unittest
import zlib

from cli_test import SMALL, Base, wythe

HEAD, STAGES = SMALL[:SMALL.index("[material.joint]")], SMALL[SMALL.index("[[stage]]"):]
RULES = HEAD + """
[masonry]
unit_type = "clay"
unit_strength = "15 MPa"
masonry_strength = "6 MPa"
youngs_modulus = "3 GPa"
shear_modulus = "rule"
unit_youngs_modulus = "9 GPa"
initial_shear_strength = "0.2 MPa"
friction_tan = 0.7
vertical_stress = "0.15 MPa"
[material.joint]
missing = "rule"
[material.unit]
missing = "rule"
""" + STAGES


class Materials(Base):
    def write(self, text, name="rules.toml"):
        path = pathlib.Path(self.temporary.name) / name
        path.write_text(text)
        return path

    def test_the_list_names_every_material_and_rule_and_each_explains_itself(self):
        names = [line.split()[0] for line in wythe("materials").stdout.splitlines() if line.startswith("  ")]
        self.assertGreater(len(names), 40)
        for name in names:
            done = wythe("materials", name)
            self.assertEqual(done.returncode, 0, name)
            self.assertIn("source: ", done.stdout, name)
        done = wythe("materials", "circolare_brik_lime")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean circolare_brick_lime?", done.stderr)

    def test_a_used_model_runs_again_to_the_same_bits_without_rules(self):
        first, again = self.out, pathlib.Path(self.temporary.name) / "again"
        done = wythe("run", self.write(RULES), "--out", first, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        used = (first / "model.used.toml").read_text()
        self.assertNotIn('= "rule', used)
        self.assertIn("tensile_strength 0.5", used)
        self.assertIn("derived by unit_ft_from_fb from unit_strength 15 MPa", used)
        self.assertIn("head_joint_bond = 0.25", used)
        self.assertIn("head_joint_bond 0.25: derived by head_joint_quarter", used)
        wythe("run", first / "model.used.toml", "--out", again, "--quiet")
        hashes = [json.loads((folder / "summary.json").read_text())["state_hash"] for folder in (first, again)]
        self.assertEqual(*hashes)
        self.assertEqual(used, (again / "model.used.toml").read_text())

    def test_check_says_what_head_joints_have_and_a_share_changes_the_wall(self):
        told = "head joints of [material.joint] have 0.25 of the tensile strength and cohesion of its beds (head_joint_bond)"
        self.assertIn(told, wythe("check", self.write(RULES)).stdout)
        hashes = []
        for setting in ("material.joint.head_joint_bond=1", "wall.head_joint=joint", "material.joint.head_joint_bond=0", "wall.bond=running"):
            self.assertEqual("have 0.25" in wythe("check", self.write(RULES), "--set", setting).stdout, setting == "wall.bond=running", setting)
            done = wythe("run", self.write(RULES), "--out", self.out, "--quiet", "--set", setting, "--set", "stage.push.until=0.2 mm")
            self.assertEqual(done.returncode, 0, done.stderr)
            hashes.append(json.loads((self.out / "summary.json").read_text())["state_hash"])
        self.assertEqual(hashes[0], hashes[1])  # as the beds, said in two ways
        self.assertEqual(len(set(hashes)), 3)
        done = wythe("check", self.write(RULES), "--set", "material.joint.head_joint_bond=1.5")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--set: material.joint.head_joint_bond = 1.5: ", done.stderr)

    LEFT_OUT = "is stated, so mode_2_energy_per_pressure is 0 and not the 0.13 mm of its rule"
    ENERGY = "material.joint.mode_2_energy=100 N/m"

    def test_check_run_page_and_used_model_tell_of_a_slope_that_a_stated_energy_leaves_out(self):
        told = "note: material.joint.mode_2_energy " + self.LEFT_OUT
        model = self.write(RULES)
        self.assertNotIn("per_pressure", wythe("check", model).stdout)
        self.assertEqual(wythe("check", model, "--set", self.ENERGY).stdout.count(told), 1)
        done = wythe("run", model, "--out", self.out, "--set", self.ENERGY, "--set", "stage.push.until=0.1 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(self.LEFT_OUT, done.stdout + done.stderr)
        page = zlib.decompress((self.out / "report.data").read_bytes()).decode(errors="replace")  # src/report/bundle.cpp
        self.assertIn(self.LEFT_OUT, page)
        self.assertIn("0 e non 0,13 mm come da regola", page)
        used, again = (self.out / "model.used.toml").read_text(), pathlib.Path(self.temporary.name) / "again"
        done = wythe("run", self.out / "model.used.toml", "--out", again)
        self.assertIn(self.LEFT_OUT, done.stdout + done.stderr)
        self.assertEqual(used, (again / "model.used.toml").read_text())

    def test_a_study_tells_once_of_a_slope_that_its_base_an_input_or_options_leave_out(self):
        self.write(RULES)
        study = """[study]
model = "rules.toml"
samples = 3
seed = 1
[variable.x]
path = "material.joint.tensile_strength"
distribution = "lognormal"
mean = "0.1 MPa"
cov = 0.2
"""
        options = "".join(f'[[variant]]\nname = "{name}"\nset = ["{setting}"]\n' for name, setting in
                          (("one", "material.joint.mode_1_energy=5 N/m"), ("two", self.ENERGY), ("three", self.ENERGY)))

        def said(text):
            return wythe("check", self.write(text, "study.toml")).stdout
        self.assertNotIn(self.LEFT_OUT, said(study))
        text = said(study + options)
        self.assertEqual(text.count(self.LEFT_OUT), 1, text)
        self.assertLess(text.index('variant "two"'), text.index(self.LEFT_OUT))
        text = said(study.replace("tensile_strength", "mode_2_energy").replace("0.1 MPa", "100 N/m"))
        self.assertEqual(text.count("mode_2_energy by variable.x " + self.LEFT_OUT), 1, text)
        self.assertEqual(text.count(self.LEFT_OUT), 1, text)
        self.write(RULES.replace("[material.joint]", '[material.joint]\nmode_2_energy = "100 N/m"'))
        text = said(study + options)
        self.assertEqual(text.count(self.LEFT_OUT), 1, text)

    def test_a_knowledge_level_divides_and_the_page_shows_the_way(self):
        office = HEAD + """
[masonry]
use = "circolare_brick_lime"
knowledge_level = "LC1"
injections = true
unit_strength = "rule"
unit_youngs_modulus = "rule: unit_e_is_e"
vertical_stress = "0.15 MPa"
[material.joint]
missing = "rule"
[material.unit]
missing = "rule"
[assessment]
code = "circolare_2019"
[assessment.spectrum]
kind = "en1998"
ground_acceleration = "1 m/s^2"
""" + STAGES
        done = wythe("run", self.write(office), "--out", self.out, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        said = json.loads((self.out / "summary.json").read_text())["assessment"]
        self.assertEqual(said["confidence_factor"], 1.35)
        self.assertTrue(any("took the typology's values for LC1" in note for note in said["notes"]), said["notes"])
        self.assertNotIn("no strength was divided", said["sentence"])
        page = zlib.decompress((self.out / "report.data").read_bytes()).decode(errors="replace")  # src/report/bundle.cpp
        self.assertIn("minimum 2.6 MPa x 1.2 injections / 1.35", page)
        used = (self.out / "model.used.toml").read_text()
        self.assertNotIn("knowledge_level", used)
        self.assertIn("masonry_strength 2.31111 MPa: typical of circolare_brick_lime at LC1", used)
        again = pathlib.Path(self.temporary.name) / "again"
        wythe("run", self.out / "model.used.toml", "--out", again, "--quiet")
        self.assertEqual(used, (again / "model.used.toml").read_text())
        # the same without the level: undivided, and not to be signed for that
        wythe("run", self.write(office.replace('knowledge_level = "LC1"\ninjections = true\n', "")
                                .replace('[assessment]\n', '[assessment]\nconfidence_factor = 1.35\n')), "--out", self.out, "--quiet")
        said = json.loads((self.out / "summary.json").read_text())["assessment"]
        self.assertIn("no strength was divided", said["sentence"])

    def test_the_list_prints_values_of_each_level_and_coefficients(self):
        said = wythe("materials", "circolare_brick_lime").stdout
        for words in ("LC1", "1.926 MPa", "2.875 MPa", "fm^0.35", "transverse_connection", "weight"):
            self.assertIn(words, said)
        self.assertNotIn("courses ", said)
        self.assertNotIn("LC1", wythe("materials", "clay_brick_old").stdout)

    def test_check_says_what_a_published_crack_plane_costs(self):
        stiff = RULES.replace('[material.unit]\n', '[material.unit]\nnormal_stiffness = "1e6 N/mm^3"\n'
                                                   'shear_stiffness = "1e6 N/mm^3"\n')
        said = wythe("check", self.write(stiff)).stdout
        self.assertIn("times as many steps", said)
        self.assertIn("kn = Eu/(l/2), here 90 GPa/m", said)  # 2 x 9 GPa / 200 mm
        self.assertNotIn("warning", wythe("check", self.write(RULES)).stdout)

    def test_a_campaign_follows_a_varied_input(self):
        self.write(RULES)
        study = self.write('[study]\nmodel = "rules.toml"\nsamples = 3\nseed = 1\n[variable.fm]\n'
                           'path = "masonry.masonry_strength"\ndistribution = "lognormal"\nmean = "6 MPa"\n'
                           'cov = 0.2\n', "study.toml")
        done = wythe("campaign", study, "--out", self.out, "--quiet", "--set", "stage.push.until=0.2 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        sample = pathlib.Path(self.temporary.name) / "sample"
        done = wythe("replay", self.out, "--sample", 2, "--out", sample, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        used = (sample / "model.used.toml").read_text()
        self.assertIn("compressive_strength", used)
        self.assertNotIn('compressive_strength = "6 MPa"', used)
        self.assertIn("derived by fc_is_fm from masonry_strength", used)
        self.assertIn("head_joint_bond = 0.25", used)


if __name__ == "__main__":
    unittest.main()
