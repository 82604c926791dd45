"""The table of the slider-crank: every quantity beside its reference, with what explains their difference."""

from __future__ import annotations

import numpy as np

from flexel.examples import slider_crank_data as data
from flexel.examples.reasons import ITERATION, STEPS
from flexel.examples.slider_crank import CONVERGED, Results, amplitudes, deflection, largest, omega0
from flexel.examples.slider_crank_branch import Branches, peaks
from flexel.linear import periodic
from flexel.results.report import Quantity


def single(results: Results) -> list[Quantity]:
    """Frequencies of the rod, transients and periodic motions at 150 rad/s."""
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
            Quantity(f"transient_max_{round(100 * z)}pct", float(np.abs(deflection(m, CONVERGED)).max()),
                     data.TRANSIENT_MAX[z], 1.5e-4 if z == 0.01 else 5e-5, "", data.TRANSIENT, converged,
                     kind="own", reason=STEPS)
            for z, m in results.transients.items()
        ),
        *(
            Quantity(f"periodic_{round(100 * z)}pct_2el", largest(results.periodic[z]),
                     data.TWO_ELEMENTS[z], 4e-4, "", data.TWO_ELEMENTS_SOURCE, two, kind="own")
            for z in (0.02, 0.01)
        ),
        Quantity("periodic_2pct_converged", largest(series), steady[2], 0.002, "", data.MODES, converged,
                 kind="own"),
        Quantity("periodic_1pct_converged", largest(results.converged[0.01]), steady[1],
                 0.002, "", data.MODES, converged, kind="own"),
        Quantity("periodic_2pct_2el_linearized", largest(results.linearized), source=data.NOMINAL, more=two),
        Quantity("periodic_2pct_2el_second_order", largest(results.second_order), steady[2], 0.005, "",
                 "converged value; with second-order terms two elements suffice", two, kind="own"),
        Quantity("periodic_2pct_converged_linearized", largest(results.converged_linearized), more=converged),
        Quantity("harmonics_2pct", periodic.cosine_sine(series, 6), source=data.PAIRS, more=converged),
        Quantity("harmonics_2pct_amplitudes", amplitudes(series), data.HARMONICS, 0.012, "", data.MODES, converged,
                 kind="own"),
        Quantity("spatial_minus_planar", gap / largest(results.second_order), 0.0, 2e-11, "", data.SPACE, two,
                 kind="own", reason=ITERATION),
    ]  # fmt: skip


def sweeps(results: Results) -> list[Quantity]:
    """Largest deflections over the speeds, and stability."""
    rows = []
    for z, column in ((0.02, 2), (0.01, 1)):
        found, name = results.swept[z], f"{round(100 * z)}pct"
        reference = {row[0]: row[column] for row in data.SWEEP}
        at = [i for i, speed in enumerate(found.speeds) if speed in reference]
        expected = [reference[found.speeds[i]] for i in at]
        more = {"elements": CONVERGED, "speeds": found.speeds[at].tolist()}
        table = np.column_stack(
            [found.speeds, results.rows_linearized[z][: found.speeds.size], found.largest]
        )
        about = f"rows of speed [rad/s], linearized, nonlinear; {100 * z:g} % damping"
        rows += [
            Quantity(
                "sweep" if z == 0.02 else "sweep_1pct", table, source=about, more={"elements": CONVERGED}
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
    neglected = max(z.neglected for z in results.swept.values())
    stops = "; ".join(z.message for z in results.swept.values() if z.message)
    return [
        *rows,
        Quantity("sweep_seconds", results.seconds, unit="s",
                 source=data.TIMED),
        Quantity("sweep_neglected", neglected, 0.0, 2e-3, "", stops or "share of the harmonics above 16, worst speed",
                 kind="own"),
    ]  # fmt: skip


def branches(found: Branches) -> list[Quantity]:
    """What excites the harmonics; folds and stability of the nonlinear motions over the speed."""
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
