"""Models as objects: read, build and change them key by key, with units, checked at once.

    model = wythe.Model.read("model.toml")
    model.wall.length = "5.1 m"                          # a text with its unit,
    model.material["joint"].cohesion = (0.2, "MPa")      # a number with its unit, or a pint quantity
    model["stage.push.velocity"] = "5 mm/s"              # the path as in `wythe run --set`
"""

from __future__ import annotations

import copy
import difflib
import functools
import json
import os
import re
import tomllib
from collections.abc import Iterable, Iterator
from html import escape
from typing import TYPE_CHECKING, Any, Optional, TypeAlias, TypeGuard, Union

from ._errors import AccessError, Fault, InputError, MadeText, NoMember, path_of, refused, write_text
from ._jobs import perform
from ._results import Check
from ._types import Measured, Path, Plain, Value

if TYPE_CHECKING:  # it takes a tenth of the time of import wythe
    from .answers import Key

_NUMBER = re.compile(r"\s*([-+]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")
_QUANTITIES = ("quantity", "quantities", "points")


class Quantity(str):
    """A number with its unit, as a model file writes it: "5.10 m". ``.value`` and ``.unit`` are its parts."""

    def __new__(cls, text: str, *more: object) -> Quantity:
        if more or not isinstance(text, str):
            raise TypeError(f"{(text, *more)!r:.60} is no text with a unit: write Quantity(\"5.10 m\")")
        return super().__new__(cls, text)

    @property
    def value(self) -> float:
        """The number, in the unit that stands beside it."""
        match = _NUMBER.fullmatch(self)
        if match is None:
            raise ValueError(f"{str(self)!r} is not a number with a unit")
        return float(match.group(1).replace("_", ""))

    @property
    def unit(self) -> str:
        """The unit as it is written, "" where there is none."""
        match = _NUMBER.fullmatch(self)
        return match.group(2) if match else ""


@functools.cache
def keys() -> dict[str, Key]:
    """Every key that a model file may have, by its path: kind, unit, allowed values, default, meaning.

    In a path ``[]`` stands for the members of a list and ``<name>`` for a name: ``stage[].velocity``,
    ``material.<name>.cohesion``.
    """
    return perform("keys", lambda job: {key["path"]: key for key in job.json("keys")}, {})


@functools.cache
def _children(path: str) -> dict[str, Key]:
    """The keys of one table, by name."""
    head = path + "." if path else ""
    found = {p[len(head) :]: key for p, key in keys().items() if p.startswith(head)}
    return {name: key for name, key in found.items() if "." not in name and "[" not in name}


def _no_member(path: str, members: Iterable[str]) -> NoMember:
    return NoMember([Fault(path=path, problem="no such member", cure=f"there are: {', '.join(members) or 'none'}")])


def as_text(value: object) -> Optional[str]:
    """A quantity as text: "5 m", (5, "m"), or an object with magnitude and units (pint). None: it is none."""
    if isinstance(value, str):
        return value
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
        try:
            return f"{float(value[0])!r} {value[1]}"
        except (TypeError, ValueError, OverflowError):
            raise refused("quantity", value, "is no number with a unit", 'write e.g. (5, "m")') from None
    if is_measured(value):
        return f"{float(value.magnitude)!r} {unit_of(value)}"
    return None


def is_measured(value: object) -> TypeGuard[Measured]:
    """Whether it is a quantity of pint or the like."""
    return hasattr(value, "magnitude") and hasattr(value, "units")


def unit_of(value: Measured) -> str:
    """Its unit as wythe reads it."""
    return f"{value.units:~}".replace(" ** ", "^").replace("**", "^")


def as_setting(path: str, value: Value) -> str:
    """"path=value" as `wythe run --set` takes it."""
    text = as_text(value)
    if text is not None:
        return f"{path}={text}"
    return f"{path}={_toml(_plain(value))}"


