"""Rigid three-node beam: two points and one orientation (SPACAR's PINBODY with a beam's mass)."""

from flexel.derive.declare import Deformation, Element, Frame, Let, Point
from flexel.derive.declare.rotation import HALF, body_angular_velocity, components, dot, product
from flexel.derive.declare.shape import linear_energy
from flexel.derive.elements.picture_outputs import LINK_DOC, axes, displacement
from flexel.derive.elements.shared_parameters import D0, GRAVITY, L0, RHOA, RHOJ, TP
from flexel.derive.elements.triads import named_quaternion, named_triad


def _beam3() -> Element:
    p, rp, q = Point("p"), Frame("rp"), Point("q")
    l0, mass = L0.symbol, RHOA.symbol * L0.symbol
    let = Let()
    u = named_quaternion(let, rp, TP, "p")
    d = let.vector("d", q.x - p.x)
    triad = named_triad(let, u, "p")
    relative = components(triad, d) - D0.vector
    w = let.vector("w_p", body_angular_velocity(u, product(rp.v, TP.vector)))
    rotary = sum(j * w[i] ** 2 for i, j in enumerate(RHOJ.symbols))
    return Element(
        name="beam3",
        family="link",
        picture="bar",
        span="bar_span",
        nodes=(p, rp, q),
        parameters=(TP, D0, L0, RHOA, RHOJ, GRAVITY),
        let=let.entries,
        deformations=(
            Deformation("along", "m", relative[0]),
            Deformation("across1", "m", relative[1]),
            Deformation("across2", "m", relative[2]),
        ),
        kinetic_energy=mass * linear_energy(p.v, q.v) / 6 + HALF * l0 * rotary,
        potential=-mass * HALF * dot(GRAVITY.vector, p.x + q.x),
        doc=(
            "triad ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp; d = xq - xp\n"
            "(along, across1, across2) = R(u_p)' d - d0\n"
            "w_p = angular velocity of the triad, in its own axes\n"
            "T = rhoA l0/6 (vp.vp + vp.vq + vq.vq) + l0/2 sum rhoJ_i w_i^2, uniform bar\n"
            "U = -rhoA l0 gravity.(xp + xq)/2" + LINK_DOC
        ),
        source="Meijaard, Papadopoulos, Ruina and Schwab 2007, supplement, PINBODY; UT SPACAR, RBEAM",
        outputs=(axes(*triad), displacement(relative)),
    )


BEAM3 = _beam3()
