"""States within the steps of DOP853: the same digits whenever they are asked for, and right between the stages."""

import pickle
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from wheels import MAGIC, MAGIC_ON, H, K, wheel

import flexel as fx
from flexel.examples.bicycle import bicycle, kick

Motion = Callable[[], fx.Motion]


def rolling() -> fx.Motion:
    """Rolling conditions, periodic angles, and degrees of freedom that change."""
    system = bicycle()
    return system.simulate(3.0, start=kick(system, 4.5, 0.05)[0], samples=121, method="DOP853")


def tumbling() -> fx.Motion:
    """An orientation that turns freely."""
    m = fx.Model()
    m.rigid_body("stone", (0, 0, 0), mass=1.0, inertia=(1.0, 2.0, 3.0))
    system = m.build()
    rng = np.random.default_rng(5)
    rates = dict(zip(system.dynamic, rng.normal(size=len(system.dynamic)), strict=True))
    return system.simulate(4.0, start=system.state_at(rates=rates), samples=101, method="DOP853")


def slipping() -> fx.Motion:
    """Internal states of a law."""
    m = wheel(z=H)
    m.attach("magic_formula", MAGIC_ON, name="rubber", stiffness=K, damping=0.0, **MAGIC)
    for name, rate in (("hub.x", 10.0), ("hub.y", 0.5)):
        m.initial(name, rate=rate)
    return m.build().simulate(0.3, samples=61, method="DOP853")


def driven() -> fx.Motion:
    """A prescribed motion and a load with knots."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point("B", (0.3, -1))
    m.fix("A.y")
    m.truss("rod", "A", "B")
    m.rigid("rod.elongation")
    m.point_mass("bob", "B", 1.0)
    m.prescribe("A.x", fx.Table([0, 1, 2, 3], [0, 0.2, -0.1, 0.3]))
    m.load("B.x", fx.Table([0, 0.7, 1.9], [0, 1, -1], kind="step"))
    return m.build().simulate(3.0, samples=91, method="DOP853")


MOTIONS: list[Motion] = [rolling, tumbling, slipping, driven]


def digits(state: fx.State) -> bytes:
    return b"".join(getattr(state, name).tobytes() for name in ("x", "v", "e", "z", "a", "stresses"))


@pytest.mark.parametrize("made", MOTIONS, ids=lambda made: made.__name__)
def test_at_a_stored_time_the_state_is_the_stored_one(made: Motion) -> None:
    """In any order, from a pickle, and in other threads, where the stages of the steps are found anew."""
    motion = made()
    stored = [digits(state) for state in motion]
    order = np.random.default_rng(1).permutation(np.arange(1, len(motion)))  # the start was given
    assert [digits(motion.at(motion.t[i])) for i in order] == [stored[i] for i in order]
    again = pickle.loads(pickle.dumps(motion))
    assert [digits(again.at(t)) for t in motion.t[1::7]] == stored[1::7]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(lambda t: digits(motion.at(t)), motion.t[1:])) == stored[1:]


@pytest.mark.parametrize("made", MOTIONS, ids=lambda made: made.__name__)
def test_between_the_stages_the_motion_is_as_exact_as_at_the_ends_of_steps(made: Motion) -> None:
    """Reference: the same motion with steps that end at every time that is compared."""
    motion = made()
    ends = [segment.t1 for segment in motion._segments]
    fine = motion.system.simulate(
        motion.t[-1], start=motion[0], times=motion.t, method="DOP853", rtol=1e-12, atol=1e-13
    )
    scale = np.ptp(fine.x, axis=0).max()
    off = np.abs(motion.x - fine.x).max(axis=1) / scale
    at_ends = [np.abs(motion.at(t).x - fine.at(t).x).max() / scale for t in ends]
    assert off.max() < 3 * max(at_ends) + 1e-9


def test_events_and_stored_states_change_no_step() -> None:
    system = bicycle()
    start = kick(system, 4.5, 0.05)[0]
    event = fx.Event("upright", lambda s: s["lean.angle"])
    plain = system.simulate(2.0, start=start, samples=2, method="DOP853")
    watched = system.simulate(2.0, start=start, samples=301, method="DOP853", events=[event])
    assert watched.statistics == plain.statistics
    assert np.array_equal(watched[-1].x, plain[-1].x) and watched.events
