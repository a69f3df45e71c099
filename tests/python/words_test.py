#!/usr/bin/python3
"""Answers that explain themselves in Python: no NaN or None without a reason, the same meaning of cores in every
call, and a docstring and types for every name that help() shows."""
import inspect
import os
import pathlib
import sys
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(BUILD / "python"))

try:
    import numpy
    import pandas
    import wythe
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

DRY = """
wall = { length = "1.0 m", height = "1.2 m", thickness = "0.2 m", unit = { length = "200 mm", height = "100 mm", split = "none", density = "1800 kg/m^3" } }
stage = [{ name = "gravity" }, { name = "push", at = { x = "0 m", y = "1.05 m", courses = 3 }, velocity = "10 mm/s", until = "0.5 mm" }]
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
"""
VELOCITY = "stage.push.velocity"
PIER = str(SOURCE / "examples/brick_pier/model.toml")
WORDS = ["status", "failure_mode", "reason", "rate_judgement"]


def dry(text=DRY):
    return wythe.Model.parse(text)


class Frames(unittest.TestCase):
    # 2 mm/s is usable, 40 mm/s outruns the wall, 1e9 mm/s is refused
    def batch(self):
        return wythe.run_many(dry(), {VELOCITY: (numpy.array([2.0, 40.0, 1e9]), "mm/s")}, jobs=1, progress=False)

    def test_every_row_without_a_number_has_a_word(self):
        frame = self.batch().frame()
        self.assertEqual(list(frame.columns[1:5]), WORDS)
        for _, row in frame.iterrows():
            if row["peak_reaction_kN"] != row["peak_reaction_kN"]:
                self.assertTrue(row["reason"], row)
        self.assertEqual(list(frame["status"]), ["completed", "completed", "refused"])
        self.assertEqual(frame["rate_judgement"][1], "too fast")
        self.assertIn("differ by more than 2 %", frame["reason"][1])
        self.assertIsNone(frame["reason"][0])

    def test_a_batch_says_how_many_have_no_capacity(self):
        self.assertEqual(repr(self.batch()), "<batch of 3: 2 completed (1 without a capacity), 1 refused>")

    def test_a_campaign_has_the_same_words(self):
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            at = pathlib.Path(folder)
            (at / "model.toml").write_text(DRY)
            (at / "study.toml").write_text("""[study]
model = "model.toml"
samples = 2
seed = 1
[variable.v]
path = "stage.push.velocity"
distribution = "uniform"
low = "30 mm/s"
high = "40 mm/s"
""")
            campaign = wythe.campaign(at / "study.toml", at / "out", jobs=1, progress=False)
            frame = campaign.frame()
            for name in WORDS:
                self.assertIn(name, frame.columns)
            self.assertTrue(all(frame["reason"]), frame["reason"])
            self.assertEqual(set(frame["rate_judgement"]), {"too fast"})
            self.assertIn("2 completed (2 without a capacity)", repr(campaign))
            self.assertNotIn("None", repr(campaign) + campaign._repr_html_())


class Nothing(unittest.TestCase):
    def test_an_answer_that_is_not_there_is_said_in_words(self):
        fast = wythe.run(dry(), set={VELOCITY: "40 mm/s"}, progress=False)
        self.assertIsNone(fast.summary["peak_reaction_kN"])
        for text in (repr(fast), fast._repr_html_(), repr(wythe.check(dry())), wythe.check(dry())._repr_html_()):
            self.assertNotIn("None", text)
            self.assertNotIn(" nan", text)
        self.assertIn("capacity not known: reaction and base shear differ", repr(fast))
        self.assertNotIn("- kN", repr(fast))

    def test_a_load_factor_is_a_capacity_too(self):
        tilt = '{ name = "tilt", tilt_rate = "20 deg/s", tilt_until = "60 deg" }]'
        text = DRY[:DRY.index('{ name = "push"')] + tilt + DRY[DRY.index("\n[material.joint]"):]
        low = text.replace('height = "1.2 m"', 'height = "0.6 m"')  # all of it slides at the angle of friction
        self.assertRegex(repr(wythe.run(dry(low), progress=False)), "capacity load factor 0.57[0-9]+, 1\\.")


