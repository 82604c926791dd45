"""Prescribed motions and loads at the stages of a step, for the engine."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from flexel.base.arrays import Array
from flexel.mechanics.kinematics import Kinematics


class Smooth(Protocol):
    """Where functions of time are smooth: an interval between knots, or the present one of `Knots`."""

    def inside(self, t: float) -> float:
        """Return the time [s], or the nearest one within the interval."""


def give(kinematics: Kinematics, knots: Smooth, given: Array, times: Sequence[float]) -> None:
    """Fill rows (times, 3 prescribed + loads) with prescribed motions (value, rate, second rate) and loads.

    Parameters
    ----------
    kinematics : Kinematics
    knots : Smooth
        The interval between knots in which the functions are evaluated.
    given : ndarray (times, 3 prescribed + loads)
    times : sequence of float
        [s]
    """
    motions, loads = kinematics.roles.motions, kinematics.loads
    split = given.shape[1] - loads.quantities.size
    varying = loads.any and not loads.steady
    if loads.any and loads.steady:
        given[:, split:] = loads.values(knots.inside(times[0]))
    for row, t in zip(given, times, strict=True) if motions or varying else ():
        inside = knots.inside(t)
        if motions:
            row[:split] = kinematics.roles.motion(inside).ravel()
        if varying:
            row[split:] = loads.values(inside)
