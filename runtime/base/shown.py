"""Tables of results, as text in a shell and as HTML in a notebook."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import ClassVar, Protocol, TypeVar

LONGEST = 60  # rows of a table that are shown, the rest is counted


@dataclass(frozen=True)
class Table:
    """A title, names of columns, and rows of text."""

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]

    @property
    def text(self) -> str:
        """Columns of equal width."""
        lines = [self.head, *self.rows[:LONGEST]] if self.rows else []
        widths = [max(len(line[i]) for line in lines) for i in range(len(self.head))] if lines else []
        body = ["  ".join(f"{z:<{w}}" for z, w in zip(line, widths, strict=True)).rstrip() for line in lines]
        return "\n".join([*([self.title] if self.title else []), *body, *self._rest()])

    @property
    def html(self) -> str:
        """A table for a notebook."""
        head = "".join(f"<th>{escape(z)}</th>" for z in self.head)
        body = "".join(
            f"<tr>{''.join(f'<td>{escape(z)}</td>' for z in row)}</tr>" for row in self.rows[:LONGEST]
        )
        rest = "".join(f"<p>{escape(z)}</p>" for z in self._rest())
        title = f"<p>{escape(self.title)}</p>" if self.title else ""
        return f"{title}<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{rest}"

    def _rest(self) -> list[str]:
        left = len(self.rows) - LONGEST
        return [f"and {left} more"] if left > 0 else []


class Row(Protocol):
    """Interface of the rows of a `Listing`."""

    HEAD: ClassVar[tuple[str, ...]]

    def row(self) -> tuple[str, ...]:
        """Its cells."""


R = TypeVar("R", bound=Row)


class Listing(list[R]):
    """A list of results that prints as a table."""

    def _table(self) -> Table:
        return Table("", self[0].HEAD, [z.row() for z in self]) if self else Table("none", (), ())

    def __repr__(self) -> str:
        return self._table().text

    def _repr_html_(self) -> str:
        return self._table().html


def counted(count: int, what: str) -> str:
    """A number with its noun in the singular or plural."""
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def listed(names: Sequence[str], most: int = 8) -> str:
    """Names joined by commas, the first ones if there are many."""
    shown = ", ".join(names[:most])
    return f"{shown} and {len(names) - most} more" if len(names) > most else shown
