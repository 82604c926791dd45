"""Completes states of a system: from values and rates by name, or from the integrator's variables.

Angles are the kernels' principal values plus turns, which are counted from a nearby state.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from flexel.base.arguments import number, numbers
from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import ModelWarning
from flexel.engine.coordinate_work import CoordinateWork
from flexel.mechanics import dynamics
from flexel.mechanics.exchange import Exchange, exchanged
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.start_rates import consistent_rates
from flexel.mechanics.suspects import in_degrees
from flexel.mechanics.travel import travelled
from flexel.model.snapshot import Snapshot
from flexel.model.state import State, own_state


def between(first: Snapshot, last: Snapshot, t: float) -> Snapshot:
    """Interpolate the instant within a step, by the cubic through both ends; it determines branch and turns."""
    h = last.t - first.t
    part = (t - first.t) / h
    a, b = part * part * (3 - 2 * part), h * part * (1 - part)
    x = (1 - a) * first.x + a * last.x + b * ((1 - part) * first.v - part * last.v)
    e = (1 - a) * first.e + a * last.e + b * ((1 - part) * first.ed - part * last.ed)
    return Snapshot(t, x, first.v, e, first.ed)


Rates = (
    Array | Callable[[CoordinateWork], Array]
)  # q_d' (nd,), or a function for them at a position in the workspace


def located(
    kinematics: Kinematics, t: float, q: Array, qd: Rates, guess: Snapshot
) -> tuple[Array, Array, Array]:
    """Find coordinates x, rates v and deformations e, turns included, for degrees of freedom and their rates.

    Turns are counted from the deformations of a nearby instant, extrapolated with the mean of its rates and the new
    rates.
    """
    choice = kinematics.locate(t, q, guess.x, guess.turns(t))
    work = choice.work
    x, e = work.x.copy(), work.e.copy()
    v = kinematics.velocity(choice, qd(choice) if callable(qd) else qd)
    if t != guess.t and kinematics.structure.period[: e.size].any():
        work.rates()
        mean = guess.e + (t - guess.t) * (guess.ed + work.w[: e.size]) / 2
        held = kinematics.roles.position_rows
        held = held[held < e.size]  # their turns are known
        mean[held] = e[held]
        work.unwrap_from[:] = mean
        work.position()
        e = work.e.copy()
    own = kinematics.roles.dofs < e.size
    e[kinematics.roles.dofs[own]] = q[own]
    return x, v, e


def state_of(
    kinematics: Kinematics,
    t: float,
    q: Array,
    qd: Rates,
    z: Array,
    guess: Snapshot,
    qdd: Array | None = None,
) -> State:
    """Return the complete state at time t for the degrees of freedom, their rates and internal states of laws.

    Parameters
    ----------
    q : ndarray (nq,), qd : ndarray (nd,), z : ndarray (nz,)
        The rates q_d' may be a function of the choice of degrees of freedom, with its position in the workspace.
    guess : Snapshot
        Start of the search; turns are counted from its deformations, extrapolated with their rates.
    qdd : ndarray (nd,), optional
        Accelerations of a driven motion; see `dynamics.complete`.

    Raises
    ------
    PositionError, ConstraintError, DynamicsError
    """
    return dynamics.complete(kinematics, t, *located(kinematics, t, q, qd, guess), z, qdd)


def state_at(
    kinematics: Kinematics,
    exchange: Exchange,
    values: Mapping[str, float] | None,
    rates: Mapping[str, float] | None,
    t: float | None,
    start: State,
) -> State:
    """Return a consistent state with given values and rates; see `System.state_at`.

    Parameters
    ----------
    exchange : callable
        Returns the kinematics with other degrees of freedom.
    values, rates : mapping of name to number
        Values and rates of any quantities, and values of internal states.
    t : float, optional
        Time [s]; that of `start` by default.
    start : State
        For values that are not named.
    """
    structure, roles = kinematics.structure, kinematics.roles
    own_state(structure, start, "state_at")
    wanted = numbers(values, "state_at", "value")
    time = start.t if t is None else number(t, "state_at", "time t")
    z, named = start.z.copy(), {}
    for name, value in wanted.items():
        if name in structure.internal:
            z[structure.internal[name]] = value
        else:
            named[name] = value
            if text := in_degrees(name, structure.units[structure.find(name, "state_at")], value):
                warnings.warn(f"state_at: {text}", ModelWarning, stacklevel=outside())
    other = exchanged(kinematics, exchange, start, list(named)) if named else kinematics
    q, rows = np.array(start.values[other.roles.dofs]), other.roles.dofs.tolist()
    for name, value in named.items():
        q[rows.index(structure.find(name))] = value
    guess = _placed(other, start, time, q)
    if other is not kinematics:
        found = kinematics.values(guess.e, guess.x)
        found[other.roles.dofs] = q  # to the last digit
        q = found[roles.dofs]
    qd: Rates = start.qd if rates is None else lambda choice: consistent_rates(kinematics, choice, rates)
    return state_of(kinematics, time, q, qd, z, guess)


def _placed(kinematics: Kinematics, start: State, t: float, q: Array) -> Snapshot:
    """Return the position at a time [s] near a start for degrees of freedom q (nq,), at rest."""
    here = Snapshot.of(start)
    found = travelled(kinematics, here, t, q)
    if found is not None:
        return found
    still = np.zeros(kinematics.roles.nd)
    x, v, e = located(kinematics, t, q, still, here.still(t))  # names the unreached values
    return Snapshot(t, x, np.zeros_like(v), e, np.zeros_like(e))


def moving(kinematics: Kinematics, start: State, rates: Sequence[Mapping[str, float]]) -> list[Snapshot]:
    """Return the position of a state with other rates, given by name, the others as small as possible each time."""
    guess = Snapshot.of(start)
    choice = kinematics.locate(start.t, np.array(start.values[kinematics.roles.dofs]), guess.x, guess.e)
    x, e, found = choice.work.x.copy(), start.e, []
    for some in rates:
        v = kinematics.velocity(choice, consistent_rates(kinematics, choice, some))
        found.append(Snapshot(start.t, x, v, e, choice.work.jvp(v)[: e.size]))
    return found
