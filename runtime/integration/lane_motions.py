"""Motions by DOP853 in SIMD lanes: up to eight variants of a system side by side, each with its own steps.

A lane does what `flexel.integration.dop853` does, to the same digits.  A step that needs special treatment is repeated
outside the lanes; then the motion returns to its lane, or stays outside if it can no longer be computed in one.
"""

from __future__ import annotations

from typing import TypeGuard

import numpy as np

from flexel.engine.lane_arrays import (
    IDLE,
    PASSED,
    RUNNING,
    STOPPED,
    LaneCoordinateWork,
    LaneCovered,
    LaneRun,
    LaneSteps,
)
from flexel.engine.lane_workspace import LaneWorkspace
from flexel.generated._kernels import lib
from flexel.integration.dense import Allowed, Interpolant
from flexel.integration.dop853 import Dop853
from flexel.integration.dop853_stages import TABLEAU
from flexel.integration.dop853_steps import accepted_error
from flexel.integration.driver import Run
from flexel.integration.minimal import SHORTEST, MinimalRun
from flexel.integration.watch import Watch
from flexel.model.snapshot import Snapshot

STAGES = ("K", "V", "W", "turning", "w_rates")  # rates at the stages; the first row belongs to the start


def steps_of(run: MinimalRun) -> Dop853:
    """Return the steps of a motion by DOP853."""
    assert isinstance(run.method, Dop853)
    return run.method


def suits(run: Run | None) -> TypeGuard[MinimalRun]:
    """Whether a motion that has begun can go on in a lane."""
    if not isinstance(run, MinimalRun) or not isinstance(run.method, Dop853) or run.at_end:
        return False
    kinematics = run.kinematics
    roles, n = kinematics.roles, kinematics.structure.nf
    return not (
        run.events
        or run.sampling.all
        or roles.motions
        or not kinematics.loads.constant
        or kinematics.lists.saddle
        or roles.nq - roles.nd > lib.FLEXEL_MOST_KINEMATIC
        or run.choices.changes
        or not run.method.usual
        or run.now.v[n:].any()
    )


