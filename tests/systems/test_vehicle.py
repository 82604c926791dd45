"""The road vehicle: statics, linear equations, steering, bumps, and invalid requests."""

from typing import Any

import numpy as np
import pytest

import flexel as fx
from flexel.base.quaternions import matrix
from flexel.examples import motorcycle, vehicle_data, vehicle_runs, vehicle_signals, vehicle_table
from flexel.examples.bicycle_data import EIGENVALUES
from flexel.examples.differences import mismatch
from flexel.examples.published import published
from flexel.examples.vehicle import LEAF, UNIT_DAMPER, UNIT_SPRING, vehicle
from flexel.integration.ranges import outside

CORNERS = vehicle_data.CORNERS


@pytest.fixture(scope="module")
def benchmark() -> dict[str, Any]:
    return published("iltis")


@pytest.fixture(scope="module")
def at_rest() -> fx.State:
    return vehicle_runs.at_rest(vehicle(deflection="drop"))


def test_the_points_are_those_of_the_file(benchmark: dict[str, Any]) -> None:
    names = {
        "link pivot": "upper_arm_chassis",
        "upper ball": "upper_ball",
        "arm pivot": "lower_arm_chassis",
        "lower ball": "lower_ball",
        "unit top": "damper_chassis",
        "unit foot": "damper_lower_arm",
        "rack end": "tie_rod_rack_end",
        "tie rod end": "tie_rod_upright_end",
        "hub": "wheel_centre",
    }
    rest = vehicle().at_rest
    for corner in CORNERS:
        axle, side = corner.split()
        points = benchmark["nominal_points_in_chassis_frame"][f"{axle}_{'ym' if side == 'right' else 'yp'}"]
        for ours, theirs in names.items():
            expected = np.array(points[theirs]) + [0, 0, vehicle_data.HEIGHT]
            assert rest.position(f"{corner} {ours}") == pytest.approx(expected, abs=1e-9)


def test_tables_of_springs_and_dampers_are_their_curves(benchmark: dict[str, Any]) -> None:
    unit = benchmark["forces"]["damper_unit"]
    for x, force in unit["spring_table_Z_F"]:
        assert UNIT_SPRING(x) == pytest.approx(force, abs=2e-3)
    for x, force in unit["damper_table_Zd_F"]:
        assert UNIT_DAMPER(x) == pytest.approx(force, abs=2e-3)
    for x, force in benchmark["forces"]["leaf_spring"]["table_L_F"]:
        assert -LEAF(vehicle_data.LEAF_FREE - x) == pytest.approx(force, abs=2e-3)


def test_nominal_forces_are_the_published_ones() -> None:
    found = vehicle_table.suspension_forces(vehicle(deflection="drop").at_rest)
    assert found["leaf_front"] == pytest.approx(-2728.9, abs=0.05)
    assert found["unit_rear"] == pytest.approx(-128.0, abs=0.05)
    assert found["tyre_front"] == pytest.approx(3829.6, abs=0.11)
    assert found["tyre_rear"] == pytest.approx(3593.6, abs=0.11)


def test_static_equilibrium_is_the_recomputed_one(at_rest: fx.State) -> None:
    found = vehicle_table.suspension_forces(at_rest) | vehicle_table.height(at_rest)
    for name, (value, _) in vehicle_data.EQUILIBRIUM.items():
        assert found[name] == pytest.approx(value, rel=1e-5 if name.startswith("tyre") else 2e-4), name
    assert sum(vehicle_signals.loads(at_rest)) == pytest.approx(1513.4 * 9.81, rel=1e-12)


def test_the_rack_steers_the_wheels_as_the_data_say() -> None:
    state = vehicle(rack=fx.Polynomial((0.002,))).initial
    for corner, degrees in vehicle_data.RACK_STEER.items():
        R = matrix(state.position(f"{corner} upright"))
        kingpin = state.position(f"{corner} upper ball") - state.position(f"{corner} lower ball")
        kingpin /= np.linalg.norm(kingpin)
        turned = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
        assert np.degrees(np.arcsin(turned @ kingpin)) == pytest.approx(degrees, abs=1e-2)


