"""Flexible beam in the plane, with and without the second-order terms of its elongation."""

from sympy import Expr, Matrix, Symbol

from flexel.derive.declare import Deformation, Element, Let, Node, Parameter, PlanarAngle, PlanarPoint
from flexel.derive.declare.rotation import HALF, dot, norm
from flexel.derive.declare.shape import hermite_energy, hermite_mean, rotary_energy, shear_number
from flexel.derive.elements.beam_ranges import classic_ranges, shear_angle
from flexel.derive.elements.section_outputs import axis, planar_section_forces
from flexel.derive.elements.shared_parameters import EIZ, GAY, L0, PLANAR_GRAVITY, RHOA
from flexel.derive.elements.triads import named_directions

ALPHA0 = Parameter("alpha0", 1, "rad", "initial direction of the element minus the angle of node p")
ALPHAQ0 = Parameter("alphaq0", 1, "rad", "initial direction of the element minus the angle of node q")
PLANAR_RHOJ = Parameter("rhoJ", 1, "kg m", "mass moment of inertia of the section per length")

_DOC = """\
ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
d = xq - xp, l = |d|, el = d/l;  b1 = l - l0,  b5 = l0 ey_p.el,  b6 = -l0 ey_q.el
elongation = {elongation},  bend1 = b5,  bend2 = b6
phi_y = 12 EIz/(GAy l0^2): shear number
T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
   the shear-corrected (phi_y) cubic shapes
U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)"""
PLANAR_FORCES = """
f = De'sigma: force_p, moment_p = -(ex_p.f_xp, ey_p.f_xp), -f_angle_p; force_q, moment_q the same at q, without minus
axis: places on the cubic axis; across: ey_p, ey_q"""
_ANGLE = """
shear_angle = |phi_y/(1 + phi_y) (bend1 - bend2)|/(2 l0)
ranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; shear_angle, sin(shear_angle)^2"""


def planar_shear_number(let: Let) -> Symbol:
    """Return the shear number of the deflection in the plane, named ``phi_y``."""
    return let.scalar("phi_y", shear_number(EIZ.symbol, GAY.symbol, L0.symbol))


def planar_kinetic_energy(
    let: Let, nodes: tuple[Node, ...], across: tuple[Matrix, Matrix], length: Expr, shear: Expr
) -> Expr:
    """Return the kinetic energy of the cubic axis and of the sections' rotation.

    Parameters
    ----------
    across : tuple of Matrix (2, 1)
        Directions ey of the element at the ends.
    length : Expr
        Present length.
    shear : Expr
        Shear number.
    """
    p, rp, q, rq = nodes
    l0 = L0.symbol
    wp, wq = rp.v[0], rq.v[0]
    chord = let.scalar("chord", HALF * dot(q.v - p.v, across[0] + across[1]) / length)
    columns: tuple[Matrix, ...] = (p.v, l0 * wp * across[0], q.v, l0 * wq * across[1])
    translation = RHOA.symbol * hermite_energy(columns)
    rotation = PLANAR_RHOJ.symbol * rotary_energy(shear, chord, wp, wq)
    return HALF * l0 * (translation + rotation)


def _planar_beam(name: str, second: bool) -> Element:
    nodes = p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    l0 = L0.symbol
    let = Let()
    ex_p, ey_p = named_directions(let, rp, ALPHA0, "p")
    ex_q, ey_q = named_directions(let, rq, ALPHAQ0, "q")
    d = let.vector("d", q.x - p.x)
    length = let.scalar("l", norm(d))
    el = let.vector("el", d / length)
    b5, b6 = let.scalar("b5", l0 * dot(ey_p, el)), let.scalar("b6", -l0 * dot(ey_q, el))
    elongation = length - l0
    if second:
        elongation += (2 * b5**2 + b5 * b6 + 2 * b6**2) / (30 * l0)
    shear = planar_shear_number(let)
    energy = planar_kinetic_energy(let, nodes, (ey_p, ey_q), length, shear)
    centre = hermite_mean(p.x, l0 * ex_p, q.x, l0 * ex_q)
    modes = (
        Deformation("elongation", "m", elongation),
        Deformation("bend1", "m", b5),
        Deformation("bend2", "m", b6),
    )
    ends = (ex_p, ey_p), (ex_q, ey_q)
    sheared = shear_angle([(modes[1], modes[2], shear)])
    return Element(
        name=name,
        family="beam",
        picture="beam",
        span="planar_beam_span",
        nodes=nodes,
        parameters=(L0, ALPHA0, ALPHAQ0, RHOA, PLANAR_RHOJ, EIZ, GAY, PLANAR_GRAVITY),
        let=let.entries,
        deformations=modes,
        kinetic_energy=energy,
        potential=-RHOA.symbol * l0 * dot(PLANAR_GRAVITY.vector, centre),
        doc=_DOC.format(elongation="b1 + (2 b5^2 + b5 b6 + 2 b6^2)/(30 l0)" if second else "b1")
        + PLANAR_FORCES
        + _ANGLE,
        source="SPACAR95 manual (Schwab and Meijaard 2000), PLBEAM, PLBEAMNL; signs of the "
        "spatial beam's b5, b6; Meijaard 1996, Nonlinear Dyn. 9",
        outputs=(
            *planar_section_forces(nodes, ends),
            sheared,
            *classic_ranges(el, *ends, sheared),
            *axis(p, q, ends),
        ),
    )


PLANAR_BEAM = _planar_beam("planar_beam", second=True)
PLANAR_BEAM_FIRST_ORDER = _planar_beam("planar_beam_first_order", second=False)
