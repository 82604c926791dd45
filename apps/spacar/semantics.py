"""Converts the sheet to the parts of the model and its analysis.

Roles, loads, motions and initial values are those of the file; deformations have SPACAR's signs in the file and
flexel's in the model, by the tables of `flexel.apps.spacar.keywords`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flexel.apps.spacar.contradictions import Claims
from flexel.apps.spacar.converted_elements import check_line, element_parts, node_parts
from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.file_entries import NodeEntry, quantity
from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.prescribed_motions import PrescribedMotions
from flexel.apps.spacar.remarks import remark
from flexel.apps.spacar.sheet import Sheet, name_of
from flexel.apps.spacar.terminals import Terminal, terminals
from flexel.apps.spacar.warping_beams import unnamed_warping
from flexel.base.time_functions import Polynomial
from flexel.parts.bodies import PointMass
from flexel.parts.couplings import RotaryInertia
from flexel.parts.loads import LoadPart
from flexel.parts.roles import Independent, Kinematic


@dataclass
class Draft:
    """The content of a file.

    Attributes
    ----------
    parts : list of Declaration
        The model.
    still : list of Declaration
        Moving inputs at their initial values: in static load steps t is not time, and their motions do not continue.
    steps : list of Declaration
        Increments of DELXF, DELINPX and DELINPE for static load steps, per unit of the load parameter t.
    scales : dict of str to float
        SPACAR's values over flexel's of degrees of freedom that are coordinates, but named as modes of elements.
    """

    gravity: tuple[float, ...] = (0.0, 0.0, 0.0)
    parts: list[Declaration] = field(default_factory=list)
    still: list[Declaration] = field(default_factory=list)
    steps: list[Declaration] = field(default_factory=list)
    inputs: list[Terminal] = field(default_factory=list)
    outputs: list[Terminal] = field(default_factory=list)
    scales: dict[str, float] = field(default_factory=dict)


def understand(sheet: Sheet) -> Draft:
    """Interpret a whole sheet.

    Contradictory lines, and references to undefined items, become errors among the sheet's problems.
    """
    draft, each = Draft(), sheet.problems.each
    for line in sheet.of("GRAVITY"):
        draft.gravity = (*line.values, 0.0)[:3]
    _mark_free(sheet)
    twisting = unnamed_warping(sheet)
    Claims(sheet)
    draft.parts += sum(each(node_parts, [sheet.nodes[n] for n in sorted(sheet.nodes)]), start=[])
    each(lambda pair: check_line(*pair), [(e, given) for e in sheet.elements.values() for given in e.lines])
    made = sum(each(lambda entry: element_parts(entry, sheet.dialect), sheet.elements.values()), start=[])
    draft.parts += sorted(made, key=lambda made: isinstance(made.part, RotaryInertia))
    draft.parts += each(lambda line: _mass(line, sheet.node(line)), sheet.of("MASS"))
    draft.parts += _forces(sheet, draft)
    motions = PrescribedMotions(sheet)
    draft.parts += motions.prescribed
    draft.still, draft.steps = motions.still, draft.steps + motions.steps
    draft.parts += _dofs(sheet, twisting, draft.scales)
    draft.parts += motions.initial
    draft.inputs, draft.outputs, measured = terminals(sheet)
    draft.parts += measured
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


def _dofs(sheet: Sheet, twisting: Sequence[NodeEntry], scales: dict[str, float]) -> list[Declaration]:
    """Return dynamic and kinematic coordinates; a coordinate that is named twice counts once.

    In the Twente dialect they are in SPACAR's order: coordinates of nodes, then deformations, each by number and
    component; in the Delft one in the order of the file.

    Parameters
    ----------
    twisting : sequence of NodeEntry
        Nodes of warping that are dynamic coordinates in addition to the named ones, if there are any.
    scales : dict of str to float
        Is filled, see `Draft`.
    """
    chosen: dict[type[Independent | Kinematic], dict[str, Line]] = {Independent: {}, Kinematic: {}}
    place: dict[str, tuple[int, int, int]] = {}

    def name(line: Line) -> None:
        own = chosen[Kinematic if line.keyword in ("KINX", "KINE", "ENHC") else Independent]
        if line.keyword.endswith("X"):
            found = [((0, node.number, i), name_of(node, i)) for node, i in sheet.coordinates(line)]
        else:
            modes = [sheet.mode(line, 2, 3)] if line.keyword == "ENHC" else sheet.modes(line)
            found = [((1, entry.number, i), quantity(entry, i)[0]) for entry, i in modes]
            scales.update(
                quantity(entry, i) for entry, i in modes if entry.kind.modes[i - 1].node is not None
            )
        for where, quantity_name in found:
            own.setdefault(quantity_name, line)
            place[quantity_name] = where

    for keywords in (("DYNX", "KINX"), ("DYNE", "LINE", "KINE"), ("ENHC",)):
        sheet.problems.each(name, sheet.of(*keywords))
    for node in twisting if chosen[Independent] else ():
        chosen[Independent][name_of(node, 1)] = node.line
        place[name_of(node, 1)] = (0, node.number, 1)
    found = []
    for kind, named in chosen.items():
        names = sorted(named, key=place.__getitem__) if sheet.dialect == "twente" else list(named)
        if names:
            found.append(Declaration.of(named[names[0]], kind, tuple(names)))
    return found


# -- masses and loads ----------------------------------------------------------------------------


def _mass(line: Line, node: NodeEntry) -> Declaration:
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
        return Declaration.of(line, RotaryInertia, name, node.name, (xx, yy, zz, xy, xz, yz))
    if node.kind == "planar_angle":
        return Declaration.of(line, RotaryInertia, name, node.name, values[0])
    return Declaration.of(line, PointMass, name, node.name, values[0])


def _forces(sheet: Sheet, draft: Draft) -> list[Declaration]:
    """Return the loads that act from the start; loads of load steps are added to the draft's."""
    each = sheet.problems.each

    def growing(line: Line) -> list[Declaration]:
        rows = tuple(Polynomial((0.0, rate)) if rate else 0.0 for rate in line.values[1:])
        return _force(line, sheet.node(line), rows)

    def turning(line: Line) -> list[Declaration]:
        node, values = sheet.node(line), line.values[1:]
        if node.kind != "frame" or len(values) != 3:
            raise line.error("it takes an orientation node and three moments about the axes of the body")
        return [Declaration.of(line, LoadPart, node.name, values, follower=True)]

    constant = each(lambda line: _force(line, sheet.node(line), line.values[1:]), sheet.of("FORCE"))
    draft.steps += sum(each(growing, sheet.of("DELXF")), start=[])
    return sum([*constant, *each(turning, sheet.of("TORQUEL"))], start=[])


def _force(line: Line, node: NodeEntry, values: tuple[object, ...]) -> list[Declaration]:
    """Return a force, a moment, a bimoment on a warping node, or four forces conjugate to Euler parameters."""
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
        return [
            Declaration.of(line, LoadPart, f"{node.name}.{c}", value) for c, value in pairs if value != 0.0
        ]
    value = values if len(values) > 1 else values[0]
    return [Declaration.of(line, LoadPart, node.name, value)]
