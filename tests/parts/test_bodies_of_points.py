"""Bodies without inertia are point masses, where the motion still moves mass."""

import numpy as np
import pytest

import flexel as fx
from flexel.mechanics.inertia import InertiaError


@pytest.mark.parametrize("planar", [True, False])
def test_a_pendulum_of_a_body_without_inertia_is_the_mathematical_one(planar: bool) -> None:
    m = fx.Model(gravity=(0, -9.81) if planar else (0, -9.81, 0))
    if planar:
        point, frame = m.point("O", (0, 0), fixed=True), m.angle("rod")
        m.hinge("axle", m.angle("ground", fixed=True), frame)
        m.body("bob", point, frame, mass=2.0, inertia=0, offset=(0, -0.5))
    else:
        point, frame = m.point("O", (0, 0, 0), fixed=True), m.frame("rod")
        m.hinge("axle", m.frame("ground", fixed=True), frame, axis=(0, 0, 1))
        m.body("bob", point, frame, mass=2.0, inertia=(0, 0, 0), offset=(0, -0.5, 0))
    s = m.build()
    assert s.vibrations()[0].omega == pytest.approx(np.sqrt(9.81 / 0.5), rel=1e-13)
    start = s.state_at({"axle.angle": np.pi / 2})
    motion = s.simulate(1.0, start=start, rtol=1e-11, samples=21)
    assert motion.rate("axle.angle") ** 2 == pytest.approx(
        2 * 9.81 / 0.5 * np.cos(motion["axle.angle"]), abs=1e-8
    )


def test_a_rotation_that_moves_no_mass_is_an_error_that_names_it() -> None:
    m = fx.Model()
    m.body("b", m.point("A", (0, 0, 0)), m.frame("R"), mass=1.0, inertia=(0, 0, 0))
    m.load("A", (1.0, 0, 0))
    m.load("R", (0, 0, 1.0))  # a moment that turns nothing
    s = m.build()
    for method in ("DOP853", "generalized-alpha"):
        with pytest.raises(InertiaError, match="moves no mass"):
            s.simulate(1.0, method=method)
