"""Tops: heavy symmetric and free asymmetric, as a free frame and on three hinges."""

import json
from pathlib import Path

import numpy as np
import pytest
from differences import worst
from mechanisms import heavy_top
from scipy.special import ellipj

from flexel.base.quaternions import matrix
from flexel.parts.model import Model

DATA = Path(__file__).parent.parent / "data"
END = 2.0


def on_three_hinges(inertia: tuple[float, float, float], mass: float, height: float, axes: str) -> Model:
    """A body turning about the origin on three hinges about the named axes; its mass centre at z = height."""
    m = Model(gravity=(0, 0, -9.81))
    O = m.point("O", (0, 0, 0), fixed=True)
    frames = [m.frame("ground", fixed=True), m.frame("outer"), m.frame("inner"), m.frame("top")]
    for name, axis, p, q in zip(("first", "second", "third"), axes, frames[:-1], frames[1:], strict=True):
        m.hinge(name, p, q, axis=np.eye(3)["xyz".index(axis)])
    m.body("body", O, frames[-1], mass=mass, inertia=inertia, offset=(0, 0, height))
    return m


def test_heavy_top_follows_the_reference() -> None:
    """A free frame that turns 48 times in 2 s and hangs straight down on the way, where Euler angles would fail."""
    data = json.loads((DATA / "heavy_top.json").read_text())
    rows = [row for row in data["reference"] if row["t"] <= END]
    motion = heavy_top().simulate(END, times=[row["t"] for row in rows], rtol=2e-12, atol=2e-12)
    assert motion.statistics["rechoices"] > 5
    for state, row in zip(motion, rows, strict=True):
        R = matrix(state.position("top"))
        assert np.max(np.abs(R[:, 1] - row["com"])) < data["tolerance"]["com_abs_t2"]
        omega = [state.rate(f"top.body_omega.w{axis}") for axis in "xyz"]
        assert worst(np.array(omega), np.array(row["omega_body"])) < 1e-8
        q = state.position("top")
        reference = np.array(row["euler_parameters_e0e1e2e3"])
        assert np.max(np.abs(q * np.sign(q @ reference) - reference)) < 1e-7  # after 300 rad of spin
    E = motion.energy["total"]
    assert abs(E[0] - data["total_energy"]) < 1e-8
    assert np.ptp(E) < data["tolerance"]["energy_rel_drift"] * E[0]


A, C, MASS, HEIGHT = 0.07, 0.02, 2.0, 0.15  # transverse inertia about the support, axial inertia
TRANSVERSE = A - MASS * HEIGHT**2


@pytest.mark.parametrize("slow", [True, False])
@pytest.mark.parametrize("theta", [0.4, 1.3, 2.2])
def test_heavy_top_precesses_and_nutates_at_the_closed_form_rates(slow: bool, theta: float) -> None:
    """A Ω² cos θ - C ω₃ Ω + m g l = 0;  ω_n² = (C ω₃ / A - 2 Ω cos θ)² + Ω² sin²θ."""
    spin, mgl = 60.0, MASS * 9.81 * HEIGHT
    roots = np.roots([A * np.cos(theta), -C * spin, mgl])
    rate = roots[np.argmin(np.abs(roots))] if slow else roots[np.argmax(np.abs(roots))]
    m = on_three_hinges((TRANSVERSE, TRANSVERSE, C), MASS, HEIGHT, "zxz")
    m.initial("second.angle", theta, rate=0)
    m.initial("first.angle", rate=0.98 * rate)
    m.initial("third.angle", rate=spin - rate * np.cos(theta))
    s = m.build()
    state = s.initial
    # with the rate about the figure axis given, the precession is what keeps the cone angle steady
    for _ in range(60):
        before = state.rate("first.angle")
        rates = {"third.angle": spin - before * np.cos(theta)}
        state = s.steady(state, rates=rates, unknown=[], unknown_rates=["first.angle"])
        if abs(state.rate("first.angle") - before) < 1e-13 * abs(rate):
            break
    assert abs(state.rate("first.angle") / rate - 1) < 1e-11
    w = s.linearize(state).eigenvalues()
    nutation = np.sqrt((C * spin / A - 2 * rate * np.cos(theta)) ** 2 + (rate * np.sin(theta)) ** 2)
    assert abs(np.max(w.imag) / nutation - 1) < 1e-11


