"""Nodes and elements of a file, with the contents of their lines."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from flexel.apps.spacar.keywords import ElementMode, ElementType
from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.problems import FollowingError
from flexel.base.arrays import Array
from flexel.model.node import COMPONENTS

LETTERS = {"point": "p", "planar_point": "p", "frame": "o", "planar_angle": "o", "warping": "w"}
START = {
    "point": (0.0,) * 3,
    "planar_point": (0.0,) * 2,
    "frame": (1.0, 0.0, 0.0, 0.0),
    "planar_angle": (0.0,),
    "warping": (0.0,),
}


@dataclass
class NodeEntry:
    """A node: its kind, its coordinates and which of them are fixed.

    Attributes
    ----------
    line : Line
        Of its coordinates, or of the element by which it comes into being.
    unread : bool
        A line about it could not be read.
    """

    number: int
    kind: str
    x: Array
    line: Line
    fixed: set[int] = field(default_factory=set)
    unread: bool = False

    @property
    def name(self) -> str:
        """Name in the model: p for positions, o for orientations, w for warping, then the number."""
        return f"{LETTERS[self.kind]}{self.number}"

    @property
    def components(self) -> tuple[str, ...]:
        """Names of its coordinates."""
        return COMPONENTS[self.kind]


@dataclass
class ElementEntry:
    """An element: its type, its nodes and the lines about it.

    Attributes
    ----------
    nodes : tuple of NodeEntry
        In the order of our element.
    numbers : tuple of float
        Numbers after the nodes, with a direction from DIR.
    lines : dict
        The one line each of ESTIFF, EDAMPP, EMASS, ESIG, LENGTH0 about it.
    free : set of int
        Modes that are not rigid, for any reason.
    vlasov : bool
        Warping is that of flexel's own beam, not SPACAR's; see `warping_parts`.
    """

    number: int
    kind: ElementType
    line: Line
    nodes: tuple[NodeEntry, ...]
    numbers: tuple[float, ...]
    lines: dict[str, Line] = field(default_factory=dict)
    free: set[int] = field(default_factory=set)
    vlasov: bool = False

    @property
    def name(self) -> str:
        """Name in the model: the keyword in lower case, then the number."""
        return f"{self.line.keyword.lower()}{self.number}"

    @property
    def ends(self) -> tuple[str, ...]:
        """Names of its nodes."""
        return tuple(node.name for node in self.nodes)

    def values(self, keyword: str) -> tuple[float, ...]:
        """Return the numbers after the element number on its line of that keyword; none without one."""
        return self.lines[keyword].values[1:] if keyword in self.lines else ()


def quantity(entry: ElementEntry, i: int) -> tuple[str, float]:
    """Return flexel's name of a mode, a deformation or a coordinate, and the ratio of SPACAR's value to flexel's."""
    mode: ElementMode = entry.kind.modes[i - 1]
    if mode.node is None:
        return deformation_of(entry, i)
    node = entry.nodes[mode.node]
    return f"{node.name}.{node.components[0]}", length(entry) ** 2


def deformation_of(entry: ElementEntry, i: int) -> tuple[str, float]:
    """Return flexel's deformation or slip in which a mode has its law, and the ratio of SPACAR's value to flexel's."""
    mode: ElementMode = entry.kind.modes[i - 1]
    return f"{entry.name}.{mode.name}", mode.factor * _scale(entry, mode.scale)


def length(entry: ElementEntry) -> float:
    """Return the distance between the first and the last position node as drawn; an error if there is none."""
    points = [node for node in entry.nodes if node.kind.endswith("point")]
    if any(node.unread for node in points):
        raise FollowingError(f"{entry.name}: a line about its nodes could not be read; correct that line")
    distance = float(np.linalg.norm(points[-1].x - points[0].x))
    if not distance:
        first, last = points[0].number, points[-1].number
        raise entry.line.error(
            f"the nodes {first} and {last} coincide as drawn, so the element has no length; give their coordinates"
        )
    return distance


def _scale(entry: ElementEntry, what: str) -> float:
    """Return a length of an element by which SPACAR's mode differs from flexel's."""
    if what == "radii":
        if not entry.numbers[0] + entry.numbers[1]:
            raise entry.line.error("the radii are opposite, so the centres coincide; correct one of them")
        return entry.numbers[0] + entry.numbers[1]
    if what == "radius":
        radius = float(np.linalg.norm(entry.nodes[2].x - entry.nodes[0].x))
        if not radius:
            raise entry.line.error("hub and contact point coincide as drawn; correct their coordinates")
        return radius
    return 1.0
