"""The balance of forces in C: its tangent against differences, and its energies; steps in several threads."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from mechanisms import heavy_top

import flexel as fx
from flexel.base.arrays import Array
from flexel.engine.energies import Energies
from flexel.examples.bicycle import bicycle
from flexel.examples.rope_models import atwood
from flexel.examples.vehicle import vehicle
from flexel.integration.balance import Saddle

RATE, ACCELERATION = 30.0, 2e3  # dv/dx and da/dx


def rope_on_a_sheave() -> fx.System:
    """Atwood's machine: cables, contacts with friction, some of them closed."""
    return atwood(14, 2.5, 2.0, inertia=0.02, mass=1.0)[0]


SYSTEMS: dict[str, Callable[[], fx.System]] = {
    "bicycle": bicycle,
    "vehicle": vehicle,
    "top": heavy_top,
    "rope": rope_on_a_sheave,
}


def off_balance(system: fx.System) -> tuple[Saddle, Callable[[Array], Array]]:
    """A state with motion, accelerations and multipliers, and the unbalance when the free coordinates change."""
    rng, saddle = np.random.default_rng(3), Saddle(system)
    s, start = system.structure, system.at_rest
    x = start.x + 1e-5 * rng.standard_normal(s.n)
    v, a = rng.standard_normal((2, s.n))
    mu = 10 * rng.standard_normal(saddle.force_rows.size)

    def r(change: Array) -> Array:
        full = np.concatenate([change, np.zeros(s.n - s.nf)])
        moved = x + full, v + RATE * full, a + ACCELERATION * full
        return saddle.balance(start.t, *moved, mu, start.e).r

    return saddle, r


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_tangent_is_that_of_differences(name: str) -> None:
    saddle, r = off_balance(SYSTEMS[name]())
    nf, h = saddle.structure.nf, 1e-8
    r(np.zeros(nf))
    saddle.stiffness(RATE, ACCELERATION)
    T = saddle.work.tables.T.pattern.matrix(saddle.free)
    for direction in np.random.default_rng(4).standard_normal((3, nf)):
        change = (r(h * direction) - r(-h * direction)) / (2 * h)
        assert T @ direction == pytest.approx(change, abs=2e-6 * np.abs(change).max())


@pytest.mark.parametrize("name", SYSTEMS)
def test_energies_are_those_of_the_state(name: str) -> None:
    saddle, r = off_balance(SYSTEMS[name]())
    r(np.zeros(saddle.structure.nf))
    found = Energies(saddle.work)
    found.evaluate()
    energy = saddle.state(saddle.present()).energy
    values = [found.struct.kinetic, found.struct.potential, found.struct.strain]
    assert values == pytest.approx([energy.kinetic, energy.potential, energy.strain], rel=1e-12, abs=1e-12)


def test_threads_step_side_by_side() -> None:
    system = rope_on_a_sheave()

    def end(_: int) -> Array:
        return system.simulate(0.05, method="generalized-alpha", step=1e-3, samples=2, progress=False)[-1].x

    alone = end(0)
    with ThreadPoolExecutor(2) as pool:
        assert all(np.array_equal(x, alone) for x in pool.map(end, range(4)))
