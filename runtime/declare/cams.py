"""Cams: the method of `Model` that lets a follower roll or slide on a cam, whose outline is a spline."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from flexel.base.arguments import array, span, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.quaternions import from_matrix, in_body, in_frame, unit
from flexel.base.transactions import whole_or_nothing
from flexel.declare.rigid_bodies import Given, RigidBodies
from flexel.generated.table import ELEMENTS
from flexel.structure.nodes import Node

PIECES = next(z.size for z in ELEMENTS["roller_cam"].parameters if z.name == "control")
FEWEST = 6  # equal steps of an outline: the support of a spline of degree five
AT_KNOTS = np.array([1, 26, 66, 26, 1]) / 120  # B-splines of degree five at the knots of their support
SLOPE_AT_KNOTS = np.array([-1, -10, 0, 10, 1]) / 24  # their derivatives by the number of the knot
BENT_AT_KNOTS = np.array([1, 2, -6, 2, 1]) / 6

Outline = Callable[[float], float] | Vector


class Cams(RigidBodies):
    """Cams."""

    @whole_or_nothing
    def cam(
        self,
        name: str,
        cam: Given,
        follower: Given,
        at: Vector,
        outline: Outline,
        *,
        centre: Vector | None = None,
        axis: Vector | None = None,
        start: Vector | None = None,
        face: Vector | None = None,
    ) -> None:
        """Keep the centre of a follower's roller on the pitch curve of a cam, or its flat face on the cam.

        Parameters
        ----------
        cam, follower : str, RigidBody or pair of nodes
            Bodies, as in `revolute`; joints guide them.
        at : sequence of float (3,) or (2,)
            Centre of the roller in global coordinates as drawn; the edge itself for a knife-edge follower; any point
            of a flat face.
        outline : callable(angle) -> radius, or sequence of float
            Distance of the roller's centre from the centre of the cam [m], over the angle in the cam [rad], counted
            from `start` about `axis`; or its values at equal steps of a turn, from zero on: 6, 8, 12, 16, 24 or 48.
            A periodic spline of degree five passes through them, or through 48 values of the function.  For a flat
            face: its distance from the centre of the cam, over the angle of its normal.
        centre : sequence of float, optional
            Of the cam, in global coordinates as drawn; by default the point of the cam's body.
        axis : sequence of float (3,)
            Of the cam, in global axes as drawn; not needed in a planar model.
        start : sequence of float, optional
            Direction in the cam from which angles are counted, in global axes as drawn; by default from the centre to
            the roller, or the normal of the face.
        face : sequence of float, optional
            Normal of a flat face as drawn, in global axes, away from the cam; without it there is a roller.

        Raises
        ------
        ModelError
            An outline of other length, or that is not positive; a roller at the centre; an outline that is not convex,
            which a flat face cannot follow; a face along the axis.

        Notes
        -----
        The deformation ``name.gap`` is rigid: its stress is negative while the cam pushes, and positive where the
        follower would have to be pulled.  It is measured along the radius, or across the face.  Released, it takes the
        law ``hertz``, and the follower can lift off.
        """
        owner = f"cam '{name}'"
        bodies = self._two_bodies(owner, cam, follower)
        size = bodies[0].point.x0.size
        x = vector(at, owner, "at", size)
        c = bodies[0].point.x0 if centre is None else vector(centre, owner, "centre", size)
        n = None if face is None else unit(face, owner, "face", size)
        if start is not None:
            e = unit(start, owner, "start", size)
        else:
            e = span(c, x, owner)[0] if n is None else n
        values = {"control": control_values(outline, owner)}
        points = [
            self._point_of(z, y, f"{name}_{end}") for z, y, end in zip(bodies, (c, x), "pq", strict=True)
        ]
        frame = bodies[0].frame
        if n is not None:
            self._flat_cam(name, points, (frame, bodies[1].frame), values, (e, n), axis)
            return
        if size == 2:
            values["alpha0"] = np.arctan2(e[1], e[0]) - frame.x0
            arm = x - c
        else:
            T = _axes(owner, e, axis)
            values["tp"] = in_frame(frame.x0, T)
            arm = in_body(T, x - c)[:2]
        if np.linalg.norm(arm) < 1e-9 * np.max(values["control"]):
            raise ModelError(f"{owner}: the roller is drawn on the axis of the cam; move 'at' to the outline")
        self._place(
            name, "roller_cam" if size == 3 else "planar_roller_cam", (points[0], frame, points[1]), values
        )

    def _flat_cam(
        self,
        name: str,
        points: list[Node],
        frames: tuple[Node, Node],
        values: dict[str, Any],
        directions: tuple[Array, Array],
        axis: Vector | None,
    ) -> None:
        """A cam under a flat face, from the directions of angle zero and of the face's normal."""
        owner, (e, n), (p, q) = f"cam '{name}'", directions, frames
        _check_convex(values["control"], owner)
        if e.size == 2:
            values["alpha0"] = np.arctan2(e[1], e[0]) - p.x0
            values["alphaq0"] = np.arctan2(n[1], n[0]) - q.x0
        else:
            T = _axes(owner, e, axis)
            values["tp"] = in_frame(p.x0, T)
            across = np.cross(in_body(T, n), (0.0, 0.0, 1.0))
            if np.linalg.norm(across) < 1e-6:
                raise ModelError(
                    f"{owner}: its face lies across the axis; turn face into the plane of the cam"
                )
            side = unit(np.cross(n, unit(axis, owner, "axis")), owner, "face")
            values["tq"] = in_frame(q.x0, from_matrix(np.column_stack([n, side, np.cross(n, side)])))
        kind = "planar_flat_cam" if e.size == 2 else "flat_cam"
        self._place(name, kind, (points[0], p, points[1], q), values)


