"""What the calls answer: results of a run, a batch, a campaign, a second opinion."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from html import escape
from typing import Any, Optional

from ._errors import Fault, InputError, needed, refused, write_text
from ._jobs import Job, Table


def _number(value: Any, digits: int = 4, unit: str = "") -> str:
    """A number with its unit; "not known" where there is none."""
    if value is None or value != value:
        return "not known"
    return f"{value:.{digits}g}{unit}"


def _whole(name: str, value: Any) -> int:
    """The number of a row or sample; a text or a fraction is none."""
    try:
        if not isinstance(value, (str, bytes)) and value == int(value):
            return int(value)
    except (TypeError, ValueError, OverflowError):
        pass
    raise refused(name, f"{value!r:.60}", "is no whole number", "write a number, without quotes")


def _word(value: Any) -> str:
    return "not known" if value in (None, "") else str(value)


def _curve_svg(x: Any, y: Any, x_label: str, y_label: str, width: int = 420, height: int = 260) -> str:
    """A small plot that needs no package but NumPy."""
    numpy = needed("numpy", "the picture of a curve")
    keep = numpy.isfinite(x) & numpy.isfinite(y)
    x, y = numpy.asarray(x)[keep], numpy.asarray(y)[keep]
    if len(x) < 2:
        return ""
    left, bottom, top = 52, 36, 10
    x_low, x_high = min(0.0, float(x.min())), max(0.0, float(x.max()))
    y_low, y_high = min(0.0, float(y.min())), max(0.0, float(y.max()))
    across = (width - left - 12) / ((x_high - x_low) or 1)
    up = (height - bottom - top) / ((y_high - y_low) or 1)
    points = " ".join(
        f"{left + (a - x_low) * across:.1f},{height - bottom - (b - y_low) * up:.1f}" for a, b in zip(x, y)
    )
    right, floor = width - 12, height - bottom
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" role="img" '
        f'aria-label="{escape(y_label)} over {escape(x_label)}" '
        'style="max-width:100%;font:12px sans-serif;fill:currentColor">'
        f'<path d="M{left} {top}V{floor}H{right}" fill="none" stroke="currentColor"/>'
        f'<polyline points="{points}" fill="none" stroke="#1f77b4" stroke-width="1.5"/>'
        f'<text x="{left - 4}" y="{top + 10}" text-anchor="end">{_number(y_high, 3)}</text>'
        f'<text x="{left - 4}" y="{floor}" text-anchor="end">{_number(y_low, 3)}</text>'
        f'<text x="{right}" y="{floor + 14}" text-anchor="end">{_number(x_high, 3)}</text>'
        f'<text x="{left}" y="{floor + 14}">{_number(x_low, 3)}</text>'
        f'<text x="{(left + right) / 2}" y="{height - 4}" text-anchor="middle">{escape(x_label)}</text>'
        f'<text transform="translate(12 {height / 2}) rotate(-90)" text-anchor="middle">{escape(y_label)}</text>'
        "</svg>"
    )


def _rows_html(rows: Sequence[tuple[str, str]]) -> str:
    cells = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th><td style="text-align:left">{escape(value)}</td></tr>'
        for name, value in rows
    )
    return f"<table>{cells}</table>"


def _side_by_side(*parts: str) -> str:
    inner = "".join(f'<div style="max-width:30rem">{part}</div>' for part in parts if part)
    return f'<div style="display:flex;flex-wrap:wrap;gap:1rem;align-items:flex-start">{inner}</div>'


class State:
    """The wall at one moment of a run."""

    def __init__(self, job: Job, number: int, row: dict[str, Any]):
        self._job, self._number = job, number
        #: "start of push", "peak", "20 mm", "end"
        self.label: str = row["label"]
        #: of the push [mm]
        self.displacement_mm: float = row["displacement_mm"]
        #: against the push [kN]
        self.reaction_kN: float = row["reaction_kN"]

    @property
    def blocks(self) -> Table:
        """A row a block: where it was, how far it went, how far it turned."""
        return self._table("blocks")

    @property
    def joints(self) -> Table:
        """A row a joint: place, opening, slip, damage, stresses and forces."""
        return self._table("joints")

    def _table(self, name: str) -> Table:
        table = self._job.table(f"state {self._number} {name}")
        assert table is not None
        return table

    @property
    def svg(self) -> str:
        """A picture of the wall as an SVG document; empty for walls in space."""
        return self._job.text(f"state {self._number} svg") or ""

    def save_compas(self, path: str | os.PathLike[str]) -> None:
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
        self.summary: dict[str, Any] = job.json("summary")
        curve = job.table("curve")
        assert curve is not None
        #: the rows of force_displacement.csv
        self.curve: Table = curve
        #: the rows of history.csv, of a wall that was shaken; else None
        self.history: Optional[Table] = job.table("history")
        #: the states that the run kept, in order of time
        self.states: list[State] = [State(job, k, row) for k, row in enumerate(job.json("states"))]
        #: of a replay: whether it equals the stored sample, and the sample's settings
        self.replay: Optional[dict[str, Any]] = job.json("replay")

    @property
    def status(self) -> str:
        """"completed", "collapsed", "interrupted", "not_settled", "unstable" or "budget_spent"."""
        return str(self.summary["status"])

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

    def save_page(self, path: str | os.PathLike[str]) -> None:
        """Writes the report of the run as one HTML page."""
        write_text(path, self.page)

    def plot(self, axes: Any = None) -> Any:
        """The curve on matplotlib's axes, which it gives back."""
        pyplot = needed("matplotlib.pyplot", "plot()")
        if axes is None:
            axes = pyplot.subplots()[1]
        axes.plot(self.curve["displacement_mm"], self.curve["reaction_kN"])
        axes.set_xlabel("displacement [mm]")
        axes.set_ylabel("reaction [kN]")
        return axes

    def _capacity(self) -> str:
        s = self.summary
        bound = "at least " if s.get("censored_peak") else ""
        factor = [f"load factor {_number(s['load_factor'])}"] if s.get("load_factor") else []
        if s.get("peak_reaction_kN"):
            at = s.get("displacement_at_peak_mm")
            force = _number(s["peak_reaction_kN"], unit=" kN") + ("" if at is None else f" at {_number(at, unit=' mm')}")
            return bound + ", ".join([*factor, force])
        if factor:
            return bound + factor[0]
        if s.get("peak_reaction_kN") == 0:
            return "not asked for: nothing pushed the wall"
        return "not known" + (f": {s['peak_reason']}" if s.get("peak_reason") else "")

    def _answer(self) -> list[tuple[str, str]]:
        """What the run says of the wall: of one that was shaken alone, how it stands, and no capacity."""
        shaken = (self.summary.get("shaking") or {}).get("sentence")
        said = [("shaking", str(shaken))] if shaken else []
        if said and self.summary.get("peak_reaction_kN") == 0:
            return said
        mode = self.summary.get("failure_mode") or {}
        return [*said, ("capacity", self._capacity()), ("failure mode", _word(mode.get("name")))]

    def _facts(self) -> list[tuple[str, str]]:
        s = self.summary
        rate = s.get("quasi_static") or {}
        warning = [("warning", str(s["warning"]))] if s.get("warning") else []
        reason = [("reason", str(s["reason"]))] if s.get("reason") else []
        return [
            *warning,
            ("status", self.status),
            *reason,
            *self._answer(),
            ("rate", _word(rate.get("verdict"))),
            *((f"rate, {name}", f"not known: {said['reason']}") for key, name in
              (("displacement", "displacement"), ("mode", "failure mode"))
              if (said := rate.get(key) or {}).get("verdict") == "not known"),
        ]

    def _repr_html_(self) -> str:
        svg = self.states[-1].svg if self.states else ""
        curve = _curve_svg(
            self.curve["displacement_mm"], self.curve["reaction_kN"], "displacement [mm]", "reaction [kN]"
        )
        return _side_by_side(_rows_html(self._facts()), curve, svg)

    def __repr__(self) -> str:
        return "<run: " + "; ".join(f"{name} {value}" for name, value in self._facts()) + ">"


