"""Checks whether the rates that the user gives for a prescribed motion match its values."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.time_functions import Foreign, TimeFunction, Triple, rates_at
from flexel.system import CoreSystem

# Parts of a motion, evenly spread, on no round number.
PLACES: Array = np.asarray((np.arange(7) + 0.5) * 0.6180339887498949 % 1)
STEP = 1e-5  # of the differences, relative to the duration
ERROR = 0.1  # of a rate, relative to the largest, that is accepted: values may be interpolated in a table
ROUNDING = 1e-14
FEWEST = 2  # times at which a rate is wrong: it may jump near one
PANELS = 8  # in which rates are integrated over a motion
LEVELS_OF_HALVES = 16  # of panels, where the integral of a rate is in doubt
MOST_HALVES = 64  # at one level
NODES, WEIGHTS = np.polynomial.legendre.leggauss(4)
MISFIT = (
    1e-3  # of the change of a value from the integral of its rate, relative to all changes, that is accepted
)
RATES = ("rate u'", "second rate u''")
VALUES = ("value u", "rate u'")


def check_rates(system: CoreSystem, begin: float, end: float) -> None:
    """Compare the rates of prescribed motions with differences of their values at some times of a motion [s].

    Raises
    ------
    ModelError
        If a rate differs from the differences at two times or more; names the quantity.
    """
    roles, names = system.roles, system.structure.names
    for place, function in zip(roles.prescribed, roles.motions, strict=True):
        if isinstance(function, Triple | Foreign) and end > begin:
            _check(names[place], function, begin, end - begin)


def _check(name: str, function: TimeFunction, begin: float, duration: float) -> None:
    """Check one function; differences that do not settle say nothing."""
    times, h = begin + duration * PLACES, STEP * duration
    there, fine, coarse = (
        rates_at(function, times),
        _slopes(function, times, h / 2),
        _slopes(function, times, h),
    )
    for i, rate in enumerate(RATES):
        given, found = there[:, i + 1], fine[:, i]
        size = max(np.abs(given).max(), np.abs(found).max())
        unsure = 10 * np.abs(found - coarse[:, i]) + ROUNDING * np.abs(there[:, i]).max() / h
        off = np.abs(given - found) - unsure
        if np.count_nonzero(off > ERROR * size) >= FEWEST:
            k = int(np.argmax(off))
            raise ModelError(
                f"'{name}': the {rate} of its prescribed motion is {given[k]:.6g} at t = {times[k]:.6g} s, but "
                f"differences give {found[k]:.6g}; correct the triple (u, u', u''), or give u alone"
            )


def misfits(system: CoreSystem, begin: float, end: float) -> list[str]:
    """Report prescribed motions whose values do not change by the integral of their rates.

    It finds what `check_rates` does not: rates that are a little wrong everywhere, or jumps that they leave out.

    Parameters
    ----------
    begin, end : float
        Times of the motion [s].
    """
    roles, names = system.roles, system.structure.names
    found = []
    for place, function in zip(roles.prescribed, roles.motions, strict=True):
        if isinstance(function, Triple | Foreign) and end > begin:
            found += [f"'{names[place]}': {text}" for text in _misfits(function, begin, end)]
    return found


def _misfits(function: TimeFunction, begin: float, end: float) -> Iterator[str]:
    """Report the same of one function, for its value and its rate."""
    edges = np.linspace(begin, end, PANELS + 1)
    there, integrals = rates_at(function, edges)[:, :2], _integrals(function, edges[:-1], edges[1:])
    changes = np.diff(there, axis=0)
    size = np.maximum(np.abs(changes).sum(axis=0), np.abs(integrals).sum(axis=0))
    allowed = MISFIT * size + ROUNDING * PANELS * np.abs(there).max(axis=0)
    wrong = _off(changes, integrals).max(axis=0) > allowed
    if wrong.any():
        refined = _refined(function, edges, there, integrals, np.where(wrong, allowed / PANELS, np.inf))
        integrals = np.where(wrong, refined, integrals)
    off = _off(changes, integrals)
    for i, rate in enumerate(RATES):
        k = int(np.argmax(off[:, i]))
        if off[k, i] > allowed[i]:
            yield (
                f"from t = {begin:.6g} s to {edges[k + 1]:.6g} s its prescribed {VALUES[i]} changes by "
                f"{there[k + 1, i] - there[0, i]:.6g}, but the integral of the {rate} is "
                f"{integrals[: k + 1, i].sum():.6g}: give u alone, or "
                "correct the triple (u, u', u''); where a rate jumps, give one function of t, whose jumps are found"
            )


def _off(changes: Array, integrals: Array) -> Array:
    """Return by how much values have changed from their integrals up to the end of each panel."""
    return np.abs(np.cumsum(changes - integrals, axis=0))


def _refined(function: TimeFunction, edges: Array, values: Array, integrals: Array, allowed: Array) -> Array:
    """Integrate both rates over panels again (panels, 2), in halves where a value does not change by its integral.

    So the short pieces of a function are found, such as rounded corners.  Where a rate is wrong everywhere, or leaves
    out a jump, halves do not help.

    Parameters
    ----------
    values : ndarray (panels + 1, 2)
        Value and rate at the edges.
    integrals : ndarray (panels, 2)
        Of both rates, not refined.
    allowed : ndarray (2,)
        Differences over a panel at which a panel is left as it is; infinite for what is not refined.
    """
    found = np.zeros_like(integrals)
    panel, start, end = np.arange(edges.size - 1), edges[:-1], edges[1:]
    first, last = values[:-1], values[1:]
    for level in range(LEVELS_OF_HALVES):
        wrong = np.abs(last - first - integrals) > allowed * 0.5**level
        allowed = np.where(np.count_nonzero(wrong, axis=0) > MOST_HALVES, np.inf, allowed)
        split = np.any(wrong & np.isfinite(allowed), axis=1) & (level < LEVELS_OF_HALVES - 1)
        np.add.at(found, panel[~split], integrals[~split])
        if not split.any():
            break
        start, end, first, last = start[split], end[split], first[split], last[split]
        middle: Array = (start + end) / 2
        between = rates_at(function, middle)[:, :2]
        panel = np.tile(panel[split], 2)
        start, end = np.concatenate([start, middle]), np.concatenate([middle, end])
        first, last = np.concatenate([first, between]), np.concatenate([between, last])
        integrals = _integrals(function, start, end)
    return found


def _integrals(function: TimeFunction, start: Array, end: Array) -> Array:
    """Integrate first and second rate (panels, 2) by Gauss's rule."""
    half = (end - start) / 2
    times = (start + half)[:, None] + half[:, None] * NODES
    rates = rates_at(function, times.ravel()).reshape(*times.shape, 3)[..., 1:]
    return np.asarray(np.einsum("pgc,g,p->pc", rates, WEIGHTS, half))


def _slopes(function: TimeFunction, times: Array, h: float) -> Array:
    """Compute the central differences of the values."""
    return (rates_at(function, times + h) - rates_at(function, times - h)) / (2 * h)
