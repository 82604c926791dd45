"""Skates: the blade of a body on ice."""

from __future__ import annotations

import numpy as np

from flexel.base.arguments import vector
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry
from flexel.base.quaternions import in_body, unit
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.parts.rigid_bodies import Given, point_of, rigid_body

UP = (0.0, 0.0, 1.0)


@part
class Skate(Part[None]):
    """Put a knife edge of a body on the ice: it moves along its blade, not across, and may turn.

    Raises
    ------
    ModelError
        A blade that is normal to the ice.

    Notes
    -----
    The slip ``name.lateral`` is zero and ``name.forward`` is free, for `friction` or a damper; in space the
    deformation ``name.surface`` holds the point on the ice.
    """

    name: str = entry("Name of the element with the slips.")
    body: Given = entry("The body with the blade, as in `revolute`.")
    at: Vector = array_quantity(
        "m", "Point at which the blade touches the ice, in global coordinates as drawn."
    )
    direction: Vector = array_quantity("-", "Direction of the blade, in global axes as drawn.")
    normal: Vector = array_quantity(
        "-", "Normal of the ice, a plane through `at`; the plane itself in a planar model.", default=UP
    )

    def lower(self, to: Lowering) -> None:
        """Add the element at a point of the body."""
        body = rigid_body(to, self.body, self.owner)
        x = vector(self.at, self.owner, "at", body.point.x0.size)
        e = unit(self.direction, self.owner, "direction", x.size)
        n = unit(self.normal, self.owner, "normal")
        nodes = point_of(to, body, x, f"{self.name}_point"), body.frame
        if body.planar:
            alpha0 = np.arctan2(e[1], e[0]) - body.frame.x0
            to.element(self.name, "planar_skate", nodes, {"alpha0": alpha0})
            return
        if np.linalg.norm(np.cross(e, n)) < 1e-6:
            raise ModelError(
                f"{self.owner}: its blade is normal to the ice and has no direction on it; turn it"
            )
        values = {"blade": in_body(body.frame.x0, e), "normal": n, "height": n @ x}
        to.element(self.name, "skate", nodes, values)
