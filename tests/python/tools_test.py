#!/usr/bin/python3
"""The package with other tools: a wall as a function, in OpenTURNS, over UM-Bridge, from Dakota."""
import contextlib
import http.client
import io
import json
import os
import pathlib
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
import wythe.dakota  # noqa: E402
import wythe.umbridge  # noqa: E402

DRY = str(SOURCE / "validation/lourenco_dry_stone_wall/model.toml")  # a tenth of a second for a wall
KN, KS = "material.joint.normal_stiffness", "material.joint.shear_stiffness"
PHI, RESIDUAL = "material.joint.friction_angle", "material.joint.residual_friction_angle"
INPUTS = {KN: "GPa/m", PHI: "deg"}
PEAK, AT_PEAK, AT_80 = "peak_reaction_kN", "displacement_at_peak_mm", "displacement_at_80_percent_mm"
FAST = {"set": {"stage.push.until": "4 mm", "stage.push.velocity": "20 mm/s"}}
WHOLE = {"follow": {KS: (0.4, KN), RESIDUAL: (1, PHI)}, "bounds": "take", "rate": "take", **FAST}
GOOD, REFUSED = [7.56, 33.0], [-1.0, 33.0]


class Functions(unittest.TestCase):
    def test_rows_are_runs_and_followers_follow(self):
        function = wythe.Function(DRY, INPUTS, [PEAK, AT_PEAK], **WHOLE)
        rows = function([[7.56, 33.0], [5.0, 20.0]])
        self.assertEqual(rows.shape, (2, 2))
        for row, (stiffness, angle) in zip(rows, [(7.56, 33.0), (5.0, 20.0)]):
            run = wythe.run(DRY, progress=False, set={
                **FAST["set"], KN: (stiffness, "GPa/m"), KS: (0.4 * stiffness, "GPa/m"), PHI: (angle, "deg"),
                RESIDUAL: (angle, "deg")})
            self.assertEqual(list(row), [run.summary[PEAK], run.summary[AT_PEAK]])
        numpy.testing.assert_array_equal(function([5.0, 20.0]), rows[1])

    def test_a_wall_that_is_refused_raises_with_its_row_or_gives_the_stated_number(self):
        with self.assertRaises(wythe.NoAnswer) as caught:
            wythe.Function(DRY, INPUTS, **WHOLE)([GOOD, REFUSED])
        self.assertEqual(list(caught.exception.rows), [1])
        self.assertIn("must be more than 0", str(caught.exception))
        self.assertIn("missing=", str(caught.exception))
        rows = wythe.Function(DRY, INPUTS, [PEAK], missing=-7, **WHOLE)([GOOD, REFUSED])
        self.assertGreater(rows[0, 0], 20)
        self.assertEqual(rows[1, 0], -7)
        self.assertTrue(numpy.isnan(wythe.Function(DRY, INPUTS, missing=float("nan"), **WHOLE)([REFUSED])).all())

    def test_a_push_that_was_too_fast_is_no_answer_unless_it_is_taken(self):
        hasty = {**WHOLE, "set": {"stage.push.until": "4 mm", "stage.push.velocity": "300 mm/s"}}
        taken = wythe.Function(DRY, INPUTS, ["peak_raw_kN"], **hasty)([GOOD])
        self.assertTrue(numpy.isfinite(taken).all())
        strict = wythe.Function(DRY, INPUTS, ["peak_raw_kN"], **{**hasty, "rate": "raise"})
        with self.assertRaisesRegex(wythe.NoAnswer, "(too fast|unknown).*rate='take'"):
            strict([GOOD])
        with self.assertRaisesRegex(wythe.NoAnswer, "rate='take'"):
            strict.curves_at([GOOD], [1.0])
        with self.assertRaisesRegex(wythe.InputError, "rate"):
            wythe.Function(DRY, INPUTS, rate="maybe")

    def test_a_lower_bound_is_no_answer_unless_it_is_taken(self):
        strict = wythe.Function(DRY, INPUTS, [AT_80], **{**WHOLE, "bounds": "raise"})
        with self.assertRaisesRegex(wythe.NoAnswer, "only a lower bound"):
            strict([GOOD])
        taken = wythe.Function(DRY, INPUTS, [AT_80], **WHOLE)([GOOD])
        self.assertAlmostEqual(taken[0, 0], 4, delta=0.01)
        run = wythe.run(DRY, progress=False, set=FAST["set"])
        self.assertTrue(run.summary["censored_80"])

    def test_curves_end_where_they_end(self):
        function = wythe.Function(DRY, INPUTS, **WHOLE)
        self.assertEqual(function.curves_at([GOOD, GOOD], [0.5, 1, 2]).shape, (2, 3))
        with self.assertRaisesRegex(wythe.NoAnswer, "ends at 4"):
            function.curves_at([GOOD], [1, 9])
        filled = wythe.Function(DRY, INPUTS, missing=0, **WHOLE).curves_at([GOOD, REFUSED], [1, 9])
        self.assertGreater(filled[0, 0], 1)
        self.assertEqual(filled[0, 1], 0)
        self.assertEqual(list(filled[1]), [0, 0])

    def test_what_is_wrong_is_said_before_any_wall_runs(self):
        def refused(word, *arguments, **options):
            with self.assertRaisesRegex(wythe.InputError, word):
                wythe.Function(DRY, *arguments, **options)
        refused("name no inputs", {})
        refused("name no inputs", [KN])
        refused("is no unit", {KN: None})
        refused("did you mean", {KN + "s": "GPa/m"})
        refused("kg", {KN: "kg"})
        refused("is no answer", INPUTS, ["peak"])
        refused("names nothing", INPUTS, [])
        refused("no such choice", INPUTS, missing="skip")
        refused("no such choice", INPUTS, missing=True)
        refused("no such choice", INPUTS, bounds=1)
        refused("is no input", INPUTS, follow={KS: (1, "kn")})
        refused("is an input itself", INPUTS, follow={KN: (1, PHI)})
        refused("factor", INPUTS, follow={KS: 0.4})
        with self.assertRaisesRegex(wythe.InputError, "neither a path nor a Model|int"):
            wythe.Function(17, INPUTS)
        function = wythe.Function(DRY, INPUTS, **WHOLE)
        for points in ([[1, 2, 3]], [["a", "b"]], 3, [[]], [[[1, 2]]], {"a": 1}):
            with self.assertRaises(wythe.InputError, msg=str(points)):
                function(points)
        with self.assertRaisesRegex(wythe.InputError, "finite"):
            function([[7, float("nan")]])

    def test_later_changes_of_the_model_do_not_reach_it(self):
        model = wythe.Model.read(DRY)
        function = wythe.Function(model, INPUTS, **WHOLE)
        before = function([GOOD])
        model["stage.precompression.beam_load"] = "50 kN"
        numpy.testing.assert_array_equal(function([GOOD]), before)


