"""Solves eigenvalue problems of the tangent on the admissible motions, for vibrations and for buckling.

A motion is admissible if it violates no condition and no wheel slips, so no choice of independent coordinates is
needed.  Forces without a potential, such as follower forces, make the stiffness unsymmetric.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.linalg import eig, eigh
from scipy.sparse import block_array, block_diag, coo_array, csc_array, csr_array, vstack
from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigs, eigsh, splu

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.base.null_space import null_space
from flexel.statics.equilibrium import Equations, Rest

_eigsh: Any = eigsh
_eigs: Any = eigs
_eig: Any = eig
MAX_DENSE_SIZE = 400  # free coordinates up to which all modes are computed at once, with dense matrices
MASSLESS_TOLERANCE = 1e-13  # mass, relative to the largest, that counts as zero
# Coupling of two modes by the skew part, relative to their stiffnesses, that is taken into account.
SKEW_TOLERANCE = 1e-7
ROUNDING = (
    1e-14  # the same relative to the largest stiffness: rounding errors of the sums in which it cancels
)
FAR_BELOW = (
    1e-6  # distance of the first shift below zero, over the largest stiffness: a free motion has w = 0
)
CLOSE_ENOUGH = 1e-11  # relative error of eigenvalues of large models; they are refined afterwards
SAME = 1e-6  # difference of their distances from the shift at which eigenvalues may be copies of one
LEAST_ROOM = 40  # vectors of Lanczos's method
BESIDE = 0.1  # distance of the shift below zero and the lowest eigenvalue, over the largest that is wanted
NEARER, NEAREST = 3, 1e-3  # how often the shift moves there, and by how much at most: a free motion has w = 0
# Imaginary part of an eigenvalue, relative to its magnitude, from which it is flutter, which grows by more than the
# damping of any structure takes, 0.1 % of critical.
FLUTTER_SHARE = 2e-3


def mass_matrix(problem: Rest) -> Any:
    """Return the mass matrix (nf, nf) of the coordinates, sparse, at the last evaluation."""
    problem.work.tangent(0.0, 0.0, 1.0, phi=False)
    return problem.work.tables.T.pattern.matrix(problem.free)


def lowest_squares(problem: Rest, q: Equations, M: Any, count: int) -> tuple[Array, Array]:
    """Compute the squares of the lowest frequencies, ascending, and vectors (nf, …); complex where it flutters."""
    heaviest = max(float(np.abs(M.diagonal()).max(initial=0.0)), 1e-300)
    return Pencil.of(problem, q, M).lowest(count, -FAR_BELOW * q.stiffness / heaviest)


@dataclass(frozen=True)
class Pencil:
    """K v = w M v on the admissible motions.

    Attributes
    ----------
    K, M : sparse array (nf, nf)
    C : sparse array (nm, nf)
        Conditions on the motions.
    name : callable
        Names of the coordinates that take part in a motion (nf,), in quotes.
    """

    K: Any
    M: Any
    C: Any
    name: Callable[[Array], str]

    @classmethod
    def of(cls, problem: Rest, q: Equations, M: Any) -> Pencil:
        """Set up the problem with the stiffness of the evaluated equations, and another matrix."""
        nf, A = problem.structure.nf, q.matrix.sparse.tocsr()
        return cls(A[:nf, :nf], M, A[:nf, nf:].T.tocsr(), q.matrix.names_of)

    def beside(self, motions: Array) -> Pencil:
        """Return the problem on what is orthogonal to some motions (nf, r)."""
        return replace(self, C=csr_array(vstack([self.C, csr_array(motions.T)]))) if motions.size else self

    @property
    def size(self) -> int:
        """Free coordinates."""
        return int(self.K.shape[0])

    def lowest(self, count: int, shift: float) -> tuple[Array, Array]:
        """Compute the lowest eigenvalues (…) and vectors (nf, …), ascending; complex if the stiffness is not symmetric.

        Parameters
        ----------
        shift : float
            Below all eigenvalues, but near 0: for large models, of which `count` modes are found.
        """
        if self.size <= MAX_DENSE_SIZE:
            Z = null_space(self.C.toarray(), self.size)[0]
            values, vectors = self._dense(Z.T @ self.K @ Z, Z.T @ (self.M @ Z), Z)
            return values, Z @ vectors
        count = min(count, self.size - 2)
        values, vectors = self._symmetric(count, shift)
        # from a shift that is far away, eigenvalues are hard to tell from one another, and one may be missed
        for _ in range(NEARER):
            wanted = min(0.0, float(values.min())) - BESIDE * float(np.abs(values).max())
            if wanted <= shift:
                break
            shift = min(wanted, NEAREST * shift)
            values, vectors = self._symmetric(count, shift)
        if self.skew(values, vectors):
            values, vectors = self._coupled(count, shift)
        order = np.argsort(values.real)
        return values[order], vectors[: self.size, order]

    def skew(self, values: Array, vectors: Array) -> bool:
        """Whether the skew part of K couples these modes (nf or more, …) of its symmetric part.

        A coupling may be a rounding error: all of it, between motions without stiffness.
        """
        V = vectors[: self.size]
        coupling = V.T @ ((self.K - self.K.T) @ V) / 2
        stiffness = np.abs(values * self._mass(V))
        pairs = np.sqrt(np.outer(stiffness, stiffness))
        sums = np.abs(V).T @ (abs(self.K) @ np.abs(V))
        return bool(np.any(np.abs(coupling) > SKEW_TOLERANCE * pairs + ROUNDING * sums))

    def _mass(self, V: Array) -> Array:
        return np.asarray(np.einsum("ij,ij->j", V, self.M @ V))

    def _dense(self, K: Array, M: Array, Z: Array) -> tuple[Array, Array]:
        """Compute the finite eigenvalues, ascending; massless directions are condensed statically.

        A direction without mass and stiffness is an error, which names its coordinates.
        """
        M = (M + M.T) / 2
        m, U = np.linalg.eigh(M)
        massless = m < MASSLESS_TOLERANCE * max(float(m.max(initial=0.0)), 1e-300)
        A, B = U[:, ~massless], U[:, massless]
        if not A.size:  # no moving part has mass, so there is no vibration
            return np.zeros(0), np.zeros((m.size, 0))
        symmetric = (K + K.T) / 2
        T = A + B @ self._condensed(symmetric, A, B, Z)
        values, V = eigh(T.T @ symmetric @ T, T.T @ M @ T if not B.size else np.diag(m[~massless]))
        if not self.skew(values, Z @ T @ V):
            return np.asarray(values), np.asarray(T @ V)
        T = A + B @ self._condensed(K, A, B, Z)
        root = 1 / np.sqrt(m[~massless])
        values, V = _eig(root[:, None] * (A.T @ K @ T) * root)
        order = np.argsort(values.real)
        return values[order], T @ (root[:, None] * V[:, order])

    def _condensed(self, K: Array, A: Array, B: Array, Z: Array) -> Array:
        """Return how the massless directions B follow those with mass, A."""
        inner = B.T @ K @ B
        try:
            return np.asarray(-np.linalg.solve(inner, B.T @ K @ A))
        except np.linalg.LinAlgError as error:
            free = Z @ (B @ np.linalg.eigh((inner + inner.T) / 2)[1][:, 0])
            raise DynamicsError(
                f"vibrations: a motion of {self.name(free)} has neither mass nor stiffness; give it one of them, or "
                "fix it"
            ) from error

    def _coupled(self, count: int, shift: float) -> tuple[Array, Array]:
        """Compute the eigenvalues nearest to a shift, and vectors (nf + nm, …), by Arnoldi's method."""
        A, B, start = self.bordered(self.K)
        solve = splu(csc_array(A - shift * B)).solve
        return _nearest(_eigs, A, B, solve, start, count, shift)

    def _symmetric(self, count: int, shift: float) -> tuple[Array, Array]:
        """Compute the same for the symmetric part of K, with all copies of repeated eigenvalues.

        Lanczos's method finds one vector of several with the same eigenvalue, and others by rounding only.  So it is
        used again without what it has found, until nothing new is as close to the shift.
        """
        A, B, start = self.bordered((self.K + self.K.T) / 2)
        solve = splu(csc_array(A - shift * B)).solve
        values, vectors = _nearest(_eigsh, A, B, solve, start, count, shift)
        while values.size < self.size - 2:
            others = _nearest(_eigsh, A, B, solve, start, 1, shift, vectors)
            if abs(others[0][0] - shift) >= (1 - SAME) * np.sort(np.abs(values - shift))[count - 1]:
                break
            values, vectors = np.concatenate([values, others[0]]), np.hstack([vectors, others[1]])
        nearest = np.argsort(np.abs(values - shift))[:count]
        return values[nearest], vectors[:, nearest]

    def bordered(self, K: Any) -> tuple[Any, Any, Array]:
        """Return the constrained stiffness, a matrix of the same size that contains M, and a starting vector."""
        border = self.C.shape[0]
        A = block_array([[K, self.C.T], [self.C, coo_array((border, border))]], format="csc")
        B = block_diag([self.M, coo_array((border, border))], format="csc")
        return A, B, np.random.default_rng(0).standard_normal(A.shape[0])


