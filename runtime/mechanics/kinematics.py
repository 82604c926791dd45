"""Solves the position and velocity problem: from the degrees of freedom q to the coordinates x and back.

Position: c(x, t) = 0 and the degrees of freedom at their values, by Newton's method, periodic quantities compared
modulo their periods.  Velocity: B v = (u', 0, q_d').  The work is done in C, see `runtime/engine/explicit.h`;
messages are written here.  Source: van der Werff (1977); Jonker and Meijaard (1990); Schwab and Meijaard (2003) for the
non-holonomic rows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from scipy.sparse import csc_array

from flexel.base.arrays import Array, Index
from flexel.base.errors import ConstraintError, FlexelError, ModelError, PositionError
from flexel.base.nested import Levels
from flexel.base.once import once
from flexel.base.time_functions import TimeFunction
from flexel.engine.coordinate_work import CoordinateLists, CoordinateWork
from flexel.engine.evaluate import Evaluation
from flexel.engine.linearizer import Linearizer
from flexel.engine.solvers import null_vector
from flexel.generated._kernels import lib
from flexel.mechanics.actuation import refuse_actuators, unheld
from flexel.mechanics.inertia import massless, unmoved
from flexel.model.applied_loads import Loads
from flexel.model.callbacks import raise_failures
from flexel.model.role_lists import Roles
from flexel.model.snapshot import Snapshot
from flexel.model.structure import Structure

SIZES = 1e-5, 1e5  # least and largest extent of a model [m], see `check_size`
# Inertia of a motion, relative to the largest one, in natural scales, that names its coordinate.
HARDLY = 1e-6
SHOWN = 6  # laws named in a message
T = TypeVar("T")


@dataclass(frozen=True)
class Configuration:
    """A configuration that satisfies the constraints: time, coordinates, deformations, J = [De; V; 1].

    J is a sparse matrix in a large model (`Evaluation.large`).
    """

    t: float
    x: Array
    e: Array
    J: Any


def size_of(structure: Structure) -> float:
    """Return the largest extent of the drawn points along an axis [m]; one if all points coincide."""
    positions = [node.x0 for node in structure.nodes if node.kind in ("point", "planar_point")]
    if not positions:
        return 1.0
    columns = max(p.size for p in positions)
    cloud = np.array([np.pad(p, (0, columns - p.size)) for p in positions])
    return float(np.ptp(cloud, axis=0).max()) or 1.0


def check_size(structure: Structure) -> None:
    """Raise if a model is so large or small that lengths and angles cannot be compared.

    Ranks and balances of forces combine lengths and angles, in metres and radians: the smaller would be lost in the
    rounding errors of the larger.
    """
    size, (least, most) = size_of(structure), SIZES
    if not least <= size <= most:
        raise ModelError(
            f"the model measures {size:.3g} m; flexel solves models from {least:g} m to {most:g} m: write all lengths, "
            f"forces and inertias in {'a larger' if size > most else 'a smaller'} unit of length, so that it measures "
            "about 1"
        )


def natural_scales(structure: Structure) -> Array:
    """Return the natural scale of each quantity: from the size of the model for lengths and curvatures, else one."""
    size = size_of(structure)
    scale = {"m": size, "1/m": 1 / size}
    return np.array([scale.get(unit, 1.0) for unit in structure.units])


def turns(difference: Array, period: Array) -> Array:
    """Return the whole periods in differences of quantities; zero for a quantity without a period."""
    return period * np.round(np.divide(difference, period, out=np.zeros_like(difference), where=period > 0))


def wrap(residual: Array, period: Array) -> Array:
    """Return differences of quantities without whole periods; those without a period unchanged."""
    return residual - turns(residual, period)


class Kinematics:
    """The kinematic problems of one model for one choice of degrees of freedom."""

    def __init__(self, evaluation: Evaluation, roles: Roles, loads: Loads) -> None:
        self.evaluation = evaluation
        self.structure: Structure = evaluation.structure
        self.roles, self.loads = roles, loads
        self._timed = bool(roles.motions) or loads.any
        self._scale = natural_scales(self.structure)
        self._choices = Levels(lambda: CoordinateWork(self.evaluation.work, self.lists))
        self._own: dict[Callable[[Kinematics], Any], Levels[Any]] = {}

    def __reduce__(self) -> tuple[type[Kinematics], tuple[Evaluation, Roles, Loads]]:
        """Pickle and copy as the arguments; the lists are made again."""
        return Kinematics, (self.evaluation, self.roles, self.loads)

    @once
    def lists(self) -> CoordinateLists:
        """The lists of this choice of degrees of freedom for the engine."""
        return CoordinateLists(self.evaluation.tables, self.roles, self._scale, self.loads.quantities)

    @once
    def linearizer(self) -> Linearizer:
        """The lists of its linearization."""
        refuse_actuators(self.structure, self.roles)
        return Linearizer(self.evaluation, self.lists)

    @cached_property
    def role_names(self) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
        """Names of the dynamic and kinematic degrees of freedom, and of the prescribed motions."""
        roles, names = self.roles, self.structure.names
        return (
            tuple(names[i] for i in roles.dynamic),
            tuple(names[i] for i in roles.kinematic),
            tuple(names[i] for i in roles.prescribed),
        )

    @cached_property
    def kept_at_start(self) -> tuple[Index, Index]:
        """Free deformations that keep their values at a start if possible: those that store energy, and the others.

        Contacts are left out: touching bodies may slide and separate.
        """
        structure, roles = self.structure, self.roles
        acting = [([structure.find(name) for name in law.deformations], law) for law in structure.laws]
        touching = {i for rows, _ in acting if any(structure.kinds[i] == "gap" for i in rows) for i in rows}
        elastic = {i for rows, law in acting if law.spec.stores for i in rows} - touching
        others = {i for i in range(structure.m) if structure.kinds[i] not in ("gap", "norm")} - touching
        held = {*roles.holonomic.tolist(), *roles.zero.tolist()}
        levels = (sorted(level - held) for level in (elastic, others - elastic))
        first, second = (np.array(level, dtype=np.intp) for level in levels)
        return first, second

    @property
    def choice(self) -> CoordinateWork:
        """Return the arrays of this choice of degrees of freedom in the workspace of this thread."""
        return self._choices.present()

    @property
    def time_functions(self) -> tuple[TimeFunction, ...]:
        """The prescribed motions and the loads."""
        return (*self.roles.motions, *self.loads.functions)

    def given(self, t: float) -> CoordinateWork:
        """Return these arrays, with the prescribed motions and loads set to time t."""
        choice = self.choice
        if self._timed:
            choice.motion[:] = self.roles.motion(t).ravel()
            choice.loads[:] = self.loads.values(t)
        return choice

    def own(self, make: Callable[[Kinematics], T]) -> T:
        """Return what a function makes of this choice of degrees of freedom, once for each thread and level."""
        if make not in self._own:
            self._own.setdefault(make, Levels(lambda: make(self)))
        found: T = self._own[make].present()
        return found

    def scales(self, rows: Any) -> Array:
        """Return the natural scales of quantities."""
        return np.asarray(self._scale[rows])

    def values(self, e: Array, x: Array) -> Array:
        """Return the values of all quantities; zero for slips, which have none."""
        y = np.zeros(self._scale.size)
        y[: e.size] = e
        y[y.size - x.size :] = x
        return y

    def target(self, motion: Array, q: Array) -> Array:
        """Return the target values of the rows of the position problem, for prescribed motions (3, prescribed)."""
        nr, nu = self.roles.rigid.size, self.roles.prescribed.size
        y = np.zeros(nr + nu + q.size)
        y[nr : nr + nu] = motion[0]
        y[nr + nu :] = q
        return y

    def locate(self, t: float, q: Array, guess: Array, unwrap_from: Array) -> CoordinateWork:
        """Find the position at time t with degrees of freedom q; x, e and J are then in this thread's workspace.

        Parameters
        ----------
        t : float
        q : ndarray (nq,)
            Values of the degrees of freedom (q_d, q_k); angles over any number of turns.
        guess : ndarray (n,)
            Coordinates to start from.
        unwrap_from : ndarray (m,)
            Deformations near the solution, from which whole periods are counted.

        Raises
        ------
        PositionError
            If Newton's method does not converge; names the rows that remain unsatisfied.
        ConstraintError
            If the degrees of freedom do not determine the position.
        """
        choice = self.given(t)
        choice.reset()
        work = choice.work
        work.struct.t = t
        work.x[:], work.unwrap_from[:], choice.q[:] = guess, unwrap_from, q
        self.check(choice.locate(), t)
        return choice

    def velocity(self, choice: CoordinateWork, qd: Array) -> Array:
        """Return the rates v (n,) of all coordinates for the rates q_d' (nd,), at a position that was located."""
        choice.qd[:] = qd
        self.check(choice.velocity(), choice.work.struct.t)
        return choice.work.v.copy()

    def check(self, code: int, t: float, choice: CoordinateWork | None = None) -> None:
        """Raise the error for a return code of the engine.

        Raises
        ------
        PositionError, ConstraintError, InertiaError
        """
        if code:
            raise self.failure(code, t, choice)

    def failure(self, code: int, t: float, choice: CoordinateWork | None = None) -> FlexelError:
        """Return the error for a return code of the engine, with the names of the model."""
        if code == lib.FLEXEL_UNREACHED:
            return PositionError(self._unreached(t, choice or self.choice))
        if code == lib.FLEXEL_MASSLESS:
            return self._massless(choice or self.choice)
        what = "velocities" if code == lib.FLEXEL_SLIDING else "position"
        chosen = self.roles.kinematic if code == lib.FLEXEL_SLIDING else self.roles.dofs
        given, remedy = f"the degrees of freedom {self.names(chosen)}", "choose other independent coordinates"
        if not chosen.size:
            given = f"the prescribed motions of {self.names(self.roles.prescribed)}"
            remedy = "prescribe another quantity, or store states at other times"
        return ConstraintError(
            f"{given} do not determine the {what} at t = {t:g} s (singular position); {remedy}"
        )

    def _massless(self, choice: CoordinateWork) -> FlexelError:
        """Return the error for a motion without mass, by name."""
        s, A = self.structure, self.lists.A
        if self.roles.actuated:
            return unheld(s, self.roles)
        if not self.lists.saddle:
            return massless(s, self.roles, self._reduced_mass(choice))
        values = np.concatenate([choice.work.M, choice.work.J])[A.source]
        motion = null_vector(csc_array((values, (A.rows, A.columns)), shape=(A.size, A.size)))
        moved = None if motion is None else s.names[s.m + s.k + int(np.argmax(np.abs(motion[: s.nf])))]
        return unmoved(moved)

    def _reduced_mass(self, choice: CoordinateWork) -> Array:
        """Return H' M H (nd, nd) of the last evaluation."""
        nf = self.structure.nf
        H, M = choice.H, self.evaluation.matrix(self.evaluation.tables.M, choice.work.M)[:nf, :nf]
        return np.asarray(H.T @ (M @ H))

    def hardly_moves(self, at: Snapshot) -> str:
        """Return the degree of freedom whose motion moves almost no mass at an instant; empty if there is none."""
        choice = self.given(at.t)
        choice.reset()
        work = choice.work
        work.x[:], work.unwrap_from[:], choice.qd[:] = at.x, at.e, 0.0
        work.position()
        work.inertia()
        if self.lists.saddle or not self.roles.nd or choice.directions():
            return ""
        scales = self.scales(self.roles.dynamic)
        w, V = np.linalg.eigh(scales[:, None] * self._reduced_mass(choice) * scales)
        row = self.roles.dynamic[int(np.argmax(np.abs(V[:, 0])))]
        return self.structure.names[row] if w[0] < HARDLY * w[-1] else ""

    def _unreached(self, t: float, choice: CoordinateWork) -> str:
        """Write the message for a position that was not reached."""
        residual = choice.residual
        if np.isnan(residual[self.roles.holonomic.size :]).any():
            laws = self.structure.laws
            raise_failures(law.code for law in laws)
            own = [law for law in laws if law.kernels]
            named = ", ".join(dict.fromkeys(f"'{law.name}'" for law in own or laws[:SHOWN]))
            suspects = f" and the laws{' given by formulas' * bool(own)} (on {named})" * bool(laws)
            return (
                f"position at t = {t:g} s is not a number: a force was not finite just before; check the loads"
                f"{suspects} in the range that the motion reaches"
            )
        worst = np.argsort(-np.abs(np.nan_to_num(residual, nan=np.inf)) * self.lists.weight)[:4]
        rows = self.roles.position_rows
        names = ", ".join(f"'{self.structure.names[rows[i]]}' (off by {residual[i]:.3g})" for i in worst)
        driven = f" of {self.names(self.roles.prescribed)}" if self.roles.prescribed.size else ""
        return (
            f"position at t = {t:g} s cannot be reached: {names} remain unsatisfied; the constraints admit no such "
            f"position near the current one: check prescribed and initial values{driven}, or move in smaller steps"
        )

    @cached_property
    def _conditions(self) -> tuple[Array, Array | None]:
        """Return the natural scales of the rigid quantities, and their periods, if any of them has one."""
        rows = self.roles.rigid
        period = self.structure.period[rows]
        return self.scales(rows), period if period.any() else None

    def drift(self, e: Array) -> float:
        """Return the largest violation of the rigid conditions, relative to their natural scales."""
        held, (scales, period) = e[self.roles.rigid], self._conditions
        held = held if period is None else wrap(held, period)
        return float(np.abs(held / scales).max(initial=0.0))

    def names(self, rows: Any) -> str:
        """Name quantities in messages."""
        return ", ".join(f"'{self.structure.names[i]}'" for i in rows)
