"""What the calls answer: results of a run, a batch, a campaign, a second opinion."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal, Optional, Union, cast, overload

from . import plot
from ._errors import Fault, InputError, folder_of, needed_for, path_of, refused, write_text
from ._jobs import Job, Table, perform
from ._types import Floats, Language, Path, Progress
from .plot import number

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike
    from pandas import DataFrame

    from .answers import CheckFacts, Mechanisms, Outcome, Replay, Statistics, Summary


def _whole(name: str, value: float) -> int:
    """The number of a row or sample; a text or a fraction is none."""
    try:
        if not isinstance(value, (str, bytes)) and value == int(value):
            return int(value)
    except (TypeError, ValueError, OverflowError):
        pass
    raise refused(name, f"{value!r:.60}", "is no whole number", "write a number, without quotes")


def _word(value: Optional[str]) -> str:
    return value or "not known"


class State:
    """The wall at one moment of a run."""

    def __init__(self, job: Job, number: int, label: str, displacement_mm: float, reaction_kN: float):
        self._job, self._number = job, number
        #: "start of push", "peak", "20 mm", "end"
        self.label = label
        #: of the push [mm]
        self.displacement_mm = displacement_mm
        #: against the push [kN]
        self.reaction_kN = reaction_kN

    @property
    def blocks(self) -> Table:
        """A row a block: where it was, how far it went, how far it turned."""
        return self._job.table(f"state {self._number} blocks")

    @property
    def joints(self) -> Table:
        """A row a joint: place, opening, slip, damage, stresses and forces."""
        return self._job.table(f"state {self._number} joints")

    @property
    def svg(self) -> str:
        """A picture of the wall as an SVG document; empty for walls in space."""
        return self._job.text(f"state {self._number} svg") or ""

    def save_compas(self, path: Path) -> None:
        """Writes the blocks as they stand here as a COMPAS assembly (JSON): metres, z up, a mesh a block."""
        write_text(path, self._job.text(f"state {self._number} compas") or "")

    def _repr_html_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<state {self.label!r}: {self.displacement_mm:.4g} mm, {self.reaction_kN:.4g} kN>"


class Result:
    """A run: its numbers, curve and states."""

    def __init__(self, job: Job):
        self._job = job
        #: the keys of summary.json (docs/reference/results.md)
        self.summary: Summary = job.json("summary")
        #: the rows of force_displacement.csv
        self.curve: Table = job.table("curve")
        #: the rows of history.csv, of a wall that was shaken; else None
        self.history: Optional[Table] = job.table_or_none("history")
        #: the states that the run kept, in order of time
        self.states: list[State] = [State(job, k, **row) for k, row in enumerate(job.json("states"))]
        #: of a replay: whether it equals the stored sample, and the sample's settings
        self.replay: Optional[Replay] = job.json("replay")

    @property
    def status(self) -> str:
        """"completed", "collapsed", "interrupted", "not_settled", "unstable" or "budget_spent"."""
        return self.summary["status"]

    @property
    def model(self) -> str:
        """The model as it was run, every default written out (model.used.toml)."""
        return self._job.text("model") or ""

    @property
    def block_ids(self) -> list[str]:
        """The names of the blocks, in the order of the rows of ``state.blocks``."""
        ids: list[str] = self._job.json("block_ids")
        return ids

    @property
    def page(self) -> str:
        """The report of the run as one HTML page."""
        return self._job.text("page") or ""

    def save_page(self, path: Path) -> None:
        """Writes the report of the run as one HTML page."""
        write_text(path, self.page)

    def plot(self, axes: Optional[Axes] = None) -> Axes:
        """The curve on matplotlib's axes, which it gives back: `wythe.plot.curve`."""
        return plot.curve(self.curve, axes)

    def _capacity(self) -> str:
        s = self.summary
        bound = "at least " if s.get("censored_peak") else ""
        factor = [f"load factor {number(s['load_factor'])}"] if s.get("load_factor") else []
        if s.get("peak_reaction_kN"):
            at = s.get("displacement_at_peak_mm")
            force = number(s["peak_reaction_kN"], unit=" kN") + ("" if at is None else f" at {number(at, unit=' mm')}")
            return bound + ", ".join([*factor, force])
        if factor:
            return bound + factor[0]
        if s.get("peak_reaction_kN") == 0:
            return "not asked for: nothing pushed the wall"
        return "not known" + (f": {s['peak_reason']}" if s.get("peak_reason") else "")

    def _answer(self) -> list[tuple[str, str]]:
        """What the run says of the wall: of one that was shaken alone, how it stands, and no capacity."""
        shaken = self.summary["shaking"]["sentence"] if "shaking" in self.summary else ""
        said = [("shaking", shaken)] if shaken else []
        if said and self.summary["peak_reaction_kN"] == 0:
            return said
        return [*said, ("capacity", self._capacity()), ("failure mode", _word(self.summary["failure_mode"]["name"]))]

    def _facts(self) -> list[tuple[str, str]]:
        s, rate = self.summary, self.summary["quasi_static"]
        said = [("warning", s["warning"]), ("status", self.status), ("reason", s["reason"])]
        after = [("displacement", rate["displacement"]), ("failure mode", rate["mode"])]
        return [
            *((name, words) for name, words in said if words),
            *self._answer(),
            ("rate", _word(rate["verdict"])),
            *((f"rate, {name}", f"not known: {of['reason']}") for name, of in after if of["verdict"] == "not known"),
        ]

    def _repr_html_(self) -> str:
        svg = self.states[-1].svg if self.states else ""
        return plot.side_by_side(plot.rows_html(self._facts()), plot.curve_svg(self.curve), svg)

    def __repr__(self) -> str:
        return "<run: " + "; ".join(f"{name} {value}" for name, value in self._facts()) + ">"


