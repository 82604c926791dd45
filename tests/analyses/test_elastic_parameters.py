"""Stiffnesses, initial shape and damping of beams vary in a built system as in a model that is built anew."""

from typing import Any

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

import flexel as fx
from flexel.model.parameters import Parameters

# initially strained beams, as drawn, do not rest; their linearization is compared all the same
pytestmark = pytest.mark.filterwarnings("ignore::flexel.UnsteadyWarning")

GIVEN: dict[str, Any] = {
    "EA": 900.0,
    "GJ": 3.0,
    "EIy": 4.0,
    "EIz": 5.0,
    "GAy": 60.0,
    "GAz": 70.0,
    "initial_strain": 0.01,
    "initial_curvature": [0.1, 0.2, -0.15],
    "damping": 0.003,
}
OTHER: dict[str, Any] = {
    "EA": 700.0,
    "GJ": 2.1,
    "EIy": 5.5,
    "EIz": 3.2,
    "GAy": 35.0,
    "GAz": 110.0,
    "initial_strain": -0.02,
    "initial_curvature": [-0.05, 0.12, 0.1],
    "damping": 0.02,
    "EIw": 0.09,
}
PLANAR = ("EA", "EIz", "GAy", "initial_strain", "initial_curvature", "damping")
KINDS: dict[str, dict[str, Any]] = {
    "second order": {},
    "first order": {"second_order": False},
    "logarithmic": {"rotations": "logarithmic"},
    "warping": {"warping": True, "EIw": 0.06, "warping_inertia_per_length": 0.003},
}
UNITS = {
    "EA": "N",
    "GJ": "N m^2",
    "EIy": "N m^2",
    "EIz": "N m^2",
    "GAy": "N",
    "GAz": "N",
    "EIw": "N m^4",
    "initial_strain": "1",
    "initial_curvature": "1/m",
    "damping": "s",
}
CASES = [
    *(("space", kind, key) for kind, more in KINDS.items() for key in {**GIVEN, **more} if key in OTHER),
    *(("plane", kind, key) for kind in list(KINDS)[:3] for key in PLANAR),
]
varied = pytest.mark.parametrize(("space", "kind", "key"), CASES)


def cantilever(space: str, given: dict[str, Any], load: float = 0.0) -> fx.System:
    """Two beams in a line, clamped at one end and loaded across at the other."""
    m = fx.Model(gravity=(0, 0) if space == "plane" else (0, 0, 0))
    inertia: Any = 0.02
    if space == "space":
        inertia = (0.05, 0.02, 0.03)
        given = {"direction": (0, 1, 0)} | given
    else:
        given = {key: value[2] if key == "initial_curvature" else value for key, value in given.items()}
        given = {key: value for key, value in given.items() if key not in ("GJ", "EIy", "GAz")}
    for i in range(3):
        m.point(f"P{i}", (float(i), 0.0, 0.0)[: 2 if space == "plane" else 3], fixed=not i)
        (m.angle if space == "plane" else m.frame)(f"R{i}", fixed=not i)
    for i in range(2):
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, mass_per_length=1.0, inertia_per_length=inertia, **given)
    if load:
        m.load("P2", (0.0, load, 0.5 * load)[: 2 if space == "plane" else 3])
    return m.build()


