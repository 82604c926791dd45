"""A motion: states over time, by name, with energy, drift, events and dense output.

Imports numpy; pictures are made by `flexel.plot`, imported when asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.errors import ModelError
from flexel.inputs import number
from flexel.ledger import energy_balance
from flexel.state import State
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.integrate import Integration
    from flexel.system import System


class Motion(Sequence[State]):
    """The states of a simulated or prescribed motion at the stored times.

    ``motion["rod.bend1"]`` is the time history (nt,) of a quantity, ``motion[i]`` the i-th state.

    Attributes
    ----------
    t : ndarray (nt,)
        Stored times [s].
    events : list of (str, State)
        Events in the order of their occurrence.
    statistics : dict of str to int
        Steps, evaluations of the equations of motion, changes of coordinates.
    message : str
        How the integration ended.
    """

    def __init__(self, system: System, integration: Integration) -> None:
        self.system = system
        self._states = integration.states
        self._segments = integration.segments
        self.events = integration.events
        self.statistics = integration.statistics
        self.message = integration.message
        self._ledger = integration.ledger
        self.t = np.array([state.t for state in self._states])

    def __len__(self) -> int:
        return len(self._states)

    def __iter__(self) -> Iterator[State]:
        return iter(self._states)

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            return np.array([state[key] for state in self._states])
        return self._states[key]

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
        """Kinetic, potential, strain and total energy [J] over time, each (nt,)."""
        names = ("kinetic", "potential", "strain", "total")
        return {z: np.array([getattr(state.energy, z) for state in self._states]) for z in names}

    def energy_balance(self) -> dict[str, Array]:
        """Energies [J] of an implicit integration over time, each (nt,).

        kinetic, potential, strain (of laws other than contacts), contact; dissipated, and work of prescribed
        motions and of loads without a potential, both since the start; error: what does not add up, which is that of
        the integration, numerical damping included.

        Raises
        ------
        ModelError
            If the motion has no ledger of its losses.
        """
        if self._ledger is None:
            raise ModelError("this motion has no energy balance; integrate with simulate_stiff for one")
        return energy_balance(self.energy, self._ledger)

    @property
    def drift(self) -> Array:
        """Largest relative violation of the constraints at each stored time (nt,)."""
        return np.array([state.drift for state in self._states])

    @property
    def dense(self) -> bool:
        """Whether `at` gives states between the stored times."""
        return bool(self._segments)

    def at(self, t: float) -> State:
        """State at any time within the motion, from the integrator's dense output.

        Raises
        ------
        ModelError
            If the motion does not cover the time.
        """
        if not self._segments:
            raise ModelError(
                "this motion has no dense output (a path, or implicit integration); give times to keep"
            )
        t = number(t, "motion.at", "time")
        if not self.t[0] <= t <= self._segments[-1].t1:
            raise ModelError(
                f"time {t:g} s lies outside the motion, {self.t[0]:g}…{self._segments[-1].t1:g} s"
            )
        segment = next(z for z in self._segments if t <= z.t1)
        return segment.state(self.system, t)

    def plot(self, *names: str, path: str | Path | None = None) -> Any:
        """Time histories of named quantities (needs matplotlib); written to `path` if given."""
        from flexel.plot import plot_histories

        return plot_histories(self, names, path)

    def animate(self, path: str | Path, **options: Any) -> Path:
        """Animation of the mechanism as .gif or .mp4 (needs matplotlib), or .html: see `view`."""
        from flexel.plot import animate

        return animate(self, Path(path), **options)

    def view(self, path: str | Path, **options: Any) -> Path:
        """A page that shows the motion in any browser, without a network; options of `flexel.view.scene_data`."""
        from flexel.view import view_motion

        return view_motion(self, path, **options)
