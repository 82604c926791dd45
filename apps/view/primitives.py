"""The primitives of a picture: lines carried by a body or deforming, with a section, a force or values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.model.instances import Instance
from flexel.model.profiles import Section
from flexel.model.structure import Structure
from flexel.parts.closed_profile import ClosedProfile
from flexel.parts.looks import Look
from flexel.parts.materials import Profile
from flexel.parts.round_sections import Circle, Tube
from flexel.parts.sections import IBeam, Rectangle
from flexel.parts.thin_sections import LBeam, UBeam
from flexel.parts.wire_rope import WireRope

CORNERS = 16  # vertices of a round section


@dataclass(frozen=True)
class Shape:
    """Lines and marks of one part, painted in one style, in one state or in several.

    In several states, every array but `outline` and `surface` has them along its first axis: (..., k, 3) is (k, 3) for
    one state, and (states, k, 3) for several.

    Attributes
    ----------
    style : str
        bar, beam, rope, sheave, tyre, rim, spoke, valve, axle, hinge, spring, damper, spiral, guide, slide, box, mass,
        joint, fixed, sketch, solid, force or load; springs and dampers are two points.
    name : str
        Name of the element or node.
    lines : tuple of ndarray (..., k, 3)
        Polylines in global axes [m]; a mark is a polyline of one point.
    pose : (origin (..., 3), axes (..., 3, 3)), optional
        Pose of the body that carries the lines, if they do not deform.
    outline : ndarray (k, 2), optional
        Corners (y, z) of the section that is swept along the lines [m]; thin lines without.
    across : ndarray (..., 2, 3), optional
        Directions of the section's y axis at the ends of the lines; any, if they do not matter.
    force : ndarray (..., 3), optional
        A force on the point that is the only vertex [N].
    values : mapping of str to ndarray
        Quantities (..., k) for colouring the line: values at equal steps along it, or one for the whole line.
    surface : (vertices (k, 3), triangles (t, 3)), optional
        A surface that the pose carries, in the body's axes [m].
    colour : str, optional
        Its own colour.
    opacity : float
        From 0 to 1.
    aside : bool
        Shown in the viewer only on request: points within a rope or a row of flexible beams, and boxes of inertia
        of bodies that have a shape by other parts.
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
    aside: bool = False


UNITS = {
    "tension": "N",
    "bending moment": "N m",
    "normal stress": "Pa",
    "strain": "-",
    "bending strain": "-",
}  # of the values used for colouring


def extent(structure: Structure) -> float:
    """Return the size of the drawn model [m]: of the box around points, mass centres and wheels, or the largest body.

    The size of a model without extent is 1 m.
    """
    sizes, gyration = [0.0], 0.0
    for instance in structure.instances:
        parameters = instance.parameters
        if "c" in parameters:
            sizes.append(float(np.linalg.norm(parameters["c"])))
        if "radius" in parameters:
            sizes.append(2 * float(np.max(parameters["radius"])))
        if "J" in parameters and "mass" in parameters:
            gyration = max(gyration, float(np.sqrt(np.max(parameters["J"]) / parameters["mass"][0])))
    places = [np.append(n.x0, 0.0)[:3] for n in structure.nodes if n.kind.endswith("point")]
    if places:
        sizes.append(float(np.max(np.ptp(places, axis=0))))
    return max(sizes) or 3 * gyration or 1.0


def lowest(shape: Shape, up: Array) -> float:
    """Return the height along `up` of the lowest point of a shape, with the section that is swept along it."""
    low = min(float(np.min(line @ up)) for line in shape.lines)
    if shape.outline is None:
        return low
    if shape.across is None:
        return low - float(np.max(np.linalg.norm(shape.outline, axis=1)))
    for line in shape.lines:
        for i, along in ((0, line[..., 1, :] - line[..., 0, :]), (-1, line[..., -1, :] - line[..., -2, :])):
            side = shape.across[..., i, :]
            across = np.cross(along / np.linalg.norm(along, axis=-1, keepdims=True), side)
            corners = np.stack([side @ up, across @ up], axis=-1) @ shape.outline.T
            low = min(low, float(np.min((line[..., i, :] @ up)[..., None] + corners)))
    return low


