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
ROUNDING = 1e-25  # of the difference, relative to the largest number of the law, where a stress is zero
POINTS = 4
DIGITS, STEP = 50, sp.Float(10, 50) ** -15  # of the difference quotient of the energy


def check_stored(law: Law, data: Mapping[str, NDArray[np.float64]]) -> None:
    """Raise ValueError for an energy whose slope is not the elastic stress, at pairs of sampled deformations."""
    depends = {
        symbol for expr in (*law.sigma, *(expr for _, expr in law.let)) for symbol in expr.free_symbols
    }
    if len(law.e) != 1 or law.states or law.energy == 0 or TIME in depends:
        return
    largest = _largest_number(law)
    for i in range(POINTS):
        parameters = dict(zip(law.parameter_symbols, data["p"][i], strict=True))
        floor = ROUNDING * max([largest, *(abs(value) for value in parameters.values())])
        near, far = (_sides(law, parameters, float(data["e"][j, 0])) for j in (i, i + POINTS))
        off = (near[0] - near[1]) - (far[0] - far[1])
        allowed = max(floor, *(TOLERANCE * abs(value) for value in (*near, *far)))
        if abs(off) > allowed:  # false for NaN: outside the domain
            raise ValueError(
                f"law '{law.name}': the derivative of the energy {law.energy} is not the stress at rest, of "
                f"{law.sigma[0]}; correct one of them, or leave the energy out"
            )


def _largest_number(law: Law) -> float:
    """Return the largest number in the stress and the energy, at least 1: the size of the terms that may cancel."""
    numbers = law.sigma[0].atoms(sp.Number) | law.energy.atoms(sp.Number)
    return max([1.0, *(abs(float(number)) for number in numbers if number.is_finite)])


def _sides(law: Law, parameters: Mapping[sp.Symbol, float], at: float) -> tuple[complex, complex]:
    """Return the stress at rest and slope of the energy at a deformation."""
    e, half = sp.Float(at, DIGITS), STEP / 2
    ends = [_values(law, parameters, strain)[1] for strain in (e - half, e + half)]
    return complex(_values(law, parameters, e)[0]), complex((ends[1] - ends[0]) / STEP)


def _values(law: Law, parameters: Mapping[sp.Symbol, float], at: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the stress at rest and the energy; named intermediates are computed one by one, as in the kernels."""
    known: dict[sp.Symbol, sp.Expr] = dict.fromkeys((*law.ed, *law.s), sp.S.Zero)
    known |= {symbol: sp.Float(float(value), DIGITS) for symbol, value in parameters.items()} | {law.e[0]: at}
    for symbol, expr in law.let:
        known[symbol] = expr.xreplace(known).evalf(DIGITS)
    return law.sigma[0].xreplace(known).evalf(DIGITS), law.energy.xreplace(known).evalf(DIGITS)
