"""Curves along which a cable or a chain is drawn, and the positions of its nodes on them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from flexel.base.arguments import array, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.lowering import Lowering
from flexel.model.node import Node
from flexel.parts.nodes import Point

SAMPLES = 400  # samples of a given curve, for its arc length
Path = Sequence[Sequence[float]] | Array | Callable[[float], Any]


def fractions(owner: str, n: int | None, at: Any) -> Array:
    """Return the positions of the nodes over the length."""
    if (n is None) == (at is None):
        raise ModelError(f"{owner}: give either n, the number of elements, or at, the positions of the nodes")
    if at is None:
        return np.linspace(0, 1, whole(n, owner, "number of elements n", most=10**6) + 1)
    found = array(at, owner, "at").ravel()
    if found.size < 2 or found[0] != 0 or found[-1] != 1 or np.any(np.diff(found) <= 0):
        raise ModelError(f"{owner}: at = {found.tolist()} does not increase from 0 to 1; correct it")
    return found


def curve(owner: str, path: Path) -> tuple[Callable[..., Array], float]:
    """Return the path as a function of its arc length (with derivatives), and its length."""
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
    """Parametrize a spline by arc length, resampled."""
    u = np.linspace(spline.x[0], spline.x[-1], 20 * SAMPLES + 1)
    speed = CubicSpline(u, np.linalg.norm(spline(u, 1), axis=1)).antiderivative()
    s = speed(u)
    knots = np.linspace(0, s[-1], SAMPLES + 1)
    return CubicSpline(knots, spline(CubicSpline(s, u)(knots))), float(s[-1])


def points_at(
    to: Lowering, owner: str, name: str, places: Array, start: Node | str | None, end: Node | str | None
) -> tuple[Node, ...]:
    """Add points ``name_p0`` … at positions (n + 1, …), with existing ones for the ends where they are given."""
    existing = {0: start, len(places) - 1: end}
    own = {i: _end(to, owner, given, places[i]) for i, given in existing.items() if given is not None}
    return tuple(own.get(i) or Point(f"{name}_p{i}", place).lower(to) for i, place in enumerate(places))


def _end(to: Lowering, owner: str, given: Node | str, place: Array) -> Node:
    """Return the node that was given for an end, which must be there."""
    node = to.find_of_kind(given, ("point", "planar_point"), owner)
    if node.x0.shape != place.shape or np.linalg.norm(node.x0 - place) > 1e-9 * (1 + np.linalg.norm(place)):
        raise ModelError(
            f"{owner}: node '{node.name}' at {node.x0.tolist()} is not at the end of the path, "
            f"{place.tolist()}; move one"
        )
    return node
