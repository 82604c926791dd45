"""Checks that the user's functions of time still return the values that they had when a motion was computed.

States between the stored ones are computed on request, with the loads and prescribed motions of that moment.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.time_functions import calls_user, value_of

if TYPE_CHECKING:
    from flexel.integration.segments import Segment

COMPARED = 5  # times at which values are compared
Given = list[tuple[float, list[float]]]  # times, and the values of each function


def given_in(segments: Sequence[Segment], times: Array) -> Given:
    """Return the values of the functions at some stored times; empty if they cannot change, or without dense output."""
    if not segments or not any(map(calls_user, segments[0].kinematics.time_functions)):
        return []
    some = times[np.unique(np.linspace(0, times.size - 1, COMPARED).astype(int))]
    return [(float(t), [value_of(f, float(t)) for f in segments[0].kinematics.time_functions]) for t in some]


def check_given(segments: Sequence[Segment], given: Given) -> None:
    """Check that the functions return the same values.

    Raises
    ------
    ModelError
        If one does not; names it.
    """
    for t, values in given:
        for function, before in zip(segments[0].kinematics.time_functions, values, strict=True):
            now = value_of(function, t)
            if now != before:
                owner = getattr(function, "owner", "function of time")
                raise ModelError(
                    f"motion.at: {owner} has changed since the motion was computed ({before:g} then, {now:g} now "
                    f"at t = {t:g} s); simulate again, and give the times to store"
                )
