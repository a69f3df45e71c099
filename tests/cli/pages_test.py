#!/usr/bin/env python3
"""README and the first tutorial: their files and commands, and the numbers in them."""
import csv
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

WYTHE = os.environ.get("WYTHE", "build/release/wythe")
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
README = (SOURCE / "README.md").read_text(encoding="utf-8")
TUTORIAL = (SOURCE / "docs/tutorial/first_wall.md").read_text(encoding="utf-8")
PEAK = r"^peak (?:at least )?([\d.]+) kN"


def blocks(page, language=""):
    found = re.findall(r"^```(\w*)\n(.*?)^```$", page, re.S | re.M)
    return [text for word, text in found if word == language]


def one_line(text):
    return re.sub(r"\\\n\s*", "", text)


class Pages(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def put(self, name, text):
        (pathlib.Path(self.folder.name) / name).write_text(text, encoding="utf-8")

    def call(self, command):
        """Runs a command of a page, whatever it calls the program; returns what it printed."""
        words = shlex.split(command, comments=True)
        words = [str(pathlib.Path(WYTHE).resolve())] + words[1:]
        done = subprocess.run(words, cwd=self.folder.name, text=True, check=False, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}{done.stderr}")
        return done.stdout

    def near(self, found, stated, what):
        self.assertLess(abs(float(found) / float(stated) - 1), 0.01, f"{what}: {found}, the page says {stated}")

    def test_commands_of_the_readmes_model_work(self):
        self.put("dry.toml", blocks(README, "toml")[0])
        commands = re.findall(r"^build/release/wythe .*dry\.toml.*$", README, re.M)
        self.assertEqual(len(commands), 3)
        for command in commands:
            self.call(command)

    def test_first_wall_gives_the_numbers_of_the_tutorial(self):
        self.put("pier.toml", blocks(TUTORIAL, "toml")[0])
        said = self.call("wythe run pier.toml --out out --quiet")
        stated = next(b for b in blocks(TUTORIAL) if b.startswith("status completed"))
        self.near(re.search(PEAK, said, re.M).group(1), re.search(PEAK, stated, re.M).group(1), "peak")
        for words in ("failure mode rocking", "rate: slow enough"):
            self.assertIn(words, stated)
            self.assertIn(words, said)

    def test_changes_of_the_tutorial_give_its_peaks(self):
        self.put("pier.toml", blocks(TUTORIAL, "toml")[0])
        table = re.findall(r"^\| (`[^|]*) \| ([\d.]+|none|–) \|", TUTORIAL, re.M)
        self.assertEqual(len(table), 6)
        for cell, stated in table:
            settings = " ".join(f"--set {s}" for s in re.findall(r"`([^`]*)`", cell))
            command = f"wythe run pier.toml --out out --quiet {settings}"
            with self.subTest(settings):
                if stated == "–":
                    self.assertRaises(AssertionError, self.call, command)
                elif stated == "none":
                    self.assertIn("peak not known", self.call(command))
                else:
                    self.near(re.search(PEAK, self.call(command), re.M).group(1), stated, settings)

    def test_sliding_wall_and_single_joint_of_the_tutorial(self):
        self.put("pier.toml", blocks(TUTORIAL, "toml")[0])
        slide = one_line(next(b for b in blocks(TUTORIAL) if "out/slide" in b))
        stated = re.search(r"The result is ([\d.]+) kN", TUTORIAL).group(1)
        said = self.call(slide)
        self.near(re.search(PEAK, said, re.M).group(1), stated, "sliding")
        self.assertIn("failure mode sliding", said)

        self.put("path.csv", next(b for b in blocks(TUTORIAL) if b.startswith("opening_mm")))
        self.call(next(b for b in blocks(TUTORIAL) if "wythe contact" in b))
        with open(pathlib.Path(self.folder.name) / "answer.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.near(rows[1]["normal_stress_MPa"], re.search(r"carries ([\d.]+) MPa", TUTORIAL).group(1), "stress")
        self.near(rows[2]["dissipated_N_per_m"], re.search(r"dissipated ([\d.]+) N/m", TUTORIAL).group(1), "energy")
        self.near(rows[5]["shear_stress_MPa"], re.search(r"= ([\d.]+) MPa in both", TUTORIAL).group(1), "friction")


class Lists(unittest.TestCase):
    def test_every_page_of_docs_stands_in_a_list_of_the_site(self):
        # tools/site, which finds it too, runs where Sphinx is installed alone
        listed = [re.sub(r".*<(.*)>", r"\1", line.strip()).lstrip("/") for page in (SOURCE / "docs/site").glob("*.md")
                  for toctree in re.findall(r"^```{toctree}\n(.*?)^```", page.read_text(encoding="utf-8"), re.S | re.M)
                  for line in toctree.splitlines() if line.strip() and not line.startswith(":")]
        pages = [p.relative_to(SOURCE).with_suffix("") for p in (SOURCE / "docs").rglob("*.md") if p.parent.name != "site"]
        self.assertEqual([str(p) for p in pages if not any(p.match(name) for name in listed) and p.name != "README"], [])


if __name__ == "__main__":
    unittest.main()
