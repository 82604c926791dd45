"""Over- and under-constraint of a mechanism, counted and named, where `Model.build` would raise an error.

The left null space of the rigid conditions holds the states of self-stress: redundant conditions, through which a
misalignment would load the mechanism.  The right null space holds the motions.  The conditions to release are found
as in SPACAR Light: repeatedly the one with the largest share in the remaining redundancy.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import qr

from flexel.base.arrays import Array, Index
from flexel.declare.declarations import Declarations
from flexel.declare.resolution import norms, resolve_roles
from flexel.engine.evaluate import Evaluation
from flexel.mechanics.diagnose import null_space
from flexel.structure.roles import Roles
from flexel.structure.state import State
from flexel.structure.structure import Structure, assemble_structure

SHOWN = 0.02  # smallest share that is listed, relative to the largest


@dataclass(frozen=True)
class ConstraintReport:
    """How a mechanism is constrained at a configuration.

    Attributes
    ----------
    dofs : int
        Independent motions that the rigid and prescribed conditions leave.
    motions : list of dict
        Those that no elastic law resists either (under-constraint), by coordinates, the largest scaled to 1.
    redundant : list of dict
        States of self-stress (over-constraint): shares of the redundant conditions, the largest scaled to 1.
    release : list of str
        Conditions whose release removes all redundancy, preferably of beams that are otherwise flexible.
    """

    dofs: int
    motions: list[dict[str, float]]
    redundant: list[dict[str, float]]
    release: list[str]

    def __str__(self) -> str:
        lines = [f"{self.dofs} degree(s) of freedom left by the rigid conditions"]
        lines += [f"over-constrained: {_shares(z)}" for z in self.redundant]
        lines += [f"nothing resists: {_shares(z)}" for z in self.motions]
        if self.release:
            lines.append("release " + ", ".join(f"'{z}'" for z in self.release))
        return "\n".join(lines)


def report_of_model(model: Declarations) -> ConstraintReport:
    """Over- and under-constraint of a model as drawn; see `Model.constraint_report`."""
    elements = [*model.instances.values(), *norms(model)]
    structure = assemble_structure(model.nodes.values(), elements, model.laws)
    _, J = Evaluation(structure).position(structure.x0)
    return _report(structure, resolve_roles(model, structure), J)


def report_of_state(state: State) -> ConstraintReport:
    """Over- and under-constraint at a state; see `State.constraint_report`."""
    return _report(state.structure, state.roles, state.J)


def _report(structure: Structure, roles: Roles, J: Array) -> ConstraintReport:
    rows, nf = roles.holonomic, structure.nf
    C = J[rows, :nf]
    right, left = null_space(C, nf)
    elastic = [structure.index[z] for law in structure.laws for z in law.deformations]
    still = np.concatenate([rows, np.array(elastic, dtype=np.intp)])
    loose, _ = null_space(J[still, :nf], nf)
    moving = np.arange(nf) + structure.m + structure.k
    return ConstraintReport(
        dofs=right.shape[1],
        motions=_named(structure, moving, loose),
        redundant=_named(structure, rows, left),
        release=_releases(structure, rows, C),
    )


def _named(structure: Structure, rows: Index, space: Array) -> list[dict[str, float]]:
    """Vectors that span a null space, made sparse by elimination, largest entries first."""
    if not space.shape[1]:
        return []
    _, R, pivots = qr(space.T, mode="economic", pivoting=True)
    count = space.shape[1]
    echelon = np.empty_like(R)
    echelon[:, pivots] = np.linalg.solve(R[:, :count], R)
    found = []
    for vector in echelon:
        share = vector / vector[int(np.argmax(np.abs(vector)))]
        order = [i for i in np.argsort(-np.abs(share), kind="stable") if abs(share[i]) > SHOWN]
        named = {structure.names[rows[i]]: float(share[i]) for i in order}
        found.append({z: v for z, v in named.items() if not structure.is_norm(z)} or named)
    return found


def _releases(structure: Structure, rows: Index, C: Array) -> list[str]:
    """Conditions to release, each the one with the largest share in the remaining redundancy."""
    bending = {z.split(".")[0] for law in structure.laws for z in law.deformations}
    flexible = {
        d
        for z in structure.instances
        if z.spec.family == "beam" and z.name in bending
        for d in z.deformations
    }
    usable = [i for i in range(rows.size) if structure.names[rows[i]] in flexible]
    usable = usable or [i for i in range(rows.size) if rows[i] < structure.m]
    kept = list(range(rows.size))
    released: list[str] = []
    while True:
        _, left = null_space(C[kept], C.shape[1])
        share = np.linalg.norm(left, axis=1)
        candidates = [k for k, i in enumerate(kept) if i in usable and share[k] > 1e-6] if left.size else []
        if not candidates:
            return released
        worst = max(candidates, key=lambda k: round(float(share[k]), 9))
        released.append(structure.names[rows[kept.pop(worst)]])


def _shares(vector: dict[str, float]) -> str:
    return ", ".join(f"'{name}' {share:.2f}" for name, share in vector.items())
