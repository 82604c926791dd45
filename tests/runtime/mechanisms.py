"""Small mechanisms to be looked at."""

import numpy as np

import flexel as fx


def pendulum() -> fx.System:
    """A planar rod of 1 m, let go from 60 degrees below the horizontal."""
    m = fx.Model(gravity=(0, -9.81))
    m.point("O", (0, 0), fixed=True)
    m.point("A", (0.5, -np.sqrt(0.75)))
    m.angle("ground", fixed=True)
    m.angle("turn")
    m.hinge("pivot", "ground", "turn")
    m.beam("rod", "O", "turn", "A", mass_per_length=1.0)
    return m.build()


def cantilever() -> fx.System:
    """A steel strip clamped at one end."""
    m = fx.Model()
    m.point("O", (0, 0, 0), fixed=True)
    m.point("A", (0.1, 0, 0))
    m.frame("wall", fixed=True)
    m.frame("tip")
    strip = fx.Rectangle(0.5e-3, 10e-3)
    m.beam("leaf", "O", "wall", "A", "tip", direction=(0, 1, 0), section=strip, material="steel")
    return m.build()
