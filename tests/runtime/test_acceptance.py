"""What a new user tries first: mistakes with a motion are named."""

import pytest

import flexel as fx


@pytest.mark.parametrize("time", ["x", None, float("nan")])
def test_a_motion_at_no_time_is_named(time: object) -> None:
    """A time that is no finite number is refused by name, not by NumPy."""
    m = fx.Model(gravity=(0, -9.81))
    m.point_mass("stone", m.point("A", (0, 0)), 1.0)
    motion = m.build().simulate(0.1, samples=3)
    with pytest.raises(fx.ModelError, match=r"motion\.at: time"):
        motion.at(time)  # type: ignore[arg-type]
