"""How much the coefficients of linearized equations change while prescribed motions go on.

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
from flexel.mechanics.travel import travelled
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

Linearize = Callable[[Kinematics, Sequence[State]], Sequence[Sequence[Array]]]
FRACTIONS = (0.13, 0.37, 0.71)  # of the time over which they are compared: no symmetric parts of a period
SHORTER = (1.0, 0.1, 0.01)  # parts of that time, tried in turn where the motion cannot go on for the whole


def variation(
    linearize: Linearize, kinematics: Kinematics, state: State, matrices: Sequence[Array], duration: float
) -> float:
    """Return the largest change of M, C and K, relative to each one's largest entry, within a time that follows.

    Degrees of freedom keep their rates; prescribed motions go on. Zero without prescribed motions that move.

    Parameters
    ----------
    linearize : callable
        M, C and K at complete states.
    matrices : sequence of ndarray
        The same at the state.
    duration : float
        Time over which they are compared [s], such as a period of the slowest vibration.
    """
    roles = kinematics.roles
    times = [state.t + fraction * duration for fraction in FRACTIONS]
    if not any(np.any(roles.motion(t) != roles.motion(state.t)) for t in times if roles.motions):
        return 0.0
    for part in SHORTER:
        later = _continued(kinematics, state, [state.t + part * (t - state.t) for t in times])
        if len(later) == len(times):
            break
    found = linearize(kinematics, later)
    sizes = [max(float(np.abs(matrix).max(initial=0.0)), 1e-300) for matrix in matrices]
    return max(
        (
            float(np.abs(new - old).max(initial=0.0)) / size
            for some in found
            for new, old, size in zip(some, matrices, sizes, strict=True)
        ),
        default=0.0,
    )


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
