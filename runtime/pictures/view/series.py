"""Numbers beside the picture: time histories for the plot strip, and the noise floors of the colours."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.pictures.figures import COLOURS, axis_label
from flexel.pictures.shape import Shape
from flexel.results.quantities import history
from flexel.structure.state import State

if TYPE_CHECKING:
    from flexel.results.quantities import History
    from flexel.structure.structure import Structure

MOST = 60  # histories in a page for which none were named
SHOWN = 3  # histories drawn when the page opens
NOISE = 1e-9  # of the largest force in a motion: smaller tensions are rounding
STRAIN = 1e-12  # strains below are rounding


def histories(states: Sequence[State], asked: Sequence[str] | None) -> dict[str, Any]:
    """Histories for the plot strip: those requested, then degrees of freedom, then other quantities that change.

    Parameters
    ----------
    states : sequence of State
    asked : sequence of str, optional
        Names as for `Motion.series`: ``"steer.angle'"`` is a rate, ``"force:rod.elongation"`` a stress.  They are
        drawn when the page opens; by default the first degrees of freedom.

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
    shown = list(dofs[:SHOWN] if asked is None else asked)
    table = np.array([z.values for z in states])
    others = [z for z in s.names if _plain(s, z) and np.ptp(table[:, s.index[z]]) > 0]
    rows = []
    for name in list(dict.fromkeys([*shown, *dofs, *others]))[: max(MOST, len(shown))]:
        z = history(s, name)
        values = (
            table[:, s.index[name]] if name in s.index else np.array([_value(state, z) for state in states])
        )
        if np.all(np.isfinite(values)):
            unit = "" if z.unit in ("-", "1") else z.unit
            labels = {"label": axis_label([name], unit), "shared": axis_label([name] * 2, unit)}
            rows.append({"name": name, "unit": unit, **labels, "values": values})
    return {"shown": shown, "rows": rows, "colours": COLOURS}


def _plain(s: Structure, name: str) -> bool:
    """Whether a quantity is one that people look at: no slip, no norm, no Euler parameter, no sensor's."""
    i = s.index[name]
    return (
        not (s.m <= i < s.m + s.k)
        and not s.is_norm(name)
        and name.count(".") == 1
        and not name.endswith((".l0", ".l1", ".l2", ".l3"))
    )


def _value(state: State, z: History) -> float:
    read = {-1: state.force, 1: state.rate, 2: state.acceleration}
    return float(state[z.base] if not z.order else read[z.order](z.base))


def floors(states: Sequence[State], table: Sequence[Sequence[Shape]], size: float) -> dict[str, float]:
    """Size below which a value used for colouring is noise, by name.

    Parameters
    ----------
    states : sequence of State
    table : sequence of sequences of Shape
        Shapes of the parts at each frame.
    size : float
        Of the model [m].
    """
    largest = max((float(np.max(np.abs(z.stresses), initial=0.0)) for z in states), default=0.0)
    given = {"tension": NOISE * largest, "bending moment": NOISE * largest * size}
    names = {name for shapes in table[:1] for shape in shapes for name in shape.values}
    return {name: float(f"{given.get(name, STRAIN):.6g}") for name in sorted(names)}
