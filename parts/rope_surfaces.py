"""Surfaces for ropes and points to touch: sheaves, drums and planes on bodies.

A surface is geometry on a point and a frame; mass, bearings and motion belong to the body.
"""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import array, new_name, number, positive
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, described, entry, in_unit, quantity
from flexel.base.quaternions import in_frame, matrix, triad, unit
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.model.surfaces import Surface


@described
class RoundGroove:
    """Groove with a round bottom, and straight flanks that continue it.

    Parameters
    ----------
    radius : float
        Radius of the bottom [m], slightly larger than the rope's (0.53 to 0.55 of its diameter, ISO 16625).
    opening : float
        Angle between the flanks [rad], 45 degrees by default.
    """

    radius: float = in_unit("m")
    opening: float = in_unit("rad", default=np.pi / 4)


@dataclass(frozen=True, kw_only=True)
class HelicalGroove(RoundGroove):
    """Round groove along a helix on a drum: a rope that winds on it moves sideways by the lead per turn.

    Parameters
    ----------
    lead : float
        Axial distance between turns [m], negative for a left-handed helix; usually 1.1 to 1.2 rope diameters.
    start : sequence of float (3,), optional
        Direction from the axle, in global axes as drawn, in which the groove crosses the plane through the drum's
        centre; the global axis farthest from the axle by default.
    """

    lead: float = in_unit("m")
    start: Any = in_unit("-", default=None)


@described
class VGroove:
    """Groove of two straight flanks with an angle [rad] between them."""

    opening: float = in_unit("rad", default=np.pi / 3)


Gaps = tuple[tuple[str, tuple[str, ...]], ...]  # as in Surface
CYLINDER: Gaps = (("gap", ("tangential", "axial")),)
ROUND: Gaps = (("gap", ("tangential", "across")),)
VEE: Gaps = (("gap1", ("tangential", "across1")), ("gap2", ("tangential", "across2")))
PLANE: Gaps = (("gap", ("x", "y")),)
PLANAR: Gaps = (("gap", ("tangential",)),)
STEEP = np.cos(np.radians(25.0))  # x component of the normal of a plane whose axes start from the y axis


@part
class Sheave(Part[Surface]):
    """Declare a sheave or drum: a cylinder about an axle through a point of a body, smooth or with a groove.

    Raises
    ------
    ModelError
        A name that is taken, a radius that is not positive, an opening that is not an angle, a lead of zero.

    Examples
    --------
    >>> m.sheave("sheave", "S", "RS", radius=0.5, groove=fx.RoundGroove(0.0098))  # doctest: +SKIP
    """

    name: str = entry("Name of the surface.")
    point: Node | str = entry("Centre of the surface: a point of the body that carries it.")
    frame: Node | str = entry("Orientation of the body (an angle in a planar model).")
    _: KW_ONLY
    radius: float = quantity(
        "m",
        "positive",
        "Radius [] at the lowest point of a rope or sphere in contact: that of the bottom of a round groove; a V is as "
        "deep as this requires, and touches on both flanks, slightly higher.",
    )
    axle: Vector = array_quantity(
        "-",
        "Direction of the axle in global axes, as drawn; planar models need none.",
        default=(0.0, 0.0, 1.0),
    )
    groove: RoundGroove | HelicalGroove | VGroove | None = entry(
        "Guides the rope sideways; planar models have none.", default=None
    )

    def lower(self, to: Lowering) -> Surface:
        """Register the surface."""
        _check_new(to, self.name, self.owner)
        planar, (centre, body) = to.find_nodes(self.owner, (self.point, "point"), (self.frame, "frame"))
        across = None
        if planar:
            if self.groove is not None:
                raise ModelError(
                    f"{self.owner}: a planar model has no sideways motion for a groove to guide; leave it out"
                )
            element, gaps, axle = "circle", PLANAR, np.array([0.0, 0.0, 1.0])
            values = {"alpha0": np.zeros(1), "offset": np.zeros(2)}
        else:
            axle = unit(self.axle, self.owner, "axle")
            start = self.groove.start if isinstance(self.groove, HelicalGroove) else None
            axes = triad(axle, start, self.owner)
            element, gaps, more = _groove(self.groove, self.owner)
            values = {"t": in_frame(body.x0, axes), "offset": np.zeros(3)} | more
            across = matrix(axes)[:, 1] if "lead" in more else None
        values = {"radius": np.array([self.radius])} | values
        at = centre.name, body.name
        return _added(
            to, Surface(self.name, element, *at, values, self.radius, centre.x0, axle, gaps, across)
        )


