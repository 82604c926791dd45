"""The finished list of a model's nodes, elements and quantities, with their names and indices.

Coordinates are ordered free first, fixed last, so that the free columns of every matrix are one slice.
Every deformation, slip and coordinate is one *quantity* with one index in the stacked list
[deformations | slips | coordinates]; roles, loads, inputs and outputs all refer to these indices.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array, Index
from flexel.base.copies import Constant
from flexel.base.errors import ModelError
from flexel.model.controller import Controller
from flexel.model.instances import Instance, LawInstance, arm_name
from flexel.model.node import Node, unknown_quantity
from flexel.model.relation_matrix import Relations, find_relations


@dataclass(frozen=True)
class Structure(Constant):
    """Index maps of a model; immutable.

    Attributes
    ----------
    x0 : ndarray (n,)
        Initial coordinates as drawn, free ones first.
    n, nf, m, k : int
        Coordinates, free coordinates, deformations, slips.
    names : tuple of str (m + k + n)
        Names of the quantities in the stacked order.
    period : ndarray (m + k + n)
        Period of a quantity: 2 pi for an angle, zero if it is not periodic.
    kinds : tuple of str (m)
        Kind of a deformation: "gap" of a contact, "norm" of a frame's Euler parameters, or "".
    internal : mapping of str to int
        Names of the laws' internal states z, with their indices in z (nz,); they are not quantities.
    internal_units : tuple of str (nz)
    z0 : ndarray (nz,)
        Their initial values.
    controllers : tuple of Controller
        None in a structure from a file.
    """

    nodes: tuple[Node, ...]
    instances: tuple[Instance, ...]
    laws: tuple[LawInstance, ...]
    x0: Array
    nf: int
    names: tuple[str, ...]
    units: tuple[str, ...]
    period: Array
    kinds: tuple[str, ...]
    coordinate_of: Mapping[str, int]
    m: int
    k: int
    index: Mapping[str, int] = field(repr=False)
    internal: Mapping[str, int] = field(repr=False)
    internal_units: tuple[str, ...] = field(repr=False)
    z0: Array = field(repr=False)
    relations: Relations = field(repr=False)
    controllers: tuple[Controller, ...] = field(default=(), repr=False)

    @property
    def nz(self) -> int:
        """Number of internal states of laws."""
        return self.z0.size

    @property
    def n(self) -> int:
        """Number of nodal coordinates, fixed ones included."""
        return self.x0.size

    def coordinate(self, i: int) -> int:
        """Return the quantity index of coordinate i."""
        return self.m + self.k + i

    def find(self, name: str, owner: str = "") -> int:
        """Return the quantity index of a name; raise a ModelError with near names (and the owner) otherwise."""
        if isinstance(name, str) and name in self.index:
            return self.index[name]
        message = unknown_quantity(str(name), self.index, self._by_name)
        raise ModelError(f"{owner}: " * bool(owner) + message)

    @cached_property
    def added(self) -> frozenset[str]:
        """Coordinates of the points that joints add to bodies, and deformations of the links that hold these."""
        ends = [(instance.nodes[-1], instance) for instance in self.instances if instance.nodes]
        arms = {node: instance for node, instance in ends if instance.name == arm_name(node)}
        places = (name for node in self.nodes if node.name in arms for name in node.coordinates)
        return frozenset({*places, *(name for arm in arms.values() for name in arm.deformations)})

    def is_norm(self, name: str) -> bool:
        """Whether a quantity is the norm of a frame's Euler parameters."""
        i = self.index[name]
        return i < self.m and self.kinds[i] == "norm"

    @cached_property
    def kinked(self) -> tuple[int, ...]:
        """Deformations whose derivatives may jump within a motion: they cannot be degrees of freedom."""
        specs = [d for instance in self.instances for d in instance.spec.deformations]
        return tuple(i for i, d in enumerate(specs) if d.kinked)

    @cached_property
    def touching(self) -> Index:
        """Deformations that are heights of contacts which are never lost."""
        return np.flatnonzero([kind == "touch" for kind in self.kinds])

    @cached_property
    def wheels(self) -> tuple[tuple[Instance, ...], Array]:
        """Elements that keep their last node on a road below their first; the matrix gives these heights from x."""
        named = {"axle", "normal"}
        rolling = (one for one in self.instances if named <= one.parameters.keys())
        some = tuple(one for one in rolling if any(d.kind == "touch" for d in one.spec.deformations))
        heights = np.zeros((len(some), self.n))
        for row, one in zip(heights, some, strict=True):
            for node, sign in ((one.nodes[0], 1.0), (one.nodes[-1], -1.0)):
                row[self.places(node)] += sign * one.parameters["normal"]
        return some, heights

    @property
    def has_user_code(self) -> bool:
        """Whether elements or laws are evaluated by code that was compiled for the user."""
        return any(owner.code is not None for owner in (*self.instances, *self.laws))

    @cached_property
    def commands(self) -> Mapping[str, tuple[Controller, int]]:
        """Outputs of continuous controllers by name, which are computed; those of sampled ones are internal states."""
        some = [c for c in self.controllers if c.period is None]
        return {name: (c, i) for c in some for i, name in enumerate(c.shown)}

    @cached_property
    def _by_name(self) -> dict[str, Node]:
        return {node.name: node for node in self.nodes}

    def node(self, name: str) -> Node:
        """Return the node of that name."""
        if not isinstance(name, str) or name not in self._by_name:
            raise ModelError(unknown(str(name), self._by_name, "node"))
        return self._by_name[name]

    @cached_property
    def _elements(self) -> dict[str, Instance]:
        return {instance.name: instance for instance in self.instances}

    def element(self, name: str) -> Instance:
        """Return the element of that name."""
        if not isinstance(name, str) or name not in self._elements:
            raise ModelError(unknown(str(name), self._elements, "element"))
        return self._elements[name]

    def places(self, name: str) -> Index:
        """Return the indices in x of all coordinates of a node."""
        return np.array([self.coordinate_of[c] for c in self.node(name).coordinates], dtype=np.intp)


