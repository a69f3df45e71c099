"""What can go wrong, and how Python hears of it."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any


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


class WytheError(Exception):
    """Anything that wythe refuses or cannot do."""


class InputError(WytheError, ValueError):
    """Inputs that are not admissible. ``faults`` has all of them, not only the first."""

    def __init__(self, faults: Iterable[Fault]):
        self.faults: list[Fault] = list(faults)
        super().__init__("\n".join(str(fault) for fault in self.faults))


class AccessError(WytheError, OSError):
    """A file or folder that is missing, cannot be written, is damaged, or is in use."""


class DefectError(WytheError, RuntimeError):
    """A defect of wythe itself. Please report it."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a computation. ``result`` holds what was done until then, or None."""

    def __init__(self, result: Any = None):
        self.result = result
        super().__init__("stopped" if result is None else "stopped; .result has what was done until then")


class MissingPackage(WytheError, ImportError):
    """A Python package that this call needs is not installed."""


def needed(name: str, purpose: str) -> Any:
    """Imports a package when it is first needed; where it is missing, says so with the cure."""
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.split(".")[0]
        raise MissingPackage(
            f"{purpose} needs the Python package {package}, which this interpreter does not have; "
            f"on Debian install python3-{package}"
        ) from error
