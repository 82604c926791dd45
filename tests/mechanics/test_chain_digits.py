"""Accelerations of long chains of hinges against Newton's and Euler's equations in 40 digits."""

import mpmath as mp
import numpy as np
import pytest

import flexel as fx

LENGTH, MASS, INERTIA, GRAVITY = 0.1, 0.1, (1e-5, 8e-5, 8e-5), 9.81
HINGES = 20  # more than 16: the accelerations come from [M C'; C 0]


def chain(axes: np.ndarray) -> fx.System:
    m = fx.Model(gravity=(0, 0, -GRAVITY))
    m.point("p0", (0, 0, 0), fixed=True)
    m.frame("r0", fixed=True)
    for i, axis in enumerate(axes, start=1):
        m.point(f"p{i}", (LENGTH * i, 0, 0))
        m.frame(f"r{i}")
        m.hinge(f"h{i}", f"r{i - 1}", f"r{i}", axis=axis)
        m.beam(f"b{i}", f"p{i - 1}", f"r{i}", f"p{i}")
        m.body(f"m{i}", f"p{i}", f"r{i}", mass=MASS, inertia=INERTIA, offset=(-LENGTH / 2, 0, 0))
    m.independent(*(f"h{i + 1}.angle" for i in range(len(axes))))
    return m.build()


def exactly(values: np.ndarray) -> mp.matrix:
    return mp.matrix([mp.mpf(float(value)) for value in values])


def cross(a: mp.matrix, b: mp.matrix) -> mp.matrix:
    return mp.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def turned(axis: mp.matrix, angle: mp.mpf) -> mp.matrix:
    """Rodrigues' rotation about a unit axis."""
    K = mp.matrix([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return mp.eye(3) + mp.sin(angle) * K + (1 - mp.cos(angle)) * (K * K)


def accelerations(axes: np.ndarray, angles: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Angular accelerations of the hinges, by the principle of virtual power."""
    n = len(axes)
    weight, J = exactly(np.array([0, 0, -GRAVITY])), mp.diag([mp.mpf(j) for j in INERTIA])
    R, tip, omega, alpha, a = mp.eye(3), *(mp.matrix(3, 1) for _ in range(4))
    M, h, hinges = mp.matrix(n, n), mp.matrix(n, 1), []
    for i in range(n):
        unit = exactly(axes[i])
        unit /= mp.sqrt((unit.T * unit)[0])
        axis, rate = R * unit, mp.mpf(float(rates[i]))
        hinges.append((axis, tip.copy()))
        alpha, omega = alpha + cross(omega, axis * rate), omega + axis * rate
        R = R * turned(unit, mp.mpf(float(angles[i])))
        rod, centre = R * exactly(np.array([LENGTH, 0, 0])), R * exactly(np.array([-LENGTH / 2, 0, 0]))
        tip, a = tip + rod, a + cross(alpha, rod) + cross(omega, cross(omega, rod))
        inertia = R * J * R.T
        force = MASS * (a + cross(alpha, centre) + cross(omega, cross(omega, centre)) - weight)
        moment = inertia * alpha + cross(omega, inertia * omega)
        ways = [(cross(axis, tip + centre - place), axis) for axis, place in hinges]
        for row, (path, turn) in enumerate(ways):
            h[row] += (path.T * force)[0] + (turn.T * moment)[0]
            for column, (other, about) in enumerate(ways):
                M[row, column] += mp.mpf(MASS) * (path.T * other)[0] + (turn.T * inertia * about)[0]
    return np.array([float(value) for value in mp.lu_solve(M, -h)])


@pytest.mark.parametrize("seed", [5, 11])
def test_accelerations_of_twenty_hinges_have_thirteen_digits(seed: int) -> None:
    rng = np.random.default_rng(seed)
    axes = rng.standard_normal((HINGES, 3))
    s = chain(axes)
    angles, rates = rng.uniform(-1.5, 1.5, HINGES), rng.standard_normal(HINGES)
    state = s.state_at(dict(zip(s.dynamic, angles, strict=True)), dict(zip(s.dynamic, rates, strict=True)))
    with mp.workdps(40):
        exact = accelerations(axes, angles, rates)
    found = np.array([state.acceleration(name) for name in s.dynamic])
    np.testing.assert_allclose(found, exact, rtol=0, atol=1e-13 * np.abs(exact).max())
