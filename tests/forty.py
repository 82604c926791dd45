"""Forty mechanisms with the length of a motion of each, stiff and not, on which the meaning of `rtol` is measured."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import controlled
import mechanisms
import moving
import numpy as np

import flexel as fx
from flexel.examples import (
    beams_models,
    bicycle,
    cardan,
    cylinder,
    linkages,
    manipulator,
    motorcycle,
    vehicle_runs,
    warping,
)
from flexel.examples.beams_data import SPIN_SIMO
from flexel.examples.rope_models import swinging
from flexel.examples.slider_crank import slider_crank

Start = tuple[fx.System, fx.State]


@dataclass(frozen=True)
class Forty:
    """A mechanism.

    Attributes
    ----------
    make : callable
        Its system and the state in which the motion starts.
    duration : float
        [s]
    fine : int
        How many times as many steps the references take; more where something may be stepped over.
    atol : float
        Absolute tolerance of the references; larger where rounding in stiff forces is.
    """

    make: Callable[[], Start]
    duration: float
    fine: int = 1
    atol: float = 1e-14


MECHANISMS: dict[str, Forty] = {}


def mechanism(
    duration: float, fine: int = 1, atol: float = 1e-14
) -> Callable[[Callable[[], Any]], Callable[[], Any]]:
    """Register a function that makes a model, a system, or a system with its start."""

    def register(make: Callable[[], Any]) -> Callable[[], Any]:
        def started() -> Start:
            made = make()
            if isinstance(made, fx.Model):
                made = made.build()
            return made if isinstance(made, tuple) else (made, made.initial)

        MECHANISMS[make.__name__.replace("_", " ")] = Forty(started, duration, fine, atol)
        return make

    return register


def ground(gravity: tuple[float, ...] = (0.0, -9.81)) -> fx.Model:
    """A model with a fixed point O and a fixed orientation G."""
    m = fx.Model(gravity=gravity)
    m.point("O", (0.0,) * len(gravity), fixed=True)
    (m.angle if len(gravity) == 2 else m.frame)("G", fixed=True)
    return m


for name, duration in {
    "double_pendulum": 1.0,
    "flexible_arm": 0.5,
    "loop": 1.0,
    "rolling": 1.0,
    "sliding": 0.5,
    "tumbling": 1.0,
    "planar": 0.5,
}.items():
    mechanism(duration)(moving.MODELS[name])
mechanism(0.3, 5)(moving.touching)
mechanism(2.0)(mechanisms.pendulum)
mechanism(0.3)(mechanisms.heavy_top)


@mechanism(1.0)
def disc() -> fx.Model:
    """A disc that rolls and wobbles."""
    return mechanisms.disc(1.1, (2.0, 0.4, -5.0))


@mechanism(0.5)
def spatial_four_bar() -> fx.Model:
    """Crank, coupler and rocker on skew axes."""
    return mechanisms.rssr(universal=True)


@mechanism(0.5)
def rigid_slider_crank() -> fx.Model:
    """Twelve radians a second."""
    return mechanisms.slider_crank("crank hinge.angle")


@mechanism(1.0)
def kicked_bicycle() -> Start:
    """The benchmark bicycle at 4.5 m/s, leaning with 0.5 rad/s."""
    s = bicycle.bicycle()
    return s, s.state_at(rates={"rear hub.x": 4.5, "lean.angle": 0.5, "steer.angle": 0.0})


@mechanism(0.5)
def vehicle() -> Start:
    """The Iltis at 20 m/s, pushed aside."""
    s, start = vehicle_runs.straight(20.0)
    rates = {name: float(start.rate(name)) for name in s.dynamic}
    return s, s.state_at(rates=rates | {"chassis.y": 0.3, "roll.angle": 0.2}, start=start)


@mechanism(0.2)
def leaning_motorcycle() -> Start:
    """The motorcycle at 20 m/s on tyres that lag."""
    s = motorcycle.motorcycle(20.0)
    start = motorcycle.straight(s, 20.0)
    rates = {name: float(start.rate(name)) for name in s.dynamic}
    return s, s.state_at(rates=rates | {"lean.angle": 0.3}, start=start)


@mechanism(0.05, atol=1e-11)
def flexible_slider_crank() -> fx.System:
    """A rod of two beams, the crank prescribed."""
    return slider_crank(150.0)


@mechanism(0.5)
def spun_up_beam() -> fx.System:
    """One element, axially stiff; the first half second of the spin-up."""
    return beams_models.spin_up(1, SPIN_SIMO)


@mechanism(0.1)
def controlled_manipulator() -> fx.System:
    """Two flexible links, the joints commanded and controlled with the gains of rigid links."""
    P, D = np.diag([40.0, 20.0]), np.diag([8.0, 3.0])
    gains = manipulator.Gains(
        np.hstack([P, np.zeros((2, len(manipulator.MEASURED) - 2))]),
        np.hstack([D, np.zeros((2, len(manipulator.MEASURED) - 2))]),
    )
    return manipulator.manipulator(lambda t: 0.3 * t**2, lambda t: -0.2 * t**2, gains)


@mechanism(1.0)
def falling_boom() -> fx.System:
    """A boom whose cylinder is free."""
    return cylinder.falling()


@mechanism(0.3)
def boom_on_oil() -> fx.System:
    """A boom on a stiff column of oil."""
    return cylinder.on_oil()


@mechanism(0.5)
def cardan_shaft() -> fx.System:
    """A universal joint behind an elastic shaft."""
    return cardan.elastic_shaft(0.5, 20.0, 300.0, 0.5)


@mechanism(0.05)
def warping_cantilever() -> fx.System:
    """An I beam of steel whose section warps, under a sudden moment at its end."""
    m = warping.clamped(fx.IBeam(height=0.1, width=0.05, web=4e-3, flange=6e-3), 1.0, 1, held=(0,))
    m.load("R1", (20.0, 0.0, 0.0))
    return m.build()


@mechanism(0.3)
def swinging_cable() -> fx.System:
    """Three cables, let go."""
    return swinging(3)


@mechanism(0.3)
def cart_with_a_pole() -> fx.Model:
    """A cart with a rod that stands on it and falls."""
    m = controlled.cart()
    m.initial("pivot.angle", rate=0.5)
    return m


@mechanism(1.0)
def sampled_carriage() -> fx.Model:
    """A carriage that a sampled controller moves."""
    m = controlled.carriage()
    m.controller([[30.0, 8.0]], inputs=["A.x", "A.x'"], outputs=["A.x"], period=0.05, reference={"A.x": 0.2})
    return m


def along_x(length: float = 1.0) -> fx.Model:
    """A mass of 1 kg at the free end of a bar along x."""
    m = ground((0.0, 0.0))
    m.point("A", (length, 0.0))
    m.fix("A.y")
    m.truss("bar", "O", "A")
    m.point_mass("m", "A", 1.0)
    return m


@mechanism(3.0)
def van_der_pol() -> fx.System:
    """e'' = 20 (1 - e²) e' - e."""
    m = along_x(10.0)
    m.law("bar.elongation", lambda e, ed: e - 20.0 * (1 - e**2) * ed, energy=lambda e: e**2 / 2)
    m.initial("bar.elongation", 2.0)
    return m.build()


