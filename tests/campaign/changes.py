"""The same mechanism elsewhere and in other units: turned, shifted, mirrored, scaled in length, mass and time.

Every method of the model says here how its arguments change (`changed`); the motion of the new model must be the
changed motion of the old one.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from campaign.algebra import product, rotation
from campaign.calls import Call, Case, Made, Node
from flexel.base.arrays import Array

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
        powers = [(z[0], int(z[1:] or 1)) for z in unit.split()]
        factors = {"M": self.mass, "L": self.length, "T": self.time}
        factor = float(np.prod([factors[z] ** n for z, n in powers]))
        return self.factored(value, factor)

    def factored(self, value: Any, factor: float) -> Any:
        """A number or a function of time, times a factor; a function runs slower by the factor of time."""
        if isinstance(value, Made):
            if value.name == "Harmonic":
                a, w, *rest = value.args
                rest = [*rest[:1], *(z * factor for z in rest[1:])]
                return Made("Harmonic", (a * factor, w / self.time, *rest))
            if value.name == "Polynomial":
                return Made(
                    "Polynomial", (tuple(c * factor / self.time**i for i, c in enumerate(value.args[0])),)
                )
            raise Inapplicable(f"no change of {value.name}")
        return tuple(z * factor for z in value) if isinstance(value, tuple) else value * factor

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


Changer = Callable[[Change, Call, Case], Call]
CHANGERS: dict[str, Changer] = {}


def changer(*methods: str) -> Callable[[Changer], Changer]:
    """Register how the calls of these methods change."""

    def register(function: Changer) -> Changer:
        CHANGERS.update(dict.fromkeys(methods, function))
        return function

    return register


def changed(case: Case, change: Change) -> Case:
    """The case after a change.

    Raises
    ------
    Inapplicable
        If a call cannot be expressed after it.
    """
    calls = []
    for call in case.calls:
        if call.method not in CHANGERS:
            raise Inapplicable(f"no change of m.{call.method} is written down")
        calls.append(CHANGERS[call.method](change, call, case))
    gravity = change.length / change.time**2 * change.vector(case.gravity)
    return replace(
        case, gravity=tuple(gravity.tolist()), calls=tuple(calls), duration=case.duration * change.time
    )


def options(call: Call, **values: Any) -> Call:
    """The call with other options; those that it does not have are left out."""
    new = {
        key: z.tolist() if isinstance(z, np.ndarray) else z
        for key, z in values.items()
        if key in call.options
    }
    new = {key: tuple(z) if isinstance(z, list) else z for key, z in new.items()}
    return replace(call, options={**call.options, **new})
