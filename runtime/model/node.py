"""Nodes as declared: their kinds, names of coordinates, drawn values and which of them are fixed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.shown import prints
from flexel.model.handle import Handle

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
SENSORS = ("omega", "body_omega")  # of the angular velocity of a frame: in global axes, in its own
AXES = ("wx", "wy", "wz")


@dataclass(frozen=True)
class Node(Handle):
    """A node as declared: its kind, its initial coordinates and which of them are fixed."""

    name: str
    kind: str
    x0: Array
    fixed: NDArray[np.bool_]

    @prints
    def __repr__(self) -> str:
        values = ", ".join(f"{value:.6g}" for value in self.x0)
        held = "fixed" if self.fixed.all() else "partly fixed" if self.fixed.any() else "free"
        return f"Node({self.name}: {self.kind.replace('_', ' ')} at ({values}) {self.unit}, {held})"

    @property
    def unit(self) -> str:
        """Unit of the coordinates."""
        return UNITS.get(self.kind, "m")

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Full names of the coordinates, ``node.component``."""
        return tuple(f"{self.name}.{c}" for c in COMPONENTS[self.kind])


def unknown_quantity(name: str, known: Iterable[str], nodes: Mapping[str, Node]) -> str:
    """Explain that a quantity does not exist: how to measure it, or the nearest ones that do."""
    names = list(known)
    missing = _unmeasured(name, nodes, names)
    return f"unknown name '{name}'; {missing}" if missing else unknown(name, names)


def _unmeasured(name: str, nodes: Mapping[str, Node], known: Sequence[str]) -> str:
    """Advise on an angular velocity that is not measured, or by other names; return "" for any other name."""
    part, _, axis = name.rpartition(".")
    frame, _, sensor = part.rpartition(".")
    if part in nodes and axis not in SENSORS + AXES:
        return ""
    node = nodes.get(part) or (nodes.get(frame) if sensor in SENSORS else None)
    if node is None or node.kind not in ("frame", "planar_angle"):
        return ""
    if node.kind == "planar_angle":
        return f"the angular velocity of '{node.name}' is the rate of '{node.coordinates[0]}'; name that"
    measured = [kind for kind in SENSORS if f"{node.name}.{kind}.{AXES[0]}" in known]
    asked = sensor if sensor in SENSORS else axis
    wanted = asked if asked in SENSORS else (*measured, SENSORS[0])[0]
    slips = ", ".join(f"{node.name}.{wanted}.{letter}" for letter in AXES)
    if wanted in measured:
        return f"the angular velocity of '{node.name}' has the components {slips}; name one"
    axes = ", body_axes=True" if wanted == SENSORS[1] else ""
    advice = f"declare m.angular_velocity('{node.name}'{axes}) first, which makes the slips {slips}"
    if not measured:
        return advice
    declared = ", ".join(f"{node.name}.{measured[0]}.{letter}" for letter in AXES)
    return f"{advice}; declared so far are {declared}, in {'global' if measured[0] == SENSORS[0] else 'body'} axes"
