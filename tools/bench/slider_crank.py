"""Times the flexible slider-crank: harmonic balance at 200 speeds."""

from __future__ import annotations

import numpy as np

from bench.timing import Work
from flexel.examples.slider_crank import HARMONICS, Sweep, linear_sweep


def sweep() -> Work:
    """Time the linearized sweep of the example: models, orbits, linearization and 200 speeds with 12 harmonics."""

    def error(found: Sweep) -> float:
        expected = linear_sweep(0.02, harmonics=HARMONICS).largest
        return float(np.abs(found.largest - expected).max() / expected.max())

    return Work(lambda: linear_sweep(0.02), error)
