"""Equilibrium, load paths, buckling, vibrations about a state of rest, steady motion."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace

from flexel.base.arguments import flag
from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.callers import outside
from flexel.base.errors import IncompleteWarning, UnstableWarning
from flexel.base.shown import Listing
from flexel.integration.outcome import Integration
from flexel.mechanics.ranges import warn_beyond
from flexel.mechanics.timed_laws import refuse_steady
from flexel.model.controller import refuse_sampled
from flexel.model.state import State, own_state
from flexel.results.motion import Motion
from flexel.statics import load_path, stability
from flexel.statics.compliance import Compliance
from flexel.statics.compliance import compliance as compliance_of
from flexel.statics.steady import steady_motion
from flexel.system import CoreSystem


@in_one_thread
def equilibrium(
    system: CoreSystem,
    start: State | None = None,
    *,
    t: float | None = None,
    hold: Sequence[str] = (),
    stable: bool = False,
) -> State:
    """Find the state of rest in which all forces balance, with kinematic coordinates held.

    Internal states of laws are held too, but for those that change with displacements only: the bristles of a contact
    follow its slip since the start, in one step.

    Newton's method on the analytic tangent; if it fails, the residual forces at the start are removed
    incrementally, past limit points if necessary; if nothing resists a motion at the start, as for a pendulum
    drawn horizontally, it descends in potential energy.

    Parameters
    ----------
    start : State, optional
        Starting point; the initial configuration by default.
    t : float, optional
        Time [s] at which loads, prescribed motions and laws that depend on time are evaluated; that of `start` by
        default.
    hold : sequence of str
        Coordinates and deformations held at their values in `start` by the necessary forces
        (``state.drive(name)``), such as sheaves that would otherwise turn freely.
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
        If a beam is bent or twisted by more than 15° within one element; this applies to every analysis.
    """
    wanted = flag(stable, "equilibrium", "stable")
    found = load_path.equilibrium(system, t, _at(system, start, "equilibrium"), hold, stable=wanted)
    if found.unstable:
        warnings.warn(
            f"equilibrium: the one found at t = {found.state.t:g} s is unstable {found.unstable}",
            UnstableWarning,
            stacklevel=outside(),
        )
    return _checked(system, found.state, "equilibrium")


@in_one_thread
def static_path(
    system: CoreSystem, start: State | None = None, *, t_end: float, hold: Sequence[str] = ()
) -> Motion:
    """Compute equilibria as time, the load parameter, goes to `t_end`; limit points are passed by arc length.

    The bristles of contacts follow the slip from one equilibrium to the next.

    Parameters
    ----------
    start : State, optional
        A state of equilibrium; by default that near the initial configuration, as `equilibrium` finds it.
    t_end : float
        Time [s] at the end of the path, different from that of the start.
    hold : sequence of str
        Coordinates and deformations held at their values in `start`, as in `equilibrium`.

    Raises
    ------
    ModelError
        If `t_end` is not a number or is the time of the start; if a name to be held is unknown, or is held, prescribed
        or fixed already.
    PositionError
        If the start is not in equilibrium.
    DynamicsError
        If a force acts along a motion that nothing resists; names it.

    Warns
    -----
    IncompleteWarning
        If the path cannot be continued: the states so far are returned, and ``message`` says where and why it
        stopped: at a limit, or where a load has no value, as before the first time of a table.
    UnstableWarning
        If the path becomes unstable where others branch off, as that of a perfect column that buckles. ``verdict`` says
        how many equilibria are unstable.
    """
    given = None if start is None else own_state(system.structure, start, "static_path")
    along = load_path.static_path(system, t_end, given, hold)
    if along.message:
        warnings.warn(along.message, IncompleteWarning, stacklevel=outside())
    if along.branches:
        warnings.warn(f"static_path: {along.branches}", UnstableWarning, stacklevel=outside())
    unstable = sum(map(bool, along.unstable))
    verdict = f"{unstable} of {len(along.states)} equilibria are unstable" if unstable else ""
    found = replace(Integration.of_equilibria(along.states, along.message), verdict=verdict)
    path = found.states
    warn_beyond(system.evaluation, path.times, path.deformations, path.coordinates, "static_path")
    return Motion(system, found)


@in_one_thread
def buckling(
    system: CoreSystem, state: State | None = None, *, increment: Mapping[str, float], count: int = 5
) -> Listing[stability.BucklingMode]:
    """Compute load multipliers at which equilibrium bifurcates, with their shapes, nearest first.

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
        If the state is already unstable, or under forces that have no potential, such as follower forces; if the load
        acts along a motion that nothing resists.

    Warns
    -----
    UnsteadyWarning
        If the state is not in equilibrium.
    """
    return stability.buckling(
        system, _checked(system, _at(system, state, "buckling"), "buckling"), increment, count
    )


@in_one_thread
def vibrations(
    system: CoreSystem, state: State | None = None, *, count: int = 10
) -> Listing[stability.Vibration]:
    """Compute the lowest natural frequencies and modes about a state of rest, without damping.

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
        If the state flutters under forces that have no potential, and grows faster than 0.1 % of critical
        damping would suppress; if a motion has neither mass nor stiffness.

    Warns
    -----
    UnsteadyWarning
        If the state moves or is not in equilibrium; names the coordinate.
    """
    if state is None:
        rest = load_path.equilibrium(system, None, system.at_rest).state
    else:
        rest = own_state(system.structure, state, "vibrations")
    return stability.vibrations(system, _checked(system, rest, "vibrations"), count)


@in_one_thread
def compliance(
    system: CoreSystem,
    point: str,
    frame: str,
    state: State | None = None,
    *,
    offset: Sequence[float] | Array | None = None,
    hold: Sequence[str] = (),
) -> Compliance:
    """Compute the compliance of the body that a point and a frame belong to, at a state of rest.

    Parameters
    ----------
    point, frame : str
        Nodes of the body.
    state : State, optional
        A state of rest, with its preload; the unloaded initial configuration by default.
    offset : sequence of float (3,) or (2,), optional
        From the point to where forces act and displacements are taken, in the frame's axes [m].
    hold : sequence of str
        Coordinates or deformations held in addition to the prescribed ones, such as those of a drive.

    Raises
    ------
    ModelError
        Nodes that are not a point and a frame; names that cannot be held.
    DynamicsError
        If a motion is unresisted; names it.
    """
    rest = _checked(system, _at(system, state, "compliance"), "compliance")
    return compliance_of(system, point, frame, rest, offset=offset, hold=hold)


@in_one_thread
def steady(
    system: CoreSystem,
    start: State | None = None,
    *,
    rates: Mapping[str, float] | None = None,
    unknown: Sequence[str] | None = None,
    unknown_rates: Sequence[str] = (),
) -> State:
    """Find the steady motion or equilibrium near `start`, in which nothing accelerates.

    Parameters
    ----------
    start : State, optional
        Starting point; the initial state by default.
    rates : mapping of name to rate, optional
        Given rates of the dynamic degrees of freedom; the rates of `start` by default.
    unknown : sequence of str, optional
        Degrees of freedom to solve for; all by default (smallest change).
    unknown_rates : sequence of str
        Dynamic degrees of freedom whose rates are solved for too.

    Raises
    ------
    PositionError
        If no steady motion is found near the start; reports what was reached.  If a law depends on time.

    Notes
    -----
    The rates of the degrees of freedom are held.  For a rotating structure name deformations as degrees of
    freedom (`Model.independent`) and prescribe the rotation: with global coordinates the search would look for a
    motion with these at rest.
    """
    refuse_sampled(
        system.structure.controllers, "steady", "simulate it, or take an equilibrium with its outputs held"
    )
    refuse_steady(system.structure)
    begin = system.initial if start is None else own_state(system.structure, start, "steady")
    return _checked(system, steady_motion(system, begin, rates, unknown, unknown_rates), "steady")


def _at(system: CoreSystem, state: State | None, owner: str) -> State:
    """Return the given state of rest, which must be one of the system, or its initial configuration."""
    return system.at_rest if state is None else own_state(system.structure, state, owner)


def _checked(system: CoreSystem, state: State, analysis: str) -> State:
    """Return the same state, and warn of beams that are bent or twisted too far within one element."""
    warn_beyond(system.evaluation, [state.t], state.e[None], state.x[None], analysis)
    return state
