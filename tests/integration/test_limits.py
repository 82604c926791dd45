"""Motions near a limit of their model say so: wheels that would lift, ropes at their ends, singular positions."""

import re
import warnings
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from linkages import parallel

import flexel as fx
from flexel.integration.outcome import States
from flexel.integration.rope_ends import at_their_ends

G, RADIUS, THIN = 9.81, 0.1, 2e-3


def lifted(force: Any) -> fx.System:
    """A wheel of 2 kg that rolls along x, pulled up by a force [N]."""
    m = fx.Model(gravity=(0, 0, -G))
    m.point("hub", (0, 0, 0.3))
    m.point("contact", (0, 0, 0))
    m.frame("F")
    m.body("disc", "hub", "F", mass=2.0, inertia=(0.05, 0.09, 0.05))
    m.wheel("front", "hub", "F", "contact", radius=0.3, axle=(0, 1, 0))
    m.load("hub.z", force)
    return m.build()


def growing(most: float) -> fx.System:
    """The same, with a force that grows to `most` times the weight in a second."""
    return lifted(lambda t: most * 2.0 * G * t)


@pytest.mark.parametrize("method", ["DOP853", "generalized-alpha"])
def test_a_wheel_that_pulls_on_the_road_is_named_with_its_force(method: str) -> None:
    """It pulls by the lifting force less the weight."""
    with pytest.warns(
        fx.AuditWarning, match=r"wheel 'front' pulls on the road by 9\.81 N at t = 1 s"
    ) as said:
        motion = growing(1.5).simulate(1.0, samples=11, method=method, progress=False)
    assert len(said) == 1 and "m.tyre" in motion.warnings[0] and motion.warnings[0] in motion.message
    assert motion[-1].force("front.surface") == pytest.approx(0.5 * 2.0 * G, rel=1e-6)
    assert growing(0.99).simulate(1.0, samples=11, method=method, progress=False).warnings == ()


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
@pytest.mark.parametrize("complete", [False, True])
def test_a_wheel_that_pulls_for_a_moment_is_named(method: str, complete: bool) -> None:
    """For 0.07 s of one, between the five states looked at before; for 0.02 s where all states are complete."""
    times, forces = [0.0, 0.575, 0.625, 0.675, 1.0], [0.0, 0.0, 6.0 * G, 0.0, 0.0]
    bell = lifted(lambda t: 6.0 * G * np.exp(-(((t - 0.625) / 0.01) ** 2)))
    system = bell if complete else lifted(fx.Table(times, forces, kind="linear"))
    with pytest.warns(fx.AuditWarning, match=r"wheel 'front' pulls on the road by .* N at t = 0\.6"):
        system.simulate(1.0, samples=201, method=method, progress=False)


def test_a_wheel_whose_height_is_released_does_not_pull() -> None:
    m = fx.Model(gravity=(0, 0, -G))
    m.point("hub", (0, 0, 0.3))
    m.point("contact", (0, 0, 0))
    m.frame("F")
    m.body("disc", "hub", "F", mass=2.0, inertia=(0.05, 0.09, 0.05))
    m.wheel("front", "hub", "F", "contact", radius=0.3, axle=(0, 1, 0))
    m.release("front.surface")
    m.spring("front.surface", 1e4, 100.0)
    m.load("hub.z", 3.0 * G)
    assert m.build().simulate(0.2, samples=11, progress=False).warnings == ()


CONTACT = fx.Contact(1e8, dissipation=10.0)
ROPE: dict[str, Any] = {
    "contact": CONTACT, "radius": THIN, "EA": 1e4, "EI": 1e-3, "mass_per_length": 0.05, "damping": 1e-3,
}  # fmt: skip


def sunk(depth: float) -> fx.System:
    """A taut rope over a sheave that sinks by a depth in 0.1 s."""
    m = fx.Model()
    m.point("C", (0, -0.08))
    m.fix("C.x")
    m.prescribe("C.y", lambda t: -0.08 - depth * (1 - np.cos(np.pi * t / 0.1)) / 2)
    m.angle("F", fixed=True)
    m.sheave("S", "C", "F", radius=RADIUS)
    m.point("A", (-0.3, 0), fixed=True)
    m.point("B", (0.3, 0), fixed=True)
    m.rope("rope", ["A", "S", "B"], 14, tension=50.0, **ROPE)
    return m.build()


@pytest.mark.long
def test_a_rope_that_leaves_its_sheave_is_named() -> None:
    """It is straight when the sheave has sunk by 22 mm, the height by which it was held up."""
    with pytest.warns(fx.AuditWarning, match=r"rope 'rope' has left 'S' at t = 0\.0\d+ s: no point") as said:
        sunk(0.06).simulate(0.1, samples=51, method="generalized-alpha", progress=False)
    assert len(said) == 1
    assert sunk(0.005).simulate(0.1, samples=51, method="generalized-alpha", progress=False).warnings == ()


