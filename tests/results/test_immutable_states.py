"""What was computed never changes: states cannot be written to, and a motion keeps its loads."""

import pickle

import numpy as np
import pytest

import flexel as fx


def pendulum() -> fx.Model:
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0.0, 0.0), fixed=True)
    m.point("A", (0.6, -0.8))
    m.truss("rod", "O", "A")
    m.point_mass("bob", "A", 1.0)
    return m


def test_the_initial_state_cannot_be_changed_by_accident() -> None:
    """`s.initial.v += 0.1` changed all later motions, although it raised an error."""
    s = pendulum().build()
    with pytest.raises(ValueError, match="read-only"):
        s.initial.v += 0.1  # type: ignore[misc]
    with pytest.raises(ValueError, match="read-only"):
        s.initial.x[0] = 0.5
    np.testing.assert_array_equal(s.simulate(0.1, method="DOP853")[0].v, 0.0)


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_states_of_motions_and_of_files_cannot_be_written_to(method: str) -> None:
    motion = pendulum().build().simulate(0.1, method=method)
    for state in (motion[0], motion[-1], pickle.loads(pickle.dumps(motion))[-1]):
        with pytest.raises(ValueError, match="read-only"):
            state.v[0] = 1.0


def test_a_motion_keeps_the_loads_with_which_it_was_computed() -> None:
    """Stored states are complete; between them, a load that gives other values now is an error by name."""
    strength = [1.0]
    m = pendulum()
    m.load("A.x", lambda t: strength[0] * np.cos(t))
    s = m.build()
    motion, same = s.simulate(1.0, samples=5, method="DOP853"), s.simulate(1.0, samples=5, method="DOP853")
    expected, between = same["A.x''"], same.at(0.6).a
    np.testing.assert_array_equal(motion.at(0.6).a, between)
    strength[0] = 100.0
    np.testing.assert_array_equal(motion["A.x''"], expected)
    with pytest.raises(
        fx.ModelError, match=r"load on 'A\.x' has changed since .*\(1 then, 100 now at t = 0 s\)"
    ):
        motion.at(0.6)
