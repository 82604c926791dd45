"""From a declared model to a system: roles resolved, position assembled, freedoms chosen, rates made consistent.

Imports numpy and the runtime rooms below the model.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexel.diagnose import choose_freedoms
from flexel.errors import ModelError, PositionError
from flexel.evaluate import Evaluation
from flexel.generated.table import ELEMENTS
from flexel.kinematics import Configuration, Kinematics, wrap
from flexel.loads import Loads
from flexel.roles import Roles
from flexel.structure import Array, Index, Instance, Structure, assemble_structure
from flexel.system import System

if TYPE_CHECKING:
    from flexel.model import Model

STEP = 0.2  # largest change of a wanted value (in its natural scale) in one step of the first assembly


def build(model: Model, t: float) -> System:
    """The system of a model at time t; see `Model.build`."""
    if not model.nodes:
        raise ModelError("the model has no nodes; add points and frames first")
    structure = assemble_structure(
        model.nodes.values(), [*model.instances.values(), *norms(model)], model.laws
    )
    evaluation = Evaluation(structure)
    roles = resolve_roles(model, structure)
    loads = Loads(structure, tuple(model.loads))
    check_names(model, structure, roles)
    kinematics = Kinematics(evaluation, roles)
    c = first_position(model, kinematics, t)
    chosen = choose_freedoms(
        kinematics, c.J, named(structure, model.dynamic), named(structure, model.kinematic_names)
    )
    system = System(evaluation, loads, chosen, c)
    if model.rates:
        system.initial = system.state_at(rates=model.rates)
    return system


def norms(model: Model) -> list[Instance]:
    """The norm condition of every frame that is not wholly fixed."""
    frames = [n for n in model.nodes.values() if n.kind == "frame" and not np.all(n.fixed)]
    return [Instance(n.name, ELEMENTS["norm"], (n.name,), {}) for n in frames]


def named(structure: Structure, names: list[str] | None) -> Index | None:
    """Quantity indices of named freedoms, each once."""
    if names is None:
        return None
    doubles = {z for z in names if names.count(z) > 1}
    if doubles:
        raise ModelError(f"freedom(s) {sorted(doubles)} named twice; name each once")
    return np.array([structure.find(z) for z in names], dtype=np.intp)


def resolve_roles(model: Model, structure: Structure) -> Roles:
    """Rigid, prescribed and rolling conditions, from what the user said and the elements' defaults."""
    role = {}
    for instance in structure.instances:
        frees = [z.free for z in instance.spec.deformations] + [z.free for z in instance.spec.slips]
        for name, free in zip((*instance.deformations, *instance.slips), frees, strict=True):
            role[name] = "free" if free else "rigid"
    for law in model.laws:
        for name in (*law.deformations, *law.slips):
            structure.find(name)
            role[name] = "free"
    for name, wish in model.roles.items():
        if structure.find(name) >= structure.m + structure.k:
            raise ModelError(
                f"'{name}' is a coordinate; rigid and free are roles of deformations and slips, use fix"
            )
        role[name] = wish
    for name in [*(model.dynamic or []), *(model.kinematic_names or []), *model.motions]:
        structure.find(name)
        role[name] = "free"
    rigid = [structure.index[z] for z, wish in role.items() if wish == "rigid"]
    prescribed = [structure.find(z) for z in model.motions]
    empty = np.zeros(0, dtype=np.intp)
    return Roles(
        rigid=np.array(sorted(i for i in rigid if i < structure.m), dtype=np.intp),
        prescribed=np.array(prescribed, dtype=np.intp),
        motions=tuple(model.motions.values()),
        zero=np.array(sorted(i for i in rigid if i >= structure.m), dtype=np.intp),
        dynamic=empty,
        kinematic=empty,
    )


