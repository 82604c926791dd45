"""Radau IIA of order 5: order, stiff models, dense output, and what costs it no steps."""

import pickle

import numpy as np
import pytest
import sympy as sp
from controlled import carriage, spring_law
from scipy.integrate import solve_ivp

import flexel as fx
from flexel.derive import Internal, Law, Parameter, symbol
from flexel.examples.bicycle import bicycle, kick
from flexel.examples.rope_models import let_go
from flexel.generated._kernels import ffi, lib
from flexel.integration import radau_saddle
from flexel.integration.jacobian import jacobian
from flexel.integration.radau_saddle import SaddleFactors
from flexel.integration.radau_steps import Collocation
from flexel.integration.radau_tableau import CORRECTION, NODES, PAIR, REAL, WEIGHTS, T
from flexel.model.snapshot import Snapshot

STIFF = 50.0  # of Van der Pol's equation
W = 2.0  # of the oscillator [rad/s]
AMPLITUDE = 0.25  # [m]


pytestmark = pytest.mark.usefixtures("cache")


def along_x(length: float = 1.0) -> fx.Model:
    """A mass of 1 kg at the free end of a bar along x."""
    m = fx.Model()
    m.point("O", (0, 0), fixed=True)
    m.point_mass("bob", m.point("A", (length, 0)), 1.0)
    m.truss("bar", "O", "A")
    m.fix("A.y")
    return m


def oscillator() -> fx.System:
    m = along_x()
    m.spring("bar.elongation", W**2)
    m.initial("A.x", rate=AMPLITUDE * W)
    return m.build()


def van_der_pol() -> fx.System:
    """e'' = μ (1 - e²) e' - e, which starts on its slow part."""
    m = along_x(10.0)
    m.law("bar.elongation", lambda e, ed: e - STIFF * (1 - e**2) * ed, energy=lambda e: e**2 / 2)
    m.initial("bar.elongation", 2.0)
    return m.build()


