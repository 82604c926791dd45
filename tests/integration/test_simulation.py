"""Events, dense output, energy and drift, turns of angles, functions of time, nonlinear springs."""

import math

import numpy as np
import pytest
from differences import pendulum, slope, worst

from flexel.base.errors import FlexelError, ModelError
from flexel.base.time_functions import Harmonic, Polynomial, Ramp, as_function
from flexel.base.time_tables import Table
from flexel.integration.events import Event
from flexel.parts.model import Model
from flexel.results.system_facade import System


def falling(damping: float = 0.0) -> Model:
    """A mass that falls under gravity."""
    m = Model(gravity=(0, 0, -9.81))
    P = m.point("P", (0, 0, 2.0))
    m.point_mass("stone", P, 0.5)
    m.initial("P.x", rate=3.0)
    return m


def test_stone_hits_the_ground_when_the_parabola_says() -> None:
    motion = (
        falling()
        .build()
        .simulate(
            2.0,
            events=[
                Event("ground", lambda state: state["P.z"], terminal=True),
                Event("top", lambda state: state.rate("P.z")),
            ],
        )
    )
    (name, state), *more = motion.events
    assert name == "ground"
    assert not more
    assert abs(state.t - np.sqrt(4 / 9.81)) < 1e-12
    assert abs(state["P.x"] - 3.0 * state.t) < 1e-12
    assert "ground" in motion.message
    assert motion.t[-1] <= state.t
    assert abs(motion.at(state.t)["P.z"]) < 1e-12
    with pytest.raises(ModelError, match="outside"):
        motion.at(state.t + 1e-6)


@pytest.mark.parametrize(("direction", "count"), [(0, 6), (1, 3), (-1, 3)])
def test_events_are_counted_by_direction(direction: int, count: int) -> None:
    m = pendulum(mass_per_length=1.0)
    m.initial("pivot.angle", np.pi / 2 - 0.3, rate=0)
    period = 2 * np.pi / np.sqrt(14.715) * (1 + 0.3**2 / 16)
    s = m.build()
    motion = s.simulate(3 * period, events=[Event("low", lambda state: state["A.x"], direction=direction)])
    assert len(motion.events) == count
    times = np.array([state.t for _, state in motion.events])
    spacing = period / 2 if direction == 0 else period
    assert np.max(np.abs(np.diff(times) - spacing)) < 1e-3
    assert np.max(np.abs([state["A.x"] for _, state in motion.events])) < 1e-11


def test_dense_output_satisfies_the_equations_between_the_samples() -> None:
    m = pendulum(mass_per_length=1.0)
    s = m.build()
    motion = s.simulate(2.0, samples=3, rtol=1e-11, atol=1e-12)
    fine = s.simulate(2.0, samples=201, rtol=1e-11, atol=1e-12)
    for state in fine[::10]:
        between = motion.at(state.t)
        assert np.max(np.abs(between.x - state.x)) < 1e-14
        assert between.drift < 1e-13
    rate = slope(lambda d: np.array(motion.at(0.77 + d)["pivot.angle"]), 1e-2)
    assert abs(rate - motion.at(0.77).rate("pivot.angle")) < 1e-8


@pytest.mark.parametrize(("method", "rtol", "bound"), [
    ("DOP853", 1e-12, 1e-10), ("DOP853", 1e-9, 1e-7), ("Radau", 1e-7, 1e-3),
])  # fmt: skip
def test_energy_is_kept_at_the_tolerance_of_the_integrator(method: str, rtol: float, bound: float) -> None:
    m = pendulum(mass_per_length=1.0)
    B, R2 = m.point("B", (1.5, 0.5, 0.2)), m.frame("R2")
    m.hinge("elbow", "R1", R2, axis=(0.3, 1, 0), stiffness=3.0)
    m.beam("arm", "A", R2, B, mass_per_length=1.0, inertia_per_length=(0.1, 0.1, 0.1))
    motion = m.build().simulate(2.0, samples=21, method=method, rtol=rtol, atol=rtol * 1e-2)
    assert np.ptp(motion.energy["total"]) < bound * np.max(motion.energy["kinetic"])
    assert np.max(motion.drift) < 1e-12


def test_damping_takes_exactly_its_power_from_the_energy() -> None:
    m = pendulum(mass_per_length=1.0)
    m.spring("pivot.angle", 2.0, 0.8)
    motion = m.build().simulate(1.5, samples=4, rtol=1e-11, atol=1e-12)
    for t in motion.t[1:-1]:
        state = motion.at(t)
        loss = slope(lambda d, t=t: np.array(motion.at(t + d).energy.total), 1e-2)
        assert abs(loss + 0.8 * state.rate("pivot.angle") ** 2) < 1e-7


