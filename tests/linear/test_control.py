"""Linearizations handed to control engineering: labels, and the same answers as the nonlinear model gives."""

import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat
from scipy.signal import lsim

import flexel as fx
from flexel.mechanics.modes import sort_eigenvalues


def cart(prescribed: bool = False, damping: float = 0.0) -> fx.System:
    """A cart along x that carries a pendulum of 1 m."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("C", (0, 0))
    m.fix("C.y")
    m.angle("rail", fixed=True)
    m.angle("turn")
    m.point("B", (0, -1))
    m.point_mass("cart", "C", 2.0)
    m.point_mass("bob", "B", 0.5)
    m.hinge("pivot", "rail", "turn")
    m.beam("rod", "C", "turn", "B", rigid=True)
    if damping:
        m.spring("pivot.angle", 0.0, damping)
    m.independent("pivot.angle", *([] if prescribed else ["C.x"]))
    if prescribed:
        m.prescribe("C.x", lambda t: 0.01 * np.sin(2 * t))
    return m.build()


def test_python_control_gets_labelled_poles_and_transfer_functions() -> None:
    """From the force on the cart to its position: (s² + g/l) / (s² (M s² + (M + m) g / l))."""
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    lin = cart().linearize()
    plant = lin.to_control(["C.x"], ["C.x", "pivot.angle", "C.x'"], name="cart")
    assert isinstance(plant, control.StateSpace)
    assert plant.name == "cart"
    assert plant.input_labels == ["C_x"]
    assert plant.output_labels == ["C_x", "pivot_angle", "C_x'"]
    assert plant.state_labels == ["pivot_angle'", "C_x'", "pivot_angle", "C_x"]
    assert sort_eigenvalues(plant.poles()) == pytest.approx(lin.eigenvalues(), abs=1e-12)
    s = 0.7 + 1.3j
    expected = (s**2 + 9.81) / (s**2 * (2 * s**2 + 2.5 * 9.81))
    assert plant(s)[:, 0] == pytest.approx([expected, expected_angle(s), s * expected], rel=1e-12)


def expected_angle(s: complex) -> complex:
    """From the force on the cart to the pendulum's angle."""
    return -(s**2) / (s**2 * (2 * s**2 + 2.5 * 9.81))


def test_named_signals_can_be_connected() -> None:
    """A loop is closed by names, and a PD controller moves the poles to where they are calculated to be."""
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    plant = cart().linearize().to_control(["pivot.angle"], ["pivot.angle", "pivot.angle'"], name="cart")
    plant.input_labels = ["torque"]
    measured = ["pivot_angle", "pivot_angle'"]
    gain = control.ss([], [], [], [[-30.0, -4.0]], inputs=measured, outputs=["torque"], name="gain")
    loop = control.interconnect([plant, gain], inputs=["torque"], outputs=["pivot_angle"])
    m_eff = 0.5 * 2.0 / 2.5  # inertia of the free cart and pendulum about the pivot
    wanted = np.roots([m_eff, 4.0 * 1.0, 30.0 + 0.5 * 9.81])
    found = np.array([pole for pole in loop.poles() if abs(pole) > 1e-6])
    assert sort_eigenvalues(found) == pytest.approx(sort_eigenvalues(wanted), rel=1e-9)


def test_scipy_predicts_small_motions_of_the_nonlinear_model() -> None:
    """Under a prescribed motion of the cart: acceleration is the input, rate and value are states."""
    system = cart(prescribed=True, damping=0.3)
    lin = system.linearize()
    plant = lin.to_scipy(["C.x"], ["pivot.angle", "C.x", "force:C.x"])
    motion = system.simulate(3.0, samples=601, rtol=1e-10)
    u = -0.04 * np.sin(2 * motion.t)
    x0 = np.array([0.0, 0.0, 0.02, 0.0])
    x0[0] = motion.rate("pivot.angle")[0]
    _, y, _ = lsim(plant, u, motion.t, x0)
    assert np.max(np.abs(y[:, 0] - motion["pivot.angle"])) < 2e-6
    assert np.max(np.abs(motion["pivot.angle"])) > 5e-3
    assert np.max(np.abs(y[:, 1] - motion["C.x"])) < 1e-6
    assert np.max(np.abs(y[:, 2] - (motion.force("C.x") - motion.force("C.x")[0]))) < 2e-5


def test_matlab_gets_the_matrices_and_their_names(tmp_path: Path) -> None:
    lin = cart(prescribed=True).linearize()
    path = lin.save_state_space(tmp_path / "cart.mat", ["pivot.angle", "C.x"], ["B.x", "pivot.angle'"])
    contents = loadmat(path, simplify_cells=True)
    for name, expected in zip(
        "ABCD", lin.state_space(["pivot.angle", "C.x"], ["B.x", "pivot.angle'"]), strict=True
    ):
        assert np.array_equal(contents[name].reshape(expected.shape), expected)
    assert list(contents["states"]) == ["pivot.angle'", "pivot.angle", "C.x'", "C.x"]
    assert list(contents["inputs"]) == ["pivot.angle", "C.x''"]
    assert list(contents["outputs"]) == ["B.x", "pivot.angle'"]
    with pytest.raises(fx.ModelError, match=r"use \.mat"):
        lin.save_state_space(tmp_path / "cart.m", ["C.x"])


