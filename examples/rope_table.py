"""Rows of the table of rope problems: errors on successively doubled meshes, with the observed order of convergence."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flexel.examples.convergence import order
from flexel.results.reproduction import Kind, Quantity


def over_meshes(
    name: str,
    error: Callable[[int], float],
    meshes: Sequence[int],
    tolerance: float,
    source: str,
    stepped: int = 0,
    kind: Kind = "closed form",
) -> Quantity:
    """Return the row of a relative error on the finest of some meshes that double, with the observed order.

    Where the meshes count steps, `stepped` is the number of elements that are integrated with them.
    """
    errors = [error(n) for n in meshes]
    finest = {"elements": stepped, "steps": meshes[-1]} if stepped else {"elements": meshes[-1]}
    more = {**finest, "order": order(errors), "meshes": list(meshes), "errors": errors}
    return Quantity(name, errors[-1], 0.0, tolerance, "", source, more, kind=kind)
