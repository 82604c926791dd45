"""Inputs and outputs of the linear model requested by a file."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.file_entries import quantity
from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.sheet import Sheet
from flexel.apps.spacar.warping_beams import TORSION
from flexel.parts.loads import AngularVelocity

MOMENTS = ("wx", "wy", "wz")


@dataclass(frozen=True)
class Terminal:
    """An input or output of the linear model: its name for `Linearization.state_space`, and the ratio SPACAR/flexel."""

    number: int
    name: str
    factor: float


def terminals(sheet: Sheet) -> tuple[list[Terminal], list[Terminal], list[Declaration]]:
    """Return inputs and outputs of the linear model in the order of their numbers, and the parts that measure them."""
    measured: list[Declaration] = []
    makers = {
        "INPUTF": lambda line: _force(sheet, line, measured),
        "INPUTS": lambda line: _stress(sheet, line),
        **dict.fromkeys(("OUTX", "OUTXP"), lambda line: _coordinate(sheet, line)),
        **dict.fromkeys(("OUTE", "OUTEP"), lambda line: _deformation(sheet, line)),
    }
    found = []
    for what, keywords in (("input", ("INPUTF", "INPUTS")), ("output", ("OUTX", "OUTXP", "OUTE", "OUTEP"))):
        seen: dict[int, Line] = {}
        lines = sheet.problems.each(partial(_numbered, what=what, seen=seen), sheet.of(*keywords))
        own = sheet.problems.each(lambda line: makers[line.keyword](line), lines)
        own.sort(key=lambda terminal: terminal.number)
        if own and own[-1].number != len(own) and lines:
            numbers = ", ".join(str(terminal.number) for terminal in own)
            sheet.notes.add(
                lines[0], f"{what}s have the numbers {numbers}; matrices have one for each, in this order"
            )
        found.append(own)
    return found[0], found[1], measured


def _numbered(line: Line, what: str, seen: dict[int, Line]) -> Line:
    """Return the line, if its number has not been given before; there may be gaps."""
    number = line.whole(0, what)
    first = seen.setdefault(number, line)
    if first is not line:
        raise line.error(f"{what} {number} is already given in line {first.number}; give another number")
    return line


def _force(sheet: Sheet, line: Line, measured: list[Declaration]) -> Terminal:
    node, name = sheet.node(line, 1), sheet.coordinate(line, 1)
    if node.kind == "frame":
        i = line.whole(2, "moment")
        if i > 3:
            raise line.error("moments on an orientation node have numbers 1 to 3, about x, y and z")
        measured.append(Declaration.of(line, AngularVelocity, node.name))
        name = f"{node.name}.omega.{MOMENTS[i - 1]}"
    return Terminal(line.whole(0, "input"), name, 1.0)


def _stress(sheet: Sheet, line: Line) -> Terminal:
    entry, i = sheet.mode(line, 1, 2)
    if entry.line.keyword == "BEAMW" and i == TORSION:
        raise line.error(
            "mode 2 of a BEAMW as an input is not supported; apply the torque to its nodes by INPUTF"
        )
    name, factor = quantity(entry, i)
    # a load in flexel does work as the deformation grows, a stress the opposite
    return Terminal(line.whole(0, "input"), name, -1.0 / factor)


def _coordinate(sheet: Sheet, line: Line) -> Terminal:
    prime = "'" if line.keyword == "OUTXP" else ""
    return Terminal(line.whole(0, "output"), sheet.coordinate(line, 1) + prime, 1.0)


def _deformation(sheet: Sheet, line: Line) -> Terminal:
    entry, i = sheet.mode(line, 1, 2)
    name, factor = quantity(entry, i)
    if line.keyword == "OUTE" and i in entry.kind.slips:
        raise line.error(f"mode {i} of element {entry.number} is a slip, which has only a rate; use OUTEP")
    return Terminal(line.whole(0, "output"), name + "'" * (line.keyword == "OUTEP"), factor)
