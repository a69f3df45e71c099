#!/usr/bin/python3
"""The Python package with Debian's interpreter: the module of the build folder, or the one
that pip installed if WYTHE_PYTHONPATH is empty."""
import ast
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(BUILD / "python"))

import numpy  # noqa: E402

import wythe  # noqa: E402

PIER = str(SOURCE / "examples/brick_pier/model.toml")
TUFF = str(SOURCE / "examples/tuff_wall/model.toml")
STUDY = str(SOURCE / "examples/tuff_wall/study.toml")
SHORT = {"stage.push.targets": ["0.3 mm"]}
COHESION = "material.joint.cohesion"
# a model of blocks that COMPAS, or save_compas, wrote
READ_BACK = """
[wall]
blocks = "wall.json"
blocks_unit = "m"
[wall.unit]
density = "2000 kg/m^3"
[material.joint]
use = "limestone_dry"
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
friction_tan = 0.7
residual_friction_tan = 0.7
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
"""


def python(code, *options, **environment):
    """The code in an interpreter of its own; (exit status, stdout, stderr)."""
    done = subprocess.run(["/usr/bin/python3", *options, "-c", code], capture_output=True, text=True, check=False,
                          env={**os.environ, "PYTHONPATH": str(BUILD / "python"), **environment})
    return done.returncode, done.stdout, done.stderr


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = wythe.run(TUFF, set={"stage.push.targets": ["3 mm"]}, progress=False)

    def test_it_is_the_run_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([BUILD / "wythe", "run", TUFF, "--out", f"{folder}/run", "--quiet", "--set",
                            'stage.push.targets=["3 mm"]'], check=True, capture_output=True)
            summary = json.loads(pathlib.Path(folder, "run/summary.json").read_text())
            again = wythe.run(TUFF, set={"stage.push.targets": ["3 mm"]}, out=f"{folder}/mine", progress=False)
            files = [sorted(p.name for p in pathlib.Path(folder, name).iterdir()) for name in ("run", "mine")]
            curves = [pathlib.Path(folder, name, "force_displacement.csv").read_bytes() for name in ("run", "mine")]
        self.assertEqual(self.result.summary["state_hash"], summary["state_hash"])
        self.assertEqual(again.summary["state_hash"], summary["state_hash"])
        self.assertEqual(self.result.summary.keys(), summary.keys())
        self.assertEqual(*files)
        self.assertEqual(*curves)

    def test_columns_are_views_that_outlive_the_result(self):
        force = wythe.run(PIER, set=SHORT, progress=False).curve["reaction_kN"]
        self.assertEqual(force.dtype, numpy.float64)
        self.assertFalse(force.flags.owndata)
        self.assertFalse(force.flags.writeable)
        first = force.copy()
        for _ in range(3):  # memory of jobs that ended is used again
            wythe.run(PIER, set=SHORT, progress=False)
        numpy.testing.assert_array_equal(force, first)
        with self.assertRaises(ValueError):
            force[0] = 1

    def test_curve_and_states(self):
        curve = self.result.curve
        self.assertEqual(curve.columns[:4], ("time_s", "displacement_mm", "drift_percent", "reaction_kN"))
        self.assertAlmostEqual(curve.displacement_mm[-1], 3, delta=0.01)
        self.assertAlmostEqual(numpy.nanmax(curve.reaction_kN), self.result.summary["peak_raw_kN"], delta=0.05)
        self.assertEqual(list(curve.frame().columns), list(curve.columns))
        last = self.result.states[-1]
        self.assertEqual(last.label, "end")
        self.assertEqual(last.blocks.rows, self.result.summary["blocks"] + 1)  # and the lintel
        self.assertGreater(last.joints.rows, self.result.summary["joints"])  # and the lintel's contacts
        self.assertEqual(len(self.result.block_ids), last.blocks.rows)
        top = last.blocks["y_m"].argmax()
        self.assertAlmostEqual(abs(last.blocks["displacement_x_mm"][top]), 3, delta=0.5)
        with self.assertRaisesRegex(AttributeError, "reaction_kN"):
            curve.reaction
        with self.assertRaisesRegex(KeyError, "reaction_kN"):
            curve["reaction"]

    def test_the_joints_of_the_foundation_carry_the_base_shear(self):
        joints = self.result.states[-1].joints
        ground = joints["block_a"] < 0
        self.assertAlmostEqual(joints["shear_kN"][ground].sum(), self.result.states[-1].reaction_kN, delta=4)
        self.assertGreater(joints["compression_kN"][ground].sum(), 200)

    def test_pictures(self):
        page = self.result._repr_html_()
        self.assertEqual(page.count("<svg"), 2)
        self.assertIn("capacity", page)
        self.assertIn("<!doctype html", self.result.page[:200].lower())
        axes = self.result.plot()
        self.assertEqual(axes.get_ylabel(), "reaction [kN]")

    def test_progress_reaches_a_function_and_its_exception_stops(self):
        seen = []
        wythe.run(PIER, progress=lambda *news: seen.append(news), set=SHORT)
        self.assertTrue(seen)
        self.assertEqual(sorted(share for _, share, _, _ in seen), [share for _, share, _, _ in seen])
        with self.assertRaises(ZeroDivisionError):
            wythe.run(TUFF, progress=lambda *news: 1 / 0)

    def test_ctrl_c_keeps_what_is_done(self):
        # the signal comes from the run's own progress: nothing here waits for a clock
        def press(*news):
            if news[1] > 0.02:
                os.kill(os.getpid(), signal.SIGINT)
        with self.assertRaises(wythe.Interrupted) as caught:
            wythe.run(TUFF, progress=press)
        self.assertEqual(caught.exception.result.status, "interrupted")
        self.assertIsInstance(caught.exception, KeyboardInterrupt)

    def test_runs_in_threads_at_once_give_the_same_bits(self):
        hashes = []
        threads = [threading.Thread(target=lambda: hashes.append(
            wythe.run(PIER, set=SHORT, progress=False).summary["state_hash"])) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(hashes), 4)
        self.assertEqual(len(set(hashes)), 1)


