"""The balance of forces of a workspace in C, with the arrays that it reads and writes."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib


class Balancing:
    """Inputs and outputs of `flexel_balanced`, see balance.h; the state is that of the workspace.

    Attributes
    ----------
    nodal, applied, target, mu : ndarray (n,), (m + k,), (nh,), (nforce,)
        To be set: loads, values of the conditions, multipliers.
    given, force, r, gap : ndarray (m + k,), (n,), (nf,), (nh,)
        Results: stresses of laws and loads, forces on the coordinates, unbalance, errors of the conditions.
    known : ndarray (nz,)
        Known part of the internal states of laws in an implicit step.
    """

    def __init__(self, work: Workspace, rows: Index, period: Array) -> None:
        s = work.tables.structure
        self.work = work
        self.struct: Any = ffi.new("flexel_balance *")
        self._keep: list[Any] = [rows.astype(np.int32), period]
        self.struct.work = work.struct
        self.struct.nforce, self.struct.nh = rows.size, period.size
        self.struct.rows = ffi.from_buffer("int[]", self._keep[0])
        self.struct.period = ffi.from_buffer("double[]", period)
        self.nodal, self.force = (self._new(z, s.n) for z in ("nodal", "force"))
        self.applied, self.given, self.size = (self._new(z, s.m + s.k) for z in ("applied", "given", "size"))
        self.target, self.gap = (self._new(z, period.size) for z in ("target", "gap"))
        self.mu, self.r = self._new("mu", rows.size), self._new("r", s.nf)
        self.known = self._new("known", s.nz)

    def _new(self, name: str, size: int) -> Array:
        array = np.zeros(size)
        self._keep.append(array)
        setattr(self.struct, name, ffi.from_buffer("double[]", array))
        return array

    def run(self) -> None:
        """The balance at the state of the workspace."""
        lib.flexel_balanced(self.struct)

    def tangent(self, scaling: float, rate: float, acceleration: float, share: float) -> bool:
        """Derivatives of r, with rates and accelerations that vary with x, into T; whether all laws have a slope."""
        return not lib.flexel_balance_tangent(self.struct, scaling, rate, acceleration, share)
