"""Orientations with one Euler parameter as a degree of freedom, in a step of Radau IIA; see angles.h."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.rotations import frames_with, numbers_of
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure

NO_CHARTS: Array = np.zeros((0, 3))


class Angles(Struct):
    """The struct of angles.h for one choice of degrees of freedom.

    Parameters
    ----------
    structure : Structure
    roles : Roles

    Attributes
    ----------
    at : ndarray of int (count, 4)
        Coordinates of the Euler parameters.
    dof : ndarray of int (count,)
        Number of the one among the dynamic degrees of freedom.
    axis : ndarray (count, 3)
        Axis at the start of the step, in the frame.
    slope : ndarray (count,)
        Twice the derivative of the Euler parameter by the angle there; zero where it is its own variable.
    passed : ndarray (count,)
        Angle since the start of the motion [rad].
    """

    def __init__(self, structure: Structure, roles: Roles) -> None:
        super().__init__(ffi.new("flexel_angles *"))
        found = [[*at, *part, *dof] for at, part, dof in frames_with(structure, roles, parameters=1)]
        lists = np.array(found, dtype=np.int32).reshape(-1, 6)
        self.at, self._part, self.dof = lists[:, :4], lists[:, 4], lists[:, 5]
        c, self._nq, count = self.struct, roles.nq, len(lists)
        c.count, c.nq = count, roles.nq
        c.at, c.part, c.dof = (
            self.integers(indices.flatten()) for indices in (self.at, self._part, self.dof)
        )
        self._start, self.axis = (
            self.new(name, width * count).reshape(-1, width) for name, width in (("start", 4), ("axis", 3))
        )
        self.new("others", 3 * count)
        self.new("before", 4 * count)
        self.slope, self._seen, self.passed = (self.new(name, count) for name in ("slope", "seen", "passed"))

    @property
    def count(self) -> int:
        """Number of frames."""
        return int(self.dof.size)

    @property
    def known(self) -> bool:
        """Whether all of them are described by angles."""
        return bool(np.all(self.slope))

    @property
    def numbers(self) -> dict[int, int]:
        """Number of each frame by the coordinate of its first Euler parameter."""
        return numbers_of(self.at)

    @property
    def charts(self) -> Array:
        """What the angles of a step are, (angles, 3): number in y, Euler parameter and slope at its start."""
        return self.charts_of(self._start[np.arange(self.count), self._part], self.slope)

    def charts_of(self, q: Array, slope: Array) -> Array:
        """Return the same for the Euler parameters q (count,) at the start of a step, and their slopes."""
        if not self.count:
            return NO_CHARTS
        return np.asarray(np.column_stack([self.dof, q, slope])[slope != 0])

    def take_over(self, before: Angles) -> None:
        """Keep what is known of frames that both have."""
        numbers = before.numbers
        for at, i in self.numbers.items():
            if at in numbers:
                j = numbers[at]
                self.axis[i], self.passed[i] = before.axis[j], before.passed[j]

    def jacobian(self, A: Array, y: Array, f: Array) -> Array:
        """Return the derivatives (ny, ny) of the rates of the variables by the variables, at the start of a step.

        Parameters
        ----------
        A : ndarray (ny, ny)
            The same with Euler parameters and their rates.
        y, f : ndarray (ny,)
            The variables and their rates.
        """
        change = np.eye(y.size)
        charts = [(int(i), self._nq + int(i), q, b) for i, q, b in self.charts]
        for value, rate, q, b in charts:
            change[value, value] = change[rate, rate] = b / 2
            change[rate, value] = -q / 4 * y[rate]
        J = A @ change
        for value, rate, q, b in charts:
            J[rate, value] += q / 4 * f[rate] + b / 8 * y[rate] ** 2
            J[rate, rate] += q / 2 * y[rate]
            J[rate] /= b / 2
            J[value] = 0.0
            J[value, rate] = 1.0
        return J


def placed(y: Array, charts: Array, nq: int) -> Array:
    """Convert variables of a step with its charts to y with Euler parameters and their rates."""
    y = y.copy()
    for number, q, b in charts:
        i, half = int(number), 0.5 * y[int(number)]
        c, s = np.cos(half), np.sin(half)
        y[i], y[nq + i] = q * c + b * s, 0.5 * (b * c - q * s) * y[nq + i]
    return y
