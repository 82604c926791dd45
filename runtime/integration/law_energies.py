"""Laws of the user whose energy does not match their stress: they give back energy that they do not count as stored."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arrays import Array
from flexel.derive.spec import LawSpec
from flexel.engine.batches import Batch
from flexel.engine.workspace import Workspace
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure
from flexel.system import CoreSystem

WRONG = 1e-6  # power that is given back, relative to that of the stress, from which an energy is wrong
ROUNDED = 1e-3  # of the kinetic energy over the motion, as a power: less than this may be rounding
LATER = 0.38196601125  # parts of the motion by which time is moved, to find laws that depend on it


def wrong_energies(system: CoreSystem, moments: Sequence[tuple[Snapshot, Array]]) -> list[str]:
    """Report users' laws of one deformation whose declared energy does not fit their stress.

    Dissipation takes power out in both directions of a motion.  What a law takes in one direction and gives back in
    the other is stored; if its energy does not count that, it is wrong.  Laws that depend on time may do so.

    Parameters
    ----------
    system : CoreSystem
    moments : sequence of (Snapshot, ndarray)
        Some instants of a motion, and the internal states there.
    """
    tables = system.evaluation.tables
    some = [(i, b) for i, b in enumerate(tables.laws) if _is_elastic(system.structure, b)]
    if not some:
        return []
    work = Workspace(tables)
    span = moments[-1][0].t - moments[0][0].t
    found: dict[str, str] = {}
    least = ROUNDED * _kinetic(work, moments) / span if span else 0.0
    for at, z in moments:
        U, P, stress = _powers(work, at, z, at.t, 1.0)
        back = _powers(work, at, z, at.t, -1.0)[1]
        later = _powers(work, at, z, at.t + LATER * span, 1.0)[2]
        for i, b in some:
            numbers = tables.law.first[i] + np.arange(b.size)
            rows = b.places["e"][:, 0]
            size = np.maximum(np.abs(stress[rows] * at.ed[rows]), least)
            both = np.array([P[numbers], back[numbers]])
            wrong = (both.min(axis=0) < -WRONG * size) & (both.max(axis=0) > WRONG * size)
            for k in np.flatnonzero(wrong & (stress[rows] == later[rows]) & (U[numbers] != 0)):
                law = system.structure.laws[b.members[k]]
                power = float(np.abs(both[:, k]).max())
                found.setdefault(
                    law.name,
                    f"the energy of law '{law.name}' on '{law.deformations[0]}' is not that of its stress: of "
                    f"{size[k]:.3g} W at t = {at.t:.6g} s, {power:.3g} W are stored but not counted, so "
                    "motion.energy is wrong by that much; correct the energy of the law",
                )
    return list(found.values())


def _kinetic(work: Workspace, moments: Sequence[tuple[Snapshot, Array]]) -> float:
    """Return the largest kinetic energy [J] at some instants."""
    found = []
    for at, _ in moments:
        work.x[:], work.v[:], work.unwrap_from[:], work.a[:] = at.x, at.v, at.e, 0.0
        work.position()
        work.inertia()
        found.append(work.state()[1][0])
    return max(found)


def _is_elastic(structure: Structure, b: Batch) -> bool:
    """Whether laws are by the user, act on one deformation, and have no internal states."""
    one = b.places["e"].shape[1] == 1 and not b.places["s"].shape[1] and not b.places["z"].shape[1]
    return one and isinstance(b.spec, LawSpec) and structure.laws[b.members[0]].code is not None


def _powers(work: Workspace, at: Snapshot, z: Array, t: float, factor: float) -> tuple[Array, Array, Array]:
    """Return energies and powers (laws,), and stresses (m + k,), at a time, with the rates times a factor."""
    work.struct.t = t
    work.x[:], work.v[:], work.unwrap_from[:], work.z[:] = at.x, factor * at.v, at.e, z
    work.position()
    work.rates()
    work.laws()
    return work.law_U.copy(), work.law_P.copy(), work.law_stress.copy()
