"""What a new user tries first: mistakes with a motion are named."""

import pytest

import flexel as fx


@pytest.mark.parametrize("time", ["x", None, float("nan")])
def test_a_motion_at_no_time_is_named(time: object) -> None:
    """A time that is not a finite number is rejected with its name, not by NumPy."""
    m = fx.Model(gravity=(0, -9.81))
    m.point_mass("stone", m.point("A", (0, 0)), 1.0)
    motion = m.build().simulate(0.1, samples=3)
    with pytest.raises(fx.ModelError, match=r"motion\.at: time"):
        motion.at(time)  # type: ignore[arg-type]


def test_two_wheels_on_one_axle_are_told_to_release_a_slip() -> None:
    m = fx.Model(gravity=(0, 0, -9.81))
    axle, ground = m.frame("axle"), (m.point("L", (0, 0.5, 0.3)), m.point("R", (0, -0.5, 0.3)))
    for side, hub in zip("lr", ground, strict=True):
        wheel = m.frame(f"wheel {side}")
        m.hinge(f"spin {side}", axle, wheel, axis=(0, 1, 0))
        contact = m.point(f"contact {side}", (0, 0.5 if side == "l" else -0.5, 0))
        m.wheel(side, hub, wheel, contact, radius=0.3, axle=(0, 1, 0))
        m.body(f"rim {side}", hub, wheel, mass=1.0, inertia=(0.02, 0.04, 0.02))
    m.beam("bar", ground[0], axle, ground[1])
    with pytest.raises(fx.ConstraintError, match=r"m\.release\('[lr]\.lateral'\)"):
        m.build()
