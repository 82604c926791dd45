"""The paper's own cable element, equation (8), as a page of a user: Green's strain, curvature by deformed length.

U = 1/2 int EA eps² + 1/2 int EJ kappa² with eps = (r'.r' - 1)/2 at five Gauss points and kappa = |r' x r''|/|r'|³ at
three.  Five strains are more than a cubic can follow on a sheave: it locks, which the page of the hoist shows.
"""

from __future__ import annotations

from functools import cache

from sympy import Expr, Integer, Matrix, Rational
from sympy.integrals.quadrature import gauss_legendre

import flexel as fx
from flexel.derive import Deformation, Element, Law, Let, Output, Parameter, Point, Slope, symbol
from flexel.derive.compiled import CompiledElement, CompiledLaw
from flexel.derive.declare.rotation import HALF, cross, dot, norm
from flexel.derive.declare.shape import (
    gauss_points,
    hermite_energy,
    hermite_mean,
    hermite_points,
    hermite_slopes,
)

STRAINS, CURVATURES, PLACES = 5, 3, 9
L0 = Parameter("l0", 1, "m", "undeformed length", sign="positive")
RHOA = Parameter("rhoA", 1, "kg/m", "mass per length", sign="not negative")
GRAVITY = Parameter("gravity", 3, "m/s^2", "acceleration of gravity")
EA = Parameter("EA", 1, "N", "stiffness in tension", sign="positive")
EI = Parameter("EI", 1, "N m^2", "stiffness in bending", sign="not negative")
DAMPING = Parameter("damping", 1, "s", "ratio of damping to stiffness of stretching", sign="not negative")


def gauss_weights(count: int) -> list[Expr]:
    """Return the weights of Gauss's quadrature on (0, 1), to 50 digits."""
    return [weight / 2 for weight in gauss_legendre(count, 50)[1]]


def element() -> Element:
    """Declare the element: five strains, then three curvature vectors."""
    nodes = p, dp, q, dq = Point("p"), Slope("dp"), Point("q"), Slope("dq")
    l0, let = L0.symbol, Let()
    ends = let.vector("d", q.x - p.x), dp.x, dq.x
    strains, tensions, curvatures, bent = [], [], [], []
    for i, (xi, weight) in enumerate(zip(gauss_points(STRAINS), gauss_weights(STRAINS), strict=True), 1):
        slope, bend = hermite_slopes(*ends, l0, xi)
        slope = let.vector(f"s{i}", slope)
        strain = Deformation(f"strain{i}", "1", HALF * (dot(slope, slope) - 1), free=True)
        strains.append(strain)
        tensions.append(strain.stress * norm(slope) / (weight * l0))
        bent.append(norm(cross(slope, bend)) / norm(slope) ** 3)
    for i, xi in enumerate(gauss_points(CURVATURES), 1):
        first, second = hermite_slopes(*ends, l0, xi)
        slope, bend = let.vector(f"t{i}", first), let.vector(f"b{i}", second)
        stretch = let.scalar(f"n{i}", norm(slope))
        for axis, component in zip("xyz", cross(slope, bend), strict=True):
            curvatures.append(Deformation(f"curvature{i}{axis}", "1/m", component / stretch**3, free=True))
    mass = RHOA.symbol * l0
    return Element(
        name="paper_cable",
        family="cable",
        picture="rope",
        nodes=nodes,
        parameters=(L0, RHOA, GRAVITY),
        let=let.entries,
        deformations=(*strains, *curvatures),
        kinetic_energy=HALF * mass * hermite_energy((p.v, l0 * dp.v, q.v, l0 * dq.v)),
        potential=-mass * dot(GRAVITY.vector, hermite_mean(p.x, l0 * dp.x, q.x, l0 * dq.x)),
        doc="strain = (r'.r' - 1)/2 at 5 Gauss points;  curvature = (r' x r'')/|r'|^3 at 3 Gauss points",
        source="Cao, Du, Ma and Liu 2017, eq. (8)",
        outputs=(
            Output("arc_length", "m", Matrix([l0 * xi for xi in gauss_points(STRAINS)])),
            Output("tension", "N", Matrix(tensions)),
            Output("strain", "1", Matrix([strain.value for strain in strains])),
            Output("curvature", "1/m", Matrix(bent)),
            Output("line", "m", hermite_points(p.x, dp.x, q.x, dq.x, l0, PLACES), draws="rope"),
        ),
    )


def law() -> Law:
    """Declare the law of equation (8), with Kelvin-Voigt damping of stretching."""
    l0, axial = L0.symbol, [EA.symbol * weight for weight in gauss_weights(STRAINS)]
    bending = [EI.symbol * weight for weight in gauss_weights(CURVATURES) for _ in range(3)]
    e, ed = ([symbol(f"{letter}_{i}") for i in range(STRAINS + 3 * CURVATURES)] for letter in ("e", "ed"))
    rated = [strain + DAMPING.symbol * rate for strain, rate in zip(e[:STRAINS], ed, strict=False)]
    rated += e[STRAINS:]
    energy: Expr = sum((k * value**2 for k, value in zip([*axial, *bending], e, strict=True)), Integer(0))
    return Law(
        name="paper_cable_stiffness",
        doc="sigma = EA l0 w (strain + damping rate), EI l0 w curvature with Gauss's weights w",
        parameters=(L0, EA, EI, DAMPING),
        e=tuple(e),
        ed=tuple(ed),
        s=(),
        sigma=tuple(l0 * k * value for k, value in zip([*axial, *bending], rated, strict=True)),
        tau=(),
        energy=l0 * energy * Rational(1, 2),
        source="Cao, Du, Ma and Liu 2017, eq. (8)",
        units=("1",) * STRAINS + ("1/m",) * (3 * CURVATURES),
    )


@cache
def paper_element() -> tuple[CompiledElement, CompiledLaw]:
    """Compile the element and its law; later processes find them in the cache."""
    return fx.compile_element(element()), fx.compile_law(law())
