"""What a user hands over, checked before anything is computed: numbers, vectors, names.

Imports numpy and the errors.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.errors import ModelError

Array = NDArray[np.float64]


def array(value: Any, owner: str, what: str) -> Array:
    """A float array of finite numbers of any shape; text, None and objects are refused.

    Raises
    ------
    ModelError
        `owner` and `what` name the value.
    """
    try:
        given = np.asarray(value)
        numeric = given.dtype.kind in "biuf"
    except (TypeError, ValueError):  # ragged nesting
        numeric = False
    if not numeric:
        raise ModelError(f"{owner}: {what} {_shown(value)} is not numeric; give real numbers")
    if not np.all(np.isfinite(given)):
        raise ModelError(f"{owner}: {what} {_shown(value)} is not finite; give finite numbers")
    return np.array(given, dtype=float)


def vector(value: Any, owner: str, what: str, size: int) -> Array:
    """A float array (size,) of finite numbers, or a ModelError that names the owner."""
    d = array(value, owner, what)
    if d.shape != (size,):
        raise ModelError(f"{owner}: {what} {_shown(value)} has shape {d.shape}; give {size} numbers")
    return d


def number(value: Any, owner: str, what: str) -> float:
    """One finite number, or a ModelError that names the owner."""
    d = array(value, owner, what)
    if d.size != 1:
        raise ModelError(f"{owner}: {what} {_shown(value)} has shape {d.shape}; give one number")
    return float(d.reshape(()))


def numbers(values: Mapping[str, Any] | None, owner: str, what: str) -> dict[str, float]:
    """Finite numbers by name, or a ModelError that names the owner and the one at fault."""
    if values is None:
        return {}
    if not isinstance(values, Mapping):
        raise ModelError(f"{owner}: {what} {_shown(values)} must be given by name; write {{'name': number}}")
    return {name: number(value, owner, f"{what} of '{name}'") for name, value in values.items()}


def names(given: Any, owner: str) -> tuple[str, ...]:
    """A sequence of names; a single text is refused, because its letters would count as names."""
    listed = tuple(given) if isinstance(given, Iterable) and not isinstance(given, str) else None
    if listed is None or not all(isinstance(z, str) for z in listed):
        raise ModelError(f"{owner}: {_shown(given)} is not a list of names; write ['…', '…']")
    return listed


def new_name(name: Any, kind: str) -> str:
    """A name that quantities can be made of, or a ModelError."""
    if not isinstance(name, str) or not re.fullmatch(r"[^\s.':][^.':]*", name):
        raise ModelError(f"{kind} {name!r}: a name is text without dots, colons or quotes; choose another")
    return name


def _shown(value: Any) -> str:
    text = str(value.tolist()) if isinstance(value, np.ndarray) else repr(value)
    return text if len(text) < 80 else text[:76] + " …"


def quantities(given: Any, owner: str) -> tuple[str, ...]:
    """Names of coordinates, deformations or slips; nodes and lists are refused."""
    for name in given:
        if not isinstance(name, str):
            raise ModelError(
                f"{owner}: {_shown(name)} is not the name of a quantity; give text such as 'A.x' or 'hinge.angle', "
                "several as separate arguments"
            )
    return tuple(given)
