#!/usr/bin/python3
"""The package against clumsy and hostile use: a named exception with a cure, never a crash and never a silent guess."""
import concurrent.futures
import copy
import gc
import multiprocessing
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(BUILD / "python"))

import numpy  # noqa: E402
import pandas  # noqa: E402

import wythe  # noqa: E402

DRY = str(SOURCE / "validation/lourenco_dry_stone_wall/model.toml")
KN = "material.joint.normal_stiffness"
SHORT = {"stage.push.until": "1 mm", "stage.push.velocity": "20 mm/s"}
CHILD = {**os.environ, "PYTHONPATH": str(BUILD / "python")}


def run(**options):
    return wythe.run(DRY, **{"set": SHORT, "progress": False, **options})


def batch(inputs, **options):
    return wythe.run_many(DRY, inputs, **{"set": SHORT, "progress": False, **options})


def hash_of(path):
    """For another process."""
    return wythe.run(path, set=SHORT, progress=False).summary["state_hash"]


class Clumsy(unittest.TestCase):
    def refused(self, call, *words):
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # a warning of NumPy is a guess
            with self.assertRaises(wythe.InputError) as caught:
                call()
        for word in words:
            self.assertIn(word, str(caught.exception))
        self.assertTrue(all(fault.problem for fault in caught.exception.faults))

    def test_things_that_are_no_paths(self):
        for thing in (None, 3, object(), ["a.toml"]):
            self.refused(lambda: wythe.run(thing), "neither a path nor a Model")
            for call in (wythe.Model.read, wythe.open_campaign, lambda t: wythe.replay(t, 1), lambda t: wythe.campaign(t, "x"),
                         lambda t: wythe.campaign(DRY, t)):
                self.refused(lambda: call(thing), "is no path")
        self.refused(lambda: run(out=3), "is no path")
        for call in (wythe.run, wythe.Model.read):
            self.refused(lambda: call("a\0b"), "zero byte")
        for call in (wythe.run, wythe.Model.read):
            with self.assertRaises((wythe.InputError, wythe.AccessError)):
                call("/tmp")
            with self.assertRaises((wythe.InputError, wythe.AccessError)):
                call("no\udc80where.toml")
        self.assertEqual(wythe.check(os.fsencode(DRY))["weight_kN"], wythe.check(pathlib.Path(DRY))["weight_kN"])

    def test_what_is_not_there_is_no_input(self):
        for call in (lambda: wythe.run("nowhere.toml"), lambda: wythe.campaign("nowhere.toml", "x"), lambda: wythe.check("nowhere.toml"),
                     lambda: wythe.open_campaign("nowhere"), lambda: wythe.replay("nowhere", 1), lambda: wythe.limit("nowhere.toml"),
                     lambda: wythe.run_many("nowhere.toml", {KN: ([1.0], "GPa/m")}), lambda: wythe.contact("nowhere.toml", [0], [0]),
                     lambda: wythe.Model.read("nowhere.toml"), lambda: wythe.Function("nowhere.toml", {KN: "GPa/m"})):
            with self.assertRaisesRegex(wythe.AccessError, "nowhere"):
                call()
        self.refused(lambda: wythe.check(wythe.Model("", "nowhere.toml")), "stage")  # its name alone is not asked for

    def test_empty_paths(self):
        for call in (lambda: run(out=""), lambda: wythe.limit(DRY, out=""), lambda: wythe.replay("x", 1, out=""), lambda: wythe.run(""),
                     lambda: wythe.campaign("", "x"), lambda: wythe.campaign(DRY, ""), lambda: wythe.open_campaign(""),
                     lambda: wythe.Model.read(""), lambda: wythe.Model("").write("")):
            self.refused(call, "is empty")

    def test_units_that_differ(self):
        title, pair = f"{KN} [GPa/m]", ([1.0], "MPa/m")
        for call, first, second in ((lambda: batch({title: [1.0]}, units={title: "MPa/m"}), "GPa/m (its title)", "MPa/m (units)"),
                                    (lambda: batch({title: pair}), "GPa/m (its title)", "MPa/m (its values)"),
                                    (lambda: batch({KN: pair}, units={KN: "GPa/m"}), "GPa/m (units)", "MPa/m (its values)"),
                                    (lambda: batch([[1.0]], columns=title, units={title: "MPa/m"}), "GPa/m (its title)", "MPa/m (units)")):
            self.refused(call, KN, "has units that differ", first, second)
        same = batch({title: ([8.0], "GPa/m")}, units={title: "GPa/m"})
        self.assertEqual(same.units, {KN: "GPa/m"})
        self.assertEqual(same.state_hash, batch({KN: ([8.0], "GPa/m")}).state_hash)
        self.refused(lambda: batch({KN: [1.0]}, units={KN: 5}), "is no unit")

    def test_what_limit_is_asked_for(self):
        self.refused(lambda: wythe.limit(DRY, only=["parts"]), "only: parts", "add assessment=True")
        self.refused(lambda: wythe.limit(DRY, only=["parts", "lp"]), "only: parts", "add assessment=True")
        self.refused(lambda: wythe.limit(DRY, only=3), "is no list of names")
        self.refused(lambda: wythe.limit(DRY, only="all"), "all: is nothing that limit analysis answers")
        self.assertEqual(wythe.limit(DRY, only="lp").limit_loads, wythe.limit(DRY, only=["lp"]).limit_loads)
        tilt = wythe.Model.read(str(SOURCE / "examples/dry_tilt/model.toml"))
        self.refused(lambda: wythe.limit(tilt, only="parts", assessment=True), "parts: none is here to check")

    def test_a_path_is_no_model_and_a_number_no_quantity(self):
        with self.assertRaises(wythe.InputError) as caught:
            wythe.Model("model.toml")
        self.assertIn("is the name of a file", str(caught.exception))
        self.assertIn("wythe.Model.read('model.toml')", str(caught.exception))
        for words in ((1, "ton"), (1.0,), ("5 m", "s")):
            with self.assertRaisesRegex(TypeError, "no text with a unit"):
                wythe.Quantity(*words)

    def test_what_a_function_takes_instead(self):
        for wrong in (None, [1], "x", True):
            self.refused(lambda: wythe.Function(DRY, {KN: "GPa/m"}, missing=wrong), "missing", 'write "raise"')
        self.refused(lambda: wythe.Function(DRY, {KN: "GPa/m"}, outputs=3), "is no list of names")
        self.refused(lambda: batch({KN: ([8.0], "GPa/m")}, curves=True).curve("0"), "is no whole number")

    def test_files_whose_names_are_not_unicode_are_files(self):
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(os.fsencode(folder), b"wall\xff.toml")
            with open(name, "wb") as file:
                file.write((SOURCE / "examples/dry_tilt/model.toml").read_bytes())
            self.assertGreater(wythe.check(name)["blocks"], 1)
            self.assertGreater(wythe.check(wythe.Model.read(name))["blocks"], 1)

    def test_texts_that_are_none(self):
        for text in (b"x = 1", None, 3):
            self.refused(lambda: wythe.Model.parse(text), "is no text")
        self.refused(lambda: wythe.run(wythe.Model.parse('name = "\udc80"')), "is no text")
        self.refused(lambda: wythe.Model.parse("a = " + "[" * 100000 + "]" * 100000), "too deep")
        self.refused(lambda: wythe.run(wythe.Model()), "stage")

    def test_texts_that_could_not_be_made(self):
        """They are made when they are asked for; one of no such name is None."""
        from wythe._jobs import Job

        class Raw:
            def __init__(self, why):
                self.why, self.error = why, ""

            def text(self, name):
                if name == "error":
                    return self.error
                self.error = self.why if name == "check" else ""
                return None

        for why, kind in (("there is not enough memory", MemoryError), ("a defect of wythe: no", wythe.DefectError)):
            job = Job(Raw(why))
            with self.assertRaisesRegex(kind, why):
                job.json("check")
            self.assertIsNone(job.json("none"))

    def test_settings_of_every_wrong_kind(self):
        for wrong in (5, [5], b"x=1", [b"x=1"], {"wall.length": None}, {"wall.length": object()}, {"": "x"}, {1: 2},
                      {"stage.push.until": (1, 2)}, {"stage.push.until": ("a", "mm")}, {"stage.push.until": "\udc80"},
                      {"stage.push.until": (float("nan"), "mm")}, {"stage.push.until": numpy.float64(3)},
                      {"stage.push.until": "1 mm\n[x]"}, {"stage.push.until": "1" + "0" * 5000 + " mm"}):
            self.refused(lambda: wythe.check(DRY, set=wrong))

    def test_numbers_that_are_none(self):
        for wrong in (-1, 2.5, "x", [1], 1e300, float("nan"), 10**400):
            self.refused(lambda: run(threads=wrong))
        for wrong in (-1, "x", float("nan"), 10**400):
            self.refused(lambda: batch({KN: ([7], "GPa/m")}, jobs=wrong))
        for wrong in ("2", b"2", True, False, numpy.True_, "all"):
            self.refused(lambda: run(threads=wrong), "threads", "is no number")
            self.refused(lambda: batch({KN: ([7], "GPa/m")}, jobs=wrong), "jobs", "is no number")
            self.refused(lambda: wythe.campaign(DRY, "nowhere", jobs=wrong), "jobs", "is no number")
        for wrong in ("yes", "false", 2, 0.5, [True]):
            self.refused(lambda: run(replace=wrong), "replace", "is neither True nor False")
        run(threads=numpy.int64(1), replace=numpy.False_)
        self.refused(lambda: wythe.campaign(DRY, "nowhere", shard=3), "pair")
        self.refused(lambda: run(language=3), "is no text")

    def test_columns_that_are_no_numbers_are_not_made_into_some(self):
        masked = numpy.ma.masked_array([7.0, 8.0], [False, True])
        for wrong in (None, "abc", ["7"], [7 + 1j], numpy.array([7 + 1j]), [[7], [8, 9]], [[7]], [10**400], masked,
                      numpy.array(["2020-01-01"], dtype="datetime64[s]"), [None], [float("inf")], {"a": 1}):
            self.refused(lambda: batch({KN: (wrong, "GPa/m")}))
        self.refused(lambda: batch(pandas.DataFrame({KN + " [GPa/m]": pandas.array([7, None], dtype="Int64")})))
        strided = batch({KN: (numpy.arange(10, dtype=numpy.float32)[5::3], "GPa/m")})
        self.assertEqual(strided.status, ["completed"] * 2)

    def test_no_column_is_dropped_in_silence(self):
        self.refused(lambda: batch([[7, 8]], columns=[KN, KN], units={KN: "GPa/m"}), "twice")
        self.refused(lambda: batch(pandas.DataFrame([[7.0, 8.0]], columns=[KN + " [GPa/m]"] * 2)), "twice")
        self.refused(lambda: batch({KN + " [GPa/m]": [7], KN + " [MPa/m]": [7]}), "twice")
        self.refused(lambda: batch([[7]], columns=[KN], units=["GPa/m"]), "units")
        self.refused(lambda: batch([["a"]], columns=[KN], units={KN: "GPa/m"}), "matrix")
        self.refused(lambda: batch([[1, 2], [3]], columns=[KN], units={KN: "GPa/m"}), "matrix")

    def test_displacements_of_curves(self):
        rows = batch({KN: ([7], "GPa/m")}, curves=True)
        for wrong in ("x", 0.5, [[0.5]], None):
            self.refused(lambda: rows.curves_at(wrong), "displacement_mm")
        self.assertTrue(numpy.isnan(rows.curves_at([-1, 99])).all())

    def test_models_that_hold_what_no_model_can(self):
        model = wythe.Model.read(DRY)
        before = model.text
        cycle, ring = {}, []
        cycle["unit"] = cycle
        ring.append(ring)
        for change in (lambda: setattr(model, "wall", cycle), lambda: model.__setitem__("stage.push.targets", ring),
                       lambda: setattr(model, "wall", "x"), lambda: setattr(model, "stage", 3), lambda: setattr(model, "stage", [3]),
                       lambda: model.wall.__setitem__("unit", model.wall), lambda: model[3], lambda: model[""], lambda: model["..."],
                       lambda: model.material.__setitem__(3, {}), lambda: model.__setitem__("stage.push.targets", 5),
                       lambda: model.__setitem__("stage.push.targets", None), lambda: model.__setitem__(3, 4),
                       lambda: model.__setitem__("stage.push.until", ("a", "mm"))):
            self.refused(change)
        self.assertEqual(wythe.check(model).model, wythe.check(wythe.Model.parse(before, DRY)).model)
        with self.assertRaises((wythe.AccessError, OSError)):
            model.write("/nowhere/x.toml")

    def test_a_part_of_a_model_may_be_put_into_another(self):
        one, two = wythe.Model.read(DRY), wythe.Model()
        two.wall, two.material, two.stage = one.wall, one.material, one.stage
        two.stage.append(one.stage["push"])
        self.assertEqual(len(two.stage), 4)
        self.assertEqual(two.material["joint"].cohesion, one.material["joint"].cohesion)


