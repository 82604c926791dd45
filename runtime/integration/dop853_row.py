"""Steps of DOP853 that are taken in a row in C, see dop853_run.h, and what is kept of them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import accumulate, pairwise
from typing import NamedTuple

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.contact_look import ContactLook
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.dense import Allowed, Interpolant
from flexel.integration.dips import DEEP, Dips
from flexel.integration.dop853_steps import Steps, accepted_error
from flexel.integration.knots import Interval
from flexel.integration.step_method import InRow, Tolerances
from flexel.model.snapshot import Snapshot

ROOM = 2**18  # bytes for what is kept of steps, and as many for their stages: at least one step has room
ENDED = lib.FLEXEL_ROW_ENDED  # how a row ends: where it should,
TRIED = lib.FLEXEL_ROW_TRIED  # or with a trial that is to be judged


class Place(NamedTuple):
    """Where a row of steps begins.

    Attributes
    ----------
    now : Snapshot
    h : float
        Length of the first trial [s].
    amplification, allowed : float
        Of the degrees of freedom, and up to which there are steps.
    stored : int
        How many states are stored up to there.
    """

    now: Snapshot
    h: float
    amplification: float
    allowed: float
    stored: int


class Row(Struct):
    """The struct of dop853_run.h, for one choice of degrees of freedom.

    Parameters
    ----------
    steps : Steps
    look : ContactLook
    dips : Dips
    times : ndarray
        At which states are stored.
    given : Tolerances
    least : float
        Length below which a step is too short, wherever it is [s].
    """

    def __init__(
        self,
        steps: Steps,
        look: ContactLook,
        dips: Dips,
        times: Array,
        given: Tolerances,
        least: float,
    ) -> None:
        super().__init__(ffi.new("flexel_dop853_run *"))
        self.steps, self.times, self._look, self._dips = steps, times, look, dips
        self._relative = given.relative
        r, c = self.struct, steps.struct
        r.work, r.choice, r.steps = steps.choice.work.struct, steps.choice.struct, c
        r.touching, r.dips = look.struct, dips.struct
        r.accept, r.deep = accepted_error(steps.kinematics, c.rtol), DEEP
        r.longest, r.shortest = given.max_step, least
        r.times, r.ntimes = self.pointer(np.ascontiguousarray(times)), times.size
        s, ny, count = steps.kinematics.structure, int(c.ny), steps.rotations.count
        self._v, self._e, self._w = (self.new(name, n) for name, n in (("v", s.n), ("e", s.m), ("w", s.m)))
        sizes = s.n, s.n, s.m, s.m, ny, ny, ny, ny, 3 * count, 3 * count, 4 * count
        self._parts = [slice(*ends) for ends in pairwise(accumulate(sizes, initial=int(lib.FLEXEL_KEPT)))]
        r.width, r.wide = self._parts[-1].stop, lib.flexel_dop853_slot(r)
        r.slots, self._most = (max(1, ROOM // (8 * size)) for size in (int(r.wide), int(r.width)))
        self._kept = np.empty((self._most, int(r.width)))
        r.kept, r.stages = self.pointer(self._kept), self.pointer(np.empty(int(r.slots * r.wide)))
        self._accounts = ffi.new("flexel_account[]", self._most)
        r.accounts = self._accounts

    def take(self, place: Place, end: float, most: int, z: int, interval: Interval) -> list[InRow]:
        """Take up to `most` steps, and return them.

        Parameters
        ----------
        place : Place
            Where they begin.
        end : float
            When the last step ends at the latest [s].
        most : int
        z : int
            Number of internal states.
        interval : Interval
            In which functions of time are evaluated.
        """
        r, steps, now = self.struct, self.steps, place.now
        steps.give_stages(interval, now.t, 0.0)
        r.t, r.h, r.amplification, r.allowed = now.t, place.h, place.amplification, place.allowed
        r.end, r.next, r.most = end, place.stored, min(most, self._most)
        self._v[:], self._e[:], self._w[:] = now.v, now.e, now.ed
        r.known = self._dips.known(steps.kinematics, now.t)
        r.largest = self._dips.largest(steps.kinematics)
        y, w = steps.y.copy(), steps.w.copy()
        rates, w_rates = steps.K[0].copy(), steps.w_rates[0].copy()
        self.ended = int(lib.flexel_dop853_steps(r))
        taken = int(r.taken)
        if taken:
            self._dips.go_on(steps.kinematics, float(r.t), float(r.largest))
        return list(self._found(self._kept[:taken].copy(), now, (y, rates, w, w_rates), z, interval))

    def _found(
        self,
        kept: Array,
        first: Snapshot,
        begun: tuple[Array, Array, Array, Array],
        nz: int,
        interval: Interval,
    ) -> Iterator[InRow]:
        """Yield the steps that are kept, from the first point and y, its rates, angular velocities and their rates."""
        kinematics, rtol, parts = self.steps.kinematics, float(self.struct.rules.rtol), self._parts
        heads = kept[:, : lib.FLEXEL_KEPT].tolist()
        accounts = ffi.buffer(self._accounts)
        size = ffi.sizeof("flexel_account")
        for i, (t, amplification, part, accept, slot, same) in enumerate(heads):
            x, v, e, ed, y, rates, scale, ranges, w, w_rates, w_scale = [kept[i, part] for part in parts]
            last, z = Snapshot(t, x, v, e, ed), y[y.size - nz :]
            allowed = Allowed(scale, w_scale, y, ranges, part, self._relative)
            dense = Interpolant(kinematics, first, last, *begun, z, allowed, interval, rtol, accept)
            balance = accounts[i * size : (i + 1) * size]
            recall = partial(self._recall, dense, int(slot), bool(same)) if slot >= 0 else None
            yield InRow(dense, z, amplification, balance, recall)
            first, begun = last, (y, rates, w, w_rates)

    def _recall(self, step: Interpolant, slot: int, same: bool) -> None:
        """Find the stages of a step: those that are kept, if they are the same when they are found anew."""
        if not same:
            step.inside.again(step, step.h)
            return
        lib.flexel_dop853_recall(self.struct, slot, step.inside.struct)
        step.inside.holds(step)