class Faults(unittest.TestCase):
    def refused(self, call, *words):
        with self.assertRaises(wythe.InputError) as caught:
            call()
        for word in words:
            self.assertIn(word, str(caught.exception))
        return caught.exception.faults

    def test_all_faults_at_once_with_place_and_cure(self):
        faults = self.refused(lambda: wythe.run(PIER, set={"wall.length": "-3 m", "wall.heigt": "2 m"}))
        self.assertEqual([fault.path for fault in faults], ["wall.length", "wall.heigt"])
        self.assertTrue(all(fault.cure for fault in faults))

    def test_a_file_that_is_not_there_and_a_folder_that_cannot_be_written(self):
        with self.assertRaisesRegex(wythe.AccessError, "nowhere.toml: there is no such file; name a file"):
            wythe.run("nowhere.toml")
        with tempfile.NamedTemporaryFile() as file, self.assertRaises((wythe.AccessError, wythe.InputError)):
            wythe.run(PIER, set=SHORT, out=file.name + "/inside", progress=False)

    def test_line_of_a_text(self):
        model = wythe.Model.parse('[wall]\nlength = "-1 m"\n', "mine.toml")
        self.assertEqual([(f.file, f.line) for f in self.refused(lambda: wythe.run(model), "mine.toml:2")
                          if f.path == "wall.length"], [("mine.toml", 2)])
        self.refused(lambda: wythe.Model.parse("[wall"), "TOML")

    def test_what_is_no_model(self):
        self.refused(lambda: wythe.run(17), "int")

    def test_batch_inputs(self):
        def batch(inputs, **options):
            return lambda: wythe.run_many(PIER, inputs, set=SHORT, progress=False, **options)
        self.refused(batch({COHESION: [0.1]}), "no unit", "MPa")
        self.refused(batch({COHESION: ([0.1], "kg")}), "kg")
        self.refused(batch({COHESION + "n": ([0.1], "MPa")}), "did you mean")
        self.refused(batch({COHESION: ([0.1, float("nan")], "MPa")}), "row 1", "finite")
        self.refused(batch({COHESION: ([[0.1]], "MPa")}), "shape (1, 1)")
        self.refused(batch({COHESION: (["x"], "MPa")}), "numbers")
        self.refused(batch({COHESION: ([0.1], "MPa"), "wall.length": ([1, 2], "m")}), "rows")
        self.refused(batch(numpy.ones((3, 2)), columns=[COHESION]), "(3, 2)")
        self.refused(batch(numpy.ones(3)), "names")
        self.refused(batch({}), "no columns")
        self.refused(batch({COHESION: ([0.1], "MPa"), "stage.precompression.pier_lod": ([1], "kN")}), "pier_l")
        idle = {"masonry.unit_strength": ([10, 20], "MPa")}
        self.refused(lambda: wythe.run_many(TUFF, idle, set=SHORT, progress=False), "no rule")
        self.refused(batch({COHESION: ([0.1], "MPa")}, units={"other": "m"}), "other")
        both = {COHESION: ([0.1], "MPa"), "material.joint.cohesion ": ([0.2], "MPa")}
        self.refused(batch(both))

    def test_contact_path(self):
        self.refused(lambda: wythe.contact(TUFF, [0, 0.1], [0]), "rows")
        self.refused(lambda: wythe.contact(TUFF, [], []), "rows")
        self.refused(lambda: wythe.contact(TUFF, [float("inf")], [0]), "finite")

    def test_an_unknown_way_of_limit_analysis(self):
        self.refused(lambda: wythe.limit(TUFF, only=["infinit"]), "infinite")

    def test_without_numpy_the_summary_is_there_and_arrays_say_what_is_missing(self):
        code = f"""
import sys
sys.modules["numpy"] = None
import wythe
result = wythe.run({PIER!r}, set={SHORT!r}, progress=False)
print(result.summary["status"])
try:
    result.curve["reaction_kN"]
except wythe.MissingPackage as error:
    print(error)
"""
        status, out, err = python(code)
        self.assertEqual(status, 0, err)
        self.assertEqual(out.splitlines()[0], "completed")
        self.assertIn("python3-numpy", out)


