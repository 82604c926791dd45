"""The section about the property campaign: random models, and what must hold for each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flexel.base.shown import counted
from flexel.report.markup import Html, folded, size, table, tag, time
from flexel.report.parts import Campaign, Counterexample, Property
from flexel.report.section import Section, absent

SAYS = (
    "Random models of many families, and properties that each must have: the largest error of all models beside its "
    "tolerance. A failure is an error above the tolerance; the program that builds the model is printed."
)
HEAD = ("property", "models", "largest error", "median", "tolerance", "")


def section(found: Campaign | None) -> Section:
    """The section about what ``python -m campaign`` wrote, or that there is nothing."""
    said = "campaign", "Property campaign", SAYS
    if found is None:
        return Section(*said, missing=[absent("campaign", "The property campaign")])
    failures = [_said(z) for z in found.failures]
    shown = {z.property for z in found.failures}
    failures += [f"{z.name}: largest error {size(z.largest)}, tolerance {size(z.tolerance)}"
                 for z in found.properties if _failed(z) and z.name not in shown]  # fmt: skip
    if not found.models or not found.properties:
        failures.append("no model, or no property, was tried")
    summary = (
        f"{counted(found.models, 'model')} of {len(found.families)} families, {len(found.properties)} properties; "
        f"seed {found.seed}; {time(found.seconds)}."
    )
    body: list[Html] = [
        *map(_program, found.failures),
        table(HEAD, [_line(z, z.name in shown) for z in found.properties]),
        folded("Models of each family", _counts("family", found.families)),
    ]
    if found.skipped:
        skipped = {z.reason: z.models for z in found.skipped}
        body.append(folded("Models without a comparison, and why", _counts("reason", skipped)))
    return Section(*said, summary, body, failures)


def _failed(row: Property) -> bool:
    """Whether the largest error of a property is above its tolerance, or no number."""
    return row.models > 0 and not (row.largest is not None and row.largest <= row.tolerance)


def _line(row: Property, lacking: bool) -> tuple[str, Sequence[object]]:
    """The line of a property; a model can violate it without an error to compare."""
    wrong = lacking or _failed(row)
    kind, verdict = ("bad", "NOT OK") if wrong else ("", "ok") if row.models else ("missing", "no model")
    return kind, (row.name, row.models, size(row.largest), size(row.median), size(row.tolerance), verdict)


def _counts(title: str, counts: Mapping[str, int]) -> Html:
    """A table of numbers of models."""
    return table((title, "models"), [("", pair) for pair in counts.items()])


def _said(found: Counterexample) -> str:
    """The property that a model violates, and the error."""
    return f"{found.property}: {found.message or f'error {size(found.error)}'}"


def _program(found: Counterexample) -> Html:
    """A program that shows a failure."""
    return folded(_said(found), tag("pre", found.program), unfolded=True)
