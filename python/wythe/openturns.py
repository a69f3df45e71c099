"""A wall as a function of OpenTURNS.

    import openturns
    import wythe.openturns
    peak = wythe.openturns.function("model.toml", {"material.joint.cohesion": "MPa"}, ["peak_reaction_kN"])
    curve = wythe.openturns.field_function("model.toml", {"material.joint.cohesion": "MPa"}, range(21))

A sample is one batch: all cores work, and the answers do not depend on how many there are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Optional, Union

from ._errors import Fault, InputError, needed_for
from ._function import Choice, Follow, Function, Missing
from ._model import ModelLike
from ._types import Settings

if TYPE_CHECKING:
    import openturns


def _titles(of: Function) -> list[str]:
    return [f"{path} [{unit}]" if unit else path for path, unit in of.inputs.items()]


def function(
    model: ModelLike,
    inputs: Mapping[str, str],
    outputs: Union[str, Sequence[str]] = ("peak_reaction_kN",),
    *,
    set: Settings = None,
    follow: Optional[Follow] = None,
    missing: Missing = "raise",
    bounds: Choice = "raise",
    rate: Choice = "raise",
    jobs: int = 0,
) -> openturns.Function:
    """An `openturns.Function`: numbers in the units of ``inputs`` to the answers ``outputs``.

    The options are those of `wythe.Function`. With ``missing="raise"`` OpenTURNS hands the exception on as a
    RuntimeError with the same text. Raises MissingPackage without OpenTURNS.
    """
    with needed_for("wythe.openturns"):
        import openturns
    of = Function(model, inputs, outputs, set=set, follow=follow, missing=missing, bounds=bounds, rate=rate, jobs=jobs)

    def point(x: Sequence[float]) -> list[float]:
        return [float(answer) for answer in of([list(x)])[0]]

    def sample(x: Sequence[Sequence[float]]) -> Union[list[list[float]], openturns.Sample]:
        rows = [list(row) for row in x]
        return [row.tolist() for row in of(rows)] if rows else openturns.Sample(0, len(of.outputs))

    made = openturns.PythonFunction(len(of.inputs), len(of.outputs), func=point, func_sample=sample)
    made.setInputDescription(_titles(of))
    made.setOutputDescription(list(of.outputs))
    return openturns.Function(made)


def field_function(
    model: ModelLike,
    inputs: Mapping[str, str],
    displacement_mm: Sequence[float],
    *,
    set: Settings = None,
    follow: Optional[Follow] = None,
    missing: Missing = "raise",
    bounds: Choice = "raise",
    rate: Choice = "raise",
    jobs: int = 0,
) -> openturns.PointToFieldFunction:
    """An `openturns.PointToFieldFunction`: numbers to the force [kN] at each displacement [mm] of a mesh.

    ``displacement_mm`` rises and lies on the curve of every wall: a wall whose curve ends before has no answer
    there. The options are those of `wythe.Function`; ``bounds`` changes nothing, for forces at stated places are none.
    """
    with needed_for("wythe.openturns"):
        import openturns
    at = [float(place) for place in displacement_mm]
    if len(at) < 2 or any(not b > a for a, b in zip(at, at[1:])):
        raise InputError([Fault(path="displacement_mm", value=str(at), problem="does not rise from place to place",
                                cure="give two or more displacements, e.g. range(21)")])
    of = Function(model, inputs, set=set, follow=follow, missing=missing, bounds=bounds, rate=rate, jobs=jobs)
    mesh = openturns.Mesh([[place] for place in at], [[i, i + 1] for i in range(len(at) - 1)])
    mesh.setDescription(["displacement [mm]"])

    class Curve(openturns.OpenTURNSPythonPointToFieldFunction):  # type: ignore[misc]
        def __init__(self) -> None:
            super().__init__(len(of.inputs), mesh, 1)
            self.setInputDescription(_titles(of))
            self.setOutputDescription(["reaction [kN]"])

        def _exec(self, x: Sequence[float]) -> list[list[float]]:
            return self._exec_sample([x])[0]

        def _exec_sample(self, x: Sequence[Sequence[float]]) -> list[list[list[float]]]:
            rows = of.curves_at([list(row) for row in x], at)
            return [[[force] for force in row.tolist()] for row in rows]

    return openturns.PointToFieldFunction(Curve())
