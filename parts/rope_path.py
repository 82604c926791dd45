"""The path of a taut rope around circles in a plane: tangents, arcs and the positions of a rope on it.

Pure geometry, in the plane of the sheaves; angles count from its first axis towards its second.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError

MOST_SENSES = 12  # most sheaves whose sense of wrap is determined automatically
NEARLY = 1e-9  # depth to which rounding may let a straight part cut a circle, over the radius


@dataclass(frozen=True)
class PathCircle:
    """A point or circle that the rope passes: centre (2,), radius of the rope's centre line (zero for a point), sense.

    The sense is +1 where the rope runs counterclockwise, -1 where it runs clockwise, 0 if undetermined;
    `turns` are dead wraps, on the first or last circle only.
    """

    name: str
    centre: Array
    radius: float
    sense: int = 0
    turns: float = 0.0


@dataclass(frozen=True)
class PathPart:
    """A straight part (`sense` 0) from a point along a direction angle, or an arc about a centre from a polar angle.

    It is `off` from the plane at its start, and rises from it by `rise` per length in the plane.
    """

    origin: Array
    angle: float
    length: float
    radius: float = 0.0
    sense: int = 0
    on: str = ""
    rise: float = 0.0
    off: float = 0.0

    @property
    def slant(self) -> float:
        """Length per length in the plane."""
        return float(np.hypot(1, self.rise))

    @property
    def end_off(self) -> float:
        """Distance from the plane at the part's end [m]."""
        return self.off + self.rise * self.length / self.slant

    def at(self, s: Array) -> tuple[Array, Array]:
        """Return points in the plane and unit tangents there (ns, 2) at arc lengths s (ns,) from the part's start."""
        s = s / self.slant
        if self.sense == 0:
            u = np.array([np.cos(self.angle), np.sin(self.angle)])
            return self.origin + s[:, None] * u, np.tile(u, (s.size, 1))
        polar = self.angle + self.sense * s / self.radius
        radial = np.stack([np.cos(polar), np.sin(polar)], axis=1)
        tangent = self.sense * np.stack([-radial[:, 1], radial[:, 0]], axis=1)
        return self.origin + self.radius * radial, tangent


@dataclass(frozen=True)
class RopePath:
    """Straight parts and arcs, one after another."""

    parts: tuple[PathPart, ...]

    @property
    def length(self) -> float:
        """Length along the rope's centre line [m]."""
        return sum(part.length for part in self.parts)

    @property
    def wraps(self) -> dict[str, float]:
        """Angle [rad] of the arc on each circle."""
        return {part.on: part.length / part.slant / part.radius for part in self.parts if part.sense}

    def at(self, s: Array) -> tuple[Array, Array]:
        """Return points in the plane and unit tangents there (ns, 2) at arc lengths s (ns,) of the path."""
        places, tangents = np.zeros((2, s.size, 2))
        for part, own, along in self._split(s):
            places[own], tangents[own] = part.at(along)
        return places, tangents

    def off(self, s: Array) -> tuple[Array, Array]:
        """Return distances from the plane (ns,) [m], and rises per length in it (ns,), at arc lengths s (ns,)."""
        places, rises = np.zeros((2, s.size))
        for part, own, along in self._split(s):
            places[own], rises[own] = part.off + part.rise * along / part.slant, part.rise
        return places, rises

    def _split(self, s: Array) -> Iterator[tuple[PathPart, Array, Array]]:
        """Yield the parts, the mask of arc lengths (ns,) on each, and these lengths from its start."""
        ends = np.cumsum([part.length for part in self.parts])
        which = np.minimum(np.searchsorted(ends, s, side="left"), len(self.parts) - 1)
        for i, part in enumerate(self.parts):
            own = which == i
            yield part, own, s[own] - (ends[i] - part.length)

    def spans(self) -> list[tuple[str, float, float]]:
        """Return the circle and ends of the arc length [m] of every arc."""
        ends = np.cumsum([part.length for part in self.parts])
        return [
            (p.on, float(e - p.length), float(e)) for p, e in zip(self.parts, ends, strict=True) if p.sense
        ]


def taut_path(owner: str, circles: Sequence[PathCircle], closed: bool = False) -> RopePath:
    """Return the path over circles in the given order; senses that are not given follow the shortest path.

    A closed one starts where it leaves the first circle and ends there.

    Raises
    ------
    ModelError
        Fewer than two circles or points, circles that overlap, a straight part that cuts a circle.
    """
    if len(circles) < 2:
        raise ModelError(f"{owner}: the path has {len(circles)} entry; give two or more")
    unknown = [i for i, c in enumerate(circles) if c.radius and not c.sense]
    if len(unknown) > MOST_SENSES:
        raise ModelError(
            f"{owner}: the sense of wrap of {len(unknown)} sheaves is undetermined; "
            "give it as ('name', +1) or ('name', -1)"
        )
    best: RopePath | None = None
    trouble: ModelError | None = None
    for senses in product((1, -1), repeat=len(unknown)):
        signs = [c.sense for c in circles]
        for i, sense in zip(unknown, senses, strict=True):
            signs[i] = sense
        try:
            path = (_closed if closed else _path)(owner, circles, signs)
        except ModelError as error:
            trouble = trouble or error
            continue
        if best is None or path.length < best.length * (1 - 1e-12):
            best = path
    if best is None:
        assert trouble is not None
        raise trouble
    return best


