"""The rule and the period of a controller: gains, linear systems of python-control and SciPy, Python functions."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.base.arguments import array, positive, vector
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.controller import SAME
from flexel.model.rules import FunctionRule, LinearRule, Rule

WHAT = "a function of (t, y), a matrix of gains, or a system of python-control or scipy.signal"


def rule_of(
    owner: str, given: Any, sizes: tuple[int, int], state: Any, reference: Array | None, period: float | None
) -> tuple[Rule, float | None, Array]:
    """Return the rule of a given controller, its period [s], and its initial internal state (nx,).

    Parameters
    ----------
    owner : str
    given : callable, array_like, or linear system
    sizes : tuple of int
        Inputs and outputs.
    state : array_like or None
        Initial internal state.
    reference : ndarray (ny,) or None
    period : float or None
        As the user gave it [s], positive.
    """
    ny, nu = sizes
    if _is_system(given):
        linear, period = _linear_system(owner, given, sizes, reference, period)
        return linear, period, _start(owner, state, linear.nx)
    if callable(given) and not isinstance(given, type):
        if reference is not None:
            raise ModelError(
                f"{owner}: a function contains its reference; leave reference out (it is for gains and linear systems)"
            )
        start = np.zeros(0) if state is None else np.atleast_1d(array(state, owner, "state"))
        if start.ndim != 1 or (state is not None and not start.size):
            raise ModelError(f"{owner}: state has shape {start.shape}; give a list of one or more numbers")
        return FunctionRule(owner, given, nu, start.size, state is not None), period, start
    if given is None or isinstance(given, str | type | dict | set):
        raise ModelError(f"{owner}: {given!r} is not a controller; give {WHAT}")
    if state is not None:
        raise ModelError(f"{owner}: gains have no state; leave state out, or give a function or a system")
    gains = np.atleast_2d(array(given, owner, "gains"))
    if gains.shape != (nu, ny):
        raise ModelError(
            f"{owner}: gains of shape {gains.shape}; give {(nu, ny)}, a row for each output and a column for each input"
        )
    return LinearRule(*_static(gains), _reference(reference, ny)), period, np.zeros(0)


def _static(gains: Array) -> tuple[Array, Array, Array, Array]:
    nu, ny = gains.shape
    return np.zeros((0, 0)), np.zeros((0, ny)), np.zeros((nu, 0)), gains


def _reference(reference: Array | None, ny: int) -> Array:
    return np.zeros(ny) if reference is None else reference


def _start(owner: str, state: Any, nx: int) -> Array:
    """Return the the initial state of a linear system; zero by default."""
    if state is None:
        return np.zeros(nx)
    return vector(np.atleast_1d(array(state, owner, "state")), owner, "state", nx)


def _is_system(given: Any) -> bool:
    """Whether it is a linear system: it has matrices, or can be turned into matrices."""
    return (
        all(hasattr(given, letter) for letter in "ABCD") or hasattr(given, "num") or hasattr(given, "to_ss")
    )


def _linear_system(
    owner: str, given: Any, sizes: tuple[int, int], reference: Array | None, period: float | None
) -> tuple[LinearRule, float | None]:
    """Return the rule of a linear system, and its period: the given one if the system has none."""
    ny, nu = sizes
    dt = _time_step(given)
    if dt == 0 and period is not None:
        raise ModelError(
            f"{owner}: the system is continuous, but a period is given; make it discrete (control.c2d, "
            "scipy.signal.cont2discrete), or leave period out"
        )
    if dt is True and period is None:
        raise ModelError(f"{owner}: the system is discrete and has no period; give period=… [s]")
    if isinstance(dt, float) and dt > 0:
        if period is not None and abs(period - dt) > SAME * dt:
            raise ModelError(f"{owner}: period {period:g} s, but the system has {dt:g} s; leave period out")
        period = positive(dt, owner, "period of the system")
    try:
        system = _matrices(given)
        A, B, C, D = (
            np.atleast_2d(array(getattr(system, letter), owner, f"matrix {letter}")) for letter in "ABCD"
        )
        nx = A.shape[0]
        A, B, C = A.reshape(nx, nx), B.reshape(nx, D.shape[1]), C.reshape(D.shape[0], nx)
    except (ImportError, ValueError, NotImplementedError) as error:
        raise ModelError(
            f"{owner}: the system has no state-space form ({error}); give one with A, B, C, D"
        ) from error
    if D.shape != (nu, ny):
        raise ModelError(
            f"{owner}: the system has {D.shape[1]} inputs and {D.shape[0]} outputs; it is connected to {ny} inputs and "
            f"{nu} outputs"
        )
    return LinearRule(A, B, C, D, _reference(reference, ny)), period


def _time_step(given: Any) -> bool | float | None:
    """Return 0.0 for a continuous system, the step of a discrete one (True: not given), None if unspecified."""
    dt = getattr(given, "dt", None)
    if dt is None:
        return 0.0 if type(given).__module__.startswith("scipy") else None
    return True if dt is True else float(dt)


def _matrices(given: Any) -> Any:
    """Return the system in state space."""
    if hasattr(given, "A"):
        return given
    if hasattr(given, "to_ss"):
        return given.to_ss()
    import control

    return control.ss(given)
