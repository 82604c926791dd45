"""Linkages on which methods are compared and times are measured: a squeezer, a flyball governor, a ladder of cranks.

Andrews' squeezing mechanism has seven bodies in three loops, driven by a motor against a spring.  Source: Schiehlen
(1990), Multibody systems handbook; Hairer and Wanner (1996), VII.7, whose names are used.

The governor has two arms on a spindle, tied to a sliding collar by stiff springs with dampers.

The ladder is a row of cranks that couplers keep parallel.  Every pair of adjacent cranks closes a loop, and all move
in one motion, whose equation is known in closed form.
"""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array

SQUEEZER_SECONDS = 0.03
START = {  # angles of the squeezer when it starts [rad]
    "beta": -0.0617138900142764496358948458001,
    "gamma": 0.455279819163070380255912382449,
    "Phi": 0.222668390165885884674473185609,
    "delta": 0.487364979543842550225598953530,
    "Omega": -0.222668390165885884674473185609,
    "epsilon": 1.23054744454982119249735015568,
}
END = {  # angles after 0.03 s [rad]: the test set for initial value problem solvers, release 2.4
    "K1": 15.81077119629904,
    "K2": 15.81077119629904 - 15.75637105984298,
    "K3": 0.04082224013073101,
    "K4": -0.5347301163226948 + 0.5244099658805304,
    "K5": 0.5244099658805304,
    "K6": 0.5347301163226948 + 1.048080741042263,
    "K7": 1.048080741042263,
}
A, B, C = np.array([-0.06934, -0.00227]), np.array([-0.03635, 0.03273]), np.array([0.014, 0.072])
MASSES = 0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498  # [kg]
INERTIAS = 2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5  # [kg m²]
D, DA, E, EA, RR, RA, SS, SA, SB, SC, SD = (
    1e-5 * length for length in (2800, 1150, 2000, 1421, 700, 92, 3500, 1874, 1043, 1800, 2000)
)
TA, TB, U, UA, UB, ZF, ZT, FA = (1e-5 * length for length in (2308, 916, 4000, 1228, 449, 2000, 4000, 1421))
SPRING, FREE, MOMENT = 4530.0, 0.07785, 0.033  # [N/m], [m], [N m]

GOVERNOR_SECONDS = 0.5
SPEED = 8.0  # of the governor's spindle when it starts [rad/s]
STIFFNESS, DAMPING = 8e4, 40.0  # of its ties [N/m], [N s/m]

CRANK, SPACING = 0.2, 0.3  # length of a crank and of a coupler of the ladder [m]
MASS = 1.0  # of its bars per length [kg/m]
GRAVITY = 9.81
ANGLE, RATE = 0.7, 2.0  # of its cranks above the horizontal [rad], [rad/s]


