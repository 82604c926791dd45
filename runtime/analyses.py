"""The analyses of a system: motion, equilibrium, buckling, vibrations, steady motion; methods of `System`.

Each checks what the user gave and hands the work to the room that does it.
Imports numpy and those rooms.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from flexel import stability, states, statics
from flexel.errors import FlexelError, IncompleteWarning, ModelError, PositionError
from flexel.implicit.bdf import Bdf
from flexel.implicit.steps import Control, GeneralizedAlpha, Run
from flexel.integrate import (
    Event,
    Integration,
    Integrator,
    Segment,
    longest_step,
    positive,
    stored_times,
    turning_weights,
)
from flexel.ranges import warn_outside
from flexel.result import Motion
from flexel.state import State, own_state
from flexel.steady import steady_motion
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.system import System


def simulate(
    self: System,
    duration: float,
    *,
    start: State | None = None,
    times: Sequence[float] | Array | None = None,
    samples: int = 201,
    method: str = "DOP853",
    rtol: float = 1e-9,
    atol: float = 1e-11,
    max_step: float = np.inf,
    events: Sequence[Event] = (),
    progress: bool | None = None,
    rechoose: bool = True,
) -> Motion:
    """Forward dynamics; with no freedoms left, the prescribed motion and its driving forces.

    Parameters
    ----------
    duration : float
        Length of the motion [s].
    start : State, optional
        The initial state by default.
    times : array_like, optional
        Times [s] at which states are kept; `samples` equidistant ones by default.
    method : str
        DOP853, RK45, LSODA, Radau or BDF.
    rtol, atol, max_step : float
        Of the integrator.
    events : sequence of Event
    progress : bool, optional
        Progress bar on stderr; by default where stderr is a terminal.
    rechoose : bool
        Change the freedoms when they become ill-conditioned.

    Returns
    -------
    Motion

    Raises
    ------
    ModelError, PositionError, DynamicsError
        Where the motion cannot go on, with what was computed until then as ``error.motion``.

    Warns
    -----
    RangeWarning
        Where the data of a law were left at a stored time, by name.
    """
    start = self.initial if start is None else own_state(self.structure, start, "simulate")
    grid = stored_times(start, duration, times, samples, "simulate")
    if self.roles.nq == 0:
        return _motion(self, _follow(self, start, grid))
    chosen = self.roles
    if start.roles is not chosen:
        if self.condition(start) > 1e-3 * self.condition(start, start.roles):
            start = self.state(start.t, start.x, start.v, start.e, start.z)
        else:  # the motion has led to where the chosen freedoms are of no use
            self.use(start.roles)
    try:
        run = Integrator(self, start, grid, method, rtol, atol, max_step, events, progress, rechoose)
        try:
            found = run.run()
        except FlexelError as error:
            error.motion = Motion(self, run.kept(str(error), complete=False))
            raise
    finally:
        self.use(chosen)
    return _motion(self, found)


def simulate_stiff(
    self: System,
    duration: float,
    *,
    start: State | None = None,
    times: Sequence[float] | Array | None = None,
    samples: int = 201,
    tolerance: float = 1e-6,
    radius: float = 0.8,
    step: float | None = None,
    first_step: float | None = None,
    max_step: float = np.inf,
    newton: str = "full",
    method: str = "alpha",
    max_order: int = 2,
    progress: bool | None = None,
) -> Motion:
    """Implicit dynamics of a stiff model by the generalized-alpha method, whatever the freedoms.

    The cost of a step grows linearly with the number of elements.  Where a step does not converge it is halved,
    and a few times where a contact begins.  If the integration cannot go on, the motion up to there is returned with an
    IncompleteWarning, and ``message`` says why; its last state can be started from again.

    Parameters
    ----------
    duration : float
        Length of the motion [s].
    start : State, optional
        The initial state by default; a state of rest serves where a freedom has no inertia.
    times : array_like, optional
        Times [s] at which states are kept; `samples` equidistant ones by default.
    tolerance : float
        Local error of the coordinates in their natural scales, in one step.
    radius : float
        Spectral radius at infinite frequency, 0 (all high frequencies damped at once) to below 1; 1 (no damping) is
        possible without constraints.
    step : float, optional
        Constant step [s] in place of one that follows from the tolerance.
    first_step, max_step : float
        [s]; the first is a thousandth of the duration by default.
    newton : str
        full: a new tangent at every iteration; modified: the last one is kept while it serves.
    method : str
        alpha, or bdf: the backward differentiation formulas of SUNDIALS, for comparison (needs the optional package
        scikit-sundae; radius, step and newton are then without meaning, and first_step is its own choice by default).
    max_order : int
        Of bdf, 1 to 5; orders above 2 are slow on structures with little damping.

    Returns
    -------
    Motion
        With `Motion.energy_balance`, and statistics of steps, iterations and factorizations.

    Raises
    ------
    ModelError, DynamicsError
        Where a load or a prescribed motion has no value, with what was computed until then as ``error.motion``.
    """
    owner = "simulate_stiff"
    start = self.initial if start is None else own_state(self.structure, start, owner)
    grid = stored_times(start, duration, times, samples, owner)
    tolerance = positive(tolerance, owner, "tolerance")
    first = duration / 1000 if first_step is None else positive(first_step, owner, "first_step")
    control = Control(tolerance, first, positive(max_step, owner, "max_step"))
    if step is not None:
        control = Control(np.inf, *(positive(step, owner, "step"),) * 2)
    run: Run
    if method == "alpha":
        run = GeneralizedAlpha(self, start, radius, newton, control)
    elif method == "bdf":
        if step is not None:
            raise ModelError(
                "simulate_stiff: bdf chooses its own steps; leave step out, or limit them with max_step"
            )
        if max_order not in range(1, 6):
            raise ModelError(
                f"simulate_stiff: max_order {max_order!r} of bdf; give a whole number from 1 to 5"
            )
        run = Bdf(self, start, duration, Control(tolerance, first_step or 0.0, max_step), max_order)
    else:
        raise ModelError(f"simulate_stiff: method {method!r} is unknown; choose alpha or bdf")
    try:
        found = run.run(grid, progress)
    except FlexelError as error:
        error.motion = Motion(self, run.kept(str(error)))
        raise
    if not found.complete:
        warnings.warn(found.message, IncompleteWarning, stacklevel=2)
    return _motion(self, found)


def _motion(self: System, found: Integration) -> Motion:
    """The motion, with a warning of what has left the data of its law."""
    warn_outside(self, found.states)
    return Motion(self, found)


def _follow(self: System, start: State, grid: Array) -> Integration:
    """States of a fully prescribed motion; long steps are halved until the position is found."""
    found, none = [start], np.zeros(0)
    segments: list[Segment] = []
    weights = turning_weights(self.structure)
    dense: Callable[[float], Array] = lambda t: none  # noqa: E731 (a fully prescribed motion has no state)
    for t in grid[1:]:
        last, step = found[-1], float(t) - found[-1].t
        while last.t < t:
            step = min(step, longest_step(last, weights))
            try:
                state = self.state_from(min(last.t + step, float(t)), none, self.roles, last)
            except FlexelError as error:
                step /= 2
                if not isinstance(error, PositionError) or step < 1e-6 * (grid[-1] - grid[0]):
                    reached = [*found, last] if last.t > found[-1].t else found
                    error.motion = Motion(self, _followed(reached, segments, str(error), complete=False))
                    raise
                continue
            ends = states.End.of(last), states.End.of(state)
            segments.append(Segment(last.t, state.t, self.roles, dense, *ends))
            last = state
        found.append(last)
    return _followed(found, segments)


def _followed(
    found: list[State], segments: list[Segment], message: str = "", complete: bool = True
) -> Integration:
    counts = {"steps": len(segments), "evaluations": 0, "rechoices": 0}
    return Integration(found, [], segments, counts, message, complete=complete)


def equilibrium(
    self: System, t: float | None = None, start: State | None = None, *, hold: Sequence[str] = ()
) -> State:
    """State of rest in which all forces balance, kinematic coordinates held.

    Newton's method on the analytic tangent; where it fails, the forces that are out of balance at the start
    are taken on gradually, past limit points if need be.

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
        If none is found; says how far the loads could be taken on.
    DynamicsError
        If nothing resists a motion; names it.
    """
    return statics.equilibrium(self, t, start or self.rest, hold)


def static_path(self: System, t_end: float, start: State | None = None) -> Motion:
    """Equilibria while the time, here the load parameter, goes to `t_end`; past limit points by arc length.

    The start must be in equilibrium (see `equilibrium`).  If the path cannot be continued, what was reached
    is returned with an IncompleteWarning, and ``message`` says where it stopped and why.
    """
    states_, message = statics.static_path(self, t_end, start or self.rest)
    if message:
        warnings.warn(message, IncompleteWarning, stacklevel=2)
    counts = {"steps": len(states_) - 1, "evaluations": 0, "rechoices": 0}
    return Motion(self, Integration(states_, [], [], counts, message))


def buckling(
    self: System, state: State | None = None, *, increment: Mapping[str, float], count: int = 5
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
    return stability.buckling(self, state or self.rest, increment, count)


def vibrations(self: System, state: State | None = None, count: int = 10) -> list[stability.Vibration]:
    """Lowest natural frequencies [rad/s] and modes about a state of rest, damping left out.

    The state is the equilibrium nearest to the initial configuration, if none is given.
    Unlike ``linearize(state).modes()`` this needs no choice of independent coordinates.
    """
    return stability.vibrations(self, state or self.equilibrium(), count)


def steady(
    self: System,
    start: State | None = None,
    *,
    rates: Mapping[str, float] | None = None,
    unknown: Sequence[str] | None = None,
    unknown_rates: Sequence[str] = (),
) -> State:
    """Steady motion or equilibrium: the state near `start` whose freedoms have no acceleration.

    Parameters
    ----------
    start : State, optional
        Where to look from; the initial state by default.
    rates : mapping of name to rate, optional
        Given rates of the dynamic freedoms; those of `start` by default.
    unknown : sequence of str, optional
        Freedoms to be found; all by default (smallest change).
    unknown_rates : sequence of str
        Dynamic freedoms whose rates are to be found too.

    Raises
    ------
    PositionError
        If no steady motion is found near the start; says what was reached.

    Notes
    -----
    The rates that are held are those of the freedoms.  For a rotating structure name deformations as freedoms
    (`Model.independent`) and prescribe the rotation: with global coordinates as freedoms a motion with these at
    rest would be looked for.
    """
    return steady_motion(self, start or self.initial, rates, unknown, unknown_rates)
