"""Finds contradictory statements about a coordinate or deformation in a file, and reports both lines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from flexel.apps.spacar.file_entries import quantity
from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.sheet import Sheet, name_of

FIXED_ROLE = "fixed"
ROLES = {"FIX": FIXED_ROLE, "INPUTX": "an input", "INPUTE": "an input"}
ROLES |= dict.fromkeys(("DYNX", "DYNE", "LINE"), "a dynamic coordinate")
ROLES |= dict.fromkeys(("KINX", "KINE", "ENHC"), "a kinematic coordinate")
STARTS = ("E", "ED", "STARTDE")


@dataclass(frozen=True)
class Claim:
    """The first line that gives a coordinate or deformation its role."""

    role: str
    line: Line

    def __str__(self) -> str:
        return f"{self.role} by {self.line.written} in line {self.line.number}"


class Claims:
    """The roles that a file gives to coordinates and deformations.

    Each has one role, and only movable ones have initial values and forces; a contradiction becomes an error
    that names the later line and the earlier one.
    """

    def __init__(self, sheet: Sheet) -> None:
        self.sheet = sheet
        self._found: dict[str, Claim] = {}
        each = sheet.problems.each
        each(self._claim, sheet.of(*ROLES))
        each(self._rate, sheet.of("XD"))
        each(self._start, sheet.of(*STARTS))
        each(self._force, sheet.of("FORCE", "DELXF"))

    def _claim(self, line: Line) -> None:
        for name, subject in _subjects(self.sheet, line):
            claim = self._found.setdefault(name, Claim(ROLES[line.keyword], line))
            if claim.role != ROLES[line.keyword]:
                raise line.error(
                    f"{subject} is {ROLES[line.keyword]} here and {claim}; it can only be one: remove it from one line"
                )

    def _rate(self, line: Line) -> None:
        claim = self._found.get(self.sheet.coordinate(line))
        if claim and claim.role == FIXED_ROLE:
            raise line.error(
                f"the coordinate is {claim}, and cannot have a given rate; remove one of the lines"
            )

    def _start(self, line: Line) -> None:
        entry, i = self.sheet.mode(line)
        if i not in entry.free and i not in entry.kind.slips:
            self.sheet.refuse_unread(line)
            raise line.error(
                f"mode {i} of element {entry.number} is rigid and cannot have an initial value; release it (RLSE, "
                "DYNE, INPUTE ...), or remove the line"
            )

    def _force(self, line: Line) -> None:
        """Check that a force acts on a movable coordinate."""
        node, values = self.sheet.node(line), line.values[1:]
        if len(values) != len(node.components):
            return  # moments about axes, which are not conjugate to a coordinate
        for i, value in enumerate(values, 1):
            claim = self._found.get(name_of(node, i))
            if value and claim and claim.role == FIXED_ROLE:
                raise line.error(
                    f"coordinate {i} of node {node.number} is {claim}, and a force cannot move it; give a zero, or "
                    "remove one of the lines"
                )


def _subjects(sheet: Sheet, line: Line) -> Iterator[tuple[str, str]]:
    """Return the quantities that get a role from a line: names in the model, and in the words of the file."""
    if line.keyword in ("INPUTX", "DYNX", "KINX", "FIX"):
        for node, i in sheet.coordinates(line):
            yield name_of(node, i), f"coordinate {i} of node {node.number}"
        return
    # of ENHC the first pair is a slip, not a coordinate
    for entry, i in [sheet.mode(line, 2, 3)] if line.keyword == "ENHC" else sheet.modes(line):
        yield quantity(entry, i)[0], f"mode {i} of element {entry.number}"
