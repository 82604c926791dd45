"""Refines frequencies to the last digits if stiffnesses differ greatly, as for a leaf spring in bending and tension.

In K = G + L' S J, the entries of soft motions are sums in which the contributions of stiff motions cancel.  Here the
stresses s = S J v remain unknowns, like the multipliers m of the constraints, so nothing cancels:

    [G - σ M  C'  L'] [v]   [M v0]
    [C        0   0 ] [m] = [0   ]
    [S J      0   -1] [s]   [0   ]

Inverse iteration with this matrix gives a vector v, and with its transpose a vector u.  The eigenvalue is the quotient
(u' G v + (L u)' S (J v)) / (u' M v), whose error is of second order in the errors of the vectors.
Source: Parlett (1980), "The symmetric eigenvalue problem", chapter 4.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.sparse import block_array, coo_array, csc_array, diags_array
from scipy.sparse.linalg import splu as untyped_splu

from flexel.base.arrays import Array
from flexel.statics.equilibrium import Equations, Rest

splu: Any = untyped_splu
SHIFT_DISTANCE = 1e-4  # distance of the shift from an eigenvalue, relative to it
ITERATIONS = 2  # steps of inverse iteration
CORRECTION = 1e-9  # largest change of a coordinate, in natural scales, that removes only rounding errors
SELF_STRESSED = 1e-14  # of stiffnesses under stresses, whose parts may cancel
MAX_CHANGE = 1e-3  # largest relative change of an eigenvalue that corrects its last digits only


@dataclass(frozen=True)
class StiffnessParts:
    """The stiffness K = G + L' S J in parts without cancellation.

    Attributes
    ----------
    G : sparse array (nf, nf)
        Stiffness that is not of laws: of stresses and loads.
    C : sparse array (nm, nf)
        Conditions with multipliers.
    L, J : sparse array (nl, nf), sparse array (nj, nf)
        Quantities on which laws act, and those on which they depend: the same but for laws of controllers.
    S : sparse array (nl, nj)
        Derivatives of these laws.
    M : sparse array (nf, nf)
    """

    G: Any
    C: Any
    L: Any
    J: Any
    S: Any
    M: Any

    def matrix(self, shift: float) -> csc_array:
        """Assemble the matrix above, with the rows of its laws divided by their largest derivatives."""
        scale = diags_array(1 / abs(self.S).max(axis=1).toarray().ravel())
        rows = [
            [self.G - shift * self.M, self.C.T, self.L.T],
            [self.C, None, None],
            [scale @ self.S @ self.J, None, -scale],
        ]
        return csc_array(block_array(rows))

    def quotient(self, left: Array, right: Array) -> float:
        """Return the two-sided Rayleigh quotient of two admissible motions (nf,)."""
        stiffness = left @ (self.G @ right) + (self.L @ left) @ (self.S @ (self.J @ right))
        return float(stiffness / (left @ (self.M @ right)))

    def refined(self, value: float, vector: Array) -> tuple[float, Array]:
        """Refine an eigenvalue and its vector (nf,) from approximations; return these if nothing can be gained.

        Without laws, nothing is stiff.  The eigenvalue of a motion without stiffness, a rounding error, becomes zero.
        """
        if not self.S.nnz:
            return (0.0 if abs(value) <= self._rounding(vector) else value), vector
        A = self.matrix(value * (1 - SHIFT_DISTANCE))
        factors = _factors(A)
        if factors is None:
            return value, vector
        left = right = vector
        for _ in range(ITERATIONS):
            right = self._turned(A, factors, self.M @ right, "N")
            left = self._turned(A.T, factors, self.M.T @ left, "T")
        found = self.quotient(left, right)
        if abs(found - value) <= MAX_CHANGE * abs(value):
            return found, right
        free = abs(found) <= max(MAX_CHANGE * abs(value), self._rounding(right))
        return 0.0 if free else value, vector

    def _rounding(self, vector: Array) -> float:
        """Return the rounding error of the eigenvalue of a motion (nf,), whose stiffness under stresses may cancel."""
        size = np.abs(vector)
        return float(SELF_STRESSED * (size @ (abs(self.G) @ size)) / (vector @ (self.M @ vector)))

    def correction(self, residual: Array) -> Array | None:
        """Solve for the change of all unknowns that removes a residual (nf + nm,); return None if undetermined."""
        A = self.matrix(0.0)
        factors = _factors(A)
        rhs = np.zeros(A.shape[0])
        rhs[: residual.size] = -residual
        return None if factors is None else _solved(A, factors, rhs, "N")

    @staticmethod
    def _turned(A: Any, factors: Any, forces: Array, way: str) -> Array:
        """Return the motion (nf,) under forces (nf,), of size 1."""
        rhs = np.zeros(A.shape[0])
        rhs[: forces.size] = forces
        x = _solved(A, factors, rhs, way)[: forces.size]
        return np.asarray(x / np.linalg.norm(x))


def _factors(A: csc_array) -> Any:
    """Factorize a matrix; return None if it is singular."""
    try:
        return splu(A)
    except RuntimeError:  # the only sign of a singular matrix
        return None


def _solved(A: Any, factors: Any, rhs: Array, way: str) -> Array:
    """Solve, with one correction."""
    x = factors.solve(rhs, way)
    return np.asarray(x + factors.solve(rhs - A @ x, way))


def parts(problem: Rest, q: Equations, M: Any) -> StiffnessParts:
    """Return the parts of the stiffness at the last evaluation, whose laws are lost from the workspace.

    The stresses of laws are those of equilibrium: rounded coordinates would strain stiff elements.

    Parameters
    ----------
    M : sparse array (nf, nf)
    """
    work, first, nf = problem.work, problem.first, problem.structure.nf
    codes = work.tables.law.codes
    slopes = work.S[: codes.size].copy()
    codes, slopes = codes[slopes != 0], slopes[slopes != 0]
    work.S[:] = work.S_rate[:] = 0.0
    acting, row = np.unique(codes // max(first, 1), return_inverse=True)
    seen, column = np.unique(codes % max(first, 1), return_inverse=True)
    S = coo_array((slopes, (row, column)), shape=(acting.size, seen.size)).tocsr()
    J = work.tables.J.matrix(work.J)[:, :nf]

    def by_stress() -> Any:
        work.tangent(1.0, 0.0, 0.0, phi=False)
        return work.tables.T.pattern.matrix(problem.free)

    found = StiffnessParts(by_stress(), J[problem.force_rows], J[acting], J[seen], S, M)
    more = found.correction(q.residual) if S.nnz else None
    if more is None or problem.extent(more) > CORRECTION:
        return found
    work.stress[acting] += more[nf + problem.force_rows.size :]
    inner = problem.force_rows < first
    work.stress[problem.force_rows[inner]] += more[nf : nf + problem.force_rows.size][inner]
    return replace(found, G=by_stress())
