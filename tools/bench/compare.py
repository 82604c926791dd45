"""Measures a row with its peers: all installed programs, in turn, in one process."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import isfinite
from typing import Any

import numpy as np

from bench import timing
from bench.peers import beside
from bench.table import UNITS, Prepare, Row
from bench.timing import Series, Timing, measure

OWN = "flexel"
Failed = Callable[[str, Exception], None]


@dataclass
class Figure:
    """The times of one program for a row.

    Attributes
    ----------
    unit : str
        Of the times.
    sizes : tuple of int
        Of a row that scales.
    timings : list of Timing or None
        One for each size, or a single one; None: the program failed, or cannot run that size.
    """

    unit: str
    sizes: tuple[int, ...] = ()
    timings: list[Timing | None] = field(default_factory=list)

    @property
    def last(self) -> Timing | None:
        """Of the largest size."""
        return self.timings[-1] if self.timings else None

    @property
    def measured(self) -> bool:
        """Whether it has a time for any size."""
        return any(timing is not None for timing in self.timings)

    @property
    def value(self) -> float | None:
        """Shortest time of the largest size [unit]."""
        return self._shortest(self.last)

    @property
    def error(self) -> float | None:
        """Accuracy, for a row with sizes the worst of all; None without a reference, or if it is not a number."""
        found = [timing.error for timing in self.timings if timing is not None]
        numbers = [error for error in found if error is not None and isfinite(error)]
        return max(numbers) if numbers and len(numbers) == len(found) else None

    @property
    def values(self) -> list[float | None]:
        """Shortest time for each size [unit]."""
        return [self._shortest(timing) for timing in self.timings]

    @property
    def exponent(self) -> float | None:
        """Power of the size with which the time grows: least squares on logarithms; None for fewer than two times."""
        known = [(n, value) for n, value in zip(self.sizes, self.values, strict=False) if value is not None]
        if len(known) < 2:
            return None
        n, times = np.log(np.array(known)).T
        return float(np.polyfit(n, times, 1)[0])

    def to_dict(self) -> dict[str, Any]:
        """Return value and error, for JSON; for a row with sizes also the values and the exponent."""
        found: dict[str, Any] = {"value": self.value, "error": self.error}
        return found | {"values": self.values, "exponent": self.exponent} if self.sizes else found

    def _shortest(self, timing: Timing | None) -> float | None:
        return None if timing is None else timing.shortest / UNITS[self.unit]


@dataclass
class Comparison:
    """A row: flexel's figure, and those of its peers (None: not installed)."""

    row: Row
    own: Figure
    peers: dict[str, Figure | None]

    @property
    def installed(self) -> dict[str, Figure]:
        """The installed peers."""
        return {name: figure for name, figure in self.peers.items() if figure is not None}

    def by_row_and_name(self) -> dict[str, Figure]:
        """Return these by names that include the row."""
        return {f"{self.row.name} with {name}": figure for name, figure in self.installed.items()}

    def to_dict(self) -> dict[str, Any]:
        """Return the JSON form: value, target and goal in `unit`."""
        row = self.row
        own = self.own.to_dict()
        found = {
            "name": row.name,
            "value": own.pop("value"),
            "unit": row.unit,
            "error": own.pop("error"),
            "target": row.target,
            "goal": row.goal,
            "accuracy": row.accuracy,
            "within": row.within,
            "peers": {
                name: None if figure is None else figure.to_dict() for name, figure in self.peers.items()
            },
        }
        return found | {"sizes": list(row.sizes)} | own if row.sizes else found


def compare(row: Row, failed: Failed) -> Comparison:
    """Measure a row and its peers.

    Parameters
    ----------
    failed : function
        Called with the name of a peer and its error; the row is measured without this peer. flexel's errors are raised.
    """
    programs = beside(row.name)
    installed = [peer for peer in programs if peer.installed]
    figures = {name: Figure(row.unit, row.sizes) for name in (OWN, *(peer.name for peer in installed))}
    broken: set[str] = set()

    def fails(name: str, error: Exception) -> None:
        broken.add(name)  # and would fail again with the next size
        failed(name, error)

    for size in row.sizes or (None,):
        able = {
            program.name: program.rows[row.name]
            for program in installed
            if program.can(row.name, size) and program.name not in broken
        }
        arguments = () if size is None else (size,)
        found = _in_turn({OWN: row.prepare, **able}, arguments, timing.BUDGET / max(len(row.sizes), 1), fails)
        for name, figure in figures.items():
            figure.timings.append(found.get(name))
    return Comparison(row, figures[OWN], {program.name: figures.get(program.name) for program in programs})


def nothing(row: Row) -> Comparison:
    """Return a row that failed: no figures."""
    empty = {
        program.name: Figure(row.unit, row.sizes) if program.installed else None
        for program in beside(row.name)
    }
    return Comparison(row, Figure(row.unit, row.sizes), empty)


def _in_turn(
    works: Mapping[str, Prepare], arguments: Sequence[int], budget: float, failed: Failed
) -> dict[str, Timing]:
    """Return the timings of the works that do not fail."""
    series: dict[str, Series] = {}
    for name, prepare in works.items():
        try:
            series[name] = Series(prepare(*arguments), budget)
        except Exception as error:  # any error of another program is reported, and the row continues
            if name == OWN:
                raise
            failed(name, error)
    return dict(zip(series, measure(list(series.values())), strict=True))
