"""Follows branches of nonlinear periodic motions over the speed, past folds, with their stability.

Folds, and maxima of the largest Floquet multiplier, are located between the computed motions.  Source: Seydel,
"Practical bifurcation and stability analysis" (2010), for turning points and their location.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import ConstraintError, DynamicsError, LinearizationError, PositionError
from flexel.linear.speeds import Balanced, PeriodicCurve
from flexel.mechanics.arclength import Arcs, CurvePoint, corrected, follow, point_at
from flexel.mechanics.timed_laws import refuse_speeds
from flexel.system import CoreSystem

log = logging.getLogger("flexel.continuation")
FIRST_ARC, SMALLEST_ARC = 0.2, 1e-6  # arc lengths, relative to the largest
# Accuracy of the position of a fold along the curve, relative to the distance between two motions.
FOLD_TOLERANCE = 1e-3
PEAK_TOLERANCE = 0.05  # the same for a maximum
PROMINENCE = 0.004  # of a maximum above the adjacent minima
NEARLY_REAL_SHARE = 0.9  # real share of a multiplier above which its maximum is located
TILT = 1.0  # weight of the real share relative to the modulus
MULTIPLIERS = 1e-6  # error of the transition matrix
FAILURES = (PositionError, ConstraintError, DynamicsError, LinearizationError)


@dataclass(frozen=True)
class BranchPoint:
    """A motion of a branch with its Floquet multipliers (2 nd,).

    Its kind is "", "end", "fold", or "peak" where the largest multiplier has a maximum.
    """

    point: CurvePoint[Balanced]
    multipliers: ComplexArray
    kind: str = ""

    @property
    def modulus(self) -> float:
        """The modulus of the largest multiplier."""
        return float(np.abs(self.multipliers[0]))

    @property
    def share(self) -> float:
        """The real part of the largest multiplier over its modulus."""
        return float(self.multipliers[0].real) / max(self.modulus, 1e-300)


def branch(
    system: CoreSystem, period: float, end: float, start: ComplexArray, samples: int, step: float, most: int
) -> tuple[list[BranchPoint], str]:
    """Follow the branch of periodic motions from one period to another; see `System.periodic_branch`.

    Parameters
    ----------
    period, end : float
        [s]
    start : ndarray of complex (2k + 1, nd)
        Fourier coefficients of the motion at the start.
    samples : int
        Times in a period.
    step : float
        Largest arc length.
    most : int
        Number of steps.

    Returns
    -------
    list of BranchPoint, str
        In order along the branch; why it stopped early, if it did.

    Raises
    ------
    LinearizationError
        If a law depends on time, not only on the motion.
    """
    p_end, sense = float(abs(np.log(period / end))), 1.0 if end < period else -1.0
    curve = PeriodicCurve(system, 2 * np.pi / period, samples, start.shape[0] // 2, sense)
    y = np.append(curve.pack(start), 0.0)
    first = curve.equations(y, None)
    refuse_speeds(system.evaluation, first.states[0])
    points = [point_at(curve, y, first)]
    level = np.append(np.zeros(y.size - 1), 1.0)

    def finish(guess: Array, known: CurvePoint[Balanced], arc: float) -> bool:
        goal = np.append(guess[:-1], p_end if guess[-1] > p_end / 2 else 0.0)
        found = corrected(curve, goal, level, known, arc)
        if found is not None:
            points.append(found)
        return found is not None

    arcs, message = Arcs(FIRST_ARC * step, step, SMALLEST_ARC * step, most), ""
    try:
        arc = follow(curve, points[0], (0.0, p_end), arcs, points.append, finish)
        if arc is not None:
            message = (
                f"{len(points)} motions were found, the last step is {arc:.2g}: allow more or smaller steps"
            )
    except FAILURES as error:
        message = str(error)
    if message:
        speed = curve.omega * np.exp(sense * points[-1].y[-1])
        message = f"the branch stopped at {speed:g} rad/s: {message}"
    log.info("branch of %d periodic motions%s", len(points), f"; {message}" if message else "")
    stations = [_station(point, "end" if i in (0, len(points) - 1) else "") for i, point in enumerate(points)]
    try:
        stations = _with_folds(curve, stations)
        stations = _with_peaks(curve, stations)
    except FAILURES as error:
        message = f"{message}; folds and maxima are missing: {error}".removeprefix("; ")
    return stations, message


def _station(point: CurvePoint[Balanced], kind: str = "") -> BranchPoint:
    return BranchPoint(point, point.equations.coefficients.floquet_multipliers(MULTIPLIERS), kind)


def _with_folds(curve: PeriodicCurve, stations: list[BranchPoint]) -> list[BranchPoint]:
    """Insert the folds between the motions."""
    found = stations[:1]
    for before, after in zip(stations, stations[1:], strict=False):
        if before.point.tangent[-1] * after.point.tangent[-1] < 0:
            found.append(_station(_fold(curve, before.point, after.point), "fold"))
        found.append(after)
    return found


def _with_peaks(curve: PeriodicCurve, stations: list[BranchPoint]) -> list[BranchPoint]:
    """Insert the maxima of the largest multiplier.

    The modulus rises where a pair of multipliers meets on the real axis and separates, perhaps only between two
    motions.  The real share of the multiplier has a maximum there.
    """
    from scipy.signal import find_peaks  # slow to import

    moduli = np.array([station.modulus for station in stations])
    shares = np.array([abs(station.share) for station in stations])
    broad = find_peaks(moduli, prominence=PROMINENCE)[0].tolist()
    tops = dict.fromkeys((i for i in broad if moduli[i - 1] < moduli[i] > moduli[i + 1]), 0.0)
    heights = moduli + TILT * shares
    for i in find_peaks(heights)[0].tolist():
        strict = heights[i - 1] < heights[i] > heights[i + 1]
        if strict and shares[i] > NEARLY_REAL_SHARE and not {i - 1, i, i + 1} & tops.keys():
            tops[i] = TILT
    found = list(stations)
    for i in sorted(tops, reverse=True):
        three = stations[i - 1 : i + 2]
        part, peak = _peak(curve, three, tops[i])
        if tops[i] and peak.modulus < max(station.modulus for station in three) + PROMINENCE:
            continue
        place = slice(i + (part > 1), i + (part >= 1))  # the middle one becomes the peak if none is larger
        found[place] = [replace(peak, kind="peak")]
    return found


def _between(
    curve: PeriodicCurve, first: CurvePoint[Balanced], last: CurvePoint[Balanced], part: float
) -> CurvePoint[Balanced]:
    """Find the point of the curve at the given fraction of the way from one point to another."""
    if part in (0.0, 1.0):
        return last if part else first
    chord, weights = last.y - first.y, curve.weights(first.equations)
    arc = float(np.sqrt(weights @ chord**2))
    found = corrected(curve, first.y + part * chord, weights * chord, first, arc)
    if found is None:
        raise PositionError("periodic_branch: no motion found between two neighbours: take smaller steps")
    return found


def _fold(
    curve: PeriodicCurve, first: CurvePoint[Balanced], last: CurvePoint[Balanced]
) -> CurvePoint[Balanced]:
    """Find the point between two others at which the speed reverses."""
    part = brentq(lambda s: _between(curve, first, last, s).tangent[-1], 0.0, 1.0, xtol=FOLD_TOLERANCE)
    return _between(curve, first, last, float(part))


def _peak(curve: PeriodicCurve, three: list[BranchPoint], tilt: float) -> tuple[float, BranchPoint]:
    """Find the maximum of the largest modulus, plus tilt times the real share, around the second of three motions.

    Returns its position, 0…2 from the first motion on, and the motion.
    """
    known = {float(i): station for i, station in enumerate(three)}

    def height(s: float) -> float:
        if s not in known:
            i = min(int(s), 1)
            known[s] = _station(_between(curve, three[i].point, three[i + 1].point, s - i))
        return known[s].modulus + tilt * abs(known[s].share)

    minimize_scalar(lambda s: -height(float(s)), bracket=(0.0, 1.0, 2.0), method="brent", tol=PEAK_TOLERANCE)
    place = max(known, key=height)
    return place, known[place]
