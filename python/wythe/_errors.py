"""What can go wrong, and how Python hears of it."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import re
from collections.abc import Iterable, Iterator
from typing import Optional, Union

from ._types import Floats, Path

# Options of the command line that are arguments here; those without a value are flags.
_ARGUMENTS = {"set": "set", "samples": "samples", "seed": "seed", "jobs": "jobs", "threads": "threads", "until": "until",
              "out": "out", "only": "only", "lang": "language", "shard": "shard", "sample": "sample"}
_FLAGS = ("resume", "replace", "assessment")
_OPTION = re.compile(
    rf"that wythe (?P<call>\w+) --out wrote|wythe [a-z]+ [^;]*"  # a whole command stays one
    rf"|(?<![\w/.-])--(?:(?P<flag>{'|'.join(_FLAGS)})"
    rf"|(?P<name>{'|'.join(_ARGUMENTS)})(?: (?:(?P<pair>\d+/\d+)|(?P<number>\d+)|(?P<word>lp|parts)))?)(?![\w-])"
)


@dataclasses.dataclass(frozen=True)
class Fault:
    """One thing wrong with an input: where it stands, what was read, what to do.

    ``file`` and ``line`` are those of a file, ``path`` is the key ("wall.opening.0.width"), ``value`` what was
    read, ``problem`` what is wrong with it and ``cure`` what to write instead. Any of them may be empty.
    """

    path: str = ""
    value: str = ""
    problem: str = ""
    cure: str = ""
    file: str = ""
    line: int = 0

    def __str__(self) -> str:
        place = ":".join(part for part in (self.file, str(self.line) if self.line else "") if part)
        said = f"{self.path} = {self.value}" if self.path and self.value else self.path or self.value
        head = " ".join(part for part in (place + ":" if place else "", said) if part)
        problem = f"{head}: {self.problem}" if said else f"{head} {self.problem}".strip()
        return f"{problem}; {self.cure}" if self.cure else problem


def in_python(text: str) -> str:
    """What the engine says of an option of the command line, in Python's words: --resume is resume=True."""

    def said(match: re.Match[str]) -> str:
        if match["call"]:
            return f"that wythe.{match['call']} wrote"
        if match["flag"]:
            return f"{match['flag']}=True"
        if not match["name"]:
            return match[0]
        name = _ARGUMENTS[match["name"]]
        if match["pair"]:
            return f"{name}=({match['pair'].replace('/', ', ')})"
        return name + (f"={match['number']}" if match["number"] else f'="{match["word"]}"' if match["word"] else "")

    return _OPTION.sub(said, text)


def fault_in_python(fault: Fault, arguments: Iterable[str]) -> Fault:
    """A fault of an option as one of the argument that stands for it; ``arguments`` are those of the call."""
    file, path = in_python(fault.file), fault.path
    if file != fault.file and path.startswith("study.") and path[len("study."):] in arguments:
        file, path = "", path[len("study."):]  # samples=1 is no set={"study.samples": 1}
    elif file != fault.file and not path:
        file, path = "", file
    return dataclasses.replace(fault, file=file, path=path, problem=in_python(fault.problem), cure=in_python(fault.cure))


class MadeText(str):
    """A model's text that Python wrote: no file has its lines."""


class WytheError(Exception):
    """Anything that wythe refuses or cannot do."""


class InputError(WytheError, ValueError):
    """Inputs that are not admissible. ``faults`` has all of them, not only the first."""

    def __init__(self, faults: Iterable[Fault]):
        self.faults: list[Fault] = list(faults)
        super().__init__("\n".join(str(fault) for fault in self.faults))

    def __reduce__(self) -> tuple[type, tuple[list[Fault]]]:  # between processes
        return type(self), (self.faults,)


class NoMember(InputError, KeyError):
    """A name that is none of the members."""

    __str__ = Exception.__str__  # a KeyError would show quotes


class AccessError(WytheError, OSError):
    """A file or folder that a call names is missing, or one cannot be written, is damaged, or is in use."""


class DefectError(WytheError, RuntimeError):
    """A defect of wythe itself. Please report it."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a computation. ``result`` is what the call would have given, as far as it came, or None.

    A checker of types wants to know which: ``if isinstance(stop.result, wythe.Result)``.
    """

    def __init__(self, result: object = None):
        self.result = result
        super().__init__("stopped" if result is None else "stopped; .result has what was done until then")

    def __reduce__(self) -> tuple[type, tuple[None]]:  # a result stays in its process
        return Interrupted, (None,)


class NoAnswer(WytheError, ArithmeticError):
    """Rows of a `wythe.Function` that have no answer. ``rows`` has the reason of each, by its number from 0.

    ``answers`` has all rows, NaN where there is none: what was computed is not lost.
    """

    def __init__(self, rows: dict[int, str], answers: Optional[Floats] = None):
        self.rows, self.answers = rows, answers
        shown = [f"row {row}: {why}" for row, why in list(rows.items())[:5]]
        more = [f"and {len(rows) - 5} rows more"] if len(rows) > 5 else []
        super().__init__("\n".join([*shown, *more, 'missing=NUMBER takes a number in the place of an exception']))

    def __reduce__(self) -> tuple[type, tuple[dict[int, str], Optional[Floats]]]:  # between processes
        return NoAnswer, (self.rows, self.answers)


class MissingPackage(WytheError, ImportError):
    """A Python package that this call needs is not installed."""


def refused(path: str, value: object, problem: str, cure: str) -> InputError:
    """An InputError with one fault."""
    return InputError([Fault(path=path, value=str(value), problem=problem, cure=cure)])


def names_of(name: str, value: Union[None, str, Iterable[str]]) -> list[str]:
    """A list of names; one name may stand alone."""
    if isinstance(value, str):
        return [value]
    try:
        return list(() if value is None else value)
    except TypeError:
        raise refused(name, type(value).__name__, "is no list of names", "write them as a list of texts") from None


def path_of(name: str, value: Path) -> str:
    """A path as text; ``name`` is the argument it stands in."""
    try:
        path = os.fsdecode(value)
    except TypeError:
        raise refused(name, type(value).__name__, "is no path", 'write it as text, e.g. "model.toml"') from None
    if not path:
        raise refused(name, "", "is empty", "name a file or folder")
    if "\0" in path:
        raise refused(name, repr(path), "holds a zero byte", "no file is called so")
    return path


def folder_of(out: Optional[Path]) -> Optional[str]:
    """The folder that ``out`` names, or None."""
    return None if out is None else path_of("out", out)


def write_text(path: Path, text: str) -> None:
    """Writes a text file."""
    name = path_of("path", path)
    try:
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        raise AccessError(f"{name}: {error.strerror}") from error


@contextlib.contextmanager
def needed_for(purpose: str) -> Iterator[None]:
    """Around the import of a package, when it is first needed: where it is missing, says so with the cure."""
    try:
        yield
    except ImportError as error:
        package = (error.name or "").split(".")[0]
        raise MissingPackage(
            f"{purpose} needs the Python package {package}, which this interpreter does not have; "
            f"on Debian install python3-{package}"
        ) from error
