"""Reads dataclasses from JSON files and checks each value: errors name the file, the position and the remedy."""

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
    """Read the content of a file.

    Parameters
    ----------
    kind : type
        Type of the content: a dataclass, ``list[...]``, ``dict[str, ...]``, or a union of such.
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
    except (ValueError, RecursionError) as error:  # not UTF-8, not JSON, or nested too deeply
        raise FlexelError(f"{file}: not JSON ({error}); write it again: {remedy}") from error


def _number(written: str) -> float:
    """Return a float within range; NaN and infinities are not JSON."""
    value = float(written)
    if not isfinite(value):
        raise ValueError(f"{written[:20]} is not a finite number")
    return value


def _whole(written: str) -> int:
    """Return an integer that is also a finite float."""
    _number(written)
    return int(written)


class _WrongError(Exception):
    """A value has the wrong kind for its position."""


def _read(kind: Any, value: Any, place: str) -> Any:
    """Return the value as `kind`, or raise an error that names the position."""
    if kind is Any:
        return value
    if is_dataclass(kind):
        return _record(kind, value, place)
    origin, inner = get_origin(kind), get_args(kind)
    if origin is UnionType:
        return _read(_of_union(inner, value), value, place)
    if origin is list:
        return [_read(inner[0], item, f"{place}[{i}]") for i, item in enumerate(_plain(list, value, place))]
    if origin is dict:
        return {
            key: _read(inner[1], item, f"{place}.{key}") for key, item in _plain(dict, value, place).items()
        }
    return _plain(kind, value, place)


def _of_union(kinds: tuple[Any, ...], value: Any) -> Any:
    """Return the kind of a union that fits a value: null, a list, or the other."""
    for kind in kinds:
        if (kind is type(None)) == (value is None) and (get_origin(kind) is list) == isinstance(value, list):
            return kind
    return kinds[0]


def _record(kind: Any, value: Any, place: str) -> Any:
    """Make a dataclass from an object; unknown keys are ignored."""
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
    """Return a value of a plain kind; an integer is a float too, a boolean is not a number."""
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
        raise _WrongError(f"{place} is {_shown(value)}, not {NAMES.get(kind, kind.__name__)}")
    return value


def _shown(value: Any) -> str:
    """Write a value, shortened if it is long."""
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
