"""Finds when the comparisons in a function of time change, its kinks and jumps, from the rates of the compared values.

A function that compares (``t > 7``, ``np.minimum(t, 1)``, ``abs(…)``) is smooth as long as no comparison changes.  The
jets that it is evaluated with give the difference of the two sides with its rates, and so the time at which it is zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from flexel.base.jets import Jet, watched

MAX_ITERATIONS = 8  # of Newton's method for a difference that is not linear in time
TIME_TOLERANCE = 1e-13  # last correction, relative to the time


def next_switch(function: Callable[[Any], Any], t: float) -> float:
    """Return the first time after t [s] at which a comparison in a function of time changes; infinite if none is found.

    The time is exact if both sides are linear in time.  Otherwise it is the zero to which Newton's method leads: it
    may be missed from a distance, and is found close by.
    """
    following = (_zero_after(function, t, i, d) for i, d in enumerate(_differences(function, t)))
    return min(following, default=math.inf)


def on_switch(function: Callable[[Any], Any], t: float, within: float) -> bool:
    """Whether a comparison in a function of time changes within a given time [s] of t."""
    return any(abs(d.value) <= within * abs(d.rate) for d in _differences(function, t))


def _differences(function: Callable[[Any], Any], t: float) -> list[Jet]:
    """Return the differences of the values that the function compares at time t."""
    with watched() as differences:
        function(Jet(t, 1.0, 0.0))
    return differences


def _zero_after(function: Callable[[Any], Any], t: float, i: int, d: Jet) -> float:
    """Return the zero of the i-th difference after time t, at which its jet is d."""
    step = _first_zero(d)
    if not math.isfinite(step) or d.acceleration == 0:
        return t + step
    at = t + step
    for _ in range(MAX_ITERATIONS):
        try:
            differences = _differences(function, at)
        except Exception:  # the function may be undefined there; the motion reports this if it gets there
            return math.inf
        if i >= len(differences) or not differences[i].rate:
            return math.inf
        correction = -differences[i].value / differences[i].rate
        at += correction
        if abs(correction) <= TIME_TOLERANCE * abs(at):
            return at if at > t else math.inf
    return math.inf


def _first_zero(d: Jet) -> float:
    """Return the time [s] until the parabola through a value with its rates is zero; infinite if it never is."""
    v, r, a = d.value, d.rate, d.acceleration
    if a == 0:
        zeros = [-v / r] if r else []
    else:
        root = r * r - 2 * a * v
        zeros = [] if root < 0 else [(-r + sign * math.sqrt(root)) / a for sign in (1, -1)]
    return min((step for step in zeros if step > 0 and math.isfinite(step)), default=math.inf)
