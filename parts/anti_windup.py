"""Anti-windup as specified by the user: a time constant, gains, or clamping."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.linalg import null_space

from flexel.base.arguments import array, positive
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.controller import SAME, Controller
from flexel.model.rules import LinearRule, Rule
from flexel.model.windup import AntiWindup, BackCalculation, Clamping, Holding

INTEGRATOR = 1e-12  # largest singular value of an integrator, relative
MOST_OBLIQUE = 1e6  # condition of the product of left and right eigenvectors of unit length
CLAMP = "clamp"


def anti_windup_of(c: Controller, given: Any) -> AntiWindup | None:
    """Return a controller's anti-windup from the user's choice: a number, gains (nx, nu), "clamp", or None."""
    if given is None:
        return None
    owner, rule, period, nu = f"{c.owner}: anti_windup", c.rule, c.period, len(c.outputs)
    if not rule.nx:
        raise ModelError(f"{owner} {given!r:.60}: the controller has no state that could wind up")
    if not c.limits:
        raise ModelError(f"{owner} {given!r:.60}: without limits nothing winds up; give limits=(low, high)")
    if isinstance(given, str):
        return _clamping(owner, given, rule, period)
    gains = array(given, owner, "value")
    if not gains.shape:
        return _back_calculation(owner, positive(given, owner, "time constant"), rule, period)
    if gains.shape != (rule.nx, nu):
        raise ModelError(
            f"{owner}: gains of shape {gains.shape}; give {(rule.nx, nu)}, a row for each state and a column for "
            "each output"
        )
    return BackCalculation(gains)


def _clamping(owner: str, given: str, rule: Rule, period: float | None) -> AntiWindup:
    if given != CLAMP:
        raise ModelError(
            f"{owner} {given!r:.60}; give a time constant [s], gains (states, outputs), or '{CLAMP}'"
        )
    if period is None:
        raise ModelError(
            f"{owner} '{CLAMP}' is for sampled controllers; for a continuous one give a time constant [s] or gains"
        )
    if not isinstance(rule, LinearRule):
        return Holding()
    modes, left = _integrators(owner, rule, period)
    through = rule.C @ modes
    return Clamping(through @ left, modes @ np.linalg.pinv(through))


def _back_calculation(owner: str, time: float, rule: Rule, period: float | None) -> BackCalculation:
    """Let the integral parts of the outputs track the limited outputs with a time constant."""
    if not isinstance(rule, LinearRule):
        raise ModelError(
            f"{owner} {time:g}: a time constant is for linear systems; for a function give gains (states, outputs)"
        )
    if period is not None and time < period * (1 - SAME):
        raise ModelError(
            f"{owner}: the time constant {time:g} s is less than the period {period:g} s; give a longer one"
        )
    modes, _ = _integrators(owner, rule, period)
    share = 1 / time if period is None else period / time
    return BackCalculation(share * modes @ np.linalg.pinv(rule.C @ modes))


def _integrators(owner: str, rule: LinearRule, period: float | None) -> tuple[Array, Array]:
    """Return right and left eigenvectors (nx, k), (k, nx) of the integrators; their product is the unit matrix."""
    A = rule.A if period is None else rule.A - np.eye(rule.nx)
    modes, left = null_space(A, rcond=INTEGRATOR), null_space(A.T, rcond=INTEGRATOR)
    if not modes.size:
        raise ModelError(
            f"{owner}: the system has no integrator (a pole at {'0' if period is None else '1'}); give gains ("
            "states, outputs)"
        )
    product = left.T @ modes
    if np.linalg.cond(product) > MOST_OBLIQUE:
        raise ModelError(f"{owner}: the system has integrators in series; give gains (states, outputs)")
    if not np.any(np.abs(rule.C @ modes) > INTEGRATOR * np.abs(rule.C).max(initial=0.0)):
        raise ModelError(f"{owner}: no output depends on an integrator of the system; leave anti_windup out")
    return modes, np.asarray(np.linalg.solve(product, left.T), dtype=float)
