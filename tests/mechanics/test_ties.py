"""Quantities that are as good as one another as degrees of freedom: rounding does not choose among them."""

from collections.abc import Callable

import numpy as np
import pytest

import flexel as fx
from flexel.base.arrays import Array
from flexel.mechanics import diagnose


def disc() -> fx.Model:
    """A disc that rolls: its centre and the point where it touches the ground move alike."""
    m = fx.Model(gravity=(0, 0, -9.81))
    hub, touch, frame = m.point("hub", (0, 0, 0.3)), m.point("touch", (0, 0, 0)), m.frame("disc")
    m.wheel("wheel", hub, frame, touch, radius=0.3, axle=(0, 1, 0), normal=(0, 0, 1))
    m.body("body", hub, frame, mass=1.0, inertia=(0.0225, 0.045, 0.0225))
    return m


def carriages() -> fx.Model:
    """Masses with points beside them, in frames that do not turn: both move alike."""
    m = fx.Model()
    m.frame("fixed", fixed=True)
    for i in range(5):
        m.point_mass(f"m{i}", m.point(f"P{i}", (0, i, 0)), 1.0)
        m.body_point(f"b{i}", f"P{i}", "fixed", m.point(f"Q{i}", (1, i, 0)))
    return m


@pytest.mark.parametrize("model", [disc, carriages])
def test_the_first_of_equally_good_degrees_of_freedom_is_chosen(
    model: Callable[[], fx.Model], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Other processors find another basis of the same space, which differs by a rotation and by rounding."""
    exact, generator, found = diagnose.null_space, np.random.default_rng(1), set()

    def turned(A: Array, columns: int) -> tuple[Array, Array]:
        right, left = exact(A, columns)
        turn = np.linalg.qr(generator.standard_normal((right.shape[1], right.shape[1])))[0]
        return right @ turn, left

    monkeypatch.setattr(diagnose, "null_space", turned)
    for _ in range(20):
        found.add(model().build().dynamic)
    assert len(found) == 1
    assert {name.partition(".")[0] for name in found.pop()} <= {"hub", "disc", *(f"P{i}" for i in range(5))}
