"""The analytic linearization against numerical derivatives of the nonlinear equations, at general states.

Moving, out of equilibrium, with springs, dampers, loads, prescribed motions, loops and rolling contact.
"""

import numpy as np
import pytest
from differences import (
    Knob,
    numerical_matrices,
    numerical_outputs,
    numerical_state_matrix,
    worst,
)
from moving import CRANK, FORCE, MODELS, PUSH, TROLLEY, TURN, double_pendulum

TOLERANCE = 1e-8  # of the numerical derivatives, which lose digits to rounding


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
    "touching": ["P.x''", "foot.gap", "foot.x''", "force:foot.gap", "force:foot.y", "ball.gap1'", "force:ball.gap2",
                 "force:ball.tangential1", "force:ball.across2", "ball.tangential2''", "force:O.z"],
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
