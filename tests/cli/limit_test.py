#!/usr/bin/env python3
"""wythe limit as a user meets it: files, columns, both directions, comparison with runs, refusals."""
import csv
import json
import pathlib
import shutil
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

    def test_other_direction_mirrors_the_hinges(self):
        there, back = self.out("there"), self.out("back")
        self.limit("--out", there, "--only", "macro_block_1")
        self.limit("--out", back, "--only", "macro_block_1", "--set", "stage.push.direction=-x")
        hinges = [json.loads((out / "mechanisms.json").read_text())["mechanisms"][1]["hinges_m"]
                  for out in (there, back)]
        for a, b in zip(*hinges):
            self.assertAlmostEqual(a[0], 0.8 - b[0], places=9)
            self.assertAlmostEqual(a[1], b[1], places=9)

    def test_beside_a_run_and_a_run_that_cannot_be(self):
        run = self.out("run")
        dry = self.folder / "dry.toml"
        text = SMALL.replace('until = "3 mm"', 'until = "1 mm"')
        for line in ('tensile_strength = "0.15 MPa"', 'tensile_strength = "0.5 MPa"'):
            text = text.replace(line, 'tensile_strength = "0 MPa"')
        for line in ('cohesion = "0.15 MPa"', 'cohesion = "0.75 MPa"'):
            text = text.replace(line, 'cohesion = "0 MPa"')
        dry.write_text(text)
        self.assertEqual(wythe("run", dry, "--out", run, "--quiet").returncode, 0)
        done = self.limit("--out", run, "--with", run, "--only", "lp", model=dry)
        data = json.loads((run / "mechanisms.json").read_text())["comparison"]
        self.assertTrue(data["bounds"][0]["holds"], data["bounds"])
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
        done = self.limit("--out", self.out(), "--with", false, "--only", "lp", model=dry, code=3)
        self.assertIn("error of the run", done.stderr)

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

    def refused(self, text, words, *arguments):
        model = self.folder / "refused.toml"
        model.write_text(text)
        done = self.limit("--out", self.out(), *arguments, model=model, code=2)
        self.assertIn(words, done.stderr)
        self.assertIn(";", done.stderr, "a cure follows the problem")
        self.assertFalse(self.out().exists(), "nothing is written")

    def test_walls_outside_say_why(self):
        self.refused(SMALL, "no opening")
        low = DOOR.replace('y = "0.75 m" }', 'y = "0.05 m" }')
        self.refused(low.replace('x = "0 m", y = "0.05 m"', 'x = "0.75 m", y = "0.05 m"'), "stays in FM-1")
        strong = DOOR.replace('compressive_strength = "4 MPa"', 'compressive_strength = "unlimited"')
        strong = strong.replace('compressive_energy = "12800 N/m"\n', "")
        self.refused(strong, "need a compressive strength")
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
