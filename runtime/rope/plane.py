"""The plane in which a rope's sheaves and ends lie, and the places of its path in it.

Imports numpy, the errors, the surfaces and the geometry of paths.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from flexel.errors import ModelError
from flexel.rope.contacts import Contact, find_surface
from flexel.rope.path import Circle
from flexel.structure import Array, Node

if TYPE_CHECKING:
    from flexel.model import Model
    from flexel.rope.surfaces import Surface

Place = str | Node | tuple[str, int]


class RopePlane:
    """The plane in which a rope's sheaves and ends lie, and what the path is made of."""

    def __init__(self, model: Model, owner: str, path: Sequence[Place]) -> None:
        if isinstance(path, str) or len(path) < 2:
            raise ModelError(f"{owner}: path {path!r} has fewer than two places; give a list")
        items = [z if isinstance(z, tuple) else (z, 0) for z in path]
        self.model, self.owner = model, owner
        self.items: list[tuple[Surface | Node, int]] = []
        for i, (place, sense) in enumerate(items):
            known = isinstance(place, str) and place in model.surfaces
            inner = 0 < i < len(items) - 1
            if sense not in (-1, 0, 1):
                raise ModelError(f"{owner}: sense {sense!r} at '{place}'; give +1 or -1")
            if known or inner:
                surface = find_surface(model, str(place))
                if not surface.radius:
                    raise ModelError(
                        f"{owner}: '{place}' is a plane; name it in also=, the path runs over sheaves"
                    )
                self.items.append((surface, int(sense)))
            else:
                self.items.append((model.of_kind(place, ("point", "planar_point"), owner), 0))
        self.surfaces = [z for z, _ in self.items if not isinstance(z, Node)]
        self.names = [z.name for z in self.surfaces]
        ends = self.items[0][0], self.items[-1][0]
        self.ends = [z if isinstance(z, Node) else None for z in ends]
        self.drums = [None if isinstance(z, Node) else z for z in ends]
        centres = np.array([z.x0 if isinstance(z, Node) else z.centre for z, _ in self.items])
        self.planar = centres.shape[1] == 2
        if self.planar:
            self.origin, self.axes = np.zeros(2), np.eye(2)
        else:
            self.origin, self.axes = self._spatial(centres)
        self.flat = (centres - self.origin) @ self.axes.T
        normal = np.array([0.0, 0.0, 1.0]) if self.planar else np.cross(*self.axes)
        self.signs = [1 if isinstance(z, Node) else int(np.sign(z.axle @ normal)) for z, _ in self.items]

    def _spatial(self, centres: Array) -> tuple[Array, Array]:
        """Origin and two axes of the plane; the sheaves' axles must be normal to it."""
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
                    "off, axle not normal to it, or both); a rope is laid in one plane"
                )
        first = np.zeros(3)
        first[int(np.argmin(np.abs(normal)))] = 1.0
        e1 = first - (first @ normal) * normal
        e1 /= np.linalg.norm(e1)
        return centres[0], np.array([e1, np.cross(normal, e1)])

    def circles(
        self, rope_radius: float, contact: Contact, tension: float, turns: float, n: int
    ) -> list[Circle]:
        """The places of the path with the radii at which the rope's centre line lies under a tension."""
        found = []
        for i, (place, sense) in enumerate(self.items):
            if isinstance(place, Node):
                found.append(Circle(place.name, self.flat[i], 0.0))
                continue
            R = place.radius + rope_radius
            depth = contact.depth(tension / R, R / 2)
            if place.element == "cable_v_groove":  # both flanks share the load
                sine = float(place.parameters["flank"][0])
                depth = contact.depth(tension / R / (2 * sine), R / 2) / sine
            end = turns if i in (0, len(self.items) - 1) else 0.0
            found.append(Circle(place.name, self.flat[i], R - depth, sense * self.signs[i], end))
        return found

    def place(self, flat: Array) -> Array:
        """A point of the plane in global coordinates."""
        return np.asarray(self.origin + flat @ self.axes)

    def direction(self, flat: Array) -> Array:
        """A direction of the plane in global coordinates."""
        return np.asarray(flat @ self.axes)
