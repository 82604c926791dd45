"""Linkages of several kinds and loops through their change points, against the equation of their one angle."""

import logging
from typing import Any

import numpy as np
import pytest
from linkages import LINKAGES, Linkage, parallel
from scipy.integrate import solve_ivp
from spatial_linkages import SPATIAL

import flexel as fx

DURATION = 4.0
EVERY = LINKAGES | SPATIAL
ALL = [pytest.mark.campaign, pytest.mark.slow]


def flown(
    linkage: Linkage, system: fx.System, rate: float, times: Any, **options: Any
) -> tuple[fx.Motion, float]:
    """A motion from a rate of the angle, and its largest error."""
    point = next(name for name in linkage.places if name.startswith("A"))
    start = system.state_at(rates={f"{point}.x": rate * linkage.rate(f"{point}.x")})
    motion = system.simulate(DURATION, start=start, times=times, progress=False, **options)
    return motion, linkage.error(motion, linkage.follow(rate, times))


# Bounds are the tolerance times what a perturbation grows by: these swing over their upper dead points. With the
# tightest tolerance it is rounding that grows: where a position is flat, a coordinate is known to the root of that of
# a length.
BOUNDS: list[tuple[str, dict[str, float], float]] = [
    ("DOP853", {}, 1e-6),
    ("DOP853", {"rtol": 1e-6}, 2e-3),
    ("DOP853", {"rtol": 1e-10}, 1e-7),
    ("DOP853", {"rtol": 1e-12}, float(np.sqrt(np.finfo(float).eps))),
    ("Radau", {"rtol": 1e-8}, 1e-5),
]
RATES = (-1.3, 0.4, 2.7, -5.0)


def cases() -> list[Any]:
    """One motion of every second linkage always, of the others in `make test-all`, the rest in the campaign."""
    found = []
    for number, name in enumerate(EVERY):
        for i, (method, options, bound) in enumerate(BOUNDS):
            for j, rate in enumerate(RATES):
                marks = ([pytest.mark.long] if number % 2 else []) if i == j == number % 4 else ALL
                found.append(pytest.param(name, method, options, bound, rate, marks=marks))
    return found


@pytest.mark.parametrize(("name", "method", "options", "bound", "rate"), cases())
def test_linkages_keep_their_branch_through_change_points(
    name: str, method: str, options: dict[str, float], bound: float, rate: float
) -> None:
    linkage = EVERY[name]()
    motion, error = flown(
        linkage, linkage.system(), rate, np.linspace(0, DURATION, 81), method=method, **options
    )
    assert motion.statistics["carried"] >= 2
    assert error < bound


@pytest.mark.parametrize("loops", [pytest.param(n, marks=[] if n == 4 else ALL) for n in range(1, 16)])
@pytest.mark.parametrize("options", [{}, {"rtol": 1e-6}, {"rtol": 1e-12}])
# a step may end close to a flat position
@pytest.mark.filterwarnings("ignore:.*nearly singular:flexel.base.errors.AuditWarning")
def test_parallelograms_of_any_number_and_pitch(loops: int, options: dict[str, float]) -> None:
    linkage = parallel([1 + 0.3 * np.cos(3 * i) for i in range(loops)])
    system, times = linkage.system(), np.linspace(0, DURATION, 41)
    bound = next(bound for method, some, bound in BOUNDS if method == "DOP853" and some == options)
    for rate in (-0.9, 2.7):
        assert flown(linkage, system, rate, times, method="DOP853", **options)[1] < bound, rate


CLOSE = np.array([-1e-3, -1e-4, -1e-6, -1e-9, 0, 1e-9, 1e-6, 1e-4, 1e-3])


def test_events_and_states_at_a_flat_position_are_as_exact_as_elsewhere() -> None:
    linkage = LINKAGES["kite and parallelogram"]()
    system, rate = linkage.system(), -1.3
    event = fx.Event("flat", lambda s: s["A.y"])
    options: dict[str, Any] = {"method": "DOP853", "rtol": 1e-10}
    motion, _ = flown(linkage, system, rate, np.array([0.0, DURATION]), events=[event], **options)
    flat = np.array([state.t for _, state in motion.events])
    assert flat.size == motion.statistics["carried"] == 5
    assert np.sin(linkage.follow(rate, np.append(flat, DURATION))[:-1]) == pytest.approx(0, abs=1e-8)
    motion, error = flown(linkage, system, rate, flat[0] + CLOSE, **options)
    assert error < 1e-10
    for name in ("A.y", "B.x", "C.x"):
        place = system.structure.names.index(name) - system.structure.m - system.structure.k
        a = np.array([state.a[place] for state in motion])
        straight = np.polynomial.Polynomial.fit(CLOSE, a, 2)
        assert a == pytest.approx(straight(CLOSE), rel=1e-6)
    energy = np.array([state.energy.total for state in motion])
    assert energy / energy[0] == pytest.approx(1, abs=20 * options["rtol"])  # what every motion promises


