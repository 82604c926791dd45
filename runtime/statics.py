"""Static equilibrium, load paths past limit points, buckling, and vibrations about equilibrium.

All of it works on coordinates and multipliers together (the saddle-point form), so that no choice of
independent coordinates is needed, however far the structure deforms; the tangent is the analytic r_x.
A path is followed by its arc length, from the unbalance that the start has (loads that are taken on
gradually) or along the time, which then is the load parameter.  Source: Crisfield (1981) for the arc
length; Besseling (1974) for buckling with generalized deformations.
Imports numpy, scipy.linalg and the dynamics.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.linalg import eigh

from flexel.diagnose import largest, null_space, quoted
from flexel.dynamics import Forces, forces, with_multipliers
from flexel.errors import DynamicsError, ModelError, PositionError
from flexel.kinematics import Configuration, wrap
from flexel.state import State
from flexel.states import unwrap
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.system import System

MAX_ITERATIONS = 20
STEP = 0.4  # largest change of a coordinate, in its natural scale, in one Newton step
FIRST_ARC, LARGEST_ARC, SMALLEST_ARC = 0.1, 0.5, 1e-7
MAX_STEPS = 500
TINY_FORCE = 1e-3  # [N] in the denominator of relative unbalances: 1e-15 N counts as nothing


@dataclass(frozen=True)
class Balance:
    """Unbalance and tangent at coordinates x and multipliers mu.

    Attributes
    ----------
    configuration : Configuration
    e : ndarray (m,)
        Deformations with their turns.
    residual : ndarray (nf + nh,)
        Unbalanced forces r, then violated constraints c.
    matrix : ndarray (nf + nh, nf + nh)
        Its derivative with respect to (x, mu).
    scale : float
        Size of the forces that balance one another.
    """

    configuration: Configuration
    e: Array
    forces: Forces
    residual: Array
    matrix: Array
    scale: float


class StaticProblem:
    """The equations of equilibrium of a system, kinematic coordinates held."""

    def __init__(self, system: System, start: State) -> None:
        self.system = system
        self.structure = system.structure
        roles = system.roles
        self.force_rows = np.concatenate([roles.holonomic, roles.zero])
        self.hold_rows = np.concatenate([roles.holonomic, roles.kinematic])
        self.held = start.values[roles.kinematic]
        self.scales = system.kinematics.scales(np.arange(len(self.structure.names)))
        first = self.structure.m + self.structure.k
        self.x_scale = self.scales[first : first + self.structure.nf]
        self.rest = np.zeros(self.structure.n)

    def multipliers(self, state: State) -> Array:
        """Multipliers of the constraint rows at a state: stresses less those of laws and loads."""
        first = self.structure.m + self.structure.k
        given = forces(
            self.system.kinematics,
            self.system.loads,
            Configuration(state.t, state.x, state.e, state.J),
            self.rest,
            state.e,
        )
        total = np.concatenate([state.stress - given.stress, -state.reactions])
        assert total.size == first + self.structure.n
        return np.asarray(total[self.force_rows])

    def balance(self, t: float, x: Array, mu: Array, e_near: Array) -> Balance:
        """Unbalance and tangent at (x, mu) and time t; angles are counted from `e_near`."""
        s, kinematics = self.structure, self.system.kinematics
        principal, J = kinematics.evaluation.position(x)
        e = unwrap(s, principal, e_near)
        c = Configuration(t, x, principal, J)
        given = forces(kinematics, self.system.loads, c, self.rest, e)
        C, A = J[self.force_rows, : s.nf], J[self.hold_rows, : s.nf]
        r = -given.F[: s.nf] + mu @ C
        stress = given.stress.copy()
        inner = self.force_rows < stress.size
        np.add.at(stress, self.force_rows[inner], mu[inner])
        T = kinematics.evaluation.tangents(x, self.rest, self.rest, J, e, stress)
        target = np.concatenate([kinematics.target(t, np.zeros(0)), self.held])
        gap = wrap(kinematics.values(e, x)[self.hold_rows] - target, s.angle[self.hold_rows])
        size = self.hold_rows.size
        matrix = np.block([[T.r_x[: s.nf, : s.nf], C.T], [A, np.zeros((size, self.force_rows.size))]])
        parts = np.abs(stress)[:, None] * np.abs(J[: stress.size, : s.nf])
        scale = max(
            float(parts.max(initial=0.0)),
            float(np.abs(given.F[: s.nf]).max(initial=0.0)),
            float(np.abs(mu[:, None] * C).max(initial=0.0)),
        )
        return Balance(c, e, given, np.concatenate([r, gap]), matrix, scale)

    def parameter_rate(self, b: Balance) -> Array:
        """Derivative (nf + nh,) of the residual with respect to the time at fixed x and mu."""
        s, system = self.structure, self.system
        nodal, applied = system.loads.at(b.configuration.t, order=1)
        r = -nodal[: s.nf] + applied @ b.configuration.J[: applied.size, : s.nf]
        gap = np.zeros(self.hold_rows.size)
        if system.roles.motions:
            first = system.roles.rigid.size
            gap[first : system.roles.holonomic.size] = -system.roles.motion(b.configuration.t)[1]
        return np.concatenate([r, gap])

    def error(self, b: Balance, residual: Array) -> float:
        """Largest entry of a residual: forces relative to those that balance, constraints to natural scales.

        A stiffness K turns a rounding of x into an unbalance of about 1e-15 K x, below which nothing can go;
        with it in the denominator, the tolerance 1e-12 is met there.
        """
        nf = self.structure.nf
        stiff = float(np.abs(b.matrix[:nf, :nf]).max(initial=0.0)) * float(self.x_scale.max(initial=1.0))
        r = float(np.abs(residual[:nf]).max(initial=0.0)) / (b.scale + 1e-3 * stiff + TINY_FORCE)
        return max(r, float(np.abs(residual[nf:] / self.scales[self.hold_rows]).max(initial=0.0)))

    def state(self, b: Balance, mu: Array) -> State:
        """The state of rest at a balanced configuration."""
        multiplier = np.zeros(len(self.structure.names))
        multiplier[self.force_rows] = mu
        kinematics = self.system.kinematics
        return with_multipliers(kinematics, b.configuration, self.rest, self.rest, b.e, b.forces, multiplier)

    def solve(self, b: Balance, rhs: Array) -> Array:
        """Solve with the tangent; names the motion that nothing resists if it is singular.

        Raises
        ------
        DynamicsError
        """
        try:
            return np.asarray(np.linalg.solve(b.matrix, rhs))
        except np.linalg.LinAlgError as error:
            nf = self.structure.nf
            right, _ = null_space(b.matrix, b.matrix.shape[0])
            first = self.structure.m + self.structure.k
            rows = np.arange(nf) + first
            names = largest(self.structure, rows, right[:nf, 0]) if right.shape[1] else []
            raise DynamicsError(
                f"the stiffness is singular: nothing resists a motion of {quoted(names)}; support it, or give it "
                "a stiffness"
            ) from error


def equilibrium(system: System, t: float | None, start: State) -> State:
    """State of rest in which all forces balance; see `System.equilibrium`."""
    problem = StaticProblem(system, start)
    t = start.t if t is None else t
    mu = np.zeros(problem.force_rows.size)
    direct = _newton(problem, t, start.x, mu, start.e)
    if direct is not None:
        return problem.state(*direct)
    states, message = _follow(problem, start, mu, t, t)
    if message:
        raise PositionError(f"no equilibrium found at t = {t:g} s: {message}")
    return states[-1]


def static_path(system: System, t_end: float, start: State) -> tuple[list[State], str]:
    """Equilibria from `start` to the time `t_end`, which is the load parameter; see `System.static_path`."""
    problem = StaticProblem(system, start)
    return _follow(problem, start, problem.multipliers(start), start.t, t_end)


def _newton(
    problem: StaticProblem, t: float, x: Array, mu: Array, e_near: Array
) -> tuple[Balance, Array] | None:
    """Newton's method at a fixed parameter; None if it does not converge."""
    nf, last = problem.structure.nf, np.inf
    x, mu = x.copy(), mu.copy()
    for _ in range(MAX_ITERATIONS):
        b = problem.balance(t, x, mu, e_near)
        error = problem.error(b, b.residual)
        if error < 1e-12 or (error < 1e-9 and error > 0.5 * last):
            return b, mu
        if not np.isfinite(error):
            return None
        step = problem.solve(b, b.residual)
        size = float(np.abs(step[:nf] / problem.x_scale).max(initial=0.0))
        if size > 10 * STEP:
            return None
        factor = min(1.0, STEP / max(size, 1e-300))
        x[:nf] -= factor * step[:nf]
        mu -= factor * step[nf:]
        last, e_near = (error if factor == 1 else np.inf), b.e
    return None


