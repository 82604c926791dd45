"""Dataclasses from JSON files, each value checked: a damaged file is named, with the place and the remedy."""

from __future__ import annotations

import json
from dataclasses import MISSING, fields, is_dataclass
from math import isfinite
from pathlib import Path
from types import UnionType
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

from flexel.base.errors import FlexelError

T = TypeVar("T")


def read_json(kind: type[T] | Any, file: Path, remedy: str) -> Any:
    """The content of a file.

    Parameters
    ----------
    kind : type
        Of the content: a dataclass, ``list[...]``, ``dict[str, ...]``, or a union of such.
    remedy : str
        The command that writes the file again.

    Raises
    ------
    FlexelError
        It cannot be read, is not JSON, or holds something else.
    """
    try:
        text = file.read_text(encoding="utf-8")
        value = json.loads(text, parse_int=_whole, parse_float=_number, parse_constant=_number)
        return _read(kind, value, "the file")
    except OSError as error:
        raise FlexelError(f"{file}: {error.strerror}; write it again: {remedy}") from error
    except _WrongError as error:
        raise FlexelError(f"{file}: {error}; write it again: {remedy}") from error
    except (ValueError, RecursionError) as error:  # not UTF-8, not JSON, nested without end
        raise FlexelError(f"{file}: not JSON ({error}); write it again: {remedy}") from error


def _number(written: str) -> float:
    """A number that a computer has; NaN and infinities are not JSON."""
    value = float(written)
    if not isfinite(value):
        raise ValueError(f"{written[:20]} is not a finite number")
    return value


def _whole(written: str) -> int:
    """A whole number that is a finite number too."""
    _number(written)
    return int(written)


class _WrongError(Exception):
    """A value is not of the kind that belongs in its place."""


def _read(kind: Any, value: Any, place: str) -> Any:
    """The value as `kind`, or an error that names the place."""
    if kind is Any:
        return value
    if is_dataclass(kind):
        return _record(kind, value, place)
    origin, inner = get_origin(kind), get_args(kind)
    if origin is UnionType:
        return _read(_of_union(inner, value), value, place)
    if origin is list:
        return [_read(inner[0], z, f"{place}[{i}]") for i, z in enumerate(_plain(list, value, place))]
    if origin is dict:
        return {key: _read(inner[1], z, f"{place}.{key}") for key, z in _plain(dict, value, place).items()}
    return _plain(kind, value, place)


def _of_union(kinds: tuple[Any, ...], value: Any) -> Any:
    """The kind of a union that a value is meant to be: null, a list, or the other."""
    for kind in kinds:
        if (kind is type(None)) == (value is None) and (get_origin(kind) is list) == isinstance(value, list):
            return kind
    return kinds[0]


def _record(kind: Any, value: Any, place: str) -> Any:
    """A dataclass from an object; keys that it does not have are left out."""
    given = _plain(dict, value, place)
    hints = get_type_hints(kind)
    found = {}
    for field in fields(kind):
        if field.name in given:
            found[field.name] = _read(hints[field.name], given[field.name], f"{place}.{field.name}")
        elif field.default is MISSING and field.default_factory is MISSING:
            raise _WrongError(f"{place} has no '{field.name}'")
    return kind(**found)


def _plain(kind: type, value: Any, place: str) -> Any:
    """A value of a plain kind; a whole number is a float too, a truth value is not a number."""
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
        raise _WrongError(f"{place} is {_shown(value)}, not {NAMES.get(kind, kind.__name__)}")
    return value


def _shown(value: Any) -> str:
    """A value, cut where it is long."""
    written = json.dumps(value)
    return written if len(written) < 40 else f"{written[:40]}…"


NAMES = {
    float: "a number",
    int: "a whole number",
    str: "a string",
    bool: "true or false",
    list: "a list",
    dict: "an object",
    type(None): "null",
}
