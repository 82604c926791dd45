"""An evaluation whose parameters can be changed: variants of a model one after another on the same tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.engine.batches import Batch, has_inertia
from flexel.engine.evaluate import Evaluation
from flexel.engine.lanes import LANES
from flexel.engine.workspace import NEARBY
from flexel.model.parameters import ParameterPlace, Parameters, Target
from flexel.model.structure import Structure


class Variant:
    """An evaluation with separate parameters, for one thread.

    Attributes
    ----------
    evaluation : Evaluation
    """

    def __init__(
        self, evaluation: Evaluation, places: Sequence[ParameterPlace], structure: Structure | None = None
    ) -> None:
        tables = evaluation.tables.variant()
        tables.structure = structure or tables.structure
        self.evaluation = Evaluation(tables.structure)
        self.evaluation.__dict__["tables"] = tables  # instead of new ones
        self._targets, self._listed = [], ", ".join(f"'{place.name}'" for place in places)
        self._diagonal = np.flatnonzero(tables.M.row == tables.M.column)
        for place in places:
            kept = []
            for target in place.targets:
                number, batch, row = _row(evaluation, place.name, target)
                lane = row % LANES
                end = LANES if row == batch.size - 1 else lane + 1  # the last element fills its block
                block = tables.parameters[target.law][number][row // LANES]
                kept.append((block[target.numbers, lane:end], target.entries))
            self._targets.append(kept)

    def set(self, values: Sequence[Array]) -> None:
        """Change the parameters, one array of numbers for each place."""
        for kept, value in zip(self._targets, values, strict=True):
            for numbers, entries in kept:
                numbers[:] = value[entries, None]
        work = self.evaluation.work
        work.refresh()
        work.inertia()
        if (work.M[self._diagonal] < 0).any():
            raise ModelError(f"{self._listed}: these values give a negative mass; give positive ones")


def _row(evaluation: Evaluation, name: str, target: Target) -> tuple[int, Batch, int]:
    """Number of the batch of a parameter's owner, the batch, and the owner's place in it."""
    batches = evaluation.tables.laws if target.law else evaluation.tables.elements
    for number, batch in enumerate(batches):
        found = np.flatnonzero(batch.members == target.owner)
        if found.size:
            return number, batch, int(found[0])
    raise ModelError(f"'{name}' belongs to a relation; change its terms in the model")


def check_variable(
    evaluation: Evaluation, place: ParameterPlace, value: Array, owner: str, held: Index, start: Array
) -> None:
    """Check that a parameter can vary in a built system: neither its start nor its constraints depend on it.

    Parameters
    ----------
    value : ndarray (size,)
        Another value of the parameter.
    held : ndarray of int
        Quantities that are rigid, prescribed or without slip.
    start : ndarray (n,)
        Coordinates of the initial state.

    Raises
    ------
    ModelError
        If the geometry changes, or an element that was built without mass gets some.
    """
    targets = [target for target in place.targets if not target.law]
    if not targets:
        return
    structure = evaluation.structure
    changed = Parameters(structure).changed([place], [value])
    variant = Variant(evaluation, [place])
    variant.set([value])
    rng, every = np.random.default_rng(3), np.arange(structure.m + structure.k)
    places = [(start, every)]
    places += [(structure.x0 + far * rng.standard_normal(structure.n), held) for far in (0.0, NEARBY)]
    for x, rows in places:
        (e, J), (e_new, J_new) = (version.position(x) for version in (evaluation, variant.evaluation))
        same = np.array_equal(e[rows[rows < e.size]], e_new[rows[rows < e.size]])
        if not same or (rows.size and abs(J[rows] - J_new[rows]).max() > 0):
            raise ModelError(
                f"{owner}: '{place.name}' changes the geometry, and with it the initial position; build the model for "
                "each value, with fx.sweep"
            )
    periods = [_periods(layout) for layout in (structure, changed)]
    if periods[0] != periods[1]:
        raise ModelError(
            f"{owner}: '{place.name}' changes a period; build the model for each value, with fx.sweep"
        )
    for target in targets:
        _, batch, row = _row(evaluation, place.name, target)
        own = replace(batch, p=batch.p.copy())
        own.p[row, target.numbers] = value[target.entries]
        if (
            "inertia" in batch.spec.kernels
            and row >= batch.n_with_inertia
            and has_inertia(own, structure)[row]
        ):
            raise ModelError(
                f"{owner}: '{place.name}': the element has no mass in the system as built; give it some mass in the "
                "model"
            )


def _periods(structure: Structure) -> list[float]:
    return [
        d.repeats(instance.parameters) for instance in structure.instances for d in instance.spec.deformations
    ]
