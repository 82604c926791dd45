"""Loads: generalized forces dual to named coordinates, deformations and slips, and the methods of `Model`.

A positive load does positive work when its quantity grows.  On a coordinate it is a nodal force; on a
deformation or slip it is an applied stress of the opposite sign.  Imports numpy and the functions of time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.errors import ModelError
from flexel.functions import Polynomial, TimeFunction, as_function
from flexel.generated.table import ELEMENTS
from flexel.structure import Array, Instance, Node, Structure

if TYPE_CHECKING:
    from flexel.model import Model


@dataclass(frozen=True)
class Load:
    """A generalized force on one quantity, as a function of time."""

    name: str
    function: TimeFunction


class Loads:
    """All loads of a model, summed into nodal forces and applied stresses."""

    def __init__(self, structure: Structure, loads: tuple[Load, ...]) -> None:
        self._size = len(structure.names)
        self._split = structure.m + structure.k
        self._index = np.array([structure.find(load.name) for load in loads], dtype=np.intp)
        self._functions = [load.function for load in loads]
        self._conservative = [isinstance(f, Polynomial) and len(f.coefficients) == 1 for f in self._functions]

    def at(self, t: float, order: int = 0) -> tuple[Array, Array]:
        """Nodal forces f (n,) and applied stresses (m + k,) at time t, or their first or second rates."""
        total = np.zeros(self._size)
        if self._functions:
            np.add.at(total, self._index, [f.rates(t)[order] for f in self._functions])
        return total[self._split :], -total[: self._split]

    def potential(self, t: float, values: Array) -> float:
        """Potential [J] of the constant loads on coordinates and deformations; zero at value zero."""
        U = 0.0
        for i, f, conservative in zip(self._index, self._functions, self._conservative, strict=True):
            if conservative and np.isfinite(values[i]):
                U -= f.rates(t)[0] * float(values[i])
        return U


def load(self: Model, target: Node | str, value: Any, *, follower: bool = False) -> None:
    """Apply a force, moment or generalized force, constant or a function of time.

    Parameters
    ----------
    target : node or name
        A point takes a force vector [N]; a frame a moment vector [N m] about global axes (with
        ``follower=True`` about body axes); a coordinate, deformation or slip a generalized force, positive when
        it does positive work as the quantity grows.
    value : number or function of time, or a sequence of them for a node
    """
    if isinstance(target, str) and "." in target:
        if follower:
            raise ModelError(f"load on '{target}': follower loads act on frames; leave follower out")
        self.loads.append(Load(target, as_function(value, f"load on '{target}'")))
        return
    node = self.node(target, "load")
    owner = f"load on '{node.name}'"
    if follower and node.kind != "frame":
        raise ModelError(f"{owner}: follower loads act on frames, not on a {node.kind}; leave follower out")
    if np.all(node.fixed):
        raise ModelError(f"{owner}: this node is fixed and cannot move; remove load or fixing")
    if node.kind == "frame":
        quantities = [f"{sensor(self, node, follower)}.{w}" for w in ("wx", "wy", "wz")]
    else:
        quantities = list(node.coordinates)
    for quantity, component in zip(quantities, _components(value, len(quantities), owner), strict=True):
        function = as_function(component, owner)
        if function != Polynomial((0.0,)):
            self.loads.append(Load(quantity, function))


def _components(value: Any, size: int, owner: str) -> list[Any]:
    if size == 1 and not isinstance(value, (list, tuple)):
        return [value]
    if not isinstance(value, (list, tuple, np.ndarray)):
        raise ModelError(
            f"{owner}: {value!r} given; it takes a list of {size} components, each a number or a function of time"
        )
    if len(value) != size:
        raise ModelError(f"{owner}: {len(value)} components given; it takes {size}")
    return list(value)


def sensor(self: Model, frame: Node, body_axes: bool) -> str:
    """The element that measures (and so can load) a frame's angular velocity; made when first needed."""
    name = f"{frame.name}.{'body_omega' if body_axes else 'omega'}"
    if name not in self.instances:
        spec = ELEMENTS["body_rotation" if body_axes else "rotation"]
        values = {z.name: np.array([1.0, 0.0, 0.0, 0.0]) for z in spec.parameters}
        self.instances[name] = Instance(name, spec, (frame.name,), values)
    return name


def angular_velocity(self: Model, frame: Node | str, body_axes: bool = False) -> str:
    """Measure a frame's angular velocity; its components are the slips ``<returned name>.wx``, ``wy``, ``wz``."""
    return sensor(self, self.of_kind(frame, ("frame",), "angular_velocity"), body_axes)
