"""Computes buckling loads and free vibrations about a state of rest.

Both are eigenvalue problems of the tangent r_x on the admissible motions, so no choice of independent coordinates is
needed.  Source: Besseling (1974) for buckling with generalized deformations.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from scipy.linalg import eig, eigh
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from flexel.base.arguments import numbers, whole
from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, ModelError
from flexel.base.null_space import null_space
from flexel.base.shown import Listing, prints
from flexel.model.state import State
from flexel.statics.eigenproblem import (
    FLUTTER_SHARE,
    MAX_DENSE_SIZE,
    SKEW_TOLERANCE,
    Pencil,
    lowest_squares,
    mass_matrix,
)
from flexel.statics.equilibrium import Equations, Rest
from flexel.statics.refining import parts
from flexel.statics.rest_check import check_balance, check_rest
from flexel.statics.search import free_motion
from flexel.system import CoreSystem

_eigsh: Any = eigsh
_eig: Any = eig
# Imaginary part of an eigenvalue, relative to its magnitude, that is not a rounding error.
COUPLED_TOLERANCE = 1e-6
ALONG_FREE = 1e-9  # share of a load that acts along a motion by rounding errors alone


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
        """Return its row in a table of modes."""
        return f"{self.multiplier:.6g}", largest(self.shape)

    @prints
    def __repr__(self) -> str:
        return f"BucklingMode(multiplier {self.multiplier:.6g}: {largest(self.shape)})"


def buckling(
    system: CoreSystem, state: State, increment: Mapping[str, float], count: int
) -> Listing[BucklingMode]:
    """Compute buckling multipliers of a load increment at a preloaded state; see `System.buckling`.

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
    check_balance("buckling", problem, q)
    free = _free_motions(q)
    K1 = _by_load(problem, q, load, free)
    if np.abs(K1 @ free).max(initial=0.0) > ALONG_FREE * abs(K1).max():
        raise DynamicsError(
            f"buckling: nothing resists a motion of {q.matrix.names_of(free[:, 0])}, and any load moves it; support it"
        )
    try:
        w, V = _largest(problem, q, K1, count, free)
    except np.linalg.LinAlgError as error:
        raise DynamicsError(
            "buckling: the stiffness at this state is not positive definite: it has already buckled, or a motion is "
            "not supported; start from an earlier state of the path"
        ) from error
    modes = [(-1.0 / wi, V[:, i]) for i, wi in enumerate(w) if abs(wi) > 1e-12 * np.abs(w).max(initial=0.0)]
    modes.sort(key=lambda mode: (abs(mode[0]), -mode[0]))
    return Listing(BucklingMode(float(multiplier), _shape(system, v)) for multiplier, v in modes[:count])


def _free_motions(q: Equations) -> Array:
    """Return motions (nf, r) that nothing resists, such as the spin of a column between ball joints."""
    return np.zeros((q.matrix.structure.nf, 0)) if free_motion(q) is None else q.matrix.free_motions()


def _by_load(problem: Rest, q: Equations, load: Array, free: Array) -> Any:
    """Return the derivative (nf, nf) of the stiffness along the equilibria under growing loads, at the last evaluation.

    Parameters
    ----------
    load : ndarray (m + k + n,)
        Generalized forces on the quantities.
    free : ndarray (nf, r)
        Motions that nothing resists.

    Raises
    ------
    DynamicsError
        If the load acts along such a motion.
    """
    s, work, first = problem.structure, problem.work, problem.first
    nodal, change = load[first:] + work.vjp(load[:first]), np.zeros(s.n)
    forces = np.concatenate([nodal[: s.nf], np.zeros(problem.hold_rows.size)])
    along = free[:, np.abs(free.T @ nodal[: s.nf]) > ALONG_FREE * np.abs(nodal).max()]
    if along.size:
        raise DynamicsError(
            f"buckling: the load acts where nothing resists a motion of {q.matrix.names_of(along[:, 0])}; support it"
        )
    solution = q.matrix.least_solution(forces)[0] if free.size else q.matrix.solve(forces)
    change[: s.nf] = solution[: s.nf]
    left, right = np.divmod(work.tables.law.codes, max(first, 1))
    by_laws = work.S[: left.size] * work.jvp(change)[right]
    stress = np.bincount(left, by_laws, minlength=first) - load[:first]
    inner = problem.force_rows < first
    np.add.at(stress, problem.force_rows[inner], solution[s.nf :][inner])
    work.S[:] = work.S_rate[:] = 0.0  # the rest is proportional to the stresses, except for body forces
    under, free = (_tangent(problem, each) for each in (stress, np.zeros(first)))
    return work.tables.T.pattern.matrix(under - free)


def _tangent(problem: Rest, stress: Array) -> Array:
    """Return the entries of the tangent at given stresses (m + k,)."""
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
        """Return its row in a table of vibrations."""
        return f"{self.omega:.6g}", f"{self.hertz:.6g}", largest(self.shape)

    @prints
    def __repr__(self) -> str:
        return f"Vibration({self.omega:.6g} rad/s, {self.hertz:.6g} Hz: {largest(self.shape)})"

    @property
    def hertz(self) -> float:
        """Frequency [Hz], negative, like `omega`, if the equilibrium is unstable."""
        return self.omega / (2 * np.pi)


