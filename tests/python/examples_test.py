#!/usr/bin/python3
"""The lectures of examples/python, each with --quick; and the content of their figures."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
FOLDER = SOURCE / "examples/python"


class Examples(unittest.TestCase):
    def told(self, name):
        """What a lecture prints; it has to write its picture."""
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["/usr/bin/python3", FOLDER / f"{name}.py", "--quick"], cwd=folder, capture_output=True,
                                  text=True, check=False, env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            self.assertEqual(pathlib.Path(folder, f"{name}.png").read_bytes()[:4], b"\x89PNG")
        return done.stdout

    def test_sobol_the_load_decides_the_capacity_and_the_joints_the_stiffness(self):
        text = self.told("sobol")
        capacity, stiffness = text.split("initial_stiffness_kN_per_mm")
        for part, strong in ((capacity, "P"), (stiffness, "kn")):
            totals = {name: float(t) for name, t in re.findall(r"^  (\w+) .*   T +(-?[\d.]+)", part, re.M)}
            self.assertEqual(sorted(totals), ["P", "density", "kn", "phi"])
            self.assertEqual(max(totals, key=totals.get), strong)
            self.assertTrue(all(t < 0.1 for name, t in totals.items() if name != strong), totals)

    def test_surrogate_cross_validation_tells_the_error_of_fresh_walls(self):
        rows = re.findall(r"^ +(\d) +\d+ +([\d.]+) kN +([\d.]+) kN +([\d.]+) kN", self.told("surrogate"), re.M)
        self.assertEqual([row[0] for row in rows], ["1", "2", "3"])
        own, cross, fresh = ([float(row[i]) for row in rows] for i in (1, 2, 3))
        self.assertEqual(own, sorted(own, reverse=True))  # always falls: it proves nothing
        best = min(range(3), key=lambda i: cross[i])
        self.assertTrue(0.4 < fresh[best] / cross[best] < 2.5, rows)

    def test_reliability_agrees_with_the_line(self):
        text = self.told("reliability")
        found = float(re.search(r"^probability ([\de.-]+)", text, re.M).group(1))
        by_hand = float(re.search(r"walls: ([\de.-]+)$", text, re.M).group(1))
        self.assertTrue(1e-5 < by_hand < 2e-2, text)
        self.assertTrue(1 / 8 < found / by_hand < 8, text)  # 50 walls a step: CoV near 0.6 of each

    def test_calibration_learns_the_stiffness_and_not_the_friction(self):
        text = self.told("calibration")
        gone = {name: int(share) for name, share in re.findall(r"^(\S+).* (\d+)%$", text, re.M) if name in ("kn", "tan(phi)")}
        self.assertGreater(gone["kn"], 80)
        self.assertLess(gone["tan(phi)"], 50)
        self.assertLess(float(re.search(r"R-hat ([\d.]+)", text).group(1)), 1.1)
        self.assertIn("not used", text)

    def test_every_lecture_is_tested_and_listed(self):
        names = sorted(path.stem for path in FOLDER.glob("*.py"))
        self.assertEqual(names, ["calibration", "reliability", "sobol", "surrogate"])
        page = (FOLDER / "README.md").read_text(encoding="utf-8")
        for name in names:
            self.assertIn(f"{name}.py", page)
            self.assertTrue((FOLDER / f"{name}.png").is_file(), name)


if __name__ == "__main__":
    unittest.main()