def test_there_are_ten_dofs_and_eight_without_lateral_slip() -> None:
    assert vehicle().counts["degrees_of_freedom"] == 10
    rolling = vehicle(10.0, tyres="zero slip")
    assert (rolling.counts["degrees_of_freedom"], rolling.counts["kinematic_coordinates"]) == (8, 2)


@pytest.mark.parametrize("tyres", ["calspan", "linear", "zero slip"])
def test_the_linearization_is_the_derivative_of_the_nonlinear_equations(tyres: str) -> None:
    system, state = vehicle_runs.straight(20.0, tyres)
    assert mismatch(system, state) < 1e-8


def test_modes_at_20_are_near_those_of_the_symmetric_model() -> None:
    lin = vehicle_runs.linear(20.0)[1]
    assert vehicle_table.named(lin) == pytest.approx(list(vehicle_data.SYMMETRIC), abs=0.06)
    names = {vehicle_runs.mode_name(mode) for mode in lin.modes() if mode.eigenvalue.imag > 1e-6}
    assert {"hop bounce", "hop pitch", "hop roll", "hop warp", "bounce", "pitch", "roll"} <= names
    bare = vehicle_runs.linear(20.0, "vertical")[1]
    assert vehicle_table.named(bare) == pytest.approx(list(vehicle_data.SYMMETRIC_NO_SIDE_FORCE), abs=0.01)
    others = vehicle_data.NO_SIDE_FORCE
    assert vehicle_table.named(bare, others) == pytest.approx(list(others.values()), abs=0.012)


def test_steering_follows_the_other_program(benchmark: dict[str, Any]) -> None:
    run = benchmark["robotran_time_histories"]["runs"]["RampToSteer_30ms"]
    motion = vehicle_runs.steer(30.0, seconds=1.01)
    for k, t in enumerate(run["t"]):
        if t in (0.6, 0.8, 1.0):
            state = motion.at(t + vehicle_data.ROUNDED / 2)  # the rounded ramp is that much later
            assert vehicle_signals.yaw_rate(state) == pytest.approx(run["yaw_rate"][k], rel=2e-3)
            assert vehicle_signals.lateral_acceleration(state) == pytest.approx(run["ay_body"][k], rel=5e-3)
            loads = [run[f"F_{wheel}"][k] for wheel in ("FL", "FR", "RL", "RR")]
            assert vehicle_signals.loads(state) == pytest.approx(loads, rel=5e-3)


def test_axles_that_do_not_slip_do_not_slip() -> None:
    motion = vehicle_runs.steer(20.0, "zero slip", seconds=0.6)
    for axle in vehicle_data.AXLES:
        assert np.abs(motion.rate(f"{axle} slip.lateral")).max() < 1e-12
    speed = vehicle_signals.history(motion, "speed")
    assert speed[-1] == pytest.approx(20.0, abs=1e-2)


def test_energy_goes_into_dampers_and_comes_from_what_drives() -> None:
    gap = vehicle_runs.energy_gap(
        lambda times: vehicle_runs.bump(5.0, seconds=0.2, times=times, rtol=1e-8), 0.2, 12
    )
    assert gap < 1e-5


def test_wheels_leave_the_road_and_tyres_their_data_by_name() -> None:
    motion = vehicle_runs.bump(10.0, seconds=0.75)
    assert {"front right", "front left"} <= set(vehicle_signals.lifted(motion))
    assert any(
        line.startswith("front left tyre") and "end at 12930 N" in line
        for line in outside(motion.system, list(motion))
    )
    assert (
        max(motion[f"{CORNERS[0]} leaf.across2"]) > vehicle_data.LEAF_LENGTH - vehicle_data.LEAF_STOP
    )  # the stop


def test_locked_wheels_slide_without_braking_on_tyres_without_longitudinal_force() -> None:
    system = vehicle(10.0, spinning=False)
    motion = system.simulate(
        0.1, start=vehicle_runs.start(system, 10.0), samples=3, method="DOP853", rtol=1e-6
    )
    assert motion[-1].rate("front left tyre.longitudinal") == pytest.approx(10.0, abs=0.1)
    assert motion[-1].force("front left tyre.longitudinal") == 0.0


