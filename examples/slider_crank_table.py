"""The table of the slider-crank: every quantity with its reference, and the reason for their difference."""

from __future__ import annotations

import numpy as np

from flexel.examples import slider_crank_data as data
from flexel.examples.reasons import ITERATION, STEPS
from flexel.examples.slider_crank import (
    CONVERGED,
    SliderCrankResults,
    amplitudes,
    deflection,
    largest,
    omega0,
)
from flexel.examples.slider_crank_branch import SweptBranches, peaks
from flexel.examples.slider_crank_talk import ELEMENTS, TalkResults, simulated
from flexel.linear import periodic
from flexel.results.reproduction import Quantity


def single(results: SliderCrankResults) -> list[Quantity]:
    """Compare frequencies of the rod, transients and periodic motions at 150 rad/s."""
    steady = data.SWEEP[[row[0] for row in data.SWEEP].index(data.SPEED)]
    series = results.converged[0.02]
    two, converged = {"elements": 2}, {"elements": CONVERGED}
    gap = float(np.abs(results.spatial - results.second_order).max())
    return [
        Quantity("omega0_two_elements", omega0(2), data.OMEGA0_TWO_ELEMENTS, 8e-9, "rad/s", data.TWO, two,
                 kind="own"),
        Quantity("omega0_exact", omega0(32), data.OMEGA0_EXACT, 1.5e-7, "rad/s", data.EXACT, {"elements": 32},
                 kind="closed form"),
        *(
            Quantity(f"transient_max_{round(100 * ratio)}pct", float(np.abs(deflection(m, CONVERGED)).max()),
                     data.TRANSIENT_MAX[ratio], 1.5e-4 if ratio == 0.01 else 5e-5, "", data.TRANSIENT, converged,
                     kind="own", reason=STEPS)
            for ratio, m in results.transients.items()
        ),
        Quantity("periodic_2pct_converged", largest(series), steady[2], 0.002, "", data.MODES, converged,
                 kind="own"),
        Quantity("periodic_1pct_converged", largest(results.converged[0.01]), steady[1],
                 0.002, "", data.MODES, converged, kind="own"),
        Quantity("periodic_2pct_2el_second_order", largest(results.second_order), steady[2], 0.005, "",
                 "converged value; with second-order terms two elements suffice", two, kind="own"),
        *(
            Quantity(f"periodic_{round(100 * ratio)}pct_converged_linearized", largest(linear), more=converged)
            for ratio, linear in results.converged_linearized.items()
        ),
        Quantity("harmonics_2pct", periodic.cosine_sine(series, 6), source=data.PAIRS, more=converged),
        Quantity("harmonics_2pct_amplitudes", amplitudes(series), data.HARMONICS, 0.012, "", data.MODES, converged,
                 kind="own"),
        Quantity("spatial_minus_planar", gap / largest(results.second_order), 0.0, 2e-11, "", data.SPACE, two,
                 kind="own", reason=ITERATION),
    ]  # fmt: skip


def talk(results: SliderCrankResults, slides: dict[float, TalkResults]) -> list[Quantity]:
    """Compare the talk's model, slides 23 to 30: transient, periodic and swept, linearized and full."""
    two, rows = {"elements": ELEMENTS}, []
    for zeta, found in slides.items():
        pct = f"{round(100 * zeta)}pct"
        tops, full = found.maxima, found.full_maxima
        gap = np.abs(found.linear_transient - found.transient).max()
        rows += [
            Quantity(f"talk_transient_{pct}", [np.abs(y).max() for y in (found.linear_transient, found.transient)],
                     source=data.BOTH, more=two),
            Quantity(f"talk_transient_difference_{pct}", gap, source=data.GAP, more=two),
            Quantity(f"periodic_{pct}_2el", largest(found.periodic), data.TWO_ELEMENTS[zeta], 4e-4, "",
                     data.TWO_ELEMENTS_SOURCE, two, kind="own"),
            Quantity(f"periodic_{pct}_2el_linearized", largest(found.linear_periodic), found.linear_periodic_in_time,
                     1.3e-9, "", data.IN_TIME, two, kind="own"),
            Quantity(f"talk_resonances_{pct}", omega0(ELEMENTS, False) / tops[-3:, 0], data.TALK_RESONANCES, 0.03, "",
                     data.RESONANCES, two, kind="published"),
            Quantity(f"talk_resonances_{pct}_full", omega0(ELEMENTS, False) / full[-3:, 0], data.TALK_RESONANCES,
                     0.06 if zeta == 0.01 else 0.04, "", data.RESONANCES_FULL, two, kind="published"),
            Quantity(f"talk_maxima_{pct}", tops, source=data.MAXIMA, more=two),
            Quantity(f"talk_maxima_deflections_{pct}", tops[:, 1], found.maxima_in_time,
                     1e-8 if zeta == 0.01 else 1.7e-9, "", data.IN_TIME, two, kind="own"),
            Quantity(f"talk_maxima_{pct}_full", full, source=data.MAXIMA_FULL, more=two),
            Quantity(f"talk_fold_speeds_{pct}", found.fast.omega[found.fast.folds], unit="rad/s", source=data.FOLDS,
                     more=two),
            Quantity(f"converged_maxima_{pct}", results.maxima[zeta], source=data.MAXIMA, more={"elements": CONVERGED}),
        ]  # fmt: skip
    return [
        *rows,
        Quantity("talk_full_minus_simulation_1pct", simulated(slides[0.01], 0.01), 0.0, 4e-7, "", data.FIVE_TURNS, two,
                 kind="own"),
    ]  # fmt: skip