def control_values(outline: Outline, owner: str) -> Array:
    """Control values of the periodic spline through an outline; a ModelError names the owner."""
    steps = 2 * np.pi / PIECES * np.arange(PIECES)
    if callable(outline):
        r = array([outline(float(z)) for z in steps], owner, "outline")
    else:
        r = array(outline, owner, "outline")
    if r.ndim != 1 or r.size < FEWEST or PIECES % r.size:
        raise ModelError(
            f"{owner}: outline has shape {r.shape}; give 6, 8, 12, 16, 24 or {PIECES} radii, or a function"
        )
    if np.any(r <= 0):
        raise ModelError(f"{owner}: outline has the radius {np.min(r):g}; give positive ones")
    return _through(_refined(r))


def _check_convex(control: Array, owner: str) -> None:
    """A ModelError where the radius of curvature of a cam under a flat face, h + h'', is not positive."""
    radius = at_knots(control) + _weighted(control, BENT_AT_KNOTS) * (PIECES / (2 * np.pi)) ** 2
    if np.any(radius <= 0):
        angle = 2 * np.pi / PIECES * int(np.argmin(radius))
        raise ModelError(
            f"{owner}: outline has the radius of curvature {np.min(radius):.3g} m at the angle {angle:.3g}: a flat "
            f"face cannot follow what is not convex; add more than {-np.min(radius):.3g} m, or smooth it"
        )


def at_knots(control: Array) -> Array:
    """Radii (48,) of the outline at equal steps of a turn, from its control values."""
    return _weighted(control, AT_KNOTS)


def slope_at_knots(control: Array) -> Array:
    """Derivatives (48,) of the outline by the angle, at equal steps of a turn."""
    return _weighted(control, SLOPE_AT_KNOTS) * PIECES / (2 * np.pi)


def _weighted(control: Array, weights: Array) -> Array:
    """At each knot the sum of the five control values about it, times the weights."""
    return np.asarray(sum(w * np.roll(control, -z) for z, w in zip(range(-2, 3), weights, strict=True)))


def _refined(r: Array) -> Array:
    """Values of the spline through r at all knots: those of the coarser spline between the given ones."""
    from scipy.interpolate import BSpline

    n = r.size
    if n == PIECES:
        return r
    control = _through(r)
    knots = np.arange(-5.0, n + 6.0)
    return np.asarray(
        BSpline(knots, np.take(control, np.arange(n + 5) - 2, mode="wrap"), 5)(np.arange(PIECES) * n / PIECES)
    )


def _through(r: Array) -> Array:
    """Control values of the uniform periodic spline of degree five with values r at its knots."""
    n = r.size
    A = np.zeros((n, n))
    for shift, value in zip(range(-2, 3), AT_KNOTS, strict=True):
        A[np.arange(n), (np.arange(n) + shift) % n] += value
    return np.asarray(np.linalg.solve(A, r))


def _axes(owner: str, e: Array, axis: Any) -> Array:
    """Triad whose third axis is that of the cam, and whose first is the direction of angle zero."""
    if axis is None:
        raise ModelError(f"{owner}: in space it needs an axis; give axis=(x, y, z)")
    ez = unit(axis, owner, "axis")
    ex = unit(e - (e @ ez) * ez, owner, "direction of angle zero, across the axis,")
    return from_matrix(np.column_stack([ex, np.cross(ez, ex), ez]))
