"""The flexible manipulator: rigid limit in closed form, exact closed loops, and what the regulator is worth."""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.integrate import solve_ivp
from scipy.signal import StateSpace

import flexel as fx
from flexel.apps.cli.main import main
from flexel.examples.manipulator import (
    DESIGN,
    JOINTS,
    TIP,
    Arm,
    joint_control,
    manipulator,
    manoeuvre,
    regulator,
    tip_error,
    workspace,
)
from flexel.mechanics.modes import sort_eigenvalues


@pytest.fixture(scope="module")
def design() -> fx.Linearization:
    return manipulator(0.0, DESIGN).linearize()


@pytest.mark.parametrize("elbow", [0.3, DESIGN, 2.8])
def test_rigid_links_have_the_mass_matrix_of_the_textbook(elbow: float) -> None:
    """Two uniform rods with point masses, in relative angles."""
    arm = Arm()
    lin = manipulator(0.2, elbow, rigid=True).linearize()
    rod, l = arm.mass_per_length * arm.length, arm.length
    lower = rod * l**2 / 3 + arm.payload * l**2 + arm.hub
    coupling = (rod / 2 + arm.payload) * l**2 * np.cos(elbow)
    upper = rod * l**2 / 3 + (arm.motor + rod + arm.payload) * l**2 + arm.hub
    expected = [[upper + lower + 2 * coupling, lower + coupling], [lower + coupling, lower]]
    assert lin.dynamic == JOINTS
    assert lin.M == pytest.approx(np.array(expected), rel=1e-12)


def test_the_closed_loop_has_the_poles_of_the_design(design: fx.Linearization) -> None:
    """The controller in the nonlinear model, linearized analytically, against A - B K."""
    gains = regulator(design)
    A, B, _, _ = design.state_space(JOINTS)
    wanted = sort_eigenvalues(np.linalg.eigvals(A - B @ np.hstack([gains.D, gains.P])))
    found = manipulator(0.0, DESIGN, gains).linearize().eigenvalues()
    assert np.max(np.abs(found - wanted)) < 1e-9 * np.max(np.abs(wanted))
    assert found.real.max() < -6.5


def test_one_design_is_stable_over_the_workspace_and_damps_more_than_joint_control(
    design: fx.Linearization,
) -> None:
    elbows = np.radians([10.0, 90.0, 130.0])
    slowest = [
        [lin.eigenvalues().real.max() for lin in workspace(elbows, gains)]
        for gains in (regulator(design), joint_control(design))
    ]
    assert max(slowest[0]) < -2.0
    assert all(a < 2 * b for a, b in zip(*slowest, strict=True))
    folded = workspace([np.radians(170.0)], regulator(design))[0]
    assert (
        folded.eigenvalues().real.max() > 1.0
    )  # there the gains must be others: the linearizations show it in advance


def test_the_nonlinear_closed_loop_settles_where_joint_control_still_swings(design: fx.Linearization) -> None:
    """Both joints turn by 80 degrees in a second; then the payload rests within 2 mm, or swings by 0.5 m."""
    errors = []
    for gains in (regulator(design), joint_control(design)):
        motion = manoeuvre(gains, 2.0, 41)
        errors.append(tip_error(motion)[motion.t > 1.5])
        assert motion["shoulder command.angle"][-1] == pytest.approx(np.radians(80), abs=1e-12)
    assert errors[0].max() < 2e-3
    assert errors[0][-1] < 0.5 * errors[0][0]
    assert errors[1].max() > 0.5


def test_two_integrators_agree_on_the_closed_loop(design: fx.Linearization) -> None:
    """The motion over the first quarter of a second, by the implicit method and by LSODA of SciPy."""
    gains = regulator(design)
    motion = manoeuvre(gains, 0.25, 6, tolerance=1e-7)
    system = motion.system
    start = system.initial
    y = np.concatenate([start.q, start.qd])
    found = solve_ivp(system.rhs, (0, 0.25), y, method="LSODA", t_eval=motion.t, rtol=1e-7, atol=1e-9).y
    elbow = found[system.dynamic.index("elbow.angle")]
    scale = np.abs(elbow).max()
    assert scale > 0.02
    assert np.abs(motion["elbow.angle"] - elbow).max() < 1e-4 * scale


