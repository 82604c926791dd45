"""Frequency responses of linearized equations: complex amplitudes of outputs per unit amplitude of inputs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import eigvals

from flexel.base.arguments import array, names
from flexel.base.arrays import Array, ComplexArray
from flexel.base.errors import LinearizationError, ModelError
from flexel.base.units import force_unit, rate_unit
from flexel.linear.sensors import state_space
from flexel.linear.state_space_inputs import DISPLACEMENT, Inputs
from flexel.mechanics.linearized_system import LinearizedSystem
from flexel.model.quantities import history

FREQUENCY_COUNT = 400  # frequencies over the whole range, equidistant on a logarithmic axis
PEAK_OFFSETS = np.logspace(-1.5, 2, 22)  # around a resonance, in half widths of its peak
MIN_HALF_WIDTH = 1e-5  # half width over frequency that is resolved; a peak without damping is infinite
BLOCK_FREQUENCIES = 128  # frequencies solved at once

_eigvals: Any = eigvals


@dataclass(frozen=True)
class FrequencyResponse:
    """Complex amplitudes of outputs per unit amplitude of inputs.

    Attributes
    ----------
    frequencies : ndarray (nf,)
        [Hz]
    values : ndarray of complex (nf, outputs, inputs)
    inputs, outputs : tuple of str
        As in `Linearization.state_space`.
    units : tuple of tuple of str
        Unit of each output per unit of each input, (outputs, inputs).
    """

    frequencies: Array
    values: ComplexArray
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    units: tuple[tuple[str, ...], ...]

    @property
    def magnitude(self) -> Array:
        """Ratio of the amplitudes (nf, outputs, inputs)."""
        return np.asarray(np.abs(self.values))

    @property
    def decibels(self) -> Array:
        """20 log₁₀ of the ratio of the amplitudes (nf, outputs, inputs)."""
        return np.asarray(20 * np.log10(np.maximum(self.magnitude, np.finfo(float).tiny)))

    @property
    def phase(self) -> Array:
        """Phase lead of the output [rad], without jumps of 2π (nf, outputs, inputs)."""
        return np.asarray(np.unwrap(np.angle(self.values), axis=0))


def frequency_response(
    lin: LinearizedSystem,
    inputs: str | Sequence[str],
    outputs: str | Sequence[str],
    frequencies: Any = None,
    *,
    refine: bool = False,
) -> FrequencyResponse:
    """Compute the response, see `Linearization.frequency_response`; `refine` adds resonances to given frequencies."""
    ins = (inputs,) if isinstance(inputs, str) else names(inputs, "inputs")
    outs = (outputs,) if isinstance(outputs, str) else names(outputs, "outputs")
    if not ins or not outs:
        raise LinearizationError("frequency_response: name an input and an output, ('motor.angle', 'tip.y')")
    matrices = state_space(lin, ins, outs)
    given = Inputs.of(lin, ins)
    if frequencies is None:
        f = _range(matrices[0]) / (2 * np.pi)
    else:
        f = array(frequencies, "frequency_response", "frequencies").ravel()
        if not f.size or not np.isfinite(f).all() or (f < 0).any():
            raise ModelError("frequency_response: give frequencies that are not negative, in Hz")
    if frequencies is None or refine:
        sharp = _sharp(matrices) / (2 * np.pi)
        f = np.unique([*f, *sharp[(sharp > f.min()) & (sharp < f.max())]])
    by = [_input_unit(lin, label, base) for label, base in zip(given.labels, given.quantities, strict=True)]
    of = [history(lin.state.structure, name).unit for name in outs]
    units = tuple(tuple(_ratio(a, b) for b in by) for a in of)
    return FrequencyResponse(f, _solved(matrices, 2 * np.pi * f), given.labels, outs, units)


def _solved(matrices: tuple[Array, Array, Array, Array], omega: Array) -> ComplexArray:
    """Evaluate C (iω - A)⁻¹ B + D at each frequency."""
    A, B, C, D = matrices
    if not len(A):
        return np.tile(D.astype(complex), (omega.size, 1, 1))
    parts = []
    for first in range(0, omega.size, BLOCK_FREQUENCIES):
        w = omega[first : first + BLOCK_FREQUENCIES, None, None]
        try:
            parts.append(C @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B.astype(complex)) + D)
        except np.linalg.LinAlgError as error:
            raise LinearizationError(
                "frequency_response: a frequency is that of an undamped motion, where the response is infinite; "
                "leave it out (0 Hz for a motion without stiffness)"
            ) from error
    return np.concatenate(parts)


def _range(A: Array) -> Array:
    """Return a range from a tenth of the lowest natural frequency to ten times the highest [rad/s]."""
    size = np.abs(np.linalg.eigvals(A)) if len(A) else np.zeros(0)
    size = size[size > 1e-6 * size.max(initial=0.0)]
    low, high = (size.min(), size.max()) if size.size else (1.0, 1.0)
    return np.logspace(np.log10(0.1 * low), np.log10(10 * high), FREQUENCY_COUNT)


def _sharp(matrices: tuple[Array, Array, Array, Array]) -> Array:
    """Return frequencies [rad/s] around all peaks (poles) and dips (zeros of each pair), dense enough for them."""
    A, B, C, D = matrices
    n = len(A)
    if not n:
        return np.zeros(0)
    roots = [np.linalg.eigvals(A)]
    mass = np.diag([*np.ones(n), 0.0])
    for i in range(len(C)):
        for j in range(B.shape[1]):
            pencil = np.block([[A, B[:, [j]]], [C[[i]], D[[i], j : j + 1]]])
            zeros = np.asarray(_eigvals(pencil, mass))
            roots.append(zeros[np.isfinite(zeros)])
    found = np.concatenate(roots)
    found = found[found.imag > 1e-6 * np.abs(found)]
    width = np.maximum(np.abs(found.real), MIN_HALF_WIDTH * found.imag)
    about = found.imag + np.concatenate([-PEAK_OFFSETS[::-1], PEAK_OFFSETS])[:, None] * width
    centre = found.imag[np.abs(found.real) >= MIN_HALF_WIDTH * found.imag]
    return np.asarray(np.concatenate([about.ravel(), centre]))


def _input_unit(lin: LinearizedSystem, label: str, base: str) -> str:
    structure = lin.state.structure
    i = structure.find(base, "input")
    if label.startswith(DISPLACEMENT):
        return structure.units[i]
    if label.endswith("''"):
        return rate_unit(structure.units[i], 2)
    return force_unit(structure.units[i], structure.m <= i < structure.m + structure.k)


def _ratio(output: str, given: str) -> str:
    """Return the unit of an output per unit of an input."""
    if output == given:
        return "1"
    if given in ("1", "-", ""):
        return output
    below = f"({given})" if any(mark in given for mark in " /") else given
    return f"({output})/{below}" if "/" in output else f"{output}/{below}"
