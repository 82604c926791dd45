"""Joints and connections: the methods of `Model` for trusses, hinges, bearings and body points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arguments import array, flag, not_negative, positive, span
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.quaternions import in_body, in_frame, matrix, triad, unit
from flexel.base.transactions import whole_or_nothing
from flexel.declare.leaf_springs import LeafSprings
from flexel.structure.nodes import Node

Vector = Sequence[float] | Array


class Joints(LeafSprings):
    """Joints and connections."""

    @whole_or_nothing
    def truss(
        self,
        name: str,
        p: Node | str,
        q: Node | str,
        *,
        stiffness: float | None = None,
        damping: float = 0.0,
        mass_per_length: float = 0.0,
    ) -> None:
        """Join two points by a bar; rigid unless a stiffness is given.

        Its elongation may be prescribed or independent: a hydraulic cylinder.

        Parameters
        ----------
        p, q : node
            Points at its ends.
        stiffness : float, optional
            EA / length [N/m].
        damping : float
            [N s/m], with a stiffness.
        mass_per_length : float
            [kg/m]
        """
        owner = f"truss '{name}'"
        planar, nodes = self._find_nodes(owner, (p, "point"), (q, "point"))
        k = 0.0 if stiffness is None else positive(stiffness, owner, "stiffness")
        d = not_negative(damping, owner, "damping")
        if stiffness is None and d:
            raise ModelError(
                f"{owner}: damping without stiffness leaves the bar rigid; give a stiffness, or make a dashpot with "
                f"m.spring('{name}.elongation', damping=…)"
            )
        l0 = span(nodes[0].x0, nodes[1].x0, owner)[1]
        rhoA = np.array([not_negative(mass_per_length, owner, "mass_per_length")])
        self._place(name, "planar_truss" if planar else "truss", nodes, {"l0": np.array([l0]), "rhoA": rhoA})
        if stiffness is not None:
            self.spring(f"{name}.elongation", k, d)

    @whole_or_nothing
    def hinge(
        self,
        name: str,
        p: Node | str,
        q: Node | str,
        axis: Vector | None = None,
        *,
        stiffness: float | Sequence[float] | None = None,
        damping: float | Sequence[float] = 0.0,
    ) -> None:
        """Join two orientations by a hinge; the angle is free, zero as drawn.

        Parameters
        ----------
        p, q : node
            Orientations of the two bodies.
        axis : sequence of float (3,)
            Direction of the axis in global axes as drawn; not needed in a planar model.
        stiffness, damping : float or three of them
            Torsional spring [N m/rad] and damper [N m s/rad] on the angle, or on the angle and both bending
            deformations: a flexible hinge.
        """
        owner = f"hinge '{name}'"
        planar, nodes = self._find_nodes(owner, (p, "frame"), (q, "frame"))
        if nodes[0] is nodes[1]:
            raise ModelError(f"{owner}: both its frames are '{nodes[0].name}'; give those of the two bodies")
        if planar:
            self._place(name, "planar_hinge", nodes, {"offset0": nodes[1].x0 - nodes[0].x0})
        else:
            if axis is None:
                raise ModelError(f"{owner}: a spatial hinge needs an axis; give axis=(x, y, z)")
            self._place(name, "hinge", nodes, hinge_triads(nodes[0].x0, nodes[1].x0, axis, owner))
        modes = ("angle",) if planar else ("angle", "bend1", "bend2")
        _joint_springs(self, name, modes, stiffness, damping)

    @whole_or_nothing
    def bearing(
        self,
        name: str,
        p: Node | str,
        rp: Node | str,
        q: Node | str,
        rq: Node | str,
        axis: Vector | None = None,
    ) -> None:
        """Join two bodies by a hinge that also holds the points p and q together, as drawn; the angle is free.

        In space the displacements are measured along and across the axis, in the plane in the axes of the first angle.

        Parameters
        ----------
        p, q : node
            Points of the two bodies.
        rp, rq : node
            Their orientations.
        axis : sequence of float (3,)
            Direction of the axis in global axes as drawn; not needed in a planar model.
        """
        owner = f"bearing '{name}'"
        planar, nodes = self._find_nodes(owner, (p, "point"), (rp, "frame"), (q, "point"), (rq, "frame"))
        d = nodes[2].x0 - nodes[0].x0
        if planar:
            phi_p, phi_q = nodes[1].x0, nodes[3].x0
            values = {"alpha0": np.zeros(1), "d0": in_body(phi_p, d), "offset0": phi_q - phi_p}
            self._place(name, "planar_bearing", nodes, values)
            return
        if axis is None:
            raise ModelError(f"{owner}: a spatial bearing needs an axis; give axis=(x, y, z)")
        t = triad(unit(axis, owner, "axis"), None, owner)
        values = hinge_triads(nodes[1].x0, nodes[3].x0, axis, owner)
        self._place(name, "bearing", nodes, values | {"d0": matrix(t).T @ d})

    def body_point(
        self, name: str, p: Node | str, frame: Node | str, q: Node | str, *, body_axes: bool = False
    ) -> None:
        """Hold the point q at its drawn place in the body (p, frame): SPACAR's PINBODY; massless.

        Parameters
        ----------
        p, frame : node
            A point of the body, and its orientation.
        q : node
            The point that moves with it.
        body_axes : bool
            Measure the displacements (along, across1, across2), where they are released, in the frame's own axes
            instead of along and across the line from p to q.
        """
        if not flag(body_axes, f"body point '{name}'", "body_axes"):
            self.beam(name, p, frame, q, rigid=True)
            return
        planar, nodes = self._find_nodes(f"body point '{name}'", (p, "point"), (frame, "frame"), (q, "point"))
        d, r = nodes[2].x0 - nodes[0].x0, nodes[1].x0
        zero = np.zeros(1)
        if planar:
            values = {"alpha0": zero, "d0": in_body(r, d), "l0": zero, "rhoA": zero, "rhoJ": zero}
        else:
            still = np.array([1.0, 0.0, 0.0, 0.0])
            values = {"tp": still, "d0": in_body(r, d), "l0": zero, "rhoA": zero, "rhoJ": np.zeros(3)}
        self._place(name, "planar_beam3" if planar else "beam3", nodes, values)


def hinge_triads(rp: Array, rq: Array, axis: Any, owner: str) -> dict[str, Array]:
    """Reference triads at both frames of a hinge; its axis is given in global axes as drawn."""
    t = triad(unit(axis, owner, "axis"), None, owner)
    return {"tp": in_frame(rp, t), "tq": in_frame(rq, t)}


def _joint_springs(model: LeafSprings, name: str, modes: Sequence[str], stiffness: Any, damping: Any) -> None:
    owner = f"hinge '{name}'"
    d = np.atleast_1d(array(damping, owner, "damping"))
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
        model.spring(f"{name}.{mode}", float(ki), not_negative(di, owner, f"damping of {mode}"))
