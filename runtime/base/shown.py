"""Prints results as tables: text in a shell, HTML in a notebook."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import wraps
from html import escape
from typing import Any, ClassVar, Protocol, TypeVar, cast

from flexel.base.arrays import Array

MAX_ROWS_SHOWN = 60  # rows of a table that are shown; the remaining ones are counted


@dataclass(frozen=True)
class PrintedTable:
    """A title, names of columns, and rows of text."""

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]

    @property
    def text(self) -> str:
        """Columns of equal width."""
        lines = [self.head, *self.rows[:MAX_ROWS_SHOWN]] if self.rows else []
        widths = [max(len(line[i]) for line in lines) for i in range(len(self.head))] if lines else []
        body = [
            "  ".join(f"{cell:<{w}}" for cell, w in zip(line, widths, strict=True)).rstrip() for line in lines
        ]
        return "\n".join([*([self.title] if self.title else []), *body, *self._rest()])

    @property
    def html(self) -> str:
        """A table for a notebook."""
        head = "".join(f"<th>{escape(title)}</th>" for title in self.head)
        body = "".join(
            f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>"
            for row in self.rows[:MAX_ROWS_SHOWN]
        )
        rest = "".join(f"<p>{escape(line)}</p>" for line in self._rest())
        title = f"<p>{escape(self.title)}</p>" if self.title else ""
        return f"{title}<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{rest}"

    def _rest(self) -> list[str]:
        left = len(self.rows) - MAX_ROWS_SHOWN
        return [f"and {left} more"] if left > 0 else []


SIMPLE = str.maketrans(
    {"×": "x", "…": "...", "·": "*", "−": "-", "²": "^2", "³": "^3", "°": " deg", "λ": "lambda", "ω": "omega"}
    | {"δ": "delta", "Δ": "Delta", "ζ": "zeta", "µ": "u", "√": "sqrt", "≤": "<=", "≥": ">=", "Φ": "Phi"}
)
F = TypeVar("F", bound=Callable[[Any], str])


def printable(text: str) -> str:
    """Return a text as standard output can print it: what its encoding lacks is replaced."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return text.translate(SIMPLE).encode(encoding, "replace").decode(encoding)
    return text


def prints(method: F) -> F:
    """Decorate `__repr__` or `__str__`, so that ``print`` never raises a UnicodeEncodeError."""

    @wraps(method)
    def text(self: object) -> str:
        return printable(method(self))

    return cast(F, text)


class Histories(dict[str, Array]):
    """Arrays over time by name, all in one unit; shown by their ranges."""

    def __init__(self, unit: str, values: Mapping[str, Array]) -> None:
        super().__init__(values)
        self.unit = unit

    @prints
    def __repr__(self) -> str:
        ranges = (f"{name} {_range(values)} {self.unit}".rstrip() for name, values in self.items())
        return f"Histories({', '.join(ranges)})"


def _range(values: Array) -> str:
    """Return the least and the largest of some values."""
    if not values.size:
        return "(empty)"
    low, high = f"{values.min():.4g}", f"{values.max():.4g}"
    return low if low == high else f"{low} … {high}"


class TableRow(Protocol):
    """Interface of the rows of a `Listing`."""

    HEAD: ClassVar[tuple[str, ...]]

    def row(self) -> tuple[str, ...]:
        """Return its cells."""


R = TypeVar("R", bound=TableRow)


class Listing(list[R]):
    """A list of results that prints as a table."""

    def _table(self) -> PrintedTable:
        return (
            PrintedTable("", self[0].HEAD, [item.row() for item in self])
            if self
            else PrintedTable("none", (), ())
        )

    @prints
    def __repr__(self) -> str:
        return self._table().text

    def _repr_html_(self) -> str:
        return self._table().html


def counted(count: int, what: str) -> str:
    """Write a number with its noun in the singular or plural."""
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def listed(names: Sequence[str], most: int = 8) -> str:
    """Join names by commas; show only the first ones if there are many."""
    shown = ", ".join(names[:most])
    return f"{shown} and {len(names) - most} more" if len(names) > most else shown


def quoted(names: list[str], most: int | None = None) -> str:
    """Put names in quotes, separated by commas; only the first ones if there are more than `most`."""
    return listed([f"'{name}'" for name in names], len(names) if most is None else most)
