"""Searches for equilibria, and follows load paths past limit points.

A path is followed by arc length: either the residual at the start is removed (loads applied incrementally), or
time is the load parameter.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexel.base.arguments import names, number
from flexel.base.arrays import Array, Index
from flexel.base.errors import DynamicsError, FlexelError, ModelError, PositionError
from flexel.base.shown import counted, quoted
from flexel.integration.branch import Choices
from flexel.mechanics.amplification import amplification, lost, warn_replaced
from flexel.mechanics.arclength import Arcs, CurvePoint, corrected, follow, point_at
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.statics.equilibrium import MAX_STEP, STALLED_TOLERANCE, TOLERANCE, Equations, Rest
from flexel.statics.growth import growing_motions
from flexel.statics.rest_check import unbalanced
from flexel.statics.search import Search, free_motion, heaviest
from flexel.statics.settling import descend, unstable_motions, way_out
from flexel.system import CoreSystem

log = logging.getLogger("flexel.statics")
ARCS = Arcs(first=0.1, largest=0.5, smallest=1e-7, steps=2000)
MOST_PUSH = 20.0  # forces that push, over those that would move the model by its size at the start
MOST_LEFT = 10  # unstable equilibria that are left, one after another
MISSED = 1e-6  # share of a load that acts along free motions by rounding errors alone
UNRESISTING = 1e-10  # stiffness, over the largest, of what counts as free
RETURNED = 0.1  # share of a displacement that may be left where something resists
DISPLACED = 0.1  # displacement, in natural scales, from which a model descends or returns


@dataclass
class FoundPath:
    """Equilibria on a path.

    Attributes
    ----------
    states : list of State
    unstable : list of int or None
        Number of motions in which each is unstable, where that is known.
    most : float
        Largest parameter that was reached.
    branches : str
        Where the path becomes unstable because others branch off; empty if it does not.
    message : str
        Where and why it stopped; empty if it did not.
    """

    states: list[State]
    unstable: list[int | None]
    most: float = 0.0
    branches: str = ""
    message: str = ""

    def add(self, state: State, last: CurvePoint[Loaded], point: CurvePoint[Loaded]) -> None:
        """Add an equilibrium, at a point after another one."""
        self.states.append(state)
        self.unstable.append(point.unstable)
        self.most = max(self.most, float(point.y[-1]))
        fold = last.tangent[-1] * point.tangent[-1] < 0
        if not self.branches and (point.unstable or 0) - (last.unstable or 0) > fold:
            self.branches = (
                f"at t = {state.t:g} s other paths of equilibria branch off, and beyond, this one is unstable (in "
                f"{counted(point.unstable or 0, 'motion')}); a small imperfection, such as a load or a node that is "
                "drawn aside, leads to another"
            )


@dataclass(frozen=True)
class FoundEquilibrium:
    """An equilibrium, and the motions in which it is unstable, with advice; empty if none is known."""

    state: State
    unstable: str


def equilibrium(
    system: CoreSystem, t: float | None, start: State, hold: Sequence[str] = (), *, stable: bool = False
) -> FoundEquilibrium:
    """Find the state of rest in which all forces balance; see `System.equilibrium`."""
    held = _held(system, hold, "equilibrium")
    problem = Rest(system, start, held)
    t = start.t if t is None else number(t, "equilibrium", "time t")
    q, mu = _balanced(problem, t, start)
    count, state = unstable_motions(problem, q), _well_chosen(system, problem.state(q.balance))
    unstable = _unstable(system, state, count, held=held.size > 0)
    log.info("equilibrium at t = %g s%s", t, f", unstable {unstable}" if unstable else "")
    if not (unstable and stable):
        return FoundEquilibrium(state, unstable)
    settled = _left(problem, state, mu, q, start.x - state.x) if count else None
    if settled is None:
        raise PositionError(
            f"no stable equilibrium found{problem.when(t)}: the one that was found is unstable, and the way out of it "
            "reaches none; start nearer to one, or support the parts that move"
        )
    return FoundEquilibrium(_well_chosen(system, settled), "")


def _well_chosen(system: CoreSystem, state: State) -> State:
    """Return the state, in the best degrees of freedom where the chosen ones have reached an extreme."""
    own, here = system.kinematics_of(state.roles), Snapshot.of(state)
    present = amplification(own, here)
    most = lost(own.roles)
    better = Choices(system, own, free=True).worse(here, present, most) if present > most else None
    if better is None:
        return state
    warn_replaced(own, better, state.t)
    return replace(state, roles=better.roles)


def _left(problem: Rest, state: State, mu: Array, q: Equations, onward: Array) -> State | None:
    """Return the stable equilibrium to which the way out of an unstable one leads; None if it leads nowhere.

    It begins on the side of a displacement `onward` (n,): where the search started, from where a model with an
    imperfection moves to its own side.

    Forces push along the motion in which it is unstable.  The further the model has moved, the less they need to
    push, until they vanish at another equilibrium.  If that is unstable, or they only grow, as where parts turn
    far, the model descends from the way.  It descends at once where nothing resists some motion, such as the turning
    of an upright pendulum about its axis: the slightest push may move it far along that.
    """
    for _ in range(MOST_LEFT):
        before, (way, steepness) = state.x, way_out(problem, q, onward)
        descended = None
        if free_motion(q) is not None:
            x = state.x.copy()
            x[: way.size] += DISPLACED * problem.x_scale * way
            descended = _descended(problem, state.t, x, mu, state.e)
        if descended is None:
            forces = np.zeros(len(q.residual))
            forces[: way.size] = steepness * way / problem.x_scale
            found = _follow(problem, LoadPath(problem, state, mu, (state.t, state.t), forces))
            state = found.states[-1]
            q, mu = _again(problem, state)
            if not found.message and not unstable_motions(problem, q):
                return state
            beside = found.states[-1 if found.message else -2]
            descended = _descended(problem, state.t, beside.x, problem.multipliers(beside), beside.e)
        if descended is None:
            return None
        (q, mu), state = descended, problem.state(descended[0].balance)
        if not unstable_motions(problem, q):
            return state
        onward = state.x - before
    return None


def _unstable(system: CoreSystem, state: State, count: int | None, *, held: bool) -> str:
    """Describe an instability, with advice, from the count of `unstable_motions`; empty if there is none."""
    if count:
        return f"in {count} independent motion(s), see system.vibrations(state); for a stable one give stable=True"
    growing = growing_motions(system, state) if count is None and not held else 0
    if growing:
        return f"in motion: {growing} eigenvalue(s) of system.linearize(state) have positive real parts"
    return ""


def _balanced(problem: Rest, t: float, start: State) -> tuple[Equations, Array]:
    """Find the equilibrium near a start, and its multipliers.

    By Newton's method; if that fails, by removing the unbalance gradually; if no stiffness resists, by descent.
    """
    mu = problem.holding_forces(t, start)
    try:
        found = Search(problem, t).found(start.x, mu, start.e)
        if found is not None:
            return found
        log.info("t = %g s: Newton's method does not converge; the unbalance is removed gradually", t)
        path = _follow(problem, LoadPath(problem, start, mu, (t, t)))
        if not path.message:
            return _again(problem, path.states[-1])
        failure: FlexelError = PositionError(f"no equilibrium found{problem.when(t)}: {path.message}")
    except DynamicsError as error:  # the stiffness is singular
        failure = error
    log.info("t = %g s: descends to where forces balance, because %s", t, failure)
    found = _descended(problem, t, start.x, mu, start.e)
    if found is None:
        raise failure
    return found


def _descended(
    problem: Rest, t: float, x: Array, mu: Array, unwrap_from: Array
) -> tuple[Equations, Array] | None:
    """Descend from a point to an equilibrium, and find it with all digits; None if none is reached."""
    found = descend(problem, t, x, mu, unwrap_from)
    if found is None:
        return None
    balance = found[0].balance
    return Search(problem, t).found(balance.x, found[1], balance.e)


def _again(problem: Rest, state: State) -> tuple[Equations, Array]:
    """Evaluate the equations at an equilibrium, and its multipliers."""
    mu = problem.multipliers(state)
    return problem.equations(state.t, state.x, mu, state.e), mu


def _held(system: CoreSystem, hold: Sequence[str], owner: str) -> Index:
    """Return the quantities to be held, without duplicates."""
    structure, roles, first = system.structure, system.roles, system.structure.m + system.structure.k
    found = [structure.find(name, f"{owner}: hold") for name in names(hold, f"{owner}: hold")]
    for name, i in zip(hold, found, strict=True):
        if (
            structure.m <= i < first
            or i >= first + structure.nf
            or i in roles.holonomic
            or i in roles.kinematic
        ):
            raise ModelError(
                f"{owner}: '{name}' cannot be held: it is a slip, or fixed, rigid, prescribed or held; drop it"
            )
    return np.array(found, dtype=np.intp)


def static_path(system: CoreSystem, t_end: float, start: State | None, hold: Sequence[str] = ()) -> FoundPath:
    """Follow equilibria to the time `t_end`, which is the load parameter; see `System.static_path`."""
    end = number(t_end, "static_path", "t_end")
    held = _held(system, hold, "static_path")
    first = _balanced_start(system, start, held, hold)
    if end == first.t:
        raise ModelError(f"static_path: t_end is the time of the start, {end:g} s; give another time")
    problem = Rest(system, first, held)
    return _follow(problem, LoadPath(problem, first, problem.multipliers(first), (first.t, end)))


def _balanced_start(system: CoreSystem, start: State | None, held: Index, hold: Sequence[str]) -> State:
    """Return the start of a path: that of the user, or the equilibrium near the initial configuration.

    Raises
    ------
    PositionError
        If the user's is not in equilibrium; names the largest unbalanced force.
    """
    state = system.at_rest if start is None else start
    problem = Rest(system, state, held)
    force = unbalanced(problem, problem.equations(state.t, state.x, problem.multipliers(state), state.e))
    if not force:
        return state
    if start is None:
        return equilibrium(system, None, state, hold).state
    raise PositionError(
        f"static_path: the start is not in equilibrium: {force}; give the state of system.equilibrium()"
    )


def _follow(problem: Rest, curve: LoadPath) -> FoundPath:
    """Follow equilibria by arc length until p is 1 and no forces remain.

    If the end was not reached, there is a message with the place and the reason; errors at the start are raised.
    """
    t0, t1 = curve.times
    found = FoundPath([problem.state(curve.first.rest.balance)], [curve.unstable(curve.first)])
    states, passed = found.states, list[CurvePoint[Loaded]]()

    def keep(point: CurvePoint[Loaded]) -> None:
        found.add(problem.state(point.equations.rest.balance), passed[-1], point)
        problem.leave(states[-1])
        passed[:] = [point]

    level = np.append(np.zeros(curve.start.size), 1.0)
    pushed = curve.begin == 1.0
    ends = (1.0, 1.0 + MOST_PUSH) if pushed else (-np.inf, 1.0)

    def finish(guess: Array, known: CurvePoint[Loaded], arc: float) -> bool:
        if pushed and guess[-1] > np.mean(ends):
            found.message = "the forces that push no longer move the model on"
            return True
        nf = problem.structure.nf
        there = corrected(curve, np.append(guess[:-1], 1.0), level, known, arc)
        if there is None:
            return False
        x = np.concatenate([there.y[:nf], curve.held])
        e = there.equations.rest.balance.e
        end = Search(problem, t1).found(x, there.y[nf:-1], e)  # with all digits
        if end is not None:
            found.add(problem.state(end[0].balance), known, there)
        return end is not None

    try:
        first = point_at(curve, np.append(curve.start, curve.begin), curve.first)
        passed.append(replace(first, unstable=found.unstable[0]))
        arc = follow(curve, passed[0], ends, ARCS, keep, finish)
    except (DynamicsError, ModelError) as error:
        if len(states) == 1:
            raise
        found.message = (
            f"the path stopped{problem.when(states[-1].t)} after {len(states)} equilibria: {error}"
        )
        return found
    if arc is not None:
        p = float(passed[0].y[-1]) if t0 != t1 else found.most
        found.message = _stopped(problem, states, p, arc, t0 != t1)
    told = f"; {found.message}" if found.message else ""
    log.info("path to t = %g s: %d equilibria%s", states[-1].t, len(states), told)
    return found


@dataclass(frozen=True)
class Loaded:
    """The equations at a point of a load path."""

    rest: Equations
    residual: Array  # without the remaining part of the start's residual
    rate: Array  # derivative by the parameter


class LoadPath:
    """Equilibria (x, mu) over a parameter p.

    At p the time is t0 + p (t1 - t0), and the share 1 - p of some forces acts: of the residual at the start, from where
    p goes from 0 to 1; or of forces that push, which are zero where p begins, at 1.
    """

    tolerance, stalled, further = TOLERANCE, STALLED_TOLERANCE, 1
    retried: tuple[type[Exception], ...] = (ModelError,)  # beyond the times of a load, which may be a table

    def __init__(
        self, problem: Rest, start: State, mu: Array, times: tuple[float, float], push: Array | None = None
    ) -> None:
        self.problem, self.nf, self.times = problem, problem.structure.nf, times
        self.held = start.x[self.nf :]
        self.start = np.concatenate([start.x[: self.nf], mu])
        rest = problem.equations(times[0], start.x, mu, start.e)
        self.unbalance, self.begin = (rest.residual, 0.0) if push is None else (push, 1.0)
        self.first = self._loaded(rest, self.begin)
        self._free = times[0] != times[1] and free_motion(rest) is not None
        self._weights = np.concatenate([problem.x_scale**-2.0, np.zeros(mu.size), [1.0]])

    def _loaded(self, rest: Equations, p: float) -> Loaded:
        rate, span = self.unbalance.copy(), self.times[1] - self.times[0]
        if span:
            rate += span * self.problem.rate(rest)
        return Loaded(rest, rest.residual - (1.0 - p) * self.unbalance, rate)

    def equations(self, y: Array, last: Loaded) -> Loaded:
        """Evaluate the equations at (x, mu, p); turns are counted from the last point."""
        x, p, (t0, t1) = np.concatenate([y[: self.nf], self.held]), float(y[-1]), self.times
        rest = self.problem.equations(t0 + p * (t1 - t0), x, y[self.nf : -1], last.rest.balance.e)
        return self._loaded(rest, p)

    def error(self, equations: Loaded) -> float:
        """Return the size of the residual in natural scales."""
        return self.problem.size(equations.rest, equations.residual)

    def solve(self, equations: Loaded) -> Array:
        """Return the solutions for the residual and for its derivative by the parameter."""
        both = np.column_stack([equations.residual, equations.rate])
        if not self._free:
            return np.asarray(equations.rest.matrix.solve(both))
        return np.column_stack([self._solution(equations.rest, column) for column in both.T])

    def _solution(self, rest: Equations, rhs: Array) -> Array:
        """Solve without motions that nothing resists, such as that of a cart on its rails.

        If something does after a while (a string that is pulled aside), the path begins along them.

        Raises
        ------
        DynamicsError
            If the load acts along them, and nothing does.
        """
        smallest, missed = rest.matrix.least_solution(rhs)
        if self.problem.size(rest, missed) <= max(TOLERANCE, MISSED * self.problem.size(rest, rhs)):
            return smallest
        motions = rest.matrix.free_motions()
        way = motions @ (motions.T @ missed[: self.nf])
        if self.problem.extent(way):
            self._check_resisted(rest, way)
        smallest[: self.nf] += way / (UNRESISTING * rest.stiffness)
        return smallest

    def _check_resisted(self, rest: Equations, way: Array) -> None:
        """Raise if the model does not return when it is moved along a motion (nf,), under the same load."""
        problem, balance = self.problem, rest.balance
        moved = balance.x.copy()
        moved[: self.nf] += DISPLACED / problem.extent(way) * way
        found = Search(problem, balance.t).found(moved, balance.mu, balance.e)
        if found is None or problem.extent(found[0].balance.x - balance.x) < RETURNED * DISPLACED:
            return
        name = problem.structure.names[problem.first + heaviest(problem, way)]
        raise DynamicsError(
            f"no path{problem.when(balance.t)}: the load acts where nothing resists a motion of '{name}'; support it, "
            f"give hold=['{name}'], or start from an equilibrium under part of the load, system.equilibrium(t=…)"
        )

    def sign(self, equations: Loaded) -> int:
        """Return the sign of the determinant of the tangent; zero if it is one of rounding errors."""
        return 0 if self._free else equations.rest.matrix.factors.sign

    def unstable(self, equations: Loaded) -> int | None:
        """Return the number of motions in which an equilibrium is unstable."""
        return unstable_motions(self.problem, equations.rest)

    def weights(self, _: Loaded) -> Array:
        """Return the weights of the coordinates in natural scales and of the parameter, but not of the multipliers."""
        return self._weights

    def allows(self, step: Array, arc: float) -> bool:
        """Whether no coordinate changes too much."""
        return self.problem.extent(step) <= MAX_STEP + arc


def _stopped(problem: Rest, states: list[State], p: float, arc: float, loaded: bool) -> str:
    """Explain why a path ended; `loaded` if time was its parameter, otherwise the unbalance was removed gradually."""
    e = states[-1].values
    rows = np.argsort(-np.abs(np.nan_to_num(e[: problem.structure.m])))[:3]
    deformed = f"deformations {quoted([problem.structure.names[i] for i in rows])} are largest at the end"
    if not loaded:
        return f"at most {100 * p:.4g} % of the unbalanced forces could be removed; {deformed}"
    if arc >= ARCS.smallest:
        why = f"{ARCS.steps} steps were not enough: apply a smaller load, or start again from the last state"
    else:
        why = "a limit load may have been reached; otherwise use more elements where deformations are large"
    top = max(states, key=lambda state: state.t)
    return (
        f"the path stopped at {100 * p:.4g} % of the load (t = {states[-1].t:g} s) after {len(states)} equilibria, arc "
        f"{arc:.2g}; the largest t reached is {top.t:g} s; {deformed}: {why}"
    )
