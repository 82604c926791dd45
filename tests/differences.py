"""Numerical derivatives of the nonlinear equations, against which the analytic linearization is held.

Central differences with Richardson extrapolation to sixth order; used in tests only.
"""

from collections.abc import Callable, Sequence

import numpy as np

from flexel.mechanics.states import state_of
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.parts.model import Model
from flexel.results.system_facade import System

STEP = 4e-3


class Knob:
    """A function of time whose value, rate and acceleration are set by a test."""

    def __init__(self, value: float = 0.0, rate: float = 0.0, acceleration: float = 0.0) -> None:
        self.now = [value, rate, acceleration]

    def rates(self, t: float) -> tuple[float, float, float]:
        return self.now[0], self.now[1], self.now[2]


def slope(f: Callable[[float], np.ndarray], h: float = STEP) -> np.ndarray:
    """df/dx at x = 0 with an error of order h^6."""
    D = [(f(h / 2**i) - f(-h / 2**i)) / (2 * h / 2**i) for i in range(3)]
    E = [(4 * D[1] - D[0]) / 3, (4 * D[2] - D[1]) / 3]
    return (16 * E[1] - E[0]) / 15


def jacobian(f: Callable[[np.ndarray], np.ndarray], x0: np.ndarray, h: float = STEP) -> np.ndarray:
    """df/dx at x0, column by column."""
    columns = [slope(lambda d, u=u: f(x0 + d * u), h) for u in np.eye(x0.size)]
    return np.array(columns).T.reshape(-1, x0.size)


def numerical_matrices(
    system: System, state: State, h: float = STEP
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M, C, K from the residual of the nonlinear equations."""
    nd = system.roles.nd
    qdd = np.array([state.acceleration(name) for name in system.dynamic])
    t, q, qd = state.t, state.q, state.qd
    M = jacobian(lambda accelerations: system.residual(t, q, qd, accelerations, state), qdd, h)
    C = jacobian(lambda velocities: system.residual(t, q, velocities, qdd, state), qd, h)
    K = jacobian(lambda positions: system.residual(t, positions, qd, qdd, state), q, h)
    assert M.shape == (nd, nd)
    return M, C, K


def numerical_state_matrix(system: System, state: State) -> np.ndarray:
    """State matrix for (q_d', q_d, q_k) from the right-hand side."""
    nq, nd = system.roles.nq, system.roles.nd

    def rates(values: np.ndarray) -> np.ndarray:
        system.warm(state)
        r = system.rhs(state.t, np.concatenate([values[nd:], values[:nd]]))
        return np.concatenate([r[nq:], r[:nq]])

    return jacobian(rates, np.concatenate([state.qd, state.q]))


def numerical_outputs(
    system: System,
    state: State,
    motions: Sequence[Knob],
    loads: Sequence[Knob],
    outputs: Sequence[str],
    h: float = STEP,
) -> tuple[np.ndarray, np.ndarray]:
    """Rates of the states and outputs, differentiated by (q_d', q, u', u | loads, u'')."""
    nd, nq, nu = system.roles.nd, system.roles.nq, len(motions)
    ns = nd + nq + 2 * nu
    start = [list(k.now) for k in (*motions, *loads)]

    def evaluate(d: np.ndarray) -> np.ndarray:
        for i, knob in enumerate(motions):
            u, ud, udd = start[i]
            knob.now = [u + d[nd + nq + nu + i], ud + d[nd + nq + i], udd + d[ns + len(loads) + i]]
        for i, knob in enumerate(loads):
            knob.now = [start[nu + i][0] + d[ns + i], 0.0, 0.0]
        y = np.concatenate([state.q + d[nd : nd + nq], state.qd + d[:nd]])
        q, qd, z = np.split(y, [nq, nq + nd])
        now = state_of(system.kinematics, state.t, q, qd, z, Snapshot.of(state))
        rates = [now.acceleration(name) for name in system.dynamic] + [
            now.rate(name) for name in system.dynamic
        ]
        rates += [now.rate(name) for name in system.kinematic] + [d[ns + len(loads) + i] for i in range(nu)]
        rates += [d[nd + nq + i] for i in range(nu)]
        return np.array(rates + [read(now, name) for name in outputs])

    J = jacobian(evaluate, np.zeros(ns + len(loads) + nu), h)
    for knob, now in zip((*motions, *loads), start, strict=True):
        knob.now = now
    return J[:ns], J[ns:]


def read(state: State, output: str) -> float:
    """Value of an output as the state-space form names it."""
    if output.startswith("force:"):
        return state.force(output.removeprefix("force:"))
    if output.endswith("''"):
        return state.acceleration(output[:-2])
    return state.rate(output[:-1]) if output.endswith("'") else state[output]


def worst(computed: np.ndarray, reference: np.ndarray) -> float:
    """Largest difference, relative to the largest entry of the reference (at least 1e-3)."""
    return float(np.max(np.abs(computed - reference)) / max(float(np.max(np.abs(reference))), 1e-3))


def pendulum(gravity: float = 9.81, **rod: float) -> Model:
    """A rod of length 1 along x on a hinge about y, at rest; more is up to the test."""
    m = Model(gravity=(0, 0, -gravity))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (1, 0, 0))
    R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0))
    m.beam("rod", O, R1, A, **rod)
    return m
