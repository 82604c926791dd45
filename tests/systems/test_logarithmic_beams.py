"""Beams with logarithmic rotations: limits over meshes, large turns within one element, what other analyses see."""

from typing import Any

import numpy as np
import pytest
from chains import chain
from reissner import planar_tip, spatial_tip

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.convergence import romberg

LOGARITHMIC = {"rotations": "logarithmic"}


def planar_chain(n: int, **beam: Any) -> fx.Model:
    """A straight beam of length 1 along x in n elements, clamped at the origin, in the plane."""
    m = fx.Model()
    for i in range(n + 1):
        m.point(f"p{i}", (i / n, 0), fixed=i == 0)
        m.angle(f"r{i}", fixed=i == 0)
    for i in range(n):
        m.beam(f"b{i}", f"p{i}", f"r{i}", f"p{i + 1}", f"r{i + 1}", **beam)
    return m


def planar_end(n: int, force: tuple[float, ...], moment: float, **beam: Any) -> Array:
    """Place and angle (3,) of the end in equilibrium."""
    m = planar_chain(n, **beam)
    m.load(f"p{n}", force)
    m.load(f"r{n}", moment)
    state = m.build().equilibrium()
    return np.concatenate([state.position(f"p{n}"), state.position(f"r{n}")])


@pytest.mark.parametrize("GA", [20.0, np.inf])
def test_the_limit_over_meshes_is_reissners_rod_in_the_plane(GA: float) -> None:
    """The end turns by 115°; with shear the sections lean by up to 17°.  Reference: own, shooting."""
    force, moment = (-1.0, 6.0), 1.5
    shear = {} if np.isinf(GA) else {"GAy": GA}
    exact = planar_tip(400.0, 1.0, GA, force, moment)
    ends = [planar_end(n, force, moment, EA=400.0, EIz=1.0, **shear, **LOGARITHMIC) for n in (4, 8, 16)]
    assert np.max(np.abs(ends[-1] - exact)) < 5e-4
    assert np.max(np.abs(romberg(ends) - exact)) < 5e-6


@pytest.mark.parametrize("sheared", [True, False])
@pytest.mark.long
def test_the_limit_over_meshes_is_reissners_rod_in_space(sheared: bool) -> None:
    """The end turns by 106° about an oblique axis.  Reference: own, shooting."""
    force, moment = (-1.0, 4.0, 2.0), (1.0, -0.8, 1.2)
    shear = {"GAy": 30.0, "GAz": 20.0} if sheared else {}
    exact = spatial_tip(
        (400.0, shear.get("GAy", np.inf), shear.get("GAz", np.inf)), (0.8, 1.0, 1.7), force, moment
    )
    ends = []
    for n in (4, 8, 16):
        m = chain(n, EA=400.0, GJ=0.8, EIy=1.0, EIz=1.7, **shear, **LOGARITHMIC)
        m.load(f"p{n}", force)
        m.load(f"r{n}", moment)
        state = m.build().equilibrium()
        q = state.position(f"r{n}")
        ends.append(np.concatenate([state.position(f"p{n}"), q * np.sign(q @ exact[3:])]))
    assert np.max(np.abs(ends[-1] - exact)) < 5e-4
    assert np.max(np.abs(romberg(ends) - exact)) < 5e-6


@pytest.mark.parametrize(("rotations", "share"), [("classic", 0.295), ("logarithmic", 0.0)])
def test_a_bent_beam_leans_under_a_shear_force_by_the_force_over_its_shear_stiffness(
    rotations: str, share: float
) -> None:
    """The limit at the clamp, under a moment with M² = 0.295 EI GA.

    The shear stiffness of the classic beam is GA - M²/EI (closed form: its energy is EI (κ cos γ)²/2 + GA γ²/2).
    """
    force, moment = 1e-4, 2.0
    GA = moment**2 / 0.295
    found = []
    for n in (8, 16, 32):
        m = planar_chain(n, EA=1e4, EIz=1.0, GAy=GA, rotations=rotations)
        m.load(f"r{n}", moment)
        m.load(f"p{n}", (0.0, force))
        state = m.build().equilibrium()
        x, y = state.position("p1")
        halfway = state["r1.angle"] / 2
        found.append(np.array([(np.arctan2(y, x) - halfway) * GA / (force * np.cos(halfway))]))
    assert abs(romberg(found)[0] * (1 - share) - 1) < 2e-4


def test_a_column_with_shear_buckles_at_the_load_of_the_rod() -> None:
    """Clamped and free: P (1 + P/GA - P/EA) = π² EI/(4 L²) (closed form, Reissner 1972)."""
    EA, GA = 400.0, 20.0
    exact = (np.sqrt(1 + np.pi**2 * (1 / GA - 1 / EA)) - 1) / (2 * (1 / GA - 1 / EA))
    loads = []
    for n in (4, 8, 16):
        m = planar_chain(n, EA=EA, EIz=1.0, GAy=GA, **LOGARITHMIC)
        m.load(f"p{n}.x", -exact)
        s = m.build()
        found = s.buckling(s.equilibrium(stable=False), increment={f"p{n}.x": -1.0}, count=1)
        loads.append(np.array([exact + found[0].multiplier]))
    assert abs(romberg(loads)[0] / exact - 1) < 1e-5


