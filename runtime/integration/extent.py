"""How far a motion may go, estimated before it begins: the scale of its tolerances until it has a range itself."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.time_functions import TimeFunction, calls_user, values_at
from flexel.integration.balance import Saddle
from flexel.integration.time_scales import FEWER
from flexel.mechanics.saddle import SaddlePattern
from flexel.model.state import State

PARTS = 10.0 ** -np.arange(7)  # of the duration, over which steps are tried
LOOKS = np.linspace(0.125, 1.0, 8)  # instants, over the duration, at which loads and motions are seen


def extent(saddle: Saddle, start: State, duration: float) -> float:
    """Estimate the largest displacement to expect, in natural scales, at most 1.

    One step of the implicit Euler method from the start, linearized, goes as far as a vibration whose period is
    longer than the step, or else to its static deflection. The largest of steps of many lengths is taken, and of
    steps over the whole duration with the loads and prescribed motions of later instants; loads that are functions of
    the user are not called before their time.  What is prescribed goes at least as far as its values.

    Parameters
    ----------
    saddle : Saddle
    start : State
    duration : float
        [s]

    Returns
    -------
    float
        Zero where nothing moves the model, or where it has no tangent at its start.
    """
    if not saddle.structure.nf:
        return 0.0
    pattern = SaddlePattern(saddle.work, saddle.force_rows, saddle.force_rows)
    found = [_displacement(saddle, pattern, start, part * duration, start.t) for part in PARTS]
    kinematics = saddle.system.kinematics
    if kinematics.time_functions and not any(map(calls_user, kinematics.loads.functions)):
        found += [_later(saddle, pattern, start, duration, start.t + at * duration) for at in LOOKS]
    scales = saddle.scales[saddle.roles.prescribed].tolist()
    for motion, scale in zip(saddle.roles.motions, scales, strict=True):
        found.append(_range(motion, start.t, duration) / scale)
    return min(max(found), 1.0)


def _range(motion: TimeFunction, begin: float, duration: float) -> float:
    """Return by how much a prescribed motion changes from a time [s] on, as far as it is known there."""
    knots = np.asarray(getattr(motion, "knots", ()), dtype=float)
    inside = knots[(begin < knots) & (knots < begin + duration)]
    values = values_at(motion, np.concatenate([begin + duration * np.linspace(0.0, 1.0, FEWER + 1), inside]))
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if known.size else 0.0


def _later(saddle: Saddle, pattern: SaddlePattern, start: State, step: float, t: float) -> float:
    """Estimate the largest displacement in a step with the loads at a later time; zero where a table has ended.

    The motion reports that by itself if it comes so far.
    """
    try:
        return _displacement(saddle, pattern, start, step, t)
    except ModelError:
        return 0.0


def _displacement(saddle: Saddle, pattern: SaddlePattern, start: State, step: float, t: float) -> float:
    """Return the largest displacement in a step with the loads at a time."""
    saddle.z = start.z
    b = saddle.balance(t, start.x, start.v, -start.v / step, saddle.multipliers(start), start.e)
    saddle.stiffness(1 / step, 1 / step**2, share=step if saddle.structure.nz else 0.0)
    factors = pattern.matrix(saddle.work).factors
    if not factors.regular:
        return 0.0
    slips = np.zeros(saddle.force_rows.size - b.gap.size)
    moved: Array = factors.solve(np.concatenate([b.r, b.gap, slips]))[: saddle.structure.nf]
    return float(np.abs(moved / saddle.x_scale).max())
