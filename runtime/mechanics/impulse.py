"""The impulse of prescribed rates that jump: the rates just after it.

Forces of laws and loads are finite, so that only constraints act: M (v+ - v-) + C' p = 0 together with C v+ = u'+.  Of
all rates that satisfy the constraints, v+ are those with the least kinetic energy of v+ - v-.  Source: Pars (1965),
chapter 14.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import block_array

from flexel.engine.solvers import factorize
from flexel.mechanics.inertia import unmoved
from flexel.mechanics.kinematics import Kinematics
from flexel.structure.moment import Moment


def struck(kinematics: Kinematics, before: Moment, t: float) -> Moment:
    """The instant just after prescribed rates have jumped.

    Parameters
    ----------
    kinematics : Kinematics
    before : Moment
        The instant just before.
    t : float
        A time [s] just after the jump, at which the prescribed rates are evaluated.

    Raises
    ------
    ConstraintError, InertiaError
        Prescribed rates that contradict the constraints; a degree of freedom without inertia.
    """
    structure, roles, tables = kinematics.structure, kinematics.roles, kinematics.evaluation.tables
    nf = structure.nf
    choice = kinematics.given(t)
    work = choice.work
    work.x[:], work.near[:] = before.x, before.e
    kinematics.check(choice.directions(), t)
    driven = kinematics.velocity(
        choice, np.zeros(roles.nd)
    )  # v+ = driven + a motion that the constraints admit
    work.inertia()
    M = tables.M.matrix(work.M)[:nf, :nf]
    C = tables.J.matrix(work.J)[:, :nf][np.concatenate([roles.holonomic, roles.zero])]
    rhs = np.concatenate([M @ (before.v - driven)[:nf], np.zeros(C.shape[0])])
    factors = factorize(block_array([[M, C.T], [C, None]]))
    if not factors.regular:
        raise unmoved(None)
    v = driven
    v[:nf] += factors.solve(rhs)[:nf]
    return Moment(before.t, before.x, v, before.e, work.push(v)[: before.e.size])
