"""Deformations along a step whose coordinates are interpolated between its ends, in C; see touching.h."""

from __future__ import annotations

from flexel.base.arrays import Array
from flexel.engine.structs import Struct
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib
from flexel.model.snapshot import Snapshot


class StepPath(Struct):
    """The cubic through both ends of a step.

    Parameters
    ----------
    work : Workspace
        Is changed.
    first, last : Snapshot
        The ends.
    """

    def __init__(self, work: Workspace, first: Snapshot, last: Snapshot) -> None:
        super().__init__(ffi.new("flexel_path *"))
        self._work, self._lowest, c, h = work, ffi.new("double *"), self.struct, last.t - first.t
        c.x0, c.v0, c.e0, c.w0 = map(self.pointer, _point(first, h))
        c.x1, c.v1, c.e1, c.w1 = map(self.pointer, _point(last, h))

    def value(self, row: int, part: float) -> float:
        """Return a deformation at a part of the step, from 0 to 1."""
        return float(lib.flexel_path_value(self._work.struct, self.struct, row, part))

    def lowest(self, row: int, near: float) -> tuple[float, float]:
        """Return the part of the step at which a deformation is smallest, and that value.

        The deformation is convex along the step, or nearly so; a smallest value above `near` is not exact.
        """
        part = lib.flexel_path_lowest(self._work.struct, self.struct, row, near, self._lowest)
        return float(part), float(self._lowest[0])


def _point(at: Snapshot, h: float) -> tuple[Array, Array, Array, Array]:
    """Return coordinates and deformations, with their rates per step."""
    return at.x, h * at.v, at.e, h * at.ed
