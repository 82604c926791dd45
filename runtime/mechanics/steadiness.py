"""Checks that a state is an equilibrium or a steady motion, so that eigenvalues describe the motion that follows."""

from __future__ import annotations

import warnings
from collections.abc import Sequence

from flexel.base.arrays import Array, largest
from flexel.base.callers import outside
from flexel.base.errors import UnsteadyWarning
from flexel.base.shown import listed
from flexel.model.state import State

UNSTEADY = 1e-6  # residual forces, relative to the balancing forces, above which a state is not steady
# Change of coefficients, as the vibrations feel it, above which they vary: below it, growth by
# parametric resonance is at most VARYING / 4 of the frequency (Mathieu's equation): a damping ratio of 0.25 % suffices.
VARYING = 0.01
OTHERS = (
    "name degrees of freedom in which the motion is steady with m.independent(…): angles of yaw, lean and roll for "
    "what rolls or spins (m.cardan_chain), deformations for what turns"
)
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
    inertia = largest(M @ state.Phi_v[state.roles.dynamic]) if M.size else 0.0
    return inertia / max(inertia, balancing(H, state), SMALL * largest(M), 1e-300)


def balancing(H: Array, state: State) -> float:  # noqa: N803
    """Return the largest force that stresses exert on a degree of freedom at a state, for its transfer function H."""
    return largest(state.J[: state.stresses.size, : H.shape[0]].T @ state.stresses) * largest(H)


def check_steady(what: str, off: float) -> None:
    """Warn the caller of a public method about a state with that acceleration."""
    if off > UNSTEADY:
        warnings.warn(
            f"{what}: the state accelerates (its residual forces are {off:.2g} of the balancing ones), so these do not "
            "describe the motion that follows; linearize about system.equilibrium() or system.steady(state)",
            UnsteadyWarning,
            stacklevel=outside(),
        )


def warn_of_instant(what: str, drift: float, moving: Sequence[str]) -> None:
    """Warn the caller of a public method about a state that is steady for an instant only.

    Parameters
    ----------
    what : str
    drift : float
        See `Afterwards.drift`.
    moving : sequence of str
        Degrees of freedom with rates.
    """
    who = f"{listed(moving)} cannot keep the rate" if moving else "prescribed motions change that"
    remedy = OTHERS if moving else "use system.along(…, period=…).multipliers()"
    warnings.warn(
        f"{what}: nothing accelerates at this instant, but {who} (as the motion goes on, residual forces change by "
        f"{drift:.2g} of the balancing ones), so these do not describe the motion that follows; {remedy}",
        UnsteadyWarning,
        stacklevel=outside(),
    )


def warn_of_variation(what: str, change: float, moving: Sequence[str]) -> None:
    """Warn the caller of a public method about coefficients that vary by so much, and name what moves."""
    cause = f"the motion of {listed(moving)} changes" if moving else "prescribed motions change"
    remedy = f"; {OTHERS}" if moving else ""
    warnings.warn(
        f"{what}: {cause} the coefficients of the linearized equations, by up to {change:.2g} of what holds a "
        "vibration, within the slowest one: these are eigenvalues of frozen coefficients, which do not decide "
        "stability; use system.periodic(period=…).multipliers() or system.along(…, period=…).multipliers()"
        f"{remedy}",
        UnsteadyWarning,
        stacklevel=outside(),
    )