class Models(unittest.TestCase):
    def setUp(self):
        self.model = wythe.Model.read(PIER)

    def test_read_and_change_with_units(self):
        model = self.model
        self.assertEqual(model.wall.length.unit, "m")
        before = model.text
        model.material["joint"].cohesion = (0.2, "MPa")
        self.assertEqual(model[COHESION], "0.2 MPa")
        self.assertEqual(model[COHESION].value, 0.2)
        model["stage.push.targets"] = ["0.2 mm"]
        model.stage["push"].velocity = "8 mm/s"
        self.assertNotEqual(model.text, before)
        run = wythe.run(model, progress=False)
        asked = wythe.run(PIER, progress=False, set={COHESION: (0.2, "MPa"), "stage.push.targets": ["0.2 mm"],
                                                     "stage.push.velocity": "8 mm/s"})
        self.assertEqual(run.summary["state_hash"], asked.summary["state_hash"])

    def test_text_that_is_written_says_the_same(self):
        for path in sorted(SOURCE.glob("examples/*/model.toml")):
            with self.subTest(path.parent.name):
                model = wythe.Model.read(path)
                written = wythe.Model.parse(model.text, model.file)
                written._touch()
                self.assertEqual(wythe.check(written).model, wythe.check(model).model)

    def test_bare_numbers_wrong_words_and_unknown_keys_are_refused_at_once(self):
        model = self.model
        for change, word in [(lambda: setattr(model.wall, "length", 5.1), "without a unit"),
                             (lambda: setattr(model.wall, "lenght", "5 m"), "did you mean length"),
                             (lambda: setattr(model.wall, "bond", "runing"), "running"),
                             (lambda: model.__setitem__("stage.pish.velocity", "1 mm/s"), "push"),
                             (lambda: model.stage.append(name="more", velocty="1 mm/s"), "velocity"),
                             (lambda: setattr(model, "material", {"joint": {"cohesion": 3}}), "without a unit")]:
            before = wythe.check(model).model
            with self.assertRaisesRegex(wythe.InputError, word):
                change()
            self.assertEqual(wythe.check(model).model, before)

    def test_pint_like_quantities(self):
        class Units:
            def __format__(self, _):
                return "N / mm ** 2"

        class Pint:
            magnitude, units = 0.25, Units()
        self.model[COHESION] = Pint()
        self.assertIn("cohesion", wythe.check(self.model).model)
        self.assertIn("0.25 MPa", wythe.check(self.model).model)

    def test_built_from_nothing(self):
        model = wythe.Model()
        model.wall = {"length": "0.6 m", "height": "0.6 m", "thickness": (0.2, "m"), "bond": "running",
                      "unit": {"length": "200 mm", "height": "100 mm", "density": "2000 kg/m^3"}}
        for name in ("joint", "unit"):
            model.material[name] = wythe.Model.read(TUFF).material[name].to_dict()
        model.stage.append(name="gravity")
        model.stage.append(name="push", at={"x": "0 m", "y": "0.55 m"}, direction="+x", velocity="10 mm/s",
                           targets=["0.2 mm"])
        self.assertEqual(wythe.run(model, progress=False).status, "completed")

    def test_a_change_during_a_run_does_not_reach_it(self):
        self.model["stage.push.targets"] = ["0.3 mm"]
        expected = wythe.run(self.model, progress=False).summary["state_hash"]

        def change(*news):
            self.model[COHESION] = "9 MPa"
        self.assertEqual(wythe.run(self.model, progress=change).summary["state_hash"], expected)

    def test_every_key_has_a_meaning(self):
        keys = wythe.keys()
        self.assertGreater(len(keys), 200)
        self.assertTrue(all(key["meaning"] or key["kind"] in ("table", "list", "map") for key in keys.values()))
        self.assertIn("Length of the wall", self.model.wall.help("length"))

    def test_picture_of_the_wall(self):
        self.assertIn("<svg", self.model._repr_html_())


