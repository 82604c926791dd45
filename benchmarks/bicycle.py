"""The bicycle of the 2007 benchmark: right-hand side, linearization, root loci, manoeuvre M1."""

import numpy as np
from timing import Row, best

from flexel.examples.bicycle import bicycle, lean_steer, rolling


def measure() -> list[Row]:
    """The figures of this file."""
    system = bicycle()
    start = rolling(system, 4.0, 0.05)
    y = np.concatenate([start.q, start.qd])
    points = [y, y + 1e-4]  # two states in turn, so that no answer is remembered
    system.rhs(0.0, y)

    def right_hand_side() -> None:
        for point in points:
            system.rhs(0.0, point)

    def loci() -> None:
        for v in np.linspace(0.0, 10.0, 100):
            lean_steer(system, float(v)).eigenvalues()

    return [
        Row("bicycle: model build, kernels cached", best(bicycle, repeat=5), 0.1, 0.1),
        Row("bicycle: right-hand side", best(right_hand_side, repeat=7, number=100) / 2, 60e-6, 6e-6),
        Row("bicycle: linearization", best(lambda: system.linearize(start), repeat=5, number=20)),
        Row("bicycle: root loci, 100 speeds", best(loci, repeat=3), 0.3, 30e-3),
        Row(
            "bicycle: manoeuvre M1, 5 s, error 1e-6",
            best(
                lambda: system.simulate(5.0, start=start, samples=2, method="DOP853", rtol=1e-7, atol=1e-9),
                repeat=3,
            ),
            0.1,
            7e-3,
        ),
    ]