def vibrations(system: CoreSystem, state: State, count: int) -> Listing[Vibration]:
    """Compute the lowest natural frequencies and modes about a state of rest; see `System.vibrations`."""
    problem = Rest(system, state)
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    check_balance("vibrations", problem, q)
    count = whole(count, "vibrations", "count")
    M = mass_matrix(problem)
    if not np.any(M.diagonal()):
        return Listing()
    w2, V = _lowest(problem, q, M, count)
    omega = np.sign(w2) * np.sqrt(np.abs(w2))
    check_rest("vibrations", problem, state, omega)
    return Listing(Vibration(float(frequency), _shape(system, V[:, i])) for i, frequency in enumerate(omega))


def _lowest(problem: Rest, q: Equations, M: Any, count: int) -> tuple[Array, Array]:
    """Compute the lowest eigenvalues of K v = w² M v, ascending, to the last digits, and admissible vectors (nf, …).

    Raises
    ------
    DynamicsError
        If forces without a potential make it flutter: eigenvalues are complex.
    """
    w2, V = lowest_squares(problem, q, M, count)
    flutter = np.abs(w2.imag) > FLUTTER_SHARE * np.abs(w2)
    slight = np.abs(w2.imag) > COUPLED_TOLERANCE * np.abs(w2)
    if np.any(flutter):
        growth, omega = (abs(part) for part in (np.sqrt(w2[flutter][0]).imag, np.sqrt(w2[flutter][0]).real))
        raise DynamicsError(
            f"vibrations: the state flutters ({omega:.5g} rad/s, growing by {growth:.3g}/s) under forces that have no "
            "potential, such as follower forces, so it has no undamped vibrations; system.linearize(state).modes() are "
            "its modes"
        )
    whole = parts(problem, q, M)
    found = [
        (float(np.sqrt(w2[i]).real ** 2), V[:, i].real)
        if slight[i]
        else whole.refined(float(w2[i].real), V[:, i].real)
        for i in range(min(count, w2.size))
    ]
    found.sort(key=lambda pair: pair[0])
    return np.array([value for value, _ in found]), np.array([vector for _, vector in found]).T


def _largest(problem: Rest, q: Equations, G: Any, count: int, free: Array) -> tuple[Array, Array]:
    """Compute the eigenvalues of G v = w K v of largest magnitude, and admissible vectors (nf, …).

    Motions `free` (nf, r), which nothing resists, are left out.

    Raises
    ------
    LinAlgError
        If K is not positive definite on these motions.
    DynamicsError
        If K or G is not symmetric.
    """
    pencil = Pencil.of(problem, q, G).beside(free)
    K, nf = pencil.K, pencil.size
    if nf <= MAX_DENSE_SIZE:
        Z = null_space(pencil.C.toarray(), nf)[0]
        stiffness, load = Z.T @ K @ Z, Z.T @ (G @ Z)
        w, V = eigh((load + load.T) / 2, (stiffness + stiffness.T) / 2)
        V = Z @ V
    else:
        A, B, start = replace(pencil, M=(G + G.T) / 2).bordered((K + K.T) / 2)
        inverse = LinearOperator(A.shape, matvec=splu(A).solve, dtype=np.float64)
        w, V = _eigsh(B, min(count, nf - 2), M=A, Minv=inverse, which="LM", v0=inverse @ (B @ start))
        if np.any(np.einsum("ij,ij->j", V, A @ V) <= 0):
            raise np.linalg.LinAlgError("not positive definite")
        V = V[:nf]
    # relative to the stiffness, which is 1 in these modes
    skew = [np.abs(V.T @ ((part - part.T) @ V)).max(initial=0.0) for part in (K, G)]
    follower = skew[1] > SKEW_TOLERANCE * np.abs(w).max(initial=0.0)
    if skew[0] > SKEW_TOLERANCE or (follower and nf > MAX_DENSE_SIZE):
        raise DynamicsError(
            "buckling: forces that have no potential, such as follower forces, make the stiffness unsymmetric; "
            "equilibrium may then be lost by flutter, before any load at which it bifurcates: follow it with "
            "system.static_path(), and take system.linearize(state).eigenvalues() at its states"
        )
    if follower:  # such as a moment about a fixed axis: only real multipliers are bifurcations
        complex_w, vectors = _eig(load, (stiffness + stiffness.T) / 2)
        real = np.abs(complex_w.imag) <= COUPLED_TOLERANCE * np.abs(complex_w)
        w, V = complex_w[real].real, Z @ vectors[:, real].real
    return w, V


def _shape(system: CoreSystem, dx: Array) -> dict[str, float]:
    s = system.structure
    first = s.m + s.k
    pivot = dx[int(np.argmax(np.abs(dx)))] if dx.size else 1.0
    return {s.names[first + i]: float(entry / pivot) for i, entry in enumerate(dx)}


def largest(shape: Mapping[str, float], count: int = 3) -> str:
    """Return the largest changes of a shape, by name."""
    order = sorted(shape, key=lambda name: -abs(shape[name]))[:count]
    return ", ".join(f"{name} {shape[name]:.3g}" for name in order if shape[name])
