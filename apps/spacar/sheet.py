"""The declarations of a file, collected by node and element number, before conversion to a model."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from flexel.apps.spacar.file_entries import START, ElementEntry, NodeEntry
from flexel.apps.spacar.keywords import ELEMENTS, VALUES
from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.problems import FollowingError, Notes, Problems

PLACES = {"XY": "planar_point", "XYZ": "point", "BETA": "planar_angle", "LAMBDA": "frame"}
ABOUT_ELEMENTS = ("ESTIFF", "EDAMPP", "EMASS", "ESIG", "LENGTH0")
# numbers with a meaning for a beam of the Twente dialect, and the note about the others
OF_BEAM = {"ESTIFF": 6, "EDAMPP": 6, "EMASS": 5, "ESIG": 6}
OF_BEAMW = {"ESTIFF": 7, "EDAMPP": 7, "EMASS": 6, "ESIG": 8}
MEANING = {
    "BEAM": (OF_BEAM, "the last numbers belong to warping, which a BEAM does not have"),
    "BEAMW": (OF_BEAMW, "the last numbers are ignored, as no description says what they mean"),
}

# how many of the first numbers identify the subject of a line that may occur only once
SUBJECT = dict.fromkeys("ESTIFF EDAMPP EMASS ESIG LENGTH0 DIR MASS FORCE DELXF TORQUEL".split(), 1)
SUBJECT |= dict.fromkeys("XD XDD E ED EDD STARTDE DELINPX DELINPE ENHC".split(), 2)
SUBJECT |= {usage.meaning: 2 for usage in VALUES.values()}
SUBJECT |= dict.fromkeys("TIME GRAVITY TIMESTEP HMAX ITERSTEP".split(), 0)


class Sheet:
    """The declarations of one file.

    Parameters
    ----------
    lines : iterable of Line
    dialect : str
    problems : Problems
        Gets the errors: duplicate numbers, nodes of two kinds, nodes and elements that do not exist.
    notes : Notes
    vlasov : bool
        Beams with warping are flexel's own, not SPACAR's; see `warping_parts`.
    """

    def __init__(
        self, lines: Iterable[Line], dialect: str, problems: Problems, notes: Notes, vlasov: bool
    ) -> None:
        self.dialect, self.problems, self.notes, self._vlasov = dialect, problems, notes, vlasov
        self.nodes: dict[int, NodeEntry] = {}
        self.elements: dict[int, ElementEntry] = {}
        seen: dict[tuple[object, ...], Line] = {}
        self.lines = problems.each(lambda line: _once(line, seen), lines)
        self.each(self._element, *ELEMENTS)
        self.each(self._coordinates, *PLACES, "X")
        for n in problems.unread & self.nodes.keys():
            self.nodes[n].unread = True
        self.each(self._fix, "FIX")
        self.each(self._direction, "DIR")
        self.each(self._about_element, *ABOUT_ELEMENTS)

    def of(self, *keywords: str) -> list[Line]:
        """Return the lines of the keywords, in the order of the file."""
        return [line for line in self.lines if line.keyword in keywords]

    def each(self, handle: Callable[[Line], None], *keywords: str) -> None:
        """Handle all lines of the keywords; the numbers in wrong lines count as unread."""
        for line in self.of(*keywords):
            if not self.problems.each(handle, [line]):
                self.problems.unread |= {
                    int(value) for value in line.values if value == round(value) and 0 < value < 1e9
                }

    def _element(self, line: Line) -> None:
        number, kind = line.whole(0, "element"), ELEMENTS[line.keyword]
        if number in self.elements:
            first = self.elements[number].line.number
            raise line.error(f"element {number} already exists (line {first}); give another number")
        nodes = []
        for place, node_kind in enumerate(kind.nodes, 1):
            n = line.whole(place, "node")
            node = self.nodes.setdefault(n, NodeEntry(n, node_kind, np.array(START[node_kind]), line))
            if node.kind != node_kind:
                raise line.error(
                    f"node {n} is already a {node.kind}, and is used here as a {node_kind}; use another"
                )
            nodes.append(node)
        ordered = tuple(nodes[i] for i in kind.order) or tuple(nodes)
        numbers = line.values[1 + len(nodes) :]
        if len(numbers) not in (len(kind.numbers), len(kind.numbers) - kind.optional):
            raise line.error(f"{len(numbers)} numbers follow the nodes; give {' '.join(kind.numbers)}")
        self.elements[number] = ElementEntry(number, kind, line, ordered, numbers, vlasov=self._vlasov)

    def _coordinates(self, line: Line) -> None:
        if self._unused(line):
            self._note_unused(line)
            return
        node, values = self.node(line), line.values[1:]
        wanted = PLACES.get(line.keyword, node.kind)
        if node.kind != wanted or len(values) != node.x.size:
            raise line.error(
                f"{len(values)} coordinates given, but node {node.number} is a {node.kind} with {node.x.size} "
                f"({', '.join(node.components)}); give these"
            )
        if node.kind == "warping" and any(values):
            raise line.error(
                "a node of warping is drawn without twist, so that the element is unstrained; give 0, or make it "
                "an input with this value"
            )
        node.x, node.line = np.array(values), line

    def _unused(self, line: Line) -> bool:
        """Whether a line of the Twente dialect places or fixes a node that no element has, as SPACAR accepts."""
        n = line.whole(0, "node")
        return self.dialect == "twente" and n not in self.nodes and n not in self.problems.unread

    def _note_unused(self, line: Line) -> None:
        self.notes.add(line, "no effect, as no element has such a node", line.whole(0, "node"))

    def _fix(self, line: Line) -> None:
        if self._unused(line):
            self._note_unused(line)
        for node, i in self.coordinates(line):
            node.fixed.add(i)

    def _direction(self, line: Line) -> None:
        entry = self.element(line)
        if entry.kind.optional != 3:
            raise line.error(f"a {entry.line.keyword} has no direction; remove the line")
        if entry.numbers:
            raise line.error(
                f"element {entry.number} has its direction in line {entry.line.number}; keep one of them"
            )
        entry.numbers = line.values[1:]

    def _about_element(self, line: Line) -> None:
        entry = self.element(line)
        numbers, what = MEANING.get(entry.line.keyword, ({}, ""))
        known = 1 + numbers.get(line.keyword, len(line.values))
        if self.dialect == "twente" and len(line.values) > known:
            self.notes.add(line, what, entry.number)
            line = replace(line, values=line.values[:known], words=line.words[:known])
        entry.lines[line.keyword] = line

    def refuse_unread(self, line: Line) -> None:
        """Return an error if another line about the node or element of a line could not be read."""
        if line.values[0] in self.problems.unread:
            raise FollowingError(
                f"node or element {line.words[0]} is in a line that could not be read; correct that line"
            )

    # -- subjects of lines -----------------------------------------------------------------------

    def node(self, line: Line, place: int = 0) -> NodeEntry:
        """Return the node whose number is at a position of a line."""
        n = line.whole(place, "node")
        if n not in self.nodes:
            if n in self.problems.unread:
                raise FollowingError(f"node {n} is in a line that could not be read; correct that line")
            raise line.error(f"no element has the node {n}; correct the number, or remove the line")
        return self.nodes[n]

    def element(self, line: Line, place: int = 0) -> ElementEntry:
        """Return the element whose number is at a position of a line."""
        n = line.whole(place, "element")
        if n not in self.elements:
            if n in self.problems.unread:
                raise FollowingError(f"element {n} is in a line that could not be read; correct that line")
            known = ", ".join(map(str, sorted(self.elements)[:20])) or "none"
            raise line.error(f"element {n} does not exist; elements are {known}")
        return self.elements[n]

    def coordinates(self, line: Line) -> list[tuple[NodeEntry, int]]:
        """Return the node of a line and the coordinates that it names, or all of them.

        For a whole orientation, these are the last three, which determine the first, if they must be independent.
        A FIX of a node that no element has names none.
        """
        if line.keyword == "FIX" and self._unused(line):
            return []
        node = self.node(line)
        if len(line.values) == 1:
            first = 2 if node.kind == "frame" and line.keyword != "FIX" else 1
            return [(node, i) for i in range(first, len(node.components) + 1)]
        return [self._component(line, node, place) for place in range(1, len(line.values))]

    def coordinate(self, line: Line, node_place: int = 0) -> str:
        """Return the name of the coordinate given by node and component on a line."""
        return name_of(*self._component(line, self.node(line, node_place), node_place + 1))

    def _component(self, line: Line, node: NodeEntry, place: int) -> tuple[NodeEntry, int]:
        i = _component_number(line, place, "coordinate")
        if i > len(node.components):
            raise line.error(
                f"node {node.number}, a {node.kind}, has coordinates 1 to {len(node.components)}"
            )
        return node, i

    def modes(self, line: Line) -> list[tuple[ElementEntry, int]]:
        """Return the element of a line and the modes that it names, or all of them.

        In the Twente dialect an INPUTE of a mode that is DYNE has no effect, as in SPACAR.
        """
        entry = self.element(line)
        numbers = [_component_number(line, place, "mode") for place in range(1, len(line.values))]
        found = [self._mode(line, entry, i) for i in numbers or range(1, len(entry.kind.modes) + 1)]
        if line.keyword == "INPUTE" and self.dialect == "twente":
            return [place for place in found if not self.is_dynamic(*place)]
        return found

    def mode(self, line: Line, element_place: int = 0, mode_place: int = 1) -> tuple[ElementEntry, int]:
        """Return the element and the mode number to which a line refers."""
        return self._mode(line, self.element(line, element_place), line.whole(mode_place, "mode"))

    def _mode(self, line: Line, entry: ElementEntry, i: int) -> tuple[ElementEntry, int]:
        if i > len(entry.kind.modes):
            raise line.error(
                f"a {entry.line.keyword} has modes 1 to {len(entry.kind.modes)}; correct the number"
            )
        if entry.line.keyword == "L2MIN1":
            raise line.error("the norm of Euler parameters is always constrained; remove the line")
        return entry, i

    def is_dynamic(self, entry: ElementEntry, i: int) -> bool:
        """Whether a line DYNE names a mode, or all of its element."""
        own = [line.values[1:] for line in self.of("DYNE") if line.values[0] == entry.number]
        return any(not indices or i in indices for indices in own)


def name_of(node: NodeEntry, i: int) -> str:
    """Return the name of coordinate i of a node."""
    return f"{node.name}.{node.components[i - 1]}"


def _component_number(line: Line, place: int, what: str) -> int:
    """Return the number of a coordinate or mode; raise for the value of an input, as in lines of later blocks."""
    value = line.values[place]
    if line.keyword in VALUES and (value != round(value) or value < 1):
        raise line.error(
            f"{line.words[place]} is not a component, and a line {line.keyword} in the first block lists components; "
            "values follow after END HALT (Twente), or in separate lines: X, XD, XDD, E, ED, EDD (Delft)"
        )
    return line.whole(place, what)


def _once(line: Line, seen: dict[tuple[object, ...], Line]) -> Line:
    """Return the line, if it may be given again or is the first of its kind."""
    if line.keyword not in SUBJECT and line.keyword not in PLACES and line.keyword != "X":
        return line
    group = line.keyword if line.keyword in SUBJECT else "X"
    first = seen.setdefault((group, *line.values[: SUBJECT.get(line.keyword, 1)]), line)
    if first is not line:
        raise line.error(f"already given in line {first.number}; keep one of them")
    return line
