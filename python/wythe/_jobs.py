"""One call of the engine: inputs in, answers out, exceptions for whatever goes wrong."""

from __future__ import annotations

import atexit
import json
import os
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NoReturn, Optional, TypeVar, Union, cast

from . import _wythe
from ._errors import (
    AccessError, DefectError, Fault, InputError, Interrupted, MadeText, WytheError, fault_in_python, in_python, needed_for,
    refused,
)
from ._progress import listener
from ._types import Floats, Hear, Progress

if TYPE_CHECKING:
    from pandas import DataFrame

Answer = TypeVar("Answer")

_PATHS = ("file", "folder", "out")

_DONE, _BAD_INPUT, _STOPPED, _NO_ACCESS, _NO_MEMORY = 0, 2, 3, 4, 5


class Job:
    """A job that has ended; its answers."""

    def __init__(self, raw: _wythe.Job):
        self._raw = raw

    def __reduce__(self) -> NoReturn:
        raise TypeError("a result lives in its process and cannot be pickled or copied deeply; hand on its "
                        ".summary, .curve.frame() or .frame()")

    def text(self, name: str) -> Optional[str]:
        """None where there is none of that name. Raises MemoryError or DefectError where it could not be made."""
        text = self._raw.text(name)
        if text is None and (why := self._raw.text("error")):
            raise MemoryError(why) if "memory" in why else DefectError(why)
        return text

    def json(self, name: str) -> Any:
        """What a text holds; whoever asks says what that is."""
        text = self.text(name)
        return None if text is None else json.loads(text)

    def table_or_none(self, name: str) -> Optional[Table]:
        columns = self.json(f"columns of {name}")
        return None if columns is None else Table(self._raw, name, columns)

    def table(self, name: str) -> Table:
        """One that there always is."""
        table = self.table_or_none(name)
        assert table is not None
        return table


class Table(Mapping[str, Floats]):
    """Columns of numbers by name, as NumPy arrays (rows,) of float64 that look at the engine's own memory.

    ``table["reaction_kN"]`` and ``table.reaction_kN`` are the same array, read-only and without a copy.
    ``table.frame()`` is a pandas DataFrame (a copy). A column that is not there raises KeyError or AttributeError
    with the names of those that are; without NumPy a column raises MissingPackage.
    """

    def __init__(self, raw: _wythe.Job, name: str, columns: Sequence[str]):
        self._raw = raw
        self._name = name
        self._columns = tuple(columns)

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns; each ends with its unit."""
        return self._columns

    def _memory(self, column: str) -> memoryview:
        found = self._raw.column(self._name, column) if column in self._columns else None
        if found is None:
            raise KeyError(f"{column!r}; the columns are {', '.join(self._columns)}")
        return memoryview(cast(bytes, found))  # it lets its memory be looked at, which no stub can say

    def __getitem__(self, column: str) -> Floats:
        memory = self._memory(column)
        with needed_for("a column"):
            import numpy
        return numpy.asarray(memory)

    def __getattr__(self, column: str) -> Floats:
        if column.startswith("_"):
            raise AttributeError(column)
        if column not in self._columns:
            raise AttributeError(f"no column {column!r}; the columns are {', '.join(self._columns)}")
        return self[column]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    # a table is equal to itself alone: columns with NaN are equal to none
    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = object.__hash__

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return len(self._memory(self._columns[0])) if self._columns else 0

    def numbers(self, column: str) -> list[float]:
        """A column as a list of Python's numbers, which needs no package."""
        return [float(value) for value in self._memory(column)]

    def frame(self) -> DataFrame:
        """All columns as a pandas DataFrame."""
        with needed_for("frame()"):
            from pandas import DataFrame
        return DataFrame({name: self[name].copy() for name in self})

    def __repr__(self) -> str:
        return f"<table {self._name!r}: {self.rows} rows of {', '.join(self._columns)}>"


Texts = Mapping[str, Union[None, str, Sequence[str]]]
Numbers = Mapping[str, Optional[float]]


