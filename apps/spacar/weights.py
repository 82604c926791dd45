"""Computes stresses of rigid beams under their weight, which UT SPACAR leaves out of its results.

The weight of a beam, spread over its length, loads its nodes with half of it and with a pair of opposite moments,
rhoA l0² |g| / 12 on a level beam.  On a rigid beam the pair is balanced by the beam's stresses; without it they are
smaller by rhoA l0 g_z / 12 in the modes that bend it in z, and by -rhoA l0 g_y / 12 in those that bend it in y.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from flexel.apps.spacar.file_entries import ElementEntry, length
from flexel.base.quaternions import in_frame, matrix, triad
from flexel.model.node import COMPONENTS
from flexel.model.state import State


@dataclass(frozen=True)
class Weight:
    """The stress by weight of one mode of a rigid beam, force · R(λ) axis.

    Attributes
    ----------
    frame : str
        The orientation node of the beam's first end, or its angle.
    axis : tuple of float (3,)
        The section's axis of bending deflection, in the axes of the frame.
    force : tuple of float (3,)
        The stress if the axis points in x, y or z.
    """

    frame: str
    axis: tuple[float, ...]
    force: tuple[float, ...]
    planar: bool

    def stress(self, state: State) -> float:
        """Return the stress at a state, in SPACAR's sign."""
        if self.planar:
            turn = state[f"{self.frame}.angle"]
            R = np.array(
                [[np.cos(turn), -np.sin(turn), 0.0], [np.sin(turn), np.cos(turn), 0.0], [0.0, 0.0, 1.0]]
            )
        else:
            R = matrix(np.array([state[f"{self.frame}.{component}"] for component in COMPONENTS["frame"]]))
        return float(np.array(self.force) @ R @ np.array(self.axis))


def unloaded_stresses(
    elements: Iterable[ElementEntry], gravity: Sequence[float]
) -> dict[tuple[int, int], Weight]:
    """Return the stresses by weight of all modes of rigid beams, by element and mode."""
    found: dict[tuple[int, int], Weight] = {}
    g = np.array(gravity)
    for entry in elements:
        mass = entry.values("EMASS")[:1]
        if (
            entry.line.keyword not in ("BEAM", "BEAMW", "PLBEAM")
            or entry.free
            or not any(mass)
            or not g.any()
        ):
            continue
        p, frame, q = entry.nodes[:3]
        l0 = length(entry)
        force = mass[0] * l0 * g / 12
        if entry.line.keyword == "PLBEAM":
            dx, dy = (q.x - p.x) / l0
            c, s = np.cos(frame.x[0]), np.sin(frame.x[0])
            axis = (float(-c * dy + s * dx), float(s * dy + c * dx), 0.0)
            # the planar modes have the opposite sign
            found |= {
                (entry.number, i): Weight(frame.name, axis, tuple(force.tolist()), True) for i in (2, 3)
            }
            continue
        T = matrix(in_frame(frame.x, triad((q.x - p.x) / l0, entry.numbers or None, entry.name)))
        for sign, column, modes in ((1.0, 2, (3, 4)), (-1.0, 1, (5, 6))):
            own = Weight(frame.name, tuple(T[:, column].tolist()), tuple((sign * force).tolist()), False)
            found |= {(entry.number, i): own for i in modes}
    return found
