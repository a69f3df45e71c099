#!/usr/bin/env python3
"""Short console output: notes of one kind in one line with a table, modes of many elements in
one line, and no WARNING beside a usable push."""
import json
import pathlib
import re
import unittest
import zlib

from cli_test import SOURCE, Base, wythe

JOINT = """[material.joint]
normal_stiffness = "4 GPa/m"
shear_stiffness = "1.6 GPa/m"
tensile_strength = "0.02 MPa"
cohesion = "0.03 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4 N/m"
mode_2_energy = "40 N/m"
compressive_strength = "unlimited"
[material.timber]
density = "500 kg/m^3"
youngs_modulus = "10 GPa"
shear_modulus = "0.6 GPa"
"""


def wall(storeys, in_a_row, lintels=True):
    """Windows whose sizes all have to be fitted to courses of 200 mm."""
    text = (f'[wall]\nlength = "{0.8 + 1.6 * in_a_row:.1f} m"\nheight = "{2.4 * storeys:.1f} m"\nthickness = "0.3 m"\nfit = "cut"\n'
            '[wall.unit]\nlength = "400 mm"\nheight = "200 mm"\nsplit = "none"\ndensity = "1800 kg/m^3"\n')
    for storey in range(storeys):
        for i in range(in_a_row):
            text += (f'[[wall.opening]]\nname = "w{storey}{i}"\nx = "{0.83 + 1.6 * i:.2f} m"\ny = "{2.4 * storey + 0.63:.2f} m"\n'
                     'width = "0.75 m"\nheight = "1.17 m"\n')
            if lintels:
                text += 'lintel = { kind = "timber", depth = "170 mm", bearing = "190 mm", material = "timber" }\n'
    return text + JOINT + ('[[stage]]\nname = "gravity"\n[[stage]]\nname = "push"\n'
                           f'at = {{ x = "0 m", y = "{2.4 * storeys - 0.1:.1f} m" }}\n'
                           'velocity = "20 mm/s"\ndamping = 0.2\nuntil = "8 mm"\n')


class FewWords(Base):
    def write(self, text):
        path = pathlib.Path(self.temporary.name) / "model.toml"
        path.write_text(text)
        return path

    def notes(self, command, text, *more):
        done = wythe(command, self.write(text), *more)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return [line for line in done.stdout.splitlines() if line.startswith("note: ")], done.stdout

    def test_forty_fitted_sizes_are_two_lines_and_a_table(self):
        notes, said = self.notes("check", wall(2, 5))
        fitted = [note for note in notes if "opening" in note]
        self.assertEqual(len(fitted), 2, said)
        self.assertIn("20 sizes of openings were fitted to units and courses, by 30 mm at most", fitted[0])
        self.assertIn("20 sizes of lintels were fitted", fitted[1])
        # a row an opening
        self.assertIn("\n  opening 9 (w14) y 3.03 m -> 3 m, height 1.17 m -> 1.2 m\n", said)
        self.assertLess(len(notes), 8, said)

    def test_a_run_has_the_lines_without_the_table(self):
        notes, said = self.notes("run", wall(2, 5), "--out", self.out, "--set", "stage.push.until=0.1 mm")
        self.assertIn("20 sizes of openings", said)
        self.assertNotIn("\n  opening 9", said)
        page = zlib.decompress((self.out / "report.data").read_bytes()).decode(errors="replace")  # src/report/bundle.cpp
        self.assertIn("20 sizes of openings were fitted", page)
        self.assertIn("20 misure di aperture sono state adattate", page)

    def test_three_of_a_kind_stay_as_they_are(self):
        notes, said = self.notes("check", wall(1, 1))
        self.assertIn("note: opening 0 (w00) height 1.17 m -> 1.2 m", notes, said)

    def test_other_notes_of_one_kind_are_counted_too(self):
        notes, said = self.notes("check", wall(2, 5, lintels=False))
        bare = [note for note in notes if "has no lintel" in note]
        self.assertEqual(len(bare), 1, said)
        self.assertIn("and 9 more of this kind", bare[0])
        self.assertIn("\n  opening 9 (w14)", said)

    def test_modes_of_many_elements_are_one_short_line(self):
        done = wythe("run", self.write(wall(1, 5)), "--out", self.out, "--quiet")
        line = next(line for line in done.stdout.splitlines() if line.startswith("failure mode "))
        self.assertRegex(line, r"\d+ elements: .*flexural crack \d+")
        self.assertLess(len(line), 160)
        # the file keeps each element
        sentence = json.loads((self.out / "summary.json").read_text())["failure_mode"]["sentence"]
        self.assertRegex(sentence, r"pier 6: (rocking, )?flexural crack")


class Usable(Base):
    def readme(self):
        text = (SOURCE / "README.md").read_text()
        return re.search(r"<!-- test: file dry.toml -->\n```toml\n(.*?)```", text, re.S).group(1)

    def ran(self, text, *more):
        path = pathlib.Path(self.temporary.name) / "dry.toml"
        path.write_text(text)
        done = wythe("run", path, "--out", self.out, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.out / "summary.json").read_text()), done.stdout

    def test_the_readmes_first_run_has_no_warning(self):
        summary, said = self.ran(self.readme())
        self.assertNotIn("WARNING", said)
        self.assertEqual(summary["warning"], "")
        self.assertIn("rate: usable", said)
        self.assertIn("rate, for the displacement: not known; for the failure mode: not known", said)

    def test_usable_pushes_have_a_verdict_and_no_warning(self):
        for velocity in ("2 mm/s", "5 mm/s", "12 mm/s"):
            summary, said = self.ran(self.readme(), "--set", f"stage.push.velocity={velocity}", "--set", "stage.push.until=2 mm")
            judgement = summary["quasi_static"]["judgement"]
            self.assertEqual("WARNING" in said, judgement not in ("usable", "slow enough"), said)
            self.assertNotIn("WARNING usable", said)

    def test_a_campaign_of_usable_pushes_has_a_note_and_no_warning(self):
        (pathlib.Path(self.temporary.name) / "dry.toml").write_text(self.readme())
        study = pathlib.Path(self.temporary.name) / "study.toml"
        study.write_text("""[study]
model = "dry.toml"
samples = 2
seed = 1
set = ["stage.push.velocity=VELOCITY", "stage.push.until=1 mm"]
[variable.thickness]
path = "wall.thickness"
distribution = "uniform"
low = "200 mm"
high = "220 mm"
""")
        text = study.read_text()
        for velocity, warns in (("2 mm/s", False), ("100 mm/s", True)):
            study.write_text(text.replace("VELOCITY", velocity))
            out = pathlib.Path(self.temporary.name) / f"campaign {velocity[:3]}"
            done = wythe("campaign", study, "--out", out, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("WARNING" in done.stdout, warns, done.stdout)
            self.assertEqual('note: 2 of 2 pushes are "usable"' in done.stdout, not warns, done.stdout)

    def test_too_fast_still_warns_first(self):
        _, said = self.ran(self.readme(), "--set", "stage.push.velocity=10 mm/s", "--set", "stage.push.damping=0.2")
        self.assertRegex(said, r"(?m)^WARNING too fast")


if __name__ == "__main__":
    unittest.main()
