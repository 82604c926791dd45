"""Other integrators on the equations of flexel: SUNDIALS' CVODE and SciPy's Radau in minimal coordinates, with their
analytic Jacobian; SUNDIALS' IDA in all coordinates and multipliers.

Each function integrates from a start over times (k,), the first of which is that of the start.  The absolute tolerance
is a hundredth of rtol, in natural scales.  It returns coordinates (k, n) at the times, and the numbers of steps and
evaluations.  It raises a FlexelError if a package is not installed or the integration fails.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.integrate

import flexel as fx
from flexel.base.arrays import Array
from flexel.base.errors import FlexelError
from flexel.integration.balance import Balance, Saddle
from flexel.integration.jacobian import jacobian
from flexel.integration.step_method import natural_scales_of_y
from flexel.mechanics.saddle import Matrix, SaddlePattern
from flexel.model.snapshot import Snapshot

LARGE = 100  # variables from which LAPACK factorizes
FREE = 1e20  # absolute tolerance of variables excluded from the error control
PULL = 300.0  # rate at which violations of the constraints die out, times the duration of the motion
KRYLOV = 12  # vectors of GMRES
MISSING = "SUNDIALS needs scikit-sundae; pip install 'flexel[peers]'"

Found = tuple[Array, dict[str, int]]


class Minimal:
    """The equations in the degrees of freedom of the start, y = (q, q_d', z)."""

    def __init__(self, system: fx.System, start: fx.State) -> None:
        self.system, self.kinematics = system, system.kinematics_of(start.roles)
        self.y = np.concatenate([start.q, start.qd, start.z])
        self.scales = natural_scales_of_y(self.kinematics)
        system.warm(start)

    def rates(self, t: float, y: Array) -> Array:
        """Compute y'."""
        return self.system.rhs(t, np.array(y))

    def at(self, t: float, y: Array) -> Snapshot:
        """Find the position, from the last one."""
        self.rates(t, y)
        work = self.kinematics.choice.work
        work.rates()
        return Snapshot(t, work.x.copy(), work.v.copy(), work.e.copy(), work.w[: work.e.size].copy())

    def jacobian(self, t: float, y: Array) -> Array:
        """Compute the derivatives of y' by y."""
        now = self.at(t, y)
        found = jacobian(self.kinematics, now, np.array(y[y.size - self.kinematics.structure.nz :]))
        self.system.warm(now)
        return found


def by_radau(system: fx.System, start: fx.State, times: Array, rtol: float) -> Found:
    """Integrate by SciPy's Radau."""
    own = Minimal(system, start)
    tolerances: dict[str, Any] = {"rtol": rtol, "atol": rtol / 100 * own.scales}  # its types know no array
    solver = scipy.integrate.Radau(own.rates, times[0], own.y, times[-1], jac=own.jacobian, **tolerances)
    steps, x = 0, [start.x]
    while len(x) < times.size:
        message = solver.step()
        if solver.status == "failed":
            raise FlexelError(f"SciPy's Radau: {message}")
        steps, within = steps + 1, solver.dense_output()
        while len(x) < times.size and times[len(x)] <= solver.t:
            time = float(times[len(x)])
            x.append(own.at(time, within(time)).x)
    return np.array(x), {"steps": steps, "evaluations": int(solver.nfev)}


def by_cvode(system: fx.System, start: fx.State, times: Array, rtol: float) -> Found:
    """Integrate by the backward differentiation formulas of order 1 to 5 of CVODE."""
    try:
        from sksundae.cvode import CVODE
    except ImportError as error:
        raise FlexelError(MISSING) from error
    own = Minimal(system, start)

    def rates(t: float, y: Array, dy: Array) -> None:
        dy[:] = own.rates(t, y)

    def slope(t: float, y: Array, dy: Array, J: Array) -> None:
        J[:] = own.jacobian(t, y)

    solver = CVODE(
        rates,
        jacfn=slope,
        rtol=rtol,
        atol=rtol / 100 * own.scales,
        linsolver="lapackdense" if own.scales.size > LARGE else "dense",
    )
    known, steps, x = float(times[0]), 0, [start.x]
    solver.init_step(known, own.y)
    for time in times[1:]:
        while known < time:
            found = solver.step(times[-1], method="onestep", tstop=times[-1])
            if not found.success:
                raise FlexelError(f"CVODE: {found.message}")
            steps += float(found.t) > known  # after a time within a step its end is returned again
            known = float(found.t)
        found = solver.step(time)
        x.append(own.at(float(time), found.y).x)
    return np.array(x), {"steps": steps, "evaluations": int(found.nfev)}


class WithMultipliers(Saddle):
    """The equations of motion as F(t, y, y') = 0 with y = (x, v, mu, z), free coordinates only.

    The constraints are on the level of accelerations, stabilized so that violations die out quickly. The sparse
    saddle-point matrix is the preconditioner. Source: Hindmarsh et al. (2005); Baumgarte (1972) for the stabilization.
    """

    _matrix: Matrix
    _coupling: Any

    def __init__(self, system: fx.System, start: fx.State, duration: float) -> None:
        super().__init__(system)
        self.pull, self.unwrap_from, self._start = PULL / duration, start.e, start
        self.pattern = SaddlePattern(self.work, self.force_rows, self.force_rows)
        self.evaluations = 0
        nf = self.structure.nf
        self.ends = np.cumsum([0, nf, nf, self.force_rows.size, self.structure.nz])
        x, v, mu = start.x[:nf], start.v[:nf], self.multipliers(start)
        self.y = np.concatenate([x, v, mu, start.z])
        self.yp = np.concatenate([v, start.a[:nf], np.zeros(mu.size), start.zd])

    def split(self, y: Array) -> list[Array]:
        """Split y into (x, v, mu, z), or y' into their rates."""
        return [np.array(y[a:b]) for a, b in zip(self.ends[:-1], self.ends[1:], strict=True)]

    def tolerances(self, tolerance: float, span: float) -> Array:
        """Return the absolute tolerances of y, in natural scales; multipliers are excluded from the error control."""
        z = np.full(self.structure.nz, tolerance)
        free = np.full(self.force_rows.size, FREE)
        return np.concatenate([tolerance * self.x_scale, tolerance * self.x_scale / span * 100, free, z])

    def at(self, t: float, y: Array, yp: Array) -> Balance:
        """Return the balance of forces at y, y'."""
        nf, s = self.structure.nf, self._start
        x, v, mu, self.z = self.split(y)
        x, v, a = (
            np.concatenate([own, fixed[nf:]])
            for own, fixed in ((x, s.x), (v, self.rest), (self.split(yp)[1], self.rest))
        )
        return self.balance(t, x, v, a, mu, self.unwrap_from)

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
        """Compute the preconditioner: the matrix of (x, mu) with v = cj x and z eliminated."""
        self.at(t, y, yp)
        whole, still = (self._assembled(rate, 1 / cj) for rate in (cj, 0.0))
        self._coupling, self._matrix = (whole.sparse - still.sparse) / cj, whole

    def _assembled(self, rate: float, share: float) -> Matrix:
        self.stiffness(rate, rate * rate, share=share)
        return self.pattern.matrix(self.work)

    def precondition(
        self, t: float, y: Array, yp: Array, residual: Array, r: Array, out: Array, cj: float, delta: float
    ) -> None:
        """Solve (dF/dy + cj dF/dy') out = r approximately."""
        nf, nh, p, matrix = self.structure.nf, self.roles.holonomic.size, self.pull, self._matrix
        if not matrix.factors.regular:  # the solver may not be left by an error
            out[:] = r
            return
        r1, r2, r3, r4 = self.split(r)
        # with dv = cj dx - r1 the rows of the constraints are (cj² + 2 p cj + p²) C dx - (cj + 2 p) C r1
        square, linear = np.full(r3.size, cj * (cj + p)), np.full(r3.size, cj + p)
        square[:nh], linear[:nh] = (cj + p) ** 2, cj + 2 * p
        padded = np.concatenate([r1, np.zeros(r3.size)])
        top = r2 + (self._coupling @ padded)[:nf]
        bottom = (r3 + linear * (matrix.sparse @ padded)[nf:]) / square
        found = matrix.factors.solve(np.concatenate([top, bottom]))
        out[:] = np.concatenate([found[:nf], cj * found[:nf] - r1, found[nf:], r4 / cj])


def by_ida(system: fx.System, start: fx.State, times: Array, rtol: float) -> Found:
    """Integrate by the backward differentiation formulas of order 1 to 5 of IDA."""
    try:
        from sksundae.ida import IDA, IDAPrecond
    except ImportError as error:
        raise FlexelError(MISSING) from error
    duration = float(times[-1] - times[0])
    own = WithMultipliers(system, start, duration)
    multipliers = list(range(*own.ends[2:4]))
    solver = IDA(
        own.residual,
        algebraic_idx=multipliers or None,
        rtol=rtol,
        atol=own.tolerances(rtol / 100, duration),
        linsolver="gmres",
        krylov_dim=KRYLOV,
        precond=IDAPrecond(own.prepare, own.precondition),
    )
    known, steps, x = float(times[0]), 0, [start.x]
    solver.init_step(known, own.y, own.yp)
    for time in times[1:]:
        while known < time:
            found, before = solver.step(time, method="onestep", tstop=time), known
            known = float(np.ravel(found.t)[-1])
            if not found.success or known <= before:
                raise FlexelError(f"IDA: {found.message}")
            last = own.at(known, np.ravel(found.y), np.ravel(found.yp))
            own.unwrap_from, steps = last.e, steps + 1
        x.append(last.x)
    return np.array(x), {"steps": steps, "evaluations": own.evaluations}
