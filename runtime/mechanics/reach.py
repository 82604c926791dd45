"""The reach of a choice of degrees of freedom: change of the coordinates per unit of them, in natural scales."""

from __future__ import annotations

import numpy as np

from flexel.mechanics.kinematics import Kinematics
from flexel.structure.moment import Moment

LOST = 100.0  # reach, relative to that of the best choice, beyond which degrees of freedom are not used


def reach(kinematics: Kinematics, near: Moment) -> float:
    """Reach of the degrees of freedom at a position; infinite where they do not determine it."""
    choice = kinematics.given(near.t)
    choice.reset()
    work = choice.work
    work.x[:], work.near[:], choice.qd[:] = near.x, near.e, 0.0
    work.position()
    return np.inf if choice.directions() else choice.reach()
