"""Ranks quantities as degrees of freedom: relative angles, and coordinates of much heavier bodies, are preferred."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.mechanics.kinematics import Kinematics

RELATIVE = 3.0  # relative angles and elongations are preferred to absolute coordinates by this factor
SPREAD = (
    1e10  # ratio of the largest inertia to the smallest above which the heavier coordinates are preferred
)
POWER = 0.1  # exponent of the inertia ratio: a ratio of 1e20 makes a factor of 100
# By this factor at most, the first of quantities that are as good as one another is preferred: rounding, which differs
# from one processor to another, does not decide.  A thousand of them are told apart far beyond rounding.
EARLIER = 1 + 1e-8


def preferences(kinematics: Kinematics, rows: Index) -> Array:
    """Return weights of rates of quantities of one kind, to compare them as degrees of freedom.

    Parameters
    ----------
    rows : ndarray of int
        Quantities.

    Returns
    -------
    ndarray
        Positive.
    """
    structure = kinematics.structure
    weight = 1.0 / kinematics.scales(rows)
    weight[(rows < structure.m) | (np.array(structure.units, dtype=object)[rows] == "rad")] *= RELATIVE
    return weight


def earliness(count: int) -> Array:
    """Return factors (count,) that decide among quantities which are as good as one another: the first is preferred."""
    return np.linspace(EARLIER, 1.0, count)


def heaviness(kinematics: Kinematics, rows: Index) -> Array:
    """Return factors, at least one, by which quantities are preferred for their inertia as drawn; one in most models.

    A heavy body must not move by the difference between two light bodies: its inertia in the reduced mass matrix then
    exceeds those of the light bodies so far that rounding errors hide them.
    """
    first = kinematics.structure.m + kinematics.structure.k
    inertia = kinematics.evaluation.inertia * kinematics.scales(slice(first, None)) ** 2
    moving = inertia[inertia > 0]
    if not moving.size or moving.max() <= SPREAD * moving.min():
        return np.ones(rows.size)
    factor = np.ones(first + inertia.size)
    factor[first:] = np.maximum(inertia**POWER / moving.min() ** POWER, 1.0)
    return np.asarray(factor[rows])
