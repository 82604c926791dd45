"""Checks user input before anything is computed: numbers, vectors, names."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any
from unicodedata import category

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.near_names import near_names, quantities_of

LARGEST = 1e150  # beyond it, squares overflow
MIN_POSITIVE = 1e-150  # of positive numbers: below it, squares vanish
MAX_NAME_BYTES = 255  # bytes in the name of a file or folder, on all usual systems
FORMULAS = "=+-@"  # a spreadsheet executes what begins with one of these
MAX_NAMES_SHOWN = 12  # known names in a message


def array(value: Any, owner: str, what: str) -> Array:
    """Return a float array of finite numbers of any shape; refuse text, None and objects.

    Raises
    ------
    ModelError
        `owner` and `what` name the value.
    """
    if isinstance(value, float) and -LARGEST <= value <= LARGEST:
        return np.array(value)  # the usual case, ten times as fast as what follows
    try:
        given = np.asarray(value)
        numeric = given.dtype.kind in "biuf"
    except (TypeError, ValueError):  # ragged nesting
        numeric = False
    if not numeric:
        raise ModelError(f"{owner}: {what} {_shown(value)} is not numeric; give real numbers")
    found = np.array(given, dtype=float)
    if not (np.abs(found) <= LARGEST).all():
        if not np.isfinite(found).all():
            raise ModelError(f"{owner}: {what} {_shown(value)} is not finite; give finite numbers")
        raise ModelError(
            f"{owner}: {what} {_shown(value)} is too large to calculate with; give at most {LARGEST:g}"
        )
    return found


def vector(value: Any, owner: str, what: str, size: int) -> Array:
    """Return a float array (size,) of finite numbers, or raise a ModelError that names the owner."""
    d = array(value, owner, what)
    if d.shape != (size,):
        raise ModelError(f"{owner}: {what} {_shown(value)} has shape {d.shape}; give {size} numbers")
    return d


def number(value: Any, owner: str, what: str) -> float:
    """Return one finite number, or raise a ModelError that names the owner."""
    if isinstance(value, float) and -LARGEST <= value <= LARGEST:
        return float(value)
    d = array(value, owner, what)
    if d.shape:
        raise ModelError(f"{owner}: {what} {_shown(value)} has shape {d.shape}; give one number")
    return float(d)


def numbers(values: Mapping[str, Any] | None, owner: str, what: str) -> dict[str, float]:
    """Return finite numbers by name, or raise a ModelError that names the owner and the offending entry."""
    if values is None:
        return {}
    if not isinstance(values, Mapping):
        raise ModelError(f"{owner}: {what} {_shown(values)} must be given by name; write {{'name': number}}")
    return {name: number(value, owner, f"{what} of '{name}'") for name, value in values.items()}


def index(value: Any, owner: str, what: str) -> int:
    """Return a whole number, or raise a ModelError that names the owner."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise ModelError(f"{owner}: {what} {_shown(value)} is not a whole number; give one")
    return int(value)


def whole(value: Any, owner: str, what: str, least: int = 1, most: int = 10**9) -> int:
    """Return a whole number from `least` to `most`, or raise a ModelError that names the owner."""
    given = index(value, owner, what)
    if not least <= given <= most:
        limit = f"{least} or more" if given < least else f"at most {most}"
        raise ModelError(f"{owner}: {what} {_shown(value)}; give a whole number, {limit}")
    return given


def flag(value: Any, owner: str, what: str) -> bool:
    """Return True or False, or raise a ModelError that names the owner: a text such as "no" would count as true."""
    if not isinstance(value, (bool, np.bool_)):
        raise ModelError(f"{owner}: {what} {_shown(value)} is neither True nor False; give one of them")
    return bool(value)


def text(value: Any, owner: str, what: str) -> str:
    """Return a text, or raise a ModelError that names the owner."""
    if not isinstance(value, str):
        raise ModelError(f"{owner}: {what} {_shown(value)} is not a string; give one")
    return value


def mapping(value: Any, owner: str, what: str) -> Mapping[str, Any]:
    """Return a mapping from names, empty for None, or raise a ModelError that names the owner."""
    if value is None:
        return {}
    if not isinstance(value, Mapping) or not all(isinstance(name, str) for name in value):
        raise ModelError(f"{owner}: {what} {_shown(value)} must be given by name; write {{'name': …}}")
    return value


def path_of(value: Any, owner: str) -> Path:
    """Return a path, or raise a ModelError that names the owner."""
    if not isinstance(value, (str, PathLike)) or not str(value) or not _possible(str(value)):
        raise ModelError(f"{owner}: {_shown(value)} is not a path; give one as text")
    return Path(value)