def _follow(problem: StaticProblem, start: State, mu: Array, t0: float, t1: float) -> tuple[list[State], str]:
    """Follow equilibria by arc length while the parameter p goes from 0 to 1.

    At p the time is t0 + p (t1 - t0), and the share 1 - p of the start's unbalance is left.
    Returns the states and, if the end was not reached, a message that says where it stopped and why.
    """
    nf = problem.structure.nf
    first = problem.balance(t0, start.x, mu, start.e)
    unbalance = first.residual
    states = [problem.state(first, mu)]
    z, p, arc = np.concatenate([start.x[:nf], mu]), 0.0, FIRST_ARC
    near, b = start.e, first
    direction: Array | None = None
    count = 0
    while p < 1.0:
        count += 1
        slope = _slope(problem, b, unbalance, t1 - t0)
        tangent = _unit_tangent(problem, slope, direction)
        reach = (1.0 - p) / tangent[-1] if tangent[-1] > 0 else np.inf
        if reach <= arc:
            guess = z + reach * tangent[:-1]
            x = np.concatenate([guess[:nf], start.x[nf:]])
            found = _newton(problem, t1, x, guess[nf:], near)
            if found is not None:
                states.append(problem.state(*found))
                return states, ""
            arc = reach
        corrected = _correct(problem, start, z, p, arc, tangent, unbalance, (t0, t1), near)
        if corrected is None:
            arc /= 2
            if arc < SMALLEST_ARC or count > MAX_STEPS:
                return states, _stopped(problem, states, p, arc)
            continue
        b, z, p, iterations = corrected
        near, direction = b.e, tangent
        states.append(problem.state(b, z[nf:]))
        arc = min(arc * (1.5 if iterations <= 4 else 0.7), LARGEST_ARC)
        if count > MAX_STEPS:
            return states, _stopped(problem, states, p, arc)
    return states, ""


