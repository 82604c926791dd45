"""A step that carries a motion across a flat position: its path gives the states within it.

At the flat position the constraints do not determine the accelerations and the forces; on the way there rounding errors
of these grow without bound.  Close to it accelerations are those of the path, and forces are interpolated between both
sides.  Forces may have a pole there, which is then cut off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.integration.path import Path
from flexel.integration.segments import Pending, Stretch
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import between
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

CLOSE = (
    3e-3  # distance from the flat position where forces are interpolated, relative to the length of the path
)


@dataclass(frozen=True)
class Carried(Stretch):
    """A step across a flat position.

    Attributes
    ----------
    path : Path
        It may begin before the step.
    flat : float
        Time of the flat position [s].
    """

    path: Path
    flat: float

    @property
    def reach(self) -> float:
        """Distance [s] from the flat position where forces are interpolated."""
        return CLOSE * (self.path.t1 - self.path.t0)

    def pending(self, t: float) -> Pending:
        """Return the state at a time within the step."""
        found = self.on_path(t)
        close = abs(t - self.flat) < self.reach
        return Close(self.kinematics, self.shown, found.moment, found.z, self) if close else found

    def on_path(self, t: float) -> Pending:
        """Return the state of the path at a time, to be completed by the equations of motion."""
        if t == self.last.t:
            return self.end(self.path.at(t)[2])
        moment, z = moment_on(self.kinematics, self.path, t, between(self.first, self.last, t))
        return Pending(self.kinematics, self.shown, moment, z)


@dataclass(frozen=True)
class Close(Pending):
    """A state close to a flat position.

    Attributes
    ----------
    step : Carried
    """

    step: Carried

    def state(self) -> State:
        """Return the complete state."""
        step, at, kinematics = self.step, self.moment, self.kinematics
        before, after = step.flat - step.reach, step.flat + step.reach
        part = (at.t - before) / (after - before)
        states = [step.on_path(t).state() for t in (before, after)]
        given, stresses, reactions = (
            (1 - part) * getattr(states[0], name) + part * getattr(states[1], name)
            for name in ("given", "stresses", "reactions")
        )
        a = np.zeros_like(at.x)
        a[: kinematics.structure.nf] = step.path.accelerations(at.t)
        kinematics.given(at.t)
        work = kinematics.evaluation.at(at.t, at.x, at.v, a, self.z, at.e)
        work.laws()
        work.inertia()
        work.convective()
        return self.given(dynamics.state_in(kinematics, work, given, stresses, reactions))


def moment_on(kinematics: Kinematics, path: Path, t: float, guess: Snapshot) -> tuple[Snapshot, Array]:
    """Return the instant of a path at a time [s], turns counted from an instant nearby, and the internal states."""
    xf, vf, z = path.at(t)
    x, v = guess.x.copy(), guess.v.copy()
    x[: xf.size], v[: vf.size] = xf, vf
    work = kinematics.evaluation.work
    work.x[:], work.unwrap_from[:] = x, guess.turns(t)
    work.position()
    return Snapshot(t, x, v, work.e.copy(), work.jvp(v)[: work.e.size]), z
