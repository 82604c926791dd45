"""Carry a motion in minimal coordinates across a flat position, where its steps become too short.

There the constraints leave the motion a choice of branches.  The one on which all coordinates are smooth is
taken: a polynomial of high degree through both sides, see collocation.py.  It begins before the flat
position, in the known part of the motion, and ends equally far beyond it, so that the flat position is in the
middle, between the points.  A motion that is not smooth, or leaves the constraints, has no such polynomial
and is not carried.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass, field

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.integration.branch import WORSE
from flexel.integration.carried import CLOSE, Carried
from flexel.integration.collocation import Sweeps
from flexel.integration.knots import Knots
from flexel.integration.path import Path
from flexel.integration.segments import Stretch
from flexel.mechanics.amplification import amplification
from flexel.mechanics.kinematics import Kinematics
from flexel.model.snapshot import Snapshot

log = logging.getLogger("flexel.simulate")
TRAVEL = 0.8  # largest change of a coordinate before the flat position, in natural scales
SHORTER, TRIALS = 0.6, 9  # lengths that are tried
SNAP = 0.4  # distance of the end of a step where a path may begin instead, relative to the length
LEAST = 1e-12  # error that is allowed at any tolerance
DECISIVE = 1e-7  # largest distance from the constraints: a linkage that is flat but for its square turns back
JOINED = 100.0  # distance between path and motion where the path goes on alone, in allowed errors
BEFORE = 0.05  # least time from there to the flat position, relative to the length
CENTRED, CENTRINGS = 0.04, 3  # distance of the flat position from the middle, relative to the length
KNOWN = 4  # instants through which the first guess goes
MOST = 1000  # steps that are looked back
PIECES = 7  # steps into which the rest of the path is divided, for events


@dataclass
class Crossing:
    """The known part of a motion before a flat position.

    Attributes
    ----------
    segments : list of Stretch
        Its steps.
    now : Snapshot
    z : ndarray (nz,)
        Internal states now.
    since : float
        Time [s] from which on all functions of time are smooth, and no sampled controller has acted.
    stop, until : float
        Times [s] at which the motion ends, and up to which all functions of time are smooth: a path may end beyond the
        motion.
    kinematics, shown : Kinematics
        Its degrees of freedom, and those in which states are given.
    knots : Knots
    tolerance : float
        In natural scales.
    evaluations : int
        That were made.
    """

    segments: list[Stretch]
    now: Snapshot
    z: Array
    since: float
    stop: float
    until: float
    kinematics: Kinematics
    shown: Kinematics
    knots: Knots
    tolerance: float
    evaluations: int = field(init=False, default=0)

    def __post_init__(self) -> None:
        self._motion = max(self.tolerance, LEAST)
        self._allowed = min(self._motion, DECISIVE)
        self._history = self._known()

    def steps(self, flat: float) -> list[Carried]:
        """Carry the motion across a flat position near a time [s]; return no steps if it is not smooth there.

        They begin at the end of the last step before it that rounding errors have not spoilt.
        """
        for t0 in self._begins(flat):
            if found := self._attempt(t0, flat):
                return found
        return []

    def _begins(self, flat: float) -> list[float]:
        """Return times [s] from which a path may begin, the longest path first: ends of steps, which are most exact."""
        weight = self.kinematics.lists.step_weight
        fastest = float(np.max(np.abs(self.now.v[: weight.size]) * weight, initial=0.0))
        ends = np.array([*(segment.t0 for segment in self._history), self.now.t])
        longest = min(flat - float(ends[0]), TRAVEL / max(fastest, 1e-300))
        found: list[float] = []
        for length in longest * SHORTER ** np.arange(TRIALS):
            end = float(ends[np.argmin(np.abs(ends - (flat - length)))])
            at_end = abs(end - (flat - length)) < SNAP * length
            t0 = end if at_end else min(float(flat - length), self.now.t)
            if t0 not in found:
                found.append(t0)
        return found

    def _known(self) -> list[Stretch]:
        """Return the steps that lead up to now without a gap, all of them smooth."""
        until, first = self.now.t, len(self.segments)
        least = max(first - MOST, 0)
        while (
            first > least
            and self.segments[first - 1].t1 == until
            and self.segments[first - 1].t0 >= self.since
        ):
            first -= 1
            until = self.segments[first].t0
        return self.segments[first:]

    def _at(self, t: float) -> tuple[Snapshot, Array]:
        """Return the known motion at a time: the instant and the internal states."""
        if t >= self.now.t:
            return self.now, self.z
        found = next(segment for segment in self._history if t <= segment.t1).pending(t)
        return found.moment, found.z

    def _choice(self, start: Snapshot) -> Kinematics:
        """Return the degrees of freedom for a path: the present ones, or those of its start if much better there."""
        then = next(
            (segment.kinematics for segment in self._history if start.t < segment.t1), self.kinematics
        )
        if then is self.kinematics:
            return then
        own, other = amplification(self.kinematics, start), amplification(then, start)
        return then if own > WORSE * other else self.kinematics

    def _attempt(self, t0: float, flat: float) -> list[Carried]:
        """Try a path that begins at a time [s]; return its steps, or none."""
        start, z = self._at(t0)
        kinematics = self._choice(start)
        later = [self._at(t)[0] for t in np.linspace(t0, self.now.t, KNOWN)[1:].tolist() if t > t0]
        sweeps = Sweeps(kinematics, self.knots, z, self._allowed)
        try:
            known = [sweeps.begin(start), *later]
            for _ in range(CENTRINGS):
                t1 = min(2 * flat - t0, self.until)
                if t1 <= self.now.t:
                    return []
                path, errors = sweeps.path(Path.through(known, kinematics.structure.nf, z, t1))
                share = sweeps.flat
                log.debug("path from %.9g to %.9g s: %s, flat position at %s", t0, t1, errors, share)
                if share is None:
                    return []
                flat = t0 + share * (t1 - t0)
                if abs(share - 0.5) <= CENTRED or t1 == self.until:
                    exact = errors.terms <= self._motion and sweeps.on_constraints(errors)
                    return self._divided(sweeps, path, self._joint(path, flat), flat) if exact else []
        except FlexelError as error:
            log.debug("no path from %.9g s: %s", t0, error)
        finally:
            self.evaluations += sweeps.evaluations
        return []

    def _joint(self, path: Path, flat: float) -> Snapshot:
        """Return the last end of a step before a flat position that a path shares, or the start of the path."""
        latest = flat - BEFORE * 2 * path.half
        ends = [self.now, *(segment.first for segment in reversed(self._history))]
        shared = (
            moment
            for moment in ends
            if path.t0 < moment.t <= latest and self._off(path, moment) <= JOINED * self._motion
        )
        return next(shared, self._at(path.t0)[0])

    def _off(self, path: Path, at: Snapshot) -> float:
        """Return the distance of a path from an instant of the motion, in natural scales."""
        weight = self.kinematics.lists.step_weight
        x, v, _ = path.at(at.t)
        off = (np.abs(x - at.x[: x.size]), np.abs(v - at.v[: v.size]) * path.half)
        return max(float(np.max(difference * weight, initial=0.0)) for difference in off)

    def _divided(self, sweeps: Sweeps, path: Path, joint: Snapshot, flat: float) -> list[Carried]:
        """Divide the rest of a path, from an instant on, into steps."""
        flat, ends = sweeps.exactly(path, flat), np.linspace(joint.t, min(path.t1, self.stop), PIECES + 1)[1:]
        close = 2 * CLOSE * (path.t1 - path.t0)
        steps, first = [], joint
        for t in ends[(np.abs(ends - flat) > close) | (ends == ends[-1])].tolist():
            last = sweeps.moment(path, t, first)
            steps.append(
                Carried(first.t, t, sweeps.kinematics, self.shown, first, last, path=path, flat=flat)
            )
            first = last
        return steps