def _possible(path: str) -> bool:
    """Check that a file can have this path: no null character, encodable letters, no name of over 255 bytes."""
    try:
        written = os.fsencode(path)
    except UnicodeEncodeError:
        return False
    return b"\0" not in written and max(map(len, written.split(os.fsencode(os.sep)))) <= MAX_NAME_BYTES


def names(given: Any, owner: str) -> tuple[str, ...]:
    """Return a sequence of names; refuse a single text, because its letters would count as names."""
    listed = tuple(given) if isinstance(given, Iterable) and not isinstance(given, str) else None
    if listed is None or not all(isinstance(item, str) for item in listed):
        raise ModelError(f"{owner}: {_shown(given)} is not a list of names; write ['…', '…']")
    return listed


def new_name(name: Any, kind: str) -> str:
    """Return a name from which quantity names can be formed, or raise a ModelError."""
    if not isinstance(name, str) or not re.fullmatch(r"[^\s.':][^.':]*", name):
        raise ModelError(f"{kind} {name!r}: a name is text without dots, colons or quotes; choose another")
    return storable(name, kind)


def storable(name: str, kind: str) -> str:
    """Return a name that every file format holds and no spreadsheet reads as a formula, or raise a ModelError."""
    if any(category(letter) in ("Cc", "Cs") for letter in name):
        raise ModelError(
            f"{kind} {name!r}: a name cannot contain control characters or unpaired surrogates, which files cannot "
            "hold; choose another"
        )
    if name[:1] in FORMULAS:
        raise ModelError(
            f"{kind} {name!r}: a spreadsheet reads a name that begins with {name[0]} as a formula; choose another"
        )
    return name


def _shown(value: Any) -> str:
    text = str(value.tolist()) if isinstance(value, np.ndarray) else repr(value)
    return text if len(text) < 80 else text[:76] + " …"


def quantities(given: Any, owner: str) -> tuple[str, ...]:
    """Return names of coordinates, deformations or slips; refuse nodes and lists."""
    for name in given:
        if not isinstance(name, str):
            raise ModelError(
                f"{owner}: {_shown(name)} is not the name of a quantity; give text such as 'A.x' or 'hinge.angle', "
                "several as separate arguments"
            )
    return tuple(given)


def positive(value: Any, owner: str, what: str) -> float:
    """Return a positive finite number, or raise a ModelError."""
    given = number(value, owner, what)
    if given <= 0:
        raise ModelError(f"{owner}: {what} {given:g} is not positive; give a positive value")
    if given < MIN_POSITIVE:
        raise ModelError(
            f"{owner}: {what} {given:g} is too small to calculate with; give at least {MIN_POSITIVE:g}"
        )
    return given


def not_negative(value: Any, owner: str, what: str) -> float:
    """Return a finite number that is zero or positive, or raise a ModelError."""
    given = number(value, owner, what)
    if given < 0:
        raise ModelError(f"{owner}: {what} {given:g} is negative; give zero or a positive value")
    return given


def span(xp: Array, xq: Array, owner: str) -> tuple[Array, float]:
    """Return the direction and length of the line between two points."""
    line = xq - xp
    length = float(np.linalg.norm(line))
    if length < 1e-12 * max(1.0, float(np.max(np.abs(xp)))):
        raise ModelError(
            f"{owner}: its two points coincide at {tuple(xp.tolist())}, so the element has no length; move one"
        )
    return line / length, length


def unknown(name: str, known: Iterable[str], kind: str = "name") -> str:
    """Write the message for an unknown name, with the most similar known names."""
    names = list(dict.fromkeys(known))
    similar = near_names(name, names)
    if similar:
        return f"unknown {kind} '{name}'; did you mean {', '.join(similar)}?"
    if not names:
        return f"unknown {kind} '{name}'; there is none yet"
    part = name.rpartition(".")[0]
    mates = quantities_of(part, names)
    where, shown = (f"'{part}' has ", mates) if mates else ("known: ", names)
    more = f", … ({len(shown)} in all)" * (len(shown) > MAX_NAMES_SHOWN)
    return f"unknown {kind} '{name}'; {where}{', '.join(shown[:MAX_NAMES_SHOWN])}{more}"


def step_limit(value: Any, owner: str, what: str, least: float = 0.0) -> float:
    """Return a number above `least`, or raise a ModelError."""
    checked = number(value, owner, what)
    if checked <= least:
        raise ModelError(f"{owner}: {what} {checked:g} is too small; give more than {least:g}")
    return checked
