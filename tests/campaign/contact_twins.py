"""Contact of ropes written again: gaps of the points of a cable from surfaces on a body, and the forces there.

A surface sees a point by its place y in axes fixed in the body. How y changes is differentiated by a complex step, so
that no velocity is written down.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from campaign.algebra import norm
from campaign.elastic import Stressed
from campaign.oracle import jacobian
from campaign.rope_twins import on_arc
from flexel.base.arrays import Array

RELEASE = 1e3  # rate [1/s] at which bristles straighten while the gap is open


@dataclass(frozen=True)
class Gap:
    """One gap of a surface: its name, its size (…) at y (3, …), directions of sliding (k, 3) at y (3,)."""

    name: str
    size: Callable[[Array, float], Array]
    slides: Callable[[Array], Array]
    slips: tuple[str, ...]


def _round(y: Array) -> tuple[Array, Array, Array]:
    """Distance from the axle, which is the first axis; the unit vectors away from it and around it (3,)."""
    r = norm(y[1:])
    return r, np.array([0 * r, y[1] / r, y[2] / r]), np.array([0 * r, -y[2] / r, y[1] / r])


def cylinder(radius: float) -> list[Gap]:
    """A cylinder about the first axis."""

    def slides(y: Array) -> Array:
        return np.array([_round(y)[2], [1.0, 0.0, 0.0]])

    return [Gap("gap", lambda y, a: norm(y[1:]) - radius - a, slides, ("tangential", "axial"))]


def vee(radius: float, opening: float) -> list[Gap]:
    """Two flanks that a rope touches when its centre is at the radius and in the middle."""
    s, c = np.sin(opening / 2), np.cos(opening / 2)

    def flank(sign: float) -> Gap:
        def size(y: Array, a: float) -> Array:
            return s * (norm(y[1:]) - radius - a) - sign * c * y[0]

        def slides(y: Array) -> Array:
            _, away, around = _round(y)
            return np.array([around, c * away + sign * s * np.array([1.0, 0.0, 0.0])])

        which = "1" if sign > 0 else "2"
        return Gap("gap" + which, size, slides, ("tangential", "across" + which))

    return [flank(1.0), flank(-1.0)]


def round_groove(radius: float, bottom: float, opening: float) -> list[Gap]:
    """A groove with a round bottom and flanks that continue it."""
    s, c = np.sin(opening / 2), np.cos(opening / 2)

    def normal(y: Array) -> Array:
        """Direction (2, …) into the wall, by depth and sideways."""
        depth, side = radius + bottom - norm(y[1:]), y[0]
        sign = np.where(np.real(side) < 0, -1.0, 1.0)
        on_bottom = np.real(c * depth) > np.real(s * sign * side)
        w = np.sqrt(np.where(on_bottom, depth**2 + side**2, 1.0))
        return np.array([np.where(on_bottom, depth / w, s), np.where(on_bottom, side / w, c * sign)])

    def size(y: Array, a: float) -> Array:
        n = normal(y)
        return bottom - a - n[0] * (radius + bottom - norm(y[1:])) - n[1] * y[0]

    def slides(y: Array) -> Array:
        _, away, around = _round(y)
        n = normal(y)
        return np.array([around, n[0] * np.array([1.0, 0.0, 0.0]) + n[1] * away])

    return [Gap("gap", size, slides, ("tangential", "across"))]


def circle(radius: float) -> list[Gap]:
    """A circle in the plane."""

    def slides(y: Array) -> Array:
        return np.array([[-y[1], y[0]] / norm(y)])

    return [Gap("gap", lambda y, a: norm(y) - radius - a, slides, ("tangential",))]


def plane() -> list[Gap]:
    """The plane across the third axis."""
    return [Gap("gap", lambda y, a: y[2] - a, lambda y: np.eye(3)[:2] + 0 * y, ("x", "y"))]


def line() -> list[Gap]:
    """The line across the second axis of the plane."""
    return [Gap("gap", lambda y, a: y[1] - a, lambda y: np.eye(2)[:1] + 0 * y, ("tangential",))]


@dataclass(frozen=True)
class Body:
    """Where a surface is: its body's nodes, its axes as vectors fixed in the body, and whether it is in the plane."""

    nodes: tuple[str, str]
    axes: Sequence[Array]
    turned: Callable[[Array, Array], Array]

    def seen(self, x: Array, point: Array) -> Array:
        """Place (3, …) or (2, …) of a point on the axes, from the body's coordinates."""
        d = point - x[: len(point)]
        orientation = x[len(point) :]
        return np.array([(self.turned(orientation, e) * d).sum(0) for e in self.axes])