class OpenTurns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        try:
            import openturns
        except ImportError:
            raise unittest.SkipTest("python3-openturns is not installed") from None
        import wythe.openturns
        cls.openturns, cls.bridge = openturns, wythe.openturns

    def test_ctrl_c_stops_a_call_beside_openturns(self):
        # OpenTURNS puts a handler of its own in the place of Python's, which throws out of the signal
        code = f"""
import openturns, os, signal, wythe
def stop(*heard):
    os.kill(os.getpid(), signal.SIGINT)
for _ in range(2):
    try:
        wythe.run({DRY!r}, progress=stop)
    except wythe.Interrupted as stopped:
        print(stopped.result.status)
"""
        done = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
        self.assertEqual((done.returncode, done.stdout.split()), (0, ["interrupted"] * 2), done.stderr)

    def test_a_sample_is_one_batch_and_equals_its_points(self):
        function = self.bridge.function(DRY, INPUTS, [PEAK, AT_PEAK], **WHOLE)
        self.assertEqual(list(function.getInputDescription()), [f"{KN} [GPa/m]", f"{PHI} [deg]"])
        self.assertEqual(list(function.getOutputDescription()), [PEAK, AT_PEAK])
        calls = []
        original = wythe._function.run_many
        wythe._function.run_many = lambda *a, **k: calls.append(1) or original(*a, **k)
        try:
            sample = function(self.openturns.Sample([GOOD, [5.0, 25.0], [6.0, 30.0]]))
        finally:
            wythe._function.run_many = original
        self.assertEqual(len(calls), 1)
        self.assertEqual(list(sample[1]), list(function([5.0, 25.0])))

    def test_it_works_with_a_distribution_of_openturns(self):
        ot = self.openturns
        function = self.bridge.function(DRY, INPUTS, **WHOLE)
        ot.RandomGenerator.SetSeed(1)
        inputs = ot.RandomVector(ot.ComposedDistribution([ot.Uniform(5, 10), ot.Uniform(30, 35)]))
        peaks = ot.CompositeRandomVector(function, inputs).getSample(4)
        self.assertTrue(all(20 < peak[0] < 60 for peak in peaks))

    def test_no_answer_is_an_exception_or_the_stated_number(self):
        with self.assertRaisesRegex(Exception, "must be more than 0"):
            self.bridge.function(DRY, INPUTS, **WHOLE)(REFUSED)
        self.assertEqual(self.bridge.function(DRY, INPUTS, missing=-1, **WHOLE)(REFUSED)[0], -1)

    def test_a_field_is_the_curve(self):
        at = [0.5, 1.0, 2.0]
        field = self.bridge.field_function(DRY, INPUTS, at, **WHOLE)
        curve = wythe.Function(DRY, INPUTS, **WHOLE).curves_at([GOOD], at)[0]
        self.assertEqual([row[0] for row in field(GOOD)], list(curve))
        process = field(self.openturns.Sample([GOOD, [5.0, 25.0]]))
        self.assertEqual([row[0] for row in process[0]], list(curve))
        self.assertEqual([v[0] for v in field.getOutputMesh().getVertices()], at)
        for wrong in ([1.0], [2.0, 1.0], [1.0, 1.0]):
            with self.assertRaisesRegex(wythe.InputError, "rise"):
                self.bridge.field_function(DRY, INPUTS, wrong, **WHOLE)


