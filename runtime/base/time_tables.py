"""Values at given times, as a function of time: joined smoothly, by straight lines, or held."""

from __future__ import annotations

import copy

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arguments import array, number, unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError

ROUNDING = 1e-13  # of sums of durations, relative to the times of a table
FEWEST = {"cubic": (4, "four"), "linear": (2, "two"), "step": (2, "two")}
SAME_SLOPE = 1e-12  # difference of two slopes, relative to them, that is due to rounding


class Table:
    """Values at given times, and between them.

    Parameters
    ----------
    t, u : array_like (n,)
        Increasing times [s] and values; n >= 4 for "cubic", n >= 2 otherwise.
    kind : {"cubic", "linear", "step"}
        "cubic": a cubic spline, with continuous rates (C2).  "linear": straight lines, as ``np.interp``.  "step": each
        value holds until the next time.  Prescribed motions have continuous rates, so only loads are linear or steps.

    Attributes
    ----------
    knots : ndarray
        Inner times [s] at which the value jumps ("step") or its rate does ("linear"); a cubic spline has none.

    Notes
    -----
    At a knot, value and rates are those of the piece that begins there.

    Examples
    --------
    >>> m.load("A.x", fx.Table([0.0, 1.0, 2.0], [0.0, 50.0, 20.0], kind="step"))  # doctest: +SKIP
    """

    def __init__(self, t: ArrayLike, u: ArrayLike, kind: str = "cubic") -> None:
        if not isinstance(kind, str) or kind not in FEWEST:
            raise ModelError(f"Table: {unknown(str(kind), FEWEST, 'kind')}")
        times, values = array(t, "Table", "times"), array(u, "Table", "values")
        if values.shape != times.shape:
            raise ModelError(
                f"Table: {times.size} times and values of shape {values.shape}; give one value for each"
            )
        fewest, word = FEWEST[kind]
        if times.ndim != 1 or times.size < fewest or np.any(np.diff(times) <= 0):
            raise ModelError(f"Table: times must be at least {word}, strictly increasing; sort them")
        self.kind = kind
        self._begins = times
        self._pieces = _pieces(times, values, kind)
        self._range = float(times[0]), float(times[-1])
        self._owner = ""

    @property
    def knots(self) -> Array:
        """Inner times [s] at which the value or its rate jumps."""
        if self.kind == "cubic":
            return np.zeros(0)
        inner = self._begins[1:-1]
        steps = self._pieces[0, : inner.size + 1]  # slopes of straight lines, or values that are held
        jumps = np.abs(np.diff(steps)) > SAME_SLOPE * np.maximum(np.abs(steps[1:]), np.abs(steps[:-1]))
        return np.array(inner[jumps])

    def of(self, owner: str) -> Table:
        """The same table; its errors name the quantity that it moves."""
        found = copy.copy(self)
        found._owner = owner
        return found

    def rates(self, t: float) -> tuple[float, float, float]:
        """Value, first and second rate at time t [s]; a ModelError outside the table."""
        t = number(t, self._owner or "Table", "time")
        first, last = self._range
        slack = ROUNDING * max(abs(first), abs(last))
        if not first - slack <= t <= last + slack:
            before = self._owner and f"{self._owner}: "
            raise ModelError(f"{before}Table: time {t} s lies outside {first}…{last} s; extend the table")
        t = min(max(t, first), last)
        i = min(int(np.searchsorted(self._begins, t, side="right")), self._pieces.shape[1]) - 1
        d, u, v, a = t - float(self._begins[i]), 0.0, 0.0, 0.0
        for c in self._pieces[:, i].tolist():  # Horner's scheme for the value and its derivatives together
            u, v, a = u * d + c, v * d + u, a * d + 2 * v
        return u, v, a


def _pieces(times: Array, values: Array, kind: str) -> Array:
    """Coefficients (degree + 1, pieces) of the polynomials of the time since a piece began, highest power first."""
    if kind == "cubic":
        from scipy.interpolate import CubicSpline

        return np.asarray(CubicSpline(times, values).c)
    if kind == "linear":
        return np.array([np.diff(values) / np.diff(times), values[:-1]])
    return values[None, :]
