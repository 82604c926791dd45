"""Linearized equations about a state as a result: matrices by name, eigenvalues, modes, state space.

M̄ δq_d'' + C̄ δq_d' + K̄ δq + Z δz = F̄ δu, δq_k' = 𝒜 δq_d' + ℬ δq, and for internal states of laws
δz' = Z_v δq_d' + Z_q δq + Z_z δz.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import index
from flexel.base.arguments import names as checked_names
from flexel.base.arrays import Array, ComplexArray, StateSpace
from flexel.base.copies import Portable
from flexel.base.errors import LinearizationError, ModelError
from flexel.base.outside import DataFrame, Dataset
from flexel.base.shown import Listing
from flexel.base.units import rate_unit
from flexel.engine.derivatives import Derivatives, Tangents
from flexel.mechanics.drawn import DrawnLinearization
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
from flexel.mechanics.sampled import SampledLinearization
from flexel.mechanics.soft import Spectrum, corrected
from flexel.mechanics.steadiness import acceleration
from flexel.mechanics.transfer import Transfer
from flexel.structure.state import State


@dataclass(frozen=True, repr=False)
class Linearization(SampledLinearization, DrawnLinearization, Portable):
    """Linearized equations about a state.

    Attributes
    ----------
    M, C : ndarray (nd, nd)
    K : ndarray (nd, nq)
        Columns for dynamic, then kinematic degrees of freedom.
    A_k, B_k : ndarray (nk, nd), ndarray (nk, nq)
        𝒜 and ℬ of δq_k' = 𝒜 δq_d' + ℬ δq.
    Z : ndarray (nd, nz)
        Generalized forces of the laws' internal states: M δq_d'' + C δq_d' + K δq + Z δz = F δu.
    Z_v, Z_q, Z_z : ndarray (nz, nd), ndarray (nz, nq), ndarray (nz, nz)
        δz' = Z_v δq_d' + Z_q δq + Z_z δz.
    dynamic, kinematic, prescribed, internal : tuple of str
        Names of the degrees of freedom, of the prescribed motions and of the laws' internal states.
    state : State
        The state about which it was linearized.
    """

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
    transfer: Transfer = field(repr=False)
    derivatives: Derivatives | Tangents = field(repr=False)

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
        return tuple(f"{z}'" for z in self.dynamic) + self.dofs + self.internal

    @property
    def state_matrix(self) -> Array:
        """Matrix of the first-order equations for (δq_d', δq_d, δq_k, δz), (2 nd + nk + nz) square."""
        rolling, lags = (self.A_k, self.B_k), (self.Z_v, self.Z_q, self.Z_z)
        return first_order(self.M, (self.C, self.K, self.Z), rolling, lags)

    def eigenvalues(self) -> ComplexArray:
        """All eigenvalues [1/s] of the state matrix, sorted by real, then imaginary part.

        Those of rigid-body motions and of coordinates that enter no force are zero, without rounding errors.

        Warns
        -----
        UnsteadyWarning
            If the state accelerates.
        """
        self._check("eigenvalues")
        return sort_eigenvalues(self._spectrum()[0])

    @property
    def acceleration(self) -> float:
        """The largest residual force, relative to the balancing forces.

        Zero for an equilibrium or a motion with constant rates of the degrees of freedom; one in free fall.
        """
        return acceleration(self.M, self.transfer.H[:, : len(self.dynamic)], self.state)

    def modes(self) -> Listing[Mode]:
        """Modes, one for each complex pair (that with positive imaginary part); sorts and warns as `eigenvalues`."""
        self._check("modes")
        return modes_of(self._spectrum(), self.dofs + self.internal, len(self.dynamic))

    def _spectrum(self) -> Spectrum:
        """Eigenvalues, left and right eigenvectors of the state matrix, small eigenvalues to their last digits."""
        A = self.state_matrix
        forces = np.hstack([self.C, self.K, self.Z])
        return corrected(spectrum(A, len(self.dynamic)), self.M, forces, A)

    def reduced(self, names: Sequence[str], tolerance: float = 1e-9) -> Reduced:
        """Second-order equations of the named dynamic degrees of freedom, after a check that they are decoupled.

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

    def input_matrix(self, names: Sequence[str]) -> Array:
        """F̄ (nd, inputs): generalized forces of loads on the named coordinates, deformations or slips."""
        rows = [self.state.structure.find(name, "input") for name in checked_names(names, "inputs")]
        for name, i in zip(names, rows, strict=True):
            if i >= self.state.rates.size - self.state.x.size + self.state.structure.nf:
                raise LinearizationError(f"input '{name}' is a fixed coordinate and moves nothing; drop it")
        nd, nf = len(self.dynamic), self.state.structure.nf
        return np.asarray((self.state.J[rows, :nf] @ self.transfer.H[:, :nd]).T)

    def state_space(self, inputs: Sequence[str] = (), outputs: Sequence[str] = ()) -> StateSpace:
        """State-space matrices A, B, C, D.

        Parameters
        ----------
        inputs : sequence of str
            Names of loads (any quantity: the generalized force dual to it) or of prescribed motions.  The input of
            a prescribed motion is its acceleration, labelled ``road.y''``; its rate and value join the states, in that
            order.  ``displacement:road.y`` makes its displacement the input: the states are then shifted, so that no
            rates of the input are needed, and marked with a star.
        outputs : sequence of str
            Names of quantities; a suffix ``'`` selects the rate, ``''`` the acceleration, and a prefix
            ``force:`` the stress or reaction.

        Returns
        -------
        A, B, C, D : ndarray
        """
        from flexel.linear.sensors import state_space

        return state_space(self, inputs, outputs)

    def to_control(self, inputs: Sequence[str], outputs: Sequence[str] = (), *, name: str = "flexel") -> Any:
        """A labelled `control.StateSpace` (needs python-control).

        Parameters
        ----------
        inputs, outputs : sequence of str
            As in `state_space`; the outputs are the degrees of freedom if none are named.
        name : str
            Name of the system, for `control.interconnect`.

        Raises
        ------
        FlexelError
            If python-control is not installed.
        LinearizationError, ModelError
            No inputs; duplicate or unknown names.

        Examples
        --------
        >>> plant = lin.to_control(["motor.angle"], ["tip.y", "motor.angle'"])  # doctest: +SKIP
        >>> plant.input_labels, plant.output_labels  # doctest: +SKIP
        (['motor_angle'], ['tip_y', "motor_angle'"])
        """
        from flexel.results.control import to_control

        return to_control(self, inputs, outputs, name=name)

    def to_scipy(self, inputs: Sequence[str], outputs: Sequence[str] = ()) -> Any:
        """A `scipy.signal.StateSpace`; its states, inputs and outputs are in the order of `state_space`."""
        from flexel.results.control import to_scipy

        return to_scipy(self, inputs, outputs)

    def save_state_space(self, path: str | Path, inputs: Sequence[str], outputs: Sequence[str] = ()) -> Path:
        """Write A, B, C, D and the names of states, inputs and outputs to a .mat file, for Matlab's ``ss(A, B, C, D)``.

        Raises
        ------
        ModelError
            A suffix other than .mat.
        """
        from flexel.results.control import save_state_space

        return save_state_space(self, path, inputs, outputs)

    def to_xarray(self) -> Dataset:
        """Matrices, eigenvalues and modes as an xarray.Dataset with names and units along rows and columns."""
        from flexel.results.saved.archive_linear import to_xarray

        return to_xarray(self)

    def to_pandas(self) -> DataFrame:
        """A pandas.DataFrame of the modes: eigenvalue, frequency, damping ratio, and the degrees of freedom that
        take part.
        """
        from flexel.results.saved.archive_linear import to_pandas

        return to_pandas(self)

    def save(self, path: str | Path) -> Path:
        """Write all matrices with their names as .nc, .npz, .mat or .csv; `flexel.load` reads them back.

        For A, B, C and D alone, in Matlab format, see `save_state_space`.
        """
        from flexel.results.saved.archive_linear import save

        return save(self, path)

    @property
    def units(self) -> dict[str, str]:
        """Units of the degrees of freedom, their rates (``name'``), prescribed motions and internal states, by name.

        A row of M, C or K is the generalized force dual to its degree of freedom, per unit of that of its column or of
        its rates.
        """
        s = self.state.structure
        own = {name: s.units[s.index[name]] for name in (*self.dofs, *self.prescribed)}
        rates = {f"{name}'": rate_unit(own[name], 1) for name in self.dynamic}
        return own | rates | {name: s.internal_units[s.internal[name]] for name in self.internal}

    def mode(self, number: int) -> Mode:
        """The mode of that number, from 0, in the order of `modes`.

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

    def mode_shape(self, number: int) -> dict[str, complex]:
        """Displacements of all free coordinates in a mode, for pictures; those of degrees of freedom are at most 1."""
        mode = self.mode(number)
        q = np.array([mode.shape[name] for name in self.dofs])
        x, structure = self.transfer.G[:, : q.size] @ q, self.state.structure
        first = structure.m + structure.k
        return {structure.names[first + i]: complex(z) for i, z in enumerate(x)}
