"""The path of a stretch of motion, by collocation: sweeps over Gauss's points until it no longer changes.

Each sweep places the coordinates and rates of the path at each point on the constraints, takes the accelerations
there, and integrates them.  Errors of the path are in the degrees of freedom only, and each sweep reduces them.  The
accelerations at a distance d from a flat position have rounding errors of the order 1/d^3, so the points nearest to it
must be far enough.  Source: Hairer, Norsett and Wanner (1993), II.7; Dutt, Greengard and Rokhlin (2000) for sweeps.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError
from flexel.integration.account import powers
from flexel.integration.flat import flat_position
from flexel.integration.knots import Knots
from flexel.integration.path import LAST, PLACES, POINTS, Path, Rates
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import located
from flexel.model.snapshot import Snapshot

MOST = 30  # sweeps
CONVERGED = 0.03  # change in a sweep, relative to what is allowed
STALLED = 0.5  # change, relative to that of the last sweep, from which on it is rounding
ROUNDING = 1e-10  # change and distance from the constraints that are accepted as rounding, in natural scales
UNSURE, SURE = 0.01, 1e-5  # of the time of the flat position, by its fit and at last, relative to the length
AGAIN = 3  # sweeps that are taken in any case
LEAST = float(np.log(np.finfo(float).tiny))  # logarithm of a determinant that is zero


class Errors(NamedTuple):
    """Errors of a path: the change in the last sweep, the last terms, and the distance from the constraints.

    They are those of coordinates and of rates times half the length, in natural scales, and those of internal states
    over the tolerance.
    """

    change: float
    terms: float
    off: float


class Sweeps:
    """Sweeps over one stretch.

    Parameters
    ----------
    kinematics : Kinematics
    knots : Knots
    z : ndarray (nz,)
        Internal states at the start.
    allowed : float
        Error of the path, in natural scales.

    Attributes
    ----------
    start : Snapshot
        Where the path begins.
    evaluations : int
        That were made so far.
    """

    def __init__(self, kinematics: Kinematics, knots: Knots, z: Array, allowed: float) -> None:
        self.kinematics, self._knots, self._z = kinematics, knots, z
        self._converged, self._allowed = CONVERGED * allowed, max(allowed, ROUNDING)
        self._weight = kinematics.lists.step_weight
        self.start: Snapshot
        self._off = np.inf
        self._determinant = np.zeros(POINTS)
        self.evaluations = 0

    def begin(self, start: Snapshot) -> Snapshot:
        """Begin at an instant, and return it on the constraints.

        A step ends there within its tolerance only, and this distance grows towards a flat position.

        Raises
        ------
        PositionError, ConstraintError
            Where it cannot be placed there.
        """
        nf = self.kinematics.structure.nf
        self.start = self._placed(start.t, start.x[:nf], start.v[:nf], start)
        return self.start

    def path(self, guess: Path) -> tuple[Path, Errors]:
        """Compute the path that follows from a guess.

        Raises
        ------
        PositionError, ConstraintError, InertiaError, DynamicsError
            Where a point cannot be evaluated.
        """
        path, change = guess, np.inf
        for sweep in range(MOST):
            following = self._sweep(path)
            before, change = change, self._distance(following, path)
            path = following
            if not np.isfinite(change) or change <= self._converged:
                break
            if sweep >= AGAIN and self._allowed >= change > STALLED * before:
                break
        return path, Errors(change, self._terms(path), self._off)

    def on_constraints(self, errors: Errors) -> bool:
        """Whether a path satisfies the constraints and the equations of motion, up to rounding."""
        return max(errors.change, errors.off) <= self._allowed

    @property
    def flat(self) -> float | None:
        """The flat position in the last sweep, relative to the length; None if there is none."""
        return flat_position(self._determinant, (1 + PLACES) / 2)

    def exactly(self, path: Path, flat: float) -> float:
        """Find the time of a flat position of a path near a time [s], where the determinant is least."""
        size, start = path.t1 - path.t0, self.start
        found = minimize_scalar(
            lambda t: self._size(path, t, start),
            bounds=(flat - UNSURE * size, flat + UNSURE * size),
            method="bounded",
            options={"xatol": SURE * size},
        )
        return float(found.x)

    def _size(self, path: Path, t: float, start: Snapshot) -> float:
        """Return the logarithm of the determinant's size at a time; finite where it is zero, to be interpolated."""
        choice = self.kinematics.choice
        free = path.at(t)[0]
        choice.work.x[:], choice.work.unwrap_from[:] = start.x, start.e
        choice.work.x[: free.size] = free
        choice.work.position()
        return LEAST if choice.factorize() else max(choice.determinant, LEAST)

    def moment(self, path: Path, t: float, last: Snapshot) -> Snapshot:
        """Return the instant of a path at a time, on the constraints; turns are counted from an instant nearby."""
        x, v, _ = path.at(t)
        return self._placed(t, x, v, last)

    def _placed(self, t: float, free: Array, rates: Array, last: Snapshot) -> Snapshot:
        """Return the instant with the degrees of freedom of given free coordinates and rates."""
        kinematics, roles, work = self.kinematics, self.kinematics.roles, self.kinematics.evaluation.work
        x, v = last.x.copy(), last.v.copy()
        x[: free.size], v[: rates.size] = free, rates
        work.x[:], work.unwrap_from[:] = x, last.turns(t)
        work.position()
        q = kinematics.values(work.e, x)[roles.dofs]
        qd = np.concatenate([work.jvp(v), v])[roles.dynamic]
        guess = Snapshot(last.t, x, v, last.e, last.ed)
        x, v, e = located(kinematics, self._knots.inside(t), q, qd, guess)
        return Snapshot(t, x, v, e, work.jvp(v)[: e.size])

    def _sweep(self, path: Path) -> Path:
        nf, last, times = self.kinematics.structure.nf, self.start, path.times
        found = Rates(*(np.empty((POINTS, size)) for size in (nf, self._z.size, 2)))
        x, v, z = path.at_points()
        self._off = 0.0
        for i, t in enumerate(times.tolist()):
            last = self._placed(t, x[i], v[i], last)
            self._off = max(self._off, self._largest(last.x[:nf] - x[i]))
            found.a[i], found.zd[i], found.powers[i] = self._rates(last, z[i])
            self._determinant[i] = self.kinematics.choice.determinant
        if not all(np.isfinite(part).all() for part in found):
            raise DynamicsError(f"the path up to t = {path.t1:g} s leads to infinite forces")
        return Path.integral(self.start, self._z, path.t1, found)

    def _rates(self, at: Snapshot, z: Array) -> tuple[Array, Array, tuple[float, float]]:
        """Return accelerations, rates of internal states, and powers."""
        choice = self.kinematics.given(self._knots.inside(at.t))
        work = choice.work
        work.struct.t = at.t
        work.x[:], work.v[:], work.unwrap_from[:], work.z[:] = at.x, at.v, at.e, z
        self.evaluations += 1
        self.kinematics.check(choice.complete(False), at.t)
        return work.a[: self.kinematics.structure.nf].copy(), work.zd.copy(), powers(choice)

    def _largest(self, x: Array) -> float:
        return float(np.max(np.abs(x) * self._weight, initial=0.0))

    def _distance(self, path: Path, other: Path) -> float:
        (x, v, z), (x0, v0, z0) = path.at_points(), other.at_points()
        return max(self._largest(x - x0), self._largest(v - v0) * path.half, self._of_states(z - z0, z))

    def _terms(self, path: Path) -> float:
        return max(
            self._largest(path.x[-LAST:]),
            self._largest(path.v[-LAST:]) * path.half,
            self._of_states(path.z[-LAST:], path.at_points()[2]),
        )

    def _of_states(self, part: Array, z: Array) -> float:
        """Return the distance of internal states, relative to the size of each."""
        size = np.maximum(np.max(np.abs(z), axis=0, initial=0.0), 1.0)
        return float(np.max(np.abs(part) / size, initial=0.0))
