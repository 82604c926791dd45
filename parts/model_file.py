"""Files of models: JSON with the parts as they were declared.

Functions and compiled elements are written by the names by which they are imported; loading such a file imports their
modules.  Nothing else in a file is executed.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import path_of, unknown
from flexel.base.errors import FlexelError, ModelError
from flexel.base.files import replacing
from flexel.model.part import Part
from flexel.parts.method import METHOD_OF
from flexel.parts.written import (
    arguments_of,
    constructor_named,
    constructor_of,
    import_name,
    imported,
    listed,
)

FORMAT, VERSION = "flexel model", 1


def write_model(gravity: Any, parts: tuple[Part[Any], ...], path: str | Path) -> Path:
    """Write a model to a file; it is written completely, or the old one remains.

    Raises
    ------
    ModelError
        A function or an object that cannot be imported, named by its part; a suffix other than .json.
    FlexelError
        If the file cannot be written.
    """
    path = path_of(path, "save")
    if path.suffix.lower() != ".json":
        raise ModelError(f"save '{path}': a model is saved as JSON; give a name that ends in .json")
    rows = [_written(part) for part in parts]
    head = json.dumps({"format": FORMAT, "version": VERSION, "gravity": gravity.tolist()})[:-1]
    listed = ",\n".join(json.dumps(row, ensure_ascii=False) for row in rows)  # a line for each part
    with replacing(path, "save") as target:
        target.write_text(f'{head}, "parts": [\n{listed}\n]}}\n', encoding="utf-8")
    return path


def read_parts(path: Path) -> tuple[list[float], list[Part[Any]]]:
    """Read gravity and parts from a file that was written by `write_model`.

    Raises
    ------
    ModelError
        A file that is missing, damaged, or from another program; an unknown part, by name.
    """
    owner = f"load '{path}'"
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ModelError(
            f"{owner}: it cannot be read ({error}); give a file written by Model.save"
        ) from error
    if not isinstance(content, Mapping) or content.get("format") != FORMAT:
        raise ModelError(f"{owner}: this is not a flexel model; give a file written by Model.save")
    if content.get("version") != VERSION:
        raise ModelError(
            f"{owner}: its version is {content.get('version')!r:.20}, but this flexel reads {VERSION}; update flexel"
        )
    try:
        return list(content["gravity"]), [
            _part(row, f"{owner}: part {i}") for i, row in enumerate(content["parts"], 1)
        ]
    except FlexelError:
        raise
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        raise ModelError(
            f"{owner}: it is malformed ({error!r:.100}); use a backup copy of the file"
        ) from error


def _written(part: Part[Any]) -> dict[str, Any]:
    """Write a part: its method, or the import name of its class, and the fields that differ from their defaults."""
    method = METHOD_OF.get(type(part))
    kind: Any = method or list(import_name(type(part), part.owner, "class"))
    return {"part": kind} | {key: _plain(value, part.owner, key) for key, value in arguments_of(part).items()}


def _plain(value: Any, owner: str, what: str) -> Any:
    """Convert a value to JSON; another type becomes an object with one key that says what it is."""
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, np.generic):
        return _plain(value.item(), owner, what)
    if isinstance(value, complex):
        return {"complex": [value.real, value.imag]}
    if isinstance(value, np.ndarray):
        found = listed(value)
        return {"zeros": value.shape} if found is None else {"array": _plain(found, owner, what)}
    if isinstance(value, list):
        return [_plain(item, owner, what) for item in value]
    if isinstance(value, tuple):
        return {"tuple": [_plain(item, owner, what) for item in value]}
    if isinstance(value, Mapping):
        return {
            "dict": [[_plain(key, owner, what), _plain(item, owner, what)] for key, item in value.items()]
        }
    if kind := constructor_of(value):
        given = {key: _plain(item, owner, key) for key, item in arguments_of(value).items()}
        return {"object": kind, "arguments": given}
    return {"import": list(import_name(value, owner, what))}


def _part(row: Mapping[str, Any], owner: str) -> Part[Any]:
    """Read the part in a row of a file."""
    kinds = {method: kind for kind, method in METHOD_OF.items()}
    named = row["part"]
    if isinstance(named, list):
        kind = imported(str(named[0]), str(named[1]), owner)
        if not isinstance(kind, type) or not issubclass(kind, Part):
            raise ModelError(
                f"{owner}: {named[1]} is not a known part; load the file with the module that defines it"
            )
    elif named in kinds:
        kind = kinds[named]
    else:
        raise ModelError(f"{owner}: {unknown(str(named), kinds, 'part')}")
    found: Part[Any] = _called(
        kind, {key: value for key, value in row.items() if key != "part"}, f"{owner} ({named})"
    )
    return found


def _called(kind: Any, arguments: Mapping[str, Any], owner: str) -> Any:
    """Make a part or another object with the arguments in a file."""
    given = {key: _value(value, owner) for key, value in arguments.items()}
    try:
        return kind(**given)
    except FlexelError as error:
        raise type(error)(f"{owner}: {error}") from error
    except TypeError as error:
        raise ModelError(f"{owner}: {error}; use a backup copy of the file") from error


def _value(plain: Any, owner: str) -> Any:
    """Read a value that `_plain` wrote."""
    if isinstance(plain, list):
        return [_value(item, owner) for item in plain]
    if not isinstance(plain, Mapping):
        return plain
    if "array" in plain:
        return np.array(_value(plain["array"], owner))
    if "zeros" in plain:
        return np.zeros(tuple(plain["zeros"]))
    if "complex" in plain:
        return complex(*plain["complex"])
    if "tuple" in plain:
        return tuple(_value(item, owner) for item in plain["tuple"])
    if "dict" in plain:
        return {_value(key, owner): _value(item, owner) for key, item in plain["dict"]}
    if "import" in plain:
        return imported(str(plain["import"][0]), str(plain["import"][1]), owner)
    return _called(constructor_named(str(plain["object"]), owner), plain["arguments"], owner)
