"""A law that drives what moves: a damper whose constant may be negative, which `Model.spring` does not admit."""

import flexel as fx
from flexel.derive import Law, Parameter, symbol
from flexel.derive.compiled import CompiledLaw


def driver() -> CompiledLaw:
    """A spring and a damper of either sign."""
    e, ed = symbol("e"), symbol("ed")
    k, c = Parameter("k", 1, "N/m", "stiffness"), Parameter("c", 1, "N s/m", "damping; negative: it drives")
    force = k.symbol * e + c.symbol * ed
    text = "sigma = k e + c ed"
    energy = k.symbol * e**2 / 2
    return fx.compile_law(
        Law("campaign_driver", text, (k, c), (e,), (ed,), (), (force,), (), energy, "campaign")
    )
