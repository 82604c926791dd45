"""States within the steps of the generalized-alpha method: each step is taken again, up to the time that is asked for.

Positions and rates are those of the shorter step, so that conditions hold as exactly as at the ends of steps.  Its
accelerations and multipliers are not: every change of the length of steps disturbs them, the more the shorter it is.
They are interpolated between both ends.  Little is kept: a point every few steps, from which the others are taken
again.
"""

from __future__ import annotations

from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Mapping
from dataclasses import dataclass
from threading import Lock
from typing import Any, ClassVar

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.integration.alpha import AlphaStepper
from flexel.integration.balance import Balance
from flexel.integration.knots import Interval
from flexel.integration.segments import Segment
from flexel.model.state import State

SPACING = 32  # steps between two points that are kept: a point is as large as a stored state
FORCES = ("a", "mu")  # what a change of the length of steps disturbs
HALVINGS = 20  # of the way to a time that one step does not reach


@dataclass(frozen=True)
class StepEnd:
    """One end of a step.

    Attributes
    ----------
    t : float
        [s]
    places : dict of str to slice
        Where vectors of `Stepping.old` are among the numbers.
    numbers : ndarray
    """

    t: float
    places: dict[str, slice]
    numbers: Array

    @classmethod
    def of(cls, t: float, values: Mapping[str, Array]) -> StepEnd:
        """Copy vectors at a time [s]."""
        ends = np.cumsum([array.size for array in values.values()]).tolist()
        parts = zip(values, [0, *ends[:-1]], ends, strict=True)
        return cls(t, {name: slice(*part) for name, *part in parts}, np.concatenate(list(values.values())))

    @property
    def values(self) -> dict[str, Array]:
        """The vectors."""
        return {name: self.numbers[place] for name, place in self.places.items()}