def drawn_over(duration: float) -> fx.Motion:
    """A rope over a sheave that a mass of 1 kg pulls down on one side; the other end is 0.2 m below the axle."""
    m = fx.Model(gravity=(0, -G))
    m.point("C", (0, 0), fixed=True)
    m.angle("F", fixed=True)
    m.sheave("S", "C", "F", radius=RADIUS)
    for name, x, mass in (("A", -RADIUS - THIN, 0.1), ("B", RADIUS + THIN, 1.0)):
        m.point(name, (x, -0.2))
        m.point_mass(f"mass {name}", name, mass)
    m.rope("rope", ["A", "S", "B"], 18, tension=0.1 * G, **ROPE)
    return m.build().simulate(duration, samples=81, method="generalized-alpha", progress=False)


def test_a_rope_that_runs_to_its_end_on_a_sheave_is_named() -> None:
    """Masses of 1 and 0.1 kg with a rope of 36 g accelerate it by about 7.8 m/s2: its end is there after 0.23 s."""
    assert drawn_over(0.15).warnings == ()
    with pytest.warns(fx.AuditWarning, match="rope 'rope' has run to its end on 'S' at t = ") as said:
        drawn_over(0.3)
    found = [str(warning.message) for warning in said if "to its end" in str(warning.message)]
    when = float(found[0].split("t = ")[1].split(" s")[0])
    assert "its last element 'rope1' touches it" in found[0]
    assert 0.19 < when < 0.24  # the last element is 41 mm long


def test_a_drum_that_runs_empty_is_named() -> None:
    """The last element of its rope lies on it at the start."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("F", fixed=True)
    m.sheave("drum", "C", "F", radius=RADIUS)
    m.point("B", (RADIUS + THIN, -0.5), fixed=True)
    rope = m.rope("rope", ["drum", "B"], 24, tension=10.0, turns=0.5, **ROPE)
    s = m.build()
    e = np.array([s.initial.e] * 3)
    assert (
        list(at_their_ends(s.structure, cast(States, SimpleNamespace(deformations=e, times=[0, 1, 2])))) == []
    )
    names = [s.structure.names.index(f"{point.element}.gap") for point in rope.contacts["drum"]]
    last = [row for row, point in zip(names, rope.contacts["drum"], strict=True) if point.cable == "rope1"]
    e[2, last] = 0.01
    said = list(at_their_ends(s.structure, cast(States, SimpleNamespace(deformations=e, times=[0, 1, 2]))))
    assert len(said) == 1 and said[0].startswith(
        "rope 'rope' has run off 'drum' to its end at t = 2 s: its last element 'rope1'"
    )


def nearly_parallel(misfit: float) -> fx.System:
    """A parallelogram whose pivots are too far apart by a misfit [m]."""
    m = fx.Model(gravity=(0, -G))
    base = 1.0 + misfit
    diagonal = np.hypot(base, 1.0)
    across = np.array([1.0, base]) / diagonal * np.sqrt(1 - diagonal**2 / 4)
    m.point("O", (0, 0), fixed=True)
    m.point("P", (base, 0), fixed=True)
    m.point("A", (0, 1))
    m.point("B", tuple(np.array([base, 1.0]) / 2 + across))
    for p, q in (("O", "A"), ("P", "B"), ("A", "B")):
        m.beam(f"bar {p}{q}", p, m.angle(f"R{p}{q}"), q, mass_per_length=1.0)
    return m.build()


def test_a_position_that_is_nearly_singular_is_named() -> None:
    """The bars line up but for a thousandth of a degree; where they do so exactly, or clearly not, all is well."""
    for misfit, near in ((1e-10, True), (1e-4, False)):
        system = nearly_parallel(misfit)
        start = system.state_at(rates={"A.x": 2.0})
        options: dict[str, Any] = {"start": start, "method": "DOP853", "samples": 3, "progress": False}
        if not near:
            assert system.simulate(0.7, **options).warnings == ()
            continue
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", fx.AuditWarning)  # energy may be lost there, too
            motion = system.simulate(0.7, **options)
        told = "\n".join(motion.warnings)
        found = re.search(
            r"the position is nearly singular at t = 0\.5\d* s: coordinates change (\S+) times", told
        )
        assert found is not None
        change = float(found[1])
        assert 1e4 < change < 1e-10**-0.5 * 10
    exact = parallel([1.0]).system()
    start = exact.state_at(rates={"A0.x": 2.0})
    assert exact.simulate(0.7, start=start, method="DOP853", samples=3, progress=False).warnings == ()
