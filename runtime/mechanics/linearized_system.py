"""Linearized equations about a state: matrices by name, eigenvalues, modes.

M̄ δq_d'' + C̄ δq_d' + K̄ δq + Z δz = F̄ δu, δq_k' = 𝒜 δq_d' + ℬ δq, and for internal states of laws
δz' = Z_v δq_d' + Z_q δq + Z_z δz.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from flexel.base.arguments import index
from flexel.base.arguments import names as checked_names
from flexel.base.arrays import Array, ComplexArray
from flexel.base.blas import in_one_thread
from flexel.base.copies import Portable
from flexel.base.errors import LinearizationError, ModelError
from flexel.base.shown import Listing, PrintedTable, counted, listed, prints
from flexel.base.units import rate_unit
from flexel.engine.derivatives import Derivatives, Tangents
from flexel.mechanics.modes import (
    Mode,
    Reduced,
    check_decoupled,
    first_order,
    modes_of,
    places_of,
    sort_eigenvalues,
)
from flexel.mechanics.rigid import spectrum
from flexel.mechanics.soft import Spectrum, corrected
from flexel.mechanics.steadiness import (
    UNSTEADY,
    VARYING,
    acceleration,
    check_steady,
    warn_of_instant,
    warn_of_variation,
)
from flexel.mechanics.transfer import GeometricTransfer
from flexel.mechanics.variation import FREE, Afterwards
from flexel.model.controller import refuse_sampled
from flexel.model.state import State

INSTEAD = (
    "between its instants the loop is open; linearize().sampled() gives the eigenvalues of the closed loop"
)


@dataclass(frozen=True, repr=False)
class LinearizedSystem(Portable):
    """Linearized equations about a state; `flexel.Linearization`, which adds plots and files, lists its attributes."""

    M: Array
    C: Array
    K: Array
    A_k: Array
    B_k: Array
    M_u: Array = field(repr=False)
    C_u: Array = field(repr=False)
    K_u: Array = field(repr=False)
    A_ku: Array = field(repr=False)
    B_ku: Array = field(repr=False)
    Z: Array = field(repr=False)
    Z_v: Array = field(repr=False)
    Z_q: Array = field(repr=False)
    Z_z: Array = field(repr=False)
    Z_vu: Array = field(repr=False)
    Z_qu: Array = field(repr=False)
    dynamic: tuple[str, ...]
    kinematic: tuple[str, ...]
    prescribed: tuple[str, ...]
    internal: tuple[str, ...]
    state: State = field(repr=False)
    transfer: GeometricTransfer = field(repr=False)
    derivatives: Derivatives | Tangents = field(repr=False)

    @prints
    def __repr__(self) -> str:
        others = ((self.kinematic, "kinematic coordinate"), (self.internal, "state of laws"))
        more = [counted(len(names), what) for names, what in others if names]
        coordinates = ", ".join([listed(self.dynamic) or "nothing", *more])
        return f"{type(self).__name__}(about t = {self.state.t:g} s in {coordinates})"

    def _repr_html_(self) -> str:
        names = (*self.dynamic, *self.kinematic, *self.internal)
        modes = modes_of(self._spectrum(), names, len(self.dynamic))
        note = (
            ""
            if self.acceleration <= UNSTEADY
            else "; the state accelerates, so these are not modes of a motion"
        )
        return PrintedTable(f"{self!r}{note}", Mode.HEAD, [mode.row() for mode in modes]).html

    @cached_property
    def tangents(self) -> Tangents:
        """Derivatives at the state, as dense arrays."""
        return self.derivatives.dense()

    @property
    def dofs(self) -> tuple[str, ...]:
        """Names of q = (q_d, q_k)."""
        return self.dynamic + self.kinematic

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the states (q_d', q_d, q_k, z)."""
        return tuple(f"{name}'" for name in self.dynamic) + self.dofs + self.internal

    @property
    def state_matrix(self) -> Array:
        """Matrix of the first-order equations for (δq_d', δq_d, δq_k, δz), (2 nd + nk + nz) square."""
        rolling, internal_states = (self.A_k, self.B_k), (self.Z_v, self.Z_q, self.Z_z)
        return first_order(self.M, (self.C, self.K, self.Z), rolling, internal_states)

    @in_one_thread
    def eigenvalues(self) -> ComplexArray:
        """Return all eigenvalues [1/s] of the state matrix, sorted by real, then imaginary part.

        Those of rigid-body motions and of coordinates that enter no force are zero, without rounding errors.

        Warns
        -----
        UnsteadyWarning
            If the state accelerates, or prescribed motions make the coefficients vary in time.
        """
        found = self._spectrum()
        self._check("eigenvalues", found)
        return sort_eigenvalues(found[0])

    @property
    def acceleration(self) -> float:
        """The largest residual force, relative to the balancing forces.

        Zero for an equilibrium or a motion with constant rates of the degrees of freedom; one in free fall.
        """
        return acceleration(self.M, self.transfer.H[:, : len(self.dynamic)], self.state)

    @in_one_thread
    def modes(self) -> Listing[Mode]:
        """Return the modes, one per complex pair (with positive imaginary part); sorts and warns as `eigenvalues`."""
        found = self._spectrum()
        self._check("modes", found)
        return modes_of(found, self.dofs + self.internal, len(self.dynamic))

    def variation(self) -> float:
        """Return how much the coefficients change while the motion goes on, as the vibrations feel it.

        See `Afterwards.change`.  Zero for equations that were pickled or read from a file, which no longer have a
        system.
        """
        afterwards: Afterwards | None = getattr(self, "_afterwards", None)
        return 0.0 if afterwards is None else afterwards.change(self, self._spectrum())

    def _check(self, owner: str, found: Spectrum | None = None) -> None:
        """Refuse eigenvalues if a controller is sampled; warn if the state is not steady or coefficients vary.

        Parameters
        ----------
        owner : str
            What is named in the error and the warning.
        found : tuple of ndarray, optional
            Eigenvalues, left and right eigenvectors, if they are known.
        """
        refuse_sampled(self.state.structure.controllers, owner, INSTEAD)
        off = self.acceleration
        check_steady(owner, off)
        afterwards: Afterwards | None = getattr(self, "_afterwards", None)
        if off > UNSTEADY or afterwards is None:
            return
        found = found or self._spectrum()
        drift = afterwards.drift(self, found)
        if drift > UNSTEADY:
            warn_of_instant(owner, drift, self._moving)
        elif (change := afterwards.change(self, found)) > VARYING:
            warn_of_variation(owner, change, self._moving)

    @property
    def _moving(self) -> list[str]:
        """Names of the degrees of freedom with rates."""
        least = FREE * float(np.abs(self.state.rates).max(initial=0.0))
        return [name for name in self.dofs if abs(self.state.rate(name)) > least]

    def _spectrum(self) -> Spectrum:
        """Compute eigenvalues, left and right eigenvectors of the state matrix; refine small eigenvalues."""
        A = self.state_matrix
        forces = np.hstack([self.C, self.K, self.Z])
        return corrected(spectrum(A, len(self.dynamic)), self.M, forces, A)

    @in_one_thread
    def reduced(self, names: Sequence[str], tolerance: float = 1e-9) -> Reduced:
        """Reduce to second-order equations of the named dynamic degrees of freedom, checked to be decoupled.

        Raises
        ------
        LinearizationError
            If another degree of freedom enters their equations by more than `tolerance` of the largest entry.
        """
        i, nd = places_of(names, self.dynamic), len(self.dynamic)
        rows = np.hstack([self.M, self.C, self.K, self.Z])[i]
        columns = {"M": self.dynamic, "C": self.dynamic, "K": self.dofs, "Z": self.internal}
        check_decoupled(names, columns, np.abs(rows).max(axis=0).tolist(), tolerance)
        return Reduced(tuple(names), rows[:, i], rows[:, nd + i], rows[:, 2 * nd + i])

    @in_one_thread
    def input_matrix(self, names: Sequence[str]) -> Array:
        """Return F̄ (nd, inputs): generalized forces of loads on the named coordinates, deformations or slips."""
        rows = [self.state.structure.find(name, "input") for name in checked_names(names, "inputs")]
        for name, i in zip(names, rows, strict=True):
            if i >= self.state.rates.size - self.state.x.size + self.state.structure.nf:
                raise LinearizationError(f"input '{name}' is a fixed coordinate and moves nothing; drop it")
        nd, nf = len(self.dynamic), self.state.structure.nf
        return np.asarray((self.state.J[rows, :nf] @ self.transfer.H[:, :nd]).T)

    @property
    def units(self) -> dict[str, str]:
        """Units of the degrees of freedom, their rates (``name'``), prescribed motions and internal states, by name.

        A row of M, C or K is the generalized force dual to its degree of freedom, per unit of the degree of freedom of
        its column or of its rates.
        """
        s = self.state.structure
        own = {name: s.units[s.index[name]] for name in (*self.dofs, *self.prescribed)}
        rates = {f"{name}'": rate_unit(own[name], 1) for name in self.dynamic}
        return own | rates | {name: s.internal_units[s.internal[name]] for name in self.internal}

    @in_one_thread
    def mode(self, number: int) -> Mode:
        """Return the mode of that number, from 0, in the order of `modes`.

        Raises
        ------
        ModelError
            The mode does not exist.
        """
        modes, number = self.modes(), index(number, "mode", "number")
        if not -len(modes) <= number < len(modes):
            raise ModelError(
                f"mode {number}: there are {len(modes)} modes, numbered from 0; list them with modes()"
            )
        return modes[number]

    @in_one_thread
    def mode_shape(self, number: int) -> dict[str, complex]:
        """Return displacements of all free coordinates in a mode, for pictures; at most 1 for degrees of freedom."""
        mode = self.mode(number)
        q = np.array([mode.shape[name] for name in self.dofs])
        x, structure = self.transfer.G[:, : q.size] @ q, self.state.structure
        first = structure.m + structure.k
        return {structure.names[first + i]: complex(amplitude) for i, amplitude in enumerate(x)}
