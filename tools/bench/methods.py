"""The methods of flexel beside others: what an error costs each; `PYTHONPATH=tools python -m bench.methods`.

For each model and method the loosest tolerance whose error is at most that asked for, among four in each decade: steps,
evaluations and milliseconds of thread CPU time.  The error is the largest of any coordinate over the largest range of
one, against a motion with a tight tolerance.  CVODE and SciPy's Radau have the equations of flexel in minimal
coordinates and their analytic Jacobian, IDA those with multipliers.  A dash: not within 10 s.
"""

from __future__ import annotations

import sys
import time
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

import numpy as np

import flexel as fx
from bench import cvode
from bench.ropes import rope
from flexel.base.arrays import Array
from flexel.examples import beams_data, linkages
from flexel.examples.beams_models import spin_up
from flexel.examples.manipulator import END, SECONDS, START, joint_control, manipulator, move, workspace
from flexel.examples.slider_crank import slider_crank
from flexel.examples.slider_crank_data import SPEED
from flexel.examples.vehicle import vehicle
from flexel.examples.vehicle_runs import rounded_ramp, start

ERRORS = 1e-4, 1e-6, 1e-8
OTHERS = {
    "SciPy's Radau": cvode.by_radau,
    "SUNDIALS' IDA": cvode.by_ida,
    "SUNDIALS' CVODE": cvode.by_cvode,
}
METHODS = ("DOP853", "Radau", "generalized-alpha", *OTHERS)
FIRST, LAST = 1, 11  # powers of ten: the loosest and the tightest tolerance
FINE = 4  # tolerances in a decade
LONGEST = 10.0  # CPU time [s] after which a method is not asked for more
SHORT = 0.1  # motions that take less are repeated for this CPU time [s], and the shortest run counts
SAMPLES = 21


@dataclass(frozen=True)
class Case:
    """A motion, and the method and tolerance of its reference."""

    system: fx.System
    seconds: float
    start: fx.State
    reference: str = "DOP853"
    tolerance: float = 1e-11


@dataclass(frozen=True)
class Found:
    """What a motion with some tolerance has cost, and its error."""

    rtol: float
    error: float
    steps: int
    evaluations: int
    seconds: float


def cases() -> Iterator[tuple[str, Case]]:
    """Return the motions, by name."""
    mechanism = linkages.squeezer()
    yield "squeezer", Case(mechanism, linkages.SQUEEZER_SECONDS, mechanism.initial, tolerance=1e-12)
    flyballs = linkages.governor()
    yield "governor", Case(flyballs, linkages.GOVERNOR_SECONDS, flyballs.initial)
    crank = slider_crank(SPEED, 4)
    yield "slider-crank", Case(crank, 0.04, crank.initial)
    beam = spin_up(4, beams_data.SPIN_SIMO)
    yield "spin-up beam", Case(beam, 15.0, beam.initial, "Radau")
    car = vehicle(30.0, rack=rounded_ramp())
    yield "car", Case(car, 2.0, start(car, 30.0))
    shoulder, elbow = (move(a, b, SECONDS) for a, b in zip(START, END, strict=True))
    arm = manipulator(shoulder, elbow, joint_control(workspace()[0]))
    yield "manipulator", Case(arm, 1.0, arm.initial, "Radau")
    cables = rope(56)
    yield "56 cables", Case(cables, 0.02, cables.initial, "DOP853", 1e-10)


def taken(case: Case, method: str, rtol: float) -> tuple[Array, dict[str, int]]:
    """Return coordinates (SAMPLES, n) of a motion, and its counts."""
    if method in OTHERS:
        times = case.start.t + np.linspace(0, case.seconds, SAMPLES)
        return OTHERS[method](case.system, case.start, times, rtol)
    motion = case.system.simulate(
        case.seconds, start=case.start, samples=SAMPLES, method=method, rtol=rtol, progress=False
    )
    return motion.x, motion.statistics


def measured(case: Case, method: str, exact: Array, rtol: float) -> Found:
    """Measure the error and the cost of a motion; both are infinite if there is none."""
    shortest = spent = 0.0
    while spent < SHORT:
        began = time.thread_time()
        try:
            x, counts = taken(case, method, rtol)
        except fx.FlexelError as failure:
            print(f"{method} {rtol:.1e}: {failure}", file=sys.stderr)
            return Found(rtol, np.inf, 0, 0, time.thread_time() - began)
        last = time.thread_time() - began
        spent += last
        shortest = min(shortest or last, last)
    error = float(np.abs(x - exact).max() / np.ptp(exact, axis=0).max())
    return Found(rtol, error, counts["steps"], counts["evaluations"], shortest)


def cheapest(case: Case, method: str, exact: Array) -> Iterator[Found | None]:
    """Find what each error costs, or none if the method does not reach it."""

    @cache
    def at(step: int) -> Found:
        return measured(case, method, exact, 10.0 ** (-step / FINE))

    step, last = FIRST * FINE, LAST * FINE
    for wanted in ERRORS:
        while at(step).error > wanted and step < last and at(step).seconds < LONGEST:
            step += FINE
        if at(step).error > wanted:
            yield None
            continue
        first = max(step - FINE + 1, FIRST * FINE)
        yield next(at(tried) for tried in range(first, step + 1) if at(tried).error <= wanted)


def cell(found: Found | None) -> str:
    """Write steps, evaluations and CPU time [ms], or a dash for an error that is not reached."""
    if found is None:
        return "–"
    time_ms = 1e3 * found.seconds
    return f"{found.steps} / {found.evaluations} / {time_ms:.{0 if time_ms >= 100 else 1}f}"


def main(names: list[str]) -> None:
    """Print the table, of some models or of all."""
    for kind in (fx.StiffWarning, fx.DampingWarning, fx.AuditWarning):
        warnings.simplefilter("ignore", kind)
    heads = ["motion", "method", *(f"{error:.0e}" for error in ERRORS)]
    print("| " + " | ".join(heads) + " |\n" + "|---" * len(heads) + "|")
    for name, case in cases():
        if names and name not in names:
            continue
        exact = taken(case, case.reference, case.tolerance)[0]
        for method in METHODS:
            cells = [cell(found) for found in cheapest(case, method, exact)]
            print("| " + " | ".join([name, method, *cells]) + " |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
