"""The elements of one kind and where their local arrays start in flat ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.assembly import Batch


@dataclass(frozen=True)
class Group:
    """The elements of one batch and where their local arrays start in the flat ones.

    Attributes
    ----------
    lines : ndarray of int (elements, rows)
        Quantity of each local row, deformations first, then slips.
    places : ndarray of int (elements, columns)
        Coordinate of each local column.
    first_line, first_J, first_K : int
    """

    batch: Batch
    lines: Index
    places: Index
    first_line: int
    first_J: int
    first_K: int

    @property
    def shape(self) -> tuple[int, int, int]:
        """Elements, rows, columns."""
        return self.lines.shape[0], self.lines.shape[1], self.places.shape[1]

    def J(self, flat: Array) -> Array:  # noqa: N802
        """The part (elements, rows, columns) of a flat array of the kind of J."""
        E, m, n = self.shape
        return flat[self.first_J : self.first_J + E * m * n].reshape(E, m, n)

    def K(self, flat: Array) -> Array:  # noqa: N802
        """The part (elements, columns, columns) of a flat array of the kind of K."""
        E, _, n = self.shape
        return flat[self.first_K : self.first_K + E * n * n].reshape(E, n, n)


def grouped(batches: list[Batch], m: int) -> list[Group]:
    """The batches of elements with their starts in the flat arrays; `m` deformations come before the slips."""
    found: list[Group] = []
    line = J = K = 0
    for batch in batches:
        lines = np.concatenate([batch.inputs["sigma"], batch.inputs["tau"] + m], axis=1)
        group = Group(batch, lines, batch.inputs["x"], line, J, K)
        found.append(group)
        E, rows, columns = group.shape
        line, J, K = line + E * rows, J + E * rows * columns, K + E * columns**2
    return found
