"""Motions that are fully prescribed: a sequence of positions, without equations of motion to integrate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import PositionError
from flexel.integration.carried import Carried
from flexel.integration.dense_run import DenseRun
from flexel.integration.dips import Dips
from flexel.integration.events import Event
from flexel.integration.segments import Step, Variables
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import located
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.model.structure import Structure
from flexel.system import CoreSystem

SHORTEST = 1e-6  # step, relative to the times, below which a position counts as unreachable
SHORT = 0.2  # change of a coordinate per step, in natural scales: a flat position must not be stepped over
# How much longer steps may be while the logarithm of the determinant, to base two, changes by so little in each, and
# by how much it may change in a longer one.
LENGTHENED, GENTLE, SUDDEN = 8.0, 0.2, 0.5
EXACT = 1e-11  # error of a path across one, in natural scales
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
    """One run of a fully prescribed motion; steps are halved until the position is found.

    At a flat position the constraints leave a choice of branches; see across.py.
    """

    name = ""
    timed = True
    exactness = EXACT

    def __init__(self, system: CoreSystem, start: State, times: Array, events: Sequence[Event]) -> None:
        super().__init__(system, start, times, events)
        self._weights = turning_weights(system.structure)
        self._step = np.inf
        self._kinematics = system.kinematics_of(start.roles)
        self._a = start.a
        self._dips, self._uncertain = Dips(), list[float]()
        self._longer, self._size = 1.0, np.nan

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        return {"steps": len(self.result.segments), "evaluations": 0, "rechoices": 0}

    @property
    def kinematics(self) -> Kinematics:
        """The only choice of degrees of freedom: none."""
        return self._kinematics

    def dangers(self) -> list[str]:
        """Describe a flat position that could not be crossed smoothly."""
        if not self._uncertain:
            return []
        return [
            f"the position is singular near t = {self._uncertain[0]:.6g} s, where the prescribed motions leave a "
            "choice of branches, and the mechanism does not go on smoothly from there: it may be on another branch "
            "afterwards; prescribe it otherwise, or end the motion earlier"
        ]

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states."""
        self.z = z

    def advance(self) -> str | None:
        """Take one step towards the next stored time."""
        here, until, kinematics = self.now, min(self.until, self.stop), self._kinematics
        try:
            there, change = self._next(here, until)
        except PositionError:
            if steps := self.across(here.t + self._step, at_once=True):
                return self._carry(steps)
            raise
        flat = self._dips.passed(kinematics, here, there, kinematics.choice)
        if flat is not None:
            if steps := self.across(flat):
                return self._carry(steps)
            self._uncertain.append(flat)
        wanted = self._longer * GENTLE / max(change, 1e-300)
        self._longer = min(max(wanted, 1.0), LENGTHENED) if np.isfinite(change) else 1.0
        self._size, self._a = self._dips.struct.size, (there.v - here.v) / (there.t - here.t)
        dense = HeldStates(kinematics, here, there, self.z)
        ended = self.accept(Step(here.t, there.t, kinematics, kinematics, here, there, dense), self.z)
        if there.t >= until:
            self._step = np.inf
        return ended

    def _next(self, here: Snapshot, until: float) -> tuple[Snapshot, float]:
        """Return the end of the next step, and how much the logarithm of the determinant changes in it.

        Raises
        ------
        PositionError
            If the shortest step leads to no position.
        """
        kinematics, weight = self._kinematics, self._kinematics.lists.step_weight
        fastest = float(np.max(np.abs(here.v[: weight.size]) * weight, initial=0.0))
        short, longest = SHORT / max(fastest, 1e-300), longest_step(here.v, self._a, self._weights)
        self._step = min(self._step, until - here.t, longest, self._longer * short)
        while True:
            t = min(here.t + self._step, until)
            ahead = replace(here, x=here.x + (t - here.t) * here.v)
            try:
                x, v, e = located(kinematics, t, NOTHING, NOTHING, ahead)
            except PositionError:
                self._step /= 2
                if self._step < SHORTEST * self._span:
                    raise
                continue
            change = abs(kinematics.choice.determinant - self._size)
            if not change > SUDDEN or self._longer == 1.0:
                work = kinematics.evaluation.at(t, x, v, unwrap_from=e)
                return Snapshot(t, x, v, e, work.w[: e.size].copy()), change
            self._longer, self._step = 1.0, min(self._step, short)

    def _carry(self, steps: list[Carried]) -> str | None:
        """Take steps across a flat position, and continue on the other side."""
        ended = self.accept_carried(steps)
        self._step, self._a = np.inf, np.zeros_like(self._a)
        self._longer, self._size = 1.0, np.nan
        self._dips.forget()
        self._uncertain = [t for t in self._uncertain if t < steps[0].path.t0]
        return ended