def test_angles_and_their_springs_count_turns() -> None:
    """A weak torsion spring wound up over many turns by a fast rotor: ω₀ = sqrt(k/J), amplitude 50 turns."""
    k, J, amplitude = 0.02, 0.5, 100 * np.pi
    m = Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    R0, R1 = m.frame("R0", fixed=True), m.frame("R1")
    m.hinge("axle", R0, R1, axis=(0, 0, 1), stiffness=k)
    m.body("rotor", O, R1, mass=1.0, inertia=(J, J, J))
    w = np.sqrt(k / J)
    m.initial("axle.angle", rate=amplitude * w)
    motion = m.build().simulate(2 * np.pi / w, samples=9, rtol=1e-11, atol=1e-9)
    assert np.max(np.abs(motion["axle.angle"] - amplitude * np.sin(w * motion.t))) < 1e-6 * amplitude
    assert np.ptp(motion.energy["total"]) < 1e-8 * motion.energy["total"][0]


def test_a_relative_angle_between_two_fast_rotors_counts_turns_too() -> None:
    """Two rotors on one axis joined by a weak spring on their relative angle, which is not a degree of freedom."""
    J1, J2, k = 0.5, 0.3, 0.05
    m = Model()
    O = m.point("O", (0, 0, 0), fixed=True)
    R0, R1, R2 = m.frame("R0", fixed=True), m.frame("R1"), m.frame("R2")
    m.hinge("first", R0, R1, axis=(0, 0, 1))
    m.hinge("second", R0, R2, axis=(0, 0, 1))
    m.hinge("between", R1, R2, axis=(0, 0, 1), stiffness=k)
    m.release("between.bend1", "between.bend2")
    m.body("rotor1", O, R1, mass=1.0, inertia=(J1, J1, J1))
    m.body("rotor2", O, R2, mass=1.0, inertia=(J2, J2, J2))
    m.independent("first.angle", "second.angle")
    m.initial("first.angle", rate=40.0)
    m.initial("second.angle", rate=-25.0)
    w = np.sqrt(k * (1 / J1 + 1 / J2))
    motion = m.build().simulate(8.0, samples=9, rtol=1e-11, atol=1e-9)
    relative = -65.0 / w * np.sin(w * motion.t)
    assert np.ptp(relative) > 20 * np.pi
    assert np.max(np.abs(motion["between.angle"] - relative)) < 1e-6
    assert np.ptp(motion.energy["total"]) < 1e-8 * motion.energy["total"][0]


