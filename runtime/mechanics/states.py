"""Complete states of a system: from values and rates by name, or from the integrator's variables.

Angles are kernels' principal values plus turns; the turns are counted from a nearby state.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from flexel.base.arguments import number, numbers
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.engine.choice import Choice
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.start_rates import consistent_rates
from flexel.mechanics.travel import travelled
from flexel.structure.moment import Moment
from flexel.structure.state import State, own_state


def between(first: Moment, last: Moment, t: float) -> Moment:
    """The instant within a step, by the cubic through both ends; it determines branch and turns."""
    h = last.t - first.t
    part = (t - first.t) / h
    a, b = part * part * (3 - 2 * part), h * part * (1 - part)
    x = (1 - a) * first.x + a * last.x + b * ((1 - part) * first.v - part * last.v)
    e = (1 - a) * first.e + a * last.e + b * ((1 - part) * first.ed - part * last.ed)
    return Moment(t, x, first.v, e, first.ed)


Rates = Array | Callable[[Choice], Array]  # q_d' (nd,), or a function for them at a position in the workspace


def located(
    kinematics: Kinematics, t: float, q: Array, qd: Rates, near: Moment
) -> tuple[Array, Array, Array]:
    """Coordinates x, rates v and deformations e, turns included, for degrees of freedom and their rates.

    Turns are counted from the deformations of a nearby instant, extrapolated with the mean of its rates and those
    found.
    """
    choice = kinematics.locate(t, q, near.x, near.turns(t))
    work = choice.work
    x, e = work.x.copy(), work.e.copy()
    v = kinematics.velocity(choice, qd(choice) if callable(qd) else qd)
    if t != near.t and kinematics.structure.period[: e.size].any():
        work.rates()
        mean = near.e + (t - near.t) * (near.ed + work.w[: e.size]) / 2
        held = kinematics.roles.position_rows
        held = held[held < e.size]  # their turns are known
        mean[held] = e[held]
        work.near[:] = mean
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
    near: Moment,
    qdd: Array | None = None,
) -> State:
    """Complete state at time t from the degrees of freedom, their rates and internal states of laws.

    Parameters
    ----------
    q : ndarray (nq,), qd : ndarray (nd,), z : ndarray (nz,)
        The rates q_d' may be a function of the choice of degrees of freedom, with its position in the workspace.
    near : Moment
        Start of the search; turns are counted from its deformations, extrapolated with their rates.
    qdd : ndarray (nd,), optional
        Accelerations of a driven motion; see `dynamics.complete`.

    Raises
    ------
    PositionError, ConstraintError, DynamicsError
    """
    return dynamics.complete(kinematics, t, *located(kinematics, t, q, qd, near), z, qdd)


def state_at(
    kinematics: Kinematics,
    values: Mapping[str, float] | None,
    rates: Mapping[str, float] | None,
    t: float | None,
    start: State,
) -> State:
    """Consistent state with given values and rates; see `System.state_at`.

    Parameters
    ----------
    values, rates : mapping of name to number
        Values of degrees of freedom and internal states; rates of any quantities.
    t : float, optional
        Time [s]; that of `start` by default.
    start : State
        For values that are not named.
    """
    structure, roles = kinematics.structure, kinematics.roles
    own_state(structure, start, "state_at")
    wanted = numbers(values, "state_at", "value")
    time = start.t if t is None else number(t, "state_at", "time t")
    q, z = np.array(start.values[roles.dofs]), start.z.copy()
    for name, value in wanted.items():
        if name in structure.internal:
            z[structure.internal[name]] = value
            continue
        i = structure.find(name, "state_at")
        if i not in roles.dofs:
            raise ModelError(
                f"'{name}' is not a degree of freedom; values can be given to {kinematics.names(roles.dofs)}"
            )
        q[list(roles.dofs).index(i)] = value
    here = Moment.of(start)
    near = travelled(kinematics, here, time, q) or here.still(
        time
    )  # Newton's method names what is not reached
    qd: Rates = start.qd if rates is None else lambda choice: consistent_rates(kinematics, choice, rates)
    return state_of(kinematics, time, q, qd, z, near)


def moving(kinematics: Kinematics, start: State, rates: Sequence[Mapping[str, float]]) -> list[Moment]:
    """The position of a state with other rates, given by name, each time with the others as small as possible."""
    near = Moment.of(start)
    choice = kinematics.locate(start.t, np.array(start.values[kinematics.roles.dofs]), near.x, near.e)
    x, e, found = choice.work.x.copy(), start.e, []
    for some in rates:
        v = kinematics.velocity(choice, consistent_rates(kinematics, choice, some))
        found.append(Moment(start.t, x, v, e, choice.work.push(v)[: e.size]))
    return found
