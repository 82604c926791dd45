"""Finds steady motion and equilibrium by Newton's method on the analytic linearization."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from flexel.base.arguments import names, numbers
from flexel.base.arrays import Array, largest
from flexel.base.errors import ModelError, PositionError
from flexel.engine.solvers import least
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.mechanics.newton import newton, shortened
from flexel.model.state import State
from flexel.system import CoreSystem

TOLERANCE = 1e-13  # residual forces, relative to the largest balancing force
STALLED_TOLERANCE = 1e-10  # the same, when rounding prevents further progress
NOISE_SHARE = (
    10 / STALLED_TOLERANCE
)  # residual forces that are then accepted too, in rounding errors of coordinates
MAX_ITERATIONS = 30
MAX_STEP = 0.3  # largest change of a coordinate in one step
MOST_NAMED = 6  # degrees of freedom in a message
MAX_HALVINGS = 6  # of a step that leads to an unreachable position


def steady_motion(
    system: CoreSystem,
    start: State,
    rates: Mapping[str, float] | None,
    unknown: Sequence[str] | None,
    unknown_rates: Sequence[str],
) -> State:
    """Find the state near `start` with q_d'' = 0 and internal states of laws at rest; see `System.steady`."""
    kinematics = system.kinematics
    dynamic, kinematic, _ = kinematics.role_names
    dofs, nd = [*dynamic, *kinematic], system.roles.nd
    columns = (
        list(range(len(dofs)))
        if unknown is None
        else [_place(dofs, name) for name in names(unknown, "steady")]
    )
    speeds = [_place(dofs[:nd], name) for name in names(unknown_rates, "steady")]
    first = start if rates is None else _with_rates(system, start, rates)

    def evaluate(state: State) -> tuple[Unbalance, float]:
        lin = system._linearization(state)
        scale = _force_scale(system, state, lin) + NOISE_SHARE * _rounding(system, lin)
        qdd = state.Phi_v[system.roles.dynamic]
        found = Unbalance(-lin.M @ qdd / scale, state.zd, scale, lin, columns, speeds)
        return found, found.size

    def move(state: State, unbalance: Unbalance) -> State:
        step = unbalance.step()
        step = shortened(step, largest(step[: len(columns)]), MAX_STEP)
        return _moved(system, state, (columns, speeds), step)

    found = newton(first, evaluate, move, tolerance=TOLERANCE, stalled=STALLED_TOLERANCE, most=MAX_ITERATIONS)
    if found.converged:
        return found.point
    shown = ", ".join(
        f"{name} = {value:.6g}" for name, value in zip(dofs[:MOST_NAMED], found.point.q, strict=False)
    )
    more = f" and {len(dofs) - MOST_NAMED} more" if len(dofs) > MOST_NAMED else ""
    rest = "" if np.any(first.v) else "; from further away, system.equilibrium() finds a state of rest"
    raise PositionError(
        f"no steady motion found near the start after {found.iterations} iterations (residual forces "
        f"{found.error:.3g} of the balancing ones at {shown}{more}); start nearer to it, or name other unknowns{rest}"
    )


@dataclass(frozen=True)
class Unbalance:
    """The equations of steady motion at a state.

    Attributes
    ----------
    forces : ndarray (nd,)
        Residual forces, relative to `scale`.
    lag : ndarray (nz,)
        Rates of internal states of laws.
    scale : ndarray (nd,)
        Balancing forces, and what rounding errors of the coordinates cause beside them.
    lin : LinearizedSystem
    columns, speeds : list of int
        The unknown coordinates and rates.
    """

    forces: Array
    lag: Array
    scale: Array
    lin: LinearizedSystem
    columns: list[int]
    speeds: list[int]

    def _by(self, values: Array, rates: Array, internal_states: Array) -> Array:
        """Return the derivatives with respect to the unknowns: coordinates, rates, internal states."""
        return np.hstack([values[:, self.columns], rates[:, self.speeds], internal_states])

    @cached_property
    def by_lag(self) -> Array:
        """Return the derivatives (nz, unknowns) of the rates of internal states."""
        return self._by(self.lin.Z_q, self.lin.Z_v, self.lin.Z_z)

    @property
    def size(self) -> float:
        """Return the largest relative error."""
        if not self.lag.size:
            return largest(self.forces)
        return max(largest(self.forces), largest(self.lag) / max(largest(self.by_lag), 1.0))

    def step(self) -> Array:
        """Return the smallest change of the unknowns that removes it."""
        by_forces = self._by(self.lin.K, self.lin.C, self.lin.Z) / self.scale[:, None]
        return least(np.vstack([by_forces, self.by_lag]), -np.concatenate([self.forces, self.lag]), 1e-10)


def _moved(system: CoreSystem, state: State, places: tuple[list[int], list[int]], step: Array) -> State:
    """Return the state with its unknowns changed by a step, which is shortened if the position is unreachable."""
    names, nd = [system.structure.names[i] for i in system.roles.dofs], system.roles.nd
    columns, speeds = places
    for shorter in range(MAX_HALVINGS + 1):
        part = step / 2**shorter
        values = {names[j]: float(state.q[j] + d) for j, d in zip(columns, part, strict=False)}
        internal_states = part[len(columns) + len(speeds) :]
        values |= {
            name: float(state.z[i] + internal_states[i]) for name, i in system.structure.internal.items()
        }
        qd = state.qd.copy()
        qd[speeds] += part[len(columns) :][: len(speeds)]
        try:
            return system.state_at(values, dict(zip(names[:nd], qd, strict=True)), start=state)
        except PositionError:
            if shorter == MAX_HALVINGS:
                raise
    return state


def _force_scale(system: CoreSystem, state: State, lin: LinearizedSystem) -> float:
    """Return the size of the balancing forces in the reduced equations; the workspace holds the linearized state."""
    work, nf = system.evaluation.work, system.structure.nf
    reach, pulled = lin.transfer.H[:, : len(lin.dynamic)], work.vjp(state.stresses)
    return max(
        max(largest(work.F[:nf]), largest(pulled[:nf])) * largest(reach), largest(work.M) * 1e-3, 1e-300
    )


def _rounding(system: CoreSystem, lin: LinearizedSystem) -> Array:
    """Return the forces (nd,) that rounding errors of the degrees of freedom cause, by their stiffnesses."""
    errors = np.finfo(float).eps * system.kinematics.scales(system.roles.dofs)
    return np.asarray(np.abs(lin.K) @ errors)


def _with_rates(system: CoreSystem, start: State, rates: Mapping[str, float]) -> State:
    names = [system.structure.names[i] for i in system.roles.dynamic]
    given = dict(zip(names, start.qd, strict=True)) | numbers(rates, "steady", "rate")
    return system.state_at(rates=given, start=start)


def _place(names: Sequence[str], name: str) -> int:
    if name not in names:
        raise ModelError(
            f"steady: '{name}' is not among the degrees of freedom {tuple(names)}; name one of them"
        )
    return list(names).index(name)
