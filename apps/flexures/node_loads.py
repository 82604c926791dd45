"""Declares loads and prescribed motions of nodes, over time as the load parameter; see `Schedule`."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexel.apps.flexures.input_tables import node_owner
from flexel.apps.flexures.properties import NodeProperties
from flexel.base.arguments import number, unknown, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.time_functions import Polynomial, TimeFunction
from flexel.parts.model import Model
from flexel.results.flexure_step import frame_name, node_name

AXES = ("x", "y", "z")
PARALLEL_TOLERANCE = 1e-9  # tolerance for the axes of initial and further rotation


@dataclass(frozen=True)
class Schedule:
    """The shares of the initial loads and of the others over time, so that every step is reached from the drawn shape.

    Attributes
    ----------
    times : tuple of float
        From the unloaded mechanism to all loads; between them the shares grow evenly.
    initial, growing : tuple of float
        Shares at these times.
    """

    times: tuple[float, ...]
    initial: tuple[float, ...]
    growing: tuple[float, ...]

    def shares(self, t: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return the shares of the initial and of the growing loads at time t, and their rates."""
        i = min(max(bisect_right(self.times, t) - 1, 0), len(self.times) - 2)
        t0, t1 = self.times[i : i + 2]
        pairs = [(part[i], (part[i + 1] - part[i]) / (t1 - t0)) for part in (self.initial, self.growing)]
        (a, a_rate), (b, b_rate) = pairs
        return (a + a_rate * (t - t0), b + b_rate * (t - t0)), (a_rate, b_rate)


ONE_WAY = Schedule((-1.0, 0.0, 1.0), (0.0, 1.0, 1.0), (0.0, 0.0, 1.0))
BOTH_WAYS = Schedule((-3.0, -2.0, -1.0, 1.0), (0.0, 1.0, 1.0, 1.0), (0.0, 0.0, -1.0, 1.0))


@dataclass(frozen=True)
class Staged:
    """Grows by `initial` and `growth` as a schedule says; starts from `offset`."""

    initial: float
    growth: float
    schedule: Schedule
    offset: float = 0.0

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t."""
        (a, b), (a_rate, b_rate) = self.schedule.shares(t)
        value = self.offset + self.initial * a + self.growth * b
        return value, self.initial * a_rate + self.growth * b_rate, 0.0


@dataclass(frozen=True)
class HalfAngleSine:
    """The Euler parameter of a growing angle about an axis: its component times the sine of half the angle."""

    component: float
    angle: Staged

    def rates(self, t: float) -> tuple[float, float, float]:
        """Return value, first and second rate at time t."""
        angle, rate, _ = self.angle.rates(t)
        s, c = self.component * np.sin(angle / 2), self.component * np.cos(angle / 2)
        return float(s), float(c * rate / 2), float(-s * rate**2 / 4)


def load_node(m: Model, node: int, given: NodeProperties, schedule: Schedule) -> None:
    """Apply force, moment, prescribed displacement and rotation of a node."""
    owner, point, frame = node_owner(node), node_name(node), frame_name(node)
    held = [bool(component) for component in m.nodes[point].fixed]
    turned = [bool(component) for component in m.nodes[frame].fixed[1:]]
    moved = _pair(given.displacement_initial, given.displacement, owner, "displacement")
    rotated = _pair(given.rotation_initial, given.rotation, owner, "rotation")
    _contradictions(held, moved, owner, "displacement")
    _contradictions(turned, rotated, owner, "rotation")
    for i, (start, growth) in moved.items():
        place = float(m.nodes[point].x0[i])
        m.prescribe(f"{point}.{AXES[i]}", Staged(start, growth, schedule, place))
    for i, motion in _rotation(rotated, owner, schedule).items():
        m.prescribe(f"{frame}.lambda{i + 1}", motion)
    for what, target, fixed in (("force", point, held), ("moment", frame, turned)):
        parts = [_vector(getattr(given, key), owner, key) for key in (f"{what}_initial", what)]
        _act(m, target, fixed, parts, schedule, f"{owner}: {what}")


def _vector(given: Any, owner: str, what: str) -> Array:
    return np.zeros(3) if given is None else vector(given, owner, what, 3)


def _act(
    m: Model, target: str, fixed: list[bool], parts: list[Array], schedule: Schedule, owner: str
) -> None:
    """Apply a force or moment; refuse a load that a support would take, as it is probably a mistake."""
    values = [(float(a), float(b)) for a, b in zip(*parts, strict=True)]
    for axis, hold, value in zip(AXES, fixed, values, strict=True):
        if hold and any(value):
            raise ModelError(
                f"{owner} in {axis} acts on a fixed direction; drop it, or leave the direction free"
            )
    if any(component for value in values for component in value):
        m.load(target, [Staged(*value, schedule) if any(value) else 0.0 for value in values])


def _pair(initial: Any, further: Any, owner: str, what: str) -> dict[int, tuple[float, float]]:
    """Return initial value and growth of the prescribed components, by index."""
    a, b = _components(initial, owner, f"{what}_initial"), _components(further, owner, what)
    return {i: (a.get(i, 0.0), b.get(i, 0.0)) for i in sorted(a.keys() | b.keys())}


def _components(given: Any, owner: str, what: str) -> dict[int, float]:
    """Return the prescribed components among three, by index: from a mapping, or a list with None for free ones."""
    if given is None:
        return {}
    if isinstance(given, Mapping):
        for name in given:
            if name not in AXES:
                raise ModelError(f"{owner}: {what}: {unknown(str(name), AXES, 'axis')}")
        return {AXES.index(name): number(value, owner, f"{what} in {name}") for name, value in given.items()}
    if not isinstance(given, (list, tuple, np.ndarray)) or np.shape(np.asarray(given, dtype=object)) != (3,):
        raise ModelError(f"{owner}: {what} {given!r:.60}; give three numbers, None where free, or {{'x': …}}")
    return {
        i: number(value, owner, f"{what} in {AXES[i]}") for i, value in enumerate(given) if value is not None
    }


def _contradictions(
    fixed: list[bool], prescribed: dict[int, tuple[float, float]], owner: str, what: str
) -> None:
    for i in prescribed:
        if fixed[i]:
            raise ModelError(f"{owner}: {what} in {AXES[i]} is both fixed and prescribed; drop one of them")


def _rotation(
    parts: dict[int, tuple[float, float]], owner: str, schedule: Schedule
) -> dict[int, TimeFunction]:
    """Return Euler parameters lambda1 … lambda3 of the prescribed components of a rotation about one axis."""
    if not parts:
        return {}
    start, growth = np.array(list(parts.values())).T
    largest = max((start, growth, start + growth), key=lambda turn: float(np.linalg.norm(turn)))
    size = float(np.linalg.norm(largest))
    if size == 0.0:
        return {i: Polynomial((0.0,)) for i in parts}
    axis = largest / size
    across = max(float(np.linalg.norm(turn - (turn @ axis) * axis)) for turn in (start, growth))
    if across > PARALLEL_TOLERANCE * size:
        raise ModelError(
            f"{owner}: rotation and rotation_initial have different axes; give both about the same axis"
        )
    a, b = float(start @ axis), float(growth @ axis)
    farthest = max((a + share * b for share in schedule.growing), key=abs)
    if abs(farthest) >= np.pi:
        raise ModelError(
            f"{owner}: rotation of {farthest:.4g} rad; give less than half a turn (angles are in radians)"
        )
    return {
        i: HalfAngleSine(float(part), Staged(a, b, schedule)) for i, part in zip(parts, axis, strict=True)
    }