class Check:
    """What `wythe check` says of a model."""

    def __init__(self, job: Job):
        self._job = job
        #: blocks, joints, points, weight_kN, time_step_s, steps, expected_seconds, notes, ...
        self.facts: dict[str, Any] = job.json("check")

    @property
    def model(self) -> str:
        """The model with every default written out."""
        return self._job.text("model") or ""

    @property
    def svg(self) -> str:
        """A picture of the wall as an SVG document; empty for walls in space."""
        return self._job.text("svg") or ""

    def __getitem__(self, name: str) -> Any:
        return self.facts[name]

    def _repr_html_(self) -> str:
        f = self.facts
        rows = [
            ("blocks", str(f["blocks"])),
            ("joints", str(f["joints"])),
            ("weight", _number(f["weight_kN"], unit=" kN")),
            ("size", f"{_number(f['length_m'])} x {_number(f['height_m'])} x {_number(f['thickness_m'])} m"),
            ("expected time", _number(f["expected_seconds"], 2, " s")),
            *(("note", str(note)) for note in f["notes"]),
        ]
        return _side_by_side(_rows_html(rows), self.svg)

    def __repr__(self) -> str:
        f = self.facts
        return (f"<check: {f['blocks']} blocks, {f['joints']} joints, {_number(f['weight_kN'], unit=' kN')}, "
                f"about {_number(f['expected_seconds'], 2, ' s')}; {len(f['notes'])} notes>")


