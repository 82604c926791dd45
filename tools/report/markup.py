"""Builds HTML whose text is always escaped: `tag` makes elements, and only its results are used unescaped."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence


class Html(str):
    """Text that is HTML already."""

    __slots__ = ()


def text(value: object) -> Html:
    """Return HTML unchanged; anything else as text, escaped."""
    return value if isinstance(value, Html) else Html(html.escape(str(value)))


def join(parts: Iterable[object], between: str = "") -> Html:
    """Join several pieces of HTML."""
    return Html(str(text(between)).join(text(part) for part in parts))


def tag(name: str, *children: object, **attributes: str) -> Html:
    """Make an element with its attributes and children; `class_` becomes class, empty attributes are left out."""
    given = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{html.escape(value)}"'
        for key, value in attributes.items()
        if value
    )
    return Html(f"<{name}{given}>{join(children)}</{name}>")


def table(head: Sequence[str], rows: Iterable[tuple[str, Sequence[object]]]) -> Html:
    """Make a table in a box that scrolls sideways on a narrow screen.

    Parameters
    ----------
    head : sequence of str
        Titles of the columns.
    rows : iterable of (str, sequence)
        Class of a row, as "bad" or "", and its cells.
    """
    titles = tag("thead", tag("tr", *(tag("th", title, scope="col") for title in head)))
    lines = [tag("tr", *(tag("td", cell) for cell in cells), class_=kind) for kind, cells in rows]
    return tag("div", tag("table", titles, tag("tbody", join(lines, "\n"))), class_="scroll")


def folded(title: object, *children: object, unfolded: bool = False) -> Html:
    """Make a part that opens with a click on its title."""
    start = "<details open>" if unfolded else "<details>"
    return Html(f"{start}{tag('summary', title)}{join(children)}</details>")


def sentence(written: str, kind: str = "") -> Html:
    """Make a paragraph of a class, with code between back ticks."""
    pieces = written.split("`")
    return tag("p", *(tag("code", piece) if i % 2 else piece for i, piece in enumerate(pieces)), class_=kind)


def size(error: float | None) -> str:
    """Write an error with two digits; a dash for none."""
    if error is None:
        return "–"
    digits, e, power = f"{error:.1e}".partition("e")
    return digits + e + str(int(power)) if error and e else f"{error:g}"  # 0, nan and inf have no exponent


def time(seconds: float) -> str:
    """Write the duration of a command."""
    return f"{seconds:.1f} s" if seconds < 100 else f"{seconds / 60:.0f} min"
