"""A wrong name is refused by the call that gives it, with near names; nothing of the call remains in the model."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from mistakes import pendulum

import flexel as fx

CALLS: dict[str, Callable[[fx.Model, str], Any]] = {
    "spring": lambda m, name: m.spring(name, 1.0),
    "damper": lambda m, name: m.spring(name, damping=1.0),
    "spring by a formula": lambda m, name: m.spring(name, lambda e: 2 * e**3),
    "spring by a curve": lambda m, name: m.spring(name, fx.Curve([[0.0, 1.0]])),
    "pair": lambda m, name: m.spring(("A.x", name), 1.0),
    "list": lambda m, name: m.spring(["A.x", name], np.eye(2)),
    "stop": lambda m, name: m.stop(name, 0.1, 10.0),
    "limits": lambda m, name: m.limits(name, -1.0, 1.0, 10.0),
    "friction": lambda m, name: m.friction(name, 1.0, 0.1),
    "law": lambda m, name: m.law(name, lambda e, ed: e + ed),
    "attach": lambda m, name: m.attach("linear_1", [name], preload=0.0, S=1.0, D=0.0),
    "load": lambda m, name: m.load(name, 1.0),
    "prescribe": lambda m, name: m.prescribe(name, lambda t: t),
    "independent": lambda m, name: m.independent("A.x", name),
    "kinematic": lambda m, name: m.kinematic(name),
    "initial": lambda m, name: m.initial(name, 0.1),
    "rigid": lambda m, name: m.rigid("pivot.bend1", name),
    "release": lambda m, name: m.release("pivot.bend1", name),
    "relation": lambda m, name: m.relation("gears", {"A.x": 1.0, name: -2.0}),
}


def declared(m: fx.Model) -> dict[str, Any]:
    """Everything that the model holds, as comparable text."""
    return {name: repr(value) for name, value in vars(m.lowering).items()}


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
    with pytest.raises(fx.ModelError, match="'R1.omega.wx' is not a deformation"):
        m.law("R1.omega.wx", lambda e, ed: e)
    with pytest.raises(fx.ModelError, match="'pivot.angle' is not a slip"):
        m.attach("viscous_1", ["pivot.angle"], C=1.0)


def test_the_norm_of_euler_parameters_is_no_quantity_to_name() -> None:
    m = pendulum()
    for call in (
        m.independent,
        m.rigid,
        m.initial,
        lambda name: m.load(name, 1.0),
        lambda name: m.spring(name, 1.0),
    ):
        with pytest.raises(
            fx.ModelError, match=r"'R1\.norm' is the norm of the Euler parameters of frame 'R1'"
        ):
            call("R1.norm")
