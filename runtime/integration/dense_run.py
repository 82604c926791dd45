"""A motion in minimal coordinates, whose steps have a dense output: its steps, and passages of flat positions."""

from __future__ import annotations

import logging
from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np

from flexel.base.arrays import Array
from flexel.base.time_functions import calls_user
from flexel.integration.across import Crossing
from flexel.integration.carried import Carried
from flexel.integration.driver import Run, ended_by
from flexel.integration.events import Event, value
from flexel.integration.outcome import Integration
from flexel.integration.passed import Passages
from flexel.integration.segments import Pending, Stretch
from flexel.mechanics.impulse import struck
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

log = logging.getLogger("flexel.simulate")
LONGEST_PAUSE = 1024  # steps without another trial to cross a flat position


class DenseRun(Run):
    """A motion in minimal coordinates, whose steps have a dense output.

    Attributes
    ----------
    now : Snapshot
        The current point of the motion.
    """

    def __init__(self, system: Any, start: State, times: Array, events: Sequence[Event]) -> None:
        super().__init__(system, start, times, events)
        self.system = system
        self.now, self.z = Snapshot.of(start), start.z
        self._shown: Kinematics = system.kinematics_of(start.roles)
        # what the user's functions give later may be something else: states are then completed at once
        self._at_once = bool(self._callbacks) or any(map(calls_user, self._shown.time_functions))
        self._pause, self._next_crossing = 1, 0  # steps

    def run(self, progress: bool | None, each: Callable[[Run], None] | None = None) -> Integration:
        """Run as all methods do; a motion of zero length is its start, and no step is prepared."""
        return super().run(progress, each) if self._span else self.kept("reached the end")

    def begin(self) -> None:
        """Prepare nothing."""

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self.now.t

    @property
    def stretches(self) -> list[Stretch]:
        """The steps so far."""
        return cast("list[Stretch]", self.result.segments)

    @property
    def step(self) -> float | None:
        """The length of the last step [s]."""
        return self.stretches[-1].t1 - self.stretches[-1].t0 if self.stretches else None

    @property
    def instant(self) -> tuple[Snapshot, Array]:
        """Coordinates, rates and deformations at the current time, and internal states of laws."""
        return self.now, self.z

    @property
    def present(self) -> State:
        """The complete state at the current time."""
        return self._pending().state()

    def _pending(self) -> Pending:
        """Return the state at the current time, to be completed in the degrees of freedom of the last step."""
        steps = self.stretches
        return Pending(steps[-1].kinematics if steps else self._shown, self._shown, self.now, self.z)

    def keep(self) -> None:
        """Store the current state, unless it is already stored."""
        if self.t > self.result.states.end:
            self.result.states.append(self._pending())

    def strike(self) -> None:
        """Continue from here with the rates just after an impulse."""
        super().strike()
        self.now = struck(self._shown, self.now, self.knots.inside(self.t))

    def passages(self) -> Passages:
        """Return the contacts that were passed within steps."""
        self.passed.look((step.first, step.last) for step in self.stretches)
        return self.passed

    def rewind(self, now: Snapshot, z: Array) -> None:
        """Continue from an earlier instant, with what was stored since then dropped."""
        result, steps = self.result, self.stretches
        while steps and steps[-1].t0 >= now.t:
            steps.pop()
        if steps and steps[-1].t1 > now.t:
            steps[-1] = replace(steps[-1], t1=now.t)
        result.cut(int(np.searchsorted(result.states.times, now.t, side="right")))
        result.events[:] = [found for found in result.events if found[1].t <= now.t]
        self.now, self.z = now, z
        state = self.present
        self._looks.back(now.t, [value(event, state) for event in self.events])

    @property
    @abstractmethod
    def kinematics(self) -> Kinematics:
        """The present degrees of freedom."""

    @property
    @abstractmethod
    def timed(self) -> bool:
        """Whether anything depends on time itself: a prescribed motion, a load, a law, a sampled controller."""

    @property
    @abstractmethod
    def exactness(self) -> float:
        """Error of a path across a flat position, in natural scales."""

    def across(self, flat: float, *, at_once: bool = False) -> list[Carried]:
        """Carry the motion across a flat position near a time [s]; return no steps if that is impossible.

        After each failure in a row it is tried after twice as many steps, but at once if asked.
        """
        if self.taken < self._next_crossing and not at_once:
            return []
        until, shown = self.stop if self.timed else np.inf, self._shown
        start = self.stretches, self.now, self.z, self.smooth_since
        crossing = Crossing(*start, self.stop, until, self.kinematics, shown, self.knots, self.exactness)
        found = crossing.steps(flat)
        self._pause = 1 if found else min(2 * self._pause, LONGEST_PAUSE)
        self._next_crossing = 0 if found else self.taken + self._pause
        self.evaluated(crossing.evaluations)
        return found

    def evaluated(self, evaluations: int) -> None:
        """Count evaluations."""

    def accept_carried(self, steps: list[Carried]) -> str | None:
        """Take steps across a flat position; return a message as `accept` does.

        Those that came too close to it are dropped.
        """
        log.info("t = %.9g s: carried across a flat position at %.9g s", steps[-1].t1, steps[0].flat)
        if steps[0].t0 < self.t:
            self.rewind(steps[0].first, steps[0].path.at(steps[0].t0)[2])
        ended = None
        for step in steps:
            ended = self.accept(step, step.path.at(step.t1)[2])
            if ended is not None:
                break
        return ended

    def accept(self, step: Stretch, z: Array) -> str | None:
        """Continue from the end of a step, or end at a terminal event within it and return its message."""
        terminal = self.report_events(step, lambda: step.end(z).state())
        end = terminal[1].t if terminal else step.t1
        self._store(step, end, z)
        self.result.segments.append(replace(step, t1=end) if terminal else step)
        self.now, self.z, self._shown = step.last, z, step.shown
        if terminal:
            self.now, self.z = Snapshot.of(terminal[1]), terminal[1].z
            return ended_by(terminal[0])
        return None

    def _store(self, step: Stretch, end: float, z: Array) -> None:
        """Store the states at the times passed by the step, at whose end the internal states are z."""
        states = self.result.states
        while self.more_times and self.until <= end:
            at_end = self.until == step.last.t
            found = step.end(z) if at_end else step.pending(self.until)
            states.append(found.state() if self._at_once else found)
