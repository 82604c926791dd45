"""Ranges of the data to which laws were fitted: which quantities of a motion leave them.

Beyond its data a law is extrapolated as its definition says; the user is warned when this happens.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from flexel.derive.spec import LawSpec, LimitSpec
from flexel.engine.batches import Batch
from flexel.model.state import State
from flexel.system import CoreSystem


def outside(system: CoreSystem, states: Sequence[State]) -> list[str]:
    """Report quantities outside the range of their law's data, with the largest stress and the extrapolation."""
    return [
        line
        for law in system.evaluation.tables.laws
        if isinstance(law.spec, LawSpec) and law.spec.limit
        for line in _outside(system, law, law.spec.limit, states)
    ]


def _outside(system: CoreSystem, law: Batch, end: LimitSpec, states: Sequence[State]) -> Iterator[str]:
    name, quantities = law.spec.name, law.places["e"][:, 0]
    limits = law.parameter(end.parameter)[:, end.component]
    histories = np.array([state.stresses[quantities] for state in states]).T
    for quantity, limit, history in zip(quantities, limits, histories, strict=True):
        worst = int(np.argmax(history))
        if history[worst] > limit:
            yield (
                f"{system.structure.names[quantity]}: {history[worst]:.0f} N at t = {states[worst].t:g} s, data of the "
                f"{name} end at {limit:.0f} N; {end.beyond}"
            )
