"""Counts and names over- and under-constraint of a mechanism, where `Model.build` would raise an error.

The left null space of the rigid conditions holds the states of self-stress: redundant conditions, through which a
misalignment would load the mechanism.  The right null space holds the motions.  The conditions to release are found
as in SPACAR Light: repeatedly the one with the largest share in the remaining redundancy.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.linalg import qr
from scipy.sparse import issparse

from flexel.base.arrays import Array, Index
from flexel.base.null_space import RANK_TOLERANCE, null_space
from flexel.base.shown import prints, quoted
from flexel.derive.spec import LawSpec
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure, declared

_issparse: Any = issparse
SHARE_DIGITS = 9  # of shares that are compared: equal ones stay in the order of the model
MIN_SHARE_SHOWN = 0.02  # smallest share listed, relative to the largest
MIN_SHARE = 1e-6  # smallest share of a condition that counts as part of a self-stress


@dataclass(frozen=True)
class ConstraintReport:
    """The constraints of a mechanism at a configuration.

    Attributes
    ----------
    dofs : int
        Independent motions that the rigid and prescribed conditions leave.
    motions : list of dict
        Those that no elastic law resists either (under-constraint), by coordinates, the largest scaled to 1.
    redundant : list of dict
        States of self-stress (over-constraint): shares of the redundant conditions, the largest scaled to 1.
    release : list of str
        Conditions whose release removes all redundancy: of otherwise flexible beams if these suffice, then of joints,
        then of rigid beams.
    alternatives : dict of str to list of str
        For each of `release`, the conditions that may be released instead: together they form a smallest set
        of dependent conditions.  All other sets of releases follow from such exchanges, one at a time.
    added : frozenset of str
        Quantities of the points and links that joints add to bodies, printed only if nothing else is concerned.
    """

    dofs: int
    motions: list[dict[str, float]]
    redundant: list[dict[str, float]]
    release: list[str]
    alternatives: dict[str, list[str]] = field(default_factory=dict)
    added: frozenset[str] = field(default=frozenset(), repr=False)

    @prints
    def __repr__(self) -> str:
        lines = [f"{self.dofs} degree(s) of freedom left by the rigid conditions"]
        lines += [f"over-constrained: {self._shares(shares)}" for shares in self.redundant]
        lines += [f"nothing resists: {self._shares(shares)}" for shares in self.motions]
        if self.release:
            lines.append(f"release {quoted(self.release)}")
        lines += [
            f"alternatives to '{name}': {quoted(declared(others, self.added)) or 'none'}"
            for name, others in self.alternatives.items()
        ]
        return "\n".join(lines)

    def _shares(self, vector: dict[str, float]) -> str:
        return ", ".join(f"'{name}' {vector[name]:.2f}" for name in declared(vector, self.added))


def _resists(spec: LawSpec) -> bool:
    """Whether forces of a law depend on its deformations or rates; the held forces of sampled controllers do not."""
    (J,) = spec.kernels["tangent"].outputs
    own = 2 * spec.deformations + spec.slips
    return any(i % J.shape[1] < own for i in J.nonzeros)


def constraint_report(structure: Structure, roles: Roles, J: Any) -> ConstraintReport:
    """Report over- and under-constraint, from J (m + k + n, n), which is sparse for a large model."""
    if _issparse(J):
        J = J.toarray()
    rows, nf = roles.holonomic, structure.nf
    C = J[rows, :nf]
    right, left = null_space(C, nf)
    elastic = [
        structure.index[name] for law in structure.laws if _resists(law.spec) for name in law.deformations
    ]
    still = np.concatenate([rows, np.array(elastic, dtype=np.intp)])
    loose, _ = null_space(J[still, :nf], nf)
    moving = np.arange(nf) + structure.m + structure.k
    names = [structure.names[i] for i in rows]
    usable = {k for k, i in enumerate(rows) if i < structure.m and not structure.is_norm(names[k])}
    groups = [{k for k in usable if names[k] in group} for group in (flexible(structure), _joints(structure))]
    released = _releases(C, (*groups, usable))
    return ConstraintReport(
        dofs=right.shape[1],
        motions=_named(structure, moving, loose),
        redundant=_named(structure, rows, left),
        release=[names[k] for k in released],
        alternatives={
            names[k]: [names[i] for i in others if i in usable]
            for k, others in zip(released, _exchanges(C, released), strict=True)
        },
        added=structure.added,
    )


def _named(structure: Structure, rows: Index, space: Array) -> list[dict[str, float]]:
    """Return vectors that span a null space, made sparse by elimination, largest entries first."""
    if not space.shape[1]:
        return []
    _, R, pivots = qr(space.T, mode="economic", pivoting=True)
    count = space.shape[1]
    echelon = np.empty_like(R)
    echelon[:, pivots] = np.linalg.solve(R[:, :count], R)
    found = []
    for vector in echelon:
        weight = (np.abs(vector) / np.max(np.abs(vector))).round(SHARE_DIGITS)
        share = vector / vector[int(np.argmax(weight))]
        order = [i for i in np.argsort(-weight, kind="stable") if weight[i] > MIN_SHARE_SHOWN]
        named = {structure.names[rows[i]]: float(share[i]) for i in order}
        found.append({name: v for name, v in named.items() if not structure.is_norm(name)} or named)
    return found


def flexible(structure: Structure) -> set[str]:
    """Return the deformations of arms that have flexible ones, such as those of beams."""
    bending = {name.split(".")[0] for law in structure.laws for name in law.deformations}
    return {
        d
        for instance in structure.instances
        if instance.spec.arm and instance.name in bending
        for d in instance.deformations
    }


def _joints(structure: Structure) -> set[str]:
    """Return the deformations of all elements but the arms of bodies."""
    return {d for instance in structure.instances if not instance.spec.arm for d in instance.deformations}


def _releases(C: Array, groups: tuple[set[int], ...]) -> list[int]:
    """Choose rows of C to release, each the one with the largest share in the remaining redundancy.

    Rows of the first group come first; if they are not enough, those of the next group follow.
    """
    kept = list(range(C.shape[0]))
    released: list[int] = []
    while True:
        _, left = null_space(C[kept], C.shape[1])
        found = _largest_shares(kept, left, groups) if left.size else []
        if not found:
            return released
        released += found
        kept = [k for k in kept if k not in found]


def _exchanges(C: Array, released: list[int]) -> list[list[int]]:
    """Return, for each released row of C, the kept rows it depends on: each of them can be released instead."""
    size = np.linalg.norm(C, axis=1, keepdims=True)
    rows = C / np.where(size > 0, size, 1.0)
    kept = np.setdiff1d(np.arange(C.shape[0]), released)
    if not released or not kept.size:
        return [[] for _ in released]
    shares = np.linalg.lstsq(rows[kept].T, rows[released].T, rcond=RANK_TOLERANCE)[0]
    return [kept[np.abs(column) > MIN_SHARE].tolist() for column in shares.T]


def _largest_shares(kept: list[int], left: Array, groups: tuple[set[int], ...]) -> list[int]:
    """Choose rows that remove a left null space (kept, l), one by one; from the first group while it has a share."""
    kept, found = list(kept), []
    while left.shape[1]:
        share = np.linalg.norm(left, axis=1)
        concerned = [k for k in range(len(kept)) if share[k] > MIN_SHARE]
        candidates = next(
            (members for g in groups if (members := [k for k in concerned if kept[k] in g])), []
        )
        if not candidates:
            break
        worst = max(candidates, key=lambda k: round(float(share[k]), 9))
        found.append(kept.pop(worst))
        # the states of self-stress without a share of the released condition remain
        others = np.linalg.qr(left[worst][:, None], mode="complete")[0][:, 1:]
        left = np.delete(left, worst, axis=0) @ others
    return found
