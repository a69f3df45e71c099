#!/usr/bin/env python3
"""Buildings in space from the command line: floor slabs, roles, studies of the builder's keys, fields, assessment, tables."""
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from cli_test import Held

WYTHE = os.environ.get("WYTHE", "build/release/wythe")

JOINT = """
[material.joint]
use = "limestone_dry"
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
friction_tan = 0.6
residual_friction_tan = 0.6
compressive_strength = "unlimited"
"""
PIERS = """
[wall]
height = "0.9 m"
thickness = "0.3 m"
[wall.unit]
length = "1.2 m"
height = "0.3 m"
density = "2000 kg/m^3"
split = "none"
[[plan_wall]]
name = "left"
line = [["0 m", "0 m"], ["0 m", "1.2 m"]]
[[plan_wall]]
name = "right"
line = [["3 m", "0 m"], ["3 m", "1.2 m"]]
[[slab]]
name = "deck"
walls = ["left", "right"]
bearing = "150 mm"
thickness = "0.2 m"
material = "concrete"
joint = "bearing"
load = "2 kPa"
[material.concrete]
density = "2500 kg/m^3"
""" + JOINT + JOINT.replace("joint", "bearing").replace("0.6", "0.4")
GRAVITY = """
[[stage]]
name = "gravity"
"""
PUSH = """
[[stage]]
name = "push"
at = { role = "slab" }
direction = "-x"
velocity = "10 mm/s"
until = "3 mm"
damping = 0.4
"""
# A pier in its plane: 0.6 m wide, squat enough to slide or rock at once.
PIER = """
[wall]
height = "0.9 m"
thickness = "0.2 m"
[wall.unit]
length = "300 mm"
height = "150 mm"
density = "2000 kg/m^3"
split = "none"
[[plan_wall]]
name = "front"
line = [["0 m", "0 m"], ["0.6 m", "0 m"]]
""" + JOINT + GRAVITY


