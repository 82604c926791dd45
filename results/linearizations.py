"""Linearized equations of many variants of a system, and at many rates, as results."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexel.base.arguments import index
from flexel.base.arguments import names as checked_names
from flexel.base.arrays import Array, ComplexArray
from flexel.base.blas import in_one_thread
from flexel.base.errors import ModelError
from flexel.base.outside import Dataset, Figure
from flexel.base.shown import counted, listed, prints
from flexel.linear.tracking import Branches
from flexel.mechanics.modes import check_decoupled, first_order, places_of
from flexel.results.linearization import Linearization
from flexel.results.saved.record import require


@dataclass(frozen=True)
class Linearizations:
    """Linearized equations of variants, or of variants at several rates; NaN for those that failed.

    Attributes
    ----------
    M, C, K, A_k, B_k, Z, Z_v, Z_q, Z_z : ndarray (variants, …) or (variants, rates, …)
        The matrices of `Linearization`, stacked.
    dynamic, kinematic, internal : tuple of str
        Names of the degrees of freedom and of the laws' internal states.
    parameters : dict of str to ndarray (variants, …)
        The varied parameters.
    rates : dict of str to ndarray (rates,)
        The rates that were given; empty if there are none.
    failed : dict of int to str
        Messages of variants that failed, by their number.
    """

    M: Array
    C: Array
    K: Array
    A_k: Array = field(repr=False)
    B_k: Array = field(repr=False)
    Z: Array = field(repr=False)
    Z_v: Array = field(repr=False)
    Z_q: Array = field(repr=False)
    Z_z: Array = field(repr=False)
    dynamic: tuple[str, ...]
    kinematic: tuple[str, ...]
    internal: tuple[str, ...]
    parameters: Mapping[str, Array]
    rates: Mapping[str, Array]
    failed: Mapping[int, str]
    recompute: Callable[[int, int], Linearization] = field(repr=False)

    @prints
    def __repr__(self) -> str:
        rates = f" at {counted(self.M.shape[1], 'rate')}" if self.rates else ""
        failed = f", {len(self.failed)} failed" if self.failed else ""
        return f"Linearizations({counted(len(self), 'variant')}{rates}{failed}; {listed(self.dofs)})"

    def __len__(self) -> int:
        """Number of variants."""
        return int(self.M.shape[0])

    @property
    def dofs(self) -> tuple[str, ...]:
        """Names of q = (q_d, q_k)."""
        return self.dynamic + self.kinematic

    @in_one_thread
    def linearization(self, variant: int, rate: int = 0) -> Linearization:
        """Compute the whole linearization of one variant again, with its inputs, modes and state.

        Raises
        ------
        ModelError
            A number that does not exist.
        FlexelError
            The error of the variant.
        """
        counts = len(self), self.M.shape[1] if self.rates else 1
        for what, i, count in zip(("variant", "rate"), (variant, rate), counts, strict=True):
            if isinstance(i, bool) or not isinstance(i, (int, np.integer)) or not 0 <= i < count:
                raise ModelError(f"linearization: {what} {i!r}; give a number from 0 to {count - 1}")
        return self.recompute(int(variant), int(rate))

    @property
    def state_matrices(self) -> Array:
        """First-order equations (…, n, n), each as `Linearization.state_matrix`; NaN where a variant failed."""
        good = np.isfinite(self.M).all(axis=(-2, -1))
        forces, rolling, internal_states = (
            [block[good] for block in blocks]
            for blocks in ((self.C, self.K, self.Z), (self.A_k, self.B_k), (self.Z_v, self.Z_q, self.Z_z))
        )
        some = first_order(self.M[good], forces, rolling, internal_states)
        A = np.full((*good.shape, *some.shape[1:]), np.nan)
        A[good] = some
        return A

    @in_one_thread
    def eigenvalues(self) -> ComplexArray:
        """Return the eigenvalues (…, n) [1/s] of the state matrices, unordered; NaN where a variant failed."""
        return _eigenvalues(self.state_matrices)

    @in_one_thread
    def reduced(self, names: Sequence[str], tolerance: float = 1e-9) -> Linearizations:
        """Reduce to equations of the named dynamic degrees of freedom, checked to be decoupled in every variant.

        Raises
        ------
        LinearizationError
            If another degree of freedom enters their equations by more than `tolerance` of the largest entry.
        """
        names, i = tuple(checked_names(names, "reduced")), places_of(names, self.dynamic)
        columns = {"M": self.dynamic, "C": self.dynamic, "K": self.dofs, "Z": self.internal}
        rows = np.concatenate([getattr(self, matrix)[..., i, :] for matrix in columns], axis=-1)
        sizes = np.abs(rows).max(axis=-2).reshape(-1, rows.shape[-1])
        for worst in _worst(names, columns, sizes[np.isfinite(sizes).all(axis=1)]):
            check_decoupled(names, columns, worst.tolist(), tolerance)
        first, n = self.M.shape[:-2], len(names)
        blocks = {matrix: getattr(self, matrix)[..., i, :][..., i] for matrix in ("M", "C", "K")}
        sizes_of = {"A_k": (0, n), "B_k": (0, n), "Z": (n, 0), "Z_v": (0, n), "Z_q": (0, n), "Z_z": (0, 0)}
        blocks |= {matrix: np.zeros((*first, *size)) for matrix, size in sizes_of.items()}
        return replace(self, dynamic=names, kinematic=(), internal=(), **blocks)

    def to_xarray(self) -> Dataset:
        """Return M, C, K and the eigenvalues as an xarray.Dataset, with parameters, rates and names along the axes."""
        xarray = require("xarray", "xarray")
        lead = ("variant", "rate") if self.rates else ("variant",)
        data: dict[str, Any] = {
            matrix: ((*lead, "row", "column"), getattr(self, matrix)) for matrix in ("M", "C")
        }
        w = self.eigenvalues()
        data["K"] = (*lead, "row", "dof"), self.K
        data["eigenvalues_re"] = (*lead, "eigenvalue"), w.real, {"units": "1/s"}
        data["eigenvalues_im"] = (*lead, "eigenvalue"), w.imag, {"units": "1/s"}
        data["failed"] = "variant", [self.failed.get(i, "") for i in range(len(self))]
        coordinates: dict[str, Any] = {
            "row": list(self.dynamic),
            "column": list(self.dynamic),
            "dof": list(self.dofs),
        }
        for name, values in self.parameters.items():
            coordinates[name] = (("variant", f"{name}: entry") if values.ndim > 1 else "variant", values)
        coordinates |= {name: ("rate", values) for name, values in self.rates.items()}
        return xarray.Dataset(data, coordinates)


@dataclass(frozen=True)
class RootLoci:
    """Eigenvalues as functions of a rate or parameter; each column is one branch.

    Attributes
    ----------
    name : str
        The rate or parameter of the loci.
    values : ndarray (np,)
    linearizations : Linearizations
        The equations that have these eigenvalues.
    unit : str
        Of the values.
    matrix_at : callable(float) -> ndarray (n, n), optional
        The state matrix at any value of the parameter, where the loci run over one alone.
    """

    name: str
    values: Array
    linearizations: Linearizations
    unit: str = ""
    matrix_at: Callable[[float], Array] | None = field(default=None, repr=False)

    @prints
    def __repr__(self) -> str:
        ends = (
            f" from {self.values[0]:g} to {self.values[-1]:g} {self.unit}".rstrip()
            if len(self.values)
            else ""
        )
        return f"RootLoci({self.name}{ends}, {counted(len(self.values), 'value')}; {self.linearizations!r})"

    @cached_property
    def _tracked(self) -> list[Branches]:
        """Return the branches of each variant; of all together if the loci run over a parameter."""
        own, A = self.linearizations, self.linearizations.state_matrices
        labels = own.dynamic + own.dofs + own.internal
        found = [Branches.of(self.values, matrix, labels) for matrix in (A if own.rates else [A])]
        return [replace(branches, exact=self.matrix_at) for branches in found]

    @in_one_thread
    def branches(self, variant: int = 0) -> Branches:
        """Return the names of the branches, the columns of each, and where they become stable or unstable.

        Parameters
        ----------
        variant : int
            Variant to show, if parameters vary in addition to the rates.
        """
        chosen = index(variant, "root_loci", "variant")
        if not -len(self._tracked) <= chosen < len(self._tracked):
            raise ModelError(f"root_loci: variant {chosen}; give a number from 0 to {len(self._tracked) - 1}")
        return self._tracked[chosen]

    @property
    @in_one_thread
    def eigenvalues(self) -> ComplexArray:
        """Branches (np, n) [1/s], followed by the shapes of their modes; (variants, np, n) where parameters vary
        besides the rates.
        """
        found = np.array([branches.eigenvalues for branches in self._tracked])
        return found if self.linearizations.rates and self.linearizations.parameters else found[0]

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Whether all real parts are negative (np,) or (variants, np)."""
        return np.asarray((self.eigenvalues.real < 0).all(axis=-1))

    def plot(self, path: str | Path | None = None, *, variant: int = 0, **options: Any) -> Figure:
        """Plot real and imaginary parts against the values, or each other with ``plane=True`` (needs matplotlib).

        Parameters
        ----------
        path : path, optional
            File for the figure; the suffix determines the format.
        variant : int
            Variant to show, if parameters vary in addition to the rates.
        **options
            ``names``, ``marks``, ``limits``, ``label``, ``title`` and ``plane``; see
            `flexel.apps.view.loci.root_loci`.  Branches are named after the degree of freedom that participates most.

        Examples
        --------
        >>> loci.plot("loci.png", names={"weave": (6.0, -1.5), "capsize": (8.0, 0.2)})  # doctest: +SKIP
        """
        from flexel.apps.view.figures import axis_label
        from flexel.apps.view.loci import plot_loci
        from flexel.apps.view.options import checked

        label = axis_label([self.name], self.unit) if self.unit else self.name
        return plot_loci(
            self.branches(variant), path, **{"label": label} | checked("plot", plot_loci, options)
        )

    def to_xarray(self) -> Dataset:
        """Return the branches as an xarray.Dataset, in addition to the variables of `Linearizations.to_xarray`."""
        found, w = self.linearizations.to_xarray(), self.eigenvalues
        axes = (
            ("variant", "rate", "branch")[-w.ndim :] if self.linearizations.rates else ("variant", "branch")
        )
        return found.assign(
            branch_re=(axes, w.real, {"units": "1/s"}), branch_im=(axes, w.imag, {"units": "1/s"})
        )


def _worst(names: Sequence[str], columns: Mapping[str, Sequence[str]], sizes: Array) -> Array:
    """Return the equations in which other than the named degrees of freedom have the largest entries (n, columns)."""
    ends = np.cumsum([0, *(len(column) for column in columns.values())]).tolist()
    found = []
    for (label, own), first, end in zip(columns.items(), ends, ends[1:], strict=False):
        if label != "Z":
            largest = sizes[:, first:end].max(axis=1, initial=1e-300)
        foreign = np.array([name not in names for name in own], dtype=bool)
        share = (sizes[:, first:end][:, foreign]).max(axis=1, initial=0.0) / largest
        found.append(sizes[np.argmax(share)] if len(share) else np.zeros(0))
    return np.array(found) if sizes.size else np.zeros((0, ends[-1]))


def _eigenvalues(A: Array) -> ComplexArray:
    found = np.full(A.shape[:-1], np.nan, dtype=complex)
    good = np.isfinite(A).all(axis=(-2, -1))
    if good.any() and A.shape[-1]:
        found[good] = np.linalg.eigvals(A[good])
    return found
