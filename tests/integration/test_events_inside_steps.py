"""Events that come and go within one step."""

import numpy as np
import pytest

import flexel as fx

METHODS = ("DOP853", "RK45", "Radau", "BDF", "LSODA", "auto")
HEIGHT = 4.0**2 / (2 * 9.81)  # of a throw at 4 m/s [m]


def thrown() -> fx.System:
    """A stone thrown up at 4 m/s."""
    m = fx.Model(gravity=(0, 0, -9.81))
    m.point("P", (0, 0, 0))
    m.point_mass("stone", "P", 0.5)
    m.initial("P.z", rate=4.0)
    return m.build()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("above", [1e-2, 1e-6])
def test_a_ceiling_that_is_touched_briefly_ends_the_motion(method: str, above: float) -> None:
    """A throw passes HEIGHT - above for the first time at (v - sqrt(2 g above))/g; closed form."""
    ceiling = fx.Event("ceiling", lambda s: s["P.z"] - (HEIGHT - above), terminal=True)
    motion = thrown().simulate(0.9, method=method, events=[ceiling])
    assert "ceiling" in motion.message
    assert motion.t[-1] == pytest.approx((4.0 - np.sqrt(2 * 9.81 * above)) / 9.81, abs=1e-7)
