"""Chains of beams, for tests."""

from collections.abc import Sequence
from typing import Any

from flexel.parts.model import Model


def chain(n: int, *, pinned: bool = False, gravity: Sequence[float] = (0, 0, 0), **beam: Any) -> Model:
    """A straight beam of length 1 along x in n elements, clamped at the origin, or pinned about z at both ends."""
    m = Model(gravity=gravity)
    for i in range(n + 1):
        m.point(f"p{i}", (i / n, 0, 0), fixed=i == 0)
        m.frame(f"r{i}", fixed=i == 0 and not pinned)
    if pinned:
        m.frame("ground", fixed=True)
        m.hinge("pin", "ground", "r0", axis=(0, 0, 1))
        m.fix(f"p{n}.y")
    for i in range(n):
        m.beam(f"b{i}", f"p{i}", f"r{i}", f"p{i + 1}", f"r{i + 1}", direction=(0, 1, 0), **beam)
    return m
