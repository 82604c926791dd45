"""Variants of single numbers of parts, beside the model that is built anew with the other number."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.meaning import Meaning, meaning_of
from flexel.model.part import Part

CHANGE = 1e-3
Path = tuple[str, ...]


def numbers(value: Any, path: Path = ()) -> Iterator[tuple[Path, Meaning]]:
    """Paths to all numbers within a part, and what the field that holds them means."""
    for item in fields(value):
        held, meaning = getattr(value, item.name), meaning_of(item)
        if meaning.named and isinstance(held, str):
            held = meaning.named(held)
        yield from _within(held, (*path, item.name), meaning)


def _within(held: Any, path: Path, meaning: Meaning) -> Iterator[tuple[Path, Meaning]]:
    if isinstance(held, Mapping):
        for key, entry in held.items():
            yield from _within(entry, (*path, str(key)), meaning)
    elif is_dataclass(held) and type(held).__name__ in fx.__all__:
        yield from numbers(held, path)
    elif numeric(held):
        yield path, meaning


def numeric(held: Any) -> bool:
    """Whether a value is a number, or an array of numbers."""
    if held is None or isinstance(held, (bool, str)) or callable(held):
        return False
    return np.asarray(held, dtype=object).size > 0 and all(
        isinstance(entry, (int, float, np.number)) and not isinstance(entry, bool)
        for entry in np.asarray(held, dtype=object).ravel()
    )


def field_at(value: Any, path: Path) -> tuple[str, str]:
    """The class and the name of the innermost field on a path; keys of mappings lead no further."""
    name, *inner = path
    held = meant(value, name)
    if inner and not isinstance(held, Mapping):
        return field_at(held, tuple(inner))
    if inner and is_dataclass(held := held[inner[0]]):
        return field_at(held, tuple(inner[1:]))
    return type(value).__name__, name


def fields_of(kinds: Iterable[type]) -> set[tuple[str, str]]:
    """Classes and names of all fields that are declared as numbers."""
    return {
        (kind.__name__, item.name)
        for kind in kinds
        if is_dataclass(kind)
        for item in fields(kind)
        if meaning_of(item).unit is not None
    }


def held_at(value: Any, path: Path) -> Any:
    """What a part holds at a path."""
    for name in path:
        value = value[name] if isinstance(value, Mapping) else meant(value, name)
    return value


def meant(value: Any, name: str) -> Any:
    """A field of an object; the material of a name."""
    held = getattr(value, name)
    meaning = next(meaning_of(item) for item in fields(value) if item.name == name)
    return meaning.named(held) if meaning.named and isinstance(held, str) else held


def with_other(value: Any, path: Path, number: Any) -> Any:
    """The part or object with another number at a path."""
    name, *inner = path
    if isinstance(value, Mapping):
        return {**value, name: with_other(value[name], tuple(inner), number) if inner else number}
    other = with_other(meant(value, name), tuple(inner), number) if inner else number
    return replace(value, **{name: other})


def other_value(owner: str, field: str, held: Any) -> Array:
    """Numbers beside the given ones: each changed by another factor, so that a direction turns.

    Parameters
    ----------
    owner : str
        Class of the part, or of the object within it, that has the field.
    field : str
    held : float or array_like
    """
    given = np.asarray(held, dtype=float)
    if owner == "ClosedProfile":  # it stays symmetric
        return np.asarray(given * (1 - CHANGE))
    if field == "orientation" and given.size == 4:
        turned = given + CHANGE * np.arange(4)
        return np.asarray(turned / np.linalg.norm(turned))
    order = np.arange(given.size).reshape(given.shape)
    if given.ndim == 2 and np.array_equal(given, given.T):  # a matrix that stays symmetric
        order = order + order.T
    if field == "at" and owner in ("CableLinePart", "ChainPart"):  # the ends are those of the line
        order[[0, -1]] = -1
    return np.asarray(given * (1 - CHANGE * (1 + order))) if given.any() else given + CHANGE


def in_kind(held: Any, value: Array) -> Any:
    """Numbers as the part holds them: a tuple, a list or a number."""
    if np.ndim(held) == 0:
        return float(value.reshape(-1)[0])
    listed = value.reshape(np.shape(held)).tolist()
    return listed if isinstance(held, list) else tuple(map(_tupled, listed))


def _tupled(value: Any) -> Any:
    return tuple(map(_tupled, value)) if isinstance(value, list) else value


def model_with(m: fx.Model, part: Part[Any], path: Path, value: Any) -> fx.Model:
    """The model built anew with another number of one part."""
    return fx.Model.of(
        m.gravity, [with_other(other, path, value) if other is part else other for other in m.parts]
    )
