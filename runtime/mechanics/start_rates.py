"""Rates at the start of a motion: those that are given, and the others as a person would expect them.

Rates that are given by name and those of prescribed motions hold.  Where they leave a choice, deformations with a law
do not change, then other free deformations do not; what is left has the least kinetic energy.  The result does not
depend on the choice of the degrees of freedom.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.sparse import block_array, diags_array, eye_array, vstack

from flexel.base.arguments import numbers
from flexel.base.arrays import Array, Index
from flexel.base.errors import PositionError
from flexel.engine.choice import Choice
from flexel.engine.solvers import factorize
from flexel.mechanics.kinematics import Kinematics
from flexel.structure.structure import Structure

UNHELD = "gap", "norm"  # kinds of deformations that are not kept from changing
HELD = 1e-14  # softness of conditions, which may be redundant
LIGHT = 1e-9  # weight of directions that a level does not concern
SWEEPS = 4  # each takes away all but that share of what the weight leaves
CONSISTENT = 1e-9  # error of a given rate, relative to the largest, from which it is contradictory


def consistent_rates(kinematics: Kinematics, choice: Choice, rates: Mapping[str, float]) -> Array:
    """Rates q_d' (nd,) that give the named rates, and the expected ones elsewhere, at a position that was located.

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
        return np.concatenate([work.push(v), v])

    first = rates_of(still)
    if not nd or not (np.any(wanted) or np.any(first)):
        qd, found = still, first
    else:
        work.inertia()
        v = _expected(kinematics, choice, first, rows, wanted)
        qd = np.concatenate([work.push(v), v])[kinematics.roles.dynamic]
        place = {int(row): i for i, row in enumerate(kinematics.roles.dynamic)}
        for row, rate in zip(rows.tolist(), wanted, strict=True):
            if row in place and abs(qd[place[row]] - rate) <= CONSISTENT * abs(rate):
                qd[place[row]] = rate  # to the last digit
        found = rates_of(qd)
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


def resisted(structure: Structure) -> Index:
    """Deformations (r,) on which a law acts, without gaps of contacts."""
    names = dict.fromkeys(name for law in structure.laws for name in law.deformations)
    found = np.array([structure.find(name) for name in names], dtype=np.intp)
    return found[[structure.kinds[i] != "gap" for i in found]]


def _expected(kinematics: Kinematics, choice: Choice, first: Array, rows: Index, wanted: Array) -> Array:
    """Rates v (n,): level by level the least rates of some quantities, among those that are least in earlier levels.

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
    elastic = np.setdiff1d(resisted(structure), held)
    every = np.array([i for i in range(structure.m) if structure.kinds[i] not in UNHELD], dtype=np.intp)
    free = np.setdiff1d(every, held)
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
    """Rows of a sparse matrix, relative to the natural scales of their quantities."""
    return diags_array(1 / kinematics.scales(rows)) @ J.tocsr()[rows]


def _least(K: Any, f: Array, hard: Any, kept: Array, u: Array) -> Array:
    """The vector (n,) near u that makes u' K u/2 - f' u least, with `hard` u = `kept`; sparse matrices."""
    size = float(abs(K).max()) if K.nnz else 0.0
    if not size:
        return u
    K, f = K / size, f / size
    n, h = K.shape[0], hard.shape[0]
    corner = -HELD * eye_array(h) if h else None
    blocks = [[K + LIGHT * eye_array(n), hard.T], [hard, corner]] if h else [[K + LIGHT * eye_array(n)]]
    factors = factorize(block_array(blocks))
    for _ in range(SWEEPS):
        u = u + factors.solve(np.concatenate([f - K @ u, kept - hard @ u]))[:n]
    return u
