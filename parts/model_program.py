"""The Python program that builds a model, from its parts."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from itertools import chain, repeat
from math import isfinite
from typing import Any

import numpy as np

from flexel.model.part import Part, is_same
from flexel.parts.method import METHOD_OF
from flexel.parts.written import constructor_of, import_name, listed, split_arguments

WIDTH = 110
INDENT = "    "


def program(gravity: Any, parts: Iterable[Part[Any]], name: str = "m") -> str:
    """Write the program that builds a model.

    Parameters
    ----------
    gravity : ndarray
        [m/s²]
    parts : iterable of Part
    name : str
        Of the variable that holds the model.

    Raises
    ------
    ModelError
        A function or an object that cannot be imported, named by its part.
    """
    modules: dict[str, None] = {}
    lines = [statement(part, name, modules) for part in parts]
    head = ["import flexel as fx", *(f"import {module}" for module in sorted(modules))]
    return "\n".join([*sorted(head), "", empty_model(gravity, name), *lines, ""])


def empty_model(gravity: Any, name: str) -> str:
    """Write the line that makes a model without parts."""
    g = tuple(gravity.tolist())
    given = "" if is_same(g, (0.0, 0.0, 0.0)) else f"gravity={literal(g)}"
    return f"{name} = fx.Model({given})"


def literal(value: Any, owner: str = "") -> str:
    """Write the Python expression of a value that needs no import."""
    return _text(value, owner, "value", {})


def statement(part: Part[Any], name: str, modules: dict[str, None]) -> str:
    """Write the call that declares a part, on one line if it fits.

    Parameters
    ----------
    part : Part
    name : str
        Of the variable that holds the model.
    modules : dict
        Gets the modules that the program must import.

    Raises
    ------
    ModelError
        A function or an object that cannot be imported, named by its part.
    """
    positional, named = part.call()
    labels = chain((item.name for item in fields(part)), repeat("argument"))
    written = [
        _text(value, part.owner, label, modules) for label, value in zip(labels, positional, strict=False)
    ]
    written += [f"{key}={_text(value, part.owner, key, modules)}" for key, value in named.items()]
    method = METHOD_OF.get(type(part))
    start = f"{name}.{method}(" if method else f"{name}.add({_class(part, modules)}("
    end = ")" if method else "))"
    line = start + ", ".join(written) + end
    if len(line) <= WIDTH:
        return line
    return "\n".join([start, *filled(written), end])


def filled(items: Sequence[str]) -> list[str]:
    """Write indented lines of items with commas, as many on a line as fit."""
    lines = [""]
    for item in items:
        if lines[-1] and len(lines[-1]) + len(item) + 6 > WIDTH:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + item + ","
    return [f"{INDENT}{line}" for line in lines]


def _class(part: Part[Any], modules: dict[str, None]) -> str:
    return _imported(type(part), part.owner, "class", modules)


def _text(value: Any, owner: str, what: str, modules: dict[str, None]) -> str:
    """Write the Python expression of a value."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, np.generic):
        return _text(value.item(), owner, what, modules)
    if isinstance(value, np.ndarray):
        found = listed(value)
        if found is None:
            modules["numpy"] = None
            return f"numpy.zeros({value.shape})"
        return _text(found, owner, what, modules)
    if isinstance(value, float) and not isfinite(value):
        return f'float("{value}")'
    if value is None or isinstance(value, (bool, int, float)):
        return repr(value)
    if isinstance(value, complex):
        return f"complex({', '.join(_text(x, owner, what, modules) for x in (value.real, value.imag))})"
    if isinstance(value, (list, tuple)):
        inner = ", ".join(_text(item, owner, what, modules) for item in value)
        if isinstance(value, list):
            return f"[{inner}]"
        return f"({inner},)" if len(value) == 1 else f"({inner})"
    if isinstance(value, Mapping):
        rows = (
            f"{_text(k, owner, what, modules)}: {_text(v, owner, what, modules)}" for k, v in value.items()
        )
        return "{" + ", ".join(rows) + "}"
    if kind := constructor_of(value):
        required, named = split_arguments(value)
        written = [_text(item, owner, what, modules) for item in required]
        written += [f"{key}={_text(item, owner, key, modules)}" for key, item in named.items()]
        module = kind.rpartition(".")[0]
        if module:
            modules[module] = None
        return f"{kind if module else f'fx.{kind}'}({', '.join(written)})"
    return _imported(value, owner, what, modules)


def _imported(value: object, owner: str, what: str, modules: dict[str, None]) -> str:
    module, name = import_name(value, owner, what)
    modules[module] = None
    return f"{module}.{name}"
