"""Writes the section about convergence: errors on finer and finer meshes or with smaller and smaller steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flexel.base.shown import counted
from report.markup import Html, folded, sentence, size, table, tag
from report.parts import Case, QuantityRow
from report.plots import Plots, log_log
from report.section import PageSection, absent

SAYS = (
    "The error of results with more and more elements or steps, and the order with which it falls from the last but "
    "one to the last. Where the order is known, it is a row of its own among the systems, and fails there. Dashed: the "
    "nearest whole order, to guide the eye."
)
HEAD = ("system", "quantity", "over", "meshes", "errors", "order")


@dataclass(frozen=True)
class ErrorSeries:
    """Errors of one quantity over the number of elements or steps."""

    case: str
    name: str
    over: str
    meshes: Sequence[float]
    errors: Sequence[float]
    order: float | None


def series(cases: Sequence[Case]) -> list[ErrorSeries]:
    """Collect the rows with errors on several meshes."""
    found = [(case.case, row) for case in cases for row in case.quantities]
    return [_series(case, row) for case, row in found if _converges(row)]


def _converges(row: QuantityRow) -> bool:
    """Whether a row has errors on meshes."""
    both = _numbers(row.errors), _numbers(row.meshes)
    return all(both) and len(row.errors) == len(row.meshes) > 1


def _numbers(value: Any) -> bool:
    """Whether a value is a list of numbers."""
    return isinstance(value, list) and all(isinstance(item, int | float) for item in value)


def _series(case: str, row: QuantityRow) -> ErrorSeries:
    order = float(row.order) if isinstance(row.order, int | float) else None
    over = "elements" if row.steps is None else "steps"
    return ErrorSeries(case, row.name.removesuffix("_error"), over, row.meshes, row.errors, order)


def section(cases: Sequence[Case], plots: Plots) -> PageSection:
    """Write the section, with one small plot for each quantity."""
    said = "convergence", "Convergence", SAYS
    found = series(cases)
    if not found:
        return PageSection(*said, missing=[absent("reproduce", "Systems with errors on several meshes")])
    groups = [
        (name, [study for study in found if study.case == name])
        for name in dict.fromkeys(study.case for study in found)
    ]
    lines = [
        (
            study.case,
            study.name,
            study.over,
            _listed(study.meshes),
            ", ".join(map(size, study.errors)),
            _order(study),
        )
        for study in found
    ]
    listing = folded("Table of all", table(HEAD, [("", line) for line in lines]), unfolded=not plots.possible)
    drawn = (
        [_group(*group, plots) for group in groups] if plots.possible else [sentence(plots.remedy, "missing")]
    )
    return PageSection(
        *said, f"{len(found)} quantities of {counted(len(groups), 'system')}.", [*drawn, listing]
    )


def _group(case: str, found: Sequence[ErrorSeries], plots: Plots) -> Html:
    """Draw the plots of a system."""
    drawn = tag("div", *(_plot(one, plots) for one in found), class_="plots")
    return folded(f"{case}: {counted(len(found), 'plot')}", drawn, unfolded=True)


def _listed(numbers: Sequence[float]) -> str:
    return ", ".join(f"{n:g}" for n in numbers)


def _order(found: ErrorSeries) -> str:
    return "–" if found.order is None else f"{found.order:.2f}"


def _plot(found: ErrorSeries, plots: Plots) -> Html:
    """Draw the plot of a quantity with its caption."""
    drawn = plots.draw(log_log, found.meshes, found.errors, found.order, found.over)
    caption = (
        tag("b", found.name),
        f" order {_order(found)}; {size(found.errors[-1])} with {found.meshes[-1]:g} {found.over}",
    )
    return tag("figure", drawn, tag("figcaption", *caption))
