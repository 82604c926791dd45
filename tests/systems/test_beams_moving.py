"""Beams in motion: rigid and partly flexible ones, damping, bearings, points of bodies."""

from typing import Any

import numpy as np
import pytest
from chains import chain
from coarse import COARSE_MESH

from flexel.base.arrays import Array
from flexel.parts.model import Model

MODES = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")


SECTION = {"EA": ("elongation",), "GJ": ("torsion",), "EIy": ("bend1", "bend2"), "EIz": ("bend3", "bend4")}


@pytest.mark.parametrize("subset", range(1, 16))
def test_any_subset_of_modes_may_be_flexible(subset: int) -> None:
    keys = [key for i, key in enumerate(SECTION) if subset >> i & 1]
    m = chain(1, mass_per_length=1.0, inertia_per_length=(0.1, 0.1, 0.1), **dict.fromkeys(keys, 2.0))
    flexible = {f"b0.{mode}" for key in keys for mode in SECTION[key]}
    m.independent(*flexible)
    s = m.build()
    assert set(s.dynamic) == flexible
    rigid = {s.structure.names[i] for i in s.roles.rigid} - {"r1.norm"}
    assert rigid == {f"b0.{mode}" for mode in MODES} - flexible
    assert np.all(np.abs(s.linearize().eigenvalues().imag) > 0.1)


def test_rigid_beam_with_two_frames_moves_as_the_three_node_beam() -> None:
    found = []
    for second_frame in (True, False):
        m = Model(gravity=(0, 0, -9.81))
        m.point("O", (0, 0, 0), fixed=True)
        m.point("A", (0.3, 0.4, -1.2))
        m.frame("R0", fixed=True)
        m.frame("R1")
        m.frame("R2") if second_frame else None
        m.hinge("pivot", "R0", "R1", axis=(0.2, 1, 0.1))
        end = ("R2",) if second_frame else ()
        m.beam(
            "rod",
            "O",
            "R1",
            "A",
            *end,
            rigid=True,
            direction=(0.3, 1, 0),
            mass_per_length=2.0,
            inertia_per_length=(0.02, 0.03, 0.05),
        )
        m.independent("pivot.angle")
        m.initial("pivot.angle", 0.7, rate=2.0)
        s = m.build()
        motion = s.simulate(1.0, samples=5)
        found.append((motion.position("A"), motion.energy["total"], s.linearize().K))
    for one, other in zip(*found, strict=True):
        assert np.max(np.abs(one - other)) < 1e-9


def test_direction_turns_the_section_of_a_rigid_beam() -> None:
    def period(direction: tuple[float, float, float]) -> float:
        m = Model()
        m.point("O", (0, 0, 0), fixed=True)
        m.point("A", (1, 0, 0))
        m.frame("R0", fixed=True)
        m.frame("R1")
        m.hinge("pivot", "R0", "R1", axis=(0, 0, 1))
        m.beam(
            "rod", "O", "R1", "A", direction=direction, mass_per_length=1.0, inertia_per_length=(0, 0.2, 0.5)
        )
        return float(m.build().linearize().M[0, 0])

    assert abs(period((0, 1, 0)) - (1 / 3 + 0.5)) < 1e-12  # about the section's z axis
    assert abs(period((0, 0, 1)) - (1 / 3 + 0.2)) < 1e-12  # about its y axis


@pytest.mark.parametrize("second_order", [True, False])
def test_free_beam_falls_without_deforming(second_order: bool) -> None:
    m = Model(gravity=(1.0, -2.0, -9.81))
    m.point("A", (0, 0, 0))
    m.point("B", (0.6, 0.8, 0))
    m.frame("RA")
    m.frame("RB")
    section = {"EA": 50.0, "GJ": 2.0, "EIy": 3.0, "EIz": 4.0}
    inertia = {"mass_per_length": 2.0, "inertia_per_length": (0.01, 0.01, 0.02)}
    m.beam("b", "A", "RA", "B", "RB", **section, **inertia, second_order=second_order)
    s = m.build()
    assert np.max(np.abs(s.initial.a[:6] - np.tile([1.0, -2.0, -9.81], 2))) < 1e-12
    motion = s.simulate(0.5, samples=3)
    for mode in MODES:
        assert np.max(np.abs(motion[f"b.{mode}"])) < 1e-9
    fallen = motion.position("B")[-1] - [0.6, 0.8, 0] - 0.125 * np.array([1.0, -2.0, -9.81])
    assert np.max(np.abs(fallen)) < 1e-9


