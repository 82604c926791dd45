"""Gears, racks, belts and chains of angles: relations of the coordinates of joints.

The sense in which one turns the other follows from the drawing: the axes of the joints, the point where teeth touch.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from flexel.base.arguments import flag, vector, whole
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.near_names import near_names
from flexel.base.quaternions import matrix, product, unit
from flexel.model.lowering import Lowering
from flexel.model.part import Part, part
from flexel.parts.joints import Hinge
from flexel.parts.nodes import Frame
from flexel.parts.relations import Relation
from flexel.parts.rigid_bodies import GROUND, Given, two_bodies

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
        """Return the velocity of the second body at a point, for unit rate of the joint's angle."""
        return np.cross(self.direction, at - self.point)


@part
class Gear(Part[None]):
    """Mesh two gears on joints of the same body: spur, internal, bevel or crossed gears, or a worm and its wheel.

    Raises
    ------
    ModelError
        Joints of different first bodies, numbers of teeth that contradict the drawing, a point on an axis, teeth
        that move in different directions there (which requires a lead).

    Notes
    -----
    The relation is ``name.relation``: angle of q minus ratio times angle of p, over any number of turns.  Released,
    with a spring, it is an elastic mesh.

    See Also
    --------
    planar_gear : Planar gears given by their nodes, with centres that may move.
    """

    name: str = entry("Name of the relation.")
    p: str = entry(
        "A joint with an angle (`revolute`, `cylindrical`, `bearing`): its first body is the housing or carrier, its "
        "second one the gear."
    )
    q: str = entry("The joint of the other gear, with the same first body.")
    at: Vector = array_quantity(
        "m", "Where the teeth touch, in global coordinates as drawn; it gives ratio and sense."
    )
    _: KW_ONLY
    teeth: Sequence[int] | None = entry(
        "Numbers of teeth (or starts) of p and q, for the exact ratio; the sense still follows from the drawing.",
        default=None,
    )
    lead: float | None = quantity(
        "m",
        "any",
        "Lead of the teeth of p, per turn [], negative if left-handed: p is a worm or a helical gear, on any axis.",
        default=None,
    )

    def lower(self, to: Lowering) -> None:
        """Add the relation."""
        owner = self.owner
        first, second = _two_axes(to, owner, self.p, self.q)
        x = _in_drawing(to, owner, self.p, self.at)
        vp, vq = first.speed(x), second.speed(x)
        if min(np.linalg.norm(vp), np.linalg.norm(vq)) < 1e-12:
            raise ModelError(f"{owner}: the teeth touch on an axis; move 'at' to the pitch circles")
        n = _across_teeth(self, first, vp, vq)
        weak = ALIGNED * np.linalg.norm(vq) * np.linalg.norm(n)
        if abs(vp @ n) < 1e-12 * np.linalg.norm(vp) or abs(vq @ n) < weak:
            raise ModelError(f"{owner}: these teeth do not drive one another; check lead and axes")
        ratio = (vp @ n) / (vq @ n)
        if self.teeth is not None:
            ratio = np.sign(ratio) * _teeth(owner, self.teeth, abs(float(ratio)))
        Relation(self.name, {f"{self.q}.angle": 1.0, f"{self.p}.angle": -float(ratio)}).lower(to)


def _across_teeth(gear: Gear, first: _Axis, vp: Array, vq: Array) -> Array:
    """Return the direction in which the teeth of p push the teeth of q, from the velocities where they touch."""
    t = vp / np.linalg.norm(vp)
    if gear.lead is not None:
        return np.asarray(gear.lead / (2 * np.pi) * t - np.linalg.norm(vp) * first.direction)
    if np.linalg.norm(np.cross(t, vq)) > ALIGNED * np.linalg.norm(vq):
        raise ModelError(
            f"{gear.owner}: the teeth of '{gear.p}' and '{gear.q}' cross at 'at'; move it, or give a lead"
        )
    return np.asarray(t)


