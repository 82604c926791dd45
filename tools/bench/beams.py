"""A cantilever bent by a large force at its end: one equilibrium, against the elastica."""

from __future__ import annotations

import numpy as np

import flexel as fx
from bench.timing import Work
from flexel.base.arrays import Array
from flexel.examples.flexures_exact import cantilever_elastica
from flexel.examples.rope_models import cantilever

LOAD = 10.0  # P L²/EI
ELEMENTS = 16
EA = 1e8  # of length 1 and EI = 1: hardly extensible
LOAD_STEPS = 25  # of flexel's path to the full load, for programs that should take as many


def tip_error(tip: Array) -> float:
    """Return the distance of the end (2,) from that of the elastica, over the length."""
    down, back = cantilever_elastica(LOAD)
    return float(np.hypot(tip[1] - down, 1 - tip[0] - back))


def equilibrium() -> Work:
    """Time `System.equilibrium` of 16 planar cables, from the straight cantilever."""
    system = cantilever(ELEMENTS, LOAD)

    def error(state: fx.State) -> float:
        return tip_error(state.position(f"rope_p{ELEMENTS}"))

    return Work(system.equilibrium, error)
