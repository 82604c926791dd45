"""Andrews' squeezing mechanism: seven bodies in three loops, driven by a motor against a spring.

Source: Schiehlen (1990), Multibody systems handbook; Hairer and Wanner (1996), VII.7, whose names are used.
"""

from __future__ import annotations

import numpy as np

import flexel as fx
from flexel.base.arrays import Array

SECONDS = 0.03
START = {  # angles when it starts [rad]
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


def at(angle: float, along: float, across: float = 0.0) -> Array:
    """Return a vector (2,) from its components along a direction and to the left of it."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([along * c - across * s, along * s + across * c])


def squeezer() -> fx.System:
    """Build the mechanism; the angles of its bodies start at zero."""
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
