"""Parameters of a built structure by name: of elements (``rider.mass``) and laws (``strut.elongation.stiffness``).

Springs, dampers and beams are laws; their matrices S and D are called stiffness and damping.  A second law of the same
name is ``name#2``.  An entry of a parameter of several numbers has its number in brackets: ``rider.J[0]``.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.derive.spec import FORMULA_NUMBERS
from flexel.structure.instances import Instance, LawInstance
from flexel.structure.structure import Structure

ALIASES = {
    "S": "stiffness",
    "D": "damping",
    "C": "damping",
}  # of the matrices of linear laws, for use in names


@dataclass(frozen=True)
class Place:
    """Where a parameter is kept.

    Attributes
    ----------
    name : str
        As requested.
    law : bool
        Whether it belongs to a law, otherwise to an element.
    owner : int
        Number of the element or law in the structure.
    parameter : str
        Its name in the specification.
    numbers : slice
        Its numbers among all of the owner.
    """

    name: str
    law: bool
    owner: int
    parameter: str
    numbers: slice

    @property
    def size(self) -> int:
        """How many numbers it has."""
        return int(self.numbers.stop - self.numbers.start)


class Parameters(Mapping[str, Array]):
    """All parameters of a structure as a mapping from names to arrays; read only."""

    def __init__(self, structure: Structure) -> None:
        self._structure = structure
        self._places = dict(_places(structure))

    def __len__(self) -> int:
        return len(self._places)

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __contains__(self, name: object) -> bool:
        return name in self._places

    def __getitem__(self, name: str) -> Array:
        place = self.find(name, "parameters")
        return np.array(self.owner(place).p[place.numbers])

    def __repr__(self) -> str:
        return f"Parameters({len(self)}: {', '.join(list(self)[:6])}, …)"

    def owner(self, place: Place) -> Instance | LawInstance:
        """The element or law of a parameter."""
        return self._structure.laws[place.owner] if place.law else self._structure.instances[place.owner]

    def unit(self, place: Place) -> str:
        """Unit of a parameter; of a law on a length or an angle that of the two which belongs to it."""
        owner = self.owner(place)
        unit = next(z.unit for z in owner.spec.parameters if z.name == place.parameter)
        if isinstance(owner, LawInstance) and " or " in unit:
            s, of = self._structure, [*owner.deformations, *owner.slips]
            linear, turning = unit.split(" or ", 1)
            return turning if s.units[s.index[of[0]]].startswith("rad") else linear
        return unit

    def find(self, name: Any, owner: str) -> Place:
        """The place of a parameter; a ModelError with the nearest known names otherwise."""
        base, entry = _split(name)
        if base not in self._places:
            raise ModelError(f"{owner}: {unknown(str(name), self._places, 'parameter')}")
        place = replace(self._places[base], name=name)
        if entry is None:
            return place
        if not 0 <= entry < place.size:
            raise ModelError(
                f"{owner}: '{name}': entries of '{base}' are numbered from 0 to {place.size - 1}"
            )
        first = place.numbers.start + entry
        return replace(place, numbers=slice(first, first + 1))

    def changed(self, places: Sequence[Place], values: Sequence[Array]) -> Structure:
        """The structure with other values of some parameters."""
        s, owners = self._structure, self.owners(places, values)
        instances = tuple(owners.get((False, i), z) for i, z in enumerate(s.instances))
        laws = tuple(owners.get((True, i), z) for i, z in enumerate(s.laws))
        return replace(s, instances=instances, laws=laws)

    def owners(self, places: Sequence[Place], values: Sequence[Array]) -> dict[tuple[bool, int], Any]:
        """The elements and laws with other values of some parameters, by `Place.law` and `Place.owner`."""
        rows: dict[tuple[bool, int], Array] = {}
        found = {}
        for place, value in zip(places, values, strict=True):
            key, owner = (place.law, place.owner), self.owner(place)
            row = rows.setdefault(key, np.array(owner.p))
            row[place.numbers] = value
            found[key] = _with(owner, row)
        return found


def _with(owner: Any, row: Array) -> Any:
    """An element or law with its parameters from a row of numbers."""
    ends = np.cumsum([0, *(z.size for z in owner.spec.parameters)]).tolist()
    parts = zip(owner.spec.parameters, ends, ends[1:], strict=False)
    return replace(owner, parameters=owner.parameters | {z.name: row[a:b] for z, a, b in parts})


def _split(name: Any) -> tuple[str, int | None]:
    """A name and the number of the entry in brackets, if there is one."""
    match = re.fullmatch(r"(.*)\[(\d+)\]", name) if isinstance(name, str) else None
    return (match[1], int(match[2])) if match else (str(name), None)


def _places(structure: Structure) -> Iterator[tuple[str, Place]]:
    """All parameters with their names; laws have also those in words.

    Gains of controllers are not included: the controller has a copy of them, for its outputs and limits.  Nor are the
    numbers of a formula: its energy has numbers that follow from those of the stress.
    """
    controllers = {c.name for c in structure.controllers}
    for law, owners in ((False, structure.instances), (True, structure.laws)):
        count: Counter[str] = Counter()
        for number, owner in enumerate(owners):
            count[owner.name] += 1
            if law and owner.name in controllers:
                continue
            label = owner.name if count[owner.name] == 1 else f"{owner.name}#{count[owner.name]}"
            first = 0
            for z in owner.spec.parameters:
                word = ALIASES.get(z.name, z.name) if law else z.name
                name = f"{label}.{word}"
                if z.name != FORMULA_NUMBERS:
                    yield name, Place(name, law, number, z.name, slice(first, first + z.size))
                first += z.size
