"""Laws of tyres: vertical with lift-off, linear, CALSPAN, and a Magic Formula with combined slip and relaxation.

They act on the element ``tyre``: a load from its deflection, a side force from the slip and the camber, put on the
contact point. The benchmark's tyres take the slip of the wheel's centre, the Magic Formula that of the contact point,
which is another one while the wheel leans over. All forces vanish when the wheel lifts off; side forces fade out below
a standstill speed, where no slip angle exists.
"""

from sympy import Abs, Expr, Max, Min, Piecewise, Rational, Symbol, atan, cos, sin, sqrt

from flexel.derive.declare import Internal, Law, Let, Limit, Parameter, symbol

STIFFNESS = Parameter("stiffness", 1, "N/m", "vertical stiffness", sign="not negative")
DAMPING = Parameter("damping", 1, "N s/m", "vertical damping while the tyre is pressed", sign="not negative")
STANDSTILL = Parameter(
    "standstill", 1, "m/s", "forward speed below which side forces fade out", sign="positive"
)
LEAST_LOAD = Rational(1, 1000)  # [N] in the denominator of what is relative to the load

PRESS, PRESS_RATE = symbol("deflection"), symbol("deflection_rate")
CAMBER, CAMBER_RATE = symbol("camber"), symbol("camber_rate")
FORWARD, SIDEWAYS, ROLLING = symbol("forward"), symbol("sideways"), symbol("rolling")
LONGITUDINAL, LATERAL, SPIN = symbol("longitudinal"), symbol("lateral"), symbol("spin")
SIDE_SLIPS = (FORWARD, SIDEWAYS, LATERAL, SPIN)
UNITS = {PRESS: "m", CAMBER: "rad", FORWARD: "m/s", SIDEWAYS: "m/s", ROLLING: "rad/s"}
UNITS |= {LONGITUDINAL: "m/s", LATERAL: "m/s", SPIN: "rad/s"}

LOAD = STIFFNESS.symbol * PRESS + DAMPING.symbol * PRESS_RATE  # while the tyre is pressed
# The load is zero where the tyre is lifted, and before, where it is unloaded faster than its damper lets it expand.
BEGINS = (PRESS, LOAD)

_LOAD_DOC = "Fz = max(0, stiffness e + damping edot) while the deflection e > 0, else 0"
_SIDE_DOC = (
    f"{_LOAD_DOC}\n"
    "slip angle alpha = atan(sideways/max(|forward|, standstill)), of the wheel's centre\n"
    "tau(lateral) = -fade Fy, tau(spin) = -fade Mz;  fade = 3 u^2 - 2 u^3, u = min(1, |forward|/standstill)"
)


def _units(*arguments: Symbol) -> tuple[str, ...]:
    return tuple(UNITS[argument] for argument in arguments)


def _load(let: Let) -> tuple[Symbol, Expr]:
    """Return the vertical force, which never pulls, and the energy stored with it."""
    pressed = Piecewise((Max(0, LOAD), PRESS > 0), (0, True))
    return let.scalar("Fz", pressed), Piecewise((STIFFNESS.symbol * PRESS**2 / 2, PRESS > 0), (0, True))


def _slip_angle(let: Let) -> tuple[Symbol, Symbol]:
    """Return the tangent of the slip angle, and the factor by which side forces fade out at standstill."""
    standstill = STANDSTILL.symbol
    speed = let.scalar("speed", Abs(FORWARD))
    u = let.scalar("u", Min(1, speed / standstill))
    fade = let.scalar("fade", u**2 * (3 - 2 * u))
    return let.scalar("tan_alpha", SIDEWAYS / Max(speed, standstill)), fade


def _side_law(
    name: str,
    doc: str,
    parameters: tuple[Parameter, ...],
    let: Let,
    results: tuple[Expr, ...],
    source: str,
    limit: Limit | None = None,
    kinks: tuple[Expr, ...] = (),
) -> Law:
    """Declare a law of load and side force; `results` are Fz, its energy, Fy, Mz and the fading at standstill.

    At zeros of `kinks` its slope jumps, besides where the load begins.
    """
    Fz, energy, Fy, Mz, fade = results
    return Law(
        name=name,
        doc=f"{_SIDE_DOC}\n{doc}",
        parameters=(STIFFNESS, DAMPING, *parameters, STANDSTILL),
        e=(PRESS, CAMBER),
        ed=(PRESS_RATE, CAMBER_RATE),
        s=SIDE_SLIPS,
        sigma=(Fz, Rational(0)),
        tau=(Rational(0), Rational(0), -fade * Fy, -fade * Mz),
        energy=energy,
        begins=BEGINS + kinks,
        source=source,
        let=let.entries,
        limit=limit,
        units=_units(PRESS, CAMBER, *SIDE_SLIPS),
    )


