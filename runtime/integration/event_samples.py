"""The functions of events at the ends of steps: how much they change, and what contradicts what was reported.

Contradictions are looked for at the stored states, and inside steps where a function may jump.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.integration.events import Event, value
from flexel.integration.outcome import States
from flexel.integration.segments import Segment
from flexel.model.state import State

STORED = 200  # stored states that are looked at, evenly spread
EVERY, MOST = 20, 1000  # looks in a step, and in a motion, at a function that seems to jump
FEWEST = 4  # values that must be the same for that
PAST = 3  # steps, besides the present one, whose changes show how much a function can change


@dataclass(frozen=True)
class EventSample:
    """A value of an event's function that contradicts what was reported.

    Attributes
    ----------
    event : str
    t : float
        [s]
    value : float
    """

    event: str
    t: float
    value: float

    def __str__(self) -> str:
        return (
            f"event '{self.event}' was missed: its function is {self.value:.3g} at t = {self.t:.6g} s and has "
            "the opposite sign around it; give a function that changes gradually, such as a distance, or a max_step "
            "shorter than the passage"
        )


class EventSamples:
    """The event functions at the ends of steps, how fast they change, and what contradicts their signs.

    Between the ends of a step a function has the sign of its beginning, and changes it at each event that was reported
    there.  Where only one direction is reported and the signs of the ends differ, it is not known when it changes.

    Parameters
    ----------
    events : sequence of Event
    t : float
        Start of the motion [s].
    values : sequence of float
        The functions there.
    """

    def __init__(self, events: Sequence[Event], t: float, values: Sequence[float]) -> None:
        self._events, self._times, self._values = events, [t], [list(values)]
        self._reported: list[list[float]] = [[] for _ in events]
        self._slopes: list[deque[float]] = [deque(maxlen=PAST) for _ in events]

    @property
    def values(self) -> list[float]:
        """The functions at the end of the last step."""
        return self._values[-1]

    def forget(self) -> None:
        """Forget how fast the functions changed: rates jump here, or a contact begins."""
        for own in self._slopes:
            own.clear()

    def back(self, t: float, values: Sequence[float]) -> None:
        """Return to an earlier time [s], where the functions have these values."""
        kept = bisect_left(self._times, t)
        self._times[kept:], self._values[kept:] = [t], [list(values)]
        self._reported = [[time for time in own if time <= t] for own in self._reported]
        self.forget()

    def travel(self, number: int, t: float, value: float) -> float:
        """Return how much a function can change up to a time [s], where it has this value, as fast as it did lately.

        It is infinite where too few steps are known, and where the function has been constant: it may jump.
        """
        slopes = self._slopes[number]
        if len(slopes) < PAST:
            return np.inf
        return max(abs(value - self._values[-1][number]), max(slopes) * (t - self._times[-1])) or np.inf

    def starts_at(self, number: int, t: float) -> None:
        """Note that the motion starts at an event, found at a time [s], that is not reported again."""
        self._reported[number].append(max(t, float(np.nextafter(self._times[-1], np.inf))))

    def note(self, t: float, values: Sequence[float], found: Sequence[tuple[Event, State]]) -> None:
        """Keep the functions at the end of a step, and the events that were found in it, in the order of time."""
        for own, before, after in zip(self._slopes, self._values[-1], values, strict=True):
            own.append(abs(after - before) / (t - self._times[-1]))
        self._times.append(t)
        self._values.append(list(values))
        for number, event in enumerate(self._events):
            self._reported[number] += [state.t for one, state in found if one is event]

    def contradictions(self, states: States, segments: Sequence[Segment]) -> Iterator[EventSample]:
        """Yield the first contradiction of each event, at the stored states or between them.

        Parameters
        ----------
        states : States
        segments : sequence of Segment
            The steps.
        """
        stored = states.times
        some = np.unique(np.linspace(0, len(stored) - 1, min(STORED, len(stored))).astype(int))
        for number in range(len(self._events)):
            look = self._first(number, [stored[i] for i in some], lambda k: states[int(some[k])])
            if look is None and segments and self._jumps(number):
                look = self._inside(number, segments)
            if look is not None:
                yield look

    def _first(
        self, number: int, times: Sequence[float], state: Callable[[int], State]
    ) -> EventSample | None:
        """Return the first of some times at which a function does not have the expected sign."""
        for k, t in enumerate(times):
            sign = self._expected(number, t)
            if sign:
                found = value(self._events[number], state(k))
                if found * sign < 0:
                    return EventSample(self._events[number].name, t, found)
        return None

    def _expected(self, number: int, t: float) -> float:
        """Return the sign of a function at a time within a step; zero if it is not known."""
        i = bisect_left(self._times, t)
        if i == 0 or i == len(self._times) or t == self._times[i]:
            return 0.0
        begin, end = self._times[i - 1], self._times[i]
        before, after = (float(np.sign(self._values[k][number])) for k in (i - 1, i))
        inside = [time for time in self._reported[number] if begin < time <= end]
        if any(abs(time - t) < 1e-3 * (end - begin) for time in inside) or not before or not after:
            return 0.0
        if self._events[number].direction and (inside or before != after):
            return 0.0
        return before * (-1.0) ** sum(time < t for time in inside)

    def _jumps(self, number: int) -> bool:
        """Whether a function has had no values but one number and its opposite: as if it jumped between them."""
        sizes = {abs(row[number]) for row in self._values}
        return len(sizes) == 1 and len(self._values) >= FEWEST and sizes != {0.0}

    def _inside(self, number: int, segments: Sequence[Segment]) -> EventSample | None:
        begin, end = segments[0].t0, segments[-1].t1
        count = min(EVERY * (len(self._times) - 1), MOST)
        times = (begin + (end - begin) * (np.arange(count) + 0.5) / count).tolist()
        ends = [step.t1 for step in segments]
        return self._first(number, times, lambda k: segments[bisect_left(ends, times[k])].state(times[k]))
