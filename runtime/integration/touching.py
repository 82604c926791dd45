"""Ends steps of an explicit method where contacts, stops and tyres begin and end to act."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.contact_selection import every_gap
from flexel.engine.tables import Tables
from flexel.model.snapshot import Snapshot

CLOSE = (
    1e-9  # share of a step, at its ends, in which a contact may begin or end: it shifts the rates by as much
)
BEYOND = (
    1e-10  # the same, by which a step ends past that instant, so that the next one begins on the other side
)
TRIALS = 8  # of one step


class TouchingContacts:
    """Finds where a gap changes its sign within a step, or a deformation passes the level at which a law begins to act.

    The estimates of the error of a step hold for smooth forces.  Those of a contact have a finite order at the
    instant at which it begins or ends, and the error may be much larger than the estimate.  So a step ends there.

    Parameters
    ----------
    tables : Tables

    Attributes
    ----------
    rows : ndarray of int (k,)
        Deformations that are gaps, or at a value of which a law begins to act.
    levels : ndarray (k,)
        Their values where a contact begins.
    """

    def __init__(self, tables: Tables) -> None:
        gaps = every_gap(tables)
        found = [(gaps, np.zeros(gaps.size)), *_levels(tables)]
        self.rows: Index = np.concatenate([rows for rows, _ in found])
        self.levels: Array = np.concatenate([levels for _, levels in found])

    def until(self, first: Snapshot, e: Array, h: float) -> float:
        """Return the step [s] up to the first contact that begins or ends within a step; zero if there is none.

        Parameters
        ----------
        first : Snapshot
            At the beginning of the step.
        e : ndarray
            Deformations at its end.
        h : float
            Its length [s].
        """
        if not self.rows.size:
            return 0.0
        g0, g1 = first.e[self.rows] - self.levels, e[self.rows] - self.levels
        r0 = first.ed[self.rows]
        shares = [
            _root(*(float(v) for v in gap))
            for gap in zip(g0, h * r0, g1 - g0 - h * r0, strict=True)
            if gap[0] * (gap[0] + gap[1] + gap[2]) < 0
        ]
        share = min((s for s in shares if s > CLOSE), default=1.0)
        return h * (share + BEYOND) if share < 1 - CLOSE else 0.0


def _levels(tables: Tables) -> list[tuple[Index, Array]]:
    """Return the deformations of laws that begin to act at a value of theirs, and these values."""
    found = []
    for batch, p in zip(tables.laws, tables.parameters[1], strict=True):  # p: the parameters of a variant
        components = [(q.name, component) for q in batch.spec.parameters for component in range(q.size)]
        for level in batch.spec.begins:
            rows = batch.places["e"][:, 0]
            values = np.swapaxes(p, 1, 2).reshape(-1, p.shape[1])[: rows.size]
            known = level.parameter, level.component
            at = values[:, components.index(known)] if level.parameter else np.zeros(rows.size)
            found.append((rows, at))
    return found


def _root(g: float, rate: float, bend: float) -> float:
    """Find the first zero between 0 and 1 of g + rate s + bend s², which has opposite signs there."""
    q = -(rate + np.copysign(np.sqrt(max(rate * rate - 4 * bend * g, 0.0)), rate)) / 2
    roots = [g / q if q else 1.0, q / bend if bend else 1.0]
    return float(min((s for s in roots if 0 < s <= 1), default=1.0))
