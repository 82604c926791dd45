"""Converts numbers of parts to numbers of elements and laws, for all variants of a system."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.compile import build
from flexel.engine.variants import check_variable
from flexel.model.lowering import Lowering
from flexel.model.origin import Origin, layout_of, same_but_numbers
from flexel.model.parameters import ParameterPlace, Parameters, Target
from flexel.system import CoreSystem


@dataclass(frozen=True)
class Rebuilt:
    """Rebuilds the system of a variant, with the degrees of freedom of the first one.

    Attributes
    ----------
    origin : Origin
    values : tuple of dict of str to ndarray
        Of each variant, by the names of the numbers.
    dynamic, kinematic : tuple of str
    owner : str
        The analysis, for messages.
    kind : type
        The class of the systems.
    """

    origin: Origin
    values: tuple[dict[str, Array], ...]
    dynamic: tuple[str, ...]
    kinematic: tuple[str, ...]
    owner: str
    kind: type[CoreSystem]

    def __call__(self, i: int) -> Any:
        """Return the system of variant number i."""
        model = self.origin.lowered(self.values[i], self.owner)
        model.dynamic, model.kinematic = list(self.dynamic), list(self.kinematic)
        found = build(model, self.origin.t, self.kind)
        found.origin = self.origin.changed(self.values[i])
        return found


@dataclass(frozen=True)
class LoweredValues:
    """What numbers of parts become in elements and laws.

    Attributes
    ----------
    places : list of ParameterPlace
    rows : list of ndarray (count, size)
        Their numbers in all variants.
    profiles : tuple of dict of int to Profile
        Of each variant: other sections of beams, by the number of the element.
    anew : Rebuilt, optional
        Where more changes than numbers: builds each variant.
    """

    places: list[ParameterPlace]
    rows: list[Array]
    profiles: tuple[dict[int, object], ...] = ()
    anew: Rebuilt | None = None


def lowered_values(
    system: CoreSystem,
    parameters: Parameters,
    asked: Sequence[ParameterPlace],
    rows: Sequence[Array],
    owner: str,
) -> LoweredValues:
    """Replace numbers of parts by the numbers of elements and laws that follow from them.

    Parameters
    ----------
    system : CoreSystem
    parameters : Parameters
    asked : sequence of ParameterPlace
    rows : sequence of ndarray (count, size)
    owner : str
        The analysis, for messages.

    Raises
    ------
    ModelError
        A value that a part refuses, or one that changes the layout of the model.
    """
    pairs = [
        (_variable(system, parameters, place, row, owner), row)
        for place, row in zip(asked, rows, strict=True)
    ]
    direct = [(place, row) for place, row in pairs if place.declared is None]
    declared = [(place, row) for place, row in pairs if place.declared is not None]
    found = LoweredValues([place for place, _ in direct], [row for _, row in direct])
    origin = system.origin
    if not declared or origin is None:
        return found
    values = tuple(_by_name(parameters, declared, i) for i in range(len(declared[0][1])))
    models = [origin.lowered(some, owner) for some in values]  # reports functions that were lost
    base = origin.unchanged
    layout = layout_of(base)
    for model in models:
        if layout_of(model) != layout:
            names = ", ".join(f"'{place.name}'" for place, _ in declared)
            raise ModelError(
                f"{owner}: {names} changes which nodes, elements or laws the model has; build the model for each "
                "value, with fx.sweep"
            )
    places, columns = _changed(base, models, declared[0][0].name)
    moved = not all(same_but_numbers(base, model) for model in models)
    if not moved and _can_vary(system, parameters, places, columns, owner):
        profiles = tuple(_profiles(base, model) for model in models)
        return LoweredValues(found.places + places, found.rows + columns, profiles)
    if direct or _differs(base, system):
        raise ModelError(
            f"{owner}: '{declared[0][0].name}' changes the geometry, so that the model is rebuilt, without "
            f"{'the changes to' if not direct else 'values of'} single elements and laws; give values of parts alone"
        )
    anew = Rebuilt(origin, values, tuple(system.dynamic), tuple(system.kinematic), owner, type(system))
    return LoweredValues([], [], anew=anew)


def _profiles(base: Lowering, model: Lowering) -> dict[int, object]:
    """Return the sections of beams that differ from the first model's, by the number of the element."""
    pairs = zip(base.instances.values(), model.instances.values(), strict=True)
    return {i: other.profile for i, (own, other) in enumerate(pairs) if other.profile != own.profile}


