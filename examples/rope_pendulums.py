"""Ropes over a sheave with one end swinging: the rope wraps and unwraps, its other end held or carrying a mass."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.rope_models import THIN, WHEEL, G
from flexel.examples.rope_table import over_meshes
from flexel.parts.rope import Rope
from flexel.results.reproduction import Quantity

BOB = 1.0  # mass that swings [kg]
FREE = 0.5  # length from the sheave to the bob when the rope hangs straight down [m]
OTHER = 0.4  # length on the other side at the start [m]
ROPE = 0.01  # mass of the rope per length [kg/m]
STICKS = 0.5  # coefficient of friction on a sheave that turns
STEP = 1e-3  # [s]
MESHES = (28, 56)


@dataclass(frozen=True)
class Swing:
    """A bob on a rope over a sheave, released at rest.

    Attributes
    ----------
    start : float
        Angle of the free rope from the vertical, away from the sheave [rad].
    duration : float
        [s]
    mass : float
        At the other end [kg]; zero: that end is held.
    inertia : float
        Of the sheave, which the rope turns by friction [kg m²]; with a held rope it is fixed and smooth.
    """

    start: float
    duration: float
    mass: float = 0.0
    inertia: float = 0.0


HELD = Swing(0.8, 3.0)
TURNING = Swing(1.0, 1.5, mass=1.2, inertia=2e-3)


# -- references -----------------------------------------------------------------------------------


def place(angle: Array | float, free: Array | float) -> Array:
    """Return positions (nt, 2) [m] of the bob from the axle, with the free length [m] at an angle from the vertical."""
    s, c = np.sin(angle), np.cos(angle)
    return np.stack([WHEEL * c + free * s, WHEEL * s - free * c], axis=-1)


def carried(free: float) -> tuple[float, float]:
    """Return first and second moment (kg m, kg m²) of the bob and the free rope about the end of the arc."""
    return BOB * free + ROPE * free**2 / 2, BOB * free**2 + ROPE * free**3 / 3


def exact(case: Swing, times: Array) -> Array:
    """Return positions (nt, 2) [m] of the bob from Lagrange's equations of an inextensible rope.

    The free rope is l = FREE + R θ + x long, where x has passed over the sheave.  At a distance z from the sheave it
    moves by zθ' across its direction and x' along it.
    """
    length = OTHER + WHEEL * np.pi + FREE

    def rates(t: float, y: Array) -> list[float]:  # noqa: ARG001 (of scipy's form)
        angle, x, spin, speed = y
        free = FREE + WHEEL * angle + x
        first, second = carried(free)
        turn = -first / second * (WHEEL * spin**2 + 2 * speed * spin + G * np.sin(angle))
        if not case.mass:
            return [spin, speed, turn, 0.0]
        hanging = OTHER - x + WHEEL * np.sin(angle) - free * np.cos(angle)  # more rope than on the bob's side
        pull = first * spin**2 + G * (BOB * np.cos(angle) - case.mass - ROPE * hanging)
        moved = BOB + case.mass + case.inertia / WHEEL**2 + ROPE * length
        return [spin, speed, turn, float(pull / moved)]

    y = solve_ivp(rates, (0, times[-1]), [case.start, 0, 0, 0], t_eval=times, rtol=1e-11, atol=1e-13).y
    return place(y[0], FREE + WHEEL * y[0] + y[1])


def period(start: float) -> float:
    """Return the period [s] of a bob on a rope that is held, released at an angle [rad], from its energy."""

    def energy(angle: float) -> float:
        free = FREE + WHEEL * angle
        rope = WHEEL**2 * np.cos(angle) + free * WHEEL * np.sin(angle) - free**2 / 2 * np.cos(angle)
        return float(G * (BOB * place(angle, free)[1] + ROPE * rope))

    highest = energy(start)
    far = float(brentq(lambda angle: energy(angle) - highest, -2 * start, -start / 2, xtol=1e-15))
    middle, half = (start + far) / 2, (start - far) / 2

    def share(phase: float) -> float:
        angle = middle + half * np.sin(phase)
        second = carried(FREE + WHEEL * angle)[1]
        return float(half * np.cos(phase) * np.sqrt(second / (2 * (highest - energy(angle)))))

    return 2 * float(quad(share, -np.pi / 2, np.pi / 2, epsabs=1e-10)[0])


# -- models ---------------------------------------------------------------------------------------


def swing(case: Swing, n: int) -> tuple[fx.System, Rope]:
    """Build the mechanism with a light, stiff rope of n elements; the bob is "B", the other end "A"."""
    m = fx.Model(gravity=(0, -G))
    C, still = m.point("C", (0, 0), fixed=True), m.angle("still", fixed=True)
    wheel = still
    if case.mass:
        wheel = m.angle("F")
        m.hinge("axle", still, wheel)
        m.body("wheel", C, wheel, mass=1.0, inertia=case.inertia)
    m.sheave("S", C, wheel, radius=WHEEL - THIN)
    A = m.point("A", (-WHEEL, -OTHER), fixed=not case.mass)
    if case.mass:
        m.point_mass("other", A, case.mass)
    B = m.point("B", place(case.start, FREE + WHEEL * case.start))
    m.point_mass("bob", B, BOB)
    contact = fx.Contact(1e11, friction=STICKS if case.mass else 0.0, slip_speed=1e-3, dissipation=10.0)
    rope = m.rope(
        "rope", [A, "S", B], n, contact=contact, radius=THIN, tension=BOB * G * np.cos(case.start), EA=1e6, EI=1e-6,
        mass_per_length=ROPE, damping=1e-3,
    )  # fmt: skip
    return m.build(), rope


@cache
def motion(case: Swing, n: int) -> tuple[fx.Motion, Rope]:
    """Simulate from rest, sampled every 0.02 s."""
    system, rope = swing(case, n)
    samples = round(case.duration / 0.02) + 1
    return system.simulate(
        case.duration,
        method="generalized-alpha",
        samples=samples,
        step=STEP,
        spectral_radius=0.5,
        progress=False,
    ), rope


def path(case: Swing, n: int) -> Array:
    """Return positions (nt, 2) [m] of the bob in that motion."""
    found = motion(case, n)[0]
    return np.stack([found["B.x"], found["B.y"]], axis=1)


def error(case: Swing, n: int) -> float:
    """Return the largest distance of the bob from the reference, over the length of the free rope."""
    away = path(case, n) - exact(case, motion(case, n)[0].t)
    return float(np.hypot(*away.T).max() / FREE)


def found_period(n: int) -> float:
    """Return the period [s] of the bob on a held rope, from passes through the vertical in the same direction."""
    times = motion(HELD, n)[0].t
    passes = CubicSpline(times, path(HELD, n)[:, 0] - WHEEL).roots(extrapolate=False)
    return float((passes[2:] - passes[:-2]).mean())


def rows() -> list[Quantity]:
    """Compare the pendulum that wraps around a sheave, and the swinging Atwood's machine."""
    lagrange = "Lagrange's equations of an inextensible rope, integrated; bob over the free length"
    return [
        over_meshes("wrapping_pendulum_error", lambda n: error(HELD, n), MESHES, 6e-4, lagrange, kind="own"),
        over_meshes("swinging_atwood_error", lambda n: error(TURNING, n), MESHES, 2.7e-4, lagrange, kind="own"),
        Quantity("wrapping_pendulum_period", found_period(MESHES[-1]), period(HELD.start), 5e-5, "s",
                 "energy integral", {"elements": MESHES[-1]}, kind="closed form"),
    ]  # fmt: skip
