"""Ropes that hang: the elastic catenary and the frequencies of a hanging chain.

Imports numpy and flexel.
"""

from __future__ import annotations

from functools import cache

import numpy as np

import flexel as fx
from flexel.base.arrays import Array
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.rope_table import over_meshes
from flexel.results.report import Quantity

MESHES = (6, 12, 24)
CHAIN_MESHES = (4, 8, 16)  # rounding shows from 32 on: EA is 3e6 times the chain's weight
CHAIN = 2.0  # length of the hanging chain [m]


def end_forces(state: fx.State, n: int) -> Array:
    """Forces of the supports of a hanging cable (3,): horizontal at the first end, tensions at both."""
    a, b = (np.array([state.force(f"rope_p{i}.{c}") for c in "xy"]) for i in (0, n))
    return np.array([-a[0], np.hypot(*a), np.hypot(*b)])


def catenary(case: exact.Catenary, n: int, EI: float = 0.0) -> fx.State:
    """Equilibrium of a cable of n elements, started from the closed form."""
    return models.hanging_between(case, n, length=case.L0, EA=case.EA, weight=case.w, EI=EI).equilibrium()


@cache
def catenary_errors(n: int) -> tuple[float, float]:
    """Largest relative error of the end forces of the catenary, and that of its middle over its depth."""
    forces, middle = exact.CATENARY.greens()
    state = catenary(exact.CATENARY, n)
    off = state.position(f"rope_p{n // 2}") - middle
    return float(abs(end_forces(state, n) / forces - 1).max()), float(np.hypot(*off) / abs(middle[1]))


def chain_error(n: int, share: float | None = None) -> float:
    """Largest relative error of the four lowest frequencies of a hanging chain, of a share of its payload's mass."""
    payload = 0.0 if share is None else 1.5 * CHAIN / share
    found = [z.omega for z in models.hanging_chain(n, CHAIN, payload).vibrations(count=4)]
    given = (
        exact.chain_frequencies(CHAIN, 4)
        if share is None
        else exact.loaded_chain_frequencies(CHAIN, share, 4)
    )
    return float(abs(np.array(found) / given - 1).max())


def rows() -> list[Quantity]:
    """Catenary and hanging chain."""
    irvine = "Irvine's catenary, Green's strain"
    return [
        over_meshes("catenary_error", lambda n: catenary_errors(n)[0], MESHES, 4e-7, f"end forces, {irvine}"),
        over_meshes("catenary_sag_error", lambda n: catenary_errors(n)[1], MESHES, 1e-6, f"of the middle, {irvine}"),
        over_meshes("hanging_frequencies_error", chain_error, CHAIN_MESHES, 1e-5, "zeros of J0 (Bernoulli), 4 modes"),
        over_meshes("loaded_chain_frequencies_error", lambda n: chain_error(n, 1.0), CHAIN_MESHES, 1.5e-6,
                    "J2(z0) Y0(z1) = Y2(z0) J0(z1), payload as heavy as the chain, 4 modes"),
    ]  # fmt: skip
