"""Evaluates a model at a state through the engine in C.

The rows of stacked arrays are the quantities [deformations | slips | coordinates] of `flexel.model.structure`;
symbols as in the formulation: e, De, V, γ, M, h, f, σ, τ, Φ, Ψ.  The matrix J stacks De, V and the identity, so that
the rate of any quantity is a row of J times v.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.nested import Levels
from flexel.base.once import once
from flexel.engine.outputs import OutputTable, element_outputs, ranged
from flexel.engine.patterns import Pattern
from flexel.engine.tables import Tables
from flexel.engine.workspace import Workspace
from flexel.model.instances import Instance
from flexel.model.structure import Structure

LARGE = 400  # coordinates above which matrices are returned as sparse ones


class Evaluation:
    """The compiled kernels of a structure; each thread has its own workspace.

    Attributes
    ----------
    structure : Structure
    tables : Tables
    large : bool
        Whether matrices are sparse.
    """

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        self.large = structure.n > LARGE
        self._works = Levels(lambda: Workspace(self.tables))

    @once
    def tables(self) -> Tables:
        """The tables, made when they are first needed."""
        return Tables(self.structure)

    @once
    def ranged(self) -> list[OutputTable]:
        """The elements whose pages declare a range in which they are valid, by type."""
        return ranged(self.structure)

    @once
    def inertia(self) -> Array:
        """Inertia (n,) of each coordinate as drawn: the diagonal of M."""
        M = self.tables.M
        return np.asarray(M.matrix(self.work.samples[-1][: M.size]).diagonal())

    def __reduce__(self) -> tuple[type[Evaluation], tuple[Structure]]:
        """Pickle as the structure; the tables are made again when they are first needed."""
        return Evaluation, (self.structure,)

    def __deepcopy__(self, _: object) -> Evaluation:
        """Return the same tables, which belong to a structure that never changes."""
        return self

    @property
    def work(self) -> Workspace:
        """The workspace of this thread; functions of the user that an evaluation calls have another one."""
        return self._works.present()

    def matrix(self, pattern: Pattern, values: Array) -> Any:
        """Return a matrix of a pattern: dense, or sparse in a large model."""
        found = pattern.matrix(values)
        return found if self.large else found.toarray()

    def position(self, x: Array, unwrap_from: Array | None = None) -> tuple[Array, Any]:
        """Compute deformations e (m,), and J = [De; V; 1] (m + k + n, n).

        Parameters
        ----------
        x : ndarray (n,)
        unwrap_from : ndarray (m,), optional
            Deformations from which whole periods are counted; e holds principal values by default.
        """
        work = self.work
        if np.shape(x) != work.x.shape:
            raise ModelError(f"position: x has shape {np.shape(x)}; give {work.x.size} numbers")
        work.x[:] = x
        work.unwrap_from[:] = 0.0 if unwrap_from is None else unwrap_from
        work.position()
        return work.e.copy(), self.matrix(self.tables.J, work.J)

    def outputs(self, elements: Sequence[Instance], x: Array, e: Array, stresses: Array) -> dict[str, Array]:
        """Compute the outputs of some elements of one type at states; see `flexel.engine.outputs.element_outputs`."""
        return element_outputs(self.structure, elements, x, e, stresses)

    # -- the rest of an evaluation: at the position of the workspace, see `at` ----------------------

    def at(
        self,
        t: float,
        x: Array,
        v: Array,
        a: Array | None = None,
        z: Array | None = None,
        unwrap_from: Array | None = None,
    ) -> Workspace:
        """Return the workspace with deformations, J and rates at a state; all else is evaluated on demand.

        Parameters
        ----------
        t : float
        x, v : ndarray (n,)
        a : ndarray (n,), optional
            Accelerations; zero by default.
        z : ndarray (nz,), optional
            Internal states of laws; their initial values by default.
        unwrap_from : ndarray (m,), optional
            Deformations from which whole periods are counted.
        """
        work = self.work
        work.struct.t = t
        work.x[:], work.v[:], work.a[:] = x, v, 0.0 if a is None else a
        work.z[:] = self.structure.z0 if z is None else z
        work.unwrap_from[:] = 0.0 if unwrap_from is None else unwrap_from
        work.position()
        work.rates()
        return work