def _path(owner: str, circles: Sequence[PathCircle], signs: Sequence[int]) -> RopePath:
    angles = [
        _direction(owner, a, b, sa, sb)
        for a, b, sa, sb in zip(circles[:-1], circles[1:], signs[:-1], signs[1:], strict=True)
    ]
    parts: list[PathPart] = []
    for i, (circle, sense) in enumerate(zip(circles, signs, strict=True)):
        arriving = angles[i - 1] if i else None
        leaving = angles[i] if i < len(angles) else None
        arc = _arc(circle, sense, arriving, leaving)
        if arc is not None:
            parts.append(arc)
        if leaving is not None:
            parts.append(_straight(circles[i : i + 2], signs[i : i + 2], leaving))
            _check_clear(owner, parts[-1], circles, (i, i + 1))
    return RopePath(tuple(part for part in parts if part.length > 0))


def _closed(owner: str, circles: Sequence[PathCircle], signs: Sequence[int]) -> RopePath:
    """Return the path around all circles and back to the first."""
    n = len(circles)
    pairs = [(i, (i + 1) % n) for i in range(n)]
    angles = [_direction(owner, circles[i], circles[j], signs[i], signs[j]) for i, j in pairs]
    parts: list[PathPart] = []
    for i, j in pairs:
        parts.append(_straight((circles[i], circles[j]), (signs[i], signs[j]), angles[i]))
        _check_clear(owner, parts[-1], circles, (i, j))
        arc = _arc(circles[j], signs[j], angles[i], angles[j])
        if arc is not None:
            parts.append(arc)
    return RopePath(tuple(part for part in parts if part.length > 0))


def _direction(owner: str, a: PathCircle, b: PathCircle, sense_a: int, sense_b: int) -> float:
    """Return the angle of the common tangent from circle a to circle b that fits both senses."""
    D = b.centre - a.centre
    distance = float(np.hypot(*D))
    offset = sense_a * a.radius - sense_b * b.radius
    if distance <= abs(offset) or distance == 0:
        raise ModelError(
            f"{owner}: '{a.name}' and '{b.name}' overlap for the rope ({distance:.4g} m between their centres, "
            f"{abs(offset):.4g} m needed); move them apart, or give another sense of wrap"
        )
    return float(np.arctan2(D[1], D[0]) + np.arcsin(offset / distance))


def _polar(sense: int, direction: float) -> float:
    """Return the polar angle of the point of a circle at which the rope runs in a direction."""
    return direction - sense * np.pi / 2


def _arc(circle: PathCircle, sense: int, arriving: float | None, leaving: float | None) -> PathPart | None:
    if circle.radius == 0:
        return None
    if arriving is None or leaving is None:
        angle = 2 * np.pi * circle.turns
    else:
        angle = float(np.mod(sense * (leaving - arriving), 2 * np.pi))
        angle = 0.0 if 2 * np.pi - angle < 1e-9 else angle
    if arriving is not None:
        start = _polar(sense, arriving)
    else:
        assert leaving is not None
        start = _polar(sense, leaving) - sense * angle
    return PathPart(circle.centre, start, angle * circle.radius, circle.radius, sense, circle.name)


def _straight(pair: Sequence[PathCircle], signs: Sequence[int], angle: float) -> PathPart:
    normal = np.array([np.sin(angle), -np.cos(angle)])
    p, q = (c.centre + s * c.radius * normal for c, s in zip(pair, signs, strict=True))
    return PathPart(p, angle, float(np.hypot(*(q - p))))


def _check_clear(owner: str, line: PathPart, circles: Sequence[PathCircle], own: tuple[int, int]) -> None:
    """Check that no straight part runs through a circle that it does not touch."""
    u = np.array([np.cos(line.angle), np.sin(line.angle)])
    for i, circle in enumerate(circles):
        if i in own or circle.radius == 0:
            continue
        along = float(np.clip((circle.centre - line.origin) @ u, 0.0, line.length))
        distance = float(np.hypot(*(circle.centre - line.origin - along * u)))
        if distance < circle.radius * (1 - NEARLY):
            raise ModelError(
                f"{owner}: between '{circles[own[0]].name}' and '{circles[own[1]].name}' the rope would run through "
                f"'{circle.name}' ({distance:.4g} m from its centre, radius {circle.radius:.4g} m); put it "
                "into the path, or move it"
            )
