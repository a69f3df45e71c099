#!/usr/bin/env python3
"""Files from other programs and people: each is read correctly, or refused with the true reason (tests/data/strangers)."""
import json
import math
import os
import pathlib
import re
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


class Folder(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="wythe_strangers_"))
        self.addCleanup(shutil.rmtree, self.root)

    def wythe(self, *arguments, code=0):
        done = subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout[-500:]}{done.stderr[-2000:]}")
        return done


class Falls(Folder):
    """A wall that falls under its loads is told so, and a wall that finds rest is not."""

    MODEL = """
[wall]
blocks = "b.json"
[wall.unit]
density = "2000 kg/m^3"
[material.joint]
normal_stiffness = "{kn}"
shear_stiffness = "{ks}"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_tan = {mu}
residual_friction_tan = {mu}
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "lean"
direction = "+x"
rate = "0.1 1/s"
factor = 1.0
"""

    @staticmethod
    def cube(name, x, y, width=1.0, height=1.0):
        return {"id": name, "z": [0, 1], "polygon": [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]}

    def stack(self, lean, count=9, width=1.0, height=1.0):
        blocks = [{**self.cube("g", -0.5, -1), "fixed": True}]
        return blocks + [self.cube(f"s{k}", -0.5 + (k + 1) * lean, k * height, width, height) for k in range(count)]

    @staticmethod
    def arch(depth, count=31):
        """A semicircle of mean radius 1 m; the thinnest that stands has depth over radius 0.1075 (Heyman's problem)."""
        def at(r, k):
            angle = math.pi * (1 - k / count)
            return [r * math.cos(angle), r * math.sin(angle)]
        inner, outer = 1 - depth / 2, 1 + depth / 2
        blocks = [{"id": f"v{k}", "z": [0, 1], "polygon": [at(inner, k), at(inner, k + 1), at(outer, k + 1), at(outer, k)]}
                  for k in range(count)]
        for name, sign in (("left", -1), ("right", 1)):
            x = sorted((sign * inner, sign * outer))
            blocks.append({"id": name, "z": [0, 1], "fixed": True,
                           "polygon": [[x[0], -0.2], [x[1], -0.2], [x[1], 0], [x[0], 0]]})
        return blocks

    def run_of(self, blocks, code=0, kn="10 GPa/m", ks="4 GPa/m", mu=0.7, more=(), **head):
        (self.root / "b.json").write_text(json.dumps({"units": "m", "blocks": blocks, **head}))
        (self.root / "model.toml").write_text(self.MODEL.format(kn=kn, ks=ks, mu=mu))
        settings = [word for one in ("stage.lean.factor=1e-6", *more) for word in ("--set", one)]
        done = self.wythe("run", self.root / "model.toml", "--out", self.root / "out", "--quiet", *settings, code=code)
        return json.loads((self.root / "out/summary.json").read_text()), done.stdout

    def falls(self, block, blocks, **options):
        summary, said = self.run_of(blocks, **options)
        self.assertEqual(summary["status"], "collapsed", said)
        self.assertIn("cannot stand", said)
        if block:
            self.assertIn(f"block {block} has moved", said)
        self.assertNotEqual(summary["failure_mode"]["name"], "none", said)
        limit = self.wythe("limit", self.root / "model.toml", "--out", self.root / "limit", "--only", "lp", "--quiet", code=2)
        self.assertIn("cannot stand", limit.stderr)
        return summary

    def test_a_stack_that_leans_too_far(self):
        summary = self.falls("s8", self.stack(0.13))
        self.assertLess(summary["stages"][0]["time_s"], 5)  # at once, not when the time to settle is over

    def test_a_stack_that_just_falls(self):
        self.falls("s8", self.stack(0.102))  # the upper nine are over the edge by 10 mm

    def test_stacks_that_just_stand(self):
        for lean in (0.099, 0.09):
            summary, said = self.run_of(self.stack(lean))
            self.assertEqual(summary["status"], "completed", said)

    def test_two_stones_that_are_tilted_over_rock(self):
        flat = lambda blocks: [{key: value for key, value in block.items() if key != "z"} for block in blocks]
        ground = {"id": "g", "fixed": True, "polygon": [[-5, -1], [5, -1], [5, 0], [-5, 0]]}
        blocks = [ground, *flat([self.cube("a", 0, 0, 0.3), self.cube("b", 0, 1, 0.3)])]
        for slope in ("0.05 1/s", "0.1 1/s"):
            summary, said = self.run_of(blocks, thickness=1.0, more=("stage.lean.factor=0.3", f"stage.lean.rate={slope}"))
            self.assertEqual(summary["status"], "collapsed", said)
            self.assertAlmostEqual(summary["load_factor"], 0.15, delta=0.002)  # half a width over half a height
            self.assertEqual(summary["failure_mode"]["name"], "rocking", said)
            self.assertNotIn("no damage", said)
            self.assertNotIn("no mechanism", said)

    def test_two_stones_on_the_edge(self):
        self.falls("s1", self.stack(0.34, count=2, height=0.3))

    def test_an_arch_too_thin(self):
        self.falls("", self.arch(0.0998))

    def test_an_arch_that_stands(self):
        summary, said = self.run_of(self.arch(0.112))
        self.assertEqual(summary["status"], "completed", said)

    def test_a_block_that_slides_down(self):
        def ramp(slope, mu):
            c, s = math.cos(math.atan(slope)), math.sin(math.atan(slope))
            turn = lambda x, y: [c * x - s * y, s * x + c * y]
            body = lambda x0, y0, x1, y1: [turn(x0, y0), turn(x1, y0), turn(x1, y1), turn(x0, y1)]
            return [{"id": "g", "z": [0, 1], "fixed": True, "polygon": body(-3, -1, 3, 0)},
                    {"id": "s", "z": [0, 1], "polygon": body(0, 0, 0.6, 0.3)}], {"mu": mu}
        blocks, options = ramp(0.3, 0.299)
        self.falls("s", blocks, **options)
        blocks, options = ramp(0.3, 0.301)
        summary, said = self.run_of(blocks, **options)
        self.assertEqual(summary["status"], "completed", said)

    def test_soft_joints_that_give_far_are_no_fall(self):
        # settles by 0.14 m, a seventh of a block, in a motion that begins as a free fall
        summary, said = self.run_of(self.stack(0, count=3), kn="1 MPa/m", ks="0.4 MPa/m", more=("solve.collapse_displacement=0.5 m",))
        self.assertEqual(summary["status"], "completed", said)
        summary, said = self.run_of(self.stack(0.05, count=3), kn="3 MPa/m", ks="1 MPa/m", more=("solve.collapse_displacement=0.5 m",))
        self.assertEqual(summary["status"], "completed", said)

    def test_a_soft_stack_that_leans_far_and_stands_is_no_fall(self):
        # near to buckling: they sway for seconds, by 80 to 180 mm
        for lean, kn in ((0.005, 40), (0.01, 40), (0.03, 100), (0.08, 300)):
            summary, said = self.run_of(self.stack(lean), kn=f"{kn} MPa/m", ks=f"{0.4 * kn:g} MPa/m")
            self.assertEqual(summary["status"], "completed", said)

    def test_a_wall_that_trembles_is_no_fall(self):
        summary, said = self.run_of(self.stack(0), code=3, more=("stage.gravity.damping=0", "solve.settle_limit=2 s"))
        self.assertEqual(summary["status"], "not_settled", said)


    def test_a_stone_that_its_tie_pulls_out(self):
        blocks = [{**self.cube("g", -0.2, -0.2, 1.6, 0.2), "fixed": True}]
        for course in range(6):
            ends = [0, 0.4, 0.8, 1.2] if course % 2 == 0 else [0, 0.2, 0.6, 1.0, 1.2]
            blocks += [self.cube(f"c{course}u{k}", ends[k], 0.2 * course, ends[k + 1] - ends[k], 0.2) for k in range(len(ends) - 1)]
        tie = lambda block, x, y, stress: f"""
[[tie]]
name = "chain"
anchored = true
from = {{{{ block = "{block}" }}}}
to = {{{{ x = "{x} m", y = "{y} m", z = "0.5 m" }}}}
area = "1000 mm^2"
youngs_modulus = "0.2 GPa"
prestress = "{stress} MPa"
"""
        model = self.MODEL
        try:
            for block, x, y, stress in (("c4u2", 5, 0.9, 12), ("c4u0", -4, 0.9, 12), ("c5u3", 4, 1.1, 12)):
                Falls.MODEL = model + tie(block=block, x=x, y=y, stress=stress)
                summary, said = self.run_of(blocks, more=("output.rows=50",))
                self.assertEqual(summary["status"], "collapsed", said)
                self.assertRegex(said, rf"chain, tensioned to [0-9.]+ kN, pulls block {block} away")
                mode = summary["failure_mode"]
                self.assertEqual(mode["name"], "part breaking away", said)
                self.assertIn(block, mode["sentence"])
                self.assertIn("chain", mode["sentence"])
                self.assertNotEqual(mode["mechanism"]["name"], "none")
            Falls.MODEL = model + tie(block="c4u0", x=-4, y=0.9, stress=0.5)  # less than friction holds
            summary, said = self.run_of(blocks)
            self.assertEqual(summary["status"], "completed", said)
        finally:
            Falls.MODEL = model


