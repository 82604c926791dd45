"""Equilibria of cars on tyres: nothing resists that they roll, and side forces of leaning wheels have no potential."""

import numpy as np
import pytest
from wheels import MAGIC, PARTS

import flexel as fx
from flexel.examples.vehicle import vehicle

WEIGHT = (1200.0 + 4 * 40.0) * 9.81
AXLES = {"front": 1.2, "rear": -1.3}


def car(camber_stiffness: float) -> fx.System:
    """A body on four sprung swing axles, whose wheels lean as the body sinks."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("chassis", (0, 0, 0.5))
    m.frame("body")
    m.angular_velocity("body")
    m.body("mass", "chassis", "body", mass=1200.0, inertia=(300, 1500, 1600))
    for axle, x in AXLES.items():
        for side, s in (("left", 1), ("right", -1)):
            corner = f"{axle} {side}"
            pivot, hub, arm, tyre = (f"{corner} {part}" for part in ("pivot", "hub", "arm", "tyre"))
            m.point(pivot, (x, s * 0.3, 0.35))
            m.point(hub, (x, s * 0.75, 0.33))
            m.frame(arm)
            m.body_point(f"{corner} seat", "chassis", "body", pivot)
            m.hinge(f"{corner} swing", "body", arm, axis=(s, 0, 0))
            m.body_point(f"{corner} rod", pivot, arm, hub)
            m.spring(f"{corner} swing.angle", 4000.0, 400.0)
            m.body(f"{corner} wheel", hub, arm, mass=40.0, inertia=(1, 1.5, 1))
            m.tyre(tyre, hub, arm, radius=0.34, axle=(0, 1, 0))
            on = [f"{tyre}.{part}" for part in PARTS if part != "sideways"]
            values = MAGIC | {"camber_stiffness": camber_stiffness}
            m.attach("magic_formula", on, name=f"{tyre} law", stiffness=2e5, damping=100.0, **values)
    return m.build()


def carried(state: fx.State) -> float:
    """Sum of the loads on the tyres [N]."""
    corners = [f"{axle} {side}" for axle in AXLES for side in ("left", "right")]
    lean = [np.cos(state[f"{corner} tyre.camber"]) for corner in corners]
    return float(
        sum(state.force(f"{c} tyre.deflection") / cosine for c, cosine in zip(corners, lean, strict=True))
    )


@pytest.mark.parametrize("tyres", ["vertical", "linear", "calspan"])
def test_a_standing_vehicle_sinks_and_does_not_roll_away(tyres: str) -> None:
    state = vehicle(0.0, tyres=tyres).equilibrium()
    assert abs(state["chassis.x"]) < 1e-2  # the wheels move back and forth with their suspension
    assert abs(state["chassis.y"]) < 1e-9
    assert abs(state["yaw.angle"]) < 1e-9


def test_a_car_sinks_on_its_swing_axles() -> None:
    state = car(0.0).equilibrium()
    assert abs(state["chassis.y"]) < 1e-9
    assert carried(state) == pytest.approx(WEIGHT, rel=1e-3)


def test_a_force_along_a_motion_that_nothing_resists_is_named_and_can_be_held() -> None:
    """Camber thrust of wheels that a pitched body has turned has a part along the car."""
    s = car(1.0)
    with pytest.raises(fx.DynamicsError, match=r"nothing resists a motion of 'chassis\.x'.*hold="):
        s.equilibrium()
    state = s.equilibrium(hold=["chassis.x"])
    assert abs(state["chassis.y"]) < 1e-9
    assert 1.0 < abs(state.force("chassis.x")) < 100.0


def test_wheels_drawn_on_the_road_settle_where_they_are() -> None:
    """Nothing resists the fall until they touch: the descent took 0.2 m along the road, turned and rolled the car."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("C", (0, 0, 0.5))
    m.frame("B")
    m.body("body", "C", "B", mass=300.0, inertia=(20.0, 40.0, 50.0))
    for name, (x, y) in {"left": (1, 0.6), "right": (1, -0.6), "rear": (-1, 0)}.items():
        m.point(f"{name} hub", (x, y, 0.3))
        m.frame(name)
        m.body_point(f"{name} arm", "C", "B", f"{name} hub")
        m.hinge(f"{name} axle", "B", name, (0, 1, 0))
        m.body(f"{name} rim", f"{name} hub", name, mass=10.0, inertia=(0.3, 0.5, 0.3))
        m.tyre(f"{name} tyre", f"{name} hub", name, radius=0.3, axle=(0, 1, 0), crown=0.05)
        m.attach("vertical_tyre", [f"{name} tyre.deflection"], stiffness=1e5, damping=100.0)
    found = m.build().equilibrium()
    # with the weight in the middle, the rear wheel carries half of it, and sinks by twice as much
    rear, front = (found[f"{name} hub.z"] - 0.3 for name in ("rear", "left"))
    assert (rear, front) == pytest.approx((-165 * 9.81 / 1e5, -82.5 * 9.81 / 1e5), rel=0.05)
    assert abs(found["C.x"]) < 1e-3
    assert (found["C.y"], found["left hub.y"]) == pytest.approx((0, 0.6), abs=1e-5)
