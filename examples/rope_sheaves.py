"""Ropes in contact: capstan, Atwood's machine, Hertz's impact."""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.rope_table import over_meshes
from flexel.parts.rope import Rope
from flexel.results.reproduction import Quantity

WRAPS = (90.0, 180.0, 360.0, 540.0)  # of the capstan [degrees]
FRICTIONS = (0.1, 0.2, 0.35, 0.5)
PER_TURN = 36  # elements of the finest capstan per turn of wrap, and its straight parts are as long as six
ATWOOD = {"m1": 3.0, "m2": 2.0, "inertia": 0.02}
STEPS = (50, 100, 200)  # in the duration of the contact
HERTZ = "Hertz 1882; steps in the contact"
BALL = {"stiffness": 30769230769.23077, "mass": 0.03288200310757317, "speed": 1.0}  # a steel ball of 20 mm


# -- capstan --------------------------------------------------------------------------------------


@cache
def capstan_ratio(friction: float, degrees: float, n: int) -> float:
    """Return the tension at the held end over that at the pulled end, when the drum has slid for long."""
    system = models.capstan(n, friction, np.radians(degrees))
    motion = system.simulate(
        0.4, method="generalized-alpha", samples=3, rtol=1e-2, atol=1e-2, spectral_radius=0.0, progress=False
    )
    return float(np.hypot(motion[-1].force("rope_p0.x"), motion[-1].force("rope_p0.y")))


def capstan_elements(degrees: float) -> int:
    """Return the number of elements of the finest mesh for a wrap."""
    return 12 + round(PER_TURN * degrees / 360)


def capstan() -> list[Quantity]:
    """Compare all wraps and coefficients of friction on the finest mesh; the order for half a turn."""
    keys = [(mu, degrees) for mu in FRICTIONS for degrees in WRAPS]
    ratios = np.array([np.exp(mu * np.radians(degrees)) for mu, degrees in keys])
    found = np.array([capstan_ratio(mu, degrees, capstan_elements(degrees)) for mu, degrees in keys])

    def error(n: int) -> float:
        return abs(capstan_ratio(0.2, 180.0, n) / float(np.exp(0.2 * np.pi)) - 1)

    more = {
        "friction": list(FRICTIONS),
        "degrees": list(WRAPS),
        "elements": [capstan_elements(wrap) for wrap in WRAPS],
    }
    return [
        over_meshes("capstan_error", error, (12, 24, 48), 1e-4, "exp(mu phi) (Euler 1769), mu = 0.2, half a turn"),
        Quantity("capstan_ratios_error", found / ratios - 1, 0 * ratios, 5e-3, "", "exp(mu phi), 16 cases", more,
                 kind="closed form"),
    ]  # fmt: skip


# -- Atwood's machine -----------------------------------------------------------------------------


@cache
def atwood_motion(n: int, mass: float, duration: float = 0.3) -> tuple[fx.Motion, Rope]:
    """Simulate Atwood's machine from rest with a rope of a mass per length."""
    system, rope = models.atwood(n, mass=mass, **ATWOOD)
    return system.simulate(
        duration, method="generalized-alpha", samples=31, step=2e-3, spectral_radius=0.5, progress=False
    ), rope


def atwood_error(n: int, mass: float) -> float:
    """Return the largest error of the fall over the fall at the end."""
    motion, rope = atwood_motion(n, mass)
    fall = motion["A.y"][0] - motion["A.y"]
    given = exact.atwood_fall(motion.t, rope=mass, length=float(rope.s[-1]), radius=models.WHEEL, **ATWOOD)
    return float(abs(fall - given).max() / given[-1])


def atwood() -> list[Quantity]:
    """Compare light and heavy rope."""
    meshes = (14, 28, 56)
    return [
        over_meshes("atwood_error", lambda n: atwood_error(n, 1.0), meshes, 2.4e-4,
                    "fall with a heavy rope, cosh law; sheave with inertia"),
        over_meshes("atwood_light_rope_error", lambda n: atwood_error(n, 0.01), meshes[1:], 2e-4,
                    "(m1 - m2) g/(m1 + m2 + I/R²)"),
    ]  # fmt: skip


# -- Hertz's impact -------------------------------------------------------------------------------


@cache
def impact(steps: int, dissipation: float = 0.0) -> tuple[Array, Array, Array]:
    """Return times, heights and speeds of the ball with a number of steps in the duration of the contact."""
    h = exact.hertz(**BALL)[1] / steps
    count = round(1.25 * steps)
    system = models.bouncing(height=1e-6, dissipation=dissipation, **BALL)
    motion = system.simulate(
        count * h, method="generalized-alpha", samples=count + 1, step=h, spectral_radius=1.0, progress=False
    )
    return motion.t, motion["rope_p0.y"], motion["rope_p0.y'"]


def impact_errors(steps: int) -> tuple[float, float]:
    """Return the relative errors of the largest approach and of the duration.

    The lowest point is that of a parabola through three heights; the ends of the contact are where the height passes
    zero, with the speed there.
    """
    t, y, v = impact(steps)
    approach, duration = exact.hertz(**BALL)
    i = int(np.argmin(y))
    lowest = y[i] - (y[i + 1] - y[i - 1]) ** 2 / (8 * (y[i + 1] - 2 * y[i] + y[i - 1]))
    inside = np.flatnonzero(y < 0)
    begin, end = (t[k] - y[k] / v[k] for k in (inside[0] - 1, inside[-1] + 1))
    return abs(-lowest / approach - 1), abs((end - begin) / duration - 1)


def hertz() -> list[Quantity]:
    """Compare approach and duration; speed after an impact with dissipation."""
    rows = [
        over_meshes("hertz_error", lambda k: impact_errors(k)[0], STEPS, 6e-5, f"approach, {HERTZ}", 1),
        over_meshes("hertz_duration_error", lambda k: impact_errors(k)[1], STEPS, 6e-5, f"duration, {HERTZ}", 1),
    ]  # fmt: skip
    restitution = [float(impact(100, _dissipation(e))[2][-1]) for e in (0.6, 0.8, 0.9)]
    rows.append(Quantity("restitution", restitution, (0.7561486806625201, 0.8471022797901452, 0.9131766778073924),
                         2e-4, "", "Lankarani and Nikravesh's law with e = 0.6, 0.8, 0.9, integrated",
                         kind="own"))  # fmt: skip
    return rows


def _dissipation(e: float) -> float:
    """Return the dissipation of Lankarani and Nikravesh's law, for a coefficient of restitution at the ball's speed."""
    contact = fx.Contact.restitution(BALL["stiffness"], e, BALL["speed"], law="lankarani-nikravesh")
    return contact.dissipation


def rows() -> list[Quantity]:
    """Compare capstan, Atwood's machine, Hertz's impact."""
    return [*capstan(), *atwood(), *hertz()]
