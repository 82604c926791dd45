"""Numbers of parts are parameters: a variant equals the model built anew with the other number."""

import pickle
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from declared_models import KINDS, OTHERS, hardening

import flexel as fx
from flexel.generated.table import LAWS
from flexel.model.parameters import Parameters

ALL = KINDS | OTHERS
CHANGE = 1 - 1e-3
pytestmark = pytest.mark.filterwarnings(
    "ignore::flexel.ModelWarning", "ignore::flexel.AssemblyWarning", "ignore::flexel.UnsteadyWarning"
)


def anew(system: fx.System, values: dict[str, Any]) -> fx.System:
    """The system of the model built with other numbers."""
    assert system.origin is not None
    changed = system.origin.changed({name: np.asarray(value, dtype=float) for name, value in values.items()})
    return fx.Model.of(changed.gravity, changed.parts).build()


def assert_same_system(a: fx.System, b: fx.System) -> None:
    """Two systems have equal numbers of elements and laws, starts, and numbers of parts."""
    for own, other in (
        *zip(a.structure.instances, b.structure.instances, strict=True),
        *zip(a.structure.laws, b.structure.laws, strict=True),
    ):
        np.testing.assert_array_equal(own.p, other.p, err_msg=own.name)
    assert [law.z0 for law in a.structure.laws] == [law.z0 for law in b.structure.laws]
    np.testing.assert_allclose(a._start.x, b._start.x, rtol=1e-13, atol=1e-13)
    assert a.origin is not None and b.origin is not None
    assert list(a.origin.numbers) == list(b.origin.numbers)
    for name, number in a.origin.numbers.items():
        np.testing.assert_array_equal(number.value, b.origin.numbers[name].value, err_msg=name)


