"""How many elements a problem needs: convergence with mesh refinement, orders, extrapolation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, Protocol

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.results.reproduction import Kind, Quantity, ToleranceKind

MOST = 128  # elements, beyond which the search gives up


def order(errors: Sequence[float]) -> float:
    """Return the order of convergence from the errors of the last two of meshes that double."""
    return float(np.log2(errors[-2] / errors[-1]))


def romberg(values: Sequence[Array]) -> Array:
    """Return the limit of values on meshes that double, with errors in h², h⁴, ...; two or three meshes are usual."""
    rows = [np.asarray(value, dtype=float) for value in values]
    power = 4.0
    while len(rows) > 1:
        rows = [(power * b - a) / (power - 1) for a, b in zip(rows, rows[1:], strict=False)]
        power *= 4.0
    return rows[0]


def elements_needed(
    error: Callable[[int], float], bounds: Sequence[float], fewest: int = 1
) -> list[int | None]:
    """Find the fewest elements with which the error stays below each of some bounds; None above `MOST`.

    Meshes are doubled until the error is below the smallest bound; between the last mesh that is too coarse and the
    next the error is taken to fall steadily.  A mesh on which no solution is found counts as too coarse.

    Parameters
    ----------
    error : callable
        Relative error on a mesh of n elements.
    """
    found: dict[int, float] = {}

    def log_error(n: int) -> float:
        if n not in found:
            try:
                found[n] = float(np.log(error(n)))
            except FlexelError:
                found[n] = 10.0
        return found[n]

    meshes = [fewest]
    while log_error(meshes[-1]) > np.log(min(bounds)):
        meshes.append(2 * meshes[-1])
        if meshes[-1] > MOST:
            break
    return [_fewest(log_error, float(np.log(bound)), meshes) for bound in bounds]


def _fewest(log_error: Callable[[int], float], bound: float, meshes: Sequence[int]) -> int | None:
    """Find the fewest elements by interpolation with the power of n that the error falls with."""
    coarse = [n for n in meshes if n <= MOST and log_error(n) > bound]
    if not coarse:
        return meshes[0]
    low, high = coarse[-1], 2 * coarse[-1]
    if high > MOST:
        return None
    while high - low > 1:
        share = (log_error(low) - bound) / (log_error(low) - log_error(high))
        guess = int(np.clip(np.ceil(low * (high / low) ** share), low + 1, high - 1))
        if log_error(guess) > bound:
            low = guess
        elif log_error(guess - 1) > bound:
            return guess
        else:
            high = guess - 1
    return high


class MeshError(Protocol):
    """Relative error on a mesh of n elements, with or without the second-order terms."""

    def __call__(self, n: int, second_order: bool) -> float:
        """Return the error."""


def converged(
    name: str,
    value: Callable[[int], Array | float],
    reference: Array | float,
    meshes: Sequence[int],
    tolerances: tuple[float, float, float | None],
    unit: str,
    source: str,
    kind: Kind,
    tolerance_kind: ToleranceKind = "relative",
    reason: str = "",
) -> list[Quantity]:
    """Return rows of one result: on the finest mesh, the order there, and the limit extrapolated from the meshes.

    Parameters
    ----------
    meshes : sequence of int
        Numbers of elements, each twice the one before.
    tolerances : (float, float)
        Of the finest mesh and of the limit, both of the `tolerance_kind`; absolute one of the order, which is to be
        2, or None where terms of the second and fourth order are of the same size.
    kind : str
        Of the reference.
    reason : str, optional
        Of the tolerances of the limit and the order.
    """
    found = [np.asarray(value(n)) for n in meshes]
    size = float(np.max(np.abs(reference)))
    errors = [float(np.max(np.abs(value - reference))) / size for value in found]
    observed = order(errors)
    mesh = {"elements": meshes[-1], "order": observed, "meshes": list(meshes), "errors": errors}
    limit = {"elements": list(meshes)}
    comment = f"{source}; extrapolated from the meshes of " + ", ".join(map(str, meshes)) + " elements"
    both: Any = {"kind": kind, "tolerance_kind": tolerance_kind}
    return [
        Quantity(name, found[-1], reference, tolerances[0], unit, source, mesh, **both),
        order_row(name, observed, tolerances[2], limit, reason),
        Quantity(
            f"{name}_limit",
            romberg(found),
            reference,
            tolerances[1],
            unit,
            comment,
            limit,
            reason=reason,
            **both,
        ),
    ]


def order_row(
    name: str, observed: float, tolerance: float | None, more: Mapping[str, object], reason: str = ""
) -> Quantity:
    """Return the row of an observed order, compared with 2, or only reported if there is no tolerance."""
    said = f"{name}_order", observed
    if tolerance is None:
        return Quantity(*said, source="order of convergence, terms of several orders", more=more)
    return Quantity(*said, 2.0, tolerance, "", "order of convergence", more, kind="closed form",
                    tolerance_kind="absolute", reason=reason)  # fmt: skip


def needed(name: str, error: MeshError, source: str, fewest: int = 1, terms: bool = True) -> Quantity:
    """Return the row of the elements needed for 1 % and for 0.1 %, with and without the second-order terms."""
    both: tuple[bool, ...] = (True, False) if terms else (True,)
    found = [
        elements_needed(partial(error, second_order=second_order), (1e-2, 1e-3), fewest)
        for second_order in both
    ]
    more: dict[str, object] = {"elements_1pct": found[0][0], "elements_0.1pct": found[0][1]}
    if terms:
        more |= {"elements_1pct_first_order": found[1][0], "elements_0.1pct_first_order": found[1][1]}
    counts = np.array([np.nan if n is None else n for row in found for n in row], dtype=float)
    text = "elements for 1 %, 0.1 %" + ("; the same without second-order terms" if terms else "")
    return Quantity(f"elements_for_{name}", counts, source=f"{text}: {source}", more=more)
