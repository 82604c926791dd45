"""Resolves the user's declarations into the roles of all quantities; every contradiction is reported."""

from __future__ import annotations

import numpy as np

from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.generated.table import ELEMENTS
from flexel.structure.instances import Instance
from flexel.structure.roles import Roles
from flexel.structure.structure import Structure


def norms(model: Declarations) -> list[Instance]:
    """The norm condition of every frame that is not wholly fixed."""
    frames = [n for n in model.nodes.values() if n.kind == "frame" and not np.all(n.fixed)]
    return [Instance(n.name, ELEMENTS["norm"], (n.name,), {}) for n in frames]


def resolve_roles(model: Declarations, structure: Structure) -> Roles:
    """Rigid, prescribed and rolling conditions, from the declarations and the elements' defaults."""
    role = {}
    for instance in structure.instances:
        frees = [z.free for z in instance.spec.deformations] + [z.free for z in instance.spec.slips]
        for name, free in zip((*instance.deformations, *instance.slips), frees, strict=True):
            role[name] = "free" if free else "rigid"
    for instance in structure.instances:
        role |= {z: "free" for z in instance.terms or {} if role.get(z) == "rigid"}
    for law in structure.laws:
        role.update(dict.fromkeys((*law.deformations, *law.slips), "free"))
        contradicted = [z for z in (*law.deformations, *law.slips) if model._roles.get(z) == "rigid"]
        if contradicted:
            raise ModelError(f"'{contradicted[0]}' is rigid and also has a law; remove one of them")
    role |= model._roles
    for name in [*(model._dynamic or []), *(model._kinematic or []), *model._motions]:
        if model._roles.get(name) == "rigid":
            raise ModelError(f"'{name}' is rigid and also independent or prescribed; remove one of them")
        role[name] = "free"
    rigid = [structure.index[z] for z, given in role.items() if given == "rigid"]
    prescribed = [structure.find(z) for z in model._motions]
    empty = np.zeros(0, dtype=np.intp)
    return Roles(
        rigid=np.array(sorted(i for i in rigid if i < structure.m), dtype=np.intp),
        prescribed=np.array(prescribed, dtype=np.intp),
        motions=tuple(model._motions.values()),
        zero=np.array(sorted(i for i in rigid if i >= structure.m), dtype=np.intp),
        dynamic=empty,
        kinematic=empty,
    )


def check_names(model: Declarations, structure: Structure, roles: Roles) -> None:
    """Contradictions between roles, loads and initial values, by name."""
    first, nf = structure.m + structure.k, structure.nf
    for name in model._motions:
        if structure.find(name) >= first + nf:
            raise ModelError(f"prescribe: '{name}' is fixed; release the node, or do not prescribe it")
    for name in model._dynamic or []:
        if name in model._motions or name in (model._kinematic or []):
            raise ModelError(f"'{name}' is independent and also prescribed or kinematic; choose one")
    for load in model.loads:
        if structure.find(load.name) >= first + nf:
            raise ModelError(
                f"load on '{load.name}': this coordinate is fixed and cannot move; remove the load or the fixing"
            )
    for name in model._values:
        i = structure.find(name, "initial")
        if i in roles.rigid or i in roles.prescribed or i >= first + nf:
            raise ModelError(
                f"initial value of '{name}': it is rigid, prescribed or fixed; remove the initial value"
            )
    for name in model._rates:
        i = structure.find(name, "initial")
        if i in roles.rigid or i in roles.prescribed or i in roles.zero or i >= first + nf:
            raise ModelError(
                f"initial rate of '{name}': it is rigid, prescribed, fixed or a no-slip constraint; "
                "remove the initial rate"
            )
