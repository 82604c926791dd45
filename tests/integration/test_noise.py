"""Motions whose rates are lost to rounding beyond the tolerance that is asked for."""

import numpy as np
import pytest

import flexel as fx

TIGHT = {"rtol": 1e-10, "atol": 1e-12, "samples": 2, "progress": False, "method": "DOP853"}


def cables() -> fx.System:
    """Two cables of 30 mm on a body, a metre from the origin: their curvatures keep fewer digits than their places."""
    m = fx.Model(gravity=(2.7, -3.8, 6.0))
    m.point("P0", (0.7, -1.2, 0.4))
    m.frame("R", fx.turn((1, 2, -0.5), 0.8))
    m.body("hand", "P0", "R", mass=45.0, inertia=(0.030, 0.036, 0.045), offset=(0.005, -0.017, 0.014))
    m.slope("d0", (-0.94, -0.42, -0.05), stretch=0.95)
    m.slope("d1", (-0.73, -0.59, -0.38), stretch=1.05)
    m.slope("d2", (-1.0, -0.62, -0.04), stretch=1.03)
    m.point("P1", (0.6718, -1.2232, 0.3968))
    m.point("P2", (0.6464, -1.2465, 0.3958))
    data = {"EA": 40262.0, "EI": 0.225, "mass_per_length": 192.0}
    m.cable("c0", "P0", "d0", "P1", "d1", 0.029, **data)
    m.cable("c1", "P1", "d1", "P2", "d2", 0.032, **data)
    m.point_mass("bob", "P2", 32.7)
    return m.build()


@pytest.mark.parametrize("seed", [0, 4])
def test_steps_do_not_become_ever_shorter_where_rates_are_noisy(seed: int) -> None:
    """Each step was refused once for rounding errors of its rates, and the next one began no longer than it."""
    s, rng = cables(), np.random.default_rng(seed)
    start = s.state_at(rates={name: rng.uniform(-5, 5) for name in s.dynamic})
    motion = s.simulate(2e-3, start=start, **TIGHT)
    back = s.state(2e-3, motion[-1].x, -motion[-1].v)
    again = s.simulate(2e-3, start=back, **TIGHT)
    assert abs(again[-1].x - start.x).max() < 1e-9
    assert motion.statistics["steps"] < 150
