"""Nodes: points, orientations, angles and warping."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arguments import array, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part


@part
class Point(Part[Node]):
    """Add a position node, in space or in the plane.

    Raises
    ------
    ModelError
        A duplicate name, coordinates that are not two or three finite numbers.
    """

    name: str = entry("Name of the node; its coordinates are ``name.x``, ``name.y`` and ``name.z``.")
    position: Vector = array_quantity("m", "Position as drawn []: (x, y, z), or (x, y) in a planar model.")
    fixed: bool = entry("Hold it as drawn.", default=False)

    def lower(self, to: Lowering) -> Node:
        """Add the node."""
        x0 = drawn(self.position, self.owner)
        return to.node(self.name, "planar_point" if x0.size == 2 else "point", x0, self.fixed)


def drawn(position: Any, owner: str) -> Array:
    """Return a position in a plane or in space, or raise a ModelError."""
    x0 = array(position, owner, "position")
    if x0.shape not in {(2,), (3,)}:
        raise ModelError(f"{owner}: position {x0.tolist()} has shape {x0.shape}; give 2 or 3 numbers")
    return x0


@part
class Frame(Part[Node]):
    """Add an orientation node with Euler parameters of norm one.

    See Also
    --------
    flexel.base.quaternions.turn : Euler parameters of a rotation about an axis.
    """

    name: str = entry("Name of the node; its coordinates are ``name.lambda0`` to ``name.lambda3``.")
    orientation: Vector = array_quantity(
        "-", "Euler parameters (λ0, λ1, λ2, λ3) as drawn.", default=(1.0, 0.0, 0.0, 0.0)
    )
    fixed: bool = entry("Hold it as drawn.", default=False)

    def lower(self, to: Lowering) -> Node:
        """Add the node."""
        x0 = vector(self.orientation, self.owner, "orientation", 4)
        norm = float(np.linalg.norm(x0))
        if abs(norm - 1) > 1e-6:
            raise ModelError(
                f"{self.owner}: Euler parameters {x0.tolist()} have norm {norm:g}; divide them by it"
            )
        return to.node(self.name, "frame", x0 / norm, self.fixed)


@part
class Angle(Part[Node]):
    """Add an orientation node of a planar model, an angle."""

    name: str = entry("Name of the node; its coordinate is ``name.angle``.")
    value: float = quantity("rad", "any", "Angle as drawn.", default=0.0)
    fixed: bool = entry("Hold it as drawn.", default=False)

    def lower(self, to: Lowering) -> Node:
        """Add the node."""
        return to.node(self.name, "planar_angle", np.array([self.value]), self.fixed)


@part
class Warping(Part[Node]):
    """Add the warping of a section, for `beam`: its coordinate ``name.twist`` is the beam's twist per length.

    Beams of the same section along one line share the node between them, where the warping is continuous.  It is
    fixed where a support keeps the section plane (a clamp), and free otherwise.

    Raises
    ------
    ModelError
        A duplicate name.
    """

    name: str = entry("Name of the node; its coordinate is ``name.twist`` [rad/m].")
    fixed: bool = entry("Keep the section plane.", default=False)

    def lower(self, to: Lowering) -> Node:
        """Add the node."""
        return to.node(self.name, "warping", np.zeros(1), self.fixed)
