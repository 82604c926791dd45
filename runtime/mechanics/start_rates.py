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
from flexel.engine.solvers import factorize, least, singular_values
from flexel.mechanics.kinematics import Kinematics

HELD = 1e-14  # softness of conditions, which may be redundant
DEPENDENT = 1e-9  # relative size of a given rate that counts as dependent on others
LIGHT = 1e-9  # weight of directions that a level does not concern, relative to its largest square
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
        qd = _expected(kinematics, choice, first, rows, wanted)
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


def _expected(
    kinematics: Kinematics, choice: CoordinateWork, first: Array, rows: Index, wanted: Array
) -> Array:
    """Find q_d' (nd,): level by level the least rates of some quantities, among those least in earlier levels.

    Parameters
    ----------
    first : ndarray (m + k + n,)
        Rates that satisfy the constraints, about which unknowns u are counted: the rates are first + N u.
    rows : ndarray of int (r,), wanted : ndarray (r,)
        Quantities whose rates are given.
    """
    structure, roles = kinematics.structure, kinematics.roles
    v = structure.m + structure.k + np.arange(structure.nf)
    N, unknowns = (_constrained if kinematics.lists.saddle else _independent)(kinematics, choice)
    for level, target in ((rows, wanted), *((level, 0.0) for level in kinematics.kept_at_start)):
        if level.size:
            scale = kinematics.scales(level)
            unknowns.reduce(_rows(N, level, scale), (target - first[level]) / scale)
    if unknowns.left:
        M = kinematics.evaluation.tables.M.matrix(choice.work.M)[: v.size, : v.size]
        unknowns.minimize(N[v].T @ (M @ N[v]), -N[v].T @ (M @ first[v]))
    return np.asarray((first + N @ unknowns.u)[roles.dynamic])


def _rows(N: Any, rows: Index, scale: Array) -> Any:
    """Return rows of a matrix, relative to scales."""
    return N[rows] / scale[:, None] if isinstance(N, np.ndarray) else diags_array(1 / scale) @ N[rows]


def _independent(kinematics: Kinematics, choice: CoordinateWork) -> tuple[Array, FewUnknowns]:
    """Return N (m + k + n, nd) and unknowns where they are the degrees of freedom, in their natural scales."""
    dynamic = kinematics.roles.dynamic
    N = choice.unit_rates(np.arange(kinematics.structure.m + kinematics.structure.k + kinematics.structure.n))
    return N * kinematics.scales(dynamic), FewUnknowns(dynamic.size)


def _constrained(kinematics: Kinematics, choice: CoordinateWork) -> tuple[Any, ManyUnknowns]:
    """Return N (m + k + n, nf), sparse, and unknowns where they are all free coordinates, under the constraints."""
    structure, roles = kinematics.structure, kinematics.roles
    own, held = (
        structure.m + structure.k + np.arange(structure.nf),
        np.concatenate([roles.holonomic, roles.zero]),
    )
    J = kinematics.evaluation.tables.J.matrix(choice.work.J)[:, : structure.nf]
    N = (J @ diags_array(kinematics.scales(own))).tocsr()
    return N, ManyUnknowns(_rows(N, held, kinematics.scales(held)))


class FewUnknowns:
    """Few unknowns u (n,), and a basis Z (n, f) of their changes that earlier levels leave free; dense."""

    def __init__(self, n: int) -> None:
        self.u, self._free = np.zeros(n), np.eye(n)

    @property
    def left(self) -> bool:
        """Whether any change is free."""
        return self._free.size > 0

    def reduce(self, D: Array, b: Array) -> None:
        """Minimize |D u - b|."""
        U, s, V = singular_values(D @ self._free)
        rank = int(np.count_nonzero(s > LIGHT**0.5 * np.abs(D).max()))
        self.u = self.u + self._free @ (V[:rank].T @ (U[:, :rank].T @ (b - D @ self.u) / s[:rank]))
        self._free = self._free @ V[rank:].T

    def minimize(self, K: Array, f: Array) -> None:
        """Minimize u' K u/2 - f' u."""
        Z = self._free
        self.u = self.u + Z @ least(Z.T @ K @ Z, Z.T @ (f - K @ self.u), LIGHT)


class ManyUnknowns:
    """Many unknowns u (n,), and conditions hard u = kept of the constraints and of earlier levels; sparse."""

    left = True  # which are free is not known

    def __init__(self, hard: Any) -> None:
        self.u, self._hard, self._kept = np.zeros(hard.shape[1]), hard, np.zeros(hard.shape[0])

    def reduce(self, D: Any, b: Array) -> None:
        """Minimize |D u - b|, and keep what is reached."""
        self.minimize(D.T @ D, D.T @ b)
        found = D @ self.u
        exact = np.abs(found - b) <= CONSISTENT * np.abs(self.u).max(initial=0.0)
        self._hard = vstack([self._hard, D]).tocsr()
        self._kept = np.concatenate([self._kept, np.where(exact, b, found)])

    def minimize(self, K: Any, f: Array) -> None:
        """Minimize u' K u/2 - f' u."""
        size = float(abs(K).max()) if K.nnz else 0.0
        if not size:
            return
        K, f, hard, (h, n) = K / size, f / size, self._hard, self._hard.shape
        blocks = [[K + LIGHT * eye_array(n), hard.T], [hard, -HELD * eye_array(h)]]
        factors = factorize(block_array(blocks if h else [blocks[0][:1]]))
        if not factors.regular:
            raise DynamicsError(
                "the rates at the start cannot be determined; give the rate of every degree of freedom"
            )
        for _ in range(SWEEPS):
            self.u = self.u + factors.solve(np.concatenate([f - K @ self.u, self._kept - hard @ self.u]))[:n]