def frame(width: float = 0.02, mass: float = 0.5, offset: float = 0.1) -> fx.Model:
    """A leaf spring with a body at its end, on a wall."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0, 0))
    m.frame("wall", fixed=True)
    m.frame("tip")
    section, steel = fx.Rectangle(0.5e-3, width), fx.Material(2.1e11, 7800.0, 0.3)
    m.leaf_spring(
        "leaf", "O", "wall", "A", "tip", section=section, material=steel, elements=2, direction=(0, 1, 0)
    )
    m.body("rider", "A", "tip", mass=mass, inertia=(1e-3, 2e-3, 2e-3), offset=(offset, 0, 0))
    return m


def test_names_have_units() -> None:
    s = frame().build()
    units = {name: s.origin.numbers[name].unit for name in s.origin.numbers}  # type: ignore[union-attr]
    width = next(name for name in units if name.startswith("leaf.section."))
    assert units[width] == "m"
    assert units["leaf.material.E"] == "Pa"
    assert units["rider.mass"] == "kg"
    assert units["rider.inertia"] == "kg m²"
    assert set(units) <= set(s.parameters)


VARIED = {
    "leaf.section.height": [0.4e-3, 0.5e-3, 0.6e-3],
    "leaf.material.E": [1e11, 2e11],
    "rider.mass": [0.4, 0.7],
    "rider.inertia": [[1e-3, 2e-3, 2e-3], [2e-3, 3e-3, 2.5e-3]],
    "rider.offset": [[0.1, 0, 0], [0.12, 0.01, 0]],
    "A.position": [[0.1, 0, 0], [0.12, 0, 0]],
}


@pytest.mark.parametrize("name", VARIED)
def test_variants_equal_models_built_anew(name: str) -> None:
    s = frame().build()
    found = s.linearize_many(parameters={name: VARIED[name]}, threads=1)
    again = s.linearize_many(parameters={name: VARIED[name]}, threads=2)
    for i, value in enumerate(VARIED[name]):
        other, variant = anew(s, {name: value}), s.with_parameters({name: value})
        assert_same_system(variant, other)
        lin = other.linearize()
        for key in "MCK":
            scale = abs(getattr(lin, key)).max()
            np.testing.assert_allclose(getattr(found, key)[i], getattr(lin, key), rtol=0, atol=1e-13 * scale)
            np.testing.assert_array_equal(getattr(found, key)[i], getattr(again, key)[i])
        np.testing.assert_array_equal(variant.parameters[name], np.ravel(value))


@pytest.mark.long
def test_motions_of_variants_are_those_of_models_built_anew() -> None:
    s = frame().build()
    values = [0.4, 0.7]
    many = s.simulate_many(0.01, parameters={"rider.mass": values}, outputs=["A.z"], samples=3, threads=1)
    for i, value in enumerate(values):
        alone = anew(s, {"rider.mass": value}).simulate(0.01, samples=3)
        np.testing.assert_allclose(many["A.z"][i], alone["A.z"], rtol=0, atol=1e-12)
    loci = s.root_loci(parameters={"rider.mass": values})
    for i, value in enumerate(values):
        alone = anew(s, {"rider.mass": value}).root_loci(parameters={"rider.mass": [value]})
        wanted = np.sort(alone.eigenvalues[0].imag)
        np.testing.assert_allclose(np.sort(loci.eigenvalues[i].imag), wanted, rtol=1e-10)


def test_an_entry_in_brackets_and_chains() -> None:
    s = frame().build()
    a = s.with_parameters({"rider.inertia[1]": 2.5e-3})
    assert_same_system(a, anew(s, {"rider.inertia": [1e-3, 2.5e-3, 2e-3]}))
    b = a.with_parameters({"rider.mass": 0.8}).with_parameters({"leaf.section.height": 0.4e-3})
    values = {"rider.inertia": [1e-3, 2.5e-3, 2e-3], "rider.mass": 0.8, "leaf.section.height": 0.4e-3}
    assert_same_system(b, anew(s, values))
    np.testing.assert_array_equal(b.parameters["rider.inertia"], values["rider.inertia"])
    with pytest.raises(fx.ModelError, match="numbered from 0 to 2"):
        s.with_parameters({"rider.inertia[3]": 1.0})


def test_refusals_name_the_number() -> None:
    s = frame().build()
    with pytest.raises(fx.ModelError, match="rider.*mass.*-1"):
        s.with_parameters({"rider.mass": -1.0})
    with pytest.raises(fx.ModelError, match="unknown parameter 'leaf.section.hight'.*leaf.section.height"):
        s.with_parameters({"leaf.section.hight": 1.0})
    with pytest.raises(fx.ModelError, match="leaf.elements"):
        s.with_parameters({"leaf.elements": 3})


def test_pickled_systems_have_the_same_variants() -> None:
    s = frame().build()
    sent = pickle.loads(pickle.dumps(s))
    values = {"rider.mass": 0.8, "leaf.material.E": 1e11}
    assert_same_system(sent.with_parameters(values), s.with_parameters(values))


def sprung(force: Any) -> fx.System:
    """A rotor on a spring whose axis carries a body with an offset."""
    m = frame()
    m.spring("A.y", force)
    return m.build()


def test_a_lambda_is_lost_in_a_pickle_and_named_where_it_is_needed() -> None:
    s = sprung(lambda e: 3 * e)
    s.with_parameters({"leaf.material.E": 1e11})
    sent = pickle.loads(pickle.dumps(s))
    with pytest.raises(fx.ModelError, match="spring on 'A.y' was declared with .*lambda.*pickle cannot hold"):
        sent.with_parameters({"leaf.material.E": 1e11})
    kept = pickle.loads(pickle.dumps(sprung(hardening)))
    kept.with_parameters({"leaf.material.E": 1e11})


def named_by_the_issue() -> dict[str, fx.Model]:
    """Models with a rope, a tyre and leaf springs, for the names that users write."""
    rope = fx.Model(gravity=(0, -9.81))
    rope.point("C", (0, 0), fixed=True)
    rope.angle("G", fixed=True)
    rope.sheave("S", "C", "G", radius=0.1)
    a, b = rope.point("A", (-0.1, -0.3), fixed=True), rope.point("B", (0.1, -0.3))
    contact, section = fx.Contact(1e8, dissipation=10.0), fx.WireRope(0.004)
    rope.rope("rope", [a, "S", b], 10, contact=contact, section=section, material="wire rope", tension=5.0)
    rope.point_mass("load", "B", 1.0)
    tyre = fx.Model(gravity=(0, 0, -9.81))
    tyre.point("hub", (0, 0, 0.29))
    tyre.frame("wheel")
    tyre.body("rim", "hub", "wheel", mass=20.0, inertia=(1.0, 1.5, 1.0))
    numbers = {"stiffness": 2e5, "damping": 100.0, "cornering": 1e4, "trail": 0.03, "standstill": 0.1}
    rubber = {
        name: numbers.get(name, 1e3)
        for name in (parameter.name for parameter in LAWS["linear_tyre"].parameters)
    }
    tyre.tyre("front tyre", "hub", "wheel", radius=0.3, axle=(0, 1, 0), law="linear_tyre", **rubber)
    thin = frame_of(fx.LBeam(0.02, 0.02, 0.5e-3))
    return {"rope": rope, "tyre": tyre, "thin": thin, "leaf": frame_of(fx.Rectangle(0.5e-3, 0.02))}


def frame_of(section: Any) -> fx.Model:
    """A beam of a section of steel with a body at its end, on a wall."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0, 0))
    m.frame("wall", fixed=True)
    m.frame("tip")
    m.beam("leaf", "O", "wall", "A", "tip", section=section, material="steel", direction=(0, 1, 0))
    m.body("rider", "A", "tip", mass=0.5, inertia=(1e-3, 2e-3, 2e-3))
    return m