def pendulum() -> fx.System:
    """A mass on a bar so stiff that it vibrates at 356 Hz."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (1, 0))
    m.truss("bar", "O", "A", stiffness=1e7, damping=10.0)
    m.point_mass("bob", "A", 2.0)
    return m.build()


def test_the_coefficients_are_those_of_the_method() -> None:
    """Collocation: the stages integrate powers of time exactly, up to the second; the end up to the fourth."""
    for k in range(1, 4):
        assert WEIGHTS @ NODES ** (k - 1) == pytest.approx(NODES**k / k, abs=1e-15)
    assert [WEIGHTS[2] @ NODES ** (k - 1) * k for k in range(1, 6)] == pytest.approx(np.ones(5), abs=1e-15)
    blocks = np.array([[REAL, 0, 0], [0, PAIR.real, -PAIR.imag], [0, PAIR.imag, PAIR.real]])
    assert np.linalg.inv(T) @ np.linalg.inv(WEIGHTS) @ T == pytest.approx(blocks, abs=1e-13)
    assert REAL == pytest.approx(3 + 3 ** (2 / 3) - 3 ** (1 / 3), rel=1e-14)  # (8.8)
    slope = np.polynomial.Polynomial([0, *CORRECTION]).deriv()
    assert [slope(c) for c in NODES] == pytest.approx([0, 0, 0], abs=1e-14)


def test_the_linear_systems_of_a_step_leave_out_the_values_whose_rates_are_variables() -> None:
    """The bicycle, with kinematic coordinates: (μ/h) 1 - J against NumPy; a singular or infinite matrix is refused."""
    system, h = bicycle(), 0.1
    ny = system.kinematics.roles.nq + system.kinematics.roles.nd
    steps = Collocation(system.kinematics, 1e-6, np.full(ny, 1e-8))
    rng = np.random.default_rng(1)
    nd = system.kinematics.roles.nd
    steps.J[:nd, ny - nd :] = np.eye(nd)
    steps.J[nd:] = rng.normal(size=(ny - nd, ny))
    assert lib.flexel_radau_factorize(steps.struct, h) == 0
    b = rng.normal(size=ny)
    x = b.copy()
    lib.flexel_radau_solve(steps.struct, h, ffi.from_buffer("double[]", x))
    assert x == pytest.approx(np.linalg.solve(REAL / h * np.eye(ny) - steps.J, b), rel=1e-12)
    steps.J[nd:] = REAL / h * np.eye(ny)[nd:]
    assert lib.flexel_radau_factorize(steps.struct, h) == 1
    steps.J[nd] = np.nan
    assert lib.flexel_radau_factorize(steps.struct, h) == 1


def swing(count: int, tip: float = 0.0, gravity: float = 9.81) -> fx.System:
    """Beams in a row with damping, hinged at one end, with a rate of the other one [m/s]."""
    m = fx.Model(gravity=(0, -gravity))
    m.point("P0", (0, 0), fixed=True)
    m.angle("R0")
    for i in range(count):
        m.point(f"P{i + 1}", ((i + 1) / count, 0))
        m.angle(f"R{i + 1}")
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, EA=1e6, EIz=10.0, mass_per_length=1.0, damping=1e-4)
    for i in range(count):
        m.initial(f"P{i + 1}.y", rate=tip * (i + 1) / count)
    return m.build()


def solved(system: fx.System, h: float, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Solutions with the sparse factors at the start for the real number over h, and for the complex one."""
    factors, state = SaddleFactors(system.kinematics), system.initial
    factors.look(system.kinematics, Snapshot.of(state), state.z)
    pair = np.array([PAIR.real, PAIR.imag]) / h
    numbers = ffi.from_buffer("double[]", pair)
    assert lib.flexel_radau_saddle_factorize(factors.struct, REAL / h, numbers) == 0
    x, paired = b.copy(), b + 2j * b[::-1]
    lib.flexel_radau_saddle_solve(factors.struct, REAL / h, ffi.from_buffer("double[]", x))
    lib.flexel_radau_saddle_solve_pair(
        factors.struct, numbers, ffi.from_buffer("double[]", paired.view(float))
    )
    return x, paired


