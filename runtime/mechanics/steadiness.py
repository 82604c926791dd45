"""Checks that a state is an equilibrium or a steady motion, so that eigenvalues describe the motion that follows."""

from __future__ import annotations

import warnings

import numpy as np

from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import UnsteadyWarning
from flexel.model.state import State

UNSTEADY = 1e-6  # residual forces, relative to the balancing forces, above which a state is not steady
# Change of the forces in a vibration, relative to the largest, above which the coefficients vary: below it, growth by
# parametric resonance is at most VARYING / 4 of the frequency (Mathieu's equation): a damping ratio of 0.25 % suffices.
VARYING = 0.01
SMALL = 1e-3  # accelerations that count as small if no forces act, like the tolerance of steady motions


def acceleration(M: Array, H: Array, state: State) -> float:  # noqa: N803
    """Return the largest residual force M q_d'' at a state, relative to the balancing forces.

    Parameters
    ----------
    M : ndarray (nd, nd)
        Reduced mass matrix.
    H : ndarray (nf, nd)
        First-order transfer function.
    state : State
    """
    inertia = _largest(M @ state.Phi_v[state.roles.dynamic]) if M.size else 0.0
    pulled = state.J[: state.stresses.size, : H.shape[0]].T @ state.stresses
    return inertia / max(inertia, _largest(pulled) * _largest(H), SMALL * _largest(M), 1e-300)


def check_steady(what: str, off: float) -> None:
    """Warn the caller of a public method about a state with that acceleration."""
    if off > UNSTEADY:
        warnings.warn(
            f"{what}: the state accelerates (its residual forces are {off:.2g} of the balancing ones), so these do not "
            "describe the motion that follows; linearize about system.equilibrium() or system.steady(state)",
            UnsteadyWarning,
            stacklevel=outside(),
        )


def check_constant(what: str, change: float) -> None:
    """Warn the caller of a public method about coefficients that vary by so much."""
    if change > VARYING:
        warnings.warn(
            f"{what}: prescribed motions change the linearized equations by {change:.2g} of their largest coefficients "
            "within a slow vibration, so these are eigenvalues of frozen coefficients, which do not decide stability; "
            "use system.periodic(period=…).multipliers() or system.along(…, period=…).multipliers()",
            UnsteadyWarning,
            stacklevel=outside(),
        )


def _largest(values: Array) -> float:
    return float(np.abs(values).max(initial=0.0))
