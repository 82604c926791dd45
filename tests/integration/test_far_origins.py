"""Models far from their origin move with the digits that their coordinates have there."""

from typing import Any

import numpy as np
import pytest

import flexel as fx


def hanging(away: float) -> fx.System:
    """Three slender beams that fall from the horizontal, their upper end at a distance [m] along both axes."""
    m = fx.Model(gravity=(0, -9.81))
    for i in range(4):
        m.point(f"P{i}", (away + 0.3 * i, away), fixed=i == 0)
        m.angle(f"R{i}")
    for i in range(3):
        ends = f"P{i}", f"R{i}", f"P{i + 1}", f"R{i + 1}"
        m.beam(f"b{i}", *ends, EA=1e5, EIz=0.1, mass_per_length=1.0, rotations="logarithmic")
    return m.build()


@pytest.mark.filterwarnings("ignore:.*far from the origin:flexel.base.errors.AuditWarning")
@pytest.mark.parametrize(("away", "digits"), [(5e5, 1e-8), (5e6, 1e-7)])
@pytest.mark.parametrize("options", [{}, {"method": "Radau"}])
def test_beams_far_away_fall_as_they_do_here(away: float, digits: float, options: dict[str, Any]) -> None:
    """At 500 km they took 41 000 steps, and at 5000 km no position was found beside the first one."""
    here, far = (hanging(d).simulate(0.1, samples=11, **options) for d in (0.0, away))
    assert far.statistics["steps"] < 10 * here.statistics["steps"]
    assert "place the model near the origin" in far.message
    for name in ("P3.x", "P3.y"):
        np.testing.assert_allclose(far[name] - away, here[name], rtol=0, atol=digits)


@pytest.mark.filterwarnings("ignore::flexel.base.errors.AssemblyWarning")
@pytest.mark.parametrize("away", [1e4, 1e6])
def test_a_wheel_is_assembled_far_away(away: float) -> None:
    """Conditions on the wheel could not be satisfied to better than rounding of the places: "cannot be assembled"."""
    m = fx.Model(gravity=(0, 0, -9.81))
    hub, touch, frame = m.point("hub", (away, 0.3, 0.3)), m.point("touch", (away, 0.3, 0)), m.frame("disc")
    m.wheel("wheel", hub, frame, touch, radius=0.3, axle=(0.1, 1.0, 0.2), normal=(0, 0, 1))
    m.body("body", hub, frame, mass=1.0, inertia=(0.0225, 0.045, 0.0225))
    m.body_point("arm", hub, frame, m.point("tip", (away + 0.3, 0.7, 0.4)))
    system = m.build()
    assert abs(system.initial["hub.x"] - away) < 0.1
