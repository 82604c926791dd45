"""Laws of a structure as tables: their forces, and their derivatives by pairs of quantities.

A pair (i, j) says that the stress of quantity i depends on quantity j.  Pairs within one element are multiplied in
the lanes of the element; a pair across elements, or with a relation, gives the outer product of two rows of J.
Internal states z of laws that follow from an implicit step are condensed, law by law.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.batches import Batch
from flexel.engine.lanes import filled
from flexel.engine.patterns import JacobianPattern
from flexel.engine.stages import Stage, flat, sums
from flexel.model.structure import Structure


@dataclass(frozen=True)
class Lag:
    """Laws of a type with internal states; see `flexel_lag` in table.h.

    Attributes
    ----------
    at : ndarray of int (laws, rows x columns)
        Places of all derivatives in the buffer of the tangents.
    z : ndarray of int (laws, nz)
    lasting : bool
        Whether the states change with displacements only.
    first : int
        Where their condensed derivatives start in the buffer.
    matrix, sides : int
        Where the matrix (nz, nz) and the right-hand sides (nz, 2m + k) of one law are stored in the buffer.
    """

    count: int
    m: int
    k: int
    at: Index
    z: Index
    lasting: bool
    first: int
    matrix: int
    sides: int


class LawTables:
    """The laws of a structure.

    Attributes
    ----------
    law, tangent : Stage
    width : int
        Numbers in the buffer of the tangents, with condensed derivatives and the systems of equations that give them;
        then come a zero and a one.
    codes : ndarray of int (pairs,)
        Pairs of quantities, i * (m + k) + j.
    """

    def __init__(self, structure: Structure, batches: Sequence[Batch]) -> None:
        self.structure, self.batches = structure, batches
        self._rows = max(structure.m + structure.k, 1)
        self.law, self.tangent = Stage("law", batches), Stage("tangent", batches)
        self.count = sum(b.size for b in batches)
        self.first = np.cumsum([0, *(b.size for b in batches)])
        self.lines = [np.concatenate([b.places["e"], b.places["s"]], axis=1) for b in batches]
        pairs = [self._pairs(i)[:, _coupled(b, self.tangent, i)].ravel() for i, b in enumerate(batches)]
        self.codes = np.unique(flat(pairs))
        self.width = self.tangent.width
        self.lags = [self._lag(i) for i, b in enumerate(batches) if b.places["z"].shape[1]]
        self._collect()

    def _pairs(self, i: int) -> Index:
        """Return the codes (laws, rows, rows) of all pairs of a batch."""
        lines = self.lines[i]
        return np.asarray(lines[:, :, None] * self._rows + lines[:, None, :])

    @property
    def zero(self) -> int:
        """Place of a zero in the buffer of the tangents."""
        return self.width

    def _lag(self, i: int) -> Lag:
        b = self.batches[i]
        m, k, nz = (b.places[name].shape[1] for name in ("e", "s", "z"))
        rows, columns = m + k + nz, 2 * m + k + nz
        at = np.full((b.size, rows * columns), -1)
        at[:, self.tangent.nonzeros(i, "J")] = self.tangent.places(i, "J")
        first = self.width
        matrix = first + b.size * (m + k) * (2 * m + k)
        sides = matrix + nz * nz
        self.width = sides + nz * max(2 * m + k, 1)
        lasting = all(state.lasting for state in b.spec.states)
        return Lag(b.size, m, k, at, b.places["z"], lasting, first, matrix, sides)

    def _collect(self) -> None:
        """Collect the sums of all outputs; laws are numbered batch by batch."""
        m, law = self.structure.m, self.law
        found: list[list[tuple[Index, Index]]] = [[] for _ in range(6)]
        stress, zd, U, P, value, rate = found
        lags = iter(self.lags)
        for i, b in enumerate(self.batches):
            for parts, name, targets in (
                (stress, "sigma", b.places["e"]),
                (stress, "tau", b.places["s"]),
                (zd, "zd", b.places["z"]),
                (U, "U", self.first[i] + np.arange(b.size)[:, None]),
                (P, "P", self.first[i] + np.arange(b.size)[:, None]),
            ):
                parts.append((targets[:, law.nonzeros(i, name)], law.places(i, name)))
            self._derivatives(i, next(lags) if b.places["z"].shape[1] else None, value, rate)
        for lag in self.lags:
            lag.at[lag.at < 0] = self.zero
        self.stress = law.summed(stress, m + self.structure.k)
        self.zd = law.summed(zd, self.structure.nz)
        self.U, self.P = law.summed(U, self.count), law.summed(P, self.count)
        size = self.codes.size
        self.value, self.rate = (
            sums(
                flat(targets for targets, _ in part),
                flat(places for _, places in part),
                size,
                self.zero,
            )
            for part in (value, rate)
        )

    def _derivatives(
        self, i: int, lag: Lag | None, value: list[tuple[Index, Index]], rate: list[tuple[Index, Index]]
    ) -> None:
        """Add the pairs of a batch with the places of their derivatives, by e and by rates."""
        m, k = (self.batches[i].places[name].shape[1] for name in ("e", "s"))
        direct = 2 * m + k
        if lag is None:
            at, places = self.tangent.nonzeros(i, "J"), self.tangent.places(i, "J")
        else:
            at = np.arange((m + k) * direct)
            places = lag.first + np.arange(lag.count * at.size).reshape(lag.count, at.size)
        row, column = at // direct, at % direct
        pair = np.searchsorted(self.codes, self._pairs(i))
        own = np.where(column < m, column, column - m)
        for part, some in ((value, column < m), (rate, column >= m)):
            part.append((pair[:, row[some], own[some]], places[:, some]))

    def find(self, codes: Index) -> Index:
        """Return the pair of each code; where there is none, the number of pairs, the index of a zero."""
        size = self.codes.size
        at = np.minimum(np.searchsorted(self.codes, codes), size - 1) if size else np.zeros_like(codes)
        return np.where(self.codes[at] == codes, at, size) if size else at

    def own(self, lines: Index) -> tuple[Index, bool] | None:
        """Return the pairs within elements of a type, in lanes, and whether all are diagonal; None if no law acts.

        Parameters
        ----------
        lines : ndarray of int (elements, rows)
        """
        size = self.codes.size
        pairs = self.find(lines[:, :, None] * self._rows + lines[:, None, :])
        if np.all(pairs == size):
            return None
        diagonal = np.eye(lines.shape[1], dtype=bool)
        alone = bool(np.all(pairs[:, ~diagonal] == size))
        found = pairs[:, diagonal] if alone else pairs.reshape(lines.shape[0], -1)
        return filled(found, size), alone

    def foreign(self, J: JacobianPattern) -> tuple[Index, Index, Index]:
        """Return the pairs across elements, and the two entries of J that are multiplied."""
        element = np.zeros(self._rows, dtype=np.intp)
        number = 0
        for lines in J.lines:
            element[lines] = number + np.arange(lines.shape[0])[:, None]
            number += lines.shape[0]
        rows = self.structure.relations.rows
        element[rows] = number + np.arange(rows.size)
        related = np.isin(np.arange(self._rows), rows)
        left, right = self.codes // self._rows, self.codes % self._rows
        found = []
        for p in np.flatnonzero((element[left] != element[right]) | related[left]):
            a, b = (np.arange(J.start[side[p]], J.start[side[p] + 1]) for side in (left, right))
            found.append((np.full(a.size * b.size, p), np.repeat(a, b.size), np.tile(b, a.size)))
        pair, at, by = (flat(arrays[i] for arrays in found) for i in range(3))
        return pair, at, by

    @cached_property
    def entries(self) -> tuple[Index, Index, Index]:
        """All derivatives of (sigma, tau, dz/dt) by (e, de/dt, s, z): rows, columns, places in the buffer."""
        m, k = self.structure.m, self.structure.k
        parts: list[tuple[Index, Index, Index]] = []
        for i, b in enumerate(self.batches):
            d, s, z = (b.places[name] for name in ("e", "s", "z"))
            lines = np.concatenate([d, s, z + m + k], axis=1)
            columns = np.concatenate([d, d + m, s + m, z + 2 * m + k], axis=1)
            at = self.tangent.nonzeros(i, "J")
            row, column = lines[:, at // columns.shape[1]], columns[:, at % columns.shape[1]]
            parts.append((row, column, self.tangent.places(i, "J")))
        rows, across, places = (flat(part[i] for part in parts) for i in range(3))
        return rows, across, places


def _coupled(batch: Batch, stage: Stage, i: int) -> Array:
    """Return which stresses (rows) of a law depend on which of its quantities (rows, rows), at all."""
    m, k, nz = (batch.places[name].shape[1] for name in ("e", "s", "z"))
    found = np.full((m + k, m + k), nz > 0)
    row, column = np.divmod(stage.nonzeros(i, "J"), 2 * m + k + nz)
    own = (row < m + k) & (column < 2 * m + k)
    found[row[own], np.where(column[own] < m, column[own], column[own] - m)] = True
    return found
