"""Printed forms of linearizations: one line, and in a notebook the table of their modes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from flexel.base.shown import Table, counted, listed
from flexel.mechanics.modes import Mode, modes_of
from flexel.mechanics.steadiness import UNSTEADY

if TYPE_CHECKING:
    from flexel.mechanics.soft import Spectrum
    from flexel.structure.state import State


class ShownLinearization:
    """The printed forms of a `Linearization`."""

    if TYPE_CHECKING:
        dynamic: tuple[str, ...]
        kinematic: tuple[str, ...]
        internal: tuple[str, ...]
        state: State
        dofs: property
        acceleration: property

        def _spectrum(self) -> Spectrum: ...

    def __repr__(self) -> str:
        others = ((self.kinematic, "kinematic coordinate"), (self.internal, "state of laws"))
        more = [counted(len(names), what) for names, what in others if names]
        return f"Linearization(about t = {self.state.t:g} s in {', '.join([listed(self.dynamic) or 'nothing', *more])})"

    def _repr_html_(self) -> str:
        names = (*self.dynamic, *self.kinematic, *self.internal)
        modes = modes_of(self._spectrum(), names, len(self.dynamic))
        note = (
            ""
            if self.acceleration <= UNSTEADY
            else "; the state accelerates, so these are not modes of a motion"
        )
        return Table(f"{self!r}{note}", Mode.HEAD, [z.row() for z in modes]).html
