"""Computes the values for colouring in a mode of vibration: amplitudes of tension, bending moment and strain."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from flexel.apps.view import drawing
from flexel.apps.view.page.packing import packed
from flexel.apps.view.primitives import UNITS
from flexel.apps.view.scene import View
from flexel.base.arrays import Array, ComplexArray
from flexel.engine.evaluate import Evaluation
from flexel.model.state import State

SUFFIX = " of the mode"  # appended to the name of a value


def modal_values(state: State, amplitude: ComplexArray, step: float, view: View) -> list[dict[str, Array]]:
    """Compute amplitudes of the values of every shape in a mode, with the laws linearized at a state.

    Parameters
    ----------
    amplitude : ndarray (n,)
        Amplitudes of all coordinates.
    step : float
        Part of the amplitude by which the state is displaced to either side.

    Returns
    -------
    list of dict
        One for each shape of `flexel.apps.view.drawing.shapes`; without values for a state from a file, which has no
        laws.
    """
    if not isinstance(state.evaluation, Evaluation):
        return [{} for _ in drawing.shapes(state, view.sketches)]
    squares: list[dict[str, Array]] = []
    for direction in (amplitude.real, amplitude.imag):
        (e, law), (e_back, law_back) = (_at(state, state.x + sign * step * direction) for sign in (1, -1))
        change = replace(state, e=(e - e_back) / (2 * step), stresses=(law - law_back) / (2 * step))
        found = [part.values for part in drawing.shapes(change, view.sketches)]
        squares = squares or [{name: np.zeros(np.shape(x)) for name, x in values.items()} for values in found]
        for total, values in zip(squares, found, strict=True):
            for name, x in values.items():
                total[name] = total[name] + np.square(x)
    return [{name: np.sqrt(x) for name, x in values.items()} for values in squares]


def _at(state: State, x: Array) -> tuple[Array, Array]:
    """Return deformations (m,) and stresses of the laws (m + k,) at a displaced position."""
    assert isinstance(state.evaluation, Evaluation)
    work = state.evaluation.at(state.t, x, state.v, state.a, state.z, state.e)
    work.laws()
    return work.e.copy(), work.law_stress.copy()


def packed_values(modes: Sequence[dict[str, Array]]) -> dict[str, Any]:
    """Return values of one shape in all modes, for unit amplitude, in the form of `flexel.apps.view.page.data.part`."""
    return {
        name + SUFFIX: {
            "count": int(np.size(x)),
            "modal": packed([np.concatenate([np.ravel(values[name]) for values in modes])]),
        }
        for name, x in modes[0].items()
    }


def modal_units() -> dict[str, str]:
    """Return the units of the values of modes."""
    return {name + SUFFIX: unit for name, unit in UNITS.items()}
