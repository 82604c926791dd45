"""Rigid bodies: the method of `Model` that makes nodes, mass and further points of a body at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from flexel.base.arguments import array, flag, mapping, new_name, unknown, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.bodies import Bodies
from flexel.declare.joints import Joints
from flexel.declare.nodes import Nodes
from flexel.structure.nodes import Node
from flexel.structure.rigid_bodies import RigidBody

GROUND = "ground"
NEAR = 1e-12  # points closer than this, relative to their distance from the origin, are one
Given = RigidBody | str | tuple[Node | str, Node | str]


class RigidBodies(Joints, Bodies, Nodes):
    """Rigid bodies, and points on them."""

    @whole_or_nothing
    def rigid_body(
        self,
        name: str,
        position: Vector,
        orientation: Any = None,
        *,
        mass: float | None = None,
        inertia: Any = None,
        points: Mapping[str, Vector] | None = None,
        fixed: bool = False,
    ) -> RigidBody:
        """Add a rigid body: its nodes, its mass and further points for joints, springs and loads.

        Parameters
        ----------
        name : str
            Of the body and of the node at its mass centre; ``name_frame`` is its orientation, ``name_body`` the element
            with its mass, and ``name_tip`` the node of a point ``tip``.
        position : sequence of float (3,) or (2,)
            Mass centre as drawn [m]; two numbers in a planar model.
        orientation : sequence of float (4,) or float, optional
            Euler parameters, or the angle [rad] in a planar model; by default the body's axes are the global ones.
        mass : float, optional
            [kg]; without mass and inertia the body is massless.
        inertia : array_like, optional
            About the mass centre in body axes [kg m²], as in `body`; one number in a planar model.
        points : mapping of str to sequence of float, optional
            Further points of the body, by name, in global coordinates as drawn.
        fixed : bool
            Hold the body where it is drawn.

        Returns
        -------
        RigidBody
            With ``point``, ``frame`` and ``points``; its name can be given wherever a body is expected.

        Raises
        ------
        ModelError
            A mass without inertia or the reverse, a name that is taken.

        Examples
        --------
        >>> crank = m.rigid_body("crank", (0.5, 0), mass=2.0, inertia=0.1, points={"tip": (1, 0)})  # doctest: +SKIP
        >>> m.revolute("pivot", "ground", "crank", at=(0, 0))  # doctest: +SKIP
        >>> m.load("crank_tip.y", -10.0)  # doctest: +SKIP
        """
        new_name(name, "rigid body")
        owner = f"rigid body '{name}'"
        if name == GROUND:
            raise ModelError(f"{owner}: the ground exists already; joints refer to it by this name")
        x0 = array(position, owner, "position")
        planar = x0.shape == (2,)
        x0 = vector(x0, owner, "position", 2 if planar else 3)
        held = flag(fixed, owner, "fixed")
        point = self.point(name, x0, held)
        if planar:
            frame = self.angle(f"{name}_frame", 0.0 if orientation is None else orientation, held)
        else:
            frame = self.frame(f"{name}_frame", np.eye(4)[0] if orientation is None else orientation, held)
        if (mass is None) != (inertia is None):
            missing, given = ("inertia", "mass") if inertia is None else ("mass", "inertia")
            raise ModelError(f"{owner}: {given} is given without {missing}; give both, or a massless body")
        if mass is not None:
            self.body(f"{name}_body", point, frame, mass=mass, inertia=inertia)
        body = RigidBody(name, point, frame, {})
        places = {
            z: vector(x, owner, f"point '{z}'", x0.size) for z, x in mapping(points, owner, "points").items()
        }
        found = {z: _new_point(self, body, f"{name}_{new_name(z, 'point')}", x) for z, x in places.items()}
        self._rigid_bodies[name] = RigidBody(name, point, frame, found)
        return self._rigid_bodies[name]

    def _two_bodies(self, owner: str, p: Given, q: Given) -> tuple[RigidBody, RigidBody]:
        """The bodies that a joint joins, both planar or both spatial; the ground is made at first use."""
        planar = None
        for given in (p, q):
            if not _is_ground(given):
                planar = self._rigid_body(given, owner).planar
        if planar is None:
            raise ModelError(f"{owner}: both its bodies are the ground; name two different ones")
        first, second = (
            self._ground(planar, owner) if _is_ground(given) else self._rigid_body(given, owner)
            for given in (p, q)
        )
        if first.planar != second.planar:
            raise ModelError(
                f"{owner}: '{first.name}' and '{second.name}' are one planar and one spatial; join two of one kind"
            )
        if first.frame.name == second.frame.name:
            raise ModelError(f"{owner}: both its bodies are '{first.name}'; name two different ones")
        return first, second

    def _rigid_body(self, given: Given, owner: str) -> RigidBody:
        """A body by name, as an object, or as a pair of nodes (point, frame)."""
        if isinstance(given, tuple) and len(given) == 2:
            _, (point, frame) = self._find_nodes(owner, (given[0], "point"), (given[1], "frame"))
            return RigidBody(point.name, point, frame, {})
        name = given.name if isinstance(given, RigidBody) else given
        if not isinstance(name, str):
            raise ModelError(
                f"{owner}: {given!r:.80} is not a body; give the name of one, 'ground', or its nodes (point, frame)"
            )
        if name not in self._rigid_bodies:
            raise ModelError(f"{owner}: {unknown(name, [*self._rigid_bodies, GROUND], 'rigid body')}")
        found = self._rigid_bodies[name]
        point, frame = self.nodes[found.point.name], self.nodes[found.frame.name]
        if isinstance(given, RigidBody) and given.point.x0 is not found.point.x0:
            raise ModelError(
                f"{owner}: the body '{name}' belongs to another model; use the bodies of this one"
            )
        return RigidBody(name, point, frame, found.points)  # as fixed by now

    def _ground(self, planar: bool, owner: str) -> RigidBody:
        """The ground of a planar or spatial model."""
        if GROUND not in self._rigid_bodies:
            if GROUND in self.nodes and not np.all(self.nodes[GROUND].fixed):
                raise ModelError(
                    f"{owner}: the node '{GROUND}' of this model can move, and joints mean the ground by this name; "
                    "fix it, name it otherwise, or give the nodes (point, frame) of a body"
                )
            place, turned = f"{GROUND}_point", f"{GROUND}_frame"  # 'ground' is left to nodes of the user
            if taken := [name for name in (place, turned) if name in self.nodes or name in self.instances]:
                raise ModelError(
                    f"{owner}: '{taken[0]}' is a name in this model; give the nodes (point, frame) of the ground"
                )
            point = self.point(place, np.zeros(2 if planar else 3), fixed=True)
            frame = self.angle(turned, fixed=True) if planar else self.frame(turned, fixed=True)
            self._rigid_bodies[GROUND] = RigidBody(GROUND, point, frame, {})
        return self._rigid_bodies[GROUND]

    def _point_of(self, body: RigidBody, place: Array, name: str) -> Node:
        """The point of a body at a drawn place: one that it has there, or a new one of that name."""
        for node in (body.point, *body.points.values()):
            if np.linalg.norm(node.x0 - place) <= NEAR * max(1.0, float(np.max(np.abs(place)))):
                return self.nodes[node.name]
        return _new_point(self, body, name, place)


def _is_ground(given: object) -> bool:
    return isinstance(given, str) and given == GROUND


def _new_point(model: RigidBodies, body: RigidBody, name: str, place: Array) -> Node:
    """A point of a body: fixed where the body is, otherwise held by a massless link."""
    node = model.point(name, place, fixed=body.still)
    if not body.still:
        model.body_point(f"{name}_link", body.point, body.frame, node, body_axes=True)
    return node
