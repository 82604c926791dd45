"""From a declared model to a system: roles resolved, position assembled, freedoms chosen, rates made consistent.

Imports numpy, scipy.sparse and the runtime rooms below the model.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, eye_array

from flexel.diagnose import choose_freedoms, named_freedoms
from flexel.errors import ModelError, PositionError
from flexel.evaluate import Evaluation
from flexel.generated.table import ELEMENTS
from flexel.inputs import number
from flexel.kinematics import Configuration, Kinematics, turns, wrap
from flexel.loads import Loads
from flexel.roles import Roles
from flexel.solvers import factorize
from flexel.structure import Array, Index, Instance, Structure, assemble_structure
from flexel.system import System

if TYPE_CHECKING:
    from flexel.model import Model

STEP = 0.2  # largest change of a wanted value (in its natural scale) in one step of the first assembly


def build(model: Model, t: float) -> System:
    """The system of a model at time t; see `Model.build`."""
    t = number(t, "build", "time t")
    if not model.nodes:
        raise ModelError("the model has no nodes; add points and frames first")
    structure = assemble_structure(
        model.nodes.values(), [*model.instances.values(), *norms(model)], model.laws
    )
    check_laws(structure)
    evaluation = Evaluation(structure)
    roles = resolve_roles(model, structure)
    loads = Loads(structure, tuple(model.loads))
    check_names(model, structure, roles)
    loads.at(t)  # a load that fails is found here, not in the middle of a motion
    kinematics = Kinematics(evaluation, roles)
    c = first_position(model, kinematics, t)
    dynamic = named_freedoms(structure, model.dynamic, "independent")
    kinematic = named_freedoms(structure, model.kinematic_names, "kinematic")
    chosen = choose_freedoms(kinematics, c.J, dynamic, kinematic)
    return System(evaluation, loads, chosen, c, model.rates)


def norms(model: Model) -> list[Instance]:
    """The norm condition of every frame that is not wholly fixed."""
    frames = [n for n in model.nodes.values() if n.kind == "frame" and not np.all(n.fixed)]
    return [Instance(n.name, ELEMENTS["norm"], (n.name,), {}) for n in frames]


def check_laws(structure: Structure) -> None:
    """Each law must act on deformations (springs) or slips (viscous resistance) that exist."""
    m, k = structure.m, structure.k
    for law in structure.laws:
        owner = f"law on '{law.name}'"
        for name in law.deformations:
            if structure.find(name, owner) >= m:
                raise ModelError(f"{owner}: '{name}' is not a deformation; springs and formulas act on these")
            refuse_norm(structure, name, owner)
        for name in law.slips:
            if not m <= structure.find(name, owner) < m + k:
                raise ModelError(
                    f"{owner}: '{name}' is not a slip; use m.spring(…, 0, damping) on deformations"
                )


def refuse_norm(structure: Structure, name: str, owner: str) -> None:
    """The norm of Euler parameters has no role, law or load of its own."""
    structure.find(name, owner)
    if structure.is_norm(name):
        frame = name.rpartition(".")[0]
        raise ModelError(
            f"{owner}: '{name}' is the norm of the Euler parameters of frame '{frame}', which always holds; name "
            "another quantity"
        )


def resolve_roles(model: Model, structure: Structure) -> Roles:
    """Rigid, prescribed and rolling conditions, from what the user said and the elements' defaults."""
    role = {}
    for instance in structure.instances:
        frees = [z.free for z in instance.spec.deformations] + [z.free for z in instance.spec.slips]
        for name, free in zip((*instance.deformations, *instance.slips), frees, strict=True):
            role[name] = "free" if free else "rigid"
    for law in structure.laws:
        role.update(dict.fromkeys((*law.deformations, *law.slips), "free"))
        contradicted = [z for z in (*law.deformations, *law.slips) if model.roles.get(z) == "rigid"]
        if contradicted:
            raise ModelError(f"'{contradicted[0]}' is rigid and also has a law; take one of them back")
    for name, wish in model.roles.items():
        if structure.find(name, "rigid or release") >= structure.m + structure.k:
            raise ModelError(
                f"'{name}' is a coordinate; rigid and free are roles of deformations and slips, use fix"
            )
        refuse_norm(structure, name, "rigid or release")
        role[name] = wish
    for name in [*(model.dynamic or []), *(model.kinematic_names or []), *model.motions]:
        structure.find(name, "independent, kinematic or prescribe")
        refuse_norm(structure, name, "independent, kinematic or prescribe")
        if model.roles.get(name) == "rigid":
            raise ModelError(f"'{name}' is rigid and also independent or prescribed; take one of them back")
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
    for name in model.motions:
        i = structure.find(name)
        if structure.m <= i < first:
            raise ModelError(
                f"prescribe: '{name}' is a slip; only coordinates and deformations are prescribed"
            )
        if i >= first + nf:
            raise ModelError(f"prescribe: '{name}' is fixed; release the node, or do not prescribe it")
    for name in model.dynamic or []:
        if name in model.motions or name in (model.kinematic_names or []):
            raise ModelError(f"'{name}' is independent and also prescribed or kinematic; choose one")
    for load in model.loads:
        refuse_norm(structure, load.name, "load")
        if structure.find(load.name) >= first + nf:
            raise ModelError(
                f"load on '{load.name}': this coordinate is fixed and cannot move; remove load or fixing"
            )
    for name in model.values:
        i = structure.find(name, "initial")
        if i in roles.rigid or i in roles.prescribed or i >= first + nf or structure.m <= i < first:
            raise ModelError(
                f"initial value of '{name}': it is rigid, prescribed, fixed or a slip; take it back"
            )
    for name in model.rates:
        i = structure.find(name, "initial")
        if i in roles.rigid or i in roles.prescribed or i in roles.zero or i >= first + nf:
            raise ModelError(
                f"initial rate of '{name}': it is rigid, prescribed, fixed or a zero slip; take it back"
            )