class UmBridge(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = wythe.umbridge.Server(DRY, INPUTS, [PEAK, AT_PEAK], port=0, **WHOLE)
        cls.thread = threading.Thread(target=cls.server.serve_forever)
        cls.thread.start()

    @classmethod
    def tearDownClass(cls):
        cls.server.shutdown()
        cls.server.server_close()
        cls.thread.join()

    def ask(self, method, path, body=None, headers=None):
        connection = http.client.HTTPConnection(*self.server.server_address[:2])
        with contextlib.closing(connection):
            connection.request(method, path, body if body is None or isinstance(body, bytes) else json.dumps(body),
                               headers or {})
            reply = connection.getresponse()
            text = reply.read()
            return reply.status, json.loads(text) if text else None

    def post(self, path, **body):
        return self.ask("POST", path, {"name": "wythe", **body})

    def refused(self, reply, status, kind):
        self.assertEqual((reply[0], reply[1]["error"]["type"]), (status, kind), reply)
        self.assertEqual((set(reply[1]), set(reply[1]["error"])), ({"error"}, {"type", "message"}))

    def test_what_a_client_asks_first(self):
        self.assertEqual(self.ask("GET", "/Info"), (200, {"protocolVersion": 1.0, "models": ["wythe"]}))
        self.assertEqual(self.post("/ModelInfo"), (200, {"support": {
            "Evaluate": True, "Gradient": False, "ApplyJacobian": False, "ApplyHessian": False}}))
        self.assertEqual(self.post("/InputSizes", config={}), (200, {"inputSizes": [2]}))
        self.assertEqual(self.post("/OutputSizes", config={}), (200, {"outputSizes": [2]}))
        self.assertEqual(self.ask("HEAD", "/")[0], 200)

    def test_evaluate_is_the_function(self):
        expected = wythe.Function(DRY, INPUTS, [PEAK, AT_PEAK], **WHOLE)([GOOD])[0]
        self.assertEqual(self.post("/Evaluate", input=[GOOD], config={}), (200, {"output": [list(expected)]}))

    def test_clients_at_once_each_get_their_own_answer(self):
        rows = [[5.0 + i, 30.0 + i] for i in range(8)]
        expected = wythe.Function(DRY, INPUTS, [PEAK, AT_PEAK], **WHOLE)(rows)
        replies = [None] * 8

        def client(number):
            replies[number] = self.post("/Evaluate", input=[rows[number]])
        threads = [threading.Thread(target=client, args=(i,)) for i in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([reply[1]["output"][0] for reply in replies], expected.tolist())

    def test_errors_are_those_of_the_protocol(self):
        self.refused(self.ask("POST", "/Evaluate", {"name": "wrong_model_name"}), 400, "ModelNotFound")
        self.refused(self.ask("POST", "/ModelInfo", {}), 400, "ModelNotFound")
        for path in ("/Gradient", "/ApplyJacobian", "/ApplyHessian"):
            self.refused(self.post(path), 400, "UnsupportedFeature")
        for wrong in (None, [], [[1]], [[1, 2, 3]], [[1, 2], [3]], [["a", 2]], [[True, 2]], {"a": 1}, [[1, 10**400]]):
            self.refused(self.post("/Evaluate", input=wrong), 400, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b'{"name": "wythe", "input": [[NaN, 1]]}'), 400, "InvalidInput")
        self.refused(self.post("/Evaluate", input=[GOOD], config={"speed": 1}), 400, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b"{"), 400, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b"[" * 100000), 400, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b"3"), 400, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b"\xff\xfe"), 400, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b"", {"Content-Length": str(1 << 40)}), 413, "InvalidInput")
        self.refused(self.ask("POST", "/Evaluate", b"", {"Content-Length": "x"}), 411, "InvalidInput")
        self.refused(self.ask("GET", "/Evaluate"), 404, "InvalidInput")
        self.refused(self.post("/nothing"), 404, "InvalidInput")

    def test_a_wall_without_an_answer_says_why_and_stops_no_other(self):
        reply = self.post("/Evaluate", input=[REFUSED])
        self.refused(reply, 500, "NoAnswer")
        self.assertIn("must be more than 0", reply[1]["error"]["message"])
        self.assertEqual(self.post("/Evaluate", input=[GOOD])[0], 200)

    def test_a_push_that_was_too_fast_says_so(self):
        hasty = {**WHOLE, "rate": "raise", "set": {"stage.push.until": "4 mm", "stage.push.velocity": "300 mm/s"}}
        with wythe.umbridge.Server(DRY, INPUTS, ["peak_raw_kN"], port=0, **hasty) as server:
            with self.assertRaisesRegex(Exception, "(too fast|unknown).*rate='take'"):
                server.evaluate(GOOD)

    def test_the_command_prints_its_address_and_ends_at_ctrl_c(self):
        command = ["/usr/bin/python3", "-m", "wythe.umbridge", DRY, "--input", f"{KN}=GPa/m", "--output", PEAK, "--port", "0",
                   "--set", "stage.push.until=4 mm", "--follow", f"{KS}=0.4*{KN}", "--bounds", "take", "--missing", "-1"]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
        try:
            url = server.stdout.readline().split()[-1]
            connection = http.client.HTTPConnection(url.removeprefix("http://"))
            with contextlib.closing(connection):
                for value in (7.56, -1.0):
                    connection.request("POST", "/Evaluate", json.dumps({"name": "wythe", "input": [[value]]}))
                    output = json.loads(connection.getresponse().read())["output"][0][0]
                    self.assertTrue(20 < output < 60 if value > 0 else output == -1, output)
        finally:
            server.send_signal(2)
            _, errors = server.communicate()
        self.assertEqual((server.returncode, errors), (0, ""))

    def test_a_command_that_cannot_start_says_why(self):
        for arguments, word in [(["nowhere.toml", "--input", "a=m"], "nowhere.toml"),
                                ([DRY, "--input", f"{KN}=kg"], "kg"),
                                ([DRY, "--input", f"{KN}=GPa/m", "--missing", "nan"], "JSON"),
                                ([DRY, "--input", f"{KN}=GPa/m", "--port", str(self.server.server_address[1])], "in use")]:
            said = io.StringIO()
            with contextlib.redirect_stderr(said):
                self.assertEqual(wythe.umbridge.main(arguments), 2)
            self.assertIn(word, said.getvalue())


