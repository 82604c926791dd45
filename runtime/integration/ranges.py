"""Ranges of the data that laws were fitted to: which quantities of a motion have left them.

A law goes on beyond its data as its definition says; whoever trusts the result should know that it did.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from flexel.base.errors import RangeWarning
from flexel.mechanics.core import Core

if TYPE_CHECKING:
    from flexel.engine.assembly import Batch
    from flexel.structure.state import State

# law: the parameter, and its entry, that is the largest stress of the law's first deformation in its data; and what
# the law does beyond
LARGEST_STRESS = {"calspan_tyre": ("A", 2, "friction and stiffnesses keep their values beyond")}


def outside(system: Core, states: Sequence[State]) -> list[str]:
    """What left the range of its law's data at a state, each with the largest stress and what the law does there."""
    return [
        line
        for law in system.evaluation.laws
        if law.spec.name in LARGEST_STRESS
        for line in _outside(system, law, states)
    ]


def warn_outside(system: Core, states: Sequence[State]) -> None:
    """Warn of everything that left the range of its law's data, at the place that called the analysis."""
    found = outside(system, states)
    if found:
        warnings.warn("; ".join(found), RangeWarning, stacklevel=4)


def _outside(system: Core, law: Batch, states: Sequence[State]) -> Iterator[str]:
    name, quantities = law.spec.name, law.inputs["e"][:, 0]
    parameter, entry, beyond = LARGEST_STRESS[name]
    limits = law.parameter(parameter)[:, entry]
    histories = np.array([state.stresses[quantities] for state in states]).T
    for quantity, limit, history in zip(quantities, limits, histories, strict=True):
        worst = int(np.argmax(history))
        if history[worst] > limit:
            yield (
                f"{system.structure.names[quantity]}: {history[worst]:.0f} N at t = {states[worst].t:g} s, data of the "
                f"{name} end at {limit:.0f} N; {beyond}"
            )
