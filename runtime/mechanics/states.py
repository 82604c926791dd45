"""Complete states of a system: from values and rates by name, or from the integrator's variables.

Angles are kernels' principal values plus turns; the turns are counted from a nearby state.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from scipy.sparse import block_array, eye_array, vstack

from flexel.base.arguments import number, numbers
from flexel.base.arrays import Array, Index
from flexel.base.errors import ModelError, PositionError
from flexel.engine.choice import Choice
from flexel.engine.solvers import factorize, least
from flexel.mechanics import dynamics
from flexel.mechanics.kinematics import Kinematics
from flexel.structure.moment import Moment
from flexel.structure.roles import Roles
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
    near = Moment.of(start).still(time)
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


def consistent_rates(kinematics: Kinematics, choice: Choice, rates: Mapping[str, float]) -> Array:
    """Rates q_d' (nd,) that give the named rates at a position that was located; undetermined ones are zero.

    Raises
    ------
    ModelError, PositionError
        Rates that are not finite; rates that contradict one another or the constraints.
    """
    structure, nd, work = kinematics.structure, kinematics.roles.nd, choice.work
    given = numbers(rates, "initial rates", "rate")
    rows = np.array([structure.find(name, "initial rates") for name in given], dtype=np.intp)
    wanted, still = np.array(list(given.values())), np.zeros(nd)
    if not rows.size:
        return still

    def rates_of(qd: Array) -> Array:
        v = kinematics.velocity(choice, qd)
        return np.concatenate([work.push(v), v])

    first = rates_of(still)
    missing = wanted - first[rows]
    if kinematics.lists.saddle:
        J = kinematics.evaluation.tables.J.matrix(work.J)
        qd = smallest(J, kinematics.roles, structure.nf, rows, missing)
    else:
        qd = least(choice.unit_rates(rows), missing, 1e-12)
    found = rates_of(qd)
    off = np.abs(wanted - found[rows])
    scale = np.abs(np.concatenate([wanted, first, found])).max(initial=1e-12)
    if off.max() > 1e-9 * scale:
        worst = int(np.argmax(off))
        raise PositionError(
            f"initial rates are inconsistent: '{list(rates)[worst]}' cannot be {wanted[worst]:g} together with "
            f"the others and the constraints (off by {off[worst]:.3g}); give at most {nd} independent rates"
        )
    return qd


def smallest(J: Any, roles: Roles, nf: int, rows: Index, wanted: Array) -> Array:
    """Rates (nd,) of the degrees of freedom, of smallest size, that change some rates as required.

    For many degrees of freedom: from the sparse conditions of the constrained least squares.

    Parameters
    ----------
    J : sparse (m + k + n, n)
    roles : Roles
    nf : int
        Free coordinates.
    rows : ndarray of int (r,)
        Quantities whose rates are wanted.
    wanted : ndarray (r,)
    """
    J = J[:, :nf]
    S, C = J[roles.dynamic], J[np.concatenate([roles.holonomic, roles.zero])]
    A = vstack([C, J[rows]])
    damping = -1e-14 * eye_array(A.shape[0])  # for redundant rates
    factors = factorize(block_array([[S.T @ S, A.T], [A, damping]]))
    rhs = np.concatenate([np.zeros(nf + C.shape[0]), wanted])
    return np.asarray(S @ factors.solve(rhs)[:nf])