class Restitution(Folder):
    """One block comes back with the share that is asked for; of a pile the model's check says what comes."""

    MODEL = """
[wall]
blocks = "b.json"
[wall.unit]
density = "2000 kg/m^3"
[material.joint]
normal_stiffness = "1 GPa/m"
shear_stiffness = "0.4 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_tan = 0.5
residual_friction_tan = 0.5
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "hop"
record = {{ pulse = "half_cycle", amplitude = "{amplitude} m/s^2", period = "0.2 s", direction = "+y" }}
free_vibration = "0.6 s"
restitution = {restitution}
interval = "0.001 s"
[[history]]
name = "top"
at = {{ block = "s0" }}
[solve]
contacts = "{contacts}"
"""

    def model(self, count=1, restitution=0.5, amplitude=-30, contacts="joints", space=False):
        ground = {"id": "g", "polygon": [[-1, -0.1], [1.4, -0.1], [1.4, 0], [-1, 0]], "fixed": True}
        blocks = [ground] + [{"id": f"s{k}", "polygon": [[0, 0.2 * k], [0.4, 0.2 * k], [0.4, 0.2 * k + 0.2], [0, 0.2 * k + 0.2]]}
                             for k in range(count)]
        for block in blocks:
            if space:
                block["z"] = [-0.5, 0.7] if block["id"] == "g" else [0, 0.2]
        self.root.joinpath("b.json").write_text(json.dumps({"units": "m", "blocks": blocks, **({} if space else {"thickness": 0.2})}))
        self.root.joinpath("model.toml").write_text(
            self.MODEL.format(restitution=restitution, amplitude=amplitude, contacts=contacts))
        return self.root / "model.toml"

    def rebound(self, **options):
        self.wythe("run", self.model(**options), "--out", self.root / "out", "--quiet")
        rows = [line for line in self.root.joinpath("out/history.csv").read_text().splitlines() if not line.startswith("#")]
        column = rows[0].split(",").index("top_uy_mm")
        y = [float(row.split(",")[column]) for row in rows[1:]]
        peaks = [y[i] for i in range(1, len(y) - 1) if y[i] >= y[i - 1] and y[i] > y[i + 1] and y[i] > 0.3]
        return math.sqrt(peaks[1] / peaks[0])

    def test_one_block_comes_back_as_asked(self):
        for restitution in (0.8, 0.5, 0.2):
            for amplitude in (-28, -30, -31.7):  # the phase of the impact within a step differs
                with self.subTest(restitution=restitution, amplitude=amplitude):
                    self.assertAlmostEqual(self.rebound(restitution=restitution, amplitude=amplitude), restitution, delta=0.03)

    def test_so_it_does_in_space_and_at_free_contacts(self):
        for options in ({"space": True}, {"contacts": "free"}, {"space": True, "contacts": "free"}):
            with self.subTest(**options):
                self.assertAlmostEqual(self.rebound(**options), 0.5, delta=0.05)

    def test_of_a_pile_the_check_says_what_comes(self):
        for count, restitution, obtained in ((2, 0.1, 0.20), (5, 0.1, 0.41), (10, 0.1, 0.56), (10, 0.5, 0.82)):
            said = self.wythe("check", self.model(count=count, restitution=restitution)).stdout
            found = re.search(r"restitution ([0-9.]+) is that of one block.*comes back with about ([0-9.]+) of its speed", said)
            self.assertIsNotNone(found, said)
            self.assertEqual(float(found[1]), restitution)
            self.assertAlmostEqual(float(found[2]), obtained, delta=0.02)
        for count, restitution in ((1, 0.1), (10, 1)):
            self.assertNotIn("is that of one block", self.wythe("check", self.model(count=count, restitution=restitution)).stdout)