class Replay:
    """Takes the steps of a motion again, in another workspace.

    Parameters
    ----------
    live : AlphaStepper
        That of the motion, of which the present step has not been accepted yet.
    """

    def __init__(self, live: AlphaStepper) -> None:
        self._arguments = live.arguments
        self._live: AlphaStepper | None = live
        self._ends = array("d")  # of the steps [s]
        self._points: dict[int, StepEnd] = {}  # at the starts of some of them
        self._intervals: dict[int, Interval] = {}  # of the functions of time, each from a step on
        self._interval: Interval | None = None  # the last of them
        self._due = True
        self._reset()

    def _reset(self) -> None:
        self._twin: AlphaStepper | None = None
        self._at: int | None = None  # number of the step at whose start the twin is
        self._ended: tuple[int, StepEnd] | None = None  # the last step of which the end was asked for
        self._lock = Lock()

    def __getstate__(self) -> dict[str, Any]:
        """Return what is needed to take the steps again."""
        kept = ("_arguments", "_ends", "_points", "_intervals", "_interval", "_due")
        return {name: getattr(self, name) for name in kept}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take the same."""
        self.__dict__.update(state)
        self._live = None
        self._reset()

    @property
    def number(self) -> int:
        """Number of the present step."""
        return len(self._ends)

    def step_at(self, t: float) -> int:
        """Return the number of the first accepted step that ends at a time [s] or later."""
        return bisect_left(self._ends, t)

    def part(self) -> None:
        """The present step does not begin where the last one ended: loads or rates have jumped."""
        self._due = True

    def add(self, t1: float, interval: Interval) -> None:
        """Add the present step before it is accepted, with its end [s] and the interval of its functions of time."""
        number = len(self._ends)
        if self._due or number % SPACING == 0:
            self._points[number] = StepEnd.of(self._living.t, self._living.stepping.old)
            self._due = False
        if interval is not self._interval:
            self._intervals[number] = self._interval = interval
        self._ends.append(t1)
        self._ended = None

    def state(self, number: int, t: float) -> State:
        """Return the state at a time [s] within a step."""
        with self._lock:
            twin, balance = self.balance(number, t)
            return twin.state(balance)

    def balance(self, number: int, t: float) -> tuple[AlphaStepper, Balance]:
        """Return the balance at a time [s] within a step, and the stepper whose workspace holds it.

        Raises
        ------
        DynamicsError
            If the step to that time is not found.
        """
        end = self._end(number)
        twin = self._begun(number)
        t0, start = twin.t, {name: twin.stepping.old[name].copy() for name in FORCES}
        if t <= t0:
            return twin, twin.current()
        self._reach(twin, t)
        part, found = (t - t0) / (end.t - t0), twin.stepping.now
        a, mu = ((1 - part) * start[name] + part * end.values[name] for name in FORCES)
        return twin, twin.balance_at(t, found | {"a": a, "mu": mu})

    def _end(self, number: int) -> StepEnd:
        """Return accelerations and multipliers at the end of a step."""
        if self._ended is None or self._ended[0] != number:
            if number == self.number:
                of, t = self._living, self._living.t + float(self._living.numbers.h)
            else:
                of, t = self._begun(number), self._ends[number]
                self._reach(of, t)
            self._ended = number, StepEnd.of(t, {name: of.stepping.now[name] for name in FORCES})
        return self._ended[1]

    def roughly(self, t: float) -> State:
        """Return a state near that at a time [s] within the present step, interpolated between its ends."""
        live, twin = self._living, self._other
        old, now, t0, h = live.stepping.old, live.stepping.now, live.t, float(live.numbers.h)
        part = (t - t0) / h
        mean = {name: (1 - part) * old[name] + part * now[name] for name in ("v", "a", "mu", "e", "z")}
        bend = part * (1 - part) * ((1 - part) * (h * old["v"]) - part * (h * now["v"]))
        weight = part * part * (3 - 2 * part)
        x = (1 - weight) * old["x"] + weight * now["x"] + bend
        with self._lock:
            self._at = None
            twin.inside = live.inside
            return twin.state(twin.balance_at(t, mean | {"x": x}))

    @property
    def _living(self) -> AlphaStepper:
        assert self._live is not None, "the motion has no present step"
        return self._live

    @property
    def _other(self) -> AlphaStepper:
        """The stepper that takes the steps again."""
        if self._twin is None:
            self._twin = AlphaStepper(*self._arguments)
        return self._twin

    def _begun(self, number: int) -> AlphaStepper:
        """Return the stepper at the start of a step."""
        twin = self._other
        if number == self.number:
            twin.follow(self._living)
            twin.inside = self._living.inside
            self._at = number
            return twin
        first = _last(self._points, number)
        if self._at is None or not first <= self._at <= number:
            point = self._points[first]
            twin.take(point.t, point.values)
            self._at = first
        while self._at < number:
            reached = self._at + 1
            twin.inside = self._interval_of(self._at).inside
            self._at = None  # if it fails
            self._reach(twin, self._ends[reached - 1])
            twin.accept(self._ends[reached - 1])
            self._at = reached
        twin.inside = self._interval_of(number).inside
        return twin

    def _interval_of(self, number: int) -> Interval:
        return self._intervals[_last(self._intervals, number)]

    def _reach(self, twin: AlphaStepper, t: float) -> None:
        """Find the point at a time, in one step or in shorter ones, as the end of a step that is not accepted."""
        rest = h = t - twin.t
        shortest = rest * 0.5**HALVINGS
        while not (found := twin.step(h)) or h < rest:
            if found:
                self._at = None  # no longer at the start
                twin.accept(twin.t + h)
                rest = h = t - twin.t
                continue
            h /= 2
            if h < shortest:
                raise DynamicsError(
                    f"the state at t = {t:g} s, within a step of the motion, is not found: the motion is not "
                    "smooth there; give it as one of the times to store"
                )


def _last(numbers: Mapping[int, object], number: int) -> int:
    """Return the last of some numbers, in increasing order, that is not above another."""
    known = list(numbers)
    return known[bisect_right(known, number) - 1]


@dataclass(frozen=True)
class Replayed(Segment):
    """A motion by the generalized-alpha method, or its present step, which has not been accepted yet.

    Attributes
    ----------
    replay : Replay
    """

    replay: Replay
    interpolates: ClassVar[bool] = False

    def state(self, t: float) -> State:
        """Return the complete state at a time [s] within it."""
        return self.replay.state(self.replay.step_at(t), t)

    def roughly(self, t: float) -> State:
        """Return a state near it, interpolated in the present step."""
        return self.replay.roughly(t)
