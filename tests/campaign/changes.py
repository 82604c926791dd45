"""The same mechanism elsewhere and in other units: turned, shifted, mirrored, scaled in length, mass and time.

Every kind of part says here how its fields change (`changed`); the motion of the new model must be the
changed motion of the old one.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

import flexel as fx
from campaign.algebra import product, rotation
from campaign.case import Case, Node
from flexel.base.arrays import Array
from flexel.model.part import Part, kind_of
from flexel.parts.written import arguments_of

Declared = TypeVar("Declared", bound=Part[Any])
EXPONENTS = {"M": 0, "L": 1, "T": 2}


class Inapplicable(Exception):  # noqa: N818 (no error: a property that says nothing about a case)
    """A property that has nothing to say about a case; the text says why, and is counted."""


@dataclass(frozen=True)
class Change:
    """x' = shift + length R S x with a rotation R and, if mirrored, the reflection S of y.

    In the plane only the z component of `turn` may be used, and S reflects y as well.
    """

    turn: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    mirror: bool = False
    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0

    def size(self, unit: str, value: Any) -> Any:
        """A number (or several) of a unit such as ``M L2 T-2``; a function of time too."""
        powers = [(word[0], int(word[1:] or 1)) for word in unit.split()]
        factors = {"M": self.mass, "L": self.length, "T": self.time}
        factor = float(np.prod([factors[letter] ** n for letter, n in powers]))
        return self.factored(value, factor)

    def factored(self, value: Any, factor: float) -> Any:
        """A number or a function of time, times a factor; a function runs slower by the factor of time."""
        if isinstance(value, fx.Harmonic):
            a, w, phase, offset = value.amplitude, value.omega, value.phase, value.offset
            return fx.Harmonic(a * factor, w / self.time, phase, offset * factor)
        if isinstance(value, fx.Polynomial):
            return fx.Polynomial(tuple(c * factor / self.time**i for i, c in enumerate(value.coefficients)))
        if callable(value):
            raise Inapplicable(f"no change of {type(value).__name__}")
        return tuple(number * factor for number in value) if isinstance(value, tuple) else value * factor

    def vector(self, b: Any) -> Array:
        """A direction in global axes."""
        b = np.array(b, float)
        S = np.array([1.0, -1.0, 1.0])[: b.size] if self.mirror else np.ones(b.size)
        return np.asarray(rotation(np.array(self.turn))[: b.size, : b.size] @ (S * b))

    def axial(self, b: Any) -> Array:
        """An axis of rotation: a turn about it keeps its sign."""
        return -self.vector(b) if self.mirror else self.vector(b)

    def place(self, x: Any) -> Array:
        """A place."""
        return np.asarray(np.array(self.shift)[: len(x)] + self.length * self.vector(x))

    def body(self, b: Any) -> Array:
        """A vector in body axes [m]."""
        b = self.length * np.array(b, float)
        return b * np.array([1.0, -1.0, 1.0])[: b.size] if self.mirror else b

    def tensor(self, J: Any) -> Any:
        """An inertia tensor in body axes."""
        J = self.size("M L2", J)
        if not self.mirror or not isinstance(J, tuple) or len(J) < 6:
            return J
        return (*J[:3], -J[3], J[4], -J[5])

    def frame(self, lam: Any) -> Array:
        """Euler parameters, or their rates."""
        lam = np.array(lam, float)
        return product(np.array(self.turn), lam * (1, -1, 1, -1) if self.mirror else lam)

    @property
    def sign(self) -> float:
        """Of an angle in the plane."""
        return -1.0 if self.mirror else 1.0

    @property
    def heading(self) -> float:
        """Angle of the turn in the plane."""
        return float(2 * np.arctan2(self.turn[3], self.turn[0]))

    def values(self, node: Node, x: Array) -> Array:
        """Coordinates of a node."""
        if node.kind == "point":
            return self.place(x)
        if node.kind == "slope":
            return self.vector(x)
        return self.frame(x) if node.kind == "frame" else self.heading + self.sign * x

    def rates(self, node: Node, v: Array, order: int = 1) -> Array:
        """First or second rates of the coordinates of a node."""
        if node.kind == "point":
            return self.length * self.vector(v) / self.time**order
        if node.kind == "slope":
            return self.vector(v) / self.time**order
        return (self.frame(v) if node.kind == "frame" else self.sign * v) / self.time**order


Changer = Callable[[Change, Any, Case], Part[Any]]
CHANGERS: dict[type[Part[Any]], Changer] = {}


def changer(*kinds: type[Part[Any]]) -> Callable[[Changer], Changer]:
    """Register how parts of these kinds change."""

    def register(function: Changer) -> Changer:
        CHANGERS.update(dict.fromkeys(kinds, function))
        return function

    return register


def changed(case: Case, change: Change) -> Case:
    """The case after a change.

    Raises
    ------
    Inapplicable
        If a part cannot be expressed after it.
    """
    parts = []
    for part in case.parts:
        if type(part) not in CHANGERS:
            raise Inapplicable(f"no change of a {kind_of(type(part))} is written down")
        parts.append(CHANGERS[type(part)](change, part, case))
    gravity = change.length / change.time**2 * change.vector(case.gravity)
    return replace(
        case, gravity=tuple(gravity.tolist()), parts=tuple(parts), duration=case.duration * change.time
    )


def having(part: Declared, **values: Any) -> Declared:
    """The part with other values of fields; those that it has by default stay as they are."""
    return replace(part, **{key: listed(value) for key, value in values.items() if key in arguments_of(part)})


def sized(change: Change, part: Declared, units: dict[str, str]) -> Declared:
    """The part with its fields that have a unit."""
    given = arguments_of(part)
    return having(part, **{key: change.size(unit, given[key]) for key, unit in units.items() if key in given})


def numbers(change: Change, values: Mapping[str, Any], units: Mapping[str, str]) -> dict[str, Any]:
    """The parameters of an element or a law, those changed that have a unit."""
    return {key: change.size(units[key], value) if key in units else value for key, value in values.items()}


def listed(value: Any) -> Any:
    """An array as a tuple; other values as they are."""
    return tuple(value.tolist()) if isinstance(value, np.ndarray) and value.ndim else value
