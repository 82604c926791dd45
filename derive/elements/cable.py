"""Cable with positions and slopes at its ends (absolute nodal coordinates): it stretches and bends, without torsion."""

from sympy import Expr, Matrix

from flexel.derive.declare import (
    Deformation,
    Element,
    Let,
    Node,
    Parameter,
    PlanarPoint,
    PlanarSlope,
    Point,
    Slope,
)
from flexel.derive.declare.rotation import HALF, cross, dot
from flexel.derive.declare.shape import gauss_points, hermite_energy, hermite_mean, hermite_slopes
from flexel.derive.elements.parameters import GRAVITY, L0, PLANAR_GRAVITY, RHOA

AXIAL_POINTS = 4
BENDING_POINTS = 3


def _strains(let: Let, ends: tuple[Matrix, Matrix, Matrix]) -> list[Deformation]:
    """Green's axial strain at the points of quadrature."""
    strains = []
    for i, xi in enumerate(gauss_points(AXIAL_POINTS), 1):
        slope = let.vector(f"s{i}", hermite_slopes(*ends, L0.symbol, xi)[0])
        strains.append(Deformation(f"strain{i}", "1", HALF * (dot(slope, slope) - 1), free=True))
    return strains


def _curvature(slope: Matrix, bend: Matrix) -> dict[str, Expr]:
    """Components of the curvature vector (r' x r'')/|r'|^3, or the one normal to the plane, by their suffixes."""
    square = dot(slope, slope)
    factor = square ** (-3 * HALF)
    if slope.rows == 2:
        return {"": (slope[0] * bend[1] - slope[1] * bend[0]) * factor}
    return {axis: c * factor for axis, c in zip("xyz", cross(slope, bend), strict=True)}


def _curvatures(let: Let, ends: tuple[Matrix, Matrix, Matrix]) -> list[Deformation]:
    """Curvature at the points of quadrature."""
    curvatures = []
    for i, xi in enumerate(gauss_points(BENDING_POINTS), 1):
        first, second = hermite_slopes(*ends, L0.symbol, xi)
        slope, bend = let.vector(f"t{i}", first), let.vector(f"b{i}", second)
        for axis, expr in _curvature(slope, bend).items():
            curvatures.append(Deformation(f"curvature{i}{axis}", "1/m", expr, free=True))
    return curvatures


def _cable(name: str, nodes: tuple[Node, Node, Node, Node], gravity: Parameter) -> Element:
    p, dp, q, dq = nodes
    l0, mass = L0.symbol, RHOA.symbol * L0.symbol
    let = Let()
    ends = (let.vector("d", q.x - p.x), dp.x, dq.x)
    deformations = (*_strains(let, ends), *_curvatures(let, ends))
    mean = hermite_mean(p.x, l0 * dp.x, q.x, l0 * dq.x)
    return Element(
        name=name,
        family="cable",
        picture="rope",
        span=f"{name}_span",
        nodes=nodes,
        parameters=(L0, RHOA, gravity),
        let=let.entries,
        deformations=deformations,
        kinetic_energy=HALF * mass * hermite_energy((p.v, l0 * dp.v, q.v, l0 * dq.v)),
        potential=-mass * dot(gravity.vector, mean),
        doc=(
            "r(s): cubic Hermite curve with slopes dp, dq = dr/ds by the undeformed arc length s at the ends\n"
            "strain = (r'.r' - 1)/2 at 4 Gauss points of (0, l0); curvature = (r' x r'')/|r'|^3 at 3 Gauss points\n"
            "work: EA strain and EI curvature, each times its Gauss weight (of sum l0), are the stresses of a rope\n"
            "T = rhoA/2 int rdot.rdot ds (constant mass matrix),  U = -rhoA gravity.int r ds"
        ),
        source="Berzeri and Shabana 2000, J. Sound Vib. 235:539; Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109",
    )


CABLE = _cable("cable", (Point("p"), Slope("dp"), Point("q"), Slope("dq")), GRAVITY)
PLANAR_CABLE = _cable(
    "planar_cable",
    (PlanarPoint("p"), PlanarSlope("dp"), PlanarPoint("q"), PlanarSlope("dq")),
    PLANAR_GRAVITY,
)