def sweeps(results: SliderCrankResults) -> list[Quantity]:
    """Compare the largest deflections over the speeds, and stability."""
    rows = []
    for ratio, column in ((0.02, 2), (0.01, 1)):
        found, name = results.swept[ratio], f"{round(100 * ratio)}pct"
        reference = {row[0]: row[column] for row in data.SWEEP}
        at = [i for i, speed in enumerate(found.speeds) if speed in reference]
        expected = [reference[found.speeds[i]] for i in at]
        more = {"elements": CONVERGED, "speeds": found.speeds[at].tolist()}
        table = np.column_stack(
            [found.speeds, results.rows_linearized[ratio][: found.speeds.size], found.largest]
        )
        about = f"rows of speed [rad/s], linearized, nonlinear; {100 * ratio:g} % damping"
        rows += [
            Quantity(
                "sweep" if ratio == 0.02 else "sweep_1pct", table, source=about, more={"elements": CONVERGED}
            ),
            Quantity(
                f"sweep_nonlinear_{name}",
                found.largest[at],
                expected,
                0.012,
                "",
                data.MODES,
                more,
                kind="own",
            ),
        ]
    neglected = max(swept.neglected for swept in results.swept.values())
    stops = "; ".join(swept.message for swept in results.swept.values() if swept.message)
    return [
        *rows,
        Quantity("sweep_seconds", results.seconds, unit="s",
                 source=data.TIMED),
        Quantity("sweep_neglected", neglected, 0.0, 2e-3, "", stops or "share of the harmonics above 16, worst speed",
                 kind="own"),
    ]  # fmt: skip


def branches(found: SweptBranches) -> list[Quantity]:
    """Compare the excitation of the harmonics; folds and stability of the nonlinear motions over the speed."""
    one, two = found.followed[0.01], found.followed[0.02]
    converged = {"elements": CONVERGED}
    ones = np.ones(len(one.folds))
    return [
        Quantity("excitation", found.excited, source=data.EXCITED, more=converged),
        Quantity("excitation_2el_first_order", found.excited_first_order, source=data.EXCITED, more={"elements": 2}),
        Quantity("fold_speeds_1pct", one.omega[one.folds], unit="rad/s",
                 source="the nonlinear motions turn back, by arc length", more=converged),
        Quantity("fold_speed_1pct_half_steps", found.fold_half_steps, float(one.omega[one.folds[0]]), 1e-8, "rad/s",
                 data.FINE, converged, kind="own", reason=ITERATION),
        Quantity("fold_multipliers_1pct", one.modulus[one.folds], ones, 4.5e-4, "", data.ONE, converged,
                 kind="closed form"),
        Quantity("branches_minus_simulation_1pct", found.off_simulation, np.zeros(2), 2.3e-4, "",
                 data.TURNS, converged, kind="own"),
        Quantity("floquet_peaks_1pct", peaks(one), source=data.PEAKS, more=converged),
        Quantity("floquet_peaks_2pct", peaks(two), source=data.PEAKS, more=converged),
        Quantity("largest_floquet_multiplier", float(two.modulus.max()),
                 source="nonlinear, 2 %, all speeds from 190 to 330 rad/s; stable below 1"),
    ]  # fmt: skip
