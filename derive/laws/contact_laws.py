"""Laws of contact: a normal force on a gap, and friction on the slips along the surface.

The force of the gap g is sigma = -N with N >= 0; a gap that is open carries nothing. Stiffness is a force per
penetration to the power of the exponent; for a point of a rope the runtime multiplies it by the length that the point
stands for.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp
from sympy import Expr, Symbol

from flexel.derive.declare import Internal, Law, Let, Parameter, symbol

STIFFNESS = Parameter(
    "stiffness", 1, "N/m^exponent", "normal force per penetration^exponent", sign="not negative"
)
EXPONENT = Parameter(
    "exponent", 1, "1", "exponent of the penetration, 3/2 for Hertz, at least 1", sign="at least one"
)
DISSIPATION = Parameter(
    "dissipation", 1, "s/m", "relative growth of the normal force per speed of approach", sign="not negative"
)
FRICTION = Parameter("friction", 1, "1", "coefficient of friction", sign="not negative")
SLIP_SPEED = Parameter(
    "slip_speed", 1, "m/s", "speed of sliding at which 71 % of the friction acts", sign="positive"
)
GRIP = replace(FRICTION, sign="positive")  # bristles divide by it
BRISTLES = Parameter(
    "bristle_stiffness",
    1,
    "1/m",
    "friction per normal force and deflection of the bristles",
    sign="not negative",
)
BRISTLE_DAMPING = Parameter(
    "bristle_damping", 1, "s/m", "friction per normal force and rate of deflection", sign="not negative"
)
RELEASE = Parameter(
    "release", 1, "1/s", "rate at which bristles straighten while the gap is open", sign="not negative"
)

NORMAL = (STIFFNESS, EXPONENT, DISSIPATION)
_DOC = (
    "d = max(-e, 0) penetration of the gap e, N = max(stiffness d^exponent (1 - dissipation ed), 0), sigma = -N\n"
    "energy = stiffness d^(exponent + 1)/(exponent + 1)"
)
_SOURCE = "Hunt and Crossley 1975, J. Appl. Mech. 42:440; Lankarani and Nikravesh 1990, J. Mech. Des. 112:369"


@dataclass(frozen=True)
class _Normal:
    """Symbols of a gap, the elastic and the whole normal force, the stored energy and the names given to them."""

    e: Symbol
    ed: Symbol
    elastic: Expr
    N: Expr
    energy: Expr
    let: Let


def _normal() -> _Normal:
    e, ed, let = symbol("e_0"), symbol("ed_0"), Let()
    K, n, a = (p.symbol for p in NORMAL)
    closed = e < 0
    depth = let.scalar(
        "depth", sp.Piecewise((-e, closed), (1, True))
    )  # no power of zero where the gap is open
    elastic = let.scalar("elastic", sp.Piecewise((K * depth**n, closed), (0, True)))
    N = let.scalar("N", sp.Max(elastic * (1 - a * ed), 0))
    return _Normal(e, ed, elastic, N, -e * elastic / (n + 1), let)


def _slips(k: int) -> tuple[Symbol, ...]:
    return tuple(symbol(f"s_{i}") for i in range(k))


def _square(values: Sequence[Expr]) -> Expr:
    return sp.Add(*(value**2 for value in values))


def _hertz() -> Law:
    c = _normal()
    return Law(
        name="hertz",
        doc=_DOC,
        parameters=NORMAL,
        e=(c.e,),
        ed=(c.ed,),
        s=(),
        sigma=(-c.N,),
        tau=(),
        energy=c.energy,
        source=_SOURCE,
        let=c.let.entries,
    )


def _coulomb(k: int) -> Law:
    """Declare a normal force, and friction that is a smooth function of the sliding velocity."""
    c, s = _normal(), _slips(k)
    speed = sp.sqrt(_square(s) + SLIP_SPEED.symbol**2)
    factor = c.let.scalar("factor", FRICTION.symbol * c.N / speed)
    return Law(
        name=f"hertz_coulomb_{k}",
        doc=_DOC + "\ntau = friction N s/sqrt(s.s + slip_speed^2)",
        parameters=(*NORMAL, FRICTION, SLIP_SPEED),
        e=(c.e,),
        ed=(c.ed,),
        s=s,
        units=("m", *("m/s" for _ in s)),
        sigma=(-c.N,),
        tau=tuple(factor * slip for slip in s),
        energy=c.energy,
        source=_SOURCE + "; Coulomb's friction, regularized",
        let=c.let.entries,
    )


def _bristle(k: int) -> Law:
    """Declare a normal force, and friction by bristles that bend before they slide: it sticks, and holds at rest.

    The bristles are stiff in proportion to the normal force: their deflection saturates at friction/bristle_stiffness
    whatever the force is, and nothing is divided by a force that may vanish.
    """
    c, s = _normal(), _slips(k)
    z = tuple(symbol(f"z_{i}") for i in range(k))
    stiffness, let = BRISTLES.symbol, c.let
    square = let.scalar("square", _square(s))
    moving = square > 0  # the root has no derivative at zero; the speed there is zero with its derivative
    safe = let.scalar("safe", sp.Piecewise((square, moving), (1, True)))  # SymPy takes roots of pieces apart
    speed = let.scalar("speed", sp.Piecewise((sp.sqrt(safe), moving), (0, True)))
    sliding = let.scalar("sliding", stiffness * speed / GRIP.symbol)
    closed = c.e < 0
    rates = [
        let.scalar(f"zd_{i}", sp.Piecewise((s[i] - sliding * z[i], closed), (-RELEASE.symbol * z[i], True)))
        for i in range(k)
    ]
    bent = c.elastic * stiffness * _square(z) / 2
    return Law(
        name=f"hertz_bristle_{k}",
        doc=(
            _DOC + " + stiffness d^exponent bristle_stiffness z.z/2\n"
            "dz/dt = s - bristle_stiffness |s| z/friction in contact, -release z when open\n"
            "tau = N (bristle_stiffness z + bristle_damping dz/dt)"
        ),
        parameters=(*NORMAL, GRIP, BRISTLES, BRISTLE_DAMPING, RELEASE),
        e=(c.e,),
        ed=(c.ed,),
        s=s,
        units=("m", *("m/s" for _ in s)),
        sigma=(-c.N,),
        tau=tuple(c.N * (stiffness * z[i] + BRISTLE_DAMPING.symbol * rates[i]) for i in range(k)),
        energy=c.energy + bent,
        source=_SOURCE + "; Dahl 1968; Canudas de Wit et al. 1995, IEEE Trans. Autom. Control 40:419",
        states=tuple(Internal(z[i].name, "m", rates[i], lasting=True) for i in range(k)),
        let=let.entries,
    )


CONTACT: tuple[Law, ...] = (_hertz(), *(_coulomb(k) for k in (1, 2)), *(_bristle(k) for k in (1, 2)))