# As Dakota 6.16 and later write them; older ones end with eval_id.
STANDARD = """                                          2 variables
                      {0:.15e} kn
                      3.300000000000000e+01 phi
                                          1 functions
                                          {1} ASV_1:{2}
                                          2 derivative_variables
                                          1 DVV_1:kn
                                          2 DVV_2:phi
                                          0 analysis_components
                                        {3} eval_id
                                          0 metadata
"""
APREPRO = """                    {{ DAKOTA_VARS     =                      2 }}
                    {{ kn              =  {0:.15e} }}
                    {{ phi             =  3.300000000000000e+01 }}
                    {{ DAKOTA_FNS      =                      1 }}
                    {{ ASV_1:{2}       =                      {1} }}
                    {{ DAKOTA_DER_VARS =                      2 }}
                    {{ DVV_1:kn        =                      1 }}
                    {{ DVV_2:phi       =                      2 }}
                    {{ DAKOTA_AN_COMPS =                      1 }}
                    {{ AC_1:python3    =                      "a b" }}
                    {{ DAKOTA_EVAL_ID  =                      {3} }}
"""


class Dakota(unittest.TestCase):
    LABELS = ["--input", f"kn={KN}=GPa/m", "--input", f"phi={PHI}=deg", "--output", f"f={PEAK}"]
    OPTIONS = ["--follow", f"{KS}=0.4*{KN}", "--follow", f"{RESIDUAL}=1*{PHI}", "--bounds", "take", "--set",
               "stage.push.until=4 mm", "--set", "stage.push.velocity=20 mm/s"]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.results = self.folder / "results.out"

    def drive(self, text, *options):
        """(exit status, what it wrote or None, what it said)."""
        (self.folder / "params.in").write_text(text)
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            status = wythe.dakota.main([DRY, *(options or self.LABELS), *self.OPTIONS, str(self.folder / "params.in"),
                                        str(self.results)])
        return status, self.results.read_text() if self.results.exists() else None, said.getvalue()

    def peak(self, stiffness):
        return wythe.Function(DRY, INPUTS, [PEAK], **WHOLE)([stiffness, 33.0])[0]

    def test_standard_and_aprepro_files(self):
        for form in (STANDARD, APREPRO):
            status, written, said = self.drive(form.format(7.56, 1, "f", 3))
            self.assertEqual((status, said), (0, ""))
            value, label = written.split()
            self.assertEqual((float(value), label), (self.peak(7.56), "f"))

    def test_json_files_and_metadata(self):
        one = {"variables": [{"label": "kn", "value": 7.56}, {"label": "phi", "value": 33}], "derivative_variables": [1, 2],
               "responses": [{"label": "f", "active_set": 1}], "analysis_components": [], "eval_id": "1",
               "metadata": [AT_PEAK]}
        status, written, said = self.drive(json.dumps(one))
        self.assertEqual((status, said), (0, ""))
        self.assertEqual([line.split()[1] for line in written.splitlines()], ["f", AT_PEAK])

    def test_a_batch_is_written_in_its_order(self):
        text = "".join(STANDARD.format(value, 1, "f", f"1:{i}") for i, value in enumerate([7.56, -1, 5.0], 1))
        status, written, said = self.drive(text)
        parts = [part.strip() for part in written.split("#\n")]
        self.assertEqual(status, 0)
        self.assertEqual(float(parts[0].split()[0]), self.peak(7.56))
        self.assertTrue(parts[1].lower().startswith("fail"))
        self.assertEqual(float(parts[2].split()[0]), self.peak(5.0))
        self.assertIn("evaluation 1:2", said)

    def test_paths_themselves_as_labels_and_words_as_values(self):
        text = (STANDARD.format(7.56, 1, PEAK, 1).replace(" kn", f" {KN}[GPa/m]").replace(" phi", f" {PHI}[deg]")
                .replace("2 variables", "3 variables").replace("1 functions", "centroid solve.rule\n 1 functions"))
        status, written, said = self.drive(text.replace("centroid solve.rule", "+x stage.push.direction"), "--output", PEAK)
        self.assertEqual((status, said), (0, ""))
        self.assertEqual(float(written.split()[0]), self.peak(7.56))

    def test_a_wall_without_an_answer_is_a_failed_evaluation(self):
        status, written, said = self.drive(STANDARD.format(-1, 1, "f", 1))
        self.assertEqual((status, written[:4]), (0, "fail"))
        self.assertIn("must be more than 0", said)

    def test_nothing_asked_gives_nothing(self):
        self.assertEqual(self.drive(STANDARD.format(7.56, 0, "f", 1)), (0, "", ""))

    def test_what_no_evaluation_could_mend_writes_no_results(self):
        good = STANDARD.format(7.56, 1, "f", 1)
        for text, options, word in [(STANDARD.format(7.56, 3, "f", 1), (), "gradient"),
                                    (good.replace("kn", "kx"), (), "kx"),
                                    (STANDARD.format(7.56, 1, "g", 1), (), "is no answer"),
                                    (good, ("--input", f"kn={KN}=kg", "--input", f"phi={PHI}=deg", "--output", f"f={PEAK}"), "kg"),
                                    (good, ("--input", "kn"), "LABEL=PATH=UNIT"),
                                    ("", (), "empty"), ("hello\n", (), "variables"), ("{", (), "Dakota"), ("[3]", (), "Dakota"),
                                    ("{}", (), "variables"), ("\n".join(good.splitlines()[:2]), (), "announced"),
                                    ("-5 variables\n" + good, (), "Dakota"), ("x variables\n", (), "Dakota")]:
            with self.subTest(word):
                status, written, said = self.drive(text, *options)
                self.assertEqual((status, written), (2, None), said)
                self.assertIn(word, said)

    def test_it_runs_as_dakota_runs_it(self):
        (self.folder / "params.in").write_text(STANDARD.format(7.56, 1, "f", 1))
        done = subprocess.run(["/usr/bin/python3", "-m", "wythe.dakota", DRY, *self.LABELS, *self.OPTIONS, "params.in",
                               "results.out"], cwd=self.folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(float(self.results.read_text().split()[0]), self.peak(7.56))
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["params.in", "results.out"])


if __name__ == "__main__":
    unittest.main()