def _periods(instances: Iterable[Instance]) -> Iterator[float]:
    """Yield the periods of all deformations, from the parameters of their elements; zero for those without one."""
    for instance in instances:
        yield from (d.repeats(instance.parameters) for d in instance.spec.deformations)


def assemble_structure(
    nodes: Iterable[Node],
    instances: Iterable[Instance],
    laws: Iterable[LawInstance],
    controllers: Iterable[Controller] = (),
) -> Structure:
    """Order the coordinates, number the quantities and check that names are unique."""
    nodes, instances, laws = tuple(nodes), tuple(instances), tuple(laws)
    labels = [c for node in nodes for c in node.coordinates]
    values = np.concatenate([node.x0 for node in nodes]) if nodes else np.zeros(0)
    fixed = np.concatenate([node.fixed for node in nodes]) if nodes else np.zeros(0, dtype=bool)
    order = np.argsort(fixed, kind="stable")
    coordinates = [labels[i] for i in order]
    deformations = [d for instance in instances for d in instance.deformations]
    slips = [s for instance in instances for s in instance.slips]
    specs = [d for instance in instances for d in instance.spec.deformations]
    names = (*deformations, *slips, *coordinates)
    own_units = [node.unit for node in nodes for _ in node.coordinates]
    units = [d.unit for d in specs] + [s.unit for instance in instances for s in instance.spec.slips]
    units += [own_units[i] for i in order]
    internal = [name for law in laws for name in law.states]
    index = {name: i for i, name in enumerate(names)}
    for law in laws:
        if clash := next((name for name in law.states if name in index), None):
            raise ModelError(
                f"law '{law.name}': its internal state '{clash}' has the same name as a coordinate, "
                f"deformation or slip of '{law.name}'; attach the law under another name"
            )
    return Structure(
        nodes=nodes,
        instances=instances,
        laws=laws,
        x0=values[order],
        nf=int(np.sum(~fixed)),
        names=names,
        units=tuple(units),
        period=np.array([*_periods(instances), *[0.0] * (len(slips) + len(coordinates))]),
        kinds=tuple(d.kind for d in specs),
        coordinate_of={name: i for i, name in enumerate(coordinates)},
        m=len(deformations),
        k=len(slips),
        index=index,
        internal={name: i for i, name in enumerate(internal)},
        internal_units=tuple(state.unit for law in laws for state in law.spec.states),
        z0=np.array([value for law in laws for value in law.z0], dtype=float),
        relations=find_relations(instances, index, len(names)),
        controllers=tuple(controllers),
    )


def declared(names: Iterable[str], added: frozenset[str]) -> list[str]:
    """Return the names without those that were added to what was declared; all, if no others are left."""
    names = list(names)
    return [name for name in names if name not in added] or names
