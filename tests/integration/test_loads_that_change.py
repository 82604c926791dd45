"""A load that reads a variable of the program: every motion begins with what the variable is then."""

import numpy as np
import pytest

import flexel as fx


def test_the_initial_state_is_not_kept_from_the_last_motion() -> None:
    m = fx.Model()
    m.point("A", (0, 0))
    m.fix("A.y")
    m.point_mass("mass", "A", 2.0)
    given = {"force": 10.0}
    m.load("A.x", lambda t: given["force"] + 0 * t)
    system = m.build()
    for force in (10.0, 50.0, -3.0):
        given["force"] = force
        motion = system.simulate(1.0, samples=5, progress=False)
        np.testing.assert_allclose(motion.acceleration("A.x"), force / 2, rtol=1e-12)
        for state in (system.initial, system.state_at(rates={"A.x": 1.0})):
            assert state.acceleration("A.x") == pytest.approx(force / 2, rel=1e-14)


def test_the_initial_state_of_constant_loads_is_kept() -> None:
    m = fx.Model(gravity=(0, -9.81))
    m.point("A", (0, 0))
    m.point_mass("mass", "A", 2.0)
    m.load("A.x", 1.0)
    system = m.build()
    assert system.initial is system.initial
