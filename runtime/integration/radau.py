"""Radau IIA of order 5 in minimal coordinates: the control of its steps, which are taken in C.

The Jacobian is that of the analytic linearization, and kept while the iteration converges.  The step control is
predictive.  With steps of length h the estimates of the local error are of order h^4, and the error of the motion is of
order h^5: so the tolerance of the estimate is TIGHT rtol^(4/5), and the error is proportional to rtol.
Source: Hairer and Wanner (1996), IV.8; Gustafsson (1994).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.finite import TangentError
from flexel.generated._kernels import lib
from flexel.integration.radau_steps import Collocation, Polynomial
from flexel.integration.radau_tableau import ESTIMATE, NODES

SAFETY, SMALLEST, LARGEST, KEPT = 0.9, 0.2, 8.0, 1.2  # factors of a step; KEPT: not worth other factors
SLOW = 1e-3  # rate of convergence from which the Jacobian is evaluated again
TIGHT = 0.25  # the program RADAU5 has 0.1 rtol^(2/3), which is the same at 1e-3 and looser below
ORDER = 4  # of the local error, by which steps are chosen
FIRST = 1e-6  # first step, relative to the time left, where the rates say nothing
LEAST_FIRST = 1e-9  # the same at least: values of y that are rounding errors, or zero, ask for less
LEAST = 1e-2  # error of a step that the prediction of the next one uses at least


class Radau:
    """A solver with the interface of SciPy's.

    Parameters
    ----------
    rates : callable (t, y) -> ndarray
    t, y, end
        The start, and the last time [s].
    rtol, atol : float, ndarray (ny,)
        Error relative to the largest values so far, and in the units of y.
    max_step, first_step, shortest : float
        Steps [s].
    jac : callable (t, y) -> ndarray (ny, ny)
    collocation : Collocation
    before : Radau, optional
        The solver that this one continues in the same variables: its Jacobian is tried first.

    Attributes
    ----------
    enlarged : float
        How much more the coordinates change with these variables than with the best ones: errors are so much larger.
    """

    enlarged = 1.0

    def __init__(
        self,
        rates: Callable[[float, Array], Array],
        t: float,
        y: Array,
        end: float,
        rtol: float,
        atol: Array,
        max_step: float,
        jac: Callable[[float, Array], Array],
        collocation: Collocation,
        shortest: float,
        first_step: float | None = None,
        before: Radau | None = None,
    ) -> None:
        self._rates, self._jac, self.collocation, self._shortest = rates, jac, collocation, shortest
        self.t, self.y, self.t_bound, self.max_step = t, y, end, max_step
        self._rtol = TIGHT * rtol ** (4 / 5)
        self._atol = self._rtol * (atol / rtol)
        collocation.struct.tolerance = max(10 * np.finfo(float).eps / self._rtol, min(0.03, self._rtol**0.5))
        self.nfev, self.status = 1, "running"
        self._f = rates(t, y)
        self._factorized = 0.0  # length of the step that the factors are for
        self._largest = np.abs(y)
        self._J = np.zeros((y.size, y.size))
        self._current = False
        self._no_slope: TangentError | None = None
        if before is None:
            self._evaluate_jacobian()
        else:
            self._largest = np.maximum(before._largest, self._largest)
            self._J = before._J
        self._dense: Polynomial | None = None
        self._last: tuple[float, float] | None = None  # length and error of the last step
        self.h_abs = min(first_step or self._first(end - t), max_step, end - t)

    def _first(self, left: float) -> float:
        """A first step [s] in which y changes by a hundredth of itself."""
        scale = self._scale(self._largest)
        value, rate = _norm(self.y / scale), _norm(self._f / scale)
        known = value > 1e-5 and rate > 1e-5
        return max(0.01 * value / rate, LEAST_FIRST * left) if known else FIRST * left

    def _scale(self, largest: Array) -> Array:
        return np.asarray(self._atol + self._rtol * largest)

    def dense_output(self) -> Polynomial:
        """The last step as a function of time."""
        assert self._dense is not None
        return self._dense

    def step(self) -> str | None:
        """One accepted step; a message if it has become too short.

        Raises
        ------
        PositionError, ConstraintError, InertiaError
            If a stage cannot be evaluated.
        TangentError
            If the steps become too short where a law has no slope.
        """
        rejected, wished = False, self.h_abs
        least = max(self._shortest, 10 * abs(np.nextafter(self.t, np.inf) - self.t))
        while True:
            left = self.t_bound - self.t
            h = self.h_abs = min(self.h_abs, self.max_step, left)
            if h < least and h < left:
                if self._no_slope:
                    raise self._no_slope
                self.status = "failed"
                return "the step has become too short"
            if not self._stages(h):
                self.h_abs, rejected, self._last = 0.5 * h, True, None
                continue
            error, estimate = self._error(h, rejected or self._dense is None)
            if error < 1:
                break
            self.h_abs, rejected = h * max(SMALLEST, self._safety * error ** (-1 / ORDER)), True
        self._accept(h, error, estimate, rejected)
        if h < wished and self.t == self.t_bound and not rejected:
            self.h_abs = max(self.h_abs, wished)  # it was cut short
        return None

    @property
    def _safety(self) -> float:
        """Less than one, the more so the more iterations the last step needed."""
        most = lib.FLEXEL_RADAU_ITERATIONS
        return float(SAFETY * (2 * most + 1) / (2 * most + self.collocation.struct.iterations))

    def _stages(self, h: float) -> bool:
        """Find the stages, with another Jacobian if the iteration does not converge with an old one."""
        c = self.collocation
        while True:
            if self._factorized != h:
                if not c.factorize(self._J, h):
                    return False
                self._factorized = h
            dense = self._dense
            c.Z[:] = [dense(self.t + part * h) - self.y for part in NODES] if dense else 0.0
            c.y[:], c.scale[:] = self.y, self._scale(self._largest)
            before = c.struct.evaluations
            try:
                found = c.step(self.t, h)
            finally:
                self.nfev += c.struct.evaluations - before
            if found or self._current:
                return found
            self._evaluate_jacobian()

    def _evaluate_jacobian(self) -> None:
        """The Jacobian here; where a law has no slope, the last one serves, with shorter steps if need be."""
        try:
            self._J, self._no_slope = self._jac(self.t, self.y), None
        except TangentError as error:
            self._no_slope = error
        self._current, self._factorized = True, 0.0

    def _error(self, h: float, careful: bool) -> tuple[float, Array]:
        """The error relative to what is allowed, filtered once more after a refused step (8.20); and its estimate."""
        c = self.collocation
        scale = self._scale(np.maximum(self._largest, np.abs(self.y + c.Z[2])))
        change = ESTIMATE @ c.Z / h
        estimate = c.solve(self._f + change)
        size = _norm(estimate / scale)
        if careful and size >= 1:
            self.nfev += 1
            size = _norm(c.solve(self._rates(self.t, self.y + estimate) + change) / scale)
        return (size * self.enlarged if np.isfinite(size) else np.inf), estimate

    def _accept(self, h: float, error: float, estimate: Array, rejected: bool) -> None:
        """Continue from the end of a step."""
        c, size = self.collocation.struct, max(error, 1e-10)
        factor = size ** (-1 / ORDER)
        if self._last is not None:  # predictive control (8.26)
            before, past = self._last
            factor *= min(1.0, h / before * (past / size) ** (1 / ORDER))
        factor = min(LARGEST, max(SMALLEST, self._safety * factor))
        again = c.iterations > 2 and c.rate > SLOW
        if rejected:
            factor = min(1.0, factor)
        if 1.0 <= factor < KEPT and not again:
            factor = 1.0
        self._last = h, max(error, LEAST)
        self._dense = Polynomial.through(self.t, h, self.y, self.collocation.Z, estimate)
        self.t = self.t_bound if h == self.t_bound - self.t else self.t + h
        self.y, self.h_abs = self._dense.end, h * factor
        self._largest = np.maximum(self._largest, np.abs(self.y))
        self._f = self._rates(self.t, self.y)
        self.nfev += 1
        if again:
            self._evaluate_jacobian()
        else:
            self._current = False


def _norm(x: Array) -> float:
    return float(np.linalg.norm(x) / max(x.size, 1) ** 0.5)
