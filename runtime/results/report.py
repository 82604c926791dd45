"""Report of the reproduction of a published system: computed numbers beside published ones.

A `Quantity` evaluates its own error (`error`, `ok`); a `Report` collects the quantities and figures of one system
and writes them as a table or as JSON.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

COLUMNS = ("quantity", "published", "computed", "error", "tolerance", "ok", "source")
LISTED = 4  # for arrays with more entries, the table shows only the worst one


@dataclass(frozen=True)
class Quantity:
    """One computed number, list or matrix, beside the published one.

    Parameters
    ----------
    name : str
        Name in the table and in the JSON.
    computed : array_like, real, integer or complex, any shape
        The result of flexel.  Complex numbers must be sorted by real, then imaginary part.
    reference : array_like of the same shape, or None
        The published value, as printed; None when the quantity is only reported.
    tolerance : float
        Largest permitted `error`.
    unit : str
        SI unit of both, "" for a pure number.
    source : str
        Where the reference was published, with table or equation number.
    more : mapping, optional
        Further keys of the JSON row, for instance ``{"elements": 8}``.
    """

    name: str
    computed: ArrayLike
    reference: ArrayLike | None = None
    tolerance: float = 0.0
    unit: str = ""
    source: str = ""
    more: Mapping[str, object] = field(default_factory=dict)

    @property
    def errors(self) -> NDArray[np.float64] | None:
        """Error of each entry, relative to the largest entry of the reference, absolute where that is 0.

        None when there is no reference; infinite where the shapes differ or a number is not finite.
        """
        if self.reference is None:
            return None
        computed, reference = np.asarray(self.computed), np.asarray(self.reference)
        if computed.shape != reference.shape:
            return np.full(computed.shape, np.inf)
        largest = float(np.max(np.abs(reference), initial=0.0))
        with np.errstate(invalid="ignore", over="ignore"):
            errors = np.abs(computed - reference) / (largest or 1.0)
        return np.where(np.isfinite(errors), errors, np.inf)

    @property
    def error(self) -> float | None:
        """Largest of the `errors`, or None when there is no reference."""
        errors = self.errors
        return None if errors is None else float(np.max(errors, initial=0.0))

    @property
    def ok(self) -> bool:
        """Whether the error is within the tolerance; without a reference, whether all is finite."""
        error, finite = self.error, bool(np.all(np.isfinite(np.asarray(self.computed))))
        return finite and (error is None or error <= self.tolerance)

    def to_dict(self) -> dict[str, object]:
        """Return the row of the JSON, in plain lists and numbers."""
        return {
            "name": self.name,
            "computed": plain(self.computed),
            "reference": None if self.reference is None else plain(self.reference),
            "tolerance": self.tolerance,
            "unit": self.unit,
            "source": self.source,
            "ok": self.ok,
            **self.more,
        }


@dataclass(frozen=True)
class Report:
    """Results of the reproduction of one published system.

    Parameters
    ----------
    case : str
        Name of the system, as given to ``flexel reproduce``.
    quantities : sequence of Quantity
    files : sequence of Path, optional
        Figures and animations that were written.
    seconds : float, optional
        How long it took [s]; measured by ``flexel reproduce`` when left at 0.
    """

    case: str
    quantities: Sequence[Quantity]
    files: Sequence[Path] = ()
    seconds: float = 0.0

    @property
    def ok(self) -> bool:
        """Whether every quantity is ok."""
        return all(quantity.ok for quantity in self.quantities)

    def to_dict(self) -> dict[str, object]:
        """Return the JSON object of this case, in plain lists and numbers."""
        return {
            "case": self.case,
            "quantities": [quantity.to_dict() for quantity in self.quantities],
            "files": [str(file) for file in self.files],
            "seconds": self.seconds,
        }

    def table(self) -> str:
        """Return the table: one line per number, longer arrays by their worst entry."""
        rows = [COLUMNS, *(row for quantity in self.quantities for row in _rows(quantity))]
        widths = [max(len(row[column]) for row in rows) for column in range(len(COLUMNS))]
        rows.insert(1, tuple("-" * width for width in widths))
        lines = ["  ".join(map(str.ljust, row, widths)) for row in rows]
        return "\n".join(line.rstrip() for line in lines)


def to_json(reports: Sequence[Report], *, as_list: bool) -> str:
    """Return the JSON text: one object for one case, else a list of them.

    Parameters
    ----------
    reports : sequence of Report
    as_list : bool
        Whether to write a list; must be true unless there is exactly one report.
    """
    rows = [report.to_dict() for report in reports]
    return json.dumps(rows if as_list else rows[0], indent=2, allow_nan=False) + "\n"


def plain(values: ArrayLike) -> object:
    """Return numbers in JSON form: nested lists, complex as [re, im], not finite as None."""
    array = np.asarray(values)
    if array.ndim:
        return [plain(entry) for entry in array]
    number = array.item()
    if isinstance(number, complex):
        return [plain(number.real), plain(number.imag)]
    return number if np.isfinite(number) else None


def _rows(quantity: Quantity) -> Iterable[tuple[str, ...]]:
    """Yield the table's lines for one quantity."""
    computed, errors = np.asarray(quantity.computed), quantity.errors
    reference = None if quantity.reference is None else np.asarray(quantity.reference)
    if reference is not None and reference.shape != computed.shape:
        shapes = f"shape {reference.shape}", f"shape {computed.shape}"
        yield (quantity.name, *shapes, "inf", f"{quantity.tolerance:.0e}", "NO", quantity.source)
        return
    chosen = list(np.ndindex(computed.shape))
    note = ""
    if len(chosen) > LISTED:
        worst = 0 if errors is None else int(np.argmax(errors))
        note, chosen = f" (worst of {len(chosen)})", [chosen[worst]]
    for index in chosen:
        error = None if errors is None else float(errors[index])
        fits = bool(np.isfinite(computed[index])) and (error is None or error <= quantity.tolerance)
        if note:
            fits = quantity.ok
        yield (
            quantity.name + (f"[{','.join(map(str, index))}]" if index else "") + note,
            "-" if reference is None else _number(reference[index]),
            _number(computed[index]) + (f" {quantity.unit}" if quantity.unit else ""),
            "-" if error is None else f"{error:.1e}",
            "-" if error is None else f"{quantity.tolerance:.0e}",
            "yes" if fits else "NO",
            quantity.source,
        )


def _number(value: object) -> str:
    """Write one number with as many digits as published values have."""
    if isinstance(value, complex | np.complexfloating):
        return f"{value.real:.15g}{value.imag:+.15g}i"
    return f"{value:.15g}" if isinstance(value, float | np.floating) else str(value)
