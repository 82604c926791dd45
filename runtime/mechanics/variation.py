"""How much the coefficients of linearized equations change while prescribed motions continue.

The eigenvalues of equations whose coefficients vary in time are those of frozen coefficients: a vibration of the
support can make a stable pendulum unstable, and a rotor in an unsymmetric bearing has no constant coefficients at all.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import PositionError
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import state_of
from flexel.mechanics.steadiness import UNSTEADY
from flexel.mechanics.travel import travelled
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

Linearize = Callable[[Kinematics, Sequence[State]], Sequence[tuple[float, Array, Array, Array]]]
FRACTIONS = (0.13, 0.37, 0.71)  # of the time over which they are compared: no symmetric parts of a period
FARTHEST = 10.0  # way of the fastest quantity within that time, in its natural scale
SHORTER = (1.0, 0.1, 0.01)  # parts of that time, tried in turn where the motion cannot go on for the whole


def variation(
    linearize: Linearize, kinematics: Kinematics, state: State, matrices: Sequence[Array], duration: float
) -> float:
    """Return the largest change of the forces of M, C and K in a vibration, relative to the largest force.

    Degrees of freedom keep their rates; prescribed motions continue. Zero without prescribed motions that move, and if
    degrees of freedom do not keep their rates: then the state is not one of a motion about which anything vibrates.

    Parameters
    ----------
    linearize : callable
        Residual forces, relative to those that balance, and M, C and K at complete states.
    matrices : sequence of ndarray
        M, C and K at the state.
    duration : float
        Period of the vibration [s], over which they are compared; a shorter time where quantities move fast.
    """
    roles = kinematics.roles
    fastest = float(np.abs(state.rates / kinematics.scales(np.arange(state.rates.size))).max(initial=0.0))
    length = min(duration, FARTHEST / max(fastest, FARTHEST / duration))
    times = [state.t + fraction * length for fraction in FRACTIONS]
    if not any(np.any(roles.motion(t) != roles.motion(state.t)) for t in times if roles.motions):
        return 0.0
    for part in SHORTER:
        later = _continued(kinematics, state, [state.t + part * (t - state.t) for t in times])
        if len(later) == len(times):
            break
    weights = (2 * np.pi / duration) ** np.array([2, 1, 0])
    size = max(map(_size, weights, matrices))
    return max(
        (
            _size(weight, new - old) / size
            for off, *found in linearize(kinematics, later)
            if off <= UNSTEADY
            for weight, new, old in zip(weights, found, matrices, strict=True)
        ),
        default=0.0,
    )


def _size(weight: float, matrix: Array) -> float:
    """Return the largest force of a matrix in a vibration."""
    return weight * float(np.abs(matrix).max(initial=0.0))


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
