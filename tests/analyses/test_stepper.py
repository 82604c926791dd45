"""A system in steps of somebody else's loop."""

import pickle

import numpy as np
import pytest

import flexel as fx


def arm(push: float = 0.0) -> fx.System:
    """A damped arm of 1 m on a hinge under gravity, with a force at its tip."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("arm")
    m.point("tip", (1, 0))
    m.hinge("motor", "ground", "arm")
    m.beam("rod", "O", "arm", "tip", mass_per_length=2)
    m.spring("motor.angle", 0.0, 0.1)
    if push:
        m.load("motor.angle", push)
    return m.build()


@pytest.mark.parametrize(
    ("method", "tolerance"), [("DOP853", 1e-8), ("Radau", 1e-8), ("generalized-alpha", 1e-4)]
)
def test_a_held_input_is_a_load(method: str, tolerance: float) -> None:
    """Steps with a constant input end where a simulation with that load does; rates and times too."""
    stepper = arm().stepper(
        0.05, inputs=["motor.angle"], outputs=["tip.y", "tip.y'"], method=method, rtol=1e-9
    )
    for _ in range(20):
        found = stepper.step([15.0])
    reference = arm(15.0).simulate(1.0, method="DOP853")[-1]
    assert stepper.t == pytest.approx(1.0, abs=1e-15)
    assert found == pytest.approx([reference["tip.y"], reference.rate("tip.y")], abs=10 * tolerance)
    assert stepper["motor.angle"] == pytest.approx(reference["motor.angle"], abs=tolerance)
    assert stepper.state.acceleration("motor.angle") == pytest.approx(
        reference.acceleration("motor.angle"), abs=100 * tolerance
    )


def test_inputs_change_between_steps() -> None:
    """A staircase of inputs ends where pieces of simulations end, each from the last."""
    stepper = arm().stepper(0.1, inputs=["motor.angle"], rtol=1e-10)
    start: fx.State | None = None
    for push in (5.0, -8.0, 20.0):
        stepper.step([push])
        system = arm(push)
        start = system.simulate(0.1, start=start and system.restore(start), method="DOP853")[-1]
    assert start is not None
    assert stepper.state.x == pytest.approx(start.x, abs=1e-9)


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_what_was_saved_is_restored(method: str) -> None:
    """The same steps from there give the same digits, also from a pickle, in another stepper."""
    stepper = arm().stepper(0.05, inputs=["motor.angle"], outputs=["tip.x"], method=method)
    for _ in range(7):
        stepper.step([3.0])
    saved = stepper.save()

    def further(it: fx.Stepper, where: object) -> list[float]:
        it.restore(where)  # type: ignore[arg-type]
        return [float(it.step()[0]) for _ in range(6)]

    once = further(stepper, saved)
    assert further(stepper, saved) == once
    other = arm().stepper(0.05, inputs=["motor.angle"], outputs=["tip.x"], method=method)
    assert further(other, pickle.loads(pickle.dumps(saved))) == once
    assert stepper.reset() == pytest.approx([1.0], abs=1e-15) and stepper.t == 0.0


def chain(stiffness: float) -> fx.System:
    """Two damped springs in a row that carry a light mass and a heavy one, free to swing in the plane."""
    m = fx.Model(gravity=(0, -9.81))
    ends = [m.point("O", (0, 0), fixed=True), m.point("A", (1, 0)), m.point("B", (2, 0))]
    for i in (0, 1):
        m.truss(f"spring {i}", ends[i], ends[i + 1], stiffness=stiffness, damping=1e-4 * stiffness)
        m.point_mass(f"mass {i}", ends[i + 1], (0.01, 1.0)[i])
    return m.build()


def test_a_stiff_system_goes_on_with_radau_by_default() -> None:
    """From the second step on, in which DOP853 would take 560 steps; where it was is in what is saved."""
    stiff = chain(1e7)
    stepper, radau = (
        stiff.stepper(0.01, inputs=["B.x"], outputs=["B.x"], **kind) for kind in ({}, {"method": "Radau"})
    )
    assert stepper.method == "DOP853"
    for i in range(40):
        found, wanted = (one.step([np.sin(0.05 * i)]) for one in (stepper, radau))
    assert stepper.method == "Radau" and "Radau" in repr(stepper)
    assert found == pytest.approx(wanted, abs=1e-6)
    saved = pickle.loads(pickle.dumps(stepper.save()))
    once = [float(stepper.step()[0]) for _ in range(5)]
    again = stiff.stepper(0.01, inputs=["B.x"], outputs=["B.x"])
    again.restore(saved)
    assert again.method == "Radau" and [float(again.step()[0]) for _ in range(5)] == pytest.approx(
        once, abs=1e-7
    )
    stepper.reset()
    assert stepper.method == "DOP853"


def test_other_systems_stay_with_dop853_or_have_generalized_alpha_by_default() -> None:
    stepper = chain(1e3).stepper(0.01, inputs=["B.x"])
    for _ in range(600):
        stepper.step()
    assert stepper.method == "DOP853"
    m = fx.Model()
    m.truss(
        "spring", m.point("O", (0.0, 0.0), fixed=True), m.point("P", (1.0, 0.0)), stiffness=10.0, damping=1.0
    )
    m.truss("next", "P", m.point("Q", (2.0, 0.0)), stiffness=10.0)
    m.point_mass("mass", "Q", 1.0)
    m.fix("P.y", "Q.y")
    without_inertia = m.build().stepper(0.1, inputs=["Q.x"], outputs=["Q.x"])
    without_inertia.step([1.0])
    assert without_inertia.method == "generalized-alpha"


def test_inputs_by_name_stay() -> None:
    stepper = arm().stepper(0.1, inputs=["motor.angle", "tip.x"])
    stepper["motor.angle"] = 9.81
    stepper.step()
    assert abs(stepper["motor.angle"]) < 1e-9  # the weight of the rod is held
    stepper.step([0.0, 0.0])
    assert stepper["motor.angle'"] < -0.5


def test_bad_input_is_refused() -> None:
    """By name; the stepper stays where it was."""
    system = arm()
    stepper = system.stepper(0.1, inputs=["motor.angle"])
    for call, what in (
        (lambda: system.stepper(0.0), "dt 0 is not positive"),
        (lambda: system.stepper(0.1, inputs=["moter.angle"]), "motor.angle"),
        (lambda: system.stepper(0.1, outputs=["force:tip.x"]), "stepper.state"),
        (lambda: system.stepper(0.1, outputs=["tip.x''"]), "stepper.state"),
        (lambda: system.stepper(0.1, method="RK45"), "DOP853, Radau, generalized-alpha"),
        (lambda: system.stepper(0.1, rtol=-1.0), "rtol"),
        (lambda: stepper.step([1.0, 2.0]), "inputs"),
        (lambda: stepper.step([np.nan]), "inputs"),
        (lambda: stepper.__setitem__("tip.x", 1.0), "not one of its inputs"),
        (lambda: stepper.restore(3), "what save"),  # type: ignore[arg-type]
    ):
        with pytest.raises(fx.FlexelError, match=what):
            call()  # type: ignore[no-untyped-call]
    assert stepper.t == 0.0
    m = fx.Model()
    m.point_mass("mass", m.point("P", (0.0, 0.0)), 1.0)
    m.prescribe("P.x", fx.Ramp(0, 1, 0, 5))
    m.fix("P.y")
    with pytest.raises(fx.ModelError, match="every motion of the system is prescribed"):
        m.build().stepper(0.1)


def test_a_bicycle_is_balanced_by_steering() -> None:
    """It falls over by itself, and rides on with a regulator; the environment passes the checks of Gymnasium."""
    gymnasium = pytest.importorskip("gymnasium", reason="gymnasium is not installed")
    from gymnasium.utils.env_checker import check_env

    from flexel.examples.balance import BicycleEnv, regulator, ride

    env = BicycleEnv()
    assert isinstance(env, gymnasium.Env)
    free, steered = ride(env, lambda observed: np.zeros(1)), ride(env, regulator(env.system))
    assert len(free) < 150 and abs(free[-1, 0]) > 0.5
    assert len(steered) == 501 and np.max(np.abs(steered[-1])) < 1e-4
    check_env(env, skip_render_check=True)