def test_a_rack_that_the_tie_rods_cannot_follow_is_refused_by_name() -> None:
    with pytest.raises(fx.PositionError, match=r"front (left|right)"):
        vehicle(rack=fx.Polynomial((0.9,)))
    with pytest.raises(fx.ModelError, match=r"tyres 'square' are unknown; choose one of calspan, linear"):
        vehicle(tyres="square")


@pytest.mark.long
def test_a_rack_that_runs_out_of_reach_is_named_with_its_time() -> None:
    """Half a metre in a second: the tie rods come into line with the uprights, in whatever degrees of freedom."""
    system = vehicle(5.0, rack=fx.Polynomial((0.0, 0.5)))
    begin = vehicle_runs.start(system, 5.0)
    said = r"failed at t = 0\.374\d* s: the step has become too short; .* check what drives 'front right rack.across1'"
    with pytest.raises(fx.DynamicsError, match=said) as caught:
        system.simulate(1.0, start=begin, method="Radau", rtol=1e-4)
    assert any("computed up to t = 0.374" in note for note in caught.value.__notes__)


def test_steering_beyond_what_the_road_can_hold_slides() -> None:
    """Nearly 30 mm of the rack at 30 m/s: the front tyres give what friction allows, and the vehicle ploughs on."""
    system = vehicle(30.0, rack=fx.Polynomial((0.0, 0.04)))
    begin = vehicle_runs.start(system, 30.0)
    end = system.simulate(0.7, start=begin, samples=2, method="DOP853", rtol=1e-5)[-1]
    B1, B3, B4 = vehicle_data.CALSPAN["B"]
    for corner, load in zip(CORNERS[:2], vehicle_signals.loads(end)[:2], strict=True):
        friction = vehicle_data.CALSPAN["SN"] * (B1 * load + B3 + B4 * load**2) * load
        side = abs(end.force(f"{corner} tyre.lateral"))
        assert 0.95 * friction < side <= friction * (1 + 1e-12)


def test_a_locked_wheel_on_tyres_that_brake_stops_the_wheel_not_the_program() -> None:
    """A motorcycle whose rear wheel is blocked at 20 m/s: it slides with its friction and keeps upright."""
    system = motorcycle.motorcycle(20.0)
    start = motorcycle.straight(system, 20.0)
    locked = system.state_at({}, {"rear spin.angle": 0.0} | {
        name: start.rate(name) for name in system.dynamic if name != "rear spin.angle"
    }, start=start)  # fmt: skip
    state = system.simulate(0.004, start=locked, rtol=1e-8)[-1]
    assert state.force("rear tyre.longitudinal") > 0  # against the sliding
    assert state.rate("rear spin.angle") > 0  # and it is spun up again
    assert state.acceleration("frame.x") < 0


def test_a_motorcycle_weaves_wobbles_and_capsizes() -> None:
    slow, fast = motorcycle.loci((20.0, 50.0))
    assert (
        1.5
        < slow["weave"].eigenvalue.imag / (2 * np.pi)
        < 4
        < fast["wobble"].eigenvalue.imag / (2 * np.pi)
        < 10
    )
    assert fast["weave"].damping < 0.1 < slow["weave"].damping
    assert slow["wobble"].eigenvalue.real < 0 < fast["wobble"].eigenvalue.real
    assert 0 < fast["capsize"].eigenvalue.real < slow["capsize"].eigenvalue.real
    system = motorcycle.motorcycle()
    assert mismatch(system, motorcycle.straight(system, 30.0)) < 1e-8
    assert system.counts["degrees_of_freedom"] == 11


def test_tyres_with_and_without_a_crown_carry_the_bicycle_of_the_benchmark() -> None:
    for quantity in motorcycle.confirmations():
        assert quantity.ok, quantity
    published = np.array(EIGENVALUES[5])
    errors = [
        np.abs(motorcycle.nearest(motorcycle.bicycle_on_tyres(5.0, 0.0, k), published) - published).max()
        for k in (1e6, 1e7)
    ]
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.05)  # softness goes as one over the stiffness
