"""The Jacobian of the equations of motion in minimal coordinates, for implicit methods."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.linearize import linearized
from flexel.mechanics.modes import first_order
from flexel.model.snapshot import Snapshot


def jacobian(kinematics: Kinematics, now: Snapshot, z: Array) -> Array:
    """Compute the derivatives (ny, ny) of the rates of y = (q_d, q_k, q_d', z) by y, from the linearization.

    Raises
    ------
    TangentError
        If a law has no slope there.
    ConstraintError, InertiaError
        As in `linearize`.
    """
    nd, nq = kinematics.roles.nd, kinematics.roles.nq
    state = dynamics.complete(kinematics, now.t, now.x, now.v, now.e, z)
    found = linearized(kinematics, kinematics.linearizer.rows([state]))
    blocks = found.blocks | (found.all_internal_states() if z.size else {})
    of = {name: block[0] for name, block in blocks.items()}
    forces, rolling, internal = ("C", "K", "Z"), ("A_k", "B_k"), ("Z_v", "Z_q", "Z_z")
    sides = ([of[name] for name in names if name in of] for names in (forces, rolling, internal))
    A = first_order(of["M"], *filter(None, sides))
    order = np.concatenate([np.arange(nd, nd + nq), np.arange(nd), np.arange(nd + nq, len(A))])
    return np.asarray(A[order][:, order])  # states are ordered (q_d', q_d, q_k, z) there
