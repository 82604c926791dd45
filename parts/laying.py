"""Initial configuration of a rope: its tension or length, its path, and a check of clearance.

The depth of a rope in its sheaves follows from its tension, and its tension from its length and its path.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.optimize import brentq

from flexel.base.arguments import not_negative
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.surfaces import Surface
from flexel.parts.helix import helical_gaps, out_of_plane
from flexel.parts.rope_contacts import Contact
from flexel.parts.rope_path import PathCircle, RopePath, taut_path
from flexel.parts.rope_plane import RopePlane

# Largest depth of a rope in its sheave over the radius of its centre line; a softer contact is an error.
DEEPEST = 0.5
INSIDE = 0.1  # largest depth in a surface that is not on the path, over the rope's radius
SAMPLES = 4000  # places of the path that are checked


class Laying:
    """A rope of n elements on its path, for any tension.

    Attributes
    ----------
    bare : RopePath
        The path without tension.
    """

    def __init__(
        self, plane: RopePlane, contact: Contact, rope_radius: float, turns: Any, n: int, refine: float
    ) -> None:
        self.plane, self.owner, self._contact, self._radius = plane, plane.owner, contact, rope_radius
        self._turns = dead_turns(plane, turns)
        self._n, self._refine = n, refine
        self._element = 0.0  # length of the elements on arcs, which matters only under tension
        self._untouched = self._circles(0.0)
        self.bare = self._path(self._untouched)
        self._element = self.bare.length * float(_shares(self.bare, refine)[1][-1]) / (n * refine)

    def _circles(self, tension: float) -> list[PathCircle]:
        def depth(load: float) -> float:
            return self._contact.depth(load, self._element)

        return self.plane.circles(self._radius, depth, tension, self._turns)

    def depths(self, tension: float) -> dict[str, float]:
        """Return the indentation [m] of the rope into each sheave of its path under a tension [N]."""
        pressed = zip(self._circles(tension), self._untouched, strict=True)
        return {free.name: free.radius - c.radius for c, free in pressed}

    def path(self, tension: float) -> RopePath:
        """Return the path under a tension [N].

        Raises
        ------
        ModelError
            A tension that presses the rope through a sheave.
        """
        found = self._borne(tension)
        if found is None:
            raise ModelError(
                f"{self.owner}: a tension of {tension:.4g} N presses it into a sheave by more than half the radius; "
                "give a lower tension or a stiffer contact"
            )
        return found

    def _borne(self, tension: float) -> RopePath | None:
        """Return the path under a tension [N]; None if a sheave cannot carry it."""
        circles = self._circles(tension)
        pressed = zip(circles, self._untouched, strict=True)
        if any(c.radius < (1 - DEEPEST) * free.radius for c, free in pressed):
            return None
        return self._path(circles)

    def _path(self, circles: list[PathCircle]) -> RopePath:
        flat = taut_path(self.owner, circles, self.plane.closed)
        return out_of_plane(flat, {surface.name: surface for surface in self.plane.surfaces}, self.plane.axes)

    def tension(self, length: float, EA: float) -> float:  # noqa: N803
        """Find the tension [N] at which a rope of a given undeformed length [m] fills its path.

        Raises
        ------
        ModelError
            A length that leaves slack, or is so short that the rope is pressed through a sheave.
        """
        stretch = self.bare.length / length
        if stretch < 1 - 1e-9:
            raise ModelError(
                f"{self.owner}: its length is {(1 / stretch - 1) * 100:.3g} % longer than its path, so it hangs "
                "slack; give a shorter length, or model a slack rope with m.cable_line along its hanging curve"
            )
        largest = EA * max(stretch - 1, 0.0)

        def missing(tension: float) -> float:
            path = self._borne(tension)
            return (path.length / length if path else 0.0) - (1 + tension / EA)

        if missing(largest) >= 0:  # no sheave yields
            return largest
        found = float(brentq(missing, 0.0, largest, xtol=1e-15 * largest, rtol=1e-14))
        if abs(missing(found)) > 1e-9:
            raise ModelError(
                f"{self.owner}: the length {length:g} m on a path of {self.bare.length:.4g} m presses it into a sheave "
                "by more than half the radius; give a greater length or a stiffer contact"
            )
        return found

    def fractions(self, path: RopePath) -> Array:
        """Return the positions of the nodes (n + 1,) over the length: elements are shorter on the arcs of the path."""
        at, share = _shares(path, self._refine)
        return np.asarray(np.interp(np.linspace(0, share[-1], self._n + 1), share, at))


def dead_turns(plane: RopePlane, turns: Any) -> tuple[float, float]:
    """Return the turns on the drum at the start and at the end of a path."""
    given = tuple(turns) if isinstance(turns, (tuple, list)) else (turns, turns)
    if len(given) != 2:
        raise ModelError(f"{plane.owner}: turns {turns!r}; give one number, or a pair for drums at both ends")
    first, last = (not_negative(count, plane.owner, "turns") for count in given)
    missing = [drum is None and count > 0 for drum, count in zip(plane.drums, (first, last), strict=True)]
    if all(missing) or (any(missing) and isinstance(turns, (tuple, list))):
        raise ModelError(
            f"{plane.owner}: turns {turns!r} need a drum, but there is none at that end of the path; end it on a "
            "drum, or leave turns out"
        )
    for drum, count in zip(plane.drums, (first, last), strict=True):
        if drum is not None and drum.pitch and not count:
            raise ModelError(
                f"{plane.owner}: it has no turns in the helical groove of '{drum.name}', on which it ends; "
                "give turns=…, usually two or three"
            )
    return first, last


def check_clear(
    plane: RopePlane,
    path: RopePath,
    surfaces: Sequence[Surface],
    rope_radius: float,
    depths: Mapping[str, float],
) -> None:
    """Refuse an initial rope that runs through a surface, deeper than it presses into the sheaves of its path."""
    places = plane.at(path, np.linspace(0, path.length, SAMPLES))[0]
    for surface in surfaces:
        depth = -float(_gaps(surface, places, rope_radius).min(initial=np.inf))
        meant = depths.get(surface.name, 0.0)
        if depth > meant + INSIDE * rope_radius + 1e-9 * path.length:
            if surface.name not in depths:
                remedy = "which is not on its path; put it into the path, or move it"
            elif surface.pitch:
                remedy = (
                    "whose ridges it touches, or where another sheave guides it; change the start of the groove or its "
                    "sense, or move the next sheave away"
                )
            else:
                remedy = "where another sheave guides it; move them apart, or change their order or sense"
            raise ModelError(
                f"{plane.owner}: in its initial configuration it runs {depth:.3g} m deep into '{surface.name}', "
                f"{remedy}"
            )


def _gaps(surface: Surface, places: Array, rope_radius: float) -> Array:
    """Return the gaps at points of the rope; a groove counts as deep as its bottom, and no wider than the rope."""
    off = places - surface.centre
    if not surface.radius:
        return np.asarray(off @ surface.axle) - rope_radius
    if off.shape[1] == 2:
        return np.asarray(np.linalg.norm(off, axis=1)) - surface.radius - rope_radius
    along = off @ surface.axle
    radial = np.linalg.norm(off - along[:, None] * surface.axle, axis=1)
    gaps: Array = radial - surface.radius - rope_radius
    if surface.pitch:
        return helical_gaps(surface, off, rope_radius)
    return gaps if "flank" not in surface.parameters else gaps[np.abs(along) < rope_radius]


def _shares(path: RopePath, refine: float) -> tuple[Array, Array]:
    """Return ends of straight parts and arcs over the length, and the share of elements up to them; arcs weigh more."""
    knots, weights = [0.0], []
    for _, a, b in path.spans():
        if a > knots[-1] + 1e-12:
            knots.append(a)
            weights.append(1.0)
        knots.append(b)
        weights.append(refine)
    if knots[-1] < path.length * (1 - 1e-12):
        knots.append(path.length)
        weights.append(1.0)
    at = np.array(knots) / knots[-1]
    return at, np.concatenate([[0.0], np.cumsum(np.diff(at) * np.array(weights))])