class LaneMotions:
    """Eight lanes for motions over the same times with the same degrees of freedom and tolerances.

    Parameters
    ----------
    run : MinimalRun
        One of the motions.
    """

    def __init__(self, run: MinimalRun) -> None:
        kinematics, given, own = run.kinematics, run.tolerances, steps_of(run)
        s = own.steps
        self._runs: dict[int, MinimalRun] = {}
        self._watches: dict[int, Watch | None] = {}
        work = LaneWorkspace(kinematics.evaluation.work)
        choice = LaneCoordinateWork(kinematics.lists, s.choice)
        choice.struct.accept = accepted_error(kinematics, given.rtol)
        self._covered = LaneCovered(run.covered)
        weight = kinematics.lists.step_weight
        steps = LaneSteps(work, s.y.size, run.natural_atol(), weight, TABLEAU, self._covered, s.rotations)
        steps.struct.rtol = given.rtol
        span = float(run.times[-1] - run.times[0])
        self._lanes = LaneRun(
            work,
            choice,
            steps,
            {
                "end": float(run.times[-1]),
                "longest": given.max_step,
                "shortest": SHORTEST * span,
            },
            run.touching.look,
        )
        own.give_rules(self._lanes.struct.rules)
        self._roles = kinematics.roles

    def enter(self, lane: int, run: MinimalRun, watch: Watch | None) -> None:
        """Put a motion that has begun into a lane, and what looks at it."""
        l, method = self._lanes, steps_of(run)
        s, look = method.steps, run.touching.look
        choice = s.choice
        l.work.load(lane, choice.work)
        steps, now = l.steps, run.now
        for wide, own in (
            (steps.y, s.y),
            (steps.x, s.x),
            (steps.e, s.e),
            (steps.w, s.w),
            (l.v, now.v),
            (l.e, now.e),
            (l.w, now.ed),
            (l.look.value, look.value),
            (l.look.rate, look.rate),
            (l.look.rest, look.rest),
        ):
            wide[:, lane] = own
        for name in STAGES:
            getattr(steps, name)[0, :, lane] = getattr(s, name)[0]
        for name, wide in self._covered.arrays.items():
            wide[..., lane] = run.covered.arrays[name]
        l.choice.loads[:, lane] = run.kinematics.loads.values(run.t)
        l.t[lane], l.h[lane], l.until[lane], l.amplification[lane] = (
            run.t,
            method.h,
            run.until,
            run.amplification,
        )
        l.allowed[lane] = run.allowed()
        l.sign[lane] = s.struct.sign
        l.size[lane], l.fall[lane] = run.dips.at(run.kinematics, run.t)
        l.taken[lane] = l.refused[lane] = l.tries[lane] = 0
        l.most[lane] = watch.next - run.taken if watch else np.iinfo(np.int32).max
        l.doing[lane] = RUNNING
        l.take_account(lane, run.account)
        self._runs[lane], self._watches[lane] = run, watch

    def run(self) -> list[int]:
        """Take steps until lanes need attention; returns these lanes."""
        self._lanes.run()
        doing = self._lanes.doing
        return np.flatnonzero((doing == PASSED) | (doing == STOPPED)).tolist()

    def look(self, lane: int) -> bool:
        """Store the states at the times that a motion has passed, or take its step outside; whether it has left.

        Raises
        ------
        FlexelError
            If the motion cannot be continued.
        """
        l, run = self._lanes, self._runs[lane]
        stopped = l.doing[lane] == STOPPED
        if not stopped:
            self._pass(lane, run)
            if run.t < run.times[-1]:
                return False
        self._leave(lane, run)
        if not stopped:
            return True
        watch = self._watches[lane]
        if watch is not None:
            watch(run)
        run.watched(1)
        if not self.takes(run):
            return True
        self.enter(lane, run, watch)
        return False

    def drop(self, lane: int) -> None:
        """Clear a lane."""
        self._lanes.doing[lane] = IDLE
        self._lanes.take_account(lane, None)

    def takes(self, run: Run | None) -> TypeGuard[MinimalRun]:
        """Whether a motion that has begun can go on in these lanes."""
        return suits(run) and run.kinematics.roles is self._roles

    def _pass(self, lane: int, run: MinimalRun) -> None:
        """Store the states at the times within a step."""
        l, steps = self._lanes, self._lanes.steps
        first, x, e = self._start(lane), steps.x_new[:, lane].copy(), l.work.e[:, lane].copy()
        ed = l.work.w[: e.size, lane].copy()
        last = Snapshot(float(l.to[lane]), x, l.work.v[:, lane].copy(), e, ed)
        y0, y1, w0 = (array[:, lane].copy() for array in (steps.y, steps.y_new, steps.w))
        rates0, w_rates0 = (array[0, :, lane].copy() for array in (steps.K, steps.w_rates))
        scales = steps.scale[:, lane], steps.w_scale[:, lane]
        ranges, part = self._covered.ranges(lane, y1), self._covered.part(lane)
        allowed = Allowed(*scales, y1, ranges, part, run.tolerances.relative)
        accept = self._covered.accepted_error(lane, float(l.choice.struct.accept))
        exactness = float(run.tolerances.rtol), accept
        z1 = y1[y1.size - run.z.size :].copy()
        of = y0, rates0, w0, w_rates0, z1, allowed, run.knots.interval, *exactness
        run.pass_step(Interpolant(run.kinematics, first, last, *of), z1)

    def _start(self, lane: int) -> Snapshot:
        """Return the start of the step of a lane."""
        l = self._lanes
        x, v, e, ed = (values[:, lane].copy() for values in (l.steps.x, l.v, l.e, l.w))
        return Snapshot(float(l.t[lane]), x, v, e, ed)

    def _leave(self, lane: int, run: MinimalRun) -> None:
        """Hand a motion back, at its end or at the start of a step that it takes outside the lanes."""
        l, steps, method = self._lanes, self._lanes.steps, steps_of(run)
        own = method.steps
        ended = bool(l.doing[lane] == PASSED)
        covered = run.covered.arrays
        for name, wide in self._covered.arrays.items():
            covered[name][:] = wide[..., lane]
        taken, refused = int(l.taken[lane]) + ended, int(l.refused[lane]) + ended * int(l.tries[lane])
        if not ended:
            pairs = [
                (steps.y, own.y),
                (steps.x, own.x),
                (steps.e, own.e),
                (steps.w, own.w),
            ]
            pairs += [(getattr(steps, name)[0], getattr(own, name)[0]) for name in STAGES]
            for wide, single in pairs:
                single[:] = wide[..., lane]
            method.h = float(l.first[lane])
            z = own.y[own.y.size - run.z.size :].copy()
            run.go_on_alone(self._start(lane), z, float(l.amplification[lane]))
            sizes = float(l.size[lane]), float(l.fall[lane])
            run.dips.take(run.kinematics, run.t, int(own.struct.sign), *sizes)
        else:
            covered["sizes"][:] = covered["sizes_new"]
            run.account.accept(float(l.to[lane] - l.t[lane]))
        run.count(taken, refused, lib.FLEXEL_STAGES * (taken + refused))
        self.drop(lane)
        del self._runs[lane]
