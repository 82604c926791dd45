"""Flexible beam in space whose sections warp: non-uniform torsion, with all second-order terms."""

from collections.abc import Callable

from sympy import Expr, Matrix, Rational

from flexel.derive.declare import Deformation, Element, Frame, Let, Point, Warping
from flexel.derive.declare.rotation import dot
from flexel.derive.declare.shape import hermite_energy, hermite_mean
from flexel.derive.elements.beam import (
    ANGLE,
    FIRST,
    FORCES,
    LENGTH,
    SHEAR,
    deformations,
    first_order,
    kinetic_energy,
    second_order,
    shear_numbers,
)
from flexel.derive.elements.beam_ranges import classic_ranges, shear_angle
from flexel.derive.elements.section_outputs import axis, section_forces
from flexel.derive.elements.shared_parameters import (
    EA,
    EIY,
    EIZ,
    GAY,
    GAZ,
    GRAVITY,
    L0,
    RHOA,
    RHOIW,
    RHOJ,
    TP,
    TQ,
)
from flexel.derive.elements.triads import named_quaternion, named_triad

_DOC = f"""{SHEAR}
polar = (EIy + EIz)/EA: square of the polar radius of gyration of the section
b7 = l0^2 wp - b2           b8 = l0^2 wq - b2           (wp, wq: twist per length at the ends)
elongation = b1 + (2 b3^2 + b3 b4 + 2 b4^2 + 2 b5^2 + b5 b6 + 2 b6^2)/(30 l0)
             + polar/(2 l0^3) (b2^2 + (2 b7^2 - b7 b8 + 2 b8^2)/15)
torsion = b2 + (b4 b5 - b3 b6)/l0
bend1 = b3 + k + (3 b5 b7 - (b5 + b6) b8)/(30 l0)    with k = b2 (b5 + b6)/(6 l0)
bend2 = b4 - k + ((b5 + b6) b7 - 3 b6 b8)/(30 l0)
bend3 = b5 - h - (3 b3 b7 - (b3 + b4) b8)/(30 l0)    with h = b2 (b3 + b4)/(6 l0)
bend4 = b6 + h - ((b3 + b4) b7 - 3 b4 b8)/(30 l0)
warp1 = l0^2 wp - torsion   warp2 = l0^2 wq - torsion: zero in uniform torsion
the angle of twist is cubic with the ends' twist per length; the strain energy of torsion, from the beam's laws, is
    GJ/(2 l0^3) (torsion^2 + (2 warp1^2 - warp1 warp2 + 2 warp2^2)/15)
    + 2 E Iw/l0^5 (warp1^2 + warp1 warp2 + warp2^2)
T: as the beam, its twist cubic with the rates of wp, wq, plus rhoIw/2 times the integral of the square of the
   rate of twist per length
U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)"""


def _uneven(a: Expr, b: Expr) -> Expr:
    """Return the mean square of the uneven part of a cubic's slope; its ends deviate by a and b from the mean slope."""
    return (2 * a**2 - a * b + 2 * b**2) * Rational(1, 15)


def _with_uneven_twist(e: list[Expr], b: list[Expr], b7: Expr, b8: Expr, polar: Expr) -> list[Expr]:
    """Add to the beam's six deformations what the twist shortens, and where uneven twist turns the bending.

    A twist kappa stretches a fibre at the distance r from the axis by r^2 kappa^2/2; its mean over the section
    and the length is the term of the elongation (Wagner 1929).  The bending curvatures of a rod are, to second
    order, v'' + phi w'' and w'' - phi v'' with the angle of twist phi; what the cubic part of phi adds is projected
    on the linear curvatures of the element, as for the beam.
    """
    _, b2, b3, b4, b5, b6 = b
    l0 = L0.symbol
    stretch = polar * (b2**2 + _uneven(b7, b8)) / (2 * l0**3)
    turned = (
        3 * b5 * b7 - (b5 + b6) * b8,
        (b5 + b6) * b7 - 3 * b6 * b8,
        (b3 + b4) * b8 - 3 * b3 * b7,
        3 * b4 * b8 - (b3 + b4) * b7,
    )
    return [
        e[0] + stretch,
        e[1],
        *(curvature + t / (30 * l0) for curvature, t in zip(e[2:], turned, strict=True)),
    ]


def _cubic_spin(let: Let, wp: Expr, wq: Expr) -> Callable[[Expr, Expr], Expr]:
    """Return the rotary energy of cubic twist and warping over l0/2, from the rates wp, wq of twist per length."""
    l0 = L0.symbol

    def spin(p: Expr, q: Expr) -> Expr:
        turning = hermite_energy((Matrix([p]), Matrix([l0 * wp]), Matrix([q]), Matrix([l0 * wq])))
        mean = let.scalar("mean_twisting", q - p)
        a, b = let.scalar("uneven_p", l0 * wp - mean), let.scalar("uneven_q", l0 * wq - mean)
        return RHOJ.symbols[0] * turning + RHOIW.symbol * (mean**2 + _uneven(a, b)) / l0**2

    return spin


def _beam_warping() -> Element:
    nodes = p, rp, q, rq, wp, wq = (
        Point("p"),
        Frame("rp"),
        Point("q"),
        Frame("rq"),
        Warping("wp"),
        Warping("wq"),
    )
    l0 = L0.symbol
    let = Let()
    us = named_quaternion(let, rp, TP, "p"), named_quaternion(let, rq, TQ, "q")
    tp, tq = named_triad(let, us[0], "p"), named_triad(let, us[1], "q")
    b = first_order(let, p, q, tp, tq)
    b7, b8 = (let.scalar(f"b{i}", l0**2 * w.x[0] - b[1]) for i, w in ((7, wp), (8, wq)))
    polar = let.scalar("polar", (EIY.symbol + EIZ.symbol) / EA.symbol)
    e = _with_uneven_twist(second_order(b, l0), b, b7, b8, polar)
    warps = [Deformation(f"warp{i}", "m", l0**2 * w.x[0] - e[1]) for i, w in ((1, wp), (2, wq))]
    spin = _cubic_spin(let, wp.v[0], wq.v[0])
    modes, (phi_y, phi_z) = (*deformations(e), *warps), shear_numbers(let)
    energy = kinetic_energy(let, (p, rp, q, rq), us, tp, tq, (phi_y, phi_z), spin)
    sheared = shear_angle([(modes[2], modes[3], phi_z), (modes[4], modes[5], phi_y)])
    return Element(
        name="beam_warping",
        family="beam",
        picture="beam",
        span="beam_span",
        nodes=nodes,
        parameters=(L0, TP, TQ, RHOA, RHOJ, RHOIW, EA, EIY, EIZ, GAY, GAZ, GRAVITY),
        let=let.entries,
        deformations=modes,
        kinetic_energy=energy,
        potential=-RHOA.symbol * l0 * dot(GRAVITY.vector, hermite_mean(p.x, l0 * tp[0], q.x, l0 * tq[0])),
        doc=FIRST + _DOC + FORCES + "\nbimoment_p = -f_wp, bimoment_q = f_wq" + ANGLE,
        source="Vlasov 1961, Thin-walled elastic beams; Wagner 1929 (twist and axial force); Jonker 2021 (warping "
        "coordinates)",
        outputs=(
            *section_forces(nodes, us, (tp, tq)),
            sheared,
            *classic_ranges((q.x - p.x) / LENGTH, tp, tq, sheared),
            *axis(p, q, (tp, tq)),
        ),
    )


BEAM_WARPING = _beam_warping()
