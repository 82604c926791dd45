"""What a page says of its element beside the mathematics: words from small vocabularies, periods, spans."""

from typing import Any

import pytest
import sympy as sp

from flexel.derive.declare import (
    Deformation,
    Element,
    Let,
    Limit,
    Parameter,
    PlanarAngle,
    PlanarPoint,
)
from flexel.derive.declare.words import FAMILIES, PICTURES, SIGNS
from flexel.derive.spec import DeformationSpec, TermSpec, triangle
from flexel.derive.verify import definitions
from flexel.generated.table import ELEMENTS as TABLE
from flexel.generated.table import LAWS as LAW_TABLE

p, q = PlanarPoint("p"), PlanarAngle("q")
h = Parameter("h", 2, "m", "two lengths")


def element(deformation: Deformation, **fields: Any) -> Element:
    let = Let()
    let.scalar("r", sp.sqrt(p.x.dot(p.x)))
    let.scalar("theta", sp.atan2(p.x[1], p.x[0]))
    return Element("own", (p, q), (h,), let.entries, (deformation,), doc="something of its own", **fields)


theta, r = sp.Symbol("theta", real=True), sp.Symbol("r", real=True)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"family": "beem"}, "element 'own': family 'beem' is unknown; choose one of .*'beam'"),
        ({"picture": "photo"}, "element 'own': picture 'photo' is unknown; choose one of .*'wheel'"),
    ],
)
def test_an_unknown_word_names_the_element_and_lists_the_known_ones(fields: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        element(Deformation("d", "m", p.x[0]), **fields)


def test_kinds_and_signs_are_checked_too() -> None:
    with pytest.raises(
        ValueError, match="deformation 'd': kind 'gab' is unknown; choose one of '', 'gap', 'touch', 'norm'"
    ):
        Deformation("d", "m", p.x[0], kind="gab")
    with pytest.raises(ValueError, match="parameter 'k': sign 'plus' is unknown; choose one of .*'positive'"):
        Parameter("k", 1, "1", "number", sign="plus")
    with pytest.raises(ValueError, match="parameter 'k': 1 signs of 2 components; give one for each"):
        Parameter("k", 2, "1", "numbers", sign=("any",))
    with pytest.raises(ValueError, match="parameter 'S': 4 components are not the upper triangle"):
        Parameter("S", 4, "1", "matrix", sign="semidefinite")


def test_an_element_of_ones_own_is_of_no_family_and_has_no_picture() -> None:
    own = element(Deformation("d", "m", p.x[0]))
    assert (own.family, own.picture, own.span, own.deformations[0].kind) == ("", "", "", "")


@pytest.mark.parametrize("family", [family for family in FAMILIES if family])
def test_every_family_has_members(family: str) -> None:
    assert any(element.family == family for element in TABLE.values())


@pytest.mark.parametrize("picture", [picture for picture in PICTURES if picture])
def test_every_picture_shows_something(picture: str) -> None:
    assert any(element.picture == picture for element in TABLE.values())


@pytest.mark.parametrize("sign", SIGNS)
def test_every_sign_is_asked_for(sign: str) -> None:
    words = {
        w
        for law in LAW_TABLE.values()
        for parameter in law.parameters
        for w in ([parameter.sign] if isinstance(parameter.sign, str) else parameter.sign)
    }
    assert sign in words


@pytest.mark.parametrize("name", [element.name for element in TABLE.values() if element.span])
def test_a_span_takes_nodes_and_parameters_of_what_it_loads(name: str) -> None:
    loaded, span = TABLE[name], TABLE[TABLE[name].span]
    kinds = [node.kind for node in loaded.nodes]
    assert [node.kind for node in span.nodes] in (kinds[: len(span.nodes)], [kinds[0], kinds[-1]])
    assert {(parameter.name, parameter.size) for parameter in span.parameters} <= {
        (parameter.name, parameter.size) for parameter in loaded.parameters
    }


def test_a_limit_is_a_parameter_of_its_law() -> None:
    assert LAW_TABLE["calspan_tyre"].limit is not None
    assert [law.name for law in LAW_TABLE.values() if law.limit] == ["calspan_tyre"]
    law = definitions()["law_calspan_tyre"]
    with pytest.raises(ValueError, match=f"law '{law.name}': the limit x is not one of its parameters"):
        type(law)(**{**vars(law), "limit": Limit(sp.Symbol("x"), "nothing")})


def test_a_law_begins_to_act_at_a_parameter_or_at_zero() -> None:
    begins = {
        law.name: [(at.parameter, at.component) for at in law.begins]
        for law in LAW_TABLE.values()
        if law.begins
    }
    tyres = ("vertical_tyre", "linear_tyre", "calspan_tyre", "magic_formula")
    assert begins == {"stop": [("gap", 0)], "limits": [("low", 0), ("high", 0)]} | dict.fromkeys(
        tyres, [("", 0)]
    )
    law = definitions()["law_stop"]
    with pytest.raises(
        ValueError, match="law 'stop': it begins to act where .* one of its parameters, not x; correct"
    ):
        type(law)(**{**vars(law), "begins": (sp.Symbol("x"),)})


# -- what winds


def test_an_angle_whose_cut_reaches_a_deformation_needs_a_period() -> None:
    with pytest.raises(ValueError, match=r"element 'own': deformation 'd' jumps .* its cut; give .*period="):
        element(Deformation("d", "rad", theta - q.x[0]))
    element(Deformation("d", "rad", theta - q.x[0], period=2 * sp.pi))


def test_a_period_that_is_not_the_jump_is_refused() -> None:
    h0, h1 = h.symbols
    with pytest.raises(
        ValueError, match="element 'own': deformation 'd' jumps by .* not a whole number of the period"
    ):
        element(Deformation("d", "m", q.x[0] - h0 * theta, period=2 * sp.pi * h1))
    element(Deformation("d", "m", q.x[0] - h0 * theta, period=2 * sp.pi * h0))
    element(Deformation("d", "m", q.x[0] - 3 * h0 * theta, period=2 * sp.pi * h0))


def test_an_angle_inside_a_periodic_function_or_away_from_its_cut_needs_none() -> None:
    element(Deformation("d", "m", r - h.symbols[0] * sp.cos(theta - q.x[0])))
    element(Deformation("d", "rad", sp.atan2(p.x[1], sp.sqrt(1 + p.x[0] ** 2)) - q.x[0]))
    element(Deformation("d", "rad", sp.atan2(p.x[1], r) - q.x[0]))
    element(Deformation("d", "rad", theta - q.x[0], period=0))


def test_a_period_is_a_sum_of_products_of_parameters() -> None:
    with pytest.raises(
        ValueError, match="the period .* is not a sum of products of whole powers of parameters"
    ):
        element(Deformation("d", "rad", q.x[0], period=sp.sqrt(h.symbols[0])))
    with pytest.raises(ValueError, match="the period of 'd' contains q_angle"):
        element(Deformation("d", "rad", q.x[0], period=q.x[0]))


def test_the_runtime_finds_a_period_without_sympy() -> None:
    terms = (TermSpec(2.0, (("h", 0, 1), ("h", 1, -1))), TermSpec(-1.0, (("a", 0, 1),)))
    spec = DeformationSpec("d", "m", True, terms)
    assert spec.repeats({"h": (3.0, 2.0), "a": [1.0]}) == 2.0
    assert spec.repeats({"h": (3.0, 2.0), "a": [4.0]}) == 1.0  # whatever the sign
    assert spec.repeats({"h": (3.0, 2.0), "a": [3.0 * (1 + 1e-15)]}) == 0.0  # a difference that is rounding


def test_a_triangle_has_so_many_rows() -> None:
    assert [triangle(n) for n in range(1, 11)] == [1, None, 2, None, None, 3, None, None, None, 4]
