"""Steps end where a contact, a stop or a tyre begins and ends to act: forces are smooth within each."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from wheels import CALSPAN, MAGIC, MAGIC_ON, SIDE, K, R, wheel

import flexel as fx

HEIGHT, STIFFNESS, G = 0.1, 1e4, 9.81  # [m], [N/m], [m/s²]; the mass is 1 kg


def falling() -> fx.Model:
    """A mass above the ground that moves up and down."""
    m = fx.Model(gravity=(0, -G))
    m.point("O", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.point("ball", (0, HEIGHT))
    m.fix("ball.x")
    m.point_mass("mass", "ball", 1.0)
    return m


def on_a_floor() -> fx.Model:
    """The floor is a linear spring."""
    m = falling()
    m.plane("floor", "O", "ground", normal=(0, 1))
    m.contact("touch", "ball", "floor", fx.Contact(STIFFNESS, exponent=1.0))
    return m


def on_a_stop() -> fx.Model:
    """The length of a bar from above is limited by a stop that is a linear spring."""
    m = falling()
    m.point("above", (0, 3 * HEIGHT), fixed=True)
    m.truss("bar", "above", "ball")
    m.stop("bar.elongation", HEIGHT, STIFFNESS)
    return m


def on_a_formula() -> fx.Model:
    """The same with the user's own formula."""
    m = falling()
    m.point("above", (0, 3 * HEIGHT), fixed=True)
    m.truss("bar", "above", "ball")
    m.spring("bar.elongation", lambda e: STIFFNESS * sp.Max(0, e - HEIGHT))
    return m


def on_a_curve() -> fx.Model:
    """The same with a curve of two pieces."""
    m = falling()
    m.point("above", (0, 3 * HEIGHT), fixed=True)
    m.truss("bar", "above", "ball")
    m.spring("bar.elongation", fx.Curve([[0.0], [-STIFFNESS * HEIGHT, STIFFNESS]], breaks=[HEIGHT]))
    return m


def between_limits() -> fx.Model:
    """The same by limits of a joint, of which the upper one is not reached."""
    m = falling()
    m.point("below", (0, -HEIGHT), fixed=True)
    m.truss("bar", "below", "ball")
    m.limits("bar.elongation", -HEIGHT, 1.0, STIFFNESS)
    return m


def on_a_tyre() -> fx.Model:
    """A wheel that does not turn, on a tyre that is a linear spring."""
    m = fx.Model(gravity=(0, 0, -G))
    m.point("ball", (0, 0, HEIGHT + 0.3))
    m.fix("ball.x", "ball.y")
    m.frame("wheel", fixed=True)
    m.point_mass("mass", "ball", 1.0)
    m.tyre("tyre", "ball", "wheel", radius=0.3, axle=(0, 1, 0))
    m.attach("vertical_tyre", ["tyre.deflection"], stiffness=STIFFNESS, damping=0.0)
    return m


MODELS: dict[str, tuple[Callable[[], fx.Model], str]] = {
    "floor": (on_a_floor, "ball.y"),
    "stop": (on_a_stop, "ball.y"),
    "formula": (on_a_formula, "ball.y"),
    "curve": (on_a_curve, "ball.y"),
    "limits": (between_limits, "ball.y"),
    "tyre": (on_a_tyre, "ball.z"),
}


def bounced(t: float) -> float:
    """Height of the mass: free fall, and half vibrations about the depth at which it would rest."""
    omega, rest = np.sqrt(STIFFNESS), G / STIFFNESS
    speed, fall = np.sqrt(2 * G * HEIGHT), np.sqrt(2 * HEIGHT / G)
    touch = (np.pi + 2 * np.arctan(rest * omega / speed)) / omega
    t = (t + fall) % (2 * fall + touch)  # from the upward start of a flight
    if t < 2 * fall:
        return float(speed * t - G * t**2 / 2)
    s = omega * (t - 2 * fall)
    return float(rest * (np.cos(s) - 1) - speed / omega * np.sin(s))


