"""A wall as a function of numbers: what OpenTURNS, UM-Bridge and Dakota call, and any tool of your own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Literal, Optional, Protocol, TypeAlias, Union

from ._calls import run_many
from ._errors import NoAnswer, names_of, needed_for, refused
from ._model import Model, ModelLike
from ._results import Batch
from ._types import Floats, Settings

if TYPE_CHECKING:
    from argparse import ArgumentParser

    from numpy.typing import ArrayLike

#: answers that may be lower bounds, and the flag that says so in a row
_FLAG = {
    "peak_reaction_kN": "censored_peak",
    "peak_raw_kN": "censored_peak",
    "displacement_at_peak_raw_mm": "censored_peak",
    "displacement_at_peak_mm": "censored_peak",
    "drift_at_peak_percent": "censored_peak",
    "displacement_at_80_percent_mm": "censored_80",
    "drift_at_80_of_peak_percent": "censored_80",
    "displacement_max_mm": "censored_max",
    "drift_max_percent": "censored_max",
    "collapse_displacement_mm": "censored_collapse",
}
_ENDED = ("completed", "collapsed")
#: judgements of a push whose numbers are not those of a slow one
_DOUBTFUL = ("too fast", "unknown")


Missing: TypeAlias = Union[float, Literal["raise"]]
Choice: TypeAlias = Literal["raise", "take"]
#: {path: (factor, input)}
Follow: TypeAlias = Mapping[str, tuple[float, str]]


class Rows(Protocol):
    """What a Function reads of a Batch."""

    @property
    def status(self) -> Sequence[str]: ...
    @property
    def reason(self) -> Sequence[Optional[str]]: ...
    @property
    def rate_judgement(self) -> Sequence[Optional[str]]: ...
    @property
    def answers(self) -> Mapping[str, Floats]: ...


class Function:
    """Numbers in, numbers out: f(rows of inputs) = rows of answers, one `run_many` for all rows.

    ``inputs`` maps the path of a key to the unit of its numbers ("" where it has none), in the order of the
    columns; ``outputs`` names columns of ``Batch.answers``. ``follow`` holds keys that go with an input:
    ``{"material.joint.shear_stiffness": (0.4, "material.joint.normal_stiffness")}`` is 0.4 of it, in its unit.

    What has no answer (a wall that is refused, does not settle, or has no such value) raises NoAnswer with
    ``missing="raise"``, whose ``.answers`` has the other rows; a number is taken in its place. A displacement
    that is only a lower bound because the push ended before, or a peak that was still rising, counts as no answer with ``bounds="raise"``, and as the
    answer with ``bounds="take"``. A push that was too fast, or whose energy does not close (``rate_judgement``),
    counts as no answer with ``rate="raise"``, and as the answer with ``rate="take"``.

    ``jobs`` is the number of cores for rows side by side, 0 all.

    The model is read once: changes of its file or of the Model do not reach a Function.
    """

    def __init__(
        self,
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
    ):
        self.inputs: dict[str, str] = _units(inputs)
        self.outputs: tuple[str, ...] = tuple(names_of("outputs", outputs))
        self.follow: dict[str, tuple[float, str]] = _followers(follow or {}, self.inputs)
        self.missing: Optional[float] = _number_or_raise(missing)
        if bounds not in ("raise", "take"):
            raise refused("bounds", bounds, "is no such choice", 'write "raise" or "take"')
        if rate not in ("raise", "take"):
            raise refused("rate", rate, "is no such choice", 'write "raise" or "take"')
        self.take_bounds = bounds == "take"
        self.take_fast = rate == "take"
        self._model = model.copy() if isinstance(model, Model) else Model.read(model)
        self._set, self._jobs = set, jobs
        known = self._run([]).answers.columns  # no wall is run; paths, units and the model are checked
        for name in self.outputs:
            if name not in known:
                raise refused("outputs", name, "is no answer of a row", "the answers are " + ", ".join(known))
        if not self.outputs:
            raise refused("outputs", "", "names nothing", "the answers are " + ", ".join(known))

    def _run(self, rows: ArrayLike, curves: bool = False) -> Batch:
        with needed_for("a function of a wall"):
            import numpy
        matrix = numpy.asarray(rows, dtype=float).reshape(-1, len(self.inputs))
        columns = {path: (matrix[:, i], unit) for i, (path, unit) in enumerate(self.inputs.items())}
        for path, (factor, leader) in self.follow.items():
            values, unit = columns[leader]
            columns[path] = (factor * values, unit)
        return run_many(self._model, columns, set=self._set, jobs=self._jobs, curves=curves, progress=False)

    def rows_of(self, points: ArrayLike) -> Floats:
        """The points as a matrix (rows, inputs); InputError where they are none."""
        with needed_for("a function of a wall"):
            import numpy
        try:
            matrix: Floats = numpy.asarray(points, dtype=float)
        except (TypeError, ValueError):
            raise refused("inputs", type(points).__name__, "are no numbers", "give rows of numbers") from None
        if matrix.ndim != 2 or matrix.shape[1] != len(self.inputs):
            raise refused("inputs", f"shape {matrix.shape}", f"do not fit the {len(self.inputs)} inputs",
                          "the columns are " + ", ".join(self.inputs))
        return matrix

    def evaluate(self, points: ArrayLike) -> tuple[Floats, Batch]:
        """Answers (rows, outputs), NaN where a row has none whatever ``missing`` says; and the batch behind them."""
        with needed_for("a function of a wall"):
            import numpy
        batch = self._run(self.rows_of(points))
        answers: Floats = numpy.column_stack([numpy.array(batch.answers[name]) for name in self.outputs])
        answers[[status not in _ENDED for status in batch.status]] = numpy.nan
        answers[self._doubtful(batch)] = numpy.nan
        for column, name in enumerate(self.outputs):
            if name in _FLAG and not self.take_bounds:
                answers[batch.answers[_FLAG[name]] == 1, column] = numpy.nan
        return answers, batch

    def _doubtful(self, batch: Rows) -> list[bool]:
        return [not self.take_fast and judgement in _DOUBTFUL for judgement in batch.rate_judgement]

    def why(self, batch: Rows, row: int) -> str:
        """Why a row has no answer."""
        if batch.status[row] not in _ENDED:
            return f"{batch.status[row] or 'not run'}: {batch.reason[row] or 'no reason was given'}"
        if self._doubtful(batch)[row]:
            return (f"its push is judged \"{batch.rate_judgement[row]}\": the numbers are not those of a slow one; "
                    "push slower, or rate='take'")
        bounds = [name for name in self.outputs if name in _FLAG and batch.answers[_FLAG[name]][row] == 1]
        if bounds and not self.take_bounds:
            return f"{', '.join(bounds)}: only a lower bound, the push ended before; push farther, or bounds='take'"
        absent = [name for name in self.outputs if batch.answers[name][row] != batch.answers[name][row]]
        return f"{', '.join(absent)}: the run has no such value"

    def fill(self, answers: Floats, batch: Rows) -> Floats:
        """The answers (rows, outputs) with ``missing`` where a row has none; raises NoAnswer where that is "raise"."""
        with needed_for("a function of a wall"):
            import numpy
        empty = numpy.isnan(answers)
        if empty.any() and self.missing is None:
            rows = [int(row) for row in numpy.flatnonzero(empty.any(axis=1))]
            raise NoAnswer({row: self.why(batch, row) for row in rows}, answers)
        answers[empty] = numpy.nan if self.missing is None else self.missing
        return answers

    def __call__(self, points: ArrayLike) -> Floats:
        """Answers (rows, outputs) to points (rows, inputs); one point gives one row without the first axis."""
        with needed_for("a function of a wall"):
            import numpy
        if numpy.ndim(points) == 1:
            row: Floats = self(numpy.asarray(points)[numpy.newaxis])[0]
            return row
        return self.fill(*self.evaluate(points))

    def curves_at(self, points: ArrayLike, displacement_mm: ArrayLike) -> Floats:
        """Reactions [kN] (rows, displacements) at the same displacements [mm] for every row.

        A curve that ends before a displacement has no answer there: it raises NoAnswer, or gives ``missing``.
        """
        with needed_for("a function of a wall"):
            import numpy
        batch = self._run(self.rows_of(points), curves=True)
        at = numpy.asarray(displacement_mm, dtype=float)
        table = batch.curves_at(at)
        doubtful = self._doubtful(batch)
        table[doubtful] = numpy.nan
        empty = numpy.isnan(table)
        if empty.any() and self.missing is None:
            ends = [float(numpy.max(batch.curve(row)["displacement_mm"], initial=0)) for row in range(len(batch))]
            raise NoAnswer({
                int(row): self.why(batch, int(row)) if doubtful[row] else
                f"{batch.status[row]}: {batch.reason[row] or f'the curve ends at {ends[row]:.4g} mm'}"
                for row in numpy.flatnonzero(empty.any(axis=1))
            }, table)
        table[empty] = numpy.nan if self.missing is None else self.missing
        return table

    def __repr__(self) -> str:
        named = ", ".join(f"{path} [{unit}]" if unit else path for path, unit in self.inputs.items())
        return f"<function of {named}: {', '.join(self.outputs)}>"


def _units(inputs: Mapping[str, str]) -> dict[str, str]:
    if not isinstance(inputs, Mapping) or not inputs:
        raise refused("inputs", type(inputs).__name__, "name no inputs", 'write {"material.joint.cohesion": "MPa"}')
    for path, unit in inputs.items():
        if not isinstance(path, str) or not isinstance(unit, str):
            raise refused(f"inputs[{path!r}]", unit, "is no unit", 'write its unit as text, "" where it has none')
    return dict(inputs)


def _followers(follow: Follow, inputs: Mapping[str, str]) -> dict[str, tuple[float, str]]:
    for path, pair in follow.items():
        if not isinstance(pair, tuple) or len(pair) != 2 or not isinstance(pair[0], (int, float)):
            raise refused(f"follow[{path!r}]", pair, "is no factor with an input", 'write (0.4, "path of an input")')
        if pair[1] not in inputs:
            raise refused(f"follow[{path!r}]", pair[1], "is no input", "the inputs are " + ", ".join(inputs))
        if path in inputs:
            raise refused(f"follow[{path!r}]", path, "is an input itself", "leave it out of one of them")
    return {path: (float(factor), leader) for path, (factor, leader) in follow.items()}


def _number_or_raise(missing: Missing) -> Optional[float]:
    if missing == "raise":
        return None
    try:
        if not isinstance(missing, (str, bytes, bool)):
            return float(missing)
    except (TypeError, ValueError, OverflowError):
        pass
    raise refused("missing", missing, "is no such choice", 'write "raise", or the number to take instead')


# --- the same from a command line ------------------------------------------------------------------------


def add_options(parser: ArgumentParser) -> None:
    """The options by which a command names inputs and answers."""
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="change the model, as `wythe run --set`")
    parser.add_argument("--follow", action="append", default=[], metavar="PATH=FACTOR*INPUT",
                        help="a key that goes with an input, by a factor, in its unit")
    parser.add_argument("--bounds", choices=["raise", "take"], default="raise",
                        help="a value that is only a lower bound: no answer, or the answer")
    parser.add_argument("--rate", choices=["raise", "take"], default="raise",
                        help="a push that was too fast, or whose energy does not close: no answer, or the answer")
    parser.add_argument("--jobs", type=int, default=0, help="cores; 0: all")


def parse_follow(texts: Sequence[str]) -> dict[str, tuple[float, str]]:
    """"PATH=FACTOR*INPUT" of each text."""
    found = {}
    for text in texts:
        path, _, rest = text.partition("=")
        factor, _, leader = rest.partition("*")
        try:
            found[path] = (float(factor), leader)
        except ValueError:
            raise refused("--follow", text, "is not understood",
                          "write PATH=FACTOR*INPUT, e.g. material.joint.shear_stiffness=0.4*material.joint.normal_stiffness"
                          ) from None
    return found