def _slope(problem: StaticProblem, b: Balance, unbalance: Array, span: float) -> Array:
    """Derivative of (x, mu) with respect to the parameter p."""
    rate = unbalance.copy()
    if span:
        rate += span * problem.parameter_rate(b)
    return -problem.solve(b, rate)


def _unit_tangent(problem: StaticProblem, slope: Array, before: Array | None) -> Array:
    """Tangent (x, mu, p) of unit arc length, in the sense of the step before."""
    nf = problem.structure.nf
    change = slope[:nf] / problem.x_scale
    tangent = np.append(slope, 1.0) / np.sqrt(float(change @ change) + 1.0)
    if before is not None:
        sense = (tangent[:nf] / problem.x_scale) @ (before[:nf] / problem.x_scale) + tangent[-1] * before[-1]
        if sense < 0:
            tangent = -tangent
    return tangent


def _correct(
    problem: StaticProblem,
    start: State,
    z: Array,
    p: float,
    arc: float,
    tangent: Array,
    unbalance: Array,
    times: tuple[float, float],
    near: Array,
) -> tuple[Balance, Array, float, int] | None:
    """Newton's method on (x, mu, p) in the plane normal to the tangent at the predicted point."""
    nf, (t0, t1) = problem.structure.nf, times
    normal = np.concatenate([tangent[:nf] / problem.x_scale**2, np.zeros(z.size - nf), tangent[-1:]])
    predicted = np.append(z, p) + arc * tangent
    y, last = predicted.copy(), np.inf
    for iteration in range(1, MAX_ITERATIONS + 1):
        x = np.concatenate([y[:nf], start.x[nf:]])
        b = problem.balance(t0 + y[-1] * (t1 - t0), x, y[nf:-1], near)
        residual = b.residual - (1.0 - y[-1]) * unbalance
        error = problem.error(b, residual)
        if error < 1e-12 or (error < 1e-9 and error > 0.5 * last):
            return b, y[:-1], float(y[-1]), iteration
        if not np.isfinite(error):
            return None
        rate = unbalance + ((t1 - t0) * problem.parameter_rate(b) if t1 != t0 else 0.0)
        both = problem.solve(b, np.column_stack([residual, rate]))
        # bordered elimination: (x, mu) = -both0 - both1 dp, and the step stays in the plane
        gap = normal @ (y - predicted)
        bottom = normal[-1] - normal[:-1] @ both[:, 1]
        dp = (normal[:-1] @ both[:, 0] - gap) / bottom
        step = np.append(-both[:, 0] - both[:, 1] * dp, dp)
        if float(np.abs(step[:nf] / problem.x_scale).max(initial=0.0)) > STEP + arc:
            return None
        y += step
        last = error
    return None


