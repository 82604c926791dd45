"""Cable with positions and slopes at its ends (absolute nodal coordinates): it stretches and bends, without torsion."""

from sympy import Expr, Integer, Matrix, Rational

from flexel.derive.declare import (
    Deformation,
    Element,
    Let,
    Node,
    Output,
    Parameter,
    PlanarPoint,
    PlanarSlope,
    Point,
    Slope,
)
from flexel.derive.declare.rotation import HALF, cross, dot, norm
from flexel.derive.declare.shape import (
    gauss_points,
    hermite_energy,
    hermite_mean,
    hermite_points,
    hermite_slopes,
)
from flexel.derive.elements.shared_parameters import GRAVITY, L0, PLANAR_GRAVITY, RHOA

BENDING_POINTS = 3
PLACES = 9  # on the centre line, of which a rope has many elements
SHARES = (Rational(1), Rational(1, 3), Rational(1, 5))  # integrals of the squares of Legendre's polynomials


def _strains(let: Let, ends: tuple[Matrix, Matrix, Matrix]) -> list[Deformation]:
    """Return three axial strains, all that a cubic can provide: with 2 n + 1 in a line of n elements, none locks.

    They are the Legendre coefficients of the quadratic strain that has the element's mean and its values at the ends.
    """
    at_p, at_q = (let.scalar(f"n{k}", norm(slope)) for k, slope in zip("pq", ends[1:], strict=True))
    lengths = [
        norm(let.vector(f"s{i}", hermite_slopes(*ends, L0.symbol, xi)[0]))
        for i, xi in enumerate(gauss_points(3), 1)
    ]
    weights = (Rational(5, 18), Rational(8, 18), Rational(5, 18))
    mean = let.scalar(
        "mean", sum((w * length for w, length in zip(weights, lengths, strict=True)), Integer(0))
    )
    exprs = (mean - 1, HALF * (at_q - at_p), HALF * (at_q + at_p) - mean)
    return [Deformation(f"strain{i}", "1", expr, free=True) for i, expr in enumerate(exprs, 1)]


def _curvature(slope: Matrix, bend: Matrix) -> dict[str, Expr]:
    """Return the components of the curvature (r' x r'')/|r'|^2, or the one normal to the plane, by their suffixes."""
    factor = 1 / dot(slope, slope)
    if slope.rows == 2:
        return {"": (slope[0] * bend[1] - slope[1] * bend[0]) * factor}
    return {axis: c * factor for axis, c in zip("xyz", cross(slope, bend), strict=True)}


def _curvatures(let: Let, ends: tuple[Matrix, Matrix, Matrix]) -> list[Deformation]:
    """Return the curvature at the points of quadrature."""
    curvatures = []
    for i, xi in enumerate(gauss_points(BENDING_POINTS), 1):
        first, second = hermite_slopes(*ends, L0.symbol, xi)
        slope, bend = let.vector(f"t{i}", first), let.vector(f"b{i}", second)
        for axis, expr in _curvature(slope, bend).items():
            curvatures.append(Deformation(f"curvature{i}{axis}", "1/m", expr, free=True))
    return curvatures


def _outputs(nodes: tuple[Node, ...], modes: tuple[Deformation, ...]) -> tuple[Output, ...]:
    """Return arc length, tension, strain and curvature at the points of quadrature, and the centre line."""
    p, dp, q, dq = nodes
    l0, strains, bends = L0.symbol, modes[:3], modes[3:]
    at, points = [], gauss_points(BENDING_POINTS)
    for xi in points:
        y = 2 * xi - 1
        at.append((1, y, (3 * y**2 - 1) / 2))  # Legendre's polynomials
    parts = [mode.stress / (share * l0) for mode, share in zip(strains, SHARES, strict=True)]
    tension = [sum(a * b for a, b in zip(row, parts, strict=True)) for row in at]
    strain = [sum(a * mode.value for a, mode in zip(row, strains, strict=True)) for row in at]
    size = len(bends) // BENDING_POINTS
    bent = [
        norm(Matrix([mode.value for mode in bends[size * i : size * (i + 1)]])) for i in range(BENDING_POINTS)
    ]
    line = hermite_points(p.x, dp.x, q.x, dq.x, l0, PLACES)
    return (
        Output("arc_length", "m", Matrix([l0 * xi for xi in points])),
        Output("tension", "N", Matrix(tension)),
        Output("strain", "1", Matrix(strain)),
        Output("curvature", "1/m", Matrix(bent)),
        Output("line", "m", line, draws="rope"),
    )


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
            "strain1 = L/l0 - 1, the mean of |r'| - 1 by 3 Gauss points;  strain2 = (|dq| - |dp|)/2;\n"
            "strain3 = (|dq| + |dp|)/2 - L/l0:  |r'| - 1 = strain1 + strain2 P1 + strain3 P2, Legendre's polynomials\n"
            "curvature = (r' x r'')/|r'|^2, the turn by undeformed arc length, at 3 Gauss points\n"
            "work: EA l0 (1, 1/3, 1/5) times the strains, EI times curvature and Gauss weight (of sum l0)\n"
            "T = rhoA/2 int rdot.rdot ds (constant mass matrix),  U = -rhoA gravity.int r ds\n"
            "arc_length, tension, strain, curvature at 3 Gauss points:\n"
            "tension = (sigma1 + 3 sigma2 P1 + 5 sigma3 P2)/l0,  strain = strain1 + strain2 P1 + strain3 P2,\n"
            "curvature = its magnitude\n"
            "line: places on the curve"
        ),
        source=(
            "Gerstmayr and Irschik 2008, J. Sound Vib. 318:461 (strain and curvature); Gerstmayr and Shabana 2006, "
            "Nonlinear Dyn. 45:109 (cubic cable)"
        ),
        outputs=_outputs(nodes, deformations),
    )


CABLE = _cable("cable", (Point("p"), Slope("dp"), Point("q"), Slope("dq")), GRAVITY)
PLANAR_CABLE = _cable(
    "planar_cable",
    (PlanarPoint("p"), PlanarSlope("dp"), PlanarPoint("q"), PlanarSlope("dq")),
    PLANAR_GRAVITY,
)
