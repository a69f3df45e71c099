"""The calls: run, check, limit, contact, run_many, campaign, open, replay."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Optional, Union

from ._errors import Fault, InputError, folder_of, names_of, needed_for, path_of, refused
from ._jobs import Table, perform
from ._model import Model, ModelLike, as_setting, is_measured, unit_of
from ._results import Batch, Campaign, Check, Result, SecondOpinion, replay
from ._types import Floats, Inputs, Language, Path, Progress, Settings

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["run", "check", "limit", "contact", "run_many", "campaign", "open_campaign", "replay"]


Texts = dict[str, Union[None, str, list[str]]]


def _model(model: ModelLike) -> Texts:
    if isinstance(model, Model):
        return {"model": model._told(), "file": model.file}
    if not isinstance(model, (str, bytes, os.PathLike)):
        raise refused("model", type(model).__name__, "is neither a path nor a Model",
                      "give the path of a model file, or wythe.Model.parse(text)")
    return {"file": path_of("model", model)}


def _settings(changes: Settings) -> list[str]:
    if changes is None:
        return []
    if isinstance(changes, str):
        return [changes]
    if isinstance(changes, Mapping):
        return [as_setting(path, value) for path, value in changes.items()]
    if not isinstance(changes, (list, tuple)):
        raise refused("set", type(changes).__name__, "holds no settings", 'write {"wall.length": "5 m"}')
    return list(changes)


def run(
    model: ModelLike,
    *,
    set: Settings = None,
    out: Optional[Path] = None,
    threads: int = 1,
    progress: Progress = None,
    replace: bool = False,
    language: Language = "en",
) -> Result:
    """Runs a wall through its stages.

    ``set`` changes keys for this run, ``out`` names a folder for the files that `wythe run` writes (none are
    written without it), ``threads`` is the number of cores for this one wall, 0 all: the bits are the same for any.
    A folder that holds results of another model file is refused, unless ``replace`` is true.

    Raises InputError with every fault of the model, AccessError, and Interrupted at Ctrl-C, whose ``.result``
    is the Result up to there. A run that fails in the mathematics raises nothing: see ``.status``.
    """
    texts = {**_model(model), "set": _settings(set), "out": folder_of(out), "language": language}
    numbers = {"threads": threads, "replace": replace}
    return perform("run", Result, texts, numbers, progress=progress)


def check(model: ModelLike, *, set: Settings = None) -> Check:
    """Builds the wall without running it: blocks, joints, weight, expected time, notes, a picture."""
    return perform("check", Check, {**_model(model), "set": _settings(set)})


def limit(
    model: ModelLike,
    *,
    set: Settings = None,
    only: Union[str, Sequence[str]] = (),
    assessment: bool = False,
    out: Optional[Path] = None,
    progress: Progress = None,
    replace: bool = False,
    language: Language = "en",
) -> SecondOpinion:
    """Limit analysis of the wall: limit loads by linear programmes, and chains of macro-blocks.

    ``only`` takes some of "lp", "infinite", "macro_block_1", "macro_block_2", and with ``assessment=True`` also
    "parts", those that fall on their face; all unless said.
    """
    texts = {
        **_model(model), "set": _settings(set), "only": names_of("only", only), "out": folder_of(out), "language": language
    }
    numbers = {"assessment": assessment, "replace": replace}
    return perform("limit", SecondOpinion, texts, numbers, progress=progress)


def contact(law: ModelLike, opening_mm: ArrayLike, slip_mm: ArrayLike) -> Table:
    """Drives one joint along a path and gives its stresses and damage, a row for each point of the path.

    ``law`` is a file or a Model with one joint law, or with one called joint. Openings and slips (points,) are in
    millimetres; pressing is negative. Stresses are in MPa, tension positive.
    """
    told = _model(law)
    texts = {"law": told.get("model"), "file": told["file"]}
    columns = {"opening_mm": _column("opening_mm", opening_mm), "slip_mm": _column("slip_mm", slip_mm)}
    return perform("contact", lambda job: job.table("answer"), texts, columns=columns)


def _column(name: str, values: object) -> Floats:
    """The values as one column of float64."""
    with needed_for(name):
        import numpy
    if isinstance(values, numpy.ma.MaskedArray) and values.mask.any():
        raise refused(name, "a masked array", "hides some of its numbers", "leave those rows out")
    try:
        given = numpy.asarray(values)
        if given.dtype.kind not in "fiubO":
            raise TypeError(given.dtype)
        column: Floats = numpy.ascontiguousarray(given, dtype=numpy.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError([Fault(path=name, value=type(values).__name__, problem="is no list of numbers",
                                cure="give numbers in one unit")]) from error
    if column.ndim != 1:
        raise InputError([Fault(path=name, value=f"shape {column.shape}", problem="has another shape than one column",
                                cure="give a flat list, one number a row")])
    return column


def _one_unit(path: str, said: Mapping[str, str]) -> str:
    """The unit of a column, which may stand at several places as long as it is the same."""
    found = {place: unit for place, unit in said.items() if unit != ""}
    for place, unit in found.items():
        if not isinstance(unit, str):
            raise refused(path, f"{unit!r:.60}", "is no unit", 'write it as text, e.g. "MPa"')
    if len(set(found.values())) > 1:
        raise refused(path, ", ".join(f"{unit} ({place})" for place, unit in found.items()), "has units that differ",
                      "leave all but one of them out")
    return next(iter(found.values()), "")


def _pairs(inputs: Inputs, columns: Union[None, str, Sequence[str]]) -> list[tuple[str, object]]:
    """Titles and values of the columns, from the shapes in which people have them."""
    if columns is not None:
        columns = names_of("columns", columns)
        with needed_for("a matrix of inputs"):
            import numpy
        try:
            matrix = numpy.asarray(inputs, dtype=float)
        except (TypeError, ValueError, OverflowError):
            raise refused("inputs", type(inputs).__name__, "are no matrix of numbers",
                          "give a matrix of (rows, columns)") from None
        if matrix.ndim != 2 or matrix.shape[1] != len(columns):
            raise InputError([Fault(path="inputs", value=f"shape {matrix.shape}",
                                    problem=f"does not fit the {len(columns)} columns",
                                    cure="give a matrix of (rows, columns)")])
        return [(path, matrix[:, i]) for i, path in enumerate(columns)]
    if hasattr(inputs, "items"):  # a mapping, or a data frame
        return [(str(path), values) for path, values in inputs.items()]
    raise InputError([Fault(path="inputs", value=type(inputs).__name__, problem="has no names for its columns",
                            cure="give a mapping of path to values, a data frame, or a matrix with columns=")])


def _inputs(
    inputs: Inputs, columns: Union[None, str, Sequence[str]], units: Optional[Mapping[str, str]]
) -> tuple[dict[str, Floats], dict[str, str]]:
    """Columns by path, and their units."""
    pairs = _pairs(inputs, columns)
    if units is not None and not isinstance(units, Mapping):
        raise refused("units", type(units).__name__, "names no columns", 'write {"wall.length": "m"}')
    found: dict[str, Floats] = {}
    units_of: dict[str, str] = {}
    for title, values in pairs:
        path, said = title, {"units": (units or {}).get(title, "")}
        if title.endswith("]") and " [" in title:  # "material.joint.cohesion [MPa]"
            path, said["its title"] = title[:-1].split(" [", 1)
        if isinstance(values, tuple) and len(values) == 2 and isinstance(values[1], str):
            values, said["its values"] = values
        if is_measured(values):
            said["its quantity"], values = unit_of(values), values.magnitude
        if path in found:
            raise refused(path, title, "stands there twice", "leave one of the columns out")
        found[path] = _column(path, values)
        units_of[path] = _one_unit(path, said)
    for name in units or {}:
        if name not in dict(pairs):
            raise InputError([Fault(path=f"units[{name!r}]", problem="names no column of the inputs",
                                    cure="the columns are " + ", ".join(dict(pairs)))])
    return found, units_of


def run_many(
    model: ModelLike,
    inputs: Inputs,
    *,
    columns: Union[None, str, Sequence[str]] = None,
    units: Optional[Mapping[str, str]] = None,
    set: Settings = None,
    jobs: int = 0,
    curves: bool = False,
    read_modes_at_mm: Optional[float] = None,
    progress: Progress = None,
) -> Batch:
    """Runs the wall once for every row of inputs, many side by side on all cores.

    ``inputs`` is a mapping from the path of a key to its values, ``{"material.joint.cohesion": ([0.1, 0.2],
    "MPa")}``, a pandas DataFrame with columns "path [unit]", or a matrix (rows, columns) with ``columns`` and
    ``units``. The answers are in the order of the rows; a row gives the same bits alone, in any batch, and
    in a campaign. A row that is not admissible has the status "refused" and a reason; it stops no other row.

    ``curves`` keeps the curves. ``jobs`` is the number of cores for walls side by side, 0 all.
    """
    found, units_of = _inputs(inputs, columns, units)
    if not found:
        raise InputError([Fault(path="inputs", problem="has no columns", cure="name the keys that differ")])
    texts: Texts = {**_model(model), "set": _settings(set), "path": list(found), "unit": list(units_of.values())}
    numbers = {"jobs": jobs, "curves": curves, "read_modes_at_mm": read_modes_at_mm}
    data = {f"input {i}": column for i, column in enumerate(found.values())}
    return perform("batch", lambda job: Batch(job, found, units_of), texts, numbers, data, progress)


def campaign(
    study: Path,
    out: Path,
    *,
    set: Settings = None,
    samples: Optional[int] = None,
    seed: Optional[int] = None,
    until: Optional[str] = None,
    jobs: int = 0,
    resume: bool = False,
    shard: Optional[tuple[int, int]] = None,
    progress: Progress = None,
    language: Language = "en",
) -> Campaign:
    """Runs the samples of a study into the folder ``out``, as `wythe campaign` does.

    Every sample is stored when it ends. Ctrl-C keeps those; ``resume=True`` goes on with them. ``shard`` is
    (number, of how many). ``jobs`` is the number of cores for samples side by side, 0 all.
    """
    folder = path_of("out", out)
    texts = {
        "file": path_of("study", study), "out": folder, "set": _settings(set), "until": until, "language": language
    }
    if shard is not None and not (isinstance(shard, tuple) and len(shard) == 2):
        raise refused("shard", f"{shard!r:.60}", "is no pair of numbers", "write (number, of how many), e.g. (1, 4)")
    number, shards = shard if shard is not None else (None, None)
    numbers = {
        "samples": samples, "seed": seed, "jobs": jobs, "resume": resume, "shard": number, "shards": shards
    }
    return perform("campaign", lambda job: Campaign(job, folder), texts, numbers, progress=progress)


def open_campaign(folder: Path) -> Campaign:
    """The campaign in a folder, however far it is."""
    name = path_of("folder", folder)
    return perform("results", lambda job: Campaign(job, name), {"folder": name})
