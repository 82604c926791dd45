"""Radau IIA of order 5 in minimal coordinates: one step in C, and its control.

The stages are found in C (radau.c in the engine) with factors of the analytic Jacobian, which is kept while the iteration
converges.  The step control is predictive.  The error estimate is of order 3 and the method of order 5, so that the
tolerance of the estimate is 0.1 rtol^(2/3), as in the program RADAU5.
Source: Hairer and Wanner (1996), IV.8; Gustafsson (1994).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.linalg import lapack

from flexel.base.arrays import Array
from flexel.engine.choice import Choice
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi, lib
from flexel.integration.knots import Knots
from flexel.mechanics.kinematics import Kinematics

S6 = 6**0.5
C = np.array([(4 - S6) / 10, (4 + S6) / 10, 1.0])
MATRIX = np.array(
    [
        [(88 - 7 * S6) / 360, (296 - 169 * S6) / 1800, (-2 + 3 * S6) / 225],
        [(296 + 169 * S6) / 1800, (88 + 7 * S6) / 360, (-2 - 3 * S6) / 225],
        [(16 - S6) / 36, (16 + S6) / 36, 1 / 9],
    ]
)
ESTIMATE = np.array([-13 - 7 * S6, -13 + 7 * S6, -1]) / 3  # (8.19), divided by the real eigenvalue
POLYNOMIAL = np.linalg.inv(C[:, None] ** np.arange(1, 4))  # powers of time of the collocation polynomial, from Z
SAFETY, SMALLEST, LARGEST, KEPT = 0.9, 0.2, 8.0, 1.2  # factors of a step; KEPT: not worth other factors
SLOW = 1e-3  # rate of convergence from which the Jacobian is evaluated again
ORDER = 4  # of the local error, by which steps are chosen
FIRST = 1e-6  # first step, relative to the time left, where the rates say nothing


def _decoupled() -> tuple[Array, float, complex]:
    """T of the inverse of the matrix of the method, and its real and complex eigenvalue."""
    values, vectors = np.linalg.eig(np.linalg.inv(MATRIX))
    real, pair = int(np.argmin(np.abs(values.imag))), int(np.argmax(values.imag))
    T = np.column_stack([vectors[:, real].real, vectors[:, pair].real, -vectors[:, pair].imag])
    return np.ascontiguousarray(T), float(values[real].real), complex(values[pair])


T, REAL, PAIR = _decoupled()


class Collocation(Struct):
    """The struct of radau.h for one choice of degrees of freedom."""

    def __init__(self, kinematics: Kinematics, choice: Choice, knots: Knots, size: int) -> None:
        super().__init__(ffi.new("flexel_radau *"))
        self.kinematics, self.choice, self._knots = kinematics, choice, knots
        c = self.struct
        c.ny, c.mu = size, REAL
        c.pair[0], c.pair[1] = PAIR.real, PAIR.imag
        c.T, c.inverse, c.C = (self.pointer(np.ascontiguousarray(z)) for z in (T, np.linalg.inv(T), C))
        self.y, self.scale = self.new("y", size), self.new("scale", size)
        self.Z, _, _ = (self.new(name, 3 * size).reshape(3, size) for name in ("Z", "W", "F"))
        self.new("space", 3 * size)
        c.ngiven = choice.motion.size + choice.loads.size
        self._given = self.new("given", 3 * c.ngiven).reshape(3, -1)
        self._factors: tuple[Any, ...] = ()

    def factorize(self, J: Array, h: float) -> bool:  # noqa: N803
        """Factors of (mu/h) 1 - J for a step of length h; whether both matrices are regular."""
        unit = np.eye(len(J))
        real, real_pivots, failed = lapack.dgetrf(REAL / h * unit - J)
        pair, pair_pivots, failed_too = lapack.zgetrf(PAIR / h * unit - J)
        arrays = real.T, np.ascontiguousarray(pair.T).view(float).reshape(len(J), -1)
        numbers = [ffi.from_buffer("double[]", np.ascontiguousarray(z)) for z in arrays]
        pivots = [ffi.from_buffer("int[]", z.astype(np.int32)) for z in (real_pivots, pair_pivots)]
        self._factors = *numbers, *pivots
        c = self.struct
        c.real_factors, c.complex_factors, c.real_pivots, c.complex_pivots = self._factors
        return not (failed or failed_too)

    def solve(self, b: Array) -> Array:
        """x of ((mu/h) 1 - J) x = b for the real mu."""
        x = np.array(b)
        c = self.struct
        lib.flexel_radau_solve(x.size, c.real_factors, c.real_pivots, ffi.from_buffer("double[]", x))
        return x

    def step(self, t: float, h: float) -> bool:
        """Find the stages of a step from y, the guess in Z; whether the iteration converges."""
        motions, loads = self.kinematics.roles.motions, self.kinematics.loads
        split = self.choice.motion.size
        for i in range(3) if motions or loads.any else ():
            time = self._knots.inside(t + C[i] * h)
            if motions:
                self._given[i, :split] = self.kinematics.roles.motion(time).ravel()
            if loads.any:
                self._given[i, split:] = loads.values(time)
        code = lib.flexel_radau_step(self.choice.work.struct, self.choice.struct, self.struct, t, h)
        self.kinematics.check(code, t + h, self.choice)
        return bool(self.struct.converged)


class Polynomial:
    """The collocation polynomial of a step: dense output of order 3, and of order 5 at its ends.

    Parameters
    ----------
    t, h : float
        Start and length of the step [s].
    y : ndarray (ny,)
        Values at its start.
    Z : ndarray (3, ny)
        Changes up to the stages.
    """

    def __init__(self, t: float, h: float, y: Array, Z: Array) -> None:  # noqa: N803
        self.t, self.h, self.y, self._powers = t, h, y, POLYNOMIAL @ Z

    def __call__(self, t: float) -> Array:
        """Values (ny,) at a time [s]."""
        part = (t - self.t) / self.h
        return np.asarray(self.y + part ** np.arange(1, 4) @ self._powers)


class Radau:
    """Radau IIA of order 5 with the interface of SciPy's solvers.

    Parameters
    ----------
    rates : callable (t, y) -> ndarray
    t, y, end
        The start, and the last time [s].
    rtol, atol : float, ndarray (ny,)
        Error relative to the largest values so far, and in the units of y.
    max_step, first_step : float
        Steps [s].
    jac : callable (t, y) -> ndarray (ny, ny)
    collocation : Collocation
    """

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
        first_step: float | None = None,
    ) -> None:
        self._rates, self._jac, self.collocation = rates, jac, collocation
        self.t, self.y, self.t_bound, self.max_step = t, y, end, max_step
        quotient = atol / rtol
        self._rtol = 0.1 * rtol ** (2 / 3)
        self._atol = self._rtol * quotient
        collocation.struct.tolerance = max(10 * np.finfo(float).eps / self._rtol, min(0.03, self._rtol**0.5))
        self.nfev, self.status = 1, "running"
        self._f = rates(t, y)
        self._largest = np.abs(y)
        self._J = jac(t, y)
        self._current, self._factorized = True, 0.0  # length of the step that the factors are for
        self._dense: Polynomial | None = None
        self._last: tuple[float, float] | None = None  # length and error of the last step
        self.h_abs = min(first_step or self._first(end - t), max_step, end - t)

    def _first(self, left: float) -> float:
        """A first step [s] in which y changes by a hundredth of itself."""
        scale = self._scale(self._largest)
        value, rate = _norm(self.y / scale), _norm(self._f / scale)
        return 0.01 * value / rate if value > 1e-5 and rate > 1e-5 else FIRST * left

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
        """
        rejected, c = False, self.collocation
        least = 10 * abs(np.nextafter(self.t, np.inf) - self.t)
        wished = self.h_abs
        while True:
            left = self.t_bound - self.t
            h = self.h_abs = min(self.h_abs, self.max_step, left)
            if h < least and h < left:
                self.status = "failed"
                return "the step has become too short"
            if 1.0 < left / h < 1.0 + 1e-9:
                h = self.h_abs = left
            if not self._stages(h):
                self.h_abs, rejected, self._last = 0.5 * h, True, None
                continue
            end = self.y + c.Z[2]
            error = self._error(h, end, rejected or self._dense is None)
            used = c.struct.iterations
            most = lib.FLEXEL_RADAU_ITERATIONS
            safety = SAFETY * (2 * most + 1) / (2 * most + used)
            if error < 1:
                break
            self.h_abs, rejected = h * max(SMALLEST, safety * error ** (-1 / ORDER)), True
        self._accept(h, end, error, safety, rejected)
        if h < wished and self.t == self.t_bound and not rejected:
            self.h_abs = max(self.h_abs, wished)  # it was cut short
        return None

    def _stages(self, h: float) -> bool:
        """Find the stages, with another Jacobian if the iteration does not converge with an old one."""
        c = self.collocation
        while True:
            if self._factorized != h:
                if not c.factorize(self._J, h):
                    return False
                self._factorized = h
            dense = self._dense
            guess = [dense(self.t + z * h) - self.y for z in C] if dense else np.zeros_like(c.Z)
            c.Z[:], c.y[:], c.scale[:] = guess, self.y, self._scale(self._largest)
            before = c.struct.evaluations
            try:
                found = c.step(self.t, h)
            finally:
                self.nfev += c.struct.evaluations - before
            if found or self._current:
                return found
            self._evaluate_jacobian()

    def _evaluate_jacobian(self) -> None:
        self._J = self._jac(self.t, self.y)
        self._current, self._factorized = True, 0.0

    def _error(self, h: float, end: Array, careful: bool) -> float:
        """The error relative to what is allowed; filtered once more after a refused step (8.20)."""
        c, scale = self.collocation, self._scale(np.maximum(self._largest, np.abs(end)))
        change = ESTIMATE @ c.Z / h
        error = c.solve(self._f + change)
        size = _norm(error / scale)
        if careful and size >= 1:
            self.nfev += 1
            size = _norm(c.solve(self._rates(self.t, self.y + error) + change) / scale)
        return size if np.isfinite(size) else np.inf

    def _accept(self, h: float, end: Array, error: float, safety: float, rejected: bool) -> None:
        """Continue from the end of a step."""
        c, size = self.collocation.struct, max(error, 1e-10)
        factor = size ** (-1 / ORDER)
        if self._last is not None:  # predictive control (8.26)
            before, past = self._last
            factor *= min(1.0, h / before * (past / size) ** (1 / ORDER))
        factor = min(LARGEST, max(SMALLEST, safety * factor))
        self._last = h, max(error, 1e-2)
        self._dense = Polynomial(self.t, h, self.y, self.collocation.Z.copy())
        again = c.iterations > 2 and c.rate > SLOW
        if rejected:
            factor = min(1.0, factor)
        if 1.0 <= factor < KEPT and not again:
            factor = 1.0
        self.h_abs = h * factor
        self.t = self.t_bound if h == self.t_bound - self.t else self.t + h
        self.y, self._largest = end, np.maximum(self._largest, np.abs(end))
        self._f = self._rates(self.t, end)
        self.nfev += 1
        if again:
            self._evaluate_jacobian()
        else:
            self._current = False


def _norm(x: Array) -> float:
    return float(np.linalg.norm(x) / max(x.size, 1) ** 0.5)

