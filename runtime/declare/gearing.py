"""Gears, racks, belts and chains of angles: the methods of `Model` that relate the coordinates of joints.

The sense in which one turns the other follows from the drawing: the axes of the joints, the place where teeth touch.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from flexel.base.arguments import flag, number, positive, vector, whole
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.quaternions import matrix, product, unit
from flexel.base.transactions import whole_or_nothing
from flexel.declare.body_joints import BodyJoints
from flexel.declare.rigid_bodies import GROUND, Given

ALIGNED = 1e-6  # sine of the largest angle between directions that are taken as one
TEETH = 0.01  # largest relative difference between a ratio of teeth and the drawing
AXES = dict(zip("xyz", np.eye(3), strict=True))


@dataclass(frozen=True)
class _Axis:
    """A joint as drawn: where its axis passes, in which direction, and the body that holds it."""

    joint: str
    point: Array
    direction: Array
    holder: str

    def speed(self, at: Array) -> Array:
        """Velocity of the second body at a place, for unit rate of the joint's angle."""
        return np.cross(self.direction, at - self.point)


class Gearing(BodyJoints):
    """Gears, racks, belts and chains of angles."""

    @whole_or_nothing
    def gear(
        self,
        name: str,
        p: str,
        q: str,
        at: Vector,
        *,
        teeth: Sequence[int] | None = None,
        lead: float | None = None,
    ) -> None:
        """Mesh two gears on joints of the same body: spur, internal, bevel or crossed gears, or a worm and its wheel.

        Parameters
        ----------
        p, q : str
            Joints with an angle (`revolute`, `cylindrical`, `bearing`) whose first body is the same: the housing or
            carrier; the gears are their second bodies.
        at : sequence of float (3,) or (2,)
            Where the teeth touch, in global coordinates as drawn; it gives ratio and sense.
        teeth : (int, int), optional
            Numbers of teeth (or starts) of p and q, for the exact ratio; the sense still follows from the drawing.
        lead : float, optional
            Of the teeth of p [m per turn], negative if left-handed: p is a worm or a helical gear, on any axis.

        Raises
        ------
        ModelError
            Joints of different first bodies, numbers of teeth that contradict the drawing, a place on an axis, teeth
            that move in different directions there (which takes a lead).

        Notes
        -----
        The relation is ``name.relation``: angle of q less ratio times angle of p, over any number of turns.  Released,
        with a spring, it is an elastic mesh.

        See Also
        --------
        planar_gear : Gears of the plane by their nodes, on centres that may move.
        """
        owner = f"gear '{name}'"
        first, second, x = *self._two_axes(owner, p, q), self._in_drawing(owner, p, at)
        vp, vq = first.speed(x), second.speed(x)
        if min(np.linalg.norm(vp), np.linalg.norm(vq)) < 1e-12:
            raise ModelError(f"{owner}: the teeth touch on an axis; move 'at' to the pitch circles")
        t = vp / np.linalg.norm(vp)
        if lead is None:
            if np.linalg.norm(np.cross(t, vq)) > ALIGNED * np.linalg.norm(vq):
                raise ModelError(
                    f"{owner}: the teeth of '{p}' and '{q}' cross at 'at'; move it, or give a lead"
                )
            n = t
        else:
            n = number(lead, owner, "lead") / (2 * np.pi) * t - np.linalg.norm(vp) * first.direction
        if abs(vp @ n) < 1e-12 * np.linalg.norm(vp) or abs(vq @ n) < ALIGNED * np.linalg.norm(
            vq
        ) * np.linalg.norm(n):
            raise ModelError(f"{owner}: these teeth do not drive one another; check lead and axes")
        ratio = (vp @ n) / (vq @ n)
        if teeth is not None:
            ratio = np.sign(ratio) * _teeth(owner, teeth, abs(float(ratio)))
        self.relation(name, {f"{q}.angle": 1.0, f"{p}.angle": -float(ratio)})

    @whole_or_nothing
    def rack_and_pinion(self, name: str, pinion: str, rack: str, at: Vector) -> None:
        """Mesh a pinion with a rack, over any number of turns; both are held by the same body.

        Parameters
        ----------
        pinion : str
            A joint with an angle, as in `gear`.
        rack : str
            A joint with a slide, made by `prismatic` with the same first body.
        at : sequence of float (3,) or (2,)
            Where the teeth touch, in global coordinates as drawn; it gives the radius of the pinion and the sense.

        Notes
        -----
        The relation is ``name.relation``: travel of the rack less radius times angle of the pinion.
        """
        owner = f"rack and pinion '{name}'"
        turning, sliding = self._two_axes(owner, pinion, rack)
        v, d = turning.speed(self._in_drawing(owner, pinion, at)), sliding.direction
        slide = f"{rack}.axial"
        if self.instances[rack].spec.planar:
            slide = f"{rack}.along"
            angle = self._start(rack, 1)[0] + self.instances[rack].parameters["alpha0"][0]
            d = np.array([np.cos(angle), np.sin(angle), 0.0])
        if np.linalg.norm(np.cross(v, d)) > ALIGNED * np.linalg.norm(v) or np.linalg.norm(v) < 1e-12:
            raise ModelError(
                f"{owner}: the pinion does not move along the rack at 'at'; put it on the pitch circle"
            )
        self.relation(name, {slide: 1.0, f"{pinion}.angle": -float(v @ d)})

    @whole_or_nothing
    def belt(
        self, name: str, p: str, q: str, *, radius_p: float, radius_q: float, crossed: bool = False
    ) -> None:
        """Let a belt or chain that neither slips nor stretches run over two pulleys on parallel axes.

        Parameters
        ----------
        p, q : str
            Joints of the pulleys, as in `gear`.
        radius_p, radius_q : float
            [m], or numbers of teeth.
        crossed : bool
            The pulleys turn in opposite senses.

        Notes
        -----
        The relation is ``name.relation``: angle of q less ratio times angle of p.

        See Also
        --------
        planar_belt : A belt that may stretch, in the plane, on centres that may move.
        """
        owner = f"belt '{name}'"
        first, second = self._two_axes(owner, p, q)
        along = first.direction @ second.direction
        if abs(along) < np.sqrt(1 - ALIGNED**2):
            raise ModelError(
                f"{owner}: the axes of '{p}' and '{q}' are not parallel; turn one, or use m.relation"
            )
        ratio = positive(radius_p, owner, "radius_p") / positive(radius_q, owner, "radius_q")
        sense = np.sign(along) * (-1 if flag(crossed, owner, "crossed") else 1)
        self.relation(name, {f"{q}.angle": 1.0, f"{p}.angle": -float(sense * ratio)})

    @whole_or_nothing
    def cardan_chain(
        self, first: str, second: str, third: str, *, body: Given, base: Given = GROUND, axes: Any = "zxy"
    ) -> None:
        """Measure the orientation of a body by three angles: a chain of hinges without constraints.

        ``first.angle``, ``second.angle`` and ``third.angle`` are zero as drawn and count turns; they can be
        independent, prescribed, or carry springs.  In space only.

        Parameters
        ----------
        first, second, third : str
            Names of the hinges, in this order from the base to the body: "yaw", "lean", "pitch".
        body, base : str, RigidBody or pair of nodes
            As in `revolute`.
        axes : str or three vectors
            Axes of the hinges as drawn: letters of global axes, or directions.

        Notes
        -----
        Where the first and the third axis coincide (the second angle is 90 degrees for perpendicular axes), the
        first and the third angle are not determined.
        """
        owner = f"cardan chain '{first}', '{second}', '{third}'"
        start, end = self._two_bodies(owner, base, body)
        if start.planar:
            raise ModelError(f"{owner}: the orientation of a planar body is an angle already; use it")
        if not isinstance(axes, (str, Sequence, np.ndarray)) or len(axes) != 3:
            raise ModelError(
                f"{owner}: axes {axes!r:.60} are not three; give letters such as 'zxy' or directions"
            )
        directions = [
            AXES[z] if isinstance(z, str) and z in AXES else unit(z, owner, f"axis {i}")
            for i, z in enumerate(axes, 1)
        ]
        if any(np.linalg.norm(np.cross(a, b)) < ALIGNED for a, b in pairwise(directions)):
            raise ModelError(f"{owner}: two successive axes are parallel; turn one")
        frames = [start.frame, *(self.frame(f"{z}_frame", end.frame.x0) for z in (first, second)), end.frame]
        for hinge, (p, q), axis in zip((first, second, third), pairwise(frames), directions, strict=True):
            self.hinge(hinge, p, q, axis=axis)

    def _two_axes(self, owner: str, p: str, q: str) -> tuple[_Axis, _Axis]:
        """Two joints as drawn, held by the same body."""
        first, second = (self._axis_of(owner, z) for z in (p, q))
        if p == q:
            raise ModelError(f"{owner}: both its joints are '{p}'; name two")
        if first.holder != second.holder:
            raise ModelError(
                f"{owner}: '{p}' starts at '{first.holder}' and '{q}' at '{second.holder}'; make both with the "
                "housing or carrier as their first body"
            )
        return first, second

    def _axis_of(self, owner: str, joint: str) -> _Axis:
        """A joint with an axis, as drawn."""
        instance = self.instances.get(joint) if isinstance(joint, str) else None
        if instance is None or instance.spec.family != "bearing":
            raise ModelError(
                f"{owner}: {joint!r:.60} is not a joint with an axis; name one made by m.revolute or m.prismatic"
            )
        point, frame = self._start(joint, 0), self._start(joint, 1)
        axis = np.array([0.0, 0.0, 1.0])
        if instance.spec.planar:
            point = np.append(point, 0.0)
        else:
            axis = matrix(product(frame, instance.parameters["tp"]))[:, 0]
        return _Axis(joint, point, axis, instance.nodes[1])

    def _start(self, joint: str, node: int) -> Array:
        """A node of a joint as drawn."""
        return self.nodes[self.instances[joint].nodes[node]].x0

    def _in_drawing(self, owner: str, joint: str, at: Vector) -> Array:
        """A place in global coordinates (3,), given with as many as the joint has."""
        planar = self.instances[joint].spec.planar
        x = vector(at, owner, "at", 2 if planar else 3)
        return np.append(x, 0.0) if planar else x


def _teeth(owner: str, teeth: Any, drawn: float) -> float:
    """Ratio of the numbers of teeth, which must be that of the drawing."""
    if not isinstance(teeth, Sequence) or isinstance(teeth, str) or len(teeth) != 2:
        raise ModelError(f"{owner}: teeth {teeth!r:.60} are not two numbers; give (of p, of q)")
    a, b = (whole(z, owner, "teeth") for z in teeth)
    if abs(a / b - drawn) > TEETH * drawn:
        raise ModelError(
            f"{owner}: {a} and {b} teeth give the ratio {a / b:.6g}, and the drawing {drawn:.6g}; move 'at' or the axes"
        )
    return a / b
