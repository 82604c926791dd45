"""The section about the compiled kernels: the worst errors of each element."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from flexel.report.markup import Html, folded, size, table, time
from flexel.report.parts import Kernels, Output
from flexel.report.section import Section, absent, without

SAYS = (
    "Every output of every compiled kernel (`flexel verify`), at random configurations, beside differences of the "
    "kernel one order below it and beside the definition in 60 digits. A failure is a relative error above the "
    "tolerance, or a result that depends on its place in a batch."
)
HEAD = ("element or law", "outputs", "worst beside differences", "worst beside the definition", "batches", "")
EACH = ("kernel", "output", "beside differences", "beside the definition", "batches", "")


def section(found: Kernels | None, known: Sequence[str]) -> Section:
    """The section.

    Parameters
    ----------
    found : Kernels or None
        What `flexel verify` wrote.
    known : sequence of str
        Names of all elements and laws.
    """
    said = "kernels", "Kernels", SAYS
    if found is None:
        return Section(*said, missing=[absent("verify", "The errors of the kernels")])
    elements = {row.element: [z for z in found.rows if z.element == row.element] for row in found.rows}
    failures = [f"{z.element}.{z.kernel}.{z.output}: {_errors(z)}" for z in found.rows if not z.ok] or [
        "nothing was verified, or the file says that something is wrong"
    ] * (not found.ok)
    shown = [_line(name, rows) for name, rows in elements.items()]
    details = [folded(name, table(EACH, map(_output, rows)), unfolded=not all(z.ok for z in rows))
               for name, rows in elements.items()]  # fmt: skip
    missing = without(list(elements), known, "verify", "The kernels of")
    body: list[Html] = [table(HEAD, shown), folded("Every output", *details)]
    return Section(*said, _sum(found), body, failures, missing)


def _sum(found: Kernels) -> str:
    """The worst of all, beside the tolerances."""
    limits = found.tolerances
    return (
        f"{len(found.rows)} outputs; worst {size(_worst([z.differences for z in found.rows]))} beside differences "
        f"(tolerance {size(limits.get('differences'))}), {size(_worst([z.reference for z in found.rows]))} beside the "
        f"definition (tolerance {size(limits.get('reference'))}); {time(found.seconds)}."
    )


def _line(name: str, rows: Sequence[Output]) -> tuple[str, Sequence[object]]:
    """The line of an element."""
    failed = sum(not z.ok for z in rows)
    worst = size(_worst([z.differences for z in rows])), size(_worst([z.reference for z in rows]))
    batches = "same" if all(z.lanes for z in rows) else "differ"
    return "bad" * bool(failed), (name, len(rows), *worst, batches, f"{failed} NOT OK" if failed else "ok")


def _output(row: Output) -> tuple[str, Sequence[object]]:
    """The line of an output."""
    verdict = "ok" if row.ok else f"NOT OK {row.note}".rstrip()
    batch = "same" if row.lanes else "differ"
    cells = row.kernel, row.output, size(row.differences), size(row.reference), batch, verdict
    return "" if row.ok else "bad", cells


def _errors(row: Output) -> str:
    """What is wrong with an output."""
    said = f"{size(row.differences)} beside differences, {size(row.reference)} beside the definition"
    return said + ("" if row.lanes else ", batches differ") + (f", {row.note}" if row.note else "")


def _worst(errors: Sequence[float | None]) -> float | None:
    """The largest of the errors that there are."""
    return max((z for z in errors if z is not None), default=None, key=lambda z: inf if z != z else z)
