"""Watches the gaps of contacts within steps: none is stepped over, and each is resolved by the steps that it takes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.contact_selection import free_gaps
from flexel.engine.workspace import Workspace
from flexel.mechanics.kinematics import size_of
from flexel.model.structure import Structure

DEPTH = 1e-6  # depth that does not matter, relative to the size of the model
DEEP = 0.1  # error of a gap, relative to the depth of its contact, above which a step is halved


def negligible(structure: Structure) -> float:
    """Return the depth of a contact [m] that does not matter."""
    return DEPTH * size_of(structure)


class ContactWatch:
    """Finds contacts that may have closed and opened again within a step.

    The gap to a convex body is a convex function of time, except for the accelerations: its second derivative is at
    least -c, where c is the size of the part due to accelerations, taken at the beginning of the step.  Such a gap is
    at least as large as both tangents at the ends, steepened by c h/2.  Where these meet below zero, the contact may
    have been stepped over.  The contacts of ropes are left out: their neighbours hold them.

    Parameters
    ----------
    work : Workspace
        Whose gaps and rates are those at the end of a trial step.
    given : bool
        Whether the steps are given: nothing is watched then.
    """

    def __init__(self, work: Workspace, given: bool) -> None:
        self._rows = free_gaps(work.tables)
        self.any = bool(self._rows.size) and not given
        self._work, self._least = work, negligible(work.tables.structure) if self.any else 0.0
        self._gap = self._rate = self._bend = self._rows.astype(float)

    def note(self, a: Array) -> None:
        """Take the point that the workspace holds, with accelerations a (n,), as the beginning of the next step."""
        self._gap, self._rate = self._now()
        self._bend = np.abs(self._work.jvp(a)[self._rows])

    def skipped(self, h: float) -> bool:
        """Whether a contact may have been stepped over in a step of length h [s]."""
        gap, rate = self._now()
        first, last = self._rate - self._bend * h / 2, rate + self._bend * h / 2
        turned = (self._gap > 0) & (first < 0) & (rate >= 0)
        if not turned.any():
            return False
        lowest = lowest_bound((self._gap[turned], gap[turned]), (first[turned], last[turned]), h)
        return bool(np.any(lowest < -self._least))

    def rough(self, change: Callable[[], Array]) -> bool:
        """Whether a step is too coarse for a contact: the error of its gap is no small part of its depth.

        A contact that begins is as deep as the step has let it be, so that steps become short beside its duration.

        Parameters
        ----------
        change : callable() -> ndarray (n,)
            Local errors of the coordinates; called where a contact is closed.
        """
        depth = -np.minimum(self._gap, self._work.e[self._rows])
        closed = depth > 0
        if not closed.any():
            return False
        error = np.abs(self._work.jvp(change())[self._rows[closed]])
        return bool(np.any(error > DEEP * depth[closed]))

    def _now(self) -> tuple[Array, Array]:
        return self._work.e[self._rows], self._work.w[self._rows]


def lowest_bound(gaps: tuple[Array, Array], rates: tuple[Array, Array], h: float) -> Array:
    """Intersect the tangents at both ends of a step: a lower bound of convex gaps that fall first and rise then.

    Parameters
    ----------
    gaps, rates : tuple of ndarray (n,)
        At the beginning and at the end of the step; the rates are negative, and zero or positive [m, m/s].
    h : float
        Length of the step [s].
    """
    (g0, g1), (r0, r1) = gaps, rates
    return np.asarray((r1 * g0 - r0 * g1 + r0 * r1 * h) / (r1 - r0))
