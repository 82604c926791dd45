"""Computes the rates just after a jump of prescribed rates.

Forces of laws and loads are finite, so only constraints act: M (v+ - v-) + C' p = 0 together with C v+ = u'+.  Of
all rates that satisfy the constraints, v+ minimizes the kinetic energy of v+ - v-.  Source: Pars (1965),
chapter 14.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import block_array

from flexel.engine.solvers import factorize
from flexel.mechanics.actuation import refuse_jumps
from flexel.mechanics.inertia import unmoved
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot


def struck(kinematics: Kinematics, before: Snapshot, t: float) -> Snapshot:
    """Return the instant just after prescribed rates have jumped.

    Parameters
    ----------
    kinematics : Kinematics
    before : Snapshot
        The instant just before.
    t : float
        A time [s] just after the jump, at which the prescribed rates are evaluated.

    Raises
    ------
    ConstraintError, InertiaError
        Prescribed rates that contradict the constraints; a degree of freedom without inertia.
    DynamicsError
        If actuators hold a path: their forces are finite.
    """
    structure, roles, tables = kinematics.structure, kinematics.roles, kinematics.evaluation.tables
    refuse_jumps(structure, roles, t)
    nf = structure.nf
    choice = kinematics.given(t)
    work = choice.work
    choice.reset()
    work.x[:], work.unwrap_from[:] = before.x, before.e
    work.position()  # what was evaluated last may be a state within the step, for what is stored
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
    return Snapshot(before.t, before.x, v, before.e, work.jvp(v)[: before.e.size])