def _vertical() -> Law:
    let = Let()
    Fz, energy = _load(let)
    return Law(
        name="vertical_tyre",
        doc=f"sigma = Fz\n{_LOAD_DOC}",
        parameters=(STIFFNESS, DAMPING),
        e=(PRESS,),
        ed=(PRESS_RATE,),
        s=(),
        sigma=(Fz,),
        tau=(),
        energy=energy,
        begins=BEGINS,
        source="point-contact tyre with lift-off",
        let=let.entries,
        units=_units(PRESS),
    )


def _linear() -> Law:
    C, Cg, trail = (
        Parameter("cornering", 1, "N/rad", "cornering stiffness", sign="not negative"),
        Parameter("camber_stiffness", 1, "N/rad", "camber stiffness"),
        Parameter("trail", 1, "m", "pneumatic trail"),
    )
    let = Let()
    Fz, energy = _load(let)
    tan_alpha, fade = _slip_angle(let)
    on = -C.symbol * atan(tan_alpha) - Cg.symbol * CAMBER
    Fy = let.scalar("Fy", Piecewise((on, PRESS > 0), (0, True)))
    doc = "Fy = -cornering alpha - camber_stiffness camber while pressed, whatever the load;  Mz = -trail Fy"
    source = "Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl., linear tyre"
    return _side_law(
        "linear_tyre", doc, (C, Cg, trail), let, (Fz, energy, Fy, -trail.symbol * Fy, fade), source
    )


def _calspan() -> Law:
    A = Parameter(
        "A",
        5,
        "N/rad, 1/rad, N, 1/rad, N",
        "A0 ... A4: cornering and camber stiffness over the load",
        sign=("any", "any", "positive", "any", "not zero"),
    )
    B = Parameter(
        "B",
        3,
        "1/N, 1, 1/N^2",
        "B1, B3, B4: friction over the load",
        ("1", "3", "4"),
        sign=("any", "positive", "any"),
    )
    SN = Parameter("SN", 1, "1", "skid number of the road relative to that of the test", sign="positive")
    AF = Parameter("AF", 2, "m/N", "AF1, AF2: aligning moment", ("1", "2"))
    (A0, A1, A2, A3, A4), (B1, B3, B4), (AF1, AF2) = A.symbols, B.symbols, AF.symbols
    let = Let()
    Fz, energy = _load(let)
    tan_alpha, fade = _slip_angle(let)
    within = let.scalar("within", Min(Fz, A2))
    mu = let.scalar("mu", SN.symbol * (B1 * within + B3 + B4 * within**2))
    C_alpha = let.scalar("C_alpha", A0 + A1 * within * (1 - within / A2))
    C_gamma = let.scalar("C_gamma", A3 * within * (1 - within / A4))
    pull = C_alpha * atan(tan_alpha) + C_gamma * CAMBER
    slip = let.scalar("slip", Max(-3, Min(3, -pull / (mu * Max(Fz, LEAST_LOAD)))))
    Fy = let.scalar("Fy", mu * Fz * (slip - slip * Abs(slip) / 3 + slip**3 / 27))
    Mz = let.scalar("Mz", (AF1 * Fz + AF2 * Abs(Fy)) * Fy)
    doc = (
        "F = min(Fz, A2): beyond the load A2 the data end, friction and stiffnesses keep their values there\n"
        "mu = SN (B1 F + B3 + B4 F^2),  C_alpha = A0 + A1 F (1 - F/A2),  C_gamma = A3 F (1 - F/A4)\n"
        "slip = -(C_alpha alpha + C_gamma camber)/(mu Fz), at most 3\n"
        "Fy = mu Fz (slip - slip |slip|/3 + slip^3/27),  Mz = (AF1 Fz + AF2 |Fy|) Fy,  Fx = 0"
    )
    source = "CALSPAN tyre as in Frik, Leister, Schwartz 1993, Vehicle System Dynamics 22 suppl."
    limit = Limit(A2, "friction and stiffnesses keep their values beyond")
    results = Fz, energy, Fy, Mz, fade
    return _side_law("calspan_tyre", doc, (A, B, SN, AF), let, results, source, limit, kinks=(LOAD - A2,))


