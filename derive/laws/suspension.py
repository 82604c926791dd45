"""Laws of springs and dampers given by curves: polynomial pieces of a deformation or of its rate, and one-sided stops.

A curve has up to `PIECES` pieces of degree up to four, each in powers of the distance from where it begins, so that
no digits cancel; the runtime makes the pieces and checks that they join.
"""

from sympy import Expr, Max, Piecewise, Rational, Symbol

from flexel.derive.declare import Law, Let, Parameter, symbol

PIECES, DEGREE = 16, 4
BREAKS = Parameter(
    "breaks", PIECES - 1, "m or m/s", "where the next piece begins; rising, unused ones very large"
)
ORIGINS = Parameter("origins", PIECES, "m or m/s", "from where the powers of each piece are counted")
COEFFICIENTS = Parameter("coefficients", PIECES * (DEGREE + 1), "N, N/m, ...", "of each piece, rising powers")
KINKS = Parameter(
    "kinks",
    PIECES - 1,
    "m or m/s",
    "breaks at which the slope jumps, where steps end; unused ones very large",
)
STORED = Parameter("stored", PIECES, "J", "energy at the origin of each piece")


def _chosen(x: Symbol, values: tuple[Symbol, ...]) -> Expr:
    """Choose the value of the piece in which x lies."""
    pairs = [(value, x < end) for value, end in zip(values, BREAKS.symbols, strict=False)]
    return Piecewise(*pairs, (values[-1], True))


def _curve(name: str, x: Symbol, doc: str, stored: bool) -> Law:
    let, c = Let(), COEFFICIENTS.symbols
    y = let.scalar("y", x - _chosen(x, ORIGINS.symbols))
    at = [let.scalar(f"c{i}", _chosen(x, c[i :: DEGREE + 1])) for i in range(DEGREE + 1)]
    force: Expr = Rational(0)
    energy: Expr = Rational(0)
    for i in reversed(range(DEGREE + 1)):
        force = force * y + at[i]
        energy = (energy + at[i] / (i + 1)) * y
    if stored:
        energy += let.scalar("U0", _chosen(x, STORED.symbols))
    return Law(
        name=name,
        doc=doc,
        parameters=(BREAKS, ORIGINS, COEFFICIENTS, *([STORED] if stored else []), KINKS),
        e=(symbol("e"),),
        ed=(symbol("ed"),),
        s=(),
        sigma=(force,),
        tau=(),
        energy=energy if stored else Rational(0),
        begins=tuple(x - kink for kink in KINKS.symbols),
        source="piecewise polynomial",
        let=let.entries,
    )


def _stop() -> Law:
    gap, k, d = (
        Parameter("gap", 1, "m or rad", "deformation at which it is touched"),
        Parameter("stiffness", 1, "N/m or N m/rad", "stiffness once touched", sign="not negative"),
        Parameter(
            "damping",
            1,
            "s/m or s/rad",
            "loss relative to the elastic force, for unit rate",
            sign="not negative",
        ),
    )
    e, ed = symbol("e"), symbol("ed")
    depth = Max(0, e - gap.symbol)
    return Law(
        name="stop",
        doc="depth = max(0, e - gap);  sigma = stiffness depth max(0, 1 + damping edot), never pulling",
        parameters=(gap, k, d),
        e=(e,),
        ed=(ed,),
        s=(),
        sigma=(k.symbol * depth * Max(0, 1 + d.symbol * ed),),
        tau=(),
        energy=k.symbol * depth**2 / 2,
        begins=(e - gap.symbol,),
        source="Hunt and Crossley 1975, J. Appl. Mech. 42:440, exponent one",
    )


_PIECE_DOC = (
    "y = x - origin, sum of c_i y^i in the piece in which x lies (x < next break), end pieces beyond\n"
)
CURVES: tuple[Law, ...] = (
    _curve(
        "spring_curve", symbol("e"), _PIECE_DOC + "sigma = that sum with x = e;  energy = its integral", True
    ),
    _curve("damper_curve", symbol("ed"), _PIECE_DOC + "sigma = that sum with x = the rate of e", False),
    _stop(),
)
