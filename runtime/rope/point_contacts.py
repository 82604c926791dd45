"""Contact of points and spheres of any body with surfaces: a method of `Model`."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arguments import not_negative, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_body
from flexel.base.transactions import whole_or_nothing
from flexel.declare.laws import Laws
from flexel.rope.contacts import Contact, attach_contact, check_contact, check_fits, find_surface
from flexel.structure.nodes import Node
from flexel.structure.surfaces import Surface

# A sphere touches both flanks of a V groove at places of its own that differ, so that it slides differently around the
# axle there; a rope, which slides at its centre, does not.
SPHERE_IN_V = (("gap1", ("tangential1", "across1")), ("gap2", ("tangential2", "across2")))


class PointContacts(Laws):
    """Contact of points and spheres."""

    @whole_or_nothing
    def contact(
        self,
        name: str,
        point: Node | str,
        surface: Surface | str,
        contact: Contact,
        *,
        frame: Node | str | None = None,
        at: Sequence[float] | Array | None = None,
        radius: float = 0.0,
    ) -> None:
        """Let a point, or a sphere fixed in a body, touch a surface of another body or of the ground.

        The surface is a sheave or drum (its outside or its groove) or a plane; planes and cylinders have no ends. The
        element has the free deformation ``NAME.gap``, positive while open, and slips, the sliding velocities: ``x`` and
        ``y`` of a plane, ``tangential`` and ``axial`` of a cylinder, ``tangential`` and ``across`` of a round groove,
        ``tangential`` in planar models. A V groove has ``gap1`` and ``gap2``, ``across1`` and ``across2``, and
        ``tangential``, for a sphere ``tangential1`` and ``tangential2``. Their forces (`State.force`) are the normal
        force, negative in compression, and friction.

        Parameters
        ----------
        point : node
            The centre, or the point of the body that carries it.
        surface : Surface or str
            What `Model.sheave` or `Model.plane` declared.
        contact : Contact
            Its stiffness is that of this one contact [N/m^exponent]; one that is made with per="length" is refused.
        frame : node, optional
            Orientation of the body. A sphere with a frame slides with the material point of its surface at the contact:
            friction turns it, and it can roll. Without a frame there is no rotation: sliding is that of the centre
            relative to the surface's body there, whatever the radius, as for ropes.
        at : sequence of float (3,), optional
            Centre of the sphere in global axes as drawn, fixed in the body; the point itself by default. Two numbers in
            a planar model.
        radius : float
            Of the sphere, or of the disc in a planar model [m]; 0 for a point.

        Raises
        ------
        ModelError
            An unknown surface, planar and spatial ones mixed, a sphere that does not fit into its groove, a place `at`
            without a frame, a surface of the same body.

        Examples
        --------
        >>> m.contact("bounce", "ball", "floor", fx.Contact(1e6, friction=0.3), frame="R", radius=0.1)
        ... # doctest: +SKIP
        """
        found = find_surface(self, surface, f"contact '{name}'")
        owner = f"contact '{name}' with '{found.name}'"
        check_contact(contact, owner)
        if contact.per == "length":
            raise ModelError(
                f"{owner}: its stiffness is per length of a rope; give the stiffness of the point, with per='point'"
            )
        if found.kind == "helical_groove":
            raise ModelError(f"{owner}: a helical groove takes ropes only; give a sheave with another groove")
        a = not_negative(radius, owner, "radius")
        check_fits("sphere", a, found, owner)
        planar, nodes = self._find_nodes(owner, (point, "point"))
        if planar != found.planar:
            where = ("in space", "in a planar model")
            raise ModelError(
                f"{owner}: '{nodes[0].name}' lies {where[planar]}, the surface {where[not planar]}; use one kind"
            )
        if frame is not None:
            nodes.append(self._find_of_kind(frame, ("planar_angle" if planar else "frame",), owner))
        if nodes[0].name == found.point and all(z.name == found.frame for z in nodes[1:]):
            raise ModelError(
                f"{owner}: the surface is fixed in the same body, with the point '{found.point}'; give a point of "
                "another"
            )
        centre = nodes[0].x0 if at is None else vector(at, owner, "at", 2 if planar else 3)
        _check_off_axle(owner, centre, found)
        values = found.parameters | {"sphere_radius": np.array([a])}
        gaps, touching = found.gaps, "point"
        if frame is not None:
            values["centre"] = in_body(nodes[1].x0, centre - nodes[0].x0)
            touching = "disc" if planar else "sphere"
            gaps = SPHERE_IN_V if found.kind == "v_groove" else gaps
        elif at is not None:
            raise ModelError(f"{owner}: a place at={at!r} needs the body that it is fixed in; give its frame")
        self._place(name, found.element(touching), [*nodes, found.point, found.frame], values)
        attach_contact(self, name, gaps, contact, 1.0)


def _check_off_axle(owner: str, centre: Array, surface: Surface) -> None:
    """The normal of a cylinder is not defined on its axle."""
    off = centre - surface.centre
    if not surface.planar:
        off = off - (off @ surface.axle) * surface.axle
    if surface.radius and np.linalg.norm(off) < 1e-9 * surface.radius:
        raise ModelError(
            f"{owner}: as drawn, its centre lies on the axle of '{surface.name}'; move it outside"
        )
