"""Roles of coordinates, deformations and slips, as index lists into the quantities of a structure."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.copies import Constant
from flexel.base.time_functions import TimeFunction, time_scaled


@dataclass(frozen=True)
class Roles(Constant):
    """Which quantities are constrained, prescribed and independent.

    Attributes
    ----------
    rigid : ndarray of int
        Deformations held at zero (Euler-parameter norms among them).
    prescribed : ndarray of int, motions : tuple of TimeFunction
        Coordinates and deformations with a given motion, and that motion.
    zero : ndarray of int
        Slips held at zero (pure rolling).
    dynamic, kinematic : ndarray of int
        The degrees of freedom q = (q_d, q_k).
    named : bool
        Whether the user has named dynamic ones.
    actuators : ndarray of int, optional
        For each prescribed quantity, the one in which the force acts that moves it; by default itself.
    """

    rigid: Index
    prescribed: Index
    motions: tuple[TimeFunction, ...]
    zero: Index
    dynamic: Index
    kinematic: Index
    named: bool = False
    actuators: Index | None = None

    @cached_property
    def holonomic(self) -> Index:
        """Rows of c(x, t): rigid, then prescribed."""
        return np.concatenate([self.rigid, self.prescribed])

    @property
    def actuated(self) -> bool:
        """Whether prescribed quantities are moved by forces that act elsewhere."""
        return self.actuators is not None

    @cached_property
    def moved(self) -> Index:
        """Places among the prescribed quantities of those that actuators move."""
        none = np.zeros(0, dtype=np.intp)
        return none if self.actuators is None else np.flatnonzero(self.actuators != self.prescribed)

    @cached_property
    def forces(self) -> Index:
        """Where the forces act that hold c(x, t): in the same quantities, or in actuators."""
        return np.concatenate([self.rigid, self.prescribed if self.actuators is None else self.actuators])

    @cached_property
    def dofs(self) -> Index:
        """Rows of q = (q_d, q_k)."""
        return np.concatenate([self.dynamic, self.kinematic])

    @cached_property
    def velocity_rows(self) -> Index:
        """Rows of B: rigid, prescribed, no-slip constraints, dynamic degrees of freedom."""
        return np.concatenate([self.holonomic, self.zero, self.dynamic])

    @cached_property
    def position_rows(self) -> Index:
        """Rows of the matrix of the position problem: rigid, prescribed, all degrees of freedom."""
        return np.concatenate([self.holonomic, self.dofs])

    @property
    def nd(self) -> int:
        """Number of dynamic degrees of freedom."""
        return self.dynamic.size

    @property
    def nq(self) -> int:
        """Number of degrees of freedom, kinematic ones included."""
        return self.dynamic.size + self.kinematic.size

    def motion(self, t: float) -> Array:
        """Return value, first and second rate (3, prescribed) of the prescribed motions at time t."""
        return np.array([f.rates(t) for f in self.motions]).reshape(-1, 3).T

    def time_scaled(self, factor: float) -> Roles:
        """Return the same roles with prescribed motions that run `factor` times as fast."""
        return replace(self, motions=tuple(time_scaled(f, factor) for f in self.motions))

    def with_dofs(self, dynamic: Index, kinematic: Index) -> Roles:
        """Return the same constraints with another choice of coordinates."""
        return replace(self, dynamic=dynamic, kinematic=kinematic)
