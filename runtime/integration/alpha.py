"""Single steps of the generalized-alpha method on coordinates and multipliers.

Rigid and prescribed conditions hold at every step to rounding (index 3), rolling conditions on the rates;
multipliers are scaled by beta h², so that the iteration matrix does not grow ill-conditioned with small
steps.  The iteration matrix is the analytic tangent.  Internal states of laws follow the same scheme for
equations of first order.  Source: Chung and Hulbert (1993); Jansen, Whiting and Hulbert (2000) for first
order; Arnold and Brüls (2007); Bottasso, Bauchau and Cardona (2007) for the scaling; Zienkiewicz and Xie
(1991) for the step control.
"""

from __future__ import annotations

import numpy as np

from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.engine.assembly import summed
from flexel.engine.local import Local
from flexel.engine.locallaws import ImplicitStep
from flexel.engine.near import ALARM, NearContacts
from flexel.integration.scheme import Point, Scheme
from flexel.mechanics.balance import Balance, Saddle
from flexel.mechanics.core import Core
from flexel.mechanics.saddle import Matrix, SaddlePattern
from flexel.structure.state import State

MAX_ITERATIONS = 20
PATIENCE = 8  # iterations within which the error must drop to a tenth
CONVERGED, STALLED = (
    1e-11,
    1e-8,
)  # relative errors: accepted at once, and accepted when rounding stalls progress
FORCES = 1e-2  # weight of the forces' relative residual against the violation of conditions
LOOSE = 1e-4  # local error beyond which the forces are weighted less, down to a tenth: such steps are coarse anyway
ROUGH = 0.1  # relative error of a prediction beyond which another is tried
SHORTENINGS = 6  # of a Newton step, each to 40 %
SLOW = 0.2  # a contraction weaker than this renews the iteration matrix


