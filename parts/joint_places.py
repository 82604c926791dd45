"""The position of a joint: both bodies, the point of each there, and the common parts of joints of rigid bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_body, unit
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.rigid_body import RigidBody
from flexel.parts.friction import Friction, Limits
from flexel.parts.joints import Bearing, BodyPoint
from flexel.parts.rigid_bodies import Given, point_of, two_bodies
from flexel.parts.roles import Release, Rigid
from flexel.parts.springs import Spring

Numbers = Sequence[float]


@dataclass(frozen=True)
class JointPlace:
    """Both bodies of a joint, and the point of each where the joint is.

    Attributes
    ----------
    owner : str
        The joint, for messages.
    bodies : tuple of RigidBody
    points : tuple of Node
    """

    owner: str
    bodies: tuple[RigidBody, RigidBody]
    points: tuple[Node, Node]

    @property
    def planar(self) -> bool:
        """Whether the bodies are planar."""
        return self.bodies[0].planar

    @property
    def ends(self) -> tuple[Node, Node, Node, Node]:
        """Point and frame of each body."""
        return self.points[0], self.bodies[0].frame, self.points[1], self.bodies[1].frame


def place_of(to: Lowering, kind: str, name: str, p: Given, q: Given, at: Vector | None) -> JointPlace:
    """Return both bodies of a joint with their points where the joint is; by default at the point of q."""
    owner = f"{kind} '{name}'"
    bodies = two_bodies(to, owner, p, q)
    x = bodies[1].point.x0 if at is None else vector(at, owner, "at", bodies[0].point.x0.size)
    to.new_name(name, kind)
    first, second = (point_of(to, body, x, f"{name}_{end}") for body, end in zip(bodies, "pq", strict=True))
    if first.name == second.name:
        raise ModelError(f"{owner}: both bodies have the point '{first.name}'; join them by m.hinge")
    return JointPlace(owner, bodies, (first, second))


def place_in_space(
    to: Lowering, kind: str, name: str, p: Given, q: Given, at: Vector | None, remedy: str
) -> JointPlace:
    """Return the same for spatial bodies; a ModelError gives the remedy for planar ones."""
    owner = f"{kind} '{name}'"
    if two_bodies(to, owner, p, q)[0].planar:
        raise ModelError(f"{owner}: it joins bodies in space, but these are planar; {remedy}")
    return place_of(to, kind, name, p, q, at)


def add_pin(to: Lowering, name: str, place: JointPlace, axis: Vector | None) -> None:
    """Add a bearing where a joint is; an axis is needed in space only."""
    Bearing(name, *place.ends, axis=None if place.planar else axis_of(place, axis)).lower(to)


def add_planar_bearing(to: Lowering, name: str, place: JointPlace, axis: Vector) -> None:
    """Add a planar bearing that measures along an axis."""
    p, rp, q, rq = place.ends
    e = unit(axis, place.owner, "axis", 2)
    alpha0 = np.arctan2(e[1], e[0]) - rp.x0
    d0 = in_body(rp.x0 + alpha0, q.x0 - p.x0)
    values = {"alpha0": alpha0, "d0": d0, "offset0": rq.x0 - rp.x0}
    to.element(name, "planar_bearing", (p, rp, q, rq), values)


def add_ball(to: Lowering, name: str, place: JointPlace) -> None:
    """Hold the points of both bodies together."""
    p, rp, q, _ = place.ends
    BodyPoint(name, p, rp, q, body_axes=True).lower(to)


def free(to: Lowering, name: str, *deformations: str) -> None:
    """Release deformations of a joint."""
    Release(tuple(f"{name}.{deformation}" for deformation in deformations)).lower(to)


def hold_angle(to: Lowering, name: str) -> None:
    """Make the angle of a joint rigid."""
    Rigid((f"{name}.angle",)).lower(to)


def resist(
    to: Lowering,
    on: str,
    stiffness: float | None,
    damping: float,
    stops: Numbers | None,
    friction: Numbers | None,
) -> None:
    """Add a spring, a damper, stops and friction on the free deformation of a joint."""
    owner = f"joint '{on.partition('.')[0]}'"
    if stiffness is not None or damping:
        Spring(on, stiffness, damping).lower(to)
    if stops is not None:
        Limits(on, *_few(owner, "stops", stops, ("low", "high", "stiffness", "damping"), 3)).lower(to)
    if friction is not None:
        Friction(on, *_few(owner, "friction", friction, ("limit", "speed"), 2)).lower(to)


def axis_of(place: JointPlace, axis: Any, what: str = "axis") -> Array:
    """Return the direction of an axis that a joint in space needs."""
    if axis is None:
        raise ModelError(f"{place.owner}: in space it needs an axis; give axis=(x, y, z)")
    return unit(axis, place.owner, what)


def _few(owner: str, what: str, given: Any, names: tuple[str, ...], least: int) -> tuple[Any, ...]:
    """Return as many numbers as are named, or without the last ones, down to the least number."""
    if not isinstance(given, Sequence) or isinstance(given, str) or not least <= len(given) <= len(names):
        raise ModelError(f"{owner}: {what} {given!r:.60} are not numbers; give ({', '.join(names[:least])})")
    return tuple(given)
