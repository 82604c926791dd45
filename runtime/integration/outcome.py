"""The result of an integration, and the times at which it is stored."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import array, number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.mechanics.states import Moment, between, state_of
from flexel.structure.roles import Roles
from flexel.structure.state import State


@dataclass(frozen=True)
class Segment:
    """A step with its choice of degrees of freedom, its dense output y(t) = (q, q_d', z) and its ends."""

    t0: float
    t1: float
    roles: Roles
    dense: Any
    first: Moment
    last: Moment

    def state(self, system: Any, t: float) -> State:
        """Complete state at a time within the step."""
        q, qd, z = np.split(self.dense(t), [self.roles.nq, self.roles.nq + self.roles.nd])
        near = between(self.first, self.last, t)
        return state_of(system.kinematics_of(self.roles), system.loads, t, q, qd, z, near)


@dataclass(frozen=True)
class Integration:
    """Result of an integration: states at the requested times, events, pieces with dense output, counts.

    An implicit one also gives its energy ledger at these times.
    """

    states: list[State]
    events: list[tuple[str, State]]
    segments: list[Segment]
    statistics: dict[str, int]
    message: str
    ledger: dict[str, list[float]] | None = None


def stored_times(start: State, duration: Any, times: Any, samples: Any, owner: str) -> Array:
    """Times at which states are stored, from the start on.

    Parameters
    ----------
    start : State
    duration : float
        Length of the motion [s].
    times : array_like or None
        The times [s]; None for equidistant ones.
    samples : int
        Number of these.
    owner : str
        Caller named in error messages.

    Raises
    ------
    ModelError
        A duration that is not positive, times that do not increase or lie outside the motion.
    """
    span = number(duration, owner, "duration")
    if span <= 0:
        raise ModelError(f"{owner}: duration {span:g} s is not positive; give a positive time")
    if times is None:
        if not isinstance(samples, (int, np.integer)) or samples < 2:
            raise ModelError(f"{owner}: {samples!r} samples requested; give a whole number, 2 or more")
        return np.linspace(start.t, start.t + span, int(samples))
    grid = array(times, owner, "times")
    if grid.ndim != 1 or not grid.size or np.any(np.diff(grid) <= 0) or grid[0] < start.t:
        raise ModelError(f"{owner}: times must be a list that increases from {start.t:g} s; sort them")
    if grid[-1] > start.t + span * (1 + 1e-12):
        raise ModelError(
            f"{owner}: time {grid[-1]:g} s lies after the end of the motion, {start.t + span:g} s; lengthen the "
            "duration"
        )
    return np.concatenate([[start.t], grid]) if grid[0] > start.t else grid
