"""Directions 1 and 2 across the axis of a joint are those that the page on joints shows."""

import numpy as np
import pytest

import flexel as fx
from flexel.base.quaternions import matrix

AXES = [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, -0.3, 0.5)]
SMALL = 1e-4


@pytest.mark.parametrize("axis", AXES)
def test_radial_and_bending_deformations_follow_the_two_directions(axis: tuple[float, float, float]) -> None:
    along = np.array(axis) / np.linalg.norm(axis)
    one = np.eye(3)[int(np.argmin(np.abs(along)))]
    one = one - (one @ along) * along
    one /= np.linalg.norm(one)
    two = np.cross(along, one)
    m = fx.Model(gravity=(0, 0, 0))
    m.rigid_body("a", (0, 0, 0), mass=1.0, inertia=(1, 1, 1))
    m.rigid_body("b", (0, 0, 0), mass=1.0, inertia=(1, 1, 1))
    m.fix("a", "a_frame")
    m.cylindrical("j", "a", "b", at=(0, 0, 0), axis=axis)
    m.release("j.radial1", "j.radial2", "j.bend1", "j.bend2")
    s = m.build()
    for number, direction in ((1, one), (2, two)):
        shifted = s.state_at({f"j.radial{number}": SMALL})
        assert shifted.position("b") == pytest.approx(SMALL * direction, abs=1e-12)
        tilted = s.state_at({f"j.bend{number}": SMALL})
        turn = matrix(tilted.position("b_frame"))
        assert turn @ along - along == pytest.approx(np.cross(-SMALL * direction, along), abs=1e-7)