def _plain(value: object) -> object:
    """NumPy numbers and lists of them as Python's own, sections as dictionaries."""
    if isinstance(value, (Section, SectionList)):
        return value.to_dict()
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, dict):
        return {str(name): _plain(inner) for name, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(inner) for inner in value]
    return value


def _checked(path: str, key: Key, value: object) -> object:
    """The value as the file holds it. The engine checks ranges and units; this, what it could not tell."""
    kind = key["kind"]
    example = key.get("example", "")
    if kind == "quantity":
        text = as_text(value)
        if text is None:
            raise refused(path, value, "is a number without a unit" if _is_number(value) else "is no quantity",
                         f'write it with its unit, e.g. "{example}"' if example else 'write e.g. "5 m"')
        return Quantity(text)
    if kind in ("quantities", "points"):
        if isinstance(value, (str, tuple)) and kind == "quantities" and as_text(value) is not None:
            raise refused(path, value, "is one quantity", "give a list of them")
        value = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(value, (list, tuple)):
            raise refused(path, value, "is no list", f"write e.g. {example or '5 mm in brackets'}")
        return [_quantity_row(path, row, example) for row in value]
    if kind == "flag" and not isinstance(value, bool):
        raise refused(path, value, "is neither true nor false", "write True or False")
    if kind == "word" and value not in key["words"]:
        raise refused(path, value, "is no word that is known here", "write one of: " + ", ".join(key["words"]))
    if kind in ("number", "integer") and not isinstance(value, str):
        value = _plain(value)
        if not _is_number(value):
            raise refused(path, value, "is no number", f"write e.g. {example}" if example else "write a number")
        if kind == "integer" and value != int(value):
            raise refused(path, value, "is no whole number", "write a whole number")
        return int(value) if kind == "integer" else value
    if kind == "text" and not isinstance(value, str):
        raise refused(path, value, "is no text", f'write e.g. "{example}"' if example else "write a text")
    return _plain(value)


def _quantity_row(path: str, value: object, example: str) -> object:
    text = as_text(value)
    if text is not None:
        return Quantity(text)
    if isinstance(value, (list, tuple)):
        return [_quantity_row(path, inner, example) for inner in value]
    raise refused(path, value, "is a number without a unit", f"write it with its unit, e.g. {example or '5 m'}")


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _members(path: str, kind: str, value: Any) -> Any:
    """The members of a table (a dictionary) or of a list of tables, as what is to be put in their place."""
    value = value.to_dict() if isinstance(value, (Section, SectionList)) else value
    if kind == "list":
        if isinstance(value, (list, tuple)) and all(isinstance(member, (dict, Section)) for member in value):
            return [member.to_dict() if isinstance(member, Section) else member for member in value]
        raise refused(path, type(value).__name__, "is no list of tables", 'write [{"name": ...}, ...]')
    if isinstance(value, dict):
        return value
    raise refused(path, type(value).__name__, "is no table", 'write {"key": value}')


def _key(path: str, pattern: str, name: str) -> Key:
    """What a table's key is."""
    children = _children(pattern)
    if not isinstance(name, str):
        raise refused(_under(path, repr(name)), "", "is no name of a key", "write it as text")
    if name in children:
        return children[name]
    near = difflib.get_close_matches(name, children, n=1)
    cure = f"did you mean {near[0]}?" if near else "known here are " + ", ".join(sorted(children))
    raise refused(_under(path, name), "", "no such key", cure)


def _help(path: str, pattern: str, name: str) -> str:
    lines = []
    for key_name, key in ({name: _key(path, pattern, name)} if name else _children(pattern)).items():
        parts = [key["meaning"]]
        if key.get("unit"):
            parts.append(f"Unit: {key['unit']}.")
        if key.get("allowed"):
            parts.append(f"Allowed: {key['allowed']}.")
        if key.get("words"):
            parts.append(f"One of: {', '.join(key['words'])}.")
        if key.get("default"):
            parts.append(f"Default: {key['default']}.")
        lines.append(f"{key_name}: " + " ".join(parts))
    return "\n".join(lines)


