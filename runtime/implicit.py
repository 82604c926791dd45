"""Implicit integration of stiff models: the generalized-alpha method on coordinates and multipliers.

Rigid and prescribed conditions hold at every step to rounding (index 3), rolling conditions on the rates;
multipliers are scaled by beta h², so that the iteration matrix does not grow ill-conditioned with small
steps.  The iteration matrix is the analytic tangent.  Source: Chung and Hulbert (1993); Arnold and Brüls
(2007); Bottasso, Bauchau and Cardona (2007) for the scaling; Zienkiewicz and Xie (1991) for the step control.
Imports numpy, scipy.linalg and the balance.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from tqdm import tqdm

from flexel.balance import Balance, Saddle
from flexel.errors import DynamicsError, ModelError
from flexel.integrate import Integration
from flexel.kinematics import Factorization
from flexel.state import State
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.system import System

MAX_ITERATIONS = 10
SLOW = 0.2  # a contraction weaker than this renews the iteration matrix


@dataclass(frozen=True)
class Scheme:
    """Coefficients of the generalized-alpha method with a given spectral radius at infinite frequency."""

    alpha_m: float
    alpha_f: float
    beta: float
    gamma: float

    @classmethod
    def with_radius(cls, radius: float) -> Scheme:
        """The optimal scheme of second order; near radius 1 keeps energy, 0 damps high frequencies at once.

        Radius 1 is left out: with constraints its accelerations and multipliers grow without bound.
        """
        if not 0 <= radius < 1:
            raise ModelError(f"spectral radius {radius} lies outside 0 ≤ radius < 1; 0.8 is a good value")
        m, f = (2 * radius - 1) / (radius + 1), radius / (radius + 1)
        gamma = 0.5 - m + f
        return cls(m, f, 0.25 * (gamma + 0.5) ** 2, gamma)

    def rates(self, h: float) -> tuple[float, float]:
        """Derivatives (gamma', beta') of the rates and of the accelerations by the coordinates, step h."""
        return self.gamma / (h * self.beta), (1 - self.alpha_m) / (h * h * self.beta * (1 - self.alpha_f))


@dataclass
class Point:
    """Where the integration stands: coordinates, rates, accelerations, the method's own acceleration, multipliers."""

    t: float
    x: Array
    v: Array
    a: Array
    w: Array
    mu: Array
    e: Array