def at(angle: float, along: float, across: float = 0.0) -> Array:
    """Return a vector (2,) from its components along a direction and to the left of it."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([along * c - across * s, along * s + across * c])


def squeezer() -> fx.System:
    """Build the squeezing mechanism; the angles of its bodies start at zero."""
    beta, gamma, delta, epsilon = (START[name] for name in ("beta", "gamma", "delta", "epsilon"))
    four, six = START["Phi"] + delta, START["Omega"] + epsilon
    P, F, edge = at(beta, RR), A + at(epsilon, 0, -U), A + at(delta, ZT)
    Q = P - at(beta, D)
    m = fx.Model()
    m.angle("ground", fixed=True)
    for name, place in {"O": np.zeros(2), "A": A, "B": B, "C": C}.items():
        m.point(name, place, fixed=True)
    for name, place in {"P": P, "Q": Q, "E": edge, "F": F, "D": B + at(gamma, SD, -SC)}.items():
        m.point(name, place)
    bodies = {  # from which point to which ones, and where the centre of mass is
        "K1": ("O", "P", at(beta, RA)),
        "K2": ("P", "Q", at(beta, -DA)),
        "K3": ("B", "QD", at(gamma, SB, -SA)),
        "K4": ("E", "Q", at(four, 0, -(E - EA))),
        "K5": ("A", "E", at(delta, TA, TB)),
        "K6": ("F", "Q", at(six, ZF - FA)),
        "K7": ("A", "F", at(epsilon, -UB, -UA)),
    }
    for (name, (start, ends, centre)), mass, inertia in zip(bodies.items(), MASSES, INERTIAS, strict=True):
        m.angle(name)
        m.body(f"body {name}", start, name, mass=mass, inertia=inertia, offset=tuple(centre))
        for end in ends:
            m.body_point(f"arm {start}{end} {name}", start, name, end)
    m.truss("spring", "C", "D")
    m.spring("spring.elongation", SPRING, free_length=FREE)
    m.hinge("motor", "ground", "K1")
    m.load("motor.angle", MOMENT)
    return m.build()


def governor() -> fx.System:
    """Build the governor, which is far from its steady motion when it starts."""
    m = fx.Model(gravity=(0, 0, -GRAVITY))
    m.point("O", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    spindle = m.frame("spindle")
    m.hinge("shaft", "G", spindle, axis=(0, 0, 1))
    m.rotary_inertia("rotor", spindle, (0.1, 0.1, 0.1, 0.0, 0.0, 0.0))
    collar = m.point("collar", (0.0, 0.0, -0.25))
    m.fix("collar.x", "collar.y")
    m.point_mass("collar mass", collar, 1.5)
    for i, side in enumerate((1.0, -1.0)):
        arm = m.frame(f"arm {i}")
        m.hinge(f"pivot {i}", spindle, arm, axis=(0, side, 0))
        ball = m.point(f"ball {i}", (0.15 * side, 0.0, -0.2))
        m.beam(f"bar {i}", "O", arm, ball, mass_per_length=0.5)
        m.point_mass(f"ball mass {i}", ball, 2.0)
        m.truss(f"tie {i}", ball, collar, stiffness=STIFFNESS, damping=DAMPING)
    m.initial("shaft.angle", rate=SPEED)
    return m.build()


def ladder(n: int) -> fx.System:
    """Build n planar cranks of uniform bars, and n - 1 couplers between their tips."""
    m = fx.Model(gravity=(0, -GRAVITY))
    for i in range(n):
        m.point(f"a{i}", (SPACING * i, 0), fixed=True)
        m.point(f"b{i}", (SPACING * i + CRANK * np.cos(ANGLE), CRANK * np.sin(ANGLE)))
        m.truss(f"crank{i}", f"a{i}", f"b{i}", mass_per_length=MASS)
    for i in range(1, n):
        m.truss(f"coupler{i}", f"b{i - 1}", f"b{i}", mass_per_length=MASS)
    m.independent("b0.x")
    return m.build()


def ladder_state() -> Array:
    """Return the degree of freedom of the moving ladder and its rate (2,), as for `System.rhs`."""
    return np.array([CRANK * np.cos(ANGLE), -CRANK * np.sin(ANGLE) * RATE])


def ladder_error(rates: Array, n: int) -> float:
    """Return the relative error of the cranks' acceleration, from what `System.rhs` (2,) is at that state."""
    angular = (rates[1] + CRANK * np.cos(ANGLE) * RATE**2) / (-CRANK * np.sin(ANGLE))
    return abs(float(angular) / cranks_acceleration(n) - 1)


def cranks_acceleration(n: int) -> float:
    """Return the acceleration of n cranks, as one body on a hinge [rad/s²]: couplers do not turn."""
    crank, coupler = MASS * CRANK, MASS * SPACING
    inertia = (n * crank / 3 + (n - 1) * coupler) * CRANK**2
    return -float(GRAVITY * (n * crank / 2 + (n - 1) * coupler) * CRANK * np.cos(ANGLE) / inertia)
