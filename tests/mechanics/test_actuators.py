"""Inverse dynamics of a path: actuators elsewhere hold it; what they leave free is integrated where it is stable."""

import pickle

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigvals

from flexel.base.errors import DynamicsError, ModelError
from flexel.base.time_functions import Harmonic, Ramp
from flexel.base.time_tables import Table
from flexel.mechanics.internal_dynamics import internal_dynamics
from flexel.parts.model import Model
from flexel.parts.opening import load
from flexel.results.system_facade import System

G = 9.81
JOINTS = ("shoulder.angle", "elbow.angle")


def arm(lengths: tuple[float, float] = (0.6, 0.4)) -> Model:
    """A planar arm of two rods, bent at the elbow, in the vertical plane, built in space."""
    a, b = lengths
    m = Model(gravity=(0, 0, -G))
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.6 * a, 0, 0.8 * a))
    m.point("B", (0.6 * a + b, 0, 0.8 * a))
    m.frame("R0", fixed=True)
    m.frame("R1")
    m.frame("R2")
    m.hinge("shoulder", "R0", "R1", axis=(0, -1, 0))
    m.hinge("elbow", "R1", "R2", axis=(0, -1, 0))
    m.beam("upper", "O", "R1", "A", mass_per_length=3.0 / a)
    m.beam("lower", "A", "R2", "B", mass_per_length=2.0 / b)
    return m


def along_a_path() -> System:
    m = arm()
    m.prescribe("B.x", Harmonic(0.1, 3.0, -0.7, offset=0.76 + 0.1 * np.sin(0.7)), actuators=JOINTS)
    m.prescribe("B.z", Ramp(0.1, 0.9, 0.48, 0.3), actuators=JOINTS)
    return m.build()


def test_moments_for_the_path_of_the_tip_are_those_for_the_motion_of_the_joints() -> None:
    """Two runs: the angles found from the path, then prescribed; moments, and all stresses and reactions, are equal."""
    motion = along_a_path().simulate(1.2, samples=13)
    assert "every motion is prescribed" in motion.message
    for state in motion:
        m = arm()
        for name in JOINTS:
            rates = state[name], state.rate(name), state.acceleration(name)
            m.prescribe(name, tuple((lambda t, z=z: z) for z in rates))
        second = m.build().initial
        assert np.abs(second.x - state.x).max() < 1e-14
        size = np.abs(second.stresses).max()
        assert np.abs(second.stresses - state.stresses).max() < 1e-13 * size
        assert np.abs(second.reactions - state.reactions).max() < 1e-13 * size
        assert state.force("B.x") == state.force("B.z") == 0
        assert abs(state.force("shoulder.angle")) > 1


def test_the_order_of_actuators_does_not_matter() -> None:
    m = arm()
    m.prescribe("B.z", Ramp(0.1, 0.9, 0.48, 0.3), actuators=JOINTS[1:])
    m.prescribe("B.x", Harmonic(0.1, 3.0, -0.7, offset=0.76 + 0.1 * np.sin(0.7)), actuators=JOINTS[:1])
    one, other = m.build().initial, along_a_path().initial
    assert np.abs(one.stresses - other.stresses).max() < 1e-13 * np.abs(one.stresses).max()


def hanging(depth: float) -> Model:
    """A trolley on a beam, with a mass of 2 kg on a rigid rod of 1 m, of which the point at a depth follows a path."""
    m = Model(gravity=(0, -G))
    m.point("trolley", (0, 0))
    m.fix("trolley.y")
    m.point_mass("weight", "trolley", 3.0)
    m.angle("turn", 0.0)
    for name, length, mass in (("load", 1.0, 2.0), ("mark", depth, 0.0)):
        m.point(name, (0, -length))
        m.beam(f"to {name}", "trolley", "turn", name)
        if mass:
            m.point_mass(f"mass of {name}", name, mass)
    return m