class RopeContact(Stressed):
    """The points of one cable over one surface of a body; coordinates of the cable, then of the body."""

    def __init__(
        self,
        names: Sequence[str],
        cable: Sequence[str],
        l0: float,
        body: Body,
        gaps: Sequence[Gap],
        radius: float,
        places: Array,
        shares: Array,
        law: Any,
    ) -> None:
        self.names, self.nodes = tuple(names), (*cable, *body.nodes)
        self.l0, self.body, self.gaps, self.radius = l0, body, gaps, radius
        self._places, self._stiffness, self.law = places, law.stiffness * shares, law
        self._bristles = law.friction > 0 and law.bristle_stiffness is not None
        each = [(name, gap) for name in names for gap in gaps]
        if self._bristles:
            self.states = tuple(f"{name} {g.name}.z_{i}" for name, g in each for i in range(len(g.slips)))
        self.conserves = not (law.friction or law.dissipation)

    def seen(self, x: Array, j: int) -> Array:
        """Place of the point j on the axes of the surface."""
        n = 4 * len(self.body.axes)
        return self.body.seen(x[n:], on_arc(x[:n], self._places[j], self.l0))

    def potential(self, x: Array) -> Array:
        total = np.zeros(x.shape[1:])
        power = self.law.exponent + 1
        for j, K in enumerate(self._stiffness):
            y = self.seen(x, j)
            for gap in self.gaps:
                g = gap.size(y, self.radius)
                pressed = np.real(g) < 0
                total = total + K * np.where(pressed, np.where(pressed, -g, 1.0) ** power, 0.0) / power
        return total

    def _each(
        self, x: Array, v: Array, z: Array
    ) -> list[tuple[str, Gap, float, float, Array, Array, Array, Array]]:
        """Name, gap, elastic and whole normal force, friction, rates of bristles, rows De and V of each contact."""
        found = []
        k = 0
        for j, K in enumerate(self._stiffness):
            y = self.seen(x, j)
            Jy = jacobian(lambda c, j=j: self.seen(c, j), x)
            for gap in self.gaps:
                g = float(gap.size(y, self.radius))
                De = jacobian(lambda c, gap=gap: gap.size(c, self.radius), y) @ Jy
                V = gap.slides(y) @ Jy
                s = V @ v
                elastic = K * max(-g, 0.0) ** self.law.exponent
                N = max(elastic * (1 - self.law.dissipation * float(De @ v)), 0.0)
                own = z[k : k + len(s)] if self._bristles else np.zeros(0)
                tau, zdot = self._friction(N, s, own, g < 0)
                k += len(own)
                found.append((self.names[j], gap, elastic, N, tau, zdot, De, V))
        return found

    def _friction(self, N: float, s: Array, z: Array, closed: bool) -> tuple[Array, Array]:
        law = self.law
        if not self._bristles:
            return law.friction * N * s / np.sqrt(s @ s + law.slip_speed**2), np.zeros(0)
        rate = s - law.bristle_stiffness * np.sqrt(s @ s) * z / law.friction if closed else -RELEASE * z
        return N * (law.bristle_stiffness * z + law.bristle_damping * rate), rate

    def force(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (no law depends on time)
        f = np.zeros_like(x)
        if self.conserves:
            return f
        for _, _, elastic, N, tau, _, De, V in self._each(x, v, z):
            f += (N - elastic) * De - tau @ V
        return f

    def zdot(self, x: Array, v: Array, z: Array, t: float) -> Array:  # noqa: ARG002 (no law depends on time)
        if not self._bristles:
            return np.zeros(0)
        return np.concatenate([rate for *_, rate, _, _ in self._each(x, v, z)])

    def stresses(self, x: Array, v: Array, z: Array, t: float) -> dict[str, float]:  # noqa: ARG002 (as force)
        """Normal forces and friction by the names of the model's quantities; both flanks act on one slip around."""
        found: dict[str, float] = {}
        for name, gap, _, N, tau, _, _, _ in self._each(x, v, z):
            found[f"{name}.{gap.name}"] = -N
            for slip, value in zip(gap.slips, tau, strict=True):
                key = f"{name}.{slip}"
                found[key] = found.get(key, 0.0) + float(value)
        return found