class ValueColumns(Folder):
    """Files of measured values are read for what they say, or refused with a cure that is one."""

    STUDY = """
[study]
model = "model.toml"
samples = 8
seed = 3
[variable.rho]
path = "wall.unit.density"
distribution = "empirical"
file = "values.csv"
"""

    def setUp(self):
        super().setUp()
        for name in ("model.toml", "b.json"):
            shutil.copyfile(FOLDER / "paths" / name, self.root / name)

    def said(self, values, *keys, code=0):
        (self.root / "values.csv").write_text(values)
        (self.root / "study.toml").write_text(self.STUDY + "\n".join(keys))
        return self.wythe("check", self.root / "study.toml", code=code)

    def refused(self, values, *keys):
        lines = self.said(values, *keys, code=2).stderr.strip().splitlines()
        self.assertEqual(len(lines), 1, lines)
        return lines[0]

    def mean(self, values, *keys):
        return float(re.search(r"rho_kg_per_m3 +([0-9.e+]+) ", self.said(values, *keys).stdout)[1])

    def test_a_file_without_a_head(self):
        unit = 'unit = "kg/m^3"'
        for values in ("1900\n2000\n2100\n", "1900.5\n2000\n", '"1900"\n"2000"\n', "1900;1\n2000;2\n", "1 1900\n2 2000\n",
                       "# rho\n1900\n2000\n", "a,1900\nb,2000\n", "1900\n"):
            line = self.refused(values, unit)
            self.assertIn("a number stands where the names of the columns belong", line)
            self.assertIn("write a first line with their names, e.g. ft_MPa", line)
        self.said("rho_kg_m3\n1900\n2000\n2100\n")
        self.said("rho\n1900\n2000\n", unit)
        self.said("wall 2\n1900\n2000\n", unit)

    def test_row_numbers_are_no_values(self):
        unit = 'unit = "kg/m^3"'
        for index in ("nr", "Nr.", "id", "Sample", "Unnamed: 0", "index"):
            table = f"{index},rho\n0,1900\n1,2000\n2,2100\n"
            line = self.refused(table, unit)
            self.assertIn('name one: column = "rho"', line)  # and the cure is one
            self.assertEqual(self.mean(table, unit, 'column = "rho"'), 2000)
            self.assertIn("holds row numbers", self.refused(table, unit, f'column = "{index}"'))
            self.assertIn("holds row numbers", self.refused(f"{index}\n7\n3\n12\n", unit))
            self.mean(f"{index}\n1900.5\n2000.5\n", unit)  # measured, whatever their name
        named = lambda first: "pos,rho\n" + "".join(f"{first + k},{1900 + 50 * k}\n" for k in range(5))
        for first in (0, 1):
            self.assertIn("holds row numbers", self.refused(named(first), unit, 'column = "pos"'))
        self.assertEqual(self.mean(named(0), unit, 'column = "rho"'), 2000)
        self.mean(named(1000), unit, 'column = "pos"')
        self.said("rho_t_m3\n1\n2\n3\n4\n5\n")  # its unit says that they are densities
        for table in ("wall,rho_kg_m3\nA,1900\nB,2000\n", "test,rho [t/m3]\n1,1.9\n2,2.0\n"):
            name = table.split(",")[1].split("\n")[0]
            self.assertIn(f'name one: column = "{name}"', self.refused(table))
            self.mean(table, f'column = "{name}"')

    def test_thousands_or_decimals(self):
        for values in ("1.900\n2.000\n", '"1,900"\n"2,000"\n', "1.900\n950\n2.100\n", "1.900\n2000\n", "+1.900\n", "12.345\n-1.250\n"):
            line = self.refused("rho [kg/m3]\n" + values)
            self.assertIn("may have three decimals or marks of thousands", line)
            self.assertRegex(line, r"write [+0-9]+ where it is thousands, or one more decimal")
        self.assertIn("three decimals or", self.refused("n;rho [kg/m3]\n1;1,900\n2;2,000\n", 'column = "rho"'))
        # what tells them apart, and what the message says to write
        self.assertEqual(self.mean("rho [kg/m3]\n1900\n2000\n2100\n"), 2000)
        for values in ("1900.5\n2000.125\n", "1.9000\n2.000\n", "1.9\n2.000\n", "0.950\n2.000\n", "1.9e3\n2.000\n", "1900.250\n"):
            self.said("rho [kg/m3]\n" + values)
        # g/cm3: thousands of them weigh more than anything does
        self.assertEqual(self.mean("rho [g/cm3]\n1.900\n2.000\n2.100\n"), 2000)
        self.assertEqual(self.mean('rho [g/cm3]\n"1,900"\n"2,000"\n"2,100"\n'), 2000)

    def test_a_factor_in_the_head_is_refused(self):
        for head in ("rho x100 [kg/m3]", "100*rho (kg/m3)", "rho/10 [kg/m3]", "rho [kg/m3] x 10", "log10(rho) [kg/m3]", "CoV of rho [kg/m3]",
                     "1/rho [kg/m3]", "rho × 10 [kg/m3]"):
            self.assertIn("may not be the value itself", self.refused(f"{head}\n1900.5\n2000\n"))
        for head in ("rho [kg/m3/10]", "rho [10 kg/m3]", "rho (kg/m3*10)", "rho [kg/m3 × 10]", "rho [t/m3/1000]"):
            self.refused(f"{head}\n1900.5\n2000\n")
        for head in ("rho 28 days [kg/m3]", "rho of wall 10 [kg/m3]", "rho (dry) [kg/m3]", "densité ρ [kg/m3]"):
            self.said(f"{head}\n1900.5\n2000\n")

    def test_degrees_are_no_tangent(self):
        study = self.STUDY.replace("wall.unit.density", "material.joint.friction_tan")
        for head in ("phi_deg", "phi [°]", "phi (degrees)"):
            (self.root / "values.csv").write_text(f"{head}\n30\n31.5\n28\n")
            (self.root / "study.toml").write_text(study)
            self.assertIn("is of angles", self.wythe("check", self.root / "study.toml", code=2).stderr)

    def test_a_mark_of_a_missing_value_is_refused(self):
        for mark in ("99999", "-999", "-9999"):
            line = self.refused(f"rho [kg/m3]\n19\n20.5\n{mark}\n21\n")
            self.assertTrue("mark of a missing value" in line or "negative" in line or "below" in line, line)
        self.said("rho [kg/m3]\n990\n999\n1010\n")

    def test_units_of_head_and_study(self):
        values = "1.90\n2.00\n2.10\n"
        unit = 'unit = "kg/m^3"'
        for head in ("rho [g/cm3]", "rho (g/cm3)", "rho {g/cm3}", "rho_g_cm3", "rho g/cm3", "rho_t_per_m3"):
            self.assertEqual(self.mean(f"{head}\n{values}"), 2000)
            line = self.refused(f"{head}\n{values}", unit)
            self.assertIn("is not the unit of the study, kg/m^3", line)
            self.assertIn("leave unit out of the study", line)
            self.said(f"{head}\n{values}", 'unit = "t/m^3"')  # the same
        for head in ("rho [kN/m3]", "rho_kN_m3", "rho_ton_m3", "rho kN/m3"):
            self.refused(f"{head}\n{values}", unit)
        self.mean("rho_of_m\n1900\n2000\n", unit)  # no unit of what is meant
        self.assertIn("is not known", self.refused(f"rho [g/cm3]\n{values}", 'unit = "kgg/m^3"'))

    def test_units_that_are_none(self):
        for unit, reason, cure in (("ton/m3", "2000 lb in UDUNITS, 1000 kg to most", "write t (1000 kg)"),
                                   ("gr/cm3", "a grain of 65 mg", "write g"), ("kN/m3", "is not the unit of a density", "kg/m^3"),
                                   ("kgg/m3", "the unit kgg/m3 is not known", "kg/m^3")):
            for said in (self.refused(f"rho [{unit}]\n1.90\n2.00\n"), self.refused("rho\n1.90\n2.00\n", f'unit = "{unit}"')):
                self.assertIn(reason, said)
                self.assertIn(cure, said)


