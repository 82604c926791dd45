"""The rows of `flexel bench`: what is measured, the figures to reach and to aim at, and what the accuracy is.

A row of another program beside one of these is the same name with another `prepare`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import partial
from math import isfinite
from typing import Any

from flexel.benchmarks import bicycle, chains, kernels, ropes, slider_crank, start, sweeps, vehicle
from flexel.benchmarks.timing import Timing, Work, measure

UNITS = {"s": 1.0, "ms": 1e-3, "µs": 1e-6, "ns": 1e-9}


@dataclass(frozen=True)
class Row:
    """A figure to measure.

    Attributes
    ----------
    reach, aim : float or None
        Figures [unit] to reach and to aim at.
    prepare : function
        Makes what is timed; its own time is not measured.
    accuracy : str
        What `error` is; empty: there is no reference.
    within : float or None
        Largest error with which the time counts.
    """

    name: str
    unit: str
    reach: float | None
    aim: float | None
    prepare: Callable[[], Work]
    accuracy: str = ""
    within: float | None = None

    def measured(self) -> tuple[Figure, Timing]:
        """The figure, and how it was found."""
        timing = measure(self.prepare())
        error = timing.error if timing.error is not None and isfinite(timing.error) else None
        return self.figure(timing.shortest / UNITS[self.unit], error), timing

    def figure(self, value: float | None = None, error: float | None = None) -> Figure:
        """What is written as JSON; without a value, that of a row that failed."""
        return Figure(self.name, value, self.unit, error, self.reach, self.aim)

    def accurate(self, figure: Figure) -> bool:
        """Whether the result is good enough for its time to count."""
        return self.within is None or (figure.error is not None and figure.error <= self.within)

    def mark(self, figure: Figure) -> str:
        """What is met: "aim", "reach", or "missed"; "" without figures to meet."""
        if not self.accurate(figure):
            return "inaccurate"
        if figure.value is None or self.reach is None or self.aim is None:
            return ""
        return "aim" if figure.value <= self.aim else "reach" if figure.value <= self.reach else "missed"


@dataclass(frozen=True)
class Figure:
    """A measured row; value, reach and aim in `unit`."""

    name: str
    value: float | None
    unit: str
    error: float | None
    reach: float | None
    aim: float | None

    def to_dict(self) -> dict[str, Any]:
        """The entries by name, for JSON."""
        return asdict(self)


STEER = "steer at 5 s minus 0.044960974038 rad of the reference"
MATRICES = "against those of the published matrices, over the largest"
CLOSED_FORM = "accelerations of the planar chain of rods, over the largest"
BALANCE = "error of the energy balance over the energy that went through"
FALL = "fall in 1 s minus that of a converged run, over it"
YAW = "yaw rate at 5 s minus that at rtol 1e-11, over it"
DEFLECTIONS = "deflections minus those with 16 harmonics, over the largest"
DIFFERENCES = "state matrix minus that by differences of `System.rhs`, over the largest entry"
ROWS = {
    row.name: row
    for row in (
        Row("bicycle_rhs", "µs", 6, 3.5, bicycle.right_hand_side, f"accelerations {MATRICES}", 1e-8),
        Row("bicycle_M1", "ms", 7, 3, bicycle.manoeuvre, STEER, 1e-6),
        Row("bicycle_loci", "ms", 30, 5, bicycle.loci, f"eigenvalues {MATRICES}", 1e-10),
        Row("cables_56", "s", 0.12, 0.05, ropes.cables, BALANCE, 1e-4),
        Row("sheave_56x5", "s", 0.2, 0.07, ropes.sheave, FALL, 2e-5),
        Row("hoist", "s", 10, 4, ropes.hoist, BALANCE, 1e-4),
        Row("vehicle_ramp", "s", 0.2, 0.05, vehicle.ramp, YAW, 1e-5),
        Row("slider_crank_200", "s", 0.13, 0.04, slider_crank.sweep, DEFLECTIONS, 1e-4),
        Row("chain_40", "µs", 60, 35, partial(chains.right_hand_side, 40), CLOSED_FORM, 1e-6),
        Row("chain_100", "µs", 150, 90, partial(chains.right_hand_side, 100), CLOSED_FORM, 1e-6),
        Row("chain_40_closed", "µs", 60, 35, partial(chains.right_hand_side, 40, True), CLOSED_FORM, 1e-6),
        Row("chain_100_closed", "µs", 150, 90, partial(chains.right_hand_side, 100, True), CLOSED_FORM, 1e-6),
        Row("linearize_vehicle", "ms", 1, 0.3, vehicle.linearization, DIFFERENCES, 1e-8),
        Row("build_bicycle", "ms", 15, 5, bicycle.build),
        Row("build_vehicle", "ms", 250, 50, vehicle.build),
        Row("kernels_beam", "ns", 22, 18, kernels.beam),
        Row("sweep_overhead", "ms", 1, 0.2, sweeps.overhead, "results minus those of one process", 1e-14),
        Row("import_flexel", "ms", None, None, start.importing),
    )
}  # fmt: skip
