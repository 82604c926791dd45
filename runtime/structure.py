"""The finished list of a model's nodes, elements and quantities, with their names and indices.

Coordinates are ordered free first, fixed last, so that the free columns of every matrix are one slice.
Every deformation, slip and coordinate is one *quantity* with one index in the stacked list
[deformations | slips | coordinates]; roles, loads, inputs and outputs all speak of these indices.
Imports numpy, the errors and the generated tables.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexel.derive.spec import ElementSpec, LawSpec
from flexel.errors import ModelError
from flexel.inputs import array

Array = NDArray[np.float64]
Index = NDArray[np.intp]

COMPONENTS: dict[str, tuple[str, ...]] = {
    "point": ("x", "y", "z"),
    "frame": ("lambda0", "lambda1", "lambda2", "lambda3"),
    "planar_point": ("x", "y"),
    "planar_angle": ("angle",),
    "slope": ("x", "y", "z"),
    "planar_slope": ("x", "y"),
}


@dataclass(frozen=True)
class Node:
    """A node as declared: its kind, its initial coordinates and which of them are fixed."""

    name: str
    kind: str
    x0: Array
    fixed: NDArray[np.bool_]

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Full names of the coordinates, ``node.component``."""
        return tuple(f"{self.name}.{c}" for c in COMPONENTS[self.kind])


@dataclass(frozen=True)
class Instance:
    """One element of the model: a row of the element table between nodes, with its parameters."""

    name: str
    spec: ElementSpec
    nodes: tuple[str, ...]
    parameters: Mapping[str, Array]
    kernels: object = None  # address of a user-defined element's kernels; None: built in
    profile: object = None  # of a beam: its section and material, where given
    mass_damping: float = 0.0  # force per momentum [1/s], the mass-proportional part of Rayleigh damping

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


@dataclass(frozen=True)
class Structure:
    """Index maps of a model; built once, never changed.

    Attributes
    ----------
    x0 : ndarray (n,)
        Initial coordinates as drawn, free ones first.
    n, nf, m, k : int
        Coordinates, free coordinates, deformations, slips.
    names : tuple of str (m + k + n)
        Names of the quantities in the stacked order.
    period : ndarray (m + k + n)
        After which a quantity repeats, zero for none: 2 pi for an angle.
    kinds : tuple of str (m)
        What a deformation is: "gap" of a contact, "norm" of a frame's Euler parameters, or "".
    internal : mapping of str to int
        Names of the laws' internal states z, with their indices in z (nz,); they are no quantities.
    internal_units : tuple of str (nz)
    z0 : ndarray (nz,)
        Their initial values.
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

    @property
    def nz(self) -> int:
        """Number of internal states of laws."""
        return self.z0.size

    @property
    def n(self) -> int:
        """Number of nodal coordinates, fixed ones included."""
        return self.x0.size

    def coordinate(self, i: int) -> int:
        """Quantity index of coordinate i."""
        return self.m + self.k + i

    def find(self, name: str, owner: str = "") -> int:
        """Quantity index of a name; a ModelError with the nearest known names (and the owner) otherwise."""
        if isinstance(name, str) and name in self.index:
            return self.index[name]
        raise ModelError(f"{owner}: " * bool(owner) + unknown(str(name), self.index))

    def is_norm(self, name: str) -> bool:
        """Whether a quantity is the norm of a frame's Euler parameters."""
        i = self.index[name]
        return i < self.m and self.kinds[i] == "norm"

    @cached_property
    def _by_name(self) -> dict[str, Node]:
        return {node.name: node for node in self.nodes}

    def node(self, name: str) -> Node:
        """The node of that name."""
        if name not in self._by_name:
            raise ModelError(unknown(name, self._by_name, "node"))
        return self._by_name[name]

    def places(self, name: str) -> Index:
        """Indices in x of all coordinates of a node."""
        return np.array([self.coordinate_of[c] for c in self.node(name).coordinates], dtype=np.intp)


def unknown(name: str, known: Iterable[str], kind: str = "name") -> str:
    """Message for a name that does not exist, with the nearest ones that do."""
    names = list(known)
    near = difflib.get_close_matches(name, names, n=3, cutoff=0.4)
    same = [z for z in names if z.startswith(name + ".")][:8]
    hint = f"did you mean {', '.join(near or same)}?" if near or same else f"known: {', '.join(names[:12])}"
    return f"unknown {kind} '{name}'; {hint}"


def _periods(instances: Iterable[Instance]) -> Iterator[float]:
    """Of all deformations, with the parameters of their elements."""
    for z in instances:
        yield from (d.repeats(z.parameters) for d in z.spec.deformations)


def assemble_structure(
    nodes: Iterable[Node], instances: Iterable[Instance], laws: Iterable[LawInstance]
) -> Structure:
    """Order the coordinates, number the quantities and check that names are single."""
    nodes, instances, laws = tuple(nodes), tuple(instances), tuple(laws)
    labels = [c for node in nodes for c in node.coordinates]
    values = np.concatenate([node.x0 for node in nodes]) if nodes else np.zeros(0)
    fixed = np.concatenate([node.fixed for node in nodes]) if nodes else np.zeros(0, dtype=bool)
    order = np.argsort(fixed, kind="stable")
    coordinates = [labels[i] for i in order]
    deformations = [d for z in instances for d in z.deformations]
    slips = [s for z in instances for s in z.slips]
    specs = [d for z in instances for d in z.spec.deformations]
    names = (*deformations, *slips, *coordinates)
    kinds = [node.kind for node in nodes for _ in node.coordinates]
    units = [d.unit for d in specs] + [s.unit for z in instances for s in z.spec.slips]
    units += [
        {"frame": "-", "planar_angle": "rad", "slope": "-", "planar_slope": "-"}.get(kinds[i], "m")
        for i in order
    ]
    internal = [z for law in laws for z in law.states]
    index = {name: i for i, name in enumerate(names)}
    for law in laws:
        if clash := next((z for z in law.states if z in index), None):
            raise ModelError(
                f"law '{law.name}': its internal state '{clash}' has the name of a coordinate, deformation or slip of "
                f"'{law.name}'; attach the law by another name"
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
        internal_units=tuple(z.unit for law in laws for z in law.spec.states),
        z0=np.array([z for law in laws for z in law.z0], dtype=float),
    )
