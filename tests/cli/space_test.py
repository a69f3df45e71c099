#!/usr/bin/env python3
"""Walls in space from the command line: a mesh goes in, the files of a run come out, and what is not to be had in
space is refused by name."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

WYTHE = os.environ.get("WYTHE", "build/release/wythe")
SOURCE = pathlib.Path(os.environ.get("SOURCE", "."))

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


def wythe(*arguments):
    return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True)


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
        ended = wythe("limit", self.model(MODEL.format(direction="+x")), "--out", self.folder / "l")
        self.assertEqual(ended.returncode, 2, ended.stdout)
        self.assertIn("space", ended.stderr)

    def test_the_example_runs(self):
        ended = wythe("check", SOURCE / "examples/wall_with_returns/model.toml")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertIn("57", ended.stdout)


if __name__ == "__main__":
    unittest.main()
