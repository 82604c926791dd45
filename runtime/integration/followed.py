"""Motions that are fully prescribed: a sequence of positions, without equations of motion to integrate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import PositionError
from flexel.integration.driver import DenseRun
from flexel.integration.events import Event
from flexel.integration.explicit import longest_step, turning_weights
from flexel.integration.outcome import Segment
from flexel.mechanics.core import Core
from flexel.mechanics.states import Moment, state_of
from flexel.structure.state import State

SHORTEST = 1e-6  # step, relative to the times, below which a position counts as unreachable
NOTHING: Array = np.zeros(0)


def _no_state(t: float) -> Array:
    """The dense output: a fully prescribed motion has no q, q_d' or z."""
    return NOTHING


class Followed(DenseRun):
    """One run of a fully prescribed motion; long steps are halved until the position is found."""

    def __init__(self, system: Core, start: State, times: Array, events: Sequence[Event]) -> None:
        super().__init__(system, start, times, events)
        self._weights = turning_weights(system.structure)
        self._step = np.inf

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        return {"steps": len(self.result.segments), "evaluations": 0, "rechoices": 0}

    def advance(self) -> str | None:
        """One step towards the next stored time."""
        system, last = self.system, self.state
        self._step = min(self._step, self.until - last.t, longest_step(last, self._weights))
        while True:
            t = min(last.t + self._step, self.until)
            here = Moment.of(last)
            ahead = replace(here, x=last.x + min(self._step, self.until - last.t) * last.v)
            try:
                state = state_of(system.kinematics, system.loads, t, NOTHING, NOTHING, last.z, ahead)
                break
            except PositionError:
                self._step /= 2
                if self._step < SHORTEST * self._span:
                    raise
        arrived = t >= self.until
        ended = self.accept(Segment(last.t, state.t, system.roles, _no_state, here, Moment.of(state)), state)
        if arrived:
            self._step = np.inf
        return ended

    def _at(self, step: Segment, last: State, t: float) -> State:
        return last if t == last.t else super()._at(step, last, t)
