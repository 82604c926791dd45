"""Models of the rope problems: ropes that hang or fall, and ropes over drums, sheaves and planes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.parts.rope import Rope
from flexel.parts.rope_path import PathPart, RopePath

RunUp = tuple[Callable[[float], float], Callable[[float], float], Callable[[float], float]]
G = 9.81
WHEEL = 0.1  # radius of sheaves and drums up to the centre line of the rope [m]
THIN = 1e-3  # radius of ropes [m]


def hanging_between(
    curve: Callable[[float], tuple[float, float]],
    n: int,
    *,
    length: float,
    EA: float,
    weight: float,
    EI: float = 0.0,
) -> fx.System:
    """Build a cable of n elements with a weight per length between two fixed points, drawn along a curve."""
    m = fx.Model(gravity=(0, -G))
    rope = m.cable_line("rope", curve, n, length=length, EA=EA, EI=EI, mass_per_length=weight / G)
    m.fix(rope.points[0], rope.points[-1])
    return m.build()


def hanging_chain(n: int, length: float = 2.0) -> fx.System:
    """Build a chain of 1.5 kg/m that hangs from one end, of n rigid bars."""
    m = fx.Model(gravity=(0, -G))
    chain = m.chain("chain", [(0, 0), (0, -length)], n, mass_per_length=1.5)
    m.fix(chain.points[0])
    return m.build()


def loaded_rope(n: int, length: float, payload: float) -> fx.System:
    """Build a rope of 1.5 kg/m without bending stiffness, nearly inextensible, that carries a payload [kg]."""
    m = fx.Model(gravity=(0, -G))
    rope = m.cable_line("rope", [(0, 0), (0, -length)], n, EA=1e8, EI=0.0, mass_per_length=1.5)
    m.fix(rope.points[0])
    m.point_mass("payload", rope.points[-1], payload)
    return m.build()


def cantilever(n: int, load: float) -> fx.System:
    """Build a cable, length 1, EI = 1, clamped at one end, with a force across the other; hardly extensible."""
    m = fx.Model()
    rope = m.cable_line("rope", [(0, 0), (1, 0)], n, EA=1e8, EI=1.0, mass_per_length=1.0)
    wall = m.angle("wall", fixed=True)
    m.fix(rope.points[0])
    m.clamp("clamp", wall, rope.slopes[0])
    m.load(rope.points[-1], (0, load))
    return m.build()


def wrapped_sheave(n: int, tension: float = 50.0) -> tuple[fx.System, Rope]:
    """Build a rope over a fixed sheave without friction, half a turn and two vertical parts, held at both ends."""
    m = fx.Model()
    m.point("C", (0, 0), fixed=True)
    m.angle("F", fixed=True)
    m.sheave("S", "C", "F", radius=WHEEL - THIN)
    ends = [m.point(name, (x, -2 * WHEEL), fixed=True) for name, x in (("A", -WHEEL), ("B", WHEEL))]
    rope = m.rope(
        "rope", [ends[0], "S", ends[1]], n, contact=fx.Contact(1e9), radius=THIN, tension=tension, EA=1e5,
        EI=1e-5, mass_per_length=0.01,
    )  # fmt: skip
    return m.build(), rope


def straight(
    n: int, L: float, *, payload: float = 0.0, EA: float, mass: float, damping: float = 0.0
) -> fx.Model:
    """Build a cable along x, fixed at its first end, that can move along x only."""
    m = fx.Model()
    rope = m.cable_line("rope", [(0, 0), (L, 0)], n, EA=EA, EI=0.0, mass_per_length=mass, damping=damping)
    m.fix(rope.points[0], *(f"{node.name}.y" for node in (*rope.points[1:], *rope.slopes)))
    if payload:
        m.point_mass("payload", rope.points[-1], payload)
    return m


def swinging(n: int) -> fx.System:
    """Build a soft rope of 1 m, held at one end, that is let go at half a radian from the vertical."""
    m = fx.Model(gravity=(0, -G))
    end = (np.sin(0.5), -np.cos(0.5))
    rope = m.cable_line("rope", [(0, 0), end], n, EA=500.0, EI=0.05, mass_per_length=0.4)
    m.fix(rope.points[0])
    return m.build()


def falling(n: int, E: float, L: float, A: float, I: float, rho: float, size: float = 2) -> fx.System:
    """Build a rod that hangs from a pin at one end, released from the horizontal; spatial with size 3, else planar."""
    m = fx.Model(gravity=(0.0, -G, 0.0)[: int(size)])
    ends = [(0.0, 0.0, 0.0)[: int(size)], (L, 0.0, 0.0)[: int(size)]]
    rod = m.cable_line("rod", ends, n, EA=E * A, EI=E * I, mass_per_length=rho * A)
    m.fix(rod.points[0])
    return m.build()


def let_go(n: int, element: float, *, EA: float, EI: float, mass: float) -> fx.System:
    """Build a rope of n spatial cables along x, held at one end and let go, with gravity along -z.

    Parameters
    ----------
    element, mass : float
        Length of a cable [m], mass per length [kg/m].
    """
    m = fx.Model(gravity=(0, 0, -G))
    for i in range(n + 1):
        m.point(f"p{i}", (element * i, 0, 0), fixed=i == 0)
        m.slope(f"d{i}", (1, 0, 0))
    for i in range(n):
        ends = (f"p{i}", f"d{i}", f"p{i + 1}", f"d{i + 1}")
        m.cable(f"c{i}", *ends, EA=EA, EI=EI, mass_per_length=mass)
    return m.build()


def turning_wheel(m: fx.Model, inertia: float | None = None, radius: float = WHEEL - THIN) -> None:
    """Add a sheave "S" of a radius at the origin on the hinge "axle" between the angles G (fixed) and F."""
    m.point("C", (0, 0), fixed=True)
    m.angle("G", fixed=True)
    m.angle("F")
    m.hinge("axle", "G", "F")
    if inertia is not None:
        m.body("wheel", "C", "F", mass=1.0, inertia=inertia)
    m.sheave("S", "C", "F", radius=radius)


def run_up(speed: float, begin: float, end: float) -> RunUp:
    """Return angle, rate and acceleration over time of a wheel whose rate grows evenly between two times."""
    T = end - begin

    def share(t: float) -> float:
        return min(max((t - begin) / T, 0.0), 1.0)

    return (
        lambda t: speed * (T * share(t) ** 2 / 2 + max(t - end, 0.0)),
        lambda t: speed * share(t),
        lambda t: speed / T if begin <= t < end else 0.0,
    )


def wrapped(angle: float, end: float, radius: float) -> RopePath:
    """Return a straight part, an arc about the origin from (-WHEEL, 0) upwards, clockwise, and a straight part."""
    leave = np.pi - angle
    off = radius * np.array([np.cos(leave), np.sin(leave)])
    return RopePath(
        (
            PathPart(np.array([-radius, -end]), np.pi / 2, end),
            PathPart(np.zeros(2), np.pi, angle * radius, radius, -1, "S"),
            PathPart(off, leave - np.pi / 2, end),
        )
    )


def capstan(n: int, friction: float, angle: float) -> fx.System:
    """Build a rope around a turning drum, held at its first end, pulled with 1 N at its last one.

    The straight parts are as long as the drum's radius.
    Wraps beyond the first lie over one another: in the plane each touches only the drum.  The drum starts smoothly
    and slides 500 times faster than the speed that regularizes the friction.  It gives way by a hundredth of its
    radius under the largest tensions, which does not change their ratio.
    """
    m, EA = fx.Model(), 1e4
    turning_wheel(m)
    contact = fx.Contact(1e8, friction=friction, slip_speed=2e-3, dissipation=10.0)
    path = wrapped(angle, WHEEL, WHEEL - contact.depth(1 / WHEEL, WHEEL))

    def curve(u: float) -> Array:
        return np.asarray(path.at(np.array([u * path.length]))[0][0])

    rope = m.cable_line(
        "rope",
        curve,
        n,
        length=path.length / (1 + 1 / EA),
        EA=EA,
        EI=1e-7,
        mass_per_length=0.01,
        damping=1e-3,
    )
    m.rope_contact(rope, "S", contact, radius=THIN)
    m.fix(rope.points[0])
    m.load(rope.points[-1], path.parts[-1].at(np.zeros(1))[1][0])
    m.prescribe("axle.angle", run_up(-10.0, 0.0, 0.02))
    return m.build()


def atwood(
    n: int,
    m1: float,
    m2: float,
    *,
    inertia: float,
    mass: float = 0.01,
    EA: float = 1e6,
    stiffness: float = 1e10,
) -> tuple[fx.System, Rope]:
    """Build Atwood's machine: masses A and B at the ends of a rope over a turning sheave.

    28 elements are half as long as the sheave's radius.
    """
    fall = (14 * (WHEEL - THIN) - np.pi * WHEEL) / 2
    m = fx.Model(gravity=(0, -G))
    turning_wheel(m, inertia)
    A, B = m.point("A", (-WHEEL, -fall)), m.point("B", (WHEEL, -fall))
    m.point_mass("m1", A, m1)
    m.point_mass("m2", B, m2)
    contact = fx.Contact(stiffness, friction=0.5, slip_speed=1e-3, dissipation=10.0)
    rope = m.rope(
        "rope", [A, "S", B], n, contact=contact, radius=THIN, tension=(m1 + m2) / 2 * G, EA=EA, EI=1e-5,
        mass_per_length=mass, damping=1e-3,
    )  # fmt: skip
    return m.build(), rope


def winding_hoist(n: int, speed: float) -> tuple[fx.System, RunUp]:
    """Build a load of 1000 kg released on 10 m of unstretched rope; a drum of radius 0.2 m winds it up from 1 s on.

    The rope weighs and bends next to nothing, and sticks to the drum.  Its first metre, more than what is wound up in
    3 s, has n elements, the rest three.
    """
    m, R, L = fx.Model(gravity=(0, -G)), 0.2, 10.0
    turning_wheel(m, radius=R - THIN)
    load = m.point("load", (R, -L))
    m.point_mass("mass", load, 1000.0)
    at = np.concatenate([np.linspace(0, 1 / L, n + 1), np.linspace(1 / L, 1, 4)[1:]])
    rope = m.cable_line(
        "rope", [(R, 0), (R, -L)], at=at, end=load, EA=1e7, EI=1e-3, mass_per_length=0.01,
        damping=0.04 / np.sqrt(1e7 / (L * 1000.0)),
    )  # fmt: skip
    m.anchor("start", "C", "F", rope.points[0], rope.slopes[0])
    contact = fx.Contact(1e12, friction=3.0, slip_speed=1e-3, dissipation=10.0)
    m.rope_contact(rope, "S", contact, radius=THIN, only=rope.elements[:n])
    motion = run_up(speed, 1.0, 2.0)
    m.prescribe("axle.angle", motion)
    return m.build(), motion


def tackle(n: int, arm: float, load: float = 10.0) -> tuple[fx.System, Rope]:
    """Build a load [kg] on two falls of rope: from a beam to a movable sheave, up to a fixed one, down to the end P.

    P is pulled downwards by 0.2 m/s.  Both sheaves turn on journals whose radius times coefficient of friction is
    `arm`.
    """
    m, R, drop = fx.Model(gravity=(0, -G)), WHEEL, 6 * WHEEL
    m.point("beam", (0, 0), fixed=True)
    m.angle("still", fixed=True)
    m.point("block", (-2 * R, -drop))
    m.point_mass("load", "block", load)
    for i, (holder, x) in enumerate((("beam", (0, 0)), ("block", (-2 * R, -drop))), start=1):
        m.point(f"C{i}", x)
        m.angle(f"F{i}")
        m.body(f"wheel{i}", f"C{i}", f"F{i}", mass=0.1, inertia=0.1 * R**2)
        m.bearing(f"journal{i}", holder, "still", f"C{i}", f"F{i}")
        m.attach(
            "journal", [f"journal{i}.{mode}" for mode in ("along", "across", "angle")], stiffness=1e6, damping=1e3,
            friction_radius=arm, slip_speed=1e-2,
        )  # fmt: skip
        m.sheave(f"S{i}", f"C{i}", f"F{i}", radius=R - THIN)
    start = m.point("anchor", (-3 * R, 0), fixed=True)
    end = m.point("P", (R, -drop / 2))
    contact = fx.Contact(1e9, friction=0.5, slip_speed=1e-2, dissipation=10.0)
    rope = m.rope(
        "rope", [start, ("S2", 1), ("S1", -1), end], n, contact=contact, radius=THIN, tension=load * G / 2,
        EA=1e6, EI=1e-5, mass_per_length=1e-3, damping=1e-3,
    )  # fmt: skip
    m.fix("P.x")
    pull = run_up(0.2, 0.0, 0.2)
    m.prescribe("P.y", (lambda t: -drop / 2 - pull[0](t), lambda t: -pull[1](t), lambda t: -pull[2](t)))
    return m.build(), rope


def sliding(n: int, length: float, ahead: float) -> tuple[fx.System, Rope]:
    """Build a rope over a smooth round edge, which hangs lower by twice `ahead` at the end B than at the end A."""
    m, R, a = fx.Model(gravity=(0, -G)), WHEEL, THIN
    edge, still = m.point("C", (0, 0), fixed=True), m.angle("still", fixed=True)
    m.sheave("edge", edge, still, radius=R - a)
    side = (length - np.pi * R) / 2
    A, B = m.point("A", (-R, ahead - side)), m.point("B", (R, -ahead - side))
    rope = m.rope(
        "rope", [A, "edge", B], n, contact=fx.Contact(1e8, dissipation=10.0), radius=a, tension=G * side / 2,
        EA=1e5, EI=1e-5, mass_per_length=1.0, damping=1e-3,
    )  # fmt: skip
    return m.build(), rope


def bouncing(
    stiffness: float, mass: float, speed: float, height: float, dissipation: float = 0.0
) -> fx.System:
    """Build half a mass on each end of a weightless piece of rope, whose middle falls upon a plane.

    The slopes are held, so that the piece stays straight and its middle moves like its ends.
    """
    m = fx.Model()
    ground, still = m.point("ground", (0, 0), fixed=True), m.angle("still", fixed=True)
    rope = m.cable_line("rope", [(0, height), (1e-3, height)], 1, EA=1.0, EI=1.0, mass_per_length=0.0)
    m.plane("plane", ground, still, (0, 1, 0))
    for i, p in enumerate(rope.points):
        m.point_mass(f"mass{i}", p, mass / 2)
        m.initial(f"{p.name}.y", rate=-speed)
    m.fix("rope_p0.x", "rope_p1.x", *rope.slopes)
    contact = fx.Contact(stiffness, dissipation=dissipation, points=1, places="equidistant", per="point")
    m.rope_contact(rope, "plane", contact, radius=0.0)
    return m.build()