def edges(part: Shape) -> Iterator[Array]:
    """Yield the edges of the section that is swept along a part in one state, and its outlines at both ends."""
    if part.outline is None or part.across is None:
        return
    for line in part.lines:
        along = np.gradient(line, axis=0)
        share = np.linspace(0, 1, len(line))[:, None]
        z = np.cross(along, (1 - share) * part.across[0] + share * part.across[1])
        z /= np.linalg.norm(z, axis=1, keepdims=True)
        y = np.cross(z, along) / np.linalg.norm(along, axis=1, keepdims=True)
        swept = [line + a * y + b * z for a, b in part.outline]
        yield from swept
        for end in (0, -1):
            yield np.array([edge[end] for edge in (*swept, swept[0])])


def circle(radius: float, corners: int = CORNERS) -> Array:
    """Return the outline (corners, 2) of a round section."""
    angles = np.arange(corners) * 2 * np.pi / corners
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def rectangle(height: float, width: float) -> Array:
    """Return the outline (4, 2) of a rectangle, `height` along y."""
    return np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (height / 2, width / 2)


def outline_of(section: Section) -> Array:
    """Return the outline (k, 2) of a section; a circle of the same area for a user-defined one."""
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
    """Return the outline of the section chosen for showing an element, or else of its section, if it has one."""
    if isinstance(instance.look, Look) and instance.look.section is not None:
        return outline_of(instance.look.section)
    return outline_of(instance.profile.section) if isinstance(instance.profile, Profile) else None


def spatial(vectors: Array) -> Array:
    """Return positions, directions or forces (…, 3); those of planar elements have no component along z."""
    missing = 3 - vectors.shape[-1]
    return np.concatenate([vectors, np.zeros((*vectors.shape[:-1], missing))], axis=-1)


def triad_of(outputs: Mapping[str, Array], name: str = "axes") -> Array:
    """Return the axes (..., 3, 3) of an element in columns; it reports them as rows, in the plane two of them."""
    rows = spatial(outputs[name])
    first, second = rows[..., 0, :], rows[..., 1, :]
    third = rows[..., 2, :] if rows.shape[-2] > 2 else np.cross(first, second)
    return np.stack([first, second, third], axis=-1)


def frame_of(outputs: Mapping[str, Array], names: Sequence[str] = ("origin", "axes")) -> tuple[Array, Array]:
    """Return origin (..., 3) and axes (..., 3, 3), in columns, of a frame that an element reports by these names."""
    origin, axes = names
    return spatial(outputs[origin]), triad_of(outputs, axes)


def posed(line: Array, pose: tuple[Array, Array]) -> Array:
    """Return positions (..., k, 3) in global axes from those (k, 3) in the axes of a frame."""
    origin, R = pose
    return np.asarray(origin[..., None, :] + line @ np.swapaxes(R, -1, -2))


def segment(start: Array, end: Array) -> Array:
    """Return the line (..., 2, 3) between two points (..., 3); or two directions."""
    return np.stack(np.broadcast_arrays(start, end), axis=-2)


def zigzag(ends: Array) -> Array:
    """Draw a spring between two points (2, 3) as a line in the plane of both and the vertical, or of x and y."""
    d = ends[1] - ends[0]
    length = float(np.linalg.norm(d))
    across = np.cross(d, (0.0, 0.0, 1.0) if abs(d[2]) < 0.9 * length else (0.0, 1.0, 0.0))
    across /= max(float(np.linalg.norm(across)), 1e-300)
    steps = np.concatenate([[0.0], np.linspace(0.15, 0.85, 12), [1.0]])[:, None]
    sides = np.concatenate([[0.0, 0.0], np.tile([1.0, -1.0], 5), [0.0, 0.0]])[:, None]
    return np.asarray(ends[0] + steps * d + 0.09 * length * sides * across)