@mechanism(1.0)
def unstable_mass() -> fx.System:
    """A mass on a spring that pushes it away."""
    m = along_x(10.0)
    m.law("bar.elongation", lambda e, ed: -9.0 * e, energy=lambda e: -4.5 * e**2)
    m.initial("bar.elongation", 0.01)
    return m.build()


@mechanism(0.1, atol=1e-11)
def two_masses() -> fx.System:
    """Two masses on a soft and on a hard spring, at 1 and 1.4e4 rad/s, that move together."""
    m = along_x()
    m.point("B", (1.5, 0.0))
    m.fix("B.y")
    m.truss("hard", "A", "B", stiffness=1e8)
    m.point_mass("b", "B", 1.0)
    m.spring("bar.elongation", 1.0)
    m.initial("A.x", rate=1.0)
    m.initial("B.x", rate=1.0)
    return m.build()


@mechanism(0.3)
def stiff_pendulum() -> fx.System:
    """A mass on a bar that vibrates at 356 Hz."""
    m = ground()
    m.point("A", (1.0, 0.0))
    m.truss("bar", "O", "A", stiffness=1e7, damping=10.0)
    m.point_mass("bob", "A", 2.0)
    return m.build()


mechanism(linkages.SQUEEZER_SECONDS)(linkages.squeezer)
mechanism(linkages.GOVERNOR_SECONDS)(linkages.governor)


@mechanism(1.0)
def planetary_gear() -> fx.Model:
    """A planet on a carrier around a free sun, eccentric."""
    m = ground()
    for name in ("carrier", "sun", "planet"):
        m.angle(name)
    m.point("P", (0.5, 0.2))
    m.body_point("arm", "O", "carrier", "P")
    m.hinge("carrier hinge", "G", "carrier")
    m.body("carrier body", "P", "carrier", mass=1.0, inertia=0.1)
    m.rotary_inertia("sun wheel", "sun", 0.3)
    m.body("planet wheel", "P", "planet", mass=2.0, inertia=0.2, offset=(0.05, -0.1))
    m.planar_gear("mesh", "O", "sun", "P", "planet", radius_p=0.3, radius_q=0.2)
    m.initial("carrier.angle", rate=2.0)
    return m


