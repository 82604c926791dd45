"""The analytic linearization against numerical derivatives of the nonlinear equations, at general states.

Moving, out of equilibrium, with springs, dampers, loads, prescribed motions, loops and rolling contact.
"""

from collections.abc import Callable

import numpy as np
import pytest
from differences import (
    Knob,
    numerical_matrices,
    numerical_outputs,
    numerical_state_matrix,
    pendulum,
    worst,
)
from mechanisms import disc, rssr

from flexel.model import Model

TOLERANCE = 1e-8  # of the numerical derivatives, which lose digits to rounding


def double_pendulum() -> Model:
    """Two rods on skew hinges with springs and dampers, a constant force and a follower moment, in full swing."""
    m = pendulum(mass_per_length=2.0)
    B, R2 = m.point("B", (1.5, 0.6, 0.2)), m.frame("R2")
    m.hinge("elbow", "R1", R2, axis=(1, 1, 0.4), stiffness=7.0, damping=0.4)
    m.beam("arm", "A", R2, B, mass_per_length=1.0, inertia_per_length=(0.1, 0.05, 0.05))
    m.body("hand", B, R2, mass=0.7, inertia=(0.2, 0.3, 0.4, 0.02, -0.03, 0.01), offset=(0.1, 0.2, -0.1))
    m.load("B", (1.0, -2.0, 3.0))
    m.load("R2", (0.6, 0.2, -0.9), follower=True)
    m.load("R1", (0.1, 0.7, -0.3))
    m.initial("pivot.angle", 0.7, rate=2.0)
    m.initial("elbow.angle", -0.9, rate=-3.0)
    return m


def flexible_arm() -> Model:
    """A beam with all six modes flexible and damped on a turning hinge, with a tip body."""
    m = Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (1, 0, 0))
    R0, R1, R2 = m.frame("R0", fixed=True), m.frame("R1"), m.frame("R2")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0.3))
    stiff = {"EA": 900.0, "GJ": 6.0, "EIy": 9.0, "EIz": 14.0, "GAy": 500.0, "GAz": 400.0}
    m.beam(
        "arm", O, R1, A, R2, **stiff, damping=0.01, mass_per_length=1.0, inertia_per_length=(0.02, 0.01, 0.01)
    )
    m.body("tip", A, R2, mass=0.5, inertia=(0.03, 0.02, 0.04), offset=(0.1, 0.0, 0.05))
    modes = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")
    m.independent("pivot.angle", *(f"arm.{z}" for z in modes))
    m.initial("pivot.angle", 0.4, rate=2.5)
    for i, mode in enumerate(modes):
        m.initial(f"arm.{mode}", 0.02 * (-1) ** i, rate=0.1 * (i - 2))
    return m


def driven() -> Model:
    """A spring pendulum hung from a trolley on a turntable, both with prescribed motions."""
    m = Model(gravity=(0, 0, -9.81))
    O, T, P = m.point("O", (0, 0, 0), fixed=True), m.point("T", (0.5, 0, 0)), m.point("P", (0.6, 0.1, -1))
    ground, table = m.frame("ground", fixed=True), m.frame("table")
    m.hinge("turn", ground, table, axis=(0, 0, 1))
    m.beam("rail", O, table, T)
    m.release("rail.along")
    m.prescribe("turn.angle", TURN)
    m.prescribe("rail.along", TROLLEY)
    m.truss("string", T, P, stiffness=80.0, damping=1.5)
    m.point_mass("bob", P, 1.2)
    m.body("plate", T, table, mass=2.0, inertia=(0.2, 0.3, 0.4), offset=(0.1, 0.05, 0))
    m.independent("P.x", "P.y", "P.z")
    for name, rate in (("P.x", 0.5), ("P.y", -1.5), ("P.z", 0.8)):
        m.initial(name, rate=rate)
    m.load("P", (0.3, FORCE, -0.2))
    return m


TURN, TROLLEY, FORCE = Knob(0.4, 1.7, -2.2), Knob(0.12, -0.6, 1.1), Knob(1.4)


def driven_loop() -> Model:
    """The spatial four-bar with a prescribed crank and a flexible rocker hinge: no dynamic freedom but a spring."""
    m = rssr(universal=False)
    m._dynamic = None
    m._rates.clear()
    m._values.clear()
    m.release("coupler bar.elongation")
    m.spring("coupler bar.elongation", 300.0, 2.0)
    m.prescribe("input.angle", CRANK)
    m.independent("output.angle")
    m.initial("output.angle", 0.15, rate=0.7)
    return m


CRANK = Knob(0.3, 2.0, -1.0)


