"""Counts constraints, checks ranks with names, and chooses independent coordinates automatically.

Null spaces identify the error: a left null vector of the constraint matrix is a redundant set of
conditions, a right null vector is an uncontrolled motion.  Both are reported by the names of their
largest entries.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import qr
from scipy.sparse import block_array, coo_array, csr_array, issparse
from scipy.sparse.csgraph import connected_components

from flexel.base.arguments import names as checked_names
from flexel.base.arrays import Array, Index
from flexel.base.blas import in_one_thread
from flexel.base.errors import ConstraintError, ModelError
from flexel.base.null_space import null_space
from flexel.base.shown import quoted
from flexel.engine.solvers import factorize
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.preference import earliness, heaviness, preferences
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure, declared

log = logging.getLogger("flexel.build")
_block_array: Any = block_array
SINGULAR = "no independent coordinates can be chosen here: the position is singular"


def largest(structure: Structure, rows: Index, vector: Array, limit: int = 6) -> list[str]:
    """Name the quantities with the largest entries of a null vector: those that were declared, if there are any."""
    weight = np.abs(vector) / max(float(np.max(np.abs(vector))), 1e-300)
    order = [i for i in np.argsort(-weight, kind="stable") if weight[i] > 0.05]
    names = [structure.names[rows[i]] for i in order]
    names = [name for name in names if not structure.is_norm(name)] or names
    return declared(names, structure.added)[:limit]


def check_redundancy(structure: Structure, roles: Roles, J: Array, rows: Index, what: str) -> None:
    """Raise if the constraint rows are dependent, naming the redundant conditions.

    Raises
    ------
    ConstraintError
    """
    _report_redundancy(structure, roles, rows, null_space(J[rows, : structure.nf], structure.nf)[1], what)


def _report_redundancy(structure: Structure, roles: Roles, rows: Index, left: Array, what: str) -> None:
    """Raise if there are left null vectors (rows, l) of the constraint rows."""
    if not left.shape[1]:
        return
    concerned, count = [largest(structure, rows, column) for column in left.T], left.shape[1]
    log.info("not independent: %s", "; ".join(map(quoted, concerned)))
    names = list(dict.fromkeys(name for each in concerned for name in each))
    mine = [name for name in names if structure.find(name) not in roles.prescribed]
    mine.sort(key=lambda name: structure.find(name) not in roles.zero)  # slips are released first
    remedy = f"m.release('{mine[0]}')" if mine else f"without m.prescribe('{names[0]}', …)"
    raise ConstraintError(
        f"over-constrained: {count} {what} {'is' if count == 1 else 'are'} redundant, among "
        f"{quoted(names[:10])}; release {'one' if count == 1 else str(count)} of them "
        f"(for example {remedy})"
    )


def candidates(structure: Structure, roles: Roles) -> Index:
    """Return the candidates for degrees of freedom: free coordinates and deformations, except those with a kink."""
    taken = {*roles.rigid, *roles.prescribed, *structure.kinked}
    first = structure.m + structure.k
    rows = [*range(structure.m), *range(first, first + structure.nf)]
    return np.array([i for i in rows if i not in taken], dtype=np.intp)


def pick(kinematics: Kinematics, J: Array, space: Array, exclude: Index) -> Index:
    """Choose quantities whose rates best span a space of velocities, by QR with column pivoting.

    Parameters
    ----------
    J : ndarray (m + k + n, n)
    space : ndarray (nf, r)
        Basis of the admissible velocities not yet described.
    exclude : ndarray of int
        Quantities already chosen.

    Returns
    -------
    ndarray of int (r,)
    """
    structure = kinematics.structure
    if not space.shape[1]:
        return np.zeros(0, dtype=np.intp)
    rows = np.setdiff1d(candidates(structure, kinematics.roles), exclude)
    heavy = heaviness(kinematics, rows)
    weight = preferences(kinematics, rows) * heavy * earliness(rows.size)
    first = structure.m + structure.k
    scales = kinematics.scales(slice(first, first + structure.nf))
    own = scales[:, None] * in_natural_scales(space, scales)
    S = (J[rows, : structure.nf] @ own) * weight[:, None]
    _, R, pivots = qr(S.T, mode="economic", pivoting=True)
    independent = np.abs(np.diag(R)) / heavy[pivots[: len(R)]]
    if independent.size < space.shape[1] or independent.min() < 1e-9 * independent.max():
        raise ConstraintError(SINGULAR)
    return np.sort(rows[pivots[: space.shape[1]]])


def in_natural_scales(space: Array, scales: Array) -> Array:
    """Return a basis (n, r) of the same velocities that is orthonormal in natural scales: units do not matter."""
    return np.asarray(np.linalg.qr(space / scales[:, None])[0])


def named_dofs(structure: Structure, names: Sequence[str] | None, owner: str) -> Index | None:
    """Return the indices of named degrees of freedom: movable coordinates or deformations, each once."""
    if names is None:
        return None
    if len(set(checked_names(names, owner))) < len(names):
        doubles = sorted({name for name in names if list(names).count(name) > 1})
        raise ModelError(f"{owner}: {quoted(doubles)} named twice; name each once")
    found = np.array([structure.find(name, owner) for name in names], dtype=np.intp)
    first = structure.m + structure.k
    for name, i in zip(names, found, strict=True):
        if structure.m <= i < first or i >= first + structure.nf:
            what = "a slip" if i < first else "fixed"
            raise ModelError(
                f"{owner}: '{name}' is {what}, not a degree of freedom; name movable coordinates or deformations"
            )
    return found


@in_one_thread
def choose_dofs(kinematics: Kinematics, J: Array, dynamic: Index | None, kinematic: Index | None) -> Roles:
    """Return roles with all degrees of freedom: those named by the user, checked, or an automatic choice.

    Parameters
    ----------
    J : ndarray (m + k + n, n)
        At the configuration used for the choice; sparse for a large model.
    dynamic, kinematic : ndarray of int or None
        Named degrees of freedom, which are completed if they are too few; None: chosen automatically.

    Raises
    ------
    ConstraintError
        Redundant constraints, dependent coordinates, or quantities without derivatives, by name.
    """
    structure, roles = kinematics.structure, kinematics.roles
    nf = structure.nf
    _check_defined(structure, J)
    if issparse(J):
        return choose_by_blocks(kinematics, J, dynamic, kinematic)
    check_redundancy(structure, roles, J, roles.holonomic, "rigid or prescribed condition(s)")
    rolling = np.concatenate([roles.holonomic, roles.zero])
    check_redundancy(structure, roles, J, rolling, "rolling condition(s)")
    dynamic = _completed(kinematics, J, rolling, dynamic, "dynamic", roles.prescribed)
    held = np.concatenate([roles.holonomic, dynamic])
    kinematic = _completed(kinematics, J, held, kinematic, "kinematic", dynamic)
    found = roles.with_dofs(dynamic, kinematic)
    if found.position_rows.size != nf:  # by rounding, the dynamic ones no longer describe all motions
        raise ConstraintError(SINGULAR)
    return found


def _check_defined(structure: Structure, J: Array) -> None:
    """Reject a position in which quantities have no derivatives, such as the elongation of a truss without length."""
    if np.isfinite(J.sum()):
        return
    values: Any = coo_array(J)
    names = [structure.names[i] for i in np.unique(values.row[~np.isfinite(values.data)])]
    raise ConstraintError(
        f"{quoted(names, 4)} cannot be differentiated in this position: points may coincide there; change drawn, "
        "initial or prescribed values"
    )


def _completed(
    kinematics: Kinematics, J: Array, constraints: Index, named: Index | None, kind: str, taken: Index
) -> Index:
    """Check the named degrees of freedom, and choose more for the motions that these leave."""
    nf = kinematics.structure.nf
    named = np.zeros(0, dtype=np.intp) if named is None else named
    if named.size:
        check_choice(kinematics, J, constraints, named, kind)
    rows = np.concatenate([constraints, named])
    more = pick(kinematics, J, null_space(J[rows, :nf], nf)[0], np.concatenate([taken, named]))
    return np.concatenate([named, more])


@dataclass(frozen=True)
class ConstraintBlock:
    """A connected set of constraint rows (quantities) and coordinates, and their dense matrix."""

    rows: Index
    columns: Index
    matrix: Array


def blocks(J: Any, rows: Index, nf: int) -> tuple[list[ConstraintBlock], Index]:
    """Divide the constraints of a large model into decoupled parts; return also the coordinates without constraints."""
    C = csr_array(J[rows][:, :nf])
    C.eliminate_zeros()
    count, label = connected_components(_block_array([[None, C], [C.T, None]]), directed=False)
    order = np.argsort(label, kind="stable")
    parts = np.split(order, np.searchsorted(label[order], np.arange(1, count)))
    found, free = [], []
    for part in parts:
        own, columns = part[part < rows.size], part[part >= rows.size] - rows.size
        if own.size:
            found.append(ConstraintBlock(rows[own], columns, C[own][:, columns].toarray()))
        else:
            free.append(columns)
    return found, np.concatenate(free) if free else np.zeros(0, dtype=np.intp)


def choose_by_blocks(kinematics: Kinematics, J: Any, dynamic: Index | None, kinematic: Index | None) -> Roles:
    """Choose the degrees of freedom of a large model part by part, or take named ones, or raise a `ConstraintError`."""
    roles = kinematics.roles
    rolling = np.concatenate([roles.holonomic, roles.zero])
    if kinematic is None and not roles.zero.size:
        kinematic = np.zeros(0, dtype=np.intp)
    if dynamic is not None and kinematic is not None and _determined(kinematics, J, dynamic, kinematic):
        return roles.with_dofs(dynamic, kinematic)  # then no condition is redundant
    _check_parts(kinematics, J, rolling)
    none = np.zeros(0, dtype=np.intp)
    dynamic = none if dynamic is None else dynamic
    dynamic = np.concatenate([dynamic, _left_free(kinematics, J, np.concatenate([rolling, dynamic]))])
    kinematic = none if kinematic is None else kinematic
    held = np.concatenate([roles.holonomic, dynamic, kinematic])
    kinematic = np.concatenate([kinematic, _left_free(kinematics, J, held)])
    if not _determined(kinematics, J, dynamic, kinematic):
        raise ConstraintError(
            f"the {rolling.size + dynamic.size} conditions and named coordinates do not determine the "
            f"{kinematics.structure.nf} coordinates of this model; name none and let the program choose"
        )
    return roles.with_dofs(dynamic, kinematic)


def _determined(kinematics: Kinematics, J: Any, dynamic: Index, kinematic: Index) -> bool:
    """Whether the conditions and the degrees of freedom determine velocities and positions."""
    roles, nf = kinematics.roles, kinematics.structure.nf
    sets = [np.concatenate([roles.holonomic, roles.zero, dynamic])]
    if roles.zero.size or kinematic.size:  # else the same rows
        sets.append(np.concatenate([roles.holonomic, dynamic, kinematic]))
    return all(rows.size == nf and factorize(J[rows][:, :nf]).regular for rows in sets)


def _check_parts(kinematics: Kinematics, J: Any, rolling: Index) -> None:
    """Raise if rows of the constraints are dependent, part by part."""
    structure, roles = kinematics.structure, kinematics.roles
    kinds = "rigid or prescribed condition(s)", "rolling condition(s)"
    for rows, what in zip((roles.holonomic, rolling), kinds, strict=True):
        for block in blocks(J, rows, structure.nf)[0] if rows.size else ():
            left = null_space(block.matrix, block.columns.size)[1]
            _report_redundancy(structure, roles, block.rows, left, what)


def _left_free(kinematics: Kinematics, J: Any, rows: Index) -> Index:
    """Choose coordinates that describe the motions left by the constraint rows, part by part."""
    structure = kinematics.structure
    first, nf = structure.m + structure.k, structure.nf
    if not rows.size:
        return np.arange(first, first + nf)
    parts, free = blocks(J, rows, nf)
    chosen = [first + free]
    for block in parts:
        space, _ = null_space(block.matrix, block.columns.size)
        if space.shape[1]:
            weight = earliness(block.columns.size)
            weight[np.isin(first + block.columns, block.rows)] = 0.0
            own = in_natural_scales(space, kinematics.scales(first + block.columns))
            pivots = qr((own * weight[:, None]).T, mode="economic", pivoting=True)[2]
            chosen.append(first + block.columns[pivots[: space.shape[1]]])
    return np.sort(np.concatenate(chosen))


def check_choice(kinematics: Kinematics, J: Array, constraints: Index, chosen: Index, kind: str) -> None:
    """Raise if named degrees of freedom are too many or dependent, with their names."""
    structure, nf = kinematics.structure, kinematics.structure.nf
    rows = np.concatenate([constraints, chosen])
    left = null_space(J[rows, :nf], nf)[1]
    needed = nf - constraints.size
    names = [structure.names[i] for i in chosen]
    taken = [names[i] for i in range(chosen.size) if chosen[i] in constraints]
    if taken:
        raise ConstraintError(
            f"{quoted(taken)} is constrained and cannot be a {kind} coordinate; name others"
        )
    if left.shape[1] and chosen.size > needed:
        raise ConstraintError(
            f"{chosen.size} {kind} coordinate(s) named ({quoted(names)}) but the mechanism has {needed}: "
            f"{quoted(largest(structure, rows, left[:, 0]))} depend on one another; remove {chosen.size - needed} of "
            f"{quoted(names)}"
        )
    if left.shape[1]:
        better = pick(kinematics, J, null_space(J[constraints, :nf], nf)[0], constraints)
        raise ConstraintError(
            f"{quoted(names)} cannot be the {kind} coordinate(s) in this position: "
            f"{quoted(largest(structure, rows, left[:, 0]))} depend on one another; name others, for example "
            f"{quoted([structure.names[i] for i in better])}"
        )
