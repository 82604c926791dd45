"""Linearized equations against closed forms: stiffness, eigenvalues, choice of coordinates."""

import numpy as np
import pytest
from coarse import COARSE_MESH
from differences import (
    worst,
)
from moving import MODELS

from flexel.parts.model import Model


@COARSE_MESH
@pytest.mark.parametrize("name", ["loop", "planar", "flexible_arm"])
def test_stiffness_is_symmetric_in_a_conservative_equilibrium(name: str) -> None:
    m = MODELS[name]()
    m.lowering.rates.clear()
    m.lowering.values.clear()
    s = m.build()
    lin = s.linearize(s.equilibrium(stable=True) if name == "loop" else s.steady())
    assert worst(lin.K, lin.K.T) < 1e-12
    assert worst(lin.C, lin.C.T) < 1e-12


def test_eigenvalues_do_not_depend_on_the_chosen_dofs() -> None:
    m = MODELS["loop"]()
    m.lowering.rates.clear()
    s = m.build()
    rest = s.equilibrium(stable=True)
    w = s.linearize(rest).eigenvalues()
    s.use_coordinates(["output.angle"])
    assert worst(s.linearize(rest).eigenvalues(), w) < 1e-12


def test_damped_oscillator_has_the_textbook_eigenvalues() -> None:
    """λ = -δ ± i sqrt(ω₀² - δ²), δ = d/2m; and of a hinge with torsional spring and damper likewise."""
    m = Model()
    O, P = m.point("O", (0, 0, 0), fixed=True), m.point("P", (1, 0, 0))
    m.fix("P.y", "P.z")
    m.truss("spring", O, P, stiffness=40.0, damping=3.0)
    m.point_mass("mass", P, 2.5)
    w = m.build().linearize().eigenvalues()
    delta = 3.0 / 5.0
    assert np.max(np.abs(w - (-delta + np.array([-1j, 1j]) * np.sqrt(16.0 - delta**2)))) < 1e-13
    m = Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    a, b = m.frame("a", fixed=True), m.frame("b")
    m.hinge("hinge", a, b, axis=(1, 2, 3), stiffness=5.0, damping=9.0)
    m.body("wheel", O, b, mass=1.0, inertia=(2.0, 2.0, 2.0))
    lin = m.build().linearize()
    assert np.max(np.abs(lin.eigenvalues() - np.sort(np.roots([2.0, 9.0, 5.0])))) < 1e-13
    assert lin.modes()[0].name == "hinge.angle"


def test_mass_on_a_turntable_has_split_frequencies() -> None:
    """A mass on equal springs in a frame turning at Ω: λ = ± i (ω₀ ± Ω), Coriolis and centrifugal terms both."""
    m, rate = Model(), 1.3
    O, P = m.point("O", (0, 0, 0), fixed=True), m.point("P", (0, 0, 0))
    ground, table = m.frame("ground", fixed=True), m.frame("table")
    m.hinge("turn", ground, table, axis=(0, 0, 1))
    m.body_point("guide", O, table, P)
    for direction in ("along", "across1"):
        m.spring(f"guide.{direction}", 50.0)
    m.point_mass("mass", P, 2.0)
    m.prescribe("turn.angle", lambda t: rate * t)
    m.independent("guide.along", "guide.across1")
    lin = m.build().linearize()
    expected = np.sort([5 + rate, 5 - rate, -5 + rate, -5 - rate])
    assert np.max(np.abs(np.sort(lin.eigenvalues().imag) - expected)) < 1e-12
    assert np.max(np.abs(lin.eigenvalues().real)) < 1e-12
    assert worst(lin.C, 2 * 2.0 * rate * np.array([[0, -1], [1, 0]])) < 1e-13
