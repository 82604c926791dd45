"""Ranges of the data to which laws were fitted: which quantities of a motion leave them.

Beyond its data a law is extrapolated as its definition says; the user is warned when this happens.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence

import numpy as np

from flexel.base.errors import RangeWarning
from flexel.derive.spec import LawSpec, LimitSpec
from flexel.engine.kernels import Batch
from flexel.mechanics.core import Core
from flexel.structure.state import State


def outside(system: Core, states: Sequence[State]) -> list[str]:
    """Quantities outside the range of their law's data at a state, with the largest stress and the extrapolation."""
    return [
        line
        for law in system.evaluation.tables.laws
        if isinstance(law.spec, LawSpec) and law.spec.limit
        for line in _outside(system, law, law.spec.limit, states)
    ]


def warn_outside(system: Core, states: Sequence[State]) -> None:
    """Warn, at the caller of the analysis, of every quantity that left the range of its law's data."""
    found = outside(system, states)
    if found:
        warnings.warn("; ".join(found), RangeWarning, stacklevel=4)


def _outside(system: Core, law: Batch, end: LimitSpec, states: Sequence[State]) -> Iterator[str]:
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
