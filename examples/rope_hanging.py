"""Ropes that hang: the elastic catenary and the frequencies of a hanging chain.

Imports numpy and flexel.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

import flexel as fx
from flexel.examples import rope_exact as exact
from flexel.examples import rope_models as models
from flexel.examples.convergence import order
from flexel.report import Quantity
from flexel.structure import Array

MESHES = (6, 12, 24)
CHAIN = 2.0  # length of the hanging chain [m]


def over_meshes(
    name: str, error: Callable[[int], float], meshes: Sequence[int], tolerance: float, source: str
) -> Quantity:
    """The row of a relative error on the finest of some meshes that double, with the observed order."""
    errors = [error(n) for n in meshes]
    more = {"elements": meshes[-1], "order": order(errors), "meshes": list(meshes), "errors": errors}
    return Quantity(name, errors[-1], 0.0, tolerance, "", source, more)


def end_forces(state: fx.State, n: int) -> Array:
    """Forces of the supports of a hanging cable (3,): horizontal at the first end, tensions at both."""
    a, b = (np.array([state.force(f"rope_p{i}.{c}") for c in "xy"]) for i in (0, n))
    return np.array([-a[0], np.hypot(*a), np.hypot(*b)])


def catenary(case: exact.Catenary, n: int, EI: float = 0.0) -> fx.State:
    """Equilibrium of a cable of n elements, started from the closed form."""
    return models.hanging_between(case, n, length=case.L0, EA=case.EA, weight=case.w, EI=EI).equilibrium()


def catenary_error(n: int) -> float:
    """Largest relative error of the end forces of the catenary."""
    forces = end_forces(catenary(exact.CATENARY, n), n)
    return float(abs(forces / exact.CATENARY.greens() - 1).max())


def chain_error(n: int) -> float:
    """Largest relative error of the four lowest frequencies of the hanging chain."""
    found = [z.frequency for z in models.hanging_chain(n, CHAIN).vibrations(count=4)]
    return float(abs(np.array(found) / exact.chain_frequencies(CHAIN, 4) - 1).max())


def rows() -> list[Quantity]:
    """Catenary and hanging chain."""
    return [
        over_meshes(
            "catenary_error", catenary_error, MESHES, 1e-6, "elastic catenary (Irvine 1981), Green's strain"
        ),
        over_meshes(
            "hanging_frequencies_error", chain_error, (8, 16, 32), 1e-5, "zeros of J0 (Bernoulli), 4 modes"
        ),
    ]