@pytest.mark.long
def test_the_example_runs_as_a_users_file(tmp_path: Path, checkout: Path) -> None:
    """`flexel run` on the example: its pictures, and its motion to be viewed."""
    pytest.importorskip("matplotlib", reason="the example draws: pip install 'flexel[plot]'")
    file = checkout / "examples" / "manipulator.py"
    result = CliRunner().invoke(main, ["run", str(file), "--out", str(tmp_path)])
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in tmp_path.glob("*.png")) == [
        f"manipulator_{name}.png" for name in ("closed_loop", "poles", "shapes")
    ]
    assert tip_error(fx.load(tmp_path / "manipulator.npz"))[-1] < 2e-3  # type: ignore[arg-type]


def test_small_errors_decay_as_the_linear_closed_loop_says(design: fx.Linearization) -> None:
    """An initial error of a thousandth of a radian; nonlinear terms are of the second order."""
    system = manipulator(0.0, DESIGN, regulator(design))
    lin = system.linearize()
    start = system.state_at({"elbow.angle": 1e-3})
    motion = system.simulate(0.2, start=start, samples=5, rtol=1e-6, atol=1e-10)
    w, V = np.linalg.eig(lin.state_matrix)
    y0 = np.concatenate([start.qd, start.q])
    i = lin.states.index("elbow.angle")
    linear = [(V[i] * np.exp(w * t) @ np.linalg.solve(V, y0)).real for t in motion.t]
    assert np.max(np.abs(motion["elbow.angle"] - linear)) < 2e-6


def test_python_control_designs_the_same_regulator(design: fx.Linearization) -> None:
    control = pytest.importorskip("control", reason="pip install 'flexel[control]'")
    gains = regulator(design)
    plant = design.to_control(JOINTS, TIP)
    weights = np.diag([1.0, 1.0, 0.15, 0.15]) @ plant.C
    K, _, _ = control.lqr(plant.A, plant.B, weights.T @ weights, 1e-5 * np.eye(2))
    assert np.hstack([gains.D, gains.P]) == pytest.approx(K, rel=1e-6, abs=1e-6 * np.max(np.abs(K)))


def test_the_results_of_the_loop_are_saved_and_go_on(design: fx.Linearization, tmp_path: Path) -> None:
    gains = joint_control(design)
    motion = manoeuvre(gains, 0.1, 3)
    read = fx.load(motion.save(tmp_path / "arm.npz"))
    assert np.array_equal(read["lower2.bend2"], motion["lower2.bend2"])
    assert motion.system.restore(read).force("elbow.angle") == motion[-1].force("elbow.angle")


def test_an_integrating_controller_leaves_no_error_under_a_load() -> None:
    """PID on a hinge: poles of s³ + 2 s² + 4 s + 1 (unit inertia), and no error left under a constant moment."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("motor", "ground", "turn")
    m.body("rotor", "O", "turn", mass=1.0, inertia=1.0)
    m.load("motor.angle", 0.7)
    pid = StateSpace([[0.0]], [[1.0, 0.0]], [[1.0]], [[4.0, 2.0]])
    measured, wanted = ["motor.angle", "motor.angle'"], {"motor.angle": 0.5}
    m.controller(pid, name="pid", inputs=measured, outputs=["motor.angle"], reference=wanted)
    system = m.build()
    poles = system.linearize(system.steady()).eigenvalues()
    assert poles == pytest.approx(sort_eigenvalues(np.roots([1, 2, 4, 1])), rel=1e-12)
    motion = system.simulate(60.0, samples=4)
    assert motion["motor.angle"][-1] == pytest.approx(0.5, abs=1e-6)
    assert motion["pid.x0"][-1] == pytest.approx(-0.7, abs=1e-6)
