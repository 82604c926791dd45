"""Elastic laws of cables: axial stiffness of the three strains, bending stiffness of the curvatures at three points."""

from sympy import Expr, Rational

from flexel.derive.declare import Law, Let, Parameter, symbol
from flexel.derive.elements.shared_parameters import EA, L0

EI = Parameter("EI", 1, "N m^2", "bending stiffness", sign="not negative")
DAMPING = Parameter("damping", 1, "s", "ratio of damping to stiffness of stretching", sign="not negative")
BENDING_DAMPING = Parameter(
    "bending_damping", 1, "s", "ratio of damping to stiffness of bending", sign="not negative"
)
STRAINS = (Rational(1), Rational(1, 3), Rational(1, 5))  # integrals of the squares of Legendre's polynomials
POINTS = (Rational(5, 18), Rational(8, 18), Rational(5, 18))  # weights of Gauss's quadrature


def _cable(name: str, components: int) -> Law:
    """Declare the law of three strains and of the curvature, with so many components, at three points."""
    let, l0 = Let(), L0.symbol
    axial, bending = let.scalar("axial", EA.symbol * l0), let.scalar("bending", EI.symbol * l0)
    stiffness = [axial * share for share in STRAINS]
    stiffness += [bending * share for share in POINTS for _ in range(components)]
    damping = [DAMPING.symbol] * 3 + [BENDING_DAMPING.symbol] * (3 * components)
    e, ed = ([symbol(f"{letter}_{i}") for i in range(len(stiffness))] for letter in ("e", "ed"))
    rows = list(zip(stiffness, e, damping, ed, strict=True))
    energy: Expr = sum((k * strain**2 for k, strain, _, _ in rows), Rational(0))
    return Law(
        name=name,
        doc=(
            "sigma = EA l0 (1, 1/3, 1/5) (e + damping ed) of the strains,\n"
            "sigma = EI l0 (5, 8, 5)/18 (e + bending_damping ed) of the curvatures at the three points\n"
            "energy = sum of EA l0 (1, 1/3, 1/5) e^2/2 and EI l0 (5, 8, 5)/18 e^2/2"
        ),
        parameters=(L0, EA, EI, DAMPING, BENDING_DAMPING),
        e=tuple(e),
        ed=tuple(ed),
        s=(),
        sigma=tuple(k * (strain + ratio * zd) for k, strain, ratio, zd in rows),
        tau=(),
        energy=energy / 2,
        source="Gerstmayr and Shabana 2006, Nonlinear Dyn. 45:109; Kelvin-Voigt damping",
        let=let.entries,
        units=("1",) * 3 + ("1/m",) * (3 * components),
    )


CABLE: tuple[Law, ...] = (_cable("planar_cable_stiffness", 1), _cable("cable_stiffness", 3))
