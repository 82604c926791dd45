"""Euler angles and axis with angle of a rotation, beside its matrix."""

import numpy as np
import pytest

from flexel.base.arrays import Array
from flexel.base.quaternions import axis_angle, euler_angles, matrix, product, turn

X, Y, Z = np.eye(3)


def turned(z: float, y: float, x: float) -> Array:
    """The rotation about z, then the new y, then the new x axis."""
    return product(product(turn(Z, z), turn(Y, y)), turn(X, x))


@pytest.mark.parametrize("angles", [(0.3, -0.4, 2.0), (-3.0, 1.5, -0.2), (0.0, 0.0, 0.0), (1.0, -1.2, 3.0)])
def test_euler_angles_are_those_of_successive_turns(angles: tuple[float, float, float]) -> None:
    assert euler_angles(turned(*angles)) == pytest.approx(angles, abs=1e-14)
    assert euler_angles(-turned(*angles)) == pytest.approx(angles, abs=1e-14)  # the same rotation


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_at_a_quarter_turn_about_y_the_rotation_is_still_reproduced(sign: float) -> None:
    q = turned(0.7, sign * np.pi / 2, 0.4)
    angles = euler_angles(q)
    assert angles[2] == 0.0
    assert matrix(turned(*angles)) == pytest.approx(matrix(q), abs=1e-7)


@pytest.mark.parametrize("angle", [1e-9, 0.5, 3.0, 4.0, 6.0])
def test_axis_and_angle_make_the_rotation(angle: float) -> None:
    q = turn((1, 2, -2), angle)
    axis, found = axis_angle(q)
    assert 0 < found <= np.pi
    assert matrix(turn(axis, found)) == pytest.approx(matrix(q), abs=1e-14)
    none, zero = axis_angle(np.array([1.0, 0.0, 0.0, 0.0]))
    assert not none.any() and zero == 0.0
