"""Flexible beam in space, with and without the second-order terms of its deformations."""

from collections.abc import Callable

from sympy import Expr, Matrix, Rational, Symbol

from flexel.derive.declare import Deformation, Element, Frame, Let, Node, Point
from flexel.derive.declare.rotation import HALF, body_angular_velocity, dot, norm, product, triad_rate
from flexel.derive.declare.shape import hermite_energy, hermite_mean, rotary_energy, shear_number
from flexel.derive.declare.symbols import symbol
from flexel.derive.elements.beam_ranges import classic_ranges, shear_angle
from flexel.derive.elements.section_outputs import axis, section_forces
from flexel.derive.elements.shared_parameters import EIY, EIZ, GAY, GAZ, GRAVITY, L0, RHOA, RHOJ, TP, TQ
from flexel.derive.elements.triads import Triad, named_quaternion, named_triad

FIRST = """\
triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq
d = xq - xp, l = |d|, el = d/l
b1 = l - l0                 b2 = l0 (ez_p.ey_q - ey_p.ez_q)/2
b3 = -l0 ez_p.el            b4 = l0 ez_q.el
b5 = l0 ey_p.el             b6 = -l0 ey_q.el"""
_SECOND = """
elongation = b1 + (2 b3^2 + b3 b4 + 2 b4^2 + 2 b5^2 + b5 b6 + 2 b6^2)/(30 l0)
torsion = b2 + (b4 b5 - b3 b6)/l0
bend1, bend2 = b3 + k, b4 - k with k = b2 (b5 + b6)/(6 l0)
bend3, bend4 = b5 - h, b6 + h with h = b2 (b3 + b4)/(6 l0)"""
_NO_SECOND = "\nelongation, torsion, bend1, bend2, bend3, bend4 = b1, b2, b3, b4, b5, b6"
SHEAR = """
phi_y = 12 EIz/(GAy l0^2), phi_z = 12 EIy/(GAz l0^2): shear numbers of the deflections in y and z"""
_ENERGY = f"""{SHEAR}
T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
   the shear-corrected (phi_y, phi_z) cubic shapes, torsion linear; w_p, w_q angular velocities in the triads
U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)"""
FORCES = """
f = De'sigma: force_p, moment_p = -(R(u_p)'f_xp, L(u_p) (f_lambda_p o tp)/2), force_q, moment_q the same at q, without
   the minus
axis: places on the cubic axis; across: ey_p, ey_q"""
ANGLE = """
shear_angle = |(phi_z/(1 + phi_z) (bend1 - bend2), phi_y/(1 + phi_y) (bend3 - bend4))|/(2 l0)
ranges [degrees, %]: bend = angle(ex_p, el) + angle(ex_q, el), 1 - sin(bend)/bend; twist = angle with the sine
   (ez_p.ey_q - ey_p.ez_q)/2 and the cosine (ey_p.ey_q + ez_p.ez_q)/2, 1 - sin(2 twist)/(2 twist);
   shear_angle, sin(shear_angle)^2"""
BENDS = ("bend1", "bend2", "bend3", "bend4")


LENGTH = symbol("l")  # distance of the ends, named by `first_order`


def first_order(let: Let, p: Node, q: Node, tp: Triad, tq: Triad) -> list[Expr]:
    """Return the six deformations without second-order terms, named b1 ... b6."""
    l0 = L0.symbol
    d = let.vector("d", q.x - p.x)
    length = let.scalar(LENGTH.name, norm(d))
    el = let.vector("el", d / length)
    b = (
        length - l0,
        HALF * l0 * (dot(tp[2], tq[1]) - dot(tp[1], tq[2])),
        -l0 * dot(tp[2], el),
        l0 * dot(tq[2], el),
        l0 * dot(tp[1], el),
        -l0 * dot(tq[1], el),
    )
    return [let.scalar(f"b{i + 1}", value) for i, value in enumerate(b)]


def shear_numbers(let: Let) -> tuple[Symbol, Symbol]:
    """Return the shear numbers of the deflections in y and z, named ``phi_y`` and ``phi_z``."""
    pairs = (("phi_y", EIZ, GAY), ("phi_z", EIY, GAZ))
    phi_y, phi_z = (let.scalar(name, shear_number(EI.symbol, GA.symbol, L0.symbol)) for name, EI, GA in pairs)
    return phi_y, phi_z


def deformations(e: list[Expr]) -> tuple[Deformation, ...]:
    """Return the six deformations with their names, from their expressions."""
    names = ("elongation", "torsion", *BENDS)
    return tuple(Deformation(name, "m", expr) for name, expr in zip(names, e, strict=True))


