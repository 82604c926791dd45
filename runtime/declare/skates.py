"""Skates: the method of `Model` that puts the blade of a body on the ice."""

from __future__ import annotations

import numpy as np

from flexel.base.arguments import vector
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_body, unit
from flexel.base.transactions import whole_or_nothing
from flexel.declare.rigid_bodies import Given, RigidBodies

UP = (0.0, 0.0, 1.0)


class Skates(RigidBodies):
    """Skates."""

    @whole_or_nothing
    def skate(self, name: str, body: Given, at: Vector, direction: Vector, normal: Vector = UP) -> None:
        """Put a knife edge of a body on the ice: it moves along its blade, not across, and may turn.

        Parameters
        ----------
        body : str, RigidBody or pair of nodes
            As in `revolute`.
        at : sequence of float (3,) or (2,)
            Where the blade touches the ice, in global coordinates as drawn.
        direction : sequence of float (3,) or (2,)
            Along the blade, in global axes as drawn.
        normal : sequence of float (3,)
            Of the ice, a plane through `at`; the plane itself in a planar model.

        Raises
        ------
        ModelError
            A blade that is normal to the ice.

        Notes
        -----
        The slip ``name.lateral`` is zero and ``name.forward`` is free, for `friction` or a damper; in space the
        deformation ``name.surface`` holds the point on the ice.
        """
        owner = f"skate '{name}'"
        found = self._rigid_body(body, owner)
        x = vector(at, owner, "at", found.point.x0.size)
        e = unit(direction, owner, "direction", x.size)
        n = unit(normal, owner, "normal")
        nodes = self._point_of(found, x, f"{name}_point"), found.frame
        if found.planar:
            self._place(name, "planar_skate", nodes, {"alpha0": np.arctan2(e[1], e[0]) - found.frame.x0})
            return
        if np.linalg.norm(np.cross(e, n)) < 1e-6:
            raise ModelError(f"{owner}: its blade is normal to the ice and has no direction on it; turn it")
        values = {"blade": in_body(found.frame.x0, e), "normal": n, "height": n @ x}
        self._place(name, "skate", nodes, values)