FUNCTIONS = {
    "polynomial": Polynomial((0.3, -1.0, 2.0, 0.5)),
    "harmonic": Harmonic(1.3, 4.0, 0.7, 0.2),
    "ramp": Ramp(-0.4, 0.9, 1.0, 3.0),
    "table": Table(np.linspace(-1, 1.5, 26), np.sin(np.linspace(-1, 1.5, 26))),
    "jet of everything": lambda t: (
        np.exp(-t) * np.sin(3 * t) ** 2 / (2 + np.cos(t))
        + np.sqrt(1 + t**2)
        + np.arctan(t) ** 3
        - np.tanh(t) * np.log(3 + t)
        + abs(t - 7)
        + 2**t
        + np.arcsin(t / 3)
        + np.arccos(t / 3)
        + np.sinh(t) / np.cosh(t)
        + (3 - t) ** (0.5 + t / 9)
        + np.tan(t / 4)
        + np.expm1(t)
        + np.log1p(t + 1)
        + np.square(t)
        + np.reciprocal(3 + t)
    ),
    "piecewise": lambda t: t**3 if t > 0 else -(t**3),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_rates_of_functions_are_their_derivatives(name: str) -> None:
    f = as_function(FUNCTIONS[name], "test")
    for t in (-0.23, 0.11, 0.77):
        u, ud, udd = f.rates(t)
        h = 2e-3 if name == "table" else 2e-2
        assert abs(slope(lambda d, t=t: np.array(f.rates(t + d)[0]), h) - ud) < 1e-8
        assert abs(slope(lambda d, t=t: np.array(f.rates(t + d)[1]), h) - udd) < 2e-7
        assert np.isfinite(u)


def test_ramp_starts_and_ends_smoothly() -> None:
    f = Ramp(0.5, 2.0, -1.0, 3.0)
    for t, u in ((0.5, -1.0), (2.0, 3.0), (-9.0, -1.0), (9.0, 3.0)):
        assert np.allclose(f.rates(t), (u, 0, 0), atol=1e-15)
    assert abs(f.rates(1.25)[0] - 1.0) < 1e-15


def test_math_functions_of_time_are_a_named_error() -> None:
    m = pendulum(mass_per_length=1.0)
    with pytest.raises(FlexelError, match=r"pivot\.angle.*np\.sin|np\.sin.*pivot\.angle"):
        m.prescribe("pivot.angle", lambda t: math.sin(t))
        m.build()


def test_functions_that_numpy_cannot_differentiate_are_a_named_error() -> None:
    m = pendulum(mass_per_length=1.0)
    with pytest.raises(FlexelError, match=r"pivot\.angle.*cbrt|cbrt.*pivot\.angle"):
        m.prescribe("pivot.angle", lambda t: np.cbrt(t + 1))
        m.build()


def test_duffing_spring_by_formula_has_its_energy_and_tangent() -> None:
    m = Model()
    O, P = m.point("O", (0, 0, 0), fixed=True), m.point("P", (1, 0, 0))
    m.fix("P.y", "P.z")
    m.truss("spring", O, P)
    m.point_mass("mass", P, 2.0)
    m.law("spring.elongation", lambda e, ed: 30 * e + 400 * e**3 + 0.5 * ed)
    m.initial("P.x", 1.3, rate=-1.0)
    s = m.build()
    state = s.initial
    assert abs(state.force("spring.elongation") - (30 * 0.3 + 400 * 0.027 - 0.5)) < 1e-13
    assert abs(state.energy.strain - (15 * 0.09 + 100 * 0.0081)) < 1e-13
    lin = s.linearize()
    assert worst(lin.K, np.array([[30 + 1200 * 0.09]])) < 1e-14
    assert worst(lin.C, np.array([[0.5]])) < 1e-14


def test_undamped_duffing_spring_keeps_its_energy() -> None:
    m = Model()
    O, P = m.point("O", (0, 0, 0), fixed=True), m.point("P", (1, 0, 0))
    m.fix("P.y", "P.z")
    m.truss("spring", O, P)
    m.point_mass("mass", P, 2.0)
    m.law("spring.elongation", lambda e, ed: 30 * e + 400 * e**3)
    m.initial("P.x", 1.3, rate=-1.0)
    motion = m.build().simulate(5.0, samples=51, rtol=1e-12, atol=1e-13)
    assert np.ptp(motion.energy["total"]) < 1e-10


def tabled(free: bool = True) -> Model:
    """A mass that is moved along x by a table of 0.3 s, and springs along y or is fixed there."""
    m = Model()
    m.point("A", (0, 0))
    m.point_mass("mass", "A", 1.0)
    m.prescribe("A.x", Table([0, 0.1, 0.2, 0.3], [0, 0.1, 0.3, 0.3]))
    if free:
        m.spring("A.y", 10.0)
        m.initial("A.y", value=0.1)
    else:
        m.fix("A.y")
    return m


def test_a_motion_continued_to_the_end_of_a_table_is_not_stopped_by_rounding() -> None:
    s = tabled().build()
    first = s.simulate(0.1, samples=3)
    assert s.simulate(0.2, samples=3, start=first[-1])["A.x"][-1] == pytest.approx(0.3)


@pytest.mark.parametrize(("free", "method"), [(True, "DOP853"), (True, "generalized-alpha"), (False, "auto")])
def test_where_a_table_ends_its_quantity_is_named_and_the_motion_kept(free: bool, method: str) -> None:
    with pytest.raises(ModelError, match=r"prescribe 'A\.x': Table: time .* outside 0.0…0.3 s") as caught:
        tabled(free).build().simulate(0.5, method=method, samples=51)
    motion = caught.value.motion
    assert motion is not None
    assert 0.2 < motion.t[-1] <= 0.3 + 1e-9  # the last step that did not reach beyond the table


def thrown(lift: float = 0.0) -> System:
    """A mass at a height that flies upwards."""
    m = Model(gravity=(0, 0, -9.81))
    m.point_mass("stone", m.point("P", (0, 0, lift)), 0.5)
    m.initial("P.z", rate=3.0)
    return m.build()


@pytest.mark.parametrize("lift", [-1e-16, 0.0, 1e-16])
def test_a_motion_that_starts_at_an_event_does_not_meet_it_at_once(lift: float) -> None:
    ground = Event("ground", lambda state: state["P.z"], terminal=True)
    motion = thrown(lift).simulate(1.0, max_step=0.1, events=[ground])
    assert motion.t[-1] == pytest.approx(6.0 / 9.81, abs=1e-9)


def test_a_motion_goes_on_from_the_event_that_ended_it() -> None:
    """Whichever side of zero the state of the event lies on; the stored states end with it."""
    top = Event("height", lambda state: state["P.z"] - 0.2, terminal=True, direction=1)
    s = thrown()
    first = s.simulate(1.0, events=[top])
    assert first[-1].t == first.events[0][1].t
    assert first[-1]["P.z"] == pytest.approx(0.2, abs=1e-12)
    assert not s.simulate(0.1, start=first[-1], events=[top]).events


def test_of_two_events_of_one_name_only_the_terminal_one_ends_the_motion() -> None:
    low = Event("height", lambda state: state["P.z"] - 0.1)
    high = Event("height", lambda state: state["P.z"] - 0.2, terminal=True)
    motion = thrown().simulate(1.0, events=[low, high])
    assert [state["P.z"] for _, state in motion.events] == pytest.approx([0.1, 0.2])
