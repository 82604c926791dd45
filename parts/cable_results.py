"""Tension, strain and curvature of cables, at three points of each: outputs of the element.

A user's page may report them at other points.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flexel.base.arguments import unknown
from flexel.base.arrays import Array
from flexel.base.errors import ModelError
from flexel.model.instances import Instance
from flexel.model.state import State


def cable_tension(state: State, cable: str) -> tuple[Array, Array]:
    """Return arc length [m] and tension [N] at three points of a cable, with damping; compression is negative.

    Parameters
    ----------
    state : State
    cable : str
        Name of an element.

    Returns
    -------
    s, T : ndarray (3,)
        Undeformed arc length from the first end, and the force in the direction of the cable, at the Gauss points.

    Raises
    ------
    ModelError
        If there is no cable of that name.
    """
    found = cable_outputs([state], [find_cable(state, cable)])
    return found["arc_length"][0, 0], found["tension"][0, 0]


def cable_outputs(states: Sequence[State], cables: Sequence[Instance]) -> dict[str, Array]:
    """Return outputs of cables of one type in states of one model, by name: (states, cables, 3) of the points."""
    arrays = (np.array([getattr(state, name) for state in states]) for name in ("x", "e", "stresses"))
    return states[0].evaluation.outputs(cables, *arrays)


def find_cable(state: State, cable: str) -> Instance:
    """Find the cable with this name, or raise a ModelError with the nearest ones."""
    known = {element.name: element for element in state.structure.instances if element.spec.family == "cable"}
    if not isinstance(cable, str) or cable not in known:
        raise ModelError(unknown(str(cable), known, "cable"))
    return known[cable]
