"""Orientations that turn freely, by Radau IIA: a steady rotation costs no steps and loses nothing."""

import pickle
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from mechanisms import heavy_top
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.base import quaternions
from flexel.base.arrays import Array
from flexel.engine.covered import Covered
from flexel.engine.rotations import Rotations
from flexel.generated._kernels import ffi, lib
from flexel.integration.branch import Choices
from flexel.integration.jacobian import jacobian
from flexel.integration.knots import Knots
from flexel.integration.radau_saddle import SaddleFactors, sparse
from flexel.integration.radau_steps import Collocation
from flexel.integration.radau_tableau import PAIR, REAL
from flexel.model.snapshot import Snapshot
from flexel.model.state import State

RTOL = (1e-3, 1e-6, 1e-9)
END = 20.0  # [s], 100 rad
IN_SPACE = pytest.mark.parametrize("in_space", [False, True])
UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])


def body(
    inertia: tuple[float, float, float], spin: tuple[float, float, float], orientation: Array = UPRIGHT
) -> fx.System:
    """A free body with an angular velocity [rad/s], both along the axes of its frame."""
    m = fx.Model()
    frame = m.frame("R", orientation=orientation)
    m.body("body", m.point("P", (0, 0, 0)), frame, mass=1.0, inertia=inertia)
    w, rates = m.angular_velocity("R"), quaternions.matrix(orientation) @ spin
    for name, rate in zip(("wx", "wy", "wz"), rates.tolist(), strict=True):
        m.initial(f"{w}.{name}", rate=rate)
    return m.build()


@cache
def euler(inertia: tuple[float, float, float], spin: tuple[float, float, float], samples: int) -> Array:
    """Euler parameters (4, samples) of the same by Euler's equations."""
    I = np.array(inertia)  # noqa: E741

    def rates(_: float, y: Array) -> Array:
        L, w = y[:4], y[4:]
        turning = 0.5 * np.concatenate([[-L[1:] @ w], L[0] * w + np.cross(L[1:], w)])
        return np.concatenate([turning, -np.cross(w, I * w) / I])

    start, times = [1.0, 0, 0, 0, *spin], np.linspace(0, END, samples)
    return solve_ivp(rates, (0, END), start, method="DOP853", rtol=1e-13, atol=1e-14, t_eval=times).y[:4]


def parameters(motion: fx.Motion) -> Array:
    """Euler parameters (4, times) of the frame."""
    return np.array([motion[f"R.lambda{i}"] for i in range(4)])


@pytest.mark.parametrize("rtol", RTOL)
def test_a_rotor_keeps_its_speed_and_angle(rtol: float) -> None:
    """100 rad about an axis that is oblique in space, in steps of up to two radians; states also within steps.

    Before, 301 steps at 1e-6 with 7e-5 of the energy, and 1.4e-2 of it at 1e-3.
    """
    first = quaternions.turn((1, 2, -2), 0.7)
    system = body((1.0, 1.0, 2.0), (0.0, 0.0, 5.0), orientation=first)
    motion = system.simulate(END, samples=237, method="Radau", rtol=rtol)
    exact = np.array([quaternions.product(first, quaternions.turn((0, 0, 1), 5 * t)) for t in motion.t])
    assert np.max(np.abs(parameters(motion) - exact.T)) < 2e-13 * 5 * END
    speed = 2 * np.linalg.norm([motion[f"R.lambda{i}'"] for i in range(4)], axis=0)
    assert np.max(np.abs(speed / 5 - 1)) < 1e-13
    energy = motion.energy["total"]
    assert np.max(np.abs(energy / energy[0] - 1)) < 1e-13
    assert motion.statistics["steps"] < 80 and motion.statistics["rejected"] == 0
    assert len(motion.rechoices) > 20


@pytest.mark.parametrize(("rtol", "most"), [(1e-3, 900), (1e-6, 3100), (1e-9, 12500)])
def test_a_body_that_precesses_steadily(rtol: float, most: int) -> None:
    """A symmetric body against Euler's equations; 1737, 6352 and 24521 evaluations before."""
    inertia, spin = (1.0, 1.0, 2.0), (1.0, 0.0, 5.0)
    motion = body(inertia, spin).simulate(END, samples=201, method="Radau", rtol=rtol)
    assert np.max(np.abs(parameters(motion) - euler(inertia, spin, 201))) < 20 * rtol
    assert motion.statistics["evaluations"] < most
    energy = motion.energy["total"]
    assert np.max(np.abs(energy / energy[0] - 1)) < rtol


