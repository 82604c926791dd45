"""Beams that are sheared beyond the range of their deformations, which are sines of angles with the chord.

Curvature is measured times the cosine of the shear angle γ: a bending moment is too small by sin² γ of its size, and
the shear stiffness is GA - M²/EI in place of GA.  Source: this project, docs/beams.md.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arrays import Array, Index
from flexel.base.callers import outside
from flexel.base.errors import RangeWarning
from flexel.structure.instances import Instance

FAR = 0.1  # shear angle [rad] at which a bending moment is 1 % too small


def shear_numbers(beam: Instance) -> tuple[float, float]:
    """Shear numbers of the planes whose deformations are of the kinds "bend_y" and "bend_z"."""
    across = "phi_y" if "phi_y" in beam.parameters else "phi_z"  # a planar beam has one
    phi_z, phi_y = (float(beam.parameters[name][0]) for name in ("phi_z", across))
    return phi_z, phi_y


def warn_sheared(names: Sequence[str], gamma: Array, times: ArrayLike, analysis: str) -> None:
    """Warn, at the caller of an analysis, of the beam with the largest shear angle, if that is beyond the range.

    Parameters
    ----------
    names : sequence of str (elements,)
    gamma : ndarray (states, elements)
        Shear angles [rad].
    times : array_like (states,)
    analysis : str
        For the message.
    """
    if not gamma.max(initial=0.0) > FAR:
        return
    when, which = np.unravel_index(int(np.argmax(gamma)), gamma.shape)
    angle, t = float(gamma[when, which]), float(np.asarray(times)[when])
    warnings.warn(
        f"{analysis}: '{names[int(which)]}' is sheared by {np.degrees(angle):.1f}° at t = {t:g} s: its moments are "
        f"about {100 * np.sin(angle) ** 2:.2g} % too small, whatever the number of elements; "
        "rotations='logarithmic' would do",
        RangeWarning,
        stacklevel=outside(),
    )


def shear_angles(e: Array, bends: Index, lengths: Array, numbers: Array) -> Array:
    """Shear angles (states, elements) [rad].

    Parameters
    ----------
    e : ndarray (states, m + 1)
        Deformations, and zero for those that are not.
    bends : ndarray of int (elements, 2, 2)
        By plane those of both ends.
    lengths : ndarray (elements,)
    numbers : ndarray (elements, 2)
        Shear numbers by plane.
    """
    leaning = (e[:, bends[:, :, 0]] - e[:, bends[:, :, 1]]) / (2 * lengths[:, None])
    return np.asarray(np.linalg.norm(numbers / (1 + numbers) * leaning, axis=2))
