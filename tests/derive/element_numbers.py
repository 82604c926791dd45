"""Elements with numbers: 50 digits, random parameters and coordinates, superposed motions."""

import decimal
import random
from collections.abc import Callable, Sequence
from copy import copy
from decimal import Decimal
from functools import cache
from typing import Any

import mpmath
import pytest
from mpmath import cos, mpf, sin

from flexel.derive.declare import (
    Element,
)
from flexel.derive.spec import ElementSpec
from flexel.derive.verify import definitions
from flexel.derive.verify.definition import Definition
from flexel.generated.table import ELEMENTS

mpmath.mp.dps = 50
decimal.getcontext().prec = 50
TINY = mpf(10) ** -35

Vector = list[Any]


def named(name: str) -> Element:
    """The definition of an element."""
    found = definitions()[name]
    assert isinstance(found, Element)
    return found


def every(names: list[str]) -> pytest.MarkDecorator:
    """The test for the definition of each element; the formulas are imported when the first one runs."""
    return pytest.mark.parametrize("element", names, indirect=True)


with_deformations = every([name for name, element in ELEMENTS.items() if element.deformations])
with_slips = every([name for name, element in ELEMENTS.items() if element.slips])
with_mass = every([name for name, element in ELEMENTS.items() if "inertia" in element.kernels])
beams = pytest.mark.parametrize("name", ["beam", "beam_first_order", "beam_logarithmic"])
planar_beams = pytest.mark.parametrize("name", ["planar_beam", "planar_beam_first_order"])


def column(rng: random.Random, size: int) -> Vector:
    return [mpf(rng.uniform(-1, 1)) for _ in range(size)]


def unit(values: Vector) -> Vector:
    length = mpmath.sqrt(sum(v * v for v in values))
    return [v / length for v in values]


def dot(a: Vector, b: Vector) -> Any:
    return mpmath.fdot(a, b)


def cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a: Vector, b: Vector, factor: Any = 1) -> Vector:
    return [i + factor * j for i, j in zip(a, b, strict=True)]


def product(a: Vector, b: Vector) -> Vector:
    vector = plus(plus(cross(a[1:], b[1:]), b[1:], a[0]), a[1:], b[0])
    return [a[0] * b[0] - dot(a[1:], b[1:]), *vector]


def conjugate(a: Vector) -> Vector:
    return [a[0], -a[1], -a[2], -a[3]]


def rotated(q: Vector, a: Vector) -> Vector:
    return product(product(q, [0, *a]), conjugate(q))[1:]


def rotation(axis: Vector, angle: Any) -> Vector:
    return [cos(angle / 2), *(sin(angle / 2) * a for a in axis)]


X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]


def sheared(l0: Any, phi_y: Any, phi_z: Any = 0) -> dict[str, Any]:
    """Stiffnesses of a beam that give these shear numbers 12 EI/(GA l0^2)."""
    return {"EIz": phi_y * l0**2 / 12, "EIy": phi_z * l0**2 / 12, "GAy": mpf(1), "GAz": mpf(1)}


class Numbers(Definition):
    """The functions of an element, of numbers of mpmath."""

    def D(self, x: Vector) -> Vector:
        return many(super().D(decimals(x)))

    def s(self, x: Vector, v: Vector) -> Vector:
        return many(super().s(decimals(x), decimals(v)))

    def T(self, x: Vector, v: Vector) -> Any:
        return many([super().T(decimals(x), decimals(v))])[0]

    def U(self, x: Vector) -> Any:
        return many([super().U(decimals(x))])[0]


def decimals(values: Vector) -> list[Decimal]:
    return [Decimal(str(value)) for value in values]


def many(values: list[Decimal]) -> Vector:
    return [mpf(str(value)) for value in values]


@cache
def _compiled(element: Element) -> Numbers:
    return Numbers(element)


def numbers(element: Element, **values: Any) -> Definition:
    """Return the element's functions with parameters: those named; others are zero, or one if they must be positive."""
    definition = copy(_compiled(element))  # with parameters of its own
    p: Vector = []
    for parameter in element.parameters:
        value = values.get(parameter.name, [int(parameter.sign == "positive")] * parameter.size)
        p += [mpf(v) for v in (value if isinstance(value, Sequence) else [value])]
    assert len(p) == len(element.parameter_symbols)
    definition.p = decimals(p)
    return definition


def random_parameters(element: Element, rng: random.Random) -> dict[str, Any]:
    values: dict[str, Any] = {}
    for parameter in element.parameters:
        if parameter.name in (
            "radius_p",
            "radius_q",
        ):  # pulleys and gears that are smaller than their distance
            values[parameter.name] = mpf(rng.uniform(0.01, 0.05))
        elif parameter.size == 1:
            values[parameter.name] = mpf(rng.uniform(0.5, 1.5))
        elif parameter.unit == "1":
            values[parameter.name] = unit(column(rng, parameter.size))
        else:
            values[parameter.name] = column(rng, parameter.size)
    if element.name == "surface":  # of revolution about z
        a, b, c = column(rng, 3)
        values |= {"quadratic": [a, a, b, 0, 0, 0], "linear": [0, 0, c]}
    return values


