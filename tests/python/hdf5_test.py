#!/usr/bin/python3
"""wythe export --hdf5: h5py reads the values of the CSV tables, to the last digit."""
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()


def wythe(*words, code=0):
    done = subprocess.run([BUILD / "wythe", *words], capture_output=True, text=True, check=False)
    assert done.returncode == code, done.stderr
    return done


class Hdf5(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        short = 'stage.push.targets=["1 mm"]'
        wythe("campaign", SOURCE / "examples/tuff_wall/study.toml", "--out", cls.folder / "campaign", "--samples", "3",
              "--quiet", "--set", short)
        wythe("run", SOURCE / "examples/tuff_wall/model.toml", "--out", cls.folder / "run", "--quiet", "--set", short)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def compare(self, source):
        wythe("export", self.folder / source, "--out", self.folder / f"{source}_csv")
        wythe("export", self.folder / source, "--out", self.folder / f"{source}_hdf5", "--hdf5")
        self.assertEqual(sorted(p.name for p in (self.folder / f"{source}_hdf5").iterdir()), [".wythe_model", "results.h5"])
        told = json.loads((self.folder / f"{source}_csv/columns.json").read_text(encoding="utf-8"))
        with h5py.File(self.folder / f"{source}_hdf5/results.h5") as file:
            self.assertEqual(sorted(file), sorted(name.removesuffix(".csv") for name in told))
            for name, columns in told.items():
                with (self.folder / f"{source}_csv/{name}").open(newline="", encoding="utf-8") as table:
                    rows = list(csv.DictReader(table))
                group = file[name.removesuffix(".csv")]
                self.assertEqual(sorted(group), sorted(column["name"] for column in columns))
                for column in columns:
                    dataset = group[column["name"]]
                    self.assertEqual(dataset.attrs.get("unit", ""), column["unit"])
                    self.assertEqual(dataset.attrs["meaning"], column["meaning"])
                    cells = [row[column["name"]] for row in rows]
                    if dataset.dtype == numpy.float64:
                        numbers = [float(cell) if cell else numpy.nan for cell in cells]
                        numpy.testing.assert_array_equal(dataset[:], numbers)
                    else:
                        self.assertEqual(list(dataset.asstr()[:]), cells)
        return told

    def test_a_campaign_reads_back(self):
        told = self.compare("campaign")
        self.assertIn("state_joints.csv", told)

    def test_a_run_reads_back(self):
        self.compare("run")

    def test_more_rows_than_a_chunk(self):
        self.compare("campaign")
        with h5py.File(self.folder / "campaign_hdf5/results.h5") as file:
            joints = file["state_joints/opening_mm"]
            self.assertGreater(joints.shape[0], 1500)
            self.assertEqual(file["curves/sample"][:].tolist(), sorted(file["curves/sample"][:].tolist()))

    def test_equal_results_give_equal_bytes(self):
        for name in ("one", "two"):
            wythe("export", self.folder / "campaign", "--out", self.folder / name, "--hdf5")
        one, two = ((self.folder / name / "results.h5").read_bytes() for name in ("one", "two"))
        self.assertEqual(one, two)

    def test_an_export_replaces_an_export_of_the_other_kind(self):
        out = self.folder / "both"
        wythe("export", self.folder / "run", "--out", out)
        wythe("export", self.folder / "run", "--out", out, "--hdf5")
        self.assertEqual(sorted(p.name for p in out.iterdir()), [".wythe_model", "results.h5"])
        wythe("export", self.folder / "run", "--out", out)
        self.assertNotIn("results.h5", [p.name for p in out.iterdir()])


if __name__ == "__main__":
    unittest.main()
