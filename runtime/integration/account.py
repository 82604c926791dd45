"""The energy balance of a motion in minimal coordinates, integrated with its steps; see account.h."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as tableau

from flexel.base.arrays import Array
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.structs import Struct
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib
from flexel.integration.radau_tableau import NODES, WEIGHTS

MOST = 1000  # steps to which it can go back


@dataclass(frozen=True)
class Quadrature:
    """How a method integrates a power over its steps.

    Attributes
    ----------
    weights : ndarray
        Of its stages.
    estimate, rough : ndarray
        Of the same and one more, in a fine and a rough estimate of the error.
    start, end : int
        Which of them are at the start and at the end of a step.
    """

    weights: Array
    estimate: Array
    rough: Array
    start: int
    end: int


def of_dop853() -> Quadrature:
    """Return the formulas of DOP853."""
    B, E5, E3 = (np.ascontiguousarray(z, dtype=float) for z in (tableau.B, tableau.E5, tableau.E3))
    return Quadrature(B, E5, E3, 0, 12)


def of_radau() -> Quadrature:
    """Return those of Radau, compared with that of the start and the first two stages, and of the start and the end."""
    places = np.append(NODES, 0.0)
    own = np.append(WEIGHTS[2], 0.0)
    fine, rough = own.copy(), own.copy()
    for difference, used in ((fine, [0, 1, 3]), (rough, [2, 3])):
        difference[used] -= _interpolating(places[used])
    return Quadrature(WEIGHTS[2].copy(), fine, rough, 3, 2)


def _interpolating(places: Array) -> Array:
    """Weights with which values at some places give the integral from zero to one of the polynomial through them."""
    powers = np.arange(places.size)
    return np.asarray(np.linalg.solve(places ** powers[:, None], 1 / (powers + 1)))


class Account(Struct):
    """The struct of account.h, for one motion.

    Parameters
    ----------
    quadrature : Quadrature
        Of its method.
    """

    def __init__(self, quadrature: Quadrature) -> None:
        super().__init__(ffi.new("flexel_account *"))
        self.use(quadrature)
        self.part()
        self._bytes = ffi.buffer(self.struct)
        self._noted: deque[tuple[float, bytes]] = deque(maxlen=MOST)

    def use(self, quadrature: Quadrature) -> None:
        """Integrate by the formulas of another method from now on."""
        names = "weights", "estimate", "rough"
        self._method = {name: self.pointer(getattr(quadrature, name)) for name in names}
        self._method |= {"start": quadrature.start, "end": quadrature.end}
        self._method |= {"nweights": quadrature.weights.size, "nestimates": quadrature.estimate.size}
        self._give_method()

    def _give_method(self) -> None:
        for name, value in self._method.items():
            setattr(self.struct, name, value)

    def note(self, t: float, balance: bytes | None = None) -> None:
        """Remember the account, or what it was, at a time [s], the end of a step."""
        self._noted.append((t, self._bytes[:] if balance is None else balance))

    def back(self, t: float) -> float:
        """Forget the steps that began at a time [s] or later; returns up to when the account then goes [s]."""
        noted = self._noted
        while len(noted) > 1 and noted[-2][0] >= t:
            noted.pop()
        self._bytes[:] = noted[-1][1]
        self._give_method()  # the steps that are forgotten may be those of another one
        return noted[-1][0]

    def part(self) -> None:
        """The energy may differ where the next steps begin: after an impulse, or with other internal states."""
        self.struct.parted = 1

    def accept(self, h: float) -> None:
        """Add the step of length h [s] that was evaluated last."""
        lib.flexel_account_accept(self.struct, h)

    def carry(self, end: Workspace, h: float, lost: float, work: float, doubt: float) -> None:
        """Add a stretch of length h [s] with known energies and their error [J], from inertia and laws at its end."""
        lib.flexel_account_carry(self.struct, end.struct, h, lost, work, doubt)


def powers(choice: CoordinateWork) -> tuple[float, float]:
    """Return the powers [W] taken out and supplied at the evaluation that was made."""
    found = ffi.new("flexel_account *")
    lib.flexel_account_stage(found, choice.work.struct, choice.struct, 0)
    return float(found.lost[0]), float(found.work[0])
