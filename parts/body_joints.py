"""Joints of two rigid bodies at a drawn position.

Every joint is composed of elements: a point of each body at the joint, and an element between them.
"""

from __future__ import annotations

from dataclasses import KW_ONLY

import numpy as np

from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.lowering import Lowering
from flexel.model.part import Part, kind_of, part
from flexel.parts.joint_places import (
    Numbers,
    add_ball,
    add_pin,
    add_planar_bearing,
    axis_of,
    free,
    hold_angle,
    place_in_space,
    place_of,
    resist,
)
from flexel.parts.joints import Bearing, Hinge
from flexel.parts.nodes import Frame
from flexel.parts.relations import Relation
from flexel.parts.rigid_bodies import Given


@part
class Revolute(Part[None]):
    """Join two bodies by a pin; ``name.angle`` is free, zero as drawn, and counts turns.

    Raises
    ------
    ModelError
        Unknown bodies, the same body twice, a spatial pin without an axis.

    Examples
    --------
    >>> m.revolute("pivot", "ground", "crank", at=(0, 0, 0), axis=(0, 1, 0), friction=(0.2, 0.01))
    ... # doctest: +SKIP
    """

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry('A body: a name given to `rigid_body`, ``"ground"``, or nodes (point, frame).')
    q: Given = entry("The other body.")
    at: Vector = array_quantity(
        "m",
        "Position of the pin in global coordinates as drawn; the bodies' reference points may be elsewhere.",
    )
    axis: Vector | None = array_quantity(
        "-", "Direction of the pin in global axes as drawn; not needed in a planar model.", default=None
    )
    _: KW_ONLY
    stiffness: float | None = array_quantity(
        "N m/rad", "Stiffness of a torsional spring [], as in `spring`.", default=None
    )
    damping: float = quantity(
        "N m s/rad", "not negative", "Damping constant of a torsional damper.", default=0.0
    )
    stops: Numbers | None = array_quantity(
        "rad, rad, N m/rad, s/rad",
        "Stops on both sides, as in `limits`: (low, high, stiffness) or (low, high, stiffness, damping) [].",
        default=None,
    )
    friction: Numbers | None = array_quantity(
        "N m, rad/s", "Dry friction, as in `friction`: (limit, speed) [].", default=None
    )

    def lower(self, to: Lowering) -> None:
        """Add a bearing, and the laws on its angle."""
        place = place_of(to, kind_of(type(self)), self.name, self.p, self.q, self.at)
        add_pin(to, self.name, place, self.axis)
        resist(to, f"{self.name}.angle", self.stiffness, self.damping, self.stops, self.friction)


@part
class Prismatic(Part[None]):
    """Let a body slide along an axis of another; ``name.axial`` is free, or ``name.along`` in a planar model."""

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry("The body with the guide, as in `revolute`.")
    q: Given = entry("The body that slides.")
    axis: Vector = array_quantity("-", "Direction of the guide in global axes as drawn.")
    at: Vector | None = array_quantity(
        "m",
        "Where its forces and moments are measured, in global coordinates as drawn; the point of `q` by default.",
        default=None,
    )
    _: KW_ONLY
    stiffness: float | None = array_quantity("N/m", "Stiffness of a spring [], as in `spring`.", default=None)
    damping: float = quantity("N s/m", "not negative", "Damping constant of a damper.", default=0.0)
    stops: Numbers | None = array_quantity(
        "m, m, N/m, s/m", "Stops on both sides, as in `revolute`.", default=None
    )
    friction: Numbers | None = array_quantity("N, m/s", "Dry friction, as in `revolute`.", default=None)

    def lower(self, to: Lowering) -> None:
        """Add a bearing that does not turn, and the laws on its slide."""
        place = place_of(to, kind_of(type(self)), self.name, self.p, self.q, self.at)
        if place.planar:
            add_planar_bearing(to, self.name, place, self.axis)
        else:
            add_pin(to, self.name, place, self.axis)
        slide = "along" if place.planar else "axial"
        free(to, self.name, slide)
        hold_angle(to, self.name)
        resist(to, f"{self.name}.{slide}", self.stiffness, self.damping, self.stops, self.friction)


@part
class Cylindrical(Part[None]):
    """Let a body turn about an axis of another and slide along it: ``name.angle`` and ``name.axial`` are free."""

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry("A body, as in `revolute`; in space only.")
    q: Given = entry("The other body.")
    at: Vector = array_quantity("m", "A point on the axis, in global coordinates as drawn.")
    axis: Vector = array_quantity("-", "Direction of the axis in global axes as drawn.")

    def lower(self, to: Lowering) -> None:
        """Add a bearing that slides."""
        remedy = "a planar body can only slide: use m.prismatic"
        place = place_in_space(to, kind_of(type(self)), self.name, self.p, self.q, self.at, remedy)
        add_pin(to, self.name, place, self.axis)
        free(to, self.name, "axial")


