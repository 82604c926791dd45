"""Linearizations as systems of control engineering: python-control, SciPy, Matlab.

Inputs, outputs and states keep their names; python-control admits no dots in them, so that ``arm.angle`` is called
``arm_angle`` there.  These functions are methods of `Linearization`.
Imports numpy, scipy and the records; python-control when asked.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexel.errors import LinearizationError, ModelError
from flexel.inputs import names
from flexel.saved.record import require
from flexel.structure import Array

if TYPE_CHECKING:
    from flexel.linearize import Linearization

Matrices = tuple[Array, Array, Array, Array]


def state_names(lin: Linearization, inputs: Sequence[str] = ()) -> tuple[str, ...]:
    """Names of the states of `Linearization.state_space` with these inputs, in order."""
    driven = [z for z in inputs if z in lin.prescribed]
    return (*lin.states, *(f"{z}'" for z in driven), *driven)


def _labelled(
    lin: Linearization, inputs: Sequence[str], outputs: Sequence[str]
) -> tuple[Matrices, tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """Matrices with the names of states, inputs and outputs; the freedoms are the outputs if none are named."""
    inputs, outputs = names(inputs, "inputs"), names(outputs, "outputs") or lin.freedoms
    if not inputs:
        raise LinearizationError(
            "state space: no input is named; name loads or prescribed motions, inputs=['motor.angle']"
        )
    for what, given in (("input", inputs), ("output", outputs)):
        double = [z for z in given if given.count(z) > 1]
        if double:
            raise LinearizationError(f"state space: {what} '{double[0]}' is named twice; name it once")
    return lin.state_space(inputs, outputs), state_names(lin, inputs), inputs, outputs


def signal_names(given: Sequence[str]) -> list[str]:
    """Names as python-control admits them, dots replaced.

    Raises
    ------
    LinearizationError
        If two of them become one.
    """
    found = [z.replace(".", "_") for z in given]
    double = [old for old, new in zip(given, found, strict=True) if found.count(new) > 1]
    if double:
        raise LinearizationError(
            f"to_control: {' and '.join(map(repr, double))} would both be called '{double[0].replace('.', '_')}'; "
            "rename a part of the model"
        )
    return found


def to_control(
    self: Linearization, inputs: Sequence[str], outputs: Sequence[str] = (), *, name: str = "flexel"
) -> Any:
    """A labelled `control.StateSpace` (needs python-control).

    Parameters
    ----------
    inputs, outputs : sequence of str
        As in `state_space`; the outputs are the freedoms if none are named.
    name : str
        Of the system, for `control.interconnect`.

    Raises
    ------
    FlexelError
        If python-control is not installed.
    LinearizationError, ModelError
        No inputs, names that are double or unknown.

    Examples
    --------
    >>> plant = lin.to_control(["motor.angle"], ["tip.y", "motor.angle'"])  # doctest: +SKIP
    >>> plant.input_labels, plant.output_labels  # doctest: +SKIP
    (['motor_angle'], ['tip_y', "motor_angle'"])
    """
    control = require("control", "control")
    matrices, states, ins, outs = _labelled(self, inputs, outputs)
    labels = {"states": signal_names(states), "inputs": signal_names(ins), "outputs": signal_names(outs)}
    return control.ss(*matrices, name=name, **labels)


def to_scipy(self: Linearization, inputs: Sequence[str], outputs: Sequence[str] = ()) -> Any:
    """A `scipy.signal.StateSpace`; its states, inputs and outputs are in the order of `state_space`."""
    from scipy.signal import StateSpace

    return StateSpace(*_labelled(self, inputs, outputs)[0])


def save_state_space(
    self: Linearization, path: str | Path, inputs: Sequence[str], outputs: Sequence[str] = ()
) -> Path:
    """Write A, B, C, D and the names of states, inputs and outputs to a .mat file, for Matlab's ``ss(A, B, C, D)``.

    Raises
    ------
    ModelError
        A suffix other than .mat.
    """
    from scipy.io import savemat

    path = Path(path)
    if path.suffix != ".mat":
        raise ModelError(f"save_state_space '{path}': suffix '{path.suffix}' is unknown; use .mat")
    matrices, *labels = _labelled(self, inputs, outputs)
    contents: dict[str, Any] = dict(zip("ABCD", matrices, strict=True))
    for key, given in zip(("states", "inputs", "outputs"), labels, strict=True):
        contents[key] = np.array(given, dtype=object)
    savemat(path, contents, do_compression=True)
    return path
