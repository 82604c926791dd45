"""The states of a motion over time, by name, with energy, drift, events and dense output."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import SupportsIndex, overload

import numpy as np

from flexel.base.arguments import number
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.base.shown import Histories, prints
from flexel.integration.energy_balance import energy_balance
from flexel.integration.given import check_given, given_in
from flexel.integration.outcome import EQUILIBRIA, Integration
from flexel.integration.spectrum import amplitudes
from flexel.model.quantities import history
from flexel.model.state import State
from flexel.model.structure import Structure
from flexel.system import CoreSystem


class Trajectory(Sequence[State]):
    """The states of a motion at the stored times; `flexel.Motion`, which adds plots and files, lists its attributes."""

    def __init__(self, system: CoreSystem | None, integration: Integration) -> None:
        self._system = system
        self._states = integration.states
        self._segments = integration.segments
        self.events = integration.events
        self.statistics = integration.statistics
        self.message = integration.message
        self.energy_terms = integration.energy_terms
        self.rechoices = integration.rechoices
        self.warnings = tuple(integration.warnings)
        self.verdict = integration.verdict
        self.t: Array = np.array(integration.states.times)
        self._given = given_in(self._segments, self.t)

    def __len__(self) -> int:
        return len(self._states)

    def __iter__(self) -> Iterator[State]:
        return iter(self._states)

    @prints
    def __repr__(self) -> str:
        return (
            f"{type(self).__name__}({len(self)} states, t = {self.t[0]:g} … {self.t[-1]:g} s; {self.message})"
        )

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
    def system(self) -> CoreSystem:
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
    def over_time(self) -> bool:
        """Whether `t` is time; for equilibria, between which nothing was integrated, it is the load parameter."""
        return EQUILIBRIA not in self.statistics

    @property
    def dofs(self) -> tuple[str, ...]:
        """Names of the dynamic degrees of freedom at the start."""
        return tuple(self.structure.names[i] for i in self._states[0].roles.dynamic)

    def series(self, name: str) -> tuple[Array, str]:
        """Return values (nt,) and unit of a quantity; primes select rates, the prefix ``force:`` the stress.

        Raises
        ------
        ModelError
            An unknown name, more than two primes, the value of a slip.
        """
        quantity = history(self.structure, name)
        if not quantity.order:
            return np.array([state[quantity.base] for state in self._states]), quantity.unit
        read = {-1: self.force, 1: self.rate, 2: self.acceleration}
        return read[quantity.order](quantity.base), quantity.unit

    def unit(self, name: str) -> str:
        """Return the unit of a quantity, a rate (``name'``), a second rate (``name''``) or a force (``force:name``)."""
        return history(self.structure, name).unit

    def rate(self, name: str) -> Array:
        """Return the time history (nt,) of the rate of a quantity, or of a slip."""
        return np.array([state.rate(name) for state in self._states])

    def acceleration(self, name: str) -> Array:
        """Return the time history (nt,) of the second rate of a quantity."""
        return np.array([state.acceleration(name) for state in self._states])

    def force(self, name: str) -> Array:
        """Return the history (nt,) of a stress or reaction; see `State.force`."""
        return np.array([state.force(name) for state in self._states])

    def drive(self, name: str) -> Array:
        """Return the history (nt,) of the force or moment that drives a quantity; see `State.drive`."""
        return np.array([state.drive(name) for state in self._states])

    def position(self, node: str) -> Array:
        """Return the coordinates (nt, …) of a node over time."""
        return np.array([state.position(node) for state in self._states])

    def velocity(self, node: str) -> Array:
        """Return the rates (nt, …) of a node's coordinates over time."""
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
        found = {part: np.array([getattr(state.energy, part) for state in self._states]) for part in names}
        return Histories("J", found)

    def energy_balance(self) -> dict[str, Array]:
        """Return the energies [J] of an implicit integration over time, each (nt,).

        kinetic, potential, strain (of laws other than contacts), contact; dissipated, and work of prescribed
        motions and of loads without a potential, both since the start; error: the discrepancy, which is the error of
        the integration, numerical damping included.

        Raises
        ------
        ModelError
            If no energy balance was kept for the motion.
        """
        if self.energy_terms is None:
            raise ModelError(
                'this motion has no energy balance; simulate with method="generalized-alpha" for one'
            )
        return Histories("J", energy_balance(self.energy, self.energy_terms))

    @property
    def drift(self) -> Array:
        """Largest relative violation of the constraints at each stored time (nt,)."""
        return np.array([state.drift for state in self._states])

    @property
    def dense(self) -> bool:
        """Whether `at` returns states between the stored times."""
        return bool(self._segments)

    @property
    def interpolates(self) -> bool:
        """Whether such states cost little; generalized-alpha takes its steps again for them."""
        return self.dense and all(segment.interpolates for segment in self._segments)

    def nearest(self, t: float) -> State:
        """Return the stored state nearest to a time."""
        return self._states[int(np.argmin(np.abs(self.t - number(t, "motion.nearest", "time"))))]

    def at(self, t: float) -> State:
        """Return the state at any time within the motion, from the integrator's dense output.

        Raises
        ------
        ModelError
            If the motion does not cover the time, or a load or a prescribed motion gives other values than when it
            was computed.
        """
        if not self._segments:
            raise ModelError(
                "this motion has no dense output (it comes from a file, or is a path); give the times to store"
            )
        t = number(t, "motion.at", "time")
        begin, end = self._segments[0].t0, self._segments[-1].t1
        if not begin <= t <= end:
            before = "; the part before comes from a file" if self.t[0] < begin else ""
            raise ModelError(f"time {t:g} s lies outside the motion, {begin:g}…{end:g} s{before}")
        check_given(self._segments, self._given)
        segment = next(segment for segment in self._segments if t <= segment.t1)
        return segment.state(t)

    def spectrum(self, name: str, window: str = "hann") -> tuple[Array, Array]:
        """Return the one-sided amplitude spectrum of a quantity: a harmonic on a spectral line shows its amplitude.

        Parameters
        ----------
        name : str
            Name as in `Motion.series`.
        window : str
            A window of `scipy.signal.get_window`; ``boxcar`` for a whole number of periods.

        Returns
        -------
        f : ndarray (nf,)
            Frequencies [Hz].
        amplitude : ndarray (nf,)
            In the unit of the quantity.

        Raises
        ------
        ModelError
            Times that are not equidistant, or fewer than four; an unknown window.
        """
        return amplitudes(self.t, self.series(name)[0], name, window)
