"""Checks that a state is an equilibrium at rest, as vibrations and buckling require."""

from __future__ import annotations

import warnings

import numpy as np

from flexel.base.arrays import Array
from flexel.base.callers import outside
from flexel.base.errors import UnsteadyWarning
from flexel.base.units import force_unit, rate_unit
from flexel.integration.balance import TINY_FORCE
from flexel.model.state import State
from flexel.statics.equilibrium import Equations, Rest

UNBALANCED = (
    1e-6  # unbalanced force, relative to those that balance, above which a state is not in equilibrium
)
ROUNDING = 1e-12  # the same relative to the largest stiffness, over the natural scale
MOVING = (
    1e-6  # rate, in natural scales and relative to the lowest frequency, above which a state is not at rest
)
# Frequency, relative to the highest, that belongs to a free motion but for rounding errors.
FREE_FREQUENCY = 1e-5


def unbalanced(problem: Rest, q: Equations) -> str:
    """Describe the largest unbalanced force of a state that is not in equilibrium; empty if it is."""
    s, first = problem.structure, problem.first
    residual = np.abs(q.residual[: s.nf])
    worst = int(np.argmax(residual)) if s.nf else 0
    if not np.any(
        residual > UNBALANCED * q.balance.scale + ROUNDING * q.stiffness * problem.length + TINY_FORCE
    ):
        return ""
    unit = force_unit(s.units[first + worst], slip=False)
    return f"{residual[worst]:.3g} {unit} on '{s.names[first + worst]}' is not balanced"


def check_balance(owner: str, problem: Rest, q: Equations) -> None:
    """Warn the caller of a public method about a state that is not in equilibrium, with its worst coordinate."""
    if force := unbalanced(problem, q):
        warnings.warn(
            f"{owner}: the state is not in equilibrium: {force}, so the result does not describe the motion that "
            "follows; give the state of system.equilibrium()",
            UnsteadyWarning,
            stacklevel=outside(),
        )


def check_rest(owner: str, problem: Rest, state: State, omega: Array) -> None:
    """Warn about a state that moves.

    Parameters
    ----------
    omega : ndarray (modes,)
        Frequencies that were found [rad/s]: a rate matters as it compares with the lowest, free motions excepted.
    """
    s, first, size = problem.structure, problem.first, np.abs(omega)
    rates = np.abs(state.v[: s.nf]) / problem.x_scale
    lowest = float(size[size >= FREE_FREQUENCY * size.max()].min()) if size.size else np.inf
    if not np.any(rates > MOVING * lowest):
        return
    worst = int(np.argmax(rates))
    unit = rate_unit(s.units[first + worst], 1)
    warnings.warn(
        f"{owner}: the state moves ('{s.names[first + worst]}' at {state.v[worst]:.3g} {unit}), but these are "
        "vibrations about rest; system.linearize(state).modes() are those about the motion",
        UnsteadyWarning,
        stacklevel=outside(),
    )
