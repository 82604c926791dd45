"""Flexible beam in the plane whose bending is linear in the angle between its ends."""

from sympy import Matrix, cos, sin

from flexel.derive.declare import Deformation, Element, Let, PlanarAngle, PlanarPoint
from flexel.derive.declare.rotation import HALF, dot, norm
from flexel.derive.declare.shape import hermite_mean
from flexel.derive.elements.planar_beam import (
    ALPHA0,
    ALPHAQ0,
    PLANAR_FORCES,
    PLANAR_RHOJ,
    planar_kinetic_energy,
    planar_shear_number,
)
from flexel.derive.elements.rod import bow_stretch, shortening
from flexel.derive.elements.section_outputs import axis, planar_section_forces
from flexel.derive.elements.shared_parameters import EIZ, GAY, L0, PLANAR_GRAVITY, RHOA
from flexel.derive.elements.triads import named_directions

_DOC = """\
ex, ey: directions of the element at p (angle_p + alpha0) and q (angle_q + alphaq0)
phi_y = 12 EIz/(GAy l0^2): shear number
turn = angle_q + alphaq0 - angle_p - alpha0;  along, across: components of xq - xp on the direction halfway
straight = (along + l0 turn^2 (1/24 - turn^2/1920 + turn^4/322560), across): the chord without what uniform bending
      takes from it
bow = across/(phi_y l0 + |straight|): mean angle of the sections from the direction halfway; the shear angle is
      phi_y bow
elongation = straight_x + l0 (3/5 + phi_y) bow^2 - l0
bend1, bend2 = l0 (turn/2 + (1 + phi_y) bow), l0 (turn/2 - (1 + phi_y) bow)
T: cubic Hermite interpolation of the axis with slopes l0 ex at the ends, rotary inertia of the sections with
   the shear-corrected (phi_y) cubic shapes
U = -rhoA l0 gravity.((xp + xq)/2 + l0 (ex_p - ex_q)/12)"""


def _planar_beam_logarithmic() -> Element:
    nodes = p, rp, q, rq = PlanarPoint("p"), PlanarAngle("rp"), PlanarPoint("q"), PlanarAngle("rq")
    l0, let = L0.symbol, Let()
    shear = planar_shear_number(let)
    directions = named_directions(let, rp, ALPHA0, "p"), named_directions(let, rq, ALPHAQ0, "q")
    start, end = rp.x[0] + ALPHA0.symbol, rq.x[0] + ALPHAQ0.symbol
    turn = let.scalar("turn", end - start)
    mean = let.scalar("mean", HALF * (start + end))
    c, s = let.scalar("cos_mean", cos(mean)), let.scalar("sin_mean", sin(mean))
    d = let.vector("d", q.x - p.x)
    along = dot(Matrix([c, s]), d) + l0 * turn**2 * shortening(turn**2)
    straight = let.vector("straight", [along, dot(Matrix([-s, c]), d)])
    bow = let.scalar("bow", straight[1] / (shear * l0 + norm(straight)))
    elongation = straight[0] - l0 + l0 * bow_stretch(shear, bow)
    across, length = (directions[0][1], directions[1][1]), let.scalar("l", norm(d))
    energy = planar_kinetic_energy(let, nodes, across, length, shear)
    centre = hermite_mean(p.x, l0 * directions[0][0], q.x, l0 * directions[1][0])
    return Element(
        name="planar_beam_logarithmic",
        family="beam",
        picture="beam",
        span="planar_beam_span",
        nodes=nodes,
        parameters=(L0, ALPHA0, ALPHAQ0, RHOA, PLANAR_RHOJ, EIZ, GAY, PLANAR_GRAVITY),
        let=let.entries,
        deformations=(
            Deformation("elongation", "m", elongation),
            Deformation("bend1", "m", l0 * (HALF * turn + (1 + shear) * bow)),
            Deformation("bend2", "m", l0 * (HALF * turn - (1 + shear) * bow)),
        ),
        kinetic_energy=energy,
        potential=-RHOA.symbol * l0 * dot(PLANAR_GRAVITY.vector, centre),
        doc=_DOC + PLANAR_FORCES,
        source="Reissner 1972, ZAMP 23 (strains of a rod); corotational directions as Crisfield 1990",
        outputs=(*planar_section_forces(nodes, directions), *axis(p, q, directions)),
    )


PLANAR_BEAM_LOGARITHMIC = _planar_beam_logarithmic()
