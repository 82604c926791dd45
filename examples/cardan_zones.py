"""Zones of parametric instability of the universal joint, traced: smooth edges and refined peaks.

Within a zone the squared growth g² of a disturbance in one turn is a smooth function of the speed that falls through
zero at both edges: two multipliers exp(±g) meet there at one.  A polynomial through few speeds gives edges and peak.
Each zone is followed from the largest angle between the shafts, where it is widest, to smaller ones.
Imports numpy, scipy and flexel.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.polynomial import Chebyshev
from scipy.interpolate import PchipInterpolator

from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError
from flexel.examples.cardan import growth
from flexel.linear.periodic import Coefficients

Equations = Callable[[float], Coefficients]  # of a speed
TOLERANCE = 1e-6  # of the transition matrix
FLOOR = 2e-3  # growth in one turn that certainly lies inside a zone
SCAN, DEGREE, HALVINGS = 15, 6, 6


@dataclass(frozen=True)
class Zone:
    """A zone of instability over the angle between the shafts.

    Attributes
    ----------
    angles : ndarray (na,)
        Increasing [degrees]; the first has no width.
    low, high : ndarray (na,)
        Speeds at the edges, over the natural frequency.
    peak, largest : ndarray (na,)
        Speed of the largest growth, and this growth in one turn, log |multiplier|.
    shapes : ndarray (na, DEGREE + 1)
        g² over s from -1 to 1 across the zone, as coefficients of Chebyshev polynomials.
    """

    angles: Array
    low: Array
    high: Array
    peak: Array
    largest: Array
    shapes: Array

    def edges(self, angles: Array) -> tuple[Array, Array]:
        """Return the speeds at the edges for any angles [degrees] of the zone."""
        return self._over(self.low)(angles), self._over(self.high)(angles)

    def ridge(self, angles: Array) -> Array:
        """Return the speeds of the largest growth."""
        return np.asarray(self._over(self.peak)(angles))

    def field(self, count: int = 161, across: int = 81) -> tuple[Array, Array, Array]:
        """Return angles, speeds and growth (across, count) over the whole zone, its edges included."""
        angle = np.linspace(self.angles[0], self.angles[-1], count)
        low, high = self.edges(angle)
        s = np.sin(np.linspace(-np.pi / 2, np.pi / 2, across))
        square = np.array([Chebyshev(c)(s) for c in PchipInterpolator(self.angles, self.shapes)(angle)]).T
        speed = (low + high) / 2 + s[:, None] * (high - low) / 2
        inside = np.maximum(square, 0.0)
        inside[[0, -1]] = 0.0
        return np.tile(angle, (across, 1)), speed, np.sqrt(inside)

    def _over(self, values: Array) -> PchipInterpolator:
        return PchipInterpolator(self.angles, values)


def trace(at: Callable[[float], Equations], angles: Sequence[float], order: int, width: float) -> Zone:
    """Trace the zone near the speed 1/order, from the largest angle down to where it is too weak to be seen.

    Parameters
    ----------
    at : function
        The equations for an angle [rad], for any speed.
    angles : sequence of float
        [degrees]; so close together that the zone hardly leaves its own width from one to the next.
    width : float
        Half width of the range of speeds in which it is sought at the largest angle.
    """
    rows: list[tuple[float, float, float, float, float, Array]] = []
    for degrees in sorted(angles, reverse=True):
        equations = at(float(np.radians(degrees)))
        centre = 1 / order
        if rows:  # the centre shifts with the square of the angle
            a, p = (rows[-2][0], rows[-2][3]) if len(rows) > 1 else (0.0, centre)
            b, q = rows[-1][0], rows[-1][3]
            centre = q + (q - p) * (degrees**2 - b**2) / (b**2 - a**2)
        found = _across(partial(_growth, equations), centre, width)
        if found is None:
            break
        rows.append((degrees, *found))
        width = max(0.75 * (found[1] - found[0]), 0.02 / order**2)
    none = (0.0, 1 / order, 1 / order, 1 / order, 0.0, np.zeros(DEGREE + 1))
    start = none if len(rows) == len(angles) else _faded(rows, min(edge for edge, *_ in rows) - 1.0)
    columns = zip(*[start, *reversed(rows)], strict=True)
    return Zone(*(np.array(column) for column in columns))


def _faded(
    rows: Sequence[tuple[float, float, float, float, float, Array]], angle: float
) -> tuple[float, ...]:
    """Return a zone without width a little below the smallest angle at which it was seen."""
    centre = rows[-1][3]
    return angle, centre, centre, centre, 0.0, np.zeros(DEGREE + 1)  # type: ignore[return-value]


def _growth(at: Equations, speed: float) -> float:
    try:
        return growth(at(speed), TOLERANCE)
    except LinearizationError:  # too stiff for the shortest steps: not a zone
        return 0.0


def _across(
    g: Callable[[float], float], centre: float, width: float
) -> tuple[float, float, float, float, Array] | None:
    """Find edges, peak, growth there and shape of the zone within a range of speeds; None without a visible one."""
    speeds = centre + width * np.linspace(-1, 1, SCAN)
    values = np.array([g(w) for w in speeds])
    top = int(np.argmax(values))
    for _ in range(4):  # a narrow zone may lie between the points
        if values[top] > FLOOR:
            break
        speeds = (
            (speeds[:-1] + speeds[1:]) / 2 if _ == 0 else centre + width * np.linspace(-1, 1, SCAN * 2**_)
        )
        values = np.array([g(w) for w in speeds])
        top = int(np.argmax(values))
    if values[top] <= FLOOR:
        return None
    step = speeds[1] - speeds[0]
    ends = [_end(g, speeds[top], side * step) for side in (-1, 1)]
    middle, half = sum(ends) / 2, (ends[1] - ends[0]) / 2
    nodes = np.cos(np.pi * (np.arange(DEGREE + 3) + 0.5) / (DEGREE + 3))
    fit = Chebyshev.fit(
        middle + half * nodes, [g(float(middle + half * s)) ** 2 for s in nodes], DEGREE, domain=ends
    )
    low, high = _edges(fit, ends)
    s = np.linspace(low, high, 2001)
    squares = fit(s)
    peak = int(np.argmax(squares))
    shape = Chebyshev.fit(s, squares, DEGREE, domain=[low, high])
    return low, high, float(s[peak]), float(np.sqrt(squares[peak])), np.asarray(shape.coef, dtype=float)


def _end(g: Callable[[float], float], inside: float, step: float) -> float:
    """Find the last speed in a direction that is certainly inside the zone, by doubling and halving."""
    outside = inside + step
    while g(outside) > FLOOR:
        inside, outside = outside, outside + step
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if g(middle) > FLOOR else (inside, middle)
    return float(inside)


def _edges(fit: Chebyshev, ends: Sequence[float]) -> tuple[float, float]:
    """Find where the squared growth is zero, just outside of the speeds that are certainly inside."""
    roots = fit.roots()
    real = roots[np.abs(roots.imag) < 1e-6 * (ends[1] - ends[0])].real
    below, above = real[real <= ends[0]], real[real >= ends[1]]
    return (
        float(below.max()) if below.size else float(ends[0]),
        float(above.min()) if above.size else float(ends[1]),
    )
