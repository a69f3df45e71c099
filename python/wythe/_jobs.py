"""One call of the engine: inputs in, answers out, exceptions for whatever goes wrong."""

from __future__ import annotations

import atexit
import json
import os
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Optional, Union

from . import _wythe
from ._errors import (
    AccessError, DefectError, Fault, InputError, Interrupted, MadeText, WytheError, fault_in_python, in_python, needed,
    refused,
)
from ._progress import listener

#: What a call may take as ``progress``: True or False, None (where somebody can see it), or a function of
#: (what, share, displacement_mm, force_kN).
Progress = Union[bool, None, Callable[[str, float, float, float], Any]]

_PATHS = ("file", "folder", "out")

_DONE, _BAD_INPUT, _STOPPED, _NO_ACCESS, _NO_MEMORY = 0, 2, 3, 4, 5


class Job:
    """A job that has ended; its answers."""

    def __init__(self, raw: _wythe.Job):
        self._raw = raw

    def __reduce__(self) -> Any:
        raise TypeError("a result lives in its process and cannot be pickled or copied deeply; hand on its "
                        ".summary, .curve.frame() or .frame()")

    def text(self, name: str) -> Optional[str]:
        text: Optional[str] = self._raw.text(name)
        return text

    def json(self, name: str) -> Any:
        text = self.text(name)
        return None if text is None else json.loads(text)

    def table(self, name: str) -> Optional[Table]:
        columns = self.json(f"columns of {name}")
        return None if columns is None else Table(self._raw, name, columns)


class Table(Mapping[str, Any]):
    """Columns of numbers by name, as NumPy arrays that look at the engine's own memory.

    ``table["reaction_kN"]`` and ``table.reaction_kN`` are the same array, read-only and without a copy.
    ``table.frame()`` is a pandas DataFrame (a copy).
    """

    def __init__(self, raw: _wythe.Job, name: str, columns: Sequence[str]):
        self._raw = raw
        self._name = name
        self._columns = tuple(columns)

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns; each ends with its unit."""
        return self._columns

    def __getitem__(self, column: str) -> Any:
        if column not in self._columns:
            raise KeyError(f"{column!r}; the columns are {', '.join(self._columns)}")
        return needed("numpy", "a column").asarray(self._raw.column(self._name, column))

    def __getattr__(self, column: str) -> Any:
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
        column = self._raw.column(self._name, self._columns[0]) if self._columns else None
        return 0 if column is None else len(column)

    def numbers(self, column: str) -> list[float]:
        """A column as a list of Python's numbers, which needs no package."""
        found: Any = self._raw.column(self._name, column) if column in self._columns else None
        if found is None:
            raise KeyError(f"{column!r}; the columns are {', '.join(self._columns)}")
        return list(memoryview(found))

    def frame(self) -> Any:
        """All columns as a pandas DataFrame."""
        return needed("pandas", "frame()").DataFrame({name: self[name].copy() for name in self})

    def __repr__(self) -> str:
        return f"<table {self._name!r}: {self.rows} rows of {', '.join(self._columns)}>"


def _refused(raw: _wythe.Job, texts: Mapping[str, Any], numbers: Mapping[str, Any]) -> WytheError:
    """What a call is refused for: a file or folder that it names and that is not there, or faults."""
    text = next((texts[name] for name in ("model", "law", "study") if texts.get(name) is not None), None)
    named = [path for path in (texts.get("file") if text is None else None, texts.get("folder")) if path]
    if any(not os.path.lexists(path) for path in named):
        return AccessError(in_python(raw.text("error") or ""))
    given = [name for name, value in {**texts, **numbers}.items() if value is not None]
    faults = [fault_in_python(Fault(**row), given) for row in json.loads(raw.text("faults") or "[]")]
    if isinstance(text, MadeText):
        faults = [replace(fault, line=0) if fault.file == texts["file"] else fault for fault in faults]
    return InputError(faults or [Fault(problem=in_python(raw.text("error") or "it is not admissible"))])


def _encoded(name: str, text: Any) -> Any:
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


def _number(name: str, value: Any) -> float:
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


def _beside(raw: _wythe.Job, hear: Any) -> Any:
    """Performs a job in another thread than the main one."""

    def hear_or_end(*news: Any) -> None:
        if _ending:
            raise SystemExit
        if hear is not None:
            hear(*news)

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
    texts: Mapping[str, Union[None, str, Sequence[str]]],
    numbers: Mapping[str, Union[None, float, int, bool]] = {},
    columns: Mapping[str, Any] = {},
    progress: Progress = False,
    answer: Callable[[Job], Any] = lambda job: job,
) -> Any:
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
