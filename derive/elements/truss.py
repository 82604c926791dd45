"""Bar between two points, in space and in the plane."""

import sympy as sp

from flexel.derive.declare import Deformation, Element, Let, Node, Parameter, PlanarPoint, Point
from flexel.derive.declare.rotation import dot, norm
from flexel.derive.declare.shape import linear_energy
from flexel.derive.elements.shared_parameters import GRAVITY, L0, PLANAR_GRAVITY, RHOA


def _truss(name: str, p: Node, q: Node, gravity: Parameter, span: str) -> Element:
    let = Let()
    l0, mass = L0.symbol, RHOA.symbol * L0.symbol
    l = let.scalar("l", norm(let.vector("d", q.x - p.x)))  # noqa: E741 (the mathematics' letter)
    return Element(
        name=name,
        family="truss",
        picture="bar",
        span=span,
        nodes=(p, q),
        parameters=(L0, RHOA, gravity),
        let=let.entries,
        deformations=(Deformation("elongation", "m", l - l0),),
        kinetic_energy=mass * linear_energy(p.v, q.v) / 6,
        potential=-mass * dot(gravity.vector, p.x + q.x) * sp.Rational(1, 2),
        doc=(
            "elongation = |xq - xp| - l0\n"
            "T = rhoA l0/6 (vp.vp + vp.vq + vq.vq), uniform bar\n"
            "U = -rhoA l0 gravity.(xp + xq)/2"
        ),
        source="van der Werff and Jonker 1984, NATO ASI F9, p. 381",
    )


TRUSS = _truss("truss", Point("p"), Point("q"), GRAVITY, "bar_span")
PLANAR_TRUSS = _truss("planar_truss", PlanarPoint("p"), PlanarPoint("q"), PLANAR_GRAVITY, "planar_bar_span")
