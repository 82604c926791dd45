"""Columns of planar beams, length and bending stiffness one."""

import flexel as fx


def column(n: int, EA: float, *, clamped: bool = False, mass: float = 1.0) -> fx.Model:  # noqa: N803
    """Return n beams along x: points P0 … Pn, angles R0 … Rn, beams B0 …; the first point is fixed."""
    m = fx.Model()
    m.point("P0", (0, 0), fixed=True)
    m.angle("R0", fixed=clamped)
    for i in range(n):
        ends = f"P{i}", f"R{i}", m.point(f"P{i + 1}", ((i + 1) / n, 0)), m.angle(f"R{i + 1}")
        m.beam(f"B{i}", *ends, EA=EA, EIz=1.0, mass_per_length=mass)
    return m


def pinned(n: int, EA: float, thrust: float) -> fx.Model:  # noqa: N803
    """Return a column between pins, under a thrust along it."""
    m = column(n, EA)
    m.fix(f"P{n}.y")
    m.load(f"P{n}.x", -thrust)
    return m
