"""Inertia that is lost in rounding errors: the motion is named, instead of accelerations made of rounding errors."""

import numpy as np
import pytest

import flexel as fx


def rotor(angles: tuple[float, float]) -> fx.System:
    """Two blades, both on hinges in the hub's axis: the hub between them turns by itself, and has no inertia."""
    m = fx.Model(gravity=(0, 0))
    m.angle("ground", fixed=True)
    m.point("O", (0, 0), fixed=True)
    m.angle("hub", 0.5)
    m.hinge("axis", "ground", "hub")
    for i, angle in enumerate(angles):
        m.angle(f"root{i}", 0.1)
        m.hinge(f"pin{i}", "hub", f"root{i}")
        m.point(f"tip{i}", (0.3 * np.cos(angle), 0.3 * np.sin(angle)))
        m.angle(f"end{i}", angle)
        m.beam(
            f"blade{i}",
            "O",
            f"root{i}",
            f"tip{i}",
            f"end{i}",
            EA=1e3,
            mass_per_length=0.7,
            inertia_per_length=0.03,
        )
    return m.build()


@pytest.mark.parametrize("first", np.linspace(-1, 1, 9))
@pytest.mark.parametrize("second", (0.3, 1.1, 2.0))
def test_a_motion_whose_inertia_is_a_rounding_error_is_refused(first: float, second: float) -> None:
    with pytest.raises(fx.DynamicsError, match="moves no mass"):
        _ = rotor((first, second)).initial


@pytest.mark.parametrize("part", (1e-3, 1e-6, 1e-9))
def test_small_inertia_is_none_that_is_lost(part: float) -> None:
    """A hub of a small inertia between heavy bodies on springs: its acceleration is torque by inertia."""
    m = fx.Model(gravity=(0, 0))
    m.angle("ground", fixed=True)
    m.angle("hub")
    m.angle("wheel")
    m.hinge("axis", "ground", "hub")
    m.hinge("pin", "hub", "wheel")
    m.point("O", (0, 0), fixed=True)
    m.body("light", "O", "hub", mass=1.0, inertia=part)
    m.body("heavy", "O", "wheel", mass=1.0, inertia=1.0)
    m.load("axis.angle", 2.0)  # between the ground and the hub
    state = m.build().initial
    assert state.acceleration("hub.angle") == pytest.approx(2.0 / part, rel=1e-15 / part + 1e-13)
    assert state.acceleration("wheel.angle") == pytest.approx(0.0, abs=1e-15 / part)
