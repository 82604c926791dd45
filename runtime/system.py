"""The built system: its core and the analyses of it."""

from __future__ import annotations

from flexel.analyses.equilibria import Equilibria
from flexel.analyses.motions import Motions
from flexel.analyses.periodic import PeriodicMotions
from flexel.analyses.restoring import Restoring


class System(Motions, Equilibria, PeriodicMotions, Restoring):
    """A mechanism ready to move; made by `Model.build`.

    Attributes
    ----------
    structure : Structure
        Names and index maps.
    roles : Roles
        The constraints and the current choice of degrees of freedom.
    """
