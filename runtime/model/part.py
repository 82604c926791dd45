"""Parts of a model: the declarations of a user, kept as they were given.

A part is a frozen dataclass.  Its fields carry their unit, the sign that they must have, their default and one line of
meaning; `lower` turns it into nodes, elements, laws and roles.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, fields
from typing import Any, Generic, TypeVar, dataclass_transform

import numpy as np

from flexel.base.copies import Constant, can_travel
from flexel.base.meaning import SIGNS, array_quantity, entry, meaning_of, quantity
from flexel.model.handle import Handle
from flexel.model.lowering import Lowering

Made = TypeVar("Made", covariant=True)
Declared = TypeVar("Declared")


@dataclass_transform(frozen_default=True, field_specifiers=(quantity, array_quantity, entry))
def part(cls: type[Declared]) -> type[Declared]:
    """Make a subclass of `Part` a frozen dataclass; parts are compared as objects, since fields may be arrays."""
    return dataclass(frozen=True, eq=False)(cls)


@dataclass(frozen=True)
class Lost:
    """What remains in a pickle of a function that cannot be pickled; a part with it cannot be lowered again."""

    text: str


@part
class Part(Constant, Generic[Made]):
    """A declaration that a user made by one call.

    Subclasses have the decorator `part`, fields and the method `lower`; ``m.add(Beam(…))`` is ``m.beam(…)``.
    """

    def __post_init__(self) -> None:
        """Check all numbers, and keep copies of lists and arrays, which the caller may change."""
        for item in fields(self):
            given, meaning = getattr(self, item.name), meaning_of(item)
            if meaning.sign is not None and not (given is None and item.default is None):
                checked: Any = SIGNS[meaning.sign](given, self.owner, meaning.called or item.name)
            else:
                checked = _copied(given)
            if checked is not given:
                object.__setattr__(self, item.name, checked)

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; what cannot be pickled, such as a lambda, only by name."""
        return {name: value if can_travel(value) else Lost(repr(value)) for name, value in vars(self).items()}

    @property
    def owner(self) -> str:
        """Its name in messages: its kind and its name."""
        name = getattr(self, "name", None)
        return f"{kind_of(type(self))} '{name}'"

    @property
    def label(self) -> str | None:
        """Prefix of its parameters: its name; None for the name of the first law that it makes."""
        name = getattr(self, "name", None)
        return name if isinstance(name, str) else None

    def lower(self, to: Lowering) -> Made:
        """Add its nodes, elements, laws and roles to a layout, and return what the user's call returns.

        Raises
        ------
        ModelError
            A contradiction, named by the part.  The layout may then hold some of its entries: see `Lowering.add`.
        """
        raise NotImplementedError

    def call(self) -> tuple[list[Any], dict[str, Any]]:
        """Return the positional and the named arguments of the call that declares it, without defaults."""
        positional: list[Any] = []
        named: dict[str, Any] = {}
        in_order = True  # whether no positional argument was left out so far
        for item in fields(self):
            value = getattr(self, item.name)
            if meaning_of(item).spread and isinstance(value, Mapping):
                named |= value
            elif meaning_of(item).spread:
                positional += value or ()
            elif is_same(value, item.default):
                in_order = False
            elif in_order and not item.kw_only and (item.default is MISSING or not isinstance(value, bool)):
                positional.append(value)
            else:
                named[item.name] = value
                in_order = False
        return positional, named


def is_same(value: Any, other: Any) -> bool:
    """Whether two values of a field are the same in type and every bit: -0.0 is not 0.0, nor 0."""
    if value is other:
        return True
    if type(value) is not type(other):
        return False
    if isinstance(value, float):
        return bool(value.hex() == other.hex())
    if isinstance(value, np.ndarray):
        return bool(
            (value.dtype, value.shape, value.tobytes()) == (other.dtype, other.shape, other.tobytes())
        )
    if isinstance(value, (list, tuple)):
        return len(value) == len(other) and all(map(is_same, value, other))
    if isinstance(value, (str, int)):
        return bool(value == other)
    return False


def by_name(part: Part[Any]) -> Part[Any]:
    """Return the part with names in place of nodes, bodies, surfaces and ropes, which belong to one model."""
    named = {item.name: _named(getattr(part, item.name)) for item in fields(part)}
    found = object.__new__(type(part))
    vars(found).update(named)
    return found


def _named(value: Any) -> Any:
    if isinstance(value, Handle):
        return value.name
    if isinstance(value, (list, tuple)) and any(isinstance(item, (Handle, list, tuple)) for item in value):
        return type(value)(_named(item) for item in value)
    return value


def kind_of(cls: type) -> str:
    """Return a class name in words: "rack and pinion" for RackAndPinion, "rope" for RopePart."""
    return re.sub(r"(?<!^)(?=[A-Z])", " ", cls.__name__.removesuffix("Part")).lower()


def _copied(value: Any) -> Any:
    """Copy a container, so that it does not change with that of the caller."""
    if isinstance(value, np.ndarray):
        found = value.copy()
        found.setflags(write=False)
        return found
    if isinstance(value, list):
        return [_copied(item) for item in value]
    if type(value) is tuple and any(isinstance(item, (list, tuple, dict, np.ndarray)) for item in value):
        return tuple(_copied(item) for item in value)
    if isinstance(value, dict):
        return {key: _copied(item) for key, item in value.items()}
    return value