def check_names(model: Model, structure: Structure, roles: Roles) -> None:
    """Contradictions between roles, loads and initial values, by name."""
    first, nf = structure.m + structure.k, structure.nf
    for name in [*(model.dynamic or []), *(model.kinematic_names or []), *model.motions]:
        i = structure.find(name)
        if structure.m <= i < first:
            raise ModelError(
                f"'{name}' is a slip; only coordinates and deformations can be freedoms or prescribed"
            )
        if i >= first + nf:
            raise ModelError(
                f"'{name}' is fixed; release the node, or take it out of the freedoms and motions"
            )
    for name in model.dynamic or []:
        if name in model.motions or name in (model.kinematic_names or []):
            raise ModelError(f"'{name}' is independent and also prescribed or kinematic; choose one")
    for load in model.loads:
        if structure.find(load.name) >= first + nf:
            raise ModelError(
                f"load on '{load.name}': this coordinate is fixed and cannot move; remove load or fixing"
            )
    for name in model.values:
        i = structure.find(name)
        if i in roles.rigid or i in roles.prescribed or i >= first + nf or structure.m <= i < first:
            raise ModelError(
                f"initial value of '{name}': it is rigid, prescribed, fixed or a slip; take it back"
            )
    for name in model.rates:
        if structure.find(name) >= first + nf:
            raise ModelError(f"initial rate of '{name}': this coordinate is fixed; take it back")


def first_position(model: Model, kinematics: Kinematics, t: float) -> Configuration:
    """Configuration nearest to the drawing that meets the constraints and the wanted initial values.

    Gauss–Newton with the smallest change of the coordinates; wanted values are approached in steps.
    """
    structure, roles = kinematics.structure, kinematics.roles
    x = structure.x0.copy()
    e, J = kinematics.evaluation.position(x)
    drawn = kinematics.values(e, x)
    wanted = {structure.find(z): drawn[structure.find(z)] for z in (model.dynamic or [])}
    wanted |= {structure.find(z): drawn[structure.find(z)] for z in (model.kinematic_names or [])}
    wanted |= {structure.find(z): value for z, value in model.values.items()}
    rows = np.concatenate([roles.holonomic, np.array(list(wanted), dtype=np.intp)])
    start = drawn[rows]
    start[: roles.rigid.size] = 0.0
    goal = np.concatenate([kinematics.target(t, np.zeros(0)), np.array(list(wanted.values()))])
    change = wrap(goal - start, structure.angle[rows]) / kinematics.scales(rows)
    steps = max(1, int(np.ceil(np.max(np.abs(change), initial=0.0) / STEP)))
    for i in range(1, steps + 1):
        part = start + (goal - start) * i / steps
        x = _nearest(kinematics, rows, part, x, t)
    e, J = kinematics.evaluation.position(x)
    angle = structure.angle[: structure.m]
    target = np.zeros(structure.m)
    own = rows < structure.m
    target[rows[own]] = goal[own]
    e = e + 2 * np.pi * np.where(angle, np.round((target - e) / (2 * np.pi)), 0.0)
    return Configuration(t, x, e, J)


def _nearest(kinematics: Kinematics, rows: Index, goal: Array, x: Array, t: float) -> Array:
    structure, nf = kinematics.structure, kinematics.structure.nf
    scale, angle = kinematics.scales(rows), structure.angle[rows]
    x, best, stalled = x.copy(), np.inf, 0
    for _ in range(60):
        e, J = kinematics.evaluation.position(x)
        residual = wrap(kinematics.values(e, x)[rows] - goal, angle)
        error = float(np.max(np.abs(residual) / scale, initial=0.0))
        if error < 1e-13 or (error < 1e-11 and error > 0.5 * best):
            return x
        stalled = stalled + 1 if error > 0.9 * best else 0
        best = min(best, error)
        if stalled > 12 or not np.isfinite(error):
            break
        step = np.linalg.lstsq(J[rows, :nf], residual, rcond=1e-10)[0]
        x[:nf] -= step * min(1.0, 0.3 / max(float(np.max(np.abs(step))), 1e-300))
    worst = np.argsort(-np.abs(residual) / scale)[:4]
    names = ", ".join(f"'{structure.names[rows[i]]}' (off by {residual[i]:.3g})" for i in worst)
    raise PositionError(
        f"the mechanism cannot be assembled at t = {t:g} s: {names} stay unsatisfied; the drawing and the wanted "
        "initial or prescribed values contradict the constraints: correct one of them"
    )
