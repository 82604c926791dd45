"""The declarations of a file, collected by node and element number, before conversion to a model."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array
from flexel.spacar.keywords import ELEMENTS, ElementType, Mode
from flexel.spacar.lexer import Line
from flexel.structure.nodes import COMPONENTS

LETTERS = {"point": "p", "planar_point": "p", "frame": "o", "planar_angle": "o"}
START = {
    "point": (0.0,) * 3,
    "planar_point": (0.0,) * 2,
    "frame": (1.0, 0.0, 0.0, 0.0),
    "planar_angle": (0.0,),
}
PLACES = {"XY": "planar_point", "XYZ": "point", "BETA": "planar_angle", "LAMBDA": "frame"}


# how many of the first numbers identify the subject of a line that may occur only once
SUBJECT = dict.fromkeys("ESTIFF EDAMPP EMASS LENGTH0 DIR MASS FORCE DELXF TORQUEL".split(), 1)
SUBJECT |= dict.fromkeys("XD XDD E ED EDD STARTDE DELINPX DELINPE".split(), 2)
SUBJECT |= dict.fromkeys("TIME GRAVITY TIMESTEP HMAX ITERSTEP".split(), 0)


@dataclass
class NodeEntry:
    """A node: its kind, its coordinates and which of them are fixed."""

    number: int
    kind: str
    x: Array
    fixed: set[int] = field(default_factory=set)

    @property
    def name(self) -> str:
        """Name in the model: p for positions, o for orientations, then the number."""
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
    numbers : tuple of float
        Numbers after the nodes, with a direction from DIR.
    lines : dict
        The one line each of ESTIFF, EDAMPP, EMASS, LENGTH0 about it.
    free : set of int
        Modes that are not rigid, for any reason.
    """

    number: int
    kind: ElementType
    line: Line
    nodes: tuple[NodeEntry, ...]
    numbers: tuple[float, ...]
    lines: dict[str, Line] = field(default_factory=dict)
    free: set[int] = field(default_factory=set)

    @property
    def name(self) -> str:
        """Name in the model: the keyword in small letters, then the number."""
        return f"{self.line.keyword.lower()}{self.number}"

    @property
    def ends(self) -> tuple[str, ...]:
        """Names of its nodes."""
        return tuple(node.name for node in self.nodes)

    def values(self, keyword: str) -> tuple[float, ...]:
        """Numbers after the element's own on its line of that keyword; none without one."""
        return self.lines[keyword].values[1:] if keyword in self.lines else ()