class Check:
    """What `wythe check` says of a model."""

    def __init__(self, job: Job):
        self._job = job
        #: blocks, joints, points, weight_kN, time_step_s, steps, expected_seconds, notes, ...
        self.facts: CheckFacts = job.json("check")

    @property
    def model(self) -> str:
        """The model with every default written out."""
        return self._job.text("model") or ""

    @property
    def svg(self) -> str:
        """A picture of the wall as an SVG document; empty for walls in space."""
        return self._job.text("svg") or ""

    @overload
    def __getitem__(self, name: Literal["notes"]) -> list[str]: ...  # type: ignore[misc]
    @overload
    def __getitem__(self, name: str) -> float: ...
    def __getitem__(self, name: str) -> Union[float, list[str]]:
        """One of the facts."""
        return cast(Mapping[str, Union[float, list[str]]], self.facts)[name]

    def _repr_html_(self) -> str:
        f = self.facts
        rows = [
            ("blocks", str(f["blocks"])),
            ("joints", str(f["joints"])),
            ("weight", number(f["weight_kN"], unit=" kN")),
            ("size", f"{number(f['length_m'])} x {number(f['height_m'])} x {number(f['thickness_m'])} m"),
            ("expected time", number(f["expected_seconds"], 2, " s")),
            *(("note", str(note)) for note in f["notes"]),
        ]
        return plot.side_by_side(plot.rows_html(rows), self.svg)

    def __repr__(self) -> str:
        f = self.facts
        return (f"<check: {f['blocks']} blocks, {f['joints']} joints, {number(f['weight_kN'], unit=' kN')}, "
                f"about {number(f['expected_seconds'], 2, ' s')}; {len(f['notes'])} notes>")


class _Rows:
    """What rows say of themselves, in their order, and their answers."""

    def __init__(self, job: Job):
        rows = job.json("rows")
        #: numbers, a row each; NaN where a row has no answer
        self.answers: Table = job.table("answers")
        #: "completed", "collapsed", "refused", "unstable", ...; "" where the call was stopped before
        self.status: list[str] = [row["status"] for row in rows]
        #: the failure mode of each row; None where a row has no answer
        self.failure_mode: list[Optional[str]] = [row.get("failure_mode") for row in rows]
        #: why a row has no answer, no capacity or no initial stiffness, or why it ended; None where there is nothing to say
        self.reason: list[Optional[str]] = [row.get("reason") for row in rows]
        #: how nearly static each push was: "slow enough", "usable", "too fast", "unknown"; None where a row has no answer
        self.rate_judgement: list[Optional[str]] = [row.get("rate_judgement") for row in rows]
        #: the hash of each wall's last state: equal hashes are equal results
        self.state_hash: list[str] = [row["state_hash"] for row in rows]

    def __len__(self) -> int:
        return len(self.status)

    def _with_words(self, frame: DataFrame) -> DataFrame:
        """What rows say of themselves stands beside their numbers: NaN never comes without a word."""
        for name in ("status", "failure_mode", "reason", "rate_judgement"):
            frame[name] = getattr(self, name)
        for name in self.answers:
            frame[name] = self.answers[name]
        return frame

    def _capacities(self) -> dict[int, tuple[float, bool]]:
        """Each row's capacity [kN], and whether it is a lower bound; a row without one is left out."""
        peaks, bounds = self.answers.numbers("peak_reaction_kN"), self.answers.numbers("censored_peak")
        return {row: (peak, bound == 1) for row, (peak, bound) in enumerate(zip(peaks, bounds)) if peak > 0}

    def _counts(self) -> str:
        """"5 completed (2 without a capacity, 1 with a lower bound of it), 1 refused"."""
        capacities = self._capacities()
        words = []
        for status in dict.fromkeys(self.status):
            places = [row for row, own in enumerate(self.status) if own == status]
            ended = places if status in ("completed", "collapsed") else []
            bare = sum(row not in capacities for row in ended)
            bounds = sum(capacities[row][1] for row in ended if row in capacities)
            inner = [*([f"{bare} without a capacity"] if bare else []),
                     *([f"{bounds} with a lower bound of it" if bare else f"{bounds} with a lower bound of the capacity"]
                       if bounds else [])]
            words.append(f"{len(places)} {status or 'not run'}" + (f" ({', '.join(inner)})" if inner else ""))
        return ", ".join(words)