@part
class Screw(Part[None]):
    """Let a body turn about an axis of another and move along it in proportion to the angle, over any number of turns.

    Notes
    -----
    ``name.angle`` and ``name.axial`` both measure the motion; the relation ``name_thread.relation`` is the thread.
    """

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry("A body, as in `revolute`; in space only.")
    q: Given = entry("The other body.")
    at: Vector = array_quantity("m", "A point on the axis, in global coordinates as drawn.")
    axis: Vector = array_quantity("-", "Direction of the axis in global axes as drawn.")
    _: KW_ONLY
    pitch: float = quantity("m", "any", "Travel per turn; negative for a left-handed thread.")

    def lower(self, to: Lowering) -> None:
        """Add a bearing that slides, and the relation of its slide and its angle."""
        if not self.pitch:
            raise ModelError(f"{self.owner}: pitch 0 lets the nut turn without travel; use m.revolute")
        remedy = "relate a displacement to an angle with m.relation"
        place = place_in_space(to, kind_of(type(self)), self.name, self.p, self.q, self.at, remedy)
        add_pin(to, self.name, place, self.axis)
        free(to, self.name, "axial")
        terms = {f"{self.name}.axial": 1.0, f"{self.name}.angle": -self.pitch / (2 * np.pi)}
        Relation(f"{self.name}_thread", terms).lower(to)


@part
class PlanarJoint(Part[None]):
    """Let a body slide and turn on a plane of another.

    The displacements ``name.radial1`` and ``name.radial2`` in the plane and ``name.angle`` about its normal are free.
    """

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry("The body with the plane, as in `revolute`; in space only.")
    q: Given = entry("The body that slides on it.")
    normal: Vector = array_quantity("-", "Normal of the plane, in global axes as drawn; it turns with p.")
    at: Vector | None = array_quantity(
        "m",
        "A point in the plane, in global coordinates as drawn; by default the point of `q`.",
        default=None,
    )

    def lower(self, to: Lowering) -> None:
        """Add a bearing about the normal that slides across it."""
        remedy = "planar bodies move freely without a joint"
        place = place_in_space(to, kind_of(type(self)), self.name, self.p, self.q, self.at, remedy)
        add_pin(to, self.name, place, self.normal)
        free(to, self.name, "radial1", "radial2")


@part
class Spherical(Part[None]):
    """Join two bodies by a ball joint: three rotations are free.

    Its forces are the stresses of ``name.along``, ``across1`` and ``across2``, in the axes of p.  The rotations
    are not measured as angles; use `cardan_chain` if angles are needed.
    """

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry("A body, as in `revolute`; in space only.")
    q: Given = entry("The other body.")
    at: Vector = array_quantity("m", "Centre of the ball in global coordinates as drawn.")

    def lower(self, to: Lowering) -> None:
        """Hold the points of both bodies together."""
        kind = kind_of(type(self))
        add_ball(
            to,
            self.name,
            place_in_space(to, kind, self.name, self.p, self.q, self.at, "use m.revolute"),
        )


@part
class Universal(Part[None]):
    """Join two bodies by crossed pins; ``name_1.angle`` (pin in p) and ``name_2.angle`` (pin in q) are free."""

    name: str = entry("Name of the joint, and of the element that holds the points together.")
    p: Given = entry("A body, as in `revolute`; in space only.")
    q: Given = entry("The other body.")
    at: Vector = array_quantity("m", "Where the pins cross, in global coordinates as drawn.")
    axis_p: Vector = array_quantity("-", "Direction of the pin in p, in global axes as drawn.")
    axis_q: Vector = array_quantity(
        "-", "Direction of the pin in q, in global axes as drawn; not parallel to the other."
    )

    @property
    def owner(self) -> str:
        """The joint, by its usual name."""
        return f"universal joint '{self.name}'"

    def lower(self, to: Lowering) -> None:
        """Hold the points of both bodies together, and add two hinges with the cross between them."""
        place = place_in_space(to, "universal joint", self.name, self.p, self.q, self.at, "use m.revolute")
        first, second = axis_of(place, self.axis_p, "axis_p"), axis_of(place, self.axis_q, "axis_q")
        if np.linalg.norm(np.cross(first, second)) < 1e-6:
            raise ModelError(f"{self.owner}: its pins are parallel; turn axis_q")
        add_ball(to, self.name, place)
        cross = Frame(f"{self.name}_cross").lower(to)
        Hinge(f"{self.name}_1", place.bodies[0].frame, cross, axis=first).lower(to)
        Hinge(f"{self.name}_2", cross, place.bodies[1].frame, axis=second).lower(to)


@part
class Weld(Part[None]):
    """Join two bodies rigidly, as drawn; all deformations of the joint are rigid and have stresses."""

    name: str = entry("Name of the joint, and of the element with its deformations.")
    p: Given = entry("A body, as in `revolute`.")
    q: Given = entry("The other body.")
    at: Vector | None = array_quantity(
        "m",
        "Where its forces and moments are measured, in global coordinates as drawn; the point of `q` by default.",
        default=None,
    )

    def lower(self, to: Lowering) -> None:
        """Add a bearing that does not turn."""
        place = place_of(to, kind_of(type(self)), self.name, self.p, self.q, self.at)
        Bearing(self.name, *place.ends, axis=None if place.planar else (1.0, 0.0, 0.0)).lower(to)
        hold_angle(to, self.name)