@part
class RackAndPinion(Part[None]):
    """Mesh a pinion with a rack, over any number of turns; both are held by the same body.

    Notes
    -----
    The relation is ``name.relation``: travel of the rack minus radius times angle of the pinion.
    """

    name: str = entry("Name of the relation.")
    pinion: str = entry("A joint with an angle, as in `gear`.")
    rack: str = entry("A joint with a slide, made by `prismatic` with the same first body.")
    at: Vector = array_quantity(
        "m",
        "Where the teeth touch, in global coordinates as drawn; it gives the radius of the pinion and the sense.",
    )

    def lower(self, to: Lowering) -> None:
        """Add the relation."""
        turning, sliding = _two_axes(to, self.owner, self.pinion, self.rack)
        v, d = turning.speed(_in_drawing(to, self.owner, self.pinion, self.at)), sliding.direction
        slide, rack = f"{self.rack}.axial", to.instances[self.rack]
        if rack.spec.planar:
            slide = f"{self.rack}.along"
            angle = _start(to, self.rack, 1)[0] + rack.parameters["alpha0"][0]
            d = np.array([np.cos(angle), np.sin(angle), 0.0])
        if np.linalg.norm(np.cross(v, d)) > ALIGNED * np.linalg.norm(v) or np.linalg.norm(v) < 1e-12:
            raise ModelError(
                f"{self.owner}: the pinion does not move along the rack at 'at'; put it on the pitch circle"
            )
        Relation(self.name, {slide: 1.0, f"{self.pinion}.angle": -float(v @ d)}).lower(to)


@part
class Belt(Part[None]):
    """Let a belt or chain that neither slips nor stretches run over two pulleys on parallel axes.

    Notes
    -----
    The relation is ``name.relation``: angle of q minus ratio times angle of p.

    See Also
    --------
    planar_belt : A planar belt that may stretch, with centres that may move.
    """

    name: str = entry("Name of the relation.")
    p: str = entry("The joint of a pulley, as in `gear`.")
    q: str = entry("The joint of the other pulley.")
    _: KW_ONLY
    radius_p: float = quantity("m", "positive", "Radius [] of the pulley on p, or its number of teeth.")
    radius_q: float = quantity("m", "positive", "Radius [] of the pulley on q, or its number of teeth.")
    crossed: bool = entry("Whether the pulleys turn in opposite senses.", default=False)

    def lower(self, to: Lowering) -> None:
        """Add the relation."""
        first, second = _two_axes(to, self.owner, self.p, self.q)
        along = first.direction @ second.direction
        if abs(along) < np.sqrt(1 - ALIGNED**2):
            raise ModelError(
                f"{self.owner}: the axes of '{self.p}' and '{self.q}' are not parallel; turn one, or use m.relation"
            )
        sense = np.sign(along) * (-1 if flag(self.crossed, self.owner, "crossed") else 1)
        ratio = float(sense * (self.radius_p / self.radius_q))
        Relation(self.name, {f"{self.q}.angle": 1.0, f"{self.p}.angle": -ratio}).lower(to)


