"""Checks that a drawing meets the rigid conditions: finds violated ones, and the corrections by the assembly.

Motions due to initial values or prescribed motions are intended, and are not reported.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.mechanics.first_position import nearest
from flexel.mechanics.kinematics import Configuration, Kinematics, wrap
from flexel.model.lowering import Lowering

# Coordinates written with six decimals of the model's size count as exact; so do angles and slopes.
DRAWN = 1e-6
SHOWN = 4  # names in a message


@dataclass(frozen=True)
class Misfit:
    """Corrections of a drawing by the assembly.

    Attributes
    ----------
    violated : dict of str to float
        Rigid deformations that are not zero as drawn [m or rad], the largest first.
    moved : dict of str to float
        Coordinates, and how far they are moved, the largest first.
    units : dict of str to str
        The units of both.
    """

    violated: dict[str, float]
    moved: dict[str, float]
    units: dict[str, str]

    def __str__(self) -> str:
        return (
            f"the drawing violates rigid conditions: as drawn {self._named(self.violated)}, not 0; "
            f"the assembly moves {self._named(self.moved)}; correct the drawing, or release one"
        )

    def _named(self, values: dict[str, float]) -> str:
        parts = [f"'{name}'{{}} {v:.4g} {self.units[name]}".rstrip() for name, v in values.items()]
        word = " by" if values is self.moved else " is"
        more = f" and {len(parts) - SHOWN} more" if len(parts) > SHOWN else ""
        return ", ".join(part.format(word) for part in parts[:SHOWN]) + more


def misfit(model: Lowering, kinematics: Kinematics, found: Configuration) -> Misfit | None:
    """Return the corrections by the assembly, if the drawing violates rigid conditions beyond rounding errors.

    Parameters
    ----------
    model : Lowering
    kinematics : Kinematics
    found : Configuration
        The assembled one.
    """
    structure, rows = kinematics.structure, kinematics.roles.rigid
    drawn = wrap(kinematics.evaluation.position(structure.x0)[0][rows], structure.period[rows])
    off = np.abs(drawn) / kinematics.scales(rows)
    if off.max(initial=0.0) <= DRAWN:
        return None
    violated = {structure.names[rows[i]]: float(drawn[i]) for i in _largest(off)}
    x = found.x if not (model.values or model.motions) else _mended(kinematics, found.t)
    first = structure.m + structure.k
    change = x - structure.x0
    moving = _largest(np.abs(change) / kinematics.scales(np.arange(structure.n) + first))
    moved = {structure.names[first + i]: float(change[i]) for i in moving}
    units = dict(zip(structure.names, structure.units, strict=True))
    return Misfit(violated, moved, {name: units[name] for name in (*violated, *moved)})


def _mended(kinematics: Kinematics, t: float) -> Array:
    """Find the coordinates nearest to the drawing that meet the rigid conditions alone."""
    structure, rows = kinematics.structure, kinematics.roles.rigid
    unwrap_from = kinematics.evaluation.position(structure.x0)[0]
    return nearest(kinematics, rows, np.zeros(rows.size), structure.x0, unwrap_from, t)[0]


def _largest(size: Array) -> list[int]:
    """Return the indices of the entries above the tolerance, the largest first."""
    return [int(i) for i in np.argsort(-size, kind="stable") if size[i] > DRAWN]