def error_of_bounces(name: str, method: str, rtol: float) -> float:
    """Largest error of ten bounces on a linear spring, relative to their range, against the closed form."""
    make, height = MODELS[name]
    motion = make().build().simulate(3.0, rtol=rtol, method=method)
    found = motion[height] - motion[height][0]
    error = np.abs(found - [bounced(t) - bounced(0.0) for t in motion.t])
    assert found.min() < -HEIGHT
    return float(error.max() / np.ptp(found))


@pytest.mark.parametrize("rtol", [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9])
@pytest.mark.parametrize("name", MODELS)
def test_bounces_keep_to_the_tolerance(name: str, rtol: float) -> None:
    assert error_of_bounces(name, "DOP853", rtol) < 20 * rtol


@pytest.mark.parametrize("rtol", [1e-3, 1e-4, 1e-5, 1e-6])
@pytest.mark.parametrize("name", MODELS)
@pytest.mark.filterwarnings("ignore::flexel.DampingWarning")  # of 5 %, at rtol = 1e-3
def test_bounces_by_generalized_alpha_have_errors_of_second_order(name: str, rtol: float) -> None:
    """Local errors are of third order; with steps across the beginnings of contacts 200 times this power of rtol."""
    assert error_of_bounces(name, "generalized-alpha", rtol) < 30 * rtol ** (2 / 3)


def test_the_level_of_a_stop_is_that_of_the_variant() -> None:
    """Motions of variants are those of models that are built with their numbers, to the last bit."""

    def stopped(gap: float) -> fx.System:
        m = falling()
        m.point("above", (0, 3 * HEIGHT), fixed=True)
        m.truss("bar", "above", "ball")
        m.stop("bar.elongation", gap, STIFFNESS)
        return m.build()

    gaps = [0.5 * HEIGHT, 0.8 * HEIGHT]
    system = stopped(HEIGHT)
    (name,) = [name for name in system.parameters if name.endswith("gap")]
    found = system.simulate_many(1.0, parameters={name: gaps}, outputs=["ball.y"])
    for i, gap in enumerate(gaps):
        alone = stopped(gap).simulate(1.0, method="DOP853")
        np.testing.assert_array_equal(found["ball.y"][i], alone["ball.y"])


def over_a_sheave() -> fx.Model:
    """A rope over a sheave that turns, with masses at its ends that are not in balance."""
    m = fx.Model(gravity=(0, -G))
    m.point("C", (0, 0), fixed=True)
    m.angle("ground", fixed=True)
    m.angle("turning")
    m.hinge("axle", "ground", "turning")
    m.body("rim", "C", "turning", mass=1.0, inertia=0.02)
    m.sheave("sheave", "C", "turning", radius=0.2)
    for name, place, mass in (("A", (-0.205, -0.2), 1.0), ("B", (0.205, -0.15), 1.3)):
        m.point(name, place)
        m.point_mass(f"mass {name}", name, mass)
    contact = fx.Contact(1e5, exponent=1.5)
    data = {"EA": 1500.0, "EI": 0.4, "mass_per_length": 0.3, "radius": 5e-3, "tension": 10.0}
    m.rope("rope", ["A", "sheave", "B"], 8, contact=contact, **data)
    return m


def test_a_smooth_curve_ends_no_step() -> None:
    """A table through which a curve with a continuous slope passes; its slope jumps at one of two breaks otherwise."""
    smooth = fx.Curve.through([-1.0, 0.0, 1.0], [-2.0, 0.0, 3.0])
    assert np.all(smooth.parameters(0.0)["kinks"] > 1e100)
    pieces = fx.Curve([[0.0, 1.0], [0.0, 1.0], [-1.0, 2.0]], breaks=[0.0, 1.0])
    kinks = pieces.parameters(0.25)["kinks"]
    assert kinks[1] == 0.75
    assert np.all(np.delete(kinks, 1) > 1e100)


