"""Formulas and compiled laws: verified where they are real, and attached alike."""

from typing import Any

import numpy as np
import pytest
import sympy
from mechanisms import slider

from flexel.base.errors import ModelError
from flexel.derive import Law, Parameter, symbol
from flexel.parts.elements import compile_law


@pytest.mark.parametrize(
    "formula",
    [
        lambda e, ed: 1e8 * e**7 + 3 * ed,  # differences over a wide range lose digits
        lambda e, ed: sympy.sqrt(sympy.Rational(1, 100) - e),  # real on one side only
        lambda e: sympy.exp(50 * e) - 1,
        lambda e: sympy.tan(40 * e),
    ],
)
def test_a_formula_is_verified_where_it_is_real(formula: Any) -> None:
    m = slider()
    m.law("strut.elongation", formula)
    m.initial("strut.elongation", 0.005)
    assert np.isfinite(m.build().initial.force("strut.elongation"))


def test_a_compiled_law_is_attached_like_a_formula() -> None:
    e, ed = symbol("e"), symbol("ed")
    k = Parameter("k", 1, "N/m", "stiffness")
    cubic = compile_law(
        Law(
            "own_cubic",
            "k e + e**3",
            (k,),
            (e,),
            (ed,),
            (),
            (k.symbol * e + e**3,),
            (),
            k.symbol * e**2 / 2 + e**4 / 4,
        )
    )
    forces = []
    for given in ({"law": cubic, "k": 3.0}, {"law": lambda e: 3 * e + e**3}):
        m = slider()
        m.law("strut.elongation", **given)  # type: ignore[arg-type]
        m.initial("strut.elongation", 0.2)
        forces.append(m.build().initial.force("strut.elongation"))
    assert forces == pytest.approx([0.608, 0.608])
    with pytest.raises(ModelError, match="law 'own_cubic' on 'strut.elongation': parameters are missing: k"):
        slider().law("strut.elongation", cubic)
    with pytest.raises(ModelError, match="a compiled law already has an energy; leave energy out"):
        slider().law("strut.elongation", cubic, energy=lambda e: e**2)
    with pytest.raises(ModelError, match=r"attach: this law is a compiled one; use m.law\(on, law"):
        slider().attach(cubic, ["strut.elongation"], k=3.0)  # type: ignore[arg-type]


def test_a_power_within_a_piece_has_no_slope_beyond_it() -> None:
    """The force of Hertz: it was refused, because its slope beyond the contact was zero times no number."""
    e, ed = symbol("e"), symbol("ed")
    k, gap = Parameter("k", 1, "N/m^1.5", "stiffness", sign="positive"), Parameter("gap", 1, "m", "gap")
    depth = gap.symbol - e
    force = -k.symbol * sympy.Piecewise((depth ** sympy.Rational(3, 2), e < gap.symbol), (0, True))
    energy = (
        k.symbol
        * sympy.Piecewise((depth ** sympy.Rational(5, 2), e < gap.symbol), (0, True))
        * sympy.Rational(2, 5)
    )
    hertz = compile_law(Law("own_hertz", "Hertz", (k, gap), (e,), (ed,), (), (force,), (), energy))
    for at, slope in ((0.3, 0.0), (0.1 - 0.04, 1.5 * 100.0 * 0.2)):
        m = slider()
        m.law("strut.elongation", hertz, k=100.0, gap=0.1)
        m.initial("strut.elongation", at)
        system = m.build()
        depth_there = max(0.0, 0.1 - at)
        assert system.initial.force("strut.elongation") == pytest.approx(-100.0 * depth_there**1.5, abs=1e-12)
        assert system.initial.energy.strain == pytest.approx(40.0 * depth_there**2.5, abs=1e-12)
        assert system.linearize().K[0, 0] == pytest.approx(slope, abs=1e-9)
