"""Whether loads and prescribed motions have the period that an analysis of periodic motions is asked for."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from flexel.base.arrays import Array, largest
from flexel.base.errors import LinearizationError, ModelError
from flexel.base.time_functions import TimeFunction, value_of
from flexel.mechanics.kinematics import Kinematics

PLACES_IN_PERIOD = (np.arange(16) + 0.43) / 16  # at which drives are compared: between steps and kinks
OFF = 1e-6  # change within a period, relative to the largest value, that is none
UNSEEN = 1e-9  # of the largest load: what is smaller may be the rounding of a formula


def check_drives(kinematics: Kinematics, begin: float, period: float) -> None:
    """Check that loads, and the rates of prescribed motions, are the same one period later.

    Prescribed motions may go on: a drive that turns is where it was after a turn.  A function that is not defined as
    far as that, as a table of one period, is not compared.

    Raises
    ------
    LinearizationError
        Names the first that differs.
    """
    structure, roles, loads = kinematics.structure, kinematics.roles, kinematics.loads
    times = begin + PLACES_IN_PERIOD * period
    forces = [_values(partial(value_of, f), times, period) for f in loads.functions]
    least = UNSEEN * max((largest(now) for now, _ in forces), default=0.0)
    for i, (now, later) in zip(loads.quantities, forces, strict=True):
        _check(f"the load on '{structure.names[i]}'", now, later, least, period)
    for i, motion in zip(roles.prescribed, roles.motions, strict=True):
        owner, least = f"the prescribed motion of '{structure.names[i]}'", 0.0
        for order in (1, 2):
            now, later = _values(partial(_rate, motion, order), times, period)
            _check(owner, now, later, least, period)
            # an acceleration is compared with what the rate asks for
            least = 2 * np.pi / period * largest(now)


def _values(function: Callable[[float], float], times: Array, period: float) -> tuple[Array, Array]:
    """Return the values of a function at times [s], and a period later; the same ones where it is not defined there."""
    now = np.array([function(t) for t in times.tolist()])
    try:
        return now, np.array([function(t) for t in (times + period).tolist()])
    except ModelError:  # a table ends before
        return now, now


def _rate(motion: TimeFunction, order: int, t: float) -> float:
    return motion.rates(t)[order]


def _check(owner: str, now: Array, later: Array, least: float, period: float) -> None:
    size, off = max(largest(now), largest(later), least), largest(later - now)
    if off > OFF * size:
        raise LinearizationError(
            f"periodic: {owner} does not have the period {period:g} s: one period later it differs by {off / size:.2g} "
            "of its largest value; give a period that all loads and prescribed motions have"
        )
