"""Ropes of spatial cables: implicit steps with full and modified Newton iteration, and how they grow with the rope."""

from timing import Row, best

import flexel as fx

H = 1e-3  # step [s]


def rope(n: int, element: float = 0.1) -> fx.System:
    """A rope of n cables, held at one end and released from the horizontal."""
    m = fx.Model(gravity=(0, 0, -9.81))
    for i in range(n + 1):
        m.point(f"p{i}", (element * i, 0, 0), fixed=i == 0)
        m.slope(f"d{i}", (1, 0, 0))
    for i in range(n):
        ends = (f"p{i}", f"d{i}", f"p{i + 1}", f"d{i + 1}")
        m.cable(f"c{i}", *ends, EA=1e6, EI=50.0, mass_per_length=1.0)
    return m.build()


def measure() -> list[Row]:
    """The figures of this file."""
    rows = []
    system = rope(56)
    for newton, reach, aim in (("full", 1.5, 0.35), ("modified", 1.5, 0.35)):
        run = lambda newton=newton: system.simulate_stiff(
            1.0, step=H, samples=2, newton=newton, progress=False
        )  # noqa: E731
        rows.append(
            Row(f"rope of 56 cables, 1 s, h = 1 ms, {newton} Newton", best(run, repeat=2), reach, aim)
        )
    for n in (125, 500, 2000):
        rows.append(Row(f"rope of {n} cables: build", best(lambda n=n: rope(n), repeat=1)))
        system = rope(n)
        steps = 20
        run = lambda s=system: s.simulate_stiff(steps * H, step=H, samples=2, progress=False)  # noqa: E731, B023
        rows.append(Row(f"rope of {n} cables: a step, per cable", best(run, repeat=2) / steps / n))
    return rows
