"""Cams: a follower rolls or slides on a cam, whose outline is a spline."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import KW_ONLY
from typing import Any

import numpy as np

from flexel.base.arguments import array, span, vector
from flexel.base.arrays import Array, Vector
from flexel.base.errors import ModelError
from flexel.base.meaning import array_quantity, entry
from flexel.base.quaternions import from_matrix, in_body, in_frame, unit
from flexel.generated.table import ELEMENTS
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.part import Part, part
from flexel.parts.rigid_bodies import Given, point_of, two_bodies

PIECES = next(
    parameter.size for parameter in ELEMENTS["roller_cam"].parameters if parameter.name == "control"
)
FEWEST = 6  # equal steps of an outline: the support of a spline of degree five
AT_KNOTS = np.array([1, 26, 66, 26, 1]) / 120  # B-splines of degree five at the knots of their support
BENT_AT_KNOTS = np.array([1, 2, -6, 2, 1]) / 6

Outline = Callable[[float], float] | Vector


@part
class Cam(Part[None]):
    """Keep the centre of a follower's roller on the pitch curve of a cam, or its flat face on the cam.

    Raises
    ------
    ModelError
        An outline of a wrong length, or that is not positive; a roller at the centre; an outline that is not convex,
        which a flat face cannot follow; a face along the axis.

    Notes
    -----
    The deformation ``name.gap`` is rigid: its stress is negative while the cam pushes, and positive where the
    follower would have to be pulled.  It is measured along the radius, or across the face.  If released, it
    can be given the law ``hertz``, and the follower can lift off.
    """

    name: str = entry("Name of the element with the gap.")
    cam: Given = entry("A body, as in `revolute`; joints guide it.")
    follower: Given = entry("The other body.")
    at: Vector = array_quantity(
        "m",
        "Centre of the roller in global coordinates as drawn; the edge itself for a knife-edge follower; any point of "
        "a flat face.",
    )
    outline: Outline = array_quantity(
        "m",
        "Distance [] of the roller's centre from the centre of the cam, a function of the angle in the cam [rad], "
        "measured from `start` about `axis`; or its values at equal steps of a turn from zero: 6, 8, 12, 16, 24 or "
        "48.  A periodic spline of degree five passes through them, or through 48 values of the function.  For a flat "
        "face: its distance from the centre of the cam, over the angle of its normal.",
    )
    _: KW_ONLY
    centre: Vector | None = array_quantity(
        "m",
        "Centre of the cam, in global coordinates as drawn; by default the point of the cam's body.",
        default=None,
    )
    axis: Vector | None = array_quantity(
        "-", "Axis of the cam, in global axes as drawn; not needed in a planar model.", default=None
    )
    start: Vector | None = array_quantity(
        "-",
        "Direction in the cam from which angles are measured, in global axes as drawn; by default from the centre to "
        "the roller, or the normal of the face.",
        default=None,
    )
    face: Vector | None = array_quantity(
        "-",
        "Normal of a flat face as drawn, in global axes, away from the cam; without it there is a roller.",
        default=None,
    )

    def lower(self, to: Lowering) -> None:
        """Add the element between the points of both bodies."""
        bodies = two_bodies(to, self.owner, self.cam, self.follower)
        size = bodies[0].point.x0.size
        x = vector(self.at, self.owner, "at", size)
        centre = (
            bodies[0].point.x0 if self.centre is None else vector(self.centre, self.owner, "centre", size)
        )
        normal = None if self.face is None else unit(self.face, self.owner, "face", size)
        if self.start is not None:
            e = unit(self.start, self.owner, "start", size)
        else:
            e = span(centre, x, self.owner)[0] if normal is None else normal
        control = control_values(self.outline, self.owner)
        p, q = (
            point_of(to, body, place, f"{self.name}_{end}")
            for body, place, end in zip(bodies, (centre, x), "pq", strict=True)
        )
        frames = bodies[0].frame, bodies[1].frame
        if normal is not None:
            _add_flat_cam(to, self, control, (p, q), frames, (e, normal))
        else:
            _add_roller_cam(to, self, control, (p, q), frames[0], e, x - centre)


def _add_roller_cam(
    to: Lowering,
    given: Cam,
    control: Array,
    points: tuple[Node, Node],
    frame: Node,
    e: Array,
    arm: Array,
) -> None:
    """Add a cam under a roller, from the direction of angle zero and the arm from the centre to the roller."""
    values, planar = {"control": control}, e.size == 2
    if planar:
        values["alpha0"] = np.arctan2(e[1], e[0]) - frame.x0
    else:
        T = _axes(given.owner, e, given.axis)
        values["tp"] = in_frame(frame.x0, T)
        arm = in_body(T, arm)[:2]
    if np.linalg.norm(arm) < 1e-9 * np.max(control):
        raise ModelError(
            f"{given.owner}: the roller is drawn on the axis of the cam; move 'at' to the outline"
        )
    kind = "planar_roller_cam" if planar else "roller_cam"
    to.element(given.name, kind, (points[0], frame, points[1]), values)


def _add_flat_cam(
    to: Lowering,
    given: Cam,
    control: Array,
    points: tuple[Node, Node],
    frames: tuple[Node, Node],
    directions: tuple[Array, Array],
) -> None:
    """Add a cam under a flat face, from the directions of angle zero and of the face's normal."""
    owner, values, (e, n), (p, q) = given.owner, {"control": control}, directions, frames
    _check_convex(control, owner)
    if e.size == 2:
        values["alpha0"] = np.arctan2(e[1], e[0]) - p.x0
        values["alphaq0"] = np.arctan2(n[1], n[0]) - q.x0
    else:
        T = _axes(owner, e, given.axis)
        values["tp"] = in_frame(p.x0, T)
        across = np.cross(in_body(T, n), (0.0, 0.0, 1.0))
        if np.linalg.norm(across) < 1e-6:
            raise ModelError(f"{owner}: its face lies across the axis; turn face into the plane of the cam")
        side = unit(np.cross(n, unit(given.axis, owner, "axis")), owner, "face")
        values["tq"] = in_frame(q.x0, from_matrix(np.column_stack([n, side, np.cross(n, side)])))
    kind = "planar_flat_cam" if e.size == 2 else "flat_cam"
    to.element(given.name, kind, (points[0], p, points[1], q), values)


