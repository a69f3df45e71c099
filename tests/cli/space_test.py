#!/usr/bin/env python3
"""Walls in space from the command line: a mesh gives the files of a run, and inputs without support in
space are refused with their names."""
import json
import os
import pathlib
import sqlite3
import tempfile
import unittest

from cli_test import SOURCE, Held, wythe

# a block 0.3 x 0.2 x 1.2 m (z up) on a slab
OBJ = """o slab
v -1 -1 -0.2
v 1 -1 -0.2
v 1 1 -0.2
v -1 1 -0.2
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
o block
v -0.15 -0.1 0
v 0.15 -0.1 0
v 0.15 0.1 0
v -0.15 0.1 0
v -0.15 -0.1 1.2
v 0.15 -0.1 1.2
v 0.15 0.1 1.2
v -0.15 0.1 1.2
f 12 11 10 9
f 13 14 15 16
f 9 10 14 13
f 10 11 15 14
f 11 12 16 15
f 12 9 13 16
"""
MODEL = """
[wall]
blocks = "block.obj"
blocks_unit = "m"
supports = ["lowest"]
[wall.unit]
density = "2000 kg/m^3"
[material.joint]
use = "limestone_dry"
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
friction_tan = 2.0
residual_friction_tan = 2.0
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "force"
direction = "{direction}"
rate = "0.02 1/s"
factor = 0.5
"""


# three courses in two leaves tied by headers, pushed out of their plane until they crack
def two_leaves():
    blocks = [{"id": "floor", "polygon": [[-0.2, -0.1], [1, -0.1], [1, 0], [-0.2, 0]], "z": [-0.2, 0.4],
               "fixed": True}]
    for course in range(3):
        y = 0.1 * course
        for k in range(4):
            x = 0.2 * k
            outline = [[x, y], [x + 0.2, y], [x + 0.2, y + 0.1], [x, y + 0.1]]
            leaves = [[0, 0.2]] if (course + k) % 2 else [[0, 0.1], [0.1, 0.2]]
            blocks += [{"id": f"c{course}u{k}z{leaf}", "polygon": outline, "z": z}
                       for leaf, z in enumerate(leaves)]
    return json.dumps({"units": "m", "blocks": blocks})


MORTAR = """
[wall]
blocks = "leaves.json"
[wall.unit]
density = "1800 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.02 MPa"
cohesion = "0.006 MPa"
friction_angle = "16 deg"
residual_friction_angle = "16 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "1 N/m"
mode_2_energy = "60 N/m"
compressive_strength = "3.96 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { block = "c2*" }
along = [1, 0, 0.6]
velocity = "10 mm/s"
until = "1 mm"
"""
STUDY = """
[study]
name = "two leaves"
model = "model.toml"
design = "latin_hypercube"
samples = 9
seed = 7
read_modes_at = "0.5 mm"
[variable.ft]
path = "material.joint.tensile_strength"
unit = "MPa"
distribution = "lognormal"
mean = "0.02 MPa"
cov = 0.3
[dependent.cohesion]
path = "material.joint.cohesion"
unit = "MPa"
formula = "0.3 * ft"
[dependent.residual]
path = "material.joint.residual_friction_angle"
unit = "deg"
formula = "phi"
[variable.phi]
path = "material.joint.friction_angle"
unit = "deg"
distribution = "normal"
mean = "16 deg"
cov = 0.2
lower = "2 deg"
"""


