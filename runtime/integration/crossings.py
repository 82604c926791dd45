"""Zero crossings of a function of time within a step, also where it crosses zero twice between two samples."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from flexel.base.arrays import Array

LOCATED = 1e-13  # accuracy of the time of a crossing [s]
SAMPLES = (0.001, 0.25, 0.5, 0.75, 0.999)  # parts of a step; those near its ends show the slopes there
FINEST = 1e-9  # accuracy of the time of a minimum, relative to the step: closer pairs are not seen

Function = Callable[[float], float]


def crossings(
    function: Function, near: Function, ends: dict[float, float], direction: int = 0
) -> list[float]:
    """Return the times of the zero crossings within a step, increasing.

    Parameters
    ----------
    function : callable(float) -> float
        Of time [s].
    near : callable(float) -> float
        About the same, for less; NaN where it is not known.
    ends : dict of float to float
        The times of the beginning and of the end of the step, and the values there.
    direction : int
        +1: only upward crossings; -1: only downward; 0: both.

    Notes
    -----
    Between neighbouring samples of one sign, zero is crossed an even number of times.  Two crossings are found if
    |g| has a single minimum around a sample that is smaller than both its neighbours.  Where what is near to the
    function neither changes its sign nor has such a sample, the function itself is not evaluated.
    """
    t0, t1 = ends
    samples = [t for t in (t0 + part * (t1 - t0) for part in SAMPLES) if t0 < t < t1]
    values = np.array([ends[t0], *map(near, samples), ends[t1]])
    if np.isfinite(values).all() and abs(np.sign(values).sum()) == values.size and not _lowest(values):
        return []
    known = dict(ends)

    def kept(t: float) -> float:
        if t not in known:
            known[t] = function(t)
        return known[t]

    _look_below(kept, [t0, *samples, t1])
    inner = [
        t for t in sorted(known) if t in ends or known[t]
    ]  # a zero within counts only if the sign changes
    found = []
    for a, b in zip(inner[:-1], inner[1:], strict=True):
        ga, gb = known[a], known[b]
        if (ga < 0 <= gb or gb <= 0 < ga) and (direction == 0 or direction * (gb - ga) > 0):
            found.append(float(brentq(kept, a, b, xtol=LOCATED, rtol=8.9e-16)))
    return found


def _look_below(kept: Function, samples: list[float]) -> None:
    """Evaluate the function around the minima of its size, where it may cross zero twice between two samples."""
    values = np.array([kept(t) for t in samples])
    shortest = FINEST * (samples[-1] - samples[0])
    for i in _lowest(values):

        def size(t: float, sign: float = float(np.sign(values[i]))) -> float:
            return sign * kept(t)  # negative beyond zero

        bounds = samples[i - 1], samples[i + 1]
        minimize_scalar(size, bounds=bounds, method="bounded", options={"xatol": shortest})


def _lowest(values: Array) -> list[int]:
    """Return the places within a list where the size is smallest among neighbours of one sign, but not constant."""
    signs, sizes = np.sign(values), np.abs(values)
    before, here, after = sizes[:-2], sizes[1:-1], sizes[2:]
    same = np.abs(signs[:-2] + signs[1:-1] + signs[2:]) == 3
    least = (here <= np.minimum(before, after)) & (here < np.maximum(before, after))
    return (np.flatnonzero(same & least) + 1).tolist()