def test_the_displacement_of_a_prescribed_motion_as_input() -> None:
    """The transfer function to a displacement is that to the acceleration, times s²."""
    lin = cart(prescribed=True, damping=0.3).linearize()
    outputs = ["pivot.angle", "B.x", "C.x"]
    A, B, C, D = lin.state_space(["C.x''", "pivot.angle"], outputs)
    plant = lin.state_space(["displacement:C.x", "pivot.angle"], outputs)
    assert plant[0].shape == (2, 2)
    for s in (0.3j, 2.0 + 1.0j, 40j):
        by_acceleration = C @ np.linalg.solve(s * np.eye(4) - A, B) + D
        by_displacement = plant[2] @ np.linalg.solve(s * np.eye(2) - plant[0], plant[1]) + plant[3]
        assert by_displacement == pytest.approx(by_acceleration * [s**2, 1.0], rel=1e-9, abs=1e-12)
    pytest.importorskip("control", reason="needs pip install 'flexel[control]'")
    labelled = lin.to_control(["displacement:C.x"], ["pivot.angle"])
    assert labelled.input_labels == ["displacement:C_x"]
    assert labelled.state_labels == ["pivot_angle'*", "pivot_angle*"]
    assert lin.to_control(["C.x"], ["pivot.angle"]).input_labels == ["C_x''"]
    with pytest.raises(fx.LinearizationError, match=r"output 'pivot.angle'' contains its rate; .*\"C.x''\""):
        lin.state_space(["displacement:C.x"], ["B.x", "pivot.angle'"])
    with pytest.raises(fx.LinearizationError, match=r"'pivot.angle' is not prescribed"):
        lin.state_space(["displacement:pivot.angle"])
    with pytest.raises(fx.LinearizationError, match=r"'C.x' is already an input"):
        lin.state_space(["C.x", "displacement:C.x"])


def test_what_is_wrong_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    lin = cart().linearize()
    with pytest.raises(fx.LinearizationError, match="no input is named"):
        lin.to_scipy([])
    with pytest.raises(fx.LinearizationError, match=r"input 'C\.x' is named twice"):
        lin.to_scipy(["C.x", "C.x"])
    with pytest.raises(fx.ModelError, match=r"is not a list of names"):
        lin.to_scipy("C.x")
    with pytest.raises(fx.ModelError, match=r"did you mean pivot\.angle"):
        lin.to_scipy(["pivot.angel"])
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(fx.FlexelError, match=r"needs control, .*pip install 'flexel\[control\]'"):
        lin.to_control(["C.x"])


@pytest.mark.parametrize("suffix", [".npz", ".nc", ".mat", ".csv"])
def test_a_linearization_from_a_file_answers_like_the_one_that_was_saved(tmp_path: Path, suffix: str) -> None:
    lin = cart(prescribed=True, damping=0.3).linearize()
    read = fx.load(lin.save(tmp_path / f"cart{suffix}"))
    assert isinstance(read, fx.Linearization)
    assert read.states == lin.states
    assert np.array_equal(read.eigenvalues(), lin.eigenvalues())
    assert read.modes()[0].shape == lin.modes()[0].shape
    asked = (["pivot.angle", "C.x"], ["B.x", "B.y''", "force:C.x", "force:rod.along"])
    for a, b in zip(read.state_space(*asked), lin.state_space(*asked), strict=True):
        assert np.array_equal(a, b)
    assert np.array_equal(read.reduced(["pivot.angle"]).K, lin.reduced(["pivot.angle"]).K)
    assert read.state["B.y"] == lin.state["B.y"]
    assert np.array_equal(fx.load(read.save(tmp_path / "again.npz")).M, lin.M)


def test_xarray_and_pandas_have_names_along_rows_and_columns() -> None:
    lin = cart(damping=0.3).linearize()
    found = lin.to_xarray()
    assert found["M"].sel(dynamic="C.x", dynamic_column="pivot.angle") == lin.M[0, 1]
    assert np.array_equal(found["eigenvalue"], lin.eigenvalues())
    assert found["K"].sel(dof="pivot.angle")["dof_unit"] == "rad"
    assert found["state_matrix"].sel(state="C.x'")["state_unit"] == "m/s"
    assert lin.units == {"C.x": "m", "pivot.angle": "rad", "C.x'": "m/s", "pivot.angle'": "rad/s"}
    modes = lin.to_pandas()
    swing = modes[modes["imaginary part"] > 0]
    assert swing["omega"].iloc[0] == pytest.approx(np.sqrt(9.81 * 2.5 / 2), rel=1e-12)
    assert swing["damping ratio"].iloc[0] > 0
    assert modes.attrs["units"]["omega"] == "rad/s"
