"""Motions that are fully prescribed: a sequence of positions, without equations of motion to integrate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import PositionError
from flexel.integration.driver import DenseRun
from flexel.integration.events import Event
from flexel.integration.segments import Step, Variables
from flexel.mechanics.states import located
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.model.structure import Structure
from flexel.system import CoreSystem

SHORTEST = 1e-6  # step, relative to the times, below which a position counts as unreachable
TRAVEL = (
    1.0  # change of an Euler parameter per step: more than two radians could lead to another branch or turn
)
NOTHING: Array = np.zeros(0)


def turning_weights(structure: Structure) -> Array:
    """Return weights (n,) that select coordinates of orientations: 1 for Euler parameters, 1/2 for planar angles."""
    weight = {"-": 1.0, "rad": 0.5}
    return np.array([weight.get(unit, 0.0) for unit in structure.units[structure.m + structure.k :]])


def longest_step(v: Array, a: Array, weights: Array) -> float:
    """Return the time [s] in which an orientation changes by TRAVEL, at the current rates and accelerations."""
    rate, change = (float(np.max(np.abs(values) * weights, initial=0.0)) for values in (v, a))
    return 2 * TRAVEL / max(rate + float(np.sqrt(rate * rate + 2 * change * TRAVEL)), 1e-300)


@dataclass(frozen=True)
class HeldStates(Variables):
    """Dense output of a fully prescribed motion: it has no q or q_d', and its internal states z (nz,) are constant."""

    z: Array

    def __call__(self, t: float) -> Array:
        """Return the internal states."""
        return self.z


class Followed(DenseRun):
    """One run of a fully prescribed motion; steps are halved until the position is found."""

    name = ""

    def __init__(self, system: CoreSystem, start: State, times: Array, events: Sequence[Event]) -> None:
        super().__init__(system, start, times, events)
        self._weights = turning_weights(system.structure)
        self._step = np.inf
        self._kinematics = system.kinematics_of(start.roles)
        self._a = start.a

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        return {"steps": len(self.result.segments), "evaluations": 0, "rechoices": 0}

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states."""
        self.z = z

    def advance(self) -> str | None:
        """Take one step towards the next stored time."""
        here = self.now
        until = min(self.until, self.stop)
        self._step = min(self._step, until - here.t, longest_step(here.v, self._a, self._weights))
        while True:
            t = min(here.t + self._step, until)
            ahead = replace(here, x=here.x + (t - here.t) * here.v)
            try:
                x, v, e = located(self._kinematics, t, NOTHING, NOTHING, ahead)
                break
            except PositionError:
                self._step /= 2
                if self._step < SHORTEST * self._span:
                    raise
        work = self._kinematics.evaluation.at(t, x, v, unwrap_from=e)
        there = Snapshot(t, x, v, e, work.w[: e.size].copy())
        self._a = (v - here.v) / (t - here.t)
        arrived = t >= until
        segment = Step(
            here.t,
            t,
            self._kinematics,
            self._kinematics,
            here,
            there,
            HeldStates(self._kinematics, here, there, self.z),
        )
        ended = self.accept(segment, self.z)
        if arrived:
            self._step = np.inf
        return ended