def _with_words(frame: Any, rows: Batch | Campaign) -> Any:
    """What rows say of themselves stands beside their numbers: NaN never comes without a word."""
    for name in ("status", "failure_mode", "reason", "rate_judgement"):
        frame[name] = getattr(rows, name)
    for name in rows.answers:
        frame[name] = rows.answers[name]
    return frame


def _capacities(rows: Batch | Campaign) -> dict[int, tuple[float, bool]]:
    """Each row's capacity [kN], and whether it is a lower bound; a row without one is left out."""
    peaks, bounds = rows.answers.numbers("peak_reaction_kN"), rows.answers.numbers("censored_peak")
    return {row: (peak, bound == 1) for row, (peak, bound) in enumerate(zip(peaks, bounds)) if peak > 0}


def _counts(rows: Batch | Campaign) -> str:
    """"5 completed (2 without a capacity, 1 with a lower bound of it), 1 refused"."""
    capacities = _capacities(rows)
    words = []
    for status in dict.fromkeys(rows.status):
        places = [row for row, own in enumerate(rows.status) if own == status]
        ended = places if status in ("completed", "collapsed") else []
        bare = sum(row not in capacities for row in ended)
        bounds = sum(capacities[row][1] for row in ended if row in capacities)
        inner = [*([f"{bare} without a capacity"] if bare else []),
                 *([f"{bounds} with a lower bound of it" if bare else f"{bounds} with a lower bound of the capacity"]
                   if bounds else [])]
        words.append(f"{len(places)} {status or 'not run'}" + (f" ({', '.join(inner)})" if inner else ""))
    return ", ".join(words)


class Batch:
    """Answers to rows of inputs, in the order of the rows."""

    def __init__(self, job: Job, inputs: dict[str, Any], units: dict[str, str]):
        rows = job.json("rows")
        answers = job.table("answers")
        assert answers is not None
        #: numbers, a row each; NaN where a row has no answer
        self.answers: Table = answers
        #: "completed", "collapsed", "refused", "unstable", ...; "" where the batch was stopped before
        self.status: list[str] = [row["status"] for row in rows]
        #: the failure mode of each row; None where a row has no answer
        self.failure_mode: list[Optional[str]] = [row.get("failure_mode") for row in rows]
        #: why a row has no answer, no capacity or no initial stiffness, or why it ended; None where there is nothing to say
        self.reason: list[Optional[str]] = [row.get("reason") for row in rows]
        #: how nearly static each push was: "slow enough", "usable", "too fast", "unknown"; None where a row has no answer
        self.rate_judgement: list[Optional[str]] = [row.get("rate_judgement") for row in rows]
        #: the hash of each wall's last state: equal hashes are equal results
        self.state_hash: list[str] = [row["state_hash"] for row in rows]
        #: the inputs as they were given
        self.inputs: dict[str, Any] = inputs
        #: the unit of each input, "" where it has none
        self.units: dict[str, str] = units
        self._curves = job.table("curves")

    def __len__(self) -> int:
        return len(self.status)

    @property
    def done(self) -> bool:
        """Whether every row has an answer."""
        return all(status in ("completed", "collapsed") for status in self.status)

    def curve(self, row: int) -> dict[str, Any]:
        """The curve of a row, its columns as in ``Result.curve``; the batch has to be asked with curves=True."""
        if self._curves is None:
            raise InputError([Fault(path="curve", problem="the curves were not asked for",
                                    cure="call run_many(..., curves=True)")])
        number = range(len(self))[_whole("row", row)]
        numpy = needed("numpy", "a curve")
        first, last = numpy.searchsorted(self._curves["row"], [number, number + 1])
        return {name: self._curves[name][first:last] for name in self._curves if name != "row"}

    def curves_at(self, displacement_mm: Any) -> Any:
        """Reactions [kN] of all rows at the same displacements [mm]: (rows, displacements), NaN off a curve."""
        numpy = needed("numpy", "curves_at()")
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

    def frame(self) -> Any:
        """Inputs, what each row says of itself (status, failure_mode, reason, rate_judgement), and answers as a
        pandas DataFrame.

        A row that ended well may still have no capacity: then ``reason`` says why.
        """
        pandas = needed("pandas", "frame()")
        titles = {name: f"{name} [{self.units[name]}]" if self.units[name] else name for name in self.inputs}
        frame = pandas.DataFrame({titles[name]: values for name, values in self.inputs.items()})
        return _with_words(frame, self)

    def __repr__(self) -> str:
        return f"<batch of {len(self)}: {_counts(self)}>"