_MAGIC = (
    Parameter("load0", 1, "N", "nominal load Fz0", sign="positive"),
    Parameter("rolling_radius", 1, "m", "effective radius of free rolling", sign="positive"),
    Parameter(
        "friction",
        2,
        "1",
        "mu at the nominal load, and its change for one more nominal load",
        sign=("positive", "any"),
    ),
    Parameter(
        "slip_stiffness", 1, "1", "longitudinal stiffness Kx relative to the load", sign="not negative"
    ),
    Parameter(
        "cornering",
        2,
        "1",
        "largest cornering stiffness over load0, and the load of it over load0",
        sign=("not negative", "positive"),
    ),
    Parameter("camber_stiffness", 1, "1/rad", "camber stiffness relative to the load"),
    Parameter("shape", 2, "1", "C and E of the sine of the Magic Formula", sign=("positive", "any")),
    Parameter("trail", 2, "m, 1", "pneumatic trail at the nominal load, and how it falls with the slip (B)"),
    Parameter("relaxation", 2, "m", "relaxation lengths, longitudinal and lateral", sign="positive"),
)


def _magic_formula() -> Law:
    load0, Re, friction, kx, cornering, kg, shape, trail, relaxation = _MAGIC
    F0, (C, E), (length_x, length_y) = load0.symbol, shape.symbols, relaxation.symbols
    let, kappa, tan_alpha = Let(), symbol("kappa"), symbol("tan_alpha")
    Fz, energy = _load(let)
    excess = let.scalar("excess", Min(1, Fz / F0 - 1))
    mu = let.scalar("mu", friction.symbols[0] + friction.symbols[1] * excess)
    limit = let.scalar("limit", mu * Max(Fz, LEAST_LOAD))
    Ky = let.scalar("Ky", cornering.symbols[0] * F0 * sin(2 * atan(Fz / (cornering.symbols[1] * F0))))
    x = let.scalar("slip_x", kx.symbol * Fz * kappa / limit)
    y = let.scalar("slip_y", (Ky * tan_alpha + kg.symbol * Fz * CAMBER) / limit)
    rho = let.scalar("slip", sqrt(x**2 + y**2 + Rational(1, 10**16)))
    b = let.scalar("b", rho / C)
    share = let.scalar("share", mu * Fz * sin(C * atan(b - E * (b - atan(b)))) / rho)
    Fx, Fy = let.scalar("Fx", share * x), let.scalar("Fy", -share * y)
    t0, B = trail.symbols
    arm = t0 * Fz / F0 * cos(atan(B * tan_alpha))
    speed = let.scalar("speed", Abs(FORWARD))
    states = (
        Internal("kappa", "1", (Re.symbol * ROLLING - FORWARD - speed * kappa) / length_x),
        Internal("tan_alpha", "1", (LATERAL - speed * tan_alpha) / length_y),
    )
    zero = Rational(0)
    return Law(
        name="magic_formula",
        doc=(
            f"{_LOAD_DOC}\n"
            "lx kappadot = Re rolling - forward - |forward| kappa\n"
            "ly (tan alpha)dot = lateral - |forward| tan alpha,  lateral of the contact point\n"
            "mu = mu0 + mu1 min(1, Fz/Fz0 - 1),  Kx = kx Fz,  Ky = c1 Fz0 sin(2 atan(Fz/(c2 Fz0))),  Kg = kg Fz\n"
            "x = Kx kappa/(mu Fz),  y = (Ky tan alpha + Kg camber)/(mu Fz),  slip = |(x, y)|,  b = slip/C\n"
            "(Fx, Fy) = mu Fz sin(C atan(b - E (b - atan b))) (x, -y)/slip, combined slip by similarity\n"
            "Mz = -t0 Fz/Fz0 cos(atan(B tan alpha)) Fy;  tau(longitudinal, lateral, spin) = -(Fx, Fy, Mz)"
        ),
        parameters=(STIFFNESS, DAMPING, *_MAGIC),
        e=(PRESS, CAMBER),
        ed=(PRESS_RATE, CAMBER_RATE),
        s=(FORWARD, ROLLING, LONGITUDINAL, LATERAL, SPIN),
        sigma=(Fz, zero),
        tau=(zero, zero, -Fx, -Fy, arm * Fy),
        energy=energy,
        begins=(*BEGINS, LOAD - 2 * F0),  # where the friction no longer depends on the load
        source="Pacejka, Tyre and Vehicle Dynamics, similarity method and single contact point transient model",
        states=states,
        let=let.entries,
        units=_units(PRESS, CAMBER, FORWARD, ROLLING, LONGITUDINAL, LATERAL, SPIN),
    )


TYRES: tuple[Law, ...] = (_vertical(), _linear(), _calspan(), _magic_formula())
