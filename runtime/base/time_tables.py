"""Tables of values over time, joined by a cubic spline, by straight lines or by steps, and their knots."""

from __future__ import annotations

import copy

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arguments import array, number, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError

ROUNDING = 1e-13  # of sums of durations, relative to the times of a table
MIN_VALUES = {"cubic": 4, "linear": 2, "step": 1}  # number of values
SLOPE_TOLERANCE = 1e-12  # difference of two slopes, relative, that is due to rounding
UNSEEN = (
    1e-9  # change in value at a spline's knot, relative to the range, below which the knot counts as smooth
)


class Table:
    """Values at given times, interpolated in between.

    Parameters
    ----------
    t, u : array_like (n,)
        Increasing times [s] and values.
    kind : {"cubic", "linear", "step"}
        ``"cubic"``: a spline with continuous second rates, n >= 4. ``"linear"``: straight lines, n >= 2; a time that
        appears twice is a jump from the first of its values to the second. ``"step"``: each value holds from its time
        until the next one, and the last one indefinitely.

    Attributes
    ----------
    t, u, kind
        As given.
    knots : ndarray
        Times at which the function is not smooth; steps of an integration end there. A knot of a spline is omitted if
        its jump in the third rate is negligible, as in a densely sampled smooth function.

    Raises
    ------
    ModelError
        Times that do not increase, too few values, an unknown kind; on evaluation: a time outside the table.
    """

    def __init__(self, t: ArrayLike, u: ArrayLike, kind: str = "cubic") -> None:
        times, values = array(t, "Table", "times"), array(u, "Table", "values")
        if not isinstance(kind, str) or kind not in MIN_VALUES:
            raise ModelError(f"Table: {unknown(str(kind), MIN_VALUES, 'kind')}")
        if values.shape != times.shape:
            raise ModelError(
                f"Table: {times.size} times and values of shape {values.shape}; give one value for each"
            )
        _check_times(times, kind)
        self.t, self.u, self.kind = times, values, kind
        self._range = float(times[0]), float(times[-1])
        self._pieces, self.knots = _JOINED[kind](times, values)
        self._owner = ""

    def of(self, owner: str) -> Table:
        """Return the same table with errors that name the quantity it moves."""
        found = copy.copy(self)
        found._owner = owner
        return found

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t [s]; raise a ModelError outside the table."""
        t = number(t, self._owner or "Table", "time")
        first, last = self._range
        slack = ROUNDING * max(abs(first), abs(last))
        if t < first - slack or (self.kind != "step" and t > last + slack):
            before = self._owner and f"{self._owner}: "
            raise ModelError(f"{before}Table: time {t} s lies outside {first}…{last} s; extend the table")
        t = min(max(t, first), last)
        i = min(max(int(np.searchsorted(self.t, t, side="right")) - 1, 0), self._pieces.shape[1] - 1)
        c3, c2, c1, c0 = self._pieces[:, i].tolist()
        s = t - float(self.t[i])
        return c0 + s * (c1 + s * (c2 + s * c3)), c1 + s * (2 * c2 + 3 * s * c3), 2 * c2 + 6 * s * c3

    def next_knot(self, t: float) -> float:
        """Return the first knot after time t [s], which may be the end of the table; infinite after the last one."""
        i, end = int(np.searchsorted(self.knots, t, side="right")), self._range[1]
        if i < self.knots.size:
            return float(self.knots[i])
        return end if self.kind != "step" and t < end else np.inf

    def on_knot(self, t: float, within: float) -> bool:
        """Whether there is a knot within a given time [s] of t."""
        return self.next_knot(t - within) <= t + within


def _check_times(times: Array, kind: str) -> None:
    """Raise if there are too few times, or if they do not increase as the kind requires."""
    number_words = {1: "one", 2: "two", 4: "four"}
    if times.ndim != 1 or times.size < MIN_VALUES[kind] or times[0] == times[-1] and times.size > 1:
        raise ModelError(
            f"Table: times must be strictly increasing, and at least {number_words[MIN_VALUES[kind]]}; give more"
        )
    gaps = np.diff(times)
    if kind == "linear" and np.all(gaps >= 0) and not np.any((gaps[1:] == 0) & (gaps[:-1] == 0)):
        return
    if np.any(gaps <= 0):
        raise ModelError("Table: times must be strictly increasing; sort them")


def _cubic(times: Array, values: Array) -> tuple[Array, Array]:
    """Compute the coefficients (4, n - 1) of the pieces of a spline, and its detectable knots."""
    from scipy.interpolate import CubicSpline

    c = np.asarray(CubicSpline(times, values).c)
    jump, gaps = np.abs(np.diff(c[0])), np.diff(times)
    seen = jump * np.maximum(gaps[1:], gaps[:-1]) ** 3 > UNSEEN * float(np.ptp(values))
    return c, times[1:-1][seen]


def _linear(times: Array, values: Array) -> tuple[Array, Array]:
    """Compute the coefficients of straight lines, and their knots."""
    gaps, rise = np.diff(times), np.diff(values)
    slopes = np.divide(rise, gaps, out=np.zeros_like(rise), where=gaps > 0)
    none = np.zeros_like(slopes)
    largest = np.maximum(np.abs(slopes[1:]), np.abs(slopes[:-1]))
    bend = np.abs(np.diff(slopes)) > SLOPE_TOLERANCE * largest
    jump = (gaps[1:] == 0) | (gaps[:-1] == 0)
    return np.array([none, none, slopes, values[:-1]]), np.unique(times[1:-1][bend | jump])


def _step(times: Array, values: Array) -> tuple[Array, Array]:
    """Compute the coefficients of steps, and their knots."""
    none = np.zeros_like(values)
    return np.array([none, none, none, values]), times[1:][np.diff(values) != 0]


_JOINED = {"cubic": _cubic, "linear": _linear, "step": _step}
