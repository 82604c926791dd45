"""Chooses the rates at the start of a motion: the given ones, and the others as a person would expect them.

Given rates and those of prescribed motions hold.  If they leave a choice, deformations with a law do not change, then
other free deformations do not; the remaining rates minimize the kinetic energy.  The result does not depend on the
choice of the degrees of freedom.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.sparse import block_array, diags_array, eye_array, vstack

from flexel.base.arguments import numbers
from flexel.base.arrays import Array, Index
from flexel.base.errors import DynamicsError, PositionError
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.solvers import factorize, least
from flexel.mechanics.kinematics import Kinematics
from flexel.model.structure import Structure

HELD = 1e-14  # softness of conditions, which may be redundant
DEPENDENT = 1e-9  # relative size of a given rate that counts as dependent on others
LIGHT = 1e-9  # weight of directions that a level does not concern
SWEEPS = 4  # each reduces the error left by the weight to this share
CONSISTENT = 1e-9  # error of a given rate, relative to the largest, above which it is contradictory


def consistent_rates(kinematics: Kinematics, choice: CoordinateWork, rates: Mapping[str, float]) -> Array:
    """Find rates q_d' (nd,) that give the named rates, and the expected ones elsewhere, at a position that was located.

    Raises
    ------
    ModelError, PositionError
        Rates that are not finite; rates that contradict one another or the constraints.
    """
    structure, nd, work = kinematics.structure, kinematics.roles.nd, choice.work
    given = numbers(rates, "initial rates", "rate")
    rows = np.array([structure.find(name, "initial rates") for name in given], dtype=np.intp)
    wanted, still = np.array(list(given.values())), np.zeros(nd)

    def rates_of(qd: Array) -> Array:
        v = kinematics.velocity(choice, qd)
        return np.concatenate([work.jvp(v), v])

    first, dynamic = rates_of(still), kinematics.roles.dynamic
    if not nd or not (np.any(wanted) or np.any(first)):
        qd, found = still, first
    elif np.array_equal(np.sort(rows), np.sort(dynamic)):
        qd = wanted[[rows.tolist().index(row) for row in dynamic]]
        found = rates_of(qd)
    else:
        work.inertia()
        v = _expected(kinematics, choice, first, rows, wanted)
        qd = np.concatenate([work.jvp(v), v])[dynamic]
        found = rates_of(qd)
        if not kinematics.lists.saddle:  # for the last digit of the given rates
            found = rates_of(qd + least(choice.unit_rates(rows), wanted - found[rows], DEPENDENT))
            qd = choice.qd.copy()
    off = np.abs(wanted - found[rows])
    scale = np.abs(np.concatenate([wanted, first, found])).max(initial=1e-12)
    if off.size and off.max() > CONSISTENT * scale:
        wrong = zip(given.items(), off, strict=True)
        listed = [
            f"'{name}' cannot be {rate:g}" for (name, rate), error in wrong if error > CONSISTENT * scale
        ]
        raise PositionError(
            f"initial rates are inconsistent: {', '.join(listed)} together with the others and the constraints "
            f"(off by {off.max():.3g}); give at most {nd} independent rates"
        )
    return qd


def held_still(structure: Structure) -> tuple[Index, Index]:
    """Return the deformations that keep their values at the start if possible: those with laws, and the others.

    Contacts are left out: touching bodies may slide and separate.
    """
    acting = [[structure.find(name) for name in law.deformations] for law in structure.laws]
    touching = {i for rows in acting if any(structure.kinds[i] == "gap" for i in rows) for i in rows}
    elastic = {i for rows in acting for i in rows} - touching
    other = {i for i in range(structure.m) if structure.kinds[i] not in ("gap", "norm")} - elastic - touching
    return np.array(sorted(elastic), dtype=np.intp), np.array(sorted(other), dtype=np.intp)


def _expected(
    kinematics: Kinematics, choice: CoordinateWork, first: Array, rows: Index, wanted: Array
) -> Array:
    """Find rates v (n,): level by level the least rates of some quantities, among those least in earlier levels.

    Parameters
    ----------
    first : ndarray (m + k + n,)
        Rates that satisfy the constraints.
    rows : ndarray of int (r,), wanted : ndarray (r,)
        Quantities whose rates are given.
    """
    structure, roles, tables = kinematics.structure, kinematics.roles, kinematics.evaluation.tables
    nf, slips = structure.nf, structure.m + structure.k
    x_scale = kinematics.scales(slips + np.arange(nf))
    J = tables.J.matrix(choice.work.J)[:, :nf] @ diags_array(x_scale)
    M = diags_array(x_scale) @ tables.M.matrix(choice.work.M)[:nf, :nf] @ diags_array(x_scale)
    held = np.concatenate([roles.holonomic, roles.zero])
    elastic, free = (np.setdiff1d(part, held) for part in held_still(structure))
    u, hard, kept = first[slips : slips + nf] / x_scale, _scaled(kinematics, J, held), first[held]
    kept = kept / kinematics.scales(held)
    for level, target in ((rows, wanted), (elastic, np.zeros(elastic.size)), (free, np.zeros(free.size))):
        D, target = _scaled(kinematics, J, level), target / kinematics.scales(level)
        u = _least(D.T @ D, D.T @ target, hard, kept, u)
        reached = D @ u
        exact = np.abs(reached - target) <= CONSISTENT * np.abs(u).max(initial=0.0)
        hard, kept = vstack([hard, D]).tocsr(), np.concatenate([kept, np.where(exact, target, reached)])
    v = np.zeros(structure.n)
    v[:nf] = x_scale * _least(M, np.zeros(nf), hard, kept, u)
    return v


def _scaled(kinematics: Kinematics, J: Any, rows: Index) -> Any:
    """Return the rows of a sparse matrix, relative to the natural scales of their quantities."""
    return diags_array(1 / kinematics.scales(rows)) @ J.tocsr()[rows]


def _least(K: Any, f: Array, hard: Any, kept: Array, u: Array) -> Array:
    """Return the vector (n,) near u that minimizes u' K u/2 - f' u, with `hard` u = `kept`; sparse matrices."""
    size = float(abs(K).max()) if K.nnz else 0.0
    if not size:
        return u
    K, f = K / size, f / size
    n, h = K.shape[0], hard.shape[0]
    corner = -HELD * eye_array(h) if h else None
    blocks = [[K + LIGHT * eye_array(n), hard.T], [hard, corner]] if h else [[K + LIGHT * eye_array(n)]]
    factors = factorize(block_array(blocks))
    if not factors.regular:
        raise DynamicsError(
            "the rates at the start cannot be determined; give the rate of every degree of freedom"
        )
    for _ in range(SWEEPS):
        u = u + factors.solve(np.concatenate([f - K @ u, kept - hard @ u]))[:n]
    return u
