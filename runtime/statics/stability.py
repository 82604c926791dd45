"""Buckling and free vibrations about a state of rest.

Both are eigenvalue problems of the tangent r_x on the admissible motions, so no choice
of independent coordinates is needed.  Source: Besseling (1974) for buckling with generalized deformations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import block_diag, coo_array, csc_array
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from flexel.base.arguments import numbers, whole
from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, ModelError
from flexel.base.shown import Listing
from flexel.mechanics.core import Core
from flexel.mechanics.diagnose import null_space
from flexel.statics.equilibrium import Equations, Rest
from flexel.structure.state import State

_eigsh: Any = eigsh
SMALL = 400  # free coordinates up to which all modes are found at once, with dense matrices


@dataclass(frozen=True)
class BucklingMode:
    """A buckling mode: the load-increment multiplier at which equilibrium bifurcates, and the shape.

    Attributes
    ----------
    multiplier : float
    shape : dict of str to float
        Change of each coordinate, the largest scaled to 1.
    """

    multiplier: float
    shape: dict[str, float]

    HEAD: ClassVar[tuple[str, ...]] = ("multiplier", "largest changes")

    def row(self) -> tuple[str, ...]:
        """The line in a table of modes."""
        return f"{self.multiplier:.6g}", largest(self.shape)

    def __repr__(self) -> str:
        return f"BucklingMode(multiplier {self.multiplier:.6g}: {largest(self.shape)})"


def buckling(system: Core, state: State, increment: Mapping[str, float], count: int) -> Listing[BucklingMode]:
    """Buckling multipliers of a load increment at a preloaded state; see `System.buckling`.

    Parameters
    ----------
    state : State
        A state of rest, with its preload.
    increment : mapping of name to generalized force
        The loads that are multiplied.
    count : int
        Number of modes, at most.

    Raises
    ------
    ModelError
        If the increment is zero or names an unknown or fixed quantity.
    DynamicsError
        If the state is unstable already.
    """
    problem = Rest(system, state)
    s = problem.structure
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    load = np.zeros(len(s.names))
    for name, value in numbers(increment, "buckling", "load").items():
        i = s.find(name, "buckling")
        if i >= s.m + s.k + s.nf:
            raise ModelError(f"buckling: the load acts on '{name}', which is fixed; name another quantity")
        load[i] += value
    count = whole(count, "buckling", "count")
    if not np.any(load):
        raise ModelError("buckling: the load increment is zero; name at least one load, {'tip.z': -1.0}")
    K1 = _by_load(problem, q, load)
    try:
        w, V = _largest(problem, q, K1, count)
    except np.linalg.LinAlgError as error:
        raise DynamicsError(
            "buckling: the stiffness at this state is not positive definite: it has already buckled, or a motion is "
            "not supported; start from an earlier state of the path"
        ) from error
    modes = [(-1.0 / wi, V[:, i]) for i, wi in enumerate(w) if abs(wi) > 1e-12 * np.abs(w).max(initial=0.0)]
    modes.sort(key=lambda z: (abs(z[0]), -z[0]))
    return Listing(BucklingMode(float(z), _shape(system, v)) for z, v in modes[:count])


def _by_load(problem: Rest, q: Equations, load: Array) -> Any:
    """Derivative (nf, nf) of the stiffness along the equilibria under growing loads, at the last evaluation.

    Parameters
    ----------
    load : ndarray (m + k + n,)
        Generalized forces on the quantities.
    """
    s, work, first = problem.structure, problem.work, problem.first
    nodal, change = load[first:] + work.pull(load[:first]), np.zeros(s.n)
    solution = q.matrix.solve(np.concatenate([nodal[: s.nf], np.zeros(problem.hold_rows.size)]))
    change[: s.nf] = solution[: s.nf]
    left, right = np.divmod(work.tables.law.codes, max(first, 1))
    by_laws = work.S[: left.size] * work.push(change)[right]
    stress = np.bincount(left, by_laws, minlength=first) - load[:first]
    inner = problem.force_rows < first
    np.add.at(stress, problem.force_rows[inner], solution[s.nf :][inner])
    work.S[:] = work.S_rate[:] = 0.0  # the rest is proportional to the stresses, except for body forces
    under, free = (_tangent(problem, z) for z in (stress, np.zeros(first)))
    return work.tables.T.pattern.matrix(under - free)


def _tangent(problem: Rest, stress: Array) -> Array:
    """Entries of the tangent at given stresses (m + k,)."""
    work = problem.work
    work.stress[:] = stress
    work.tangent(1.0, 0.0, 0.0, phi=False)
    return problem.free.copy()


@dataclass(frozen=True)
class Vibration:
    """An undamped free vibration about equilibrium.

    Attributes
    ----------
    omega : float
        Angular frequency [rad/s].  A negative square (unstable equilibrium) is given as a
        negative frequency -|ω|.
    shape : dict of str to float
        Change of each coordinate, the largest scaled to 1.
    """

    omega: float
    shape: dict[str, float]

    HEAD: ClassVar[tuple[str, ...]] = ("frequency [rad/s]", "[Hz]", "largest changes")

    def row(self) -> tuple[str, ...]:
        """The line in a table of vibrations."""
        return f"{self.omega:.6g}", f"{self.hertz:.6g}", largest(self.shape)

    def __repr__(self) -> str:
        return f"Vibration({self.omega:.6g} rad/s, {self.hertz:.6g} Hz: {largest(self.shape)})"

    @property
    def hertz(self) -> float:
        """Frequency [Hz], negative, like `omega`, if the equilibrium is unstable."""
        return self.omega / (2 * np.pi)


def vibrations(system: Core, state: State, count: int) -> Listing[Vibration]:
    """Lowest natural frequencies and modes about a state of rest; see `System.vibrations`."""
    problem = Rest(system, state)
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    count = whole(count, "vibrations", "count")
    problem.work.tangent(0.0, 0.0, 1.0, phi=False)
    M = problem.work.tables.T.pattern.matrix(problem.free)
    if not np.any(M.diagonal()):
        return Listing()
    w2, V = _lowest(problem, q, M, count)
    found = [(np.sign(z) * np.sqrt(abs(z)), V[:, i]) for i, z in enumerate(w2)]
    return Listing(Vibration(float(z), _shape(system, v)) for z, v in found[:count])


def _admitted(problem: Rest, q: Equations) -> tuple[Array, Array]:
    """Basis (nf, r) of the admissible motions, and the stiffness (r, r) on it."""
    nf = problem.structure.nf
    matrix = q.matrix.sparse.toarray()
    Z, _ = null_space(matrix[nf:, :nf], nf)
    K = Z.T @ matrix[:nf, :nf] @ Z
    return Z, (K + K.T) / 2


def _lowest(problem: Rest, q: Equations, M: Any, count: int) -> tuple[Array, Array]:
    """Eigenvalues of K v = w² M v, ascending, and admissible vectors (nf, …)."""
    nf = problem.structure.nf
    if nf <= SMALL:
        Z, K = _admitted(problem, q)
        M = Z.T @ (M @ Z)
        w2, V = _pencil(K, (M + M.T) / 2, lambda motion: q.matrix.names_of(Z @ motion))
        return w2, Z @ V
    A, B, start = _bordered(problem, q, M)
    shift = -1e-6 * q.stiffness / max(float(np.abs(M.diagonal()).max()), 1e-300)  # a free motion has w = 0
    inverse = LinearOperator(A.shape, matvec=splu(csc_array(A - shift * B)).solve, dtype=np.float64)
    v0 = inverse @ (B @ start)
    w2, V = _eigsh(A, min(count, nf - 2), M=B, sigma=shift, OPinv=inverse, v0=v0)
    order = np.argsort(w2)
    return w2[order], V[:nf, order]


def _largest(problem: Rest, q: Equations, G: Any, count: int) -> tuple[Array, Array]:
    """Eigenvalues of G v = w K v of largest magnitude, and admissible vectors (nf, …).

    Raises
    ------
    LinAlgError
        If K is not positive definite on these motions.
    """
    nf = problem.structure.nf
    if nf <= SMALL:
        Z, K = _admitted(problem, q)
        G = Z.T @ (G @ Z)
        w, V = eigh((G + G.T) / 2, K)
        return w, Z @ V
    A, B, start = _bordered(problem, q, G)
    inverse = LinearOperator(A.shape, matvec=q.matrix.solve, dtype=np.float64)
    w, V = _eigsh(B, min(count, nf - 2), M=A, Minv=inverse, which="LM", v0=inverse @ (B @ start))
    if np.any(np.einsum("ij,ij->j", V, A @ V) <= 0):
        raise np.linalg.LinAlgError("not positive definite")
    return w, V[:nf]


def _bordered(problem: Rest, q: Equations, M: Any) -> tuple[Any, Any, Array]:
    """The constrained tangent, a matrix of the same size that contains M, and a starting vector."""
    A = q.matrix.sparse
    border = A.shape[0] - problem.structure.nf
    B = block_diag([M, coo_array((border, border))], format="csc")
    return A, B, np.random.default_rng(0).standard_normal(A.shape[0])


def _pencil(K: Array, M: Array, names_of: Callable[[Array], str]) -> tuple[Array, Array]:
    """Finite eigenvalues of K v = w² M v, ascending; massless directions are condensed statically.

    A direction without mass and stiffness is an error, which names its coordinates.
    """
    m, U = np.linalg.eigh(M)
    if not np.any(m > 0):  # no moving part has mass, so nothing vibrates
        return np.zeros(0), np.zeros((m.size, 0))
    massless = m < 1e-13 * max(float(m[-1]), 1e-300)
    if not massless.any():
        w2, V = eigh(K, M)
        return np.asarray(w2), np.asarray(V)
    A, B = U[:, ~massless], U[:, massless]
    try:
        back = -np.linalg.solve(B.T @ K @ B, B.T @ K @ A)
    except np.linalg.LinAlgError as error:
        free = B @ np.linalg.eigh(B.T @ K @ B)[1][:, 0]
        raise DynamicsError(
            f"vibrations: a motion of {names_of(free)} has neither mass nor stiffness; give it one of them, or fix it"
        ) from error
    T = A + B @ back
    w2, V = eigh(T.T @ K @ T, np.diag(m[~massless]))
    return np.asarray(w2), np.asarray(T @ V)


def _shape(system: Core, dx: Array) -> dict[str, float]:
    s = system.structure
    first = s.m + s.k
    pivot = dx[int(np.argmax(np.abs(dx)))] if dx.size else 1.0
    return {s.names[first + i]: float(z / pivot) for i, z in enumerate(dx)}


def largest(shape: Mapping[str, float], count: int = 3) -> str:
    """The largest changes of a shape, by name."""
    order = sorted(shape, key=lambda name: -abs(shape[name]))[:count]
    return ", ".join(f"{name} {shape[name]:.3g}" for name in order if shape[name])
