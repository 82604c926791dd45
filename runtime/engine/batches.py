"""Elements and laws of a structure sorted by type, with their compiled kernels and their places in
the global vectors.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.base.errors import FlexelError
from flexel.derive.spec import ElementSpec, LawSpec
from flexel.engine.lanes import LANES, blocks
from flexel.generated._kernels import ffi, lib
from flexel.model.structure import Structure


@dataclass(frozen=True)
class Batch:
    """All elements (or laws) of one type; elements with inertia come first.

    Attributes
    ----------
    spec : ElementSpec or LawSpec
    struct : cffi struct
        Function pointers of the kernels.
    places : dict of str to ndarray of int (elements, rows)
        For each kernel input, the places of its rows in the global vector.
    p : ndarray (elements, np)
        Parameters.
    weight : ndarray (elements,)
        Mass-proportional damping of the elements [1/s].
    members : ndarray of int (elements,)
        Their numbers in the structure.
    heavy : int
        Number of elements with inertia.
    """

    spec: Any
    struct: Any
    places: Mapping[str, Index]
    p: Array
    weight: Array
    members: Index
    n_with_inertia: int = 0

    @property
    def size(self) -> int:
        """Number of elements."""
        return int(self.p.shape[0])

    @property
    def nblocks(self) -> int:
        """Number of blocks of eight elements."""
        return -(-self.size // LANES)

    def parameter(self, name: str) -> Array:
        """Return the values (elements, size) of a parameter."""
        first = 0
        for parameter in self.spec.parameters:
            if parameter.name == name:
                return self.p[:, first : first + parameter.size]
            first += parameter.size
        raise KeyError(name)

    @property
    def varies(self) -> bool:
        """Whether the mass matrix or the body force of an element depends on its position.

        h vanishes identically if and only if M is constant.
        """
        kernels = self.spec.kernels
        outputs = {out.name: out for kind in ("inertia", "tangent") for out in kernels[kind].outputs}
        return any(outputs[name].nonzeros for name in ("h", "R_x", "R_v"))

    def taken(self, order: Index, n_with_inertia: int) -> Batch:
        """Return the same elements in another order, those with inertia first."""
        places = {name: rows[order] for name, rows in self.places.items()}
        own = {name: getattr(self, name)[order] for name in ("p", "weight", "members")}
        return replace(self, places=places, n_with_inertia=n_with_inertia, **own)


def kernel_struct(spec: ElementSpec | LawSpec, address: object) -> Any:
    """Return the C table of function pointers of a built-in (by name) or user-defined (by address) type."""
    law = isinstance(spec, LawSpec)
    if address is None:
        struct = getattr(lib, f"flexel_law_{spec.name}" if law else f"flexel_{spec.name}")
    else:
        struct = ffi.cast("flexel_law *" if law else "flexel_element *", address)[0]
    if ffi.string(struct.digest).decode() != spec.digest:
        raise FlexelError(
            f"the compiled kernels of '{spec.name}' do not match generated/table.py; compile them "
            "again: pip install -e . (or make test)"
        )
    return struct


def element_batches(structure: Structure) -> list[Batch]:
    """Collect the elements of each type, with the indices of their coordinates, deformations and slips."""
    groups: dict[tuple[str, object], list[int]] = defaultdict(list)
    for number, instance in enumerate(structure.instances):
        if instance.terms is None:  # a relation has no kernels
            groups[instance.spec.name, instance.kernels].append(number)
    found = []
    for numbers in groups.values():
        members = [structure.instances[i] for i in numbers]
        x = np.array([np.concatenate([structure.places(node) for node in i.nodes]) for i in members])
        sigma = _indices([[structure.index[name] for name in i.deformations] for i in members])
        tau = _indices([[structure.index[name] - structure.m for name in i.slips] for i in members])
        spec = members[0].spec
        struct = kernel_struct(spec, members[0].kernels)
        weight = np.array([i.mass_damping for i in members], dtype=float)
        places, p = {"x": x, "sigma": sigma, "tau": tau}, np.array([i.p for i in members])
        batch = Batch(spec, struct, places, p, weight, np.array(numbers, dtype=np.intp))
        found.append(_heavy_first(batch, structure, members[0].kernels is not None))
    return found


def law_batches(structure: Structure) -> list[Batch]:
    """Collect the laws of each type, with the indices of the quantities on which they act."""
    groups: dict[tuple[str, object], list[int]] = defaultdict(list)
    for number, law in enumerate(structure.laws):
        groups[law.spec.name, law.kernels].append(number)
    found = []
    for numbers in groups.values():
        members = [structure.laws[i] for i in numbers]
        e = _indices([[structure.index[name] for name in i.deformations] for i in members])
        s = _indices([[structure.index[name] for name in i.slips] for i in members])
        z = _indices([[structure.internal[name] for name in i.states] for i in members])
        spec = members[0].spec
        struct = kernel_struct(spec, members[0].kernels)
        none, p = np.zeros(len(members)), np.array([i.p for i in members])
        own = np.array(numbers, dtype=np.intp)
        found.append(Batch(spec, struct, {"e": e, "s": s, "z": z}, p, none, own))
    return found


def _heavy_first(batch: Batch, structure: Structure, own: bool) -> Batch:
    """Sort the batch so that elements with mass come first; those of users' types count as such.

    Inertia of the built-in types is proportional to their masses; if it vanishes anywhere, it vanishes everywhere.
    """
    if "inertia" not in batch.spec.kernels:
        return batch
    n_with_inertia = np.ones(batch.size, dtype=bool) if own else has_inertia(batch, structure)
    return batch.taken(np.argsort(~n_with_inertia, kind="stable"), int(n_with_inertia.sum()))


def has_inertia(batch: Batch, structure: Structure) -> Any:
    """Whether the inertia kernel of each element gives anything but zeros."""
    rng = np.random.default_rng(1)
    x, v = structure.x0 + 0.1 * rng.standard_normal(structure.n), rng.standard_normal(structure.n)
    kernel = batch.spec.kernels["inertia"]
    ins = [blocks(values) for values in (x[batch.places["x"]], v[batch.places["x"]], batch.p)]
    outs = [np.zeros((batch.nblocks, len(out.nonzeros), LANES)) for out in kernel.outputs]
    batch.struct.inertia(batch.nblocks, *pointers(ins, outs))
    some: Any = (
        np.concatenate([(values != 0).any(axis=1) for values in outs]).reshape(len(outs), -1).any(axis=0)
    )
    return some[: batch.size]


def pointers(ins: Sequence[Array], outs: Sequence[Array]) -> tuple[Any, Any]:
    """Return a kernel's arguments after its number of blocks; valid as long as they and the arrays are kept."""
    given, found = ([ffi.cast("double *", array.ctypes.data) for array in part] for part in (ins, outs))
    return ffi.new("const double *const[]", given), ffi.new("double *[]", found)


def _indices(rows: Sequence[Sequence[int]]) -> Index:
    return np.array(rows, dtype=np.intp).reshape(len(rows), -1)
