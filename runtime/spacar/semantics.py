"""From the sheet to the calls that make the model and its analysis.

Roles, loads, motions and initial values are those of the file; deformations have SPACAR's signs in the file and
flexel's in the model, by the tables of `flexel.spacar.keywords`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from flexel.base.time_functions import Polynomial
from flexel.spacar.contradictions import refuse_contradictions
from flexel.spacar.elements import element_calls, node_calls
from flexel.spacar.lexer import Line
from flexel.spacar.sheet import ElementEntry, NodeEntry, Sheet, quantity
from flexel.spacar.statements import Call
from flexel.spacar.terminals import Terminal, notes, terminals


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
    notes: list[str] = field(default_factory=list)


def understand(sheet: Sheet, dialect: str) -> Draft:
    """The complete meaning of a sheet.

    Raises
    ------
    ModelError
        A line that contradicts the others or refers to something undefined; names file and line.
    """
    draft = Draft()
    for line in sheet.of("GRAVITY"):
        draft.gravity = (*line.values, 0.0)[:3]
    _mark_free(sheet)
    refuse_contradictions(sheet)
    draft.calls += node_calls([sheet.nodes[n] for n in sorted(sheet.nodes)])
    for entry in sheet.elements.values():
        draft.calls += element_calls(entry, dialect)
    for line in sheet.of("MASS"):
        draft.calls.append(_mass(line, sheet.node(line)))
    draft.calls += _forces(sheet, draft)
    _motions(sheet, draft)
    draft.calls += _dofs(sheet)
    draft.calls += _initial(sheet)
    draft.inputs, draft.outputs, measured = terminals(sheet)
    draft.calls += measured
    draft.notes = notes(sheet, dialect)
    return draft


def _modes(sheet: Sheet, line: Line) -> list[tuple[ElementEntry, int]]:
    return [sheet.mode(line, 0, place) for place in range(1, len(line.values))]


def _mark_free(sheet: Sheet) -> None:
    """Collect the modes that are not rigid, from all lines."""
    for line in sheet.of("RLSE", "DYNE", "KINE", "LINE"):
        for entry, i in _modes(sheet, line):
            if line.keyword != "RLSE" and i in entry.kind.slips:
                raise line.error(f"mode {i} of a {entry.line.keyword} is a slip, not a coordinate; remove it")
            entry.free.add(i)
    for line in sheet.of("INPUTE"):
        entry, i = sheet.mode(line)
        if i in entry.kind.slips:
            raise line.error(f"mode {i} of a {entry.line.keyword} is a slip, which has no value; remove it")
        entry.free.add(i)
    for line in sheet.of("ENHC"):
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


# -- masses and loads ----------------------------------------------------------------------------


def _mass(line: Line, node: NodeEntry) -> Call:
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
    calls = [call for line in sheet.of("FORCE") for call in _force(line, sheet.node(line), line.values[1:])]
    for line in sheet.of("DELXF"):
        rows = tuple(Polynomial((0.0, z)) if z else 0.0 for z in line.values[1:])
        draft.steps += _force(line, sheet.node(line), rows)
    for line in sheet.of("TORQUEL"):
        node, values = sheet.node(line), line.values[1:]
        if node.kind != "frame" or len(values) != 3:
            raise line.error("it takes an orientation node and three moments about the axes of the body")
        calls.append(Call("load", (node.name, values), {"follower": True}, line))
    return calls


def _force(line: Line, node: NodeEntry, values: tuple[object, ...]) -> list[Call]:
    """A force on a position, a moment on an orientation, or four forces dual to Euler parameters."""
    sizes = {"point": (3,), "planar_point": (2,), "planar_angle": (1,), "frame": (3, 4)}[node.kind]
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


# -- motions, degrees of freedom, initial values -----------------------------------------------------------


def _motions(sheet: Sheet, draft: Draft) -> None:
    """Prescribed motions u = u0 + v0 t + a0 t²/2, from the lines of inputs and of initial values."""
    rates = {sheet.coordinate(z): z.values[2] for z in sheet.of("XD")}
    second = {sheet.coordinate(z): z.values[2] for z in sheet.of("XDD")}
    starts: dict[str, float] = {}
    changes = {sheet.coordinate(z): (z, z.values[2]) for z in sheet.of("DELINPX")}
    inputs: dict[str, tuple[Line, float]] = {}
    for line in sheet.of("INPUTX"):
        node = sheet.node(line)
        name = sheet.coordinate(line)
        starts[name] = float(node.x[line.whole(1, "coordinate") - 1])
        inputs[name] = (line, 1.0)
    for line in sheet.of("INPUTE"):
        name, factor = quantity(*sheet.mode(line))
        inputs[name] = (line, factor)
    for line in sheet.of("E", "ED", "EDD", "STARTDE"):
        name, _ = quantity(*sheet.mode(line))
        tables = {"E": (starts,), "ED": (rates,), "EDD": (second,), "STARTDE": (starts, rates)}[line.keyword]
        for table, value in zip(tables, line.values[2:], strict=False):  # STARTDE may end with the value
            table[name] = value
    for line in sheet.of("DELINPE"):
        changes[quantity(*sheet.mode(line))[0]] = (line, line.values[2])
    for name in second:
        if name not in inputs:
            line = next(z for z in sheet.of("XDD", "EDD") if _subject(sheet, z) == name)
            raise line.error("an acceleration can only be given to an input; remove the line")
    times = sheet.of("TIME")
    start = times[0].values[0] if times else 0.0
    for name, (line, factor) in inputs.items():
        own = line.values[2:]
        given = (starts, rates, second)
        u, v, a = (own[i] if len(own) > i else table.get(name, 0.0) for i, table in enumerate(given))
        draft.calls.append(Call("prescribe", (name, _motion(u, v, a, start, factor)), {}, line))
        if name in changes:
            moving = Polynomial((u / factor, changes[name][1] / factor))
            draft.steps.append(Call("prescribe", (name, moving), {}, changes[name][0]))
        elif v or a:
            draft.still.append(Call("prescribe", (name, u / factor), {}, line))
    for name, (line, _) in changes.items():
        if name not in inputs:
            raise line.error("it changes an input, and this is not one; add a line INPUTX or INPUTE")


def _subject(sheet: Sheet, line: Line) -> str:
    """Name of the quantity to which an initial-value line refers."""
    return sheet.coordinate(line) if line.keyword.startswith("X") else quantity(*sheet.mode(line))[0]


def _motion(u: float, v: float, a: float, t0: float, factor: float) -> Polynomial | float:
    """The polynomial in t with these values at t0, in flexel's deformations."""
    c = [u - v * t0 + a * t0**2 / 2, v - a * t0, a / 2]
    while len(c) > 1 and not c[-1]:
        c.pop()
    ours = tuple(z / factor for z in c)
    return Polynomial(ours) if len(ours) > 1 else ours[0]


