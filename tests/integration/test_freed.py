"""A motion that nobody holds is freed at once, with the arrays of its method: sweeps run thousands of them."""

import gc
import weakref

import pytest

import flexel as fx
from flexel.integration.simulation import begun


@pytest.mark.parametrize("method", ["DOP853", "Radau", "generalized-alpha"])
def test_a_motion_is_freed_without_the_garbage_collector(method: str) -> None:
    m = fx.Model(gravity=(0, -9.81))
    line = m.chain("chain", [(0, 0), (1, 0)], 3, mass_per_length=1.0)
    m.fix(line.points[0])
    system = m.build()
    begun(system, 0.1, method=method)  # what the system keeps
    gc.collect()
    gc.disable()
    try:
        run = begun(system, 0.1, method=method).run
        run.rest(False)
        freed = weakref.ref(run)
        del run
        assert freed() is None
    finally:
        gc.enable()
