"""Warns of beams that are sheared beyond the range of their deformations, which are sines of angles with the chord.

Curvature is measured times the cosine of the shear angle γ: a bending moment is too small by a fraction sin² γ, and
the shear stiffness is GA - M²/EI in place of GA.  Source: this project, docs/beams.md.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from flexel.base.arrays import Array
from flexel.engine.outputs import element_outputs
from flexel.mechanics.turned import instant
from flexel.model.instances import Instance
from flexel.model.structure import Structure

OUTPUT = "shear_angle"  # of the elements that have one
FAR = 0.1  # shear angle [rad] at which a bending moment is 1 % too small


def sheared(names: Sequence[str], gamma: Array, times: ArrayLike) -> list[str]:
    """Describe the beam with the largest shear angle, if that is beyond the range.

    Parameters
    ----------
    names : sequence of str (elements,)
    gamma : ndarray (states, elements)
        Shear angles [rad].
    times : array_like (states,)
    """
    if not gamma.max(initial=0.0) > FAR:
        return []
    when, which = np.unravel_index(int(np.argmax(gamma)), gamma.shape)
    angle = float(gamma[when, which])
    return [
        f"'{names[int(which)]}' is sheared by {np.degrees(angle):.1f}°{instant(times, int(when))}: its moments are "
        f"about {100 * np.sin(angle) ** 2:.2g} % too small, whatever the number of elements; "
        "use rotations='logarithmic'"
    ]


def shear_angles(
    structure: Structure, elements: Sequence[Instance], x: Array, e: Array, bends: Array
) -> Array:
    """Return the shear angles (states, elements) [rad] where they can be beyond the range, and zero elsewhere.

    Parameters
    ----------
    structure : Structure
    elements : sequence of Instance
    x : ndarray (states, n)
        Coordinates.
    e : ndarray (states, m)
        Deformations.
    bends : ndarray (states, elements)
        Turns between the ends by bending [rad]; a section is sheared by less than half of it.
    """
    found = np.zeros(bends.shape)
    for i, element in enumerate(elements):
        far = np.flatnonzero(bends[:, i] > 2 * FAR)
        if far.size and any(output.name == OUTPUT for output in element.spec.outputs):
            stresses = np.zeros((far.size, structure.m + structure.k))  # do not matter
            found[far, i] = element_outputs(structure, [element], x[far], e[far], stresses)[OUTPUT][:, 0, 0]
    return found
