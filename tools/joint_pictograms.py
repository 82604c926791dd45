"""Pictograms of the joints: two bodies, what joins them (a pin, a sleeve, a thread), and arrows for what is free."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from solids import Scene

A, B = "#8fa3b5", "#1f6fb5"  # the first body and the second
PIN, FREE = "#7a8087", "#d55e00"  # what joins them, and what is free
BAR = 0.26  # width of a bar [m]
UP = (0.0, 0.0, 1.0)


def _slide(scene: Scene, height: float, y: float = 0.0, at: float = 0.0) -> None:
    """Add a straight arrow along x, with heads at both ends."""
    scene.arrow(np.array([(x, y, height) for x in np.linspace(at - 0.36, at + 0.36, 19)]), FREE, both=True)


def revolute(scene: Scene) -> None:
    """Two knuckles of one body around one of the other, and a pin through all."""
    scene.box((-0.62, 0, 0), (0.72, BAR, 0.44), A)
    scene.box((0.62, 0, 0), (0.72, BAR, 0.14), B)
    for z in (-0.15, 0.15):
        scene.cylinder((0, 0, z - 0.07), (0, 0, z + 0.07), 0.2, A)
        scene.box((-0.17, 0, z), (0.2, BAR, 0.14), A)
    scene.cylinder((0, 0, -0.07), (0, 0, 0.07), 0.2, B)
    scene.box((0.17, 0, 0), (0.22, BAR, 0.14), B)
    scene.cylinder((0, 0, 0.22), (0, 0, 0.4), 0.07, PIN)
    scene.cylinder((0, 0, -0.4), (0, 0, -0.22), 0.07, PIN)
    scene.turn((0, 0, 0.46), UP, 0.34, (-160, 70), FREE)


def _sleeve(scene: Scene) -> None:
    """A square sleeve of four plates, open along x."""
    for y in (-0.17, 0.17):
        scene.box((-0.35, y, 0), (0.7, 0.06, 0.4), A)
    for z in (-0.17, 0.17):
        scene.box((-0.35, 0, z), (0.7, 0.28, 0.06), A)


def prismatic(scene: Scene) -> None:
    """A square bar in a square sleeve."""
    _sleeve(scene)
    scene.box((0.15, 0, 0), (1.5, 0.26, 0.26), B)
    _slide(scene, 0.36, at=0.35)


def cylindrical(scene: Scene) -> None:
    """A round rod in a round sleeve."""
    scene.cylinder((-0.7, 0, 0), (0.0, 0, 0), 0.25, A)
    scene.cylinder((0.0, 0, 0), (0.9, 0, 0), 0.14, B)
    _slide(scene, 0.36, at=0.4)
    scene.turn((0.62, 0, 0), (1, 0, 0), 0.27, (-185, -30), FREE)


def screw(scene: Scene) -> None:
    """A threaded rod in a nut."""
    scene.cylinder((-0.45, 0, 0), (-0.05, 0, 0), 0.3, A)
    scene.threaded((-0.05, 0, 0), (0.9, 0, 0), 0.17, 0.12, B)
    scene.threaded((-0.8, 0, 0), (-0.45, 0, 0), 0.17, 0.12, B)
    _slide(scene, 0.42, at=0.4)
    scene.turn((0.6, 0, 0), (1, 0, 0), 0.32, (-185, -30), FREE)


def planar_joint(scene: Scene) -> None:
    """A block that slides and turns on a plate."""
    scene.box((0, 0, -0.24), (1.5, 1.1, 0.1), A)
    scene.box((0, 0, -0.06), (0.46, 0.46, 0.24), B)
    _slide(scene, -0.14, y=-0.42)
    scene.arrow(np.array([(0.52, y, -0.14) for y in np.linspace(-0.36, 0.36, 19)]), FREE, both=True)
    scene.turn((0, 0, 0.14), UP, 0.26, (-160, 70), FREE)


def spherical(scene: Scene) -> None:
    """A ball in a socket."""
    scene.cylinder((0, 0, -0.75), (0, 0, -0.26), 0.13, A)
    scene.sphere((0, 0, 0), 0.3, A, -90, 8)
    scene.sphere((0, 0, 0), 0.25, B)
    scene.cylinder((0, 0, 0.22), (0, 0, 0.75), 0.1, B)
    scene.turn((0, 0, 0.58), UP, 0.26, (-160, 70), FREE)
    scene.turn((0, 0, 0), (0, -1, 0), 0.52, (60, 120), FREE)
    scene.turn((0, 0, 0), (1, 0, 0), 0.52, (-120, -60), FREE)


def universal(scene: Scene) -> None:
    """Two forks on a cross."""
    scene.cylinder((-0.95, 0, 0), (-0.42, 0, 0), 0.11, A)
    scene.box((-0.38, 0, 0), (0.1, 0.14, 0.6), A)
    for z in (-0.25, 0.25):
        scene.box((-0.12, 0, z), (0.44, 0.14, 0.1), A)
    scene.cylinder((0.95, 0, 0), (0.42, 0, 0), 0.11, B)
    scene.box((0.38, 0, 0), (0.1, 0.6, 0.14), B)
    for y in (-0.25, 0.25):
        scene.box((0.12, y, 0), (0.44, 0.1, 0.14), B)
    scene.cylinder((0, 0, -0.38), (0, 0, 0.38), 0.06, PIN)
    scene.cylinder((0, -0.38, 0), (0, 0.38, 0), 0.06, PIN)
    scene.turn((0, 0, 0.42), UP, 0.24, (-160, 70), FREE)
    scene.turn((0, -0.42, 0), (0, -1, 0), 0.24, (-70, 160), FREE)


def weld(scene: Scene) -> None:
    """Two bars and a bead around the seam."""
    scene.box((-0.48, 0, 0), (0.84, BAR, BAR), A)
    scene.box((0.48, 0, 0), (0.84, BAR, BAR), B)
    scene.box((0, 0, 0), (0.12, BAR + 0.1, BAR + 0.1), PIN)


def skate(scene: Scene) -> None:
    """A body on a blade, which moves along itself and turns."""
    scene.box((0, 0, -0.3), (1.5, 1.1, 0.08), A)
    scene.box((0, 0, -0.16), (0.9, 0.04, 0.2), PIN)
    scene.box((0, 0, 0.02), (0.6, 0.34, 0.16), B)
    scene.arrow(np.array([(x, -0.34, -0.22) for x in np.linspace(-0.4, 0.4, 19)]), FREE, both=True)
    scene.turn((0, 0, 0.16), UP, 0.24, (-160, 70), FREE)


def directions(scene: Scene) -> dict[str, tuple[float, float, float]]:
    """Draw the axis of a joint and the two directions across it; return where their names are written.

    The axis is z as drawn, so that direction 1 is x and direction 2 is y.
    """
    scene.cylinder((0, 0, -0.45), (0, 0, -0.05), 0.3, A)
    scene.cylinder((0, 0, -0.05), (0, 0, 0.3), 0.2, B)
    for end in ((0.95, 0, 0), (0, 0.95, 0), (0, 0, 0.95)):
        begin = np.array(end) * (0.35 if end[2] else 0.25)
        scene.arrow(np.linspace(begin, end, 19), FREE)
    scene.turn((0, 0, 0.62), UP, 0.22, (-160, 70), FREE)
    for end, angles in (((0.6, 0, 0), (-185, -30)), ((0, 0.6, 0), (-60, 100))):
        scene.turn(end, end, 0.2, angles, PIN)
    return {
        "axis: axial, angle": (0, 0, 1.06),
        "1: radial1, bend1": (1.0, 0, -0.2),
        "2: radial2, bend2": (0.35, 1.25, 0),
    }


PICTOGRAMS: dict[str, Callable[[Scene], None]] = {
    "revolute": revolute,
    "prismatic": prismatic,
    "cylindrical": cylindrical,
    "screw": screw,
    "planar_joint": planar_joint,
    "spherical": spherical,
    "universal": universal,
    "weld": weld,
    "skate": skate,
}
