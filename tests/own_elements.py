"""An element as a user declares it, for tests."""

from typing import Any

from flexel.derive import Deformation, Element, Let, Parameter, Point
from flexel.derive.declare.rotation import dot, norm


def own_bar(**changes: Any) -> Element:
    """The bar of the table, written once more."""
    p, q = Point("p"), Point("q")
    l0, mass = Parameter("l0", 1, "m", "length"), Parameter("mass", 1, "kg", "mass")
    gravity = Parameter("gravity", 3, "m/s^2", "gravity")
    let = Let()
    l = let.scalar("l", norm(let.vector("d", q.x - p.x)))
    fields = {
        "name": "own_bar",
        "nodes": (p, q),
        "parameters": (l0, mass, gravity),
        "let": let.entries,
        "deformations": (Deformation("elongation", "m", l - l0.symbol),),
        "kinetic_energy": mass.symbol * (dot(p.v, p.v) + dot(p.v, q.v) + dot(q.v, q.v)) / 6,
        "potential": -mass.symbol * dot(gravity.vector, p.x + q.x) / 2,
        "doc": "elongation = |q - p| - l0",
    }
    return Element(**(fields | changes))


P, Q = Point("p"), Point("q")


L0 = Parameter("l0", 1, "m", "length")