@COARSE_MESH
def test_energy_of_a_swinging_flexible_beam_is_conserved_and_damping_takes_it() -> None:
    for damping in (0.0, 0.02):
        section = {"EIy": 4.0, "EIz": 8.0, "GJ": 3.0}
        inertia = {"mass_per_length": 1.0, "inertia_per_length": (0.2, 0.1, 0.1)}
        m = chain(1, gravity=(0, 0, -9.81), **section, **inertia, damping=damping)
        m.load("p1", (0.0, 1.5, 0.0))
        s = m.build()
        motion = s.simulate(0.5, samples=401, rtol=1e-10, atol=1e-12)
        E = motion.energy["total"]
        modes = [f"b0.{mode}" for mode in MODES]
        law = [motion.force(mode) * motion.rate(mode) for mode in modes]  # power taken up by all stresses
        strain = motion.energy["strain"]
        taken = np.sum(law, axis=0)
        h = motion.t[1]
        work = h / 3 * (taken[0] + taken[-1] + 4 * taken[1:-1:2].sum() + 2 * taken[2:-1:2].sum())
        lost = work - (strain[-1] - strain[0])
        assert abs(E[-1] - E[0] + lost) < 1e-7
        assert (abs(lost) < 1e-7) if damping == 0 else (lost > 0.05)


def test_stiffness_proportional_damping_gives_half_omega_c() -> None:
    c = 0.003
    s = chain(3, EIz=1.0, mass_per_length=1.0, damping=c).build()
    for mode in s.linearize().modes()[-3:]:
        assert abs(mode.damping - mode.omega * c / 2) < 1e-9


def test_bearing_is_a_hinge_with_a_common_point() -> None:
    found = []
    for bearing in (True, False):
        m = Model(gravity=(0, 0, -9.81))
        m.point("O", (0, 0, 0), fixed=True)
        m.frame("R0", fixed=True)
        m.frame("R1")
        m.point("A", (0.1, 0, 0))
        m.point("B", (0.9, 0, -0.4))
        m.body_point("arm", "O", "R0", "A") if bearing else m.fix("A")
        if bearing:
            m.point("A1", (0.1, 0.2, 0))  # on the axis: the bearing keeps the offset
            m.bearing("joint", "A", "R0", "A1", "R1", axis=(0, 1, 0))
            m.body_point("end", "A1", "R1", "B")
        else:
            m.hinge("joint", "R0", "R1", axis=(0, 1, 0))
            m.body_point("end", "A", "R1", "B")
        m.body("plate", "B", "R1", mass=2.0, inertia=(0.1, 0.2, 0.15), offset=(0.1, 0.05, 0))
        m.independent("joint.angle")
        m.initial("joint.angle", 0.4)
        motion = m.build().simulate(1.0, samples=6, rtol=1e-11, atol=1e-13)
        found.append(np.column_stack([motion.position("B"), motion["joint.angle"], motion.energy["kinetic"]]))
        if bearing:
            # the bearing's axial and radial forces carry the weight
            force = [motion[0].force(f"joint.{mode}") for mode in ("axial", "radial1", "radial2")]
            m_a = 2.0 * (_mass_centre_acceleration(motion[0]) - np.array([0, 0, -9.81]))
            assert abs(np.linalg.norm(force) - np.linalg.norm(m_a)) < 1e-9
    assert np.max(np.abs(found[0] - found[1])) < 1e-9


def _mass_centre_acceleration(state: Any) -> Array:
    """Acceleration of the plate's mass centre, turning about the y axis through (0.1, ., 0)."""
    angle, w, dw = state["joint.angle"], state.rate("joint.angle"), state.acceleration("joint.angle")
    arm = np.array([0.8 + 0.1, 0.0, -0.4])
    turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    r = turn @ arm
    return np.cross([0, dw, 0], r) - w**2 * np.array([r[0], 0, r[2]])


def test_point_of_a_body_moves_with_it() -> None:
    m = Model()
    m.point("P", (0.3, -0.2, 0.5))
    m.frame("R", (0.8, 0.0, 0.6, 0.0))
    m.point("Q", (1.0, 0.4, 0.1))
    m.body_point("pin", "P", "R", "Q")
    m.body("b", "P", "R", mass=1.0, inertia=(1.0, 1.5, 2.0))
    m.angular_velocity("R")
    for axis, rate in zip("xyz", (0.3, -1.0, 2.0), strict=True):
        m.initial(f"R.omega.w{axis}", rate=rate)
    motion = m.build().simulate(2.0, samples=9)
    distance = np.linalg.norm(motion.position("Q") - motion.position("P"), axis=1)
    assert np.max(np.abs(distance - distance[0])) < 1e-12
    omega = np.column_stack([motion.rate(f"R.omega.w{axis}") for axis in "xyz"])
    expected = motion.velocity("P") + np.cross(omega, motion.position("Q") - motion.position("P"))
    assert np.max(np.abs(motion.velocity("Q") - expected)) < 1e-10
