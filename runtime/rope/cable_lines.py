"""Lines of cables: the method of `Model` that adds many elements along a straight line or a curve."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from flexel.base.arguments import array, not_negative, number, positive
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.transactions import whole_or_nothing
from flexel.rope.cables import Cables
from flexel.structure.nodes import Node

SAMPLES = 400  # samples of a given curve, for its arc length
Path = Sequence[Sequence[float]] | Array | Callable[[float], Any]


@dataclass(frozen=True, repr=False)
class CableLine:
    """A line of cable elements made by `Model.cable_line`.

    Attributes
    ----------
    name : str
    elements : tuple of str (n,)
    points, slopes : tuple of Node (n + 1,)
    s : ndarray (n + 1,)
        Undeformed arc length of the nodes [m].
    radius : float, optional
        Contact radius [m]: half the diameter of its section; None without a round section.
    """

    name: str
    elements: tuple[str, ...]
    points: tuple[Node, ...]
    slopes: tuple[Node, ...]
    s: Array
    radius: float | None

    def __repr__(self) -> str:
        """One line: a rope has hundreds of nodes."""
        return f"{type(self).__name__}('{self.name}', {len(self.elements)} elements, {self.s[-1]:.6g} m)"


class CableLines(Cables):
    """Lines of cables."""

    @whole_or_nothing
    def cable_line(
        self,
        name: str,
        path: Path,
        n: int | None = None,
        *,
        length: float | None = None,
        at: Sequence[float] | Array | None = None,
        start: Node | str | None = None,
        end: Node | str | None = None,
        **properties: Any,
    ) -> CableLine:
        """Add a cable of n elements along a path: elements ``name1`` …, points ``name_p0`` …, slopes ``name_d0`` ….

        Parameters
        ----------
        path : sequence of points (3,) or (2,), or callable
            Two points are a straight line, more a smooth curve through them; a callable gives the place for a parameter
            from 0 to 1.
        n : int
            Number of elements, of equal length.
        length : float, optional
            Undeformed length of the whole cable [m], that of the path by default; a longer path stretches the cable.
        at : sequence of float, optional
            Instead of n: undeformed arc length of the nodes over the length, from 0 to 1, for example to refine near
            a sheave.
        start, end : node, optional
            Existing points to use for the ends, such as those of a body.
        **properties
            EA, EI, mass_per_length, section, material, damping, bending_damping of `Model.cable`.

        Returns
        -------
        CableLine

        Raises
        ------
        ModelError
            A path without length, places that do not ascend, ends that are not on the path.

        Examples
        --------
        >>> rope = m.cable_line("rope", [(0, 0, 0), (0, 0, -10)], 20, EA=1e6, EI=1.0, mass_per_length=1.0)
        ... # doctest: +SKIP
        """
        owner = f"cable line '{name}'"
        fractions = _fractions(owner, n, at)
        curve, total = _curve(owner, path)
        length = total if length is None else positive(length, owner, "length")
        places, directions = curve(fractions * total), curve(fractions * total, 1)
        points = [
            _end(self, owner, start, places[0]),
            *[None] * (len(fractions) - 2),
            _end(self, owner, end, places[-1]),
        ]
        nodes = [
            z or self.point(f"{name}_p{i}", x) for i, (z, x) in enumerate(zip(points, places, strict=True))
        ]
        slopes = [
            self.slope(f"{name}_d{i}", direction, stretch=total / length)
            for i, direction in enumerate(directions)
        ]
        s = fractions * length
        elements = []
        for i in range(len(s) - 1):
            elements.append(f"{name}{i + 1}")
            ends = nodes[i], slopes[i], nodes[i + 1], slopes[i + 1]
            self.cable(elements[-1], *ends, float(s[i + 1] - s[i]), **properties)
        radius = section_radius(properties.get("section"))
        return CableLine(name, tuple(elements), tuple(nodes), tuple(slopes), s, radius)


def section_radius(section: object) -> float | None:
    """Half the outer diameter [m] of a round section; None for others."""
    diameter = getattr(section, "diameter", None)
    return None if diameter is None else float(diameter) / 2


def contact_radius(own: float | None, given: float | None, owner: str) -> float:
    """Radius [m] at which a rope touches: that of its section, or the given one if the section has none."""
    if given is None:
        if own is None:
            raise ModelError(f"{owner}: its radius is not known; give radius=…, or a section with a diameter")
        return own
    radius = not_negative(given, owner, "radius")
    if own is not None and abs(radius - own) > 1e-9 * own:
        raise ModelError(
            f"{owner}: radius {radius:g} m contradicts that of the rope's section, {own:g} m; leave radius out"
        )
    return radius


def _fractions(owner: str, n: int | None, at: Any) -> Array:
    """Places of the nodes over the length."""
    if (n is None) == (at is None):
        raise ModelError(f"{owner}: give either n, the number of elements, or at, the places of the nodes")
    if at is None:
        count = number(n, owner, "n")
        if count < 1 or count != int(count):
            raise ModelError(f"{owner}: n = {count:g} elements; give a whole number of at least 1")
        return np.linspace(0, 1, int(count) + 1)
    fractions = array(at, owner, "at").ravel()
    if fractions.size < 2 or fractions[0] != 0 or fractions[-1] != 1 or np.any(np.diff(fractions) <= 0):
        raise ModelError(f"{owner}: at = {fractions.tolist()} does not ascend from 0 to 1; correct it")
    return fractions


def _curve(owner: str, path: Path) -> tuple[Callable[..., Array], float]:
    """The path as a function of its arc length (with derivatives), and its length."""
    if callable(path):
        points = array([path(float(u)) for u in np.linspace(0, 1, SAMPLES + 1)], owner, "path")
    else:
        points = array(path, owner, "path")
    if points.ndim != 2 or len(points) < 2 or points.shape[1] not in (2, 3):
        raise ModelError(
            f"{owner}: path has shape {points.shape}; give at least two points of 3 (or 2) numbers"
        )
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if not np.all(chords > 0):
        raise ModelError(f"{owner}: path has points that coincide; leave one out")
    if len(points) == 2:
        direction = (points[1] - points[0]) / chords[0]
        line = CubicSpline([0, chords[0]], points, bc_type=((1, direction), (1, direction)))
        return line, float(chords[0])
    return _by_arc_length(CubicSpline(np.concatenate([[0], np.cumsum(chords)]), points))


def _by_arc_length(spline: CubicSpline) -> tuple[CubicSpline, float]:
    """A spline parametrized by its own arc length, resampled."""
    u = np.linspace(spline.x[0], spline.x[-1], 20 * SAMPLES + 1)
    speed = CubicSpline(u, np.linalg.norm(spline(u, 1), axis=1)).antiderivative()
    s = speed(u)
    knots = np.linspace(0, s[-1], SAMPLES + 1)
    return CubicSpline(knots, spline(CubicSpline(s, u)(knots))), float(s[-1])


def _end(model: Cables, owner: str, given: Node | str | None, place: Array) -> Node | None:
    """The node that was given for an end, if it lies there."""
    if given is None:
        return None
    node = model._find_of_kind(given, ("point", "planar_point"), owner)
    if node.x0.shape != place.shape or np.linalg.norm(node.x0 - place) > 1e-9 * (1 + np.linalg.norm(place)):
        raise ModelError(
            f"{owner}: node '{node.name}' at {node.x0.tolist()} is not at the end of the path, "
            f"{place.tolist()}; move one"
        )
    return node