@mechanism(0.5)
def elastic_belt() -> fx.Model:
    """Two pulleys and both parts of an elastic belt between them."""
    m = ground((0.0, 0.0))
    m.point("P", (0.8, 0.1), fixed=True)
    for name, point, J in (("a", "O", 0.05), ("b", "P", 0.2)):
        m.angle(name)
        m.body(f"wheel {name}", point, name, mass=1.0, inertia=J)
    for side in (1, -1):
        m.planar_belt(
            f"belt {side}",
            "O",
            "a",
            "P",
            "b",
            radius_p=0.1 * side,
            radius_q=0.15 * side,
            stiffness=800.0,
            damping=0.5,
        )
    m.initial("a.angle", rate=10.0)
    m.initial("b.angle", rate=0.0)
    return m


@mechanism(0.1)
def relaxing_tyre() -> Start:
    """A wheel on a Magic Formula tyre whose slips lag, with a slip angle."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("hub", (0.0, 0.0, 0.28))
    m.frame("wheel")
    m.body("rim", "hub", "wheel", mass=40.0, inertia=(1.2, 1.4, 1.2))
    m.tyre("tyre", "hub", "wheel", radius=0.3, axle=(0, 1, 0), crown=0.05)
    slips = ("deflection", "camber", "forward", "rolling", "longitudinal", "lateral", "spin")
    m.attach(
        "magic_formula",
        [f"tyre.{slip}" for slip in slips],
        name="rubber",
        stiffness=5e4,
        damping=300.0,
        load0=4000.0,
        rolling_radius=0.3,
        friction=(0.9, -0.1),
        slip_stiffness=15.0,
        cornering=(12.0, 2.0),
        camber_stiffness=0.5,
        shape=(1.3, -0.2),
        trail=(0.03, 5.0),
        relaxation=(0.2, 0.4),
    )
    s = m.build()
    rates = dict.fromkeys(s.dynamic, 0.0) | {"hub.x": 10.0, "hub.y": 0.8}
    return s, s.state_at(rates={name: v for name, v in rates.items() if name in s.dynamic})


@mechanism(0.35)
def two_parallelograms() -> fx.System:
    """In series, on their way to their flat position."""
    m = fx.Model(gravity=(0, -9.81))
    for i in range(3):
        m.point(f"O{i}", (i, 0), fixed=True)
        m.point(f"A{i}", (i, 1))
        m.beam(f"crank{i}", f"O{i}", m.angle(f"R{i}"), f"A{i}", mass_per_length=1.0)
    for i in range(2):
        m.beam(f"coupler{i}", f"A{i}", m.angle(f"S{i}"), f"A{i + 1}", mass_per_length=1.0)
    m.initial("A0.x", rate=3.0)
    return m.build()


@mechanism(0.5, 5)
def bouncing_ball() -> fx.Model:
    """A ball that falls on a hard floor."""
    m = ground((0.0, 0.0, -9.81))
    m.point("ball", (0.0, 0.0, 0.32))
    m.point_mass("mass", "ball", 0.1)
    m.plane("floor", "O", "G")
    m.contact("bounce", "ball", "floor", fx.Contact(1e6, exponent=1.5, per="point"), radius=0.02)
    m.initial("ball.x", rate=0.3)
    return m


@mechanism(0.2, 5)
def stopped_pendulum() -> fx.Model:
    """A pendulum that swings against a stop."""
    m = mechanisms.pendulum_model()
    m.stop("pivot.angle", 0.15, 1e4, damping=0.1)
    m.initial("pivot.angle", rate=4.0)
    return m


@mechanism(0.05, atol=1e-11)
def leaf_spring() -> fx.System:
    """A leaf spring of two beams with a mass at its end, pushed suddenly; axially it is 1e4 times faster."""
    E, t, b, L = 2.1e11, 2e-4, 0.02, 0.1
    m = ground((0.0, 0.0))
    last = "O", "G"
    for i in range(1, 3):
        end = m.point(f"P{i}", (L * i / 2, 0.0)).name, m.angle(f"R{i}").name
        m.beam(f"b{i}", *last, *end, EA=E * b * t, EIz=E * b * t**3 / 12, mass_per_length=7800 * b * t)
        last = end
    m.point_mass("load", "P2", 0.05)
    m.load("P2.y", 0.05)
    return m.build()


@mechanism(0.3)
def chain_of_eight() -> fx.System:
    """Eight rigid links in the plane, let go."""
    m = ground()
    last = "O"
    for i in range(8):
        m.beam(
            f"b{i}", last, m.angle(f"R{i}"), m.point(f"P{i}", (0.1 * (i + 1), 0.02 * i)), mass_per_length=1.0
        )
        last = f"P{i}"
    return m.build()
