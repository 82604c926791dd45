"""A wrong name is refused by the call that gives it, with near names; nothing of the call remains in the model."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from mistakes import pendulum

import flexel as fx

CALLS: dict[str, Callable[[fx.Model, str], Any]] = {
    "spring": lambda m, z: m.spring(z, 1.0),
    "damper": lambda m, z: m.spring(z, damping=1.0),
    "spring by a formula": lambda m, z: m.spring(z, lambda e: 2 * e**3),
    "spring by a curve": lambda m, z: m.spring(z, fx.Curve([[0.0, 1.0]])),
    "pair": lambda m, z: m.spring(("A.x", z), 1.0),
    "list": lambda m, z: m.spring(["A.x", z], np.eye(2)),
    "stop": lambda m, z: m.stop(z, 0.1, 10.0),
    "limits": lambda m, z: m.limits(z, -1.0, 1.0, 10.0),
    "friction": lambda m, z: m.friction(z, 1.0, 0.1),
    "law": lambda m, z: m.law(z, lambda e, ed: e + ed),
    "attach": lambda m, z: m.attach("linear_1", [z], preload=0.0, S=1.0, D=0.0),
    "load": lambda m, z: m.load(z, 1.0),
    "prescribe": lambda m, z: m.prescribe(z, lambda t: t),
    "independent": lambda m, z: m.independent("A.x", z),
    "kinematic": lambda m, z: m.kinematic(z),
    "initial": lambda m, z: m.initial(z, 0.1),
    "rigid": lambda m, z: m.rigid("pivot.bend1", z),
    "release": lambda m, z: m.release("pivot.bend1", z),
    "relation": lambda m, z: m.relation("gears", {"A.x": 1.0, z: -2.0}),
}


def declared(m: fx.Model) -> dict[str, Any]:
    """Everything that the model holds, as comparable text."""
    return {name: repr(z) for name, z in vars(m).items()}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_a_wrong_name_is_refused_where_it_is_given(call: Callable[[fx.Model, str], Any]) -> None:
    m = pendulum()
    before = declared(m)
    with pytest.raises(fx.ModelError, match=r"unknown name 'pivot\.angl'; did you mean pivot\.angle"):
        call(m, "pivot.angl")
    assert declared(m) == before


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_the_right_name_is_accepted(call: Callable[[fx.Model, str], Any]) -> None:
    m = pendulum()
    before = declared(m)
    call(m, "pivot.angle")
    assert declared(m) != before


@pytest.mark.parametrize("kind", ["a slip", "a coordinate"])
def test_a_quantity_of_another_kind_is_refused_where_it_is_given(kind: str) -> None:
    m = pendulum()
    m.angular_velocity("R1")
    calls = {
        "a slip": (
            lambda: m.prescribe("R1.omega.wx", 1.0),
            lambda: m.independent("R1.omega.wx"),
            lambda: m.kinematic("R1.omega.wx"),
        ),
        "a coordinate": (lambda: m.rigid("A.x"), lambda: m.release("A.x")),
    }
    for call in calls[kind]:
        with pytest.raises(fx.ModelError, match=f"' is {kind}"):
            call()


def test_laws_take_deformations_then_slips() -> None:
    m = pendulum()
    m.angular_velocity("R1")
    with pytest.raises(fx.ModelError, match="'A.x' is not a deformation"):
        m.law("A.x", lambda e, ed: e)
    with pytest.raises(fx.ModelError, match="'pivot.angle' is not a slip"):
        m.attach("viscous_1", ["pivot.angle"], C=1.0)


def test_the_norm_of_euler_parameters_is_no_quantity_to_name() -> None:
    m = pendulum()
    for call in (m.independent, m.rigid, m.initial, lambda z: m.load(z, 1.0), lambda z: m.spring(z, 1.0)):
        with pytest.raises(
            fx.ModelError, match=r"'R1\.norm' is the norm of the Euler parameters of frame 'R1'"
        ):
            call("R1.norm")