class Space(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "block.obj").write_text(OBJ, encoding="utf-8")

    def model(self, text):
        path = self.folder / "model.toml"
        path.write_text(text, encoding="utf-8")
        return path

    def run_to(self, text):
        out = self.folder / "out"
        ended = wythe("run", self.model(text), "--out", out)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return ended, json.loads((out / "summary.json").read_text(encoding="utf-8"))

    def test_limit_load_of_a_block_that_overturns(self):
        out = self.folder / "limit"
        done = wythe("limit", self.model(MODEL.format(direction="+x")), "--out", out, "--only", "lp")
        self.assertEqual(done.returncode, 0, done.stderr)
        limits = json.loads((out / "mechanisms.json").read_text(encoding="utf-8"))["limit_loads"]
        for limit in limits:
            self.assertAlmostEqual(limit["static"], 0.3 / 1.2, 6)
            self.assertLess(abs(limit["gap"]), 1e-6)
            self.assertLessEqual(limit["friction_excess"], 1e-4)
            self.assertEqual(len(limit["velocity_z"]), 1)
        self.assertTrue((out / "report.html").stat().st_size > 10000)

    def test_a_block_of_a_mesh_overturns_about_the_edge_in_the_files_axes(self):
        for direction, ratio in (("+x", 0.3 / 1.2), ("-y", 0.2 / 1.2)):
            ended, summary = self.run_to(MODEL.format(direction=direction))
            self.assertEqual(summary["blocks"], 1)
            self.assertEqual(summary["status"], "collapsed")
            self.assertAlmostEqual(summary["load_factor"] / ratio, 1, delta=0.01)

    def test_states_are_polyhedra(self):
        self.run_to(MODEL.format(direction="+x"))
        text = (self.folder / "out" / "state_blocks_00.vtu").read_text(encoding="utf-8")
        self.assertIn('Name="faces"', text)
        self.assertIn('Name="faceoffsets"', text)

    def test_the_folder_of_a_run_can_be_run_again(self):
        _, first = self.run_to(MODEL.format(direction="-y"))
        again = self.folder / "again"
        ended = wythe("run", self.folder / "out" / "model.used.toml", "--out", again)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        second = json.loads((again / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(second["state_hash"], first["state_hash"])

    def test_what_space_has_not_is_refused_by_name(self):
        tie = MODEL.format(direction="+x") + (
            '[[tie]]\nname = "t"\nfrom = { block = "block" }\nto = { x = "1 m", y = "1 m" }\n'
            'anchored = true\narea = "100 mm^2"\nyoungs_modulus = "200 GPa"\n')
        ended = wythe("check", self.model(tie))
        self.assertEqual(ended.returncode, 2)
        self.assertIn("tie", ended.stderr)
        ended = wythe("limit", self.model(MODEL.format(direction="+x")), "--out", self.folder / "l",
                      "--only", "infinite")
        self.assertEqual(ended.returncode, 2, ended.stdout)
        self.assertIn("macro-blocks are for plane walls", ended.stderr)

    def test_a_contact_of_blocks_that_the_wall_has_not_is_refused(self):
        contact = '[[contact]]\nbetween = ["mason", "ground"]\nmaterial = "joint"\n'
        ended = wythe("check", self.model(MODEL.format(direction="+x") + contact))
        self.assertEqual(ended.returncode, 2, ended.stdout)
        self.assertIn("mason", ended.stderr)
        self.assertIn("known here: ground, masonry", ended.stderr)

    def test_the_example_runs(self):
        ended = wythe("check", SOURCE / "examples/wall_with_returns/model.toml")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertIn("57", ended.stdout)


class Campaign(unittest.TestCase):
    """Nine samples of a wall in space: more than one filling of the lanes. No bit depends on how they were run."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "leaves.json").write_text(two_leaves(), encoding="utf-8")
        (cls.folder / "model.toml").write_text(MORTAR, encoding="utf-8")
        (cls.folder / "study.toml").write_text(STUDY, encoding="utf-8")
        cls.whole = cls.folder / "whole"
        cls.done = cls.campaign("whole", "--jobs", 1)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def campaign(cls, name, *more, **options):
        return wythe("campaign", cls.folder / "study.toml", "--out", cls.folder / name, "--quiet", *more, **options)

    def hashes(self, name):
        with sqlite3.connect(self.folder / name / "campaign.db") as store:
            return store.execute("SELECT sample, state_hash FROM sample ORDER BY sample").fetchall()

    def assert_equals_whole(self, name):
        self.assertEqual(self.hashes(name), self.hashes("whole"))
        self.assertEqual((self.folder / name / "samples.csv").read_bytes(), (self.whole / "samples.csv").read_bytes())

    def test_each_sample_is_a_wall_of_its_own(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(len({state for _, state in self.hashes("whole")}), 9)
        with sqlite3.connect(self.whole / "campaign.db") as store:
            rows = store.execute("SELECT status, energy_fracture_J, energy_friction_J FROM sample").fetchall()
        for status, fracture, friction in rows:
            self.assertEqual(status, "completed")
            self.assertGreater(fracture, 0)  # they cracked and slid: the bits below mean something
            self.assertGreater(friction, 0)

    def test_neither_jobs_nor_lanes_change_a_bit(self):
        for name, more, simd in (("two jobs", ("--jobs", 2), None), ("scalar", ("--jobs", 1), "scalar")):
            done = self.campaign(name, *more, env=os.environ | ({"WYTHE_SIMD": simd} if simd else {}))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assert_equals_whole(name)

    def test_shards_merge_to_the_whole(self):
        shards = [self.folder / f"shard_{i}" for i in (1, 2)]
        for i, shard in enumerate(shards, 1):
            done = self.campaign(shard.name, "--shard", f"{i}/2")
            self.assertEqual(done.returncode, 0, done.stderr)
        done = wythe("merge", *shards, "--out", self.folder / "merged")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole("merged")

    def test_a_campaign_that_was_stopped_resumes_to_the_same_bits(self):
        held = Held("sample 2", "campaign", self.folder / "study.toml", "--out", self.folder / "stopped",
                    "--jobs", "1")
        held.kill()
        self.assertLess(len(self.hashes("stopped")), 9)
        done = self.campaign("stopped", "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_equals_whole("stopped")

    def test_a_replay_equals_its_sample_bit_for_bit(self):
        for sample in (1, 9):
            out = self.folder / f"replay_{sample}"
            done = wythe("replay", self.whole, "--sample", sample, "--out", out, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("equals that of the campaign, bit for bit", done.stdout)
            self.assertTrue((out / "state_blocks_00.vtu").exists())


if __name__ == "__main__":
    unittest.main()
