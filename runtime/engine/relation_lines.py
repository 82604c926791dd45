"""Rows of J of linear relations, combined from the rows of their terms in flat storage."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.engine.groups import Group
from flexel.structure.structure import Structure


class RelationLines:
    """The rows of the relations, appended to those of the elements in the flat J.

    Attributes
    ----------
    quantities : ndarray of int (nr,)
    columns, widths : ndarray of int
        Coordinates of all entries, one row after another, and the number of entries in each row.
    """

    def __init__(self, structure: Structure, groups: Sequence[Group]) -> None:
        relations, first = structure.relations, structure.m + structure.k
        self._relations = relations
        places: dict[int, tuple[int, Index]] = {}
        for g in groups:
            E, rows, columns = g.shape
            for i in range(E if relations else 0):
                for row in range(rows):
                    places[int(g.lines[i, row])] = g.first_J + columns * (i * rows + row), g.places[i]
        self._ones = sum(int(np.prod(g.shape)) for g in groups)  # a one after the entries of the elements
        found = [self._row(places, first, i) for i in range(relations.rows.size)]
        # if elements are omitted, so are the relations among them
        self.quantities = relations.rows if None not in found else relations.rows[:0]
        rows_ = [z for z in found if z is not None] if self.quantities.size else []
        self.widths = np.array([z[0].size for z in rows_], dtype=np.intp)
        starts = np.cumsum([0, *self.widths])
        none = np.zeros(0, dtype=np.intp)
        self.columns = np.concatenate([none, *(z[0] for z in rows_)])
        self._targets = np.concatenate(
            [none, *(a + z[1] for a, z in zip(starts[:-1], rows_, strict=True))]
        ).astype(np.intp)
        self._sources = np.concatenate([none, *(z[2] for z in rows_)]).astype(np.intp)
        self._shares = np.concatenate([np.zeros(0), *(z[3] for z in rows_)])

    def _row(
        self, places: dict[int, tuple[int, Index]], first: int, i: int
    ) -> tuple[Index, Index, Index, Array] | None:
        """Columns of a relation's row, and for each contribution its entry there, its source and its share."""
        terms = self._relations.C[[i]].tocoo()
        columns, sources, shares = [], [], []
        for j, c in zip(terms.coords[1], terms.data, strict=True):
            if j < first and int(j) not in places:
                return None
            start, own = (self._ones, np.array([j - first])) if j >= first else places[int(j)]
            columns.append(own)
            sources.append(start + np.arange(own.size))
            shares.append(np.full(own.size, c))
        unique, inverse = np.unique(np.concatenate(columns), return_inverse=True)
        return unique, inverse, np.concatenate(sources), np.concatenate(shares)

    def among(self, chosen: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Which rows (m + k,) are terms of relations that are chosen."""
        some = self.quantities[chosen[self.quantities]]
        found = np.zeros(chosen.size, dtype=bool)
        if some.size:
            terms = abs(self._relations.C[:, : chosen.size])[np.isin(self.quantities, some)]
            found = np.asarray(terms.sum(axis=0)).ravel() > 0
        return found

    def fill(self, flat: Array, one: float = 1.0) -> Array:
        """The flat array with the rows of the relations; coordinates count as `one`: 0 for rates by x."""
        if self.quantities.size:
            entries = np.append(flat[: self._ones], one)[self._sources] * self._shares
            flat[self._ones :] = np.bincount(self._targets, entries, self.columns.size)
        return flat

    def combine(self, rows: Array) -> Array:
        """Values (m + k,) of all rows with those of the relations, where coordinates contribute nothing."""
        if self.quantities.size:
            rows[self.quantities] = 0.0
            rows[self.quantities] = self._relations.C[:, : rows.size] @ rows
        return rows
