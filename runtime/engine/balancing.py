"""The balance of forces of a workspace in C, with the arrays that it reads and writes."""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array, Index
from flexel.engine.structs import Struct
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib


class Balancing(Struct):
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
        super().__init__(ffi.new("flexel_balance *"))
        self.work = work
        self.struct.work = work.struct
        self.struct.nforce, self.struct.nh = rows.size, period.size
        self.struct.rows = self.integers(rows.astype(np.int32))
        self.struct.period = self.pointer(period)
        self.nodal, self.force = (self.new(name, s.n) for name in ("nodal", "force"))
        self.applied, self.given, self.size = (
            self.new(name, s.m + s.k) for name in ("applied", "given", "size")
        )
        self.target, self.gap = (self.new(name, period.size) for name in ("target", "gap"))
        self.mu, self.r = self.new("mu", rows.size), self.new("r", s.nf)
        self.known = self.new("known", s.nz)

    def run(self) -> None:
        """Compute the balance at the state of the workspace."""
        lib.flexel_balanced(self.struct)

    def tangent(self, scaling: float, rate: float, acceleration: float, share: float) -> bool:
        """Compute T, the derivatives of r, rates and accelerations varying with x; False if a law has no slope."""
        return not lib.flexel_balance_tangent(self.struct, scaling, rate, acceleration, share)
