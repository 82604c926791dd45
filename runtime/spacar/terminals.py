"""Inputs and outputs of the linear model requested by a file, and the reader's notes on it."""

from __future__ import annotations

from dataclasses import dataclass

from flexel.spacar.keywords import WITHOUT_EFFECT
from flexel.spacar.sheet import Sheet, quantity
from flexel.spacar.statements import Call

MOMENTS = ("wx", "wy", "wz")


@dataclass(frozen=True)
class Terminal:
    """An input or output of the linear model: its name for `Linearization.state_space`, the ratio SPACAR/flexel."""

    number: int
    name: str
    factor: float


def terminals(sheet: Sheet) -> tuple[list[Terminal], list[Terminal], list[Call]]:
    """Inputs and outputs of the linear model in the order of their numbers, and the calls that measure them."""
    inputs, measured = _inputs(sheet)
    outputs = _outputs(sheet)
    for found, lines in (
        (inputs, sheet.of("INPUTF", "INPUTS")),
        (outputs, sheet.of("OUTX", "OUTXP", "OUTE", "OUTEP")),
    ):
        found.sort(key=lambda z: z.number)
        numbers = [z.number for z in found]
        if numbers != list(range(1, len(numbers) + 1)):
            raise lines[-1].error(
                f"inputs and outputs are numbered 1, 2, 3 ..., each once; here they are {numbers}"
            )
    return inputs, outputs, measured


def _inputs(sheet: Sheet) -> tuple[list[Terminal], list[Call]]:
    found, measured = [], []
    for line in sheet.of("INPUTF"):
        node = sheet.node(line, 1)
        name = sheet.coordinate(line, 1)
        if node.kind == "frame":
            i = line.whole(2, "moment")
            if i > 3:
                raise line.error("moments on an orientation node have numbers 1 to 3, about x, y and z")
            measured.append(Call("angular_velocity", (node.name,), {}, line))
            name = f"{node.name}.omega.{MOMENTS[i - 1]}"
        found.append(Terminal(line.whole(0, "input"), name, 1.0))
    for line in sheet.of("INPUTS"):
        name, factor = quantity(*sheet.mode(line, 1, 2))
        # a load in flexel does work as the deformation grows, a stress the opposite
        found.append(Terminal(line.whole(0, "input"), name, -1.0 / factor))
    return found, measured


def _outputs(sheet: Sheet) -> list[Terminal]:
    found = []
    for line in sheet.of("OUTX", "OUTXP"):
        prime = "'" if line.keyword == "OUTXP" else ""
        found.append(Terminal(line.whole(0, "output"), sheet.coordinate(line, 1) + prime, 1.0))
    for line in sheet.of("OUTE", "OUTEP"):
        entry, i = sheet.mode(line, 1, 2)
        name, factor = quantity(entry, i)
        if line.keyword == "OUTE" and i in entry.kind.slips:
            raise line.error(
                f"mode {i} of element {entry.number} is a slip, which has only a rate; use OUTEP"
            )
        found.append(Terminal(line.whole(0, "output"), name + "'" * (line.keyword == "OUTEP"), factor))
    return found


def notes(sheet: Sheet, dialect: str) -> list[str]:
    """Lines without effect, and assumptions, with the lines of the file."""
    found = []
    for line in sheet.lines:
        if line.keyword in WITHOUT_EFFECT:
            found.append(f"line {line.number}: {line.written} has no effect: {WITHOUT_EFFECT[line.keyword]}")
    for entry in sheet.elements.values():
        where = f"line {entry.line.number}: {entry.line.written} {entry.number}"
        if entry.kind.assumed:
            found.append(f"{where}: {entry.kind.assumed}")
        if entry.line.keyword in ("BEAMNL",) or (dialect == "twente" and entry.line.keyword == "BEAM"):
            found.append(f"{where}: with all terms of second order in its deformations, torsion included")
        turned = [n for n in entry.nodes if n.kind == "frame" and abs(n.x[0]) < 1 - 1e-12]
        if turned and entry.numbers and entry.line.keyword != "SURFACE":
            found.append(f"{where}: its direction is read in global axes as drawn, where frames are turned")
    return found
