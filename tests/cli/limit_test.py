#!/usr/bin/env python3
"""wythe limit from the command line: files, columns, both directions, comparison with runs, refusals."""
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

from campaign_test import STUDY
from cli_test import SMALL, SOURCE, TUFF, wythe

OPENING = """
[[wall.opening]]
x = "0.2 m"
y = "0 m"
width = "0.4 m"
height = "0.5 m"
"""
DOOR = SMALL.replace("[wall.unit]", OPENING + "[wall.unit]").replace('until = "3 mm"', 'until = "1 mm"')
NAMES = [f"mechanism_{mode}_{h}" for mode in ("fm1", "fm4") for h in ("infinite", "macro_block_1", "macro_block_2")]
LINTEL = DOOR.replace('height = "0.5 m"\n', 'height = "0.5 m"\nlintel = { kind = "timber", depth = "100 mm", '
                      'bearing = "100 mm", material = "timber" }\n') + """
[material.timber]
density = "500 kg/m^3"
youngs_modulus = "0.3 GPa"
shear_modulus = "0.125 GPa"
"""


def dry(text):
    for strength in ("0.15", "0.5", "0.75"):
        for what in ("tensile_strength", "cohesion"):
            text = text.replace(f'{what} = "{strength} MPa"', f'{what} = "0 MPa"')
    return text


FACADE = pathlib.Path(SOURCE) / "tests/verification/facade.toml"