def random_coordinates(element: Element, rng: random.Random) -> Vector:
    x: Vector = []
    for node in element.nodes:
        values = column(rng, node.size)
        x += unit(values) if node.kind == "frame" else values
    return x


class Motion:
    """A rigid motion: rotation about an axis through the origin, then translation; constant velocities.

    In the plane the axis is z. It maps coordinates to coordinates, and gives the rates of nodes at rest in
    it.
    """

    def __init__(self, axis: Vector, angle: Any, shift: Vector, omega: Vector, velocity: Vector) -> None:
        self.q, self.angle, self.shift = rotation(axis, angle), angle, shift
        self.omega, self.velocity = omega, velocity

    def _nodes(self, element: Element, x: Vector) -> list[tuple[str, Vector]]:
        parts, start = [], 0
        for node in element.nodes:
            parts.append((node.kind, x[start : start + node.size]))
            start += node.size
        return parts

    def moved(self, element: Element, x: Vector, rates: bool = False) -> Vector:
        """Coordinates (or rates) after the motion."""
        result: Vector = []
        for kind, value in self._nodes(element, x):
            if kind == "frame":
                result += product(self.q, value)
            elif kind == "planar_angle":
                result += value if rates else [value[0] + self.angle]
            elif kind == "warping":
                result += value
            else:
                turned = rotated(self.q, [*value, 0][:3])
                free = rates or kind.endswith("slope")
                result += (turned if free else plus(turned, self.shift))[: len(value)]
        return result

    def rigid_rates(self, element: Element, x: Vector) -> Vector:
        """Rates of nodes that take part in the motion with angular velocity omega and velocity at the origin."""
        result: Vector = []
        for kind, value in self._nodes(element, x):
            if kind == "frame":
                result += [c / 2 for c in product([0, *self.omega], value)]
            elif kind == "planar_angle":
                result.append(self.omega[2])
            elif kind == "warping":
                result.append(mpf(0))
            else:
                turning = cross(self.omega, [*value, 0][:3])
                result += (turning if kind.endswith("slope") else plus(self.velocity, turning))[: len(value)]
        return result


def is_planar(element: Element | ElementSpec) -> bool:
    return all(node.kind.startswith("planar") for node in element.nodes)


def symmetry(element: Element, values: dict[str, Any], rng: random.Random) -> Motion:
    """Return a rigid motion that the element cannot notice: any, or for a wheel one that keeps the road."""
    if "heading" in values:  # waves: only along their crests
        across = [-values["heading"][1], values["heading"][0], 0]
        shift, velocity = ([mpf(rng.uniform(-1, 1)) * component for component in across] for _ in range(2))
        return Motion(Z, mpf(0), shift, [0, 0, 0], velocity)
    axis, omega = unit(column(rng, 3)), column(rng, 3)
    shift, velocity = column(rng, 3), column(rng, 3)
    if element.name == "surface":
        return Motion(Z, mpf(rng.uniform(-3, 3)), [0, 0, 0], [0, 0, omega[2]], [0, 0, 0])
    normal = Z if is_planar(element) else values.get("normal")
    if normal:
        axis, omega = normal, [omega[0] * n for n in normal]
        shift, velocity = (plus(u, normal, -dot(u, normal)) for u in (shift, velocity))
    most = 0.1 if element.name == "planar_belt" else 3  # its line of centres turns by less than half a turn
    return Motion(axis, mpf(rng.uniform(-most, most)), shift, omega, velocity)


def rates_of_deformations(d: Definition, x: Vector, v: Vector) -> Vector:
    h = mpf(10) ** -16
    ahead, behind = d.D(plus(x, v, h)), d.D(plus(x, v, -h))
    return [(a - b) / (2 * h) for a, b in zip(ahead, behind, strict=True)]


def equal(a: Vector, b: Vector, tolerance: Any = TINY) -> bool:
    return len(a) == len(b) and all(abs(i - j) <= tolerance for i, j in zip(a, b, strict=True))


def as_seen(element: Element, e: Vector, turn: Callable[[Vector], Vector]) -> Vector:
    """Deformations after a motion: the three curvature vectors of a spatial cable turn, all others stay."""
    if element.name != "cable":
        return e
    return [*e[:3], *(c for i in (3, 6, 9) for c in turn(e[i : i + 3]))]


def straight(rng: random.Random) -> tuple[dict[str, Any], dict[str, Vector]]:
    """Return parameters and the place of a straight line of nodes p, q with body frames turned at random."""
    l0 = mpf(rng.uniform(0.5, 1.5))
    tp, tq = unit(column(rng, 4)), unit(column(rng, 4))
    values = {"l0": l0, "tp": tp, "tq": tq, "d0": [l0, 0, 0]}
    places = {"p": [0, 0, 0], "q": [l0, 0, 0], "rp": conjugate(tp), "rq": conjugate(tq)}
    return values, places | {"wp": [mpf(0)], "wq": [mpf(0)]}
