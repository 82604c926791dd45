"""What is left of a simulation that is interrupted or fails."""

from typing import Any

import numpy as np
import pytest

import flexel as fx


class Impatience:
    """A load that somebody interrupts once the motion has come to a time; all times at once are looked at before."""

    def __init__(self, until: float) -> None:
        self.until = until

    def __call__(self, t: Any) -> Any:
        if np.ndim(t):
            return np.ones_like(t)
        if t > self.until:
            raise KeyboardInterrupt
        return 1.0


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_an_interrupt_keeps_the_motion_up_to_its_last_step(method: str) -> None:
    """Also between the stored samples; it continues from there."""
    load = Impatience(0.5)
    m = fx.Model(gravity=(0, -9.81))
    m.point_mass("mass", m.point("P", (0.0, 0.0)), 2.0)
    m.load("P.x", (load, lambda t: 0.0, lambda t: 0.0))
    system = m.build()
    options: dict[str, Any] = {"max_step": 0.05, "progress": False, "method": method}
    with pytest.raises(fx.Interrupted) as caught:
        system.simulate(1.0, samples=2, **options)
    motion = caught.value.motion
    end = motion[-1]
    assert 0.4 < end.t <= 0.5
    assert motion.message == f"interrupted at t = {end.t:g} s"
    assert end.position("P") == pytest.approx(np.array([0.25, -4.905]) * end.t**2, rel=1e-6)
    load.until = 2.0
    rest = system.simulate(1.0 - end.t, start=end, samples=2, **options)
    assert rest[-1].position("P") == pytest.approx([0.25, -4.905], rel=1e-6)


def overstretched() -> fx.Model:
    """A crank of 1 m whose end is drawn away until it cannot follow."""
    m = fx.Model()
    m.point("O", (0.0, 0.0), fixed=True)
    m.point_mass("mass", m.point("A", (0.6, 0.8)), 1.0)
    m.truss("rod", "O", "A")
    m.prescribe("A.x", lambda t: 0.6 + t)
    return m


@pytest.mark.parametrize("free", [False, True])
def test_a_simulation_that_fails_leaves_what_it_computed(free: bool) -> None:
    """With a degree of freedom beside the driven crank, and without."""
    m = overstretched()
    if free:
        m.point_mass("other", m.point("B", (3.0, 0.0)), 1.0)
        m.initial("B.y", rate=1.0)
    with pytest.raises(fx.FlexelError, match="'A.x'") as caught:
        m.build().simulate(1.0, samples=11, progress=False)
    motion = caught.value.motion
    assert motion is not None
    assert 0.3 < motion.t[-1] < 0.4 + 1e-9
    assert motion["A.y"][:4] == pytest.approx(np.sqrt(1 - (0.6 + motion.t[:4]) ** 2), abs=1e-9)
    if free:
        assert motion["B.y"] == pytest.approx(motion.t, abs=1e-9)
