"""Writes the section about speed: times compared with those of other programs."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from bench.ratios import best, peer_ratios

from flexel.base.shown import counted
from report.markup import Html, folded, join, size, table, tag
from report.parts import Measured, Timed
from report.plots import Plots, bars
from report.section import PageSection, absent

SAYS = (
    "The shortest CPU time of many runs in one thread (`flexel bench`), compared with other programs for the same "
    "model, data and reference of the error, if installed. A failure is a row without a time, or an error above "
    "what the row allows. A missed target is not a failure: machines differ."
)
HEAD = (
    "row",
    "flexel",
    "target, goal",
    "met",
    "error",
    "allowed",
    "other programs: time, ratio to flexel, error",
)
OVER = "time over that of flexel: to the right of 1 flexel is faster"


def section(rows: Sequence[Timed], plots: Plots) -> PageSection:
    """Write the section about the results of `flexel bench`, or state that there are none."""
    said = "speed", "Speed", SAYS
    if not rows:
        return PageSection(*said, missing=[absent("bench", "The times")])
    failures = [f"{row.name}: {_wrong(row)}" for row in rows if _wrong(row)]
    ratios_to_peers = {
        f"{row.name}, {name}": ratio for row in rows for name, ratio in peer_ratios(row, row.peers).items()
    }
    body: list[Html] = []
    if ratios_to_peers and plots.possible:
        drawn = plots.draw(bars, list(ratios_to_peers), list(ratios_to_peers.values()), OVER)
        body.append(tag("figure", drawn, tag("figcaption", OVER), class_="wide"))
    elif ratios_to_peers:
        body.append(tag("p", plots.remedy, class_="missing"))
    body.append(table(HEAD, map(_line, rows)))
    scaled = [row for row in rows if row.sizes]
    if scaled:
        body.append(folded("Times over the size", join(map(_scaling, scaled))))
    fair = [ratio for row in rows for ratio in best(peer_ratios(row, row.peers)).values()]
    faster = sum(ratio > 1 for ratio in fair)
    others = f"{counted(len(fair), 'time')} of programs at their best; flexel is faster than {faster} of them"
    return PageSection(
        *said,
        f"{counted(len(rows), 'row')}; {others if ratios_to_peers else 'no other program'}.",
        body,
        failures,
    )


def _wrong(row: Timed) -> str:
    """Describe the defect of a row; empty if there is none."""
    if row.value is None and not any(value is not None for value in row.values):
        return "no time: it failed"
    exact = row.error is not None and isfinite(row.error) and row.error <= (row.within or 0.0)
    return "" if row.within is None or exact else f"error {size(row.error)}, allowed {size(row.within)}"


def _line(row: Timed) -> tuple[str, Sequence[object]]:
    """Write the line of a row."""
    goals = "–" if row.target is None or row.goal is None else f"{row.target:g}, {row.goal:g} {row.unit}"
    ratio = peer_ratios(row, row.peers)
    fair = best(ratio)
    figures = [_peer(name, peer, ratio.get(name), row.unit, name in fair) for name, peer in row.peers.items()]
    cells = row.name, _time(row.value, row.unit), goals, _met(row), size(row.error), size(row.within)
    return "bad" if _wrong(row) else "", (*cells, join(figures, "; ") or "–")


def _met(row: Timed) -> str:
    """Return the figure that is met."""
    if row.value is None or row.target is None or row.goal is None:
        return "–"
    return "goal" if row.value <= row.goal else "target" if row.value <= row.target else "missed"


def _peer(name: str, found: Measured | None, ratio: float | None, unit: str, fair: bool) -> Html:
    """Write the figures of another program; the ratio of its best way is set in bold."""
    if found is None:
        return join([f"{name} not installed"])
    shown = "–" if ratio is None else f"{ratio:.3g}"
    return join(
        [
            f"{name} {_time(found.value, unit)}, ",
            tag("b", shown) if fair else shown,
            f", error {size(found.error)}",
        ]
    )


def _time(value: float | None, unit: str) -> str:
    """Write a time in three digits."""
    return "–" if value is None else f"{value:.0f} {unit}" if value >= 100 else f"{value:.3g} {unit}"


def _scaling(row: Timed) -> Html:
    """Write the table of a row over its sizes."""
    programs = {"flexel": row, **{name: peer for name, peer in row.peers.items() if peer is not None}}
    head = (f"{row.name} [{row.unit}]", *(f"N = {n}" for n in row.sizes), "power of N")
    lines = []
    for name, found in programs.items():
        times = ["–" if value is None else f"{value:.3g}" for value in found.values]
        lines.append(("", (name, *times, "–" if found.exponent is None else f"{found.exponent:.2f}")))
    return table(head, lines)
