"""An evaluation whose parameters can be changed: variants of a model one after another on the same tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.engine.evaluate import Evaluation
from flexel.engine.kernels import Batch, has_inertia
from flexel.engine.lanes import LANES
from flexel.engine.workspace import NEARBY
from flexel.structure.parameters import Parameters, Place
from flexel.structure.structure import Structure


class Variant:
    """An evaluation with parameters of its own, for one thread.

    Attributes
    ----------
    evaluation : Evaluation
    """

    def __init__(
        self, evaluation: Evaluation, places: Sequence[Place], structure: Structure | None = None
    ) -> None:
        tables = evaluation.tables.variant()
        tables.structure = structure or tables.structure
        self.evaluation = Evaluation(tables.structure)
        self.evaluation.__dict__["tables"] = tables  # instead of new ones
        self._targets, self._listed = [], ", ".join(f"'{z.name}'" for z in places)
        self._diagonal = np.flatnonzero(tables.M.row == tables.M.column)
        for place in places:
            number, batch, row = _row(evaluation, place)
            lane = row % LANES
            end = LANES if row == batch.size - 1 else lane + 1  # the last element fills its block
            self._targets.append(tables.parameters[place.law][number][row // LANES, place.numbers, lane:end])

    def set(self, values: Sequence[Array]) -> None:
        """Change the parameters, one array of numbers for each place."""
        for target, value in zip(self._targets, values, strict=True):
            target[:] = value[:, None]
        work = self.evaluation.work
        work.refresh()
        work.inertia()
        if (work.M[self._diagonal] < 0).any():
            raise ModelError(f"{self._listed}: these values give a negative mass; give positive ones")


def _row(evaluation: Evaluation, place: Place) -> tuple[int, Batch, int]:
    """Number of the batch of a parameter's owner, the batch, and the owner's place in it."""
    batches = evaluation.tables.laws if place.law else evaluation.tables.elements
    for number, batch in enumerate(batches):
        found = np.flatnonzero(batch.members == place.owner)
        if found.size:
            return number, batch, int(found[0])
    raise ModelError(f"'{place.name}' belongs to a relation; change its terms in the model")


def check_variable(evaluation: Evaluation, place: Place, value: Array, owner: str) -> None:
    """Check that a parameter can vary in a built system: positions must not depend on it.

    Raises
    ------
    ModelError
        If the geometry changes, or an element that was built without mass gets some.
    """
    if place.law:
        return
    structure = evaluation.structure
    changed = Parameters(structure).changed([place], [value])
    _, batch, row = _row(evaluation, place)
    variant = Variant(evaluation, [place])
    variant.set([value])
    rng = np.random.default_rng(3)
    for distance in (0.0, NEARBY):
        x = structure.x0 + distance * rng.standard_normal(structure.n)
        (e, J), (e_new, J_new) = (z.position(x) for z in (evaluation, variant.evaluation))
        if not np.array_equal(e, e_new) or abs(J - J_new).max() > 0:
            raise ModelError(
                f"{owner}: '{place.name}' changes the geometry, and with it the initial position; build the model for "
                "each value, with fx.sweep"
            )
    periods = [_periods(z) for z in (structure, changed)]
    if periods[0] != periods[1]:
        raise ModelError(
            f"{owner}: '{place.name}' changes a period; build the model for each value, with fx.sweep"
        )
    own = replace(batch, p=batch.p.copy())
    own.p[row, place.numbers] = value
    if "inertia" in batch.spec.kernels and row >= batch.heavy and has_inertia(own, structure)[row]:
        raise ModelError(
            f"{owner}: '{place.name}': the element has no mass in the system as built; give it any mass in the model"
        )


def _periods(structure: Structure) -> list[float]:
    return [d.repeats(z.parameters) for z in structure.instances for d in z.spec.deformations]
