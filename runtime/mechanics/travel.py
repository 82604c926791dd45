"""Travels from one position to a distant one: degrees of freedom change together, in steps that stay on the branch.

Each step is predicted along the tangent, which is exact without curvature, and corrected by Newton's method.  It
is accepted if the correction is small compared with the step; otherwise it is halved.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ConstraintError, PositionError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.generated._kernels import lib
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

CURVED = 0.3  # correction of a step, relative to the step, above which it is halved
STILL = 1e-6  # correction in natural scales that is always accepted
SHORTEST = 1e-7  # shortest step, relative to the whole way


def travelled(kinematics: Kinematics, start: Snapshot, t: float, q: Array) -> Snapshot | None:
    """Find the position at time t with degrees of freedom q (nq,) from a nearby position; None if it is not reached.

    Its rates are zero.
    """
    here, done, step = start.still(start.t), 0.0, 1.0
    begin = kinematics.values(start.e, start.x)[kinematics.roles.dofs]
    while done < 1.0:
        share = min(done + step, 1.0)
        there = _stepped(kinematics, here, start.t + share * (t - start.t), begin + share * (q - begin))
        if there is None:
            step /= 2
            if step < SHORTEST:
                return None
        else:
            here, done, step = there, share, 2 * step
    return here


def _stepped(kinematics: Kinematics, here: Snapshot, t: float, q: Array) -> Snapshot | None:
    """Take one step; return None if no position is found, or it may be on another branch."""
    weight = kinematics.lists.step_weight
    try:
        change = _tangent(kinematics, here, t, q)
        x = here.x.copy()
        x[: change.size] += change
        e = here.e + _rates(kinematics, here, change)
        choice = kinematics.locate(t, q, x, e)
    except (PositionError, ConstraintError):
        return None
    work = choice.work
    corrected = float(np.max(np.abs(work.x - x)[: change.size] * weight, initial=0.0))
    if corrected > CURVED * float(np.max(np.abs(change) * weight, initial=0.0)) + STILL:
        return None
    return replace(here, t=t, x=work.x.copy(), e=work.e.copy())


def _tangent(kinematics: Kinematics, here: Snapshot, t: float, q: Array) -> Array:
    """Return the change (nf,) of the free coordinates along the tangent, for given degrees of freedom and motions."""
    choice: CoordinateWork = kinematics.given(t)
    choice.reset()
    choice.work.x[:], choice.work.unwrap_from[:] = here.x, here.e
    choice.work.position()
    kinematics.check(choice.factorize(), t)
    wanted = kinematics.target(kinematics.roles.motion(t), q)
    present = kinematics.values(choice.work.e, here.x)[kinematics.roles.position_rows]
    change, space = wanted - present, np.zeros(wanted.size)
    pointers = (choice.work.pointer_of(vector) for vector in (change, change, space))
    lib.flexel_matrix_solve(choice.P, 1, *pointers)
    return change


def _rates(kinematics: Kinematics, here: Snapshot, change: Array) -> Array:
    """Return the change (m,) of the deformations, to first order."""
    whole = np.zeros(here.x.size)
    whole[: change.size] = change
    return kinematics.choice.work.jvp(whole)[: here.e.size]


def motions(kinematics: Kinematics, here: Snapshot) -> Array:
    """Return the motions (nq, m + k + n) of all quantities if each degree of freedom changes by its natural scale.

    Slips have no values, and none.
    """
    dofs, structure = kinematics.roles.dofs, kinematics.structure
    begin = kinematics.values(here.e, here.x)[dofs]
    found = np.zeros((dofs.size, here.x.size + structure.m + structure.k))
    still = _tangent(kinematics, here, here.t, begin)
    for row, step in zip(found, np.diag(kinematics.scales(dofs)), strict=True):
        change = _tangent(kinematics, here, here.t, begin + step) - still
        row[: here.e.size] = _rates(kinematics, here, change)
        row[structure.m + structure.k :][: change.size] = change
    return found