# A wall that is shaken, and not pushed.
SHAKEN = DRY[:DRY.index('{ name = "push"')] + (
    '{ name = "s", free_vibration = "0.05 s", record = { accelerations = [0, 0.1, 0, -0.1, 0], unit = "g", '
    "times = [0, 0.02, 0.04, 0.06, 0.08] } }]"
) + DRY[DRY.index("\n[material.joint]"):]


class Bounds(unittest.TestCase):
    def test_a_lower_bound_is_called_one(self):
        result = wythe.run(PIER, set={"stage.push.until": "0.3 mm"}, progress=False)
        self.assertTrue(result.summary["censored_peak"])
        peak = f"capacity at least {result.summary['peak_reaction_kN']:.4g} kN at 0.3 mm"
        self.assertIn(peak, repr(result))
        self.assertIn(peak[len("capacity "):], result._repr_html_())

    def test_a_load_that_did_not_reach_its_end_is_a_bound_too(self):
        tilt = '{ name = "tilt", tilt_rate = "20 deg/s", tilt_until = "5 deg" }]'
        text = DRY[:DRY.index('{ name = "push"')] + tilt + DRY[DRY.index("\n[material.joint]"):]
        self.assertRegex(repr(wythe.run(dry(text), progress=False)), "capacity at least load factor 0.08[0-9]*, ")

    def test_a_batch_and_a_campaign_count_them(self):
        import tempfile
        batch = wythe.run_many(PIER, {"stage.push.until": ([0.2, 0.3], "mm")}, jobs=1, progress=False)
        self.assertEqual(list(batch.answers["censored_peak"]), [1, 1])
        self.assertEqual(repr(batch), "<batch of 2: 2 completed (2 with a lower bound of the capacity)>")
        with tempfile.TemporaryDirectory() as folder:
            at = pathlib.Path(folder)
            (at / "study.toml").write_text(f"""[study]
model = "{PIER}"
samples = 2
seed = 1
[variable.until]
path = "stage.push.until"
distribution = "uniform"
low = "0.2 mm"
high = "0.3 mm"
""")
            campaign = wythe.campaign(at / "study.toml", at / "out", jobs=1, progress=False)
            self.assertIn("2 completed (2 with a lower bound of the capacity)", repr(campaign))
            page = campaign._repr_html_()
            self.assertIn("2, 2 of them with a capacity, of which 2 are lower bounds", page)
            self.assertRegex(page, r"at least [0-9.]+ to at least [0-9.]+ kN")
            for wrong in ("1", "x", None, 1.5):
                with self.assertRaisesRegex(wythe.InputError, "no whole number"):
                    campaign.curve(wrong)
            self.assertTrue(len(campaign.curve(campaign.inputs["sample"][0])["reaction_kN"]))

    def test_a_shake_has_no_capacity(self):
        result = wythe.run(dry(SHAKEN), progress=False)
        said = result.summary["shaking"]["sentence"]
        self.assertTrue(said.startswith("shaken with a peak of 0.1 g the wall stands"), said)
        for text in (repr(result), result._repr_html_()):
            self.assertIn(said, text)
            self.assertNotIn("capacity", text)
            self.assertNotIn("unclear", text)

    def test_a_wall_that_nothing_pushes_has_none(self):
        text = DRY[:DRY.index(', { name = "push"')] + "]" + DRY[DRY.index("\n[material.joint]"):]
        self.assertIn("capacity not asked for: nothing pushed the wall", repr(wythe.run(dry(text), progress=False)))