@pytest.mark.parametrize(("tip", "gravity", "error"), [(0.0, 0.0, 1e-9), (0.3, 9.81, 3e-3)])
def test_sparse_factors_solve_the_systems_of_dense_ones(tip: float, gravity: float, error: float) -> None:
    """In motion to first order in the angle of a step, which is 0.003 rad; against NumPy with the linearization."""
    system, h = swing(5, tip, gravity), 0.01
    J = jacobian(system.kinematics, Snapshot.of(system.initial), system.initial.z)
    b = np.random.default_rng(3).normal(size=len(J)) * np.repeat([1e-3, 1.0], len(J) // 2)
    x, paired = solved(system, h, b)
    one = np.eye(len(J))
    for found, shift, side in ((x, REAL / h, b), (paired, PAIR / h, b + 2j * b[::-1])):
        exact = np.linalg.solve(shift * one - J, side)
        for part in np.split(np.arange(len(J)), 2):  # values and rates
            assert np.max(np.abs(found - exact)[part]) < error * np.max(np.abs(exact[part]))


def test_steps_with_sparse_factors_are_those_with_dense_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    """37 degrees of freedom; a swing of beams, and of rigid links that change their degrees of freedom."""
    m = fx.Model(gravity=(0, -9.81))
    chain = m.chain("chain", [(0, 0), (1, 0)], 37, mass_per_length=1.0)
    m.fix(chain.points[0])
    for system, rtol, change in ((swing(12), 1e-4, False), (m.build(), 1e-5, True)):
        monkeypatch.setattr(radau_saddle, "FEWEST", 32)
        found = system.simulate(0.5, samples=6, method="Radau", rtol=rtol)
        monkeypatch.setattr(radau_saddle, "FEWEST", 1000)
        dense = system.simulate(0.5, samples=6, method="Radau", rtol=rtol)
        assert np.max(np.abs(found.x - dense.x)) < 10 * rtol
        assert found.statistics["evaluations"] < 1.1 * dense.statistics["evaluations"]
        assert bool(found.rechoices) == change


def test_the_error_at_the_end_is_of_order_five_and_between_the_steps_no_larger() -> None:
    """Harmonic oscillator in equal steps: closed form."""
    s, times = oscillator(), np.linspace(0, 4, 401)
    exact = 1 + AMPLITUDE * np.sin(W * times)
    ends, largest = [], []
    for count in (20, 40, 80):
        step = 4 / count
        options = {"rtol": 0.1, "atol": 1e6, "first_step": step, "max_step": step, "times": times}
        motion = s.simulate(4.0, method="Radau", **options)
        assert motion.statistics["steps"] <= count + 1
        errors = np.abs(motion.position("A")[:, 0] - exact)
        ends.append(errors[-1])
        largest.append(errors.max())
    assert np.log2(np.divide(ends[:-1], ends[1:])) == pytest.approx([5, 5], abs=0.1)
    assert np.log2(np.divide(largest[:-1], largest[1:])) == pytest.approx([5, 5], abs=0.1)


def test_dense_output_of_a_motion_that_is_not_linear_is_of_order_five_within_a_step() -> None:
    """A swinging bar in one step from its start, against DOP853; the polynomial alone would be of order four."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point_mass("bob", m.point("A", (0.8, -0.6)), 1.0)
    m.truss("rod", "O", "A")
    m.initial("A.x", rate=1.0)
    s = m.build()
    errors = []
    for step in (0.1, 0.05):
        times = step * np.linspace(0.1, 0.9, 9)
        exact = s.simulate(step, times=times, method="DOP853", rtol=2e-13, atol=1e-14).x
        options = {"rtol": 0.1, "atol": 1e6, "first_step": step, "times": times}
        motion = s.simulate(step, method="Radau", **options)
        assert motion.statistics["steps"] == 1
        errors.append(np.max(np.abs(motion.x - exact)))
    assert np.log2(errors[0] / errors[1]) > 4.7


def test_van_der_pols_oscillation_has_the_error_of_its_tolerance_in_few_steps() -> None:
    """Against SciPy's integration of the equation itself (Radau at 1e-11, which is another program)."""
    s, times = van_der_pol(), np.linspace(0, 60, 41)

    def rates(_: float, y: np.ndarray) -> list[float]:
        return [y[1], STIFF * (1 - y[0] ** 2) * y[1] - y[0]]

    exact = solve_ivp(rates, (0, 60), [2.0, 0.0], method="Radau", rtol=1e-11, atol=1e-12, t_eval=times).y[0]
    assert np.ptp(exact) > 3.9  # it jumps on the way
    steps = {}
    for rtol in (1e-3, 1e-6, 1e-9):
        motion = s.simulate(60.0, times=times, method="Radau", rtol=rtol)
        steps[rtol] = motion.statistics["steps"]
        assert np.max(np.abs(motion["bar.elongation"] - exact)) < 20 * rtol * np.ptp(exact)
    explicit = s.simulate(60.0, times=times, method="DOP853", rtol=1e-6)
    assert steps[1e-6] < explicit.statistics["steps"] / 4


@pytest.mark.long
def test_a_stiff_bar_does_not_limit_the_steps() -> None:
    """The swing of a pendulum on it, against DOP853, whose steps are limited by the stability of its vibration."""
    s = pendulum()
    exact = s.simulate(1.0, method="DOP853", rtol=1e-11, atol=1e-13)
    motion = s.simulate(1.0, method="Radau", rtol=1e-3)
    assert np.max(np.abs(motion.position("A") - exact.position("A"))) < 1e-4
    assert motion.statistics["steps"] < exact.statistics["steps"] / 5


@pytest.mark.filterwarnings("ignore:.*small beside the model")
def test_rounding_errors_of_stiff_positions_do_not_shorten_the_steps() -> None:
    """An error of 1e-15 in a strain is one of 1e-10 m/s in the rates of each stage."""
    cables = let_go(6, 0.1, EA=1e6, EI=50.0, mass=1.0)
    motion, tight = (
        cables.simulate(1e-3, method="Radau", rtol=rtol, samples=4, progress=False) for rtol in (1e-8, 1e-10)
    )
    counts = motion.statistics
    assert counts["rejected"] < 0.01 * counts["steps"]
    assert counts["evaluations"] < 7.1 * counts["steps"]
    assert np.abs(motion.x - tight.x).max() < 1e-9 * np.ptp(tight.x, axis=0).max()


def test_the_error_is_proportional_to_the_tolerance() -> None:
    """Three links that swing and change their degrees of freedom, against DOP853; lengths are of the order of one."""
    m = fx.Model(gravity=(0, -9.81))
    chain = m.chain("chain", [(0, 0), (1, 0)], 3, mass_per_length=1.0)
    m.fix(chain.points[0])
    s = m.build()
    exact = s.simulate(1.0, samples=21, method="DOP853", rtol=1e-12, atol=1e-14).x
    for rtol in (1e-3, 1e-5, 1e-7, 1e-9):
        motion = s.simulate(1.0, samples=21, method="Radau", rtol=rtol)
        assert motion.rechoices
        assert np.max(np.abs(motion.x - exact)) < 3 * rtol


def test_errors_count_as_much_as_poor_degrees_of_freedom_enlarge_them() -> None:
    """A free rotor in Euler parameters, whose coordinates change 31 times in 100 rad, keeps its energy."""
    m = fx.Model()
    m.body("rotor", m.point("P", (0, 0, 0)), m.frame("R"), mass=1.0, inertia=(1.0, 2.0, 3.0))
    m.initial("R.lambda3", rate=5.0)
    energy = m.build().simulate(10.0, samples=11, method="Radau", rtol=1e-3).energy["total"]
    assert np.max(np.abs(energy / energy[0] - 1)) < 0.02


def test_events_lie_inside_steps_at_their_exact_times() -> None:
    """The oscillator passes its centre every half period."""
    passage = fx.Event("centre", lambda state: state["bar.elongation"])
    motion = oscillator().simulate(5.0, samples=2, method="Radau", rtol=1e-9, events=[passage])
    times = [state.t for _, state in motion.events]
    assert times == pytest.approx(np.pi / W * np.arange(1, 4), abs=1e-8)
    assert max(abs(state["bar.elongation"]) for _, state in motion.events) < 1e-11


def test_states_between_steps_travel_and_stay_the_same() -> None:
    motion = oscillator().simulate(1.0, samples=2, method="Radau", rtol=1e-6)
    found = pickle.loads(pickle.dumps(motion))
    for t in (0.123, 0.77, 1.0):
        assert np.array_equal(found.at(t).x, motion.at(t).x)
        assert motion.at(t).drift < 1e-13


def test_a_bicycle_rolls_as_with_the_other_method() -> None:
    """Kinematic coordinates, of which there are more than degrees of freedom; compared with DOP853."""
    system = bicycle()
    start = kick(system, 4.5, 0.05)[0]
    exact = system.simulate(1.0, start=start, samples=11, method="DOP853", rtol=1e-12, atol=1e-14).x
    for rtol in (1e-3, 1e-6, 1e-9):
        found = system.simulate(1.0, start=start, samples=11, method="Radau", rtol=rtol).x
        assert np.max(np.abs(found - exact) / np.ptp(exact, axis=0).max()) < 20 * rtol


@pytest.mark.long
def test_a_flexible_crank_that_is_driven() -> None:
    """Two beams turned by a prescribed angle: against DOP853, whose steps their longitudinal vibration limits."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("P0", (0, 0), fixed=True)
    m.angle("R0")
    for i in range(2):
        m.point(f"P{i + 1}", (0.5 * (i + 1), 0))
        m.angle(f"R{i + 1}")
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, EA=1e5, EIz=50.0, mass_per_length=1.0, damping=1e-3)
    m.prescribe("R0.angle", lambda t: 1 - np.cos(3 * t))
    system = m.build()
    exact = system.simulate(1.0, samples=11, method="DOP853", rtol=1e-11, atol=1e-13)
    found = system.simulate(1.0, samples=11, method="Radau", rtol=1e-6)
    assert np.max(np.abs(found.position("P2") - exact.position("P2"))) < 2e-5
    assert found.statistics["steps"] < exact.statistics["steps"] / 4


def test_a_fast_internal_state_follows_its_slow_input() -> None:
    """A spring and a dashpot in series, with a relaxation time of 1 µs and a spring: as a spring and a dashpot."""
    k, lag, c, e, z = (
        Parameter("k", 1, "N/m", "spring"),
        Parameter("lag", 1, "s", "lag"),
        0.5,
        symbol("e"),
        symbol("z1"),
    )
    state = Internal("z1", "m", (e - z) / lag.symbol)
    sigma = W**2 * e + k.symbol * (e - z)
    U = W**2 * e**2 / 2 + k.symbol * (e - z) ** 2 / 2
    law = Law(
        "series",
        "in series",
        (k, lag),
        (e,),
        (symbol("ed"),),
        (),
        (sigma,),
        (),
        U,
        "Maxwell",
        states=(state,),
    )
    m = along_x()
    m.law(["bar.elongation"], fx.compile_law(law), k=c / 1e-6, lag=1e-6)
    m.initial("A.x", rate=AMPLITUDE * W)
    motion = m.build().simulate(5.0, samples=51, method="Radau", rtol=1e-6)
    w = np.sqrt(W**2 - c**2 / 4)
    exact = AMPLITUDE * W / w * np.exp(-c / 2 * motion.t) * np.sin(w * motion.t)
    assert np.max(np.abs(motion["bar.elongation"] - exact)) < 1e-5 * AMPLITUDE  # 1 µs is 1e-6 of a period
    assert motion.statistics["evaluations"] < 3000


def test_a_sampled_controller_does_not_shorten_the_steps() -> None:
    """Between its instants the mass moves along a parabola: one step each, however often it starts again."""
    m = carriage()
    m.controller(function=spring_law, inputs=["A.x", "A.x'"], outputs=["A.x"], name="c", period=0.05)
    s = m.build()
    start = s.state_at(rates={"A.x": 0.3})
    counts = [s.simulate(t, start=start, method="Radau").statistics["steps"] for t in (1.0, 3.0)]
    assert counts[1] - counts[0] == 40


@pytest.mark.parametrize("fewest", [1, 32])
def test_a_law_that_has_no_slope_where_the_motion_starts_or_passes(
    monkeypatch: pytest.MonkeyPatch, fewest: int
) -> None:
    """Dry friction that grows with the root of the speed, from rest: against DOP853."""
    monkeypatch.setattr(radau_saddle, "FEWEST", fewest)
    m = along_x()
    m.law(
        "bar.elongation",
        lambda e, ed: 4 * e + 0.1 * sp.sign(ed) * sp.sqrt(sp.Abs(ed)),
        energy=lambda e: 2 * e**2,
    )
    m.initial("bar.elongation", 0.2)
    s = m.build()
    exact = s.simulate(5.0, samples=11, method="DOP853", rtol=1e-10)
    found = s.simulate(5.0, samples=11, method="Radau", rtol=1e-7)
    assert np.max(np.abs(found["bar.elongation"] - exact["bar.elongation"])) < 1e-6


def test_a_law_without_a_slope_is_named_if_no_step_succeeds_without_it() -> None:
    """A period of 1e-12 s, where only the slope would allow longer steps."""
    m = along_x()
    m.spring("bar.elongation", 1e25)
    m.point("B", (2, 0), fixed=True)
    m.truss("other", "A", "B")
    m.law("other.elongation", lambda e, ed: sp.sqrt(sp.Abs(e)))
    m.initial("A.x", rate=1.0)
    with pytest.raises(fx.DynamicsError, match="other.elongation"):
        m.build().simulate(1.0, method="Radau")
