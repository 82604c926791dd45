"""Whether loads and prescribed motions have the period that an analysis of periodic motions is asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from flexel.base.errors import LinearizationError, ModelError
from flexel.base.time_functions import TimeFunction, value_of
from flexel.mechanics.kinematics import Kinematics

COMPARED_AT = (
    np.arange(16) + 0.43
) / 16  # of the period, at which they are compared: between steps and kinks
TINIEST = 1e-300  # value that is not divided by
OFF = 1e-6  # change within a period, relative to the largest value, that is none


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
    names = structure.names
    for i, load in zip(loads.quantities, loads.functions, strict=True):
        _check(f"the load on '{names[i]}'", load, lambda f, t: [value_of(f, t)], begin, period)
    for i, motion in zip(roles.prescribed, roles.motions, strict=True):
        _check(f"the prescribed motion of '{names[i]}'", motion, lambda f, t: f.rates(t)[1:], begin, period)


def _check(
    owner: str,
    function: TimeFunction,
    values: Callable[[TimeFunction, float], Sequence[float]],
    begin: float,
    period: float,
) -> None:
    times = begin + COMPARED_AT * period
    now = np.array([values(function, t) for t in times.tolist()])
    try:
        later = np.array([values(function, t) for t in (times + period).tolist()])
    except ModelError:  # a table ends before
        return
    change = float(np.max(np.abs(later - now).max(axis=0) / np.maximum(np.abs(now).max(axis=0), TINIEST)))
    if change > OFF:
        raise LinearizationError(
            f"periodic: {owner} does not have the period {period:g} s: one period later it differs by {change:.2g} "
            "of its largest value; give a period that all loads and prescribed motions have"
        )
