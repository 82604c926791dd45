"""Rigid bodies: nodes, mass and further points of a body at once; the ground, and points of bodies for joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import KW_ONLY
from typing import Any

import numpy as np

from flexel.base.arguments import flag, mapping, new_name, unknown, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.model.instances import arm_name
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.model.rigid_body import RigidBody
from flexel.parts.bodies import Body
from flexel.parts.joints import BodyPoint
from flexel.parts.nodes import Angle, Frame, Point, drawn

GROUND = "ground"
NEAR = 1e-12  # points closer than this, relative to their distance from the origin, are one
Given = RigidBody | str | tuple[Node | str, Node | str]


@part
class RigidBodyPart(Part[RigidBody]):
    """Add a rigid body: its nodes, its mass and further points for joints, springs and loads.

    Returns
    -------
    RigidBody
        With ``point``, ``frame`` and ``points``; its name can be given wherever a body is expected.

    Raises
    ------
    ModelError
        A mass without inertia or vice versa, a name that is taken.

    Examples
    --------
    >>> crank = m.rigid_body("crank", (0.5, 0), mass=2.0, inertia=0.1, points={"tip": (1, 0)})  # doctest: +SKIP
    >>> m.revolute("pivot", "ground", "crank", at=(0, 0))  # doctest: +SKIP
    >>> m.load("crank_tip.y", -10.0)  # doctest: +SKIP
    """

    name: str = entry(
        "Name of the body and of the node at its mass centre; ``name_frame`` is its orientation, ``name_body`` the "
        "element with its mass, and ``name_tip`` the node of a point ``tip``."
    )
    position: Vector = array_quantity(
        "m", "Position of the mass centre as drawn; two numbers in a planar model."
    )
    orientation: Any = array_quantity(
        "",
        "Euler parameters, or the angle [rad] in a planar model; by default the body's axes are the global ones.",
        default=None,
        form="float or sequence of float, optional",
    )
    _: KW_ONLY
    mass: float | None = quantity(
        "kg", "positive", "Mass; without mass and inertia the body is massless.", default=None
    )
    inertia: Any = array_quantity(
        "kg m²",
        "Inertia about the mass centre in body axes [], as in `body`; one number in a planar model.",
        default=None,
        form="array_like, optional",
    )
    points: Mapping[str, Vector] | None = array_quantity(
        "m", "Further points of the body, by name, in global coordinates as drawn.", default=None
    )
    fixed: bool = entry("Hold the body as drawn.", default=False)

    def lower(self, to: Lowering) -> RigidBody:
        """Add the nodes, the mass and the points, and register the body."""
        new_name(self.name, "rigid body")
        if self.name == GROUND:
            raise ModelError(f"{self.owner}: the ground already exists; joints refer to it by this name")
        point, frame = _nodes(to, self)
        if (self.mass is None) != (self.inertia is None):
            missing, given = ("inertia", "mass") if self.inertia is None else ("mass", "inertia")
            raise ModelError(
                f"{self.owner}: {given} is given without {missing}; give both, or a massless body"
            )
        if self.mass is not None:
            Body(f"{self.name}_body", point, frame, mass=self.mass, inertia=self.inertia).lower(to)
        body = RigidBody(self.name, point, frame, {})
        places = {
            tip: vector(place, self.owner, f"point '{tip}'", point.x0.size)
            for tip, place in mapping(self.points, self.owner, "points").items()
        }
        found = {
            tip: _new_point(to, body, f"{self.name}_{new_name(tip, 'point')}", place)
            for tip, place in places.items()
        }
        to.rigid_bodies[self.name] = RigidBody(self.name, point, frame, found)
        return to.rigid_bodies[self.name]


def _nodes(to: Lowering, body: RigidBodyPart) -> tuple[Node, Node]:
    """Add the mass centre and the orientation of a body."""
    x0 = drawn(body.position, body.owner)
    planar = x0.size == 2
    held = flag(body.fixed, body.owner, "fixed")
    point = Point(body.name, x0, held).lower(to)
    turned, given = f"{body.name}_frame", body.orientation
    if planar:
        return point, Angle(turned, 0.0 if given is None else given, held).lower(to)
    return point, Frame(turned, np.eye(4)[0] if given is None else given, held).lower(to)


def two_bodies(to: Lowering, owner: str, p: Given, q: Given) -> tuple[RigidBody, RigidBody]:
    """Return the bodies that a joint joins, both planar or both spatial; the ground is made at first use."""
    planar = None
    for given in (p, q):
        if not _is_ground(given):
            planar = rigid_body(to, given, owner).planar
    if planar is None:
        raise ModelError(f"{owner}: both its bodies are the ground; name two different ones")
    first, second = (
        ground(to, planar, owner) if _is_ground(given) else rigid_body(to, given, owner) for given in (p, q)
    )
    if first.planar != second.planar:
        raise ModelError(
            f"{owner}: one of '{first.name}' and '{second.name}' is planar and one spatial; join two of one kind"
        )
    if first.frame.name == second.frame.name:
        raise ModelError(f"{owner}: both its bodies are '{first.name}'; name two different ones")
    return first, second


def rigid_body(to: Lowering, given: Given, owner: str) -> RigidBody:
    """Return a body by name, as an object, or as a pair of nodes (point, frame)."""
    if isinstance(given, tuple) and len(given) == 2:
        _, (point, frame) = to.find_nodes(owner, (given[0], "point"), (given[1], "frame"))
        return RigidBody(point.name, point, frame, {})
    name = given.name if isinstance(given, RigidBody) else given
    if not isinstance(name, str):
        raise ModelError(
            f"{owner}: {given!r:.80} is not a body; give the name of one, 'ground', or its nodes (point, frame)"
        )
    if name not in to.rigid_bodies:
        raise ModelError(f"{owner}: {unknown(name, [*to.rigid_bodies, GROUND], 'rigid body')}")
    found = to.rigid_bodies[name]
    point, frame = to.nodes[found.point.name], to.nodes[found.frame.name]
    if isinstance(given, RigidBody) and given.point.x0 is not found.point.x0:
        raise ModelError(f"{owner}: the body '{name}' belongs to another model; use the bodies of this one")
    return RigidBody(name, point, frame, found.points)  # as fixed by now


def ground(to: Lowering, planar: bool, owner: str) -> RigidBody:
    """Return the ground of a planar or spatial model; made at first use."""
    if GROUND in to.rigid_bodies:
        return to.rigid_bodies[GROUND]
    if GROUND in to.nodes and not np.all(to.nodes[GROUND].fixed):
        raise ModelError(
            f"{owner}: the node '{GROUND}' of this model can move, but joints refer to the ground by this name; "
            "fix it, rename it, or give the nodes (point, frame) of a body"
        )
    place, turned = f"{GROUND}_point", f"{GROUND}_frame"  # 'ground' is left to nodes of the user
    if taken := [name for name in (place, turned) if name in to.nodes or name in to.instances]:
        raise ModelError(
            f"{owner}: '{taken[0]}' is already a name in this model; give the nodes (point, frame) of the ground"
        )
    point = Point(place, np.zeros(2 if planar else 3), fixed=True).lower(to)
    frame = Angle(turned, fixed=True).lower(to) if planar else Frame(turned, fixed=True).lower(to)
    to.rigid_bodies[GROUND] = RigidBody(GROUND, point, frame, {})
    return to.rigid_bodies[GROUND]


def point_of(to: Lowering, body: RigidBody, place: Array, name: str) -> Node:
    """Return the point of a body at a drawn position: an existing one, or a new one with that name."""
    for node in (body.point, *body.points.values()):
        if np.linalg.norm(node.x0 - place) <= NEAR * max(1.0, float(np.max(np.abs(place)))):
            return to.nodes[node.name]
    return _new_point(to, body, name, place)


def _is_ground(given: object) -> bool:
    return isinstance(given, str) and given == GROUND


def _new_point(to: Lowering, body: RigidBody, name: str, place: Array) -> Node:
    """Add a point of a body: fixed where the body is, otherwise held by a massless link."""
    node = Point(name, place, fixed=body.still).lower(to)
    if not body.still:
        BodyPoint(arm_name(node.name), body.point, body.frame, node, body_axes=True).lower(to)
    return node
