"""Elements and laws of a structure sorted by type into batches, with their places in the global vectors.

Imports numpy and the assembly.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from flexel.assembly import Batch, kernel_struct
from flexel.structure import Index, Instance, LawInstance, Structure


def element_batches(structure: Structure) -> list[Batch]:
    """The elements of each type, with the places of their coordinates, deformations and slips."""
    groups: dict[tuple[str, object], list[Instance]] = defaultdict(list)
    for instance in structure.instances:
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
    """The laws of each type, with the places of what they act on."""
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


def _indices(rows: Sequence[Sequence[int]]) -> Index:
    return np.array(rows, dtype=np.intp).reshape(len(rows), -1)