@pytest.mark.parametrize(("rtol", "most"), [(1e-3, 1050), (1e-6, 2700), (1e-9, 10200)])
def test_a_body_that_tumbles(rtol: float, most: int) -> None:
    """Over its unstable axis, which enlarges errors; 0.14, 1.3e-4 and 1.1e-7 with twice as many evaluations before."""
    inertia, spin = (1.0, 2.0, 3.0), (0.3, 5.0, 0.5)
    motion = body(inertia, spin).simulate(END, samples=201, method="Radau", rtol=rtol)
    assert np.max(np.abs(parameters(motion) - euler(inertia, spin, 201))) < 20 * rtol
    assert motion.statistics["evaluations"] < most
    energy = motion.energy["total"]
    assert np.max(np.abs(energy / energy[0] - 1)) < 2 * rtol


def test_a_heavy_top_changes_euler_parameters_without_a_jacobian_or_a_refused_step() -> None:
    """Against DOP853; 6859 evaluations and an error of 6e-4 before, 62 refused steps at 1e-3."""
    system = heavy_top()
    exact = system.simulate(1.5, samples=31, method="DOP853", rtol=1e-12, atol=1e-14)
    for rtol in (1e-3, 1e-6):
        motion = system.simulate(1.5, samples=31, method="Radau", rtol=rtol)
        assert np.max(np.abs(motion.x - exact.x)) < 400 * rtol
        assert len(motion.rechoices) > 60 and motion.statistics["rejected"] == 0
    assert motion.statistics["evaluations"] < 4500


def test_states_within_steps_travel_and_are_those_of_the_motion() -> None:
    inertia, spin = (1.0, 2.0, 3.0), (0.3, 5.0, 0.5)
    motion = body(inertia, spin).simulate(END, samples=2, method="Radau", rtol=1e-9)
    times = np.linspace(0, END, 77)
    copied = pickle.loads(pickle.dumps(motion))
    found = np.array([motion.at(t).x for t in times])
    assert np.array_equal(found, [copied.at(t).x for t in times])
    where = [motion.structure.names.index(f"R.lambda{i}") for i in range(4)]
    first = motion.structure.m + motion.structure.k
    L = found[:, np.array(where) - first].T
    assert np.max(np.abs(L - euler(inertia, spin, times.size))) < 2e-8


