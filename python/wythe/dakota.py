"""A wall as an analysis driver of Dakota: python3 -m wythe.dakota MODEL.toml params.in results.out

In Dakota's input file:

    interface
      analysis_driver 'python3 -m wythe.dakota wall.toml --input c=material.joint.cohesion=MPa --output f=peak_reaction_kN'
      fork                 (Dakota adds the names of the two files)

A variable is an input by ``--input LABEL=PATH=UNIT``, or is itself called as a path, PATH[UNIT]. A response is
an answer by ``--output LABEL=ANSWER``, or is itself called as one. Files are read in Dakota's standard, APREPRO and
JSON formats, one evaluation or a batch of them.

A wall without an answer is a failed evaluation: its results begin with "fail", and Dakota's failure_capture
decides. What no evaluation could mend (an unknown label, gradients asked for) writes no results: Dakota stops.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import os
import re
import sys
import tempfile
from collections.abc import Iterator, Sequence
from typing import Any, Optional, Union

from ._errors import AccessError, InputError, WytheError, refused
from ._function import Choice, Follow, Function, add_options, parse_follow

_APREPRO = re.compile(r"\{\s*(\S+)\s*=\s*(.*?)\s*\}")


@dataclasses.dataclass
class Evaluation:
    """What Dakota asks for once: variables by label, responses with their codes (1: the value), metadata."""

    variables: dict[str, Union[float, str]]
    responses: dict[str, int]
    metadata: list[str]
    name: str


# --- params.in -------------------------------------------------------------------------------------------


def read_parameters(text: str) -> list[Evaluation]:
    """The evaluations of a parameters file, one or a batch."""
    first = text.lstrip()[:1]
    try:
        if first in ("[", "{") and not _APREPRO.match(text.lstrip()):
            given = json.loads(text)
            return [_of_json(one) for one in (given if isinstance(given, list) else [given])]
        return list(_evaluations(_aprepro(text) if first == "{" else _standard(text)))
    except (StopIteration, RuntimeError):
        raise refused("params", "", "ends in the middle", "let Dakota write it anew") from None
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        if isinstance(error, InputError):
            raise
        raise refused("params", "", f"is no parameters file of Dakota: {error}", "let Dakota write it anew") from None


def _standard(text: str) -> Iterator[tuple[str, str]]:
    """(tag, value) of each line "value tag"; a value of text may hold blanks."""
    for line in text.splitlines():
        if line.strip():
            value, _, tag = line.strip().rpartition(" ")
            yield tag, value.strip()


def _aprepro(text: str) -> Iterator[tuple[str, str]]:
    names = {"DAKOTA_VARS": "variables", "DAKOTA_FNS": "functions", "DAKOTA_DER_VARS": "derivative_variables",
             "DAKOTA_AN_COMPS": "analysis_components", "DAKOTA_EVAL_ID": "eval_id", "DAKOTA_METADATA": "metadata"}
    for line in text.splitlines():
        if line.strip():
            match = _APREPRO.fullmatch(line.strip())
            if match is None:
                raise ValueError(line.strip())
            yield names.get(match.group(1), match.group(1)), match.group(2).strip('"')


def _evaluations(lines: Iterator[tuple[str, str]]) -> Iterator[Evaluation]:
    found: list[tuple[str, str]] = list(lines)
    place = 0

    def array(name: str) -> list[tuple[str, str]]:
        nonlocal place
        if place >= len(found) or found[place][0] != name:
            raise ValueError(f"{name} expected" + (f" where {found[place][0]} stands" if place < len(found) else ""))
        size = int(found[place][1])
        rows = found[place + 1 : place + 1 + size]
        if len(rows) != size:
            raise ValueError(f"{size} {name} are announced, {len(rows)} are there")
        place += 1 + size
        return rows

    if not found:
        raise ValueError("it is empty")
    while place < len(found):
        variables = {tag: _number_or_text(value) for tag, value in array("variables")}
        responses = {tag.partition(":")[2] or tag: int(value) for tag, value in array("functions")}
        array("derivative_variables")
        array("analysis_components")
        name = ""
        if place < len(found) and found[place][0] == "eval_id":
            name = found[place][1]
            place += 1
        metadata = []
        if place < len(found) and found[place][0] == "metadata":
            metadata = [value for _, value in array("metadata")]
        yield Evaluation(variables, responses, metadata, name)


def _of_json(one: dict[str, Any]) -> Evaluation:
    return Evaluation(
        {row["label"]: row["value"] if isinstance(row["value"], str) else float(row["value"]) for row in one["variables"]},
        {row["label"]: int(row["active_set"]) for row in one["responses"]},
        [str(name) for name in one.get("metadata", [])],
        str(one.get("eval_id", "")),
    )


def _number_or_text(value: str) -> Union[float, str]:
    try:
        return float(value)
    except ValueError:
        return value


# --- labels ----------------------------------------------------------------------------------------------


@dataclasses.dataclass
class Labels:
    """Which key a variable is, and which answer a response."""

    inputs: dict[str, tuple[str, str]]  # label: (path, unit)
    outputs: dict[str, str]  # label: answer

    def input(self, label: str) -> tuple[str, str]:
        if label in self.inputs:
            return self.inputs[label]
        if "." not in label:
            raise refused("variable", label, "stands for no key of the model",
                          f"write --input {label}=PATH=UNIT, e.g. --input {label}=material.joint.cohesion=MPa")
        path, _, unit = label.partition("[")
        return path, unit.rstrip("]")

    def output(self, label: str) -> str:
        return self.outputs.get(label, label)


def _labels(inputs: Sequence[str], outputs: Sequence[str]) -> Labels:
    found = Labels({}, {})
    for text in inputs:
        parts = text.split("=")
        if len(parts) not in (2, 3):
            raise refused("--input", text, "is not understood", "write LABEL=PATH=UNIT, e.g. c=material.joint.cohesion=MPa")
        label, path, unit = parts if len(parts) == 3 else (parts[0], parts[0], parts[1])
        found.inputs[label] = (path, unit)
    for text in outputs:
        label, _, answer = text.partition("=")
        found.outputs[label] = answer or label
    return found


# --- results.out -----------------------------------------------------------------------------------------


def evaluate(
    model: str,
    asked: Sequence[Evaluation],
    labels: Labels,
    *,
    set: Sequence[str] = (),
    follow: Optional[Follow] = None,
    bounds: Choice = "raise",
    rate: Choice = "raise",
    jobs: int = 0,
) -> list[str]:
    """The results of each evaluation, as Dakota reads them. The options are those of `wythe.Function`."""
    for one in asked:
        for label, code in one.responses.items():
            if code & 6:
                raise refused(f"response {label}", code, "asks for a gradient or a Hessian, which wythe does not have",
                              "write no_gradients or numerical_gradients, and no_hessians")
    results: list[str] = [""] * len(asked)
    alike: dict[tuple[Any, ...], list[int]] = {}  # rows that differ in numbers alone run as one batch
    for number, one in enumerate(asked):
        texts = tuple((label, value) for label, value in one.variables.items() if isinstance(value, str))
        answers = tuple(labels.output(label) for label, code in one.responses.items() if code)
        alike.setdefault((texts, answers, tuple(one.metadata), tuple(one.variables)), []).append(number)
    for (texts, answers, metadata, names), rows in alike.items():
        wanted = tuple(dict.fromkeys([*answers, *(labels.output(name) for name in metadata)]))
        if not wanted:
            continue
        changes = [*set, *(f"{labels.input(label)[0]}={value}" for label, value in texts)]
        numeric = [label for label in names if isinstance(asked[rows[0]].variables[label], float)]
        function = Function(model, dict(labels.input(label) for label in numeric), wanted,
                            set=changes, follow=follow, bounds=bounds, rate=rate, jobs=jobs)
        values, batch = function.evaluate([[asked[row].variables[label] for label in numeric] for row in rows])
        for place, row in enumerate(rows):
            if (values[place] != values[place]).any():
                why = function.why(batch, place)
                print(f"evaluation {asked[row].name}: {why}", file=sys.stderr)
                results[row] = f"fail {why.splitlines()[0]}\n"
                continue
            of = dict(zip(wanted, values[place].tolist()))
            lines = [(of[labels.output(label)], label) for label, code in asked[row].responses.items() if code]
            lines += [(of[labels.output(name)], name) for name in metadata]
            results[row] = "".join(f"{value:.17g} {label}\n" for value, label in lines)
    return results


def _write(path: str, text: str) -> None:
    """Writes a file at once: Dakota may look for it at any moment."""
    folder = os.path.dirname(path) or "."
    try:
        with tempfile.NamedTemporaryFile("w", dir=folder, prefix=".wythe-", delete=False) as file:
            file.write(text)
        os.replace(file.name, path)
    except OSError as error:
        raise AccessError(f"{path}: {error.strerror}") from error


def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="python3 -m wythe.dakota", description="a wall as an analysis driver of Dakota")
    parser.add_argument("model", help="model file")
    parser.add_argument("parameters", help="file of parameters, which Dakota writes")
    parser.add_argument("results", help="file of results, which Dakota reads")
    parser.add_argument("--input", action="append", default=[], metavar="LABEL=PATH=UNIT", help="which key a variable is")
    parser.add_argument("--output", action="append", default=[], metavar="LABEL=ANSWER", help="which answer a response is")
    add_options(parser)
    given = parser.parse_intermixed_args(arguments)
    try:
        try:
            with open(given.parameters, encoding="utf-8") as file:
                text = file.read()
        except OSError as error:
            raise AccessError(f"{given.parameters}: {error.strerror}") from error
        asked = read_parameters(text)
        results = evaluate(given.model, asked, _labels(given.input, given.output), set=given.set,
                           follow=parse_follow(given.follow), bounds=given.bounds, rate=given.rate, jobs=given.jobs)
        _write(given.results, "#\n".join(results))
    except (WytheError, UnicodeDecodeError) as error:
        print(error, file=sys.stderr)
        return 4 if isinstance(error, AccessError) else 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
