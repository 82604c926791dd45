"""Elastic laws of beams: extension, torsion, bending in one plane, and the uneven twist of a beam that warps.

Each acts on the deformations of one kind and is a law of its own, because a beam may be rigid in any of them; its
strain energy is the sum of theirs.  Planar and spatial beams, of first and second order, have the same laws, and both
planes of bending have the same one.
"""

from sympy import Expr, Rational

from flexel.derive.declare import Law, Let, Parameter, symbol
from flexel.derive.declare.shape import shear_number
from flexel.derive.elements.shared_parameters import EA, L0

GJ = Parameter("GJ", 1, "N m^2", "torsional stiffness", sign="positive")
EI = Parameter("EI", 1, "N m^2", "bending stiffness", sign="positive")
GA = Parameter("GA", 1, "N", "shear stiffness k G A", sign="positive")
EIW = Parameter("EIw", 1, "N m^4", "warping stiffness", sign="positive")
STRAIN = Parameter("initial_strain", 1, "1", "elongation per length of the unstressed beam")
TWIST = Parameter("initial_twist", 1, "1/m", "twist of the unstressed beam")
CURVATURE = Parameter("initial_curvature", 1, "1/m", "curvature of the unstressed beam")
DAMPING = Parameter("damping", 1, "s", "ratio of damping to stiffness", sign="not negative")
_BEAM = "theory of beams; Kelvin-Voigt damping"


def _law(
    name: str,
    doc: str,
    parameters: tuple[Parameter, ...],
    stiffness: tuple[Expr, ...],
    relaxed: Expr,
    let: Let,
    source: str = _BEAM,
) -> Law:
    """Declare a law of one deformation, or of two that change places when p and q do.

    Parameters
    ----------
    stiffness : tuple of Expr
        The first row of the stiffness matrix [N/m].
    relaxed : Expr
        Value of each deformation of the unstressed beam [m].
    """
    count = len(stiffness)
    e = tuple(symbol(f"e_{i}") for i in range(count))
    ed = tuple(symbol(f"ed_{i}") for i in range(count))

    def pairs(values: tuple[Expr, ...]) -> list[Expr]:
        return [
            sum((k * value for k, value in zip(stiffness, around, strict=True)), Rational(0))
            for around in (values, values[::-1])[:count]
        ]

    delayed = tuple(strain + DAMPING.symbol * zd - relaxed for strain, zd in zip(e, ed, strict=True))
    stored = pairs(tuple(strain / 2 - relaxed for strain in e))
    return Law(
        name=name,
        doc=doc,
        parameters=(L0, *parameters, DAMPING),
        e=e,
        ed=ed,
        s=(),
        sigma=tuple(pairs(delayed)),
        tau=(),
        energy=sum((strain * k for strain, k in zip(e, stored, strict=True)), Rational(0)),
        source=source,
        let=let.entries,
        units=("m",) * count,
    )


def _extension() -> Law:
    let = Let()
    k = let.scalar("k", EA.symbol / L0.symbol)
    doc = (
        "sigma = EA/l0 (e - initial_strain l0 + damping ed),  e: the beam's elongation\n"
        "energy = EA/l0 e (e/2 - initial_strain l0)"
    )
    return _law("beam_extension", doc, (EA, STRAIN), (k,), STRAIN.symbol * L0.symbol, let)


def _torsion() -> Law:
    let = Let()
    k = let.scalar("k", GJ.symbol / L0.symbol**3)
    doc = (
        "sigma = GJ/l0^3 (e - initial_twist l0^2 + damping ed),  e: l0 times the angle of twist\n"
        "energy = GJ/l0^3 e (e/2 - initial_twist l0^2)"
    )
    return _law("beam_torsion", doc, (GJ, TWIST), (k,), TWIST.symbol * L0.symbol**2, let)


def _bending(shears: bool) -> Law:
    """Declare bending in a plane, of a beam exact for end loads; sections shear or remain normal to the axis."""
    let, l0 = Let(), L0.symbol
    relaxed = let.scalar("relaxed", CURVATURE.symbol * l0**2 / 2)
    P: Expr = let.scalar("P", shear_number(EI.symbol, GA.symbol, l0)) if shears else Rational(0)
    k = let.scalar("k", EI.symbol / ((1 + P) * l0**3))
    shear = "P = 12 EI/(GA l0^2)" if shears else "P = 0"
    doc = (
        "e_0, e_1: the beam's two deformations of bending in one plane, at p and at q\n"
        f"{shear},  k = EI/((1 + P) l0^3),  r = initial_curvature l0^2/2,  d_i = e_i - r + damping ed_i\n"
        "sigma = k ((4 + P) d_0 + (P - 2) d_1, (P - 2) d_0 + (4 + P) d_1)\n"
        "energy: the same form of e_i - r, less its value at e_i = 0"
    )
    return _law(
        "beam_shear_bending" if shears else "beam_bending",
        doc,
        (EI, *([GA] if shears else []), CURVATURE),
        ((4 + P) * k, (P - 2) * k),
        relaxed,
        let,
        "Przemieniecki 1968, Theory of matrix structural analysis; Kelvin-Voigt damping",
    )


def _warping() -> Law:
    let, l0 = Let(), L0.symbol
    twisting = let.scalar("twisting", GJ.symbol / (30 * l0**3))
    bimoment = let.scalar("bimoment", 2 * EIW.symbol / l0**5)
    doc = (
        "e_0, e_1: the beam's two deformations of warping, at p and at q;  d_i = e_i + damping ed_i\n"
        "sigma_i = GJ/(30 l0^3) (4 d_i - d_j) + 2 EIw/l0^5 (2 d_i + d_j),  j: the other one\n"
        "energy: the same form of e_i, halved"
    )
    stiffness = (4 * twisting + 2 * bimoment, bimoment - twisting)
    source = "Vlasov 1961, Thin-walled elastic beams"
    return _law("beam_bimoment", doc, (GJ, EIW), stiffness, Rational(0), let, source)


BEAM: tuple[Law, ...] = (_extension(), _torsion(), _bending(False), _bending(True), _warping())
