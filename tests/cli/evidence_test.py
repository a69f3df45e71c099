#!/usr/bin/env python3
"""tools/evidence: studies become pages that name the program, and keep text that people wrote; a faulty study is refused alone."""
import csv
import importlib.machinery
import importlib.util
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import unittest

from campaign_test import MODEL, STUDY
from cli_test import SOURCE, WYTHE, wythe

TOOL = SOURCE / "tools/evidence"
OPTIONS = '\n[[variant]]\nname = "damped"\nset = ["stage.push.damping=0.4"]\n[[variant]]\nname = "stiff"\nset = ["material.joint.normal_stiffness=30 GPa/m"]\n'


def module(path):
    """A tool without .py."""
    loader = importlib.machinery.SourceFileLoader(path.name, str(path))
    made = importlib.util.module_from_spec(importlib.util.spec_from_loader(path.name, loader))
    loader.exec_module(made)
    return made


class Evidence(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.studies, self.pages, self.out = (self.folder / name for name in ("studies", "pages", "out"))
        self.studies.mkdir()
        (self.studies / "model.toml").write_text(MODEL)

    def study(self, name, text=STUDY + OPTIONS):
        (self.studies / f"{name}.toml").write_text(text)

    def evidence(self, *arguments, program=WYTHE):
        command = [sys.executable, TOOL, *arguments, "--wythe", program, "--studies", self.studies, "--pages", self.pages, "--out", self.out]
        return subprocess.run([str(c) for c in command], cwd=self.folder, capture_output=True, text=True, timeout=300)

    def made(self, *arguments):
        done = self.evidence(*arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def rows(self, page):
        return [line for line in (self.pages / page).read_text().splitlines() if line.startswith("| ")]

    # --- the studies of this project

    def test_every_study_draws_samples_of_which_none_is_refused(self):
        found = [p for p in sorted((SOURCE / "studies").glob("*.toml")) if "[study]" in p.read_text()]
        self.assertEqual([p.stem for p in found],
                         ["block_size.facade", "block_size.pier", "block_size.portal", "choices", "fields", "walls"])
        for study in found:
            done = wythe("check", study)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("will be refused", done.stdout)

    def test_every_page_of_a_study_stands_in_the_documents(self):
        for name in module(TOOL).known(type("Arguments", (), {"studies": SOURCE / "studies"})):
            self.assertTrue("<!-- kept -->" in (SOURCE / f"docs/evidence/{name}.md").read_text(), name)

    # --- a study with options

    def test_a_page_says_what_the_comparison_says_and_who_made_it(self):
        self.study("small")
        self.made("small")
        text, data = (self.pages / "small.md").read_text(), json.loads((self.out / "small/comparison.json").read_text())
        self.assertEqual([row.split("|")[1].strip() for row in self.rows("small.md")[2:]], ["base", "damped", "stiff"])
        program = subprocess.run([WYTHE, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(program.split("(")[1].split(",")[0], text)  # the commit
        self.assertIn(f"{data['samples']} samples", text)
        self.assertIn("`tools/evidence small`", text)
        self.assertRegex(text, r"\d{4}-\d\d-\d\d\. To make")

    def test_studies_of_several_walls_share_a_page(self):
        for wall in ("low", "high"):
            self.study(f"shared.{wall}", STUDY.replace('name = "small"', f'name = "{wall}: a question"') + OPTIONS)
        self.made("shared")
        text = (self.pages / "shared.md").read_text()
        self.assertTrue(text.startswith("# A question\n"))
        self.assertLess(text.index("## High"), text.index("## Low"))
        self.assertEqual([row.split("|")[1].strip() for row in self.rows("shared.md")],
                         ["wall", "---", "base", "damped", "stiff"] * 2)
        self.assertTrue((self.out / "shared/high/base/campaign.db").exists())

    def test_a_page_keeps_what_people_wrote_and_goes_on_with_what_has_run(self):
        self.study("small")
        self.made("small")
        page, store = self.pages / "small.md", self.out / "small/base/campaign.db"
        words = "<!-- kept -->\nby hand\n<!-- end of kept -->"
        page.write_text(page.read_text().replace("<!-- kept -->\n<!-- end of kept -->", words))
        self.assertIn(words, page.read_text())
        for more in ([], ["--pages-only"]):
            self.made("small", *more)
            self.assertIn(words, page.read_text())
        self.made("small", "--again", "--samples", "2")
        self.assertTrue(store.exists())
        self.assertIn("2 samples", page.read_text())
        page.write_text("# by hand, without marks\n")
        self.assertIn("not written", self.evidence("small", "--pages-only").stderr)

    def test_a_study_that_fails_leaves_the_others_their_pages(self):
        self.study("bad", STUDY + '\n[[variant]]\nname = "none"\nset = ["wall.lenght=2 m"]\n')
        self.study("good")
        done = self.evidence("bad", "good")
        self.assertEqual(done.returncode, 1)
        self.assertIn("bad: no page", done.stderr)
        self.assertFalse((self.pages / "bad.md").exists())
        self.assertTrue((self.pages / "good.md").exists())
        done = self.evidence("absent")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no evidence of the name absent", done.stderr)

    def test_a_campaign_of_another_study_is_not_taken_for_this_one(self):
        self.study("small")
        self.made("small")
        before = (self.pages / "small.md").read_text()
        self.study("small", (STUDY + OPTIONS).replace("damping=0.4", "damping=0.3"))
        self.assertEqual(self.evidence("small").returncode, 1)
        self.assertEqual((self.pages / "small.md").read_text(), before)
        self.made("small", "--again")

    # --- the paper's campaign

    def test_the_paper_is_compared_number_by_number(self):
        self.made("reproduction", "--samples", "8", "--set", "stage.push.until=0.3 mm")
        rows = [row for row in self.rows("reproduction.md") if row.rstrip(" |").endswith(("inside", "**outside**", "too few samples"))]
        self.assertEqual(len(rows), 45)
        self.assertIn("Of 45 numbers compared", (self.pages / "reproduction.md").read_text())
        # statistics.json once more, from samples.csv alone
        data = json.loads((self.out / "reproduction/statistics.json").read_text())
        with open(self.out / "reproduction/samples.csv", encoding="utf-8") as file:
            peaks = [float(row["peak_reaction_kN"]) for row in csv.DictReader(file) if row["peak_reaction_kN"]]
        told = data["table"]["all"]["peak_reaction_kN"]
        self.assertAlmostEqual(told["mean"], statistics.mean(peaks), places=5)
        self.assertAlmostEqual(told["cov"], statistics.stdev(peaks) / statistics.mean(peaks), places=7)
        self.assertIn(f"| {told['mean']:.1f} (", "".join(rows))

    def test_a_difference_is_judged_by_both_intervals(self):
        tool = module(TOOL)
        low, high = tool.difference(150, (147, 154), 160, (157, 165))
        self.assertAlmostEqual(low, -10 - math.hypot(3, 5))
        self.assertAlmostEqual(high, -10 + math.hypot(4, 3))
        rows = tool.Comparison()
        self.assertEqual(rows.row("F", "all", 9, 160, (157, 165), 150, (147, 154), 1)[-1], "**outside**")
        self.assertEqual(rows.row("F", "all", 9, 152, (147, 157), 150, (147, 154), 1)[-1], "inside")
        self.assertEqual(rows.row("F", "FM-2", 1, 152, (147, 157), 150, (None, None), 1)[-1], "too few samples")
        low, high = tool.wilson(0, 100)
        self.assertAlmostEqual(low, 0)
        self.assertAlmostEqual(high, tool.Z**2 / (100 + tool.Z**2))  # its closed form

    def test_what_the_paper_printed_agrees_with_itself(self):
        paper = module(TOOL).read_paper()
        modes = [paper[f"FM-{k}"] for k in range(1, 6)]
        self.assertAlmostEqual(sum(m["n"] for m in modes), 251)  # each the middle of its own range
        for what in ("F", "D"):
            mean = sum(m["n"] * m[f"{what}_mean"] for m in modes) / sum(m["n"] for m in modes)
            self.assertAlmostEqual(mean, paper["all"][f"{what}_mean"], delta=0.2)


if __name__ == "__main__":
    unittest.main()
