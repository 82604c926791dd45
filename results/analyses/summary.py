"""Summary of a system and of its demands on an integrator."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flexel.base.arrays import Array
from flexel.base.blas import in_one_thread
from flexel.base.shown import PrintedTable, listed, prints
from flexel.integration.methods import AUTO, Options, start_of
from flexel.integration.stiffness import ALPHA, EXPLICIT, RADAU, RIGID, limit, smooth, stiff, suitable
from flexel.mechanics.actuation import path_of
from flexel.mechanics.linearize import linearize
from flexel.mechanics.steadiness import UNSTEADY, VARYING
from flexel.model.state import State
from flexel.system import CoreSystem

# Ratio of inertias from which a system is called badly scaled: half the digits are lost.
UNEVEN_INERTIA_RATIO = 1e8
LONG_MOTION_FACTOR = 2.0  # times the longest motion for the explicit method: a long motion
STIFF_DURATION_S = 10.0  # longest motion [s] for the explicit method below which a system is called stiff


@dataclass(frozen=True)
class Summary:
    """A system in a few lines; printed as a table.

    Attributes
    ----------
    lines : tuple of (str, str)
        Name and value of each line.
    """

    lines: tuple[tuple[str, str], ...]

    def _table(self) -> PrintedTable:
        return PrintedTable("", ("system", ""), self.lines)

    @prints
    def __repr__(self) -> str:
        return self._table().text

    def _repr_html_(self) -> str:
        return self._table().html


@in_one_thread
def summarized(system: CoreSystem) -> Summary:
    """Summarize a system at its start; see `System.summary`."""
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
    if system.roles.actuated:
        lines.append(("moved by actuators", listed(path_of(system.structure, system.roles)[1])))
    if system.structure.nz:
        lines.append(("internal states of laws", listed(tuple(system.structure.internal))))
    return Summary((*lines, *_speed(system)))


def _speed(system: CoreSystem) -> list[tuple[str, str]]:
    """Return the fastest eigenvalue at the start, and the integrator that `simulate` chooses by default."""
    if not system.roles.nq:
        return [("integrator", "none: every motion is prescribed")]
    if system.roles.actuated:
        return [("integrator", f"{EXPLICIT}: actuators hold a path")]
    start = start_of(system, AUTO, None, Options())
    found = suitable(system, start)
    if found.method:
        return [("integrator", f"{found.method}: {found.detail or found.why}")]
    if found.is_large:
        return [("integrator", f"{EXPLICIT} or {RADAU}, whichever takes fewer evaluations: {found.why}")]
    uneven, fastest = _uneven(system, found.inertia), float(found.rates.max(initial=0.0))
    if not fastest:
        return [*uneven, ("integrator", EXPLICIT)]
    slowest, longest = float(found.rates[found.rates > RIGID * fastest].min()), limit(system) / fastest
    suits = f"{EXPLICIT}, also for long motions from this start"
    if stiff(system, start, found, LONG_MOTION_FACTOR * longest)[0]:
        word = " (stiff)" if longest < STIFF_DURATION_S else ""
        suits = (
            f"{EXPLICIT} up to {longest:.3g} s, {RADAU if smooth(system) else ALPHA} for longer motions{word}"
        )
    change = _variation(system, start) if system.roles.motions else 0.0
    share = f"{change:.2g} of what holds a vibration"
    varying = f"vary with time, by up to {share}: use periodic(…).multipliers() or along(…)"
    return [
        *uneven,
        ("eigenvalues", f"{slowest:.3g} to {fastest:.3g} 1/s in magnitude at the start"),
        *([("coefficients", varying)] if change > VARYING else []),
        ("integrator", suits),
    ]


def _variation(system: CoreSystem, start: State) -> float:
    """Return how much prescribed motions change the linearized equations within a slow vibration from the start."""
    lin = linearize(system.kinematics, start)
    return lin.variation() if lin.acceleration <= UNSTEADY else 0.0


def _uneven(system: CoreSystem, inertia: Array) -> list[tuple[str, str]]:
    """Return a line if inertias differ so much that digits are lost; missing inertia is reported in another line."""
    low, high = (int(extreme(inertia)) for extreme in (np.argmin, np.argmax)) if inertia.size else (0, 0)
    if low == high or not inertia[high] > UNEVEN_INERTIA_RATIO * inertia[low] > 0:
        return []
    ratio, names = inertia[high] / inertia[low], system.dynamic
    what = f"badly scaled: the inertia of '{names[high]}' is {ratio:.1g} times that of '{names[low]}'"
    return [("scales", f"{what}; check masses and units, or hold the light part")]
