"""Prescribed motions and loads at the stages of a step, for the engine."""

from __future__ import annotations

from collections.abc import Sequence

from flexel.base.arrays import Array
from flexel.integration.knots import Interval
from flexel.mechanics.kinematics import Kinematics


def give(kinematics: Kinematics, interval: Interval, given: Array, times: Sequence[float]) -> None:
    """Fill rows (times, 3 prescribed + loads) with prescribed motions (value, rate, second rate) and loads.

    Parameters
    ----------
    kinematics : Kinematics
    interval : Interval
        Between knots, in which the functions are evaluated.
    given : ndarray (times, 3 prescribed + loads)
    times : sequence of float
        [s]
    """
    motions, loads = kinematics.roles.motions, kinematics.loads
    split = given.shape[1] - loads.quantities.size
    varying = not loads.steady
    if loads.any and loads.steady:
        given[:, split:] = loads.values(interval.inside(times[0]))
    if not motions and not varying:
        return
    rows = []  # lists: small arrays would cost more than most functions
    for t in times:
        row = [part for order in zip(*[interval.rates(f, t) for f in motions], strict=True) for part in order]
        rows.append(row + loads.listed(interval.inside(t)) if varying else row)
    given[:, 0 if motions else split : None if varying else split] = rows