def second_order(b: list[Expr], l0: Expr) -> list[Expr]:
    """Return the deformations to second order from those of first order.

    The coefficients follow from the exact energy of a rod expanded to third order (unique solution); Meijaard
    1996, Jonker and Meijaard 2013.
    """
    b1, b2, b3, b4, b5, b6 = b
    elongation = b1 + (2 * b3**2 + b3 * b4 + 2 * b4**2 + 2 * b5**2 + b5 * b6 + 2 * b6**2) / (30 * l0)
    k = b2 * (b5 + b6) / (6 * l0)
    h = b2 * (b3 + b4) / (6 * l0)
    return [elongation, b2 + (b4 * b5 - b3 * b6) / l0, b3 + k, b4 - k, b5 - h, b6 + h]


def _linear_spin(wp: Expr, wq: Expr) -> Expr:
    """Return the rotary energy of the twist over l0/2, linear between the ends' angular velocities about the axis."""
    return RHOJ.symbols[0] * (wp**2 + wp * wq + wq**2) * Rational(1, 3)


def kinetic_energy(
    let: Let,
    nodes: tuple[Node, ...],
    us: tuple[Matrix, ...],
    tp: Triad,
    tq: Triad,
    shear: tuple[Expr, Expr],
    spin: Callable[[Expr, Expr], Expr] = _linear_spin,
) -> Expr:
    """Return the kinetic energy of the cubic axis and of the sections' rotation.

    Parameters
    ----------
    shear : tuple of Expr
        Shear numbers of the deflections in y and z.
    spin : callable
        Gives the part of the twist from the rates of the ends' angles about the axis.
    """
    p, rp, q, rq = nodes
    l0 = L0.symbol
    uds = product(rp.v, TP.vector), product(rq.v, TQ.vector)
    uds = let.vector("ud_p", uds[0]), let.vector("ud_q", uds[1])
    wp = let.vector("w_p", body_angular_velocity(us[0], uds[0]))
    wq = let.vector("w_q", body_angular_velocity(us[1], uds[1]))
    exd_p = let.vector("exd_p", triad_rate(us[0], uds[0])[0])
    exd_q = let.vector("exd_q", triad_rate(us[1], uds[1])[0])
    chord = let.vector("chord", (q.v - p.v) / LENGTH)
    about_z = HALF * dot(chord, tp[1] + tq[1])
    about_y = -HALF * dot(chord, tp[2] + tq[2])
    _, jy, jz = RHOJ.symbols
    translation = hermite_energy((p.v, l0 * exd_p, q.v, l0 * exd_q))
    rotation = (
        spin(wp[0], wq[0])
        + jy * rotary_energy(shear[1], let.scalar("chord_about_y", about_y), wp[1], wq[1])
        + jz * rotary_energy(shear[0], let.scalar("chord_about_z", about_z), wp[2], wq[2])
    )
    return HALF * l0 * (RHOA.symbol * translation + rotation)


def _beam(name: str, second: bool) -> Element:
    nodes = p, rp, q, rq = Point("p"), Frame("rp"), Point("q"), Frame("rq")
    l0 = L0.symbol
    let = Let()
    us = named_quaternion(let, rp, TP, "p"), named_quaternion(let, rq, TQ, "q")
    tp, tq = named_triad(let, us[0], "p"), named_triad(let, us[1], "q")
    e = first_order(let, p, q, tp, tq)
    if second:
        e = second_order(e, l0)
    modes, (phi_y, phi_z) = deformations(e), shear_numbers(let)
    energy = kinetic_energy(let, nodes, us, tp, tq, (phi_y, phi_z))
    centre = hermite_mean(p.x, l0 * tp[0], q.x, l0 * tq[0])
    sheared = shear_angle([(modes[2], modes[3], phi_z), (modes[4], modes[5], phi_y)])
    return Element(
        name=name,
        family="beam",
        picture="beam",
        span="beam_span",
        nodes=nodes,
        parameters=(L0, TP, TQ, RHOA, RHOJ, EIY, EIZ, GAY, GAZ, GRAVITY),
        let=let.entries,
        deformations=modes,
        kinetic_energy=energy,
        potential=-RHOA.symbol * l0 * dot(GRAVITY.vector, centre),
        doc=FIRST + (_SECOND if second else _NO_SECOND) + _ENERGY + FORCES + ANGLE,
        source="Meijaard 1996, Nonlinear Dyn. 9; Jonker and Meijaard 2013, Int. J. Non-Linear Mech. 53; "
        "Przemieniecki 1968 (mass with rotary inertia)",
        outputs=(
            *section_forces(nodes, us, (tp, tq)),
            sheared,
            *classic_ranges((q.x - p.x) / LENGTH, tp, tq, sheared),
            *axis(p, q, (tp, tq)),
        ),
    )


BEAM = _beam("beam", second=True)
BEAM_FIRST_ORDER = _beam("beam_first_order", second=False)
