"""The elements of the SPACAR talk (slides 8 and 12 to 16), and some more, each in a small model.

Pages show these models with all modes of their elements, and the tests count the modes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import flexel as fx
from flexel.apps.view.drawing import Sketch

SMALL = (0.1, 0.1, 0.1)  # moments of inertia [kg m²] of the bodies at frames


@dataclass(frozen=True)
class Shown:
    """An element as pages show it.

    Attributes
    ----------
    make : callable
        A model in which the element has its own name from the list of elements.
    amount : float
        How far it is moved along its modes, see `flexel.apps.view.element_modes.element_modes`.
    sketches : sequence of Sketch
        Outlines of the bodies of an element that has no shape of its own.
    """

    make: Callable[[], fx.Model]
    amount: float = 0.35
    sketches: Sequence[Sketch] = ()


def planar_truss() -> fx.Model:
    """Return a bar between two points."""
    m = fx.Model(gravity=(0, 0))
    for name, x in (("p", 0.0), ("q", 1.0)):
        m.point_mass(f"{name} mass", m.point(name, (x, 0)), 1.0)
    m.truss("planar_truss", "p", "q")
    return m


def planar_beam() -> fx.Model:
    """Return a beam between two points with angles."""
    m = fx.Model(gravity=(0, 0))
    for name, x in (("p", 0.0), ("q", 1.0)):
        m.body(f"{name} body", m.point(name, (x, 0)), m.angle(f"r{name}"), mass=1.0, inertia=1.0)
    m.beam("planar_beam", "p", "rp", "q", "rq", EA=1.0, EIz=1.0)
    return m


def truss() -> fx.Model:
    """Return a bar between two points in space."""
    m = fx.Model()
    for name, x in (("p", 0.0), ("q", 1.0)):
        m.point_mass(f"{name} mass", m.point(name, (x, 0, 0)), 1.0)
    m.truss("truss", "p", "q")
    return m


def hinge() -> fx.Model:
    """Return a hinge between the frames of two bodies that have a point in common."""
    m = fx.Model()
    m.point("P", (0, 0, 0))
    for name in "pq":
        m.body(f"{name} body", "P", m.frame(name), mass=1.0, inertia=SMALL)
    m.hinge("hinge", "p", "q", axis=(1, 0, 0))
    return m


def beam() -> fx.Model:
    """Return a beam between two points with frames."""
    m = fx.Model()
    for name, x in (("p", 0.0), ("q", 1.0)):
        m.body(f"{name} body", m.point(name, (x, 0, 0)), m.frame(f"r{name}"), mass=1.0, inertia=SMALL)
    m.beam("beam", "p", "rp", "q", "rq", section=fx.Rectangle(height=0.06, width=0.12), material="steel")
    return m


def wheel() -> fx.Model:
    """Return a wheel on a level road; z points up."""
    m = fx.Model()
    m.point("w", (0, 0, 0.5))
    m.frame("r")
    m.point("c", (0, 0, 0))
    m.body("disc", "w", "r", mass=1.0, inertia=SMALL)
    m.wheel("wheel", "w", "r", "c", radius=0.5, axle=(0, 1, 0))
    return m


ELEMENTS: Mapping[str, Shown] = {
    "planar_truss": Shown(planar_truss),
    "planar_beam": Shown(planar_beam),
    "truss": Shown(truss),
    "hinge": Shown(
        hinge,
        0.5,
        [
            Sketch("P", "p", [(-0.5, 0, 0), (0, 0, 0)]),
            Sketch("P", "q", [(0, 0, 0), (0, 0.35, 0), (0.5, 0.35, 0)]),
        ],
    ),
    "beam": Shown(beam, 0.45),
    "wheel": Shown(wheel, 0.25),
}
