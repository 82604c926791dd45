"""Jumps of functions of time of which only numbers are known: found among samples, and then by halving.

A function of `t` that compares numbers, such as `math.sin(t) > 0` or a table of steps, does not say where it jumps.
Generalized-alpha, whose errors are those of coordinates, would not see where a load does.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.time_functions import TimeFunction, values_at
from flexel.integration.knots import MOST_KNOTS

UNLIKE = 2.0  # change between two samples, over that of a neighbour, from which it may be a jump
HALF = 0.5  # share of that change that halves of the interval keep, where it is one


def jumps(function: TimeFunction, times: Array, values: Array, least: float, within: float) -> Array:
    """Return the times [s] at which a function jumps between samples.

    Parameters
    ----------
    function : TimeFunction
    times, values : ndarray
        Samples [s].
    least : float
        Size of a jump.
    within : float
        Error of its time [s].
    """
    change = np.abs(np.diff(values))
    beside = np.minimum(np.append(change[1:], 0.0), np.insert(change[:-1], 0, 0.0))
    found = np.flatnonzero((change > least) & (change > UNLIKE * beside))
    if not 0 < found.size <= MOST_KNOTS:
        return np.zeros(0)
    first, last, size = times[found], times[found + 1], change[found]
    left, right = values[found], values[found + 1]
    while first.size and np.max(last - first) > within:
        middle = (first + last) / 2
        there = values_at(function, middle)
        early = np.abs(there - left) >= np.abs(right - there)
        last, right = np.where(early, middle, last), np.where(early, there, right)
        first, left = np.where(early, first, middle), np.where(early, left, there)
        kept = np.abs(right - left) >= HALF * size  # where it is smooth, little changes in the end
        first, last, left, right, size = first[kept], last[kept], left[kept], right[kept], size[kept]
    if not first.size:
        return first
    again = values_at(function, first) == left  # noise gives another value each time
    return np.asarray((first + last)[again] / 2)
