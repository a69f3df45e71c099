#!/usr/bin/python3
"""The types of answers (wythe.answers) are those of the engine and of the reference, and a type checker finds mistakes with them."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import typing
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(BUILD / "python"))
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(BUILD / "python")}

import wythe  # noqa: E402
from wythe import answers  # noqa: E402

PIER = str(SOURCE / "examples/brick_pier/model.toml")


def misfits(value, kind, place=""):
    """What of a value is not of its type."""
    origin, inner = typing.get_origin(kind), typing.get_args(kind)
    if origin is typing.Union:
        return [] if any(not misfits(value, one) for one in inner) else [place]
    if origin in (typing.Required, typing.NotRequired):
        return misfits(value, inner[0], place)
    if typing.is_typeddict(kind):
        if not isinstance(value, dict) or not kind.__required_keys__ <= value.keys() <= set(kind.__annotations__):
            return [place]
        hints = typing.get_type_hints(kind)
        return [wrong for key in value for wrong in misfits(value[key], hints[key], f"{place}.{key}")]
    if origin is list:
        return [wrong for one in value for wrong in misfits(one, inner[0], place + "[]")] if isinstance(value, list) else [place]
    if origin is dict:
        return [wrong for one in value.values() for wrong in misfits(one, inner[1], place + ".*")] if isinstance(value, dict) else [place]
    kinds = {float: (int, float)}.get(kind, kind)
    return [] if isinstance(value, kinds) and (kind in (bool, object) or not isinstance(value, bool)) else [place]


class Types(unittest.TestCase):
    maxDiff = None

    def test_they_are_what_the_engine_answers(self):
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder, "answers.py")
            subprocess.run(["/usr/bin/python3", SOURCE / "tools/answer_types", made], check=True, env=ENVIRONMENT)
            self.assertEqual((SOURCE / "python/wythe/answers.py").read_text(), made.read_text(), "make docs writes it anew")

    def test_other_answers_fit(self):
        run = wythe.run(PIER, set={"stage.push.until": "0.3 mm"}, progress=False)
        self.assertEqual(misfits(run.summary, answers.Summary), [])
        self.assertEqual(misfits(wythe.check(PIER).facts, answers.CheckFacts), [])
        self.assertEqual(misfits(wythe.limit(PIER, only="lp", progress=False).mechanisms, answers.Mechanisms), [])
        self.assertEqual([misfits(key, answers.Key) for key in wythe.keys().values() if misfits(key, answers.Key)], [])

    def test_a_misfit_is_seen(self):
        facts = wythe.check(PIER).facts
        self.assertEqual(misfits({**facts, "blocks": 1.5}, answers.CheckFacts), [".blocks"])
        self.assertEqual(misfits({**facts, "more": 1}, answers.CheckFacts), [""])
        self.assertEqual(misfits({**facts, "notes": [3]}, answers.CheckFacts), [".notes[]"])

    def test_the_reference_has_the_same_keys(self):
        for kind, page, table in ((answers.Summary, "results", "## summary.json"), (answers.Statistics, "statistics", "# statistics.json"),
                                  (answers.Mechanisms, "limit", "## mechanisms.json")):
            text = (SOURCE / f"docs/reference/{page}.md").read_text(encoding="utf-8")
            rows = re.search(r"^\| key \|.*\n\|[-|]+\n((?:\|.*\n)+)", text[text.index(table):], re.M)[1]
            cells = [row.split("|")[1] for row in rows.splitlines()]
            said = {re.split(r"[.\[]", name)[0] for cell in cells if "…" not in cell and "–" not in cell
                    for name in re.findall("`(.+?)`", cell)}
            keys = {key for key in kind.__annotations__ if not key.endswith("_message")}
            self.assertEqual(said - keys, set(), page)
            self.assertEqual({key for key in keys if not re.search(rf"`{key}[`.\[]", text)}, set(), page)


# A line with "# " is a slip, and what a checker says of it.
PROGRAM = """
from typing import Optional
import wythe
from numpy import float64
from numpy.typing import NDArray
COHESION = "material.joint.cohesion"
run = wythe.run("model.toml", set={"wall.length": (5, "m"), "stage.push.until": "3 mm"}, threads=2)
peak: Optional[float] = run.summary["peak_reaction_kN"]
run.summary["peak_reaction_N"]  # has no key
strong: float = run.summary["peak_reaction_kN"]  # Incompatible types
force: NDArray[float64] = run.curve["reaction_kN"]
batch = wythe.run_many("model.toml", {COHESION: ([0.1, 0.2], "MPa")}, curves=True)
forces: NDArray[float64] = batch.curves_at([1, 2])
campaign = wythe.open_campaign("out")
again: wythe.Result = campaign.replay(3, out="sample")
campaign.replay(3, jobs=1)  # Unexpected keyword
weight: float = wythe.check(wythe.Model.read("model.toml"))["weight_kN"]
strength = wythe.Function("model.toml", {COHESION: "MPa"}, bounds="take")
answer: NDArray[float64] = strength([[0.1]])
wythe.Function("model.toml", {COHESION: "MPa"}, bounds="takes")  # incompatible type
"""


class Checked(unittest.TestCase):
    def test_a_checker_passes_what_is_right_and_finds_slips(self):
        done = subprocess.run(["mypy", "--strict", "--ignore-missing-imports", "-c", PROGRAM], cwd=SOURCE / "python", capture_output=True, text=True, check=False)
        found = {int(line.split(":")[1]): line for line in done.stdout.splitlines() if ": error:" in line}
        slips = {number: line.split("# ")[1] for number, line in enumerate(PROGRAM.splitlines(), 1) if "# " in line}
        self.assertEqual(found.keys(), slips.keys(), done.stdout)
        for number, said in slips.items():
            self.assertIn(said, found[number])

    def test_no_public_name_is_of_any_type(self):
        loose = [line for path in (SOURCE / "python/wythe").glob("*.py") if path.name != "_jobs.py"
                 for line in path.read_text().splitlines()
                 if re.search(r"\bAny\b", line) and re.match(r"    def [a-z]|def [a-z]|        self\.[a-z]", line)]
        self.assertEqual(loose, [])


if __name__ == "__main__":
    unittest.main()