def in_bearings(damping: float) -> fx.System:
    """An unbalanced rotor of 100 rad/s whose bearings are five springs: one Euler parameter is a degree of freedom."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.body("rotor", m.point("P", (0, 0, 0)), m.frame("R"), mass=10.0, inertia=(0.2, 0.2, 0.1))
    for end, z, off in (("A", -0.3, 1e-3), ("B", 0.3, -5e-4)):
        m.body_point(f"{end} of rotor", "P", "R", m.point(end, (off, 0, z)))
        sides = {"x": (off + 1, 0, z), "y": (off, 1, z), "z": (off, 0, z - 1)}
        for side in "xyz" if end == "A" else "xy":
            fixed = m.point(f"{end}{side}", sides[side], fixed=True)
            m.truss(f"{end}{side} spring", fixed, end, stiffness=1e7, damping=damping)
    m.initial(f"{m.angular_velocity('R')}.wz", rate=100.0)
    return m.build()


@pytest.mark.long
def test_a_rotor_in_stiff_bearings() -> None:
    """300 rad against DOP853; errors of 1.8 and 7e-3 of its Euler parameters at 1e-3 and 1e-6 before.

    The default method takes Radau, at its default tolerance too, where DOP853 takes 123 000 evaluations: the trial goes
    on until the rotor rests in its bearings.  Errors are 2e-5, 4e-8 and 5e-10.
    """
    system = in_bearings(1e3)
    exact = system.simulate(3.0, samples=61, method="DOP853", rtol=1e-9)
    elongation = exact["Ax spring.elongation"]
    for rtol, most, wide in ((1e-3, 4800, 20), (1e-6, 12000, 20), (1e-9, 33000, 40)):
        motion = system.simulate(3.0, samples=61, **({} if rtol == RTOL[-1] else {"rtol": rtol}))
        assert "(Radau, chosen" in motion.message
        assert len(motion.rechoices) > 80
        assert np.max(np.abs(parameters(motion) - parameters(exact))) < rtol
        off = np.abs(motion["Ax spring.elongation"] - elongation)
        assert np.max(off) < wide * rtol * np.ptp(elongation)
        assert motion.statistics["evaluations"] < most


def shaft(count: int) -> fx.System:
    """A disk on a shaft of some beams that spins in springs."""
    m = fx.Model()
    for i in range(count + 1):
        m.point(f"P{i}", (i / count, 0, 0))
        m.frame(f"R{i}")
        m.initial(f"R{i}.lambda1", rate=25.0)
    section = {"EA": 1e7, "GJ": 1e3, "EIy": 1.5e3, "EIz": 1.5e3, "mass_per_length": 2.0}
    for i in range(count):
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, **section, inertia_per_length=(2e-4, 1e-4, 1e-4), damping=1e-4)
    middle = count // 2
    m.body("disk", f"P{middle}", f"R{middle}", mass=5.0, inertia=(0.05, 0.025, 0.025), offset=(0, 1e-4, 0))
    for end, sides in ((0, "xyz"), (count, "yz")):
        for side in sides:
            away = {"x": (-1, 0, 0), "y": (end / count, 1, 0), "z": (end / count, 0, 1)}[side]
            fixed = m.point(f"G{end}{side}", away, fixed=True)
            m.truss(f"s{end}{side}", fixed, f"P{end}", stiffness=1e7, damping=500.0)
    return m.build()


@pytest.mark.long
def test_a_shaft_of_beams_that_spins() -> None:
    """15 rad with frames of which three Euler parameters are degrees of freedom; 11090 evaluations before at 1e-6."""
    system = shaft(8)
    assert Rotations.of(system.structure, system.roles).count > 5 and sparse(system.kinematics)
    tight, motion = (system.simulate(0.3, samples=7, method="Radau", rtol=rtol) for rtol in (1e-9, 1e-6))
    assert motion.statistics["evaluations"] < 8500
    assert np.max(np.abs(motion["R4.lambda1"] - tight["R4.lambda1"])) < 1e-8  # 7e-8 before


def started(system: fx.System, state: State, in_space: bool) -> Collocation:
    """Steps that start at a state, with their Jacobian; rotations along axes of space or of the frames."""
    kinematics, now = system.kinematics_of(state.roles), Snapshot.of(state)
    y = Choices(system, kinematics, True).values(now, state.z)
    steps = Collocation(kinematics, 1e-6, np.full(y.size, 1e-8))
    steps.turns.space[:] = in_space
    covered = Covered(system.structure, kinematics.lists.step_weight, 1e-6, 1e-8, 1e-15, True)
    steps.start(now, y, Knots(system, state.t, state.t + 1), covered)
    steps.look(jacobian(kinematics, now, state.z))
    steps.look_again()
    return steps


def moved(system: fx.System) -> State:
    """A state in which everything turns."""
    return system.simulate(0.2, samples=2, method="Radau", rtol=1e-8)[-1]


@IN_SPACE
def test_the_jacobian_is_that_of_rotations_and_angular_velocities(in_space: bool) -> None:
    """Of a top, a body that tumbles, and a rotor in springs, against differences."""
    for system in (heavy_top(), body((1.0, 2.0, 3.0), (0.3, 5.0, 0.5)), in_bearings(1e3)):
        steps = started(system, moved(system), in_space)
        J, h = np.empty_like(steps.J), 1e-5
        for i in range(len(J)):
            ends = []
            for Z in (h * np.eye(len(J))[i], -h * np.eye(len(J))[i]):
                f = np.zeros(len(J))
                both = ffi.from_buffer("double[]", Z), ffi.from_buffer("double[]", f)
                assert lib.flexel_radau_rates(*steps._structs, 3, 0.0, *both) == 0
                ends.append(f)
            J[:, i] = (ends[0] - ends[1]) / (2 * h)
        assert np.max(np.abs(J - steps.J)) < 1e-6 * np.max(np.abs(J))


@IN_SPACE
def test_linear_systems_have_the_change_of_a_rotation_by_itself(in_space: bool) -> None:
    """(μ/h) 1 - J of a top against NumPy."""
    steps, h = started(heavy_top(), moved(heavy_top()), in_space), 0.01
    assert lib.flexel_radau_factorize(steps.struct, h) == 0
    b = np.random.default_rng(1).normal(size=len(steps.J))
    x = b.copy()
    lib.flexel_radau_solve(steps.struct, h, ffi.from_buffer("double[]", x))
    assert x == pytest.approx(np.linalg.solve(REAL / h * np.eye(b.size) - steps.J, b), rel=1e-10)


def largest_misfit(steps: Collocation, state: State, h: float) -> float:
    """Largest error of solutions with sparse factors, relative to the largest value or rate, for both numbers."""
    factors, J, nd = SaddleFactors(steps.kinematics), steps.J, steps.kinematics.roles.nd
    for name in ("turns", "angles"):
        setattr(factors.struct, name, getattr(steps, name).struct)
    factors.look(steps.kinematics, Snapshot.of(state), state.z)
    pair = np.array([PAIR.real, PAIR.imag]) / h
    numbers = ffi.from_buffer("double[]", pair)
    assert lib.flexel_radau_saddle_factorize(factors.struct, REAL / h, numbers) == 0
    b, other = np.random.default_rng(3).normal(size=(2, len(J))) * np.repeat([h, 1.0], nd)
    x, paired = b.copy(), b + 1j * other
    lib.flexel_radau_saddle_solve(factors.struct, REAL / h, ffi.from_buffer("double[]", x))
    lib.flexel_radau_saddle_solve_pair(
        factors.struct, numbers, ffi.from_buffer("double[]", paired.view(float))
    )
    errors = []
    for found, shift, side in ((x, REAL / h, b), (paired, PAIR / h, b + 1j * other)):
        exact = np.linalg.solve(shift * np.eye(len(J)) - J, side)
        for part in (slice(nd), slice(nd, None)):
            errors.append(np.max(np.abs(found - exact)[part]) / np.max(np.abs(exact[part])))
    return max(errors)


@IN_SPACE
@pytest.mark.parametrize("make", [lambda: shaft(3), lambda: in_bearings(1e3), heavy_top])
def test_sparse_factors_have_the_same_variables(make: Callable[[], fx.System], in_space: bool) -> None:
    """Against dense ones, to first order in the angle of a step, of 1e-2 and 1e-3 rad at most."""
    system = make()
    state = moved(system) if make is heavy_top else system.initial
    errors = [largest_misfit(started(system, state, in_space), state, h) for h in (1e-4, 1e-5)]
    assert errors[1] < 5e-3
    assert errors[1] < errors[0] / 5


def spinning_balls(count: int, spin: float) -> fx.System:
    """Balls that roll at 1 m/s, and spin about the vertical [rad/s], on a floor with regularized friction."""
    radius, mass, stiffness = 0.05, 0.3, 1e7
    moment, sinking = 0.4 * mass * radius**2, (mass * 9.81 / stiffness) ** (2 / 3)
    m = fx.Model(gravity=(0, 0, -9.81))
    floor = m.plane("floor", m.point("G", (0, 0, 0), fixed=True), m.frame("ground", fixed=True))
    law = fx.Contact(stiffness, friction=0.5, slip_speed=1e-4)
    for i in range(count):
        ball, frame = m.point(f"P{i}", (0, 0.2 * i, radius - sinking)), m.frame(f"R{i}")
        m.body(f"ball {i}", ball, frame, mass=mass, inertia=(moment,) * 3)
        m.contact(f"touch {i}", ball, floor, law, frame=frame, radius=radius)
        m.initial(f"P{i}.x", rate=1.0)
        w = m.angular_velocity(f"R{i}")
        m.initial(f"{w}.wy", rate=1 / radius)
        m.initial(f"{w}.wz", rate=spin)
    return m.build()


@pytest.mark.parametrize(("count", "most"), [(1, 700), (6, 2200)])
def test_balls_that_spin_take_no_more_steps_than_others(count: int, most: int) -> None:
    """What acts on them is steady in space, not in their frames; 27 000 and 39 000 evaluations before."""
    system = spinning_balls(count, 30.0)
    assert sparse(system.kinematics) == (count == 6)
    motion = system.simulate(1.0, samples=11, method="Radau")
    assert motion.statistics["evaluations"] < most
    for i in range(count):
        assert motion[f"P{i}.x"] == pytest.approx(motion.t, abs=1e-9)
        assert np.abs(motion[f"P{i}.y"] - 0.2 * i).max() < 1e-9
        assert motion[f"R{i}.omega.wz'"] == pytest.approx(np.full(11, 30.0), abs=1e-6)
    within = motion.at(0.537)
    turned = quaternions.turn((0, 20, 30), np.hypot(20, 30) * 0.537)
    found = np.array([within[f"R0.lambda{i}"] for i in range(4)])
    assert abs(found @ turned) == pytest.approx(1.0, abs=1e-9)
    assert np.linalg.norm(found) == pytest.approx(1.0, abs=1e-12)
