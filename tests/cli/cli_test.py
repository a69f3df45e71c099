#!/usr/bin/env python3
"""The command line: files, columns, exit codes, messages, faults, interrupts."""
import csv
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import unittest

WYTHE = os.environ.get("WYTHE", "build/release/wythe")
SOURCE = pathlib.Path(os.environ.get("SOURCE", "."))
TUFF = SOURCE / "examples/tuff_wall/model.toml"

SMALL = """
[wall]
length = "0.8 m"
height = "0.8 m"
thickness = "0.2 m"
bond = "running"
[wall.unit]
length = "200 mm"
height = "100 mm"
density = "2000 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[material.unit]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.5 MPa"
cohesion = "0.75 MPa"
friction_angle = "38 deg"
residual_friction_angle = "38 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "20 N/m"
mode_2_energy = "550 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
[[stage]]
name = "precompression"
pier_load = "20 kN"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.75 m" }
direction = "+x"
velocity = "2 mm/s"
until = "3 mm"
"""

CURVE = ["time_s", "displacement_mm", "drift_percent", "reaction_kN", "base_shear_kN", "unbalance_ratio",
         "kinetic_ratio", "work_drive_J", "work_damping_J",
         "load_factor"]
CONTACT = ["opening_mm", "slip_mm", "normal_stress_MPa", "shear_stress_MPa", "damage_tension",
           "damage_shear", "damage", "crushing", "dissipated_N_per_m"]


def wythe(*arguments, **options):
    return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