def changed(space: str, kind: str, key: str) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Numbers of the beams, the same with another value, and that as parameters of the built system."""
    given = GIVEN | KINDS[kind]
    value = OTHER[key]
    own = value[2] if space == "plane" and key == "initial_curvature" else value
    return given, given | {key: value}, {f"b{i}.{key}": own for i in range(2)}


def difference(found: Any, wanted: Any) -> float:
    """The largest distance between eigenvalues that belong together, relative to the size of each."""
    distances = np.abs(found[:, None] - wanted) / np.abs(wanted)
    return float(distances[linear_sum_assignment(distances)].max())


def rounded(found: Any, wanted: Any) -> float:
    """The largest distance between them relative to the largest eigenvalue, as the rounding of their solver is."""
    distances = np.abs(found[:, None] - wanted) / np.abs(wanted).max()
    return float(distances[linear_sum_assignment(distances)].max())


def close(found: Any, wanted: Any, tolerance: float) -> None:
    np.testing.assert_allclose(found, wanted, rtol=tolerance, atol=tolerance * np.abs(wanted).max())


@varied
def test_eigenvalues_are_those_of_a_model_that_is_built_anew(space: str, kind: str, key: str) -> None:
    given, other, values = changed(space, kind, key)
    system, anew = cantilever(space, given), cantilever(space, other)
    wanted = anew.linearize().eigenvalues()
    assert difference(system.linearize().eigenvalues(), wanted) > 1e-4
    assert rounded(system.with_parameters(values).linearize().eigenvalues(), wanted) < 1e-14
    assert rounded(system.linearize_many(parameters=values).eigenvalues()[0], wanted) < 1e-14


@varied
def test_equilibrium_is_that_of_a_model_that_is_built_anew(space: str, kind: str, key: str) -> None:
    given, other, values = changed(space, kind, key)
    system, anew = cantilever(space, given, 0.2), cantilever(space, other, 0.2)
    state, bent = anew.equilibrium(), system.equilibrium()
    found = system.linearize_many(lambda s: s.equilibrium(), parameters=values)
    assert difference(found.eigenvalues()[0], anew.linearize(state).eigenvalues()) < 1e-9
    close(system.with_parameters(values).equilibrium().x, state.x, 1e-10)
    found = system.linearize_many(bent, parameters=values)
    there = anew.state(0.0, bent.x, np.zeros(bent.x.size))
    assert rounded(found.eigenvalues()[0], anew.linearize(there).eigenvalues()) < 1e-14


@varied
def test_motion_is_that_of_a_model_that_is_built_anew(space: str, kind: str, key: str) -> None:
    given, other, values = changed(space, kind, key)
    system, anew = cantilever(space, given, 0.2), cantilever(space, other, 0.2)
    found = system.simulate_many(0.1, parameters=values, outputs=["P2.y"], samples=5)
    close(found["P2.y"][0], anew.simulate(0.1, samples=5)["P2.y"], 1e-12)


@pytest.mark.parametrize("kind", list(KINDS)[:3])
def test_many_motions_together_are_those_of_models_that_are_built_anew(kind: str) -> None:
    """Eight of them in the lanes of one thread, and what is left."""
    given, values = GIVEN | KINDS[kind], np.linspace(3.0, 6.0, 10)
    system = cantilever("plane", given, 0.2)
    names = {f"b{i}.EIz": values for i in range(2)}
    found = system.simulate_many(0.05, parameters=names, outputs=["P2.y"], samples=3, threads=1)
    for value, path in zip(values, found["P2.y"], strict=True):
        close(path, cantilever("plane", given | {"EIz": value}, 0.2).simulate(0.05, samples=3)["P2.y"], 1e-12)


NODAL = ("P", ".x"), ("P", ".y"), ("R", ".angle")


@pytest.mark.parametrize("key", ["EA", "EIz", "GAy", "damping"])
def test_root_loci_are_those_of_models_that_are_built_anew(key: str) -> None:
    at_rest = GIVEN | {"initial_curvature": [0.0, 0.0, 0.0], "initial_strain": 0.0}
    system, anew = (cantilever("plane", numbers) for numbers in (at_rest, at_rest | {key: OTHER[key]}))
    for s in (system, anew):  # small eigenvalues keep their digits in these coordinates
        s.use_coordinates([f"{name}{i}{part}" for i in (1, 2) for name, part in NODAL])
    loci = system.root_loci(parameters={f"b{i}.{key}": [GIVEN[key], OTHER[key]] for i in range(2)})
    assert (loci.name, loci.unit) == (f"b0.{key}", UNITS[key])
    assert difference(loci.linearizations.eigenvalues()[1], anew.linearize().eigenvalues()) < 1e-13


@pytest.mark.parametrize("kind", KINDS)
def test_a_beam_has_the_parameters_that_were_given(kind: str) -> None:
    given = GIVEN | KINDS[kind]
    parameters = Parameters(cantilever("space", given).structure)
    for key, unit in UNITS.items():
        assert (f"b0.{key}" in parameters) == (key in given)
        if key in given:
            np.testing.assert_array_equal(np.squeeze(parameters[f"b0.{key}"]), given[key])
            assert parameters.unit(parameters.find(f"b0.{key}", "test")) == unit


def test_a_rigid_mode_has_no_parameters() -> None:
    found = cantilever("space", {"EIz": 1.0, "EA": 2.0, "initial_curvature": (0, 0, 0.1)})
    assert not {"b0.GJ", "b0.EIy", "b0.GAy", "b0.GAz", "b0.EIw"} & set(found.parameters)
    assert found.parameters["b0.initial_curvature"].tolist() == [0.0, 0.0, 0.1]
    assert (
        found.with_parameters({"b0.initial_curvature[2]": 0.3}).parameters["b0.initial_curvature[2]"] == 0.3
    )
    with pytest.raises(
        fx.ModelError, match="b0.initial_curvature' belongs to a rigid mode; make it flexible"
    ):
        found.with_parameters({"b0.initial_curvature": [0.1, 0.0, 0.1]})


@pytest.mark.parametrize("word", ["stiffness", "preload", "phi_y", "phi_z"])
def test_a_number_that_follows_from_others_is_refused_with_their_names(word: str) -> None:
    system = cantilever("plane", {"EA": 1.0, "EIz": 2.0, "GAy": 3.0})
    with pytest.raises(fx.ModelError, match=rf"'b0\.{word}' follows from .*: .*b0\.EA.*b0\.EIz, b0\.GAy"):
        system.with_parameters({f"b0.{word}": 1.0})


@pytest.mark.parametrize(("key", "value"), [("EIz", 0.0), ("GAy", -1.0), ("damping", -0.1), ("EA", 0.0)])
def test_a_wrong_sign_is_refused(key: str, value: float) -> None:
    with pytest.raises(fx.ModelError, match=r"variant 0: 'b0'"):
        cantilever("plane", GIVEN).with_parameters({f"b0.{key}": value})


CABLE = {"EA": 50.0, "EI": 0.4, "damping": 0.01, "bending_damping": 0.02}
OTHER_CABLE = {"EA": 70.0, "EI": 0.25, "damping": 0.03, "bending_damping": 0.005}


def hanging(space: str, given: dict[str, float]) -> fx.System:
    """A cable of two elements that sags between two points; in space slightly out of its plane as well."""
    size = 2 if space == "plane" else 3
    m = fx.Model(gravity=(0, -9.81, 0.5)[:size])
    rope = m.cable_line(
        "rope", [(0, 0, 0)[:size], (1, 0.1, 0)[:size]], 2, length=1.05, mass_per_length=0.2, **given
    )
    m.fix(rope.points[0], rope.points[-1])
    return m.build()


@pytest.mark.parametrize("key", CABLE)
@pytest.mark.parametrize("space", ["plane", "space"])
def test_a_cable_varies_like_one_that_is_built_anew(space: str, key: str) -> None:
    system, anew = hanging(space, CABLE), hanging(space, CABLE | {key: OTHER_CABLE[key]})
    values = {f"rope{i}.{key}": OTHER_CABLE[key] for i in (1, 2)}
    assert system.parameters[f"rope1.{key}"] == CABLE[key]
    wanted = anew.linearize().eigenvalues()
    assert difference(system.linearize().eigenvalues(), wanted) > 1e-4
    assert rounded(system.with_parameters(values).linearize().eigenvalues(), wanted) < 1e-14
    assert rounded(system.linearize_many(parameters=values).eigenvalues()[0], wanted) < 1e-14
    found = system.simulate_many(0.1, parameters=values, outputs=["rope_p1.y"], samples=5)
    close(found["rope_p1.y"][0], anew.simulate(0.1, samples=5)["rope_p1.y"], 1e-12)
    with pytest.raises(fx.ModelError, match=r"'rope1.stiffness' follows from .*rope1\.EA, rope1\.EI"):
        system.with_parameters({"rope1.stiffness": 1.0})


def test_the_mass_of_a_three_node_beam_varies_like_that_of_one_that_is_built_anew() -> None:
    def arm(mass: float) -> fx.System:
        m = fx.Model(gravity=(0, 0, -9.81))
        m.point("O", (0, 0, 0), fixed=True)
        m.frame("ground", fixed=True)
        m.frame("turn")
        m.point("A", (0.3, 0.1, -0.4))
        m.hinge("pivot", "ground", "turn", axis=(0, 1, 0))
        m.beam("arm", "O", "turn", "A", mass_per_length=mass)
        m.spring("pivot.angle", 2.0)
        return m.build()

    system, anew = arm(1.0), arm(1.7)
    found = system.with_parameters({"arm.rhoA": 1.7}).linearize()
    assert difference(found.eigenvalues(), anew.linearize().eigenvalues()) < 1e-13
    assert not [name for name in system.parameters if name.startswith("arm.E") or name.startswith("arm.G")]
