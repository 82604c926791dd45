"""Whether the user's functions of time still give what they gave when a motion was computed.

States between the stored ones are computed when they are asked for, with loads and prescribed motions as they are then.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.time_functions import calls_user

if TYPE_CHECKING:
    from flexel.integration.outcome import Segment

COMPARED = 5  # times at which values are compared
Given = list[tuple[float, list[tuple[float, float, float]]]]  # times, and what each function gives


def given_in(segments: Sequence[Segment], times: Array) -> Given:
    """What the functions give at some stored times; empty where they cannot change, or there is no dense output."""
    if not segments or not any(map(calls_user, segments[0].kinematics.time_functions)):
        return []
    some = times[np.unique(np.linspace(0, times.size - 1, COMPARED).astype(int))]
    return [(float(t), [f.rates(float(t)) for f in segments[0].kinematics.time_functions]) for t in some]


def check_given(segments: Sequence[Segment], given: Given) -> None:
    """Check that the functions give the same.

    Raises
    ------
    ModelError
        If one does not; names it.
    """
    for t, values in given:
        for function, before in zip(segments[0].kinematics.time_functions, values, strict=True):
            now = function.rates(t)
            if now != before:
                owner = getattr(function, "owner", "function of time")
                raise ModelError(
                    f"motion.at: {owner} has changed since the motion was computed ({before[0]:g} then, {now[0]:g} now "
                    f"at t = {t:g} s); simulate again, and give the times to store"
                )