@pytest.mark.parametrize("degrees", [90, 150])
def test_torque_of_a_bar_of_two_elements_is_linear_in_its_twist(degrees: int) -> None:
    m = chain(2, GJ=3.0, EIy=1.0, EIz=1.0, EA=10.0, **LOGARITHMIC)
    angle = np.radians(degrees)
    m.load("r2", (3.0 * angle, 0, 0))
    q = m.build().equilibrium().position("r2")
    assert abs(2 * np.arctan2(q[1], q[0]) - angle) < 1e-9


@pytest.mark.parametrize("degrees", [45, 120])
def test_an_end_moment_bends_one_element_to_an_arc(degrees: int) -> None:
    """EI times the angle, and the end of a circle: closed form; in the plane and about an oblique axis in space."""
    angle = np.radians(degrees)
    x, y = np.sin(angle) / angle, (1 - np.cos(angle)) / angle
    error = angle**8 / 9e7  # of the series for the length of the arc
    for shear in ({}, {"GAy": 5.0}):
        end = planar_end(1, (0, 0), 2.0 * angle, EA=100.0, EIz=2.0, **shear, **LOGARITHMIC)
        assert np.max(np.abs(end - [x, y, angle])) < 1e-9 + error
    axis = np.array([0, 0.6, 0.8])
    m = chain(1, EA=100.0, GJ=1.0, EIy=2.0, EIz=2.0, GAz=7.0, **LOGARITHMIC)
    m.load("r1", tuple(2.0 * angle * axis))
    state = m.build().equilibrium()
    assert np.max(np.abs(state.position("p1") - [x, 0.8 * y, -0.6 * y])) < 1e-8 + error
    assert np.max(np.abs(state.position("r1") - [np.cos(angle / 2), *(np.sin(angle / 2) * axis)])) < 1e-8


def test_an_unloaded_beam_drawn_straight_takes_the_quarter_circle_that_it_was_made_as() -> None:
    m = planar_chain(1, EA=100.0, EIz=2.0, initial_curvature=np.pi / 2, **LOGARITHMIC)
    state = m.build().equilibrium()
    assert np.max(np.abs(state.position("p1") - 2 / np.pi)) < 1e-6
    assert abs(state.position("r1")[0] - np.pi / 2) < 1e-9


def test_small_vibrations_are_those_of_the_classic_beam() -> None:
    beam = {"EA": 50.0, "GJ": 2.0, "EIy": 3.0, "EIz": 5.0, "GAy": 11.0, "GAz": 13.0, "mass_per_length": 1.0}
    beam["inertia_per_length"] = (0.02, 0.01, 0.01)
    found = [
        np.sort(chain(3, rotations=rotations, **beam).build().linearize().eigenvalues().imag)
        for rotations in ("classic", "logarithmic")
    ]
    assert np.max(np.abs(found[0] - found[1])) < 1e-8


def test_a_strongly_bent_motion_keeps_its_energy() -> None:
    """Two soft elements fall under their weight, the first turns by more than 70 degrees about an oblique axis."""
    beam = {"EA": 200.0, "GJ": 0.8, "EIy": 1.0, "EIz": 1.7, "GAy": 30.0, "GAz": 20.0, **LOGARITHMIC}
    m = chain(2, gravity=(1.0, -6.0, 9.0), mass_per_length=1.0, inertia_per_length=(0.02, 0.01, 0.01), **beam)
    motion = m.build().simulate(1.0, rtol=1e-9)
    E = motion.energy
    assert np.min(np.abs(motion.position("r1")[:, 0])) < np.cos(np.radians(70) / 2)
    assert np.ptp(E["total"]) < 1e-9 * np.max(E["strain"])


@pytest.mark.parametrize("planar", [True, False])
def test_section_forces_are_those_of_the_deformed_beam(planar: bool) -> None:
    """Under a dead force the moment at the clamp is the force times its arm, whatever the mesh; statics."""
    section = fx.Rectangle(1e-3, 5e-3)
    options = {"section": section, "material": "steel", **LOGARITHMIC}
    m, force = (
        (planar_chain(2, **options), (-0.05, 0.2)) if planar else (chain(2, **options), (-0.05, 0.2, 0.1))
    )
    m.load("p2", force)
    state = m.build().equilibrium()
    arm, F = np.zeros(3), np.zeros(3)
    arm[: len(force)], F[: len(force)] = state.position("p2"), force
    found = state.section_forces("b0")[0]
    assert np.allclose([found.T, found.My, found.Mz], np.cross(arm, F), rtol=1e-7, atol=1e-12)
    assert np.allclose([found.N, found.Vy, found.Vz], F, rtol=1e-7, atol=1e-12)
    assert state.largest_stress().beam == "b0"
