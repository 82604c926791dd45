"""Contacts that are passed within one step: open at both of its ends, closed in between."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import brentq

from flexel.base.arrays import Array, Index
from flexel.engine.contact_selection import free_gaps
from flexel.engine.evaluate import Evaluation
from flexel.engine.step_path import StepPath
from flexel.engine.workspace import Workspace
from flexel.mechanics.kinematics import size_of
from flexel.model.snapshot import Snapshot

DEPTH = 1e-6  # depth of a contact that does not matter, relative to the size of the model
CLOSE = (
    1e-9  # share of a step, at its ends, in which a contact may begin or end: it shifts the rates by as much
)
UNSURE = (
    0.1  # gap in a step, relative to the larger one at its ends, and share of the step: not known exactly
)
MOST = 200  # steps that are looked into: the first ones that may have passed a contact


@dataclass(frozen=True)
class Passage:
    """A contact that was passed.

    Attributes
    ----------
    name : str
        Its gap.
    t : float
        When it was deepest [s].
    depth : float
        How deep [m].
    """

    name: str
    t: float
    depth: float


class Passages:
    """Looks for contacts that are passed, in steps as they are taken or afterwards.

    A step that may pass a contact is looked into: the coordinates are interpolated between its ends, and the gap is
    that of the interpolated position.  Where the force of the contact was not felt, the path is smooth.  The contacts
    of ropes are left out: their neighbours hold them.

    Parameters
    ----------
    evaluation : Evaluation

    Attributes
    ----------
    found : list of Passage
    any : bool
        Whether there are contacts.
    rows : ndarray of int
        Their gaps.
    least : float
        Depth [m] that does not matter.
    """

    def __init__(self, evaluation: Evaluation) -> None:
        self._evaluation = evaluation
        self.rows = free_gaps(evaluation.tables)
        self.any = bool(self.rows.size)
        self.least = DEPTH * size_of(evaluation.structure) if self.any else 0.0
        self.found: list[Passage] = []
        self._looked = 0

    @cached_property
    def _work(self) -> Workspace:
        """A workspace of its own: that of the motion holds the point at which it is."""
        return Workspace(self._evaluation.tables)

    def until(self, first: Snapshot, last: Snapshot, gaps: Index, close: float = CLOSE) -> float:
        """Return when a step must end that may pass contacts; infinite if it passes none.

        That is when a contact begins.  Where it begins at the start of the step, it is when the gap is smallest.

        Parameters
        ----------
        first, last : Snapshot
            The ends of the step.
        gaps : ndarray of int
            Of these contacts.
        close : float
            Share of the step, at its start, in which a contact may begin.
        """
        return min(self._begin(first, last, int(row), close) for row in gaps)

    def look(self, steps: Iterable[tuple[Snapshot, Snapshot]]) -> None:
        """Look into steps, given by their ends."""
        ends = list(steps) if self.any else []
        if not ends:
            return
        g0, r0, g1, r1 = (
            np.array([part[self.rows] for part in column])
            for column in zip(*((a.e, a.ed, b.e, b.ed) for a, b in ends), strict=True)
        )
        h = np.array([[last.t - first.t] for first, last in ends])
        lowest = lowest_bound(g0, r0, g1, r1, h)
        for step, contact in zip(*np.nonzero(lowest < -self.least), strict=True):
            if self._looked < MOST:
                self._looked += 1
                first, last = ends[int(step)]
                row = int(self.rows[contact])
                part, gap = StepPath(self._work, first, last).lowest(row, 0.0)
                if gap < -self.least:
                    t = first.t + part * (last.t - first.t)
                    self.found.append(Passage(self._evaluation.structure.names[row], t, -gap))

    def _begin(self, first: Snapshot, last: Snapshot, row: int, close: float) -> float:
        """Return when a step must end that may pass a contact."""
        path, h, wide = StepPath(self._work, first, last), last.t - first.t, max(first.e[row], last.e[row])
        part, lowest = path.lowest(row, UNSURE * wide)
        if first.e[row] <= 0:
            return first.t + part * h
        if lowest >= -self.least:  # the path is interpolated: a step up to there shows how close it is
            near = lowest < UNSURE * wide and UNSURE < part < 1 - UNSURE
            return first.t + part * h if near else np.inf
        begin = float(brentq(lambda part: path.value(row, part), 0.0, part))
        return first.t + (begin if begin > close else part) * h


def lowest_bound(g0: Array, r0: Array, g1: Array, r1: Array, h: Array | float) -> Array:
    """Intersect the tangents of gaps at both ends of a step: lower bounds where they fall first and rise then.

    Infinite where a gap is closed at an end, or its tangents do not turn.  The tangents are steepened by what
    accelerations do in half a step: where a body is passed head-on, the rates at both ends would be opposite without
    them.

    Parameters
    ----------
    g0, r0, g1, r1 : ndarray (...,)
        Gaps and their rates at the beginning and at the end of the step [m, m/s].
    h : ndarray or float
        Length of the step [s].
    """
    steeper = np.abs(r0 + r1) / 2
    first, last = r0 - steeper, r1 + steeper
    turned = (g0 > 0) & (g1 > 0) & (first < 0) & (last > 0)
    fall = np.where(turned, last - first, 1.0)
    return np.where(turned, (last * g0 - first * g1 + first * last * h) / fall, np.inf)


def warning(found: list[Passage]) -> str:
    """Write the warning about passages, of which there is at least one."""
    deepest = max(found, key=lambda z: z.depth)
    others = f", and {len(found) - 1} more" if len(found) > 1 else ""
    return (
        f"contact '{deepest.name}' was passed within one step at t = {deepest.t:.6g} s, by {deepest.depth:.2g} m"
        f"{others}: its force was not felt; give shorter steps (step or max_step)"
    )
