"""Outlines and solids carried by a body, for display only: polylines, boxes, cylinders and meshes from files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from flexel.apps.view.meshes import read_mesh, sharp_edges
from flexel.base.arguments import array, positive, text, vector
from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError
from flexel.base.quaternions import unit
from flexel.parts.looks import colour_of

CYLINDER_SIDES = 32  # of a cylinder
MAX_TRIANGLES = 200_000  # triangles of a mesh: 7 MB in a page
STEEL = "#8fa3b3"


def carried(thing: Sketch | Solid) -> str:
    """Return the name of an outline or solid for messages; raise a ModelError if its point or frame is not a name."""
    kind = type(thing).__name__
    text(thing.point, kind, "point")
    if thing.frame is not None:
        text(thing.frame, kind, "frame")
    return f"{kind} on '{thing.point:.40}'"


@dataclass(frozen=True)
class Sketch:
    """A polyline carried by a body; the outline is for display only and does not affect the mechanics.

    Parameters
    ----------
    point : str
        Node of the body that carries it.
    frame : str or None
        Node whose rotation it follows: a frame or planar angle; None if it keeps its directions.
    drawn : sequence of (x, y, z)
        Vertices in global axes, as the model is drawn (before it moves) [m].
    """

    point: str
    frame: str | None
    drawn: Sequence[Sequence[float]]

    def __post_init__(self) -> None:
        owner = carried(self)
        if array(self.drawn, owner, "drawn").shape[1:] != (3,) or len(self.drawn) < 2:
            raise ModelError(f"{owner}: drawn is not a list of points (x, y, z); give two or more")

    @cached_property
    def lines(self) -> tuple[Array, ...]:
        """Return the polyline (k, 3) [m]."""
        return (np.asarray(self.drawn, dtype=float),)


@dataclass(frozen=True)
class Solid:
    """A surface of triangles carried by a body, for display only: a `Box`, `Cylinder` or `Mesh`.

    Attributes
    ----------
    point, frame
        As for a `Sketch`.
    colour : str
        As ``"#8fa3b3"``.
    """

    point: str
    frame: str | None
    colour: str = field(default=STEEL, kw_only=True)

    @cached_property
    def surface(self) -> tuple[Array, Index]:
        """Return vertices (k, 3) [m] and triangles (t, 3)."""
        raise NotImplementedError

    @cached_property
    def lines(self) -> tuple[Array, ...]:
        """Return its sharp edges, polylines (2, 3) [m]."""
        return sharp_edges(*self.surface)

    def _check(self) -> str:
        owner = carried(self)
        colour_of(text(self.colour, owner, "colour"), owner)
        return owner


@dataclass(frozen=True)
class Box(Solid):
    """A box with sides along the global axes, or along given ones, as the model is drawn.

    Parameters
    ----------
    point, frame
        As for a `Sketch`.
    centre : sequence of float (3,)
        In global axes as drawn [m].
    sides : sequence of float (3,)
        Lengths along its axes [m].
    axes : sequence of (x, y, z), optional
        Its axes as three rows, as drawn; the global ones by default.

    Examples
    --------
    >>> fx.Box("hook", None, centre=(0, -2.5, 0), sides=(2, 1, 1))  # doctest: +SKIP
    """

    centre: Sequence[float]
    sides: Sequence[float]
    axes: Sequence[Sequence[float]] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    def __post_init__(self) -> None:
        owner = self._check()
        vector(self.centre, owner, "centre", 3)
        for side in vector(self.sides, owner, "sides", 3):
            positive(float(side), owner, "side")
        _check_axes(self.axes, owner)

    @cached_property
    def surface(self) -> tuple[Array, Index]:
        """Return eight corners and twelve triangles."""
        signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        corners = np.asarray(self.centre, dtype=float) + 0.5 * signs * np.asarray(
            self.sides, dtype=float
        ) @ _rows(self.axes)
        faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        return corners, np.array(
            [triangle for a, b, c, d in faces for triangle in ((a, b, c), (a, c, d))], dtype=np.intp
        )


@dataclass(frozen=True)
class Cylinder(Solid):
    """A solid cylinder between two points, as the model is drawn.

    Parameters
    ----------
    point, frame
        As for a `Sketch`.
    start, end : sequence of float (3,)
        Centres of its two end faces, in global axes as drawn [m].
    radius : float
        [m]
    """

    start: Sequence[float]
    end: Sequence[float]
    radius: float

    def __post_init__(self) -> None:
        owner = self._check()
        a, b = vector(self.start, owner, "start", 3), vector(self.end, owner, "end", 3)
        positive(self.radius, owner, "radius")
        if np.array_equal(a, b):
            raise ModelError(f"{owner}: start and end coincide; give the centres of its two end faces")

    @cached_property
    def surface(self) -> tuple[Array, Index]:
        """Return two rings and the centres of the end faces."""
        a, b = np.asarray(self.start, dtype=float), np.asarray(self.end, dtype=float)
        along = (b - a) / np.linalg.norm(b - a)
        u = np.cross(along, np.eye(3)[int(np.argmin(np.abs(along)))])
        u /= np.linalg.norm(u)
        angles = np.arange(CYLINDER_SIDES) * 2 * np.pi / CYLINDER_SIDES
        ring = self.radius * (np.outer(np.cos(angles), u) + np.outer(np.sin(angles), np.cross(along, u)))
        found = []
        for i in range(CYLINDER_SIDES):
            j = (i + 1) % CYLINDER_SIDES
            found += [(i, j, CYLINDER_SIDES + j), (i, CYLINDER_SIDES + j, CYLINDER_SIDES + i)]
            found += [
                (2 * CYLINDER_SIDES, j, i),
                (2 * CYLINDER_SIDES + 1, CYLINDER_SIDES + i, CYLINDER_SIDES + j),
            ]
        return np.vstack([a + ring, b + ring, a, b]), np.array(found, dtype=np.intp)


@dataclass(frozen=True)
class Mesh(Solid):
    """A surface from an ``.stl`` or ``.obj`` file, which is copied into the page.

    Parameters
    ----------
    point, frame
        As for a `Sketch`.
    path : path
        The file; its coordinates are global ones as the model is drawn, after scaling and moving.
    scale : float
        Length of one unit of the file [m]: 0.001 for millimetres.
    origin : sequence of float (3,)
        Position of the file's origin, in global axes as drawn [m].
    axes : sequence of (x, y, z), optional
        Directions of the file's axes as three rows, as drawn; the global ones by default.

    Examples
    --------
    >>> fx.Mesh("hub", "wheel", "rim.stl", scale=1e-3, origin=(1.2, 0, 0.3))  # doctest: +SKIP
    """

    path: str | Path
    scale: float = 1.0
    origin: Sequence[float] = (0.0, 0.0, 0.0)
    axes: Sequence[Sequence[float]] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    def __post_init__(self) -> None:
        owner = self._check()
        positive(self.scale, owner, "scale")
        vector(self.origin, owner, "origin", 3)
        _check_axes(self.axes, owner)
        count = len(self.surface[1])
        if count > MAX_TRIANGLES:
            raise ModelError(
                f"{owner}: '{self.path}' has {count} triangles; simplify it to {MAX_TRIANGLES} or fewer"
            )

    @cached_property
    def surface(self) -> tuple[Array, Index]:
        """Return the triangles of the file, read once."""
        vertices, triangles = read_mesh(self.path)
        return np.asarray(self.origin, dtype=float) + self.scale * vertices @ _rows(self.axes), triangles


def _check_axes(axes: Any, owner: str) -> None:
    """Return three directions, or raise a ModelError that names the owner."""
    if array(axes, owner, "axes").shape != (3, 3):
        raise ModelError(f"{owner}: axes {axes!r:.60} are not three directions (x, y, z); give three rows")
    for axis in axes:
        unit(axis, owner, "axis")


def _rows(axes: Sequence[Sequence[float]]) -> Array:
    """Return unit vectors in rows."""
    return np.array([np.asarray(axis, dtype=float) / np.linalg.norm(axis) for axis in axes])