class Section:
    """One table of a model: its keys are attributes and members. An unknown key is refused with advice."""

    def __init__(self, model: Model, data: dict[str, Any], path: str, pattern: str):
        object.__setattr__(self, "_model", model)
        object.__setattr__(self, "_data", data)
        object.__setattr__(self, "_path", path)
        object.__setattr__(self, "_pattern", pattern)

    def _key(self, name: str) -> Key:
        return _key(self._path, self._pattern, name)

    def _child(self, name: str) -> Any:
        key = self._key(name)
        path, pattern = _under(self._path, name), _under(self._pattern, name)
        if key["kind"] == "table":
            return Section(self._model, self._data.setdefault(name, {}), path, pattern)
        if key["kind"] == "map":
            return SectionMap(self._model, self._data.setdefault(name, {}), path, pattern + ".<name>")
        if key["kind"] == "list":
            return SectionList(self._model, self._data.setdefault(name, []), path, pattern + "[]")
        if name not in self._data:
            return None
        value = self._data[name]
        return Quantity(value) if key["kind"] == "quantity" and isinstance(value, str) else value

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._child(name)
        except InputError as error:
            raise AttributeError(str(error)) from None

    def __setattr__(self, name: str, value: Value) -> None:
        self[name] = value

    def __delattr__(self, name: str) -> None:
        del self[name]

    def __getitem__(self, name: str) -> Any:
        return self._child(name)

    def __setitem__(self, name: str, value: Value) -> None:
        key = self._key(name)
        path = _under(self._path, name)
        try:
            if key["kind"] in ("table", "map", "list"):
                self._replace(name, key["kind"], _members(path, key["kind"], value))
                return
            self._data[name] = _checked(path, key, value)
        except RecursionError:
            raise refused(path, type(value).__name__, "holds itself, or too many levels", "give a plain value") from None
        self._model._touch()

    def _replace(self, name: str, kind: str, value: Any) -> None:
        was = self._data.get(name)
        self._data[name] = [] if kind == "list" else {}
        try:
            inner = self._child(name)
            for member in value if kind == "list" else value.items():
                inner.append(member) if kind == "list" else inner.__setitem__(*member)
        except Exception:
            if was is None:
                del self._data[name]
            else:
                self._data[name] = was
            raise
        self._model._touch()

    def __delitem__(self, name: str) -> None:
        self._key(name)
        self._data.pop(name, None)
        self._model._touch()

    def __contains__(self, name: str) -> bool:
        return name in self._data

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *_children(self._pattern)]

    def to_dict(self) -> dict[str, Plain]:
        """A copy of this table as a plain dictionary."""
        return copy.deepcopy(self._data)

    def help(self, name: str = "") -> str:
        """What a key means, its unit and what is allowed; without a name, a line for each key."""
        return _help(self._path, self._pattern, name)

    def __repr__(self) -> str:
        return f"<{self._path or 'model'}: {_toml_table(self._data).strip()}>"


class SectionMap(Section):
    """Tables by name, e.g. the materials: ``model.material["joint"]``."""

    def _key(self, name: str) -> Key:
        if not isinstance(name, str):
            raise refused(_under(self._path, repr(name)), "", "is no name", "write it as text")
        return {"path": _under(self._pattern, name), "kind": "table", "meaning": "a member by its name"}

    def _child(self, name: str) -> Any:
        return Section(
            self._model, self._data.setdefault(name, {}), _under(self._path, name), self._pattern
        )

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._data:
            raise AttributeError(f"{self._path} has no member {name!r}")
        return self._child(name)

    def __getitem__(self, name: str) -> Any:
        self._key(name)
        if name not in self._data:  # a new one is made by giving it its keys: material["new"] = {...}
            raise _no_member(_under(self._path, name), self._data)
        return self._child(name)

    def _replace(self, name: str, kind: str, value: Any) -> None:
        was = self._data.get(name)
        self._data[name] = {}
        try:
            inner = Section(self._model, self._data[name], _under(self._path, name), self._pattern)
            for key, member in value.items():
                inner[key] = member
        except Exception:
            if was is None:
                del self._data[name]
            else:
                self._data[name] = was
            raise
        self._model._touch()

    def __dir__(self) -> list[str]:
        return [*object.__dir__(self), *self._data]


