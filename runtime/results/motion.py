"""A motion: states over time, by name, with energy, drift, events and dense output."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, SupportsIndex, overload

import numpy as np

from flexel.base.arguments import number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.outside import DataFrame, Dataset
from flexel.integration.ledger import energy_balance
from flexel.mechanics.core import Core
from flexel.results.drawn import DrawnMotion
from flexel.results.given import check_given, given_in
from flexel.results.quantities import history
from flexel.structure.state import State
from flexel.structure.structure import Structure

if TYPE_CHECKING:
    from flexel.integration.outcome import Integration


class Motion(DrawnMotion, Sequence[State]):
    """The states of a simulated or prescribed motion at the stored times, from a simulation or a file.

    ``motion["rod.bend1"]`` is the time history (nt,) of a quantity, ``motion["rod.bend1'"]`` of its rate,
    ``motion["rod.bend1''"]`` of its acceleration, ``motion["force:rod.bend1"]`` of its stress or reaction; plots and
    tables use the same names.  ``motion[i]`` is the i-th state.

    Attributes
    ----------
    t : ndarray (nt,)
        Stored times [s].
    events : list of (str, State)
        Events in the order of their occurrence.
    statistics : dict of str to int
        Steps, evaluations of the equations of motion, changes of coordinates.
    message : str
        How the integration ended, why its method was chosen, and the warnings.
    warnings : tuple of str
        What the method knows against the motion; each was also issued as a Python warning when it was computed.
    rechoices : list of (float, tuple of str, tuple of str)
        Changes of the degrees of freedom within an explicit integration: times [s], old and new names.
    ledger : dict of str to list of float, optional
        For an implicit integration, at the stored times: energy in contacts, energy dissipated and work so far [J];
        see `energy_balance`.
    """

    def __init__(self, system: Core | None, integration: Integration) -> None:
        self._system = system
        self._states = integration.states
        self._segments = integration.segments
        self.events = integration.events
        self.statistics = integration.statistics
        self.message = integration.message
        self.ledger = integration.ledger
        self.rechoices = integration.rechoices
        self.warnings = tuple(integration.warnings)
        self.t: Array = np.array(integration.states.times)
        self._given = given_in(self._segments, self.t)

    def __len__(self) -> int:
        return len(self._states)

    def __iter__(self) -> Iterator[State]:
        return iter(self._states)

    def __repr__(self) -> str:
        return f"Motion({len(self)} states, t = {self.t[0]:g} … {self.t[-1]:g} s; {self.message})"

    @overload
    def __getitem__(self, key: str) -> Array: ...
    @overload
    def __getitem__(self, key: SupportsIndex) -> State: ...
    @overload
    def __getitem__(self, key: slice) -> list[State]: ...
    def __getitem__(self, key: str | SupportsIndex | slice) -> Array | State | list[State]:
        if isinstance(key, str):
            return self.series(key)[0]
        if isinstance(key, float):
            raise ModelError(
                f"motion[{key:g}]: states are indexed by integers; for the state at a time use motion.at({key:g})"
            )
        return self._states[key]

    @property
    def system(self) -> Core:
        """The system of the motion; a motion from a file has none."""
        if self._system is None:
            raise ModelError(
                "this motion comes from a file and has no system; build its model and restore the state to continue "
                "from: system.restore(motion)"
            )
        return self._system

    @property
    def structure(self) -> Structure:
        """Nodes, elements and names."""
        return self._states[0].structure

    @property
    def dofs(self) -> tuple[str, ...]:
        """Names of the dynamic degrees of freedom at the start."""
        return tuple(self.structure.names[i] for i in self._states[0].roles.dynamic)

    def series(self, name: str) -> tuple[Array, str]:
        """Values (nt,) and unit of a quantity; primes select rates, the prefix ``force:`` the stress.

        Raises
        ------
        ModelError
            An unknown name, more than two primes, the value of a slip.
        """
        z = history(self.structure, name)
        if not z.order:
            return np.array([state[z.base] for state in self._states]), z.unit
        read = {-1: self.force, 1: self.rate, 2: self.acceleration}
        return read[z.order](z.base), z.unit

    def unit(self, name: str) -> str:
        """Unit of a quantity, of its rate (``name'``), its acceleration (``name''``) or its force (``force:name``)."""
        return history(self.structure, name).unit

    def rate(self, name: str) -> Array:
        """Time history (nt,) of the rate of a quantity, or of a slip."""
        return np.array([state.rate(name) for state in self._states])

    def acceleration(self, name: str) -> Array:
        """Time history (nt,) of the second rate of a quantity."""
        return np.array([state.acceleration(name) for state in self._states])

    def force(self, name: str) -> Array:
        """Time history (nt,) of a stress or reaction; a prescribed deformation is driven by minus its stress."""
        return np.array([state.force(name) for state in self._states])

    def position(self, node: str) -> Array:
        """Coordinates (nt, …) of a node over time."""
        return np.array([state.position(node) for state in self._states])

    def velocity(self, node: str) -> Array:
        """Rates (nt, …) of a node's coordinates over time."""
        return np.array([state.velocity(node) for state in self._states])

    @property
    def x(self) -> Array:
        """All coordinates (nt, n)."""
        return np.array([state.x for state in self._states])

    @property
    def v(self) -> Array:
        """All rates (nt, n)."""
        return np.array([state.v for state in self._states])

    @property
    def energy(self) -> dict[str, Array]:
        """Kinetic, potential, strain and total energy [J] over time, each (nt,).

        Raises
        ------
        ModelError
            If the motion comes from a file without energies, as SPACAR's are.
        """
        if np.isnan(self._states[0].energy.total):
            raise ModelError(
                "this motion comes from a file without energies; build its model and restore its states: "
                "system.restore(motion, time).energy"
            )
        names = ("kinetic", "potential", "strain", "total")
        return {z: np.array([getattr(state.energy, z) for state in self._states]) for z in names}

    def energy_balance(self) -> dict[str, Array]:
        """Energies [J] of an implicit integration over time, each (nt,).

        kinetic, potential, strain (of laws other than contacts), contact; dissipated, and work of prescribed
        motions and of loads without a potential, both since the start; error: the discrepancy, which is the error of
        the integration, numerical damping included.

        Raises
        ------
        ModelError
            If the motion has no ledger of its losses.
        """
        if self.ledger is None:
            raise ModelError(
                'this motion has no energy balance; simulate with method="generalized-alpha" for one'
            )
        return energy_balance(self.energy, self.ledger)

    @property
    def drift(self) -> Array:
        """Largest relative violation of the constraints at each stored time (nt,)."""
        return np.array([state.drift for state in self._states])

    @property
    def dense(self) -> bool:
        """Whether `at` returns states between the stored times."""
        return bool(self._segments)

    def nearest(self, t: float) -> State:
        """The stored state nearest to a time."""
        return self._states[int(np.argmin(np.abs(self.t - number(t, "motion.nearest", "time"))))]

    def at(self, t: float) -> State:
        """State at any time within the motion, from the integrator's dense output.

        Raises
        ------
        ModelError
            If the motion does not cover the time, or a load or a prescribed motion gives other values than when it
            was computed.
        """
        if not self._segments:
            raise ModelError(
                "this motion has no dense output (a path, implicit integration, or a file); give the times to store"
            )
        t = number(t, "motion.at", "time")
        begin, end = self._segments[0].t0, self._segments[-1].t1
        if not begin <= t <= end:
            before = "; the part before comes from a file" if self.t[0] < begin else ""
            raise ModelError(f"time {t:g} s lies outside the motion, {begin:g}…{end:g} s{before}")
        check_given(self._segments, self._given)
        segment = next(z for z in self._segments if t <= z.t1)
        return segment.state(t)

    # -- tables and files ------------------------------------------------------------------------

    def to_xarray(self, *names: str) -> Dataset:
        """An xarray.Dataset: one variable for each name, or everything, labelled, if none is given."""
        from flexel.results.saved.tables import motion_dataset

        return motion_dataset(self, names)

    def to_pandas(self, *names: str) -> DataFrame:
        """A pandas.DataFrame over time, a column for each name; all values if none is given.

        The units are in its ``attrs["units"]``.
        """
        from flexel.results.saved.tables import motion_frame

        return motion_frame(self, names)

    def save(self, path: str | Path) -> Path:
        """Write the motion, names and units included, as .nc, .npz, .mat or .csv; `flexel.load` reads it back.

        Examples
        --------
        >>> motion.save("bicycle.nc")  # doctest: +SKIP
        >>> fx.load("bicycle.nc")["lean.angle"]  # doctest: +SKIP
        """
        from flexel.results.saved.archive import record_of
        from flexel.results.saved.files import write

        return write(record_of(self), path)
