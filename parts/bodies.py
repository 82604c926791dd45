"""Bodies and masses: parts that give nodes their inertia."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY
from typing import Any

import numpy as np

from flexel.base.arguments import array, not_negative, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part


@part
class PointMass(Part[None]):
    """Put a mass at a point."""

    name: str = entry("Name of the element.")
    point: Node | str = entry("Where the mass is.")
    mass: float = quantity("kg", "positive", "Mass.")

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        planar, (point,) = to.find_nodes(self.owner, (self.point, "point"))
        element = "planar_point_mass" if planar else "point_mass"
        to.element(self.name, element, [point], {"mass": np.array([self.mass])})


@part
class Body(Part[None]):
    """Put a rigid body on a point and a frame.

    Raises
    ------
    ModelError
        A physically impossible mass or inertia.
    """

    name: str = entry("Name of the element.")
    point: Node | str = entry("A point of the body.")
    frame: Node | str = entry("Orientation of the body.")
    _: KW_ONLY
    mass: float = quantity("kg", "positive", "Mass.")
    inertia: Any = array_quantity(
        "kg m²",
        "Inertia about the mass centre in body axes []: three principal moments, (xx, yy, zz, xy, xz, yz) as tensor "
        "components, or a symmetric (3, 3); one number in a planar model.  All zero for a point mass.",
        form="array_like",
    )
    offset: Sequence[float] | Array | None = array_quantity(
        "m", "Position of the mass centre relative to the point, in body axes.", default=None
    )

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        planar, nodes = to.find_nodes(self.owner, (self.point, "point"), (self.frame, "frame"))
        size = 2 if planar else 3
        c = np.zeros(size) if self.offset is None else vector(self.offset, self.owner, "offset", size)
        if planar:
            J = np.array([not_negative(self.inertia, self.owner, "inertia")])
        else:
            J = inertia_tensor(self.inertia, self.owner)
        values = {"mass": np.array([self.mass]), "c": c, "J": J}
        to.element(self.name, "planar_body" if planar else "body", nodes, values)


def inertia_tensor(value: Any, owner: str) -> Array:
    """Return the inertia tensor as (xx, yy, zz, xy, xz, yz), from three principal values, six entries or a matrix.

    Raises
    ------
    ModelError
        If it is neither positive definite nor zero, or a principal moment exceeds the sum of the other two.
    """
    J = symmetric_tensor(value, owner)
    w = np.linalg.eigvalsh(J)
    if w[0] <= 0 and J.any():
        raise ModelError(
            f"{owner}: inertia is not positive definite (principal moments {w}); check the signs, or give zeros for "
            "a point mass"
        )
    if w[2] > (w[0] + w[1]) * (1 + 1e-12):
        raise ModelError(
            f"{owner}: principal moments {w} violate the triangle inequality (none may exceed the sum of the "
            "others); this inertia is physically impossible: check the numbers"
        )
    return six_entries(J)


def symmetric_tensor(value: Any, owner: str) -> Array:
    """Return an inertia as a symmetric matrix (3, 3), from three principal values, six entries or a matrix."""
    J = array(value, owner, "inertia")
    if J.shape == (3,):
        return np.diag(J)
    if J.shape == (6,):
        xx, yy, zz, xy, xz, yz = J
        return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if J.shape != (3, 3) or np.max(np.abs(J - J.T)) > 1e-12 * np.max(np.abs(J)):
        raise ModelError(
            f"{owner}: inertia {J.tolist()} is not a tensor; give 3 principal moments, (xx, yy, zz, xy, xz, yz) "
            "or a symmetric 3x3"
        )
    return J


def six_entries(J: Array) -> Array:
    """Return (xx, yy, zz, xy, xz, yz) of a symmetric matrix (3, 3)."""
    return np.array([J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]])
