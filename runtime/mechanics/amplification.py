"""Measures a choice of degrees of freedom: change of the coordinates per unit of them, in natural scales."""

from __future__ import annotations

import warnings

import numpy as np

from flexel.base.callers import outside
from flexel.base.errors import CoordinateWarning
from flexel.mechanics.kinematics import Kinematics
from flexel.model.role_lists import Roles
from flexel.model.snapshot import Snapshot

NEAR = 100.0  # see `lost`


def lost(roles: Roles) -> float:
    """Return the amplification, relative to the best choice's, beyond which degrees of freedom are not used.

    Relative angles of a chain of n bodies move its end by up to n² of their size, far from any singularity.
    """
    return NEAR + float(roles.nd) ** 2


def warn_replaced(own: Kinematics, other: Kinematics, t: float) -> None:
    """Warn that named degrees of freedom are nearly singular at time t, and others are used."""
    if not own.roles.named:
        return
    mine, theirs = own.names(own.roles.dynamic), other.names(other.roles.dynamic)
    warnings.warn(
        f"the degrees of freedom {mine} are nearly singular at t = {t:g} s; {theirs} are used there: name others with "
        "m.independent, or use another state",
        CoordinateWarning,
        stacklevel=outside(),
    )


def amplification(kinematics: Kinematics, at: Snapshot) -> float:
    """Return the amplification of the degrees of freedom at a position; infinite if they do not determine it."""
    choice = kinematics.given(at.t)
    choice.reset()
    work = choice.work
    work.x[:], work.unwrap_from[:], choice.qd[:] = at.x, at.e, 0.0
    work.position()
    return np.inf if choice.directions() else choice.amplification()
