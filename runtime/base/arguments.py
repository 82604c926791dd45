"""Checks of user input before anything is computed: numbers, vectors, names."""

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

LARGEST = 1e150  # beyond it squares overflow
SMALLEST = 1e-150  # of positive numbers: below it squares vanish
LONGEST_NAME = 255  # bytes in the name of a file or folder, on all usual systems
FORMULAS = "=+-@"  # a spreadsheet executes what begins with one of these
SHOWN = 12  # known names in a message


def array(value: Any, owner: str, what: str) -> Array:
    """A float array of finite numbers of any shape; text, None and objects are refused.

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
    if not (np.abs(given) <= LARGEST).all():
        if not np.isfinite(given).all():
            raise ModelError(f"{owner}: {what} {_shown(value)} is not finite; give finite numbers")
        raise ModelError(
            f"{owner}: {what} {_shown(value)} is too large to calculate with; give at most {LARGEST:g}"
        )
    return np.array(given, dtype=float)


def vector(value: Any, owner: str, what: str, size: int) -> Array:
    """A float array (size,) of finite numbers, or a ModelError that names the owner."""
    d = array(value, owner, what)
    if d.shape != (size,):
        raise ModelError(f"{owner}: {what} {_shown(value)} has shape {d.shape}; give {size} numbers")
    return d


def number(value: Any, owner: str, what: str) -> float:
    """One finite number, or a ModelError that names the owner."""
    if isinstance(value, float) and -LARGEST <= value <= LARGEST:
        return float(value)
    d = array(value, owner, what)
    if d.shape:
        raise ModelError(f"{owner}: {what} {_shown(value)} has shape {d.shape}; give one number")
    return float(d)


def numbers(values: Mapping[str, Any] | None, owner: str, what: str) -> dict[str, float]:
    """Finite numbers by name, or a ModelError that names the owner and the offending entry."""
    if values is None:
        return {}
    if not isinstance(values, Mapping):
        raise ModelError(f"{owner}: {what} {_shown(values)} must be given by name; write {{'name': number}}")
    return {name: number(value, owner, f"{what} of '{name}'") for name, value in values.items()}


def index(value: Any, owner: str, what: str) -> int:
    """A whole number, or a ModelError that names the owner."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise ModelError(f"{owner}: {what} {_shown(value)} is not a whole number; give one")
    return int(value)


def whole(value: Any, owner: str, what: str, least: int = 1, most: int = 10**9) -> int:
    """A whole number from `least` to `most`, or a ModelError that names the owner."""
    given = index(value, owner, what)
    if not least <= given <= most:
        limit = f"{least} or more" if given < least else f"at most {most}"
        raise ModelError(f"{owner}: {what} {_shown(value)}; give a whole number, {limit}")
    return given


def flag(value: Any, owner: str, what: str) -> bool:
    """True or False, or a ModelError that names the owner: a text such as "no" would count as true."""
    if not isinstance(value, (bool, np.bool_)):
        raise ModelError(f"{owner}: {what} {_shown(value)} is neither True nor False; give one of them")
    return bool(value)


def text(value: Any, owner: str, what: str) -> str:
    """A text, or a ModelError that names the owner."""
    if not isinstance(value, str):
        raise ModelError(f"{owner}: {what} {_shown(value)} is not a string; give one")
    return value


def mapping(value: Any, owner: str, what: str) -> Mapping[str, Any]:
    """A mapping from names, empty for None; a ModelError that names the owner otherwise."""
    if value is None:
        return {}
    if not isinstance(value, Mapping) or not all(isinstance(name, str) for name in value):
        raise ModelError(f"{owner}: {what} {_shown(value)} must be given by name; write {{'name': …}}")
    return value


def path_of(value: Any, owner: str) -> Path:
    """A path, or a ModelError that names the owner."""
    if not isinstance(value, (str, PathLike)) or not str(value) or not _possible(str(value)):
        raise ModelError(f"{owner}: {_shown(value)} is not a path; give one as text")
    return Path(value)


def _possible(path: str) -> bool:
    """Whether a file can have this path: no null character, letters that can be encoded, no name of over 255 bytes."""
    try:
        written = os.fsencode(path)
    except UnicodeEncodeError:
        return False
    return b"\0" not in written and max(map(len, written.split(os.fsencode(os.sep)))) <= LONGEST_NAME


def names(given: Any, owner: str) -> tuple[str, ...]:
    """A sequence of names; a single text is refused, because its letters would count as names."""
    listed = tuple(given) if isinstance(given, Iterable) and not isinstance(given, str) else None
    if listed is None or not all(isinstance(z, str) for z in listed):
        raise ModelError(f"{owner}: {_shown(given)} is not a list of names; write ['…', '…']")
    return listed


def new_name(name: Any, kind: str) -> str:
    """A name from which quantity names can be formed, or a ModelError."""
    if not isinstance(name, str) or not re.fullmatch(r"[^\s.':][^.':]*", name):
        raise ModelError(f"{kind} {name!r}: a name is text without dots, colons or quotes; choose another")
    return storable(name, kind)


def storable(name: str, kind: str) -> str:
    """A name that every file format holds and no spreadsheet takes for a formula, or a ModelError."""
    if any(category(letter) in ("Cc", "Cs") for letter in name):
        raise ModelError(
            f"{kind} {name!r}: a name has no control characters and no halves of characters, which files cannot hold; "
            "choose another"
        )
    if name[:1] in FORMULAS:
        raise ModelError(
            f"{kind} {name!r}: a spreadsheet takes what begins with {name[0]} for a formula; choose another name"
        )
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


def positive(value: Any, owner: str, what: str) -> float:
    """A positive finite number, or a ModelError."""
    given = number(value, owner, what)
    if given <= 0:
        raise ModelError(f"{owner}: {what} {given:g} is not positive; give a positive value")
    if given < SMALLEST:
        raise ModelError(
            f"{owner}: {what} {given:g} is too small to calculate with; give at least {SMALLEST:g}"
        )
    return given


def not_negative(value: Any, owner: str, what: str) -> float:
    """A finite number that is zero or positive, or a ModelError."""
    given = number(value, owner, what)
    if given < 0:
        raise ModelError(f"{owner}: {what} {given:g} is negative; give zero or a positive value")
    return given


def span(xp: Array, xq: Array, owner: str) -> tuple[Array, float]:
    """Direction and length of the line between two points."""
    line = xq - xp
    length = float(np.linalg.norm(line))
    if length < 1e-12 * max(1.0, float(np.max(np.abs(xp)))):
        raise ModelError(
            f"{owner}: its two points coincide at {tuple(xp.tolist())}; the element has no length, move one"
        )
    return line / length, length


def unknown(name: str, known: Iterable[str], kind: str = "name") -> str:
    """Message for a name that does not exist, with the nearest ones that do."""
    names = list(dict.fromkeys(known))
    near = near_names(name, names)
    if near:
        return f"unknown {kind} '{name}'; did you mean {', '.join(near)}?"
    part = name.rpartition(".")[0]
    mates = quantities_of(part, names)
    where, shown = (f"'{part}' has ", mates) if mates else ("known: ", names)
    more = f", … ({len(shown)} in all)" * (len(shown) > SHOWN)
    return f"unknown {kind} '{name}'; {where}{', '.join(shown[:SHOWN])}{more}"


def step_limit(value: Any, owner: str, what: str, least: float = 0.0) -> float:
    """A number above `least`; a ModelError otherwise."""
    checked = number(value, owner, what)
    if checked <= least:
        raise ModelError(f"{owner}: {what} {checked:g} is too small; give more than {least:g}")
    return checked
