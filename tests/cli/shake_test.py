#!/usr/bin/env python3
"""Earthquakes from the command line: a record is checked before the run, histories are written, and the
folder of a run can be run again."""
import csv
import json
import pathlib
import tempfile
import unittest

from cli_test import SOURCE, wythe

EXAMPLE = SOURCE / "examples/shaken_parapet"


class Shake(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.held.name)
        self.model = self.folder / "model.toml"
        self.model.write_text((EXAMPLE / "model.toml").read_text().replace("6 m/s^2", "2 m/s^2")
                              .replace("2 s", "0.4 s"))
        lines = (EXAMPLE / "record.csv").read_text().splitlines()
        (self.folder / "record.csv").write_text("\n".join(lines[:42]) + "\n")

    def tearDown(self):
        self.held.cleanup()

    def summary(self, out):
        return json.loads((out / "summary.json").read_text())

    def test_check_tells_record_damping_and_cost_before_the_run(self):
        done = wythe("check", self.model)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("record.csv, column acceleration_m_per_s2 in m/s2", done.stdout)
        self.assertIn("shorten the time step", done.stdout)
        self.assertIn("steps", done.stdout)

    def test_a_run_writes_history_and_summary_and_can_be_run_again_where_it_is(self):
        out, again = self.folder / "out", self.folder / "again"
        done = wythe("run", self.model, "--out", out, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("shaken with a peak of", done.stdout)
        rows = list(csv.DictReader((out / "history.csv").read_text().splitlines()))
        self.assertGreater(len(rows), 100)
        for column in ("time_s", "base_acceleration_z_m_per_s2", "base_shear_z_kN", "drift_percent", "crest_uz_mm"):
            self.assertIn(column, rows[0])
        self.assertGreater(max(abs(float(r["base_shear_z_kN"])) for r in rows), 0.01)
        said = self.summary(out)
        shaking = said["shaking"]
        self.assertFalse(shaking["collapsed"])
        self.assertEqual(shaking["points"][0]["name"], "crest")
        self.assertAlmostEqual(shaking["records"][0]["pga_g"], 2 / 9.80665, places=6)
        self.assertEqual(shaking["damping"][0]["local"], 0)
        self.assertIn("no rate is judged", said["quasi_static"]["verdict"])
        page = (out / "report.html").read_text()
        self.assertIn("Shaken with a peak", page)
        self.assertIn('<p class="kind">A wall under an earthquake', page)  # no push-over
        # the record lies in the folder, and the model that was used names it with its hash
        (self.folder / "record.csv").unlink()
        done = wythe("run", out / "model.used.toml", "--out", again, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.summary(again)["state_hash"], said["state_hash"])

    def test_a_missing_record_and_a_wrong_unit_are_refused(self):
        done = wythe("check", self.model, "--set", 'stage.quake.record={file="none.csv",unit="g"}')
        self.assertEqual(done.returncode, 2)
        self.assertIn("none.csv", done.stderr)
        done = wythe("check", self.model, "--set",
                     'stage.quake.record={accelerations=[0,300,-300,0],step="0.01 s",unit="m/s2"}')
        self.assertEqual(done.returncode, 2)
        self.assertIn("often cm/s2", done.stderr)


if __name__ == "__main__":
    unittest.main()
