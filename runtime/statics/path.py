"""Search for equilibria, and load paths past limit points.

A path is followed by arc length: either the residual at the start is removed (loads applied incrementally), or
time is the load parameter.  Source: Crisfield (1981) for the arc
length.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arguments import names, number
from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError, PositionError
from flexel.engine.finite import TangentError
from flexel.mechanics.core import Core
from flexel.mechanics.diagnose import quoted
from flexel.mechanics.newton import newton
from flexel.statics.equilibrium import CONVERGED, MAX_ITERATIONS, STALLED, STEP, Equations, Rest, solve
from flexel.structure.state import State

FIRST_ARC, LARGEST_ARC, SMALLEST_ARC = 0.1, 0.5, 1e-7
MAX_STEPS = 500


def equilibrium(system: Core, t: float | None, start: State, hold: Sequence[str] = ()) -> State:
    """State of rest in which all forces balance; see `System.equilibrium`."""
    problem = Rest(system, start, _held(system, hold))
    t = start.t if t is None else number(t, "equilibrium", "time t")
    mu = problem.holding_forces(t, start)
    direct = solve(problem, t, start.x, mu, start.e)
    if direct is not None:
        return problem.state(direct[0].balance)
    states, message = _follow(problem, start, mu, t, t)
    if message:
        raise PositionError(f"no equilibrium found at t = {t:g} s: {message}")
    return states[-1]


def _held(system: Core, hold: Sequence[str]) -> Index:
    """Quantities to be held, without duplicates."""
    structure, roles, first = system.structure, system.roles, system.structure.m + system.structure.k
    found = [structure.find(name, "equilibrium: hold") for name in names(hold, "equilibrium: hold")]
    for name, i in zip(hold, found, strict=True):
        if (
            structure.m <= i < first
            or i >= first + structure.nf
            or i in roles.holonomic
            or i in roles.kinematic
        ):
            raise ModelError(
                f"equilibrium: '{name}' cannot be held: it is a slip, or fixed, rigid, prescribed or held; drop it"
            )
    return np.array(found, dtype=np.intp)


def static_path(system: Core, t_end: float, start: State) -> tuple[list[State], str]:
    """Equilibria from `start` to the time `t_end`, which is the load parameter; see `System.static_path`."""
    problem = Rest(system, start)
    end = number(t_end, "static_path", "t_end")
    if end == start.t:
        raise ModelError(f"static_path: t_end is the time of the start, {end:g} s; give another")
    return _follow(problem, start, problem.multipliers(start), start.t, end)


def _follow(problem: Rest, start: State, mu: Array, t0: float, t1: float) -> tuple[list[State], str]:
    """Follow equilibria by arc length while the parameter p goes from 0 to 1.

    At p the time is t0 + p (t1 - t0), and the fraction 1 - p of the start's residual remains.
    Returns the states and, if the end was not reached, a message with the place and the reason.
    """
    first = problem.equations(t0, start.x, mu, start.e)
    states = [problem.state(first.balance)]
    try:
        return states, _extend(problem, states, first, start, mu, (t0, t1))
    except TangentError as error:
        return states, f"the path stopped at t = {states[-1].t:g} s after {len(states)} equilibria: {error}"


def _extend(
    problem: Rest, states: list[State], first: Equations, start: State, mu: Array, times: tuple[float, float]
) -> str:
    """Append the equilibria that follow the first; returns the message of a path that stopped."""
    nf, (t0, t1) = problem.structure.nf, times
    unbalance = first.residual
    z, p, arc = np.concatenate([start.x[:nf], mu]), 0.0, FIRST_ARC
    near, here = start.e, first
    direction: Array | None = None
    count = 0
    while p < 1.0:
        count += 1
        slope = _slope(problem, here, unbalance, t1 - t0)
        tangent = _unit_tangent(problem, slope, direction)
        reach = (1.0 - p) / tangent[-1] if tangent[-1] > 0 else np.inf
        if reach <= arc:
            end = _at_end(problem, start, z + reach * tangent[:-1], t1, near)
            if end is not None:
                states.append(end)
                return ""
            arc = reach
        corrected = _correct(problem, start, z, p, arc, tangent, unbalance, times, near)
        if (
            corrected is not None and corrected[2] >= 1.0
        ):  # the plane of the correction extends beyond the end
            end = _at_end(problem, start, corrected[1], t1, corrected[0].balance.e)
            if end is not None:
                states.append(end)
                return ""
            corrected = None
        if corrected is None:
            arc /= 2
            if arc < SMALLEST_ARC or count > MAX_STEPS:
                return _stopped(problem, states, p, arc)
            continue
        here, z, p, iterations = corrected
        near, direction = here.balance.e, tangent
        states.append(problem.state(here.balance))
        arc = min(arc * (1.5 if iterations <= 4 else 0.7), LARGEST_ARC)
        if count > MAX_STEPS:
            return _stopped(problem, states, p, arc)
    return ""


def _at_end(problem: Rest, start: State, guess: Array, t1: float, near: Array) -> State | None:
    """The equilibrium at the end of a path, from coordinates and multipliers near it; None if Newton fails."""
    nf = problem.structure.nf
    found = solve(problem, t1, np.concatenate([guess[:nf], start.x[nf:]]), guess[nf:], near)
    return None if found is None else problem.state(found[0].balance)


def _slope(problem: Rest, q: Equations, unbalance: Array, span: float) -> Array:
    """Derivative of (x, mu) with respect to the parameter p."""
    rate = unbalance.copy()
    if span:
        rate += span * problem.rate(q)
    return -q.matrix.solve(rate)


def _unit_tangent(problem: Rest, slope: Array, before: Array | None) -> Array:
    """Tangent (x, mu, p) of unit arc length, in the direction of the previous step."""
    nf = problem.structure.nf
    change = slope[:nf] / problem.x_scale
    tangent = np.append(slope, 1.0) / np.sqrt(float(change @ change) + 1.0)
    if before is not None:
        sense = (tangent[:nf] / problem.x_scale) @ (before[:nf] / problem.x_scale) + tangent[-1] * before[-1]
        if sense < 0:
            tangent = -tangent
    return np.asarray(tangent)


def _correct(
    problem: Rest,
    start: State,
    z: Array,
    p: float,
    arc: float,
    tangent: Array,
    unbalance: Array,
    times: tuple[float, float],
    near: Array,
) -> tuple[Equations, Array, float, int] | None:
    """Newton's method on (x, mu, p) in the plane normal to the tangent at the predicted point."""
    nf, (t0, t1) = problem.structure.nf, times
    normal = np.concatenate([tangent[:nf] / problem.x_scale**2, np.zeros(z.size - nf), tangent[-1:]])
    predicted = np.append(z, p) + arc * tangent

    def evaluate(y: Array) -> tuple[tuple[Equations, Array], float]:
        x = np.concatenate([y[:nf], start.x[nf:]])
        q = problem.equations(t0 + y[-1] * (t1 - t0), x, y[nf:-1], near)
        residual = q.residual - (1.0 - y[-1]) * unbalance
        return (q, residual), problem.size(q, residual)

    def move(y: Array, equations: tuple[Equations, Array]) -> Array | None:
        q, residual = equations
        rate = unbalance + (t1 - t0) * problem.rate(q)
        both = q.matrix.solve(np.column_stack([residual, rate]))
        # bordered elimination: (x, mu) = -both0 - both1 dp, and the step stays in the plane
        gap = normal @ (y - predicted)
        bottom = normal[-1] - normal[:-1] @ both[:, 1]
        dp = (normal[:-1] @ both[:, 0] - gap) / bottom
        step = np.append(-both[:, 0] - both[:, 1] * dp, dp)
        return None if problem.extent(step) > STEP + arc else y + step

    limits = {"tolerance": CONVERGED, "stalled": STALLED}
    found = newton(predicted, evaluate, move, **limits, most=MAX_ITERATIONS)
    if not found.converged:
        return None
    return found.equations[0], found.point[:-1], float(found.point[-1]), found.iterations


def _stopped(problem: Rest, states: list[State], p: float, arc: float) -> str:
    e = states[-1].values
    rows = np.argsort(-np.abs(np.nan_to_num(e[: problem.structure.m])))[:3]
    names = quoted([problem.structure.names[i] for i in rows])
    top = max(states, key=lambda z: z.t)
    return (
        f"the path stopped at {100 * p:.4g} % of the load (t = {states[-1].t:g} s) after {len(states)} equilibria, arc "
        f"{arc:.2g}; the largest t reached is {top.t:g} s; deformations {names} are largest at the end: a limit "
        "load may have been reached, otherwise refine the mesh"
    )
