"""Resolves the user's declarations into the roles of all quantities; every contradiction is reported."""

from __future__ import annotations

import numpy as np

from flexel.base.errors import ModelError
from flexel.generated.table import ELEMENTS
from flexel.model.actuators import actuator_rows
from flexel.model.instances import Instance
from flexel.model.lowering import Lowering
from flexel.model.role_lists import Roles
from flexel.model.structure import Structure


def norms(model: Lowering) -> list[Instance]:
    """Return the norm condition of every frame that is not wholly fixed."""
    frames = [n for n in model.nodes.values() if n.kind == "frame" and not np.all(n.fixed)]
    return [Instance(n.name, ELEMENTS["norm"], (n.name,), {}) for n in frames]


def resolve_roles(model: Lowering, structure: Structure) -> Roles:
    """Resolve rigid, prescribed and rolling conditions from the declarations and the elements' defaults."""
    role = {}
    for instance in structure.instances:
        spec = instance.spec
        frees = [deformation.free for deformation in spec.deformations] + [slip.free for slip in spec.slips]
        for name, free in zip((*instance.deformations, *instance.slips), frees, strict=True):
            role[name] = "free" if free else "rigid"
    for instance in structure.instances:
        role |= {name: "free" for name in instance.terms or {} if role.get(name) == "rigid"}
    for law in structure.laws:
        role.update(dict.fromkeys((*law.deformations, *law.slips), "free"))
        contradicted = [name for name in (*law.deformations, *law.slips) if model.roles.get(name) == "rigid"]
        if contradicted:
            raise ModelError(f"'{contradicted[0]}' is rigid and also has a law; remove one of them")
    role |= model.roles
    for name in [*(model.dynamic or []), *(model.kinematic or []), *model.motions]:
        if model.roles.get(name) == "rigid":
            raise ModelError(f"'{name}' is rigid and also independent or prescribed; remove one of them")
        role[name] = "free"
    rigid = [structure.index[name] for name, given in role.items() if given == "rigid"]
    prescribed = [structure.find(name) for name in model.motions]
    empty = np.zeros(0, dtype=np.intp)
    return Roles(
        rigid=np.array(sorted(i for i in rigid if i < structure.m), dtype=np.intp),
        prescribed=np.array(prescribed, dtype=np.intp),
        motions=tuple(model.motions.values()),
        zero=np.array(sorted(i for i in rigid if i >= structure.m), dtype=np.intp),
        dynamic=empty,
        kinematic=empty,
        actuators=actuator_rows(model, structure, role),
    )


def check_names(model: Lowering, structure: Structure, roles: Roles) -> None:
    """Check, by name, that roles, loads and initial values do not contradict each other."""
    first, nf = structure.m + structure.k, structure.nf
    for name in model.motions:
        if structure.find(name) >= first + nf:
            raise ModelError(f"prescribe: '{name}' is fixed; release the node, or do not prescribe it")
    for name in model.dynamic or []:
        if name in model.motions or name in (model.kinematic or []):
            raise ModelError(f"'{name}' is independent and also prescribed or kinematic; choose one")
    for load in model.loads:
        if structure.find(load.name) >= first + nf:
            raise ModelError(
                f"load on '{load.name}': this coordinate is fixed and cannot move; remove the load or the fixing"
            )
    for name in model.values:
        i = structure.find(name, "initial")
        if i in roles.rigid or i in roles.prescribed or i >= first + nf:
            raise ModelError(
                f"initial value of '{name}': it is rigid, prescribed or fixed; remove the initial value"
            )
    for name in model.rates:
        i = structure.find(name, "initial")
        if i in roles.rigid or i in roles.prescribed or i in roles.zero or i >= first + nf:
            raise ModelError(
                f"initial rate of '{name}': it is rigid, prescribed, fixed or a no-slip constraint; "
                "remove the initial rate"
            )
