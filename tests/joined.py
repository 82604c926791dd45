"""Two rigid bodies in space and a joint between them."""

from collections.abc import Callable

import numpy as np

import flexel as fx

AXIS = np.array([1.0, 2.0, 2.0]) / 3
AT = (0.1, 0.2, 0.05)


def two_bodies(joint: Callable[[fx.Model], object]) -> fx.Model:
    """A body that floats freely in space, and another that a joint holds to it away from both mass centres."""
    m = fx.Model()
    m.rigid_body("a", (0, 0, 0), fx.turn((1, 1, 0), 0.4), mass=2.0, inertia=(0.1, 0.2, 0.25))
    m.rigid_body("b", (0.4, 0.1, -0.2), fx.turn((0, 1, 2), -0.7), mass=1.5, inertia=(0.2, 0.1, 0.15))
    joint(m)
    return m
