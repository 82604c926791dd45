"""Linkages of bars that follow one angle, also through their change points, with their motion from one equation.

The position of each point is a formula in the angle.  With T = M(phi) phi'^2 / 2 and the weight of the bars,
M phi'' = -M' phi'^2 / 2 - V'.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.base.arrays import Array

G = 9.81
PHI = sp.Symbol("phi", real=True)
Place = tuple[Any, ...]

Bar = tuple[str, str]


def on_circle(radius: float, centre: float = 0.0, angle: Any = PHI) -> Place:
    """The end of a crank on the axis."""
    return centre + radius * sp.cos(angle), radius * sp.sin(angle)


def mirrored(point: Place, p: Place, q: Place) -> Place:
    """A point of the plane, mirrored in the line through two others."""
    ux, uy = q[0] - p[0], q[1] - p[1]
    share = 2 * ((point[0] - p[0]) * ux + (point[1] - p[1]) * uy) / (ux**2 + uy**2)
    return 2 * p[0] + share * ux - point[0], 2 * p[1] + share * uy - point[1]


def crossed(radius: float, base: float, centre: float = 0.0, angle: Any = PHI) -> Place:
    """The end of the other crank of an antiparallelogram: that of the parallelogram, mirrored in a diagonal."""
    tip = on_circle(radius, centre, angle)
    return mirrored((tip[0] + base, tip[1]), tip, (centre + base, 0.0))


def kite(short: float, long: float) -> Place:
    """The fourth point of a kite, on the bisector of the angle between its short sides."""
    reach = short * sp.cos(PHI / 2) + sp.sqrt(long**2 - short**2 * sp.sin(PHI / 2) ** 2)
    return reach * sp.cos(PHI / 2), reach * sp.sin(PHI / 2)


@dataclass(frozen=True)
class Linkage:
    """Bars between points whose places are known for one angle.

    Attributes
    ----------
    places : mapping of str to (expression, …)
        By the angle PHI; constants are fixed points.
    bars : sequence of (str, str)
        One kilogram per metre each.
    start : float
        The angle at the start [rad].
    rigid : mapping of (str, str) to (str, str)
        More bars, each with the one that it turns with, as in a body.
    gravity : tuple of float
    """

    places: Mapping[str, Place]
    bars: Sequence[Bar]
    start: float
    rigid: Mapping[Bar, Bar] = field(default_factory=dict)
    gravity: tuple[float, ...] = (0.0, -G)

    def system(self) -> fx.System:
        """The linkage as drawn at its start."""
        return self.model().build()

    def model(self) -> fx.Model:
        """The same, to which more can be added."""
        m = self.points()
        angles = {}
        for p, q in [*self.bars, *self.rigid]:
            host = self.rigid.get((p, q))
            angle = angles[host] if host else m.angle(f"R{p}{q}")
            angles[p, q] = angle
            m.beam(f"bar {p}{q}", p, angle, q, mass_per_length=1.0)
        return m

    def points(self) -> fx.Model:
        """A model with the points alone."""
        m = fx.Model(gravity=self.gravity)
        for name, place in self.places.items():
            fixed = not any(sp.sympify(component).has(PHI) for component in place)
            m.point(name, self.drawn[name], fixed=fixed)
        return m

    @property
    def drawn(self) -> dict[str, tuple[float, ...]]:
        """The places at the start."""
        return {name: tuple(map(float, place)) for name, place in self.at(self.start).items()}

    def at(self, angles: Any) -> dict[str, tuple[Array, ...]]:
        """The places (times,) of all points at some angles."""
        some = np.asarray(angles)
        return {
            name: tuple(f(some) * np.ones_like(some) for f in functions)
            for name, functions in self._functions.items()
        }

    @cached_property
    def _functions(self) -> dict[str, list[Callable[[Array], Array]]]:
        return {
            name: [sp.lambdify(PHI, component) for component in place] for name, place in self.places.items()
        }

    @cached_property
    def _equation(self) -> Callable[[float], tuple[float, float, float]]:
        """M, M' and V' at an angle."""
        M: Any = sp.Integer(0)
        V: Any = sp.Integer(0)
        for p, q in [*self.bars, *self.rigid]:
            a, b = (sp.Matrix(self.places[name]) for name in (p, q))
            mass = float(np.linalg.norm(np.subtract(self.drawn[p], self.drawn[q])))
            da, db = a.diff(PHI), b.diff(PHI)
            M += mass / 3 * (da.dot(da) + da.dot(db) + db.dot(db))
            V -= mass * (a + b).dot(sp.Matrix(self.gravity)) / 2
        found: Callable[[float], tuple[float, float, float]] = sp.lambdify(
            PHI, [M, M.diff(PHI), V.diff(PHI)], cse=True
        )
        return found

    def rate(self, name: str) -> float:
        """The rate of a coordinate ("A.x") at the start for a unit rate of the angle."""
        point, axis = name.split(".")
        return float(self.places[point]["xyz".index(axis)].diff(PHI).subs(PHI, self.start))

    def follow(self, rate: float, times: Array) -> Array:
        """The angle at some times, from the start with a rate."""

        def rates(t: float, y: Array) -> list[float]:
            M, dM, dV = self._equation(float(y[0]))
            return [y[1], -(dM * y[1] ** 2 / 2 + dV) / M]

        found = solve_ivp(
            rates, (0, times[-1]), [self.start, rate], method="DOP853", rtol=2.3e-14, atol=1e-14, t_eval=times
        )
        return np.asarray(found.y[0])

    def error(self, motion: fx.Motion, angles: Array) -> float:
        """The largest distance of a point of a motion from its place."""
        return max(
            float(
                np.max(
                    np.linalg.norm(
                        [motion[f"{name}.{a}"] - values for a, values in zip("xyz", place, strict=False)],
                        axis=0,
                    )
                )
            )
            for name, place in self.at(angles).items()
        )


def parallel(pitches: Sequence[float], start: float = np.pi / 2) -> Linkage:
    """Cranks of length one and couplers as long as the distances of their pivots."""
    pivots = np.concatenate([[0.0], np.cumsum(pitches)]).tolist()
    places: dict[str, Place] = {}
    for i, x in enumerate(pivots):
        places[f"O{i}"], places[f"A{i}"] = (x, 0.0), on_circle(1.0, x)
    cranks = [(f"O{i}", f"A{i}") for i in range(len(pivots))]
    couplers = [(f"A{i}", f"A{i + 1}") for i in range(len(pivots) - 1)]
    return Linkage(places, cranks + couplers, start)


def _crossed_pair() -> Linkage:
    places = {"O": (0.0, 0.0), "P": (2.0, 0.0), "A": on_circle(0.8), "B": crossed(0.8, 2.0)}
    return Linkage(places, [("O", "A"), ("A", "B"), ("P", "B")], 1.2)


def _parallel_and_crossed() -> Linkage:
    places = {
        "O": (0.0, 0.0),
        "P": (1.5, 0.0),
        "Q": (3.7, 0.0),
        "A": on_circle(0.8),
        "B": on_circle(0.8, 1.5),
    }
    places["C"] = crossed(0.8, 2.2, 1.5)
    return Linkage(places, [("O", "A"), ("A", "B"), ("P", "B"), ("B", "C"), ("Q", "C")], 1.2)


def _three_crossed() -> Linkage:
    """Antiparallelograms on both sides of a crank, and a parallelogram beside them."""
    places = {"O": (0.0, 0.0), "P": (2.0, 0.0), "Q": (-2.5, 0.0), "R": (1.2, 0.0), "A": on_circle(0.8)}
    places |= {"B": crossed(0.8, 2.0), "C": crossed(0.8, -2.5), "D": on_circle(0.8, 1.2)}
    bars = [("O", "A"), ("A", "B"), ("P", "B"), ("A", "C"), ("Q", "C"), ("A", "D"), ("R", "D")]
    return Linkage(places, bars, 1.2)


def _kite() -> Linkage:
    places = {"O": (0.0, 0.0), "P": (1.0, 0.0), "A": on_circle(1.0), "B": kite(1.0, 2.0)}
    return Linkage(places, [("O", "A"), ("A", "B"), ("P", "B")], 1.5)


def _kite_and_parallel() -> Linkage:
    """Galloway's mechanism whose crank drives a parallelogram with another pitch."""
    places = {"O": (0.0, 0.0), "P": (1.0, 0.0), "Q": (-1.7, 0.0), "A": on_circle(1.0), "B": kite(1.0, 2.0)}
    places["C"] = on_circle(1.0, -1.7)
    return Linkage(places, [("O", "A"), ("A", "B"), ("P", "B"), ("A", "C"), ("Q", "C")], 1.5)


