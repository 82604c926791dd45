"""What a system is and what it asks of an integrator, in a few lines."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.errors import FlexelError
from flexel.base.shown import Table, listed
from flexel.engine.solvers import eigenvalues
from flexel.integration.methods import ALPHA, EXPLICIT, MANY, STIFF
from flexel.mechanics.core import Core
from flexel.mechanics.inertia import InertiaError


@dataclass(frozen=True)
class Summary:
    """A system in a few lines; printed as a table.

    Attributes
    ----------
    lines : tuple of (str, str)
        What, and how many or which.
    """

    lines: tuple[tuple[str, str], ...]

    def _table(self) -> Table:
        return Table("", ("system", ""), self.lines)

    def __repr__(self) -> str:
        return self._table().text

    def _repr_html_(self) -> str:
        return self._table().html


def summarized(system: Core) -> Summary:
    """The summary of a system at its start; see `System.summary`."""
    c, names = system.counts, system.structure.names
    prescribed = [names[i] for i in system.roles.prescribed]
    lines = [
        ("degrees of freedom", f"{c['degrees_of_freedom']}: {listed(system.dynamic) or 'none'}"),
        ("coordinates", f"{c['coordinates']}, {c['free_coordinates']} of them free"),
        ("deformations", f"{c['deformations']}, {c['rigid_deformations']} of them rigid"),
    ]
    if system.kinematic:
        lines.insert(1, ("kinematic coordinates", f"{len(system.kinematic)}: {listed(system.kinematic)}"))
    if c["slips"]:
        lines.append(("slips", f"{c['slips']}, {c['zero_slips']} of them zero (rolling)"))
    if prescribed:
        lines.append(("prescribed", listed(prescribed)))
    if system.structure.nz:
        lines.append(("internal states of laws", listed(tuple(system.structure.internal))))
    return Summary((*lines, *_speed(system)))


def _speed(system: Core) -> list[tuple[str, str]]:
    """The fastest eigenvalue at the start, and the integrator that `simulate` takes by itself."""
    if not system.roles.nq:
        return [("integrator", "none: every motion is prescribed")]
    if system.roles.nd > MANY:
        return [("integrator", f"{ALPHA}, above {MANY} degrees of freedom")]
    try:
        w = np.abs(eigenvalues(system.linearize().state_matrix))
    except InertiaError as error:
        return [("integrator", f"{ALPHA}: {error}")]
    except (FlexelError, np.linalg.LinAlgError) as error:
        return [("integrator", f"{EXPLICIT}; the start cannot be linearized: {error}")]
    fastest = float(w.max(initial=0.0))
    slow = w[w > 1e-6 * fastest]
    lines = (
        [("eigenvalues", f"{slow.min():.3g} to {fastest:.3g} 1/s in magnitude at the start")]
        if slow.size
        else []
    )
    if not fastest:
        return [("integrator", EXPLICIT)]
    longest = STIFF / fastest
    stiff = " (stiff)" if longest < 10 else ""
    return [*lines, ("integrator", f"{EXPLICIT} up to {longest:.3g} s, {ALPHA} for longer motions{stiff}")]
