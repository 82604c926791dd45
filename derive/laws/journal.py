"""Law of a journal bearing: an elastic shell, and friction in proportion to the load that it carries."""

import sympy as sp

from flexel.derive.declare import Law, Let, Parameter, symbol

STIFFNESS = Parameter("stiffness", 1, "N/m", "radial stiffness", sign="not negative")
DAMPING = Parameter("damping", 1, "N s/m", "radial damping", sign="not negative")
ARM = Parameter(
    "friction_radius", 1, "m", "coefficient of friction times the radius of the journal", sign="not negative"
)
SPEED = Parameter(
    "slip_speed", 1, "rad/s", "speed of turning at which 71 % of the friction acts", sign="positive"
)


def _journal() -> Law:
    e, ed = ([symbol(f"{name}_{i}") for i in range(3)] for name in ("e", "ed"))
    k, d, arm, speed = (p.symbol for p in (STIFFNESS, DAMPING, ARM, SPEED))
    let = Let()
    forces = [let.scalar(f"N{i + 1}", k * e[i] + d * ed[i]) for i in range(2)]
    square = let.scalar("square", forces[0] ** 2 + forces[1] ** 2)
    loaded = (
        square > 0
    )  # the root has no derivative at zero; named, because SymPy takes roots of pieces apart
    safe = let.scalar("safe", sp.Piecewise((square, loaded), (1, True)))
    N = let.scalar("N", sp.Piecewise((sp.sqrt(safe), loaded), (0, True)))
    torque = arm * N * ed[2] / sp.sqrt(ed[2] ** 2 + speed**2)
    return Law(
        name="journal",
        doc=(
            "N_i = stiffness e_i + damping ed_i in two directions (i = 0, 1), N = |(N_0, N_1)|\n"
            "torque = friction_radius N w/sqrt(w^2 + slip_speed^2) on the angle e_2, w = ed_2"
        ),
        parameters=(STIFFNESS, DAMPING, ARM, SPEED),
        e=tuple(e),
        ed=tuple(ed),
        s=(),
        sigma=(*forces, torque),
        tau=(),
        energy=k * (e[0] ** 2 + e[1] ** 2) / 2,
        source="Coulomb's friction on a journal, regularized",
        let=let.entries,
        units=("m", "m", "rad"),
    )


JOURNAL: tuple[Law, ...] = (_journal(),)
