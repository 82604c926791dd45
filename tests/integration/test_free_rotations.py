"""Orientations that turn freely: their motions cost no more where Euler parameters change places, and are as smooth."""

import numpy as np
import pytest
from mechanisms import heavy_top
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.base.arrays import Array
from flexel.engine.rotations import Rotations

INERTIA = np.array([1.0, 2.0, 3.0])
SPIN = np.array([0.3, 5.0, 0.5])  # close to the unstable axis [rad/s]
END = 20.0


def tumbling() -> fx.System:
    """A free body that turns about its unstable axis, and over it."""
    m = fx.Model()
    m.body("body", m.point("P", (0, 0, 0)), m.frame("R"), mass=1.0, inertia=tuple(INERTIA))
    w = m.angular_velocity("R")
    for name, rate in zip(("wx", "wy", "wz"), SPIN, strict=True):
        m.initial(f"{w}.{name}", rate=rate)
    return m.build()


def euler(_: float, y: Array) -> Array:
    """Euler's equations of the body, whose axes are those of the frame, and the rates of its Euler parameters."""
    L, w = y[:4], y[4:]
    rates = 0.5 * np.concatenate([[-L[1:] @ w], L[0] * w + np.cross(L[1:], w)])
    return np.concatenate([rates, -np.cross(w, INERTIA * w) / INERTIA])


def test_a_tumbling_body_follows_eulers_equations() -> None:
    """100 rad, with 38 changes of the degrees of freedom: 5135 evaluations and an error of 4.5e-8 before."""
    motion = tumbling().simulate(END, samples=401, method="DOP853")
    found = solve_ivp(
        euler, (0, END), [1, 0, 0, 0, *SPIN], method="DOP853", rtol=1e-13, atol=1e-14, t_eval=motion.t
    ).y
    L = np.array([motion[f"R.lambda{i}"] for i in range(4)])
    L *= np.sign(np.sum(L * found[:4], axis=0))
    assert np.max(np.abs(L - found[:4])) < 2e-8
    energy = motion.energy["total"]  # of states within steps as at their ends
    assert np.max(np.abs(energy / energy[0] - 1)) < 2e-8
    assert motion.rechoices
    assert motion.statistics["evaluations"] < 3300


def test_a_top_costs_no_steps_where_its_euler_parameters_change_places() -> None:
    """The heavy top: 822 of 1528 steps were refused, and the energy was exact to 3e-8."""
    motion = heavy_top().simulate(1.5, samples=301, method="DOP853")
    assert len(motion.rechoices) > 50 and motion.statistics["rejected"] < 10
    assert motion.statistics["evaluations"] < 8000  # 19 188 in charts, at full tolerances
    energy = motion.energy["total"]
    assert np.max(np.abs(energy - energy[0])) < 4e-10 * np.max(motion.energy["kinetic"])


def test_angular_velocities_give_rates_of_euler_parameters() -> None:
    """The inverse of w = 2 E L', for all choices of three Euler parameters, against the quaternion product."""
    s = tumbling().structure
    rng = np.random.default_rng(1)
    for rest in range(4):
        part = [i for i in range(4) if i != rest]
        quantities = [s.find(f"R.lambda{i}") for i in range(4)]
        at = np.array([quantities]) - s.m - s.k
        r = Rotations(at, np.array([part]), np.array([rest]), np.array([[2, 0, 1]]), 3)
        L, w = rng.normal(size=4), rng.normal(size=3)
        L /= np.linalg.norm(L)
        v = 0.5 * np.concatenate([[-L[1:] @ w], L[0] * w + np.cross(L[1:], w)])
        y = np.zeros(6)
        y[[2, 0, 1]] = 3 * L[part]
        placed = r.place(y, w, 3 * L[[rest]])
        assert placed[[2, 0, 1]] == pytest.approx(L[part], abs=1e-15)
        assert placed[[5, 3, 4]] == pytest.approx(v[part], abs=1e-15)


def test_only_orientations_with_three_free_euler_parameters_are_integrated_so() -> None:
    """Not one on a hinge, and not one on a universal joint."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("ground", fixed=True)
    m.hinge("first", "ground", m.frame("A"), axis=(1, 0, 0))
    m.hinge("second", "A", m.frame("B"), axis=(0, 1, 0))
    m.body("rotor", "O", "B", mass=1.0, inertia=(1.0, 2.0, 3.0))
    system = m.build()
    assert Rotations.of(system.structure, system.roles).count == 0
    free = tumbling()
    assert Rotations.of(free.structure, free.roles).count == 1


def on_a_spring(spin: Array) -> fx.System:
    """A body that spins [rad/s], and hangs on a spring that is fixed beside its centre of mass."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("O", (0, 0, 1), fixed=True)
    m.rigid_body("body", (0, 0, 0), mass=1.0, inertia=(0.02, 0.03, 0.015))
    m.body_point("arm", "body", "body_frame", m.point("P", (0.1, 0, 0)))
    m.truss("spring", "O", "P", stiffness=20.0)
    for i in range(3):
        m.initial(f"body_frame.lambda{i + 1}", rate=spin[i] / 2)
    return m.build()


@pytest.mark.parametrize("seed", range(12))
def test_a_body_spinning_on_a_spring_is_where_it_was_found_after_a_comparison_of_coordinates(
    seed: int,
) -> None:
    """Whether other coordinates are better was asked in the workspace of the trial: 10 of these 12 motions stopped."""
    rng = np.random.default_rng(seed)
    system = on_a_spring(rng.normal(size=3) * rng.choice([5.0, 20.0, 80.0]))
    exact = system.simulate(2.0, samples=51, method="DOP853", rtol=1e-12, atol=1e-13)
    motion = system.simulate(2.0, samples=51, method="DOP853", rtol=1e-6)
    for name in ("P.x", "P.y", "P.z", "body.z", "P.x'", "P.z'", "body.x'", "body.z'", "spring.elongation'"):
        assert np.max(np.abs(motion[name] - exact[name])) < 2e-5 * np.ptp(exact[name])  # what rtol promises
