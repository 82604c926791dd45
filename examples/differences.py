"""State matrices by differences of the nonlinear equations of motion: a check of the analytic linearization."""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array

STEP = 2e-4
WEIGHTS = {1: 45.0, 2: -9.0, 3: 1.0}  # central differences of sixth order, over 60 steps


def state_matrix(system: fx.System, state: fx.State, step: float = STEP) -> Array:
    """Compute the state matrix in the order of `Linearization.states`, by central differences of `rhs`."""
    nd, nq = len(system.dynamic), system.roles.nq
    y0 = np.concatenate([state.q, state.qd, state.z])

    def slope(i: int) -> Array:
        total = np.zeros(y0.size)
        for k, weight in WEIGHTS.items():
            for side in (1, -1):
                y = y0.copy()
                y[i] += side * k * step
                system.warm(state)
                total += side * weight * system.rhs(state.t, y)
        return total / (60 * step)

    A: Array = np.array([slope(i) for i in range(y0.size)]).T
    order = np.concatenate([np.arange(nq, nq + nd), np.arange(nq), np.arange(nq + nd, y0.size)])
    return np.asarray(A[np.ix_(order, order)])


def mismatch(system: fx.System, state: fx.State) -> float:
    """Return the largest difference of the analytic and the numerical state matrix, over the largest entry."""
    A = state_matrix(system, state)
    return float(np.abs(system.linearize(state).state_matrix - A).max() / np.abs(A).max())
