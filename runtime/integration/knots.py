"""Knots of prescribed motions, loads and laws: times at which they are not smooth, where every step ends.

Within a step they are evaluated strictly between two knots, so that a jump is never seen from the wrong side.  At a
knot, forces that jump change the accelerations, and prescribed rates that jump change the rates by an impulse.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.base.time_functions import TimeFunction, next_knot, on_knot, value_of
from flexel.model.state import State
from flexel.system import CoreSystem

ASIDE = 1e-14  # distance from a knot at which a function is evaluated, relative to the times
JUMP = 1e-9  # relative change across a knot that counts as a jump
OTHER = (
    0.01  # relative difference of a prescribed rate at a start that is more than the error of another motion
)
MOST_KNOTS = 1000  # of one function that are looked for at once
SMOOTH, FORCES, RATES = "smooth", "forces", "rates"  # what jumps at a knot


@dataclass(frozen=True)
class KnownKnots:
    """Knots whose times are known: those of a law, whose stress is continuous there, or jumps that were looked for.

    Attributes
    ----------
    times : ndarray
        [s], increasing.
    """

    times: Array

    def next_knot(self, t: float) -> float:
        """Return the first knot after time t [s]; infinite if there is none."""
        later = self.times[self.times > t]
        return float(later[0]) if later.size else np.inf

    def on_knot(self, t: float, within: float) -> bool:
        """Whether there is a knot within a given time [s] of t."""
        return bool((np.abs(self.times - t) <= within).any())


@dataclass(frozen=True)
class Interval:
    """A stretch of time between two knots, in which functions of time are smooth.

    Attributes
    ----------
    first, last : float
        The first and the last time [s] at which they are evaluated, just inside; infinite where there is no knot.
    """

    first: float = -np.inf
    last: float = np.inf

    def inside(self, t: float) -> float:
        """Return the time, or the nearest one within the interval."""
        return min(max(t, self.first), self.last)

    def rates(self, function: TimeFunction, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at a time [s], from those at the nearest one within the interval.

        Without that step of a series, positions and rates at knots would differ from those beside them, by more than
        tight tolerances allow.
        """
        inside = self.inside(t)
        u, ud, udd = function.rates(inside)
        return (u, ud, udd) if t == inside else (u + (t - inside) * ud, ud + (t - inside) * udd, udd)


class Knots:
    """The knots of one motion, from the present step on.

    Parameters
    ----------
    system : CoreSystem
    begin, end : float
        Times of the motion [s].
    jumps : ndarray, optional
        Times [s] at which functions jump that say nothing of it.

    Attributes
    ----------
    end : float
        The next knot [s]; infinite if there is none.
    interval : Interval
        The present one.
    """

    def __init__(self, system: CoreSystem, begin: float, end: float, jumps: Array | None = None) -> None:
        self._names = [system.structure.names[i] for i in system.roles.prescribed]
        self._prescribed = system.roles.prescribed
        self._motions, self._loads = system.roles.motions, system.loads.functions
        known = [np.array(law.knots) for law in system.structure.laws]
        self._functions: list[object] = [
            *(f for f in (*self._motions, *self._loads) if hasattr(f, "next_knot")),
            *(KnownKnots(times) for times in (*known, jumps) if times is not None and times.size),
        ]
        self._size = max(abs(begin), abs(end))
        self.end, self.interval = np.inf, Interval()
        if any(on_knot(f, begin, self._aside(begin)) for f in self._functions):
            self.interval = Interval(begin + self._aside(begin))

    def _aside(self, t: float) -> float:
        """Return the distance [s] from a knot at which functions are evaluated."""
        return ASIDE * max(abs(t), self._size)

    def near(self, t: float, knot: float) -> bool:
        """Whether a time is that of a knot, but for rounding: functions are evaluated further aside."""
        return abs(t - knot) <= self._aside(t) / 2

    @property
    def any(self) -> bool:
        """Whether there are functions that may have knots."""
        return bool(self._functions)

    def inside(self, t: float) -> float:
        """Return the time, or one just inside the present interval between knots if it is at its end or beyond."""
        return self.interval.inside(t)

    def look(self, t: float) -> None:
        """Find the next knot after a time within the present interval."""
        self._look(max(t, self.interval.first), self.interval.first)

    def _look(self, t: float, first: float) -> None:
        """Find the next knot after a time, in an interval that is entered at another."""
        end = min(next_knot(f, t) for f in self._functions)
        if end != self.end or first != self.interval.first:
            self.end = end
            self.interval = Interval(first, end if end == np.inf else end - self._aside(end))

    def jumps_at(self, state: State) -> bool:
        """Whether prescribed rates differ from those of the state in which a motion starts."""
        if not self._motions:
            return False
        found = np.concatenate([state.rates, state.v])[self._prescribed]
        wanted = [float(f.rates(self.inside(state.t))[1]) for f in self._motions]
        return any(_differ(before, after) for before, after in zip(found.tolist(), wanted, strict=True))

    def cross(self, t: float) -> str:
        """Enter the interval after the knot at t; return what jumps there.

        Raises
        ------
        DynamicsError
            If a prescribed quantity itself jumps; names it.
        """
        before, after = t - self._aside(t), t + self._aside(t)
        motions = [(_rates(f, before), _rates(f, after)) for f in self._motions]
        for name, (left, right) in zip(self._names, motions, strict=True):
            if _jumps(left[0], right[0]):
                raise DynamicsError(
                    f"'{name}' is prescribed to jump from {left[0]:.6g} to {right[0]:.6g} at t = {t:.9g} s, which "
                    "requires an infinite force; let it move within a finite time, for example by fx.Ramp"
                )
        loads = [(value_of(f, before), value_of(f, after)) for f in self._loads]
        self._look(after, after)
        if any(_jumps(left[1], right[1]) for left, right in motions):
            return RATES
        forces = any(_jumps(left, right) for left, right in loads)
        return FORCES if forces or any(_jumps(left[2], right[2]) for left, right in motions) else SMOOTH


def _rates(function: TimeFunction, t: float) -> Array:
    return np.array(function.rates(t))


def _differ(before: float, after: float) -> bool:
    """Whether rates at a start are those of another motion."""
    return _jumps(before, after) and abs(after - before) > OTHER * max(abs(before), abs(after))


def _jumps(before: float, after: float) -> bool:
    return bool(abs(after - before) > JUMP * max(1.0, abs(before), abs(after)))
