"""Fill the tables of README.md and the pages with the figures of `flexel bench`.

``python tools/measured.py FILE`` takes the figures of a file that `flexel bench --json FILE` wrote: rows that it has
replace those in ``docs/measured.json``. Without FILE the tables are filled from there; ``--check`` changes nothing and
fails where a table differs. A table is between two marks, and is written anew:

    <!--measured: bicycle_rhs chain_*-->     these rows, flexel beside its peers
    <!--scaling: scaling_*-->                rows that scale: a table of times over the size for each
    <!--end-->
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import filling
from bench.ratios import best
from filling import DOCS, pages
from report.markup import size

KEPT = DOCS / "measured.json"
BLOCK = filling.marked("measured|scaling")
Figures = Sequence[Mapping[str, Any]]


def kept() -> list[dict[str, Any]]:
    """Return the figures from which the tables are filled."""
    found: list[dict[str, Any]] = json.loads(KEPT.read_text(encoding="utf-8"))
    return found


def merged(old: Figures, new: Figures) -> list[Mapping[str, Any]]:
    """Combine rows of both, preferring the new figures, in the order of the old ones."""
    rows = {row["name"]: row for row in old} | {row["name"]: row for row in new}
    return list(rows.values())


def chosen(figures: Figures, patterns: str) -> list[Mapping[str, Any]]:
    """Return the rows that match patterns, in the order of the patterns."""
    found: dict[str, Mapping[str, Any]] = {}
    for pattern in patterns.split():
        some = {row["name"]: row for row in figures if fnmatchcase(row["name"], pattern)}
        if not some:
            raise ValueError(
                f"no measured row matches {pattern!r}; there are: {', '.join(row['name'] for row in figures)}"
            )
        found = found | some
    return list(found.values())


def time(value: float | None) -> str:
    """Write three digits, without an exponent."""
    if value is None:
        return "–"
    whole = len(str(int(abs(value)))) if abs(value) >= 1 else 0
    leading = 0 if whole or not value else -int(f"{value:e}".partition("e")[2]) - 1
    return f"{value:.{max(3 - whole + leading, 0)}f}"


def beside(row: Mapping[str, Any]) -> str:
    """Write the peers of a row: time, error, and the ratio for the fastest way of each program."""
    parts = []
    known = {name: peer["value"] for name, peer in row["peers"].items() if peer and peer["value"] is not None}
    fair = best(known)
    for name, peer in row["peers"].items():
        if name not in known:
            parts.append(f"{name}: {'not installed' if peer is None else 'no figure'}")
            continue
        ratio = [f"**{time(peer['value'] / row['value'])}**"] if name in fair else []
        error = [] if peer["error"] is None else [f"error {size(peer['error'])}"]
        behind = f" ({', '.join(ratio + error)})" if ratio or error else ""
        parts.append(f"{name}: {time(peer['value'])}{behind}")
    return "; ".join(parts)


def rows(figures: Figures) -> Iterator[str]:
    """Write a table: flexel, its error, and its peers with the ratio of the times."""
    yield "| row | flexel | target, goal | error | peers: time (**time over flexel's**, error) |"
    yield "|---|---|---|---|---|"
    for row in figures:
        goals = "–" if row["goal"] is None else f"{row['target']:g}, {row['goal']:g}"
        value = f"{time(row['value'])} {row['unit']}"
        yield f"| `{row['name']}` | {value} | {goals} | {size(row['error'])} | {beside(row) or '–'} |"


def scaling(figures: Figures) -> Iterator[str]:
    """Write, for each row, a table of times over the size, and the fitted powers of N."""
    for row in figures:
        programs = {"flexel": row} | {name: peer for name, peer in row["peers"].items() if peer is not None}
        sizes = " | ".join(f"N = {n}" for n in row["sizes"])
        yield f"| `{row['name']}` [{row['unit']}] | {sizes} | power of N | error |"
        yield "|---" * (len(row["sizes"]) + 3) + "|"
        for name, found in programs.items():
            times = " | ".join(map(time, found["values"]))
            power = "–" if found["exponent"] is None else f"{found['exponent']:.2f}"
            yield f"| {name} | {times} | {power} | {size(found['error'])} |"
        yield ""


def filled(text: str, figures: Figures) -> str:
    """Return the page with its tables written anew."""

    def lines(found: re.Match[str]) -> Iterator[str]:
        return (rows if found[2] == "measured" else scaling)(chosen(figures, found[3]))

    return filling.filled(text, BLOCK, lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Fill or check the tables; the exit status is 1 if one differs."""
    parser = argparse.ArgumentParser(description="Tables of the pages from the figures of flexel bench.")
    parser.add_argument("file", nargs="?", type=Path, help="JSON of flexel bench")
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a table differs")
    given = parser.parse_args(arguments)
    figures: Figures = kept() if KEPT.is_file() else []
    if given.file is not None:
        figures = merged(figures, json.loads(given.file.read_text(encoding="utf-8")))
        if not given.check:
            KEPT.write_text(f"[\n{filling.entries(figures)}\n]\n", encoding="utf-8")
    return filling.fill(pages(), lambda text: filled(text, figures), check=given.check)


if __name__ == "__main__":
    sys.exit(main())
