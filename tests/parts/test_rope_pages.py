"""Ropes with pages of users: the element and the law of their cables."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from own_cables import HARDER, LINEAR, OWN_CABLE, OWN_LAW
from test_ropes import T, over_a_sheave

import flexel as fx
from flexel.parts.cable_results import cable_tension

BUILT_IN_EA = 1e5
HARDENING = 200.0
OWN: dict[str, Any] = {"element": OWN_CABLE, "law": OWN_LAW, "parameters": {"hardening": HARDENING}}


def changed(**fields: Any) -> Any:
    """The user's element with another specification."""
    return replace(OWN_CABLE, spec=replace(OWN_CABLE.spec, **fields))


def test_the_page_of_the_built_in_cable_under_another_name_gives_equal_digits() -> None:
    """Also with its law under another name, where the hardening is zero."""
    found = []
    for given in ({}, {"element": OWN_CABLE}, OWN | {"parameters": {"hardening": 0.0}}):
        m, rope = over_a_sheave(turning=0.1, contact=fx.Contact(1e10, friction=0.2), **given)
        s = m.build()
        rest = s.equilibrium()
        motion = s.simulate(2e-3, start=rest, method="generalized-alpha", step=5e-4, samples=3)
        found.append(
            [motion.x, rope.tension(motion)[1], rope.curvature(rest)[1], rope.contact_force(motion, "S")[1]]
        )
    assert len(rope.elements) == 28
    for values in zip(*found, strict=True):
        assert np.array_equal(values[0], values[1])
        assert np.array_equal(values[0], values[2])


def test_tension_and_contact_follow_another_law() -> None:
    """The tension is EA (strain + hardening strain²), and the contact carries it: T times the angle."""
    m, rope = over_a_sheave(**OWN)
    rest = m.build().equilibrium()
    strain, tension = rope.strain(rest)[1], rope.tension(rest)[1]
    assert strain == pytest.approx(np.full(strain.size, T / BUILT_IN_EA), rel=0.03)
    assert tension.mean() == pytest.approx(BUILT_IN_EA * np.mean(strain + HARDENING * strain**2), rel=1e-5)
    assert tension.mean() > 1.05 * T
    assert rope.resultant(rest, "S") == pytest.approx(np.pi * tension.mean(), rel=1e-3)


@pytest.mark.parametrize("line", [False, True])
def test_a_stretched_straight_cable_has_the_tension_of_its_law(line: bool) -> None:
    m, stretch = fx.Model(), 1.002
    given = OWN | {"EA": 1e5, "EI": 1.0}
    if line:
        made = m.cable_line("c", [(0, 0), (2 * stretch, 0)], 2, length=2.0, **given)
        m.fix(*made.points)
    else:
        ends = m.point("A", (0, 0), fixed=True), m.slope("a", (1, 0)), m.point("B", (stretch, 0), fixed=True)
        m.cable("c1", *ends, m.slope("b", (1, 0)), 1.0, **given)
    state = m.build().equilibrium()
    expected = 1e5 * (0.002 + HARDENING * 0.002**2)
    assert cable_tension(state, "c1")[1] == pytest.approx(np.full(3, expected), rel=1e-9)


def test_its_parameters_have_names_and_can_be_varied() -> None:
    m, rope = over_a_sheave(**OWN)
    s = m.build()
    assert s.parameters["rope.parameters.hardening"] == [HARDENING]
    assert s.parameters["rope.hardening"] == [HARDENING]  # as of all numbers within a part
    assert s.parameters["rope3.hardening"] == [HARDENING]
    other = s.with_parameters({"rope.hardening": 2 * HARDENING, "rope.EI": 2e-5})
    direct = over_a_sheave(**(OWN | {"EI": 2e-5, "parameters": {"hardening": 2 * HARDENING}}))[0].build()
    assert np.array_equal(other.equilibrium().x, direct.equilibrium().x)
    assert rope.tension(other.equilibrium())[1].mean() > 1.15 * T