class Scale(Folder):
    """The dimension that is too large is named, and no other."""

    def test_a_push_beyond_the_size_of_the_wall(self):
        shutil.copyfile(FOLDER / "paths/b.json", self.root / "b.json")
        text = (FOLDER / "paths/model.toml").read_text()
        for until, is_far in (("10 m", True), ("4 m", True), ("-10 m", True), ("1 mm", False), ("100 mm", False)):
            if until.startswith("-"):
                changed = text.replace('until = "1 mm"', f'targets = ["2 mm", "{until}"]')
            else:
                changed = text.replace('until = "1 mm"', f'until = "{until}"')
            (self.root / "model.toml").write_text(changed)
            note = f'if millimetres are meant, write "{until.lstrip("-")}m"'
            (self.assertIn if is_far else self.assertNotIn)(note, self.wythe("check", self.root / "model.toml").stdout)

    def test_a_wall_too_long(self):
        blocks = lambda width, height: json.dumps({"units": "m", "blocks": [
            {"id": "g", "polygon": [[0, -1], [width, -1], [width, 0], [0, 0]], "fixed": True},
            {"id": "s", "polygon": [[0, 0], [width, 0], [width, height], [0, height]]}]})
        shutil.copyfile(FOLDER / "paths/model.toml", self.root / "model.toml")
        for width, height, has, lacks in ((1250, 1.2, "1250 m long", "1.2 m"), (1.2, 1250, "m high", "1.2 m"),
                                          (1250, 1250, "m long", "is 1250 m long")):
            (self.root / "b.json").write_text(blocks(width, height))
            note = [line for line in self.wythe("check", self.root / "model.toml").stdout.splitlines() if "millimetres" in line][0]
            self.assertIn(has, note)
            self.assertNotIn(lacks, note)