class Campaign:
    """A campaign in its folder: samples, statistics, page."""

    def __init__(self, job: Job, folder: str):
        self._job = job
        #: where campaign.db, samples.csv, statistics.json and report.html are
        self.folder: str = folder
        #: the keys of statistics.json (docs/reference/statistics.md)
        self.statistics: dict[str, Any] = job.json("statistics")
        inputs, answers = job.table("inputs"), job.table("answers")
        assert inputs is not None and answers is not None
        #: a row a sample that ran: its number and its inputs, with units
        self.inputs: Table = inputs
        #: a row a sample that ran, NaN where it has no answer
        self.answers: Table = answers
        rows = job.json("rows")
        #: by row, as those of a ``Batch``
        self.status: list[str] = [row["status"] for row in rows]
        self.failure_mode: list[Optional[str]] = [row.get("failure_mode") for row in rows]
        self.reason: list[Optional[str]] = [row.get("reason") for row in rows]
        self.rate_judgement: list[Optional[str]] = [row.get("rate_judgement") for row in rows]
        self.state_hash: list[str] = [row["state_hash"] for row in rows]
        #: of wythe.campaign(): done, total, precise_at, until, notes; None of an opened folder
        self.outcome: Optional[dict[str, Any]] = job.json("outcome")

    def __len__(self) -> int:
        return len(self.status)

    def curve(self, sample: int) -> dict[str, Any]:
        """The curve of a sample by its number (from 1), read from the store."""
        curves = self._job.table("curves")
        assert curves is not None
        numpy = needed("numpy", "a curve")
        places = numpy.flatnonzero(self.inputs["sample"] == _whole("sample", sample))
        if len(places) == 0:
            raise InputError([Fault(path="sample", value=str(sample), problem="has not run in this campaign",
                                    cure="choose a number of inputs['sample']")])
        first, last = numpy.searchsorted(curves["row"], [places[0], places[0] + 1])
        return {name: curves[name][first:last] for name in curves if name != "row"}

    def replay(self, sample: int, **options: Any) -> Result:
        """Runs a sample again, with all its states; ``.replay["equal"]`` says whether the bits are the same."""
        from ._calls import replay

        return replay(self.folder, sample, **options)

    def frame(self) -> Any:
        """Inputs, what each sample says of itself (status, failure_mode, reason, rate_judgement), and answers as a
        pandas DataFrame.
        """
        pandas = needed("pandas", "frame()")
        frame = pandas.DataFrame({name: self.inputs[name].copy() for name in self.inputs})
        frame["sample"] = frame["sample"].astype(int)
        return _with_words(frame, self)

    def _repr_html_(self) -> str:
        counts = {mode: self.failure_mode.count(mode) for mode in sorted({m for m in self.failure_mode if m})}
        peaks = list(_capacities(self).values())
        bounds = sum(is_bound for _, is_bound in peaks)
        ends = [("at least " if is_bound else "") + _number(peak) for peak, is_bound in (
            (min(peaks), max(peaks)) if peaks else ())]
        rows = [
            ("folder", self.folder),
            ("samples", f"{len(self)}, {len(peaks)} of them with a capacity"
             + (f", of which {bounds} {'is a lower bound' if bounds == 1 else 'are lower bounds'}" if bounds else "")),
            ("capacity", " to ".join(ends) + " kN" if ends else "not known"),
            ("failure modes", ", ".join(f"{mode} {count}" for mode, count in counts.items()) or "not known"),
        ]
        return _rows_html(rows)

    def __repr__(self) -> str:
        return f"<campaign {self.folder!r}: {len(self)} samples{': ' if len(self) else ''}{_counts(self)}>"


class SecondOpinion:
    """What limit analysis says: limit loads, mechanisms, and what it refuses."""

    def __init__(self, job: Job):
        self._job = job
        #: the keys of mechanisms.json (docs/reference/limit.md)
        self.mechanisms: dict[str, Any] = job.json("mechanisms")

    @property
    def limit_loads(self) -> dict[str, float]:
        """Static limit load by the strength of the joints, "dry", "bonded", ...: in kN, or as a load factor."""
        loads: dict[str, float] = {}
        for row in self.mechanisms.get("limit_loads", []):
            loads[row["name"]] = row["static_kN"] if "static_kN" in row else row["static"]
        return loads

    def curve(self, file: str) -> Table:
        """The capacity curve of a mechanism by its file name, e.g. "mechanism_fm1_infinite"."""
        table = self._job.table(file)
        if table is None:
            names = [name for name in json.loads(self._job.text("tables") or "{}")]
            raise InputError([Fault(path=file, problem="is no mechanism of this answer",
                                    cure="there are: " + (", ".join(names) or "none"))])
        return table

    def __repr__(self) -> str:
        loads = ", ".join(f"{name} {_number(load)}" for name, load in self.limit_loads.items())
        return f"<second opinion: limit loads {loads or 'none'}>"