def first_position(model: Model, kinematics: Kinematics, t: float) -> Configuration:
    """Configuration nearest to the drawing that meets the constraints and the wanted initial values.

    Gauss–Newton with the smallest change of the coordinates; wanted values are approached in steps.
    """
    structure, roles = kinematics.structure, kinematics.roles
    x = structure.x0.copy()
    e, J = kinematics.evaluate(x)
    drawn = kinematics.values(e, x)
    wanted = {structure.find(z): drawn[structure.find(z)] for z in (model.dynamic or [])}
    wanted |= {structure.find(z): drawn[structure.find(z)] for z in (model.kinematic_names or [])}
    wanted |= {structure.find(z): value for z, value in model.values.items()}
    rows = np.concatenate([roles.holonomic, np.array(list(wanted), dtype=np.intp)])
    start = drawn[rows]
    start[: roles.rigid.size] = 0.0
    goal = np.concatenate(
        [kinematics.target(kinematics.roles.motion(t), np.zeros(0)), np.array(list(wanted.values()))]
    )
    change = wrap(goal - start, structure.period[rows]) / kinematics.scales(rows)
    steps = max(1, int(np.ceil(np.max(np.abs(change), initial=0.0) / STEP)))
    for i in range(1, steps + 1):
        part = start + (goal - start) * i / steps
        x = _nearest(kinematics, rows, part, x, t)
    e, J = kinematics.evaluate(x)
    target = np.zeros(structure.m)
    own = rows < structure.m
    target[rows[own]] = goal[own]
    return Configuration(t, x, e + turns(target - e, structure.period[: structure.m]), J)


def _nearest(kinematics: Kinematics, rows: Index, goal: Array, x: Array, t: float) -> Array:
    structure, nf = kinematics.structure, kinematics.structure.nf
    scale, period = kinematics.scales(rows), structure.period[rows]
    x, best, stalled = x.copy(), np.inf, 0
    for _ in range(60):
        e, J = kinematics.evaluate(x)
        residual = wrap(kinematics.values(e, x)[rows] - goal, period)
        error = float(np.max(np.abs(residual) / scale, initial=0.0))
        if error < 1e-13 or (error < 1e-11 and error > 0.5 * best):
            return x
        stalled = stalled + 1 if error > 0.9 * best else 0
        best = min(best, error)
        if stalled > 12 or not np.isfinite(error):
            break
        step = smallest_step(J[rows][:, :nf], residual)
        x[:nf] -= step * min(1.0, 0.3 / max(float(np.max(np.abs(step))), 1e-300))
    worst = np.argsort(-np.abs(residual) / scale)[:4]
    names = ", ".join(f"'{structure.names[rows[i]]}' (off by {residual[i]:.3g})" for i in worst)
    raise PositionError(
        f"the mechanism cannot be assembled at t = {t:g} s: {names} stay unsatisfied; the drawing and the wanted "
        "initial or prescribed values contradict the constraints: correct one of them"
    )


def smallest_step(C: Any, residual: Array) -> Array:
    """The smallest change of the coordinates with C dx = residual, in the sense of least squares."""
    if isinstance(C, np.ndarray):
        return np.asarray(np.linalg.lstsq(C, residual, rcond=1e-10)[0])
    size, count = C.shape[1], C.shape[0]
    damping = -1e-12 * eye_array(count)  # conditions that repeat one another are reported later
    factors = factorize(block_array([[eye_array(size), C.T], [C, damping]]))
    return factors.solve(np.concatenate([np.zeros(size), residual]))[:size]