def _curve_of(curves: Table, row: int) -> dict[str, Floats]:
    """The curve of a row, out of the curves of all."""
    first, last = curves["row"].searchsorted([row, row + 1])
    return {name: curves[name][first:last] for name in curves if name != "row"}


class Batch(_Rows):
    """Answers to rows of inputs, in the order of the rows."""

    def __init__(self, job: Job, inputs: dict[str, Floats], units: dict[str, str]):
        super().__init__(job)
        #: the inputs as they were given
        self.inputs = inputs
        #: the unit of each input, "" where it has none
        self.units = units
        self._curves = job.table_or_none("curves")

    @property
    def done(self) -> bool:
        """Whether every row has an answer."""
        return all(status in ("completed", "collapsed") for status in self.status)

    def curve(self, row: int) -> dict[str, Floats]:
        """The curve of a row, its columns as in ``Result.curve``; the batch has to be asked with curves=True."""
        if self._curves is None:
            raise InputError([Fault(path="curve", problem="the curves were not asked for",
                                    cure="call run_many(..., curves=True)")])
        return _curve_of(self._curves, range(len(self))[_whole("row", row)])

    def curves_at(self, displacement_mm: ArrayLike) -> Floats:
        """Reactions [kN] of all rows at the same displacements [mm]: (rows, displacements), NaN off a curve.

        Raises InputError where a curve goes back, or ``displacement_mm`` is no flat list.
        """
        with needed_for("curves_at()"):
            import numpy
        try:
            at = numpy.asarray(displacement_mm, dtype=float)
        except (TypeError, ValueError):
            at = numpy.empty((0, 0))
        if at.ndim != 1:
            raise refused("displacement_mm", f"{displacement_mm!r:.60}", "is no list of displacements",
                          "give a flat list of numbers [mm]")
        table = numpy.full((len(self), len(at)), numpy.nan)
        for row in range(len(self)):
            curve = self.curve(row)
            if self.status[row] not in ("completed", "collapsed") or len(curve["displacement_mm"]) < 2:
                continue
            if (numpy.diff(curve["displacement_mm"]) < 0).any():
                raise refused("curves_at", f"row {row}", "goes back: at one displacement it has several forces",
                              "take the whole curve: batch.curve(row)")
            table[row] = numpy.interp(
                at, curve["displacement_mm"], curve["reaction_kN"], left=numpy.nan, right=numpy.nan
            )
        return table

    def frame(self) -> DataFrame:
        """Inputs, what each row says of itself (status, failure_mode, reason, rate_judgement), and answers as a
        pandas DataFrame.

        A row that ended well may still have no capacity: then ``reason`` says why.
        """
        with needed_for("frame()"):
            from pandas import DataFrame
        titles = {name: f"{name} [{self.units[name]}]" if self.units[name] else name for name in self.inputs}
        return self._with_words(DataFrame({titles[name]: values for name, values in self.inputs.items()}))

    def __repr__(self) -> str:
        return f"<batch of {len(self)}: {self._counts()}>"


