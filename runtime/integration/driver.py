"""The driver of all integrations: steps until the end, a progress bar, interruption, and what is kept."""

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
    """A motion on its way through given times, by any method.

    Attributes
    ----------
    times : ndarray (nt,)
        At which states are kept.
    result : Integration
        What has been kept.
    """

    def __init__(self, start: State, times: Array) -> None:
        self.times = times
        self.result = Integration([start], [], [], {}, "")

    @property
    @abstractmethod
    def t(self) -> float:
        """How far the motion has come."""

    @property
    @abstractmethod
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""

    @abstractmethod
    def begin(self) -> None:
        """Do what comes before the first step."""

    @abstractmethod
    def advance(self) -> str | None:
        """Take one step; a message where the motion is to end with it.

        Raises
        ------
        FlexelError
            If the motion cannot go on.
        """

    @abstractmethod
    def keep(self) -> None:
        """Keep the present state, unless it is kept already."""

    @property
    def until(self) -> float:
        """The next time at which a state is to be kept."""
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
        """What has been computed, up to the last step or the event that ended it."""
        self.keep()
        return replace(self.result, message=message, statistics=self.statistics)


class DenseRun(Run):
    """A motion with dense output, in which events can be located.

    Attributes
    ----------
    state : State
        Where it stands.
    """

    def __init__(self, system: Any, start: State, times: Array, events: Sequence[Event]) -> None:
        super().__init__(start, times)
        self.system, self.state, self.events = system, start, events
        self._values: list[float] = []
        self._span = float(times[-1] - times[0])

    def begin(self) -> None:
        """Look where the functions of the events stand."""
        self._values = [value(event, self.state) for event in self.events]

    @property
    def t(self) -> float:
        """How far the motion has come."""
        return self.state.t

    def keep(self) -> None:
        """Keep the present state, unless it is kept already."""
        if self.t > self.result.states[-1].t:
            self.result.states.append(self.state)

    def accept(self, step: Segment, state: State) -> str | None:
        """Go on from the end of a step, or end at a terminal event within it: then its message."""
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
        """Keep the states at the times that the step has passed."""
        states = self.result.states
        while len(states) < self.times.size and self.until <= end:
            states.append(self._at(step, last, self.until))

    def _at(self, step: Segment, last: State, t: float) -> State:
        return step.state(self.system, t)