class Objects(unittest.TestCase):
    def test_views_live_on_when_everything_else_is_gone(self):
        result = run()
        columns = [result.curve["reaction_kN"], result.states[-1].joints["opening_mm"]]
        copies = [column.copy() for column in columns]
        del result
        gc.collect()
        for _ in range(3):
            run()
        for column, same in zip(columns, copies):
            numpy.testing.assert_array_equal(column, same)
            with self.assertRaises(ValueError):
                column.flags.writeable = True

    def test_copies_and_pickles(self):
        result = run()
        self.assertIs(copy.copy(result.curve)["reaction_kN"].dtype, result.curve["reaction_kN"].dtype)
        with self.assertRaisesRegex(TypeError, "hand on its"):
            pickle.dumps(result)
        self.assertEqual(len({result.curve, result.curve}), 1)
        self.assertNotEqual(run().curve, result.curve)
        model = wythe.Model.read(DRY)
        self.assertEqual(pickle.loads(pickle.dumps(model)).text, model.text)
        twin = copy.deepcopy(model)
        twin[KN] = "1 GPa/m"
        self.assertNotEqual(twin[KN], model[KN])

    def test_exceptions_cross_processes_whole(self):
        fault = wythe.Fault(path="a", value="1", problem="b", cure="c", file="f", line=3)
        for error in (wythe.InputError([fault]), wythe.Interrupted(None), wythe.NoAnswer({2: "why"}), wythe.AccessError("x"),
                      wythe.DefectError("x"), wythe.MissingPackage("x")):
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(again), str(again)), (type(error), str(error)))
        self.assertEqual(pickle.loads(pickle.dumps(wythe.InputError([fault]))).faults, [fault])


