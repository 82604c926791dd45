"""Nodes as declared: their kinds, names of coordinates, drawn values and which of them are fixed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexel.base.arrays import Array
from flexel.base.copies import Constant

COMPONENTS: dict[str, tuple[str, ...]] = {
    "point": ("x", "y", "z"),
    "frame": ("lambda0", "lambda1", "lambda2", "lambda3"),
    "planar_point": ("x", "y"),
    "planar_angle": ("angle",),
    "slope": ("x", "y", "z"),
    "planar_slope": ("x", "y"),
    "warping": ("twist",),
}


UNITS = {  # others are positions
    "frame": "-",
    "planar_angle": "rad",
    "slope": "-",
    "planar_slope": "-",
    "warping": "rad/m",
}


@dataclass(frozen=True)
class Node(Constant):
    """A node as declared: its kind, its initial coordinates and which of them are fixed."""

    name: str
    kind: str
    x0: Array
    fixed: NDArray[np.bool_]

    @property
    def unit(self) -> str:
        """Unit of the coordinates."""
        return UNITS.get(self.kind, "m")

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Full names of the coordinates, ``node.component``."""
        return tuple(f"{self.name}.{c}" for c in COMPONENTS[self.kind])
