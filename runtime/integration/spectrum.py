"""Computes amplitude spectra of time histories."""

from __future__ import annotations

import numpy as np

from flexel.base.arguments import text
from flexel.base.arrays import Array
from flexel.base.errors import ModelError


def amplitudes(t: Array, values: Array, name: str, window: str = "hann") -> tuple[Array, Array]:
    """Return frequencies [Hz] and amplitudes (nf,) of values (nt,) at equidistant times; see `Motion.spectrum`."""
    from scipy.signal import get_window  # slow to import

    steps = np.diff(t)
    if t.size < 4:
        raise ModelError(
            f"spectrum of '{name}': {t.size} stored times are too few; simulate with more samples"
        )
    if np.ptp(steps) > 1e-6 * steps.mean():
        raise ModelError(
            f"spectrum of '{name}': the {t.size} stored times are not equidistant; simulate with samples=…, or with "
            "equidistant times"
        )
    try:
        w = get_window(text(window, f"spectrum of '{name}'", "window"), t.size)
    except ValueError as error:
        raise ModelError(
            f"spectrum of '{name}': {error}; 'hann', 'boxcar' and 'flattop' are usual"
        ) from error
    found: Array = np.asarray(2 * np.abs(np.fft.rfft(w * values)) / w.sum(), dtype=float)
    found[0] /= 2
    if t.size % 2 == 0:
        found[-1] /= 2
    return np.asarray(np.fft.rfftfreq(t.size, float(steps.mean())), dtype=float), found
