"""What calls take, by name: the types of their arguments."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Literal, Protocol, SupportsFloat, TypeAlias, Union

if TYPE_CHECKING:  # NumPy is imported by the calls that need it
    from numpy import float64
    from numpy.typing import ArrayLike, NDArray

#: A column of numbers.
Floats: TypeAlias = "NDArray[float64]"
Path: TypeAlias = "Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]"
Language: TypeAlias = Literal["en", "it", "de", "fr", "es", "pt"]
#: (what, share, displacement_mm, force_kN)
Hear: TypeAlias = Callable[[str, float, float, float], object]
#: True or False, None (a bar where somebody can see it), or a function that hears.
Progress: TypeAlias = Union[bool, None, Hear]


class Measured(Protocol):
    """A quantity of another package, e.g. pint: numbers and their unit."""

    @property
    def magnitude(self) -> SupportsFloat: ...
    @property
    def units(self) -> object: ...


class Listed(Protocol):
    """Numbers of NumPy or pandas."""

    def tolist(self) -> object: ...


class Tables(Protocol):
    """A section of a model, or a list of them."""

    def to_dict(self) -> object: ...


#: What a model file holds.
Plain: TypeAlias = "Union[str, float, list[Plain], dict[str, Plain]]"
#: What a key of a model may be given.
Value: TypeAlias = "Union[str, float, tuple[float, str], Measured, Listed, Tables, Sequence[Value], Mapping[str, Value]]"
#: What to change for one call: {"wall.length": "5 m"}, or texts "path=value".
Settings: TypeAlias = "Union[None, str, Mapping[str, Value], Sequence[str]]"


class Titled(Protocol):
    """Columns by title: a mapping, or a data frame."""

    def items(self) -> Iterable[tuple[object, object]]: ...


#: {path: values}, {path: (values, unit)}, a data frame with columns "path [unit]", or a matrix (rows, columns).
Inputs: TypeAlias = "Union[Titled, ArrayLike]"
