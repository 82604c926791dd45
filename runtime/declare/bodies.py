"""Bodies and masses: the methods of `Model` that give nodes their inertia."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import array, positive, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.declare.declarations import Declarations
from flexel.structure.nodes import Node


class Bodies(Declarations):
    """Mass and inertia."""

    def point_mass(self, name: str, point: Node | str, mass: float) -> None:
        """Put a mass [kg] at a point."""
        owner = f"point mass '{name}'"
        planar, (p,) = self._find_nodes(owner, (point, "point"))
        element = "planar_point_mass" if planar else "point_mass"
        self._place(name, element, [p], {"mass": np.array([positive(mass, owner, "mass")])})

    def body(
        self,
        name: str,
        point: Node | str,
        frame: Node | str,
        *,
        mass: float,
        inertia: Any,
        offset: Sequence[float] | Array | None = None,
    ) -> None:
        """Put a rigid body on a point and a frame.

        Parameters
        ----------
        mass : float
            [kg]
        inertia : array_like
            About the mass centre in body axes [kg m²]: three principal moments, (xx, yy, zz, xy, xz, yz) as
            tensor components, or a symmetric (3, 3); one number in a planar model.
        offset : sequence of float
            Mass centre relative to the point, in body axes [m].

        Raises
        ------
        ModelError
            A physically impossible mass or inertia.
        """
        owner = f"body '{name}'"
        planar, nodes = self._find_nodes(owner, (point, "point"), (frame, "frame"))
        size = 2 if planar else 3
        c = np.zeros(size) if offset is None else vector(offset, owner, "offset", size)
        J = np.array([positive(inertia, owner, "inertia")]) if planar else inertia_tensor(inertia, owner)
        values = {"mass": np.array([positive(mass, owner, "mass")]), "c": c, "J": J}
        self._place(name, "planar_body" if planar else "body", nodes, values)


def inertia_tensor(value: Any, owner: str) -> Array:
    """Inertia tensor as (xx, yy, zz, xy, xz, yz), from three principal values, six entries or a matrix.

    Raises
    ------
    ModelError
        If it is not positive definite, or a principal moment exceeds the sum of the other two.
    """
    J = array(value, owner, "inertia")
    if J.shape == (3,):
        J = np.diag(J)
    elif J.shape == (6,):
        xx, yy, zz, xy, xz, yz = J
        J = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if J.shape != (3, 3) or np.max(np.abs(J - J.T)) > 1e-12 * np.max(np.abs(J)):
        raise ModelError(
            f"{owner}: inertia {J.tolist()} is not a tensor; give 3 principal moments, (xx, yy, zz, xy, xz, yz) "
            "or a symmetric 3x3"
        )
    w = np.linalg.eigvalsh(J)
    if w[0] <= 0:
        raise ModelError(
            f"{owner}: inertia is not positive definite (principal moments {w}); check the signs"
        )
    if w[2] > (w[0] + w[1]) * (1 + 1e-12):
        raise ModelError(
            f"{owner}: principal moments {w} violate the triangle inequality (none may exceed the sum of the "
            "others); this inertia is physically impossible, check the numbers"
        )
    return np.array([J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]])
