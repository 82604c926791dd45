"""Single steps of Radau IIA of order 5 in C, and their dense output.

Source: Hairer and Wanner (1996), IV.8.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.base.copies import Portable
from flexel.engine.choice import Choice
from flexel.engine.solvers import shifted_factors
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.knots import Knots
from flexel.integration.radau_tableau import COLLOCATION, CORRECTION, NODES, PAIR, REAL, T
from flexel.mechanics.kinematics import Kinematics

POWERS = np.arange(1, 5)


class Collocation(Struct):
    """The struct of radau.h for one choice of degrees of freedom.

    Attributes
    ----------
    y, scale : ndarray (ny,)
        The start of the step, and the allowed error.
    Z : ndarray (3, ny)
        Changes up to the stages: first a guess, then what was found.
    """

    def __init__(self, kinematics: Kinematics, choice: Choice, knots: Knots, size: int) -> None:
        super().__init__(ffi.new("flexel_radau *"))
        self.kinematics, self.choice, self._knots = kinematics, choice, knots
        c = self.struct
        c.ny, c.mu = size, REAL
        c.pair[0], c.pair[1] = PAIR.real, PAIR.imag
        for name, array in (("T", T), ("inverse", np.linalg.inv(T)), ("C", NODES)):
            setattr(c, name, self.pointer(np.ascontiguousarray(array)))
        self.y, self.scale = self.new("y", size), self.new("scale", size)
        self.Z, _, _ = (self.new(name, 3 * size).reshape(3, size) for name in ("Z", "W", "F"))
        self.new("space", 3 * size)
        c.ngiven = choice.motion.size + choice.loads.size
        self._given = self.new("given", 3 * c.ngiven).reshape(3, -1)
        self._factors = [
            (self.new(f"{name}_factors", count * size * size), np.zeros(size, dtype=np.int32))
            for name, count in (("real", 1), ("complex", 2))
        ]
        c.real_pivots, c.complex_pivots = (self.integers(pivots) for _, pivots in self._factors)

    def factorize(self, J: Array, h: float) -> bool:  # noqa: N803
        """Factors of (μ/h) 1 - J for a step of length h; whether both matrices are regular."""
        found = shifted_factors(J, REAL / h), shifted_factors(J, PAIR / h)
        for part, (factors, pivots) in zip(found, self._factors, strict=True):
            if part is None:
                return False
            factors[:], pivots[:] = part[0].view(float).ravel(), part[1]
        return True

    def solve(self, b: Array) -> Array:
        """x of ((μ/h) 1 - J) x = b for the real μ."""
        x, c = np.array(b), self.struct
        lib.flexel_radau_solve(x.size, c.real_factors, c.real_pivots, ffi.from_buffer("double[]", x))
        return x

    def step(self, t: float, h: float) -> bool:
        """Find the stages of a step from y, the guess in Z; whether the iteration converges.

        Raises
        ------
        PositionError, ConstraintError, InertiaError
            If a stage cannot be evaluated.
        """
        self._give(t, h)
        work, choice = self.choice.work.struct, self.choice.struct
        self.kinematics.check(lib.flexel_radau_step(work, choice, self.struct, t, h), t + h, self.choice)
        return bool(self.struct.converged)

    def _give(self, t: float, h: float) -> None:
        """The prescribed motions and loads at the stages."""
        motions, loads = self.kinematics.roles.motions, self.kinematics.loads
        split = self.choice.motion.size
        for i in range(3) if motions or loads.any else ():
            time = self._knots.inside(t + NODES[i] * h)
            if motions:
                self._given[i, :split] = self.kinematics.roles.motion(time).ravel()
            if loads.any:
                self._given[i, split:] = loads.values(time)


@dataclass(frozen=True)
class Polynomial(Portable):
    """Dense output of a step: the collocation polynomial, corrected so that its rates at the start are right too.

    The defect of the collocation polynomial is a multiple of (s - c1)(s - c2)(s - 1) to its leading order, and known
    at the start from the estimate of the error.  Its integral is subtracted: the local error is of order 5 instead of
    4, and stiff components are filtered as in the estimate.

    Attributes
    ----------
    t, h : float
        Start and length of the step [s].
    y : ndarray (ny,)
        Values at its start.
    coefficients : ndarray (4, ny)
        Of the powers 1 to 4 of the part of the step that has passed.
    end : ndarray (ny,)
        Values at its end.
    """

    t: float
    h: float
    y: Array
    coefficients: Array
    end: Array

    @classmethod
    def through(cls, t: float, h: float, y: Array, Z: Array, estimate: Array) -> Polynomial:  # noqa: N803
        """The one through the stages y + Z (3, ny), with the estimate of the error (ny,)."""
        coefficients = np.outer(CORRECTION, -REAL * estimate)
        coefficients[:3] += COLLOCATION @ Z
        return cls(t, h, y, coefficients, y + Z[2])

    def __call__(self, t: float) -> Array:
        """Values (ny,) at a time [s]."""
        part = (t - self.t) / self.h
        return self.end if part == 1.0 else np.asarray(self.y + part**POWERS @ self.coefficients)
