"""Reports the reproduction of a system: computed numbers with references, each of a named kind.

A `Quantity` evaluates its error (`error`, `ok`); a `Report` collects the quantities and figures of one system
and writes them as a table or as JSON.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Kind = Literal["published", "closed form", "other program", "own", "none"]
ToleranceKind = Literal["absolute", "relative"]
COLUMNS = ("quantity", "reference", "kind", "computed", "error", "tolerance", "ok", "source")
MAX_ENTRIES_LISTED = 4  # for arrays with more entries, the table shows only the worst one


@dataclass(frozen=True)
class Quantity:
    """One computed number, list or matrix, with a reference if there is one.

    Parameters
    ----------
    name : str
        Name in the table and in the JSON.
    computed : array_like, real, integer or complex, any shape
        The result of flexel.  Complex numbers must be sorted by real, then imaginary part.
    reference : array_like of the same shape, or None
        The value to compare with; None if the quantity is only reported.
    tolerance : float
        Largest permitted `error`: at most three times the error found or 1e-12 of the reference, unless there
        is a `reason`.
    unit : str
        SI unit of both, "" for a pure number.
    source : str
        Origin of the reference, with table or equation number.
    more : mapping, optional
        Further keys of the JSON row, for instance ``{"elements": 8}``.
    kind : str
        Of the reference: ``published``; ``closed form``; ``other program``, whose results are not published; ``own``,
        computed independently for this project; ``none``, if and only if there is no reference.
    tolerance_kind : str, optional
        ``relative`` to each entry of the reference, the default, or ``absolute``, the default for a reference
        of zeros.  A reference with some zeros requires it.
    reason : str, optional
        Why the tolerance is larger than three times the error found.
    """

    name: str
    computed: ArrayLike
    reference: ArrayLike | None = None
    tolerance: float = 0.0
    unit: str = ""
    source: str = ""
    more: Mapping[str, object] = field(default_factory=dict)
    kind: Kind = "none"
    tolerance_kind: ToleranceKind | None = None
    reason: str = ""

    def __post_init__(self) -> None:
        if (self.reference is None) != (self.kind == "none"):
            raise ValueError(
                f"quantity {self.name!r}: kind 'none' is for quantities without a reference, and only for these"
            )
        zeros = np.asarray(0.0 if self.reference is None else self.reference) == 0
        if self.tolerance_kind is None:
            if np.any(zeros) and not np.all(zeros):
                raise ValueError(
                    f"quantity {self.name!r}: its reference has zeros; give tolerance_kind='absolute'"
                )
            object.__setattr__(self, "tolerance_kind", "absolute" if np.any(zeros) else "relative")

    @property
    def errors(self) -> NDArray[np.float64] | None:
        """Error of each entry, absolute or relative to that entry of the reference, according to `tolerance_kind`.

        None if there is no reference; infinite if the shapes differ or a number is not finite.
        """
        if self.reference is None:
            return None
        computed, reference = np.asarray(self.computed), np.asarray(self.reference)
        if computed.shape != reference.shape:
            return np.full(computed.shape, np.inf)
        with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
            errors = np.abs(computed - reference)
            if self.tolerance_kind == "relative":
                errors = np.where(errors == 0, 0.0, errors / np.abs(reference))
        return np.where(np.isfinite(errors), errors, np.inf)

    @property
    def error(self) -> float | None:
        """Largest of the `errors`, or None if there is no reference."""
        errors = self.errors
        return None if errors is None else float(np.max(errors, initial=0.0))

    @property
    def ok(self) -> bool:
        """Whether the error is within the tolerance; without a reference, whether all is finite."""
        error, finite = self.error, bool(np.all(np.isfinite(np.asarray(self.computed))))
        return finite and (error is None or error <= self.tolerance)

    @property
    def verdict(self) -> bool | None:
        """`ok`, but None if there is no reference and nothing has failed."""
        return None if self.ok and self.reference is None else self.ok

    def to_dict(self) -> dict[str, object]:
        """Return the row of the JSON, in plain lists and numbers; "complex" marks pairs that are complex numbers."""
        return {
            "name": self.name,
            "computed": plain(self.computed),
            "reference": None if self.reference is None else plain(self.reference),
            "kind": self.kind,
            "error": None if self.error is None else plain(self.error),
            "tolerance": self.tolerance,
            "tolerance_kind": self.tolerance_kind,
            "reason": self.reason,
            "unit": self.unit,
            "source": self.source,
            "ok": self.verdict,
            **({"complex": True} if np.iscomplexobj(np.asarray(self.computed)) else {}),
            **self.more,
        }


@dataclass(frozen=True)
class Report:
    """Results of the reproduction of one system.

    Parameters
    ----------
    case : str
        Name of the system, as given to ``flexel reproduce``.
    quantities : sequence of Quantity
    files : sequence of Path, optional
        Figures and animations that were written.
    seconds : float, optional
        Run time [s]; measured by ``flexel reproduce`` when left at 0.
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
        shapes = f"shape {reference.shape}", quantity.kind, f"shape {computed.shape}"
        yield (quantity.name, *shapes, "inf", _tolerance(quantity), "NO", _source(quantity))
        return
    chosen = list(np.ndindex(computed.shape))
    note = ""
    if len(chosen) > MAX_ENTRIES_LISTED:
        worst = 0 if errors is None else int(np.argmax(errors))
        note, chosen = f" ({'first' if errors is None else 'worst'} of {len(chosen)})", [chosen[worst]]
    for index in chosen:
        fits = bool(np.isfinite(computed[index])) and (errors is None or errors[index] <= quantity.tolerance)
        if note:
            fits = quantity.ok
        yield (
            quantity.name + (f"[{','.join(map(str, index))}]" if index else "") + note,
            "-" if reference is None else _number(reference[index]),
            quantity.kind,
            _number(computed[index]) + (f" {quantity.unit}" if quantity.unit else ""),
            "-" if errors is None else f"{errors[index]:.1e}",
            _tolerance(quantity),
            ("yes" if reference is not None else "-") if fits else "NO",
            _source(quantity),
        )


def _tolerance(quantity: Quantity) -> str:
    """Write the tolerance with its digits and its kind; a dash if nothing is compared."""
    if quantity.reference is None:
        return "-"
    return f"{quantity.tolerance:.3g} {quantity.tolerance_kind}" if quantity.tolerance else "exact"


def _source(quantity: Quantity) -> str:
    """Return the source, and the reason of the tolerance."""
    reason = f"tolerance: {quantity.reason}" if quantity.reason else ""
    return "; ".join(part for part in (quantity.source, reason) if part)


def _number(value: object) -> str:
    """Write one number with as many digits as published values have."""
    if isinstance(value, complex | np.complexfloating):
        return f"{value.real:.15g}{value.imag:+.15g}i"
    return f"{value:.15g}" if isinstance(value, float | np.floating) else str(value)