class OtherResults(Folder):
    """Results of another model are replaced only where that is asked for."""

    def setUp(self):
        super().setUp()
        for name in ("one", "two"):
            shutil.copytree(FOLDER / "paths", self.root / name)
        for name in ("one", "two"):
            for file in (self.root / name).iterdir():
                file.chmod(0o644)
        model = self.root / "two/model.toml"
        model.write_text(model.read_text().replace("2000 kg", "1900 kg"))
        self.out = self.root / "out"

    def model(self, name):
        return self.root / name / "model.toml"

    def test_a_run(self):
        run = lambda name, *more, code=0: self.wythe("run", self.model(name), "--out", self.out, "--quiet", *more, code=code)
        run("one")
        run("one")  # again
        run("one", "--set", "wall.unit.density=1800 kg/m^3")  # and changed
        before = (self.out / "summary.json").read_bytes()
        said = run("two", code=2).stderr
        self.assertIn("holds results of another model", said)
        self.assertIn(str(self.model("one")), said)
        self.assertIn("--replace", said)
        self.assertEqual((self.out / "summary.json").read_bytes(), before)
        origin = self.out / ".wythe_model"
        for damage in (lambda: None, lambda: origin.write_text(""), lambda: origin.write_text("no hash\n"), origin.mkdir):
            origin.unlink(missing_ok=True)
            damage()
            self.assertIn(".wythe_model, which names their model, is missing or damaged", run("two", code=2).stderr)
            self.assertEqual((self.out / "summary.json").read_bytes(), before)
        origin.rmdir()
        run("two", "--replace")
        self.assertNotEqual((self.out / "summary.json").read_bytes(), before)
        run("one", code=2)
        os.symlink(self.root / "two", self.root / "link")
        run("link")  # the same file
        shutil.copytree(self.root / "two", self.root / "copy")
        run("copy")  # the same model elsewhere

    def test_a_second_opinion(self):
        limit = lambda name, *more, code=0: self.wythe("limit", self.model(name), "--out", self.out, "--only", "lp", "--quiet",
                                                       *more, code=code)
        limit("one")
        limit("one")
        self.assertIn("another model", limit("two", code=2).stderr)
        (self.out / ".wythe_model").unlink()
        limit("two", code=2)
        limit("two", "--replace")
        self.wythe("run", self.model("one"), "--out", self.root / "run", "--quiet")
        self.out = self.root / "run"
        limit("one")  # beside the run of the same model
        self.assertIn("another model", limit("two", code=2).stderr)

    def test_a_replay(self):
        for name in ("one", "two"):
            self.wythe("campaign", self.root / name / "study.toml", "--out", self.root / (name + "_campaign"), "--jobs", 1, "--quiet")
        replay = lambda name, sample, *more, code=0: self.wythe(
            "replay", self.root / (name + "_campaign"), "--sample", sample, "--out", self.out, "--quiet", *more, code=code)
        replay("one", 1)
        replay("one", 2)
        self.assertIn("another model", replay("two", 1, code=2).stderr)
        replay("two", 1, "--replace")

    def test_a_campaign_is_never_replaced(self):
        campaign = lambda name, *more, code=0: self.wythe(
            "campaign", self.root / name / "study.toml", "--out", self.out, "--jobs", 1, "--quiet", *more, code=code)
        campaign("one")
        campaign("two", code=2)
        campaign("two", "--resume", code=2)

    def kept(self, files, words, *command):
        """The command is refused in these words and leaves the files as they are."""
        before = [pathlib.Path(file).read_bytes() for file in files]
        said = self.wythe(*command, code=2).stderr
        self.assertIn(words, said)
        self.assertEqual([pathlib.Path(file).read_bytes() for file in files], before)
        return said

    def test_a_comparison_or_tables_are_no_place_for_other_results(self):
        for name in ("one", "two", "three"):
            self.wythe("campaign", self.root / "one/study.toml", "--out", self.root / name / "campaign", "--jobs", 1, "--quiet")
        one, two, three = (self.root / name / "campaign" for name in ("one", "two", "three"))
        compare, comparison = self.root / "compare", self.root / "compare/comparison.json"
        self.wythe("compare", one, two, "--out", compare)
        self.wythe("compare", one, two, "--out", compare)
        self.assertIn("--replace", self.kept([comparison], "holds results of another", "compare", one, three, "--out", compare))
        self.kept([comparison], "holds results of another", "compare", two, one, "--out", compare)
        self.wythe("compare", one, three, "--out", compare, "--replace")
        for command in ("run", "limit"):
            for more in ([], ["--replace"]):
                self.kept([comparison], f"which no {command} wrote", command, self.model("one"), "--out", compare, *more)
        tables = self.root / "tables"
        curves = tables / "curves.csv"
        self.wythe("export", one, "--out", tables)
        self.wythe("export", one, "--out", tables)
        self.assertIn("--replace", self.kept([curves], "holds results of another", "export", two, "--out", tables))
        self.kept([curves], "holds results of another", "export", two, "--out", tables, "--hdf5")
        for command in ("run", "limit"):
            self.kept([curves], f"which no {command} wrote", command, self.model("one"), "--out", tables)
        self.kept([tables / "samples.csv"], "no campaign in it wrote", "campaign", self.root / "one/study.toml", "--out", tables)
        self.wythe("export", two, "--out", tables, "--replace")

    def test_a_campaign_beside_other_results(self):
        limit = self.root / "limit"
        self.wythe("limit", self.model("one"), "--out", limit, "--only", "lp", "--quiet")
        self.kept([limit / "report.html"], "no campaign in it wrote", "campaign", self.root / "one/study.toml", "--out", limit)
        mine = self.root / "one/samples.csv"
        mine.write_text("of the laboratory\n")
        self.kept([mine], "no campaign in it wrote", "campaign", self.root / "one/study.toml", "--out", self.root / "one")
        self.kept([mine], "which no limit wrote", "limit", self.model("one"), "--out", self.root / "one")

    def test_the_model_itself(self):
        self.wythe("run", self.model("one"), "--out", self.out, "--quiet")
        used = self.out / "model.used.toml"
        for more in ([], ["--replace"]):
            self.kept([used], "lies among the results that would replace it", "run", used, "--out", self.out, "--quiet", *more)
        self.wythe("limit", used, "--out", self.out, "--only", "lp", "--quiet", "--replace")  # which replaces no file of a run

    def test_a_table_of_a_joint(self):
        law, path, answer, link = (self.root / name for name in ("law.toml", "path.csv", "answer.csv", "hard.csv"))
        law.write_text(self.model("one").read_text()[self.model("one").read_text().index("[material.joint]"):
                                                     self.model("one").read_text().index("[[stage]]")])
        path.write_text("opening_mm,slip_mm\n0,0\n-0.01,0.1\n")
        contact = lambda out, given=path: ("contact", law, "--path", given, "--out", out)
        self.wythe(*contact(answer))
        self.wythe(*contact(answer))
        os.link(path, link)
        for out in (path, link, os.path.relpath(path), self.root / ".." / self.root.name / "path.csv", law):
            self.kept([path, law], "is what this command reads", *contact(out))
        self.kept([answer], "is what this command reads", *contact(answer, answer))
        (self.root / "mine.csv").write_text("force\n1\n")
        for out in (self.root / "mine.csv", self.model("one")):
            self.kept([out], "is no earlier answer", *contact(out))
        (self.root / "empty.csv").touch()
        self.wythe(*contact(self.root / "empty.csv"))

    def test_a_picture(self):
        campaign, picture = self.root / "campaign", self.root / "sample.svg"
        self.wythe("campaign", self.root / "one/study.toml", "--out", campaign, "--jobs", 1, "--quiet")
        draw = lambda out: ("picture", campaign, "--sample", 1, "--out", out)
        self.wythe(*draw(picture))
        self.wythe(*draw(picture))
        mine = self.root / "mine.svg"
        mine.write_text('<svg xmlns="http://www.w3.org/2000/svg" class="logo"></svg>\n')
        for out in (mine, self.root / "one/study.toml", campaign / "campaign.db", campaign / "report.html"):
            self.kept([out], "is no earlier answer", *draw(out))