class Batches(unittest.TestCase):
    def test_rows_are_alone_what_they_are_together(self):
        values = [0.1, 0.2, 0.15, 0.2, -1.0]
        batch = wythe.run_many(PIER, {COHESION: (values, "MPa")}, set=SHORT, curves=True, progress=False)
        self.assertEqual(batch.status, ["completed"] * 4 + ["refused"])
        self.assertIn("cohesion", batch.reason[4])
        self.assertEqual(batch.state_hash[1], batch.state_hash[3])
        alone = wythe.run(PIER, set={**SHORT, COHESION: "0.15 MPa"}, progress=False)
        self.assertEqual(batch.state_hash[2], alone.summary["state_hash"])
        numpy.testing.assert_array_equal(batch.curve(2)["reaction_kN"], alone.curve["reaction_kN"])
        self.assertTrue(numpy.isnan(batch.answers["peak_reaction_kN"][4]))
        self.assertFalse(batch.done)
        frame = batch.frame()
        self.assertEqual(list(frame["status"]), batch.status)
        table = batch.curves_at([0.1, 0.2, 5])
        self.assertEqual(table.shape, (5, 3))
        self.assertTrue(numpy.isnan(table[:, 2]).all())
        one_core = wythe.run_many(PIER, {COHESION: (values, "MPa")}, set=SHORT, jobs=1, progress=False)
        self.assertEqual(one_core.state_hash, batch.state_hash)

    def test_matrix_and_data_frame_say_the_same(self):
        import pandas
        rows = numpy.array([[0.1, 20.0], [0.2, 30.0]])
        paths = [COHESION, "material.joint.friction_angle"]
        one = wythe.run_many(PIER, rows, columns=paths, units=dict(zip(paths, ["MPa", "deg"])), set=SHORT, progress=False)
        frame = pandas.DataFrame({f"{COHESION} [MPa]": rows[:, 0], f"{paths[1]} [deg]": rows[:, 1]})
        two = wythe.run_many(PIER, frame, set=SHORT, progress=False)
        self.assertEqual(one.state_hash, two.state_hash)

    def test_an_interrupted_batch_keeps_the_rows_that_ended(self):
        def press(what, share, *_):
            os.kill(os.getpid(), signal.SIGINT)
        rows = list(numpy.linspace(0.1, 0.3, 64))
        low = {"wall.height": "0.4 m", "stage.push.targets": ["0.1 mm"]}
        with self.assertRaises(wythe.Interrupted) as caught:
            wythe.run_many(PIER, {COHESION: (rows, "MPa")}, progress=press, set=low)
        kept = caught.exception.result
        self.assertEqual(len(kept), 64)
        self.assertIn("completed", kept.status)


class Campaigns(unittest.TestCase):
    def test_it_is_the_campaign_of_the_program(self):
        short = {"stage.push.targets": ["0.3 mm"]}
        with tempfile.TemporaryDirectory() as folder:
            mine = wythe.campaign(STUDY, folder + "/mine", samples=4, set=short, progress=False)
            subprocess.run([BUILD / "wythe", "campaign", STUDY, "--out", folder + "/theirs", "--samples", "4",
                            "--quiet", "--set", 'stage.push.targets=["0.3 mm"]'], check=True, capture_output=True)
            tables = [pathlib.Path(folder, name, "samples.csv").read_bytes() for name in ("mine", "theirs")]
            self.assertEqual(*tables)
            opened = wythe.open_campaign(folder + "/theirs")
            self.assertEqual(opened.state_hash, mine.state_hash)
            self.assertEqual(len(mine.frame()), 4)
            self.assertEqual(mine.statistics.keys(), opened.statistics.keys())
            self.assertTrue(mine.replay(2, progress=False).replay["equal"])
            self.assertGreater(len(mine.curve(3)["reaction_kN"]), 100)
            with self.assertRaisesRegex(wythe.InputError, "resume=True|already"):
                wythe.campaign(STUDY, folder + "/mine", samples=4, set=short, progress=False)
            more = wythe.campaign(STUDY, folder + "/mine", samples=6, set=short, resume=True, progress=False)
            self.assertEqual(more.state_hash[:4], mine.state_hash)


