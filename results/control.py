"""Exports linearizations to control-engineering formats: python-control, SciPy, Matlab.

Inputs, outputs and states keep their names; python-control does not allow dots in them, so ``arm.angle`` becomes
``arm_angle`` there.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from flexel.base.arguments import names, path_of, text
from flexel.base.arrays import Array
from flexel.base.errors import LinearizationError, ModelError
from flexel.base.files import replacing
from flexel.linear.sensors import state_space
from flexel.linear.state_space_inputs import Inputs
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.results.saved.record import require

Matrices = tuple[Array, Array, Array, Array]


def _labelled(
    lin: LinearizedSystem, inputs: Sequence[str], outputs: Sequence[str]
) -> tuple[Matrices, tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """Return matrices with the names of states, inputs and outputs; the degrees of freedom are the outputs if none are
    named.
    """
    inputs, outputs = names(inputs, "inputs"), names(outputs, "outputs") or lin.dofs
    if not inputs:
        raise LinearizationError(
            "state space: no input is named; name loads or prescribed motions, inputs=['motor.angle']"
        )
    for what, given in (("input", inputs), ("output", outputs)):
        double = [name for name in given if given.count(name) > 1]
        if double:
            raise LinearizationError(f"state space: {what} '{double[0]}' is named twice; name it once")
    asked = Inputs.of(lin, inputs)
    return state_space(lin, inputs, outputs), asked.states(lin.states), asked.labels, outputs


def signal_names(given: Sequence[str]) -> list[str]:
    """Convert names to the form allowed by python-control, dots replaced.

    Raises
    ------
    LinearizationError
        If two of them become equal.
    """
    found = [name.replace(".", "_") for name in given]
    double = [old for old, new in zip(given, found, strict=True) if found.count(new) > 1]
    if double:
        raise LinearizationError(
            f"to_control: {' and '.join(map(repr, double))} would both be called '{double[0].replace('.', '_')}'; "
            "rename a part of the model"
        )
    return found


def to_control(
    lin: LinearizedSystem, inputs: Sequence[str], outputs: Sequence[str] = (), *, name: str = "flexel"
) -> Any:
    """Return a labelled `control.StateSpace` (needs python-control); see `Linearization.to_control`.

    Parameters
    ----------
    lin : LinearizedSystem
    inputs, outputs : sequence of str
        As in `Linearization.state_space`; the outputs are the degrees of freedom if none are named.
    name : str
        Of the system.
    """
    control = require("control", "control")
    text(name, "to_control", "name")
    matrices, states, ins, outs = _labelled(lin, inputs, outputs)
    labels = {"states": signal_names(states), "inputs": signal_names(ins), "outputs": signal_names(outs)}
    return control.ss(*matrices, name=name, **labels)


def to_scipy(lin: LinearizedSystem, inputs: Sequence[str], outputs: Sequence[str] = ()) -> Any:
    """Return a `scipy.signal.StateSpace`; see `Linearization.to_scipy`."""
    from scipy.signal import StateSpace

    return StateSpace(*_labelled(lin, inputs, outputs)[0])


def save_state_space(
    lin: LinearizedSystem, path: str | Path, inputs: Sequence[str], outputs: Sequence[str] = ()
) -> Path:
    """Write A, B, C, D and their names to a .mat file; see `Linearization.save_state_space`.

    Parameters
    ----------
    lin : LinearizedSystem
    path : path
        With the suffix .mat.
    inputs, outputs : sequence of str
        As in `Linearization.state_space`.

    Raises
    ------
    ModelError
        A suffix other than .mat.
    """
    from scipy.io import savemat

    path = path_of(path, "save_state_space")
    if path.suffix != ".mat":
        raise ModelError(f"save_state_space '{path}': suffix '{path.suffix}' is unknown; use .mat")
    matrices, *labels = _labelled(lin, inputs, outputs)
    contents: dict[str, Any] = dict(zip("ABCD", matrices, strict=True))
    for key, given in zip(("states", "inputs", "outputs"), labels, strict=True):
        contents[key] = np.array(given, dtype=object)
    with replacing(path, "save_state_space") as part:
        savemat(part, contents, do_compression=True)
    return path
