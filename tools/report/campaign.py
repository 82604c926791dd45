"""Writes the section about the property campaign: random models, and the properties that each must have."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flexel.base.shown import counted
from report.markup import Html, folded, size, table, tag, time
from report.parts import Campaign, Counterexample, Property
from report.section import PageSection, absent

SAYS = (
    "Random models of many families, and properties that each must have: the largest error of all models and its "
    "tolerance. A failure is an error above the tolerance; the program that builds the model is printed."
)
HEAD = ("property", "models", "largest error", "median", "tolerance", "")


def section(found: Campaign | None) -> PageSection:
    """Write the section about the results of ``python -m campaign``, or state that there are none."""
    said = "campaign", "Property campaign", SAYS
    if found is None:
        return PageSection(*said, missing=[absent("campaign", "The property campaign")])
    failures = [_said(failure) for failure in found.failures]
    shown = {failure.property for failure in found.failures}
    failures += [f"{row.name}: largest error {size(row.largest)}, tolerance {size(row.tolerance)}"
                 for row in found.properties if _failed(row) and row.name not in shown]  # fmt: skip
    if not found.models or not found.properties:
        failures.append("no model, or no property, was tried")
    summary = (
        f"{counted(found.models, 'model')} of {len(found.families)} families, {len(found.properties)} properties; "
        f"seed {found.seed}; {time(found.seconds)}."
    )
    body: list[Html] = [
        *map(_program, found.failures),
        table(HEAD, [_line(row, row.name in shown) for row in found.properties]),
        folded("Models of each family", _counts("family", found.families)),
    ]
    if found.skipped:
        skipped = {row.reason: row.models for row in found.skipped}
        body.append(folded("Models without a comparison, and why", _counts("reason", skipped)))
    return PageSection(*said, summary, body, failures)


def _failed(row: Property) -> bool:
    """Whether the largest error of a property is above its tolerance, or not a number."""
    return row.models > 0 and not (row.largest is not None and row.largest <= row.tolerance)


def _line(row: Property, lacking: bool) -> tuple[str, Sequence[object]]:
    """Write the line of a property; a model can violate it without an error to compare."""
    wrong = lacking or _failed(row)
    kind, verdict = ("bad", "NOT OK") if wrong else ("", "ok") if row.models else ("missing", "no model")
    return kind, (row.name, row.models, size(row.largest), size(row.median), size(row.tolerance), verdict)


def _counts(title: str, counts: Mapping[str, int]) -> Html:
    """Write a table of numbers of models."""
    return table((title, "models"), [("", pair) for pair in counts.items()])


def _said(found: Counterexample) -> str:
    """Write the property that a model violates, and the error."""
    return f"{found.property}: {found.message or f'error {size(found.error)}'}"


def _program(found: Counterexample) -> Html:
    """Write the program that shows a failure."""
    return folded(_said(found), tag("pre", found.program), unfolded=True)
