"""Buckling and free vibrations about a state of rest.

Both are eigenvalue problems of the tangent r_x on the motions that the constraints admit, so that no choice
of independent coordinates is needed.  Source: Besseling (1974) for buckling with generalized deformations.
Imports numpy, scipy.linalg and the statics.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.linalg import eigh

from flexel.diagnose import null_space
from flexel.errors import DynamicsError, ModelError
from flexel.inputs import numbers
from flexel.state import State
from flexel.statics import Rest
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.system import System


@dataclass(frozen=True)
class BucklingMode:
    """A buckling mode: the multiple of the load increment at which equilibrium branches, and the shape.

    Attributes
    ----------
    multiplier : float
    shape : dict of str to float
        Change of each coordinate, the largest one 1.
    """

    multiplier: float
    shape: dict[str, float]


def buckling(system: System, state: State, increment: Mapping[str, float], count: int) -> list[BucklingMode]:
    """Buckling multipliers of a load increment at a preloaded state; see `System.buckling`."""
    problem = Rest(system, state)
    s, evaluation = problem.structure, system.evaluation
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    load = np.zeros(len(s.names))
    for name, value in numbers(increment, "buckling", "load").items():
        i = s.find(name, "buckling")
        if i >= s.m + s.k + s.nf:
            raise ModelError(f"buckling: the load acts on '{name}', which is fixed; name another quantity")
        load[i] += value
    _check_count(count, "buckling")
    if not np.any(load):
        raise ModelError("buckling: the load increment is zero; name at least one load, {'tip.z': -1.0}")
    J = q.balance.configuration.J
    rhs = np.concatenate([(load @ J)[: s.nf], np.zeros(problem.hold_rows.size)])
    change = problem.solve(q.matrix, rhs)
    first = s.m + s.k
    T = evaluation.tangents(
        state.x, problem.rest, problem.rest, J, state.e, np.zeros(first), state.z, state.t
    )
    stress = T.stress_e @ (J[: s.m, : s.nf] @ change[: s.nf]) - load[:first]
    inner = problem.force_rows < first
    np.add.at(stress, problem.force_rows[inner], change[s.nf :][inner])
    K1 = evaluation.stress_stiffness(state.x, stress)[: s.nf, : s.nf]
    Z, _ = null_space(J[problem.hold_rows, : s.nf], s.nf)
    K0 = Z.T @ q.matrix[: s.nf, : s.nf] @ Z
    G = Z.T @ K1 @ Z
    try:
        w, V = eigh((G + G.T) / 2, (K0 + K0.T) / 2)
    except np.linalg.LinAlgError as error:
        raise DynamicsError(
            "buckling: the stiffness at this state is not positive definite: it has buckled already, or a motion is "
            "not supported; start from an earlier state of the path"
        ) from error
    modes = [(-1.0 / wi, V[:, i]) for i, wi in enumerate(w) if abs(wi) > 1e-12 * np.abs(w).max(initial=0.0)]
    modes.sort(key=lambda z: (abs(z[0]), -z[0]))
    return [BucklingMode(float(z), _shape(system, Z @ v)) for z, v in modes[:count]]


@dataclass(frozen=True)
class Vibration:
    """An undamped free vibration about equilibrium: angular frequency [rad/s] and shape.

    A negative square of the frequency, an unstable equilibrium, is given as a negative frequency -|ω|.
    """

    frequency: float
    shape: dict[str, float]


def vibrations(system: System, state: State, count: int) -> list[Vibration]:
    """Lowest natural frequencies and modes about a state of rest; see `System.vibrations`."""
    problem = Rest(system, state)
    s = problem.structure
    q = problem.equations(state.t, state.x, problem.multipliers(state), state.e)
    Z, _ = null_space(q.balance.configuration.J[problem.hold_rows, : s.nf], s.nf)
    K = Z.T @ q.matrix[: s.nf, : s.nf] @ Z
    M = Z.T @ q.balance.forces.M[: s.nf, : s.nf] @ Z
    _check_count(count, "vibrations")
    w2, V = _pencil((K + K.T) / 2, (M + M.T) / 2)
    found = [(np.sign(z) * np.sqrt(abs(z)), V[:, i]) for i, z in enumerate(w2)]
    return [Vibration(float(z), _shape(system, Z @ v)) for z, v in found[:count]]


def _check_count(count: object, owner: str) -> None:
    if not isinstance(count, (int, np.integer)) or count < 1:
        raise ModelError(f"{owner}: {count!r} modes asked for; give a whole number, 1 or more")


def _pencil(K: Array, M: Array) -> tuple[Array, Array]:
    """Finite eigenvalues of K v = w² M v, rising; massless directions are condensed statically."""
    m, U = np.linalg.eigh(M)
    massless = m < 1e-13 * max(float(m[-1]), 1e-300)
    if not massless.any():
        w2, V = eigh(K, M)
        return np.asarray(w2), np.asarray(V)
    A, B = U[:, ~massless], U[:, massless]
    try:
        back = -np.linalg.solve(B.T @ K @ B, B.T @ K @ A)
    except np.linalg.LinAlgError as error:
        raise DynamicsError(
            "vibrations: a motion has neither mass nor stiffness; give it one of them"
        ) from error
    T = A + B @ back
    w2, V = eigh(T.T @ K @ T, np.diag(m[~massless]))
    return np.asarray(w2), np.asarray(T @ V)


def _shape(system: System, dx: Array) -> dict[str, float]:
    s = system.structure
    first = s.m + s.k
    pivot = dx[int(np.argmax(np.abs(dx)))] if dx.size else 1.0
    return {s.names[first + i]: float(z / pivot) for i, z in enumerate(dx)}
