"""Implicit integration by the backward differentiation formulas of SUNDIALS (IDA), a cross-check of the others.

Coordinates, rates, multipliers and internal states z of laws are integrated with the constraints on the
level of accelerations, stabilized so that violations die out quickly; the multipliers are excluded from the
error control.  The linear equations are solved by GMRES with the sparse saddle-point matrix as
preconditioner.  Source: Hindmarsh et al. (2005); Baumgarte (1972) for the stabilization.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import DynamicsError, FlexelError
from flexel.integration.balance import Balance, Saddle
from flexel.integration.contact_watch import ContactWatch
from flexel.integration.steps import Control, ImplicitRun
from flexel.mechanics import dynamics
from flexel.mechanics.free_motion import check_inertia
from flexel.mechanics.impulse import struck
from flexel.mechanics.saddle import Matrix, SaddlePattern
from flexel.model.snapshot import Snapshot
from flexel.model.state import State
from flexel.system import CoreSystem

FREE = 1e20  # absolute tolerance of variables excluded from the error control
PULL = 300.0  # rate at which violations of the constraints die out, times the duration of the motion
KRYLOV = 12  # vectors of GMRES


class DifferentialAlgebraic(Saddle):
    """The equations of motion as F(t, y, y') = 0 with y = (x, v, mu, z), free coordinates only."""

    def __init__(self, system: CoreSystem, start: State, pull: float) -> None:
        super().__init__(system)
        self.pull, self.unwrap_from, self._start = pull, start.e, start
        self.pattern = SaddlePattern(self.work, self.force_rows, self.force_rows)
        self.evaluations = self.factorizations = self.iterations = 0
        self.singular = False  # whether the last preconditioner was
        self._matrix: Matrix | None = None
        self._coupling: Any = None
        nf = self.structure.nf
        self.ends = np.cumsum([0, nf, nf, self.force_rows.size, self.structure.nz])

    def restart(self, start: State) -> Balance:
        """Restart from a state."""
        self._start, self.unwrap_from, self.z = start, start.e, start.z
        return self.balance(start.t, start.x, start.v, start.a, self.multipliers(start), start.e)

    def split(self, y: Array) -> list[Array]:
        """Split y into (x, v, mu, z), or y' into their rates."""
        return [np.array(y[a:b]) for a, b in zip(self.ends[:-1], self.ends[1:], strict=True)]

    def start_values(self, mu: Array) -> tuple[Array, Array]:
        """Return y and y' at the start."""
        s, nf = self._start, self.structure.nf
        y = np.concatenate([s.x[:nf], s.v[:nf], mu, s.z])
        return y, np.concatenate([s.v[:nf], s.a[:nf], np.zeros(mu.size), s.zd])

    def tolerances(self, tolerance: float, span: float) -> Array:
        """Return the absolute tolerances of y, in natural scales."""
        z = np.full(self.structure.nz, tolerance)
        free = np.full(self.force_rows.size, FREE)
        return np.concatenate([tolerance * self.x_scale, tolerance * self.x_scale / span * 100, free, z])

    def at(self, t: float, y: Array, yp: Array) -> Balance:
        """Return the balance of forces at y, y'."""
        nf, s = self.structure.nf, self._start
        x, v, mu, self.z = self.split(y)
        a = self.split(yp)[1]
        full = (
            np.concatenate([x, s.x[nf:]]),
            np.concatenate([v, self.rest[nf:]]),
            np.concatenate([a, self.rest[nf:]]),
        )
        return self.balance(t, *full, mu, self.unwrap_from)

    def residual(self, t: float, y: Array, yp: Array, out: Array) -> None:
        """Compute F(t, y, y')."""
        self.evaluations += 1
        b, (xd, _, _, zd) = self.at(t, y, yp), self.split(yp)
        rows, nh, p = self.force_rows, self.roles.holonomic.size, self.pull
        rate = np.concatenate([b.w, b.v])[rows]
        self.work.convective()
        second = np.concatenate([self.work.g + self.work.jvp(b.a), b.a])[rows]
        if self.roles.motions:
            _, ud, udd = self.roles.motion(self.inside(t))
            driven = slice(self.roles.rigid.size, nh)
            rate[driven] -= ud
            second[driven] -= udd
        held = second + p * rate
        held[:nh] += p * rate[:nh] + p * p * b.gap
        out[:] = np.concatenate([xd - self.split(y)[1], b.r, held, zd - b.zd])

    def prepare(self, t: float, y: Array, yp: Array, residual: Array, cj: float) -> None:
        """Factorize the preconditioner: the matrix of (x, mu) with v = cj x and z eliminated."""
        self.factorizations += 1
        self.at(t, y, yp)
        whole, still = (self._assembled(rate, 1 / cj) for rate in (cj, 0.0))
        self._coupling, self._matrix = (whole.sparse - still.sparse) / cj, whole
        self.singular = not whole.factors.regular

    def _assembled(self, rate: float, share: float) -> Matrix:
        self.stiffness(rate, rate * rate, share=share)
        return self.pattern.matrix(self.work)

    def check(self) -> None:
        """Raise if the matrix of the last preconditioner was singular; names a motion without mass.

        Raises
        ------
        InertiaError, DynamicsError
        """
        if self.singular and self._matrix is not None:
            check_inertia(self._matrix, self.work.tables.M.matrix(self.work.M))
            raise DynamicsError("the matrix of a step is singular; inspect the last state of the motion")

    def precondition(
        self, t: float, y: Array, yp: Array, residual: Array, r: Array, out: Array, cj: float, delta: float
    ) -> None:
        """Solve (dF/dy + cj dF/dy') out = r approximately."""
        self.iterations += 1
        nf, nh, p = self.structure.nf, self.roles.holonomic.size, self.pull
        assert self._matrix is not None
        if self.singular:  # said by `check`: the solver may not be left by an error
            out[:] = r
            return
        r1, r2, r3, r4 = self.split(r)
        # with dv = cj dx - r1 the rows of the constraints are (cj² + 2 p cj + p²) C dx - (cj + 2 p) C r1
        square, linear = np.full(r3.size, cj * (cj + p)), np.full(r3.size, cj + p)
        square[:nh], linear[:nh] = (cj + p) ** 2, cj + 2 * p
        padded = np.concatenate([r1, np.zeros(r3.size)])
        top = r2 + (self._coupling @ padded)[:nf]
        bottom = (r3 + linear * (self._matrix.sparse @ padded)[nf:]) / square
        found = self._matrix.factors.solve(np.concatenate([top, bottom]))
        out[:] = np.concatenate([found[:nf], cj * found[:nf] - r1, found[nf:], r4 / cj])


class Sundials(ImplicitRun):
    """One run of IDA."""

    method = "sundials"

    def __init__(
        self,
        system: CoreSystem,
        start: State,
        times: Array,
        duration: float,
        control: Control,
        atol: float,
        max_order: int,
    ) -> None:
        try:
            from sksundae.ida import IDA, IDAPrecond
        except ImportError as error:
            raise FlexelError(
                "method 'sundials' needs scikit-sundae, which is not installed; pip install 'flexel[sundials]'"
            ) from error
        self.equations = equations = DifferentialAlgebraic(system, start, PULL / duration)
        super().__init__(equations, start, times)
        self._balance = equations.restart(start)
        self._watch = ContactWatch(equations.work, control.tolerance * equations.length)
        self._steps = self._rejected = 0
        nc = equations.ends[2:4]
        self._solver = IDA(
            equations.residual,
            algebraic_idx=list(range(*nc)) or None,
            first_step=control.first,
            max_step=0.0 if np.isinf(control.longest) else control.longest,
            rtol=control.tolerance,
            atol=equations.tolerances(atol, duration),
            linsolver="gmres",
            krylov_dim=KRYLOV,
            max_order=max_order,
            precond=IDAPrecond(equations.prepare, equations.precondition),
        )
        self._started = False

    @property
    def t(self) -> float:
        """Current time of the motion."""
        return self._balance.t

    def balance(self) -> Balance:
        """Return the balance of forces at the current time, in the workspace."""
        b, self.equations.z = self._balance, self._balance.z
        return self.equations.balance(b.t, b.x, b.v, b.a, b.mu, b.e)

    def jump(self, z: Array) -> None:
        """Continue from here with other internal states: the solver restarts."""
        self._restart(self._balance.v, z)
        self.energy_balance.renew()

    def strike(self) -> None:
        """Continue from here with the rates just after an impulse."""
        b, kinematics = self._balance, self.equations.system.kinematics
        before = Snapshot(b.t, b.x, b.v, b.e, b.w[: b.e.size])
        self._restart(struck(kinematics, before, self.knots.inside(b.t)).v, b.z)
        self.energy_balance.strike()

    def _restart(self, v: Array, z: Array) -> None:
        """Restart the solver from the present position."""
        b, equations = self._balance, self.equations
        t = self.knots.inside(b.t)
        found = dynamics.complete(equations.system.kinematics, t, b.x, v, b.e, z)
        self._balance = equations.restart(replace(found, t=b.t))
        self._started = False

    @property
    def statistics(self) -> dict[str, int]:
        """Counts of what was done."""
        e = self.equations
        return {
            "steps": self._steps,
            "rejected": self._rejected,
            "evaluations": e.evaluations,
            "iterations": e.iterations,
            "factorizations": e.factorizations,
            "rechoices": 0,
        }

    def advance(self) -> None:
        """Take one step of IDA, again in halves where a contact may have been stepped over."""
        before, old, until = self._balance, self.t, min(self.until, self.stop)
        if self._watch.any:
            self._watch.note(self.balance().a)
        b = self._solved(until)
        while self._watch.any and self._watch.skipped(b.t - old):
            self._rejected += 1
            until = old + (b.t - old) / 2
            if until - old < self.shortest:
                raise self.failure()
            self._restart(before.v, before.z)
            b = self._solved(until)
        self._balance = b
        self.equations.unwrap_from = b.e
        self.energy_balance.look()
        self.energy_balance.add(b.t - old)
        self._steps += 1
        if b.t >= self.until:
            self.keep()

    def _solved(self, until: float) -> Balance:
        """Return the balance at the end of a step of IDA from the present one, at most to a time."""
        equations, old = self.equations, self.t
        if not self._started:
            self._solver.init_step(old, *equations.start_values(self._balance.mu))
            self._started = True
        found = self._solver.step(until, method="onestep", tstop=until)
        t = float(np.ravel(found.t)[-1])
        equations.check()
        if not found.success or t <= old:
            raise self.failure()
        return equations.at(t, np.ravel(found.y), np.ravel(found.yp))
