"""Rigid three-node beam (rigid link) in the plane: two points and one angle."""

from sympy import Matrix

from flexel.derive.declare import Deformation, Element, Let, Parameter, PlanarAngle, PlanarPoint
from flexel.derive.declare.rotation import HALF, dot
from flexel.derive.declare.shape import linear_energy
from flexel.derive.elements.picture_outputs import LINK_DOC, axes, displacement
from flexel.derive.elements.planar_beam import ALPHA0, PLANAR_RHOJ
from flexel.derive.elements.shared_parameters import L0, PLANAR_GRAVITY, RHOA
from flexel.derive.elements.triads import named_directions

PLANAR_D0 = Parameter(
    "d0", 2, "m", "components of xq - xp on ex, ey when the deformations are zero", ("x", "y")
)


def _planar_beam3() -> Element:
    p, rp, q = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q")
    l0, mass = L0.symbol, RHOA.symbol * L0.symbol
    let = Let()
    ex, ey = named_directions(let, rp, ALPHA0, "p")
    d = let.vector("d", q.x - p.x)
    relative = Matrix([dot(ex, d), dot(ey, d)]) - PLANAR_D0.vector
    return Element(
        name="planar_beam3",
        family="link",
        picture="bar",
        span="planar_bar_span",
        nodes=(p, rp, q),
        parameters=(ALPHA0, PLANAR_D0, L0, RHOA, PLANAR_RHOJ, PLANAR_GRAVITY),
        let=let.entries,
        deformations=(
            Deformation("along", "m", relative[0]),
            Deformation("across", "m", relative[1]),
        ),
        kinetic_energy=mass * linear_energy(p.v, q.v) / 6 + HALF * l0 * PLANAR_RHOJ.symbol * rp.v[0] ** 2,
        potential=-mass * HALF * dot(PLANAR_GRAVITY.vector, p.x + q.x),
        doc=(
            "ex, ey: directions of the element (angle_p + alpha0); d = xq - xp\n"
            "along = ex.d - d0_x,  across = ey.d - d0_y\n"
            "T = rhoA l0/6 (vp.vp + vp.vq + vq.vq) + l0/2 rhoJ angledot^2, uniform bar\n"
            "U = -rhoA l0 gravity.(xp + xq)/2" + LINK_DOC
        ),
        source="planar counterpart of beam3",
        outputs=(axes(ex, ey), displacement(relative)),
    )


PLANAR_BEAM3 = _planar_beam3()
