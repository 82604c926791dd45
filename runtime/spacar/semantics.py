"""From the sheet to the calls that make the model and its analysis.

Roles, loads, motions and initial values are those of the file; deformations have SPACAR's signs in the file and
flexel's in the model, by the tables of `flexel.spacar.keywords`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flexel.base.time_functions import Polynomial
from flexel.spacar.contradictions import Claims
from flexel.spacar.elements import check_line, element_calls, node_calls
from flexel.spacar.entries import NodeEntry, quantity
from flexel.spacar.lexer import Line
from flexel.spacar.motions import Motions
from flexel.spacar.remarks import remark
from flexel.spacar.sheet import Sheet, name_of
from flexel.spacar.statements import Call
from flexel.spacar.terminals import Terminal, terminals
from flexel.spacar.warping import unnamed_warping


@dataclass
class Draft:
    """The content of a file.

    Attributes
    ----------
    calls : list of Call
        The model.
    still : list of Call
        Moving inputs at their initial values: in static load steps t is not time, and their motions do not continue.
    steps : list of Call
        Increments of DELXF, DELINPX and DELINPE for static load steps, per unit of the load parameter t.
    """

    gravity: tuple[float, ...] = (0.0, 0.0, 0.0)
    calls: list[Call] = field(default_factory=list)
    still: list[Call] = field(default_factory=list)
    steps: list[Call] = field(default_factory=list)
    inputs: list[Terminal] = field(default_factory=list)
    outputs: list[Terminal] = field(default_factory=list)


def understand(sheet: Sheet) -> Draft:
    """The complete meaning of a sheet.

    Lines that contradict others or refer to something undefined become errors among the sheet's problems.
    """
    draft, each = Draft(), sheet.problems.each
    for line in sheet.of("GRAVITY"):
        draft.gravity = (*line.values, 0.0)[:3]
    _mark_free(sheet)
    twisting = unnamed_warping(sheet)
    Claims(sheet)
    draft.calls += node_calls([sheet.nodes[n] for n in sorted(sheet.nodes)])
    each(lambda z: check_line(*z), [(e, given) for e in sheet.elements.values() for given in e.lines])
    made = sum(each(lambda entry: element_calls(entry, sheet.dialect), sheet.elements.values()), start=[])
    draft.calls += sorted(made, key=lambda call: call.method == "rotary_inertia")
    draft.calls += each(lambda line: _mass(line, sheet.node(line)), sheet.of("MASS"))
    draft.calls += _forces(sheet, draft)
    motions = Motions(sheet)
    draft.calls += motions.prescribed
    draft.still, draft.steps = motions.still, draft.steps + motions.steps
    draft.calls += _dofs(sheet, twisting)
    draft.calls += motions.initial
    draft.inputs, draft.outputs, measured = terminals(sheet)
    draft.calls += measured
    if not sheet.problems:
        remark(sheet)
    return draft


# -- roles -----------------------------------------------------------------------------------------


def _mark_free(sheet: Sheet) -> None:
    """Collect the modes that are not rigid, from all lines."""

    def released(line: Line) -> None:
        for entry, i in sheet.modes(line):
            if line.keyword != "RLSE" and i in entry.kind.slips:
                what = "has no value" if line.keyword == "INPUTE" else "is not a coordinate"
                raise line.error(f"mode {i} of a {entry.line.keyword} is a slip, which {what}; name others")
            entry.free.add(i)

    def rolling(line: Line) -> None:
        entry, i = sheet.mode(line, 0, 1)
        if i not in entry.kind.slips:
            slips = ", ".join(map(str, entry.kind.slips)) or "none"
            raise line.error(
                f"mode {i} of {entry.line.keyword} {entry.number} is not a slip ({slips}) and cannot be non-holonomic; "
                "a deformation that is rigid needs no ENHC"
            )
        if i in entry.free:
            raise line.error(
                f"mode {i} of element {entry.number} is also released; a slip held at zero cannot be"
            )
        other, j = sheet.mode(line, 2, 3)
        if j in other.kind.slips:
            raise line.error(f"mode {j} of element {other.number} is a slip, not a coordinate; name another")
        other.free.add(j)

    sheet.each(released, "RLSE", "DYNE", "KINE", "LINE", "INPUTE")
    sheet.each(rolling, "ENHC")


def _dofs(sheet: Sheet, twisting: Sequence[NodeEntry]) -> list[Call]:
    """Dynamic and kinematic coordinates; a coordinate that is named twice counts once.

    In the Twente dialect they are in SPACAR's order: coordinates of nodes, then deformations, each by number and
    component; in the Delft one in the order of the file.

    Parameters
    ----------
    twisting : sequence of NodeEntry
        Nodes of warping that are dynamic coordinates beside those that are named, if any are.
    """
    chosen: dict[str, dict[str, Line]] = {"independent": {}, "kinematic": {}}
    place: dict[str, tuple[int, int, int]] = {}

    def name(line: Line) -> None:
        own = chosen["kinematic" if line.keyword in ("KINX", "KINE", "ENHC") else "independent"]
        if line.keyword.endswith("X"):
            found = [((0, node.number, i), name_of(node, i)) for node, i in sheet.coordinates(line)]
        else:
            modes = [sheet.mode(line, 2, 3)] if line.keyword == "ENHC" else sheet.modes(line)
            found = [((1, entry.number, i), quantity(entry, i)[0]) for entry, i in modes]
        for where, quantity_name in found:
            own.setdefault(quantity_name, line)
            place[quantity_name] = where

    for keywords in (("DYNX", "KINX"), ("DYNE", "LINE", "KINE"), ("ENHC",)):
        sheet.problems.each(name, sheet.of(*keywords))
    for node in twisting if chosen["independent"] else ():
        chosen["independent"][name_of(node, 1)] = node.line
        place[name_of(node, 1)] = (0, node.number, 1)
    calls = []
    for method, named in chosen.items():
        names = sorted(named, key=place.__getitem__) if sheet.dialect == "twente" else list(named)
        if names:
            calls.append(Call(method, tuple(names), {}, named[names[0]]))
    return calls


# -- masses and loads ----------------------------------------------------------------------------


def _mass(line: Line, node: NodeEntry) -> Call:
    if node.kind == "warping":
        raise line.error("a node of warping has no mass; give Jw of its beams, the last number of EM")
    wanted = {"point": 1, "planar_point": 1, "planar_angle": 1, "frame": 6}[node.kind]
    values = line.values[1:]
    if len(values) != wanted:
        raise line.error(
            f"{len(values)} numbers given; node {node.number} is a {node.kind} and takes {wanted}"
        )
    name = f"mass{node.number}"
    if node.kind == "frame":
        xx, xy, xz, yy, yz, zz = values
        return Call("rotary_inertia", (name, node.name, (xx, yy, zz, xy, xz, yz)), {}, line)
    method = "rotary_inertia" if node.kind == "planar_angle" else "point_mass"
    return Call(method, (name, node.name, values[0]), {}, line)


def _forces(sheet: Sheet, draft: Draft) -> list[Call]:
    """Loads that act from the start; those of load steps go to the draft's."""
    each = sheet.problems.each

    def growing(line: Line) -> list[Call]:
        rows = tuple(Polynomial((0.0, z)) if z else 0.0 for z in line.values[1:])
        return _force(line, sheet.node(line), rows)

    def turning(line: Line) -> list[Call]:
        node, values = sheet.node(line), line.values[1:]
        if node.kind != "frame" or len(values) != 3:
            raise line.error("it takes an orientation node and three moments about the axes of the body")
        return [Call("load", (node.name, values), {"follower": True}, line)]

    constant = each(lambda line: _force(line, sheet.node(line), line.values[1:]), sheet.of("FORCE"))
    draft.steps += sum(each(growing, sheet.of("DELXF")), start=[])
    return sum([*constant, *each(turning, sheet.of("TORQUEL"))], start=[])


def _force(line: Line, node: NodeEntry, values: tuple[object, ...]) -> list[Call]:
    """A force, a moment, a bimoment on a node of warping, or four forces dual to Euler parameters."""
    sizes = {"point": (3,), "planar_point": (2,), "planar_angle": (1,), "warping": (1,), "frame": (3, 4)}[
        node.kind
    ]
    if len(values) not in sizes:
        wanted = " or ".join(map(str, sizes))
        raise line.error(
            f"{len(values)} numbers given; node {node.number} is a {node.kind} and takes {wanted}"
        )
    if len(values) == 4:
        pairs = zip(node.components, values, strict=True)
        return [Call("load", (f"{node.name}.{c}", z), {}, line) for c, z in pairs if z != 0.0]
    value = values if len(values) > 1 else values[0]
    return [Call("load", (node.name, value), {}, line)]
