"""Flat positions: where branches of solutions meet, and the steps that cross them far from each stage.

Close to such a position velocities lose their digits to rounding, and accelerations even more; shorter steps come only
closer.  So it lies in a gap between the stages of one step.  The sign of the determinant of the position matrix shows
it only if an odd number of loops is flat at the same time; its size shows it always.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.integration.dop853_stages import TIMES

DIP = 2.0  # range of the logarithms of the determinant in a step, to base two, that is looked at
BEYOND = 1.3  # last time tried, relative to the step: the position may lie behind its end
GRID = 400  # times that are tried
ROUGH = 0.5  # misfit of the logarithms, to base two, of a position that is found
LEAST = 0.5  # order of the zero
AHEAD = 0.2  # least step up to a position that the next one crosses, relative to that
_ENDS = np.unique(TIMES)
MIDDLES, HALVES = (_ENDS[1:] + _ENDS[:-1]) / 2, (_ENDS[1:] - _ENDS[:-1]) / 2  # of gaps between stages
WIDEST = int(np.argmax(HALVES))


def flat_position(logarithm: Array, times: Array = TIMES) -> float | None:
    """Find the time at which the determinant is zero, relative to the step; None if it is not near the step.

    The determinant is c |t - t*|^N exp(b t): each loop that is flat contributes one to N.  This is fitted by least
    squares for a number of times t*, without the stage closest to it, which may be lost to rounding.

    Parameters
    ----------
    logarithm : ndarray (count,)
        Logarithms of the size of the determinant, to base two.
    times : ndarray (count,)
        Where they are, relative to the step; by default at the stages of DOP853 and the end.
    """
    if not np.isfinite(logarithm).all() or np.ptp(logarithm) < DIP:
        return None
    used = np.arange(logarithm.size) != np.argmin(logarithm)
    times, logarithm = times[used], logarithm[used]
    tried = (np.arange(GRID) + 0.5) * (BEYOND / GRID)
    columns = np.empty((GRID, times.size, 3))
    columns[:, :, 0], columns[:, :, 1] = 1.0, times
    columns[:, :, 2] = np.log2(np.abs(times - tried[:, None]))
    found = np.linalg.pinv(columns) @ logarithm
    off = np.einsum("ijk,ik->ij", columns, found) - logarithm
    size = np.where(found[:, 2] > LEAST, np.sqrt(np.mean(off**2, axis=1)), np.inf)
    best = int(np.argmin(size))
    return float(tried[best]) if size[best] < ROUGH else None


def crossing_step(left: float, h: float) -> float:
    """Find the longest step up to h that keeps its stages far from a flat position.

    Parameters
    ----------
    left : float
        Time up to the position [s].
    h : float
        The step that is allowed [s].
    """
    if not 0 < left <= (1 + MIDDLES[WIDEST]) * h:
        return h
    ahead = left - MIDDLES[WIDEST] * h
    if ahead > 0:  # the next step crosses it
        return float(max(ahead, AHEAD * h))
    lengths = left / MIDDLES
    return float(lengths[np.argmax(np.where(lengths <= h, HALVES * lengths, 0.0))])