def _two_throws() -> Linkage:
    """Two parallelograms on one shaft, a quarter of a turn apart: they are flat at different times."""
    later = PHI + sp.pi / 2
    places = {
        "O": (0.0, 0.0),
        "P": (1.4, 0.0),
        "Q": (-1.1, 0.0),
        "A": on_circle(0.7),
        "B": on_circle(0.7, 1.4),
    }
    places |= {"C": on_circle(0.5, 0.0, later), "D": on_circle(0.5, -1.1, later)}
    bars = [("O", "A"), ("A", "B"), ("P", "B"), ("C", "D"), ("Q", "D")]
    return Linkage(places, bars, 1.0, {("O", "C"): ("O", "A")})


def _watt(crossed_over: bool) -> Linkage:
    """Watt's chain: a parallelogram whose coupler and rocker are two sides of another loop about their common pin."""
    places = {"O": (0.0, 0.0), "P": (1.4, 0.0), "A": on_circle(0.7), "B": on_circle(0.7, 1.4)}
    bx, by = places["B"]
    places["C"], places["D"] = (
        (bx + 0.9, by),
        on_circle(1.2, 1.4),
    )  # on the coupler and on the rocker, beyond B
    across = bx + 0.9 + 0.5 * sp.cos(PHI), by + 0.5 * sp.sin(PHI)
    places["E"] = mirrored(across, places["C"], places["D"]) if crossed_over else across
    bars = [("O", "A"), ("A", "B"), ("P", "B"), ("C", "E"), ("D", "E")]
    return Linkage(places, bars, 1.1, {("B", "C"): ("A", "B"), ("B", "D"): ("P", "B")})


LINKAGES: dict[str, Callable[[], Linkage]] = {
    "antiparallelogram": _crossed_pair,
    "parallelogram and antiparallelogram": _parallel_and_crossed,
    "two antiparallelograms and a parallelogram": _three_crossed,
    "kite": _kite,
    "kite and parallelogram": _kite_and_parallel,
    "two throws": _two_throws,
    "Watt's chain with two parallelograms": lambda: _watt(False),
    "Watt's chain with an antiparallelogram": lambda: _watt(True),
    "other pitches": lambda: parallel([1.3, 0.7, 2.1]),
}