class Stepper(Saddle):
    """Newton's method for single steps of the generalized-alpha method.

    Attributes
    ----------
    evaluations, factorizations, iterations : int
        Counts.
    """

    def __init__(
        self, system: Core, radius: float, newton: str, kind: str | None = None, tolerance: float = 0.0
    ) -> None:
        super().__init__(system)
        if newton not in ("full", "modified"):
            raise ModelError(f"simulate: newton {newton!r} is unknown; choose full or modified")
        self.full = newton == "full"
        self.scheme = Scheme.with_radius(radius, bool(self.force_rows.size))
        self._kind = kind
        self._forces = FORCES * max(min(LOOSE / tolerance, 1.0), 0.1) if 0 < tolerance < np.inf else FORCES
        self.evaluations = self.factorizations = self.iterations = 0
        self._matrix_step = 0.0
        self._stiffness: Array = np.zeros(
            self.structure.nf
        )  # of each row, including the masses' contribution
        self._near = NearContacts(system.evaluation)
        self._chosen = not self._near.worthwhile
        self._use(self.local)

    def _use(self, local: Local) -> None:
        """Evaluate all elements, or all except distant contacts."""
        self.local = local
        self.pattern = SaddlePattern(local, self.force_rows, self.force_rows, self._kind)
        self._rolling = np.zeros(local.columns_J.size, dtype=bool)
        for line in local.line_of[self.roles.zero]:
            self._rolling[local.starts_J[line] : local.starts_J[line + 1]] = True
        self._matrix: Matrix | None = None

    def _predict(self, p: Point, h: float) -> Point:
        z, n = self.scheme, self.structure.nf
        a = p.a.copy()
        w = (z.alpha_f * p.a + (1 - z.alpha_f) * a - z.alpha_m * p.w) / (1 - z.alpha_m)
        x = p.x + h * p.v + h * h * ((0.5 - z.beta) * p.w + z.beta * w)
        v = p.v + h * ((1 - z.gamma) * p.w + z.gamma * w)
        x[n:], v[n:] = p.x[n:], p.v[n:]
        return Point(p.t + h, x, v, a, w, p.mu.copy(), p.e, p.z, p.zd, p.zw)

    def _lag(self, p: Point, h: float) -> ImplicitStep | None:
        """The internal states required by the scheme at the end of a step: known part, and factor of their rates."""
        if not p.z.size:
            return None
        c, f = self.scheme, self.scheme.alpha_f
        share = h * c.lag_gamma / (1 - c.lag_m)
        known = p.z + h * (1 - c.lag_gamma) * p.zw + share * (f * p.zd - c.lag_m * p.zw)
        return ImplicitStep(known, share * (1 - f))

    def solve(self, old: Point, h: float) -> tuple[Point, Balance] | None:
        """One step by Newton's method; None if it does not converge."""
        if not self._chosen:
            self._use(self._near.choose(old.x))
            self._chosen = True
        found = self._solve(old, h)
        if found is None or not self._near.worthwhile:
            return found
        gap = self._near.smallest(found[0].x)
        if gap > ALARM:
            return found
        self._use(self._near.choose(found[0].x))
        return found if gap > 0 else self._solve(old, h)  # an omitted contact has closed within the step

    def state(self, b: Balance) -> State:
        """The complete state at a balance, including omitted contacts."""
        own = self.local
        self.local, self.z, self.step = self.system.local, b.laws.z, None
        try:
            whole = self.balance(b.t, b.x, b.v, b.a, b.multiplier[self.force_rows], b.e)
            return super().state(whole)
        finally:
            self.local = own

    def _solve(self, old: Point, h: float) -> tuple[Point, Balance] | None:
        p = self._predict(old, h)
        self.step, self.z = self._lag(old, h), old.z
        rate, acceleration = self.scheme.rates(h)
        scaling = self.scheme.beta * h * h
        if abs(self._matrix_step - h) > 1e-9 * h:
            self._matrix = None
        p, b = self._start_of(p, old, h)
        error = self._relative(b, h)
        first, last = error, np.inf
        for i in range(MAX_ITERATIONS):
            if error < CONVERGED or (error < STALLED and error > 0.5 * last):
                return self._finished(old, p, b), b
            if not np.isfinite(error) or (i >= PATIENCE and error > 0.1 * first):
                return None
            fresh = self._matrix is None or self.full or error > SLOW * last
            if fresh:
                self._matrix = self._tangent(b, rate, acceleration, scaling, first=i == 0)
                self._matrix_step = h
            if self._matrix is None or not self._matrix.factors.regular:
                return None
            slip = b.w[self.roles.zero]
            step = self._matrix.factors.solve(np.concatenate([scaling * b.r, b.gap, slip / rate]))
            self.iterations += 1
            last = error
            p, b = self._search(p, old, h, step, b, error)
            error = self._relative(b, h)
        return None

    def _start_of(self, p: Point, old: Point, h: float) -> tuple[Point, Balance]:
        """The predicted point, or that of an unaccelerated step if its residual is smaller.

        Accelerations of stiff parts that are not at rest give poor predictions.
        """
        b = self._evaluate(p, old)
        if self._relative(b, h) < ROUGH:
            return p, b
        still = self._moved(
            p, np.append(h * h * self._pushed(p, old, h)[: self.structure.nf], 0 * p.mu), h, b
        )
        other = self._evaluate(still, old)
        return (still, other) if self._size(other, h, b.scale) < self._size(b, h, b.scale) else (p, b)

    def _pushed(self, p: Point, old: Point, h: float) -> Array:
        """The predictor's increment beyond x + h v, over h²."""
        return (p.x - old.x - h * old.v) / (h * h)

    def _search(
        self, p: Point, old: Point, h: float, step: Array, b: Balance, last: float
    ) -> tuple[Point, Balance]:
        """The point after a Newton step, shortened while its residual exceeds the previous one.

        Contacts that open and close, and friction that saturates, make the full step overshoot.
        """
        best: tuple[Point, Balance, float] | None = None
        share = 1.0
        for _ in range(SHORTENINGS):
            tried = self._moved(p, share * step, h, b)
            found = self._evaluate(tried, old)
            size = self._size(found, h, b.scale)
            if best is None or size < best[2]:
                best = tried, found, size
            if size < (1 - 0.1 * share) * last or self._relative(found, h) < STALLED:
                break
            share *= 0.4
        assert best is not None
        return best[:2]

    def _moved(self, p: Point, step: Array, h: float, b: Balance) -> Point:
        """The point moved by minus a step of coordinates and scaled multipliers."""
        nf, scheme = self.structure.nf, self.scheme
        rate, acceleration = scheme.rates(h)
        dx = np.zeros(p.x.size)
        dx[:nf] = -step[:nf]
        w = p.w + (1 - scheme.alpha_f) / (1 - scheme.alpha_m) * acceleration * dx
        mu = p.mu - step[nf:] / (scheme.beta * h * h)
        v, a = p.v + rate * dx, p.a + acceleration * dx
        return Point(p.t, p.x + dx, v, a, w, mu, b.e, p.z, p.zd, p.zw)

    def _evaluate(self, p: Point, old: Point) -> Balance:
        """Balance at a point of the step."""
        self.z = old.z
        self.evaluations += 1
        return self.balance(p.t, p.x, p.v, p.a, p.mu, p.e)

    def _relative(self, b: Balance, h: float) -> float:
        """Error of a balance relative to the forces in it."""
        return self._size(b, h, b.scale)

    def _size(self, b: Balance, h: float, scale: float) -> float:
        """Error of a balance relative to given forces, so that two balances can be compared."""
        held = np.concatenate([b.gap / self.scales[self.roles.holonomic], b.w[self.roles.zero] * h])
        return self.error(b, self._forces * b.r, held, self._stiffness, scale)

    def _finished(self, old: Point, p: Point, b: Balance) -> Point:
        c = self.scheme
        p.e, p.z, p.zd = b.e, b.laws.z, b.laws.zd
        p.zw = ((1 - c.alpha_f) * p.zd + c.alpha_f * old.zd - c.lag_m * old.zw) / (1 - c.lag_m)
        return p

    def _tangent(
        self, b: Balance, rate: float, acceleration: float, scaling: float, *, first: bool
    ) -> Matrix:
        """The iteration matrix, first rows and multipliers scaled by beta h²; the first of a step sets row scales."""
        self.factorizations += 1
        K, cross, phi = self.stiffness(b, rate, acceleration)
        held = b.J
        if phi is not None and self.roles.zero.size:
            held = self._with_slips(b.J, phi, rate)
        stored = self.pattern.assemble(K, cross, b.J, held, scaling)
        stored += scaling * acceleration * self.pattern.mass
        if first:
            sizes = np.abs(K)
            sizes[self.local.size_M :] += acceleration * np.abs(self.local.masses0)
            self._stiffness = summed(self.local.rows_K, sizes, self.structure.n)[: self.structure.nf]
        return Matrix(self.structure, self.pattern.pattern, stored)

    def _with_slips(self, J: Array, phi: Array, rate: float) -> Array:
        """Flat J in which the rows of rolling slips are J + Phi_x / rate: the change of a slip through x and v."""
        return J + np.where(self._rolling, phi, 0.0) / rate

    def error_of(self, old: Point, new: Point, h: float) -> Array:
        """Local error (nf,) of the coordinates."""
        nf = self.structure.nf
        error: Array = abs(self.scheme.beta - 1 / 6) * h * h * (new.w - old.w)[:nf]
        return error