def test_a_terminal_event_within_a_carried_step_ends_the_motion() -> None:
    linkage = LINKAGES["kite"]()
    event = fx.Event("low", lambda s: s["A.y"] + 0.05, terminal=True)
    motion, _ = flown(
        linkage, linkage.system(), -1.3, np.array([0.0, DURATION]), method="DOP853", events=[event]
    )
    assert motion.statistics["carried"] == 1
    assert motion[-1]["A.y"] == pytest.approx(-0.05, abs=1e-9)
    angle = linkage.follow(-1.3, np.array([0.0, motion.t[-1]]))[-1]
    assert np.sin(angle) == pytest.approx(-0.05, abs=1e-8)


def test_a_carried_motion_says_so(caplog: pytest.LogCaptureFixture) -> None:
    linkage = LINKAGES["kite"]()
    with caplog.at_level(logging.INFO, logger="flexel.simulate"):
        motion, _ = flown(linkage, linkage.system(), -1.3, np.linspace(0, DURATION, 3), method="DOP853")
    said = [message for message in caplog.messages if "carried across a flat position at" in message]
    assert len(said) == motion.statistics["carried"] == 3


@pytest.mark.parametrize("loops", [1, pytest.param(2, marks=ALL), 3])
@pytest.mark.parametrize("beyond", [0.0, 1e-10, -1e-10, 1e-3])
def test_a_motion_that_turns_at_a_change_point_goes_back(loops: int, beyond: float) -> None:
    """Its speed is zero there, or a little before or behind, and the way back is the way that it has come."""
    linkage = parallel([1.0] * loops, start=-1.0)
    inertia, weight = (loops + 1) / 3 + loops, 9.81 * ((loops + 1) / 2 + loops)
    rate = float(np.sqrt(2 * weight * (np.sin(beyond) - np.sin(-1.0)) / inertia))
    times = np.linspace(0, DURATION, 41)
    motion, error = flown(linkage, linkage.system(), rate, times, method="DOP853")
    assert motion.t[-1] == DURATION and motion.warnings == () and error < 1e-8


@pytest.mark.parametrize("after", [1e-3, 0.008])
@pytest.mark.parametrize("rtol", [1e-6, 1e-12])
def test_a_motion_may_start_and_end_close_to_a_change_point(after: float, rtol: float) -> None:
    """The path across it ends beyond the motion, as far behind the change point as it begins before."""
    linkage, rate = parallel([1.0], start=-0.008), 2.0
    times, point = (
        np.array([0.0, (0.008 + after) / rate]),
        next(name for name in linkage.places if name.startswith("A")),
    )
    system = linkage.system()
    start = system.state_at(rates={f"{point}.y": rate * linkage.rate(f"{point}.y")})
    motion = system.simulate(times[-1], start=start, times=times, rtol=rtol, method="DOP853")
    assert linkage.error(motion, linkage.follow(rate, times)) < 1e-9
    assert motion.warnings == () and motion.statistics["evaluations"] < 300


def hit(loops: int, later: float) -> tuple[fx.System, float, float]:
    """Parallelograms that a load hits when they are flat, or later; their rate at the start, and the time [s]."""
    linkage, rate = parallel([1.0] * loops), -2.0
    inertia, weight = (loops + 1) / 3 + loops, 9.81 * ((loops + 1) / 2 + loops)

    def flat(t: float, y: tuple[float, float]) -> float:
        return y[0]

    flat.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(
        lambda t, y: [y[1], -weight / inertia * np.cos(y[0])],
        (0, DURATION),
        [linkage.start, rate],
        method="DOP853",
        rtol=2.3e-14,
        atol=1e-14,
        events=flat,
    )
    time = float(found.t_events[0][0]) + later
    m = linkage.model()
    m.load("A0.y", lambda t: 30.0 * (t > time))
    return m.build(), rate * linkage.rate("A0.x"), time


@pytest.mark.parametrize("loops", [1, 2, 3])
def test_a_force_that_jumps_at_a_change_point_is_refused(loops: int) -> None:
    """The motion is not smooth there: no polynomial goes through both sides."""
    system, rate, time = hit(loops, 0.0)
    words = "too short .* the (position is singular|motion is not smooth) there|position .* cannot be reached"
    with pytest.raises((fx.DynamicsError, fx.PositionError), match=words) as error:
        system.simulate(2.0, start=system.state_at(rates={"A0.x": rate}), method="DOP853", samples=3)
    assert error.value.motion.t[-1] == pytest.approx(time, abs=1e-6)


@pytest.mark.parametrize("loops", [1, 2, 3])
def test_a_force_that_jumps_beside_a_change_point_is_no_obstacle(loops: int) -> None:
    for later in (-0.01, 0.01):
        system, rate, time = hit(loops, later)
        start = system.state_at(rates={"A0.x": rate})
        times = np.array([0.0, time, 2.0])
        motion = system.simulate(2.0, start=start, times=times, method="DOP853", progress=False)
        assert motion.warnings == () and motion.statistics["carried"] >= 2
        done = motion["A0.y"][2] - motion["A0.y"][1]
        energy = motion.energy["kinetic"] + motion.energy["potential"]
        assert energy[1] == pytest.approx(energy[0], rel=1e-8)
        assert motion.verdict.startswith("energy balance") and abs(done) > 0.1
