"""The section about convergence: errors on finer and finer meshes or with smaller and smaller steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flexel.base.shown import counted
from flexel.report.markup import Html, folded, sentence, size, table, tag
from flexel.report.parts import Case, Row
from flexel.report.plots import Plots, log_log
from flexel.report.section import Section, absent

SAYS = (
    "The error of results with more and more elements or steps, and the order with which it falls from the last but "
    "one to the last. Where the order is known, it is a row of its own among the systems, and fails there. Dashed: the "
    "nearest whole order, to guide the eye."
)
HEAD = ("system", "quantity", "over", "meshes", "errors", "order")


@dataclass(frozen=True)
class Series:
    """Errors of one quantity over the number of elements or steps."""

    case: str
    name: str
    over: str
    meshes: Sequence[float]
    errors: Sequence[float]
    order: float | None


def series(cases: Sequence[Case]) -> list[Series]:
    """What converges among the rows."""
    found = [(case.case, row) for case in cases for row in case.quantities]
    return [_series(case, row) for case, row in found if _converges(row)]


def _converges(row: Row) -> bool:
    """Whether a row has errors on meshes."""
    both = _numbers(row.errors), _numbers(row.meshes)
    return all(both) and len(row.errors) == len(row.meshes) > 1


def _numbers(value: Any) -> bool:
    """Whether a value is a list of numbers."""
    return isinstance(value, list) and all(isinstance(z, int | float) for z in value)


def _series(case: str, row: Row) -> Series:
    order = float(row.order) if isinstance(row.order, int | float) else None
    over = "elements" if row.steps is None else "steps"
    return Series(case, row.name.removesuffix("_error"), over, row.meshes, row.errors, order)


def section(cases: Sequence[Case], plots: Plots) -> Section:
    """The section, with one small plot for each quantity."""
    said = "convergence", "Convergence", SAYS
    found = series(cases)
    if not found:
        return Section(*said, missing=[absent("reproduce", "Systems with errors on several meshes")])
    groups = [(name, [z for z in found if z.case == name]) for name in dict.fromkeys(z.case for z in found)]
    lines = [
        (z.case, z.name, z.over, _listed(z.meshes), ", ".join(map(size, z.errors)), _order(z)) for z in found
    ]
    listing = folded("Table of all", table(HEAD, [("", line) for line in lines]), unfolded=not plots.possible)
    drawn = (
        [_group(*group, plots) for group in groups] if plots.possible else [sentence(plots.remedy, "missing")]
    )
    return Section(*said, f"{len(found)} quantities of {counted(len(groups), 'system')}.", [*drawn, listing])


def _group(case: str, found: Sequence[Series], plots: Plots) -> Html:
    """The plots of a system."""
    drawn = tag("div", *(_plot(one, plots) for one in found), class_="plots")
    return folded(f"{case}: {counted(len(found), 'plot')}", drawn, unfolded=True)


def _listed(numbers: Sequence[float]) -> str:
    return ", ".join(f"{n:g}" for n in numbers)


def _order(found: Series) -> str:
    return "–" if found.order is None else f"{found.order:.2f}"


def _plot(found: Series, plots: Plots) -> Html:
    """The plot of a quantity with its caption."""
    drawn = plots.draw(log_log, found.meshes, found.errors, found.order, found.over)
    caption = (
        tag("b", found.name),
        f" order {_order(found)}; {size(found.errors[-1])} with {found.meshes[-1]:g} {found.over}",
    )
    return tag("figure", drawn, tag("figcaption", *caption))
