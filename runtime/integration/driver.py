"""The driver of all integrations: steps until the end, progress bar, interruption, and stored states."""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tqdm import tqdm

from flexel.base.arrays import Array
from flexel.integration.events import Event, passages, value
from flexel.integration.outcome import Integration, Segment
from flexel.structure.state import State

BAR = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"


class Run(ABC):
    """A motion being integrated over given times, by any method.

    Attributes
    ----------
    times : ndarray (nt,)
        Times at which states are stored.
    result : Integration
        The results stored so far.
    """

    def __init__(self, start: State, times: Array) -> None:
        self.times = times
        self.result = Integration([start], [], [], {}, "")

    @property
    @abstractmethod
    def t(self) -> float:
        """Current time of the motion."""

    @property
    @abstractmethod
    def statistics(self) -> dict[str, int]:
        """Counts of operations."""

    @abstractmethod
    def begin(self) -> None:
        """Prepare the first step."""

    @abstractmethod
    def advance(self) -> str | None:
        """Take one step; returns a message if the motion ends with it.

        Raises
        ------
        FlexelError
            If the motion cannot be continued.
        """

    @abstractmethod
    def keep(self) -> None:
        """Store the current state, unless it is already stored."""

    @property
    def until(self) -> float:
        """The next time at which a state is stored."""
        return float(self.times[len(self.result.states)])

    def run(self, progress: bool | None) -> Integration:
        """Integrate to the last time; an interrupt (Ctrl-C) keeps what was computed.

        Parameters
        ----------
        progress : bool, optional
            Progress bar on stderr; by default where stderr is a terminal.
        """
        self.begin()
        begin, end = float(self.times[0]), float(self.times[-1])
        show = sys.stderr.isatty() if progress is None else progress
        message: str | None = None
        bar = tqdm(total=end - begin, disable=not show, unit="s", leave=False, bar_format=BAR)
        try:
            while self.t < end and message is None:
                message = self.advance()
                bar.update(self.t - begin - float(bar.n))
        except KeyboardInterrupt:
            self.keep()
            message = f"interrupted at t = {self.result.states[-1].t:g} s; the motion up to there is kept"
        finally:
            bar.close()
        return self.kept(message or "reached the end")

    def kept(self, message: str) -> Integration:
        """The results so far, up to the last step or the event that ended it."""
        self.keep()
        return replace(self.result, message=message, statistics=self.statistics)


class DenseRun(Run):
    """A motion with dense output, in which events can be located.

    Attributes
    ----------
    state : State
        Current state.
    """

    def __init__(self, system: Any, start: State, times: Array, events: Sequence[Event]) -> None:
        super().__init__(start, times)
        self.system, self.state, self.events = system, start, events
        self._values: list[float] = []
        self._span = float(times[-1] - times[0])

    def begin(self) -> None:
        """Evaluate the functions of the events."""
        self._values = [value(event, self.state) for event in self.events]

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self.state.t

    def keep(self) -> None:
        """Store the current state, unless it is already stored."""
        if self.t > self.result.states[-1].t:
            self.result.states.append(self.state)

    def accept(self, step: Segment, state: State) -> str | None:
        """Continue from the end of a step, or end at a terminal event within it and return its message."""
        times = float(self.times[0]), self._span
        found, self._values = passages(self.system, self.events, step, state, self._values, times)
        terminal = next((z for z in found if z[0].terminal), None)
        end = terminal[1].t if terminal else step.t1
        self._store(step, state, end)
        self.result.events.extend((event.name, z) for event, z in found if z.t <= end)
        self.result.segments.append(replace(step, t1=end))
        self.state = terminal[1] if terminal else state
        return f"stopped by event '{terminal[0].name}'" if terminal else None

    def _store(self, step: Segment, last: State, end: float) -> None:
        """Store the states at the times passed by the step."""
        states = self.result.states
        while len(states) < self.times.size and self.until <= end:
            states.append(self._at(step, last, self.until))

    def _at(self, step: Segment, last: State, t: float) -> State:
        return step.state(self.system, t)
