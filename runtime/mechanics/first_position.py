"""Assembles the mechanism initially: finds the configuration nearest to the drawing that satisfies the constraints."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import block_array, diags_array, eye_array

from flexel.base.arrays import Array, Index
from flexel.base.errors import PositionError
from flexel.engine.solvers import factorize
from flexel.mechanics.kinematics import Configuration, Kinematics, wrap
from flexel.mechanics.newton import shortened
from flexel.model.lowering import Lowering

STEP = 0.2  # largest change of a wanted value (in its natural scale) in one step of the initial assembly
OF_COORDINATES = 2 * np.finfo(float).eps  # rounding error of a coordinate, relative to it; as in explicit.h
LONGEST = 0.3  # largest change of a coordinate (in its natural scale) in one step of Newton's method


def first_position(model: Lowering, kinematics: Kinematics, t: float) -> Configuration:
    """Find the configuration nearest to the drawing that satisfies the constraints and the given initial values.

    Gauss–Newton with the smallest change of the coordinates; given values are approached in steps.
    """
    structure, roles = kinematics.structure, kinematics.roles
    x = structure.x0.copy()
    e, J = kinematics.evaluation.position(x)
    drawn = kinematics.values(e, x)
    wanted = {structure.find(name): drawn[structure.find(name)] for name in (model.dynamic or [])}
    wanted |= {structure.find(name): drawn[structure.find(name)] for name in (model.kinematic or [])}
    wanted |= {structure.find(name): value for name, value in model.values.items()}
    rows = np.concatenate([roles.holonomic, np.array(list(wanted), dtype=np.intp)])
    start = drawn[rows]
    start[: roles.rigid.size] = 0.0
    goal = np.concatenate(
        [kinematics.target(kinematics.roles.motion(t), np.zeros(0)), np.array(list(wanted.values()))]
    )
    unwrap_from = e
    change = wrap(goal - start, structure.period[rows]) / kinematics.scales(rows)
    steps = max(1, int(np.ceil(np.max(np.abs(change), initial=0.0) / STEP)))
    for i in range(1, steps + 1):
        part = start + (goal - start) * i / steps
        x, unwrap_from = nearest(kinematics, rows, part, x, unwrap_from, t)
    target = unwrap_from if structure.relations else np.zeros(structure.m)
    own = rows < structure.m
    target[rows[own]] = goal[own]
    return Configuration(t, x, *kinematics.evaluation.position(x, target))


def nearest(
    kinematics: Kinematics, rows: Index, goal: Array, x: Array, unwrap_from: Array, t: float
) -> tuple[Array, Array]:
    """Find coordinates that satisfy the rows, and their deformations with turns counted from `unwrap_from`."""
    structure, nf = kinematics.structure, kinematics.structure.nf
    scale, period = kinematics.scales(rows), structure.period[rows]
    size = kinematics.scales(np.arange(nf) + structure.m + structure.k)
    x, best, stalled = x.copy(), np.inf, 0
    for _ in range(60):
        e, J = kinematics.evaluation.position(x, unwrap_from)
        unwrap_from = e
        residual = wrap(kinematics.values(e, x)[rows] - goal, period)
        error = float(np.max(np.abs(residual) / scale, initial=0.0))
        settled = error > 0.5 * best
        if error < 1e-13 or (settled and error < 1e-11):
            return x, unwrap_from
        C = J[rows][:, :nf]
        if settled and rounded(C, x[:nf], scale, residual):
            return x, unwrap_from
        stalled = stalled + 1 if error > 0.9 * best else 0
        best = min(best, error)
        if stalled > 12 or not np.isfinite(error):
            break
        # in natural scales, so that neither the path nor the result depends on the units
        step = smallest_step(_scaled(C, scale, size), residual / scale)
        x[:nf] -= size * shortened(step, float(np.max(np.abs(step), initial=0.0)), LONGEST)
    worst = np.argsort(-np.abs(residual) / scale)[:4]
    names = ", ".join(f"'{structure.names[rows[i]]}' (off by {residual[i]:.3g})" for i in worst)
    raise PositionError(
        f"the mechanism cannot be assembled at t = {t:g} s: {names} remain unsatisfied; the drawing and the given "
        "initial or prescribed values contradict the constraints: correct one of them"
    )


def rounded(C: Any, x: Array, scale: Array, residual: Array) -> bool:
    """Whether rounding explains the residuals: of values with these scales, and of coordinates, by derivatives C."""
    return bool(np.all(np.abs(residual) <= OF_COORDINATES * (scale + abs(C) @ np.abs(x))))


def _scaled(C: Any, rows: Array, columns: Array) -> Any:
    """Return a matrix for scaled columns, with scaled rows."""
    if isinstance(C, np.ndarray):
        return C / rows[:, None] * columns
    return diags_array(1 / rows) @ C @ diags_array(columns)


def smallest_step(C: Any, residual: Array) -> Array:
    """Return the least-squares solution of C dx = residual with the smallest dx."""
    if isinstance(C, np.ndarray):
        return np.asarray(np.linalg.lstsq(C, residual, rcond=1e-10)[0])
    size, count = C.shape[1], C.shape[0]
    damping = -1e-12 * eye_array(count)  # redundant conditions are reported later
    factors = factorize(block_array([[eye_array(size), C.T], [C, damping]]))
    return factors.solve(np.concatenate([np.zeros(size), residual]))[:size]
