"""From one position to a distant one: degrees of freedom change together, in steps that stay on the branch.

Each step is predicted along the tangent, which is exact where nothing is curved, and corrected by Newton's method.  It
is accepted if the correction is small compared with the step; otherwise it is halved.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError, PositionError
from flexel.engine.choice import Choice
from flexel.generated._kernels import lib
from flexel.mechanics.kinematics import Kinematics
from flexel.structure.moment import Moment

CURVED = 0.3  # correction of a step, relative to the step, above which it is halved
STILL = 1e-6  # correction in natural scales that is always allowed
SHORTEST = 1e-7  # step, relative to the way


def travelled(kinematics: Kinematics, near: Moment, t: float, q: Array) -> Moment | None:
    """The position at time t with degrees of freedom q (nq,), led to from a position nearby; None if it is not reached.

    Its rates are zero.
    """
    here, done, step = near.still(near.t), 0.0, 1.0
    begin = kinematics.values(near.e, near.x)[kinematics.roles.dofs]
    while done < 1.0:
        share = min(done + step, 1.0)
        there = _stepped(kinematics, here, near.t + share * (t - near.t), begin + share * (q - begin))
        if there is None:
            step /= 2
            if step < SHORTEST:
                return None
        else:
            here, done, step = there, share, 2 * step
    return here


def _stepped(kinematics: Kinematics, here: Moment, t: float, q: Array) -> Moment | None:
    """One step; None if it is not found, or may be on another branch."""
    weight = kinematics.lists.step_weight
    try:
        change = _tangent(kinematics, here, t, q)
        x = here.x.copy()
        x[: change.size] += change
        near = here.e + _rates(kinematics, here, change)
        choice = kinematics.locate(t, q, x, near)
    except (PositionError, ConstraintError):
        return None
    work = choice.work
    corrected = float(np.max(np.abs(work.x - x)[: change.size] * weight, initial=0.0))
    if corrected > CURVED * float(np.max(np.abs(change) * weight, initial=0.0)) + STILL:
        return None
    return replace(here, t=t, x=work.x.copy(), e=work.e.copy())


def _tangent(kinematics: Kinematics, here: Moment, t: float, q: Array) -> Array:
    """Change (nf,) of the free coordinates along the tangent, for given degrees of freedom and prescribed values."""
    choice: Choice = kinematics.given(t)
    choice.reset()
    choice.work.x[:], choice.work.near[:] = here.x, here.e
    choice.work.position()
    kinematics.check(choice.factorize(), t)
    wanted = kinematics.target(kinematics.roles.motion(t), q)
    present = kinematics.values(choice.work.e, here.x)[kinematics.roles.position_rows]
    change, space = wanted - present, np.zeros(wanted.size)
    pointers = (choice.work.pointer_of(vector) for vector in (change, change, space))
    lib.flexel_matrix_solve(choice.P, 1, *pointers)
    return change


def _rates(kinematics: Kinematics, here: Moment, change: Array) -> Array:
    """Change (m,) of the deformations, to first order."""
    whole = np.zeros(here.x.size)
    whole[: change.size] = change
    return kinematics.choice.work.push(whole)[: here.e.size]
