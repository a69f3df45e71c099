#!/usr/bin/env python3
"""wythe export: its tables agree with the store and with the files of a run."""
import csv
import json
import pathlib
import shutil
import sqlite3
import subprocess
import unittest

import campaign_test
from cli_test import wythe
from stores import renew_checksums


def read_table(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Export(campaign_test.Base):
    """wythe export: what the tables say is what the store says, to the last digit."""

    def export(self, source, *more):
        done = wythe("export", source, "--out", self.out(), *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_curves_are_those_of_the_store(self):
        done = self.export(self.whole)
        self.assertRegex(done.stdout, r"^6 samples, \d+ rows of curves, \d+ states -> ")
        made = {p.name for p in self.out().iterdir()}
        self.assertEqual(made, {"curves.csv", "samples.csv", "state_blocks.csv", "state_joints.csv", "columns.json", ".wythe_model"})
        told = json.loads((self.out() / "columns.json").read_text(encoding="utf-8"))
        scale = {"mm": 1e3, "%": 1e2, "kN": 1e-3}
        with sqlite3.connect(self.whole / "campaign.db") as store:
            rows = store.execute("SELECT sample, rows, length(data) FROM curve ORDER BY sample").fetchall()
        curves = read_table(self.out() / "curves.csv")
        self.assertEqual(len(curves), sum(n for _, n, _ in rows))
        for sample, n, _ in rows:
            self.assertEqual(sum(r["sample"] == str(sample) for r in curves), n)
        self.assertEqual([c["name"] for c in told["curves.csv"]], list(curves[0]))
        self.assertEqual({c["name"]: c["unit"] for c in told["curves.csv"]}["reaction_kN"], "kN")
        # the replayed run's file has ten digits of the same numbers
        replayed = self.folder / "replayed_for_export"
        self.assertEqual(wythe("replay", self.whole, "--sample", 2, "--out", replayed, "--quiet").returncode, 0)
        for ours, theirs in zip([r for r in curves if r["sample"] == "2"], read_table(replayed / "force_displacement.csv")):
            for name, cell in theirs.items():
                self.assertAlmostEqual(float(ours[name]), float(cell), delta=1e-9 * abs(float(cell)), msg=name)

    def test_samples_read_back_as_the_same_doubles(self):
        self.export(self.whole)
        table = read_table(self.out() / "samples.csv")
        with sqlite3.connect(self.whole / "campaign.db") as store:
            store.row_factory = sqlite3.Row
            stored = store.execute("SELECT * FROM sample ORDER BY sample").fetchall()
            inputs = dict(store.execute("SELECT sample, value FROM sample_input WHERE position = 0").fetchall())
        self.assertEqual(len(table), 6)
        for row, there in zip(table, stored):
            self.assertEqual(float(row["ft_MPa"]), inputs[there["sample"]] * 1e-6)
            self.assertEqual(float(row["peak_reaction_kN"]), there["peak_reaction_N"] * 1e-3)
            self.assertEqual(float(row["bilinear_force_kN"]), there["bilinear_force_N"] * 1e-3)
            self.assertEqual(row["state_hash"], there["state_hash"])
            self.assertEqual(row["reason"], there["reason"])
        told = json.loads((self.out() / "columns.json").read_text(encoding="utf-8"))
        self.assertEqual([c["name"] for c in told["samples.csv"]], list(table[0]))
        self.assertTrue(all(c["meaning"] for columns in told.values() for c in columns))

    def test_states_of_a_sample_are_those_of_its_run(self):
        # a run stores double precision, a store seven digits
        self.export(self.whole)
        run = self.folder / "run_of_sample_3"
        self.assertEqual(wythe("replay", self.whole, "--sample", 3, "--out", run, "--quiet").returncode, 0)
        tables = self.folder / "tables_of_sample_3"
        done = wythe("export", run, "--out", tables)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, least in (("state_blocks.csv", 50), ("state_joints.csv", 100)):
            mine = [r for r in read_table(self.out() / name) if r["sample"] == "3"]
            at = {r["push_displacement_mm"][:6] for r in mine}
            theirs = [r for r in read_table(tables / name) if r["push_displacement_mm"][:6] in at]
            self.assertGreater(len(mine), least)
            self.assertEqual(len(mine), len(theirs))
            for a, b in zip(mine, theirs):
                for key in a:
                    if key in ("sample", "state", "label", "push_displacement_mm"):
                        continue
                    try:
                        self.assertAlmostEqual(float(a[key]), float(b[key]), delta=2e-4 * max(1, abs(float(b[key]))), msg=key)
                    except ValueError:
                        self.assertEqual(a[key], b[key], key)

    def test_a_run_gives_the_same_tables(self):
        run = self.folder / "run_to_export"
        self.assertEqual(wythe("run", self.folder / "model.toml", "--out", run, "--quiet").returncode, 0)
        self.export(run)
        rows, summary = read_table(self.out() / "samples.csv"), json.loads((run / "summary.json").read_text())
        self.assertEqual(float(rows[0]["peak_reaction_kN"]), summary["peak_reaction_kN"])
        self.assertEqual(float(rows[0]["bilinear_force_kN"]), summary["bilinear"]["force_kN"])
        curve = read_table(self.out() / "curves.csv")
        self.assertEqual([{k: v for k, v in r.items() if k != "sample"} for r in curve],
                         read_table(run / "force_displacement.csv"))
        joints = read_table(self.out() / "state_joints.csv")
        self.assertEqual(len(joints) % (summary["joints"]), 0)
        self.assertGreater(max(float(r["opening_mm"]) for r in joints), 0)
        blocks = read_table(self.out() / "state_blocks.csv")
        end = [r for r in blocks if r["state"] == blocks[-1]["state"]]
        self.assertGreater(max(float(r["displacement_x_mm"]) for r in end), 0.5)

    def test_a_wall_whose_opening_is_cut_has_its_frame_and_no_more_its_masonry(self):
        model = pathlib.Path(__file__).parent.parent.parent / "examples/opening/after.toml"
        short = ("stage.push.until=0.2 mm", "stage.push.velocity=20 mm/s", "stage.push.fast_velocity=20 mm/s")
        run = self.folder / "run_of_a_cut"
        options = [word for key in short for word in ("--set", key)]
        self.assertIn(wythe("run", model, "--out", run, "--quiet", "--set", 'output.states=["0.1 mm"]', *options).returncode, (0, 3))
        (self.folder / "cut.toml").write_text(
            f'[study]\nmodel = "{model}"\nsamples = 2\nseed = 1\ndesign = "monte_carlo"\nstates = ["0.1 mm"]\n'
            '[variable.ft]\npath = "material.joint.tensile_strength"\ndistribution = "uniform"\nlow = "0.09 MPa"\nhigh = "0.1 MPa"\n')
        campaign = self.folder / "campaign_of_a_cut"
        done = wythe("campaign", self.folder / "cut.toml", "--out", campaign, "--quiet", *options)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        for source in (run, campaign):
            shutil.rmtree(self.out(), ignore_errors=True)
            self.export(source)
            joints = [r for r in read_table(self.out() / "state_joints.csv") if r["state"] == "0"]
            roles = {r["block"]: r["role"] for r in read_table(self.out() / "state_blocks.csv")}
            self.assertIn("cut_out", roles.values())
            pressed = {"cut_out": 0.0, "frame": 0.0}
            for r in joints:
                for side in (r["block_a"], r["block_b"]):
                    if roles.get(side) in pressed:
                        pressed[roles[side]] = max(pressed[roles[side]], -float(r["normal_stress_MPa"]))
            self.assertEqual(pressed["cut_out"], 0)  # gone
            self.assertGreater(pressed["frame"], 0.01)  # and what is in its place bears

    def test_names_with_commas_quotes_and_newlines_come_back(self):
        # the reason of a refused sample is a text of several clauses
        with sqlite3.connect(self.copy()) as store:
            store.execute("UPDATE sample SET reason = ?, reason_message = '' WHERE sample = 1", ('à, "b"\r\nc',))
            renew_checksums(store)
        self.export(self.out().rename(self.folder / "spoilt"))
        self.assertEqual(read_table(self.out() / "samples.csv")[0]["reason"], 'à, "b"\r\nc')

    def test_an_earlier_export_is_replaced_and_nothing_else(self):
        self.export(self.whole)
        before = (self.out() / "curves.csv").read_bytes()
        self.export(self.whole)
        self.assertEqual((self.out() / "curves.csv").read_bytes(), before)
        (self.out() / "notes.txt").write_text("mine")
        self.refused(wythe("export", self.whole, "--out", self.out()), 2, "notes.txt", "name a new folder")
        (self.out() / "notes.txt").unlink()
        for target in (self.whole, self.folder):  # a campaign; files of somebody else
            self.refused(wythe("export", self.whole, "--out", target), 2, "which no export wrote")

    def test_what_is_not_there_is_said(self):
        shard = self.folder / "half"
        self.assertEqual(wythe("campaign", self.study, "--out", shard, "--shard", "1/2", "--quiet", "--set",
                               "study.states=[]").returncode, 0)
        done = self.export(shard)
        self.assertIn("3 samples of the study have not run", done.stderr)
        self.assertEqual([r["sample"] for r in read_table(self.out() / "samples.csv")], ["1", "3", "5"])
        empty = self.folder / "empty"
        empty.mkdir()
        self.refused(wythe("export", empty, "--out", self.folder / "none"), 2, "holds neither a run", "campaign.db")

    def test_campaigns_side_by_side_are_exported_side_by_side(self):
        both = self.folder / "side_by_side"
        for name in ("base", "option"):
            (both / name).mkdir(parents=True)
            (both / name / "campaign.db").write_bytes((self.whole / "campaign.db").read_bytes())
        done = self.export(both)
        self.assertEqual(done.stdout.count("6 samples"), 2)
        self.assertEqual({p.name for p in self.out().iterdir()}, {"base", "option"})
        for name in ("base", "option"):
            self.assertEqual(len(read_table(self.out() / name / "samples.csv")), 6)
        (self.out() / "notes.txt").write_text("mine")
        self.refused(wythe("export", both, "--out", self.out()), 2, "notes.txt")
        self.refused(wythe("export", both, "--out", both), 2, "which no export wrote")

    def test_no_stored_states_is_said(self):
        with sqlite3.connect(self.copy()) as store:
            store.execute("DELETE FROM state")
            renew_checksums(store)
        done = self.export(self.out().rename(self.folder / "stateless"))
        self.assertIn("no states are stored", done.stderr)
        self.assertFalse((self.out() / "state_joints.csv").exists())

    def test_a_damaged_store_leaves_the_earlier_tables(self):
        spoilt = self.copy()
        with sqlite3.connect(spoilt) as store:
            store.execute("UPDATE curve SET data = x'00' WHERE sample = 4")
        source = self.out().rename(self.folder / "damaged_source")
        self.export(self.whole)
        before = {p.name: p.read_bytes() for p in self.out().iterdir()}
        self.refused(wythe("export", source, "--out", self.out(), "--replace"), 4, "sample 4")
        self.assertEqual({p.name: p.read_bytes() for p in self.out().iterdir() if p.is_file()}, before)
        # a state of another wall
        with sqlite3.connect(source / "campaign.db") as store:
            store.execute("UPDATE curve SET data = (SELECT data FROM curve WHERE sample = 3), rows = "
                          "(SELECT rows FROM curve WHERE sample = 3) WHERE sample = 4")
            store.execute("UPDATE state SET blocks = blocks + 1 WHERE sample = 2")
        self.refused(wythe("export", source, "--out", self.out(), "--replace"), 4)

    def test_a_run_whose_files_do_not_belong_together(self):
        run = self.folder / "run_spoilt"
        self.assertEqual(wythe("run", self.folder / "model.toml", "--out", run, "--quiet").returncode, 0)
        joints = run / "state_joints_00.vtu"
        whole = joints.read_text()
        joints.write_text(whole[:len(whole) // 2])
        self.refused(wythe("export", run, "--out", self.out()), 4, "state_joints_00.vtu")
        joints.write_text((run / "state_blocks_00.vtu").read_text())
        self.refused(wythe("export", run, "--out", self.out()), 4, "don't belong together")

    def test_pandas_reads_them(self):
        python = "/usr/bin/python3"
        self.export(self.whole)
        code = ("import sys, pandas as pd; d = sys.argv[1]; c = pd.read_csv(d + '/curves.csv'); s = pd.read_csv(d + "
                "'/samples.csv'); print(c.groupby('sample').reaction_kN.max().shape[0], s.merge(c, on='sample').shape[0] == len(c))")
        done = subprocess.run([python, "-c", code, str(self.out())], capture_output=True, text=True)
        if "No module named 'pandas'" in done.stderr or not pathlib.Path(python).exists():
            self.skipTest("no pandas here")
        self.assertEqual(done.stdout.split(), ["6", "True"], done.stderr)


if __name__ == "__main__":
    unittest.main()