def control_values(outline: Outline, owner: str) -> Array:
    """Return control values of the periodic spline through an outline; a ModelError names the owner."""
    steps = 2 * np.pi / PIECES * np.arange(PIECES)
    if callable(outline):
        r = array([outline(float(angle)) for angle in steps], owner, "outline")
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
    """Raise a ModelError where the radius of curvature of a cam under a flat face, h + h'', is not positive."""
    radius = at_knots(control) + _weighted(control, BENT_AT_KNOTS) * (PIECES / (2 * np.pi)) ** 2
    if np.any(radius <= 0):
        angle = 2 * np.pi / PIECES * int(np.argmin(radius))
        raise ModelError(
            f"{owner}: outline has the radius of curvature {np.min(radius):.3g} m at the angle {angle:.3g}: a flat "
            f"face cannot follow a concave outline; add more than {-np.min(radius):.3g} m, or smooth it"
        )


def at_knots(control: Array) -> Array:
    """Return the radii (48,) of the outline at equal steps of a turn, from its control values."""
    return _weighted(control, AT_KNOTS)


def _weighted(control: Array, weights: Array) -> Array:
    """Return at each knot the sum of the five control values around it, times the weights."""
    return np.asarray(
        sum(weight * np.roll(control, -shift) for shift, weight in zip(range(-2, 3), weights, strict=True))
    )


def _refined(r: Array) -> Array:
    """Return values of the spline through r at all knots; between the given knots they are the coarser spline's."""
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
    """Return the control values of the uniform periodic spline of degree five with values r at its knots."""
    n = r.size
    A = np.zeros((n, n))
    for shift, value in zip(range(-2, 3), AT_KNOTS, strict=True):
        A[np.arange(n), (np.arange(n) + shift) % n] += value
    return np.asarray(np.linalg.solve(A, r))


def _axes(owner: str, e: Array, axis: Any) -> Array:
    """Return a triad whose third axis is the cam's axis, and whose first is the direction of angle zero."""
    if axis is None:
        raise ModelError(f"{owner}: in space it needs an axis; give axis=(x, y, z)")
    ez = unit(axis, owner, "axis")
    ex = unit(e - (e @ ez) * ez, owner, "direction of angle zero, across the axis,")
    return from_matrix(np.column_stack([ex, np.cross(ez, ex), ez]))
