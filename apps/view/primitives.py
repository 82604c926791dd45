"""The primitives of a picture: lines carried by a body or deforming, with a section, a force or values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.quaternions import matrix
from flexel.model.instances import Instance
from flexel.model.profiles import Section
from flexel.model.state import State
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
    """Return the position (3,) of a point; planar points lie in z = 0."""
    x = state.position(node)
    return np.append(x, 0.0) if x.size == 2 else x


def turned(angle: float) -> Array:
    """Return axes (3, 3) rotated about z by a planar node's angle."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def axes_of(state: State, frame: str) -> Array:
    """Return the axes (3, 3) of a frame or of a planar angle."""
    x = state.position(frame)
    return turned(float(x[0])) if x.size == 1 else matrix(x)


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
    low = float(np.min(np.vstack(shape.lines) @ up))
    if shape.outline is None:
        return low
    if shape.across is None:
        return low - float(np.max(np.linalg.norm(shape.outline, axis=1)))
    for line in shape.lines:
        for end, along, y in ((line[0], line[1] - line[0], 0), (line[-1], line[-1] - line[-2], 1)):
            across = np.cross(along / np.linalg.norm(along), shape.across[y])
            low = min(
                low, float(np.min(end @ up + shape.outline @ np.array([shape.across[y] @ up, across @ up])))
            )
    return low


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


def reported(state: State, instance: Instance) -> dict[str, Array]:
    """Return the outputs of an element at a state, by name; see `State.outputs`."""
    found = state.evaluation.outputs([instance], state.x[None], state.e[None], state.stresses[None])
    return {name: values[0, 0] for name, values in found.items()}


def reports(instance: Instance, *names: str) -> bool:
    """Whether an element has outputs of these names."""
    return set(names) <= {output.name for output in instance.spec.outputs}


def spatial(vectors: Array) -> Array:
    """Return places, directions or forces (…, 3); those of planar elements have no component along z."""
    missing = 3 - vectors.shape[-1]
    return np.concatenate([vectors, np.zeros((*vectors.shape[:-1], missing))], axis=-1)


def triad_of(outputs: Mapping[str, Array], name: str = "axes") -> Array:
    """Return the axes (3, 3) of an element in columns; it reports them as rows, in the plane two of them."""
    rows = spatial(outputs[name])
    return np.asarray(np.column_stack([*rows, np.cross(rows[0], rows[1])][:3]))


def frame_of(outputs: Mapping[str, Array], names: Sequence[str] = ("origin", "axes")) -> tuple[Array, Array]:
    """Return origin (3,) and axes (3, 3), in columns, of a frame that an element reports by these names."""
    origin, axes = names
    return spatial(outputs[origin]), triad_of(outputs, axes)


def zigzag(ends: Array) -> Array:
    """Draw a spring between two points (2, 3) as a line in the plane of both and the vertical, or of x and y."""
    d = ends[1] - ends[0]
    length = float(np.linalg.norm(d))
    across = np.cross(d, (0.0, 0.0, 1.0) if abs(d[2]) < 0.9 * length else (0.0, 1.0, 0.0))
    across /= max(float(np.linalg.norm(across)), 1e-300)
    steps = np.concatenate([[0.0], np.linspace(0.15, 0.85, 12), [1.0]])[:, None]
    sides = np.concatenate([[0.0, 0.0], np.tile([1.0, -1.0], 5), [0.0, 0.0]])[:, None]
    return np.asarray(ends[0] + steps * d + 0.09 * length * sides * across)
