"""The plane of a rope's sheaves and ends, and the circles of its path in it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.model.surfaces import Surface
from flexel.parts.rope_contacts import find_surface
from flexel.parts.rope_path import PathCircle, RopePath

Place = str | Node | tuple[str, int]


class RopePlane:
    """The plane of a rope's sheaves and ends, and the circles of its path; a closed one has no ends."""

    def __init__(self, to: Lowering, owner: str, path: Sequence[Place], closed: bool = False) -> None:
        if not isinstance(path, (list, tuple)) or len(path) < 2:
            raise ModelError(f"{owner}: path {path!r} is not a list of two or more entries; give one")
        items = [_with_sense(owner, place) for place in path]
        self.owner, self.closed = owner, closed
        self.items: list[tuple[Surface | Node, int]] = []
        for i, (place, sense) in enumerate(items):
            known = isinstance(place, str) and place in to.surfaces
            inner = closed or 0 < i < len(items) - 1
            if known or inner:
                surface = find_surface(to, place, owner)
                if not surface.radius:
                    raise ModelError(
                        f"{owner}: '{place}' is a plane, but the path runs over sheaves; name it in also="
                    )
                self.items.append((surface, sense))
            else:
                point = to.find_of_kind(place, ("point", "planar_point"), owner)
                if sense:
                    raise ModelError(
                        f"{owner}: '{point.name}' is a point and has no sense of wrap; leave it out"
                    )
                self.items.append((point, 0))
        self.surfaces = [place for place, _ in self.items if not isinstance(place, Node)]
        self.names = [surface.name for surface in self.surfaces]
        walking = [surface.name for surface in self.surfaces if closed and surface.pitch]
        if walking:
            raise ModelError(
                f"{owner}: it is closed, so the helical groove of '{walking[0]}' would move it sideways without end; "
                "give the sheave an fx.RoundGroove(…)"
            )
        ends = (None, None) if closed else (self.items[0][0], self.items[-1][0])
        self.ends = [end if isinstance(end, Node) else None for end in ends]
        self.drums = [end if isinstance(end, Surface) else None for end in ends]
        self._check_dimensions()
        centres = np.array([_centre(place) for place, _ in self.items])
        self.planar = centres.shape[1] == 2
        if self.planar:
            self.origin, self.axes, self.normal = np.zeros(2), np.eye(2), np.zeros(2)
        else:
            self.origin, self.axes = self._spatial(centres)
            self.normal = np.cross(*self.axes)
        self.flat = (centres - self.origin) @ self.axes.T
        normal = np.array([0.0, 0.0, 1.0]) if self.planar else np.cross(*self.axes)
        self.signs = [
            1 if isinstance(place, Node) else int(np.sign(place.axle @ normal)) for place, _ in self.items
        ]

    def _check_dimensions(self) -> None:
        sizes = {place.name: _centre(place).size for place, _ in self.items}
        if len(set(sizes.values())) > 1:
            flat, spatial = ([name for name, size in sizes.items() if size == count] for count in (2, 3))
            raise ModelError(
                f"{self.owner}: {', '.join(flat)} lie in a planar model, {', '.join(spatial)} in space; use one kind"
            )

    def _spatial(self, centres: Array) -> tuple[Array, Array]:
        """Return the plane's origin and two axes; the sheaves' axles must be normal to it."""
        if not self.surfaces:
            raise ModelError(f"{self.owner}: no sheave on its path; use m.cable_line for a straight rope")
        normal = self.surfaces[0].axle
        away = (centres - centres[0]) @ normal
        size = 1e-9 * (1 + float(np.abs(centres).max()))
        for (place, _), off in zip(self.items, away, strict=True):
            slanted = not isinstance(place, Node) and np.linalg.norm(np.cross(place.axle, normal)) > 1e-9
            if slanted or abs(off) > size:
                raise ModelError(
                    f"{self.owner}: '{place.name}' does not lie in the plane of '{self.surfaces[0].name}' ({off:.4g} m "
                    "off, axle not normal to it, or both); the path of a rope must lie in one plane"
                )
        first = np.zeros(3)
        first[int(np.argmin(np.abs(normal)))] = 1.0
        e1 = first - (first @ normal) * normal
        e1 /= np.linalg.norm(e1)
        return centres[0], np.array([e1, np.cross(normal, e1)])

    def circles(
        self,
        rope_radius: float,
        depth: Callable[[float], float],
        tension: float,
        turns: tuple[float, float],
    ) -> list[PathCircle]:
        """Return the circles of the path, with the radii of the rope's centre line under a tension.

        `depth` is the one [m] at which the contact carries a load per length [N/m].
        """
        found = []
        for i, (place, sense) in enumerate(self.items):
            if isinstance(place, Node):
                found.append(PathCircle(place.name, self.flat[i], 0.0))
                continue
            R = place.radius + rope_radius
            if len(place.gaps) == 2:  # both flanks share the load
                sine = float(place.parameters["flank"][0])
                deep = depth(tension / R / (2 * sine)) / sine
            else:
                deep = depth(tension * R / place.per_radian(rope_radius) ** 2)
            end = {0: turns[0], len(self.items) - 1: turns[1]}.get(i, 0.0)
            found.append(PathCircle(place.name, self.flat[i], R - deep, sense * self.signs[i], end))
        return found

    def at(self, path: RopePath, s: Array) -> tuple[Array, Array]:
        """Return points and unit tangents (ns, 2 or 3) of a path in global coordinates, at arc lengths s (ns,)."""
        flat, tangents = path.at(s)
        off, rise = (values[:, None] for values in path.off(s))
        places = self.origin + flat @ self.axes + off * self.normal
        return places, (tangents @ self.axes + rise * self.normal) / np.hypot(1, rise)


def _centre(place: Surface | Node) -> Array:
    """Return where a node or the centre of a surface is drawn."""
    return place.x0 if isinstance(place, Node) else place.centre


def _with_sense(owner: str, place: Any) -> tuple[Any, int]:
    """Return a point of the path and its sense of wrap, 0 if undetermined."""
    if not isinstance(place, (tuple, list)):
        return place, 0
    if len(place) != 2 or not isinstance(place[1], (int, np.integer)) or place[1] not in (-1, 1):
        raise ModelError(f"{owner}: {place!r} in its path; give a name, or ('name', +1) or ('name', -1)")
    return place[0], int(place[1])