def _stopped(problem: StaticProblem, states: list[State], p: float, arc: float) -> str:
    e = states[-1].values
    rows = np.argsort(-np.abs(np.nan_to_num(e[: problem.structure.m])))[:3]
    names = quoted([problem.structure.names[i] for i in rows])
    top = max(states, key=lambda z: z.t)
    return (
        f"the path stopped at {100 * p:.4g} % of the load (t = {states[-1].t:g} s) after {len(states)} equilibria, arc "
        f"{arc:.2g}; the largest t reached is {top.t:g} s; deformations {names} are largest at the end: a limit of "
        "the load may lie there, otherwise refine the mesh"
    )


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
    problem = StaticProblem(system, state)
    s, evaluation = problem.structure, system.evaluation
    b = problem.balance(state.t, state.x, problem.multipliers(state), state.e)
    load = np.zeros(len(s.names))
    for name, value in increment.items():
        load[s.find(name)] += float(value)
    if not np.any(load):
        raise ModelError("buckling: the load increment is zero; name at least one load, {'tip.z': -1.0}")
    J = b.configuration.J
    rhs = np.concatenate([(load @ J)[: s.nf], np.zeros(problem.hold_rows.size)])
    change = problem.solve(b, rhs)
    first = s.m + s.k
    T = evaluation.tangents(state.x, problem.rest, problem.rest, J, state.e, np.zeros(first))
    stress = T.stress_e @ (J[: s.m, : s.nf] @ change[: s.nf]) - load[:first]
    inner = problem.force_rows < first
    np.add.at(stress, problem.force_rows[inner], change[s.nf :][inner])
    K1 = evaluation.stress_stiffness(state.x, stress)[: s.nf, : s.nf]
    Z, _ = null_space(J[problem.hold_rows, : s.nf], s.nf)
    K0 = Z.T @ b.matrix[: s.nf, : s.nf] @ Z
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
    """An undamped free vibration about equilibrium: angular frequency [rad/s] (0 and NaN free, see below) and shape.

    A negative square of the frequency, an unstable equilibrium, is given as a negative frequency -|ω|.
    """

    frequency: float
    shape: dict[str, float]


def vibrations(system: System, state: State, count: int) -> list[Vibration]:
    """Lowest natural frequencies and modes about a state of rest; see `System.vibrations`."""
    problem = StaticProblem(system, state)
    s = problem.structure
    b = problem.balance(state.t, state.x, problem.multipliers(state), state.e)
    Z, _ = null_space(b.configuration.J[problem.hold_rows, : s.nf], s.nf)
    K = Z.T @ b.matrix[: s.nf, : s.nf] @ Z
    M = Z.T @ b.forces.M[: s.nf, : s.nf] @ Z
    w2, V = _pencil((K + K.T) / 2, (M + M.T) / 2)
    found = [(np.sign(z) * np.sqrt(abs(z)), V[:, i]) for i, z in enumerate(w2)]
    return [Vibration(float(z), _shape(system, Z @ v)) for z, v in found[:count]]


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