@pytest.mark.long
def test_steps_end_where_points_of_a_rope_begin_to_touch() -> None:
    """3 rtol of the largest range of a rate at most; with steps across such instants 0.6 to 7, by chance."""
    system = over_a_sheave().build()
    exact = system.simulate(0.014, method="DOP853", rtol=1e-11, samples=31).v
    for rtol in (1e-6, 3e-7, 1e-7, 3e-8, 1e-8):
        found = system.simulate(0.014, method="DOP853", rtol=rtol, samples=31).v
        assert np.max(np.abs(found - exact)) < 3 * rtol * np.max(np.ptp(exact, axis=0))


@pytest.mark.long
def test_a_stiff_motion_with_contacts_is_tried_by_radau() -> None:
    """A hard damper on the rope: generalized-alpha, which was taken, is off by 2 % of the largest rate."""
    m = over_a_sheave()
    m.point("end", (0.5, -0.15), fixed=True)
    m.truss("dash", "B", "end")
    m.spring("dash.elongation", damping=1e7)
    system = m.build()
    exact = system.simulate(0.02, method="Radau", rtol=1e-10, samples=21).v
    motion = system.simulate(0.02, samples=21)
    assert "Radau, chosen because" in motion.message
    assert np.max(np.abs(motion.v - exact)) < 20e-6 * np.max(np.ptp(exact, axis=0))


@pytest.mark.parametrize(("friction", "steps"), [(0.0, 300), (0.5, 800)])
def test_a_mass_on_a_plane_that_turns_needs_no_shorter_steps(friction: float, steps: int) -> None:
    """It slides on a turntable at 2 rad/s: the chord of a step leaves the plane, the mass does not."""
    m = fx.Model(gravity=(0, 0, -G))
    m.point("axis", (0, 0, 0), fixed=True)
    m.frame("table")
    m.hinge("drive", m.frame("ground", fixed=True), "table", axis=(0, 0, 1))
    m.prescribe("drive.angle", fx.Polynomial([0.0, 2.0]))
    m.plane("top", "axis", "table", normal=(0, 0, 1))
    P = m.point("P", (0.5, 0, 0.05 - (0.3 * G / 1e7) ** (2 / 3)))
    m.point_mass("mass", P, 0.3)
    m.initial("P.y", rate=0.5)
    m.contact("touch", P, "top", fx.Contact(1e7, friction=friction, slip_speed=1e-3), radius=0.05)
    system = m.build()
    motion = system.simulate(2.0, samples=2, method="generalized-alpha")
    assert motion.statistics["steps"] < steps and motion.statistics["rejected"] < 20
    exact = system.simulate(2.0, samples=2, method="DOP853")
    for name in ("P.x", "P.y"):
        assert motion[name][-1] == pytest.approx(exact[name][-1], abs=5e-5)


@pytest.mark.parametrize(
    ("law", "on", "given", "load"),
    [
        ("magic_formula", MAGIC_ON, MAGIC, 2 * MAGIC["load0"]),
        ("calspan_tyre", SIDE, CALSPAN, CALSPAN["A"][2]),
    ],
)
@pytest.mark.filterwarnings("ignore::flexel.RangeWarning")  # the data of the CALSPAN tyre end there
def test_a_step_ends_where_the_friction_of_a_tyre_no_longer_depends_on_the_load(
    law: str, on: list[str], given: dict[str, Any], load: float
) -> None:
    """A wheel that has been pressed on the road, and lets go of it."""
    m = wheel(z=R - 1.5 * load / K)
    m.attach(law, on, name="rubber", stiffness=K, damping=100.0, **given)
    m.initial("hub.x", rate=3.0)
    m.initial("hub.y", rate=0.2)
    motion = m.build().simulate(0.05, samples=2, method="DOP853")
    ends = [motion.at(step.t1) for step in motion._segments]
    loads = np.array([K * s["tyre.deflection"] + 100.0 * s.rate("tyre.deflection") for s in ends])
    assert loads.max() > load > loads.min()
    assert np.abs(loads / load - 1).min() < 1e-6