class Interrupts(unittest.TestCase):
    def test_ctrl_c_again_and_again_ends_the_call_once(self):
        code = f"""
import signal, wythe
def press(*news):
    signal.raise_signal(signal.SIGINT)
for _ in range(3):
    try:
        wythe.run({DRY!r}, progress=press)
        print("not stopped")
    except wythe.Interrupted as stop:
        print(stop.result.status)
print(wythe.run({DRY!r}, set={SHORT!r}, progress=False).status)
"""
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False, env=CHILD)
        self.assertEqual(done.stdout.split(), ["interrupted"] * 3 + ["completed"], done.stderr)

    def test_a_killed_terminal_ends_the_process(self):
        code = f"""
import sys, wythe
wythe.run_many({DRY!r}, {{{KN!r}: ([7.0] * 5000, "GPa/m")}}, progress=lambda *news: print("under way", flush=True))
"""
        for which in (signal.SIGTERM, signal.SIGHUP):
            child = subprocess.Popen(["/usr/bin/python3", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                     text=True, env=CHILD)
            self.assertEqual(child.stdout.readline(), "under way\n")
            child.send_signal(which)
            child.stdout.close()
            self.assertEqual(child.wait(), -which)

    def test_a_call_within_the_progress_of_another(self):
        inner = []
        outer = run(progress=lambda *news: inner.append(run().summary["state_hash"]) if not inner else None)
        self.assertEqual(run().summary["state_hash"], outer.summary["state_hash"])
        self.assertTrue(all(one == outer.summary["state_hash"] for one in inner))

    def test_progress_that_raises_anything_stops_the_call_with_it(self):
        for wrong, kind in ((lambda: 1, TypeError), (lambda *news: sys.exit(3), SystemExit),
                            (lambda *news: [][1], IndexError)):
            with self.assertRaises(kind):
                wythe.run(DRY, progress=wrong)


class Others(unittest.TestCase):
    def test_batches_and_runs_in_threads_at_once(self):
        with concurrent.futures.ThreadPoolExecutor(6) as pool:
            runs = [pool.submit(run) for _ in range(6)]
            batches = [pool.submit(batch, {KN: ([7.56] * 3, "GPa/m")}) for _ in range(3)]
            hashes = {one.result().summary["state_hash"] for one in runs}
            for one in batches:
                hashes |= set(one.result().state_hash)
        self.assertEqual(len(hashes), 1)

    def test_a_model_changed_by_another_thread_gives_the_walls_before_or_after(self):
        model = wythe.Model.read(DRY)
        for path, value in SHORT.items():
            model[path] = value
        walls = set()
        for value in ("5 GPa/m", "9 GPa/m"):
            model[KN] = value
            walls.add(wythe.run(model, progress=False).summary["state_hash"])
        stop = threading.Event()

        def change():
            while not stop.is_set():
                model[KN] = "5 GPa/m"
                model[KN] = "9 GPa/m"
        thread = threading.Thread(target=change)
        thread.start()
        try:
            found = {wythe.run(model, progress=False).summary["state_hash"] for _ in range(10)}
        finally:
            stop.set()
            thread.join()
        self.assertLessEqual(found, walls)

    def test_processes_that_are_forked_or_spawned_after_the_import(self):
        expected = hash_of(DRY)  # threads have run in this process
        for method in ("fork", "spawn"):
            with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context(method)) as pool:
                self.assertEqual(list(pool.map(hash_of, [DRY, DRY])), [expected] * 2, method)

    def test_an_interpreter_that_ends_while_a_thread_computes(self):
        code = f"""
import threading, wythe
started = threading.Event()
threading.Thread(target=lambda: wythe.run({DRY!r}, progress=lambda *news: started.set()), daemon=True).start()
threading.Thread(target=lambda: wythe.run_many({DRY!r}, {{{KN!r}: ([7.0] * 5000, "GPa/m")}}), daemon=True).start()
started.wait()
"""
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False, env=CHILD)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_job_that_begins_when_the_interpreter_has_stopped_the_others_is_not_performed(self):
        code = """
import atexit, threading
class Raw:
    def perform(self, hear):
        print("performed")
def late():
    thread = threading.Thread(target=wythe._jobs._beside, args=(Raw(), None))
    thread.start()
    thread.join()
atexit.register(late)  # before wythe's own, so it is called after that
import wythe._jobs
"""
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False, env=CHILD)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_child_that_ends_while_its_parent_computes(self):
        code = f"""
import os, sys, threading, wythe
started = threading.Event()
thread = threading.Thread(target=lambda: wythe.run({DRY!r}, progress=lambda *news: started.set()))
thread.start()
started.wait()
child = os.fork()
if child == 0:
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
thread.join()
"""
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False, env=CHILD)
        self.assertEqual((done.returncode, done.stdout), (0, "7\n"), done.stderr)

    def test_without_pandas_and_matplotlib(self):
        code = f"""
import sys
sys.modules["pandas"] = sys.modules["matplotlib"] = sys.modules["matplotlib.pyplot"] = sys.modules["openturns"] = None
import wythe, wythe.openturns
result = wythe.run({DRY!r}, set={SHORT!r}, progress=False)
for call in (result.curve.frame, result.plot, lambda: wythe.openturns.function({DRY!r}, {{}})):
    try:
        call()
    except wythe.MissingPackage as error:
        print(str(error).split()[-1])
"""
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False, env=CHILD)
        self.assertEqual(done.stdout.split(), ["python3-pandas", "python3-matplotlib", "python3-openturns"], done.stderr)

    def test_a_wall_too_large_for_memory_is_refused(self):
        model = str(SOURCE / "examples/brick_pier/model.toml")
        with self.assertRaises((wythe.InputError, MemoryError)):
            wythe.check(model, set={"wall.length": "1e6 m"})

    def test_a_decimal_mark_of_the_host_changes_nothing(self):
        # LC_NUMERIC as localedef makes it: the marks of Italy and of Iran, of two bytes. No locale is installed on a bare machine
        marks = {"comma": "141103200600000020000000220000002400000028000000" "2c000000300000002c002e00030300002c0000002e000000"
                          "414e53495f58332e342d3139363800",
                 "momayyez": "141103200600000020000000230000002600000" "02c0000003000000034000000d9ab00d9ac000303000000006b06"
                             "00006c0600005554462d3800"}
        facade = str(SOURCE / "examples/brick_facade/model.toml")
        blocks = ('{"units": "m", "blocks": [{"id": "base", "polygon": [[0, 0], [0.25, 0], [0.25, 0.25], [0, 0.25]]},'
                  '{"id": "top", "polygon": [[0, 0.25], [0.25, 0.25], [0.25, 0.4375], [0, 0.4375]]}]}')
        code = f"""
import locale, pathlib, sys
def mark():
    locale.setlocale(locale.LC_NUMERIC, sys.argv[2])
    assert locale.str(0.5) in ("0,5", "0\u066b5")
if sys.argv[1] == "before": mark()
import wythe
if sys.argv[1] == "between": wythe.check({DRY!r}); mark()
print(wythe.check({facade!r}).model)
result = wythe.run({DRY!r}, set={SHORT!r}, progress=False)
print([(key, value) for key, value in sorted(result.summary.items()) if "second" not in key])
print({{name: list(column) for name, column in result.curve.items()}})
walls = wythe.run_many({DRY!r}, {{{KN!r}: [10.5, 12.5]}}, units={{{KN!r}: "GPa/m"}}, set={SHORT!r}, progress=False)
print(walls.frame().drop(columns=[c for c in walls.frame() if "second" in c]).to_csv())
model = pathlib.Path({DRY!r}).read_text()
pathlib.Path("blocks.json").write_text({blocks!r})
pathlib.Path("model.toml").write_text('wall = {{ blocks = "blocks.json", thickness = "0.2 m", unit = {{ density = "2000 kg/m^3" }} }}' + chr(10)
    + 'stage = [{{ name = "gravity" }}]' + chr(10) + model[model.index("[material.joint]"):].split("[[")[0])
print(str(wythe.check("model.toml")).split(", about")[0])
try: wythe.check({facade!r}, set={{"wall.unit.length": "-0.295 m"}})
except wythe.InputError as error: print(error)
"""
        for name, numeric in marks.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / name).mkdir()
                (pathlib.Path(folder) / name / "LC_NUMERIC").write_bytes(bytes.fromhex(numeric))
                said = [subprocess.run(["/usr/bin/python3", "-c", code, when, name], capture_output=True, text=True, check=False,
                                       cwd=folder, env={**CHILD, "LOCPATH": folder}) for when in ("never", "before", "between")]
                for done in said:
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual(done.stdout, said[0].stdout)
                self.assertIn("-0.295 m", said[0].stdout)


if __name__ == "__main__":
    unittest.main()