def test_a_crane_follows_a_path_of_a_point_of_its_rod() -> None:
    """Closed form, with l = 1 and x = u - d sin a of the trolley: (1 - d c²) a'' + d s c a'² + g s + c u'' = 0."""
    d, u = 0.4, Ramp(0.0, 2.0, 0.0, 1.0)
    m = hanging(d)
    m.prescribe("mark.x", u, actuators=("trolley.x",))
    s = m.build()
    motion = s.simulate(4.0, samples=41, rtol=1e-11, atol=1e-13)
    assert "actuators hold a path" in motion.message and not motion.warnings

    def rates(t: float, y: np.ndarray) -> list[float]:
        a, w = y
        c, sn = np.cos(a), np.sin(a)
        return [w, (-c * u.rates(t)[2] - d * sn * c * w**2 - G * sn) / (1 - d * c**2)]

    knots = [0.0, 2.0, 4.0]
    y, expected = np.zeros(2), []
    for t0, t1 in zip(knots[:-1], knots[1:], strict=True):
        times = [t for t in motion.t if t0 <= t < t1 or t1 == t == knots[-1]]
        found = solve_ivp(rates, (t0, t1), y, "DOP853", rtol=1e-12, atol=1e-14, t_eval=sorted({*times, t1}))
        expected += found.y[0, : len(times)].tolist()
        y = found.y[:, -1]
    angles = np.array([state["turn.angle"] for state in motion])
    assert np.abs(angles).max() > 0.05
    assert np.abs(angles - expected).max() < 1e-9
    state = motion[15]  # the force moves both masses along
    force = 3.0 * state.acceleration("trolley.x") + 2.0 * state.acceleration("load.x")
    assert abs(state.force("trolley.x") - force) < 1e-12


def test_the_internal_dynamics_of_the_crane_are_those_of_the_closed_form() -> None:
    m = hanging(0.4)
    m.prescribe("mark.x", 0.0, actuators=("trolley.x",))
    s = m.build()
    values, _ = internal_dynamics(s.kinematics, s.initial).modes()
    assert np.abs(np.sort(values.imag) - np.sqrt(G / 0.6) * np.array([-1, 1])).max() < 1e-12


def flexible(name: str, count: int = 2) -> Model:
    """A flexible arm on a hub, of whose points one follows a path."""
    m = Model()
    m.point("P0", (0, 0), fixed=True)
    m.angle("A0", 0.0)
    m.body("hub", "P0", "A0", mass=1.0, inertia=0.4)
    for i in range(1, count + 1):
        m.point(f"P{i}", (i / count, 0))
        m.angle(f"A{i}", 0.0)
        ends = f"P{i - 1}", f"A{i - 1}", f"P{i}", f"A{i}"
        m.beam(f"b{i}", *ends, mass_per_length=1.0, EIz=50.0)
    m.prescribe(name, Harmonic(0.2, 4.0, -np.pi / 2, offset=0.2), actuators=("A0.angle",))
    return m


def freed(count: int = 2) -> Model:
    m = flexible(f"P{count}.y", count)
    return Model.of(m.gravity, [part for part in m.parts if not part.label.startswith("prescribe")])


def test_the_internal_dynamics_of_an_arm_are_the_zeros_of_its_transfer_function() -> None:
    """Independently: the generalized eigenvalues of [A B; C 0] of the state-space model from the moment to the path."""
    s = flexible("P2.y").build()
    values, _ = internal_dynamics(s.kinematics, s.initial).modes()
    A, B, C, D = freed().build().linearize().state_space(["A0.angle"], ["P2.y"])
    n = A.shape[0]
    pencil = np.block([[A, B], [C, D]])
    weight = np.zeros_like(pencil)
    weight[:n, :n] = np.eye(n)
    zeros = eigvals(pencil, weight)
    zeros = zeros[np.abs(zeros) < 1e5]
    assert np.abs(np.sort_complex(values) - np.sort_complex(zeros)).max() < 1e-6 * np.abs(values).max()


def test_the_tip_of_a_flexible_arm_cannot_be_held_by_its_motor() -> None:
    s = flexible("P2.y").build()
    with pytest.raises(
        DynamicsError, match=r"'A0.angle' holds the path of 'P2.y'.*unstable at t = 0 s: '.*' grows"
    ):
        s.simulate(1.0)


def with_a_tool(path: bool) -> Model:
    """The arm with a flexible tool on the lower rod, which vibrates freely."""
    m = arm()
    m.point("C", (0.76, 0, 0.23))
    m.frame("R3")
    m.beam("tool", "B", "R2", "C", "R3", mass_per_length=1.0, EIy=4.0, EIz=4.0)
    if path:
        m.prescribe("B.x", Harmonic(0.1, 3.0, -0.7, offset=0.76 + 0.1 * np.sin(0.7)), actuators=JOINTS)
        m.prescribe("B.z", Ramp(0.1, 0.9, 0.48, 0.3), actuators=JOINTS)
    return m


def test_the_free_arm_moves_in_the_same_way_under_the_moments_that_were_found() -> None:
    """By the ordinary equations of motion, with a flexible tool, and with the crane."""
    crane = hanging(0.4)
    crane.prescribe("mark.x", Ramp(0.0, 2.0, 0.0, 1.0), actuators=("trolley.x",))
    for path, free, actuators, sign in (
        (with_a_tool(True), lambda: with_a_tool(False), JOINTS, -1),
        (crane, lambda: hanging(0.4), ("trolley.x",), 1),
    ):
        motion = path.build().simulate(1.0, samples=6)
        assert (
            "actuators hold a path" in motion.message and "energy" in motion.message and not motion.warnings
        )
        for state in motion:
            m = free()
            for name in actuators:
                m.load(name, sign * state.force(name))
            found = m.build().state(state.t, state.x, state.v, state.e)
            assert np.abs(found.a - state.a).max() <= 1e-9 * np.abs(state.a).max()
            assert np.abs(found.stresses - state.stresses).max() <= 1e-9 * np.abs(state.stresses).max()