def _by_name(
    parameters: Parameters, declared: Sequence[tuple[ParameterPlace, Array]], i: int
) -> dict[str, Array]:
    """Return all entries of the numbers of parts in variant number i."""
    found: dict[str, Array] = {}
    for place, row in declared:
        name = place.declared or ""
        whole = found.get(name, parameters.value(replace(place, entry=None)))
        if place.entry is None:
            whole = row[i].copy()
        else:
            whole[place.entry] = row[i][0]
        found[name] = whole
    return found


def _owners(model: Lowering) -> list[tuple[bool, int, Array]]:
    """Return the numbers of all elements and laws."""
    elements = [(False, i, instance.p) for i, instance in enumerate(model.instances.values())]
    return elements + [(True, i, law.p) for i, law in enumerate(model.laws)]


def _changed(
    base: Lowering, models: Sequence[Lowering], name: str
) -> tuple[list[ParameterPlace], list[Array]]:
    """Return the numbers of elements and laws that differ from the model's in any variant, as one place."""
    targets: list[Target] = []
    columns = []
    tables = [_owners(model) for model in models]
    for k, (is_law, i, before) in enumerate(_owners(base)):
        rows = np.array([table[k][2] for table in tables])
        different = (rows != before).any(axis=0)
        for number in np.flatnonzero(different).tolist():
            entry = slice(len(targets), len(targets) + 1)
            targets.append(Target(is_law, i, "", slice(number, number + 1), entry))
            columns.append(rows[:, number])
    if not targets:
        return [], []
    return [ParameterPlace(name, tuple(targets), len(targets))], [np.column_stack(columns)]


def _variable(
    system: CoreSystem, parameters: Parameters, place: ParameterPlace, row: Array, owner: str
) -> ParameterPlace:
    """Return the place if its numbers can vary in the built system, else the part's place; the part is built anew."""
    if place.declared is not None:
        return place
    if row[:, place.rigid].any():
        raise ModelError(f"{owner}: '{place.name}' belongs to a rigid mode; make it flexible")
    try:
        _check_variable(system, parameters, place, row, owner)
    except ModelError:
        if (declared := parameters.declared(place, owner)) is None:
            raise
        return declared
    return place


def _can_vary(
    system: CoreSystem,
    parameters: Parameters,
    places: Sequence[ParameterPlace],
    columns: Sequence[Array],
    owner: str,
) -> bool:
    """Whether neither positions nor constraints depend on the numbers.

    Each is tried with the first of its values that differs from the system's, all of them together.
    """
    try:
        for place, column in zip(places, columns, strict=True):
            first = np.argmax(column != parameters.value(place), axis=0)
            tried = column[first, np.arange(place.size)]
            _check_variable(system, parameters, place, tried[None, :], owner)
    except ModelError:  # it is built anew
        return False
    return True


def _check_variable(
    system: CoreSystem, parameters: Parameters, place: ParameterPlace, column: Array, owner: str
) -> None:
    """Check that numbers can vary in the built system, by the first variant that has others than the system."""
    held = np.concatenate([system.roles.holonomic, system.roles.zero])
    other = np.flatnonzero((column != parameters.value(place)).any(axis=1))
    if other.size:
        check_variable(system.evaluation, place, column[other[0]], owner, held, system._start.x)


def _differs(base: Lowering, system: CoreSystem) -> bool:
    """Whether numbers of elements or laws of the system are not those that follow from its parts."""
    structure = system.structure
    return any(
        not np.array_equal(numbers, (structure.laws if is_law else structure.instances)[i].p)
        for is_law, i, numbers in _owners(base)
    )
