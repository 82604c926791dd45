"""Equilibrium, load paths, buckling, vibrations about a state of rest, steady motion."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace

from flexel.base.arguments import flag
from flexel.base.arrays import Array
from flexel.base.errors import IncompleteWarning, UnstableWarning
from flexel.base.shown import Listing
from flexel.integration.branch import Choices
from flexel.integration.outcome import Integration
from flexel.mechanics.bent import warn_bent
from flexel.mechanics.core import Core
from flexel.mechanics.reach import lost, reach, warn_replaced
from flexel.results.motion import Motion
from flexel.statics import compliance, path, stability
from flexel.statics.steady import steady_motion
from flexel.structure.controllers import refuse_sampled
from flexel.structure.moment import Moment
from flexel.structure.state import State, own_state


def _well_chosen(system: Core, state: State) -> State:
    """The state, in the best degrees of freedom where the chosen ones have reached an extreme."""
    own, near = system.kinematics_of(state.roles), Moment.of(state)
    present = reach(own, near)
    most = lost(own.roles)
    better = Choices(system, own, free=True).worse(near, present, most) if present > most else None
    if better is None:
        return state
    warn_replaced(own, better, state.t)
    return replace(state, roles=better.roles)


class Equilibria(Core):
    """Statics of a system, and steady motion."""

    def equilibrium(
        self,
        start: State | None = None,
        *,
        t: float | None = None,
        hold: Sequence[str] = (),
        stable: bool = False,
    ) -> State:
        """State of rest in which all forces balance, kinematic coordinates held.

        Newton's method on the analytic tangent; if it fails, the residual forces at the start are removed
        incrementally, past limit points if necessary; if nothing resists a motion at the start, as of a pendulum drawn
        horizontal, it descends in potential energy.

        Parameters
        ----------
        start : State, optional
            Starting point; the initial configuration by default.
        t : float, optional
            Time [s] at which loads and prescribed motions are evaluated; that of `start` by default.
        hold : sequence of str
            Coordinates and deformations held at their values in `start` by the necessary forces
            (``state.force(name)``), such as sheaves that would otherwise turn freely.
        stable : bool
            Accept stable equilibria only: descend further from an unstable one.

        Raises
        ------
        ModelError
            If a name to be held is unknown, or is held, prescribed or fixed already.
        PositionError
            If none is found; reports how far the loads could be increased.  If no stable one is found with `stable`.
        DynamicsError
            If a motion is unresisted; names it.

        Warns
        -----
        UnstableWarning
            If the equilibrium is unstable: by its stiffness, or, where forces have no potential or wheels roll, by the
            eigenvalues of its linearization, if every degree of freedom has inertia and nothing is held.
        RangeWarning
            If a beam is bent or twisted by more than 15° within one element; so in every analysis.
        """
        wanted = flag(stable, "equilibrium", "stable")
        found = path.equilibrium(self, t, _at(self, start, "equilibrium"), hold, stable=wanted)
        if found.unstable:
            warnings.warn(
                f"equilibrium: the one found at t = {found.state.t:g} s is unstable {found.unstable}",
                UnstableWarning,
                stacklevel=2,
            )
        return _checked(_well_chosen(self, found.state), "equilibrium")

    def static_path(self, start: State | None = None, *, t_end: float) -> Motion:
        """Equilibria as time, the load parameter, goes to `t_end`; limit points are passed by arc length.

        Parameters
        ----------
        start : State, optional
            A state of equilibrium (see `equilibrium`); the initial configuration by default.
        t_end : float
            Time [s] at the end of the path, other than that of the start.

        Raises
        ------
        ModelError
            If `t_end` is not a number or is the time of the start.
        PositionError, DynamicsError
            If the start is not in equilibrium.

        Warns
        -----
        IncompleteWarning
            If the path cannot be continued: the states so far are returned, and ``message`` says where and why it
            stopped.
        """
        states, message = path.static_path(self, t_end, _at(self, start, "static_path"))
        if message:
            warnings.warn(message, IncompleteWarning, stacklevel=2)
        found = Integration.of_equilibria(states, message)
        warn_bent(self.structure, found.states.times, found.states.deformations, "static_path")
        return Motion(self, found)

    def buckling(
        self, state: State | None = None, *, increment: Mapping[str, float], count: int = 5
    ) -> Listing[stability.BucklingMode]:
        """Load multipliers at which equilibrium bifurcates, with their shapes, nearest first.

        Parameters
        ----------
        state : State, optional
            A state of rest, with its preload; the unloaded initial configuration by default.
        increment : mapping of name to generalized force
            The loads that are multiplied, e.g. ``{"tip.z": -1.0}``.
        count : int
            Number of modes, at most.

        Raises
        ------
        ModelError
            If the increment is zero or names an unknown or fixed quantity.
        DynamicsError
            If the state is already unstable, or under forces that have no potential, such as follower forces.

        Warns
        -----
        UnsteadyWarning
            If the state is not in equilibrium.
        """
        return stability.buckling(self, _checked(_at(self, state, "buckling"), "buckling"), increment, count)

    def vibrations(self, state: State | None = None, *, count: int = 10) -> Listing[stability.Vibration]:
        """Lowest natural frequencies and modes about a state of rest, without damping.

        Unlike ``linearize(state).modes()`` this needs no choice of independent coordinates.

        Parameters
        ----------
        state : State, optional
            A state of rest; the equilibrium nearest to the initial configuration by default.
        count : int
            Number of modes, at most.

        Raises
        ------
        DynamicsError
            If the state flutters under forces that have no potential, and grows by more than 0.1 % of critical damping
            would take; if a motion has neither mass nor stiffness.

        Warns
        -----
        UnsteadyWarning
            If the state moves or is not in equilibrium; names the coordinate.
        """
        if state is None:
            rest = path.equilibrium(self, None, self.at_rest).state
        else:
            rest = own_state(self.structure, state, "vibrations")
        return stability.vibrations(self, _checked(rest, "vibrations"), count)

    def compliance(
        self,
        point: str,
        frame: str,
        state: State | None = None,
        *,
        offset: Sequence[float] | Array | None = None,
        hold: Sequence[str] = (),
    ) -> compliance.Compliance:
        """Compliance of the body that a point and a frame belong to, at a state of rest.

        Parameters
        ----------
        point, frame : str
            Nodes of the body.
        state : State, optional
            A state of rest, with its preload; the unloaded initial configuration by default.
        offset : sequence of float (3,) or (2,), optional
            From the point to where forces act and displacements are taken, in the frame's axes [m].
        hold : sequence of str
            Coordinates or deformations held in addition to the prescribed ones, such as that of a drive.

        Raises
        ------
        ModelError
            Nodes that are not a point and a frame; names that cannot be held.
        DynamicsError
            If a motion is unresisted; names it.
        """
        rest = _checked(_at(self, state, "compliance"), "compliance")
        return compliance.compliance(self, point, frame, rest, offset=offset, hold=hold)

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
            Starting point; the initial state by default.
        rates : mapping of name to rate, optional
            Given rates of the dynamic degrees of freedom; those of `start` by default.
        unknown : sequence of str, optional
            Degrees of freedom to solve for; all by default (smallest change).
        unknown_rates : sequence of str
            Dynamic degrees of freedom whose rates are solved for too.

        Raises
        ------
        PositionError
            If no steady motion is found near the start; reports what was reached.

        Notes
        -----
        The rates that are held are those of the degrees of freedom.  For a rotating structure name deformations as
        degrees of freedom (`Model.independent`) and prescribe the rotation: with global coordinates the search would
        be for a motion with these at rest.
        """
        refuse_sampled(
            self.structure.controllers, "steady", "simulate it, or take an equilibrium with its outputs held"
        )
        begin = self.initial if start is None else own_state(self.structure, start, "steady")
        return _checked(steady_motion(self, begin, rates, unknown, unknown_rates), "steady")


def _at(system: Core, state: State | None, owner: str) -> State:
    """The given state of rest, which must be one of the system, or its initial configuration."""
    return system.at_rest if state is None else own_state(system.structure, state, owner)


def _checked(state: State, analysis: str) -> State:
    """The same state, with a warning of beams that are bent or twisted too far within one element."""
    warn_bent(state.structure, [state.t], state.e[None], analysis)
    return state
