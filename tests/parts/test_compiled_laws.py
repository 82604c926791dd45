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
