"""Contacts that were passed within one step: open at both of its ends, closed in between."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize_scalar

from flexel.base.arrays import Index
from flexel.engine.contact_selection import free_gaps
from flexel.engine.evaluate import Evaluation
from flexel.integration.contact_watch import lowest_bound, negligible
from flexel.mechanics.states import between
from flexel.model.snapshot import Snapshot

EXACT = 1e-4  # of the time of the minimum of a gap, relative to the step
LOOKS = 12  # at a gap, for its minimum in a step
NONE: Index = np.zeros(0, dtype=np.intp)
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
    """Looks for contacts that were passed, in steps as they are taken or afterwards.

    The coordinates are interpolated between the ends of a step, and the gaps are those of the interpolated position:
    where the force of the contact was not felt, the path is smooth.  The contacts of ropes are left out: their
    neighbours hold them.

    Parameters
    ----------
    evaluation : Evaluation

    Attributes
    ----------
    found : list of Passage
    any : bool
        Whether there are contacts.
    """

    def __init__(self, evaluation: Evaluation) -> None:
        self._evaluation = evaluation
        contacts = "gap" in evaluation.structure.kinds
        self._rows = free_gaps(evaluation.tables) if contacts else NONE
        self.any = bool(self._rows.size)
        self._least = negligible(evaluation.structure) if self.any else 0.0
        self.found: list[Passage] = []
        self._looked = 0

    def look(self, steps: Iterable[tuple[Snapshot, Snapshot]]) -> None:
        """Look into steps, given by their ends."""
        ends = list(steps) if self.any else []
        if not ends:
            return
        rows = self._rows
        g0, r0, g1, r1 = (
            np.array([part[rows] for part in column])
            for column in zip(*((a.e, a.ed, b.e, b.ed) for a, b in ends), strict=True)
        )
        h = np.array([[b.t - a.t] for a, b in ends])
        turned = (g0 > 0) & (g1 > 0) & (r0 < 0) & (r1 > 0)
        lowest = np.full(turned.shape, np.inf)
        where = np.nonzero(turned)
        lowest[where] = lowest_bound((g0[where], g1[where]), (r0[where], r1[where]), h[where[0], 0])
        for step, contact in zip(*np.nonzero(lowest < -self._least), strict=True):
            if self._looked < MOST:
                self._looked += 1
                first, last = ends[int(step)]
                self._look_into(first, last, int(rows[contact]))

    def _look_into(self, first: Snapshot, last: Snapshot, row: int) -> None:
        work = self._evaluation.work

        def gap(t: float) -> float:
            guess = between(first, last, t)
            work.x[:], work.unwrap_from[:] = guess.x, guess.e
            work.position()
            return float(work.e[row])

        found = minimize_scalar(
            gap,
            bounds=(first.t, last.t),
            method="bounded",
            options={"maxiter": LOOKS, "xatol": EXACT * (last.t - first.t)},
        )
        if found.fun < -self._least:
            name = self._evaluation.structure.names[row]
            self.found.append(Passage(name, float(found.x), -float(found.fun)))


def warning(found: list[Passage]) -> str:
    """Write the warning about passages, of which there is at least one."""
    deepest = max(found, key=lambda z: z.depth)
    others = f", and {len(found) - 1} more" if len(found) > 1 else ""
    return (
        f"contact '{deepest.name}' was passed within one step at t = {deepest.t:.6g} s, by {deepest.depth:.2g} m"
        f"{others}: its force was not felt; give shorter steps (step or max_step)"
    )
