"""Writes the section about systems of the literature: computed values compared with references, by kind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.errors import FlexelError
from flexel.base.shown import counted
from flexel.results.reproduction import Quantity
from report.markup import Html, folded, size, table, tag, time
from report.parts import Case, QuantityRow, command
from report.section import PageSection, absent, without

SAYS = (
    "Each computed number of `flexel reproduce` with its reference and the kind of reference. A failure is "
    "an error above the tolerance, a number that is not finite, or another shape. A row without a reference is only "
    "reported."
)
KINDS = {
    "published": "Published numbers",
    "closed form": "Closed forms",
    "other program": "Results of another program that are not published",
    "own": "Computed independently for this project",
    "none": "Without a reference, only reported",
}
HEAD = ("quantity", "", "error", "tolerance", "flexel", "reference", "unit", "source")
SHOWN = 4  # entries of an array that are shown; for a larger array only the worst one, or the first ones


def section(cases: Sequence[Case], known: Sequence[str]) -> PageSection:
    """Write the section.

    Parameters
    ----------
    cases : sequence of Case
        The results of `flexel reproduce`.
    known : sequence of str
        Names of all systems.
    """
    said = "systems", "Systems", SAYS
    if not cases:
        return PageSection(*said, missing=[absent("reproduce", "The reproduced systems")])
    failures = [
        f"{case.case}: {row.name}: {_wrong(row)}" for case in cases for row in case.quantities if failed(row)
    ]
    failures += [f"{case.case}: no quantity" for case in cases if not case.quantities]
    missing = without([case.case for case in cases], known, "reproduce", "The systems")
    body = [_overview(cases), *map(_case, cases)]
    return PageSection(*said, _sum(cases), body, failures, missing)


def failed(row: QuantityRow) -> bool:
    """Whether a row is not reproduced."""
    return row.ok is False or (row.ok is None and row.reference is not None)


def _sum(cases: Sequence[Case]) -> str:
    """Count the rows of each kind."""
    rows = [row for case in cases for row in case.quantities]
    compared = [row for row in rows if row.reference is not None]
    kinds = ", ".join(
        f"{n} {kind}" for kind in list(KINDS)[:-1] if (n := sum(row.kind == kind for row in compared))
    )
    return (
        f"{counted(len(cases), 'system')}, {len(rows)} quantities, {len(compared)} with a reference: {kinds}."
    )


def _overview(cases: Sequence[Case]) -> Html:
    """Write a line for each system: rows of each kind, the time."""
    rows = []
    for case in cases:
        counts = [sum(row.kind == kind for row in case.quantities) or "–" for kind in KINDS]
        wrong = sum(map(failed, case.quantities)) or int(not case.quantities)
        took = "–" if case.seconds is None else time(case.seconds)
        verdict = f"{wrong} NOT OK" if wrong else "ok"
        rows.append(("bad" * bool(wrong), (case.case, *counts, took, verdict)))
    return table(("system", *list(KINDS)[:-1], "no reference", "time", ""), rows)


def _case(case: Case) -> Html:
    """Write the tables of a system, one for each kind of reference."""
    tables = []
    for kind, title in (
        KINDS | {row.kind: row.kind for row in case.quantities if row.kind not in KINDS}
    ).items():
        rows = [row for row in case.quantities if row.kind == kind]
        if rows:
            tables += [tag("h4", title), table(HEAD, [_line(case.case, row) for row in rows])]
    wrong = any(map(failed, case.quantities))
    return folded(f"{case.case}: {counted(len(case.quantities), 'row')}", *tables, unfolded=wrong)


def _line(case: str, row: QuantityRow) -> tuple[str, Sequence[object]]:
    """Write the line of a quantity."""
    note, ours, reference = _values(case, row)
    verdict = "NOT OK" if failed(row) else "–" if row.reference is None else "ok"
    source = "; ".join(
        part for part in (row.source, f"tolerance: {row.reason}" if row.reason else "") if part
    )
    errors = size(row.error), _tolerance(row)
    cells = row.name + note, verdict, *errors, ours, reference, row.unit, source
    return "bad" if failed(row) else "", cells


def _tolerance(row: QuantityRow) -> str:
    """Write the tolerance and its kind."""
    if row.reference is None:
        return "–"
    return f"{size(row.tolerance)} {row.tolerance_kind}" if row.tolerance else "exact"


def _wrong(row: QuantityRow) -> str:
    """Write the error of a row that failed, with its tolerance."""
    if row.reference is None:
        return "not finite"
    return f"error {size(row.error) if row.error is not None else 'not finite'}, tolerance {_tolerance(row)}"


def _values(case: str, row: QuantityRow) -> tuple[str, str, str]:
    """Return the selection of entries to show, and their computed and reference values."""
    given = _quantity(case, row)
    ours = np.asarray(given.computed)
    reference = None if given.reference is None else np.asarray(given.reference)
    if reference is not None and reference.shape != ours.shape:
        return "", f"shape {ours.shape}", f"shape {reference.shape}"
    if ours.size <= SHOWN:
        return "", _written(ours), "–" if reference is None else _written(reference)
    errors = given.errors
    place = np.unravel_index(0 if errors is None else int(np.argmax(errors)), ours.shape)
    index = ",".join(str(int(number)) for number in place)
    note = f"[{index}], {'first' if errors is None else 'worst'} of {ours.size}"
    return note, _written(ours[place]), "–" if reference is None else _written(reference[place])


def _quantity(case: str, row: QuantityRow) -> Quantity:
    """Return the row as it was before it was written."""
    kinds: Any = {"kind": row.kind, "tolerance_kind": row.tolerance_kind}
    try:
        ours = _array(row.computed, row.complex)
        reference = None if row.reference is None else _array(row.reference, row.complex)
        return Quantity(row.name, ours, reference, row.tolerance, **kinds)
    except (TypeError, ValueError, IndexError) as error:
        raise FlexelError(
            f"reproduced system '{case}': '{row.name}' is damaged ({error}); write the file again: "
            f"{command('reproduce')}"
        ) from error


def _array(value: Any, pairs: bool) -> Any:
    """Convert to numbers, or pairs to complex numbers; null is not a number."""
    found = np.asarray(value, dtype=float)
    return found[..., 0] + 1j * found[..., 1] if pairs else found


def _written(values: Any) -> str:
    """Write numbers: one in 15 digits, as published values have; several in 10 each."""
    found = np.asarray(values)
    digits = 15 if found.size == 1 else 10
    return ", ".join(_digits(entry.item(), digits) for entry in found.reshape(-1))


def _digits(value: Any, digits: int) -> str:
    """Write a real or complex number."""
    if isinstance(value, complex):
        return f"{value.real:.{digits}g}{value.imag:+.{digits}g}i"
    return f"{value:.{digits}g}"