@part
class Plane(Part[Surface]):
    """Declare a plane through a point of a body.

    Sliding in space is measured along x and y: x is the global x axis, as drawn, projected onto the plane (the y
    axis if the normal is within 25° of x); y is at right angles to it, counterclockwise about the normal.

    Raises
    ------
    ModelError
        A name that is taken, a normal without length.
    """

    name: str = entry("Name of the surface.")
    point: Node | str = entry("A point of the plane.")
    frame: Node | str = entry("Orientation of the body.")
    normal: Vector = array_quantity(
        "-",
        "Normal, towards the side of contact, in global axes as drawn: (x, y, z), or (x, y) in a planar model.",
        default=(0.0, 0.0, 1.0),
    )

    def lower(self, to: Lowering) -> Surface:
        """Register the surface."""
        _check_new(to, self.name, self.owner)
        planar, (point, body) = to.find_nodes(self.owner, (self.point, "point"), (self.frame, "frame"))
        at = point.name, body.name
        if planar:
            n = unit(np.atleast_1d(array(self.normal, self.owner, "normal"))[:2], self.owner, "normal", 2)
            values = {"alpha0": np.arctan2(-n[0], n[1]) - body.x0, "offset": np.zeros(2)}
            return _added(to, Surface(self.name, "line", *at, values, 0.0, point.x0, n, PLANAR))
        n = unit(self.normal, self.owner, "normal")
        across = np.array([1.0, 0.0, 0.0] if abs(n[0]) < STEEP else [0.0, 1.0, 0.0])
        e_x = unit(across - (across @ n) * n, self.owner, "direction")
        t = in_frame(body.x0, triad(e_x, np.cross(n, e_x), self.owner))
        values = {"t": t, "offset": np.zeros(3)}
        return _added(to, Surface(self.name, "plane", *at, values, 0.0, point.x0, n, PLANE))


def _groove(groove: Any, owner: str) -> tuple[str, Gaps, dict[str, Array]]:
    if groove is None:
        return "cylinder", CYLINDER, {}
    if not isinstance(groove, (RoundGroove, VGroove)):
        raise ModelError(
            f"{owner}: groove {groove!r} is unknown; give fx.RoundGroove(…), "
            "fx.HelicalGroove(…) or fx.VGroove(…)"
        )
    opening = number(groove.opening, owner, "opening")
    if not 0 < opening < np.pi:
        raise ModelError(
            f"{owner}: opening {opening:g} rad is not between 0 and π; give the angle between the flanks"
        )
    flank = {"flank": np.array([np.sin(opening / 2), np.cos(opening / 2)])}
    if isinstance(groove, VGroove):
        return "v_groove", VEE, flank
    flank["groove_radius"] = np.array([positive(groove.radius, owner, "groove radius")])
    if not isinstance(groove, HelicalGroove):
        return "round_groove", ROUND, flank
    lead = number(groove.lead, owner, "lead")
    if lead == 0:
        raise ModelError(
            f"{owner}: the lead of its groove is zero; give the axial distance between turns, or fx.RoundGroove(…)"
        )
    return "helical_groove", ROUND, flank | {"lead": np.array([lead])}


def _check_new(to: Lowering, name: str, owner: str) -> None:
    if new_name(name, owner.partition(" ")[0]) in to.surfaces:
        raise ModelError(f"{owner}: this name is taken; choose another")


def _added(to: Lowering, surface: Surface) -> Surface:
    to.surfaces[surface.name] = surface
    return surface
