"""Flexible beam in space whose torsion and bending are linear in the rotation vector between its ends."""

from sympy import Expr, Matrix

from flexel.derive.declare import Element, Frame, Let, Node, Point
from flexel.derive.declare.logarithm import rotation_vector, turned_back
from flexel.derive.declare.rotation import HALF, components, conjugate, cross, dot, norm, product
from flexel.derive.declare.shape import hermite_mean
from flexel.derive.elements.beam import FORCES, LENGTH, SHEAR, deformations, kinetic_energy, shear_numbers
from flexel.derive.elements.beam_ranges import logarithmic_range
from flexel.derive.elements.rod import bow_stretch, shortening
from flexel.derive.elements.section_outputs import axis, section_forces
from flexel.derive.elements.shared_parameters import EIY, EIZ, GAY, GAZ, GRAVITY, L0, RHOA, RHOJ, TP, TQ
from flexel.derive.elements.triads import Triad, named_quaternion, named_triad

_DOC = f"""\
triads ex, ey, ez: columns of R(u_p), u_p = lambda_p o tp, and R(u_q), u_q = lambda_q o tq
turn: rotation vector of R(u_p)'R(u_q), below half a turn; R_m = R(u_p) exp(turn/2), the triad halfway{SHEAR}
s = 1/24 - turn.turn/1920 + (turn.turn)^2/322560
straight = R_m'(xq - xp) - l0 s turn x (turn x (1, 0, 0)): the chord without what uniform strains do to it
bow_z = straight_y/(phi_y l0 + |straight|),  bow_y = -straight_z/(phi_z l0 + |straight|):
    mean angles of the sections about z and y from the triad halfway; the shear angles are phi_y bow_z, -phi_z bow_y
bent = turn + turn x (0, bow_y, bow_z)
elongation = straight_x + l0 ((3/5 + phi_z) bow_y^2 + (3/5 + phi_y) bow_z^2) - l0
torsion = l0 bent_x
bend1, bend2 = l0 (bent_y/2 + (1 + phi_z) bow_y), l0 (bent_y/2 - (1 + phi_z) bow_y)
bend3, bend4 = l0 (bent_z/2 + (1 + phi_y) bow_z), l0 (bent_z/2 - (1 + phi_y) bow_z)
T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
   the shear-corrected (phi_y, phi_z) cubic shapes, torsion linear; w_p, w_q angular velocities in the triads
U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)"""


def _deformations(
    let: Let, p: Node, q: Node, us: tuple[Matrix, Matrix], tp: Triad, shear: tuple[Expr, Expr]
) -> list[Expr]:
    """Return the six deformations of a rod to second order, exact where its strains are uniform.

    The second-order terms are those for which the energy is that of a rod with linear bending moments, constant
    shear forces and a constant torque to third order, as in the classic beam, with shear.
    """
    l0, (shear_y, shear_z) = L0.symbol, shear
    turn, half, square = rotation_vector(let, let.vector("r", product(conjugate(us[0]), us[1])))
    chord = let.vector("d", q.x - p.x)
    let.scalar(LENGTH.name, norm(chord))  # of the kinetic energy
    d = turned_back(half, square, let.vector("dp", components(tp, chord)))
    s = let.scalar("shortening", l0 * shortening(let.scalar("turn_2", dot(turn, turn))))
    x, y, z = turn
    straight = let.vector("straight", d + s * Matrix([y**2 + z**2, -x * y, -x * z]))
    length = let.scalar("straight_l", norm(straight))
    bow_z = let.scalar("bow_z", straight[1] / (shear_y * l0 + length))
    bow_y = let.scalar("bow_y", -straight[2] / (shear_z * l0 + length))
    bent = let.vector("bent", turn + cross(turn, Matrix([0, bow_y, bow_z])))
    slope_y, slope_z = (1 + shear_z) * bow_y, (1 + shear_y) * bow_z
    return [
        straight[0] - l0 + l0 * (bow_stretch(shear_z, bow_y) + bow_stretch(shear_y, bow_z)),
        l0 * bent[0],
        l0 * (HALF * bent[1] + slope_y),
        l0 * (HALF * bent[1] - slope_y),
        l0 * (HALF * bent[2] + slope_z),
        l0 * (HALF * bent[2] - slope_z),
    ]


def _beam_logarithmic() -> Element:
    nodes = p, rp, q, rq = Point("p"), Frame("rp"), Point("q"), Frame("rq")
    l0 = L0.symbol
    let = Let()
    us = named_quaternion(let, rp, TP, "p"), named_quaternion(let, rq, TQ, "q")
    tp, tq = named_triad(let, us[0], "p"), named_triad(let, us[1], "q")
    shear = shear_numbers(let)
    e = _deformations(let, p, q, us, tp, shear)
    energy = kinetic_energy(let, nodes, us, tp, tq, shear)
    centre = hermite_mean(p.x, l0 * tp[0], q.x, l0 * tq[0])
    modes = deformations(e)
    return Element(
        name="beam_logarithmic",
        family="beam",
        picture="beam",
        span="beam_span",
        nodes=nodes,
        parameters=(L0, TP, TQ, RHOA, RHOJ, EIY, EIZ, GAY, GAZ, GRAVITY),
        let=let.entries,
        deformations=modes,
        kinetic_energy=energy,
        potential=-RHOA.symbol * l0 * dot(GRAVITY.vector, centre),
        doc=_DOC + FORCES,
        source="Simo 1985, Comput. Methods Appl. Mech. Eng. 49 (strains of a rod); Crisfield 1990 (triad halfway)",
        outputs=(*section_forces(nodes, us, (tp, tq)), logarithmic_range(modes), *axis(p, q, (tp, tq))),
    )


BEAM_LOGARITHMIC = _beam_logarithmic()
