"""Spatial families of the campaign "no step onto another branch": bodies on hinges and balls, a loop, a wheel."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from branch_case import Case
from references import Balls, Constrained

import flexel as fx
from flexel.base.arrays import Array

Rng = np.random.Generator
BODY = np.array([0.02, 0.03, 0.04])  # moments of inertia [kg m²]
MASSES = (1.0, 0.6)  # [kg]
Maker = Callable[[], fx.Model]


def case(name: str, model: Maker, good: tuple[str, ...], candidates: Sequence[str], **options: Any) -> Case:
    """A motion compared in all free coordinates and in the angles among the good ones."""
    m = model()
    m.independent(*good)
    reference = Constrained(m.build(), [coordinate for coordinate in good if coordinate.endswith(".angle")])
    size = max(float(np.max(np.abs(node.x0))) for node in m.nodes.values() if node.kind == "point")

    def exact() -> Callable[[Array], Array]:
        y = reference.follow(1.0)
        return lambda t: reference.values(y(t))

    return Case(name, model, good, tuple(candidates), reference.names, exact, size, **options)


def points(*names: str) -> tuple[str, ...]:
    """Coordinates of points."""
    return tuple(f"{name}.{axis}" for name in names for axis in "xyz")


def parameters(*names: str) -> tuple[str, ...]:
    """Euler parameters of frames."""
    return tuple(f"{name}.lambda{i}" for name in names for i in range(4))


def _bodies(rng: Rng) -> Callable[[], fx.Model]:
    """Two bodies at the ends of two random links, their orientations still free."""
    places = np.cumsum(rng.uniform(-0.6, 0.6, (2, 3)), axis=0)

    def made() -> fx.Model:
        m = fx.Model(gravity=(0, 0, -9.81))
        last = m.point("O", (0, 0, 0), fixed=True)
        for i, place in enumerate(places):
            end, frame = m.point(f"P{i}", place), m.frame(f"F{i}")
            m.body_point(f"link{i}", last, frame, end)
            m.body(f"body{i}", end, frame, mass=MASSES[i], inertia=BODY)
            last = end
        return m

    return made


def spatial(name: str, rng: Rng) -> Case:
    """A spatial double pendulum on hinges about random axes."""
    bodies, axes, speeds = _bodies(rng), rng.normal(size=(2, 3)), rng.uniform(-6, 6, 2)

    def model() -> fx.Model:
        m = bodies()
        last = m.frame("ground", fixed=True)
        for i, axis in enumerate(axes):
            m.hinge(f"h{i}", last, f"F{i}", axis=axis)
            m.initial(f"h{i}.angle", rate=speeds[i])
            last = m.nodes[f"F{i}"]
        return m

    return case(name, model, ("h0.angle", "h1.angle"), points("P0", "P1") + parameters("F1"))


def ball(name: str, rng: Rng) -> Case:
    """A spatial double pendulum on two ball joints: six degrees of freedom, and no coordinates regular throughout."""
    bodies, omega = _bodies(rng), rng.uniform(-5, 5, (2, 3))

    def model() -> fx.Model:
        m = bodies()
        for i in range(2):
            sensor = m.angular_velocity(f"F{i}")
            for axis, rate in zip("xyz", omega[i], strict=True):
                m.initial(f"{sensor}.w{axis}", rate=rate)
        return m

    m = model()
    ends = np.array([m.nodes[f"P{i}"].x0 for i in range(2)])
    links = Balls(np.diff(ends, axis=0, prepend=np.zeros((1, 3))), MASSES, BODY, omega)
    bad = points("P0", "P1") + parameters("F0", "F1")
    return Case(name, model, (), bad, links.names, links.follow, degrees=6, worst=1.0)


def rssr(name: str, rng: Rng) -> Case:
    """A closed spatial loop: a crank that turns fully, a rocker, and a coupler between ball joints."""
    drawn = np.array(
        [(0.8, 0.3, 0.2), (0.8, 1.03, -0.24), (1.0, 0.1, 0.1)]
    )  # margin of 0.1 m for a full turn
    d, c, axis = drawn + rng.uniform(-0.03, 0.03, (3, 3))
    rate = rng.choice([-1, 1]) * rng.uniform(4, 12)

    def model() -> fx.Model:
        m = fx.Model(gravity=(0, 0, -9.81))
        m.point("A", (0, 0, 0), fixed=True)
        m.point("D", d, fixed=True)
        m.point("B", (0, 0.15, 0))
        m.point("C", c)
        ground, crank, rocker = (
            m.frame(name, fixed=name == "ground") for name in ("ground", "crank", "rocker")
        )
        m.hinge("input", ground, crank, axis=(0, 0, 1))
        m.hinge("output", ground, rocker, axis=axis)
        m.beam("crank bar", "A", crank, "B", mass_per_length=1.0)
        m.beam("rocker bar", "D", rocker, "C", mass_per_length=1.0)
        m.truss("coupler", "B", "C", mass_per_length=0.5)
        m.body("flywheel", "A", crank, mass=1.0, inertia=(0.2, 0.2, 0.2))
        m.initial("input.angle", rate=rate)
        return m

    bad = ("output.angle", *points("B", "C"), *parameters("rocker"))
    return case(name, model, ("input.angle",), bad)


def wheel(name: str, rng: Rng) -> Case:
    """A disc that rolls and turns on a plane."""
    lean, rates = rng.uniform(-0.4, 0.4), rng.uniform((-2, -0.5, 8), (2, 0.5, 20))
    axle, up = np.array((0, np.cos(lean), np.sin(lean))), np.array((0, -np.sin(lean), np.cos(lean)))
    xx, yy, zz = 0.08 + 0.08 * axle**2
    good = ("yaw.angle", "lean.angle", "roll.angle")

    def model() -> fx.Model:
        m = fx.Model(gravity=(0, 0, -9.81))
        ground, yawed, leaned, rolled = (
            m.frame(name, fixed=name == "ground") for name in ("ground", "Y", "L", "S")
        )
        m.point("hub", 0.4 * up)
        m.point("contact", (0, 0, 0))
        m.hinge("yaw", ground, yawed, axis=(0, 0, 1))
        m.hinge("lean", yawed, leaned, axis=(1, 0, 0))
        m.hinge("roll", leaned, rolled, axis=axle)
        m.wheel("wheel", "hub", rolled, "contact", radius=0.4, axle=axle)
        m.body("disc", "hub", rolled, mass=2.0, inertia=(xx, yy, zz, 0, 0, 0.08 * axle[1] * axle[2]))
        for angle, rate in zip(good, rates, strict=True):
            m.initial(angle, rate=rate)
        return m

    bad = (*good, *points("hub", "contact"), *parameters("S"))
    return case(name, model, good, bad)


SPATIAL: dict[str, Callable[[str, Rng], Case]] = {
    "spatial": spatial,
    "ball": ball,
    "rssr": rssr,
    "wheel": wheel,
}