class Sheet:
    """The declarations of one file.

    Parameters
    ----------
    lines : iterable of Line

    Raises
    ------
    ModelError
        Duplicate numbers, nodes of two kinds, nodes and elements that do not exist; names the line.
    """

    def __init__(self, lines: Iterable[Line]) -> None:
        self.lines = list(lines)
        self.nodes: dict[int, NodeEntry] = {}
        self.elements: dict[int, ElementEntry] = {}
        _check_doubles(self.lines)
        for line in self.lines:
            if line.keyword in ELEMENTS:
                self._element(line)
        for line in self.of(*PLACES, "X"):
            self._coordinates(line)
        for line in self.of("FIX"):
            node = self.node(line)
            chosen = range(1, len(node.components) + 1) if len(line.values) == 1 else self.places(line, node)
            node.fixed |= set(chosen)
        for line in self.of("DIR"):
            self._direction(line)
        for line in self.of("ESTIFF", "EDAMPP", "EMASS", "LENGTH0"):
            entry = self.element(line)
            if line.keyword in entry.lines:
                earlier = entry.lines[line.keyword].number
                raise line.error(
                    f"element {entry.number} has its {line.written} in line {earlier}; keep one of them"
                )
            entry.lines[line.keyword] = line

    def of(self, *keywords: str) -> list[Line]:
        """Lines of the keywords, in the order of the file."""
        return [line for line in self.lines if line.keyword in keywords]

    def _element(self, line: Line) -> None:
        number, kind = line.whole(0, "element"), ELEMENTS[line.keyword]
        if number in self.elements:
            first = self.elements[number].line.number
            raise line.error(f"element {number} exists since line {first}; give another number")
        nodes = []
        for place, node_kind in enumerate(kind.nodes, 1):
            n = line.whole(place, "node")
            node = self.nodes.setdefault(n, NodeEntry(n, node_kind, np.array(START[node_kind])))
            if node.kind != node_kind:
                raise line.error(
                    f"node {n} is already a {node.kind}, and is used here as a {node_kind}; use another"
                )
            nodes.append(node)
        numbers = line.values[1 + len(nodes) :]
        if len(numbers) not in (len(kind.numbers), len(kind.numbers) - kind.optional):
            raise line.error(f"{len(numbers)} numbers follow the nodes; give {' '.join(kind.numbers)}")
        self.elements[number] = ElementEntry(number, kind, line, tuple(nodes), numbers)

    def _coordinates(self, line: Line) -> None:
        node, values = self.node(line), line.values[1:]
        wanted = PLACES.get(line.keyword, node.kind)
        if node.kind != wanted or len(values) != node.x.size:
            raise line.error(
                f"{len(values)} coordinates given, but node {node.number} is a {node.kind} with {node.x.size} "
                f"({', '.join(node.components)}); give these"
            )
        node.x = np.array(values)

    def _direction(self, line: Line) -> None:
        entry = self.element(line)
        if entry.kind.optional != 3:
            raise line.error(f"a {entry.line.keyword} has no direction; remove the line")
        if entry.numbers:
            raise line.error(
                f"element {entry.number} has its direction in line {entry.line.number}; keep one of them"
            )
        entry.numbers = line.values[1:]

    # -- subjects of lines -----------------------------------------------------------------------

    def node(self, line: Line, place: int = 0) -> NodeEntry:
        """The node whose number stands at a place of a line."""
        n = line.whole(place, "node")
        if n not in self.nodes:
            raise line.error(f"no element has the node {n}; correct the number, or remove the line")
        return self.nodes[n]

    def element(self, line: Line, place: int = 0) -> ElementEntry:
        """The element whose number stands at a place of a line."""
        n = line.whole(place, "element")
        if n not in self.elements:
            known = ", ".join(map(str, sorted(self.elements)[:20]))
            raise line.error(f"element {n} does not exist; elements are {known}")
        return self.elements[n]

    def places(self, line: Line, node: NodeEntry, first: int = 1) -> list[int]:
        """Numbers of coordinates of a node, from a place of the line to its end."""
        found = [line.whole(place, "coordinate") for place in range(first, len(line.values))]
        for i in found:
            if i > len(node.components):
                raise line.error(
                    f"node {node.number}, a {node.kind}, has coordinates 1 to {len(node.components)}"
                )
        return found

    def coordinate(self, line: Line, node_place: int = 0) -> str:
        """Name of the coordinate that node and component on a line speak of."""
        node = self.node(line, node_place)
        i = line.whole(node_place + 1, "coordinate")
        if i > len(node.components):
            raise line.error(
                f"node {node.number}, a {node.kind}, has coordinates 1 to {len(node.components)}"
            )
        return f"{node.name}.{node.components[i - 1]}"

    def mode(self, line: Line, element_place: int = 0, mode_place: int = 1) -> tuple[ElementEntry, int]:
        """The element and the mode number to which a line refers."""
        entry, i = self.element(line, element_place), line.whole(mode_place, "mode")
        if i > len(entry.kind.modes):
            raise line.error(
                f"a {entry.line.keyword} has modes 1 to {len(entry.kind.modes)}; correct the number"
            )
        if entry.line.keyword == "L2MIN1":
            raise line.error("the norm of Euler parameters is always constrained; remove the line")
        return entry, i


def quantity(entry: ElementEntry, i: int) -> tuple[str, float]:
    """Our name of a mode, and the ratio of SPACAR's value to ours."""
    mode: Mode = entry.kind.modes[i - 1]
    return f"{entry.name}.{mode.name}", mode.factor * _scale(entry, mode.scale)


def _scale(entry: ElementEntry, what: str) -> float:
    if what == "radii":
        return entry.numbers[0] + entry.numbers[1]
    if what == "radius":
        return float(np.linalg.norm(entry.nodes[2].x - entry.nodes[0].x))
    return 1.0


def _check_doubles(lines: Iterable[Line]) -> None:
    """Check that lines that may occur only once do so."""
    seen: dict[tuple[object, ...], Line] = {}
    for line in lines:
        if line.keyword in SUBJECT or line.keyword in PLACES or line.keyword == "X":
            group = line.keyword if line.keyword in SUBJECT else "X"
            key = (group, *line.values[: SUBJECT.get(line.keyword, 1)])
            if key in seen:
                raise line.error(f"already given in line {seen[key].number}; keep one of them")
            seen[key] = line