def start(*arguments):
    return subprocess.Popen([os.environ["WYTHE"], *map(str, arguments)], text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Limit(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.model = cls.folder / "model.toml"
        cls.model.write_text(DOOR)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def out(self, name="out"):
        return self.folder / f"{self._testMethodName}_{name}"

    def limit(self, *arguments, model=None, code=0):
        done = wythe("limit", model or self.model, *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def test_writes_six_curves_pictures_numbers_and_a_page(self):
        out = self.out()
        self.limit("--out", out)
        data = json.loads((out / "mechanisms.json").read_text())
        self.assertEqual([m["name"] for m in data["mechanisms"]], NAMES)
        for m in data["mechanisms"]:
            rows = rows_of(out / (m["name"] + ".csv"))
            self.assertEqual(list(rows[0]), ["displacement_mm", "force_kN"])
            self.assertEqual(float(rows[0]["displacement_mm"]), 0)
            self.assertEqual(float(rows[-1]["force_kN"]), 0)
            self.assertAlmostEqual(float(rows[0]["force_kN"]), m["force_at_rest_kN"], places=6)
            self.assertIn("C23", (out / (m["name"] + ".svg")).read_text())
            for number in m["inputs"].values():
                self.assertEqual(sorted(number), ["unit", "value"])
            self.assertNotIn("assessment", m)
        for limit in data["limit_loads"]:
            self.assertLess(limit["gap"], 1e-6)
            self.assertEqual(len(limit["velocity_x"]), data["blocks"])
        self.assertIn("Macro-Block 2", (out / "report.html").read_text())
        self.assertIsNone(data["comparison"])

    def test_only_and_assessment(self):
        out = self.out()
        self.limit("--out", out, "--only", "infinite", "--assessment")
        data = json.loads((out / "mechanisms.json").read_text())
        self.assertEqual(data["limit_loads"], [])
        self.assertEqual(len(data["mechanisms"]), 2)
        a = data["mechanisms"][0]["assessment"]
        self.assertIn("C8.7.1.2.1", a["clause"])
        self.assertAlmostEqual(a["life_safety_displacement_mm"], 0.4 * a["displacement0_mm"])
        self.assertAlmostEqual(a["spectral_displacement0_mm"], a["spectral_share"] * a["displacement0_mm"])
        self.assertGreater(a["spectral_share"], 0)

    def test_parts_need_an_assessment_and_a_wall_that_has_them(self):
        for only in (("parts",), ("parts", "lp")):
            done = self.limit("--out", self.out(), "--only", *only, code=2)
            self.assertEqual(done.stderr, "--only: parts: are checked by an assessment alone; add --assessment\n")
        tilt = SOURCE / "examples/dry_tilt/model.toml"
        done = self.limit("--out", self.out(), "--only", "parts", "--assessment", model=tilt, code=2)
        self.assertIn("parts: none is here to check", done.stderr)
        self.assertFalse(self.out().exists())

    def test_assessment_of_what_has_no_chain_is_refused_by_name(self):
        out = self.out()
        model = self.folder / "plain.toml"
        model.write_text(dry(SMALL))
        self.limit("--out", out, "--assessment", model=model)
        refused = {r["what"]: r["why"] for r in json.loads((out / "mechanisms.json").read_text())["refused"]}
        self.assertIn("macro-blocks", refused["assessment"])


    def test_other_direction_mirrors_the_hinges(self):
        there, back = self.out("there"), self.out("back")
        self.limit("--out", there, "--only", "macro_block_1")
        self.limit("--out", back, "--only", "macro_block_1", "--set", "stage.push.direction=-x",
                   "--set", "stage.push.at.x=0.8 m")
        hinges = [json.loads((out / "mechanisms.json").read_text())["mechanisms"][1]["hinges_m"]
                  for out in (there, back)]
        for a, b in zip(*hinges):
            self.assertAlmostEqual(a[0], 0.8 - b[0], places=9)
            self.assertAlmostEqual(a[1], b[1], places=9)

    def test_beside_a_run_and_a_run_that_cannot_be(self):
        run = self.out("run")
        model = self.folder / "dry.toml"
        model.write_text(dry(SMALL.replace('until = "3 mm"', 'until = "1 mm"')))
        fast = self.out("fast")
        self.assertEqual(wythe("run", model, "--out", fast, "--quiet").returncode, 0)
        done = self.limit("--out", self.out("l"), "--with", fast, "--only", "lp", model=model)
        self.assertIn("no evidence", done.stderr, "pushed too fast, by its own verdict")
        self.assertNotIn("within the limit loads", done.stdout)
        slow = ["--set", "stage.push.velocity=1 mm/s", "--set", "stage.push.ramp=0.2 s"]
        self.assertEqual(wythe("run", model, "--out", run, "--quiet", *slow).returncode, 0)
        done = self.limit("--out", run, "--with", run, "--only", "lp", model=model)
        data = json.loads((run / "mechanisms.json").read_text())["comparison"]
        self.assertTrue(data["bounds"][0]["holds"], data["bounds"])
        self.assertEqual(data["bounds"][0]["allowance"], 0.02, "whatever the run's own rate")
        self.assertEqual(data["without_bound"], [])
        self.assertTrue((run / "limit.html").exists(), "the run's own report stays")
        self.assertNotIn("error of the run", done.stderr)
        # the same run with ten times its force: no wall of these joints does that
        false = self.out("false")
        shutil.copytree(run, false)
        with open(false / "force_displacement.csv", encoding="utf-8") as file:
            lines = file.read().splitlines()
        scaled = [lines[0]]
        for line in lines[1:]:
            cells = line.split(",")
            cells[3] = str(10 * float(cells[3]))
            scaled.append(",".join(cells))
        (false / "force_displacement.csv").write_text("\n".join(scaled) + "\n")
        summary = json.loads((false / "summary.json").read_text())
        summary["quasi_static"]["damping_share"] = 50.0  # no word of its own excuses it
        if "peak_raw_kN" in summary:
            summary["peak_reaction_kN"] = 10 * summary["peak_raw_kN"]
        (false / "summary.json").write_text(json.dumps(summary))
        done = self.limit("--out", self.out(), "--with", false, "--only", "lp", model=model, code=3)
        self.assertIn("error of the run", done.stderr)
        (false / "force_displacement.csv").write_text(lines[0] + "\n")
        done = self.limit("--out", self.out("empty"), "--with", false, "--only", "lp", model=model, code=4)
        self.assertIn("holds no row", done.stderr)

    def test_beside_a_campaign(self):
        (self.folder / "study.toml").write_text(STUDY)
        campaign = self.out("campaign")
        self.assertEqual(wythe("campaign", self.folder / "study.toml", "--out", campaign, "--samples", 3,
                               "--quiet").returncode, 0)
        self.limit("--out", self.out(), "--with", campaign, "--only", "infinite")
        data = json.loads((self.out() / "mechanisms.json").read_text())["comparison"]
        self.assertEqual(data["runs"], 3)
        self.assertGreaterEqual(len(data["curves"]), 3)
        self.assertTrue(all(c["run"].startswith("sample ") for c in data["curves"]))

    def test_dry_campaign_of_a_wall_with_a_lintel_has_its_bounds(self):
        model, study = self.folder / "dry_lintel.toml", self.folder / "dry_study.toml"
        model.write_text(re.sub(r'velocity = "[^"]*"', 'velocity = "1 mm/s"', dry(LINTEL)))
        study.write_text(f"""
[study]
name = "dry"
model = "{model.name}"
samples = 2
seed = 7
[variable.phi]
path = "material.joint.friction_angle"
unit = "deg"
distribution = "normal"
mean = "33 deg"
cov = 0.02
""")
        campaign = self.out("campaign")
        done = wythe("campaign", study, "--out", campaign, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.limit("--out", self.out(), "--with", campaign, "--only", "lp", model=model)
        data = json.loads((self.out() / "mechanisms.json").read_text())
        self.assertNotIn("bonded", [limit["name"] for limit in data["limit_loads"]])
        self.assertEqual(len(data["comparison"]["bounds"]), 2)
        self.assertTrue(all(b["holds"] for b in data["comparison"]["bounds"]))
        silent = [b for b in data["comparison"]["bounds"] if b["no_evidence"]]
        self.assertEqual(done.stderr.count("no evidence"), len(silent), done.stderr)
        self.assertEqual(f"{2 - len(silent)} runs within" in done.stdout, len(silent) < 2)

    def test_stopped_it_keeps_nothing_half_and_says_so(self):
        process = start("limit", FACADE, "--out", self.out(), "--only", "lp")
        for line in process.stderr:  # the forecast: the first programme is next
            if "limit loads of 4660 blocks: about" in line:
                break
        process.send_signal(signal.SIGTERM)
        rest = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 3, rest)
        self.assertIn("stopped by the user", rest[1])
        self.assertFalse(self.out().exists())

    def test_a_lintel_of_zones_is_counted(self):
        model = self.folder / "zones.toml"
        both = []
        for kind in ("zones", "segments"):
            model.write_text(LINTEL.replace('material = "timber" }', f'material = "timber", model = "{kind}" }}'))
            self.limit("--out", self.out(kind), "--only", "lp", "infinite", model=model)
            both.append(json.loads((self.out(kind) / "mechanisms.json").read_text()))
        for a, b in zip(both[0]["mechanisms"], both[1]["mechanisms"]):
            self.assertAlmostEqual(a["force_at_rest_kN"] / b["force_at_rest_kN"], 1, places=6)
        self.assertEqual(len(both[0]["mechanisms"]), 2)
        loads = [data["limit_loads"][0]["static_kN"] for data in both]
        self.assertGreater(loads[0], 0)
        self.assertAlmostEqual(loads[0] / loads[1], 1, places=6, msg="an unlimited chain is as rigid as one block")

    def test_without_friction_no_ratio_is_asked(self):
        model = self.folder / "ice.toml"
        text = dry(SMALL)
        for angle in ("30 deg", "38 deg"):
            text = text.replace(f'friction_angle = "{angle}"', 'friction_angle = "0 deg"')
        model.write_text(text)
        done = self.limit("--out", self.out(), "--only", "lp", model=model)
        self.assertNotIn("nan", done.stdout)
        self.assertNotIn("-0 kN", done.stdout)

    def test_without_friction_in_space_the_load_is_nothing(self):
        done = self.limit("--out", self.out(), "--only", "lp", "--set", "material.joint.friction_tan=0",
                          "--set", "material.joint.residual_friction_tan=0",
                          model=pathlib.Path(SOURCE) / "examples/wall_with_returns/model.toml")
        loads = json.loads((self.out() / "mechanisms.json").read_text())["limit_loads"]
        self.assertGreater(len(loads), 0, done.stderr)
        for load in loads:
            self.assertAlmostEqual(load["static"], 0, places=6)
            self.assertAlmostEqual(load["kinematic"], 0, places=6)

    def test_a_run_of_another_wall_is_told(self):
        run = self.out("run")
        self.assertEqual(wythe("run", self.model, "--out", run, "--quiet").returncode, 0)
        own = self.limit("--out", self.out("own"), "--with", run, "--only", "lp")
        self.assertNotIn("another wall", own.stderr)
        self.assertIn("limit loads of the model", own.stdout, "a wall with bond is held against its bracket")
        other = self.limit("--out", self.out("other"), "--with", run, "--only", "lp",
                           "--set", "stage.precompression.pier_load=30 kN")
        self.assertIn("another wall", other.stderr)
        notes = json.loads((self.out("other") / "mechanisms.json").read_text())["notes"]
        self.assertEqual(len([note for note in notes if "another wall" in note]), 1, notes)

    def test_units_that_count_as_cracked_are_told(self):
        done = self.limit("--out", self.out(), "--only", "lp")
        self.assertIn("crack planes inside units count as joints without bond", done.stderr)
        notes = json.loads((self.out() / "mechanisms.json").read_text())["notes"]
        self.assertEqual(len([note for note in notes if "units have all cracked" in note]), 1, notes)
        whole = self.limit("--out", self.out("whole"), "--only", "lp", "--set", "wall.unit.split=none")
        self.assertNotIn("crack planes", whole.stderr)

    def test_what_is_refused_does_not_stop_the_rest(self):
        text = DOOR.replace('compressive_strength = "4 MPa"', 'compressive_strength = "unlimited"')
        model = self.folder / "strong.toml"
        model.write_text(text.replace('compressive_energy = "12800 N/m"\n', ""))
        done = self.limit("--out", self.out(), model=model)
        data = json.loads((self.out() / "mechanisms.json").read_text())
        self.assertEqual([m["hypothesis"] for m in data["mechanisms"]], ["infinite", "infinite"])
        self.assertEqual(len(data["refused"]), 4)
        self.assertGreater(len(data["limit_loads"]), 0)
        self.assertIn("FM-4 Macro-Block 2 left out", done.stderr)

    def refused(self, text, words, *arguments):
        model = self.folder / "refused.toml"
        model.write_text(text)
        done = self.limit("--out", self.out(), *arguments, model=model, code=2)
        self.assertIn(words, done.stderr)
        self.assertIn(";", done.stderr, "a cure follows the problem")
        self.assertFalse(self.out().exists(), "nothing is written")

    def test_walls_outside_say_why(self):
        self.refused(SMALL, "no opening", "--only", "infinite")
        low = DOOR.replace('y = "0.75 m" }', 'y = "0.05 m" }')
        self.refused(low.replace('x = "0 m", y = "0.05 m"', 'x = "0.75 m", y = "0.05 m"'), "stays in FM-1", "--only", "infinite")
        strong = DOOR.replace('compressive_strength = "4 MPa"', 'compressive_strength = "unlimited"')
        strong = strong.replace('compressive_energy = "12800 N/m"\n', "")
        self.refused(strong, "need a compressive strength", "--only", "macro_block_1")
        self.refused(DOOR, "neither a run", "--with", str(self.folder))
        # without an opening the blocks' own limit load is still there
        plain = self.folder / "plain.toml"
        plain.write_text(SMALL)
        self.limit("--out", self.out("plain"), "--only", "lp", model=plain)

    def test_paper_wall_gives_its_six_curves(self):
        out = self.out()
        self.limit("--out", out, "--only", "infinite", "macro_block_1", "macro_block_2", model=TUFF)
        force = {name: float(rows_of(out / (name + ".csv"))[0]["force_kN"]) for name in NAMES}
        for mode in ("fm1", "fm4"):
            self.assertGreater(force[f"mechanism_{mode}_infinite"], force[f"mechanism_{mode}_macro_block_1"])
            self.assertGreater(force[f"mechanism_{mode}_macro_block_1"], force[f"mechanism_{mode}_macro_block_2"])


if __name__ == "__main__":
    unittest.main()