class SectionList:
    """Tables in order, e.g. the stages: by number, or by their name: ``model.stage["push"]``."""

    def __init__(self, model: Model, data: list[dict[str, Any]], path: str, pattern: str):
        self._model, self._data, self._path, self._pattern = model, data, path, pattern

    def _at(self, place: Union[int, str]) -> int:
        if isinstance(place, int):
            return range(len(self._data))[place]
        for number, member in enumerate(self._data):
            if member.get("name") == place:
                return number
        names = (str(member.get("name", number)) for number, member in enumerate(self._data))
        raise _no_member(_under(self._path, str(place)), names)

    def __getitem__(self, place: Union[int, str]) -> Section:
        number = self._at(place)
        return Section(self._model, self._data[number], f"{self._path}.{number}", self._pattern)

    def __delitem__(self, place: Union[int, str]) -> None:
        del self._data[self._at(place)]
        self._model._touch()

    def __len__(self) -> int:
        return len(self._data)

    def __iter__(self) -> Iterator[Section]:
        return (self[number] for number in range(len(self._data)))

    def append(self, member: Optional[Value] = None, /, **keys: Value) -> Section:
        """Adds a member: ``model.stage.append(name="push", velocity="5 mm/s", targets=["20 mm"])``."""
        self._data.append({})
        section = self[len(self._data) - 1]
        try:
            for name, value in {**_members(self._path, "table", {} if member is None else member), **keys}.items():
                section[name] = value
        except Exception:
            self._data.pop()
            raise
        self._model._touch()
        return section

    def help(self, name: str = "") -> str:
        """What a key of a member means, its unit and what is allowed; without a name, a line for each key."""
        return _help(self._path, self._pattern, name)

    def to_dict(self) -> list[dict[str, Plain]]:
        """A copy of the members as plain dictionaries."""
        return copy.deepcopy(self._data)

    def __repr__(self) -> str:
        return f"<{self._path}: {len(self)} members>"


