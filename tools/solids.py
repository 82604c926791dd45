"""Shaded solids for small pictures: boxes, cylinders, spheres, threads and arrows, as polygons sorted by depth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise, product

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

from flexel.base.arrays import Array

Vector = Sequence[float] | Array
ROUND = 36  # sides of what is round
AMBIENT = 0.62  # brightness of what the light does not reach
LIGHT = np.array([-0.35, -0.6, 0.72])  # direction towards the light, in the axes of the picture's world
HEAD = 0.16  # length of an arrow's head [m]
LINE = 0.022  # radius of an arrow [m]
THREAD = 0.13  # depth of a thread, relative to its radius
CELL = 0.05  # size of the faces into which larger ones are divided, so that they can be sorted [m]


@dataclass
class Scene:
    """Polygons in space, each with its colour.

    Attributes
    ----------
    elevation, azimuth : float
        Of the eye [degrees].
    """

    elevation: float = 24.0
    azimuth: float = -58.0
    _polygons: list[Array] = field(default_factory=list)
    _colours: list[tuple[float, float, float]] = field(default_factory=list)

    def faces(self, polygons: Sequence[Array], colour: str) -> None:
        """Add plane polygons (corners, 3), counterclockwise seen from outside."""
        self._polygons += [np.asarray(polygon, dtype=float) for polygon in polygons]
        self._colours += [to_rgb(colour)] * len(polygons)

    def box(self, centre: Vector, size: Vector, colour: str) -> None:
        """Add a box along the axes."""
        middle, half = np.array(centre, dtype=float), np.array(size, dtype=float) / 2
        for axis in range(3):
            one, two = (axis + 1) % 3, (axis + 2) % 3
            across = [
                np.linspace(-half[i], half[i], 1 + max(round(2 * half[i] / CELL), 1)) for i in (one, two)
            ]
            for side in (1, -1):
                cells = []
                for (a, b), (c, d) in product(pairwise(across[0]), pairwise(across[1])):
                    corners = np.empty((4, 3))
                    corners[:, axis] = side * half[axis]
                    corners[:, one], corners[:, two] = (a, b, b, a), (c, c, d, d)
                    cells.append(middle + corners[::side])
                self.faces(cells, colour)

    def cylinder(self, p: Vector, q: Vector, radius: float, colour: str, end: float | None = None) -> None:
        """Add a round rod from p to q; with another radius at its end, a cone or a part of one."""
        last = radius if end is None else end
        count = 1 + max(round(float(np.linalg.norm(np.subtract(q, p))) / CELL), 1)
        rings = [_ring(p, q, part, radius + part * (last - radius)) for part in np.linspace(0, 1, count)]
        self._skin(rings, colour)
        self.faces([rings[0][::-1], rings[-1]], colour)

    def threaded(self, p: Vector, q: Vector, radius: float, pitch: float, colour: str) -> None:
        """Add a threaded rod from p to q."""
        length = float(np.linalg.norm(np.subtract(q, p)))
        angle = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
        rings = []
        for along in np.arange(0.0, length, pitch / 8):
            phase = (along / pitch - angle / (2 * np.pi)) % 1.0
            wave = radius * (1 - THREAD * np.abs(2 * phase - 1))
            rings.append(_ring(p, q, along / length, 1.0, wave))
        self._skin(rings, colour)
        self.faces([rings[0][::-1], rings[-1]], colour)

    def sphere(
        self, centre: Vector, radius: float, colour: str, low: float = -90.0, high: float = 90.0
    ) -> None:
        """Add a sphere, or its part between two latitudes [degrees] about z, with its inside."""
        up = np.radians(np.linspace(low, high, ROUND // 2 + 1))
        rings = [
            np.array(centre) + _ring((0, 0, 0), (0, 0, 1), radius * np.sin(a), max(radius * np.cos(a), 1e-6))
            for a in up
        ]
        self._skin(rings, colour)
        if low > -90 or high < 90:
            self._skin(rings[::-1], colour)

    def arrow(self, points: Array, colour: str, both: bool = False) -> None:
        """Add an arrow along a line of points (count, 3)."""
        points = np.asarray(points, dtype=float)
        tail = _head(points[::-1]) if both else None
        for head in [_head(points), *([tail] if tail is not None else [])]:
            base, tip = head
            self.cylinder(base, tip, 3.0 * LINE, colour, end=1e-4)
        first, last = (tail[0] if tail else points[0]), _head(points)[0]
        length = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
        inside = points[(length > (HEAD if both else 0.0)) & (length < length[-1] - HEAD)]
        line = np.array([first, *inside, last])
        for a, b in zip(line[:-1], line[1:], strict=True):
            self.cylinder(a, b, LINE, colour)

    def turn(
        self, centre: Vector, axis: Vector, radius: float, angles: tuple[float, float], colour: str
    ) -> None:
        """Add a round arrow about an axis, between two angles [degrees]; both ends have heads."""
        one, two = _across(axis)
        angle = np.radians(np.linspace(*angles, ROUND))
        points = np.array(centre) + radius * (np.outer(np.cos(angle), one) + np.outer(np.sin(angle), two))
        self.arrow(points, colour, both=True)

    def draw(self, axes: Axes) -> None:
        """Draw what is seen from outside, the farthest first."""
        out, screen = self._eye
        light = LIGHT / np.linalg.norm(LIGHT)
        shown = []
        for polygon, colour in zip(self._polygons, self._colours, strict=True):
            normal = np.cross(polygon[1] - polygon[0], polygon[2] - polygon[1])
            size = float(np.linalg.norm(normal))
            if size == 0 or normal @ out <= 0:
                continue
            bright = AMBIENT + (1 - AMBIENT) * max(float(normal @ light) / size, 0.0)
            shown.append(
                (float(np.mean(polygon @ out)), polygon @ screen, tuple(bright * part for part in colour))
            )
        shown.sort(key=lambda face: face[0])
        _, faces, colours = zip(*shown, strict=True)
        axes.add_collection(PolyCollection(faces, facecolors=colours, edgecolors=colours, lw=0.8))
        corners = np.concatenate(faces)
        (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
        axes.set_xlim(x0, x1)
        axes.set_ylim(y0, y1)
        axes.set_aspect("equal")
        axes.set_axis_off()

    def where(self, point: Vector) -> tuple[float, float]:
        """Return where a point is in the picture."""
        x, y = np.array(point, dtype=float) @ self._eye[1]
        return float(x), float(y)

    @property
    def _eye(self) -> tuple[Array, Array]:
        """The direction towards the eye (3,), and the directions of the picture (3, 2)."""
        e, a = np.radians(self.elevation), np.radians(self.azimuth)
        out = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        return out, np.array([right, np.cross(out, right)]).T

    def _skin(self, rings: Sequence[Array], colour: str) -> None:
        """Add the faces between rings of equal size."""
        for a, b in zip(rings[:-1], rings[1:], strict=True):
            following = np.roll(np.arange(len(a)), -1)
            self.faces([np.array([a[i], a[j], b[j], b[i]]) for i, j in enumerate(following)], colour)


def _across(axis: Vector) -> tuple[Array, Array]:
    """Return two directions that complete an axis to a right-handed triad."""
    along = np.array(axis, dtype=float) / np.linalg.norm(axis)
    one = np.cross(np.eye(3)[int(np.argmin(np.abs(along)))], along)
    one /= np.linalg.norm(one)
    return one, np.cross(along, one)


def _ring(p: Vector, q: Vector, part: float, radius: float, wave: Array | float = 1.0) -> Array:
    """Return points (count, 3) around the line from p to q, at a part of it."""
    begin, along = np.array(p, dtype=float), np.subtract(q, p)
    one, two = _across(along)
    angle = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
    circle = np.outer(np.cos(angle) * wave, one) + np.outer(np.sin(angle) * wave, two)
    return np.asarray(begin + part * along + radius * circle)


def _head(points: Array) -> tuple[Array, Array]:
    """Return base and tip of the head at the end of a line of points."""
    tip = points[-1]
    off = np.linalg.norm(points - tip, axis=1)
    before = points[np.flatnonzero(off > HEAD)[-1]] if (off > HEAD).any() else points[0]
    return tip + HEAD * (before - tip) / np.linalg.norm(before - tip), tip
