"""Joints and connections: trusses, hinges, bearings and body points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY
from typing import Any

import numpy as np

from flexel.base.arguments import array, flag, not_negative, positive, span
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry, quantity
from flexel.base.quaternions import in_body, in_frame, matrix, triad, unit
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.beams import Beam
from flexel.parts.springs import Spring


@part
class Truss(Part[None]):
    """Join two points by a bar; rigid unless a stiffness is given.

    Its elongation may be prescribed or independent: a hydraulic cylinder.
    """

    name: str = entry("Name of the element; its deformation is ``name.elongation``.")
    p: Node | str = entry("Point at its first end.")
    q: Node | str = entry("Point at its second end.")
    _: KW_ONLY
    stiffness: float | None = quantity("N/m", "positive", "Stiffness, EA over length.", default=None)
    damping: float = quantity("N s/m", "not negative", "Damping constant [], with a stiffness.", default=0.0)
    mass_per_length: float = quantity("kg/m", "not negative", "Mass per length.", default=0.0)

    def lower(self, to: Lowering) -> None:
        """Add the element and its spring."""
        planar, nodes = to.find_nodes(self.owner, (self.p, "point"), (self.q, "point"))
        if self.stiffness is None and self.damping:
            raise ModelError(
                f"{self.owner}: damping without stiffness leaves the bar rigid; give a stiffness, or make a dashpot "
                f"with m.spring('{self.name}.elongation', damping=…)"
            )
        l0 = span(nodes[0].x0, nodes[1].x0, self.owner)[1]
        values = {"l0": np.array([l0]), "rhoA": np.array([self.mass_per_length])}
        to.element(self.name, "planar_truss" if planar else "truss", nodes, values)
        if self.stiffness is not None:
            Spring(f"{self.name}.elongation", self.stiffness, self.damping).lower(to)


@part
class Hinge(Part[None]):
    """Join two orientations by a hinge; the angle is free, zero as drawn."""

    name: str = entry(
        "Name of the element; its deformations are ``name.angle``, ``name.bend1`` and ``name.bend2``; in a plane "
        "``name.angle``."
    )
    p: Node | str = entry("Orientation of the first body.")
    q: Node | str = entry("Orientation of the second body.")
    axis: Vector | None = array_quantity(
        "-", "Direction of the axis in global axes as drawn; not needed in a planar model.", default=None
    )
    _: KW_ONLY
    stiffness: float | Sequence[float] | None = array_quantity(
        "N m/rad",
        "Torsional spring on the angle; or three, on the angle and both bending deformations: a flexible hinge.",
        default=None,
    )
    damping: float | Sequence[float] = array_quantity(
        "N m s/rad", "Damper on the angle; or three, as for the stiffness.", default=0.0
    )

    def lower(self, to: Lowering) -> None:
        """Add the element and its springs."""
        planar, nodes = to.find_nodes(self.owner, (self.p, "frame"), (self.q, "frame"))
        if nodes[0] is nodes[1]:
            raise ModelError(
                f"{self.owner}: both its frames are '{nodes[0].name}'; give the frames of the two bodies"
            )
        if planar:
            to.element(self.name, "planar_hinge", nodes, {"offset0": nodes[1].x0 - nodes[0].x0})
        else:
            if self.axis is None:
                raise ModelError(f"{self.owner}: a spatial hinge needs an axis; give axis=(x, y, z)")
            values = hinge_triads(nodes[0].x0, nodes[1].x0, self.axis, self.owner)
            to.element(self.name, "hinge", nodes, values)
        _add_springs(to, self, ("angle",) if planar else ("angle", "bend1", "bend2"))


def _add_springs(to: Lowering, hinge: Hinge, modes: Sequence[str]) -> None:
    """Add the springs and dampers of a hinge: on its angle, or on all of its deformations."""
    owner, stiffness = hinge.owner, hinge.stiffness
    d = np.atleast_1d(array(hinge.damping, owner, "damping"))
    if stiffness is None and not np.any(d):
        return
    k = np.zeros(d.shape) if stiffness is None else np.atleast_1d(array(stiffness, owner, "stiffness"))
    if k.shape not in ((1,), (len(modes),)):
        raise ModelError(
            f"{owner}: stiffness and damping take one number or {len(modes)}, for {', '.join(modes)}; "
            f"{k.size} given"
        )
    if d.shape not in ((1,), k.shape):
        raise ModelError(
            f"{owner}: {d.size} numbers for damping and {k.size} for stiffness; give equally many"
        )
    for mode, ki, di in zip(modes, k, np.broadcast_to(d, k.shape), strict=False):
        if stiffness is not None:
            positive(ki, owner, f"stiffness of {mode}")
        damping = not_negative(di, owner, f"damping of {mode}")
        Spring(f"{hinge.name}.{mode}", float(ki), damping).lower(to)


@part
class Bearing(Part[None]):
    """Join two bodies by a hinge that also holds the points p and q together, as drawn; the angle is free.

    In space the displacements are measured along and across the axis, in the plane in the axes of the first angle.
    """

    name: str = entry(
        "Name of the element; its deformations are ``name.angle``, ``name.bend1``, ``name.bend2``, ``name.axial``, "
        "``name.radial1`` and ``name.radial2``; in a plane ``name.along``, ``name.across`` and ``name.angle``."
    )
    p: Node | str = entry("Point of the first body.")
    rp: Node | str = entry("Orientation of the first body.")
    q: Node | str = entry("Point of the second body.")
    rq: Node | str = entry("Orientation of the second body.")
    axis: Vector | None = array_quantity(
        "-", "Direction of the axis in global axes as drawn; not needed in a planar model.", default=None
    )

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        ends = (self.p, "point"), (self.rp, "frame"), (self.q, "point"), (self.rq, "frame")
        planar, nodes = to.find_nodes(self.owner, *ends)
        d = nodes[2].x0 - nodes[0].x0
        if planar:
            phi_p, phi_q = nodes[1].x0, nodes[3].x0
            values = {"alpha0": np.zeros(1), "d0": in_body(phi_p, d), "offset0": phi_q - phi_p}
            to.element(self.name, "planar_bearing", nodes, values)
            return
        if self.axis is None:
            raise ModelError(f"{self.owner}: a spatial bearing needs an axis; give axis=(x, y, z)")
        t = triad(unit(self.axis, self.owner, "axis"), None, self.owner)
        values = hinge_triads(nodes[1].x0, nodes[3].x0, self.axis, self.owner)
        to.element(self.name, "bearing", nodes, values | {"d0": matrix(t).T @ d})


def hinge_triads(rp: Array, rq: Array, axis: Any, owner: str) -> dict[str, Array]:
    """Return the reference triads at both frames of a hinge; its axis is given in global axes as drawn."""
    t = triad(unit(axis, owner, "axis"), None, owner)
    return {"tp": in_frame(rp, t), "tq": in_frame(rq, t)}


@part
class BodyPoint(Part[None]):
    """Hold the point q at its drawn position in the body (p, frame): SPACAR's PINBODY; massless."""

    name: str = entry(
        "Name of the element; its deformations are ``name.along``, ``name.across1`` and ``name.across2``; in a plane "
        "``name.along`` and ``name.across``."
    )
    p: Node | str = entry("A point of the body.")
    frame: Node | str = entry("Orientation of the body.")
    q: Node | str = entry("The point that moves with it.")
    _: KW_ONLY
    body_axes: bool = entry(
        "Measure the displacements (along, across1, across2), where they are released, in the frame's axes instead "
        "of along and across the line from p to q.",
        default=False,
    )

    def lower(self, to: Lowering) -> None:
        """Add the element."""
        if not flag(self.body_axes, self.owner, "body_axes"):
            Beam(self.name, self.p, self.frame, self.q, rigid=True).lower(to)
            return
        ends = (self.p, "point"), (self.frame, "frame"), (self.q, "point")
        planar, nodes = to.find_nodes(self.owner, *ends)
        d, r = nodes[2].x0 - nodes[0].x0, nodes[1].x0
        zero = np.zeros(1)
        if planar:
            values = {"alpha0": zero, "d0": in_body(r, d), "l0": zero, "rhoA": zero, "rhoJ": zero}
        else:
            still = np.array([1.0, 0.0, 0.0, 0.0])
            values = {"tp": still, "d0": in_body(r, d), "l0": zero, "rhoA": zero, "rhoJ": np.zeros(3)}
        to.element(self.name, "planar_beam3" if planar else "beam3", nodes, values)
