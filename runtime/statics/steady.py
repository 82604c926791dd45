"""Steady motion and equilibrium by Newton's method on the analytic linearization."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.base.arguments import names
from flexel.base.arrays import Array
from flexel.base.errors import ModelError, PositionError
from flexel.mechanics.core import Core
from flexel.mechanics.newton import newton, shortened
from flexel.structure.state import State

TOLERANCE = 1e-13  # residual forces, relative to the largest of the balancing forces
STALLED = 1e-10  # the same, when rounding prevents further progress
MAX_ITERATIONS = 30
LONGEST = 0.3  # largest change of a coordinate in one step
HALVINGS = 6  # of a step that leads to an unreachable position


def steady_motion(
    system: Core,
    start: State,
    rates: Mapping[str, float] | None,
    unknown: Sequence[str] | None,
    unknown_rates: Sequence[str],
) -> State:
    """State near `start` with q_d'' = 0 and internal states of laws at rest; see `System.steady`."""
    dofs = [system.structure.names[i] for i in system.roles.dofs]
    nd = system.roles.nd
    named = dofs if unknown is None else names(unknown, "steady")
    columns = [_place(dofs, z) for z in named]
    speeds = [_place(dofs[:nd], z) for z in names(unknown_rates, "steady")]
    first = start if rates is None else _with_rates(system, start, rates)

    def evaluate(state: State) -> tuple[Unbalance, float]:
        lin = system.linearize(state)
        qdd = np.array([state.acceleration(z) for z in dofs[:nd]])
        scale = _force_scale(system, state, lin.transfer.H[:, :nd])
        L = np.hstack([lin.Z_q[:, columns], lin.Z_v[:, speeds], lin.Z_z])
        forces = np.hstack([lin.K[:, columns], lin.C[:, speeds], lin.Z]) / scale
        found = Unbalance(-lin.M @ qdd / scale, state.zd, forces, L)
        return found, found.size

    def move(state: State, unbalance: Unbalance) -> State:
        step = unbalance.step()
        size = float(np.max(np.abs(step[: len(columns)]), initial=0.0))
        return _moved(system, state, (columns, speeds), shortened(step, size, LONGEST))

    found = newton(first, evaluate, move, tolerance=TOLERANCE, stalled=STALLED, most=MAX_ITERATIONS)
    if found.converged:
        return found.point
    raise PositionError(
        f"no steady motion found near the start after {found.iterations} iterations (residual forces "
        f"{found.error:.3g} of the acting ones at {dict(zip(dofs, np.round(found.point.q, 6), strict=True))}); "
        "start nearer, or name other unknowns"
    )


@dataclass(frozen=True)
class Unbalance:
    """The equations of steady motion at a state.

    Attributes
    ----------
    forces : ndarray (nd,)
        Residual forces, relative to the balancing ones.
    lag : ndarray (nz,)
        Rates of internal states of laws.
    by_forces, by_lag : ndarray
        Their derivatives with respect to the unknowns: coordinates, rates, internal states.
    """

    forces: Array
    lag: Array
    by_forces: Array
    by_lag: Array

    @property
    def size(self) -> float:
        """Largest relative error."""
        lags = np.abs(self.lag) / max(float(np.max(np.abs(self.by_lag), initial=0.0)), 1.0)
        return float(np.max(np.concatenate([np.abs(self.forces), lags]), initial=0.0))

    def step(self) -> Array:
        """The smallest change of the unknowns that removes it."""
        A = np.vstack([self.by_forces, self.by_lag])
        return np.asarray(np.linalg.lstsq(A, -np.concatenate([self.forces, self.lag]), rcond=1e-10)[0])


def _moved(system: Core, state: State, places: tuple[list[int], list[int]], step: Array) -> State:
    """The state with its unknown values and rates changed by a step, shortened if the position is unreachable."""
    names, nd = [system.structure.names[i] for i in system.roles.dofs], system.roles.nd
    columns, speeds = places
    for shorter in range(HALVINGS + 1):
        part = step / 2**shorter
        values = {names[j]: float(state.q[j] + d) for j, d in zip(columns, part, strict=False)}
        lags = part[len(columns) + len(speeds) :]
        values |= {name: float(state.z[i] + lags[i]) for name, i in system.structure.internal.items()}
        qd = state.qd.copy()
        qd[speeds] += part[len(columns) :][: len(speeds)]
        try:
            return system.state_at(values, dict(zip(names[:nd], qd, strict=True)), start=state)
        except PositionError:
            if shorter == HALVINGS:
                raise
    return state


def _force_scale(system: Core, state: State, H: Array) -> float:
    """Size of the balancing forces in the reduced equations."""
    work, nf = system.evaluation.at(state.t, state.x, state.v, z=state.z, near=state.e), system.structure.nf
    work.inertia()
    parts = np.concatenate([work.F[:nf], work.pull(state.stresses)[:nf]])
    M = work.M
    reach = float(np.max(np.abs(H), initial=0.0))
    return max(
        float(np.max(np.abs(parts), initial=0.0)) * reach,
        float(np.max(np.abs(M), initial=0.0)) * 1e-3,
        1e-300,
    )


def _with_rates(system: Core, start: State, rates: Mapping[str, float]) -> State:
    names = [system.structure.names[i] for i in system.roles.dynamic]
    given = dict(zip(names, start.qd, strict=True)) | dict(rates)
    return system.state_at(rates=given, start=start)


def _place(names: Sequence[str], name: str) -> int:
    if name not in names:
        raise ModelError(
            f"steady: '{name}' is not among the degrees of freedom {tuple(names)}; name one of them"
        )
    return list(names).index(name)