class Held:
    """The program, waiting at a named point (CONTRIBUTING.md): it is there, however fast the machine is."""

    def __init__(self, point, *arguments):
        self.process = subprocess.Popen([WYTHE, *map(str, arguments)], text=True, stdin=subprocess.PIPE,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                        env=os.environ | {"WYTHE_TEST_HOLD": point},
                                        # a shell that starts the tests in the background lets its children ignore it
                                        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        said = []
        for line in self.process.stderr:
            said.append(line)
            if line == f"held at {point}\n":
                return
        raise AssertionError(f"never came to {point}:\n{''.join(said)}")

    def go_on(self):
        """Lets it end; what it says from there on stderr."""
        with self.process:
            return self.process.communicate(timeout=300)[1]

    def interrupt(self, how=signal.SIGINT):
        self.process.send_signal(how)
        said = self.process.stderr.read()  # standard input stays open: the signal alone may end the wait
        self.go_on()
        return said

    def kill(self):
        self.process.kill()
        self.go_on()


class Base(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.out = self.folder / "out"

    def tearDown(self):
        self.temporary.cleanup()

    def model(self, text=SMALL, name="model.toml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def refused(self, text, *words, code=2):
        done = wythe("run", self.model(text), "--out", self.out)
        self.assertEqual(done.returncode, code, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out.exists() and any(self.out.iterdir()), "nothing may be written")


class Run(Base):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.shared.name)
        (folder / "model.toml").write_text(SMALL)
        cls.done = wythe("run", folder / "model.toml", "--out", folder / "out", "--quiet")
        cls.result = folder / "out"
        cls.summary = json.loads((cls.result / "summary.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def test_exits_with_0_and_prints_the_peak(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertIn("peak", self.done.stdout)

    def test_writes_the_contract_files(self):
        names = {p.name for p in self.result.iterdir()}
        for name in ("force_displacement.csv", "summary.json", "run.pvd", "report.html", "report.data", "model.used.toml"):
            self.assertIn(name, names)
        self.assertTrue(any(re.match(r"state_.*\.vtu", n) for n in names))

    def test_report_makes_the_page_again_in_either_language(self):
        page = self.result / "report.html"
        first = page.read_bytes()
        page.unlink()
        done = wythe("report", self.result)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(page.read_bytes(), first)
        self.assertIn(b'<html lang="en"', first)
        self.assertEqual(wythe("report", self.result, "--lang", "it").returncode, 0)
        self.assertIn('La parete resiste a', page.read_text())
        page.write_bytes(first)
        refused = wythe("report", self.result, "--lang", "xx")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("en, it", refused.stderr)
        nowhere = wythe("report", self.result.parent / "nowhere")
        self.assertEqual(nowhere.returncode, 2)
        self.assertIn("report.data", nowhere.stderr)

    def test_whether_the_threshold_decides_is_not_said_where_it_was_not_seen(self):
        capacity = self.summary["drift_capacity"]
        bound = dict(zip(capacity["left"], capacity["censored"]))
        self.assertTrue(bound[0.75], "this push is meant to end before that fall")
        self.assertIsNone(capacity["threshold_decides"])

    def test_cores_are_counted_as_in_python(self):
        model, out = self.result.parent / "model.toml", self.result.parent / "cores"
        for options in (("--threads", "1025"), ("--threads", "-1"), ("--walls", "2", "--jobs", "1025"), ("--walls", "2", "--jobs", "x")):
            done = wythe("run", model, "--out", out, "--set", "scatter.use=clay_brick", *options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("1024", done.stderr)
            self.assertFalse(out.exists())
        short = ("--set", "stage.push.until=0.02 mm", "--quiet")
        hashes = set()
        for threads in ("0", "1", "2"):
            done = wythe("run", model, "--out", out, "--threads", threads, *short)
            self.assertEqual(done.returncode, 0, done.stderr)
            hashes.add(json.loads((out / "summary.json").read_text())["state_hash"])
        self.assertEqual(len(hashes), 1)
        done = wythe("run", model, "--out", self.result.parent / "jobs", "--walls", "2", "--jobs", "0", "--set", "scatter.use=clay_brick", *short)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_push_without_a_stiffness_says_why(self):
        model, out = self.result.parent / "model.toml", self.result.parent / "fast"
        done = wythe("run", model, "--out", out, "--set", "stage.push.velocity=100 mm/s", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual(summary["initial_stiffness_kN_per_mm"] is None and summary["peak_reaction_kN"] is not None,
                         summary["initial_stiffness_reason"] != "")
        if summary["initial_stiffness_reason"]:
            self.assertIn(summary["initial_stiffness_reason"], done.stdout)

    def test_several_walls_refuse_what_is_for_one_wall_or_for_a_study(self):
        model, out = self.result.parent / "model.toml", self.result.parent / "walls"
        for more, word in ((("--threads", "2"), "--jobs"), (("--set", "study.samples=3"), "study.samples=3")):
            done = wythe("run", model, "--out", out, "--walls", "2", "--set", "scatter.use=clay_brick", *more)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(word, done.stderr)
            self.assertFalse(out.exists())

    def test_curve_has_the_contract_columns_and_500_rows(self):
        with open(self.result / "force_displacement.csv") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], CURVE)
        self.assertGreaterEqual(len(rows) - 1, 500)
        first, last = [float(x) for x in rows[1]], [float(x) for x in rows[-1]]
        self.assertEqual(first[1], 0.0)
        self.assertAlmostEqual(last[1], 3.0, delta=0.02)
        peak = max(float(r[3]) for r in rows[1:])
        self.assertAlmostEqual(peak, self.summary["peak_raw_kN"], places=6)
        self.assertLessEqual(self.summary["peak_reaction_kN"], self.summary["peak_raw_kN"])

    def test_drift_is_displacement_over_the_load_height(self):
        with open(self.result / "force_displacement.csv") as file:
            row = list(csv.DictReader(file))[-1]
        self.assertAlmostEqual(float(row["drift_percent"]), float(row["displacement_mm"]) / 750 * 100, places=4)

    def test_summary_has_the_contract_keys(self):
        for key in ("status", "peak_reaction_kN", "displacement_at_peak_mm", "displacement_at_80_percent_mm",
                    "displacement_max_mm", "initial_stiffness_kN_per_mm", "failure_mode", "energy_J",
                    "quasi_static", "blocks", "joints", "points", "steps", "time_step_s", "wall_seconds",
                    "state_hash", "provenance"):
            self.assertIn(key, self.summary)
        self.assertLess(self.summary["energy_J"]["gap_ratio"], 1e-3)

    def test_used_model_runs_to_the_same_bits(self):
        again = self.out
        done = wythe("run", self.result / "model.used.toml", "--out", again, "--quiet", "--threads", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        other = json.loads((again / "summary.json").read_text())
        self.assertEqual(other["state_hash"], self.summary["state_hash"])


class Couplet(Base):
    def test_what_moves_without_masonry_collapses_and_its_used_model_is_read(self):
        (self.folder / "couplet.json").write_text(
            """{"units": "mm", "thickness": 120, "blocks": [{"id": "low", "polygon": [[0, -60], [250, -60], [250, 0], [0, 0]], "fixed": true},
            {"id": "up", "polygon": [[0, 0], [250, 0], [250, 60], [0, 60]], "beam": true}]}""")
        model = self.folder / "couplet.toml"
        model.write_text("""[wall]
blocks = "couplet.json"
[wall.unit]
density = "1800 kg/m^3"
[material.joint]
use = "limestone_dry"
missing = "rule"
normal_stiffness = "80 GPa/m"
shear_stiffness = "35 GPa/m"
compressive_strength = "unlimited"
[[stage]]
name = "load"
beam_load = "3 kN"
[[stage]]
name = "push"
at = { beam = true }
until = "0.5 mm"
""")
        for contacts, collapse in ("joints", '"60 mm"'), ("free", '"unlimited"'):
            out, again = self.folder / contacts, self.folder / f"{contacts}_again"
            done = wythe("run", model, "--out", out, "--quiet", "--set", f"solve.contacts={contacts}")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"collapse_displacement = {collapse}", (out / "model.used.toml").read_text())
            done = wythe("run", out / "model.used.toml", "--out", again, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            first, second = (json.loads((at / "summary.json").read_text())["state_hash"] for at in (out, again))
            self.assertEqual(first, second)


class BadInput(Base):
    def test_missing_file_names_it(self):
        none, path = self.folder / "none.toml", self.folder / "none.csv"
        for command in (["run", none, "--out", self.out], ["check", none], ["limit", none, "--out", self.out],
                        ["campaign", none, "--out", self.out],
                        ["contact", none, "--path", path, "--out", self.out],
                        ["contact", self.model(), "--path", path, "--out", self.out]):
            done = wythe(*command)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"none\.(toml|csv): there is no such file; (name a file|did you mean)")
            self.assertFalse(self.out.exists())

    def test_not_toml_names_the_line(self):
        self.refused("[wall\nlength = 3", "model.toml")

    def test_unknown_key_gets_the_nearest(self):
        self.refused(SMALL.replace("thickness =", "thicknes ="), "wall.thicknes", "thickness")

    def test_wrong_unit_names_both(self):
        self.refused(SMALL.replace('thickness = "0.2 m"', 'thickness = "0.2 kN"'), "wall.thickness", "0.2 kN")

    def test_bare_number_gets_the_cure(self):
        self.refused(SMALL.replace('thickness = "0.2 m"', "thickness = 0.2"), "wall.thickness", "unit")

    def test_negative_value(self):
        self.refused(SMALL.replace('thickness = "0.2 m"', 'thickness = "-0.2 m"'), "wall.thickness", "-0.2")

    def test_nan_value(self):
        self.refused(SMALL.replace('thickness = "0.2 m"', 'thickness = "nan m"'), "wall.thickness")

    def test_missing_physical_parameter_has_no_default(self):
        self.refused(SMALL.replace('cohesion = "0.15 MPa"\nfriction', "friction"), "material.joint.cohesion")

    def test_all_faults_at_once(self):
        text = SMALL.replace('thickness = "0.2 m"', "thickness = 0.2").replace("until =", "untill =")
        self.refused(text, "wall.thickness", "untill", "until")

    def test_opening_outside_the_wall(self):
        opening = '[[wall.opening]]\nx = "0.6 m"\ny = "0 m"\nwidth = "0.6 m"\nheight = "0.4 m"\n'
        self.refused(SMALL + opening, "wall.opening.0")

    def test_lintel_shorter_than_the_opening(self):
        opening = ('[[wall.opening]]\nx = "0.3 m"\ny = "0 m"\nwidth = "0.2 m"\nheight = "0.4 m"\n'
                   'lintel = { kind = "timber", depth = "100 mm", bearing = "-50 mm", material = "timber" }\n'
                   '[material.timber]\ndensity = "500 kg/m^3"\nyoungs_modulus = "1 GPa"\nshear_modulus = "0.4 GPa"\n')
        self.refused(SMALL + opening, "bearing")

    def test_snap_back_names_the_numbers(self):
        self.refused(SMALL.replace('mode_1_energy = "4.3 N/m"', 'mode_1_energy = "0.1 N/m"'),
                     "material.joint.mode_1_energy", "snap-back")

    def test_overlapping_blocks_in_a_file(self):
        self.blocks([[[0, 0], [1, 0], [1, 0.5], [0, 0.5]], [[0.5, 0.2], [1.5, 0.2], [1.5, 0.7], [0.5, 0.7]]],
                    "overlap")

    def test_floating_block_has_no_support(self):
        self.blocks([[[0, 0], [1, 0], [1, 0.5], [0, 0.5]], [[0, 2], [1, 2], [1, 2.5], [0, 2.5]]],
                    "support")

    def blocks(self, polygons, word):
        blocks = [{"id": f"b{i}", "polygon": p} for i, p in enumerate(polygons)]
        (self.folder / "blocks.json").write_text(json.dumps({"units": "m", "blocks": blocks}))
        text = re.sub(r'\[wall\].*?\[material.joint\]',
                      '[wall]\nblocks = "blocks.json"\nthickness = "0.2 m"\n[wall.unit]\n'
                      'density = "2000 kg/m^3"\n[material.joint]', SMALL, count=1, flags=re.S)
        self.refused(text, word)

    def test_unwritable_folder(self):
        file = self.folder / "file"
        file.write_text("in the way")
        done = wythe("run", self.model(), "--out", file / "out")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("out", done.stderr)

    def test_full_disk_is_noticed_before_the_run(self):
        self.out.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", str(self.out)], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("may not mount a small disk here")
        try:
            done = wythe("run", self.model(), "--out", self.out)
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn("space", done.stderr)
        finally:
            subprocess.run(["umount", str(self.out)], check=True)

    def test_override_of_an_unknown_path(self):
        done = wythe("check", self.model(), "--set", "stage.push.velocty=1 mm/s")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--set", done.stderr)
        self.assertIn("velocity", done.stderr)


class RandomFields(Base):
    """examples/random_field: its commands, and the wall that a stored sample had."""

    def test_a_sample_is_replayed_and_run_from_its_used_model(self):
        example = SOURCE / "examples/random_field"
        done = wythe("campaign", example / "study.toml", "--out", self.out, "--set", "study.samples=3")
        self.assertEqual(done.returncode, 0, done.stderr)
        alone = self.folder / "alone"
        done = wythe("replay", self.out, "--sample", "3", "--out", alone)
        self.assertIn("equals that of the campaign, bit for bit", done.stdout + done.stderr)
        used = (alone / "model.used.toml").read_text()
        self.assertRegex(used, r"seed = [1-9]\d+")
        self.assertEqual(wythe("run", alone / "model.used.toml", "--out", self.folder / "again").returncode, 0)
        hashes = {json.loads((self.folder / run / "summary.json").read_text())["state_hash"] for run in ("alone", "again")}
        self.assertEqual(len(hashes), 1)


class Signals(Base):
    """SIGTERM as Ctrl-C: what was computed is kept, and nothing makes the program deaf."""

    def test_reading_and_building_end_with_the_signal(self):
        model = self.model()
        study = SOURCE / "examples/tuff_wall/study.toml"
        for command in (["run", model, "--out", self.out], ["check", model], ["limit", model, "--out", self.out],
                        ["campaign", study, "--out", self.out]):
            for how in (signal.SIGINT, signal.SIGTERM):
                held = Held("model read", *command)
                held.interrupt(how)
                self.assertEqual(held.process.returncode, -how, command)


class Guards(Base):
    def checked(self, *settings):
        return wythe("check", self.model(), *[word for setting in settings for word in ("--set", setting)])

    def test_a_wall_too_large_is_refused_before_it_is_built(self):
        done = self.checked("wall.length=100 m", "wall.height=20 m", "wall.unit.length=10 mm", "wall.unit.height=5 mm")
        self.assertEqual(done.returncode, 2, done.stdout)
        for word in ("model.toml:", "wall.unit = 80 million blocks", "of memory", "of computing", "larger units"):
            self.assertIn(word, done.stderr)

    def test_a_window_of_no_width_is_refused_with_the_least(self):
        done = self.checked("output.window=2e-6 mm")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("--set: output.window", done.stderr)
        least = re.search(r'write window = "([^"]+)"', done.stderr).group(1)
        self.assertEqual(self.checked(f"output.window={least}").returncode, 0)

    def test_forecasts_are_finite(self):
        done = self.checked("stage.push.velocity=0.00001 mm/s")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"about \d{4,18} steps, \d+ (s|min|h|days) on one core")
        self.assertEqual(self.checked("stage.push.velocity=1e-300 m/s").returncode, 2)

    def test_geometry_faults_have_file_line_and_opening(self):
        opening = ('[[wall.opening]]\nname = "door"\nx = "0.33 m"\ny = "0 m"\nwidth = "0.2 m"\nheight = "0.4 m"\n')
        done = wythe("check", self.model(SMALL + opening))
        self.assertEqual(done.returncode, 2)
        line = (SMALL + opening).split("\n").index('x = "0.33 m"') + 1
        self.assertIn(f"model.toml:{line}: wall.opening.0.x", done.stderr)
        self.assertIn("opening 0 (door)", done.stderr)

    def test_names_cannot_drive_the_terminal(self):
        done = wythe("check", self.model(SMALL.replace('bond = "running"', 'bond = "\\u001b[31m' + "x" * 5000 + '"')))
        self.assertEqual(done.returncode, 2)
        self.assertNotIn("\x1b", done.stderr)
        self.assertIn("\\x1b[31m", done.stderr)
        self.assertLess(len(done.stderr), 1000)

    def test_an_overloaded_wall_is_told_so(self):
        done = wythe("run", self.model(), "--out", self.out, "--quiet", "--set", "stage.precompression.pier_load=1e5 kN")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("can't carry its load", done.stdout)
        self.assertNotIn("step_fraction", done.stdout)


class Behaviour(Base):
    def test_override_changes_the_run(self):
        done = wythe("run", self.model(), "--out", self.out, "--quiet", "--set", "stage.push.until=1 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('until = "1 mm"', (self.out / "model.used.toml").read_text())

    def test_check_prints_counts_step_and_time(self):
        done = wythe("check", TUFF)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("blocks 812", "joints", "time step", "825 masonry blocks"):
            self.assertIn(word, done.stdout)

    def test_step_beyond_the_stable_one_is_refused(self):
        done = wythe("run", self.model(), "--out", self.out, "--quiet", "--set", "solve.step_fraction=1.01")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("solve.step_fraction", done.stderr)

    def test_interrupt_writes_the_curve_so_far(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            run = Held("stage push", "run", self.model(), "--out", self.out, "--quiet")
            run.interrupt(how)
            self.assertEqual(run.process.returncode, 3)
            summary = json.loads((self.out / "summary.json").read_text())
            self.assertEqual(summary["status"], "interrupted")
            self.assertIn('stopped by the user in stage "push"', summary["reason"])
            with open(self.out / "force_displacement.csv") as file:
                rows = list(csv.DictReader(file))
            self.assertGreater(len(rows), 0)
            self.assertLess(float(rows[-1]["displacement_mm"]), 3)

    DIFFERENT = ("summary.json", "force_displacement.csv", "model.used.toml", "report.html", "report.data")

    def test_a_killed_run_leaves_the_earlier_one_or_is_brought_to_its_end(self):
        self.assertEqual(wythe("run", self.model(), "--out", self.out, "--quiet").returncode, 0)
        old = {p.name: p.read_bytes() for p in self.out.iterdir() if not p.name.startswith(".")}
        again = ("run", self.model(), "--out", self.out, "--quiet", "--set")
        for point in ("stage push", "results written"):
            Held(point, *again, "stage.push.until=1 mm").kill()
            self.assertEqual({p.name: p.read_bytes() for p in self.out.iterdir() if not p.name.startswith(".")}, old, point)
        for mm, point in enumerate(("results ready", "results removed", "results moving"), 1):
            Held(point, *again, f"stage.push.until={mm} mm").kill()
            left = {p.name: p.read_bytes() for p in self.out.iterdir() if not p.name.startswith(".")}
            same = {old[name] == text for name, text in left.items() if name in self.DIFFERENT}
            self.assertLessEqual(len(same), 1, f"{point}: of two runs: {sorted(left)}")
            done = wythe("report", self.out)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = {p.name for p in self.out.iterdir()}
            self.assertEqual([n for n in names if n.startswith(".")], [".wythe_model"])
            self.assertEqual({"summary.json", "report.html", "report.data"} - names, set())
            self.assertIn(f'until = "{mm} mm"', (self.out / "model.used.toml").read_text())
            old = {p.name: p.read_bytes() for p in self.out.iterdir() if not p.name.startswith(".")}

    def test_a_failed_run_leaves_the_earlier_one_whole(self):
        self.assertEqual(wythe("run", self.model(), "--out", self.out, "--quiet").returncode, 0)
        old = {p.name: p.read_bytes() for p in self.out.iterdir()}

        def small_files():  # the summary fits, the page does not
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, resource.RLIM_INFINITY))

        done = wythe("run", self.model(), "--out", self.out, "--quiet", "--set", "stage.push.until=1 mm",
                     preexec_fn=small_files)
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertEqual({p.name: p.read_bytes() for p in self.out.iterdir()}, old)

    def test_a_run_replaces_a_run_and_nothing_else(self):
        model = self.model()
        for _ in range(2):
            self.assertEqual(wythe("run", model, "--out", self.out, "--quiet", "--set", "stage.push.until=1 mm").returncode, 0)
        done = wythe("run", model, "--out", self.folder, "--quiet")  # where the model itself lies
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("holds model.toml and 1 more, which no run wrote", done.stderr)
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"model.toml", "out"})
        held = Held("stage push", "run", model, "--out", self.out, "--quiet")
        done = wythe("run", model, "--out", self.out, "--quiet")
        held.go_on()
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("another wythe is writing its results there", done.stderr)

    def test_a_hold_changes_nothing(self):
        held = Held("stage precompression", "run", self.model(), "--out", self.out, "--quiet")
        held.go_on()
        self.assertEqual(held.process.returncode, 0)
        free = self.folder / "free"
        self.assertEqual(wythe("run", self.model(), "--out", free, "--quiet").returncode, 0)
        self.assertEqual((self.out / "force_displacement.csv").read_bytes(), (free / "force_displacement.csv").read_bytes())

    def test_standing_column_that_cannot_stand_collapses(self):
        blocks = [{"id": "base", "polygon": [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]},
                  {"id": "ledge", "polygon": [[0.15, 0.2], [0.75, 0.2], [0.75, 0.4], [0.15, 0.4]]}]
        (self.folder / "blocks.json").write_text(json.dumps({"units": "m", "blocks": blocks}))
        text = re.sub(r'\[wall\].*?\[material.joint\]',
                      '[wall]\nblocks = "blocks.json"\nthickness = "0.2 m"\n[wall.unit]\n'
                      'density = "2000 kg/m^3"\n[material.joint]', SMALL, count=1, flags=re.S)
        text = text.replace('tensile_strength = "0.15 MPa"', 'tensile_strength = "0 MPa"')
        text = text[:text.index("[[stage]]")] + '[[stage]]\nname = "gravity"\n'
        done = wythe("run", self.model(text), "--out", self.out, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("collapsed", done.stdout)

    def test_hold_keeps_the_pushed_blocks_where_they_are(self):
        hold = '[[stage]]\nname = "hold"\nduration = "0.05 s"\n'
        done = wythe("run", self.model(SMALL + hold), "--out", self.out, "--quiet", "--set", "stage.push.until=1 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        top = json.loads((self.out / "summary.json").read_text())["top_displacement_mm"]
        self.assertGreater(top, 0.8)

    def test_idle_targets_and_a_second_factor_are_refused(self):
        done = wythe("check", self.model(), "--set", 'stage.push.targets=["0 mm"]')
        self.assertEqual(done.returncode, 2)
        factor = '[[stage]]\nname = "{}"\nkind = "body_force"\nrate = "0.1 1/s"\nfactor = 0.1\n'
        done = wythe("check", self.model(SMALL + factor.format("east") + factor.format("west")))
        self.assertEqual(done.returncode, 2)
        self.assertIn("one body_force or tilt", done.stderr)

    def test_cyclic_push_does_not_stop_on_unloading(self):
        done = wythe("run", self.model(), "--out", self.out, "--quiet", "--set",
                     'stage.push.targets=["0.5 mm", "-0.5 mm", "0 mm"]', "--set", "stage.push.stop_below=0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("status completed", done.stdout)
        with open(self.out / "force_displacement.csv") as file:
            rows = list(csv.DictReader(file))[1:]
        self.assertTrue(all(float(row["unbalance_ratio"]) > 0 for row in rows))

    def test_the_mode_is_read_where_it_is_said_whatever_is_written(self):
        said = set()
        for k, settings in enumerate(([], ["output.states=[]"], ["output.states=[\"0.1 mm\", \"41 mm\"]"],
                                      ["output.rows=30"], ["output.window=4 mm"])):
            out = self.folder / f"read_{k}"
            done = wythe("run", self.model(), "--out", out, "--quiet", "--set", "stage.push.until=44 mm",
                         "--set", "stage.push.velocity=200 mm/s",
                         *[word for setting in settings for word in ("--set", setting)])
            self.assertEqual(done.returncode, 0, done.stderr)
            said.add(next(line for line in done.stdout.splitlines() if line.startswith("failure mode ")))
            mode = json.loads((out / "summary.json").read_text())["failure_mode"]
            self.assertAlmostEqual(mode["read_at_mm"], 40, delta=0.05)
        self.assertEqual(len(said), 1, said)
        self.assertIn(", read at 40.0 mm: ", said.pop())

    def test_a_push_that_ended_before_says_where_the_mode_was_read(self):
        done = wythe("run", self.model(), "--out", self.folder / "short", "--quiet")
        self.assertIn("read at 3.00 mm, where the loading ended short of 40.0 mm", done.stdout)

    def test_a_wall_that_did_nothing_has_no_mode(self):
        opening = '[[wall.opening]]\nx = "0.3 m"\ny = "0 m"\nwidth = "0.2 m"\nheight = "0.4 m"\n'
        done = wythe("run", self.model(SMALL + opening), "--out", self.out, "--quiet", "--set",
                     "stage.push.until=0.02 mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads((self.out / "summary.json").read_text())["failure_mode"]["name"], "unclear")

    def test_version_and_help(self):
        self.assertRegex(wythe("--version").stdout, r"^wythe .*; (scalar|sse2|avx2|avx512), \d walls? side by side")
        for command in ("run", "check", "contact"):
            self.assertIn("example:", wythe(command, "--help").stdout)

    def test_an_instruction_set_that_is_not_there_is_an_input_error(self):
        for variable, value, cure in (("WYTHE_SIMD", "neon9", "scalar, sse2"), ("WYTHE_LANES", "3", "1, 2, 4 or 8")):
            done = wythe("--version", env=os.environ | {variable: value})
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(variable, done.stderr)
            self.assertIn(cure, done.stderr)

    def test_unknown_command_is_an_input_error(self):
        self.assertEqual(wythe("fly").returncode, 2)


class Contact(Base):
    LAW = SMALL[SMALL.index("[material.joint]"):SMALL.index("[material.unit]")]

    def drive(self, path, law=None):
        (self.folder / "law.toml").write_text(law or self.LAW)
        (self.folder / "path.csv").write_text(path)
        done = wythe("contact", self.folder / "law.toml", "--path", self.folder / "path.csv", "--out",
                     self.folder / "out.csv")
        return done

    def test_pulling_apart_dissipates_the_mode_1_energy(self):
        done = self.drive("opening_mm,slip_mm\n0,0\n0.02,0\n0.04,0\n0.2,0\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "out.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), CONTACT)
        self.assertAlmostEqual(float(rows[-1]["dissipated_N_per_m"]), 4.3, delta=0.0043)
        self.assertEqual(float(rows[-1]["damage"]), 1.0)

    def last_row(self):
        with open(self.folder / "out.csv") as file:
            return list(csv.DictReader(file))[-1]

    def test_the_mode_1_energy_does_not_grow_with_the_opening(self):
        for opening in ("1", "1e3", "1e6"):
            done = self.drive(f"opening_mm,slip_mm\n0,0\n{opening},0\n")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertAlmostEqual(float(self.last_row()["dissipated_N_per_m"]), 4.3, delta=0.0043)

    def test_rows_beyond_a_kilometre_are_refused_with_line_and_value(self):
        done = self.drive("opening_mm,slip_mm\n0,0\n0,1e308\n")
        self.assertEqual(done.returncode, 2, done.stderr)
        for word in ("path.csv:3", "slip_mm", "1e308", "kilometre"):
            self.assertIn(word, done.stderr)
        self.assertFalse((self.folder / "out.csv").exists())

    def test_missing_column_is_named(self):
        done = self.drive("opening_mm\n0\n")
        self.assertEqual(done.returncode, 2)
        self.assertIn("slip_mm", done.stderr)

    def test_a_device_is_no_place_for_results(self):
        (self.folder / "law.toml").write_text(self.LAW)
        (self.folder / "path.csv").write_text("opening_mm,slip_mm\n0,0\n")
        done = wythe("contact", self.folder / "law.toml", "--path", self.folder / "path.csv", "--out", "/dev/full")
        self.assertEqual(done.returncode, 2)
        self.assertIn("/dev/full: is a device", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=1)
