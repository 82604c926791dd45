"""Errors in user-defined elements and laws are named."""

from typing import Any

import pytest
import sympy as sp
from own_elements import L0, P, Q, own_bar

import flexel as fx
from flexel.derive import Deformation, Element, Law, Let, Parameter, Slip, symbol

pytestmark = pytest.mark.usefixtures("cache")


def test_an_energy_that_is_not_that_of_the_stress_is_refused() -> None:
    e, ed, k = symbol("e"), symbol("ed"), Parameter("k", 1, "N/m", "stiffness").symbol
    let = Let()
    pull = let.scalar("pull", k * e)

    def law(name: str, stress: Any, energy: Any) -> Law:
        stiffness = Parameter("k", 1, "N/m", "stiffness")
        return Law(name, "spring", (stiffness,), (e,), (ed,), (), (stress,), (), energy, let=let.entries)

    with pytest.raises(fx.ElementError, match=r"law 'twice': the derivative of the energy .*correct one"):
        fx.compile_law(law("twice", pull + 3 * ed, 5 * k * e**2))
    fx.compile_law(law("pushed", pull + 3 * ed + 7, pull * e / 2))  # an actuator beside the spring
    fx.compile_law(law("stores_nothing", pull, sp.S.Zero))


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (
            P.x[0] - sp.Symbol("k"),
            "'wrong': deformation 'd' contains k: not a coordinate.*declare a Parameter",
        ),
        (P.x[0] - sp.Symbol("l0"), "contains l0: .*parameter.symbol"),  # not real: another symbol
        (P.x - Q.x, "deformation 'd' is not a scalar expression but .*Matrix.*declare each component"),
        (2 * L0.symbol, "deformation 'd' depends on no coordinate"),
        (sp.Abs(P.x[0]), "'wrong': deformation 'd' contains Abs.*kink.*Piecewise"),
        (
            sp.Piecewise((0, P.x[0] < 0), (P.x[0], True)),
            "'wrong': deformation 'd': the pieces .* do not join smoothly",
        ),
        (sp.Piecewise((0, P.x[0] < L0.symbol), (1, True)), "do not join smoothly where l0 - p_x = 0"),
        (sp.Piecewise((sp.sqrt(P.x[0]), P.x[0] > 0), (0, True)), "do not join smoothly where p_x = 0"),
        (
            sp.Piecewise((P.x[0], P.x[0] > 0)),
            "'d': .* has no value on one side of p_x = 0; give every case a piece",
        ),
        (sp.floor(P.x[0]), "floor cannot be differentiated.*use powers"),
        (sp.Function("profile")(P.x[0]), "'d' contains profile.*cannot be differentiated"),
        (P.x[0] / sp.S.Zero, "not real and finite"),
    ],
)
def test_a_wrong_deformation_is_named(expression: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        fx.compile_element(Element("wrong", (P, Q), (L0,), (), (Deformation("d", "m", expression),), doc="d"))


def test_an_element_of_nothing_is_refused() -> None:
    with pytest.raises(
        ValueError, match="element 'wrong': it has no deformation, slip or energy; declare one"
    ):
        Element("wrong", (P, Q), (L0,), doc="d")


def test_meanings_and_units_are_asked_for() -> None:
    with pytest.raises(ValueError, match="parameter 'k' has no doc; say"):
        Parameter("k", 1, "m", " ")
    with pytest.raises(ValueError, match="parameter 'k' has no unit"):
        Parameter("k", 1, "", "stiffness")
    with pytest.raises(ValueError, match="element 'own_bar': the element has no doc"):
        own_bar(doc="")
    with pytest.raises(ValueError, match="element 'own_bar': 'slide' has no unit"):
        own_bar(slips=(Slip("slide", "", P.v[0]),))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"sigma": symbol("e")}, "law 'own': sigma holds e; give a tuple"),
        ({"parameters": ("k",)}, "law 'own': parameters holds 'k'; give a tuple of Parameter"),
        ({"states": (symbol("z"),)}, "law 'own': states holds z; give a tuple of Internal"),
    ],
)
def test_parts_of_a_law_that_are_no_lists_are_named(change: dict[str, Any], message: str) -> None:
    e, ed = symbol("e"), symbol("ed")
    parts = {"parameters": (), "e": (e,), "ed": (ed,), "s": (), "sigma": (e,), "tau": (), **change}
    with pytest.raises(ValueError, match=message):
        Law("own", "a law", **parts)


def test_parts_of_an_element_and_ranges_that_are_no_lists_are_named() -> None:
    with pytest.raises(ValueError, match="'own_bar': deformations holds Deformation.*give a tuple of Deform"):
        own_bar(deformations=Deformation("d", "m", P.x[0]))
    for ranges, message in (
        ([1, 2], r"ranges \[1, 2\] have no names"),
        ({"p_x": 3}, "range 3 of 'p_x' is not"),
    ):
        with pytest.raises(fx.ElementError, match=f"'own_bar'.*{message}"):
            fx.compile_element(own_bar(), ranges=ranges)  # type: ignore[arg-type]


def test_a_definition_that_is_not_real_everywhere_needs_a_range() -> None:
    wrong = own_bar(name="rooted", deformations=(Deformation("d", "m", sp.sqrt(P.x[0])),))
    with pytest.raises(fx.ElementError, match="'rooted': .*not finite.*ranges="):
        fx.compile_element(wrong)
    with pytest.raises(fx.ElementError, match="'rooted': a range of unknown 'x'; there are l0,.* p_x"):
        fx.compile_element(wrong, ranges={"x": (1, 2)})
    with pytest.raises(fx.ElementError, match=r"range \(2, 1\) of 'p_x' is not \(lowest, highest\)"):
        fx.compile_element(wrong, ranges={"p_x": (2, 1)})
    assert fx.compile_element(wrong, ranges={"p_x": (0.2, 1)}).spec.name == "rooted"


def test_kernels_that_lose_digits_are_refused() -> None:
    x = P.x[0]
    lost = own_bar(name="lossy", deformations=(Deformation("d", "m", (10**7 + x) ** 2 - (10**7 - x) ** 2),))
    with pytest.raises(
        fx.ElementError, match="(?s)'lossy': the compiled kernels differ.*NOT OK.*fewer digits"
    ):
        fx.compile_element(lost)
    with pytest.raises(fx.ElementError, match="differ"):  # and it is not remembered as good
        fx.compile_element(lost)


def test_a_missing_compiler_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(fx.CompilerError, match="element 'uncompiled': no C compiler.*apt install gcc"):
        fx.compile_element(own_bar(name="uncompiled"))


def test_the_name_of_a_built_in_element_is_taken() -> None:
    with pytest.raises(fx.ElementError, match="'truss': flexel has an element of this name"):
        fx.compile_element(own_bar(name="truss"))