@pytest.mark.parametrize("spin", [9.0, 15.0])
def test_sleeping_top_needs_enough_spin(spin: float) -> None:
    """Upright, on two cross hinges over the spin: λ² - i C ω/A λ - m g l/A = 0; stable if (C ω)² > 4 A m g l."""
    m = on_three_hinges((TRANSVERSE, TRANSVERSE, C), MASS, HEIGHT, "xyz")
    m.initial("third.angle", rate=10 * spin)
    s = m.build()
    w = s.linearize().eigenvalues()
    complex_form = np.roots([1, -1j * C * 10 * spin / A, -MASS * 9.81 * HEIGHT / A])
    expected = np.concatenate([complex_form, complex_form.conj()])
    assert all(np.min(np.abs(w - root)) < 1e-6 for root in expected)
    unstable = (C * 10 * spin) ** 2 < 4 * A * MASS * 9.81 * HEIGHT
    assert (np.max(w.real) > 1e-3) == unstable


def test_free_asymmetric_body_moves_in_jacobi_elliptic_functions() -> None:
    """Euler's equations; the frame tumbles freely and changes its coordinates as it goes."""
    J = np.array([1.0, 2.0, 2.7])
    T, L2 = 10.0, 44.0  # L² > 2 T J2: ω3 keeps its sign
    a = np.sqrt((2 * T * J[2] - L2) / (J[0] * (J[2] - J[0])))
    b = np.sqrt((2 * T * J[2] - L2) / (J[1] * (J[2] - J[1])))
    c = np.sqrt((L2 - 2 * T * J[0]) / (J[2] * (J[2] - J[0])))
    rate = np.sqrt((J[2] - J[1]) * (L2 - 2 * T * J[0]) / J.prod())
    k2 = (J[1] - J[0]) * (2 * T * J[2] - L2) / ((J[2] - J[1]) * (L2 - 2 * T * J[0]))
    m = Model()
    P, R = m.point("P", (0, 0, 0)), m.frame("R")
    m.body("body", P, R, mass=4.0, inertia=J)
    w = m.angular_velocity(R, body_axes=True)
    for axis, value in zip("xyz", (a, 0.0, c), strict=True):
        m.initial(f"{w}.w{axis}", rate=value)
    for axis, value in zip("xyz", (1.0, -2.0, 0.5), strict=True):
        m.initial(f"P.{axis}", rate=value)
    motion = m.build().simulate(12.0, samples=61, rtol=1e-11, atol=1e-12)
    assert motion.statistics["rechoices"] > 0
    sn, cn, dn, _ = ellipj(rate * motion.t, k2)
    omega = np.column_stack([motion.rate(f"{w}.w{axis}") for axis in "xyz"])
    assert np.max(np.abs(omega - np.column_stack([a * cn, b * sn, c * dn]))) < 1e-8
    spatial = np.array([matrix(s.position("R")) @ (J * o) for s, o in zip(motion, omega, strict=True)])
    assert np.max(np.abs(spatial - spatial[0])) < 1e-8  # angular momentum is fixed in space
    assert np.max(np.abs(motion.position("P") - np.outer(motion.t, [1.0, -2.0, 0.5]))) < 1e-10
    assert np.ptp(motion.energy["total"]) < 1e-8


@pytest.mark.parametrize("axis", range(3))
def test_only_the_spin_about_the_intermediate_axis_is_unstable(axis: int) -> None:
    """λ² = Ω² (J3 - J2)(J2 - J1) … / …: real about the intermediate axis, ± i about the other two."""
    moments, rate = (1.0, 2.0, 2.7), 3.0
    order = {"yxz": 1, "xyz": 0, "zxy": 2}
    axes = next(letters for letters, i in order.items() if i == axis)
    m = on_three_hinges(moments, 1.0, 0.0, axes)  # the first hinge carries the spin and is cyclic
    m.initial("first.angle", rate=rate)
    w = m.build().linearize().eigenvalues()
    j, k = (axis + 1) % 3, (axis + 2) % 3
    J = moments
    square = -(rate**2) * (J[axis] - J[j]) * (J[axis] - J[k]) / (J[j] * J[k])
    expected = np.sqrt(complex(square))
    assert min(abs(w - expected)) < 1e-12
    assert min(abs(w + expected)) < 1e-12
    assert min(abs(w - 1j * rate)) < 1e-12  # the fixed angular momentum, seen from the turning frame
    assert (np.max(w.real) > 0.1) == (axis == 1)
