"""Pages of a cable as users write them, for tests: the built-in ones under another name, and a law that hardens."""

from dataclasses import replace

import flexel as fx
from flexel.derive import Parameter
from flexel.derive.elements.cable import PLANAR_CABLE
from flexel.derive.laws.cable_laws import CABLE

HARDENING = Parameter(
    "hardening", 1, "1", "increase of the stiffness in tension per strain", sign="not negative"
)
LINEAR = CABLE[0]
EA, L0 = (next(p for p in LINEAR.parameters if p.name == name).symbol for name in ("EA", "l0"))
_MEAN = LINEAR.e[0]

# The tension of a uniform strain is EA (strain + hardening strain²).
HARDER = replace(
    LINEAR,
    name="harder_cable",
    doc="as the built-in law, and EA l0 hardening strain1²",
    parameters=(*LINEAR.parameters, HARDENING),
    sigma=(LINEAR.sigma[0] + EA * L0 * HARDENING.symbol * _MEAN**2, *LINEAR.sigma[1:]),
    energy=LINEAR.energy + EA * L0 * HARDENING.symbol * _MEAN**3 / 3,
)
OWN_CABLE = fx.compile_element(replace(PLANAR_CABLE, name="own_cable"))
OWN_LAW = fx.compile_law(HARDER)
