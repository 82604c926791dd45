"""Ends steps of an explicit method where contacts begin and end: forces are not smooth there."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.near import rope_gaps
from flexel.engine.tables import Tables
from flexel.structure.moment import Moment

CLOSE = (
    0.01  # share of a step, at its ends, in which a contact may begin or end: its error is of a higher order
)
TRIALS = 8  # of one step


class Touching:
    """Finds where a gap changes its sign within a step.

    The estimates of the error of a step hold for smooth forces.  Those of a contact have a finite order at the
    instant at which it begins or ends, and the error may be much larger than the estimate.  So a step ends there.
    The contacts of ropes are left out: their neighbours hold them, and forces change little where one of them begins.

    Parameters
    ----------
    tables : Tables

    Attributes
    ----------
    rows : ndarray of int
        Deformations that are gaps.
    """

    def __init__(self, tables: Tables) -> None:
        gaps = np.flatnonzero(np.array(tables.structure.kinds) == "gap")
        self.rows = np.setdiff1d(gaps, rope_gaps(tables))

    def until(self, first: Moment, e: Array, h: float) -> float:
        """The step [s] up to the first contact that begins or ends within a step; zero if there is none.

        Parameters
        ----------
        first : Moment
            At the beginning of the step.
        e : ndarray
            Deformations at its end.
        h : float
            Its length [s].
        """
        if not self.rows.size:
            return 0.0
        g0, g1, r0 = first.e[self.rows], e[self.rows], first.ed[self.rows]
        shares = [
            _root(*(float(v) for v in gap))
            for gap in zip(g0, h * r0, g1 - g0 - h * r0, strict=True)
            if gap[0] * (gap[0] + gap[1] + gap[2]) < 0
        ]
        share = min((s for s in shares if s > CLOSE), default=1.0)
        return h * share if share < 1 - CLOSE else 0.0


def _root(g: float, rate: float, bend: float) -> float:
    """The first zero between 0 and 1 of g + rate s + bend s², which has opposite signs there."""
    q = -(rate + np.copysign(np.sqrt(max(rate * rate - 4 * bend * g, 0.0)), rate)) / 2
    roots = [g / q if q else 1.0, q / bend if bend else 1.0]
    return float(min((s for s in roots if 0 < s <= 1), default=1.0))