def test_a_path_with_actuators_is_saved_and_written_as_a_program(tmp_path) -> None:  # noqa: ANN001
    s = along_a_path()
    again = pickle.loads(pickle.dumps(s))
    assert again.initial.force("elbow.angle") == s.initial.force("elbow.angle")
    m = arm()
    m.prescribe("B.x", Ramp(0.1, 0.9, 0.76, 0.5), actuators=JOINTS)
    m.prescribe("B.z", Ramp(0.1, 0.9, 0.48, 0.3), actuators=JOINTS)
    wanted = m.build().initial.stresses
    opened = load(m.save(tmp_path / "arm.json"))
    assert np.array_equal(opened.build().initial.stresses, wanted)
    names: dict = {}
    exec(m.program(), names)
    assert np.array_equal(names["m"].build().initial.stresses, wanted)


def refused(**given) -> Model:  # noqa: ANN003
    m = arm()
    m.prescribe("B.x", 0.76, **given)
    m.prescribe("B.z", 0.48, **given)
    return m


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"actuators": JOINTS[:1]},
            r"2 quantities \('B.x', 'B.z'\) and 1 actuator \('shoulder.angle'\); give as many",
        ),
        ({"actuators": ("shoulder.angle", "elbow.bend1")}, "'elbow.bend1' is rigid and moves nothing"),
        ({"actuators": ("shoulder.angle", "B.z")}, "'B.z' is also prescribed"),
        ({"actuators": ("shoulder.angle", "O.x")}, "'O.x' is fixed and moves nothing"),
        ({"actuators": ("shoulder.angle", "wrist.angle")}, "prescribe 'B.x': actuator"),
        ({"actuators": "shoulder.angle"}, "is not a list of names"),
    ],
)
def test_actuators_that_cannot_act_are_refused_by_name(given: dict, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        refused(**given).build()


def test_a_path_that_the_actuator_does_not_reach_is_refused() -> None:
    """The rod has no mass: where it hangs, a force on the trolley does not move the load at once."""
    m = hanging(1.0)
    m.prescribe("mark.x", Ramp(0.0, 2.0, 0.0, 1.0), actuators=("trolley.x",))
    with pytest.raises(DynamicsError, match=r"'trolley.x' cannot hold the path of 'mark.x'"):
        m.build().simulate(0.1)


def test_other_analyses_are_refused() -> None:
    m = hanging(0.4)
    m.prescribe("mark.x", Ramp(0.0, 2.0, 0.0, 1.0), actuators=("trolley.x",))
    s = m.build()
    for analysis in (
        s.linearize,
        s.equilibrium,
        s.vibrations,
        lambda: s.simulate(0.1, method="generalized-alpha"),
        lambda: s.simulate(0.1, method="Radau"),
    ):
        with pytest.raises(ModelError, match="path of 'mark.x' is held by the actuators 'trolley.x'"):
            analysis()


def test_the_summary_names_the_actuators_and_the_method() -> None:
    m = hanging(0.4)
    m.prescribe("mark.x", Ramp(0.0, 2.0, 0.0, 1.0), actuators=("trolley.x",))
    text = str(m.build().summary())
    assert "trolley.x" in text.partition("moved by actuators")[2] and "DOP853: actuators hold a path" in text


def test_variants_have_the_forces_of_single_runs() -> None:
    m = hanging(0.4)
    m.prescribe("mark.x", Ramp(0.0, 2.0, 0.0, 1.0), actuators=("trolley.x",))
    s = m.build()
    name, times = "mass of load.mass", np.linspace(0, 1, 3)
    many = s.simulate_many(1.0, parameters={name: [1.0, 4.0]}, times=times)
    for i, mass in enumerate((1.0, 4.0)):
        single = s.with_parameters({name: mass}).simulate(1.0, times=times)
        assert np.array_equal(many["turn.angle"][i], single["turn.angle"])


def test_a_path_whose_rates_jump_is_refused() -> None:
    m = hanging(0.4)
    m.prescribe("mark.x", Table([0, 1, 2], [0, 0, 0.5], kind="linear"), actuators=("trolley.x",))
    with pytest.raises(DynamicsError, match=r"rates jump at t = 1 s.*'mark.x'"):
        m.build().simulate(2.0)
