"""The tangents of laws as a list of pairs of quantities, and their contribution to the stiffness.

A pair (i, j) says that the stress of quantity i depends on quantity j.  Pairs within one element are
multiplied element by element, as a scaling where every stress depends on its own quantity only; a pair across elements
gives the outer product of two rows of J.
Imports numpy and the assembly.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from flexel.assembly import Batch, Place
from flexel.structure import Array, Index, Structure

if TYPE_CHECKING:
    from flexel.local import Group


class LawPairs:
    """Which stresses depend on which quantities.

    Attributes
    ----------
    size : int
        Number of pairs; values by pair have one more entry, zero, for what is not there.
    left, right : ndarray of int
        Entries of the flat J whose products pairs across elements add to the stiffness.
    """

    def __init__(self, structure: Structure, laws: Sequence[Batch], groups: Sequence[Group]) -> None:
        self.structure, self._groups = structure, groups
        self._width = structure.m + structure.k
        self._laws = {id(b): self._lines(b) for b in laws}
        starts = np.cumsum([0, *(b.size for b in laws)])
        self._first_law = {id(b): int(z) for b, z in zip(laws, starts[:-1], strict=True)}
        codes = [(z[:, :, None] * self._width + z[:, None, :]).ravel() for z in self._laws.values()]
        self._codes = np.unique(np.concatenate(codes)) if codes else np.zeros(0, dtype=np.intp)
        self.size = self._codes.size
        self._index = [self._own(g) for g in groups]
        self._foreign()

    def _lines(self, batch: Batch) -> Index:
        return np.concatenate([batch.inputs["e"], batch.inputs["s"] + self.structure.m], axis=1)

    def place(self, batch: Batch, name: str) -> Place:
        """Where an output of a law goes."""
        lines = self._laws[id(batch)]
        m, size = batch.inputs["e"].shape[1], self.size + 1
        if name in ("sigma", "tau"):
            return Place("stress", (self._width,), lines[:, :m] if name == "sigma" else lines[:, m:], True)
        if name == "U":
            one = self._first_law[id(batch)] + np.arange(batch.size)[:, None]
            return Place("U", (0,), one, False)
        pair = np.searchsorted(self._codes, lines[:, :, None] * self._width + lines[:, None, :])
        places = np.concatenate([pair[:, :, :m], size + pair], axis=2)  # by e | by its rate and by s
        return Place("L", (2, size), places.reshape(batch.size, -1), True)

    def _find(self, codes: Index) -> Index:
        """Pair of each code, `size` where there is none."""
        if not self.size:
            return np.zeros(codes.shape, dtype=np.intp)
        at = np.minimum(np.searchsorted(self._codes, codes), self.size - 1)
        return np.where(self._codes[at] == codes, at, self.size)

    def _own(self, group: Group) -> Index | None:
        """Pairs of a group: (elements, rows) where all are diagonal, else (elements, rows, rows); None without laws."""
        z = group.lines
        pairs = self._find(z[:, :, None] * self._width + z[:, None, :])
        if np.all(pairs == self.size):
            return None
        diagonal = np.eye(z.shape[1], dtype=bool)
        if np.all(pairs[:, ~diagonal] == self.size):
            return pairs[:, diagonal]
        return pairs

    def _foreign(self) -> None:
        """Entries of the pairs across elements: the pair, and the two entries of J that are multiplied."""
        element = np.empty(self._width, dtype=np.intp)
        first = np.empty(self._width, dtype=np.intp)
        count = np.empty(self._width, dtype=np.intp)
        number = 0
        for g in self._groups:
            E, rows, columns = g.shape
            element[g.lines] = number + np.arange(E)[:, None]
            first[g.lines] = g.first_J + columns * np.arange(E * rows).reshape(E, rows)
            count[g.lines] = columns
            number += E
        across = np.flatnonzero(
            element[self._codes // max(self._width, 1)] != element[self._codes % max(self._width, 1)]
        )
        pair: list[Index] = []
        left: list[Index] = []
        right: list[Index] = []
        for p in across:
            i, j = divmod(int(self._codes[p]), self._width)
            a, b = np.meshgrid(
                first[i] + np.arange(count[i]), first[j] + np.arange(count[j]), indexing="ij"
            )
            pair.append(np.full(a.size, p))
            left.append(a.ravel())
            right.append(b.ravel())
        empty = [np.zeros(0, dtype=np.intp)]
        self._pair, self.left, self.right = (np.concatenate(z or empty) for z in (pair, left, right))

    def add(self, K: Array, J: Array, phi: Array | None, by_value: Array, by_rate: Array, rate: float) -> Array:
        """Add J' ((by value + rate by rate) J + by rate Phi) within elements to the flat K.

        Returns the same for the pairs across elements: entries in the rows `left` and columns `right` of J.
        """
        S = by_value + rate * by_rate
        for g, index in zip(self._groups, self._index, strict=True):
            if index is None:
                continue
            own, damping = S[index], by_rate[index] if phi is not None else None
            Jg, Kg, phig = g.J(J), g.K(K), None if phi is None else g.J(phi)
            some = own.reshape(g.shape[0], -1).any(axis=1)
            if damping is not None:
                some |= damping.reshape(g.shape[0], -1).any(axis=1)
            if not some.all():  # contacts that do not touch cost nothing further
                own, Jg = own[some], Jg[some]
                if damping is not None and phig is not None:
                    damping, phig = damping[some], phig[some]
            W = _times(own, Jg)
            if damping is not None and phig is not None:
                W += _times(damping, phig)
            product = Jg.transpose(0, 2, 1) @ W
            if some.all():
                Kg += product
            else:
                Kg[some] += product
        right = S[self._pair] * J[self.right]
        if phi is not None:
            right += by_rate[self._pair] * phi[self.right]
        return np.asarray(J[self.left] * right)


def _times(S: Array, A: Array) -> Array:
    """Products with matrices (elements, rows, rows), or with diagonals of them (elements, rows)."""
    return np.asarray(S[:, :, None] * A if S.ndim == 2 else S @ A)
