"""The section about speed: times beside those of other programs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf, isfinite
from typing import Protocol

from flexel.base.shown import counted
from flexel.report.markup import Html, folded, join, size, table, tag
from flexel.report.parts import Measured, Timed
from flexel.report.plots import Plots, bars
from flexel.report.section import Section, absent

SAYS = (
    "The shortest CPU time of many runs in one thread (`flexel bench`), beside other programs with the same model, "
    "data and reference of the error, where they are installed. A failure is a row without a time, or an error above "
    "what the row allows. A figure to reach that is missed is not a failure: machines differ."
)
HEAD = (
    "row",
    "flexel",
    "to reach, to aim at",
    "met",
    "error",
    "allowed",
    "other programs: time, ratio to flexel, error",
)
OVER = "time over that of flexel: to the right of 1 flexel is faster"


def section(rows: Sequence[Timed], plots: Plots) -> Section:
    """The section about what `flexel bench` wrote, or that there is nothing."""
    said = "speed", "Speed", SAYS
    if not rows:
        return Section(*said, missing=[absent("bench", "The times")])
    failures = [f"{z.name}: {_wrong(z)}" for z in rows if _wrong(z)]
    beside = {f"{row.name}, {name}": z for row in rows for name, z in ratios(row, row.peers).items()}
    body: list[Html] = []
    if beside and plots.possible:
        drawn = plots.draw(bars, list(beside), list(beside.values()), OVER)
        body.append(tag("figure", drawn, tag("figcaption", OVER), class_="wide"))
    elif beside:
        body.append(tag("p", plots.remedy, class_="missing"))
    body.append(table(HEAD, map(_line, rows)))
    scaled = [z for z in rows if z.sizes]
    if scaled:
        body.append(folded("Times over the size", join(map(_scaling, scaled))))
    fair = [ratio for row in rows for ratio in best(ratios(row, row.peers)).values()]
    faster = sum(ratio > 1 for ratio in fair)
    others = f"{counted(len(fair), 'time')} of programs at their best; flexel is the faster one beside {faster} of them"
    return Section(
        *said, f"{counted(len(rows), 'row')}; {others if beside else 'no other program'}.", body, failures
    )


class Times(Protocol):
    """Times of a program: of the largest size, and of each size if the row has sizes."""

    @property
    def value(self) -> float | None:
        """Of the largest size."""

    @property
    def values(self) -> Sequence[float | None]:
        """Of each size."""


def ratios(row: Times, peers: Mapping[str, Times | None]) -> dict[str, float]:
    """Time of each peer over flexel's, for the largest size that both can."""
    found = {}
    for name, other in peers.items():
        if other is None:
            continue
        pairs = zip(other.values or [other.value], row.values or [row.value], strict=False)
        both = [time / own for time, own in pairs if time is not None and own]
        if both:
            found[name] = both[-1]
    return found


def program(name: str) -> str:
    """The name of a program without the way in which it is used: exudyn of "exudyn, full Newton"."""
    return name.partition(", ")[0]


def best(values: Mapping[str, float]) -> dict[str, float]:
    """Of each program the smallest value of all its ways, by the name with the way."""
    found: dict[str, str] = {}
    for name, value in values.items():
        if value < values.get(found.get(program(name), ""), inf):
            found[program(name)] = name
    return {name: values[name] for name in found.values()}


def _wrong(row: Timed) -> str:
    """What is wrong with a row; nothing, if it is right."""
    if row.value is None and not any(z is not None for z in row.values):
        return "no time: it failed"
    exact = row.error is not None and isfinite(row.error) and row.error <= (row.within or 0.0)
    return "" if row.within is None or exact else f"error {size(row.error)}, allowed {size(row.within)}"


def _line(row: Timed) -> tuple[str, Sequence[object]]:
    """The line of a row."""
    goals = "–" if row.reach is None or row.aim is None else f"{row.reach:g}, {row.aim:g} {row.unit}"
    ratio = ratios(row, row.peers)
    fair = best(ratio)
    beside = [_peer(name, z, ratio.get(name), row.unit, name in fair) for name, z in row.peers.items()]
    cells = row.name, _time(row.value, row.unit), goals, _met(row), size(row.error), size(row.within)
    return "bad" if _wrong(row) else "", (*cells, join(beside, "; ") or "–")


def _met(row: Timed) -> str:
    """Which figure is met."""
    if row.value is None or row.reach is None or row.aim is None:
        return "–"
    return "aim" if row.value <= row.aim else "reach" if row.value <= row.reach else "missed"


def _peer(name: str, found: Measured | None, ratio: float | None, unit: str, fair: bool) -> Html:
    """The figures of another program; the ratio of its best way is set in bold."""
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
    """A time in three digits."""
    return "–" if value is None else f"{value:.0f} {unit}" if value >= 100 else f"{value:.3g} {unit}"


def _scaling(row: Timed) -> Html:
    """The table of a row over its sizes."""
    programs = {"flexel": row, **{name: z for name, z in row.peers.items() if z is not None}}
    head = (f"{row.name} [{row.unit}]", *(f"N = {n}" for n in row.sizes), "power of N")
    lines = []
    for name, found in programs.items():
        times = ["–" if z is None else f"{z:.3g}" for z in found.values]
        lines.append(("", (name, *times, "–" if found.exponent is None else f"{found.exponent:.2f}")))
    return table(head, lines)
