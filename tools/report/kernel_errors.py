"""Writes the section about the compiled kernels: the worst errors of each element."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from report.markup import Html, folded, size, table, time
from report.parts import KernelOutput, Kernels
from report.section import PageSection, absent, without

SAYS = (
    "Every output of every compiled kernel (`flexel verify`), at random configurations, against differences of the "
    "kernel one order below it and against the definition in 60 digits. A failure is a relative error above the "
    "tolerance, or a result that depends on its place in a batch."
)
HEAD = (
    "element or law",
    "outputs",
    "worst against differences",
    "worst against the definition",
    "batches",
    "",
)
EACH = ("kernel", "output", "against differences", "against the definition", "batches", "")


def section(found: Kernels | None, known: Sequence[str]) -> PageSection:
    """Write the section.

    Parameters
    ----------
    found : Kernels or None
        The results of `flexel verify`.
    known : sequence of str
        Names of all elements and laws.
    """
    said = "kernels", "Kernels", SAYS
    if found is None:
        return PageSection(*said, missing=[absent("verify", "The errors of the kernels")])
    elements = {
        row.element: [other for other in found.rows if other.element == row.element] for row in found.rows
    }
    failures = [
        f"{row.element}.{row.kernel}.{row.output}: {_errors(row)}" for row in found.rows if not row.ok
    ] or ["nothing was verified, or the file says that something is wrong"] * (not found.ok)
    shown = [_line(name, rows) for name, rows in elements.items()]
    details = [folded(name, table(EACH, map(_output, rows)), unfolded=not all(row.ok for row in rows))
               for name, rows in elements.items()]  # fmt: skip
    missing = without(list(elements), known, "verify", "The kernels of")
    body: list[Html] = [table(HEAD, shown), folded("Every output", *details)]
    return PageSection(*said, _sum(found), body, failures, missing)


def _sum(found: Kernels) -> str:
    """Write the worst errors of all, with the tolerances."""
    limits = found.tolerances
    differences = size(_worst([row.differences for row in found.rows]))
    reference = size(_worst([row.reference for row in found.rows]))
    return (
        f"{len(found.rows)} outputs; worst {differences} against differences "
        f"(tolerance {size(limits.get('differences'))}), {reference} against the "
        f"definition (tolerance {size(limits.get('reference'))}); {time(found.seconds)}."
    )


def _line(name: str, rows: Sequence[KernelOutput]) -> tuple[str, Sequence[object]]:
    """Write the line of an element."""
    failed = sum(not row.ok for row in rows)
    worst = size(_worst([row.differences for row in rows])), size(_worst([row.reference for row in rows]))
    batches = "same" if all(row.lanes for row in rows) else "differ"
    return "bad" * bool(failed), (name, len(rows), *worst, batches, f"{failed} NOT OK" if failed else "ok")


def _output(row: KernelOutput) -> tuple[str, Sequence[object]]:
    """Write the line of an output."""
    verdict = "ok" if row.ok else f"NOT OK {row.note}".rstrip()
    batch = "same" if row.lanes else "differ"
    cells = row.kernel, row.output, size(row.differences), size(row.reference), batch, verdict
    return "" if row.ok else "bad", cells


def _errors(row: KernelOutput) -> str:
    """Describe the defect of an output."""
    said = f"{size(row.differences)} against differences, {size(row.reference)} against the definition"
    return said + ("" if row.lanes else ", batches differ") + (f", {row.note}" if row.note else "")


def _worst(errors: Sequence[float | None]) -> float | None:
    """Return the largest of the known errors."""
    return max(
        (error for error in errors if error is not None),
        default=None,
        key=lambda error: inf if error != error else error,
    )