class GeneralizedAlpha(Saddle):
    """One implicit run of the dynamics of a system."""

    def __init__(self, system: System, start: State, radius: float, tolerance: float) -> None:
        super().__init__(system)
        if system.structure.nz:
            raise ModelError(
                f"simulate_stiff: internal states of laws ({', '.join(system.structure.internal)}) are not taken "
                "along; use simulate(…, method='Radau')"
            )
        self.scheme = Scheme.with_radius(radius)
        self.tolerance = tolerance
        self.start = start
        self.statistics = {"steps": 0, "rejected": 0, "evaluations": 0, "factorizations": 0, "rechoices": 0}
        self._matrix: Factorization | None = None
        self._matrix_step = self._shortest = 0.0
        self._stiffness = np.zeros((0, 0))

    def run(self, times: Array, first_step: float, max_step: float, progress: bool | None) -> Integration:
        """Integrate over the stored times; an interrupt (Ctrl-C) keeps what was computed.

        Raises
        ------
        DynamicsError
            If the step becomes too small; the motion up to there is in its attribute ``states``.
        """
        s = self.start
        mu = self.multipliers(s)
        point = Point(s.t, s.x.copy(), s.v.copy(), s.a.copy(), s.a.copy(), mu, s.e)
        states, h, message = [s], first_step, "reached the end"
        self._shortest = 1e-10 * float(times[-1] - s.t)
        show = sys.stderr.isatty() if progress is None else progress
        bar = tqdm(total=float(times[-1] - s.t), disable=not show, unit="s", leave=False)
        try:
            for t in times[1:]:
                while point.t < t:
                    gap = float(t) - point.t
                    parts = max(float(np.ceil(gap / min(h, max_step) * (1 - 1e-9))), 1.0)
                    point, balance, h = self._advance(point, gap / parts, h, states)
                    if abs(point.t - t) < 1e-6 * gap / parts:
                        point.t = float(t)
                    bar.update(point.t - s.t - float(bar.n))
                states.append(self.state(balance))
        except KeyboardInterrupt:
            message = f"interrupted at t = {point.t:g} s; the motion up to there is kept"
        finally:
            bar.close()
        return Integration(states, [], [], self.statistics, message)

    def _advance(
        self, point: Point, step: float, wish: float, states: list[State]
    ) -> tuple[Point, Balance, float]:
        """One accepted step of at most `step`; returns also the step that the error allows next."""
        asked = step
        while True:
            found = self._solve(point, step)
            if found is not None:
                new, balance = found
                error = self._error(point, new, step)
                if error <= 1.0:
                    self.statistics["steps"] += 1
                    allowed = step * min(2.0, 0.9 * max(error, 1e-6) ** (-1 / 3))
                    return new, balance, max(allowed, wish) if step == asked else allowed
            self.statistics["rejected"] += 1
            step *= 0.5 if found is None else max(0.2, 0.9 * error ** (-1 / 3))
            if step < self._shortest:
                failure = DynamicsError(
                    f"implicit integration cannot go on at t = {point.t:g} s (step {step:.2g} s): the motion is not "
                    "smooth there, or a condition cannot be met; look at the last states (error.states)"
                )
                failure.states = states  # type: ignore[attr-defined]
                raise failure

    def _error(self, old: Point, new: Point, h: float) -> float:
        """Local error of the coordinates over the tolerance."""
        nf = self.structure.nf
        change = abs(self.scheme.beta - 1 / 6) * h * h * (new.w - old.w)[:nf] / self.x_scale
        return float(np.abs(change).max(initial=0.0)) / self.tolerance

    def _predict(self, p: Point, h: float) -> Point:
        z, n = self.scheme, self.structure.nf
        a = p.a.copy()
        w = (z.alpha_f * p.a + (1 - z.alpha_f) * a - z.alpha_m * p.w) / (1 - z.alpha_m)
        x = p.x + h * p.v + h * h * ((0.5 - z.beta) * p.w + z.beta * w)
        v = p.v + h * ((1 - z.gamma) * p.w + z.gamma * w)
        x[n:], v[n:] = p.x[n:], p.v[n:]
        return Point(p.t + h, x, v, a, w, p.mu.copy(), p.e)

    def _solve(self, old: Point, h: float) -> tuple[Point, Balance] | None:
        """Newton's method for one step; None if it does not converge."""
        p, nf = self._predict(old, h), self.structure.nf
        rate, acceleration = self.scheme.rates(h)
        scaling = self.scheme.beta * h * h
        last, fresh = np.inf, False
        if self._matrix_step != h:
            self._matrix = None
        for _ in range(MAX_ITERATIONS):
            b = self.balance(p.t, p.x, p.v, p.a, p.mu, p.e)
            self.statistics["evaluations"] += 1
            slip = b.configuration.J[self.roles.zero, :nf] @ p.v[:nf]
            held = np.concatenate([b.gap / self.scales[self.roles.holonomic], slip * h])
            error = self.error(b, b.r, held, self._stiffness)
            if error < 1e-11 or (error < 1e-8 and error > 0.5 * last):
                p.e = b.e
                return p, b
            if not np.isfinite(error) or (fresh and error > 10 * last):
                return None
            fresh = self._matrix is None or error > SLOW * last
            if fresh:
                self._matrix = self._factor(b, rate, acceleration, scaling)
                self._matrix_step = h
            rhs = np.concatenate([scaling * b.r, b.gap, slip / rate])
            assert self._matrix is not None
            if not self._matrix.regular:
                return None
            step = self._matrix.solve(rhs)
            dx = -step[:nf]
            p.x[:nf] += dx
            p.v[:nf] += rate * dx
            p.a[:nf] += acceleration * dx
            p.w[:nf] += (1 - self.scheme.alpha_f) / (1 - self.scheme.alpha_m) * acceleration * dx
            p.mu -= step[nf:] / scaling
            p.e, last = b.e, error
        return None

    def _factor(self, b: Balance, rate: float, acceleration: float, scaling: float) -> Factorization:
        """Factors of the iteration matrix, first rows and multipliers scaled by beta h²."""
        nf = self.structure.nf
        self.statistics["factorizations"] += 1
        T, J = self.tangents(b), b.configuration.J
        K = T.r_x[:nf, :nf] + rate * T.r_v[:nf, :nf] + acceleration * b.forces.M[:nf, :nf]
        self._stiffness = K
        slips = J[self.roles.zero, :nf] + T.Phi_x[self.roles.zero, :nf] / rate
        C = J[self.force_rows, :nf]
        zero = np.zeros((self.force_rows.size, self.force_rows.size))
        held = np.vstack([J[self.roles.holonomic, :nf], slips])
        return Factorization(np.block([[scaling * K, C.T], [held, zero]]))
