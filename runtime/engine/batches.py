"""Elements and laws of a structure sorted by type into batches, with their places in the global vectors."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.assembly import Batch, Place, Stage, kernel_struct
from flexel.structure.instances import Instance, LawInstance
from flexel.structure.structure import Structure


def element_batches(structure: Structure) -> list[Batch]:
    """The elements of each type, with the places of their coordinates, deformations and slips."""
    groups: dict[tuple[str, object], list[Instance]] = defaultdict(list)
    for instance in structure.instances:
        if instance.terms is not None:  # a relation has no kernels
            continue
        groups[instance.spec.name, instance.kernels].append(instance)
    batches = []
    for members in groups.values():
        x = np.array([np.concatenate([structure.places(z) for z in i.nodes]) for i in members])
        sigma = _indices([[structure.index[z] for z in i.deformations] for i in members])
        tau = _indices([[structure.index[z] - structure.m for z in i.slips] for i in members])
        spec = members[0].spec
        struct = kernel_struct(spec, members[0].kernels)
        inputs = {"x": x, "v": x, "a": x, "sigma": sigma, "tau": tau}
        weight = np.array([i.mass_damping for i in members])
        batches.append(Batch(spec, struct, inputs, np.array([i.p for i in members]), weight))
    return batches


def law_batches(structure: Structure) -> list[Batch]:
    """The laws of each type, with the places of the quantities on which they act."""
    groups: dict[tuple[str, object], list[LawInstance]] = defaultdict(list)
    for law in structure.laws:
        groups[law.spec.name, law.kernels].append(law)
    batches = []
    for members in groups.values():
        e = _indices([[structure.index[z] for z in i.deformations] for i in members])
        s = _indices([[structure.index[z] - structure.m for z in i.slips] for i in members])
        z = _indices([[structure.internal[z] for z in i.states] for i in members])
        inputs = {"e": e, "ed": e, "s": s, "z": z, "t": np.zeros((len(members), 1), dtype=np.intp)}
        spec = members[0].spec
        struct = kernel_struct(spec, members[0].kernels)
        batches.append(Batch(spec, struct, inputs, np.array([i.p for i in members])))
    return batches


def with_inertia(batches: Sequence[Batch], structure: Structure) -> list[Batch]:
    """The elements that have mass: those of built-in types with zero mass are omitted.

    Inertia of the built-in types is proportional to their masses; if it vanishes anywhere, it vanishes everywhere.
    """
    rng = np.random.default_rng(1)
    x, v = structure.x0 + 0.1 * rng.standard_normal(structure.n), rng.standard_normal(structure.n)
    own = {i.spec.name for i in structure.instances if i.kernels is not None}
    found = []
    for batch in batches:
        some = np.ones(batch.size, dtype=bool) if batch.spec.name in own else _has_inertia(batch, x, v)
        if some.all():
            found.append(batch)
        elif some.any():
            inputs = {name: index[some] for name, index in batch.inputs.items()}
            weight = None if batch.weight is None else batch.weight[some]
            found.append(replace(batch, inputs=inputs, p=batch.p[some], weight=weight))
    return found


def _has_inertia(batch: Batch, x: Array, v: Array) -> Array:
    """Whether the inertia kernel of each element gives anything but zeros."""
    n, size = batch.inputs["x"].shape[1], batch.size
    sizes = {"M": n * n, "h": n, "f": n, "U": 1}

    def place(_: Batch, name: str) -> Place:
        return Place(name, (size, sizes[name]), np.arange(size * sizes[name]).reshape(size, -1), False)

    stage = Stage([batch], "inertia", place)
    stage.run(x=x, v=v)
    values = [stage.flat(name, size * rows).reshape(size, rows) for name, rows in sizes.items()]
    return np.asarray(np.concatenate(values, axis=1).any(axis=1))


def _indices(rows: Sequence[Sequence[int]]) -> Index:
    return np.array(rows, dtype=np.intp).reshape(len(rows), -1)
