"""Equilibrium, load paths, buckling, vibrations about a state of rest, steady motion."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence

from flexel.base.errors import IncompleteWarning
from flexel.integration.outcome import Integration
from flexel.mechanics.core import Core
from flexel.results.motion import Motion
from flexel.statics import path, stability
from flexel.statics.steady import steady_motion
from flexel.structure.state import State


class Equilibria(Core):
    """Statics of a system, and steady motion."""

    def equilibrium(
        self, t: float | None = None, start: State | None = None, *, hold: Sequence[str] = ()
    ) -> State:
        """State of rest in which all forces balance, kinematic coordinates held.

        Newton's method on the analytic tangent; where it fails, the forces that are out of balance at the start
        are applied incrementally, past limit points if need be.

        Parameters
        ----------
        t : float, optional
            Time [s] at which loads and prescribed motions are taken; that of `start` by default.
        start : State, optional
            Where to look from; the initial configuration by default.
        hold : sequence of str
            Coordinates and deformations that are held at their values in `start` by whatever force it takes
            (``state.force(name)``), such as sheaves that nothing else keeps from turning.

        Raises
        ------
        ModelError
            If a name to be held is unknown, or is held, prescribed or fixed already.
        PositionError
            If none is found; says how far the loads could be increased.
        DynamicsError
            If nothing resists a motion; names it.
        """
        return path.equilibrium(self, t, start or self.at_rest, hold)

    def static_path(self, t_end: float, start: State | None = None) -> Motion:
        """Equilibria while the time, here the load parameter, goes to `t_end`; past limit points by arc length.

        The start must be in equilibrium (see `equilibrium`).  If the path cannot be continued, what was reached
        is returned with an IncompleteWarning, and ``message`` says where it stopped and why.
        """
        states, message = path.static_path(self, t_end, start or self.at_rest)
        if message:
            warnings.warn(message, IncompleteWarning, stacklevel=2)
        counts = {"steps": len(states) - 1, "evaluations": 0, "rechoices": 0}
        return Motion(self, Integration(states, [], [], counts, message))

    def buckling(
        self, state: State | None = None, *, increment: Mapping[str, float], count: int = 5
    ) -> list[stability.BucklingMode]:
        """Load multipliers at which equilibrium branches, with their shapes, nearest first.

        Parameters
        ----------
        state : State, optional
            A state of rest, with its preload; the unloaded initial configuration by default.
        increment : mapping of name to generalized force
            The loads that are multiplied, e.g. ``{"tip.z": -1.0}``.

        Raises
        ------
        DynamicsError
            If the state is unstable already.
        """
        return stability.buckling(self, state or self.at_rest, increment, count)

    def vibrations(self, state: State | None = None, count: int = 10) -> list[stability.Vibration]:
        """Lowest natural frequencies [rad/s] and modes about a state of rest, damping left out.

        The state is the equilibrium nearest to the initial configuration, if none is given.
        Unlike ``linearize(state).modes()`` this needs no choice of independent coordinates.
        """
        return stability.vibrations(self, state or self.equilibrium(), count)

    def steady(
        self,
        start: State | None = None,
        *,
        rates: Mapping[str, float] | None = None,
        unknown: Sequence[str] | None = None,
        unknown_rates: Sequence[str] = (),
    ) -> State:
        """Steady motion or equilibrium: the state near `start` in which nothing accelerates.

        Parameters
        ----------
        start : State, optional
            Where to look from; the initial state by default.
        rates : mapping of name to rate, optional
            Given rates of the dynamic degrees of freedom; those of `start` by default.
        unknown : sequence of str, optional
            Degrees of freedom to be found; all by default (smallest change).
        unknown_rates : sequence of str
            Dynamic degrees of freedom whose rates are to be found too.

        Raises
        ------
        PositionError
            If no steady motion is found near the start; says what was reached.

        Notes
        -----
        The rates that are held are those of the degrees of freedom.  For a rotating structure name deformations as
        degrees of freedom (`Model.independent`) and prescribe the rotation: with global coordinates in their place a
        motion with these at rest would be looked for.
        """
        return steady_motion(self, start or self.initial, rates, unknown, unknown_rates)
