"""Contact of points and spheres of any body with surfaces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY

import numpy as np

from flexel.base.arguments import vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.quaternions import in_body
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.model.surfaces import Surface
from flexel.parts.rope_contacts import (
    Contact,
    attach_contact,
    check_contact,
    check_fits,
    find_surface,
    name_of,
)

# A sphere touches the two flanks of a V groove at different points, so that it slides differently around the
# axle there; a rope, which slides at its centre, does not.
SPHERE_IN_V = (("gap1", ("tangential1", "across1")), ("gap2", ("tangential2", "across2")))


@part
class PointContact(Part[None]):
    """Let a point, or a sphere fixed in a body, touch a surface of another body or of the ground.

    The surface is a sheave or drum (its outside or its groove) or a plane; planes and cylinders have no ends. The
    element has the free deformation ``NAME.gap``, positive while open, and slips, the sliding velocities: ``x`` and
    ``y`` of a plane, ``tangential`` and ``axial`` of a cylinder, ``tangential`` and ``across`` of a round groove,
    ``tangential`` in planar models. A V groove has ``gap1`` and ``gap2``, ``across1`` and ``across2``, and
    ``tangential``, for a sphere ``tangential1`` and ``tangential2``. Their forces (`State.force`) are the normal
    force, negative in compression, and friction.

    Raises
    ------
    ModelError
        An unknown surface, planar and spatial ones mixed, a sphere that does not fit into its groove, a position `at`
        without a frame, a surface of the same body.

    Examples
    --------
    >>> m.contact("bounce", "ball", "floor", fx.Contact(1e6, friction=0.3), frame="R", radius=0.1)
    ... # doctest: +SKIP
    """

    name: str = entry("Name of the element.")
    point: Node | str = entry("The centre, or the point of the body that carries it.")
    surface: Surface | str = entry("A surface declared by `Model.sheave` or `Model.plane`.")
    contact: Contact = entry(
        'Its stiffness is for this one contact [N/m^exponent]; a contact with per="length" is refused.'
    )
    _: KW_ONLY
    frame: Node | str | None = entry(
        "Orientation of the body. With a frame, the sliding of a sphere is that of its material point at the contact: "
        "friction turns it, and it can roll. Without a frame there is no rotation: sliding is measured at the centre "
        "relative to the surface's body there, whatever the radius, as for ropes.",
        default=None,
    )
    at: Sequence[float] | Array | None = array_quantity(
        "m",
        "Centre of the sphere [], (x, y, z) in global axes as drawn, fixed in the body; the point itself by default. "
        "Two numbers in a planar model.",
        default=None,
    )
    radius: float = quantity(
        "m",
        "not negative",
        "Radius of the sphere, or of the disc in a planar model; 0 for a point.",
        default=0.0,
    )

    @property
    def owner(self) -> str:
        """Its name in messages: the contact and its surface."""
        return f"contact '{self.name}' with '{name_of(self.surface)}'"

    def lower(self, to: Lowering) -> None:
        """Add the element and its laws."""
        surface = find_surface(to, self.surface, f"contact '{self.name}'")
        self._check_kinds(surface)
        nodes = self._nodes(to, surface)
        centre = nodes[0].x0
        if self.at is not None:
            centre = vector(self.at, self.owner, "at", 2 if surface.planar else 3)
        _check_off_axle(self.owner, centre, surface)
        values = surface.parameters | {"sphere_radius": np.array([self.radius])}
        gaps, touching = surface.gaps, "point"
        if self.frame is not None:
            values["centre"] = in_body(nodes[1].x0, centre - nodes[0].x0)
            touching = "disc" if surface.planar else "sphere"
            gaps = SPHERE_IN_V if surface.kind == "v_groove" else gaps
        elif self.at is not None:
            raise ModelError(
                f"{self.owner}: a position at={self.at!r} needs the body in which it is fixed; give its frame"
            )
        to.element(self.name, surface.element(touching), [*nodes, surface.point, surface.frame], values)
        attach_contact(to, self.name, gaps, self.contact, 1.0)

    def _check_kinds(self, surface: Surface) -> None:
        """Refuse contacts and surfaces that are for ropes only, and spheres wider than a groove."""
        check_contact(self.contact, self.owner)
        if self.contact.per == "length":
            raise ModelError(
                f"{self.owner}: its stiffness is per length of a rope; give the stiffness of the point, with "
                "per='point'"
            )
        if surface.kind == "helical_groove":
            raise ModelError(
                f"{self.owner}: a helical groove is for ropes only; give a sheave with another groove"
            )
        check_fits("sphere", self.radius, surface, self.owner)

    def _nodes(self, to: Lowering, surface: Surface) -> list[Node]:
        """Return the point and the frame, if there is one, which must not belong to the surface's body."""
        planar, nodes = to.find_nodes(self.owner, (self.point, "point"))
        if planar != surface.planar:
            where = ("in space", "in a planar model")
            raise ModelError(
                f"{self.owner}: '{nodes[0].name}' lies {where[planar]}, the surface {where[not planar]}; use one kind"
            )
        if self.frame is not None:
            kind = "planar_angle" if planar else "frame"
            nodes.append(to.find_of_kind(self.frame, (kind,), self.owner))
        if nodes[0].name == surface.point and all(node.name == surface.frame for node in nodes[1:]):
            raise ModelError(
                f"{self.owner}: the surface is fixed in the same body, with the point '{surface.point}'; give a point "
                "of another"
            )
        return nodes


def _check_off_axle(owner: str, centre: Array, surface: Surface) -> None:
    """Refuse a point on the axle of a cylinder, where its normal is undefined."""
    off = centre - surface.centre
    if not surface.planar:
        off = off - (off @ surface.axle) * surface.axle
    if surface.radius and np.linalg.norm(off) < 1e-9 * surface.radius:
        raise ModelError(
            f"{owner}: as drawn, its centre lies on the axle of '{surface.name}'; move it outside"
        )
