"""How quickly the user's functions of time vary: steps are limited there, so that no pulse is stepped over.

A method sees a load and a prescribed motion at the stages of its steps only.  Where all else is at rest, its steps
grow, and a short pulse may lie between two stages.  So each function is looked at before the motion starts.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.base.time_functions import TimeFunction, calls_user, next_knot, sampled
from flexel.integration.jumps import jumps
from flexel.integration.knots import ASIDE, MOST_KNOTS

INTERVALS = 4096  # into which a motion is divided where a function takes all times at once
FEWER = 512  # where it is called for each time
DETAIL = 1e-3  # deviation from a cubic through samples, over the range of the function, that counts
STRETCH = (
    6.0  # longest step, over the finest distance of samples at which there is a detail: ωh = 3 of a vibration
)
ROUNDED_RANGE = 1e-12  # range of a function, over its size, that is rounding
SAMPLES_AWAY = 5  # distances of samples from a sample up to the farthest that its cubic goes through
FINER, LEVELS = (
    128,
    3,
)  # intervals of a stretch in which details are finer than its samples, and how often it is divided
MOST_STRETCHES = 32  # that are divided: a function with more is a noise
CUBIC_MIDDLE = np.array([-1.0, 9.0, 9.0, -1.0]) / 16  # cubic through four samples, in their middle
CUBIC_ASIDE = np.array([5.0, 15.0, -5.0, 1.0]) / 16  # the same, between the first two


class TimeScales:
    """The longest steps of one motion.

    Parameters
    ----------
    functions : iterable of TimeFunction
    begin, end : float
        Times of the motion [s].

    Attributes
    ----------
    jumps : ndarray
        Times [s] at which functions jump that say nothing of it, increasing.
    any : bool
        Whether steps are limited anywhere.
    """

    def __init__(self, functions: Iterable[TimeFunction], begin: float, end: float) -> None:
        own = [f for f in functions if calls_user(f)] if end > begin else []
        looks = [_Look(function, begin, end) for function in own]
        self.jumps = np.unique(np.concatenate([np.zeros(0), *(look.jumps for look in looks)]))
        stretches = [look.stretches() for look in looks]
        self._stretches = [tuple(zip(*found, (end, np.inf), strict=True)) for found in stretches if found]
        self.any = bool(self._stretches)

    def until(self, t: float) -> float:
        """Return the time [s] at which a step from t ends at the latest.

        It ends before each stretch for which it is too long.
        """
        longest = np.inf
        for starts, limits in self._stretches:
            for i in range(max(bisect_right(starts, t) - 1, 0), len(starts)):
                if starts[i] - t >= longest:
                    break
                longest = min(longest, max(starts[i] - t, limits[i]))
        return t + longest


class _Look:
    """One function, looked at from one time to another [s]: where it jumps, and how quickly it varies."""

    def __init__(self, function: TimeFunction, begin: float, end: float) -> None:
        self._function, self._begin, self._end = function, begin, end
        values = self._values = sampled(function, begin, end, INTERVALS, FEWER)
        size = float(np.ptp(values))
        # neither constant, nor not finite
        self._varies = size > ROUNDED_RANGE * float(np.max(np.abs(values)))
        self._least, self.jumps = DETAIL * size, np.zeros(0)
        if self._varies:
            known, times = _knots(function, begin, end), np.linspace(begin, end, values.size)
            within = ASIDE / 8 * max(abs(begin), abs(end))
            found = jumps(function, times, values, self._least, within)
            self.jumps = found[_distances(found, known) > times[1] - times[0]]
            self._knots = np.union1d(known, self.jumps)

    def stretches(self) -> list[tuple[float, float]]:
        """Return the beginnings of stretches, and the longest steps over them [s]; none if it is smooth."""
        if not self._varies:
            return []
        found = list(self._divided(self._begin, self._end, self._values, LEVELS))
        return found if min(limit for _, limit in found) < np.inf else []

    def _divided(self, begin: float, end: float, values: Array, levels: int) -> Iterator[tuple[float, float]]:
        """Yield the stretches between two times [s] from samples there, with finer ones where these do not suffice."""
        times = np.linspace(begin, end, values.size).tolist()
        limits = _limits(values, self._least, times, self._knots)
        # equal neighbours are one stretch
        first = [0, *(np.flatnonzero(limits[1:] != limits[:-1]) + 1).tolist()]
        finest = 1.5 * STRETCH * (end - begin) / (values.size - 1)  # less than that of the next distance
        unresolved = [i for i in first if limits[i] <= finest]
        divides = levels > 0 and len(unresolved) <= MOST_STRETCHES
        for i, following in zip(first, [*first[1:], limits.size], strict=True):
            if divides and limits[i] <= finest:
                inner = sampled(self._function, times[i], times[following], FINER, FINER)
                yield from self._divided(times[i], times[following], inner, levels - 1)
            else:
                yield times[i], float(limits[i])


def _distances(times: Array, known: Array) -> Array:
    """Return the distance [s] of each time from the nearest of those that are known."""
    return np.asarray(np.min(np.abs(times[:, None] - known), axis=1, initial=np.inf))


def _limits(values: Array, least: float, times: list[float], knots: Array) -> Array:
    """Return the longest step [s] over each interval between samples: some times the distance that shows a detail.

    Details near knots do not count: every step ends there, whatever they are.
    """
    count, interval = values.size - 1, times[1] - times[0]
    limits, stride = np.full(count, np.inf), 1
    while 8 * stride <= count:
        places = times[0] + interval * np.arange(stride, count, 2 * stride)
        near = [np.searchsorted(knots, places + side * SAMPLES_AWAY * stride * interval) for side in (-1, 1)]
        detail = (np.abs(_details(values[::stride])) > least) & (near[0] == near[1])
        limits = np.minimum(
            limits, np.repeat(np.where(detail, STRETCH * stride * interval, np.inf), 2 * stride)
        )
        stride *= 2
    return limits


def _details(values: Array) -> Array:
    """Return how far every second sample lies from the cubic through its four neighbours among the others."""
    kept, inner = values[::2], values[1::2]
    four = np.lib.stride_tricks.sliding_window_view(kept, 4)
    cubic = np.concatenate([[CUBIC_ASIDE @ four[0]], four @ CUBIC_MIDDLE, [CUBIC_ASIDE[::-1] @ four[-1]]])
    return np.asarray(inner - cubic)


def _knots(function: TimeFunction, begin: float, end: float) -> Array:
    """Return the knots of a function between two times [s]."""
    found: list[float] = []
    t = begin
    while len(found) < MOST_KNOTS and (t := next_knot(function, t)) < end:
        found.append(t)
    return np.array(found)
