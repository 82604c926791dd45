"""Whether a step has passed a flat position: the determinant of the position matrix dips to zero between its ends."""

from __future__ import annotations

import numpy as np

from flexel.engine.coordinate_work import CoordinateWork
from flexel.generated._kernels import ffi, lib
from flexel.integration.flat import flat_position
from flexel.mechanics.kinematics import Kinematics
from flexel.mechanics.states import between
from flexel.model.snapshot import Snapshot

DEEP = 10.0  # fall of the logarithm of the determinant from its largest value: the position may be nearly singular
NEAR = 1e5  # change of coordinates per unit of what is held, in natural scales, of a nearly singular position
PARTS = np.linspace(0.0, 1.0, 14)  # of a step, where the determinant is evaluated then


class Dips:
    """Follows the determinant from step to step; see dips.h.

    Attributes
    ----------
    struct : cffi struct
    close : list of (float, float)
        Times [s] at the ends of steps where the position is nearly singular, and how much coordinates change there per
        unit of rigid and prescribed quantities, in natural scales.
    """

    def __init__(self) -> None:
        self._kinematics: Kinematics | None = None
        self._t = np.nan
        self.struct = ffi.new("flexel_dips *")
        self._largest = -np.inf
        self.close: list[tuple[float, float]] = []

    def at(self, kinematics: Kinematics, t: float) -> tuple[float, float]:
        """Return the logarithm of the determinant at a time [s], or NaN, and its fall in the step before."""
        return (self.struct.size, self.struct.fall) if self.known(kinematics, t) else (np.nan, 0.0)

    def known(self, kinematics: Kinematics, t: float) -> bool:
        """Whether the determinant at a time [s] is known."""
        return kinematics is self._kinematics and t == self._t

    def largest(self, kinematics: Kinematics) -> float:
        """Return the logarithm of its largest value so far, with these degrees of freedom."""
        return self._largest if kinematics is self._kinematics else -np.inf

    def go_on(self, kinematics: Kinematics, t: float, largest: float) -> None:
        """Continue from a time [s] up to which the struct has followed the determinant, and its largest value."""
        self._kinematics, self._t, self._largest = kinematics, t, largest

    def take(self, kinematics: Kinematics, t: float, sign: int, size: float, fall: float) -> None:
        """Continue from a time [s] to which other steps have led, with what they found."""
        if np.isnan(size) or kinematics is not self._kinematics:
            self._largest = -np.inf
        self._kinematics, self._t = (None if np.isnan(size) else kinematics), t
        self.struct.sign, self.struct.size, self.struct.fall = sign, size, fall
        self._largest = max(size, self._largest)

    def forget(self) -> None:
        """Continue without the determinant of the last step, whose matrix another method has."""
        self._kinematics = None

    def back(self, t: float) -> None:
        """Discard what was found after a time [s]: these steps are dropped."""
        self.close = [found for found in self.close if found[0] <= t]

    def _note(self, t: float, choice: CoordinateWork) -> None:
        """Record the end of a step if the position there is nearly singular."""
        found = choice.sensitivity()
        if found >= NEAR:
            self.close.append((t, found))

    def passed(
        self, kinematics: Kinematics, first: Snapshot, last: Snapshot, choice: CoordinateWork
    ) -> float | None:
        """Return the time [s] of a flat position in or close to a step; None if there is none.

        Parameters
        ----------
        first, last : Snapshot
            Its ends.
        choice : CoordinateWork
            With the position matrix at its end.
        """
        looks = lib.flexel_dips_look(self.struct, choice.P, self.known(kinematics, first.t))
        size = self.struct.size
        self.go_on(kinematics, last.t, max(size, self.largest(kinematics)))
        if self._largest - size >= DEEP:
            self._note(last.t, choice)
        if not looks:
            return None
        times = first.t + PARTS * (last.t - first.t)
        share = flat_position(np.array([_size(kinematics, first, last, t) for t in times.tolist()]), PARTS)
        return None if share is None else first.t + share * (last.t - first.t)


def _size(kinematics: Kinematics, first: Snapshot, last: Snapshot, t: float) -> float:
    """Return the logarithm of the determinant's size at a time within a step, where the coordinates are about right."""
    choice, guess = kinematics.choice, between(first, last, t)
    choice.reset()
    choice.work.x[:], choice.work.unwrap_from[:] = guess.x, guess.e
    choice.work.position()
    choice.factorize()
    return choice.determinant
