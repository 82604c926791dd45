"""The origin of a system: its parts, from which variants with other numbers can be lowered again."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import Field, dataclass, fields, is_dataclass, replace
from functools import cached_property
from itertools import count
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.copies import Constant
from flexel.base.errors import FlexelError, ModelError
from flexel.base.meaning import Meaning, meaning_of
from flexel.model.instances import Instance, LawInstance, law_labels
from flexel.model.lowering import Lowering
from flexel.model.part import Lost, Part, is_same


@dataclass(frozen=True)
class DeclaredNumber:
    """A number, or an array of them, that the user gave to a part.

    Attributes
    ----------
    part : int
        Number of the part in the model.
    path : tuple of str
        Its field, and the fields of objects or the keys of mappings within it: ("section", "height").
    unit : str
        "" where it depends on the quantities that the part names.
    value : ndarray
        As given.
    """

    part: int
    path: tuple[str, ...]
    unit: str
    value: Array


@dataclass(frozen=True)
class Origin(Constant):
    """The parts of a model, from which variants of its system are lowered again.

    Attributes
    ----------
    gravity : ndarray
        [m/s²]
    parts : tuple of Part
    labels : tuple of str or None
        What the numbers of each part are called by; None for a part without a name or a law.
    t : float
        Time at which the system was built [s].
    """

    gravity: Array
    parts: tuple[Part[Any], ...]
    labels: tuple[str | None, ...]
    t: float

    @cached_property
    def numbers(self) -> Mapping[str, DeclaredNumber]:
        """All numbers that parts were given, as ``part.field`` or ``part.field.field``."""
        found: dict[str, DeclaredNumber] = {}
        for i, (part, label) in enumerate(zip(self.parts, self.labels, strict=True)):
            if label is not None:
                for names, path, unit, value in _numbers(part):
                    found.setdefault(".".join((label, *names)), DeclaredNumber(i, path, unit, value))
        return found

    @cached_property
    def short_names(self) -> Mapping[str, str]:
        """Names of numbers of objects within a part as if they belonged to the part, such as ``rope.diameter``.

        Only where there is one such number: a body of two sections has no ``body.height``.
        """
        found: dict[str, list[str]] = {}
        for name, number in self.numbers.items():
            if len(number.path) > 1:
                found.setdefault(f"{self.labels[number.part]}.{number.path[-1]}", []).append(name)
        return {
            short: names[0] for short, names in found.items() if len(names) == 1 and short not in self.numbers
        }

    @cached_property
    def unchanged(self) -> Lowering:
        """The model with the numbers as they were given; see `lowered` for errors."""
        return self.lowered({}, "parts")

    @cached_property
    def more_follows(self) -> dict[str, bool]:
        """Whether more follows from a number than what has its name in elements and laws, as far as it was tried."""
        return {}

    def changed(self, values: Mapping[str, Array | float]) -> Origin:
        """Return the same with other values of some numbers, or of entries ``name[0]``; others are left out."""
        parts = list(self.parts)
        for name, value in values.items():
            base, entry = split_entry(name)
            if (number := self.numbers.get(base)) is None:
                continue
            whole = np.asarray(value, dtype=float)
            if entry is not None:
                held = _held(parts[number.part], number.path)
                whole = np.array(held, dtype=float)
                whole.reshape(-1)[entry] = np.asarray(value).item()
            parts[number.part] = _with(parts[number.part], number.path, whole)
        return replace(self, parts=tuple(parts))

    def lowered(self, values: Mapping[str, Array], owner: str) -> Lowering:
        """Lower the model with other values of some of its numbers.

        Raises
        ------
        ModelError
            A value that a part refuses; a function that was lost in a pickle.
        """
        found = Lowering(self.gravity)
        for part in self.changed(values).parts if values else self.parts:
            for item in fields(part):
                if isinstance(lost := getattr(part, item.name), Lost):
                    raise ModelError(
                        f"{owner}: {part.owner} was declared with {lost.text}, which a pickle cannot hold; build the "
                        "model again, or define the function in a module"
                    )
            try:
                part.lower(found)
            except FlexelError as error:
                raise type(error)(f"{owner}: {error}") from error
        return found


def labels_of(
    parts: Sequence[Part[Any]], firsts: Sequence[int], laws: Sequence[LawInstance]
) -> Iterator[str | None]:
    """Yield what the numbers of each part are called by among parameters.

    Parameters
    ----------
    parts : sequence of Part
    firsts : sequence of int
        Of each part, how many laws there were before it.
    laws : sequence of LawInstance
        Those of all parts.
    """
    named = law_labels(laws)
    taken: set[str | None] = set()
    for part, first, end in zip(parts, firsts, [*firsts[1:], len(laws)], strict=True):
        label = part.label
        if label is None:
            label = named[first] if first < end else None
        elif label != getattr(part, "name", None) and label in taken:
            label = next(numbered for i in count(2) if (numbered := f"{label}#{i}") not in taken)
        taken.add(label)
        yield label


def split_entry(name: Any) -> tuple[str, int | None]:
    """Split off the number of the entry in brackets; return the name and that number, or None."""
    match = re.fullmatch(r"(.*)\[(\d+)\]", name) if isinstance(name, str) else None
    return (match[1], int(match[2])) if match else (str(name), None)


def layout_of(model: Lowering) -> list[list[tuple[Any, ...]]]:
    """Return nodes, elements, laws, loads and roles without numbers: what must not change in a variant."""
    tables: tuple[list[Any], ...] = (
        list(model.nodes.values()),
        list(model.instances.values()),
        model.laws,
        model.loads,
        [model],
    )
    return [_layout(table) for table in tables]


def same_but_numbers(a: Lowering, b: Lowering) -> bool:
    """Whether two models of one layout differ only in the numbers of elements and laws, and in sections of beams.

    They have the same drawing, relations, loads, prescribed motions, controllers and initial values.
    """
    return _equal(_fixed(a), _fixed(b))


def _fixed(model: Lowering) -> tuple[Any, ...]:
    elements = [(instance.terms, instance.mass_damping) for instance in model.instances.values()]
    drawing = [node.x0 for node in model.nodes.values()]
    inputs = [*model.loads, *model.motions.values(), *model.controllers]
    return drawing, elements, [law.z0 for law in model.laws], inputs, model.values, model.rates


def _equal(a: Any, b: Any) -> bool:
    """Whether two objects have the same content; functions are equal if they are one object."""
    if is_same(a, b):
        return True
    if type(a) is not type(b):
        return False
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(_equal, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(_equal(value, b[key]) for key, value in a.items())
    inside = type(a).__module__.startswith("flexel.") and hasattr(a, "__dict__")
    return inside and _equal(vars(a), vars(b))


def _layout(entries: list[Any]) -> list[tuple[Any, ...]]:
    """Return the entries of a table without their numbers."""
    found: list[tuple[Any, ...]] = []
    for entry in entries:
        if isinstance(entry, Instance):
            found.append((entry.name, entry.spec, entry.nodes, entry.terms and tuple(entry.terms)))
        elif isinstance(entry, LawInstance):
            found.append((entry.name, entry.spec, entry.deformations, entry.slips))
        elif isinstance(entry, Lowering):
            found.append((entry.roles, entry.dynamic, entry.kinematic, list(entry.motions)))
        else:
            found.append(
                (entry.name, getattr(entry, "kind", ""), np.array(getattr(entry, "fixed", 0)).tolist())
            )
    return found


def _numbers(
    owner: Any, names: tuple[str, ...] = (), path: tuple[str, ...] = ()
) -> Iterator[tuple[tuple[str, ...], tuple[str, ...], str, Array]]:
    """Yield names, path, unit and value of the numbers in the fields of a part, and in those of objects within it."""
    for item in fields(owner):
        meaning = meaning_of(item)
        value = _meant(getattr(owner, item.name), meaning)
        called, inner = (*names, item.name), (*path, item.name)
        if isinstance(value, Mapping) and (meaning.spread or meaning.unit is not None):
            for key, entry in value.items():
                if isinstance(key, str) and (array := _array(entry)) is not None:
                    yield (
                        (*(names if meaning.spread else called), key),
                        (*inner, key),
                        meaning.unit or "",
                        array,
                    )
        elif meaning.unit is not None and (array := _array(value)) is not None:
            yield called, inner, meaning.unit, array
        elif _has_numbers(value):
            yield from _numbers(value, called, inner)


def _meant(value: Any, meaning: Meaning) -> Any:
    """Return what a value means: the object of that name, such as a material."""
    return meaning.named(value) if meaning.named is not None and isinstance(value, str) else value


def _has_numbers(value: object) -> bool:
    if not is_dataclass(value) or isinstance(value, type):
        return False
    declared: tuple[Field[Any], ...] = fields(value)
    return any(meaning_of(item).unit is not None for item in declared)


def _array(value: Any) -> Array | None:
    """Return a number or an array of numbers; None for anything else, such as a curve or None."""
    if value is None or isinstance(value, (bool, str)) or callable(value):
        return None
    try:
        given = np.asarray(value)
    except (TypeError, ValueError):
        return None
    return np.array(given, dtype=float) if given.dtype.kind in "iuf" and given.size else None


def _held(owner: Any, path: tuple[str, ...]) -> Any:
    """Return the number of a part at a path."""
    for name in path:
        owner = _inner(owner, name)
    return owner


def _inner(owner: Any, name: str) -> Any:
    """Return a field of a part or of an object within it, or the value of a key."""
    if isinstance(owner, Mapping):
        return owner[name]
    declared: Mapping[str, Field[Any]] = type(owner).__dataclass_fields__
    return _meant(getattr(owner, name), meaning_of(declared[name]))


def _with(owner: Any, path: tuple[str, ...], value: Array) -> Any:
    """Return a part with another number."""
    name, *inner = path
    held = _inner(owner, name)
    changed = _with(held, tuple(inner), value) if inner else _formed(held, value)
    return {**owner, name: changed} if isinstance(owner, Mapping) else replace(owner, **{name: changed})


def _formed(held: Any, value: Array) -> Any:
    """Return numbers in the form in which a part holds them: a number, an array, or tuples and lists."""
    if isinstance(held, (list, tuple)):
        rows = np.split(value.reshape(np.shape(held)), len(held))
        return type(held)(_formed(item, row) for item, row in zip(held, rows, strict=True))
    shape = np.shape(held)
    return value.reshape(shape) if shape else float(value.reshape(-1)[0])