class Options(unittest.TestCase):
    """The command line's options in the words of Python."""
    def test_the_words_are_pythons(self):
        from wythe._errors import in_python
        for said, meant in (("--resume goes on with it; or name another folder", "resume=True goes on with it; or name another folder"),
                            ("write --samples 5 or more, or leave --samples out", "write samples=5 or more, or leave samples out"),
                            ("e.g. --shard 1/4", "e.g. shard=(1, 4)"), ("leave --only lp out", 'leave only="lp" out'),
                            ("run it: wythe campaign S --out DIR", "run it: wythe campaign S --out DIR"),
                            ("name the folder that wythe campaign --out wrote", "name the folder that wythe.campaign wrote"),
                            ("/tmp/a--out: b", "/tmp/a--out: b"), ("--outer", "--outer")):
            self.assertEqual(in_python(said), meant)

    def test_faults_of_a_study_name_the_argument(self):
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            at = pathlib.Path(folder)
            (at / "model.toml").write_text(DRY)
            (at / "study.toml").write_text("""[study]
model = "model.toml"
samples = 3
seed = 1
[variable.v]
path = "stage.push.velocity"
distribution = "uniform"
low = "30 mm/s"
high = "40 mm/s"
""")
            def run(**options):
                return wythe.campaign(at / "study.toml", at / "out", jobs=1, progress=False, **options)
            run()
            for options, words in (({"samples": 1}, "^samples = 1: must be at least 2"), ({"until": "x"}, "^until = x: "),
                                   ({"set": {"study.samples": 1}}, "^set: study.samples = 1: "),
                                   ({}, "resume=True goes on"), ({"samples": 2, "resume": True}, "samples=")):
                with self.assertRaisesRegex(wythe.InputError, words) as caught:
                    run(**options)
                self.assertNotIn("--", str(caught.exception))

    def test_a_model_made_in_python_has_no_lines(self):
        model = dry()
        model.wall.length = "1.1 m"
        model["material.joint.normal_stiffness"] = "-1 GPa/m"
        for given in (model, model.copy()):
            with self.assertRaises(wythe.InputError) as caught:
                wythe.check(given)
            self.assertEqual({fault.line for fault in caught.exception.faults}, {0})
        with self.assertRaises(wythe.InputError) as caught:
            wythe.check(dry(DRY.replace("20 GPa/m", "-1 GPa/m")))
        self.assertEqual(caught.exception.faults[0].line, 5)

    def test_help_has_the_defaults(self):
        keys = wythe.keys()
        for path, default in (("wall.bond", "running"), ("solve.contacts", "joints"), ("assessment.masonry_share", "1")):
            self.assertEqual(keys[path]["default"], default)
        self.assertFalse([path for path, key in keys.items() if key.get("allowed") == "any"])
        self.assertFalse([path for path, key in keys.items() if key["kind"] == "flag" and "default" not in key])
        model = dry()
        self.assertIn("One of: running, ", model.wall.help("bond"))
        self.assertIn("Default: running.", model.wall.help("bond"))
        self.assertEqual(model.stage.help("velocity"), model.stage["push"].help("velocity"))
        self.assertEqual(model.material.help("cohesion"), model.material["joint"].help("cohesion"))
        self.assertIn("velocity: ", model.stage.help())

    def test_members_are_not_invented(self):
        model = dry()
        for call in (lambda: model.material["foo"], lambda: model["material.foo.cohesion"], lambda: model.stage["foo"]):
            with self.assertRaises(KeyError) as caught:
                call()
            self.assertIsInstance(caught.exception, wythe.InputError)
            self.assertRegex(str(caught.exception), "foo: no such member; there are: (joint|gravity, push)$")
        self.assertEqual(list(model.material), ["joint"])
        model.material["new"] = {"cohesion": "0.1 MPa"}
        model["material.newer.cohesion"] = "0.1 MPa"
        self.assertEqual(list(model.material), ["joint", "new", "newer"])


