"""The built system: its core and the analyses of it."""

from __future__ import annotations

from typing import Any

from flexel.analyses.ensembles import Ensembles
from flexel.analyses.equilibria import Equilibria
from flexel.analyses.periodic import PeriodicMotions
from flexel.analyses.restoring import Restoring
from flexel.analyses.stepper import Stepping
from flexel.analyses.summary import Summary, summarized


class System(Ensembles, Equilibria, PeriodicMotions, Restoring, Stepping):
    """A mechanism ready for analysis; made by `Model.build`.

    Attributes
    ----------
    structure : Structure
        Names and index maps.
    roles : Roles
        The constraints and the current choice of degrees of freedom.
    """

    def summary(self) -> Summary:
        """Degrees of freedom, constraints, eigenvalues at the start, and the integrator that suits them, as a table."""
        return summarized(self)

    def _repr_html_(self) -> str:
        return self.summary()._repr_html_()

    def __getstate__(self) -> dict[str, Any]:
        """Its model, the present coordinates and the last position; tables and caches are made again."""
        own = {"evaluation": self.evaluation, "loads": self.loads, "roles": self.roles}
        return own | {"last": self._last, "start": self._start}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """The same system; its tables are made when it is first evaluated."""
        self._prepare(state["evaluation"], state["loads"], state["roles"])
        self._start, self._continued = state["start"], state["last"]
