"""Laws of joints: dry friction, stops on both sides, and a journal or ball with play in its socket."""

import sympy as sp

from flexel.derive.declare import Law, Let, Parameter, symbol
from flexel.derive.laws.journal import ARM, SPEED

LIMIT = Parameter("limit", 1, "N or N m", "friction of fast motion", sign="not negative")
RATE = Parameter("speed", 1, "m/s or rad/s", "speed at which 71 % of the friction acts", sign="positive")
LOW = Parameter("low", 1, "m or rad", "deformation at which the lower stop is touched")
HIGH = Parameter("high", 1, "m or rad", "deformation at which the upper stop is touched")
STIFFNESS = Parameter("stiffness", 1, "N/m or N m/rad", "stiffness once touched", sign="not negative")
LOSS = Parameter(
    "damping", 1, "s/m or s/rad", "loss relative to the elastic force, for unit rate", sign="not negative"
)
CLEARANCE = Parameter("gap", 1, "m", "radial play as drawn", sign="positive")
_CONTACT = "Hunt and Crossley 1975, J. Appl. Mech. 42:440, exponent one"


def _friction(slips: bool) -> Law:
    e, ed, s = symbol("e"), symbol("ed"), symbol("s")
    rate = s if slips else ed
    force = (LIMIT.symbol * rate / sp.sqrt(rate**2 + RATE.symbol**2),)
    return Law(
        name="slip_friction" if slips else "friction",
        doc=f"{'tau' if slips else 'sigma'} = limit w/sqrt(w^2 + speed^2), w {'the slip' if slips else '= edot'}",
        parameters=(LIMIT, RATE),
        e=() if slips else (e,),
        ed=() if slips else (ed,),
        s=(s,) if slips else (),
        sigma=() if slips else force,
        tau=force if slips else (),
        source="Coulomb's friction, regularized",
    )


def _limits() -> Law:
    e, ed = symbol("e"), symbol("ed")
    k, loss = STIFFNESS.symbol, LOSS.symbol * ed
    above, below = sp.Max(0, e - HIGH.symbol), sp.Max(0, LOW.symbol - e)
    return Law(
        name="limits",
        doc=(
            "above = max(0, e - high), below = max(0, low - e)\n"
            "sigma = stiffness (above max(0, 1 + damping edot) - below max(0, 1 - damping edot))"
        ),
        parameters=(LOW, HIGH, STIFFNESS, LOSS),
        e=(e,),
        ed=(ed,),
        s=(),
        sigma=(k * (above * sp.Max(0, 1 + loss) - below * sp.Max(0, 1 - loss)),),
        tau=(),
        energy=k * (above**2 + below**2) / 2,
        begins=(e - LOW.symbol, e - HIGH.symbol),
        source=_CONTACT,
    )


def _play(let: Let, e: list[sp.Symbol], ed: list[sp.Symbol]) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return the force beyond the play in some directions, the distance from the centre, and the contact's depth."""
    gap = CLEARANCE.symbol
    square = let.scalar("square", sum(component**2 for component in e))
    touching = square > gap**2
    safe = let.scalar(
        "safe", sp.Piecewise((square, touching), (1, True))
    )  # SymPy takes roots of pieces apart
    r = let.scalar("r", sp.sqrt(safe))
    depth = let.scalar("depth", sp.Piecewise((r - gap, touching), (0, True)))
    rate = let.scalar("rate", sum(component * zd for component, zd in zip(e, ed, strict=True)) / r)
    return let.scalar("N", STIFFNESS.symbol * depth * sp.Max(0, 1 + LOSS.symbol * rate)), r, depth


def _loose_ball() -> Law:
    e, ed = ([symbol(f"{name}_{i}") for i in range(3)] for name in ("e", "ed"))
    let = Let()
    N, r, depth = _play(let, e, ed)
    return Law(
        name="loose_ball",
        doc=(
            "r = |(e_0, e_1, e_2)|, depth = max(0, r - gap), N = stiffness depth max(0, 1 + damping dr/dt)\n"
            "sigma_i = N e_i/r"
        ),
        parameters=(CLEARANCE, STIFFNESS, LOSS),
        e=tuple(e),
        ed=tuple(ed),
        s=(),
        sigma=tuple(N * component / r for component in e),
        tau=(),
        energy=STIFFNESS.symbol * depth**2 / 2,
        source=_CONTACT,
        let=let.entries,
        units=("m", "m", "m"),
    )


def _loose_journal() -> Law:
    e, ed = ([symbol(f"{name}_{i}") for i in range(3)] for name in ("e", "ed"))
    let, k = Let(), STIFFNESS.symbol
    N, r, depth = _play(let, e[:2], ed[:2])
    turning = ed[2] / sp.sqrt(ed[2] ** 2 + SPEED.symbol**2)
    return Law(
        name="loose_journal",
        doc=(
            "r = |(e_0, e_1)|, depth = max(0, r - gap), N = stiffness depth max(0, 1 + damping dr/dt)\n"
            "sigma_i = N e_i/r (i = 0, 1);  torque = friction_radius N w/sqrt(w^2 + slip_speed^2) on e_2, w = ed_2"
        ),
        parameters=(CLEARANCE, STIFFNESS, LOSS, ARM, SPEED),
        e=tuple(e),
        ed=tuple(ed),
        s=(),
        sigma=(N * e[0] / r, N * e[1] / r, ARM.symbol * N * turning),
        tau=(),
        energy=k * depth**2 / 2,
        source=_CONTACT + "; Coulomb's friction, regularized",
        let=let.entries,
        units=("m", "m", "rad"),
    )


JOINT: tuple[Law, ...] = (_friction(False), _friction(True), _limits(), _loose_journal(), _loose_ball())