class Cores(unittest.TestCase):
    def test_threads_and_jobs_take_the_same_numbers(self):
        one = {VELOCITY: (numpy.array([2.0]), "mm/s")}
        short = {"stage.push.until": "0.01 mm"}
        calls = [lambda n: wythe.run(dry(), threads=n, set=short, progress=False).summary["state_hash"],
                 lambda n: wythe.run_many(dry(), one, jobs=n, set=short, progress=False).state_hash[0]]
        for call in calls:
            self.assertEqual(len({call(n) for n in (0, 1, 2, None)}), 1)
            for wrong in (-1, 1.5, 1025):
                with self.assertRaisesRegex(wythe.InputError, "whole number from 0 to 1024"):
                    call(wrong)
        for call in (wythe.run, wythe.replay, wythe.run_many, wythe.campaign, wythe.Function):
            words = " ".join((inspect.getdoc(call) or "").split())
            self.assertRegex(words, "0 all|as of ``run``", call)


class Help(unittest.TestCase):
    def names(self):
        for name in wythe.__all__:
            found = getattr(wythe, name)
            yield f"wythe.{name}", found
            if inspect.isclass(found) and found.__module__.startswith("wythe"):
                for own, member in vars(found).items():
                    if not own.startswith("_"):
                        yield f"wythe.{name}.{own}", member

    def test_each_name_has_a_docstring_and_types(self):
        bare = []
        for name, found in self.names():
            plain = found.fget if isinstance(found, property) else getattr(found, "__func__", found)
            plain = inspect.unwrap(plain) if callable(plain) else plain
            if isinstance(plain, str) or not callable(plain):
                continue
            if not inspect.getdoc(plain):
                bare.append(f"{name}: no docstring")
            if inspect.isfunction(plain):
                signature = inspect.signature(plain)
                if signature.return_annotation is inspect.Signature.empty:
                    bare.append(f"{name}: no type of its answer")
                bare += [f"{name}({p.name}): no type" for p in signature.parameters.values()
                         if p.annotation is inspect.Parameter.empty and p.name not in ("self", "cls")]
        self.assertEqual(bare, [])


class Stiffness(unittest.TestCase):
    # The slope of the rise is the wall's: a push that is too fast to show it says so.
    def test_it_does_not_move_with_velocity(self):
        model = dry(DRY.replace('until = "0.5 mm"', 'until = "2 mm"'))
        fast = wythe.run_many(model, {VELOCITY: (numpy.array([2.0, 3.0, 5.0, 7.0, 8.0, 9.0, 12.0, 20.0]), "mm/s")}, jobs=1,
                              progress=False).answers["initial_stiffness_kN_per_mm"]
        slow = fast[0]
        known = [value / slow for value in fast if value == value]
        self.assertGreaterEqual(len(known), 3)
        for ratio in known:
            self.assertAlmostEqual(ratio, 1, delta=0.03)

    def test_a_push_without_it_says_why(self):
        batch = wythe.run_many(dry(), {VELOCITY: (numpy.array([2.0, 10.0]), "mm/s")}, jobs=1, progress=False)
        values = batch.answers["initial_stiffness_kN_per_mm"]
        self.assertTrue(values[0] == values[0] and values[1] != values[1])
        self.assertIsNone(batch.reason[0])
        self.assertRegex(batch.reason[1], "^the initial stiffness is not known: the first force of the push is above a tenth")
        summary = wythe.run(dry(), progress=False).summary
        self.assertEqual(summary["initial_stiffness_reason"], batch.reason[1])
        self.assertEqual(wythe.run(dry(), set={VELOCITY: "2 mm/s"}, progress=False).summary["initial_stiffness_reason"], "")

    def test_brothers(self):
        for until, most in (("0.5 mm", 5), ("5 mm", 12)):
            model = dry(DRY.replace('until = "0.5 mm"', f'until = "{until}"'))
            velocities = numpy.array([1.0, 2.0, 3.0, 5.0, 9.0, 12.0, 40.0])
            fast = wythe.run_many(model, {VELOCITY: (velocities, "mm/s")}, jobs=1, progress=False).answers["initial_stiffness_kN_per_mm"]
            for velocity, value in zip(velocities, fast):
                if value == value:
                    self.assertAlmostEqual(value / fast[0], 1, delta=0.04)
                self.assertTrue(value == value or velocity > 2)
                self.assertTrue(value != value or velocity < most)


if __name__ == "__main__":
    unittest.main()
