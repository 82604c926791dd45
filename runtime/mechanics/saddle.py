"""The matrix of the balance of forces, [K C'; D 0]: its sparse pattern, computed once, and its factors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import DynamicsError
from flexel.engine.local import Local
from flexel.engine.solvers import Factors, Pattern
from flexel.mechanics.diagnose import largest, null_space, quoted
from flexel.structure.structure import Structure

LARGEST_NULL_SPACE = 1500  # most unknowns for which the free motion of a singular matrix is identified


class SaddlePattern:
    """The pattern of [K C'; D 0]: K of the elements, C rows of J with multipliers, D rows of J that are held."""

    def __init__(self, local: Local, force_rows: Index, hold_rows: Index, kind: str | None = None) -> None:
        structure = local.structure
        n, nf = structure.n, structure.nf
        self._local = local
        size = nf + force_rows.size
        self._c, c_rows, c_columns = self._rows(force_rows)
        self._d, d_rows, d_columns = self._rows(hold_rows)
        outside = n + force_rows.size + nf  # any number beyond the matrix: fixed coordinates drop out
        place = np.where(np.arange(n) < nf, np.arange(n), outside)
        cross = (local.columns_J[z] for z in (local.laws.left, local.laws.right))
        rows = [place[local.rows_K], *(place[z] for z in cross)]
        left, right = rows[1], rows[2]
        all_rows = np.concatenate([rows[0], left, place[c_columns], nf + d_rows])
        all_columns = np.concatenate([place[local.columns_K], right, nf + c_rows, place[d_columns]])
        self.pattern = Pattern(all_rows, all_columns, size, kind)
        ends = np.cumsum([local.rows_K.size, left.size, c_rows.size, d_rows.size])
        self._entries = np.zeros(ends[-1])
        self._parts = np.split(self._entries, ends[:-1])

    def _rows(self, quantities: Index) -> tuple[Index, Index, Index]:
        """Entries of [J, 1] that make up rows of J, their row numbers and their coordinates."""
        local = self._local
        first, ones = local.structure.m + local.structure.k, local.columns_J.size
        entries, rows, columns = [], [], []
        for row, i in enumerate(quantities):
            if i >= first:
                entries.append(np.array([ones]))
                columns.append(np.array([i - first]))
            else:
                line = local.line_of[i]
                entries.append(np.arange(local.starts_J[line], local.starts_J[line + 1]))
                columns.append(local.columns_J[entries[-1]])
            rows.append(np.full(entries[-1].size, row))
        none = [np.zeros(0, dtype=np.intp)]
        found = tuple(np.concatenate(z or none).astype(np.intp) for z in (entries, rows, columns))
        return found[0], found[1], found[2]

    def assemble(self, K: Array, cross: Array, J: Array, held: Array, scaling: float = 1.0) -> Array:
        """The matrix in its storage.

        Parameters
        ----------
        K, cross : ndarray
            Entries of the elements (flat, see `Local`) and those across elements.
        J, held : ndarray
            Flat J for the columns of the multipliers and for the rows that are held.
        scaling : float
            Factor on K and the entries across elements.
        """
        own, across, left, lower = self._parts
        np.multiply(K, scaling, out=own)
        np.multiply(cross, scaling, out=across)
        left[:] = _with_one(J, self._c)
        lower[:] = _with_one(held, self._d)
        return self.pattern.assemble(self._entries)

    @cached_property
    def mass(self) -> Array:
        """The constant part of the mass matrix, in the storage."""
        local = self._local
        entries = np.zeros(self._entries.size)
        entries[local.size_M : local.rows_K.size] = local.masses0
        return self.pattern.assemble(entries)


def _with_one(J: Array, entries: Index) -> Array:
    """Entries of the flat J, with a 1 appended."""
    return np.append(J, 1.0)[entries] if entries.size else np.zeros(0)


@dataclass
class Matrix:
    """A saddle-point matrix, factorized when first needed."""

    structure: Structure
    pattern: Pattern
    stored: Array

    @cached_property
    def size(self) -> float:
        """Largest entry."""
        return float(np.abs(self.stored).max(initial=0.0))

    @cached_property
    def factors(self) -> Factors:
        """LU factors."""
        return self.pattern.factorize(self.stored)

    @property
    def sparse(self) -> Any:
        """The matrix as a scipy.sparse array."""
        return self.pattern.matrix(self.stored)

    def solve(self, rhs: Array) -> Array:
        """Solution for one or several right-hand sides; names the unresisted motion if the matrix is singular.

        Raises
        ------
        DynamicsError
        """
        if self.factors.regular:
            x = self.factors.solve(rhs)
            return x + self.factors.solve(
                rhs - self.sparse @ x
            )  # recovers the accuracy lost by borders and bands
        nf, first, names = self.structure.nf, self.structure.m + self.structure.k, ["unknown"]
        if self.pattern.size <= LARGEST_NULL_SPACE:
            right, _ = null_space(self.sparse.toarray(), self.pattern.size)
            names = largest(self.structure, np.arange(nf) + first, right[:nf, 0]) if right.shape[1] else []
        raise DynamicsError(
            f"the stiffness is singular: nothing resists a motion of {quoted(names)}; support it, or give it "
            "a stiffness or a mass"
        )
