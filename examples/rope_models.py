"""Models of the rope problems with closed forms: planar ropes that hang, and ropes over drums, sheaves and planes.

Imports numpy and flexel.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

import flexel as fx
from flexel.rope_path import Part, Path
from flexel.ropes import Rope
from flexel.structure import Array

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
    """A cable of n elements with a weight per length between two fixed points, drawn along a curve."""
    m = fx.Model(gravity=(0, -G))
    rope = m.cable_line("rope", curve, n, length=length, EA=EA, EI=EI, mass_per_length=weight / G)
    m.fix(rope.points[0], rope.points[-1])
    return m.build()


def hanging_chain(n: int, length: float = 2.0) -> fx.System:
    """A chain that hangs from one end, nearly inextensible."""
    m = fx.Model(gravity=(0, -G))
    rope = m.cable_line("rope", [(0, 0), (0, -length)], n, EA=1e8, EI=0.0, mass_per_length=1.5)
    m.fix(rope.points[0])
    return m.build()


def turning_wheel(m: fx.Model, inertia: float | None = None, radius: float = WHEEL - THIN) -> None:
    """A sheave "S" of a radius at the origin on the hinge "axle" between the angles G (fixed) and F."""
    m.point("C", (0, 0), fixed=True)
    m.angle("G", fixed=True)
    m.angle("F")
    m.hinge("axle", "G", "F")
    if inertia is not None:
        m.body("wheel", "C", "F", mass=1.0, inertia=inertia)
    m.sheave("S", "C", "F", radius)


def run_up(speed: float, begin: float, end: float) -> tuple[Callable[[float], float], ...]:
    """Angle, rate and acceleration over time of a wheel whose rate grows evenly between two times."""
    T = end - begin

    def share(t: float) -> float:
        return min(max((t - begin) / T, 0.0), 1.0)

    return (
        lambda t: speed * (T * share(t) ** 2 / 2 + max(t - end, 0.0)),
        lambda t: speed * share(t),
        lambda t: speed / T if begin <= t < end else 0.0,
    )


def wrapped(angle: float, end: float, radius: float) -> Path:
    """A straight part, an arc about the origin that starts at (-WHEEL, 0) upwards, clockwise, and a straight part."""
    leave = np.pi - angle
    off = radius * np.array([np.cos(leave), np.sin(leave)])
    return Path(
        (
            Part(np.array([-radius, -end]), np.pi / 2, end),
            Part(np.zeros(2), np.pi, angle * radius, radius, -1, "S"),
            Part(off, leave - np.pi / 2, end),
        )
    )


def capstan(n: int, friction: float, angle: float) -> fx.System:
    """A rope around a drum that turns: its first end is held, its last one pulled with 1 N; straight parts as long as
    the drum's radius.

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
    m.contact(rope, "S", contact, rope_radius=THIN)
    m.fix(rope.points[0])
    m.load(rope.points[-1], path.parts[-1].at(np.zeros(1))[1][0])
    m.prescribe("axle.angle", run_up(-10.0, 0.0, 0.02))
    return m.build()


def atwood(
    n: int, m1: float, m2: float, *, inertia: float, mass: float = 0.01, EA: float = 1e5
) -> tuple[fx.System, Rope]:
    """Atwood's machine: masses A and B at the ends of a rope over a turning sheave; 28 elements are half as long as
    the sheave's radius.
    """
    fall = (14 * (WHEEL - THIN) - np.pi * WHEEL) / 2
    m = fx.Model(gravity=(0, -G))
    turning_wheel(m, inertia)
    A, B = m.point("A", (-WHEEL, -fall)), m.point("B", (WHEEL, -fall))
    m.point_mass("m1", A, m1)
    m.point_mass("m2", B, m2)
    contact = fx.Contact(1e9, friction=0.5, slip_speed=1e-2, dissipation=10.0)
    rope = m.rope(
        "rope", [A, "S", B], n, contact=contact, rope_radius=THIN, tension=(m1 + m2) / 2 * G, EA=EA, EI=1e-5,
        mass_per_length=mass, damping=1e-3,
    )  # fmt: skip
    return m.build(), rope


def bouncing(
    stiffness: float, mass: float, speed: float, height: float, dissipation: float = 0.0
) -> fx.System:
    """Half a mass on each end of a weightless piece of rope, whose middle falls upon a plane.

    The slopes are held, so that the piece stays straight and its middle moves like its ends.
    """
    m = fx.Model()
    ground, still = m.point("ground", (0, 0), fixed=True), m.angle("still", fixed=True)
    rope = m.cable_line("rope", [(0, height), (1, height)], 1, EA=1.0, EI=1.0, mass_per_length=0.0)
    m.plane("plane", ground, still, (0, 1, 0))
    for i, p in enumerate(rope.points):
        m.point_mass(f"mass{i}", p, mass / 2)
        m.initial(f"{p.name}.y", rate=-speed)
    m.fix("rope_p0.x", "rope_p1.x", *rope.slopes)
    contact = fx.Contact(stiffness, dissipation=dissipation, points=1, places="equidistant", per="point")
    m.contact(rope, "plane", contact, rope_radius=0.0)
    return m.build()
