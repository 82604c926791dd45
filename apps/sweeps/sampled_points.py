"""Draws the points of a sweep from ranges and distributions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from flexel.apps.sweeps.points import OWNER, Points, listed
from flexel.base.arguments import number, text, whole
from flexel.base.arrays import Array
from flexel.base.errors import ModelError


def sample(
    parameters: Mapping[str, Any], count: int, *, seed: int = 0, method: Literal["latin", "random"] = "latin"
) -> Points:
    """Draw points for `fx.sweep` from ranges or distributions of independent parameters.

    Parameters
    ----------
    parameters : mapping of str to (float, float) or distribution
        Lower and upper limit of a uniform distribution, or a distribution of SciPy, such as
        ``scipy.stats.norm(0.3e-3, 5e-6)``.
    count : int
        Number of points.
    seed : int
        The same seed gives the same points.
    method : {"latin", "random"}
        Latin hypercube, with one point in each of `count` equally likely intervals of every parameter; or independent
        points.

    Examples
    --------
    >>> from scipy.stats import norm
    >>> points = fx.sample({"thickness": norm(0.3e-3, 5e-6), "length": (0.099, 0.101)}, 1000)
    """
    if not isinstance(parameters, Mapping) or not parameters:
        raise ModelError(f"{OWNER}: {parameters!r} names no parameter; give {{'parameter': (low, high)}}")
    size = whole(count, OWNER, "number of points")
    unit = _unit(len(parameters), size, whole(seed, OWNER, "seed", 0, 2**63), method)
    return listed(
        {
            name: _drawn(name, distribution, unit[:, i])
            for i, (name, distribution) in enumerate(parameters.items())
        }
    )


def _unit(size: int, count: int, seed: int, method: str) -> Array:
    """Return points (count, size) of the unit cube."""
    source = np.random.default_rng(seed)
    text(method, OWNER, "method")
    if method == "random":
        return source.random((count, size))
    if method != "latin":
        raise ModelError(f"{OWNER}: method {method!r} is unknown; choose 'latin' or 'random'")
    from scipy.stats import qmc

    return np.asarray(qmc.LatinHypercube(size, seed=source).random(count), float)


def _drawn(name: str, given: Any, unit: Array) -> Array:
    """Return values of one parameter for uniform numbers: the inverse of its distribution."""
    inverse = getattr(given, "ppf", None) or getattr(given, "icdf", None)
    if inverse is not None:
        return np.asarray(inverse(unit), float)
    if np.shape(given) != (2,):
        raise ModelError(
            f"{OWNER}: '{name}' is {given!r}; give (low, high) or a distribution such as scipy.stats.norm(0, 1)"
        )
    low, high = (number(limit, OWNER, f"a limit of '{name}'") for limit in given)
    if low >= high:
        raise ModelError(f"{OWNER}: the limits of '{name}', {low:g} and {high:g}, do not increase; swap them")
    return low + (high - low) * unit
