"""Steps of Radau IIA that are taken in a row in C, see radau_run.h, and what is kept of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.in_row import Kept, Looks, Place
from flexel.integration.radau_steps import Collocation, StagePolynomial
from flexel.integration.step_method import InRow
from flexel.model.snapshot import Snapshot

TRIED = lib.FLEXEL_ROW_TRIED  # a row ends with an unusual trial
INPUTS, JACOBIAN = lib.FLEXEL_ROW_INPUTS, lib.FLEXEL_ROW_JACOBIAN  # what it waits for


class RadauRow(Struct):
    """The struct of radau_run.h, for one choice of degrees of freedom.

    Parameters
    ----------
    steps : Collocation
    looks : Looks
    """

    def __init__(self, steps: Collocation, looks: Looks) -> None:
        super().__init__(ffi.new("flexel_radau_run *"))
        self.steps, s = steps, steps.kinematics.structure
        self.struct.steps = steps.struct
        ny, turns, angles = steps.y.size, steps.turns.rotations.count, steps.angles.count
        sizes = s.n, s.n, s.m, s.m, ny, ny, 4 * ny, 4 * turns, turns, angles, angles
        head = int(lib.FLEXEL_RADAU_KEPT)
        self._kept = Kept(self, self.struct.row, steps.kinematics, steps.choice, looks, (head, *sizes))

    def take(
        self, place: Place, now: Snapshot, best: float, nz: int, look: Callable[[Snapshot, Array], None]
    ) -> list[InRow]:
        """Take steps, and return them.

        Parameters
        ----------
        place : Place
        now : Snapshot
            Where they begin.
        best : float
            Amplification of the best degrees of freedom.
        nz : int
            Number of internal states.
        look : callable(now, z)
            Evaluates the Jacobian at an instant.
        """
        r, steps = self.struct, self.steps
        r.best = best
        self._kept.begin(place)
        self.unusual = self._ended(nz, look) == TRIED
        return list(self._found(self._kept.end(float(steps.struct.t)), now, nz))

    def _ended(self, nz: int, look: Callable[[Snapshot, Array], None]) -> int:
        """Take the steps, with what they wait for; return how they end."""
        r, steps = self.struct, self.steps
        while (ended := int(lib.flexel_radau_steps(r))) in (INPUTS, JACOBIAN):
            try:
                if ended == INPUTS:
                    steps.give_stages()
                else:
                    look(steps.now, steps.y[steps.y.size - nz :].copy())
            except FlexelError:  # the steps so far are kept; the next one is tried alone, and raises it again
                return ended
        return ended

    def _found(self, kept: Array, first: Snapshot, nz: int) -> Iterator[InRow]:
        """Yield the steps that are kept, from the first point."""
        steps, parts = self.steps, self._kept.parts[1:]
        kinematics, rotations = steps.kinematics, steps.turns.rotations
        heads, balances = kept[:, self._kept.parts[0]].tolist(), self._kept.balances()
        for i, (t, h, amplification) in enumerate(heads):
            x, v, e, ed, y, end, powers, L, space, q, slope = [kept[i, part] for part in parts]
            last = Snapshot(t, x, v, e, ed)
            charts = steps.angles.charts_of(q, slope)
            dense = StagePolynomial(
                kinematics,
                first,
                last,
                first.t,
                h,
                y,
                powers.reshape(4, -1),
                end,
                rotations,
                L.reshape(-1, 4),
                space.astype(np.int32),
                charts,
            )
            yield InRow(dense, end[end.size - nz :], amplification, balances[i], None)
            first = last
