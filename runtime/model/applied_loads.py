"""Loads: generalized forces dual to named coordinates, deformations and slips.

A positive load does positive work when its quantity grows.  On a coordinate it is a nodal force; on a
deformation or slip it is an applied stress of the opposite sign.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.time_functions import Polynomial, TimeFunction, rate_of, steady, time_scaled, value_of
from flexel.model.structure import Structure


@dataclass(frozen=True)
class Load:
    """A generalized force on one quantity, as a function of time."""

    name: str
    function: TimeFunction


class Loads:
    """All loads of a model, summed into nodal forces and applied stresses."""

    def __init__(self, structure: Structure, loads: tuple[Load, ...]) -> None:
        self._given = structure, loads
        self._size = len(structure.names)
        self._split = structure.m + structure.k
        self._slips = range(structure.m, self._split)
        self._index = np.array([structure.find(load.name) for load in loads], dtype=np.intp)
        self._functions = [load.function for load in loads]
        self.steady = all(map(steady, self._functions))  # within one step: nothing varies with time
        self._conservative = [isinstance(f, Polynomial) and len(f.coefficients) == 1 for f in self._functions]

    def time_scaled(self, factor: float) -> Loads:
        """Return the same loads, running `factor` times as fast."""
        structure, loads = self._given
        return Loads(structure, tuple(Load(load.name, time_scaled(load.function, factor)) for load in loads))

    def with_others(self, others: Iterable[Load]) -> Loads:
        """Return these loads, followed by others."""
        structure, loads = self._given
        return Loads(structure, (*loads, *others))

    @property
    def any(self) -> bool:
        """Whether there are any loads."""
        return bool(self._functions)

    @property
    def functions(self) -> tuple[TimeFunction, ...]:
        """The loads as functions of time."""
        return tuple(self._functions)

    @property
    def quantities(self) -> Index:
        """The quantity (loads,) on which each load acts."""
        return self._index

    @property
    def constant(self) -> bool:
        """Whether no load changes with time."""
        return all(self._conservative)

    def values(self, t: float) -> Array:
        """Return the loads (loads,) at time t."""
        return np.array(self.listed(t))

    def listed(self, t: float) -> list[float]:
        """Return the loads at time t as a list."""
        return [value_of(f, t) for f in self._functions]

    def at(self, t: float) -> tuple[Array, Array]:
        """Return nodal forces f (n,) and applied stresses (m + k,) at time t."""
        return self._summed([value_of(f, t) for f in self._functions])

    def rates(self, t: float) -> tuple[Array, Array]:
        """Return the rates of the nodal forces (n,) and of the applied stresses (m + k,) at time t."""
        return self._summed([rate_of(f, t) for f in self._functions])

    def _summed(self, values: list[float]) -> tuple[Array, Array]:
        total = np.zeros(self._size)
        np.add.at(total, self._index, values)
        return total[self._split :], -total[: self._split]

    def power(self, t: float, rates: Array) -> float:
        """Return the power [W] of the loads that have no potential, at given rates of all quantities (m + k + n,)."""
        P = 0.0
        for i, f, conservative in zip(self._index, self._functions, self._conservative, strict=True):
            if not conservative or i in self._slips:
                P += value_of(f, t) * float(rates[i])
        return P

    def potential(self, t: float, values: Array) -> float:
        """Return the potential [J] of the constant loads on coordinates and deformations; zero at value zero."""
        U = 0.0
        for i, f, conservative in zip(self._index, self._functions, self._conservative, strict=True):
            if conservative and np.isfinite(values[i]):
                U -= value_of(f, t) * float(values[i])
        return U
