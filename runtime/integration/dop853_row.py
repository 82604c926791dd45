"""Steps of DOP853 that are taken in a row in C, see dop853_run.h, and what is kept of them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.dense import Allowed, Interpolant
from flexel.integration.dop853_steps import Steps, accepted_error
from flexel.integration.in_row import ROOM, Kept, Looks, Place
from flexel.integration.knots import Interval
from flexel.integration.step_method import InRow, Tolerances
from flexel.model.snapshot import Snapshot

ENDED = lib.FLEXEL_ROW_ENDED  # how a row ends: where it should,
TRIED = lib.FLEXEL_ROW_TRIED  # or with a trial that is to be judged
INPUTS = lib.FLEXEL_ROW_INPUTS  # what it waits for


class Row(Struct):
    """The struct of dop853_run.h, for one choice of degrees of freedom.

    Parameters
    ----------
    steps : Steps
    looks : Looks
    times : ndarray
        At which states are stored.
    given : Tolerances
    """

    def __init__(self, steps: Steps, looks: Looks, times: Array, given: Tolerances) -> None:
        super().__init__(ffi.new("flexel_dop853_run *"))
        self.steps, self.times, self._relative = steps, times, given.relative
        r, c, s = self.struct, steps.struct, steps.kinematics.structure
        r.steps, r.varies, r.longest = c, steps.varies, given.max_step
        r.accept = accepted_error(steps.kinematics, c.rtol)
        r.times, r.ntimes = self.pointer(np.ascontiguousarray(times)), times.size
        ny, count = int(c.ny), steps.rotations.count
        self._v, self._e, self._w = (self.new(name, n) for name, n in (("v", s.n), ("e", s.m), ("w", s.m)))
        sizes = s.n, s.n, s.m, s.m, ny, ny, ny, ny, 3 * count, 3 * count, 4 * count
        self._kept = Kept(self, r.row, steps.kinematics, steps.choice, looks, (int(lib.FLEXEL_KEPT), *sizes))
        r.wide = lib.flexel_dop853_slot(r)
        r.slots = max(1, ROOM // (8 * int(r.wide)))
        r.stages = self.pointer(np.empty(int(r.slots * r.wide)))

    def take(
        self, place: Place, now: Snapshot, h: float, stored: int, z: int, interval: Interval
    ) -> list[InRow]:
        """Take steps, and return them.

        Parameters
        ----------
        place : Place
        now : Snapshot
            Where they begin.
        h : float
            Length of the first trial [s].
        stored : int
            How many states are stored up to there.
        z : int
            Number of internal states.
        interval : Interval
            In which functions of time are evaluated.
        """
        r, steps = self.struct, self.steps
        if not r.varies:
            steps.give_stages(interval, now.t, 0.0)
        r.t, r.h, r.next, r.refused, r.used = now.t, h, stored, 0, 0
        self._v[:], self._e[:], self._w[:] = now.v, now.e, now.ed
        begun = steps.y.copy(), steps.K[0].copy(), steps.w.copy(), steps.w_rates[0].copy()
        self._kept.begin(place)
        self.ended = self._ended(interval)
        return list(self._found(self._kept.end(float(r.t)), now, begun, z, interval))

    def _ended(self, interval: Interval) -> int:
        """Take the steps, with prescribed motions and loads at their stages; return how they end."""
        r = self.struct
        while (ended := int(lib.flexel_dop853_steps(r))) == INPUTS:
            try:
                self.steps.give_stages(interval, r.t, r.to - r.t)
            except FlexelError:  # the steps so far are kept; the next one is tried alone, and raises it again
                return int(ENDED)
        return ended

    def _found(
        self,
        kept: Array,
        first: Snapshot,
        begun: tuple[Array, Array, Array, Array],
        nz: int,
        interval: Interval,
    ) -> Iterator[InRow]:
        """Yield the steps that are kept, from the first point and y, its rates, angular velocities and their rates."""
        kinematics, rtol, parts = self.steps.kinematics, float(self.struct.rules.rtol), self._kept.parts[1:]
        heads, balances = kept[:, self._kept.parts[0]].tolist(), self._kept.balances()
        for i, (t, amplification, part, accept, slot, same) in enumerate(heads):
            x, v, e, ed, y, rates, scale, ranges, w, w_rates, w_scale = [kept[i, part] for part in parts]
            last, z = Snapshot(t, x, v, e, ed), y[y.size - nz :]
            allowed = Allowed(scale, w_scale, y, ranges, part, self._relative)
            dense = Interpolant(kinematics, first, last, *begun, z, allowed, interval, rtol, accept)
            recall = partial(self._recall, dense, int(slot), bool(same)) if slot >= 0 else None
            yield InRow(dense, z, amplification, balances[i], recall)
            first, begun = last, (y, rates, w, w_rates)

    def _recall(self, step: Interpolant, slot: int, same: bool) -> None:
        """Find the stages of a step: those that are kept, if they are the same when they are found anew."""
        if not same:
            step.inside.again(step, step.h)
            return
        lib.flexel_dop853_recall(self.struct, slot, step.inside.struct)
        step.inside.holds(step)
