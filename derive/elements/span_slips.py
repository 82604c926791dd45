"""Motion of the whole span of a bar, beam or cable as slips: the rate of the integral of position over the length.

They carry distributed loads: the stress of such a slip is minus the load per length in that direction, so that the
nodal forces are consistent with the interpolation, may depend on time, and have an exact tangent.
"""

from sympy import Matrix

from flexel.derive.declare import (
    Element,
    Frame,
    Let,
    Node,
    PlanarAngle,
    PlanarPoint,
    PlanarSlope,
    Point,
    Slip,
    Slope,
)
from flexel.derive.declare.rotation import HALF, product, triad_rate
from flexel.derive.declare.shape import hermite_mean
from flexel.derive.elements.planar_beam import ALPHA0, ALPHAQ0
from flexel.derive.elements.shared_parameters import L0, TP, TQ
from flexel.derive.elements.triads import named_directions

_SOURCE = "textbook mechanics (consistent nodal forces)"


def _slips(rate: Matrix) -> tuple[Slip, ...]:
    return tuple(Slip(axis, "m^2/s", rate[i], free=True) for i, axis in enumerate("xyz"[: rate.rows]))


def _bar_span(name: str, p: Node, q: Node) -> Element:
    return Element(
        name=name,
        family="span",
        nodes=(p, q),
        parameters=(L0,),
        slips=_slips(HALF * L0.symbol * (p.v + q.v)),
        doc="(x, y, z) = l0 (vp + vq)/2, rate of the integral of position over a straight bar",
        source=_SOURCE,
    )


def _beam_span() -> Element:
    p, rp, q, rq = Point("p"), Frame("rp"), Point("q"), Frame("rq")
    l0 = L0.symbol
    ends = [(product(r.x, t.vector), product(r.v, t.vector)) for r, t in ((rp, TP), (rq, TQ))]
    exd_p, exd_q = (triad_rate(u, ud)[0] for u, ud in ends)
    return Element(
        name="beam_span",
        family="span",
        nodes=(p, rp, q, rq),
        parameters=(L0, TP, TQ),
        slips=_slips(l0 * hermite_mean(p.v, l0 * exd_p, q.v, l0 * exd_q)),
        doc=(
            "(x, y, z) = l0 ((vp + vq)/2 + l0 (exdot_p - exdot_q)/12), rate of the integral of position over the\n"
            "beam's cubic Hermite interpolation; ex: first columns of R(lambda_p o tp), R(lambda_q o tq)"
        ),
        source=_SOURCE,
    )


def _cable_span(name: str, p: Node, dp: Node, q: Node, dq: Node) -> Element:
    l0 = L0.symbol
    return Element(
        name=name,
        family="span",
        nodes=(p, dp, q, dq),
        parameters=(L0,),
        slips=_slips(l0 * hermite_mean(p.v, l0 * dp.v, q.v, l0 * dq.v)),
        doc="l0 ((vp + vq)/2 + l0 (dpdot - dqdot)/12), rate of the integral of position over a cable's cubic curve",
        source=_SOURCE,
    )


def _planar_beam_span() -> Element:
    p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    l0 = L0.symbol
    let = Let()
    ey_p = named_directions(let, rp, ALPHA0, "p")[1]
    ey_q = named_directions(let, rq, ALPHAQ0, "q")[1]
    return Element(
        name="planar_beam_span",
        family="span",
        nodes=(p, rp, q, rq),
        parameters=(L0, ALPHA0, ALPHAQ0),
        let=let.entries,
        slips=_slips(l0 * hermite_mean(p.v, l0 * rp.v[0] * ey_p, q.v, l0 * rq.v[0] * ey_q)),
        doc=(
            "(x, y) = l0 ((vp + vq)/2 + l0 (exdot_p - exdot_q)/12), rate of the integral of position over the\n"
            "beam's cubic Hermite interpolation; ex: directions of the element at p and q"
        ),
        source=_SOURCE,
    )


BAR_SPAN = _bar_span("bar_span", Point("p"), Point("q"))
PLANAR_BAR_SPAN = _bar_span("planar_bar_span", PlanarPoint("p"), PlanarPoint("q"))
BEAM_SPAN = _beam_span()
PLANAR_BEAM_SPAN = _planar_beam_span()
CABLE_SPAN = _cable_span("cable_span", Point("p"), Slope("dp"), Point("q"), Slope("dq"))
PLANAR_CABLE_SPAN = _cable_span(
    "planar_cable_span", PlanarPoint("p"), PlanarSlope("dp"), PlanarPoint("q"), PlanarSlope("dq")
)
