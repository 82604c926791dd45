"""The stored energy of a law must belong to its stress, where an error can be distinguished from intent.

A law of one deformation without internal states and time stores the work of its elastic stress: the stress at rest may
differ from the slope of the energy by a constant (an actuator) only. Several deformations may have stresses
without an energy (circulatory ones), internal states may take a part of it, and a law may store nothing.
"""

from collections.abc import Mapping

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from flexel.derive.declare import TIME, Law

TOLERANCE = 1e-9  # of the difference, relative to stress and slope
POINTS = 4
DIGITS, STEP = 50, sp.Float(10, 50) ** -15  # of the difference quotient of the energy


def check_stored(law: Law, data: Mapping[str, NDArray[np.float64]]) -> None:
    """Raise ValueError for an energy whose slope is not the elastic stress, at pairs of sampled deformations."""
    depends = {z for expr in (*law.sigma, *(expr for _, expr in law.let)) for z in expr.free_symbols}
    if len(law.e) != 1 or law.states or law.energy == 0 or TIME in depends:
        return
    for i in range(POINTS):
        parameters = dict(zip(law.parameter_symbols, data["p"][i], strict=True))
        near, far = (_sides(law, parameters, float(data["e"][j, 0])) for j in (i, i + POINTS))
        off = (near[0] - near[1]) - (far[0] - far[1])
        if abs(off) > TOLERANCE * max(abs(z) for z in (*near, *far)):  # false for NaN: outside the domain
            raise ValueError(
                f"law '{law.name}': the derivative of the energy {law.energy} is not the stress at rest, of "
                f"{law.sigma[0]}; correct one of them, or leave the energy out"
            )


def _sides(law: Law, parameters: Mapping[sp.Symbol, float], at: float) -> tuple[complex, complex]:
    """Stress at rest and slope of the energy at a deformation."""
    e, half = sp.Float(at, DIGITS), STEP / 2
    ends = [_values(law, parameters, z)[1] for z in (e - half, e + half)]
    return complex(_values(law, parameters, e)[0]), complex((ends[1] - ends[0]) / STEP)


def _values(law: Law, parameters: Mapping[sp.Symbol, float], at: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Stress at rest and energy; the named intermediates are computed one after another, as the kernels do it."""
    known: dict[sp.Symbol, sp.Expr] = dict.fromkeys((*law.ed, *law.s), sp.S.Zero)
    known |= {z: sp.Float(float(value), DIGITS) for z, value in parameters.items()} | {law.e[0]: at}
    for symbol, expr in law.let:
        known[symbol] = expr.xreplace(known).evalf(DIGITS)
    return law.sigma[0].xreplace(known).evalf(DIGITS), law.energy.xreplace(known).evalf(DIGITS)
