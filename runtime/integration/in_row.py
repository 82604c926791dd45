"""What the steps that are taken in a row in C have in common, see in_row.h, and what is kept of them."""

from __future__ import annotations

from itertools import accumulate, pairwise
from typing import Any, NamedTuple

import numpy as np

from flexel.base.arrays import Array
from flexel.engine.contact_look import ContactLook
from flexel.engine.coordinate_work import CoordinateWork
from flexel.engine.structs import Struct
from flexel.generated._kernels import ffi
from flexel.integration.dips import DEEP, Dips
from flexel.mechanics.kinematics import Kinematics

ROOM = 2**18  # bytes for what is kept of steps: at least one step has room


class Looks(NamedTuple):
    """What is looked at in the steps of a motion.

    Attributes
    ----------
    contacts : ContactLook
    dips : Dips
    least : float
        Length below which a step is too short, wherever it is [s].
    """

    contacts: ContactLook
    dips: Dips
    least: float


class Place(NamedTuple):
    """Where a row of steps begins, and where it ends at the latest.

    Attributes
    ----------
    t, end : float
        [s]
    amplification, allowed : float
        Of the degrees of freedom, and up to which there are steps.
    most : int
        Steps.
    """

    t: float
    end: float
    amplification: float
    allowed: float
    most: int


class Kept:
    """The steps of a row that are kept, in the struct of in_row.h.

    Parameters
    ----------
    owner : Struct
        It keeps the arrays alive.
    row : cffi struct
    kinematics : Kinematics
    choice : CoordinateWork
        Arrays of the steps.
    looks : Looks
    sizes : sequence of int
        Numbers of each part of a step that is kept.
    """

    def __init__(
        self,
        owner: Struct,
        row: Any,
        kinematics: Kinematics,
        choice: CoordinateWork,
        looks: Looks,
        sizes: tuple[int, ...],
    ) -> None:
        self._row, self._kinematics, self._looks = row, kinematics, looks
        row.work, row.choice = choice.work.struct, choice.struct
        row.touching, row.dips = looks.contacts.struct, looks.dips.struct
        row.deep, row.shortest = DEEP, looks.least
        self.parts = [slice(*ends) for ends in pairwise(accumulate(sizes, initial=0))]
        row.width = self.parts[-1].stop
        self._room = max(1, ROOM // (8 * row.width))
        self._numbers = np.empty((self._room, row.width))
        row.kept = owner.pointer(self._numbers)
        self._accounts = row.accounts = ffi.new("flexel_account[]", self._room)

    def begin(self, place: Place) -> None:
        """Prepare a row."""
        row, dips = self._row, self._looks.dips
        row.end, row.most, row.taken, row.waits = place.end, min(place.most, self._room), 0, False
        row.amplification, row.allowed = place.amplification, place.allowed
        row.known, row.largest = dips.known(self._kinematics, place.t), dips.largest(self._kinematics)

    def end(self, t: float) -> Array:
        """Return the steps (taken, numbers) of a row that has come to a time [s]."""
        row = self._row
        if row.taken:
            self._looks.dips.go_on(self._kinematics, t, float(row.largest))
        return self._numbers[: row.taken].copy()

    def balances(self) -> list[bytes]:
        """Return the energy balances at the ends of the steps."""
        size, found = ffi.sizeof("flexel_account"), ffi.buffer(self._accounts)
        return [found[i * size : (i + 1) * size] for i in range(self._row.taken)]