def replay(
    folder: Path,
    sample: int,
    *,
    out: Optional[Path] = None,
    threads: int = 1,
    progress: Progress = None,
    replace: bool = False,
    language: Language = "en",
) -> Result:
    """Runs one sample of a campaign again, with all its states. ``threads`` as of ``run``.

    ``.replay["equal"]`` of the result says whether the bits are the same.
    """
    texts = {"folder": path_of("folder", folder), "out": folder_of(out), "language": language}
    numbers = {"sample": sample, "threads": threads, "replace": replace}
    return perform("replay", Result, texts, numbers, progress=progress)


class Campaign(_Rows):
    """A campaign in its folder: samples, statistics, page."""

    def __init__(self, job: Job, folder: str):
        super().__init__(job)
        self._job = job
        #: where campaign.db, samples.csv, statistics.json and report.html are
        self.folder = folder
        #: the keys of statistics.json (docs/reference/statistics.md)
        self.statistics: Statistics = job.json("statistics")
        #: a row a sample that ran: its number and its inputs, with units
        self.inputs: Table = job.table("inputs")
        #: of wythe.campaign(): done, total, precise_at, until, notes; None of an opened folder
        self.outcome: Optional[Outcome] = job.json("outcome")

    def curve(self, sample: int) -> dict[str, Floats]:
        """The curve of a sample by its number (from 1), read from the store; InputError where it has not run."""
        number = _whole("sample", sample)
        places = [row for row, own in enumerate(self.inputs.numbers("sample")) if own == number]
        if not places:
            raise InputError([Fault(path="sample", value=str(sample), problem="has not run in this campaign",
                                    cure="choose a number of inputs['sample']")])
        return _curve_of(self._job.table("curves"), places[0])

    def replay(
        self,
        sample: int,
        *,
        out: Optional[Path] = None,
        threads: int = 1,
        progress: Progress = None,
        replace: bool = False,
        language: Language = "en",
    ) -> Result:
        """Runs a sample again, with all its states, as `wythe.replay` does."""
        return replay(self.folder, sample, out=out, threads=threads, progress=progress, replace=replace, language=language)

    def frame(self) -> DataFrame:
        """Inputs, what each sample says of itself (status, failure_mode, reason, rate_judgement), and answers as a
        pandas DataFrame.
        """
        frame = self.inputs.frame()
        frame["sample"] = frame["sample"].astype(int)
        return self._with_words(frame)

    def _repr_html_(self) -> str:
        counts = {mode: self.failure_mode.count(mode) for mode in sorted({m for m in self.failure_mode if m})}
        peaks = list(self._capacities().values())
        bounds = sum(is_bound for _, is_bound in peaks)
        ends = [("at least " if is_bound else "") + number(peak) for peak, is_bound in (
            (min(peaks), max(peaks)) if peaks else ())]
        rows = [
            ("folder", self.folder),
            ("samples", f"{len(self)}, {len(peaks)} of them with a capacity"
             + (f", of which {bounds} {'is a lower bound' if bounds == 1 else 'are lower bounds'}" if bounds else "")),
            ("capacity", " to ".join(ends) + " kN" if ends else "not known"),
            ("failure modes", ", ".join(f"{mode} {count}" for mode, count in counts.items()) or "not known"),
        ]
        return plot.rows_html(rows)

    def __repr__(self) -> str:
        return f"<campaign {self.folder!r}: {len(self)} samples{': ' if len(self) else ''}{self._counts()}>"


class SecondOpinion:
    """What limit analysis says: limit loads, mechanisms, and what it refuses."""

    def __init__(self, job: Job):
        self._job = job
        #: the keys of mechanisms.json (docs/reference/limit.md)
        self.mechanisms: Mechanisms = job.json("mechanisms")

    @property
    def limit_loads(self) -> dict[str, float]:
        """Static limit load by the strength of the joints, "dry", "bonded", ...: in kN, or as a load factor."""
        return {row["name"]: row["static_kN"] if "static_kN" in row else row["static"]
                for row in self.mechanisms["limit_loads"]}

    def curve(self, file: str) -> Table:
        """The capacity curve of a mechanism by its file name, e.g. "mechanism_fm1_infinite"."""
        table = self._job.table_or_none(file)
        if table is None:
            raise InputError([Fault(path=file, problem="is no mechanism of this answer",
                                    cure="there are: " + (", ".join(self._job.json("tables") or {}) or "none"))])
        return table

    def __repr__(self) -> str:
        loads = ", ".join(f"{name} {number(load)}" for name, load in self.limit_loads.items())
        return f"<second opinion: limit loads {loads or 'none'}>"
