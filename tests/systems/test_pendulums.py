"""Pendulums: hanging rods, the simple pendulum of the IFToMM library, spherical and conical motion."""

import json
from pathlib import Path

import numpy as np
import pytest
from differences import pendulum, worst
from scipy.special import ellipj, ellipk

from flexel.parts.model import Model

DATA = Path(__file__).parent.parent / "data"


@pytest.mark.parametrize("length", [0.2, 1.0, 7.0])
def test_rod_hanging_on_a_hinge_has_frequency_3g_2L(length: float) -> None:
    m = Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (0, 0, -length))
    R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0))
    m.beam("rod", O, R1, A, mass_per_length=2.0)
    w = m.build().linearize().eigenvalues()
    assert np.max(np.abs(w - [-1j * np.sqrt(1.5 * 9.81 / length), 1j * np.sqrt(1.5 * 9.81 / length)])) < 1e-12


def test_inverted_rod_falls_with_the_same_rate() -> None:
    m = pendulum(mass_per_length=0.7)
    m.initial("pivot.angle", -np.pi / 2)
    w = m.build().linearize().eigenvalues()
    assert np.max(np.abs(w - [-np.sqrt(14.715), np.sqrt(14.715)])) < 1e-12


def test_compound_pendulum_with_offset_mass_centre() -> None:
    m, g = Model(gravity=(0, 0, -9.81)), 9.81
    O = m.point("O", (0, 0, 0), fixed=True)
    R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0))
    c, J = np.array([0.3, 0.2, -0.4]), np.array([[0.6, 0.1, -0.2], [0.1, 0.9, 0.05], [-0.2, 0.05, 0.5]])
    m.body("plate", O, R1, mass=3.0, inertia=J, offset=c)
    m.independent("pivot.angle")
    s = m.build()
    rest = s.steady()
    a = np.hypot(c[0], c[2])
    w = s.linearize(rest).eigenvalues()
    assert abs(w[1] - 1j * np.sqrt(3.0 * g * a / (J[1, 1] + 3.0 * a**2))) < 1e-12
    assert abs(np.tan(rest["pivot.angle"]) + c[0] / c[2]) < 1e-12  # the mass centre is below the axis
    assert abs(rest.force("O.z") - 3.0 * g) < 1e-12
    assert abs(rest.force("O.x")) + abs(rest.force("O.y")) < 1e-12


def test_simple_pendulum_follows_the_iftomm_reference() -> None:
    data = json.loads((DATA / "iftomm_A01_pendulum.json").read_text())
    m = Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (-1, 0, 0))
    R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0))
    m.beam("rod", O, R1, A)
    m.point_mass("bob", A, 1.0)
    rows = data["reference"]
    motion = m.build().simulate(10.0, times=[float(row["t"]) for row in rows], rtol=1e-12, atol=1e-13)
    for state, row in zip(motion, rows, strict=True):
        computed = [*state.position("A")[[0, 2]], *state.velocity("A")[[0, 2]]]
        assert (
            worst(np.array(computed), np.array([float(row[key]) for key in ("x", "y", "vx", "vy")])) < 2e-10
        )
    assert np.ptp(motion.energy["total"]) < 1e-10
    assert np.max(motion.drift) < 1e-13


def test_simple_pendulum_as_a_planar_truss_and_in_elliptic_functions() -> None:
    """θ = 2 asin(k sn(K - ω t, k)) for a pendulum let go at rest; here k = sin 45°."""
    m = Model(gravity=(0, -9.81))
    O, A = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0))
    m.truss("rod", O, A)
    m.point_mass("bob", A, 2.0)
    motion = m.build().simulate(10.0, rtol=1e-12, atol=1e-13)
    sn, *_ = ellipj(ellipk(0.5) - np.sqrt(9.81) * motion.t, 0.5)
    theta = 2 * np.arcsin(np.sqrt(0.5) * sn)
    reference = np.column_stack([np.sin(theta), -np.cos(theta)])
    assert np.max(np.abs(motion.position("A") - reference)) < 3e-9
    assert motion.statistics["rechoices"] > 0  # x and y take turns as coordinate
    # tension: m g cos + m v²/L
    tension = 2 * 9.81 * np.cos(theta) + 2 * np.sum(motion.velocity("A") ** 2, axis=1)
    assert np.max(np.abs(motion.force("rod.elongation") - tension)) < 1e-8


def spherical() -> Model:
    m = Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (0, 0, -1))
    m.truss("rod", O, A)
    m.point_mass("bob", A, 0.5)
    return m


def test_spherical_pendulum_conserves_energy_and_vertical_angular_momentum() -> None:
    m = spherical()
    m.independent("A.x", "A.y")
    m.initial("A.x", 0.6, rate=0.3)
    m.initial("A.y", -0.2, rate=2.5)
    motion = m.build().simulate(8.0, rtol=1e-11, atol=1e-12)
    x, v = motion.position("A"), motion.velocity("A")
    h = x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]
    assert np.ptp(h) < 1e-9
    assert np.ptp(motion.energy["total"]) < 1e-9
    assert np.max(np.abs(np.linalg.norm(x, axis=1) - 1)) < 1e-13


def test_conical_pendulum_goes_round_at_its_closed_form_rate() -> None:
    """ω² = g / (L cos α), rod force m g / cos α."""
    alpha = 0.9
    omega = np.sqrt(9.81 / np.cos(alpha))
    m = spherical()
    m.independent("A.x", "A.y")
    m.initial("A.x", np.sin(alpha), rate=0)
    m.initial("A.y", 0.0, rate=omega * np.sin(alpha))
    motion = m.build().simulate(5.0, rtol=1e-12, atol=1e-13)
    circle = np.sin(alpha) * np.column_stack([np.cos(omega * motion.t), np.sin(omega * motion.t)])
    assert np.max(np.abs(motion.position("A")[:, :2] - circle)) < 1e-9
    assert np.max(np.abs(motion.force("rod.elongation") - 0.5 * 9.81 / np.cos(alpha))) < 1e-9


def test_conical_motion_is_steady_in_polar_coordinates_and_its_nutation_is_closed_form() -> None:
    """About the conical motion the cone angle swings with ω_n² = ω² (1 + 3 cos²α)."""
    alpha = 0.9
    omega = np.sqrt(9.81 / np.cos(alpha))
    m = Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (0, 0, -1))
    R0, R1, R2 = m.frame("R0", fixed=True), m.frame("R1"), m.frame("R2")
    m.hinge("azimuth", R0, R1, axis=(0, 0, 1))
    m.hinge("cone", R1, R2, axis=(0, -1, 0))
    m.beam("rod", O, R2, A)
    m.point_mass("bob", A, 0.5)
    m.initial("cone.angle", 0.7, rate=0)
    m.initial("azimuth.angle", 0.0, rate=omega)
    s = m.build()
    steady = s.steady(rates={"azimuth.angle": omega, "cone.angle": 0}, unknown=["cone.angle"])
    assert abs(steady["cone.angle"] - alpha) < 1e-12
    w = s.linearize(steady).eigenvalues()
    assert abs(np.max(w.imag) - omega * np.sqrt(1 + 3 * np.cos(alpha) ** 2)) < 1e-11
