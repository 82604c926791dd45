"""The matrix of the balance of forces, [K C'; D 0]: its sparse pattern, computed once, and its factors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, Index
from flexel.base.errors import DynamicsError
from flexel.base.shown import quoted
from flexel.engine.elimination import Eliminated, Elimination, LargeFactors
from flexel.engine.solvers import least, null_vector
from flexel.engine.workspace import Workspace
from flexel.mechanics.diagnose import largest
from flexel.model.structure import Structure

MOST_DENSE = 500  # unknowns of a matrix whose singular values are computed
CONSISTENT = 1e-10  # singular values, relative to the largest, that a least-squares solution treats as zero


class SaddlePattern:
    """The pattern of [K C'; D 0]: K the tangent, C rows of J with multipliers, D rows of J that are held.

    Parameters
    ----------
    work : Workspace
        Gives the layout of the entries, the same in all workspaces of a model.
    force_rows, hold_rows : ndarray of int
        Quantities with multipliers, and those that are held.
    rolling : bool
        Whether held slips are rows of H, as in an implicit step, instead of J.
    used : ndarray of bool, optional
        Entries of the tangent that can differ from zero; all of its pattern by default.

    Attributes
    ----------
    elimination : Elimination
    source : ndarray of int (stored,)
        Positions of the stored entries in the values of a workspace.
    """

    def __init__(
        self,
        work: Workspace,
        force_rows: Index,
        hold_rows: Index,
        rolling: bool = False,
        used: NDArray[np.bool_] | None = None,
    ) -> None:
        tables, first = work.tables, work.first
        self.structure = tables.structure
        nf, m, slips = self.structure.nf, self.structure.m, self.structure.m + self.structure.k
        self._J = tables.J
        at_C, row_C, column_C = self._rows(force_rows)
        at_D, row_D, column_D = self._rows(hold_rows)
        source_D = at_D + first["J"]
        if rolling:
            slip = (hold_rows[row_D] >= m) & (hold_rows[row_D] < slips)
            source_D = np.where(slip, at_D - tables.J.start[m] + first["H"], source_D)
        T = tables.T.pattern
        at_T = np.arange(T.size) if used is None else np.flatnonzero(used)
        rows = np.concatenate([T.row[at_T], column_C, nf + row_D])
        columns = np.concatenate([T.column[at_T], nf + row_C, column_D])
        self.elimination = Elimination(rows, columns, nf + force_rows.size)
        source = np.concatenate([at_T + first["T"], at_C + first["J"], source_D])
        self.source: Index = source[np.lexsort((rows, columns))]

    def _rows(self, quantities: Index) -> tuple[Index, Index, Index]:
        """Return the entries of J over the free coordinates in some of its rows, with the row and column numbers."""
        entries, rows = self._J.rows_of(quantities, self.structure.nf)
        return entries, rows, self._J.column[entries]

    def matrix(self, work: Workspace) -> Matrix:
        """Return the matrix for the values that a workspace holds."""
        return Matrix(self.structure, self.elimination, work.values[self.source])


@dataclass
class Matrix:
    """A saddle-point matrix, factorized when first needed."""

    structure: Structure
    pattern: Elimination
    stored: Array

    @cached_property
    def size(self) -> float:
        """Largest entry."""
        return float(np.abs(self.stored).max(initial=0.0))

    @cached_property
    def factors(self) -> Eliminated | LargeFactors:
        """LU factors."""
        return self.pattern.factorized(self.stored)

    @property
    def sparse(self) -> Any:
        """The matrix as a scipy.sparse array."""
        return self.pattern.matrix(self.stored)

    def least_solution(self, rhs: Array) -> tuple[Array, Array]:
        """Return the smallest least-squares solution in scaled unknowns, and the remaining right-hand side.

        Motions without resistance, up to rounding errors, are left out.
        """
        A, scale = self._scaled()
        x = scale * least(A, scale * rhs, CONSISTENT)
        return x, rhs - self.sparse @ x

    def solve(self, rhs: Array) -> Array:
        """Solve for one or several right-hand sides; name the unresisted motion if the matrix is singular.

        Raises
        ------
        DynamicsError
        """
        if self.factors.regular:
            x = self.factors.solve(rhs)
            return np.asarray(x + self.factors.solve(rhs - self.sparse @ x))  # for accuracy of stiff models
        motion = self.free_motion()
        names = "unknown coordinates" if motion is None else self.names_of(motion)
        raise DynamicsError(
            f"the stiffness is singular: nothing resists a motion of {names}; support it, or give it "
            "a stiffness or a mass"
        )

    def free_motion(self) -> Array | None:
        """Return a motion (nf,) of the coordinates that a singular matrix maps to zero; None if there is none."""
        found = null_vector(self.sparse)
        if found is not None:
            motion = found[: self.structure.nf]
            return motion if np.any(motion) else None  # otherwise undetermined multipliers
        if self.factors.regular or len(self.sparse.indptr) > MOST_DENSE:
            return None
        # where wheels roll, forces act along other motions than those that are free, which iterations do not find
        motions = self.free_motions()
        return motions[:, 0] if motions.size else None

    def free_motions(self) -> Array:
        """Return orthonormal motions (nf, r) of the coordinates that the matrix maps to zero, up to rounding errors."""
        A, scale = self._scaled()
        _, sizes, rows = np.linalg.svd(A)
        motions = (scale * rows[sizes <= CONSISTENT * (sizes.max(initial=0.0) or 1.0)])[
            :, : self.structure.nf
        ].T
        basis, lengths, _ = np.linalg.svd(motions, full_matrices=False)
        return np.asarray(basis[:, lengths > CONSISTENT * lengths.max(initial=0.0)])

    def _scaled(self) -> tuple[Array, Array]:
        """Return the matrix with scaled rows and columns, and their scale."""
        A = self.sparse.toarray()
        scale = 1 / np.sqrt(np.maximum(np.abs(A).max(axis=1), 1e-12 * (self.size or 1.0)))
        return scale[:, None] * A * scale, scale

    def names_of(self, motion: Array) -> str:
        """Name the coordinates that take part in a motion (nf,), in quotes."""
        first = self.structure.m + self.structure.k
        return quoted(largest(self.structure, np.arange(motion.size) + first, motion))
