"""A wall as a function of OpenTURNS.

    import openturns
    import wythe.openturns
    peak = wythe.openturns.function("model.toml", {"material.joint.cohesion": "MPa"}, ["peak_reaction_kN"])
    curve = wythe.openturns.field_function("model.toml", {"material.joint.cohesion": "MPa"}, range(21))

A sample is one batch: all cores work, and the answers do not depend on how many there are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ._errors import Fault, InputError, needed
from ._calls import ModelLike
from ._function import Function


def _titles(of: Function) -> list[str]:
    return [f"{path} [{unit}]" if unit else path for path, unit in of.inputs.items()]


def function(
    model: ModelLike, inputs: Mapping[str, str], outputs: Sequence[str] = ("peak_reaction_kN",), **options: Any
) -> Any:
    """An `openturns.Function`: numbers in the units of ``inputs`` to the answers ``outputs``.

    The options are those of `wythe.Function`: ``set``, ``follow``, ``missing``, ``bounds``, ``rate``, ``jobs``.
    With ``missing="raise"`` OpenTURNS hands the exception on as a RuntimeError with the same text.
    """
    openturns = needed("openturns", "wythe.openturns")
    of = Function(model, inputs, outputs, **options)

    def point(x: Any) -> Any:
        return of([list(x)])[0].tolist()

    def sample(x: Any) -> Any:
        rows = [list(row) for row in x]
        return of(rows).tolist() if rows else openturns.Sample(0, len(of.outputs))

    made = openturns.PythonFunction(len(of.inputs), len(of.outputs), func=point, func_sample=sample)
    made.setInputDescription(_titles(of))
    made.setOutputDescription(list(of.outputs))
    return openturns.Function(made)


def field_function(
    model: ModelLike, inputs: Mapping[str, str], displacement_mm: Sequence[float], **options: Any
) -> Any:
    """An `openturns.PointToFieldFunction`: numbers to the force [kN] at each displacement [mm] of a mesh.

    ``displacement_mm`` rises and lies on the curve of every wall: a wall whose curve ends before has no answer
    there. The options are those of `wythe.Function` without ``bounds``.
    """
    openturns = needed("openturns", "wythe.openturns")
    at = [float(place) for place in displacement_mm]
    if len(at) < 2 or any(not b > a for a, b in zip(at, at[1:])):
        raise InputError([Fault(path="displacement_mm", value=str(at), problem="does not rise from place to place",
                                cure="give two or more displacements, e.g. range(21)")])
    of = Function(model, inputs, **options)
    mesh = openturns.Mesh([[place] for place in at], [[i, i + 1] for i in range(len(at) - 1)])
    mesh.setDescription(["displacement [mm]"])

    class Curve(openturns.OpenTURNSPythonPointToFieldFunction):  # type: ignore[name-defined, misc]
        def __init__(self) -> None:
            super().__init__(len(of.inputs), mesh, 1)
            self.setInputDescription(_titles(of))
            self.setOutputDescription(["reaction [kN]"])

        def _exec(self, x: Any) -> Any:
            return [[force] for force in of.curves_at([list(x)], at)[0].tolist()]

        def _exec_sample(self, x: Any) -> Any:
            rows = of.curves_at([list(row) for row in x], at)
            return [[[force] for force in row.tolist()] for row in rows]

    return openturns.PointToFieldFunction(Curve())