class Others(unittest.TestCase):
    def test_limit_analysis(self):
        opinion = wythe.limit(PIER, progress=False)
        self.assertIn("dry", opinion.limit_loads)
        self.assertGreater(opinion.limit_loads["dry"], 0)

    def test_a_joint_along_a_path(self):
        opening = numpy.linspace(0, 0.1, 200)
        answer = wythe.contact(TUFF, opening, numpy.zeros(200))
        dissipated = answer["dissipated_N_per_m"][-1]
        self.assertAlmostEqual(dissipated, 4.3, places=3)  # the whole GI of the model's joint
        self.assertEqual(answer.rows, 200)

    def test_a_compas_file_that_is_written_reads_back(self):
        for source in ("dome", "barrel_vault"):
            with self.subTest(source), tempfile.TemporaryDirectory() as folder:
                run = wythe.run(SOURCE / "examples" / source / "model.toml", set={"stage.spread.until": "0.01 mm"},
                                progress=False)
                file = pathlib.Path(folder, "wall.json")
                run.states[0].save_compas(file)
                nodes = json.loads(file.read_text())["data"]["graph"]["data"]["node"]
                self.assertEqual(sum(not node["is_support"] for node in nodes.values()), run.summary["blocks"])
                self.assertGreater(sum(node["is_support"] for node in nodes.values()), 0)
                model = wythe.Model.parse(READ_BACK, str(pathlib.Path(folder, "model.toml")))
                again = wythe.check(model)
                self.assertEqual(again["blocks"], run.summary["blocks"])
                self.assertEqual(again["joints"], run.summary["joints"])
                again = wythe.run(model, progress=False)
                self.assertIn(again.status, ("completed", "collapsed"))

    def test_stubs_fit_the_module(self):
        for command in (["mypy", "--config-file", str(SOURCE / "pyproject.toml"), "-p", "wythe"],
                        ["stubtest", "--mypy-config-file", str(SOURCE / "pyproject.toml"), "--allowlist",
                         str(SOURCE / "tests/python/stubtest_allowlist.txt"), "wythe._wythe"]):
            done = subprocess.run(command, cwd=SOURCE / "python", capture_output=True, text=True, check=False,
                                  env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_imports_go_one_way(self):
        below = {}
        for path in (SOURCE / "python/wythe").glob("*.py"):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            own = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.level]
            typed = [node for test in tree.body if isinstance(test, ast.If) and ast.unparse(test.test) == "TYPE_CHECKING"
                     for node in test.body]
            self.assertEqual([node.lineno for node in own if node not in [*tree.body, *typed]], [], path.name)
            below[path.stem] = {name for node in own for name in ([node.module] if node.module else [a.name for a in node.names])}
        while below:  # takes away what imports nothing that is left
            lowest = [name for name, imported in below.items() if not imported & below.keys()]
            self.assertTrue(lowest, f"a circle in {sorted(below)}")
            for name in lowest:
                del below[name]

    def test_import_takes_neither_numpy_nor_pandas(self):
        status, out, err = python("import sys, wythe; print([m for m in ('numpy', 'pandas', 'matplotlib') "
                                  "if m in sys.modules])")
        self.assertEqual((status, out.strip()), (0, "[]"), err)

    def test_pip_installs_it_without_a_registry(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["/usr/bin/python3", "-m", "venv", "--system-site-packages", folder], check=True)
            done = subprocess.run([f"{folder}/bin/pip", "install", "--no-build-isolation", "--no-index", str(SOURCE)],
                                  capture_output=True, text=True, check=False,
                                  env={**os.environ, "WYTHE_BUILD": str(BUILD)})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            code = f"import wythe; print(wythe.run({PIER!r}, set={SHORT!r}, progress=False).summary['status'])"
            run = subprocess.run([f"{folder}/bin/python", "-c", code], capture_output=True, text=True, check=False,
                                 cwd=folder)
            self.assertEqual((run.returncode, run.stdout), (0, "completed\n"), run.stderr)


if __name__ == "__main__":
    unittest.main()
