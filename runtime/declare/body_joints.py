"""Joints of two rigid bodies at a drawn place: the methods of `Model` that add one in a single call.

Every joint is a composition of elements: points of both bodies at the place of the joint, and an element between them.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arguments import number
from flexel.base.arrays import Vector
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.declare.joint_places import JointPlaces, Numbers, axis_of
from flexel.declare.relations import RelationMethods
from flexel.declare.rigid_bodies import Given


class BodyJoints(JointPlaces, RelationMethods):
    """Joints of rigid bodies."""

    @whole_or_nothing
    def revolute(
        self,
        name: str,
        p: Given,
        q: Given,
        at: Vector,
        axis: Vector | None = None,
        *,
        stiffness: float | None = None,
        damping: float = 0.0,
        stops: Numbers = None,
        friction: Numbers = None,
    ) -> None:
        """Join two bodies by a pin; ``name.angle`` is free, zero as drawn, and counts turns.

        Parameters
        ----------
        p, q : str, RigidBody or pair of nodes
            Bodies: names given to `rigid_body`, ``"ground"``, or nodes (point, frame).
        at : sequence of float (3,) or (2,)
            Place of the pin in global coordinates as drawn; the bodies' own points may be elsewhere.
        axis : sequence of float (3,)
            Direction of the pin in global axes as drawn; not needed in a planar model.
        stiffness, damping : float
            Torsional spring [N m/rad] and damper [N m s/rad].
        stops : (low, high, stiffness) or (low, high, stiffness, damping), optional
            Stops on both sides, as in `limits`.
        friction : (limit, speed), optional
            Dry friction, as in `friction`.

        Raises
        ------
        ModelError
            Unknown bodies, the same body twice, a spatial pin without an axis.

        Examples
        --------
        >>> m.revolute("pivot", "ground", "crank", at=(0, 0, 0), axis=(0, 1, 0), friction=(0.2, 0.01))
        ... # doctest: +SKIP
        """
        self._pin("revolute", name, p, q, at, axis)
        self._resist(f"{name}.angle", stiffness, damping, stops, friction)

    @whole_or_nothing
    def prismatic(
        self,
        name: str,
        p: Given,
        q: Given,
        axis: Vector,
        at: Vector | None = None,
        *,
        stiffness: float | None = None,
        damping: float = 0.0,
        stops: Numbers = None,
        friction: Numbers = None,
    ) -> None:
        """Let a body slide along an axis of another; ``name.axial`` is free, or ``name.along`` in a planar model.

        Parameters
        ----------
        p, q : str, RigidBody or pair of nodes
            The body with the guide and the one that slides; as in `revolute`.
        axis : sequence of float (3,) or (2,)
            Direction of the guide in global axes as drawn.
        at : sequence of float, optional
            Where its forces and moments are measured, in global coordinates as drawn; by default the point of `q`.
        stiffness, damping : float
            Spring [N/m] and damper [N s/m].
        stops, friction : optional
            As in `revolute`.
        """
        place = self._at("prismatic", name, p, q, at)
        if place.planar:
            self._planar_bearing(name, place, axis)
        else:
            self.bearing(name, *place.ends, axis=axis_of(place, axis))
        slide = self._free(name, "along" if place.planar else "axial", angle=False)
        self._resist(slide, stiffness, damping, stops, friction)

    @whole_or_nothing
    def cylindrical(self, name: str, p: Given, q: Given, at: Vector, axis: Vector) -> None:
        """Let a body turn about an axis of another and slide along it: ``name.angle`` and ``name.axial`` are free.

        Parameters
        ----------
        p, q, at, axis
            As in `revolute`; in space only.
        """
        self._pin("cylindrical", name, p, q, at, axis, "a planar one can only slide: use m.prismatic")
        self._free(name, "axial")

    @whole_or_nothing
    def screw(self, name: str, p: Given, q: Given, at: Vector, axis: Vector, *, pitch: float) -> None:
        """Let a body turn about an axis of another and move along it in proportion, over any number of turns.

        Parameters
        ----------
        p, q, at, axis
            As in `revolute`; in space only.
        pitch : float
            Travel per turn [m]; negative for a left-handed thread.

        Notes
        -----
        ``name.angle`` and ``name.axial`` both measure the motion; the relation ``name_thread.relation`` is the thread.
        """
        owner = f"screw '{name}'"
        rise = number(pitch, owner, "pitch")
        if not rise:
            raise ModelError(f"{owner}: pitch 0 lets the nut turn without travel; use m.revolute")
        self._pin("screw", name, p, q, at, axis, "relate a slide and a turn by m.relation")
        self._free(name, "axial")
        self.relation(f"{name}_thread", {f"{name}.axial": 1.0, f"{name}.angle": -rise / (2 * np.pi)})

    @whole_or_nothing
    def planar_joint(self, name: str, p: Given, q: Given, normal: Vector, at: Vector | None = None) -> None:
        """Let a body slide and turn on a plane of another.

        Free are ``name.radial1`` and ``name.radial2``, displacements in the plane, and ``name.angle`` about its normal.

        Parameters
        ----------
        p, q : str, RigidBody or pair of nodes
            As in `revolute`; in space only.
        normal : sequence of float (3,)
            Of the plane, in global axes as drawn; it turns with p.
        at : sequence of float (3,), optional
            A place in the plane, in global coordinates as drawn; by default the point of `q`.
        """
        remedy = "planar bodies are free of one another without a joint"
        self._pin("planar joint", name, p, q, at, normal, remedy)
        self._free(name, "radial1", "radial2")

    @whole_or_nothing
    def spherical(self, name: str, p: Given, q: Given, at: Vector) -> None:
        """Join two bodies by a ball joint: three rotations are free.

        Its forces are the stresses of ``name.along``, ``across1`` and ``across2``, in the axes of p.  The rotations are
        not measured by angles; use `cardan_chain` where angles are needed.

        Parameters
        ----------
        p, q, at
            As in `revolute`; in space only.
        """
        place = self._in_space("spherical", name, p, q, at, "use m.revolute")
        self._ball(name, place)

    @whole_or_nothing
    def universal(self, name: str, p: Given, q: Given, at: Vector, axis_p: Vector, axis_q: Vector) -> None:
        """Join two bodies by crossed pins; ``name_1.angle`` about that in p, ``name_2.angle`` about that in q are free.

        Parameters
        ----------
        p, q, at
            As in `revolute`; in space only.
        axis_p, axis_q : sequence of float (3,)
            Directions of the pins in p and in q, in global axes as drawn; not parallel.
        """
        place = self._in_space("universal joint", name, p, q, at, "use m.revolute")
        first, second = axis_of(place, axis_p, "axis_p"), axis_of(place, axis_q, "axis_q")
        if np.linalg.norm(np.cross(first, second)) < 1e-6:
            raise ModelError(f"{place.owner}: its pins are parallel; turn axis_q")
        self._ball(name, place)
        cross = self.frame(f"{name}_cross")
        self.hinge(f"{name}_1", place.bodies[0].frame, cross, axis=first)
        self.hinge(f"{name}_2", cross, place.bodies[1].frame, axis=second)

    @whole_or_nothing
    def weld(self, name: str, p: Given, q: Given, at: Vector | None = None) -> None:
        """Join two bodies rigidly, as drawn; all deformations of the joint are rigid and have stresses.

        Parameters
        ----------
        p, q : str, RigidBody or pair of nodes
            As in `revolute`.
        at : sequence of float, optional
            Where its forces and moments are measured, in global coordinates as drawn; by default the point of `q`.
        """
        place = self._at("weld", name, p, q, at)
        self.bearing(name, *place.ends, axis=None if place.planar else (1.0, 0.0, 0.0))
        self._free(name, angle=False)