NAMED = {  # model, name, the same number by its full name, unit
    "diameter of a rope": ("rope", "rope.diameter", "rope.section.diameter", "m"),
    "modulus of a rope": ("rope", "rope.E", "rope.material.E", "Pa"),
    "stiffness of a tyre": ("tyre", "front tyre.stiffness", "front tyre.stiffness", "N/m"),
    "thickness of a section": ("thin", "leaf.section.thickness", "leaf.section.thickness", "m"),
    "stiffness of a section": ("leaf", "leaf.EIz", "leaf.EIz", "N m^2"),
    "density of a material by its name": ("leaf", "leaf.material.rho", "leaf.material.rho", "kg/m³"),
}


@pytest.mark.parametrize("what", NAMED)
def test_names_that_users_write(what: str) -> None:
    model, name, full, unit = NAMED[what]
    s = named_by_the_issue()[model].build()
    value = s.parameters[name]
    assert name in s.parameters
    assert list(s.parameters).count(full) == 1
    assert (name in list(s.parameters)) == (name == full)  # one parameter, listed once
    found = s.linearize_many(parameters={name: [value[0], 0.9 * value[0]]}, threads=1)
    assert np.abs(found.K[1] - found.K[0]).max() > 0 or np.abs(found.M[1] - found.M[0]).max() > 0
    again = s.with_parameters({full: 0.9 * value[0]})
    np.testing.assert_array_equal(found.M[1], again.linearize().M)
    np.testing.assert_array_equal(again.parameters[name], 0.9 * value)
    parameters = Parameters(s.structure, s.origin)
    assert parameters.unit(parameters.find(name, "test")) == unit


def test_two_names_of_one_number_are_refused() -> None:
    s = named_by_the_issue()["rope"].build()
    with pytest.raises(
        fx.ModelError, match="'rope.diameter' and 'rope.section.diameter' are the same parameter"
    ):
        s.with_parameters({"rope.diameter": 0.005, "rope.section.diameter": 0.006})


def test_a_material_by_name_is_another_one_in_the_part_of_a_variant() -> None:
    s = frame_of(fx.Rectangle(0.5e-3, 0.02)).build().with_parameters({"leaf.material.E": 1e11})
    assert s.origin is not None
    (leaf,) = (part for part in s.origin.parts if part.label == "leaf")
    assert leaf.material == fx.Material(1e11, 7850.0, 0.3)  # type: ignore[attr-defined]
    wanted = frame_of(fx.Rectangle(0.5e-3, 0.02))
    parts = [replace(part, material=leaf.material) if part.label == "leaf" else part for part in wanted.parts]  # type: ignore[attr-defined,call-arg]
    assert_same_system(s, fx.Model.of(wanted.gravity, parts).build())


def sprung_twice(stiffness: float = 300.0) -> fx.Model:
    """A mass on two springs with free lengths, and a load."""
    m = fx.Model()
    m.point("A", (1.0, 0, 0))
    m.point("O", (0, 0, 0), fixed=True)
    m.truss("bar", "O", "A")
    m.release("bar.elongation")
    m.fix("A.y", "A.z")
    m.point_mass("mass", "A", 2.0)
    m.spring("bar.elongation", stiffness, free_length=0.7)
    m.spring("bar.elongation", 100.0, 1.0, free_length=0.9)
    m.load("A.x", 5.0)
    m.load("A.x", 7.0)
    return m


def test_a_free_length_gives_another_force_with_another_stiffness() -> None:
    """The force as drawn follows from both; a variant of the stiffness alone kept it before."""
    s = sprung_twice().build()
    assert_same_system(s.with_parameters({"bar.elongation.stiffness": 500.0}), sprung_twice(500.0).build())
    other = s.with_parameters({"bar.elongation#2.free_length": 0.8})
    assert other.initial.force("bar.elongation") == pytest.approx(300 * 0.3 + 100 * 0.2, rel=1e-13)


def test_loads_are_called_by_their_targets() -> None:
    s = sprung_twice().build()
    assert s.parameters["load A.x.value"] == 5.0
    assert s.parameters["load A.x#2.value"] == 7.0
    still = s.initial.force("bar.elongation")
    other = s.with_parameters({"load A.x#2.value": still - 5.0})
    assert other.initial.acceleration("A.x") == pytest.approx(0.0, abs=1e-13)


def test_parameters_print_as_a_table_of_names_values_and_units() -> None:
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.5, 0))
    m.truss("bar", "O", "A", stiffness=200.0)
    m.point_mass("mass", "A", 2.5)
    lines = [line.split() for line in repr(m.build().parameters).splitlines()]
    assert lines[0] == ["parameter", "value", "unit"]
    assert ["bar.stiffness", "200", "N/m"] in lines and ["mass.mass", "2.5", "kg"] in lines
    assert ["A.position", "[0.5,", "0]", "m"] in lines
    assert "<td>mass.mass</td><td>2.5</td><td>kg</td>" in m.build().parameters._repr_html_()
