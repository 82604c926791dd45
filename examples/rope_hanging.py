"""Ropes at rest and their frequencies: catenary, hanging chain, cantilever under a large load, rope over a sheave."""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.flexures_exact import cantilever_elastica
from flexel.examples.rope_table import over_meshes
from flexel.results.reproduction import Quantity

MESHES = (12, 24, 48)
CHAIN_MESHES = (32, 64, 128)
ROPE_MESHES = (4, 8, 16)  # rounding shows from 32 on: EA is 3e6 times the rope's weight
ELASTICA, ELASTICA_MESHES = 10.0, (4, 8, 16)  # P L²/EI
WRAPPED_MESHES = (16, 32, 64)
CHAIN = 2.0  # length of what hangs [m]


def end_forces(state: fx.State, n: int) -> Array:
    """Return the forces of the supports of a hanging cable (3,): horizontal at the first end, tensions at both."""
    a, b = (np.array([state.force(f"rope_p{i}.{c}") for c in "xy"]) for i in (0, n))
    return np.array([-a[0], np.hypot(*a), np.hypot(*b)])


def catenary(case: exact.Catenary, n: int, EI: float = 0.0) -> fx.State:
    """Compute the equilibrium of a cable of n elements, started from the closed form."""
    return models.hanging_between(case, n, length=case.L0, EA=case.EA, weight=case.w, EI=EI).equilibrium()


@cache
def catenary_errors(n: int) -> tuple[float, float]:
    """Return the largest relative errors of the catenary's end forces, and of its middle, over its depth."""
    forces, middle = exact.CATENARY.forces, exact.CATENARY(0.5)
    state = catenary(exact.CATENARY, n)
    off = state.position(f"rope_p{n // 2}") - middle
    return float(abs(end_forces(state, n) / forces - 1).max()), float(np.hypot(*off) / abs(middle[1]))


def elastica_error(n: int) -> float:
    """Return the error of the tip of a cantilever under a large load, over its length."""
    tip = models.cantilever(n, ELASTICA).equilibrium().position(f"rope_p{n}")
    down, back = cantilever_elastica(ELASTICA)
    return float(np.hypot(tip[1] - down, 1 - tip[0] - back))


def wrapped_error(n: int) -> float:
    """Return the largest relative error of the tension in a rope over a sheave, from that of its straight parts."""
    system, rope = models.wrapped_sheave(n)
    T = rope.tension(system.equilibrium())[1]
    return float(abs(T / T[0] - 1).max())


def chain_error(n: int) -> float:
    """Return the largest relative error of the four lowest frequencies of a hanging chain of n bars."""
    return _of_frequencies(models.hanging_chain(n, CHAIN), exact.chain_frequencies(CHAIN, 4))


def loaded_rope_error(n: int, share: float = 1.0) -> float:
    """Return the same for a hanging rope of n elements, of a share of its payload's mass."""
    system = models.loaded_rope(n, CHAIN, 1.5 * CHAIN / share)
    return _of_frequencies(system, exact.loaded_chain_frequencies(CHAIN, share, 4))


def _of_frequencies(system: fx.System, given: Array) -> float:
    found = [mode.omega for mode in system.vibrations(count=4)]
    return float(abs(np.array(found) / given - 1).max())


def rows() -> list[Quantity]:
    """Compare catenary, hanging chain and rope, elastica, rope over a sheave."""
    irvine = "Irvine's catenary"
    return [
        over_meshes("catenary_error", lambda n: catenary_errors(n)[0], MESHES, 2.5e-7, f"end forces, {irvine}"),
        over_meshes("catenary_sag_error", lambda n: catenary_errors(n)[1], MESHES, 5e-7, f"of the middle, {irvine}"),
        over_meshes("hanging_frequencies_error", chain_error, CHAIN_MESHES, 6e-3,
                    "zeros of J0 (Bernoulli), 4 modes; bars and masses, order 2"),
        over_meshes("loaded_chain_frequencies_error", loaded_rope_error, ROPE_MESHES, 1e-5,
                    "J2(z0) Y0(z1) = Y2(z0) J0(z1), payload as heavy as the chain, 4 modes"),
        over_meshes("elastica_error", elastica_error, ELASTICA_MESHES, 9e-6,
                    "elastica (Bisshop and Drucker 1945), P L²/EI = 10; over the length"),
        over_meshes("wrapped_rope_error", wrapped_error, WRAPPED_MESHES, 8e-4,
                    "constant tension of a rope over a sheave"),
    ]  # fmt: skip
