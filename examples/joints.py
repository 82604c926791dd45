"""Every joint of `Model` in a small model, with the names of the motions that it leaves free.

The page on joints shows these models, and the tests build them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

import flexel as fx
from flexel.apps.view.drawing import Sketch

Make = Callable[[], fx.Model]
Vector = tuple[float, float, float]
UNIT = (1.0, 1.0, 1.0)
O, X, Y, Z = (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Shown:
    """A joint as the page shows it.

    Attributes
    ----------
    make : callable
        The model; all its bodies but one pair are held.
    free : tuple of str
        What the joint leaves free: the degrees of freedom of the model.
    moved : mapping of str to float
        Where the second picture is taken.
    boxes : mapping of str to pairs of corners
        Drawn with a body: two opposite corners of a box in global axes as drawn, by the name of the body.
    axes : sequence of (point, direction)
        Axes of the joint as drawn.
    """

    make: Make
    free: tuple[str, ...]
    moved: Mapping[str, float]
    boxes: Mapping[str, Sequence[tuple[Sequence[float], Sequence[float]]]] = field(default_factory=dict)
    axes: Sequence[tuple[Vector, Vector]] = ()


def spatial(*places: tuple[float, float, float], joint: Callable[[fx.Model], object]) -> Make:
    """Return a function that builds bodies ``a``, ``b`` … at given points, and a joint."""

    def make() -> fx.Model:
        m = fx.Model()
        for name, place in zip("abc", places, strict=False):
            m.rigid_body(name, place, mass=1.0, inertia=UNIT)
        joint(m)
        return m

    return make


def planar(*places: tuple[float, float], joint: Callable[[fx.Model], object]) -> Make:
    """Return the same function for the plane."""

    def make() -> fx.Model:
        m = fx.Model(gravity=(0, 0))
        for name, place in zip("abc", places, strict=False):
            m.rigid_body(name, place, mass=1.0, inertia=1.0)
        joint(m)
        return m

    return make


def spur(m: fx.Model) -> None:
    """Add two gears on parallel shafts."""
    m.revolute("shaft_a", "ground", "a", at=O, axis=Z)
    m.revolute("shaft_b", "ground", "b", at=(0.9, 0, 0), axis=Z)
    m.gear("mesh", "shaft_a", "shaft_b", at=(0.3, 0, 0), teeth=(20, 40))


def bevel(m: fx.Model) -> None:
    """Add two gears on shafts at right angles."""
    m.revolute("shaft_a", "ground", "a", at=O, axis=X)
    m.revolute("shaft_b", "ground", "b", at=(0.6, 0, 0.3), axis=Z)
    m.gear("mesh", "shaft_a", "shaft_b", at=(0, 0, 0.3), teeth=(20, 40))


def worm(m: fx.Model) -> None:
    """Add a worm below its wheel."""
    m.revolute("shaft_a", "ground", "a", at=O, axis=X)
    m.revolute("shaft_b", "ground", "b", at=(0, 0, 0.6), axis=Y)
    m.gear("mesh", "shaft_a", "shaft_b", at=(0, 0, 0.1), lead=0.08)


def rack(m: fx.Model) -> None:
    """Add a pinion on a rack."""
    m.revolute("shaft", "ground", "a", at=(0, 0))
    m.prismatic("guide", "ground", "b", axis=(1, 0))
    m.rack_and_pinion("teeth", "shaft", "guide", at=(0, -0.3))


def belt(m: fx.Model) -> None:
    """Add two pulleys."""
    m.revolute("shaft_a", "ground", "a", at=(0, 0))
    m.revolute("shaft_b", "ground", "b", at=(1, 0))
    m.belt("belt", "shaft_a", "shaft_b", radius_p=0.2, radius_q=0.4)


def lobe(angle: float) -> float:
    """Return the outline of a cam: a circle with a nose."""
    return float(0.3 + 0.2 * np.exp(-6 * (1 - np.cos(angle))))


def gimbal(m: fx.Model) -> None:
    """Add a body that turns about its mass centre."""
    m.fix("a")
    m.cardan_chain("yaw", "lean", "pitch", body="a")


def socket(m: fx.Model) -> None:
    """Add a ball joint, and the angles of its turns."""
    m.spherical("j", "a", "b", AT)
    m.cardan_chain("yaw", "lean", "pitch", body="b", base="a")


def valve(m: fx.Model) -> None:
    """Add a cam and a follower that slides."""
    m.revolute("shaft", "ground", "a", at=(0, 0))
    m.prismatic("guide", "ground", "b", axis=(0, 1))
    m.cam("lobe", "a", "b", at=(0, lobe(np.pi / 2)), outline=lobe, start=(1, 0))


def support(angle: float) -> float:
    """Return the distance of a flat face from the centre of an egg-shaped cam."""
    return float(0.36 + 0.08 * np.cos(angle) + 0.02 * np.cos(2 * angle))


def tappet(m: fx.Model) -> None:
    """Add a cam and a follower with a flat face."""
    m.revolute("shaft", "ground", "a", at=(0, 0))
    m.prismatic("guide", "ground", "b", axis=(0, 1))
    m.cam("lobe", "a", "b", at=(0, support(np.pi / 2)), outline=support, start=(1, 0), face=(0, 1))


AT, LOW, HIGH = (0.5, 0.0, 0.0), (-0.5, -0.1, -0.1), (0.5, 0.1, 0.1)
ROD = {"a": [(LOW, HIGH)], "b": [((0.5, -0.08, -0.08), (1.5, 0.08, 0.08))]}
PAIR = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))


def on_a(joint: Callable[[fx.Model], object]) -> Make:
    """Return a function that builds two rods in line along x; the first is held, and the joint is between them."""

    def both(m: fx.Model) -> None:
        m.fix("a", "a_frame")
        joint(m)

    return spatial(*PAIR, joint=both)


JOINTS: dict[str, Shown] = {
    "revolute": Shown(on_a(lambda m: m.revolute("j", "a", "b", AT, Z)), ("j.angle",), {"j.angle": 0.6}, ROD,
        axes=[(AT, Z)],
    ),
    "prismatic": Shown(on_a(lambda m: m.prismatic("j", "a", "b", X)), ("j.axial",), {"j.axial": 0.4}, ROD,
        axes=[(AT, X)],
    ),
    "cylindrical": Shown(
        on_a(lambda m: m.cylindrical("j", "a", "b", AT, X)), ("j.angle", "j.axial"),
        {"j.angle": 0.6, "j.axial": 0.4}, ROD,
        axes=[(AT, X)],
    ),
    "screw": Shown(
        on_a(lambda m: m.screw("j", "a", "b", AT, X, pitch=1.0)), ("j.angle",), {"j.angle": 2.0}, ROD,
        axes=[(AT, X)],
    ),
    "planar_joint": Shown(
        on_a(lambda m: m.planar_joint("j", "a", "b", Z)), ("j.angle", "j.radial1", "j.radial2"),
        {"j.angle": 0.5, "j.radial1": 0.3, "j.radial2": 0.1}, ROD,
        axes=[(AT, Z)],
    ),
    "spherical": Shown(
        on_a(socket),
        ("yaw.angle", "lean.angle", "pitch.angle"), {"yaw.angle": 0.4, "lean.angle": 0.5, "pitch.angle": -0.4}, ROD,
    ),
    "universal": Shown(
        on_a(lambda m: m.universal("j", "a", "b", AT, Z, Y)), ("j_1.angle", "j_2.angle"),
        {"j_1.angle": 0.4, "j_2.angle": -0.4}, ROD,
        axes=[(AT, Z), (AT, Y)],
    ),
    "weld": Shown(on_a(lambda m: m.weld("j", "a", "b", AT)), (), {}, ROD),
    "gear": Shown(
        spatial(O, (0.9, 0.0, 0.0), joint=spur), ("shaft_a.angle",), {"shaft_a.angle": 0.8},
        axes=[(O, Z), ((0.9, 0.0, 0.0), Z)],
    ),
    "bevel": Shown(spatial(O, (0.6, 0.0, 0.3), joint=bevel), ("shaft_a.angle",), {"shaft_a.angle": 0.8},
        axes=[(O, X), ((0.6, 0.0, 0.3), Z)],
    ),
    "worm": Shown(spatial(O, (0.0, 0.0, 0.6), joint=worm), ("shaft_a.angle",), {"shaft_a.angle": 6.0},
        axes=[(O, X), ((0.0, 0.0, 0.6), Y)],
    ),
    "rack_and_pinion": Shown(
        planar((0.0, 0.0), (0.0, -0.4), joint=rack), ("shaft.angle",), {"shaft.angle": 0.8},
        {"b": [((-0.6, -0.4, 0.0), (0.6, -0.3, 0.0))]},
    ),
    "belt": Shown(planar((0.0, 0.0), (1.0, 0.0), joint=belt), ("shaft_a.angle",), {"shaft_a.angle": 0.8}),
    "cam": Shown(
        planar((0.0, 0.0), (0.0, 0.8), joint=valve), ("shaft.angle",), {"shaft.angle": 1.2},
        {"b": [((-0.05, lobe(np.pi / 2), 0.0), (0.05, 1.0, 0.0))]},
    ),
    "flat_cam": Shown(
        planar((0.0, 0.0), (0.0, 0.8), joint=tappet), ("shaft.angle",), {"shaft.angle": -1.2},
        {"b": [((-0.05, support(np.pi / 2), 0.0), (0.05, 1.0, 0.0))]},
    ),
    "skate": Shown(
        planar((0.3, 0.0), joint=lambda m: m.skate("blade", "a", at=(0, 0), direction=(1, 0))),
        ("a.x", "a_frame.angle"), {"a.x": 0.6, "a_frame.angle": 0.4}, {"a": [((-0.1, -0.1, 0.0), (0.6, 0.1, 0.0))]},
    ),
    "cardan_chain": Shown(
        spatial(O, joint=gimbal),
        ("yaw.angle", "lean.angle", "pitch.angle"), {"yaw.angle": 0.4, "lean.angle": 0.5, "pitch.angle": 0.2},
        {"a": [((-0.5, -0.2, -0.1), (0.5, 0.2, 0.1))]},
        axes=[(O, Z), (O, X), (O, Y)],
    ),
}  # fmt: skip
DISCS: dict[str, list[tuple[str, tuple[float, float, float], tuple[float, float, float], float]]] = {
    "gear": [("a", O, Z, 0.3), ("b", (0.9, 0, 0), Z, 0.6)],
    "bevel": [("a", O, X, 0.3), ("b", (0.6, 0, 0.3), Z, 0.6)],
    "worm": [
        ("a", O, X, 0.1),
        ("a", (0.15, 0, 0), X, 0.1),
        ("a", (-0.15, 0, 0), X, 0.1),
        ("b", (0, 0, 0.6), Y, 0.5),
    ],
    "rack_and_pinion": [("a", O, Z, 0.3)],
    "belt": [("a", O, Z, 0.2), ("b", (1.0, 0, 0), Z, 0.4)],
}


_N = np.array(
    [[-0.2, np.sqrt(0.96), 0.0], [-0.2, -np.sqrt(0.96), 0.0]]
)  # where both tangents touch the pulleys
RUNS = {"belt": [[list(0.2 * n), list(np.array(X) + 0.4 * n)] for n in _N]}


def sketches(name: str) -> list[Sketch]:
    """Return outlines of the bodies of a joint's model."""
    shown = JOINTS[name]
    found = [
        Sketch(body, f"{body}_frame", _box(np.array(low), np.array(high)))
        for body, boxes in shown.boxes.items()
        for low, high in boxes
    ]
    found += [Sketch("ground_point", "ground_frame", run) for run in RUNS.get(name, [])]
    for body, centre, axis, radius in DISCS.get(name, []):
        found.append(Sketch(body, f"{body}_frame", _disc(np.array(centre), np.array(axis), radius)))
    return found


def _box(low: np.ndarray, high: np.ndarray) -> list[list[float]]:
    """Return a path along all edges of a box."""
    order = [
        (0, 0, 0),
        (1, 0, 0),
        (1, 1, 0),
        (0, 1, 0),
        (0, 0, 0),
        (0, 0, 1),
        (1, 0, 1),
        (1, 0, 0),
        (1, 0, 1),
    ]
    order += [(1, 1, 1), (1, 1, 0), (1, 1, 1), (0, 1, 1), (0, 1, 0), (0, 1, 1), (0, 0, 1)]
    return [list(np.where(axis, high, low)) for axis in order]


def _disc(centre: np.ndarray, axis: np.ndarray, radius: float) -> list[list[float]]:
    """Return a circle with a spoke."""
    first = np.roll(axis, 1)
    second = np.cross(axis, first)
    angles = np.linspace(0, 2 * np.pi, 41)
    ring = centre + radius * (np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second)
    return [list(centre), *(list(point) for point in ring)]
