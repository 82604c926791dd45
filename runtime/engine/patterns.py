"""Patterns of the sparse matrices of a model: J = [De; V; 1], the mass matrix, and what relations add to J."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import csr_array

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.stages import Stage, Sums, flat, sums
from flexel.model.structure import Structure


@dataclass(frozen=True)
class Terms:
    """Products: out[target] += factor in[source]."""

    target: Index
    source: Index
    factor: Array


def terms(rows: Sequence[tuple[int, int, float]]) -> Terms:
    """Convert a list of (target, source, factor) to terms."""
    found = np.array(rows, dtype=float).reshape(-1, 3)
    return Terms(found[:, 0].astype(np.intp), found[:, 1].astype(np.intp), found[:, 2].copy())


class Pattern:
    """Pattern of a sparse matrix by rows, columns in increasing order.

    Attributes
    ----------
    start, column : ndarray of int
        Where the rows start, and the columns of the entries.
    """

    def __init__(self, rows: Index, columns: Index, shape: tuple[int, int]) -> None:
        self.shape = shape
        self._codes = np.unique(rows * shape[1] + columns)
        self.row, self.column = self._codes // max(shape[1], 1), self._codes % max(shape[1], 1)
        self.start = np.searchsorted(self.row, np.arange(shape[0] + 1))

    @property
    def size(self) -> int:
        """Number of entries."""
        return int(self._codes.size)

    def matrix(self, values: Array) -> Any:
        """Return a sparse matrix with a copy of the values."""
        return csr_array((values.copy(), self.column, self.start), shape=self.shape)

    def rows_of(self, rows: Index, width: int) -> tuple[Index, Index]:
        """Return the entries of some rows in the first columns, and for each the number of its row among them."""
        entries = flat(np.arange(self.start[i], self.start[i + 1]) for i in rows)
        place = np.repeat(np.arange(rows.size), self.start[rows + 1] - self.start[rows])
        own = self.column[entries] < width
        return entries[own], place[own]

    def find(self, rows: Index, columns: Index) -> Index:
        """Return the numbers of entries of the pattern."""
        return np.searchsorted(self._codes, rows * self.shape[1] + columns)


class JacobianPattern(Pattern):
    """The pattern of J, which holds the derivatives of the rates and accelerations of quantities as well.

    A row has all coordinates of its element, or of the terms of its relation, whether their entries vanish or not.

    Attributes
    ----------
    own : list of ndarray of int (elements, rows, columns)
        Entries of the elements of each batch.
    relations : Terms
        What relations add to their rows.
    filled : ndarray of bool
        Entries that can differ from zero in J.
    """

    def __init__(self, structure: Structure, batches: Sequence[Batch], position: Stage) -> None:
        m, k, n = structure.m, structure.k, structure.n
        self.lines = [np.concatenate([b.places["sigma"], b.places["tau"] + m], axis=1) for b in batches]
        columns = [b.places["x"] for b in batches]
        units = np.arange(n)
        rows = [np.repeat(lines, c.shape[1], axis=1) for lines, c in zip(self.lines, columns, strict=True)]
        across = [np.tile(c, (1, lines.shape[1])) for lines, c in zip(self.lines, columns, strict=True)]
        row_of, column_of = flat([*rows, units + m + k]), flat([*across, units])
        own = Pattern(row_of, column_of, (m + k + n, n))
        related = [
            (np.full(c.size, r), c) for r, terms_ in _relations(structure) for c in _columns(own, terms_)
        ]
        super().__init__(
            flat([row_of, *(row for row, _ in related)]),
            flat([column_of, *(column for _, column in related)]),
            own.shape,
        )
        self.own = [
            self.find(r, c).reshape(*lines.shape, x.shape[1])
            for r, c, lines, x in zip(rows, across, self.lines, columns, strict=True)
        ]
        self.units = self.find(units + m + k, units)
        self.relations = self._related(structure)
        self.sums = self._sums(position, ("De", "V"), position.one)
        self.filled = np.zeros(self.size, dtype=bool)
        self.filled[self.sums.filled(position.zero)] = True
        self.filled[self.relations.target] = True

    def _related(self, structure: Structure) -> Terms:
        found: list[tuple[int, int, float]] = []
        for r, terms_ in _relations(structure):
            for j, c in terms_:
                entries = np.arange(self.start[j], self.start[j + 1])
                targets = self.find(np.full(entries.size, r), self.column[entries])
                found += [(t, s, c) for t, s in zip(targets.tolist(), entries.tolist(), strict=True)]
        return terms(found)

    def _sums(self, stage: Stage, names: tuple[str, ...], unit: int | None) -> Sums:
        """Sum the entries of outputs whose rows follow one another in the elements; coordinates have `unit`."""
        targets, sources = [], []
        for i in stage.numbers:
            E, rows, columns = self.own[i].shape
            entries = self.own[i].reshape(E, -1)
            for name in names:  # they end with the last row
                first = columns * (rows - stage.rows(i, name) if name == names[-1] else 0)
                targets.append(entries[:, first + stage.nonzeros(i, name)])
                sources.append(stage.places(i, name))
        if unit is not None:
            targets.append(self.units)
            sources.append(np.full(self.units.size, unit))
        return sums(flat(targets), flat(sources), self.size, stage.zero)

    def derivatives(self, stage: Stage, name: str) -> Sums:
        """Sum the entries of derivatives of rates or accelerations, from a stage with rows of all quantities."""
        return self._sums(stage, (name,), None)


def _relations(structure: Structure) -> list[tuple[int, list[tuple[int, float]]]]:
    """Return each relation with its terms: quantities and coefficients."""
    found = []
    for r, i in enumerate(structure.relations.rows.tolist()):
        row = structure.relations.C[[r]].tocoo()
        found.append((i, list(zip(row.coords[1].tolist(), row.data.tolist(), strict=True))))
    return found


def _columns(own: Pattern, terms_: list[tuple[int, float]]) -> list[Index]:
    return [own.column[own.start[j] : own.start[j + 1]] for j, _ in terms_]


@dataclass(frozen=True)
class RelationTerms:
    """How relations follow from their terms: values from e and x, convective parts; and stresses of the terms."""

    e: Terms
    x: Terms
    g: Terms
    stress: Terms


def relation_terms(structure: Structure) -> RelationTerms:
    """Return the terms of all relations."""
    m, first = structure.m, structure.m + structure.k
    every = [(r, j, c) for r, row in _relations(structure) for j, c in row]
    return RelationTerms(
        e=terms([term for term in every if term[1] < m]),
        x=terms([(r, j - first, c) for r, j, c in every if j >= first]),
        g=terms([term for term in every if term[1] < first]),
        stress=terms([(j, r, c) for r, j, c in every if j < first]),
    )


class MassPattern(Pattern):
    """The pattern of the mass matrix, free columns first.

    Attributes
    ----------
    free : ndarray of int (n,)
        For each row, the end of its free columns.
    """

    def __init__(self, structure: Structure, batches: Sequence[Batch], inertia: Stage) -> None:
        n, rows, columns, sources, weights = structure.n, [], [], [], []
        for i in inertia.numbers:
            x, at = batches[i].places["x"][: inertia.size[i]], inertia.nonzeros(i, "M")
            rows.append(x[:, at // x.shape[1]])
            columns.append(x[:, at % x.shape[1]])
            sources.append(inertia.places(i, "M"))
            weights.append(np.repeat(batches[i].weight[: inertia.size[i], None], at.size, axis=1))
        row, column = flat(rows), flat(columns)
        super().__init__(row, column, (n, n))
        at = self.find(row, column)
        self.sums = sums(at, flat(sources), self.size, inertia.zero)
        share = np.concatenate([np.zeros(0), *(np.ravel(values) for values in weights)])
        self.damped = bool(share.any())
        self.damping = sums(at, flat(sources), self.size, inertia.zero, share)
        self.free = self.start[:-1] + np.bincount(self.row[self.column < structure.nf], minlength=n)