class Model(Section):
    """A model of a wall: the content of a model file, with every key as an attribute.

    It holds the text alone; what stands in other files (blocks, records) is read from ``folder`` when a call
    needs it. A call takes the model as it is at that moment: later changes do not reach it.
    """

    def __init__(self, text: str = "", file: Path = "model.toml"):
        if not isinstance(text, str):
            raise refused("model", type(text).__name__, "is no text", "read a file by wythe.Model.read(path)")
        name = path_of("file", file)
        if text.strip().endswith(".toml") and "\n" not in text.strip():
            raise refused("model", f"{text!r:.60}", "is the name of a file, and a model is its text",
                         f"read it by wythe.Model.read({text.strip()!r:.60})")
        try:
            data = tomllib.loads(text)
        except RecursionError:
            raise InputError([Fault(file=name, problem="has brackets within brackets, too deep",
                                    cure="no model needs that")]) from None
        except tomllib.TOMLDecodeError as error:
            raise InputError([Fault(file=name, problem=f"is not TOML: {error}",
                                    cure="mend that line")]) from error
        object.__setattr__(self, "_text", text)
        object.__setattr__(self, "_file", name)
        object.__setattr__(self, "_is_changed", False)
        super().__init__(self, data, "", "")

    @classmethod
    def read(cls, path: Path) -> Model:
        """Reads a model file."""
        name = path_of("path", path)
        try:
            with open(name, encoding="utf-8") as file:
                text = file.read()
        except UnicodeDecodeError as error:
            raise InputError([Fault(file=name, problem=f"is no UTF-8 text: {error}",
                                    cure="save it as UTF-8")]) from error
        except OSError as error:
            raise AccessError(f"{name}: {error.strerror}") from error
        return cls(text, name)

    @classmethod
    def parse(cls, text: str, file: Path = "model.toml") -> Model:
        """The model of a TOML text; ``file`` names it in messages, and files it names lie beside that."""
        return cls(text, file)

    def _touch(self) -> None:
        object.__setattr__(self, "_text", None)
        object.__setattr__(self, "_is_changed", True)

    def _told(self) -> str:
        return MadeText(self.text) if self._is_changed else self.text

    @property
    def file(self) -> str:
        """Its file, by which messages call it and beside which the files lie that it names."""
        return str(self._file)

    @property
    def text(self) -> str:
        """The model as TOML; what it was read from, as long as nothing was changed."""
        if self._text is None:
            object.__setattr__(self, "_text", _toml_table(self._data))
        return str(self._text)

    def write(self, path: Path) -> None:
        """Writes a model file."""
        write_text(path, self.text)

    def copy(self) -> Model:
        """A copy; changes of one do not reach the other."""
        other = Model(self.text, self._file)
        object.__setattr__(other, "_is_changed", self._is_changed)
        return other

    # A path is taken as in `wythe run --set`: "wall.length", "stage.push.velocity", "wall.opening.0.width".
    def _walk(self, path: str, makes: bool) -> tuple[Any, str]:
        here: Any = self
        parts = path.split(".")
        for part in parts[:-1]:
            if isinstance(here, SectionList):
                here = here[int(part) if part.isdigit() else part]
            elif isinstance(here, SectionMap) and not makes:
                here = here[part]
            elif isinstance(here, Section):
                here = here._child(part)
            if not isinstance(here, (Section, SectionList)):
                raise refused(path, "", f"{part} has no keys of its own", "shorten the path")
        return here, parts[-1]

    def __getitem__(self, path: str) -> Any:
        if not isinstance(path, str) or "." not in path:
            return self._child(path)
        here, last = self._walk(path, False)
        return here[int(last) if isinstance(here, SectionList) and last.isdigit() else last]

    def __setitem__(self, path: str, value: Value) -> None:
        if not isinstance(path, str) or "." not in path:
            super().__setitem__(path, value)
            return
        here, last = self._walk(path, True)
        if isinstance(here, SectionList):
            raise refused(path, value, "is a member of a list", f"change its keys, or use {path}.<key>")
        here[last] = value

    def _repr_html_(self) -> str:
        try:
            return perform("check", Check, {"model": self._told(), "file": self.file})._repr_html_()
        except InputError as error:
            return f"<pre>{escape(str(error))}</pre>"


#: A path of a model file, or a Model.
ModelLike: TypeAlias = Union[Path, Model]


def _under(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name


# --- TOML ----------------------------------------------------------------------------------------------

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def _toml_key(name: str) -> str:
    return name if _BARE.fullmatch(name) else _toml(str(name))


def _toml(value: object) -> str:
    """One value as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return {"inf": "inf", "-inf": "-inf", "nan": "nan"}.get(repr(value), repr(value))
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list):
        return "[" + ", ".join(_toml(inner) for inner in value) + "]"
    if isinstance(value, dict):
        inner = ", ".join(f"{_toml_key(name)} = {_toml(item)}" for name, item in value.items())
        return "{" + inner + "}"
    return _toml(str(value))


def _is_table_list(value: object) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(item, dict) for item in value)


def _toml_table(data: dict[str, Any], path: str = "") -> str:
    """A table with the tables inside it; empty ones are left out."""
    lines = [
        f"{_toml_key(name)} = {_toml(value)}\n"
        for name, value in data.items()
        if not isinstance(value, dict) and not _is_table_list(value) and value != []
    ]
    for name, value in data.items():
        inner = _under(path, _toml_key(name))
        if isinstance(value, dict) and value:
            text = _toml_table(value, inner)
            own = any(not isinstance(v, dict) and not _is_table_list(v) for v in value.values())
            lines.append(f"\n[{inner}]\n{text}" if own else text)
        elif _is_table_list(value):
            lines.extend(f"\n[[{inner}]]\n{_toml_table(item, inner)}" for item in value)
    return "".join(lines)
