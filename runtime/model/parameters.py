"""Parameters of a built system by name: of parts (``leaf.section.height``), elements and laws.

A number that the user gave to a part has the name of its field (`flexel.model.origin`); one of an object within it,
such as its section, may be named as if it were the part's (``leaf.height``) where no other has this name.  A part
without a name is called by what it acts on (``load tip.x.value``), a spring as its law.  Numbers that follow from
these in elements (``rider.mass``) and laws (``strut.elongation.stiffness``) can be changed alone too.

The elastic laws of a beam or cable have their parameters among those of the element, by the names that the user gave
them (``leaf.EIz``); one that several of them have is set in all.  Springs and dampers are laws; their matrices S and D
are called stiffness and damping.  A second law of the same name is ``name#2``.  An entry of a parameter of several
numbers has its number in brackets: ``rider.J[0]``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.shown import PrintedTable, prints
from flexel.derive.spec import FORMULA_NUMBERS
from flexel.model.instances import Instance, LawInstance, law_labels
from flexel.model.origin import Origin, split_entry
from flexel.model.structure import Structure

ALIASES = {
    "S": "stiffness",
    "D": "damping",
    "C": "damping",
}  # of the matrices of linear laws, for use in names


NUMBERS = 6  # of a parameter in a table
PROBE = 1e-3  # relative change of a number that shows what follows from it
# Of numbers that follow from the parameters of an elastic law.
FORMER_NAMES = ("stiffness", "preload", "phi_y", "phi_z", "polar")


@dataclass(frozen=True)
class Target:
    """Where numbers of a parameter are kept.

    Attributes
    ----------
    law : bool
        Whether they belong to a law, otherwise to an element.
    owner : int
        Number of the element or law in the structure.
    parameter : str
        Its name in the specification.
    numbers : slice
        Its numbers among all of the owner.
    entries : slice
        The entries of the parameter that they are.
    """

    law: bool
    owner: int
    parameter: str
    numbers: slice
    entries: slice

    def only(self, entry: int) -> Target:
        """Return the same for one entry of the parameter."""
        first = self.numbers.start + entry - self.entries.start
        return replace(self, numbers=slice(first, first + 1), entries=slice(0, 1))


@dataclass(frozen=True)
class ParameterPlace:
    """A parameter, and everything that has it.

    Attributes
    ----------
    name : str
        As requested.
    targets : tuple of Target
        An entry that none of them has is that of a rigid mode; it is zero and remains so.
    size : int
        How many numbers it has.
    declared : str, optional
        The number of a part from which others follow, by its name; such a place has no targets.
    entry : int, optional
        The entry of that number, if it is one of several.
    """

    name: str
    targets: tuple[Target, ...]
    size: int
    declared: str | None = None
    entry: int | None = None

    @property
    def full_name(self) -> str:
        """The name as requested, or that of the number of a part if this is longer."""
        if self.declared is None:
            return self.name
        return self.declared if self.entry is None else f"{self.declared}[{self.entry}]"

    @property
    def rigid(self) -> list[int]:
        """The entries that nothing has."""
        if self.declared is not None:
            return []
        known = {i for target in self.targets for i in range(target.entries.start, target.entries.stop)}
        return [i for i in range(self.size) if i not in known]


class Parameters(Mapping[str, Array]):
    """All parameters of a system as a mapping from names to arrays; read only.

    Parameters
    ----------
    structure : Structure
    origin : Origin, optional
        The parts from which it was built, for the names of their numbers.
    """

    def __init__(self, structure: Structure, origin: Origin | None = None) -> None:
        self._structure, self._origin = structure, origin
        self._declared = origin.numbers if origin else {}
        self._short = origin.short_names if origin else {}
        self._targets: dict[str, list[Target]] = {}
        for name, target in _targets(structure):
            self._targets.setdefault(name, []).append(target)

    def __len__(self) -> int:
        return len(dict.fromkeys(self))

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys((*self._declared, *self._targets)))

    def __contains__(self, name: object) -> bool:
        return name in self._targets or name in self._declared or name in self._short

    def __getitem__(self, name: str) -> Array:
        return self.value(self.find(name, "parameters"))

    def _table(self) -> PrintedTable:
        """Return names, values and units."""
        rows = [
            (place.name, _written(self.value(place)), self.unit(place)) for place in map(self._place, self)
        ]
        return PrintedTable("" if rows else "no parameters", ("parameter", "value", "unit"), rows)

    def _place(self, name: str) -> ParameterPlace:
        """Return the place of a known parameter, without asking what else follows from it."""
        targets = tuple(self._targets.get(name, ()))
        size = max((target.entries.stop for target in targets), default=0)
        return ParameterPlace(name, targets, size, name if name in self._declared else None)

    @prints
    def __repr__(self) -> str:
        return self._table().text

    def _repr_html_(self) -> str:
        """Return the table for a notebook."""
        return self._table().html

    def value(self, place: ParameterPlace) -> Array:
        """Return the numbers (size,) of a parameter."""
        if place.declared is not None:
            given = self._declared[place.declared].value.ravel()
            return given.copy() if place.entry is None else given[place.entry : place.entry + 1]
        found = np.zeros(place.size)
        for target in place.targets:
            found[target.entries] = self.owner(target).p[target.numbers]
        return found

    def owner(self, target: Target) -> Instance | LawInstance:
        """Return the element or law that some numbers belong to."""
        owners: Sequence[Instance | LawInstance] = self._structure.instances
        return (self._structure.laws if target.law else owners)[target.owner]

    def unit(self, place: ParameterPlace) -> str:
        """Return the unit of a parameter; of a law on a length or an angle that of the two which belongs to it."""
        if place.declared is not None and (unit := self._declared[place.declared].unit):
            return unit
        if split_entry(place.name)[0] not in self._targets:
            return ""
        target = self._targets[split_entry(place.name)[0]][0]
        owner = self.owner(target)
        unit = next(
            parameter.unit for parameter in owner.spec.parameters if parameter.name == target.parameter
        )
        if isinstance(owner, LawInstance) and " or " in unit:
            s, of = self._structure, [*owner.deformations, *owner.slips]
            linear, turning = unit.split(" or ", 1)
            return turning if s.units[s.index[of[0]]].startswith("rad") else linear
        return unit

    def find(self, name: Any, owner: str) -> ParameterPlace:
        """Return the place of a parameter; raise a ModelError with the nearest known names otherwise."""
        base, entry = split_entry(name)
        given = base if base in self._targets else self._short.get(base, base)
        if given in self._declared and (base not in self._targets or self._more_follows(base)):
            return _entry(name, given, entry, (), self._declared[given].value.size, owner)
        if base not in self._targets:
            self._refuse_former(base, owner)
            raise ModelError(f"{owner}: {unknown(str(name), list(self), 'parameter')}")
        targets = self._targets[base]
        return _entry(
            name, None, entry, tuple(targets), max(target.entries.stop for target in targets), owner
        )

    def declared(self, place: ParameterPlace, owner: str) -> ParameterPlace | None:
        """Return the number of a part that has the name of some numbers of elements and laws, if there is one."""
        base, entry = split_entry(place.name)
        if base not in self._declared:
            return None
        return _entry(place.name, base, entry, (), self._declared[base].value.size, owner)

    def _more_follows(self, name: str) -> bool:
        """Whether other numbers follow from one that a part was given than those that have its name."""
        assert self._origin is not None
        known = self._origin.more_follows
        if name not in known:
            known[name] = self._tried(self._origin, name)
        return known[name]

    def _tried(self, origin: Origin, name: str) -> bool:
        """Change the number a little, and compare all tables with those in which it alone is changed."""
        given = self._declared[name].value
        probe = given * (1 - PROBE) if given.any() else given + PROBE
        targets = self._targets[name]
        size = max(target.entries.stop for target in targets)
        if size != probe.size:
            return True
        try:
            lowered = origin.lowered({name: probe}, name)
        except ModelError:  # the part takes no other value, such as the vector of a direction
            return False
        direct = self.owners([ParameterPlace(name, tuple(targets), size)], [probe.ravel()])
        pairs: list[tuple[bool, Sequence[Instance | LawInstance], Sequence[Instance | LawInstance]]] = [
            (False, list(lowered.instances.values()), self._structure.instances),
            (True, lowered.laws, self._structure.laws),
        ]
        return not all(
            np.array_equal(own.p, direct.get((is_law, i), before).p)
            for is_law, table, earlier in pairs
            for i, (own, before) in enumerate(zip(table, earlier, strict=False))
        )

    def _refuse_former(self, name: str, owner: str) -> None:
        """Raise a ModelError for a matrix or a number that follows from the parameters of an elastic law."""
        part, _, word = name.rpartition(".")
        element = part.removesuffix(" warping")
        laws = [law for law in self._structure.laws if law.called is not None and law.name == element]
        if laws and word in FORMER_NAMES:
            known = dict.fromkeys(
                f"{element}.{split_entry(entry)[0]}" for law in laws for entry in (law.called or {}).values()
            )
            raise ModelError(
                f"{owner}: '{name}' follows from the parameters of '{element}'; give these: {', '.join(known)}"
            )

    def changed(self, places: Sequence[ParameterPlace], values: Sequence[Array]) -> Structure:
        """Return the structure with other values of some parameters."""
        s, owners = self._structure, self.owners(places, values)
        instances = tuple(owners.get((False, i), instance) for i, instance in enumerate(s.instances))
        laws = tuple(owners.get((True, i), law) for i, law in enumerate(s.laws))
        return replace(s, instances=instances, laws=laws)

    def owners(
        self, places: Sequence[ParameterPlace], values: Sequence[Array]
    ) -> dict[tuple[bool, int], Any]:
        """Return elements and laws with other values of some parameters, by `Target.law` and `Target.owner`."""
        rows: dict[tuple[bool, int], Array] = {}
        changed: dict[tuple[bool, int], Any] = {}
        for place, value in zip(places, values, strict=True):
            for target in place.targets:
                key, owner = (target.law, target.owner), self.owner(target)
                row = rows.setdefault(key, np.array(owner.p))
                row[target.numbers] = value[target.entries]
                changed[key] = owner
        return {key: _with(owner, rows[key]) for key, owner in changed.items()}


def _written(value: Array) -> str:
    """Write the numbers of a parameter, of many the first ones."""
    numbers = [f"{number:.6g}" for number in value[:NUMBERS]]
    if value.size == 1:
        return numbers[0]
    return f"[{', '.join(numbers)}{', …' if value.size > NUMBERS else ''}]"


def _entry(
    name: str, declared: str | None, entry: int | None, targets: tuple[Target, ...], size: int, owner: str
) -> ParameterPlace:
    """Return the place of a parameter, or of one of its entries."""
    if entry is None:
        return ParameterPlace(name, targets, size, declared)
    if not 0 <= entry < size:
        base = split_entry(name)[0]
        raise ModelError(f"{owner}: '{name}': entries of '{base}' are numbered from 0 to {size - 1}")
    having = (target for target in targets if entry in range(target.entries.start, target.entries.stop))
    return ParameterPlace(name, tuple(target.only(entry) for target in having), 1, declared, entry)


def _with(owner: Any, row: Array) -> Any:
    """Return an element or law with its parameters from a row of numbers."""
    ends = np.cumsum([0, *(parameter.size for parameter in owner.spec.parameters)]).tolist()
    parts = zip(owner.spec.parameters, ends, ends[1:], strict=False)
    return replace(
        owner, parameters=owner.parameters | {parameter.name: row[a:b] for parameter, a, b in parts}
    )


def _targets(structure: Structure) -> Iterator[tuple[str, Target]]:
    """Yield all parameters with their names; laws have also names in words.

    Gains of controllers are not included: the controller has a copy of them, for its outputs and limits.  Nor are the
    numbers of a formula: its energy has numbers that follow from those of the stress.
    """
    controllers = {c.name for c in structure.controllers}
    shared = {}  # of elements with elastic laws, by their names
    for number, instance in enumerate(structure.instances):
        elastic = instance.elastic or {}
        for parameter, numbers in _numbered(instance):
            target = Target(False, number, parameter, numbers, slice(0, numbers.stop - numbers.start))
            name = f"{instance.name}.{parameter}"
            if parameter not in elastic:
                yield name, target
            elif elastic[parameter]:
                shared[name] = target
    for number, (law, label) in enumerate(zip(structure.laws, law_labels(structure.laws), strict=True)):
        if law.called is not None:
            yield from _elastic(number, law, shared)
            continue
        if law.name in controllers:
            continue
        for parameter, numbers in _numbered(law):
            if parameter != FORMULA_NUMBERS:
                entries = slice(0, numbers.stop - numbers.start)
                name = f"{label}.{ALIASES.get(parameter, parameter)}"
                yield name, Target(True, number, parameter, numbers, entries)


def _elastic(number: int, law: LawInstance, shared: dict[str, Target]) -> Iterator[tuple[str, Target]]:
    """Yield the parameters of an elastic law by their names in its element; the element shares some."""
    called = law.called or {}
    for parameter, numbers in _numbered(law):
        base, entry = split_entry(f"{law.name}.{called[parameter]}")
        first = entry or 0
        yield (
            base,
            Target(True, number, parameter, numbers, slice(first, first + numbers.stop - numbers.start)),
        )
        if base in shared:
            yield base, shared.pop(base)


def _numbered(owner: Instance | LawInstance) -> Iterator[tuple[str, slice]]:
    """Yield the parameters of an element or law with the slices of their numbers among all of them."""
    first = 0
    for parameter in owner.spec.parameters:
        yield parameter.name, slice(first, first + parameter.size)
        first += parameter.size
