"""Belts and gears in the plane, surfaces to move on, rolling wheels in the plane, rotary inertia."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY
from typing import Any

import numpy as np

from flexel.base.arguments import array, positive, span, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.quaternions import unit
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.bodies import six_entries, symmetric_tensor
from flexel.parts.springs import Spring

PLANAR_ENDS = ("planar_point", "planar_angle", "planar_point", "planar_angle")


@part
class PlanarBelt(Part[None]):
    """Add the straight part of a belt between two pulleys in the plane, unstretched as drawn.

    Raises
    ------
    ModelError
        Pulleys that overlap.

    See Also
    --------
    belt : Pulleys on joints of one body, in the plane and in space.

    Notes
    -----
    The line of centres may turn by less than half a turn from its drawn direction.
    """

    name: str = entry("Name of the element; its deformation is ``name.elongation``.")
    p: Node | str = entry("Centre of the first pulley.")
    angle_p: Node | str = entry("Angle of the first pulley.")
    q: Node | str = entry("Centre of the second pulley.")
    angle_q: Node | str = entry("Angle of the second pulley.")
    _: KW_ONLY
    radius_p: float = quantity(
        "m",
        "any",
        "Radius of the first pulley []: positive if the belt is on the left looking from p to q, negative if on the "
        "right; opposite signs for a crossed belt.",
    )
    radius_q: float = quantity("m", "any", "Radius of the second pulley [], with its sign.")
    stiffness: float | None = quantity(
        "N/m", "positive", "Stiffness, EA over length; without it the belt does not stretch.", default=None
    )
    damping: float = quantity("N s/m", "not negative", "Damping constant [], with a stiffness.", default=0.0)

    def lower(self, to: Lowering) -> None:
        """Add the element and its spring."""
        nodes = _ends(to, self)
        a, b = self.radius_p, self.radius_q
        e, distance = span(nodes[0].x0, nodes[2].x0, self.owner)
        if distance <= abs(a - b):
            raise ModelError(
                f"{self.owner}: the centres are {distance:g} m apart, so radii {a:g} and {b:g} have no common "
                "tangent; move them"
            )
        length = np.sqrt(distance**2 - (a - b) ** 2)
        turn = -np.arctan2(a - b, length)
        zero = length + a * (nodes[1].x0 - turn) - b * (nodes[3].x0 - turn)
        values = {
            "radius_p": np.array([a]),
            "radius_q": np.array([b]),
            "psi0": np.array([np.arctan2(e[1], e[0])]),
            "zero": zero,
        }
        to.element(self.name, "planar_belt", nodes, values)
        if self.stiffness is not None:
            Spring(f"{self.name}.elongation", self.stiffness, self.damping).lower(to)
        elif self.damping:
            raise ModelError(f"{self.owner}: damping has no effect without a stiffness; give one, or drop it")


@part
class PlanarGear(Part[None]):
    """Mesh two gears in the plane, in contact as drawn; their centres may move, as on a planet carrier.

    Raises
    ------
    ModelError
        Radii that are zero or add up to zero.

    See Also
    --------
    gear : Gears on joints of one body, in the plane and in space: spur, bevel, worm.
    """

    name: str = entry("Name of the element; its deformation is ``name.mesh``.")
    p: Node | str = entry("Centre of the first gear.")
    angle_p: Node | str = entry("Angle of the first gear.")
    q: Node | str = entry("Centre of the second gear.")
    angle_q: Node | str = entry("Angle of the second gear.")
    _: KW_ONLY
    radius_p: float = quantity(
        "m",
        "any",
        "Pitch radius [] of the first gear, or number of teeth; negative for an internal gear.",
    )
    radius_q: float = quantity("m", "any", "Pitch radius [] of the second gear, or number of teeth.")

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        nodes = _ends(to, self)
        a, b = self.radius_p, self.radius_q
        if not a or not b or not a + b:
            raise ModelError(
                f"{self.owner}: pitch radii {a:g} and {b:g} do not mesh; give two whose sum is not zero"
            )
        e, _ = span(nodes[0].x0, nodes[2].x0, self.owner)
        together = (a * nodes[1].x0 + b * nodes[3].x0) / (a + b)
        offset = np.arctan2(e[1], e[0]) - together
        values = {"radius_p": np.array([a]), "radius_q": np.array([b]), "offset0": offset}
        to.element(self.name, "planar_gear", nodes, values)


def _ends(to: Lowering, pair: PlanarBelt | PlanarGear) -> list[Node]:
    """Return centres and angles of two pulleys or gears."""
    given = (pair.p, pair.angle_p, pair.q, pair.angle_q)
    return [to.find_of_kind(node, (kind,), pair.owner) for node, kind in zip(given, PLANAR_ENDS, strict=True)]


@part
class Quadric(Part[None]):
    """Keep a point on the surface p(x, y, z) = 0, p of second degree: a plane, sphere, cylinder, cone, paraboloid …

    Notes
    -----
    The deformation ``height`` is the value of the polynomial, which is zero on the surface; near it, the distance
    from the surface times the length of the gradient.

    Examples
    --------
    >>> m.quadric("bowl", "ball", quadratic=np.eye(3), constant=-0.25)  # a sphere of 0.5 m  # doctest: +SKIP
    """

    name: str = entry("Name of the element; its deformation is ``name.height``.")
    point: Node | str = entry(
        "A point drawn off the surface moves onto it when the system is built; a point far off is named in a warning."
    )
    _: KW_ONLY
    quadratic: Any = array_quantity(
        "1/m",
        "Coefficients [] of x², y², z², xy, xz, yz (6,), or a symmetric matrix A (3, 3) for x'A x.",
        default=(0.0,) * 6,
        form="array_like",
    )
    linear: Vector = array_quantity("-", "Coefficients of x, y, z (3,).", default=(0.0,) * 3)
    constant: float = quantity("m", "any", "Constant of the polynomial.", default=0.0)

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        node = to.find_of_kind(self.point, ("point",), self.owner)
        A = array(self.quadratic, self.owner, "quadratic")
        if A.shape == (3, 3):
            S = (A + A.T) / 2
            A = np.array([S[0, 0], S[1, 1], S[2, 2], 2 * S[0, 1], 2 * S[0, 2], 2 * S[1, 2]])
        values = {
            "quadratic": vector(A, self.owner, "quadratic", 6),
            "linear": vector(self.linear, self.owner, "linear", 3),
            "constant": np.array([self.constant]),
        }
        if not np.any(values["quadratic"]) and not np.any(values["linear"]):
            raise ModelError(
                f"{self.owner}: all its coefficients are zero, which defines no surface; give quadratic or linear ones"
            )
        to.element(self.name, "surface", [node], values)


@part
class PlanarWheel(Part[None]):
    """Roll an upright wheel on the plane of a planar model; with `spin` fixed, a skate that is dragged along.

    See Also
    --------
    skate : A knife edge without a spin.
    """

    name: str = entry("Name of the element; its slips are ``name.longitudinal`` and ``name.lateral``.")
    point: Node | str = entry("Centre of the wheel.")
    heading: Node | str = entry("Angle of the wheel about the normal of the plane.")
    spin: Node | str = entry("Angle of the wheel about its axle.")
    _: KW_ONLY
    radius: float = quantity(
        "m", "positive", "Radius of the wheel; a skate whose slip ``longitudinal`` is released may have any."
    )
    direction: Sequence[float] | Array = array_quantity(
        "-", "Direction of travel (2,) as drawn.", default=(1.0, 0.0)
    )

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        given = (self.point, "planar_point"), (self.heading, "planar_angle"), (self.spin, "planar_angle")
        nodes = [to.find_of_kind(node, (kind,), self.owner) for node, kind in given]
        t = unit(self.direction, self.owner, "direction", 2)
        alpha0 = np.arctan2(t[1], t[0]) - nodes[1].x0
        to.element(self.name, "planar_wheel", nodes, {"radius": np.array([self.radius]), "alpha0": alpha0})


@part
class RotaryInertia(Part[None]):
    """Give an orientation node a rotary inertia without mass, or a warping node its inertia."""

    name: str = entry("Name of the element.")
    frame: Node | str = entry("Orientation node, or warping node.")
    inertia: Any = array_quantity(
        "kg m²",
        "Inertia in body axes []: three principal moments, (xx, yy, zz, xy, xz, yz) as tensor components or a "
        "symmetric (3, 3), which need not be the inertia of a real body; one number in a planar model.  For a warping "
        "node, one number in kg m⁴: "
        "density times warping constant times the length that it represents.",
        form="array_like",
    )

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        owner = self.owner
        node = to.find_of_kind(self.frame, ("frame", "planar_angle", "warping"), owner)
        if node.kind != "frame":
            J = np.array([positive(self.inertia, owner, "inertia")])
            kind = "warping_inertia" if node.kind == "warping" else "planar_rotary_inertia"
            to.element(self.name, kind, [node], {"J": J})
            return
        J = symmetric_tensor(self.inertia, owner)
        if np.linalg.eigvalsh(J)[0] < -1e-12 * np.max(np.abs(J)):
            raise ModelError(f"{owner}: a principal moment of {J.tolist()} is negative; check the signs")
        to.element(self.name, "rotary_inertia", [node], {"J": six_entries(J)})
