"""Whether a step must end earlier, because contacts begin, end or are passed in it, in C; see touching.h."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.structs import Struct
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib

TOUCHES, PASSES = lib.FLEXEL_TOUCHES, lib.FLEXEL_PASSES


class ContactLook(Struct):
    """What is looked at in the steps of a motion.

    Parameters
    ----------
    rows : ndarray of int (k,)
        Deformations that are gaps, or with which laws begin to act.
    coefficients : tuple of ndarray (k,)
        value, rate and rest: value e + rate e' + rest is zero there.
    gaps : ndarray of int
        Those that a step may not pass.
    least : float
        Depth [m] of a contact that does not matter.
    sees_inside : bool
        Whether the method feels forces within a step.

    Attributes
    ----------
    any : bool
        Whether there is anything to look at.
    passed : ndarray of uint8
        Whether each of the gaps may have been passed in the last step.
    """

    def __init__(
        self,
        rows: Index,
        coefficients: tuple[Array, Array, Array],
        gaps: Index,
        least: float,
        sees_inside: bool,
    ) -> None:
        super().__init__(ffi.new("flexel_touching *"))
        c = self.struct
        c.rows, c.nrows = self.integers(rows.astype(np.int32)), rows.size
        self.value, self.rate, self.rest = coefficients
        c.value, c.rate, c.rest = (self.pointer(array) for array in coefficients)
        c.gaps, c.ngaps = self.integers(gaps.astype(np.int32)), gaps.size
        c.least, c.sees_inside = least, sees_inside
        self.passed = np.zeros(gaps.size, dtype=np.uint8)
        c.passed = ffi.from_buffer("unsigned char[]", self.passed)
        self.any = bool(rows.size or gaps.size)

    def __call__(self, first: tuple[Array, Array, Array], x1: Array, end: Workspace, h: float) -> int:
        """Return what may happen in a step of length h [s]: TOUCHES, PASSES, both, or zero.

        Parameters
        ----------
        first : tuple of ndarray (n,), (m,), (m,)
            Coordinates, deformations and their rates at the start.
        x1 : ndarray (n,)
            Coordinates at the end.
        end : Workspace
            It holds the end.
        """
        x0, e0, w0, x1 = (ffi.from_buffer("double[]", numbers) for numbers in (*first, x1))
        return int(lib.flexel_touching_look(self.struct, end.struct, x0, e0, w0, x1, h, 1, 0))
