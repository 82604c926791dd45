"""The stored energy of formulas: in closed form, given, by quadrature over a range, or none with a warning."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from mechanisms import slider

from flexel.base.errors import ModelError, ModelWarning
from flexel.derive.declare import Law, symbol
from flexel.derive.energy import by_gauss, closed_form, kinks
from flexel.derive.general import general
from flexel.derive.spec import FORMULA_NUMBERS
from flexel.derive.user_definitions import compile_law
from flexel.derive.verify import verify
from flexel.derive.verify.kernel_calls import Compiled
from flexel.parts.formulas import Formula, formula_law

GM, RADIUS, ROOT = 4.9e12, 2e5, 5**0.5
E, ED = symbol("e"), symbol("ed")


@pytest.fixture(autouse=True)
def fresh_cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def outputs(formula: Formula, at: float) -> tuple[float, float]:
    """Stress and stored energy at a deformation."""
    compiled, values = formula.law, formula.parameters.get(FORMULA_NUMBERS, np.zeros(0))
    data = {
        "e": np.array([[at]]),
        "ed": np.zeros((1, 1)),
        "s": np.zeros((1, 0)),
        "z": np.zeros((1, 0)),
        "t": np.zeros((1, 1)),
        "p": values.reshape(1, -1),
    }
    found = Compiled(compiled.spec, compiled.address)("law", data)
    return found["sigma"].item(), found["U"].item()


@pytest.mark.parametrize(
    ("stress", "energy", "at"),
    [
        (lambda e: 1 / (e + ROOT) ** 2, lambda e: 1 / ROOT - 1 / (e + ROOT), 0.7),
        (
            lambda e: sympy.Piecewise((1e4 * (e - 0.95), e > 0.95), (0, True)),
            lambda e: 5e3 * max(e - 0.95, 0) ** 2,
            1.4,
        ),
        (lambda e: GM / (RADIUS + e) ** 2, lambda e: GM * e / (RADIUS * (RADIUS + e)), 40.0),
        (
            lambda e: -1e5 * sympy.Max(-e, 0) ** sympy.Rational(3, 2),
            lambda e: 4e4 * max(-e, 0) ** 2.5,
            -0.02,
        ),
    ],
    ids=["inverse square", "spring with play", "gravity far from the centre", "contact"],
)
def test_the_energy_found_for_a_formula_is_its_closed_integral(
    stress: Callable[..., Any], energy: Callable[[float], float], at: float
) -> None:
    found = formula_law("law", stress)
    assert outputs(found, at)[1] == pytest.approx(energy(at), rel=1e-14)
    assert outputs(found, -at)[1] == pytest.approx(energy(-at), rel=1e-14, abs=1e-300)


@pytest.mark.long
def test_an_integral_without_elementary_functions_is_quadrature_over_the_range() -> None:
    found = formula_law("law", lambda e: sympy.exp(-(e**2)), ranges={"e": (-2.0, 2.0)})
    for at in (-1.9, -0.3, 0.0, 1.5):
        assert outputs(found, at)[1] == pytest.approx(math.sqrt(math.pi) / 2 * math.erf(at), abs=1e-14)


def test_quadrature_ends_at_the_kinks_of_a_formula() -> None:
    stress = sympy.exp(-(E**2)) * sympy.Max(E - 0.3, 0)
    assert kinks(stress, E) == (0.3,)
    found = by_gauss(stress, E, -1.0, 1.0)
    erf_part = math.sqrt(math.pi) / 2 * (math.erf(0.8) - math.erf(0.3))
    closed = (math.exp(-0.09) - math.exp(-0.64)) / 2 - 0.3 * erf_part
    assert float(found.subs(E, 0.8)) == pytest.approx(closed, rel=1e-13)
    assert float(found.subs(E, -0.5)) == 0.0


def test_a_formula_without_an_energy_is_used_and_it_is_said() -> None:
    with pytest.warns(ModelWarning, match=r"no stored energy of exp\(sin\(e\)\).*energy=.*ranges="):
        found = formula_law("law", lambda e: sympy.exp(sympy.sin(e)))
    assert outputs(found, 0.7) == (pytest.approx(math.exp(math.sin(0.7)), rel=1e-15), 0.0)


def test_quadrature_that_is_not_accurate_in_a_range_is_not_used() -> None:
    with pytest.warns(ModelWarning, match="no stored energy"):
        found = formula_law("law", lambda e: sympy.exp(-(e**2)), ranges={"e": (-60.0, 60.0)})
    assert outputs(found, 1.0)[1] == 0.0


def test_a_given_energy_is_checked_in_the_ranges_given_and_again_in_others() -> None:
    def stored(e: Any) -> Any:
        return sympy.Piecewise((e**2 / 2, e < 3), (9 / 2 + 2 * (e - 3) ** 2 + 3 * (e - 3), True))

    formula_law("law", lambda e: e, stored, ranges={"e": (-1.0, 1.0)})
    with pytest.raises(ModelError, match="derivative of the energy"):
        formula_law("law", lambda e: e, stored, ranges={"e": (4.0, 8.0)})


def test_a_formula_is_verified_where_it_is_used() -> None:
    with pytest.raises(ModelError, match="not finite"):
        formula_law("law", lambda e: sympy.log(e + 2), ranges={"e": (-3.0, 1.0)})


def test_a_power_that_differences_cannot_resolve_is_compared_with_the_definition_everywhere() -> None:
    force, stored = GM / (RADIUS + E) ** 2, GM * E / (RADIUS * (RADIUS + E))
    law = Law("far", "far", (), (E,), (ED,), (), (force,), (), stored)
    wrong = Law("far", "far", (), (E,), (ED,), (), (force,), (), stored * (1 + sympy.Float(1e-9)))
    compiled = compile_law(law)
    assert all(row.ok for row in verify(compiled.spec, compiled.address, law, {}))
    assert not all(row.ok for row in verify(compiled.spec, compiled.address, wrong, {}))


def test_integrals_are_elementary_or_none() -> None:
    assert closed_form(sympy.sin(E**2), E) is None
    assert closed_form(sympy.exp(-(E**2)), E) is None
    assert sympy.simplify(closed_form(sympy.cos(E), E) - sympy.sin(E)) == 0


def test_energy_and_range_of_a_spring_count_from_its_free_length() -> None:
    m = slider(2.0)
    free = float(m.instances["strut"].parameters["l0"][0]) + 0.1
    m.spring(
        "strut.elongation",
        lambda e: 300 * sympy.sin(e) * sympy.exp(sympy.cos(e)),
        free_length=free,
        energy=lambda e: -300 * sympy.exp(sympy.cos(e)),
        ranges={"e": (-0.5, 0.5)},
    )
    m.initial("strut.elongation", 0.3)
    motion = m.build().simulate(1.0, samples=11, rtol=1e-10, atol=1e-12)
    shift = motion["strut.elongation"] - 0.1
    assert np.max(np.abs(motion.energy["strain"] + 300 * np.exp(np.cos(shift)))) < 1e-10
    assert np.ptp(motion.energy["total"]) < 1e-7 * abs(motion.energy["total"][0])


def test_formulas_that_differ_in_numbers_are_compiled_once() -> None:
    found = []
    for a, b, c in np.random.default_rng(3).normal(size=(12, 3)) * [1e3, 1e5, 3]:
        found.append(formula_law("law", lambda e, a=a, b=b, c=c: a * e + b * e**3 + c * sympy.sin(e + a)))  # type: ignore[misc]
        stress = a * 0.3 + b * 0.027 + c * math.sin(0.3 + a)
        stored = a * 0.045 + b * 0.0081 / 4 + c * (math.cos(a) - math.cos(0.3 + a))
        assert outputs(found[-1], 0.3) == (pytest.approx(stress, rel=1e-13), pytest.approx(stored, rel=1e-12))
    assert len({formula.law.spec.digest for formula in found}) == 1
    assert len({formula.law.code.path for formula in found}) == 1


def test_numbers_become_parameters_in_an_order_that_does_not_depend_on_them() -> None:
    def shape(a: float, b: float, c: float) -> tuple[Any, ...]:
        stress = a * E + b * E**2 - sympy.Max(c - E, 0) ** 1.5
        law, values = general(Law("f", "f", (), (E,), (ED,), (), (stress,), (), a * E**2 / 2))
        restored = law.sigma[0].subs(dict(zip(law.parameter_symbols, values, strict=True)))
        assert sympy.simplify(restored - stress) == 0
        return law.sigma, law.energy, law.parameter_symbols

    assert shape(2.0, 3.0, 5.0) == shape(-7.5, 0.2, 1e6) == shape(3.0, 2.0, -0.1)


def test_a_number_that_cannot_be_a_parameter_remains_in_place() -> None:
    found = formula_law("law", lambda e: 3.0 * (2.0**e - 1))
    assert outputs(found, 0.5)[0] == pytest.approx(3 * (math.sqrt(2) - 1), rel=1e-14)


def test_the_numbers_of_a_formula_are_not_parameters_of_the_system() -> None:
    """Its energy has others, which follow from them."""
    m = slider(2.0)
    m.spring("strut.elongation", lambda e: 3e3 * e + 2e5 * e**3)
    assert not [name for name in m.build().parameters if FORMULA_NUMBERS in name]
