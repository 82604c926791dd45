"""Wheels with a crown: the torus against the equations of Newton and Euler."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.base.quaternions import matrix

UP = np.array([0.0, 0.0, 1.0])


# -- the torus ------------------------------------------------------------------------------------

MASS, RING, CROSS = 2.0, 0.08, 0.05  # inertias about and across the axle


def torus(crown: float, lean: float, rates: tuple[float, float, float]) -> fx.System:
    """A rolling wheel of radius 0.3 m with a crown; rates of yaw, lean and spin."""
    m = fx.Model(gravity=(0, 0, -9.81))
    ground, yawed, leaned, rolled = (
        m.frame(name, fixed=name == "ground") for name in ("ground", "Y", "L", "S")
    )
    m.point("hub", (0, 0, 0.3))
    m.point("contact", (0, 0, 0))
    m.hinge("yaw", ground, yawed, axis=(0, 0, 1))
    m.hinge("lean", yawed, leaned, axis=(1, 0, 0))
    m.hinge("roll", leaned, rolled, axis=(0, 1, 0))
    m.wheel("wheel", "hub", rolled, "contact", radius=0.3, axle=(0, 1, 0), crown=crown)
    m.body("body", "hub", rolled, mass=MASS, inertia=(CROSS, RING, CROSS))
    m.independent("yaw.angle", "lean.angle", "roll.angle")
    m.kinematic("contact.x", "contact.y")
    m.initial("lean.angle", lean, rate=rates[1])
    m.initial("yaw.angle", rate=rates[0])
    m.initial("roll.angle", rate=rates[2])
    return m.build()


def newton_euler(crown: float, a: np.ndarray, omega: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rates of the axle and the angular velocity of a rolling torus, by the momenta about its centre."""
    rim = 0.3 - crown

    def arm(axle: np.ndarray) -> np.ndarray:
        inward = UP - (axle @ UP) * axle
        return -rim * inward / np.linalg.norm(inward) - crown * UP

    ad, h = np.cross(omega, a), 1e-6
    c, cd = arm(a), (arm(a + h * ad) - arm(a - h * ad)) / (2 * h)
    # centre: v = -omega x c, so v' = c x omega' - omega x c';  force F = m (v' + g up);  moment c x F
    given = MASS * (-np.cross(omega, cd) + 9.81 * UP)
    spin = (RING - CROSS) * (omega @ a)
    A = np.zeros((3, 3))
    for i, unit in enumerate(np.eye(3)):
        A[:, i] = CROSS * unit + (RING - CROSS) * (unit @ a) * a - np.cross(c, MASS * np.cross(c, unit))
    rhs = np.cross(c, given) - spin * ad - (RING - CROSS) * (omega @ ad) * a
    return ad, np.linalg.solve(A, rhs)


@pytest.mark.parametrize("crown", [0.02, 0.15, 0.27])
def test_a_torus_rolls_as_newton_and_euler_say(crown: float) -> None:
    system = torus(crown, 0.35, (0.4, -0.3, 9.0))
    motion = system.simulate(1.5, rtol=1e-11, atol=1e-12, times=np.linspace(0, 1.5, 16))
    axle = np.array([matrix(state.position("S"))[:, 1] for state in motion])
    R0 = matrix(motion[0].position("L"))
    omega = np.array([0, 0, 0.4]) + np.array([-0.3, 0, 0]) + 9.0 * R0[:, 1]

    def rhs(_: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate(newton_euler(crown, y[:3], y[3:]))

    y0 = np.concatenate([R0[:, 1], omega])
    found = solve_ivp(rhs, (0, 1.5), y0, t_eval=motion.t, rtol=1e-11, atol=1e-12)
    assert np.abs(axle - found.y[:3].T).max() < 1e-8
    assert np.ptp(motion.energy["total"]) < 1e-9 * motion[0].energy.total


def test_a_crown_of_nothing_is_the_knife_edge() -> None:
    thin = torus(1e-9, 0.35, (0.4, -0.3, 9.0)).initial
    sharp = torus(0.0, 0.35, (0.4, -0.3, 9.0)).initial
    for name in ("yaw.angle", "lean.angle", "roll.angle"):
        assert thin.acceleration(name) == pytest.approx(sharp.acceleration(name), rel=1e-7)
