"""Elements and laws of a model: a row of the table with its nodes or quantities and its parameters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import array
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.derive.spec import ElementSpec, LawSpec


@dataclass(frozen=True)
class Instance:
    """One element of the model: a row of the element table between nodes, with its parameters."""

    name: str
    spec: ElementSpec
    nodes: tuple[str, ...]
    parameters: Mapping[str, Array]
    kernels: object = None  # address of a user-defined element's kernels; None: built in
    profile: object = None  # section and material of a beam, if given
    mass_damping: float = 0.0  # force per momentum [1/s], the mass-proportional part of Rayleigh damping
    terms: Mapping[str, float] | None = None  # coefficients of a relation, by quantity

    @property
    def p(self) -> Array:
        """Parameters flattened in the order that the kernels expect."""
        return flatten(self.parameters, self.spec.parameters, f"{self.spec.name} '{self.name}'")

    @property
    def deformations(self) -> tuple[str, ...]:
        """Full names of the generalized deformations, ``element.deformation``."""
        return tuple(f"{self.name}.{d.name}" for d in self.spec.deformations)

    @property
    def slips(self) -> tuple[str, ...]:
        """Full names of the generalized slips, ``element.slip``."""
        return tuple(f"{self.name}.{s.name}" for s in self.spec.slips)


@dataclass(frozen=True)
class LawInstance:
    """A law attached to named deformations and slips, with the initial values of its internal states."""

    name: str
    spec: LawSpec
    deformations: tuple[str, ...]
    slips: tuple[str, ...]
    parameters: Mapping[str, Array]
    kernels: object = None
    z0: tuple[float, ...] = ()

    @property
    def p(self) -> Array:
        """Parameters flattened in the order that the kernels expect."""
        return flatten(self.parameters, self.spec.parameters, f"law '{self.name}'")

    @property
    def states(self) -> tuple[str, ...]:
        """Full names of the internal states, ``law.state``."""
        return tuple(f"{self.name}.{z.name}" for z in self.spec.states)


def flatten(values: Mapping[str, Array], specs: Iterable[object], owner: str) -> Array:
    """Parameter values joined in the order of their specifications, sizes checked."""
    parts: list[Array] = []
    for spec in specs:
        name, size = spec.name, spec.size  # type: ignore[attr-defined]
        value = array(values[name], owner, f"parameter {name}").ravel()
        if value.size != size:
            raise ModelError(f"{owner}: parameter {name} has {value.size} numbers; it needs {size}")
        parts.append(value)
    return np.concatenate(parts) if parts else np.zeros(0)
