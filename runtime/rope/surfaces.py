"""Surfaces for ropes and points to touch: the methods of `Model` that declare sheaves, drums and planes on bodies.

A surface is geometry on a point and a frame; mass, bearings and motion belong to the body.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.base.arguments import array, new_name, number, positive
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_frame, matrix, triad, unit
from flexel.declare.declarations import Declarations
from flexel.structure.nodes import Node
from flexel.structure.surfaces import Surface


@dataclass(frozen=True)
class RoundGroove:
    """Groove with a round bottom, and straight flanks that continue it.

    Parameters
    ----------
    radius : float
        Radius of the bottom [m], slightly larger than the rope's (0.53 to 0.55 of its diameter, ISO 16625).
    opening : float
        Angle between the flanks [rad], 45 degrees by default.
    """

    radius: float
    opening: float = np.pi / 4


@dataclass(frozen=True, kw_only=True)
class HelicalGroove(RoundGroove):
    """Round groove along a helix on a drum: a rope that winds on it moves sideways by the lead per turn.

    Parameters
    ----------
    lead : float
        Axial distance of two turns [m], negative for a left-handed helix; usually 1.1 to 1.2 rope diameters.
    start : sequence of float (3,), optional
        Direction from the axle, in global axes as drawn, in which the groove crosses the plane through the drum's
        centre; the global axis farthest from the axle by default.
    """

    lead: float
    start: Any = None


@dataclass(frozen=True)
class VGroove:
    """Groove of two straight flanks with an angle [rad] between them."""

    opening: float = np.pi / 3


CYLINDER = (("gap", ("tangential", "axial")),)
ROUND = (("gap", ("tangential", "across")),)
VEE = (("gap1", ("tangential", "across1")), ("gap2", ("tangential", "across2")))
PLANE = (("gap", ("x", "y")),)
PLANAR = (("gap", ("tangential",)),)
STEEP = np.cos(np.radians(25.0))  # x component of the normal of a plane whose axes start from the y axis


class Surfaces(Declarations):
    """Surfaces that ropes and points touch."""

    def sheave(
        self,
        name: str,
        point: Node | str,
        frame: Node | str,
        *,
        radius: float,
        axle: Any = (0.0, 0.0, 1.0),
        groove: RoundGroove | HelicalGroove | VGroove | None = None,
    ) -> Surface:
        """Declare a sheave or drum: a cylinder about an axle through a point of a body, smooth or with a groove.

        Parameters
        ----------
        point, frame : node
            Centre and orientation of the body that carries the surface (an angle in a planar model).
        radius : float
            Radius of the lowest point of a rope or sphere that touches: of the bottom of a round groove; a V is as deep
            as this requires, and touches on both flanks, a little higher [m].
        axle : sequence of float (3,)
            In global axes, as drawn; planar models need none.
        groove : RoundGroove, HelicalGroove or VGroove, optional
            Guides the rope sideways; planar models have none.

        Raises
        ------
        ModelError
            A name that is taken, a radius that is not positive, an opening that is not an angle, a lead of zero.

        Examples
        --------
        >>> m.sheave("sheave", "S", "RS", radius=0.5, groove=fx.RoundGroove(0.0098))  # doctest: +SKIP
        """
        owner = f"sheave '{name}'"
        _new(self, name, owner)
        R = positive(radius, owner, "radius")
        planar, (c, r) = self._find_nodes(owner, (point, "point"), (frame, "frame"))
        values = {"radius": np.array([R])}
        if planar:
            if groove is not None:
                raise ModelError(
                    f"{owner}: a planar model has no sideways motion for a groove to guide; leave it out"
                )
            values |= {"alpha0": np.zeros(1), "offset": np.zeros(2)}
            z = np.array([0.0, 0.0, 1.0])
            return _kept(self, Surface(name, "circle", c.name, r.name, values, R, c.x0, z, PLANAR))
        u = unit(axle, owner, "axle")
        axes = triad(u, groove.start if isinstance(groove, HelicalGroove) else None, owner)
        values |= {"t": in_frame(r.x0, axes), "offset": np.zeros(3)}
        element, gaps, more = _groove(groove, owner)
        across = matrix(axes)[:, 1] if "lead" in more else None
        return _kept(self, Surface(name, element, c.name, r.name, values | more, R, c.x0, u, gaps, across))

    def plane(
        self, name: str, point: Node | str, frame: Node | str, normal: Any = (0.0, 0.0, 1.0)
    ) -> Surface:
        """Declare a plane through a point of a body.

        Sliding in space is measured along x and y: x is the global x axis, as drawn, projected onto the plane (the y
        axis if the normal is within 25° of x); y is at right angles to it, counterclockwise about the normal.

        Parameters
        ----------
        point, frame : node
            A point of the plane, and the orientation of the body.
        normal : sequence of float (3,)
            Towards what touches it, in global axes as drawn; of two numbers in a planar model.

        Raises
        ------
        ModelError
            A name that is taken, a normal without length.
        """
        owner = f"plane '{name}'"
        _new(self, name, owner)
        planar, (c, r) = self._find_nodes(owner, (point, "point"), (frame, "frame"))
        if planar:
            n = unit(np.atleast_1d(array(normal, owner, "normal"))[:2], owner, "normal", 2)
            values = {"alpha0": np.arctan2(-n[0], n[1]) - r.x0, "offset": np.zeros(2)}
            return _kept(self, Surface(name, "line", c.name, r.name, values, 0.0, c.x0, n, PLANAR))
        n = unit(normal, owner, "normal")
        across = np.array([1.0, 0.0, 0.0] if abs(n[0]) < STEEP else [0.0, 1.0, 0.0])
        e_x = unit(across - (across @ n) * n, owner, "direction")
        values = {"t": in_frame(r.x0, triad(e_x, np.cross(n, e_x), owner)), "offset": np.zeros(3)}
        return _kept(self, Surface(name, "plane", c.name, r.name, values, 0.0, c.x0, n, PLANE))


def _groove(groove: Any, owner: str) -> tuple[str, tuple[tuple[str, tuple[str, ...]], ...], dict[str, Array]]:
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
            f"{owner}: the lead of its groove is zero; give the axial distance of two turns, or fx.RoundGroove(…)"
        )
    return "helical_groove", ROUND, flank | {"lead": np.array([lead])}


def _new(model: Declarations, name: str, owner: str) -> None:
    if new_name(name, owner.partition(" ")[0]) in model.surfaces:
        raise ModelError(f"{owner}: this name is taken; choose another")


def _kept(model: Declarations, surface: Surface) -> Surface:
    model.surfaces[surface.name] = surface
    return surface
