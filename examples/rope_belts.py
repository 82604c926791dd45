"""A closed belt around two pulleys that transmits a torque: tensions, creep and arcs of slip."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.rope_models import THIN, WHEEL, run_up
from flexel.examples.rope_table import over_meshes
from flexel.parts.rope import Rope
from flexel.results.reproduction import Quantity

SPAN = 0.5  # between the axles [m]
EA, EI, MASS = 2e4, 1e-4, 0.05  # stiffnesses [N], [N m²] and mass per length [kg/m]
FRICTION, TORQUE, SPEED = (
    0.3,
    6.0,
    10.0,
)  # the driven pulley resists with the torque [N m]; speed of the driver [rad/s]
START, END, SETTLED = 0.3, 1.6, 1.2  # end of the run-up, of the motion, and begin of what is averaged [s]
MESHES = (48, 96)
SOURCE = "creep of an elastic belt (Euler-Eytelwein)"
VIBRATIONS = "what is left of the vibrations, which differs between machines"


@dataclass(frozen=True)
class BeltDrive:
    """The steady motion: tight and slack tension [N], creep, and the angle [rad] over which each pulley slips."""

    tight: float
    slack: float
    creep: float
    slip: float


def exact(length: float) -> BeltDrive:
    """Return the closed form for a belt of an undeformed length [m] on rigid pulleys, with the inertia of the belt.

    A belt adheres where it runs onto a pulley, with the tension that it brings, and slips before it leaves: the
    tension less ρA v² changes by exp(μ φ) over the angle φ.  The pulleys turn with the speeds of the belt where it
    adheres, tight on the driver and slack on the driven one; the undeformed length that passes is the same
    everywhere.
    """
    step, inertia = TORQUE / WHEEL, MASS * (SPEED * WHEEL) ** 2

    def slip(slack: float) -> float:
        return float(np.log((slack + step - inertia) / (slack - inertia)) / FRICTION)

    def undeformed(slack: float) -> float:
        tight, phi = slack + step, slip(slack)

        def share(angle: float) -> float:
            return WHEEL / float(1 + (inertia + (tight - inertia) * np.exp(-FRICTION * angle)) / EA)

        sides = sum((SPAN + WHEEL * (np.pi - phi)) / (1 + T / EA) for T in (tight, slack))
        return float(sides + 2 * quad(share, 0, phi)[0])

    least = inertia + step / (np.exp(FRICTION * np.pi) - 1)  # below it, the whole wrap slips
    slack = float(brentq(lambda T: undeformed(T) - length, least, 10 * EA, xtol=1e-12))
    tight = slack + step
    return BeltDrive(tight, slack, 1 - (1 + slack / EA) / (1 + tight / EA), slip(slack))


def belt(n: int, space: bool = False) -> tuple[fx.System, Rope]:
    """Build a driver, whose speed grows to its value, and a driven pulley, whose torque grows with it."""
    m, size = fx.Model(), 3 if space else 2
    for name, x in (("A", 0.0), ("B", SPAN)):
        m.point(name, (x, 0.0, 0.0)[:size], fixed=True)
    for name in ("ground", "driver", "driven"):
        (m.frame if space else m.angle)(name, fixed=name == "ground")
    axis = {"axis": (0, 0, 1)} if space else {}
    for axle, pulley, point in (("drive", "driver", "A"), ("output", "driven", "B")):
        m.hinge(axle, "ground", pulley, **axis)
        m.body(f"{pulley} wheel", point, pulley, mass=1.0, inertia=[5e-3, 5e-3, 1e-2] if space else 1e-2)
        m.sheave(pulley, point, pulley, radius=WHEEL - THIN)
    contact = fx.Contact(1e12, friction=FRICTION, slip_speed=1e-4, dissipation=10.0)
    rope = m.rope(
        "belt", [("driver", 1), ("driven", 1)], n, closed=True, contact=contact, radius=THIN, tension=100.0,
        EA=EA, EI=EI, mass_per_length=MASS, damping=1e-3,
    )  # fmt: skip
    m.prescribe("drive.angle", run_up(SPEED, 0.0, START))
    _, resisted, growth = run_up(-TORQUE, 0.0, START)
    m.load("output.angle", (resisted, growth, lambda t: 0.0))
    return m.build(), rope


@cache
def found(n: int, space: bool = False) -> BeltDrive:
    """Measure the same in a motion, averaged over its last part; the slip angle from the tension along the driver."""
    system, rope = belt(n, space)
    motion = system.simulate(
        END, method="generalized-alpha", step=2e-3, samples=161, spectral_radius=0.5, progress=False
    )
    steady = [state for state in motion if state.t > SETTLED]
    spans = np.array([_spans(state, rope) for state in steady]).mean(axis=0)
    rate = motion.rate("output.angle")[motion.t > SETTLED].mean()
    ratio = float((spans[0] - MASS * (SPEED * WHEEL) ** 2) / (spans[1] - MASS * (SPEED * WHEEL) ** 2))
    return BeltDrive(
        float(spans[0]), float(spans[1]), 1 - float(rate) / SPEED, float(np.log(ratio)) / FRICTION
    )


def _spans(state: fx.State, rope: Rope) -> Array:
    """Return the tension (2,) in the middle of the tight and of the slack part, the upper and the lower one."""
    places = np.array([state.position(point.name)[:2] for point in rope.points])
    middles = (places + np.roll(places, -1, axis=0)) / 2
    T = rope.tension(state)[1].reshape(-1, 3).mean(axis=1)
    free = abs(middles[:, 0] - SPAN / 2) < SPAN / 4
    return np.array([T[free & (side * middles[:, 1] > 0)].mean() for side in (1, -1)])


def errors(n: int, space: bool = False) -> tuple[float, float]:
    """Return the relative error of the creep, and the larger one of the two tensions."""
    drive = found(n, space)
    given = exact(float(belt(n)[1].s[-1]))
    tensions = abs(drive.tight / given.tight - 1), abs(drive.slack / given.slack - 1)
    return abs(drive.creep / given.creep - 1), max(tensions)


def rows() -> list[Quantity]:
    """Compare creep, tensions, torque; the belt in space."""
    n = MESHES[-1]
    drive, given = found(n), exact(float(belt(n)[1].s[-1]))
    flat, space = found(MESHES[0]), found(MESHES[0], space=True)
    return [
        over_meshes("belt_creep_error", lambda n: errors(n)[0], MESHES, 0.045, SOURCE),
        over_meshes("belt_tension_error", lambda n: errors(n)[1], MESHES, 5e-3, f"tight and slack side, {SOURCE}"),
        Quantity("belt_creep", drive.creep, given.creep, 0.045, "", SOURCE, {"elements": n}, kind="closed form"),
        Quantity("belt_tensions", [drive.tight, drive.slack], [given.tight, given.slack], 5e-3, "N", SOURCE,
                 {"elements": n}, kind="closed form"),
        Quantity("belt_torque", (drive.tight - drive.slack) * WHEEL, TORQUE, 1e-3, "N m", "torque of the driven pulley",
                 {"elements": n}, kind="closed form", reason=VIBRATIONS),
        Quantity("belt_slip_angle", drive.slip, given.slip, 0.005, "rad", f"of each pulley, {SOURCE}", {"elements": n},
                 kind="closed form"),
        Quantity("belt_in_space", [space.tight, space.slack], [flat.tight, flat.slack], 2e-3, "N",
                 "the same belt in the plane", {"elements": MESHES[0]}, kind="own", reason=VIBRATIONS),
    ]  # fmt: skip
