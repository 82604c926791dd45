"""Models of the published beam problems: chains of equal beam elements and what holds, loads or spins them.

Points are called P0, P1, ..., frames R0, R1, ... and elements b1, b2, ... from the clamp on.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import beams_data as data

RISING = fx.Polynomial((0.0, 1.0))  # a load of t at time t
BENDING = ("bend1", "bend2", "bend3", "bend4")


def lay(m: fx.Model, points: Sequence[Any], **section: Any) -> None:
    """Add beam elements between points, from the present P0 and R0 on; spatial if R0 is a frame, else planar."""
    spatial = m.nodes["R0"].kind == "frame"
    for i, x in enumerate(points, start=1):
        q = m.point(f"P{i}", x)
        r = m.frame(f"R{i}") if spatial else m.angle(f"R{i}")
        m.beam(f"b{i}", f"P{i - 1}", f"R{i - 1}", q, r, **section)


def clamped(points: Sequence[Any], **section: Any) -> fx.Model:
    """Build a model with a beam clamped at the first of the points (three coordinates: spatial; two: planar)."""
    m = fx.Model()
    m.point("P0", points[0], fixed=True)
    if len(points[0]) == 3:
        m.frame("R0", fixed=True)
        section = {"direction": (0, 1, 0)} | section
    else:
        m.angle("R0", fixed=True)
    lay(m, points[1:], **section)
    return m


def straight(n: int, length: float = 1.0, dimension: int = 3) -> list[tuple[float, ...]]:
    """Return the the ends of n equal elements along the x axis."""
    return [(length * i / n, *([0.0] * (dimension - 1))) for i in range(n + 1)]


def planar(n: int, length: float = 1.0, **section: Any) -> fx.Model:
    """Build a planar cantilever along x; without EA it is inextensible."""
    return clamped(straight(n, length, 2), **section)


def bend(n: int, second_order: bool = True) -> fx.System:
    """Build the 45 degree bend of straight elements along the arc; its load at time t is t upwards."""
    a = np.linspace(0.0, np.pi / 4, n + 1)
    arc = [(100 * (1 - np.cos(angle)), 100 * np.sin(angle), 0.0) for angle in a]
    E, G, moment = 1e7, 5e6, 1 / 12
    m = clamped(
        arc, direction=(0, 0, 1), EA=E, GJ=G / 6, EIy=E * moment, EIz=E * moment, GAy=G, GAz=G,
        second_order=second_order,
    )  # fmt: skip
    m.load(f"P{n}.z", RISING)
    return m.build()


def princeton(n: int, degrees: float, **options: Any) -> fx.System:
    """Build the Princeton beam with a tip load t at an angle from the width; options of its beams."""
    m = clamped(straight(n, data.PRINCETON_LENGTH), **options, **data.PRINCETON_SECTION)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    m.load(f"P{n}", (0, fx.Polynomial((0.0, c)), fx.Polynomial((0.0, s))))
    return m.build()


def narrow(n: int, second_order: bool = True, **section: float) -> fx.System:
    """Build the narrow cantilever with its tip load t downwards in the stiff plane."""
    inertia = {"mass_per_length": 1.0, "inertia_per_length": (1, 0, 0)}
    m = clamped(straight(n), second_order=second_order, **inertia, **section)
    m.load(f"P{n}.y", fx.Polynomial((0.0, -1.0)))
    return m.build()


def column(n: int, supports: str, **section: Any) -> fx.System:
    """Build a planar column of length 1 and EI = 1 under a load t; supports as in `data.EULER_FACTORS`."""
    m = fx.Model()
    m.point("P0", (0, 0), fixed=True)
    first, last = supports.split("-")
    m.angle("R0", fixed=first == "clamped")
    lay(m, straight(n, 1.0, 2)[1:], EIz=1.0, mass_per_length=1.0, **section)
    if last != "free":
        m.fix(f"P{n}.y")
    if last == "clamped":
        m.fix(f"R{n}")
    m.load(f"P{n}.x", fx.Polynomial((0.0, -1.0)))
    return m.build()


def bent_column(n: int, load: float, second_order: bool = True) -> fx.System:
    """Build a cantilever column that an end load bends; a push from the side while t < 1 chooses the side."""
    m = planar(n, EIz=1.0, second_order=second_order)
    m.load(f"P{n}.x", fx.Polynomial((0.0, -load)))
    m.load(f"P{n}.y", fx.Polynomial((0.0, 3.0, -3.0)))
    return m.build()


def right_angle_frame(n: int, second_order: bool = True) -> fx.System:
    """Build the right-angle frame (units N and mm) with n elements a leg and the load t along x."""
    leg, b, t, E = (data.FRAME_SECTION[name] for name in ("leg", "b", "t", "E"))
    G = E / (2 * (1 + data.FRAME_SECTION["nu"]))
    points = straight(n, leg) + [(leg, -leg * i / n, 0.0) for i in range(1, n + 1)]
    m = clamped(
        points, direction=(0, 0, 1), EA=E * b * t, GJ=G * b * t**3 / 3, EIz=E * b * t**3 / 12,
        EIy=E * t * b**3 / 12, mass_per_length=1.0, inertia_per_length=(1, 0, 0), second_order=second_order,
    )  # fmt: skip
    m.load(f"P{2 * n}.x", RISING)
    return m.build()


def blade(n: int, spin: float, hub: float = 0.0, second_order: bool = True) -> fx.System:
    """Build an inextensible blade of unit length, mass and stiffness on a hub that spins about z."""
    m = fx.Model()
    ground, r = m.frame("ground", fixed=True), m.frame("R0")
    m.hinge("hub", ground, r, axis=(0, 0, 1))
    m.prescribe("hub.angle", fx.Polynomial((0.0, spin)))
    p = m.point("P0", (hub, 0, 0), fixed=hub == 0)
    if hub:
        m.beam("arm", m.point("O", (0, 0, 0), fixed=True), r, p)
    points = [(hub + i / n, 0, 0) for i in range(1, n + 1)]
    lay(m, points, direction=(0, 1, 0), EIy=1.0, EIz=1.0, mass_per_length=1.0, second_order=second_order)
    # Deformations, not coordinates: they rest in the turning frame, so that the steady spin is where they do.
    m.independent(*(f"b{i}.{mode}" for i in range(1, n + 1) for mode in BENDING))
    return m.build()


def shaft(n: int, spin: float, radius: float, second_order: bool = True) -> fx.System:
    """Build a simply supported round shaft of unit length, mass and stiffness; `radius` of gyration I/A = radius²."""
    m = fx.Model()
    ground, drive, r = m.frame("ground", fixed=True), m.frame("drive"), m.frame("R0")
    m.point("P0", (0, 0, 0), fixed=True)
    m.hinge("motor", ground, drive, axis=(1, 0, 0))
    m.prescribe("motor.angle", fx.Polynomial((0.0, spin)))
    m.hinge("joint", drive, r, axis=(1, 0, 0))  # drives the spin and leaves the slopes free
    m.release("joint.bend1", "joint.bend2")
    m.rigid("joint.angle")
    J = radius**2
    lay(
        m, straight(n)[1:], direction=(0, 1, 0), EIy=1.0, EIz=1.0, mass_per_length=1.0,
        inertia_per_length=(2 * J, J, J), second_order=second_order,
    )  # fmt: skip
    m.fix(f"P{n}.y", f"P{n}.z")
    m.independent(*(f"b{i}.{mode}" for i in range(1, n + 1) for mode in BENDING))
    return m.build()


def square_beam(n: int, height: float, supports: str) -> fx.System:
    """Build a planar beam of square section with shear and rotary inertia, a cantilever or pinned at both ends."""
    E, nu, rho = (data.SQUARE[name] for name in ("E", "nu", "rho"))
    A, moment = height**2, height**4 / 12
    GA = 10 * (1 + nu) / (12 + 11 * nu) * A * E / (2 * (1 + nu))
    m = fx.Model()
    m.point("P0", (0, 0), fixed=True)
    m.angle("R0", fixed=supports == "cantilever")
    lay(
        m, straight(n, 1.0, 2)[1:], EIz=E * moment, GAy=GA, mass_per_length=rho * A,
        inertia_per_length=rho * moment,
    )  # fmt: skip
    if supports == "pinned":
        m.fix(f"P{n}.y")
    return m.build()


def beam_with_tip_mass(n: int, mass: float) -> fx.System:
    """Build an inextensible planar cantilever of unit length, mass and stiffness with a point mass at its tip."""
    m = planar(n, EIz=1.0, mass_per_length=1.0)
    m.point_mass("tip mass", f"P{n}", mass)
    return m.build()


def spin_up(n: int, p: dict[str, float], second_order: bool = True) -> fx.System:
    """Build the planar beam that is spun up to the speed p["ws"] in the time p["T"]."""
    speed, T = p["ws"], p["T"]
    k = 2 * np.pi / T
    motion = (
        lambda t: speed / T * (t * t / 2 + (np.cos(k * t) - 1) / k**2) if t < T else speed * (t - T / 2),
        lambda t: speed / T * (t - np.sin(k * t) / k) if t < T else speed,
        lambda t: speed / T * (1 - np.cos(k * t)) if t < T else 0.0,
    )
    m = fx.Model()
    m.point("P0", (0, 0), fixed=True)
    m.angle("R0")
    m.prescribe("R0.angle", motion)
    lay(
        m, straight(n, p["L"], 2)[1:], EA=p["EA"], EIz=p["EI"], mass_per_length=p["rhoA"],
        second_order=second_order,
    )  # fmt: skip
    return m.build()


def tip_in_turning_frame(motion: fx.Motion, n: int, length: float) -> Array:
    """Return the displacement (nt, 2) of the tip along and across the clamped end's direction."""
    a, x, y = motion["R0.angle"], motion[f"P{n}.x"], motion[f"P{n}.y"]
    return np.stack([x * np.cos(a) + y * np.sin(a) - length, y * np.cos(a) - x * np.sin(a)], axis=1)
