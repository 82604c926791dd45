"""Energies of a workspace in C, and its contacts: laws whose first deformation is a gap."""

from __future__ import annotations

from typing import Any

import numpy as np

from flexel.engine.stages import flat
from flexel.engine.workspace import Workspace
from flexel.generated._kernels import ffi, lib


class Energies:
    """Energies and contacts at the last evaluation of a workspace.

    Attributes
    ----------
    struct : cffi struct
        Kinetic, potential, strain and contact energy [J], lost power [W], depths of contacts [m]; see balance.h.
    """

    def __init__(self, work: Workspace) -> None:
        kinds, law = work.tables.structure.kinds, work.tables.law
        none = work.tables.structure.m  # no deformation: a law may act on nothing, or on slips alone
        parts = (rows[:, 0] if rows.shape[1] else np.full(len(rows), none) for rows in law.lines)
        first = flat(parts)  # quantities that the laws first act on, law by law
        deformed = [q < len(kinds) and kinds[q] == "gap" for q in first]
        contacts = np.flatnonzero(deformed).astype(np.int32)
        self._work, self._keep = work, (contacts, first[contacts].astype(np.int32))
        self._touching = np.zeros(contacts.size, dtype=np.uint8)
        self.struct: Any = ffi.new("flexel_energies *")
        self.struct.ncontacts = contacts.size
        self.struct.law, self.struct.gap = (ffi.from_buffer("int[]", indices) for indices in self._keep)
        self.struct.touching = ffi.from_buffer("unsigned char[]", self._touching)

    def evaluate(self) -> None:
        """Compute the energies at the last balance of the workspace."""
        lib.flexel_energies_at(self.struct, self._work.struct)

    def note(self) -> None:
        """Record which contacts are closed."""
        lib.flexel_touched(self.struct, self._work.struct)
