"""Flexure mechanisms in tables: a parallel guide, a cross hinge, a stage on rods; and a guide declared by hand."""

from collections.abc import Sequence
from typing import Any

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.parts.materials import MATERIALS, Profile

Tables = tuple[Any, Any, dict[int, dict[str, Any]], list[dict[str, Any]]]

STEEL = MATERIALS["spring steel"]
LENGTH, SPACING, RADIUS = 0.1, 0.06, 0.05
LEAF = fx.Rectangle(25e-3, 0.4e-3)  # the width along y of the section, the thickness along z
ROD = fx.Circle(1e-3)
IDEAL = [2, 3, 4]  # torsion, and bending across the thin direction
ALL = "all"


def leaf(elements: Sequence[int], beams: int = 4, flexible: Any = ALL) -> dict[str, Any]:
    """A group of leaf springs of the width along z."""
    return {
        "elements": list(elements),
        "section": "rectangle",
        "dimensions": (LEAF.height, LEAF.width),
        "material": "spring steel",
        "orientation": (0, 0, 1),
        "beams": beams,
        "flexible": flexible,
    }


def guide(flexible: Any = ALL, beams: int = 4, **shuttle: Any) -> Tables:
    """Two leaf springs along y; the shuttle between them, its node 5 at half their height, moves along x."""
    h = SPACING
    nodes = [[0, 0, 0], [0, LENGTH, 0], [h, LENGTH, 0], [h, 0, 0], [h / 2, LENGTH / 2, 0]]
    elements = [[1, 2], [2, 3], [3, 4], [2, 5]]
    properties: dict[int, dict[str, Any]] = {1: {"fixed": True}, 4: {"fixed": True}}
    properties[5] = {"mass": 0.5, "inertia": (2e-4, 2e-4, 2e-4)} | shuttle
    return nodes, elements, properties, [leaf([1, 3], beams, flexible)]


def hinge(flexible: Any = ALL, beams: int = 4, **body: Any) -> Tables:
    """Two leaf springs that cross at right angles in their middles, where the body's node 5 turns about z."""
    a = LENGTH / 2 / np.sqrt(2)
    nodes = np.array([[-a, -a, 0], [a, a, 0], [-a, a, 0], [a, -a, 0], [0, 0, 0]])
    elements = np.array([[1, 2], [3, 4], [2, 5], [4, 5]])
    properties: dict[int, dict[str, Any]] = {1: {"fixed": True}, 3: {"fixed": True}}
    properties[5] = {"mass": 0.2, "inertia": (1e-4, 1e-4, 1e-4)} | body
    return nodes, elements, properties, [leaf([1, 2], beams, flexible)]


def stage(flexible: Any = ALL, beams: int = 4, **body: Any) -> Tables:
    """Three upright rods at 120 degrees under a stage, whose node 7 moves in x and y and turns about z."""
    turns = 2 * np.pi / 3 * np.arange(3)
    feet = RADIUS * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(3)])
    nodes = [*feet.tolist(), *(feet + [0, 0, LENGTH]).tolist(), [0, 0, LENGTH]]
    elements = [[1, 4], [2, 5], [3, 6], [4, 7], [5, 7], [6, 7]]
    properties: dict[int, dict[str, Any]] = {i: {"fixed": True} for i in (1, 2, 3)}
    properties[7] = {"mass": 0.3, "inertia": (1e-4, 1e-4, 2e-4)} | body
    rods = {
        "elements": (1, 2, 3),
        "section": "circle",
        "dimensions": ROD.diameter,
        "E": STEEL.E,
        "nu": STEEL.nu,
        "density": STEEL.rho,
        "strength": STEEL.strength,
        "orientation": (1, 0, 0),
        "beams": beams,
        "flexible": flexible,
    }
    return nodes, elements, properties, [rods]


def axes(along: Sequence[float], width: Sequence[float]) -> Array:
    """Axes (3, 3) of a leaf as columns."""
    x, y = np.array(along) / np.linalg.norm(along), np.array(width)
    return np.column_stack([x, y, np.cross(x, y)])


def profile(section: Any) -> Profile:
    """A section of spring steel."""
    return Profile(section, STEEL)


def by_hand(force: float, release: Sequence[str], flexible: Sequence[str]) -> fx.System:
    """The guide of `guide` with m.beam, beam by beam, its force on the shuttle growing with time."""
    m = fx.Model()
    h, n = SPACING, 4
    corners = {"A": (0, 0, 0), "B": (0, LENGTH, 0), "C": (h, LENGTH, 0), "D": (h, 0, 0)}
    for name, place in corners.items():
        m.point(name, place, fixed=name in "AD")
        m.frame(f"R{name}", fixed=name in "AD")
    m.point("S", (h / 2, LENGTH / 2, 0))
    m.frame("RS")
    for start, end in ("AB", "CD"):
        p, q = (np.array(corners[corner], dtype=float) for corner in (start, end))
        nodes = [(start, f"R{start}")]
        for i in range(1, n):
            m.point(f"{start}{i}", p + (q - p) * i / n)
            m.frame(f"R{start}{i}")
            nodes.append((f"{start}{i}", f"R{start}{i}"))
        nodes.append((end, f"R{end}"))
        for i in range(n):
            m.beam(
                f"{start}{end}{i + 1}",
                *nodes[i],
                *nodes[i + 1],
                direction=(0, 0, 1),
                section=LEAF,
                material=STEEL,
                flexible=flexible,
            )
    m.beam("BC", "B", "RB", "C", "RC", rigid=True)
    m.beam("BS", "B", "RB", "S", "RS", rigid=True)
    m.body("shuttle", "S", "RS", mass=0.5, inertia=(2e-4, 2e-4, 2e-4))
    m.load("S", [fx.Polynomial((0.0, force)), 0.0, 0.0])
    k, l0 = profile(LEAF).stiffness(), LENGTH / n
    shear = 12 * k["EIz"] / (k["GAy"] * l0**2)
    for name in release:  # bending modes in the plane of a leaf
        m.spring(name, (4 + shear) * k["EIz"] / ((1 + shear) * l0**3))
    return m.build()