def test_it_is_written_as_a_program_and_saved(tmp_path: Any) -> None:
    m = fx.Model()
    m.cable_line("c", [(0, 0), (1, 0.2)], 2, EA=1e5, EI=1.0, **OWN)
    program = str(m.program())
    assert "element=own_cables.OWN_CABLE" in program
    assert "law=own_cables.OWN_LAW" in program
    names: dict[str, Any] = {}
    exec(program, names)
    loaded = fx.load(m.save(tmp_path / "rope.json"))
    assert isinstance(loaded, fx.Model)
    for made in (names["m"], loaded):
        assert str(made.program()) == program
        assert made.build().parameters["c1.hardening"] == [HARDENING]


OUTPUTS = OWN_CABLE.spec.kernels["outputs"]
FEWER = {**OWN_CABLE.spec.kernels, "outputs": replace(OUTPUTS, outputs=OUTPUTS.outputs[:1])}
SHORTER = replace(OUTPUTS.outputs[1], shape=(2,))
UNEQUAL = {
    **OWN_CABLE.spec.kernels,
    "outputs": replace(OUTPUTS, outputs=(OUTPUTS.outputs[0], SHORTER, *OUTPUTS.outputs[2:])),
}


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"element": HARDER},
            r"element 'harder_cable' is not a compiled element; give .*fx\.compile_element",
        ),
        ({"element": "cable"}, r"element ''cable'' is not a compiled element"),
        ({"law": LINEAR}, r"law 'planar_cable_stiffness' is not a compiled law; give .*fx\.compile_law"),
        ({"element": OWN_LAW}, r"element 'harder_cable' is not a compiled element"),
        (
            {"element": changed(family="")},
            r"element 'own_cable' is not declared as a cable; add family='cable'",
        ),
        (
            {"element": changed(nodes=OWN_CABLE.spec.nodes[:2])},
            r"has the nodes \(planar point, planar slope\); declare",
        ),
        ({"element": changed(parameters=OWN_CABLE.spec.parameters[1:])}, r"has no parameter 'l0'.*add it"),
        (
            {"element": changed(slips=(object(),))},
            r"has slips, on which no law of a cable acts; leave them out",
        ),
        ({"element": changed(kernels=FEWER)}, r"reports no tension; add Output\('tension', 'N', …\)"),
        (
            {"element": changed(kernels=UNEQUAL)},
            r"at different numbers of points; report them at the same ones",
        ),
        (
            {"element": changed(deformations=OWN_CABLE.spec.deformations[:4])},
            r"differ from those of the built-in cable.*law=fx\.compile_law",
        ),
        (
            OWN | {"element": changed(deformations=OWN_CABLE.spec.deformations[:4])},
            r"law 'harder_cable' acts on 6 deformations; element 'own_cable' has 4: strain1, .*declare a law",
        ),
        ({"law": OWN_LAW}, r"parameters of its pages are missing; give parameters=\{'hardening': …\}"),
        (OWN | {"parameters": {"hardning": 1.0}}, r"unknown parameter 'hardning'; did you mean hardening"),
        (OWN | {"parameters": {"EA": 1.0}}, r"'EA' in parameters has a separate argument; give EA=…"),
        (OWN | {"parameters": {"hardening": -1.0}}, r"hardening"),
        ({"parameters": {"hardening": 1.0}}, r"unknown parameter 'hardening'"),
    ],
)
def test_bad_pages_are_refused_by_name(given: dict[str, Any], message: str) -> None:
    with pytest.raises(fx.ModelError, match=f"cable 'rope1': .*{message}"):
        over_a_sheave(**given)


def test_a_number_that_neither_page_takes_is_refused() -> None:
    spec = OWN_LAW.spec
    law = replace(
        OWN_LAW, spec=replace(spec, parameters=tuple(p for p in spec.parameters if p.name != "damping"))
    )
    with pytest.raises(
        fx.ModelError, match=r"damping is given, but neither page has a parameter 'damping'.*leave it"
    ):
        over_a_sheave(**(OWN | {"law": law}))


def test_a_planar_page_is_refused_in_space() -> None:
    m = fx.Model()
    with pytest.raises(fx.ModelError, match=r"declare those of a cable: \(point, slope, point, slope\)"):
        m.cable_line("c", [(0, 0, 0), (1, 0, 0)], 2, EA=1e5, EI=1.0, element=OWN_CABLE)