def loop() -> Model:
    m = rssr(universal=True)
    m.initial("input.angle", 0.4, rate=2.0)
    m.spring("output.angle", 4.0, 0.3, preload=1.0)
    return m


def rolling() -> Model:
    """The disc in a wobbling turn, with a sprung passenger and a load: non-holonomic, far from steady."""
    m = disc(1.1, (2.0, 0.4, -5.0))
    Q = m.point("Q", (0.1, -0.1, 0.6))
    R = m.frame("Q frame")
    m.hinge("swing", "L", R, axis=(1, 0.5, 0), stiffness=3.0, damping=0.2)
    m.beam("rod", "hub", R, Q, mass_per_length=0.6)
    m.independent("swing.angle")
    m.initial("swing.angle", 0.3, rate=-1.0)
    m.load("Q", (0.5, PUSH, 0.0))
    return m


PUSH = Knob(-0.7)


def sliding() -> Model:
    """The disc with viscous resistance along and across instead of pure rolling, and a twisting moment."""
    m = disc(1.3, (1.0, 0.2, 4.0))
    m._dynamic, m._kinematic = None, None
    m.spring("wheel.longitudinal", damping=2.5)
    m.spring("wheel.lateral", damping=1.5)
    m.spring("wheel.spin", damping=0.4)
    m.independent("yaw.angle", "lean.angle", "roll.angle", "contact.x", "contact.y")
    m.initial("contact.x", rate=1.0)
    m.initial("contact.y", rate=-0.5)
    m.load("S", (0.1, 0.3, 0.2))
    return m


def tumbling() -> Model:
    """A free body on a spring; its coordinates are chosen by the program."""
    m = Model(gravity=(0, 0, -9.81))
    P, R, Q = m.point("P", (0, 0, 0)), m.frame("R"), m.point("Q", (0.3, 0.4, -0.2))
    W = m.point("wall", (0.2, 0.3, 0.9), fixed=True)
    m.body("body", P, R, mass=2.0, inertia=(0.3, 0.5, 0.6, 0.05, 0.02, -0.04), offset=(0.05, -0.1, 0.1))
    m.body_point("eye", P, R, Q)
    m.truss("spring", W, Q, stiffness=50.0, damping=0.7)
    w = m.angular_velocity(R)
    for name, rate in ((f"{w}.wx", 1.0), (f"{w}.wy", -2.0), (f"{w}.wz", 3.0), ("P.x", 0.4), ("P.z", -0.3)):
        m.initial(name, rate=rate)
    return m


def planar() -> Model:
    """Planar beam, truss and hinge spring together."""
    m = Model(gravity=(0, -9.81))
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0.2)), m.point("B", (1.1, -0.8))
    r0, r1, r2 = m.angle("r0", fixed=True), m.angle("r1", 0.1), m.angle("r2", -0.2)
    m.hinge("base", r0, r1, stiffness=20.0, damping=0.5)
    m.beam(
        "link", O, r1, A, r2, EA=700.0, EIz=9.0, damping=0.02, mass_per_length=1.0, inertia_per_length=0.01
    )
    m.truss("tie", A, B, mass_per_length=0.5)
    m.body("tip", B, "r2", mass=0.4, inertia=0.05, offset=(0.1, -0.1))
    m.independent("base.angle", "link.elongation", "link.bend1", "link.bend2", "B.x")
    for i, z in enumerate(m._dynamic or []):
        m.initial(z, rate=0.4 * (-1) ** i)
    return m


MODELS: dict[str, Callable[[], Model]] = {
    f.__name__: f
    for f in (double_pendulum, flexible_arm, driven, driven_loop, loop, rolling, sliding, tumbling, planar)
}
everyone = pytest.mark.parametrize("name", MODELS)


@everyone
def test_matrices_are_the_derivatives_of_the_nonlinear_residual(name: str) -> None:
    s = MODELS[name]().build()
    lin = s.linearize()
    M, C, K = numerical_matrices(s, s.initial)
    assert worst(lin.M, M) < 5e-11
    assert worst(lin.M, lin.M.T) < 1e-14
    assert worst(lin.C, C) < TOLERANCE
    assert worst(lin.K, K) < TOLERANCE
    assert np.all(np.linalg.eigvalsh(lin.M) > 0)


@everyone
def test_state_matrix_is_the_derivative_of_the_right_hand_side(name: str) -> None:
    s = MODELS[name]().build()
    assert np.any(s.initial.qd)
    assert np.any(np.abs(s.initial.a) > 1e-3)
    assert worst(s.linearize().state_matrix, numerical_state_matrix(s, s.initial)) < TOLERANCE


