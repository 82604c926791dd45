"""What a page says of its element beside the mathematics: words from small vocabularies, periods, spans."""

import dataclasses
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


def test_a_law_begins_to_act_where_a_linear_form_is_zero() -> None:
    begins = {
        law.name: [tuple(begin) for begin in map(dataclasses.astuple, law.begins)]
        for law in LAW_TABLE.values()
        if law.begins
    }
    one = ((1.0, ()),)
    pressed = [(one, (), ()), (((1.0, (("stiffness", 0, 1),)),), ((1.0, (("damping", 0, 1),)),), ())]
    full = {"calspan_tyre": (-1.0, (("A", 2, 1),)), "magic_formula": (-2.0, (("load0", 0, 1),))}
    tyres: dict[str, list[Any]] = {"vertical_tyre": pressed, "linear_tyre": pressed}
    tyres |= {name: [*pressed, (*pressed[1][:2], (load,))] for name, load in full.items()}
    level = {name: (one, (), ((-1.0, ((name, 0, 1),)),)) for name in ("gap", "low", "high")}
    kinks = [((-1.0, (("kinks", i, 1),)),) for i in range(15)]
    curves = {
        "spring_curve": [(one, (), kink) for kink in kinks],
        "damper_curve": [((), one, kink) for kink in kinks],
    }
    stops = {"stop": [level["gap"]], "limits": [level["low"], level["high"]]}
    assert begins == stops | curves | tyres


@pytest.mark.parametrize("expr", ["x", "e**2", "gap", "e*ed", "e - cos(gap)"])
def test_another_beginning_of_a_law_is_refused(expr: str) -> None:
    law = definitions()["law_stop"]
    names = {s.name: s for s in (law.e[0], law.ed[0], *law.parameter_symbols)}
    with pytest.raises(ValueError, match="law 'stop': begins .* (is not linear in|is not a sum of products)"):
        type(law)(**{**vars(law), "begins": (sp.sympify(expr, names),)})
