"""How much the coefficients of linearized equations change while a motion goes on.

The eigenvalues of equations whose coefficients vary in time are those of frozen coefficients: a vibration of the
support can make a stable pendulum unstable, and a rotor in an unsymmetric bearing has no constant coefficients at all.
A wheel that rolls steadily has constant coefficients in its angles of yaw and lean, but not in Euler parameters, which
turn with it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array, ComplexArray, Index, largest
from flexel.base.errors import PositionError
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.soft import Spectrum
from flexel.mechanics.states import state_of
from flexel.mechanics.steadiness import UNSTEADY, balancing
from flexel.mechanics.transfer import GeometricTransfer
from flexel.mechanics.travel import travelled
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

FRACTIONS = (0.13, 0.37, 0.71)  # of the time over which they are compared: no symmetric parts of a period
FARTHEST = 10.0  # way of the fastest quantity within that time, in its natural scale
SHORTER = (1.0, 0.1, 0.01)  # parts of that time, tried in turn where the motion cannot go on for the whole
RESTING = 1e-9  # way of the degrees of freedom within it that is a rounding error of their rates
FREE = 1e-9  # size of an eigenvalue, relative to the largest, that counts as zero
DEFECTIVE = 1e-10  # product of left and right eigenvectors, both of length one, of several eigenvalues in one
SLOW = 1e-4  # eigenvalue, relative to the largest, below which rounding errors count
UNIT_S = 1.0  # time in which a state is followed where nothing vibrates [s]
CANCELLED = 1e-11  # of stiffnesses, relative to the largest one


class Linear(Protocol):
    """Linearized equations, as `LinearizedSystem` has them."""

    @property
    def M(self) -> Array: ...  # noqa: D102, N802
    @property
    def K(self) -> Array: ...  # noqa: D102, N802
    @property
    def K_u(self) -> Array: ...  # noqa: D102, N802
    @property
    def Z(self) -> Array: ...  # noqa: D102, N802
    @property
    def state(self) -> State: ...  # noqa: D102
    @property
    def state_matrix(self) -> Array: ...  # noqa: D102
    @property
    def transfer(self) -> GeometricTransfer: ...  # noqa: D102
    @property
    def acceleration(self) -> float: ...  # noqa: D102


class Afterwards:
    """What becomes of linearized equations while their motion goes on.

    Parameters
    ----------
    linearize : callable
        Linearizes at complete states.
    kinematics : Kinematics
    """

    def __init__(
        self,
        linearize: Callable[[Kinematics, Sequence[State]], Sequence[Linear]],
        kinematics: Kinematics,
    ) -> None:
        self._linearize, self._kinematics = linearize, kinematics

    def drift(self, now: Linear, found: Spectrum) -> float:
        """Return how much the residual forces change while all rates stay, relative to the balancing ones.

        That is within a period of the slowest vibration, or the time in which the fastest quantity moves by its
        natural scale.  A state in which nothing accelerates lasts only if this is zero: it is about one at the lowest
        point of a swing, or where a coordinate belongs to a body that turns.
        """
        kinematics, state = self._kinematics, now.state
        roles, fastest = kinematics.roles, self._fastest(state)
        # how accelerated motions go on is not known, and without degrees of freedom all is prescribed
        if not fastest or not roles.nd or state.Phi_v[roles.prescribed].any():
            return 0.0
        time = min(_period(found[0]) or UNIT_S, 1 / fastest)
        H, scales = now.transfer.H[:, : roles.nd], kinematics.scales(roles.dynamic)
        changes = (
            (now.K, state.rates[roles.dofs]),
            (now.K_u, state.rates[roles.prescribed]),
            (now.Z, state.zd),
        )
        change = sum(matrix @ rates for matrix, rates in changes)
        rounding = CANCELLED * max(
            largest(scales[:, None] * matrix) * largest(rates) for matrix, rates in changes
        )
        inertia = fastest**2 * largest(scales[:, None] * now.M * scales)
        balance = max(balancing(H * scales, state), inertia)
        return max(largest(scales * change) - rounding, 0.0) * time / balance

    def change(self, now: Linear, found: Spectrum) -> float:
        """Return how much the coefficients change, as the vibrations feel it: twice the change of an eigenvalue.

        That is relative to the eigenvalue, of first order, or the geometric mean of what two vibrations do to one
        another; of a stiffness that alone holds a mass, it is the relative change.  Degrees of freedom keep their
        rates, and prescribed motions continue, for a period of the slowest vibration.  Zero if nothing moves.  Later
        states that accelerate are left out.

        Parameters
        ----------
        now : LinearizedSystem
            In which nothing accelerates.
        found : tuple of ndarray
            Its eigenvalues, left and right eigenvectors.
        """
        values, left, right = _vibrations(found)
        kinematics, state = self._kinematics, now.state
        roles, fastest = kinematics.roles, self._fastest(state)
        duration = _period(values)
        length = min(duration, FARTHEST / fastest) if fastest else duration
        times = [state.t + fraction * length for fraction in FRACTIONS]
        driven = any(np.any(roles.motion(t) != roles.motion(state.t)) for t in times if roles.motions)
        if not driven and self._fastest(state, roles.dofs) * length <= RESTING:
            return 0.0
        for part in SHORTER:
            later = _continued(kinematics, state, [state.t + part * (t - state.t) for t in times])
            if len(later) == len(times):
                break
        A, most = now.state_matrix, 0.0
        sizes = np.sqrt(np.maximum(np.abs(values), SLOW * largest(values)))
        for then in self._linearize(kinematics, later):
            if then.acceleration <= UNSTEADY:
                felt = np.abs(left.conj().T @ (then.state_matrix - A) @ right) / np.outer(sizes, sizes)
                most = max(most, 2 * largest(np.sqrt(felt * felt.T)))
        return most

    def _fastest(self, state: State, rows: Index | None = None) -> float:
        """Return the fastest rate of some quantities, by default all, in natural scales [1/s]."""
        which = np.arange(state.rates.size) if rows is None else rows
        return float(np.abs(state.rates[which] / self._kinematics.scales(which)).max(initial=0.0))


def _moving(values: ComplexArray) -> NDArray[np.bool_]:
    """Which eigenvalues are not zero."""
    return np.asarray(np.abs(values) > FREE * largest(values))


def _period(values: ComplexArray) -> float:
    """Return the period of the slowest eigenvalue that is not zero [s]; zero if there is none."""
    slowest = float(np.abs(values[_moving(values)]).min(initial=np.inf))
    return 2 * np.pi / slowest


def _vibrations(found: Spectrum) -> Spectrum:
    """Return the eigenvalues that are not zero, and their left and right eigenvectors, whose products are one.

    Those without such eigenvectors, which are several in one, are left out.
    """
    values, left, right = found
    products = (left.conj() * right).sum(axis=0)  # of unit vectors
    used = _moving(values) & (np.abs(products) > DEFECTIVE)
    return values[used], left[:, used] / products[used].conj(), right[:, used]


def _continued(kinematics: Kinematics, state: State, times: Sequence[float]) -> list[State]:
    """Return the states at times up to which the motion can go on with constant rates."""
    dofs, found = kinematics.roles.dofs, []
    here = Snapshot.of(state)
    for t in times:
        q = state.values[dofs] + (t - state.t) * state.rates[dofs]
        guess = travelled(kinematics, here, t, q)
        if guess is None:
            break
        try:
            found.append(state_of(kinematics, t, q, state.qd, state.z, guess))
        except PositionError:  # the mechanism reaches no further
            break
        here = Snapshot.of(found[-1])
    return found
