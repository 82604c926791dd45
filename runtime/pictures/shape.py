"""The primitives of a picture: lines that a body carries or that deform, with a section, a force or values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.quaternions import matrix
from flexel.declare.closed_profile import ClosedProfile
from flexel.declare.looks import Look
from flexel.declare.materials import Profile
from flexel.declare.round_sections import Circle, Tube
from flexel.declare.sections import IBeam, Rectangle, Section
from flexel.declare.thin_sections import LBeam, UBeam
from flexel.rope.wire_rope import WireRope
from flexel.structure.instances import Instance
from flexel.structure.state import State
from flexel.structure.structure import Structure

CORNERS = 16  # vertices of a round section


@dataclass(frozen=True)
class Shape:
    """Lines and marks of one part, painted in one style.

    Attributes
    ----------
    style : str
        bar, beam, rope, sheave, tyre, rim, spoke, valve, axle, hinge, spring, damper, spiral, guide, slide, box, mass,
        joint, fixed, sketch, solid, force or load; springs and dampers are two points.
    name : str
        Name of the element or node.
    lines : tuple of ndarray (k, 3)
        Polylines in global axes [m]; a mark is a polyline of one point.
    pose : (origin (3,), axes (3, 3)), optional
        Pose of the body that carries the lines, if they do not deform.
    outline : ndarray (k, 2), optional
        Corners (y, z) of the section that is swept along the lines [m]; thin lines without.
    across : ndarray (2, 3), optional
        Directions of the section's y axis at the ends of the lines; any, if they do not matter.
    force : ndarray (3,), optional
        A force on the point that is the only vertex [N].
    values : mapping of str to ndarray
        Quantities for colouring the line: values at equal steps along it, or one for the whole line.
    surface : (vertices (k, 3), triangles (t, 3)), optional
        A surface that the pose carries, in the body's axes [m].
    colour : str, optional
        Its own colour.
    opacity : float
        From 0 to 1.
    """

    style: str
    name: str
    lines: tuple[Array, ...]
    pose: tuple[Array, Array] | None = None
    outline: Array | None = None
    across: Array | None = None
    force: Array | None = None
    values: Mapping[str, Array] = field(default_factory=dict)
    surface: tuple[Array, Index] | None = None
    colour: str | None = None
    opacity: float = 1.0


UNITS = {
    "tension": "N",
    "bending moment": "N m",
    "strain": "-",
    "bending strain": "-",
}  # of the values used for colouring


def place(state: State, node: str) -> Array:
    """Place (3,) of a point; planar points lie in z = 0."""
    x = state.position(node)
    return np.append(x, 0.0) if x.size == 2 else x


def turned(angle: float) -> Array:
    """Axes (3, 3) rotated about z by a planar node's angle."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def axes_of(state: State, frame: str) -> Array:
    """Axes (3, 3) of a frame or of a planar angle."""
    x = state.position(frame)
    return turned(float(x[0])) if x.size == 1 else matrix(x)


def extent(structure: Structure) -> float:
    """Size of the model as drawn [m]: of the box around points, mass centres and wheels, or of the largest body.

    A model without any size counts as 1 m.
    """
    sizes, gyration = [0.0], 0.0
    for instance in structure.instances:
        z = instance.parameters
        if "c" in z:
            sizes.append(float(np.linalg.norm(z["c"])))
        if "radius" in z:
            sizes.append(2 * float(np.max(z["radius"])))
        if "J" in z and "mass" in z:
            gyration = max(gyration, float(np.sqrt(np.max(z["J"]) / z["mass"][0])))
    places = [np.append(n.x0, 0.0)[:3] for n in structure.nodes if n.kind.endswith("point")]
    if places:
        sizes.append(float(np.max(np.ptp(places, axis=0))))
    return max(sizes) or 3 * gyration or 1.0


def lowest(shape: Shape, up: Array) -> float:
    """The height along `up` of the lowest place of a shape, with the section that is swept along it."""
    low = float(np.min(np.vstack(shape.lines) @ up))
    if shape.outline is None:
        return low
    if shape.across is None:
        return low - float(np.max(np.linalg.norm(shape.outline, axis=1)))
    for line in shape.lines:
        for end, along, y in ((line[0], line[1] - line[0], 0), (line[-1], line[-1] - line[-2], 1)):
            z = np.cross(along / np.linalg.norm(along), shape.across[y])
            low = min(low, float(np.min(end @ up + shape.outline @ np.array([shape.across[y] @ up, z @ up]))))
    return low


def circle(radius: float, corners: int = CORNERS) -> Array:
    """Outline (corners, 2) of a round section."""
    angles = np.arange(corners) * 2 * np.pi / corners
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def rectangle(height: float, width: float) -> Array:
    """Outline (4, 2) of a rectangle, `height` along y."""
    return np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (height / 2, width / 2)


def outline_of(section: Section) -> Array:
    """Outline (k, 2) of a section; a circle of the same area for a user-defined one."""
    if isinstance(section, Rectangle):
        return rectangle(section.height, section.width)
    if isinstance(section, (Circle, Tube, WireRope)):
        return circle(section.diameter / 2)
    if isinstance(section, IBeam):
        h, b, w = section.height / 2, section.width / 2, section.web / 2
        f = h - section.flange
        half = [(h, b), (f, b), (f, w), (-f, w), (-f, b), (-h, b)]
        return np.array(half + [(y, -z) for y, z in reversed(half)])
    if isinstance(section, (UBeam, LBeam, ClosedProfile)):
        return section.outline
    return circle(float(np.sqrt(section.A / np.pi)))


def section_outline(instance: Instance) -> Array | None:
    """Outline of the section that an element is to be shown with, or else of its own, if it has one."""
    if isinstance(instance.look, Look) and instance.look.section is not None:
        return outline_of(instance.look.section)
    return outline_of(instance.profile.section) if isinstance(instance.profile, Profile) else None


def cubic(xi: Array, ends: tuple[Array, Array], slopes: tuple[Array, Array]) -> Array:
    """Points (k, 3) of the cubic through two ends with given slopes d/dxi, at xi (k, 1) from 0 to 1."""
    line = (1 - 3 * xi**2 + 2 * xi**3) * ends[0] + (3 * xi**2 - 2 * xi**3) * ends[1]
    return np.asarray(line + (xi - 2 * xi**2 + xi**3) * slopes[0] + (xi**3 - xi**2) * slopes[1])


def resultant(state: State, instance: Instance, points: Sequence[str]) -> Array:
    """Total force (3,) of an element on some of its points [N]."""
    s = state.structure
    rows = [s.index[z] for z in (*instance.deformations, *instance.slips)]
    stress = state.stresses[rows]
    if not stress.any():  # an open contact
        return np.zeros(3)
    f = -(state.J[rows].T @ stress)
    total = np.sum([f[s.places(n)] for n in points], axis=0)
    return np.append(total, 0.0)[:3]


def zigzag(ends: Array) -> Array:
    """A spring between two points (2, 3) as a line in the plane of both and the vertical, or of x and y."""
    d = ends[1] - ends[0]
    length = float(np.linalg.norm(d))
    across = np.cross(d, (0.0, 0.0, 1.0) if abs(d[2]) < 0.9 * length else (0.0, 1.0, 0.0))
    across /= max(float(np.linalg.norm(across)), 1e-300)
    steps = np.concatenate([[0.0], np.linspace(0.15, 0.85, 12), [1.0]])[:, None]
    sides = np.concatenate([[0.0, 0.0], np.tile([1.0, -1.0], 5), [0.0, 0.0]])[:, None]
    return np.asarray(ends[0] + steps * d + 0.09 * length * sides * across)
