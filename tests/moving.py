"""Moving mechanisms out of equilibrium, to be linearized: springs, dampers, loads, loops and rolling contact."""

from collections.abc import Callable

from differences import (
    Knob,
    pendulum,
)
from mechanisms import disc, rssr

from flexel.parts.model import Model
from flexel.parts.rope_contacts import Contact
from flexel.parts.rope_surfaces import VGroove


def double_pendulum() -> Model:
    """Two rods on skew hinges with springs and dampers, a constant force and a follower moment, in full swing."""
    m = pendulum(mass_per_length=2.0)
    B, R2 = m.point("B", (1.5, 0.6, 0.2)), m.frame("R2")
    m.hinge("elbow", "R1", R2, axis=(1, 1, 0.4), stiffness=7.0, damping=0.4)
    m.beam("arm", "A", R2, B, mass_per_length=1.0, inertia_per_length=(0.1, 0.05, 0.05))
    m.body("hand", B, R2, mass=0.7, inertia=(0.2, 0.3, 0.4, 0.02, -0.03, 0.01), offset=(0.1, 0.2, -0.1))
    m.load("B", (1.0, -2.0, 3.0))
    m.load("R2", (0.6, 0.2, -0.9), follower=True)
    m.load("R1", (0.1, 0.7, -0.3))
    m.initial("pivot.angle", 0.7, rate=2.0)
    m.initial("elbow.angle", -0.9, rate=-3.0)
    return m


def flexible_arm() -> Model:
    """A beam with all six modes flexible and damped on a turning hinge, with a tip body."""
    m = Model(gravity=(0, 0, -9.81))
    O, A = m.point("O", (0, 0, 0), fixed=True), m.point("A", (1, 0, 0))
    R0, R1, R2 = m.frame("R0", fixed=True), m.frame("R1"), m.frame("R2")
    m.hinge("pivot", R0, R1, axis=(0, 1, 0.3))
    stiff = {"EA": 900.0, "GJ": 6.0, "EIy": 9.0, "EIz": 14.0, "GAy": 500.0, "GAz": 400.0}
    m.beam(
        "arm", O, R1, A, R2, **stiff, damping=0.01, mass_per_length=1.0, inertia_per_length=(0.02, 0.01, 0.01)
    )
    m.body("tip", A, R2, mass=0.5, inertia=(0.03, 0.02, 0.04), offset=(0.1, 0.0, 0.05))
    modes = ("elongation", "torsion", "bend1", "bend2", "bend3", "bend4")
    m.independent("pivot.angle", *(f"arm.{mode}" for mode in modes))
    m.initial("pivot.angle", 0.4, rate=2.5)
    for i, mode in enumerate(modes):
        m.initial(f"arm.{mode}", 0.02 * (-1) ** i, rate=0.1 * (i - 2))
    return m


def driven() -> Model:
    """A spring pendulum hung from a trolley on a turntable, both with prescribed motions."""
    m = Model(gravity=(0, 0, -9.81))
    O, T, P = m.point("O", (0, 0, 0), fixed=True), m.point("T", (0.5, 0, 0)), m.point("P", (0.6, 0.1, -1))
    ground, table = m.frame("ground", fixed=True), m.frame("table")
    m.hinge("turn", ground, table, axis=(0, 0, 1))
    m.beam("rail", O, table, T)
    m.release("rail.along")
    m.prescribe("turn.angle", TURN)
    m.prescribe("rail.along", TROLLEY)
    m.truss("string", T, P, stiffness=80.0, damping=1.5)
    m.point_mass("bob", P, 1.2)
    m.body("plate", T, table, mass=2.0, inertia=(0.2, 0.3, 0.4), offset=(0.1, 0.05, 0))
    m.independent("P.x", "P.y", "P.z")
    for name, rate in (("P.x", 0.5), ("P.y", -1.5), ("P.z", 0.8)):
        m.initial(name, rate=rate)
    m.load("P", (0.3, FORCE, -0.2))
    return m


TURN, TROLLEY, FORCE = Knob(0.4, 1.7, -2.2), Knob(0.12, -0.6, 1.1), Knob(1.4)


def driven_loop() -> Model:
    """The spatial four-bar with a prescribed crank and a flexible rocker hinge: no dynamic degree of freedom but a
    spring.
    """
    m = rssr(universal=False)
    m.lowering.dynamic = None
    m.lowering.rates.clear()
    m.lowering.values.clear()
    m.release("coupler bar.elongation")
    m.spring("coupler bar.elongation", 300.0, 2.0)
    m.prescribe("input.angle", CRANK)
    m.independent("output.angle")
    m.initial("output.angle", 0.15, rate=0.7)
    return m


CRANK = Knob(0.3, 2.0, -1.0)


def loop() -> Model:
    m = rssr(universal=True)
    m.initial("input.angle", 0.4, rate=2.0)
    m.spring("output.angle", 4.0, 0.3, preload=1.0)
    return m


