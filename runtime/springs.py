"""Springs, dampers and laws: the methods of `Model` that give free deformations and slips their stress.

Imports numpy, the errors, the table of laws and the checked inputs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.checks import not_negative
from flexel.errors import ModelError
from flexel.generated.table import LAWS
from flexel.inputs import array, names, number, quantities
from flexel.laws import formula_law
from flexel.structure import Array, LawInstance

if TYPE_CHECKING:
    from flexel.model import Model

LARGEST = 6  # deformations of one linear law


def linear_law(self: Model, on: Sequence[str], S: Any, D: Any = None, preload: Any = None) -> None:
    """Attach σ = preload + S e + D ė to up to six deformations, which become free.

    Parameters
    ----------
    on : sequence of str (m,)
        Deformations.
    S, D : array_like (m, m)
        Stiffness and damping, symmetric and without negative eigenvalues.
    preload : array_like (m,)

    Raises
    ------
    ModelError
    """
    on = names(on, "linear law")
    owner, m = f"linear law on {', '.join(repr(z) for z in on)}", len(on)
    if not 1 <= m <= LARGEST or len(set(on)) < m:
        raise ModelError(f"{owner}: {m} deformations named; name 1 to {LARGEST}, each once")
    upper = np.triu_indices(m)
    values = {
        "preload": np.zeros(m) if preload is None else array(preload, owner, "preload"),
        "S": _symmetric(S, owner, "stiffness", m)[upper],
        "D": _symmetric(np.zeros((m, m)) if D is None else D, owner, "damping", m)[upper],
    }
    if values["preload"].shape != (m,):
        raise ModelError(f"{owner}: preload has shape {values['preload'].shape}; give {m} numbers")
    self.laws.append(LawInstance(" ".join(on), LAWS[f"linear_{m}"], on, (), values))


def _symmetric(value: Any, owner: str, what: str, m: int) -> Array:
    A = array(value, owner, what)
    if A.shape != (m, m):
        raise ModelError(f"{owner}: {what} has shape {A.shape}; give ({m}, {m})")
    size = float(np.max(np.abs(A)))
    if np.max(np.abs(A - A.T)) > 1e-12 * size:
        raise ModelError(
            f"{owner}: {what} {A.tolist()} is not symmetric; no energy belongs to it, make it so"
        )
    if np.linalg.eigvalsh(A)[0] < -1e-12 * size:
        raise ModelError(
            f"{owner}: {what} {A.tolist()} has a negative eigenvalue; correct it, or state a softening spring as a "
            "formula with m.law"
        )
    return (A + A.T) / 2


def spring(self: Model, name: str, stiffness: float, damping: float = 0.0, preload: float = 0.0) -> None:
    """Attach a linear spring and damper to one deformation: σ = preload + stiffness e + damping ė."""
    quantities([name], "spring")
    owner = f"spring on '{name}'"
    k, d = not_negative(stiffness, owner, "stiffness"), not_negative(damping, owner, "damping")
    self.linear_law([name], [[k]], [[d]], [number(preload, owner, "preload")])


def viscous(self: Model, name: str, damping: float) -> None:
    """Attach a viscous resistance to one slip, τ = damping s; the slip becomes free."""
    quantities([name], "viscous")
    values = {"C": np.array([not_negative(damping, f"damper on '{name}'", "damping")])}
    self.laws.append(LawInstance(name, LAWS["viscous_1"], (), (name,), values))


def law(self: Model, name: str, stress: Callable[..., Any], energy: Callable[..., Any] | None = None) -> None:
    """Attach a nonlinear spring given by a formula: σ = stress(e, ė) on one deformation.

    Parameters
    ----------
    stress : callable(e, ed)
        Called once with SymPy symbols; returns an expression.  Its tangent is derived and compiled.
    energy : callable(e), optional
        Stored energy [J]; the integral of the elastic part by default, where SymPy finds it.

    Raises
    ------
    ModelError
        If the formula is not one of e and its rate, or the energy does not belong to it.
    CompilerError
        If no C compiler is found (only user-defined laws and elements need one).

    Examples
    --------
    >>> m.law("strut.elongation", lambda e, ed: 2e4 * e + 3e6 * e**3 + 40 * ed)  # doctest: +SKIP
    """
    quantities([name], "law")
    compiled = formula_law(name, stress, energy)
    self.laws.append(LawInstance(name, compiled.spec, (name,), (), {}, compiled.address))
