"""The results: rows of a table, as data, as text and as JSON."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass

DIFFERENCES_TOLERANCE = 1e-7
REFERENCE_TOLERANCE = 1e-12


@dataclass(frozen=True)
class KernelRow:
    """One output of one kernel, with its worst relative errors.

    Parameters
    ----------
    element, kernel, output : str
    differences : float
        Against differences of the compiled kernel below (nan if there is none below).
    reference : float
        Against the definition in many digits.
    lanes : bool
        Whether every place in a batch of any size gives the same bits.
    note : str
        What is wrong with the kernel as a whole, if anything.
    """

    element: str
    kernel: str
    output: str
    differences: float
    reference: float
    lanes: bool
    note: str = ""

    @property
    def ok(self) -> bool:
        """Both errors are within their tolerances (a nan in `differences` means not applicable)."""
        return self.by_definition and not self.differences > DIFFERENCES_TOLERANCE

    @property
    def by_definition(self) -> bool:
        """Whether it agrees with the definition, in every lane of a batch; regardless of differences."""
        return self.reference <= REFERENCE_TOLERANCE and self.lanes and not self.note


@dataclass(frozen=True)
class Verification:
    """All rows of a run, and the time it took [s]."""

    rows: tuple[KernelRow, ...]
    seconds: float

    @property
    def ok(self) -> bool:
        """Every row is, and there is one."""
        return bool(self.rows) and all(row.ok for row in self.rows)

    def as_json(self) -> dict[str, object]:
        """Return plain data; a number that is not finite becomes null."""

        def number(value: float) -> float | None:
            return value if abs(value) < float("inf") else None

        rows = [
            asdict(r) | {"differences": number(r.differences), "reference": number(r.reference), "ok": r.ok}
            for r in self.rows
        ]
        tolerances = {"differences": DIFFERENCES_TOLERANCE, "reference": REFERENCE_TOLERANCE}
        return {"ok": self.ok, "tolerances": tolerances, "seconds": self.seconds, "rows": rows}

    def table(self) -> str:
        """Return the rows as text, one line each, and a line that sums up."""
        head = ("element", "kernel", "output", "differences", "definition", "batch", "")
        lines = [head, *(_cells(row) for row in self.rows)]
        widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
        text = ["  ".join(c.ljust(w) for c, w in zip(line, widths, strict=True)).rstrip() for line in lines]
        return "\n".join([*text, self._summary()])

    def _summary(self) -> str:
        failed = sum(not row.ok for row in self.rows)
        verdict = "all within tolerance" if self.ok else f"{failed} NOT OK"
        by_differences = _worst([row.differences for row in self.rows])
        by_definition = _worst([row.reference for row in self.rows])
        return (
            f"{len(self.rows)} outputs, {verdict}; worst {by_differences:.1e} (differences, tolerance "
            f"{DIFFERENCES_TOLERANCE:.0e}), {by_definition:.1e} (definition, tolerance "
            f"{REFERENCE_TOLERANCE:.0e}); {self.seconds:.1f} s"
        )


def _cells(row: KernelRow) -> tuple[str, ...]:
    # a nan is "not applicable" in the one column, a failure in the other
    differences = "-" if row.differences != row.differences else f"{row.differences:.1e}"
    verdict = "ok" if row.ok else f"NOT OK {row.note}".rstrip()
    batch = "same" if row.lanes else "differs"
    return row.element, row.kernel, row.output, differences, f"{row.reference:.1e}", batch, verdict


def _worst(errors: Sequence[float]) -> float:
    return max((error for error in errors if error == error), default=0.0)