INPUTS: dict[str, tuple[dict[str, Knob], dict[str, Knob]]] = {
    "driven": ({"turn.angle": TURN, "rail.along": TROLLEY}, {"P.y": FORCE}),
    "driven_loop": ({"input.angle": CRANK}, {}),
    "rolling": ({}, {"Q.y": PUSH}),
}
OUTPUTS = {
    "double_pendulum": ["B.x", "elbow.angle'", "B.z''", "force:arm.along", "force:elbow.angle", "force:O.x",
                        "R2.lambda1"],
    "flexible_arm": ["A.z", "arm.bend1", "A.x''", "arm.torsion''", "force:pivot.bend1", "force:arm.bend3", "force:O.z"],
    "driven": ["P.x", "T.y'", "T.x''", "string.elongation'", "force:turn.angle", "force:rail.along",
               "force:string.elongation", "force:rail.across1", "force:O.y", "table.lambda3''"],
    "driven_loop": ["C.y''", "force:input.angle", "force:output.bend1", "force:coupler bar.elongation", "force:A.z"],
    "loop": ["C.x", "coupler.lambda2'", "force:pin1.bend2", "force:coupler bar.across1", "force:D.x", "B.y''"],
    "rolling": ["Q.x", "hub.y'", "hub.z''", "wheel.spin'", "wheel.spin''", "force:wheel.longitudinal",
                "force:wheel.lateral", "force:wheel.surface", "force:swing.angle", "contact.x''"],
    "sliding": ["hub.x''", "wheel.lateral'", "wheel.longitudinal''", "force:wheel.lateral", "force:wheel.surface"],
    "tumbling": ["Q.x", "Q.y''", "spring.elongation", "force:spring.elongation", "force:wall.z", "force:eye.along",
                 "R.omega.wx'", "R.omega.wz''"],
    "planar": ["B.x''", "tie.elongation", "force:tie.elongation", "force:base.angle", "force:O.y", "r2.angle'"],
}  # fmt: skip


@everyone
def test_state_space_form_is_the_derivative_of_states_and_outputs(name: str) -> None:
    """With the inputs of prescribed motions (acceleration, and rate and value as states) and of loads."""
    s = MODELS[name]().build()
    motions, loads = INPUTS.get(name, ({}, {}))
    A, B, C, D = s.linearize().state_space([*loads, *motions], OUTPUTS[name])
    AB, CD = numerical_outputs(s, s.initial, list(motions.values()), list(loads.values()), OUTPUTS[name])
    assert worst(np.hstack([A, B]), AB) < TOLERANCE
    for computed, reference, output in zip(np.hstack([C, D]), CD, OUTPUTS[name], strict=True):
        assert worst(computed, reference) < TOLERANCE, output


def test_loads_on_any_quantity_are_inputs() -> None:
    """Coordinates, deformations (of a rigid one: a preload) and slips; each as a knob on the real model."""
    knobs = {
        "B.x": Knob(0.3),
        "elbow.angle": Knob(0.2),
        "arm.along": Knob(-0.4),
        "R2.body_omega.wy": Knob(0.1),
    }
    m = double_pendulum()
    m.angular_velocity("R2", body_axes=True)
    for name, knob in knobs.items():
        m.load(name, knob)
    s = m.build()
    outputs = [
        "B.y''",
        "force:O.z",
        "force:elbow.angle",
        "force:arm.along",
        "force:R2.body_omega.wy",
        "force:pivot.bend1",
    ]
    A, B, C, D = s.linearize().state_space(list(knobs), outputs)
    AB, CD = numerical_outputs(s, s.initial, [], list(knobs.values()), outputs)
    assert worst(np.hstack([A, B]), AB) < TOLERANCE
    for computed, reference, output in zip(np.hstack([C, D]), CD, outputs, strict=True):
        assert worst(computed, reference) < TOLERANCE, output


@pytest.mark.parametrize("name", ["loop", "planar", "flexible_arm"])
def test_stiffness_is_symmetric_in_a_conservative_equilibrium(name: str) -> None:
    m = MODELS[name]()
    m._rates.clear()
    m._values.clear()
    s = m.build()
    lin = s.linearize(s.equilibrium() if name == "loop" else s.steady())
    assert worst(lin.K, lin.K.T) < 1e-12
    assert worst(lin.C, lin.C.T) < 1e-12


def test_eigenvalues_do_not_depend_on_the_chosen_freedoms() -> None:
    m = MODELS["loop"]()
    m._rates.clear()
    s = m.build()
    rest = s.equilibrium()
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