def rolling() -> Model:
    """The disc in a wobbling turn, with a sprung passenger and a load: non-holonomic, far from steady."""
    m = disc(1.1, (2.0, 0.4, -5.0))
    Q = m.point("Q", (0.1, -0.1, 0.6))
    R = m.frame("Q frame")
    m.hinge("swing", "L", R, axis=(1, 0.5, 0), stiffness=3.0, damping=0.2)
    m.beam("rod", "hub", R, Q, mass_per_length=0.6)
    m.independent("swing.angle")
    m.initial("swing.angle", 0.3, rate=-1.0)
    m.load("Q", (0.5, PUSH, 0.0))
    return m


PUSH = Knob(-0.7)


def sliding() -> Model:
    """The disc with viscous resistance along and across instead of pure rolling, and a twisting moment."""
    m = disc(1.3, (1.0, 0.2, 4.0))
    m.lowering.dynamic, m.lowering.kinematic = None, None
    m.spring("wheel.longitudinal", damping=2.5)
    m.spring("wheel.lateral", damping=1.5)
    m.spring("wheel.spin", damping=0.4)
    m.independent("yaw.angle", "lean.angle", "roll.angle", "contact.x", "contact.y")
    m.initial("contact.x", rate=1.0)
    m.initial("contact.y", rate=-0.5)
    m.load("S", (0.1, 0.3, 0.2))
    return m


def tumbling() -> Model:
    """A free body on a spring; its coordinates are chosen by the program."""
    m = Model(gravity=(0, 0, -9.81))
    P, R, Q = m.point("P", (0, 0, 0)), m.frame("R"), m.point("Q", (0.3, 0.4, -0.2))
    W = m.point("wall", (0.2, 0.3, 0.9), fixed=True)
    m.body("body", P, R, mass=2.0, inertia=(0.3, 0.5, 0.6, 0.05, 0.02, -0.04), offset=(0.05, -0.1, 0.1))
    m.body_point("eye", P, R, Q)
    m.truss("spring", W, Q, stiffness=50.0, damping=0.7)
    w = m.angular_velocity(R)
    for name, rate in ((f"{w}.wx", 1.0), (f"{w}.wy", -2.0), (f"{w}.wz", 3.0), ("P.x", 0.4), ("P.z", -0.3)):
        m.initial(name, rate=rate)
    return m


def touching() -> Model:
    """A body with two balls that slide and roll on a tilting table and in the groove of a turning sheave."""
    m = Model(gravity=(0, 0, -9.81))
    O, C, P = (
        m.point("O", (0, 0, 0), fixed=True),
        m.point("C", (0.9, 0.1, 0), fixed=True),
        m.point("P", (0.1, 0.2, 0.2)),
    )
    ground, table, wheel, R = m.frame("ground", fixed=True), m.frame("table"), m.frame("wheel"), m.frame("R")
    m.hinge("tilt", ground, table, axis=(0.2, 1, 0), stiffness=40.0, damping=0.5)
    m.hinge("axle", ground, wheel, axis=(0.1, 1, 0.2))
    m.body("top", O, table, mass=3.0, inertia=(0.4, 0.3, 0.5))
    m.body("rim", C, wheel, mass=2.0, inertia=(0.1, 0.2, 0.1))
    m.body("body", P, R, mass=1.5, inertia=(0.03, 0.05, 0.06, 0.005, 0.002, -0.004), offset=(0.2, -0.1, 0.1))
    m.plane("plane", O, table, normal=(0.1, -0.1, 1))
    m.sheave("sheave", C, wheel, radius=0.3, axle=(0.1, 1, 0.2), groove=VGroove(1.1))
    soft = Contact(300.0, dissipation=0.4, friction=0.5, slip_speed=0.5)
    m.contact("foot", P, "plane", soft, frame=R, at=(0.15, 0.1, 0.25), radius=0.4)
    m.contact("ball", P, "sheave", soft, frame=R, at=(0.5, 0.12, 0.2), radius=0.4)
    w = m.angular_velocity(R)
    for name, rate in (("P.x", 0.4), ("P.z", -0.7), (f"{w}.wx", 1.5), (f"{w}.wy", -2.0), ("axle.angle", 3.0)):
        m.initial(name, rate=rate)
    return m


def planar() -> Model:
    """Planar beam, truss and hinge spring together."""
    m = Model(gravity=(0, -9.81))
    O, A, B = m.point("O", (0, 0), fixed=True), m.point("A", (1, 0.2)), m.point("B", (1.1, -0.8))
    r0, r1, r2 = m.angle("r0", fixed=True), m.angle("r1", 0.1), m.angle("r2", -0.2)
    m.hinge("base", r0, r1, stiffness=20.0, damping=0.5)
    m.beam(
        "link", O, r1, A, r2, EA=700.0, EIz=9.0, damping=0.02, mass_per_length=1.0, inertia_per_length=0.01
    )
    m.truss("tie", A, B, mass_per_length=0.5)
    m.body("tip", B, "r2", mass=0.4, inertia=0.05, offset=(0.1, -0.1))
    m.independent("base.angle", "link.elongation", "link.bend1", "link.bend2", "B.x")
    for i, name in enumerate(m.lowering.dynamic or []):
        m.initial(name, rate=0.4 * (-1) ** i)
    return m


MODELS: dict[str, Callable[[], Model]] = {
    f.__name__: f
    for f in (
        double_pendulum,
        flexible_arm,
        driven,
        driven_loop,
        loop,
        rolling,
        sliding,
        tumbling,
        touching,
        planar,
    )
}
