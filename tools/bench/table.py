"""The rows of `flexel bench`: the work, the targets and goals, and the accuracy.

The peers of a row are in `bench.peers`, by the name of the row.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from bench import (
    beams,
    bicycle,
    chains,
    kernels,
    many,
    ropes,
    slider_crank,
    start,
    sweeps,
    vehicle,
)
from bench.timing import Work

UNITS = {"s": 1.0, "ms": 1e-3, "µs": 1e-6, "ns": 1e-9}
Prepare = Callable[..., Work]


@dataclass(frozen=True)
class Row:
    """A figure to measure.

    Attributes
    ----------
    target, goal : float or None
        Figures [unit]: what must be met, and what is hoped for.
    prepare : function
        Makes the timed work, of a size if the row has sizes; the time to make it is not measured.
    accuracy : str
        Meaning of `error`; empty: there is no reference.
    within : float or None
        Largest error with which the time counts.
    sizes : tuple of int
        Of a row with sizes, the smallest first; its figure is that of the largest.
    """

    name: str
    unit: str
    target: float | None
    goal: float | None
    prepare: Prepare
    accuracy: str = ""
    within: float | None = None
    sizes: tuple[int, ...] = ()

    def accurate(self, error: float | None) -> bool:
        """Whether the result is accurate enough for its time to count."""
        return self.within is None or (error is not None and error <= self.within)

    def mark(self, value: float | None, error: float | None) -> str:
        """Return the figure that is met: "goal", "target", or "missed"; "" without figures to meet."""
        if not self.accurate(error):
            return "inaccurate"
        if value is None or self.target is None or self.goal is None:
            return ""
        return "goal" if value <= self.goal else "target" if value <= self.target else "missed"


STEER = "steer at 5 s minus 0.044960974038 rad of the reference"
MATRICES = "against those of the published matrices, over the largest"
CLOSED_FORM = "accelerations of the planar chain of rods, over the largest"
BALANCE = "error of the energy balance over the energy that went through"
PLACE = "place of the free end after 1 s minus that by steps of 50 µs, over the length"
FALL = "fall in 1 s minus that of a converged run, over it"
ELASTICA = "place of the end minus that of the elastica, over the length"
YAW = "yaw rate at 5 s minus that at rtol 1e-11, over it"
DEFLECTIONS = "deflections minus those with 16 harmonics, over the largest"
DIFFERENCES = "state matrix minus that by differences of `System.rhs`, over the largest entry"
RELEASED = "fall of the free end in 0.05 s minus that without a rope, over it"
LADDER = "acceleration of the cranks minus that of the closed form, over it"
SIZES = (60, 125, 250, 500, 1000, 2000)
ROWS = {
    row.name: row
    for row in (
        Row("bicycle_rhs", "µs", 6, 3.5, bicycle.right_hand_side, f"accelerations {MATRICES}", 1e-8),
        Row("bicycle_M1", "ms", 7, 3, bicycle.manoeuvre, STEER, 1e-6),
        Row("bicycle_loci", "ms", 30, 5, bicycle.loci, f"eigenvalues {MATRICES}", 1e-10),
        Row("cables_56", "s", 0.12, 0.05, ropes.cables, PLACE, 2e-5),
        Row("sheave_56x5", "s", 0.2, 0.07, ropes.sheave, FALL, 2e-5),
        Row("cantilever_16", "ms", None, None, beams.equilibrium, ELASTICA, 2e-5),
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
        Row("scaling_chain", "ms", None, None, chains.right_hand_side, CLOSED_FORM, 1e-6, SIZES),
        Row("scaling_rope", "s", None, None, ropes.release, RELEASED, 1e-6, SIZES[1:]),
        Row("scaling_ladder", "ms", None, None, chains.ladder, LADDER, 1e-6, SIZES),
        Row("kernels_beam", "ns", 22, 18, kernels.beam),
        Row("bicycle_1000", "s", 2, 0.6, many.manoeuvres, STEER, 1e-6),
        Row("bicycle_loci_many", "ms", 15, 2, many.loci, f"eigenvalues {MATRICES}", 1e-10),
        Row("loci_many", "s", 0.6, 0.2, many.loci_of_many, f"eigenvalues {MATRICES}", 1e-10),
        Row("sweep_overhead", "ms", 1, 0.2, sweeps.overhead, "results minus those of one process", 1e-14),
        Row("import_flexel", "ms", None, None, start.importing),
    )
}  # fmt: skip