class OtherFiles(Folder):
    """A file of another kind is told by what it is, with what to do; a word that is no command by the one that is meant."""

    DXF = b"  0\nSECTION\n  2\nENTITIES\n  0\nENDSEC\n  0\nEOF\n"
    KINDS = {  # name: bytes, words of the answer
        "page.json": (b"<!DOCTYPE html><html><body>not found</body></html>", ["page of the web", "download the file itself"]),
        "page.obj": (b"<html>", ["page of the web"]),
        "pointer.json": (b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", ["git-lfs", "git lfs pull"]),
        "pointer.dxf": (b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", ["git-lfs", "git lfs pull"]),
        "empty.json": (b"", ["is empty"]), "empty.dxf": (b"\n", ["is empty"]), "empty.stl": (b"", ["is empty"]),
        "a.ifc": (b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\n", ["IFC model", "OBJ"]),
        "a.stp": (b"ISO-10303-21;\nHEADER;\n", ["STEP", "OBJ"]), "a.3dm": (b"3D Geometry File Format      5\0", ["Rhino", "OBJ"]),
        "a.xlsx": (b"PK\x03\x04\0\0xl/workbook.xml", ["spreadsheet", "CSV"]), "a.zip": (b"PK\x03\x04\0\0", ["ZIP", "unpack"]),
        "a.dwg": (b"AC1027\0\0", ["DWG", "DXF"]), "a.glb": (b"glTF\2\0\0\0", ["glTF", "OBJ"]), "a.off": (b"OFF\n8 6 0\n", ["OFF", "PLY"]),
        "svg.dxf": (b'<svg xmlns="http://www.w3.org/2000/svg"></svg>', ["picture (SVG)"]), "a.pdf": (b"%PDF-1.7\n", ["PDF"]),
        "named.json": (DXF, ["a DXF drawing", "name it named.dxf"]), "named.dxf": (b'{"units": "m"}', ["is JSON", "name it named.json"]),
        "ply.obj": (b"ply\nformat ascii 1.0\n", ["a PLY mesh", "name it ply.ply"]), "table.csv": (b"id,x0,y0\n1,2,3\n", ["is no JSON", "id,x0,y0"]),
        "map.json": (b'{"type": "FeatureCollection", "features": []}', ["GeoJSON"])}

    def refused(self, words, *command, code=2):
        said = self.wythe(*command, code=code).stderr
        for word in words:
            self.assertIn(word, said)
        self.assertEqual(len(said.strip().splitlines()), 1, said)
        return said

    def test_a_blocks_file_of_another_kind(self):
        model = self.root / "model.toml"
        for name, (content, words) in self.KINDS.items():
            with self.subTest(name):
                (self.root / name).write_bytes(content)
                unit = 'blocks_unit = "m"\n' if pathlib.Path(name).suffix in (".obj", ".ply", ".stl") else ""
                text = Falls.MODEL.format(kn="1 GPa/m", ks="1 GPa/m", mu=0.5).replace('blocks = "b.json"\n', f'blocks = "{name}"\n{unit}')
                model.write_text(text)
                self.assertNotIn("not valid JSON", self.refused(words, "check", model))

    def test_a_model_of_another_kind(self):
        for name, (content, words) in self.KINDS.items():
            if "html" in str(content) or content.startswith(b"PK"):
                (self.root / "model.toml").write_bytes(content)
                self.refused(words[:1], "check", self.root / "model.toml")

    def test_a_study_where_a_model_is_asked_for(self):
        for name in ("model.toml", "study.toml", "b.json"):
            shutil.copy(FOLDER / "paths" / name, self.root / name)
        model, study, out = self.root / "model.toml", self.root / "study.toml", self.root / "out"
        for command in ("run", "assess", "limit"):
            self.refused(["is a study", "wythe campaign", str(model)], command, study, "--out", out)
        self.refused(["is a model", "wythe run", "wythe new study"], "campaign", model, "--out", out)
        self.refused(["is a study"], "contact", study, "--path", FOLDER / "record_index_column/r.csv", "--out", out)

    def test_a_name_that_is_near(self):
        for name in ("model.toml", "study.toml", "b.json"):
            shutil.copy(FOLDER / "paths" / name, self.root / name)
        model, study = self.root / "model.toml", self.root / "study.toml"
        model.write_text(model.read_text().replace('"b.json"', '"B.json"'))
        self.refused(["No such file", "did you mean b.json?"], "check", model)
        study.write_text(study.read_text().replace('"model.toml"', '"Model.toml"'))
        self.refused(["did you mean", "model.toml?"], "check", study)
        (self.root / "dead.toml").symlink_to(self.root / "gone.toml")
        self.assertNotIn("did you mean", self.refused(["is a link to", "gone.toml"], "check", self.root / "dead.toml"))

    def test_keys_without_effect(self):
        model, blocks = self.root / "model.toml", self.root / "b.json"
        model.write_text(Falls.MODEL.format(kn="1 GPa/m", ks="1 GPa/m", mu=0.5))
        flat = {"id": "s", "polygon": [[0, 0], [1, 0], [1, 1], [0, 1]]}
        ground = {"id": "g", "polygon": [[0, -1], [1, -1], [1, 0], [0, 0]], "fixed": True}
        for more, own, words in (({"blocks_xyxy": [[0, 0, 1, 1]]}, {}, ["blocks_xyxy", "stands beside"]), ({"up": "z"}, {}, ["up", "has no effect"]),
                                 ({}, {"zone_length": 0.1}, ["zone_length", "has no zones"]), ({}, {"plane": "strain"}, ["plane", "has no zones"])):
            blocks.write_text(json.dumps({"units": "m", "thickness": 0.2, "blocks": [ground, {**flat, **own}], **more}))
            self.refused(words, "check", model)
        blocks.write_text(json.dumps({"units": "m", "thickness": 0.2, "blocks": [ground, flat]}))
        self.wythe("check", model)
        self.refused(["wall.unit_joint", "has no effect"], "check", model, "--set", "wall.unit_joint=joint")
        shutil.copy(FOLDER / "dxf_hidden_layers/shown.dxf", self.root / "w.dxf")
        drawn = (FOLDER / "dxf_hidden_layers/shown.toml").read_text().replace("shown.dxf", "w.dxf")
        stated = re.search(r"\$INSUNITS\s+70\s+(\d+)", (self.root / "w.dxf").read_text())
        self.assertIsNotNone(stated)
        same, other = {"6": ("m", "mm"), "4": ("mm", "m")}[stated[1]]
        model.write_text(drawn)
        self.wythe("check", model, "--set", f"wall.blocks_unit={same}")
        self.refused(["wall.blocks_unit", f"states {same}"], "check", model, "--set", f"wall.blocks_unit={other}")

    def test_a_slip_in_a_study_of_shakes_is_told_once(self):
        example = self.root / "parapet"
        shutil.copytree(pathlib.Path(os.environ["SOURCE"]) / "examples/parapet_fragility", example)
        study = example / "study.toml"
        right = study.read_text()
        climb = re.search(r'from = .*\nstep = .*\nmost = .*\nhalvings = .*\n', right)[0]
        for old, new, words in ((climb, "levels = [1, 2, 3]\n", ["levels.0", 'levels = ["1 m/s^2", "2 m/s^2"]']),
                                (climb, 'levels = ["0.1 kg", "0.2 kg"]\n', ["levels.0", "acceleration"]),
                                ('measure = "pga"', 'measure = "pgv"', ["shaking.measure", "accelerations", "pga"]),
                                (re.search(r"step = \"0.5.*\n", right)[0], "", ["shaking.step", "is missing"]),
                                ("[shaking]", "[shakings]", ["did you mean shaking?"]), ('step = "0.01 s"', "step = 0.01", ["step", "has no unit"]),
                                ('unit = "m/s2"', 'unit = "g"', ["states another", 'write unit = "m/s2"'])):
            self.assertIn(old, right)
            study.write_text(right.replace(old, new, 1))
            self.assertNotIn("stage.1", self.refused(words, "check", study))

    def test_a_word_that_is_no_command(self):
        for words, command in ((["runn", "did you mean run?"], ["runn", "x"]), (["did you mean --help?"], ["help"]),
                               (["did you mean --help?"], ["--hlp"]), (["did you mean check?"], ["store", "chek", "x"]),
                               (["did you mean campaign?"], ["campain", "x"]), (["known here: ", "campaign"], ["zebra"])):
            self.refused(words, *command)

    def test_commands_that_are_offered_run_in_a_shell(self):
        for folder in ("-n", "a;b", "it's", "a b"):
            for kind in ("pier", "study"):
                done = subprocess.run([WYTHE, "new", kind, "--", f"{folder}{'s' if kind == 'study' else ''}"], cwd=self.root, capture_output=True,
                                      text=True, timeout=60)
                check = done.stdout.split("next: wythe ")[1].splitlines()[0]
                said = subprocess.run(["sh", "-c", f"'{WYTHE}' {check}"], cwd=self.root, capture_output=True, text=True, timeout=60)
                self.assertEqual(said.returncode, 0, check + said.stderr)

    def test_a_name_that_is_no_utf8_is_compared(self):
        for name in ("model.toml", "study.toml", "b.json"):
            shutil.copy(FOLDER / "paths" / name, self.root / name)
        folders = [os.fsencode(self.root) + name for name in (b"/one\xff", b"/two\xe9")]
        for folder in folders:
            subprocess.run([WYTHE, "campaign", self.root / "study.toml", "--out", folder, "--jobs", "1", "--quiet"], check=True, timeout=300,
                           stdout=subprocess.DEVNULL)
        done = subprocess.run([WYTHE, "compare", *folders, "--out", self.root / "c"], capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("one\\xff", json.loads((self.root / "c/comparison.json").read_text())["base"]["folder"])

    def test_a_model_of_such_a_name_is_told_so(self):
        named = os.fsencode(self.root) + b"/m\xff.toml"
        shutil.copy(FOLDER.parents[2] / "examples/brick_facade/model.toml", named)
        shutil.copy(named, self.root / "n.toml")
        set_scatter = ["--set", "scatter.use=clay_brick"]
        for command in (["assess", named, "--walls", "2", *set_scatter], ["compare", named, self.root / "n.toml", *set_scatter]):
            done = subprocess.run([WYTHE, *command, "--out", self.root / "out"], capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(b"that is no UTF-8 text; rename it", done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_a_name_that_is_too_long_is_told_so(self):
        model, study = FOLDER / "paths/model.toml", FOLDER / "paths/study.toml"
        for path in (str(self.root) + "/" + "x" * 300, str(self.root) + "/not/there/" + "x" * 300, str(self.root) + "/x" * 2050):
            for command in (["run", model], ["campaign", study], ["assess", model], ["limit", model]):
                self.refused(["too long"], *command, "--out", path, code=4)
            for command in (["check", path], ["status", path], ["report", path]):
                self.refused(["too long"], *command, code=4)


class Paths(Folder):
    """A folder may bear any name that the system takes."""

    NAMES = ["a b", "a#b", "a?b", "100%", "%41", "it's", 'a"b', "übung 石", "a&b=c", "-dash", "a;b", "x\\y", "*", "[1]", "~", "a\tb"]

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
