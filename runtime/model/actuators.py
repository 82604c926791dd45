"""Where the forces that move prescribed quantities act: in the quantities themselves, or in actuators elsewhere."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from flexel.base.arrays import Index
from flexel.base.errors import ModelError
from flexel.base.shown import quoted
from flexel.model.lowering import Lowering
from flexel.model.structure import Structure


def actuator_rows(model: Lowering, structure: Structure, role: Mapping[str, str]) -> Index | None:
    """Return, for each prescribed quantity, the one in which the force acts that moves it.

    The quantities that have actuators share them: together these hold the whole path.  None without actuators.

    Parameters
    ----------
    model : Lowering
    structure : Structure
    role : mapping of str to str
        Of deformations and slips: "rigid" or "free".

    Raises
    ------
    ModelError
        As many actuators as quantities are needed; an actuator that is rigid, prescribed or fixed; by name.
    """
    driven = [name for name in model.motions if model.actuators.get(name)]
    names = list(dict.fromkeys(name for path in driven for name in model.actuators[path]))
    if not driven:
        return None
    if len(names) != len(driven):
        raise ModelError(
            f"prescribe: {len(driven)} {'quantity' if len(driven) == 1 else 'quantities'} ({quoted(driven)}) and "
            f"{len(names)} {'actuator' if len(names) == 1 else 'actuators'} ({quoted(names)}); give as many actuators "
            "as quantities that they move"
        )
    for name in names:
        _check(model, structure, role, name)
    other = dict(zip(driven, names, strict=True))
    return np.array([structure.find(other.get(name, name)) for name in model.motions], dtype=np.intp)


def _check(model: Lowering, structure: Structure, role: Mapping[str, str], name: str) -> None:
    """Check that a force can act in a quantity."""
    i, kinds = structure.find(name, "actuator"), structure.m + structure.k
    if structure.m <= i < kinds:
        raise ModelError(
            f"actuator '{name}' is a slip; name a deformation, such as the angle of a hinge, or a coordinate"
        )
    if name in model.motions:
        raise ModelError(f"actuator '{name}' is also prescribed; name a quantity that is free to follow")
    if i >= kinds + structure.nf:
        raise ModelError(f"actuator '{name}' is fixed and moves nothing; release the node")
    if role.get(name) == "rigid":
        raise ModelError(f"actuator '{name}' is rigid and moves nothing; release it with m.release('{name}')")
