"""Forces that a sampled controller holds, and what it remembers: internal states that change at its instants only."""

import sympy as sp

from flexel.derive.declare import Internal, Law, symbol


def _held(slips: bool) -> Law:
    e, ed, s, u = symbol("e"), symbol("ed"), symbol("s"), symbol("u")
    force = (-u,)
    return Law(
        name="slip_held" if slips else "held",
        doc=f"{'tau' if slips else 'sigma'} = -u, du/dt = 0",
        parameters=(),
        e=() if slips else (e,),
        ed=() if slips else (ed,),
        s=(s,) if slips else (),
        sigma=() if slips else force,
        tau=force if slips else (),
        source="zero-order hold",
        states=(Internal("u", "N or N m", sp.S.Zero),),
    )


MEMORY = Law(
    name="memory",
    doc="dz/dt = 0, without a force",
    parameters=(),
    e=(),
    ed=(),
    s=(),
    sigma=(),
    tau=(),
    source="state of a sampled controller",
    states=(Internal("z", "1", sp.S.Zero),),
)

HELD: tuple[Law, ...] = (_held(False), _held(True), MEMORY)