def _dofs(sheet: Sheet) -> list[Call]:
    """Dynamic and kinematic coordinates; a coordinate that is named twice counts once."""
    dynamic: dict[str, Line] = {}
    kinematic: dict[str, Line] = {}
    for line in sheet.of("DYNX", "KINX"):
        node = sheet.node(line)
        for i in sheet.places(line, node):
            chosen = dynamic if line.keyword == "DYNX" else kinematic
            chosen.setdefault(f"{node.name}.{node.components[i - 1]}", line)
    for line in sheet.of("DYNE", "LINE", "KINE"):
        for entry, i in _modes(sheet, line):
            chosen = kinematic if line.keyword == "KINE" else dynamic
            chosen.setdefault(quantity(entry, i)[0], line)
    for line in sheet.of("ENHC"):
        kinematic.setdefault(quantity(*sheet.mode(line, 2, 3))[0], line)
    chosen_for = (("independent", dynamic), ("kinematic", kinematic))
    return [
        Call(method, tuple(named), {}, next(iter(named.values()))) for method, named in chosen_for if named
    ]


def _initial(sheet: Sheet) -> list[Call]:
    """Initial values and rates of quantities that are not inputs."""
    inputs = {sheet.coordinate(z) for z in sheet.of("INPUTX")}
    inputs |= {quantity(*sheet.mode(z))[0] for z in sheet.of("INPUTE")}
    calls = []
    for line in sheet.of("E", "ED", "STARTDE"):
        name, factor = quantity(*sheet.mode(line))
        given = [z / factor for z in line.values[2:]]
        keys = {"E": ("value",), "ED": ("rate",), "STARTDE": ("value", "rate")}[line.keyword]
        if name not in inputs:
            calls.append(Call("initial", (name,), dict(zip(keys, given, strict=False)), line))
    for line in sheet.of("XD"):
        if sheet.coordinate(line) not in inputs:
            calls.append(Call("initial", (sheet.coordinate(line),), {"rate": line.values[2]}, line))
    return calls
