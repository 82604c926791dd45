"""Reads prescribed motions and initial values of a file: u = u0 + v0 t + a0 t²/2."""

from __future__ import annotations

from dataclasses import dataclass

from flexel.apps.spacar.declarations import Declaration
from flexel.apps.spacar.file_entries import quantity
from flexel.apps.spacar.keywords import VALUES
from flexel.apps.spacar.lexer import Line
from flexel.apps.spacar.sheet import Sheet, name_of
from flexel.base.time_functions import Polynomial
from flexel.parts.roles import Initial, Prescribe

X_VALUES, E_VALUES = (VALUES[key].meaning for key in ("INPUTX", "INPUTE"))
# the lines that give values, rates and accelerations, by number 0, 1, 2 of derivatives of their first number
FIRST_ORDERS = {"E": 0, "STARTDE": 0, X_VALUES: 0, E_VALUES: 0, "XD": 1, "ED": 1, "XDD": 2, "EDD": 2}
OF_NODES = ("XD", "XDD", "DELINPX", X_VALUES)
KINDS = ("value", "rate", "acceleration")
TO_INPUTS = (X_VALUES, E_VALUES, "DELINPX", "DELINPE")  # lines that only an input can have


@dataclass(frozen=True)
class Input:
    """An input: its first line, the ratio of SPACAR's value to ours, and its value as drawn."""

    line: Line
    factor: float = 1.0
    drawn: float = 0.0


class PrescribedMotions:
    """Motions of inputs, and initial values of other quantities.

    Attributes
    ----------
    prescribed : list of Declaration
        Motions of the inputs.
    still, steps : list of Declaration
        In static load steps, where t is a load parameter: inputs that keep their values, and those that are moved.
    initial : list of Declaration
    """

    def __init__(self, sheet: Sheet) -> None:
        self.sheet, each = sheet, sheet.problems.each
        self.inputs: dict[str, Input] = {}
        self.given: dict[tuple[str, int], tuple[Line, float]] = {}
        self.changes: dict[str, tuple[Line, float]] = {}
        self.prescribed: list[Declaration] = []
        self.still: list[Declaration] = []
        self.steps: list[Declaration] = []
        sheet.each(self._input, "INPUTX", "INPUTE")
        each(self._values, sheet.of(*FIRST_ORDERS))
        each(self._change, sheet.of("DELINPX", "DELINPE"))
        times = sheet.of("TIME")
        self.start = times[0].values[0] if times else 0.0
        each(lambda pair: self._prescribe(*pair), self.inputs.items())
        initial = each(self._initial, sheet.of("E", "ED", "STARTDE")) + each(self._initial, sheet.of("XD"))
        self.initial = sum(initial, start=[])

    def _input(self, line: Line) -> None:
        if line.keyword == "INPUTX":
            for node, i in self.sheet.coordinates(line):
                self.inputs.setdefault(name_of(node, i), Input(line, drawn=float(node.x[i - 1])))
            return
        for entry, i in self.sheet.modes(line):
            name, factor = quantity(entry, i)
            self.inputs.setdefault(name, Input(line, factor))

    def _subject(self, line: Line) -> tuple[str, float]:
        """Return the name of the quantity of a line, and the ratio of SPACAR's value to flexel's."""
        if line.keyword in OF_NODES:
            return self.sheet.coordinate(line), 1.0
        return quantity(*self.sheet.mode(line))

    def _values(self, line: Line) -> None:
        name, _ = self._subject(line)
        if name not in self.inputs and (line.keyword in TO_INPUTS or FIRST_ORDERS[line.keyword] == 2):
            if line.keyword == E_VALUES and self.sheet.is_dynamic(*self.sheet.mode(line)):
                return  # noted
            self.sheet.refuse_unread(line)
            raise line.error(
                "it gives the motion of an input, which this is not; name it in the first block, by INPUTX or INPUTE"
                if line.keyword in TO_INPUTS
                else "an acceleration can only be given to an input; remove the line"
            )
        for order, value in enumerate(line.values[2:], FIRST_ORDERS[line.keyword]):
            first, _ = self.given.setdefault((name, order), (line, value))
            if first is not line:
                raise line.error(
                    f"the {KINDS[order]} is already given by {first.written} in line {first.number}; keep one of them"
                )

    def _change(self, line: Line) -> None:
        name, _ = self._subject(line)
        if name not in self.inputs:
            self.sheet.refuse_unread(line)
            raise line.error("it changes an input, which this is not; add a line INPUTX or INPUTE")
        self.changes[name] = (line, line.values[2])

    def _prescribe(self, name: str, own: Input) -> None:
        u, v, a = (
            self.given.get((name, order), (own.line, drawn))[1]
            for order, drawn in enumerate((own.drawn, 0.0, 0.0))
        )
        motion = _motion(u, v, a, self.start, own.factor)
        self.prescribed.append(Declaration.of(own.line, Prescribe, name, motion))
        if name in self.changes:
            line, change = self.changes[name]
            moving = Polynomial((u / own.factor, change / own.factor))
            self.steps.append(Declaration.of(line, Prescribe, name, moving))
        elif v or a:
            self.still.append(Declaration.of(own.line, Prescribe, name, u / own.factor))

    def _initial(self, line: Line) -> list[Declaration]:
        """Return initial values and rates of a quantity that is not an input."""
        name, factor = self._subject(line)
        if name in self.inputs:
            return []
        keys = KINDS[FIRST_ORDERS[line.keyword] : 2]
        given = [value / factor for value in line.values[2:]]
        return [Declaration.of(line, Initial, name, **dict(zip(keys, given, strict=False)))]


def _motion(u: float, v: float, a: float, t0: float, factor: float) -> Polynomial | float:
    """Return the polynomial in t with these values at t0, in flexel's deformations."""
    c = [u - v * t0 + a * t0**2 / 2, v - a * t0, a / 2]
    while len(c) > 1 and not c[-1]:
        c.pop()
    ours = tuple(value / factor for value in c)
    return Polynomial(ours) if len(ours) > 1 else ours[0]