@part
class CardanChain(Part[None]):
    """Measure the orientation of a body by three angles: a chain of hinges without constraints.

    ``first.angle``, ``second.angle`` and ``third.angle`` are zero as drawn and count turns; they can be
    independent, prescribed, or carry springs.  In space only.

    Notes
    -----
    Where the first and third axes coincide (at a second angle of 90 degrees for perpendicular axes), the
    first and third angles are not determined.
    """

    first: str = entry('Name of the hinge at the base, such as "yaw".')
    second: str = entry('Name of the next hinge, such as "lean".')
    third: str = entry('Name of the hinge at the body, such as "pitch".')
    _: KW_ONLY
    body: Given = entry("The body, as in `revolute`.")
    base: Given = entry("The body from which its orientation is measured.", default=GROUND)
    axes: Any = entry(
        "Axes of the three hinges as drawn: letters of global axes, or directions.",
        default="zxy",
        form="str or three vectors",
    )

    @property
    def owner(self) -> str:
        """The chain, by its hinges."""
        return f"cardan chain '{self.first}', '{self.second}', '{self.third}'"

    def lower(self, to: Lowering) -> None:
        """Add three hinges with two orientations between them."""
        start, end = two_bodies(to, self.owner, self.base, self.body)
        if start.planar:
            raise ModelError(f"{self.owner}: the orientation of a planar body is an angle already; use it")
        if not isinstance(self.axes, (str, Sequence, np.ndarray)) or len(self.axes) != 3:
            raise ModelError(
                f"{self.owner}: axes {self.axes!r:.60} are not three; give letters such as 'zxy' or directions"
            )
        directions = [
            AXES[axis] if isinstance(axis, str) and axis in AXES else unit(axis, self.owner, f"axis {i}")
            for i, axis in enumerate(self.axes, 1)
        ]
        if any(np.linalg.norm(np.cross(a, b)) < ALIGNED for a, b in pairwise(directions)):
            raise ModelError(f"{self.owner}: two successive axes are parallel; turn one")
        names = self.first, self.second, self.third
        between = [Frame(f"{name}_frame", end.frame.x0).lower(to) for name in names[:2]]
        frames = [start.frame, *between, end.frame]
        for name, (p, q), axis in zip(names, pairwise(frames), directions, strict=True):
            Hinge(name, p, q, axis=axis).lower(to)


def _two_axes(to: Lowering, owner: str, p: str, q: str) -> tuple[_Axis, _Axis]:
    """Return two joints as drawn, held by the same body."""
    first, second = (_axis_of(to, owner, joint) for joint in (p, q))
    if p == q:
        raise ModelError(f"{owner}: both its joints are '{p}'; name two different ones")
    if first.holder != second.holder:
        raise ModelError(
            f"{owner}: '{p}' starts at '{first.holder}' and '{q}' at '{second.holder}'; make both with the "
            "housing or carrier as their first body"
        )
    return first, second


def _axis_of(to: Lowering, owner: str, joint: str) -> _Axis:
    """Return a joint with an axis, as drawn."""
    instance = to.instances.get(joint) if isinstance(joint, str) else None
    if instance is None or instance.spec.family != "bearing":
        bearings = [name for name, other in to.instances.items() if other.spec.family == "bearing"]
        similar = near_names(str(joint), bearings)
        hint = (
            f"did you mean {', '.join(similar)}?" if similar else "name one made by m.revolute or m.prismatic"
        )
        raise ModelError(f"{owner}: {joint!r:.60} is not a joint with an axis; {hint}")
    point, frame = _start(to, joint, 0), _start(to, joint, 1)
    axis = np.array([0.0, 0.0, 1.0])
    if instance.spec.planar:
        point = np.append(point, 0.0)
    else:
        axis = matrix(product(frame, instance.parameters["tp"]))[:, 0]
    return _Axis(joint, point, axis, instance.nodes[1])


def _start(to: Lowering, joint: str, node: int) -> Array:
    """Return a node of a joint as drawn."""
    return to.nodes[to.instances[joint].nodes[node]].x0


def _in_drawing(to: Lowering, owner: str, joint: str, at: Vector) -> Array:
    """Return a point in global coordinates (3,), given with as many as the joint has."""
    planar = to.instances[joint].spec.planar
    x = vector(at, owner, "at", 2 if planar else 3)
    return np.append(x, 0.0) if planar else x


def _teeth(owner: str, teeth: Any, drawn: float) -> float:
    """Return the ratio of the numbers of teeth, which must agree with the drawing."""
    if not isinstance(teeth, Sequence) or isinstance(teeth, str) or len(teeth) != 2:
        raise ModelError(f"{owner}: teeth {teeth!r:.60} are not two numbers; give (of p, of q)")
    a, b = (whole(count, owner, "teeth") for count in teeth)
    if abs(a / b - drawn) > TEETH * drawn:
        raise ModelError(
            f"{owner}: {a} and {b} teeth give the ratio {a / b:.6g}, but the drawing {drawn:.6g}; move 'at' or the axes"
        )
    return a / b