def _nearest(
    solver: Any,
    A: Any,
    B: Any,
    solve: Callable[[Array], Array],
    start: Array,
    count: int,
    shift: float,
    known: Array | None = None,
) -> tuple[Array, Array]:
    """Compute the eigenvalues of A v = w B v nearest to a shift, and vectors, beside known vectors (n, …).

    The vectors have a B-norm of one.

    Parameters
    ----------
    solve : callable
        Solves with A - shift B.
    """
    none = np.zeros((A.shape[0], 0)) if known is None else known
    pulled = (B @ none).T

    def inverse(b: Array) -> Array:
        x = solve(b)
        return np.asarray(x - none @ (pulled @ x))

    operator = LinearOperator(A.shape, matvec=inverse, dtype=np.float64)
    options = {"M": B, "sigma": shift, "OPinv": operator, "v0": inverse(B @ start), "tol": CLOSE_ENOUGH}
    room = min(max(2 * count + 1, LEAST_ROOM), A.shape[0] - 1)
    try:
        values, vectors = solver(A, count, ncv=room, **options)
    except ArpackNoConvergence as error:
        raise DynamicsError(
            f"{error.eigenvalues.size} of {count} eigenvalues of a large model were found: its stiffnesses differ too "
            "much, or many of its motions are alike; ask for another number of modes, or use fewer elements"
        ) from None
    return values, vectors
