"""A growing list of rows, each one operation on earlier rows: what a program is made of, and how it is read."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

LEAVES = frozenset({"const", "input"})
CONDITIONS = frozenset({"lt", "le", "eq", "not", "and", "or"})


class TapeRow(NamedTuple):
    """One operation: its name, the rows it works on, and the value of a constant or the name of an input."""

    op: str
    args: tuple[int, ...] = ()
    value: Fraction | str | None = None


class Graph:
    """Rows by number; equal rows are one.

    Attributes
    ----------
    rows : list of TapeRow
        Every argument of a row comes before it.
    names : dict of int to str
        Names that the author gave to rows.
    """

    def __init__(self) -> None:
        self.rows: list[TapeRow] = []
        self.names: dict[int, str] = {}
        self._index: dict[TapeRow, int] = {}
        self._constant: list[bool] = []
        self.zero = self.const(0)
        self.one = self.const(1)

    def row(self, op: str, args: tuple[int, ...] = (), value: Fraction | str | None = None) -> int:
        """Return the number of this row, new or known."""
        row = TapeRow(op, args, value)
        number = self._index.get(row)
        if number is None:
            number = len(self.rows)
            self.rows.append(row)
            self._constant.append(all(self._constant[arg] for arg in args) if op != "input" else False)
            self._index[row] = number
        return number

    # -- leaves

    def const(self, value: Fraction | int) -> int:
        """Add an exact constant."""
        return self.row("const", (), Fraction(value))

    def input(self, name: str, parameter: bool = False) -> int:
        """Add an input, known by its name; parameters count as constants (see `is_constant`)."""
        number = self.row("input", (), name)
        self._constant[number] = parameter
        return number

    def is_constant(self, a: int) -> bool:
        """Whether a row depends on nothing but parameters."""
        return self._constant[a]

    def constant(self, a: int) -> Fraction | None:
        """Return the value of a row that is a constant, else None."""
        row = self.rows[a]
        return row.value if row.op == "const" and isinstance(row.value, Fraction) else None

    # -- reading

    def reachable(self, outputs: Iterable[int]) -> list[int]:
        """Return the rows that the outputs need, themselves included, in ascending order."""
        seen: set[int] = set()
        stack = list(outputs)
        while stack:
            number = stack.pop()
            if number not in seen:
                seen.add(number)
                stack.extend(self.rows[number].args)
        return sorted(seen)

    def operations(self, outputs: Iterable[int]) -> int:
        """Count the operations that the outputs need; constants and inputs are none."""
        return sum(self.rows[number].op not in LEAVES for number in self.reachable(outputs))

    def in_order(self, outputs: Sequence[int]) -> list[int]:
        """Return the rows that the outputs need, each as late as its first use permits (depth first, left to right)."""
        done: set[int] = set()
        order: list[int] = []
        stack = [(number, False) for number in reversed(outputs)]
        while stack:
            number, ready = stack.pop()
            if number in done:
                continue
            if ready:
                done.add(number)
                order.append(number)
                continue
            stack.append((number, True))
            stack.extend((arg, False) for arg in reversed(self.rows[number].args))
        return order
