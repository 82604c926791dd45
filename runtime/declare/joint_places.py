"""The place of a joint: both bodies, the point of each there, and the common part of the methods for joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import not_negative, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_body, unit
from flexel.declare.friction import Friction
from flexel.declare.rigid_bodies import Given, RigidBodies
from flexel.structure.nodes import Node
from flexel.structure.rigid_bodies import RigidBody

Numbers = Sequence[float] | None


@dataclass(frozen=True)
class _Place:
    """Both bodies of a joint, and the point of each at the place of the joint."""

    owner: str
    bodies: tuple[RigidBody, RigidBody]
    points: tuple[Node, Node]

    @property
    def planar(self) -> bool:
        return self.bodies[0].planar

    @property
    def ends(self) -> tuple[Node, Node, Node, Node]:
        """Point and frame of each body."""
        return self.points[0], self.bodies[0].frame, self.points[1], self.bodies[1].frame


class JointPlaces(RigidBodies, Friction):
    """Parts of the joints of rigid bodies."""

    def _at(self, kind: str, name: str, p: Given, q: Given, at: Vector | None) -> _Place:
        """Both bodies with their points at the place of a joint."""
        owner = f"{kind} '{name}'"
        bodies = self._two_bodies(owner, p, q)
        x = bodies[1].point.x0 if at is None else vector(at, owner, "at", bodies[0].point.x0.size)
        self._new_name(name, kind)
        points = [self._point_of(z, x, f"{name}_{end}") for z, end in zip(bodies, "pq", strict=True)]
        if points[0].name == points[1].name:
            raise ModelError(f"{owner}: both bodies have the point '{points[0].name}'; join them by m.hinge")
        return _Place(owner, bodies, (points[0], points[1]))

    def _in_space(self, kind: str, name: str, p: Given, q: Given, at: Vector | None, remedy: str) -> _Place:
        """The same for spatial bodies; a ModelError with the remedy for planar ones."""
        owner = f"{kind} '{name}'"
        if self._two_bodies(owner, p, q)[0].planar:
            raise ModelError(f"{owner}: it joins bodies in space and these are planar; {remedy}")
        return self._at(kind, name, p, q, at)

    def _pin(
        self,
        kind: str,
        name: str,
        p: Given,
        q: Given,
        at: Vector | None,
        axis: Vector | None,
        remedy: str = "",
    ) -> None:
        """A bearing at the place of a joint; a remedy is given for joints in space only."""
        place = self._in_space(kind, name, p, q, at, remedy) if remedy else self._at(kind, name, p, q, at)
        self.bearing(name, *place.ends, axis=None if place.planar else axis_of(place, axis))

    def _planar_bearing(self, name: str, place: _Place, axis: Vector) -> None:
        """A planar bearing that measures along an axis."""
        p, rp, q, rq = place.ends
        e = unit(axis, place.owner, "axis", 2)
        alpha0 = np.arctan2(e[1], e[0]) - rp.x0
        d0 = in_body(rp.x0 + alpha0, q.x0 - p.x0)
        self._place(
            name, "planar_bearing", (p, rp, q, rq), {"alpha0": alpha0, "d0": d0, "offset0": rq.x0 - rp.x0}
        )

    def _ball(self, name: str, place: _Place) -> None:
        """Hold the points of both bodies together."""
        p, rp, q, _ = place.ends
        self.body_point(name, p, rp, q, body_axes=True)

    def _free(self, name: str, *deformations: str, angle: bool = True) -> str:
        """Release deformations of a joint, and hold its angle if requested; returns the last name."""
        found = [f"{name}.{z}" for z in deformations]
        self.release(*found)
        if not angle:
            self.rigid(f"{name}.angle")
        return found[-1] if found else ""

    def _resist(
        self, on: str, stiffness: float | None, damping: float, stops: Numbers, friction: Numbers
    ) -> None:
        """A spring, a damper, stops and friction on the free deformation of a joint."""
        owner = f"joint '{on.partition('.')[0]}'"
        d = not_negative(damping, owner, "damping")
        if stiffness is not None or d:
            self.spring(on, stiffness, d)
        if stops is not None:
            self.limits(on, *_few(owner, "stops", stops, ("low", "high", "stiffness", "damping"), 3))
        if friction is not None:
            self.friction(on, *_few(owner, "friction", friction, ("limit", "speed"), 2))


def axis_of(place: _Place, axis: Any, what: str = "axis") -> Array:
    """The direction of an axis that a joint in space needs."""
    if axis is None:
        raise ModelError(f"{place.owner}: in space it needs an axis; give axis=(x, y, z)")
    return unit(axis, place.owner, what)


def _few(owner: str, what: str, given: Any, names: tuple[str, ...], least: int) -> tuple[Any, ...]:
    if not isinstance(given, Sequence) or isinstance(given, str) or not least <= len(given) <= len(names):
        raise ModelError(f"{owner}: {what} {given!r:.60} are not numbers; give ({', '.join(names[:least])})")
    return tuple(given)
