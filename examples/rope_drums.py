"""A winch whose drum has a helical groove: the rope that winds on moves sideways by the lead per turn."""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples.rope_models import G
from flexel.parts.rope import Rope
from flexel.results.reproduction import Quantity

RADIUS, ROPE, LEAD = (
    0.2,
    0.01,
    0.03,
)  # of the rope's centre line on the drum, of the rope; axial distance of turns [m]
LOAD, DEPTH = 100.0, 3.2  # [kg], and below the axle at the start [m]
TURNS, DURATION = 2.0, 4.0  # of the drum, and their time [s]
CONTACT = fx.Contact(1e11, friction=0.3, slip_speed=1e-3, dissipation=10.0)
ELEMENTS = 60


@cache
def wound(lead: float = LEAD, n: int = ELEMENTS) -> tuple[fx.Motion, Rope]:
    """Hang the load from half a turn on a drum about x, which then turns twice, from rest to rest."""
    m = fx.Model(gravity=(0, 0, -G))
    m.point("C", (0, 0, 0), fixed=True)
    m.frame("G", fixed=True)
    m.frame("F")
    m.hinge("axle", "G", "F", axis=(1, 0, 0))
    m.body("drum", "C", "F", mass=1.0, inertia=(1.0, 1.0, 1.0))
    groove = fx.HelicalGroove(1.08 * ROPE, lead=lead, start=(0, 1, 0))
    m.sheave("D", "C", "F", radius=RADIUS - ROPE, axle=(1, 0, 0), groove=groove)
    load = m.point("load", (0, RADIUS, -DEPTH))
    m.point_mass("mass", load, LOAD)
    rope = m.rope(
        "rope", [("D", -1), load], n, turns=0.5, contact=CONTACT, radius=ROPE, tension=LOAD * G, EA=1e7, EI=1e-3,
        mass_per_length=0.1, damping=1e-3,
    )  # fmt: skip
    angle, rate = 2 * np.pi * TURNS, 2 * np.pi / DURATION
    m.prescribe("axle.angle", (
        lambda t: angle * (t / DURATION - np.sin(rate * t) / (2 * np.pi)),
        lambda t: angle / DURATION * (1 - np.cos(rate * t)),
        lambda t: angle / DURATION * rate * np.sin(rate * t),
    ))  # fmt: skip
    return m.build().simulate(
        DURATION, method="generalized-alpha", step=4e-3, spectral_radius=0.5, samples=21, progress=False
    ), rope


def places(state: fx.State, rope: Rope) -> Array:
    """Return positions (n + 1, 3) of the rope's nodes: along the axle [m], radius [m], angle [rad] with its turns."""
    x = np.array([state.position(p.name) for p in rope.points])
    angle = np.unwrap(np.arctan2(x[:, 2], x[:, 1]))
    return np.stack([x[:, 0], np.hypot(x[:, 1], x[:, 2]), angle], axis=1)


def lift(lead: float = LEAD) -> tuple[float, float]:
    """Return the height [m] by which the load is lifted, and the length of the helix that was wound."""
    z = wound(lead)[0]["load.z"]
    radius = RADIUS - CONTACT.depth(LOAD * G / RADIUS, 0.0)
    return float(z[-1] - z[0]), TURNS * float(np.hypot(2 * np.pi * radius, lead))


def groove_error(lead: float = LEAD) -> float:
    """Return the largest axial distance of the rope from the helix over the lead; without the last quarter turn."""
    motion, rope = wound(lead)
    along, _, angle = places(motion[-1], rope)[rope.s < 2 * np.pi * RADIUS * (TURNS + 0.25)].T
    return float(abs(along - along[0] - lead / (2 * np.pi) * (angle - angle[0])).max() / abs(lead))


def rows() -> list[Quantity]:
    """Lift and sideways motion of the winch."""
    found, given = lift()
    more = {"elements": ELEMENTS}
    return [
        Quantity("helical_winch_lift", found, given, 4.5e-5, "m", "length of two turns of the helix", more,
                 kind="closed form"),
        Quantity("helical_winch_groove_error", groove_error(), 0.0, 1.7e-4, "lead",
                 "helix; without the last quarter turn", more, kind="closed form"),
    ]  # fmt: skip