def _refused(raw: _wythe.Job, texts: Texts, numbers: Numbers) -> WytheError:
    """What a call is refused for: a file or folder that it names and that is not there, or faults."""
    text = next((texts[name] for name in ("model", "law", "study") if texts.get(name) is not None), None)
    named = [path for path in (texts.get("file") if text is None else None, texts.get("folder")) if isinstance(path, str)]
    if any(not os.path.lexists(path) for path in named):
        return AccessError(in_python(raw.text("error") or ""))
    given = [name for options in (texts, numbers) for name, value in options.items() if value is not None]
    faults = [fault_in_python(Fault(**row), given) for row in json.loads(raw.text("faults") or "[]")]
    if isinstance(text, MadeText):
        faults = [replace(fault, line=0) if fault.file == texts["file"] else fault for fault in faults]
    return InputError(faults or [Fault(problem=in_python(raw.text("error") or "it is not admissible"))])


def _encoded(name: str, text: str) -> Union[str, bytes]:
    """The text; a path as the bytes by which the system knows it."""
    if not isinstance(text, str):
        raise refused(name, type(text).__name__, "is no text", "write a text")
    try:
        text.encode()
    except UnicodeEncodeError as error:
        if name in _PATHS:
            return os.fsencode(text)
        raise refused(name, ascii(text[:80]), f"is no text: {error.reason} at character {error.start + 1}",
                      "write it in Unicode") from None
    return text


_FLAGS = ("replace", "resume", "assessment", "curves")


def _number(name: str, value: float) -> float:
    is_bool = type(value).__name__ in ("bool", "bool_")  # of Python and NumPy
    if name in _FLAGS:
        if not is_bool and not (isinstance(value, int) and value in (0, 1)):
            raise refused(name, f"{value!r:.60}", "is neither True nor False", f"write {name}=True, or leave it out")
        return float(value)
    if is_bool:
        raise refused(name, f"{value!r:.60}", "is no number", f"write {name}=0 for all cores, {name}=1 for one"
                      if name in ("threads", "jobs") else "write a number")
    try:
        if isinstance(value, (str, bytes, bytearray)):
            raise ValueError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise refused(name, f"{value!r:.60}", "is no number", "write a number, without quotes") from None


# A thread that computes when the interpreter ends would be torn down amid the engine: stop its job and wait.
_at_work: set[threading.Event] = set()
_ending = False


def _end() -> None:
    global _ending
    _ending = True
    for done in list(_at_work):
        done.wait()


atexit.register(_end)
os.register_at_fork(after_in_child=_at_work.clear)  # a child has none of its parent's other threads


def _beside(raw: _wythe.Job, hear: Optional[Hear]) -> tuple[int, Optional[BaseException]]:
    """Performs a job in another thread than the main one."""

    def hear_or_end(what: str, share: float, displacement_mm: float, force_kN: float) -> None:
        if _ending:
            raise SystemExit
        if hear is not None:
            hear(what, share, displacement_mm, force_kN)

    done = threading.Event()
    _at_work.add(done)
    try:
        if _ending:  # nobody would wait for it any more
            raise SystemExit
        return raw.perform(hear_or_end)
    finally:
        done.set()
        _at_work.discard(done)


def perform(
    task: str,
    answer: Callable[[Job], Answer],
    texts: Texts,
    numbers: Numbers = {},
    columns: Mapping[str, Floats] = {},
    progress: Progress = False,
) -> Answer:
    """Does a task and gives ``answer(job)``. Raises InputError, AccessError, Interrupted or DefectError."""
    raw = _wythe.Job(task)
    for name, value in texts.items():
        if value is not None and not isinstance(value, (str, list, tuple)):
            raise refused(name, type(value).__name__, "is no text", "write a text")
        for text in [value] if isinstance(value, str) else value or []:
            raw.set_text(name, _encoded(name, text))
    for name, number in numbers.items():
        if number is not None:
            raw.set_number(name, _number(name, number))
    for name, column in columns.items():
        raw.set_column(name, column)
    hear, close = listener(progress)
    try:
        main = threading.current_thread() is threading.main_thread()
        code, raised = raw.perform(hear) if main else _beside(raw, hear)
    finally:
        close()
    if code == _BAD_INPUT:
        raise _refused(raw, texts, numbers)
    if code == _NO_ACCESS:
        raise AccessError(in_python(raw.text("error") or ""))
    if code == _NO_MEMORY:
        raise MemoryError(raw.text("error"))
    if code not in (_DONE, _STOPPED):
        raise DefectError(raw.text("error"))
    if raised is not None and not isinstance(raised, KeyboardInterrupt):
        raise raised
    job = Job(raw)
    if code == _STOPPED or raised is not None:
        has_answers = json.loads(raw.text("texts") or "[]")
        raise Interrupted(answer(job) if has_answers else None)
    return answer(job)
