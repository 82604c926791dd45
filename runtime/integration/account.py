"""The energy balance of a motion in minimal coordinates, integrated with its steps; see account.h."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np
from scipy.integrate import RK45
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


def _of_dop853() -> Quadrature:
    B, E5, E3 = (np.ascontiguousarray(z, dtype=float) for z in (tableau.B, tableau.E5, tableau.E3))
    return Quadrature(B, E5, E3, 0, 12)


def _of_radau() -> Quadrature:
    """Compare with the formulas of the start and the first two stages, and of the start and the end."""
    places = np.append(NODES, 0.0)
    own = np.append(WEIGHTS[2], 0.0)
    fine, rough = own.copy(), own.copy()
    for difference, used in ((fine, [0, 1, 3]), (rough, [2, 3])):
        difference[used] -= _interpolating(places[used])
    return Quadrature(WEIGHTS[2].copy(), fine, rough, 3, 2)


def _of_rk45() -> Quadrature:
    E = np.ascontiguousarray(RK45.E, dtype=float)
    return Quadrature(np.ascontiguousarray(RK45.B, dtype=float), E, np.zeros_like(E), 0, 6)


def _of_lobatto() -> Quadrature:
    """Compare with the formula without the middle, and with Simpson's."""
    places = np.concatenate([[0.0], INNER, [1.0]])
    own = _interpolating(places)
    fine, rough = own.copy(), own.copy()
    for difference, used in ((fine, [0, 1, 3, 4]), (rough, [0, 2, 4])):
        difference[used] -= _interpolating(places[used])
    return Quadrature(own, fine, rough, 0, 4)


def _interpolating(places: Array) -> Array:
    """Weights with which values at some places give the integral from zero to one of the polynomial through them."""
    powers = np.arange(places.size)
    return np.asarray(np.linalg.solve(places ** powers[:, None], 1 / (powers + 1)))


# Of Lobatto's formula of order 8, between the ends: for methods that have no formula over one step alone.
INNER = 0.5 + np.array([-1.0, 0.0, 1.0]) * np.sqrt(3 / 28)
QUADRATURES = {"DOP853": _of_dop853(), "Radau": _of_radau(), "RK45": _of_rk45()}
QUADRATURES |= dict.fromkeys(("BDF", "LSODA"), _of_lobatto())


class Account(Struct):
    """The struct of account.h, for one motion by one method.

    Parameters
    ----------
    quadrature : Quadrature
    """

    def __init__(self, quadrature: Quadrature) -> None:
        super().__init__(ffi.new("flexel_account *"))
        c = self.struct
        c.start, c.end = quadrature.start, quadrature.end
        c.nweights, c.nestimates = quadrature.weights.size, quadrature.estimate.size
        c.weights, c.estimate = self.pointer(quadrature.weights), self.pointer(quadrature.estimate)
        c.rough = self.pointer(quadrature.rough)
        self.part()
        self._next = 0
        self._last = quadrature.end
        self._bytes = ffi.buffer(self.struct)
        self._noted: deque[tuple[float, bytes]] = deque(maxlen=MOST)

    def note(self, t: float) -> None:
        """Remember the account at a time [s], the end of a step."""
        self._noted.append((t, self._bytes[:]))

    def back(self, t: float) -> float:
        """Forget the steps that began at a time [s] or later; returns up to when the account then goes [s]."""
        noted = self._noted
        while len(noted) > 1 and noted[-2][0] >= t:
            noted.pop()
        self._bytes[:] = noted[-1][1]
        return noted[-1][0]

    def part(self) -> None:
        """The energy may differ where the next steps begin: after an impulse, or with other internal states."""
        self.struct.parted = 1

    # -- for methods whose stages are not in C, each of which evaluates the rates once ------------------

    def begin(self) -> None:
        """Expect the next evaluation at the start of a step, as the first of a new sequence."""
        self._next = 0

    def first_trial(self) -> None:
        """Expect the next evaluation at the first stage after the start."""
        self._next = 1

    def evaluated(self, choice: CoordinateWork) -> None:
        """Take the powers of the evaluation that was made."""
        work, c = choice.work.struct, choice.struct
        if self._next == 0:
            lib.flexel_account_begin(self.struct, work, c)
        elif self._next == self._last:
            lib.flexel_account_end(self.struct, work, c)
        else:
            lib.flexel_account_stage(self.struct, work, c, self._next)
        self._next = self._next % self._last + 1

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
