"""Forced motion of linear equations with varying matrices, by exact Radau steps of the homogeneous equations."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from flexel.base.arrays import Array
from flexel.linear.linear_steps import interpolated, refined, transitions

Forced = Callable[[Array], tuple[Array, Array]]  # A (nodes, n, n) and b (nodes, n) at times


def forced_motion(equations: Forced, start: Array, times: Array, tolerance: float) -> Array:
    """Return y (nt, n) of y' = A y + b from a start; steps are halved until the result is accurate.

    Parameters
    ----------
    equations : callable
        A and b at times (nodes,) [s].
    start : ndarray (n,)
    times : ndarray (nt,)
        [s]
    tolerance : float
        Error relative to the largest value.
    """
    n = start.size

    def extended(at: Array) -> Array:
        A, b = equations(at)
        found = np.zeros((at.size, n + 1, n + 1))  # of (y, 1)
        found[:, :n, :n], found[:, :n, n] = A, b
        return found

    matrices = interpolated(extended, float(times[0]), float(times[-1]), tolerance / 10)

    def run(count: int) -> Array:
        y = [np.append(start, 1.0)]
        for step in transitions(matrices, times, count):
            y.append(step @ y[-1])
        return np.array(y)[:, :n]

    return refined(run, tolerance, "along.transient")
