"""Steps of a motion: their degrees of freedom, their ends, and the states within them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from typing import ClassVar

from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import between, located
from flexel.model.snapshot import Snapshot
from flexel.model.state import State


@dataclass(frozen=True)
class Pending:
    """A state that is known by its coordinates and rates, and completed on demand.

    Attributes
    ----------
    kinematics : Kinematics
        The degrees of freedom of the step that led to it, which are far from a singular position there.
    shown : Kinematics
        Those in which it is given.
    moment : Snapshot
        Coordinates, rates and deformations with their turns.
    z : ndarray (nz,)
        Internal states of laws.
    """

    kinematics: Kinematics
    shown: Kinematics
    moment: Snapshot
    z: Array

    @property
    def t(self) -> float:
        """Time [s]."""
        return self.moment.t

    def state(self) -> State:
        """Return the complete state."""
        at = self.moment
        return self.given(dynamics.complete(self.kinematics, at.t, at.x, at.v, at.e, self.z))

    def given(self, state: State) -> State:
        """Return a state of the step's degrees of freedom with those in which it is given: all else is the same."""
        return state if self.shown is self.kinematics else replace(state, roles=self.shown.roles)


@dataclass(frozen=True)
class Segment(ABC):
    """A stretch of a motion.

    Attributes
    ----------
    t0, t1 : float
        Its ends [s].
    kinematics : Kinematics
        The degrees of freedom of the step.
    """

    t0: float
    t1: float
    kinematics: Kinematics
    interpolates: ClassVar[bool] = True  # whether a state within it costs little

    @abstractmethod
    def state(self, t: float) -> State:
        """Return the complete state at a time [s] within it."""

    def roughly(self, t: float) -> State:
        """Return the same, or a state near it, where that takes fewer evaluations."""
        return self.state(t)


@dataclass(frozen=True)
class Stretch(Segment):
    """A stretch of a motion in minimal coordinates, with its ends.

    Attributes
    ----------
    shown : Kinematics
        The degrees of freedom in which its states are given.
    first, last : Snapshot
    """

    shown: Kinematics
    first: Snapshot
    last: Snapshot

    @abstractmethod
    def pending(self, t: float) -> Pending:
        """Return the state at a time within it, not yet completed."""

    def end(self, z: Array) -> Pending:
        """Return the state at its end, where the internal states are z (nz,)."""
        return Pending(self.kinematics, self.shown, self.last, z)

    def state(self, t: float) -> State:
        """Return the complete state at a time within it."""
        return self.pending(t).state()


@dataclass(frozen=True, eq=False)
class DenseOutput(Portable, ABC):
    """Dense output of a step.

    Attributes
    ----------
    kinematics : Kinematics
        The degrees of freedom of the step.
    first, last : Snapshot
        Its ends.
    """

    kinematics: Kinematics
    first: Snapshot
    last: Snapshot

    @abstractmethod
    def moment(self, t: float) -> tuple[Snapshot, Array]:
        """Return the instant at a time [s] in the step, and the internal states (nz,)."""

    def near(self, t: float) -> tuple[Snapshot, Array]:
        """Return the same, less exactly where that needs fewer evaluations."""
        return self.moment(t)


@dataclass(frozen=True)
class Step(Stretch):
    """A step of an integration, with its dense output."""

    dense: DenseOutput

    def pending(self, t: float) -> Pending:
        """Return the state at a time within the step, not yet completed."""
        return Pending(self.kinematics, self.shown, *self.dense.moment(t))

    def roughly(self, t: float) -> State:
        """Return a state near that at a time within the step."""
        return Pending(self.kinematics, self.shown, *self.dense.near(t)).state()


@dataclass(frozen=True)
class Variables(DenseOutput):
    """Dense output that gives y(t) = (q, q_d', z), from which the coordinates are found."""

    @abstractmethod
    def __call__(self, t: float) -> Array:
        """Return y (ny,) at a time [s] in the step."""

    def moment(self, t: float) -> tuple[Snapshot, Array]:
        """Return the instant at a time [s] in the step, and the internal states (nz,)."""
        y, nq, nd = self(t), self.kinematics.roles.nq, self.kinematics.roles.nd
        q, qd, z = y[:nq], y[nq : nq + nd], y[nq + nd :]
        if t == self.last.t:
            return self.last, z
        guess = between(self.first, self.last, t)
        x, v, e = located(self.kinematics, t, q, qd, guess)
        return replace(guess, t=t, x=x, v=v, e=e), z
