"""Prepares the numbers shown with the picture: time histories for the plot strip, and noise floors of the colours."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.apps.view.figures import COLOURS, axis_label
from flexel.apps.view.primitives import Shape
from flexel.base.arrays import Array
from flexel.model.quantities import history
from flexel.model.state import State

if TYPE_CHECKING:
    from flexel.model.quantities import History
    from flexel.model.structure import Structure

MAX_HISTORIES = 60  # histories in a page if none are named
HISTORIES_SHOWN = 3  # histories drawn when the page opens
STILL = 1e-3  # a coordinate moves, if it does by more than this part of the largest travel of its point
FORCE_NOISE = 1e-9  # of the largest force in a motion: smaller tensions are rounding errors
STRAIN_NOISE = 1e-12  # smaller strains are rounding errors


def histories(states: Sequence[State], asked: Sequence[str] | None) -> dict[str, Any]:
    """Choose histories for the plot strip: those requested, then degrees of freedom, then other changing quantities.

    Parameters
    ----------
    states : sequence of State
    asked : sequence of str, optional
        Names as for `Motion.series`: ``"steer.angle'"`` is a rate, ``"force:rod.elongation"`` a stress.  They are
        drawn when the page opens; by default degrees of freedom that a person can see.

    Returns
    -------
    dict
        ``"shown"``: names; ``"rows"``: name, unit, values, and labels of an axis for it alone (``"label"``) and shared
        (``"shared"``); ``"colours"``: of the lines, in their order.

    Raises
    ------
    ModelError
        An unknown name.
    """
    s = states[0].structure
    dofs = [s.names[i] for i in states[0].roles.dynamic]
    table = np.array([state.values for state in states])
    shown = _familiar(s, dofs, table) if asked is None else list(asked)
    turns = {c for node in s.nodes if node.kind == "frame" for c in node.coordinates}
    plain = (name for name in s.names if name not in turns and _plain(s, name))
    others = [name for name in plain if np.ptp(table[:, s.index[name]]) > 0]
    rows = []
    for name in list(dict.fromkeys([*shown, *dofs, *others]))[: max(MAX_HISTORIES, len(shown))]:
        quantity = history(s, name)
        values = (
            table[:, s.index[name]]
            if name in s.index
            else np.array([_value(state, quantity) for state in states])
        )
        if np.all(np.isfinite(values)):
            unit = "" if quantity.unit in ("-", "1") else quantity.unit
            labels = {"label": axis_label([name], unit), "shared": axis_label([name] * 2, unit)}
            rows.append({"name": name, "unit": unit, **labels, "values": values})
    return {"shown": shown, "rows": rows, "colours": COLOURS}


def _familiar(s: Structure, dofs: Sequence[str], table: Array) -> list[str]:
    """Choose what is drawn when the page opens: quantities that a person can see, and that change.

    These are degrees of freedom but deformations by an elastic law, slopes and Euler parameters; then the coordinates
    of the point that moves farthest.
    """
    elastic = {name for law in s.laws if law.called is not None for name in law.deformations}
    seen = {c for node in s.nodes if node.kind.endswith(("point", "angle")) for c in node.coordinates}
    inner = [name for name in dofs if name not in seen and (name in s.coordinate_of or name in elastic)]
    found = [name for name in dofs if name not in inner][:HISTORIES_SHOWN]
    points = [node for node in s.nodes if node.kind.endswith("point") and "." not in node.name]
    if inner and points:
        travel = [np.ptp(table[:, [s.index[c] for c in node.coordinates]], axis=0) for node in points]
        far = max(range(len(points)), key=lambda i: float(np.max(travel[i])))
        least = STILL * float(np.max(travel[far]))
        moving = [c for c, way in zip(points[far].coordinates, travel[far], strict=True) if way > least]
        found += [name for name in moving if name not in found]
    return found[:HISTORIES_SHOWN] or list(dofs[:HISTORIES_SHOWN])


def _plain(s: Structure, name: str) -> bool:
    """Whether a quantity is of interest to people: no slip, no norm, not of a sensor."""
    i = s.index[name]
    return not (s.m <= i < s.m + s.k) and not s.is_norm(name) and name.count(".") == 1


def _value(state: State, quantity: History) -> float:
    read = {-1: state.force, 1: state.rate, 2: state.acceleration}
    return float(state[quantity.base] if not quantity.order else read[quantity.order](quantity.base))


def floors(states: Sequence[State], parts: Sequence[Shape], size: float) -> dict[str, float]:
    """Return the size below which a value used for colouring is noise, by name.

    Parameters
    ----------
    states : sequence of State
    parts : sequence of Shape
    size : float
        Of the model [m].
    """
    largest = max((float(np.max(np.abs(state.stresses), initial=0.0)) for state in states), default=0.0)
    given = {"tension": FORCE_NOISE * largest, "bending moment": FORCE_NOISE * largest * size}
    names = {name for part in parts for name in part.values}
    return {name: float(f"{given.get(name, STRAIN_NOISE):.6g}") for name in sorted(names)}
