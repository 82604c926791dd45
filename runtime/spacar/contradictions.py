"""Contradictory statements about a coordinate or deformation in a file, reported with both lines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from flexel.spacar.lexer import Line
from flexel.spacar.sheet import Sheet, quantity

HELD = "fixed"
ROLES = {"FIX": HELD, "INPUTX": "an input", "INPUTE": "an input"}
ROLES |= dict.fromkeys(("DYNX", "DYNE", "LINE"), "a dynamic coordinate")
ROLES |= dict.fromkeys(("KINX", "KINE", "ENHC"), "a kinematic coordinate")


@dataclass(frozen=True)
class Claim:
    """The first line that gives a coordinate or deformation its role."""

    role: str
    line: Line

    def __str__(self) -> str:
        return f"{self.role} by {self.line.written} in line {self.line.number}"


def refuse_contradictions(sheet: Sheet) -> None:
    """Each coordinate and deformation has one role, and only movable ones have initial values and forces.

    Raises
    ------
    ModelError
        Names the later line and the earlier one.
    """
    claims: dict[str, Claim] = {}
    for line in sheet.of(*ROLES):
        for name, subject in _subjects(sheet, line):
            claim = claims.setdefault(name, Claim(ROLES[line.keyword], line))
            if claim.role != ROLES[line.keyword]:
                raise line.error(
                    f"{subject} is {ROLES[line.keyword]} here and {claim}; it can only be one: remove it from one line"
                )
    _refuse_values_of_what_is_held(sheet, claims)
    _refuse_forces_on_what_is_held(sheet, claims)


def _subjects(sheet: Sheet, line: Line) -> Iterator[tuple[str, str]]:
    """Quantities that get a role from a line: names in the model, and in the words of the file."""
    if line.keyword in ("INPUTE", "DYNE", "LINE", "KINE", "ENHC"):
        element = 2 if line.keyword == "ENHC" else 0  # its first pair is a slip, not a coordinate
        last = element + 2 if line.keyword in ("INPUTE", "ENHC") else len(line.values)
        for place in range(element + 1, last):
            entry, i = sheet.mode(line, element, place)
            yield quantity(entry, i)[0], f"mode {i} of element {entry.number}"
        return
    node = sheet.node(line)
    if line.keyword == "INPUTX":  # the rest are values
        yield sheet.coordinate(line), f"coordinate {line.words[1]} of node {node.number}"
        return
    for i in sheet.places(line, node) or range(1, len(node.components) + 1):
        yield f"{node.name}.{node.components[i - 1]}", f"coordinate {i} of node {node.number}"


def _refuse_values_of_what_is_held(sheet: Sheet, claims: dict[str, Claim]) -> None:
    for line in sheet.of("XD"):
        claim = claims.get(sheet.coordinate(line))
        if claim and claim.role == HELD:
            raise line.error(
                f"the coordinate is {claim}, and cannot have a given rate; remove one of the lines"
            )
    for line in sheet.of("E", "ED", "STARTDE"):
        entry, i = sheet.mode(line)
        if i not in entry.free and i not in entry.kind.slips:
            raise line.error(
                f"mode {i} of element {entry.number} is rigid and cannot have an initial value; release it (RLSE, "
                "DYNE, INPUTE ...), or remove the line"
            )


def _refuse_forces_on_what_is_held(sheet: Sheet, claims: dict[str, Claim]) -> None:
    """Check that a force acts on a movable coordinate."""
    for line in sheet.of("FORCE", "DELXF"):
        node, values = sheet.node(line), line.values[1:]
        if len(values) != len(node.components):
            continue  # moments about axes, which are not dual to a coordinate
        for i, (component, value) in enumerate(zip(node.components, values, strict=True), 1):
            claim = claims.get(f"{node.name}.{component}")
            if value and claim and claim.role == HELD:
                raise line.error(
                    f"coordinate {i} of node {node.number} is {claim}, and a force cannot move it; give a zero, or "
                    "remove one of the lines"
                )