def wythe(*arguments):
    return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True)


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class BuildingInSpace(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def summary(self, name, *arguments):
        out = self.folder / name
        ended = wythe(*arguments, "--out", out, "--quiet")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return json.loads((out / "summary.json").read_text(encoding="utf-8"))

    def refused(self, path, *words):
        ended = wythe("check", path)
        self.assertEqual(ended.returncode, 2, ended.stdout)
        for word in words:
            self.assertIn(word, ended.stderr)

    # Samples differ, and each is what its replay is: same curve, to the digits of the tables.
    def assert_replays(self, out):
        ended = wythe("export", out, "--out", self.folder / "tables")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        last = {row["sample"]: row["reaction_kN"] for row in rows(self.folder / "tables/curves.csv")}
        self.assertEqual(len(set(last.values())), 3, last)
        for number in (1, 2, 3):
            self.summary(f"replay{number}", "replay", out, "--sample", number)
            own = rows(self.folder / f"replay{number}/force_displacement.csv")[-1]["reaction_kN"]
            self.assertAlmostEqual(float(own), float(last[str(number)]), delta=1e-9 + 1e-6 * abs(float(own)))

    def test_a_slab_is_told_runs_and_its_folder_runs_again(self):
        model = self.file("model.toml", PIERS + GRAVITY + PUSH)
        told = wythe("check", model).stdout
        self.assertIn("slab deck: underside at 0.900 m", told)
        self.assertIn("on the walls left, right", told)
        first = self.summary("first", "run", model)
        again = self.summary("again", "run", self.folder / "first/model.used.toml")
        self.assertEqual(first["state_hash"], again["state_hash"])
        blocks = json.loads((self.folder / "first/blocks.json").read_text(encoding="utf-8"))["blocks"]
        self.assertEqual([b["role"] for b in blocks if b["id"] == "deck"], ["slab"])
        # friction of the bearing holds less than that of the walls' joints: the slab slides off by itself
        slid = 0.4 * (3.0 * 1.2) * (0.2 * 2500 * 9.81 + 2000) * 1e-3
        self.assertLess(first["peak_reaction_kN"], 1.02 * slid)
        free = self.summary("free", "run", model, "--set", "slab.deck.load=0 kPa")
        self.assertLess(free["peak_reaction_kN"], first["peak_reaction_kN"])

    # Killed after a checkpoint, resumed, killed again: the state of a run that nobody disturbed, to the last bit.
    def test_a_building_that_was_killed_ends_as_if_nobody_had(self):
        model = self.file("model.toml", PIERS + GRAVITY + PUSH)
        whole = self.summary("whole", "run", model)
        out = self.folder / "killed"
        Held("checkpoint 2 written", "run", model, "--out", out, "--checkpoint", "1 ns", "--quiet").kill()
        Held("checkpoint 1 written", "run", "--resume", out, "--quiet").kill()
        ended = wythe("run", "--resume", out, "--quiet")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        after = json.loads((out / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(after["state_hash"], whole["state_hash"])
        self.assertEqual(after["peak_reaction_kN"], whole["peak_reaction_kN"])

    # Tables in another order number blocks and joints otherwise: sums round otherwise, no more. Below the slab's sliding
    # that is 1e-9 of the force; friction that yields does not spread it, so the peak holds it too.
    def test_the_order_of_the_tables_does_not_matter(self):
        head, rest = PIERS.split("[[plan_wall]]", 1)
        left, rest = rest.split("[[plan_wall]]", 1)
        right, rest = rest.split("[[slab]]", 1)
        materials = rest.split("[material.concrete]", 1)[1]
        decks = [f"""
[[slab]]
name = "deck{k}"
outline = [["0 m", "{z} m"], ["3 m", "{z} m"], ["3 m", "{z + 0.5} m"], ["0 m", "{z + 0.5} m"]]
level = "0.9 m"
thickness = "0.2 m"
material = "concrete"
joint = "bearing"
load = "{1 + k} kPa"
""" for k, z in enumerate((0.0, 0.7))]
        walls = ["[[plan_wall]]" + left, "[[plan_wall]]" + right]
        materials = "[material.concrete]" + materials
        answers = []
        for order in (1, -1):
            text = head + "".join(walls[::order]) + "".join(decks[::order]) + materials + GRAVITY + PUSH
            name = f"order{order}"
            summary = self.summary(name, "run", self.file(f"{name}.toml", text))
            curve = [float(row["reaction_kN"]) for row in rows(self.folder / name / "force_displacement.csv")]
            answers.append((summary, curve))
        (first, one), (second, other) = answers
        self.assertEqual((first["blocks"], first["joints"]), (second["blocks"], second["joints"]))
        self.assertEqual(first["failure_mode"]["name"], second["failure_mode"]["name"])
        self.assertEqual(len(one), len(other))
        peak = max(map(abs, one))
        self.assertGreater(peak, 1)
        self.assertLess(max(abs(a - b) for a, b in zip(one, other)), 1e-6 * peak)
        self.assertAlmostEqual(first["peak_reaction_kN"], second["peak_reaction_kN"], delta=1e-6 * peak)

    # A wall that falls about its foot: its blocks turn about x, and rotation_mrad, about z alone, says nothing of it.
    def test_rotations_in_space_are_told_about_all_axes(self):
        push = '[[stage]]\nname = "push"\nat = { block = "front.c05*" }\ndirection = "+z"\nvelocity = "5 mm/s"\nuntil = "20 mm"\n'
        self.summary("run", "run", self.file("model.toml", PIER.replace('"0.2 m"', '"0.1 m"') + push))
        ended = wythe("export", self.folder / "run", "--out", self.folder / "tables")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        table = rows(self.folder / "tables/state_blocks.csv")
        for row in table:
            about = [float(row[f"rotation_{axis}_mrad"]) for axis in "xyz"]
            self.assertAlmostEqual(float(row["rotation_total_mrad"]), math.hypot(*about), delta=1e-9)
            self.assertEqual(float(row["rotation_mrad"]), about[2])
        top = table[-1]
        self.assertAlmostEqual(float(top["displacement_z_mm"]), 20, delta=1)
        lean = float(top["displacement_z_mm"]) / (float(top["y_m"]))  # of a wall that turns about its foot, small angles
        self.assertAlmostEqual(float(top["rotation_total_mrad"]), lean, delta=0.05 * lean)
        self.assertLess(abs(float(top["rotation_mrad"])), 0.01 * lean)
        # a run of before has rotation_mrad alone, and its table too
        for path in (self.folder / "run").glob("state_blocks_*.vtu"):
            path.write_bytes(path.read_bytes().replace(b"rotation_total_mrad", b"rotation_other_mrad"))
        ended = wythe("export", self.folder / "run", "--out", self.folder / "before")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertNotIn("rotation_x_mrad", rows(self.folder / "before/state_blocks.csv")[0])
        self.assertEqual(float(rows(self.folder / "before/state_blocks.csv")[-1]["rotation_mrad"]), float(top["rotation_mrad"]))

    # More inertia than that of a lintel's own part of the wall would brake what moves: the step pays for the rest.
    def test_a_light_lintel_of_zones_does_not_drag(self):
        text = PIER.replace('line = [["0 m", "0 m"], ["0.6 m", "0 m"]]', '''line = [["0 m", "0 m"], ["1.8 m", "0 m"]]
[[plan_wall.opening]]
x = "0.6 m"
y = "0 m"
width = "0.6 m"
height = "0.6 m"
lintel = { kind = "timber", bearing = "150 mm", depth = "150 mm", material = "timber", model = "zones" }
[material.timber]
density = "600 kg/m^3"
youngs_modulus = "10 GPa"
shear_modulus = "4.2 GPa"''')
        push = '[[stage]]\nname = "push"\nat = { block = "front.c05*" }\ndirection = "+x"\nvelocity = "5 mm/s"\nuntil = "1 mm"\ndamping = 0.2\n'
        model = self.file("model.toml", text + push)
        told = wythe("check", model).stdout
        self.assertRegex(told, r"lintel0: inertia .* 3\.0 % of the wall's, .* times shorter than rigid blocks need")
        own, raised = (self.summary(name, "run", model, "--set", f"solve.raise_light_inertia={name}") for name in ("false", "true"))
        self.assertGreater(raised["time_step_s"], own["time_step_s"])
        self.assertAlmostEqual(raised["peak_reaction_kN"] / own["peak_reaction_kN"], 1, delta=0.02)
        self.assert_tells_zones(self.folder / "true")

    # Of the lintel: all zones of each state, six stresses whose invariants are those of the principal ones; at rest it sags,
    # pulled below and pressed above.
    def assert_tells_zones(self, run):
        ended = wythe("export", run, "--out", self.folder / "zones")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        table = rows(self.folder / "zones/state_zones.csv")
        states = {row["state"] for row in table}
        self.assertEqual(len(table), len(states) * len({row["zone"] for row in table}))
        for row in table:
            xx, yy, zz, xy, yz, zx = (float(row[f"stress_{name}_MPa"]) for name in ("x", "y", "z", "xy", "yz", "zx"))
            p = [float(row[f"principal_{k}_MPa"]) for k in (1, 2, 3)]
            size = max(abs(one) for one in p) + 1e-9
            self.assertEqual(p, sorted(p, reverse=True))
            self.assertAlmostEqual(sum(p), xx + yy + zz, delta=1e-6 * size)
            second = xx * yy + yy * zz + zz * xx - xy * xy - yz * yz - zx * zx
            self.assertAlmostEqual(p[0] * p[1] + p[1] * p[2] + p[2] * p[0], second, delta=1e-6 * size * size)
            self.assertTrue(0.45 <= float(row["x_m"]) <= 1.35 and 0.6 <= float(row["y_m"]) <= 0.75 and 0 < abs(float(row["z_m"])) < 0.1)
        first = [row for row in table if row["state"] == "0" and abs(float(row["x_m"]) - 0.9) < 0.1]
        below, above = ([float(row["stress_x_MPa"]) for row in first if (float(row["y_m"]) > 0.675) == high] for high in (False, True))
        self.assertGreater(min(below), max(above))
        columns = json.loads((self.folder / "zones/columns.json").read_text(encoding="utf-8"))
        self.assertIn("stress_zx_MPa", json.dumps(columns))
        self.assertIn("lintel_deflection_mm", rows(run / "force_displacement.csv")[0])

    def test_roles_are_words_that_are_known(self):
        self.refused(self.file("a.toml", PIERS + GRAVITY + PUSH.replace('"slab"', '"slap"')), "is no role", "slab")
        self.refused(self.file("b.toml", PIERS + GRAVITY + PUSH.replace('"slab"', '"lintel"')), "finds no block")

    def test_bad_slabs_are_refused_with_place_value_and_cure(self):
        model = PIERS + GRAVITY
        self.refused(self.file("a.toml", model.replace('"150 mm"', '"450 mm"')), "slab.0.bearing", "0.45 m", "thick")
        self.refused(self.file("b.toml", model.replace('["left", "right"]', '["left", "rihgt"]')), "slab.0.walls.1", "right")
        self.refused(self.file("c.toml", model.replace('thickness = "0.2 m"\nmaterial', 'level = "0.5 m"\nthickness = "0.2 m"\nmaterial')),
                     "slab.0.level", "bed joint")
        self.refused(self.file("d.toml", model.replace('joint = "bearing"', 'joint = "felt"')), "slab.0.joint", "no such material")

    # The masonry's density in its place would change the weight, and nothing would say so.
    def test_materials_that_are_misspelt_or_have_no_density_are_refused(self):
        model = PIERS + GRAVITY
        self.refused(self.file("a.toml", model.replace('material = "concrete"', 'material = "concret"')),
                     "slab.0.material", "concret", "did you mean concrete?")
        self.refused(self.file("b.toml", model.replace('density = "2500 kg/m^3"', 'youngs_modulus = "30 GPa"')),
                     "material.concrete.density", "deck")
        self.refused(self.file("c.toml", model.replace('name = "left"\n', 'name = "left"\nmaterial = "stoen"\n')),
                     "plan_wall.0.material", "stoen", "[material.stoen]")
        rule = '[[contact]]\nbetween = ["masonry", "{}"]\nmaterial = "bearing"\n'
        self.refused(self.file("d.toml", model + rule.format("concret")), "contact.0.between", "did you mean concrete?")
        # joints go by materials: the bearing's law would hold in all beds of a wall of the slab's material
        for text in (model.replace('material = "concrete"', 'material = "masonry"'),
                     model.replace('name = "right"\n', 'name = "right"\nmaterial = "concrete"\n')):
            self.refused(self.file("f.toml", text), "slab.0.joint", "has the slab's material", "own name")
        named = self.file("e.toml", model.replace('name = "left"\n', 'name = "left"\nmaterial = "stone"\n') + rule.format("stone"))
        self.assertEqual(wythe("check", named).returncode, 0, wythe("check", named).stderr)

    # What is not built may not stand in the report as if it were.
    def test_a_ring_beam_in_space_is_refused(self):
        ring = '[[ring_beam]]\nname = "tie"\ny = "0.8 m"\nheight = "200 mm"\nmaterial = "concrete"\n'
        self.refused(self.file("a.toml", PIERS + ring + GRAVITY), "ring_beam", "in space")

    def test_laws_that_no_joint_has_and_loads_without_mass_are_told(self):
        told = wythe("check", self.file("a.toml", PIERS + JOINT.replace("joint", "fundation") + GRAVITY)).stdout
        self.assertIn("no [material.foundation]", told)
        self.assertIn("no joint has the law of [material.fundation]", told)
        shake = '[[stage]]\nname = "quake"\nrecord = { pulse = "half_cycle", amplitude = "1 m/s^2", period = "0.2 s" }\n'
        told = wythe("check", self.file("b.toml", PIERS + GRAVITY + shake)).stdout
        self.assertIn("give floors and slabs their mass", told)
        mass = 'load = "2 kPa"\nmass = "204 kg/m^2"'
        told = wythe("check", self.file("c.toml", PIERS.replace('load = "2 kPa"', mass) + GRAVITY + shake)).stdout
        self.assertNotIn("give floors and slabs their mass", told)

    def test_a_study_varies_the_builders_numbers(self):
        self.file("model.toml", PIERS + GRAVITY + PUSH)
        study = """
[study]
model = "model.toml"
samples = 3
seed = 5
[variable.t]
path = "plan_wall.left.thickness"
distribution = "uniform"
low = "0.25 m"
high = "0.4 m"
[variable.q]
path = "slab.deck.load"
distribution = "uniform"
low = "1 kPa"
high = "4 kPa"
"""
        path = self.file("study.toml", study)
        out = self.folder / "campaign"
        ended = wythe("campaign", path, "--out", out, "--quiet", "--jobs", "2")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assert_replays(out)
        self.file("study.toml", study.replace("left.thickness", "left.thicknes"))
        self.refused(path, "did you mean plan_wall.left.thickness")

    def test_fields_in_a_campaign_are_those_of_each_sample_alone(self):
        push = '[[stage]]\nname = "push"\nat = { block = "front.c05*" }\ndirection = "+x"\nvelocity = "10 mm/s"\nuntil = "1 mm"\n'
        self.file("model.toml", PIER + push)
        path = self.file("study.toml", """
[study]
model = "model.toml"
samples = 3
seed = 5
[variable.mu]
path = "material.joint.normal_stiffness"
distribution = "lognormal"
mean = "5 GPa/m"
cov = 0.1
[field.mu]
cov = 0.3
along = "0.5 m"
across = "0.3 m"
""")
        out = self.folder / "campaign"
        ended = wythe("campaign", path, "--out", out, "--quiet")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assert_replays(out)

    def test_an_assessment_in_space_says_what_it_does_not_know(self):
        assessment = '[assessment]\ncode = "{}"\n[assessment.spectrum]\nkind = "en1998"\nground_acceleration = "0.5 m/s^2"\nground = "B"\n'
        push = '[[stage]]\nname = "push"\nat = {{ block = "front.c05*" }}\ndirection = "{}"\nvelocity = "5 mm/s"\nuntil = "{}"\ndamping = 0.4\n'
        model = self.file("in.toml", PIER + push.format("+x", "12 mm") + assessment.format("circolare_2019"))
        text = json.dumps(self.summary("in", "run", model)["assessment"])
        self.assertNotIn("of the control point over its height", text)  # the drift is the pier's
        self.assertNotIn("out-of-plane failure is not modelled", text)
        model = self.file("out.toml", PIER + push.format("+z", "30 mm") + assessment.format("circolare_2019"))
        summary = self.summary("out", "run", model)
        self.assertIn(summary["failure_mode"]["name"], ("sliding", "overturning"))
        self.assertRegex(summary["assessment"]["sentence"], "leaves its plane|does not go along the plane of 1 of 1 walls")
        self.assertFalse(summary["assessment"]["may_be_signed"])

    def test_tables_of_a_run_in_space_have_all_three_coordinates(self):
        model = self.file("model.toml", PIERS + GRAVITY + PUSH)
        self.summary("run", "run", model)
        ended = wythe("export", self.folder / "run", "--out", self.folder / "tables")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        blocks = rows(self.folder / "tables/state_blocks.csv")
        deck = [row for row in blocks if row["role"] == "slab"]
        self.assertAlmostEqual(float(deck[0]["z_m"]), 0.6, delta=1e-9)
        self.assertAlmostEqual(float(deck[-1]["displacement_x_mm"]), -3, delta=0.3)
        joints = rows(self.folder / "tables/state_joints.csv")
        self.assertLess(min(float(row["displacement_x_mm"]) for row in joints), -0.5)
        self.assertIn("displacement_z_mm", joints[0])


if __name__ == "__main__":
    unittest.main()
