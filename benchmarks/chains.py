"""Chains of flexible beams: how the right-hand side and the linearization grow with the number of elements."""

import numpy as np
from timing import Row, best

import flexel as fx


def chain(n: int) -> fx.System:
    """A cantilever of n spatial beams, all modes flexible."""
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(n + 1):
        m.point(f"p{i}", (i / n, 0, 0), fixed=i == 0)
        m.frame(f"r{i}", fixed=i == 0)
    section = {"EA": 1e3, "GJ": 1.0, "EIy": 1.0, "EIz": 1.0, "mass_per_length": 1.0}
    for i in range(n):
        ends = (f"p{i}", f"r{i}", f"p{i + 1}", f"r{i + 1}")
        m.beam(f"b{i}", *ends, **section, inertia_per_length=(0.01, 0.01, 0.01))
    return m.build()


def measure() -> list[Row]:
    """The figures of this file."""
    rows = []
    for n in (4, 16):
        system = chain(n)
        state = system.initial
        y = np.concatenate([state.q, state.qd])
        rows += [
            Row(f"chain of {n} beams: right-hand side", best(lambda y=y, s=system: s.rhs(0.0, y), number=20)),
            Row(f"chain of {n} beams: linearization", best(system.linearize, repeat=3)),
        ]
    return rows
